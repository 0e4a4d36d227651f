"""What moves in the hull, blows at it, knocks it or holds its heading."""

from __future__ import annotations

import numpy as np
from borrowed import blind
from effect import EFFECTS, OUTSIDE, Session, everywhere, none_of, register, relative, sign
from friction import YAW, loss


def put_sliders(session: Session, p: dict, share: float) -> None:
    """Masses on springs; with them at rest the hull's inertia is the stated one."""
    for k, slider in enumerate(p["sliders"]):
        mass = share * slider["mass_share"] * session.hull.mass_kg
        om = 2 * np.pi * slider["frequency_hz"]
        for scene in session.scenes:
            e = scene.extras[0]
            e["slider_mass"][k] = mass
            e["slider_place"][k], e["slider_way"][k] = slider["place_m"], slider["way"]
            e["slider_spring"][k], e["slider_damping"][k] = mass * om**2, 2 * mass * slider["damping_ratio"] * om


def draw_slider(rng, session: Session, low: float, high: float) -> dict:
    """Somewhere low in the hull, along a level way."""
    hull, way = session.hull, rng.uniform(0, 2 * np.pi)
    place = [rng.uniform(-0.35, 0.35) * hull.length_m, rng.uniform(-0.2, 0.2) * hull.beam_m, -rng.uniform(0, 2) * hull.depth_m]
    omegas = [m.omega_rad_s for m in session.hungs[0].modes.values()]
    return {
        "mass_share": blind.log_uniform(rng, low, high), "place_m": place, "way": [np.cos(way), np.sin(way), 0.0],
        "frequency_hz": blind.log_uniform(rng, 1.3 * min(omegas), 4 * max(omegas)) / (2 * np.pi),
        "damping_ratio": blind.log_uniform(rng, 0.01, 0.2),
    }  # fmt: skip


def probe_sliders(session: Session) -> list[dict]:
    """Fore and aft and athwartships, slower and faster than the hull's own motions, amidships and at the bow."""
    omegas, hull = [m.omega_rad_s for m in session.hungs[0].modes.values()], session.hull
    base = {"mass_share": 3e-3, "damping_ratio": 0.05}
    return [
        {"sliders": [{**base, "place_m": [x * hull.length_m, 0.0, -hull.depth_m], "way": way, "frequency_hz": om / (2 * np.pi)}]}
        for om in (1.5 * min(omegas), 2 * max(omegas)) for way, x in (([1, 0, 0], 0.0), ([0, 1, 0], 0.0), ([0, 1, 0], 0.3))
    ]  # fmt: skip


def put_wind(session: Session, p: dict, share: float) -> None:
    """Drag areas of hull and gear; gusts of four frequencies ride on the mean."""
    area, hull = 0.08 * session.hull.length_m**2, session.hull
    for scene in session.scenes:
        e = scene.extras
        e["wind_area"] = share * area * np.array([0.25, 1.0])
        e["wind_arm"], e["wind"], e["gust"] = p["arm"] * hull.length_m, p["mean_m_s"], p["gusts"]


def draw_wind(rng, session: Session) -> dict:
    speed, way = blind.log_uniform(rng, 0.1, 2.0), rng.uniform(0, 2 * np.pi)
    turn = 2 * np.pi
    gusts = [[rng.uniform(0.05, 0.25), turn * blind.log_uniform(rng, 0.01, 0.3), rng.uniform(0, turn)] for _ in range(4)]
    return {"mean_m_s": [speed * np.cos(way), speed * np.sin(way)], "arm": rng.uniform(-0.15, 0.15), "gusts": gusts}


def probe_wind(session: Session) -> list[dict]:
    still = np.zeros((4, 3)).tolist()
    return [{"mean_m_s": way, "arm": 0.1, "gusts": still} for way in ([1.0, 0.0], [0.0, 1.0], [0.7, 0.7])]


def put_hardening(session: Session, p: dict, share: float) -> None:
    """A spring about the vertical with torque k₃ ψ³; `relative` to the lines' own at 0.1 rad."""
    everywhere(session, "torsion_cubic", p["relative"] * session.yaw_stiffness() / 0.1**2, share)


def put_rub(session: Session, p: dict, share: float) -> None:
    everywhere(session, "rub", [loss(session, p["decay_s"], 0.0)[YAW], 0.0], share)
    for scene in session.scenes:
        scene.extras["rub"][0, 1] = p["beyond_rad"]


def put_knock(session: Session, p: dict, share: float) -> None:
    e = session.scenes[p["swing"]].extras
    e["knock"] += share * np.array(p["impulse_n_s"])
    e["knock_arm"], e["knock_time"] = p["arm_m"], [p["at_s"], p["takes_s"]]


def draw_knock(rng, session: Session) -> dict:
    swing, way, hull = int(rng.integers(len(session.scenes))), rng.uniform(0, 2 * np.pi), session.hull
    impulse = hull.mass_kg * blind.log_uniform(rng, 5e-4, 1e-2)
    arm = [rng.uniform(-0.4, 0.4) * hull.length_m, 0.0, rng.uniform(-0.2, 0.2)]
    when = session.scenes[swing].shown_s[-1] * rng.uniform(0.15, 0.85)
    return {"swing": swing, "at_s": when, "takes_s": rng.uniform(0.04, 0.15),
            "impulse_n_s": [impulse * np.cos(way), impulse * np.sin(way), 0.0], "arm_m": arm}  # fmt: skip


def draw_second_slosh(rng, session: Session) -> dict:
    """Two, whose frequencies differ by half at least."""
    first = draw_slider(rng, session, 2e-3, 2e-2)
    while True:
        second = draw_slider(rng, session, 2e-3, 2e-2)
        if abs(np.log(second["frequency_hz"] / first["frequency_hz"])) > np.log(1.5):
            return {"sliders": [first, second]}


def draw_rub(rng, session: Session) -> dict:
    """The rope lies against something beyond a heading."""
    return {"decay_s": blind.log_uniform(rng, 50, 3000), "beyond_rad": sign(rng) * rng.uniform(0.01, 0.06)}


register(EFFECTS, "internal_motion", lambda rng, s: {"sliders": [draw_slider(rng, s, 5e-4, 2e-2)]}, put_sliders, probe_sliders)
register(EFFECTS, "wind", draw_wind, put_wind, probe_wind)

register(OUTSIDE, "second_slosh", draw_second_slosh, put_sliders, none_of)
register(OUTSIDE, "hardening_spring", relative(5e-4, 3e-2, False), put_hardening, none_of)
register(OUTSIDE, "rubbing_rope", draw_rub, put_rub, none_of)
register(OUTSIDE, "knock", draw_knock, put_knock, none_of)
