"""The effects that are hidden: how strong one is drawn, and what it changes in a session.

Each has `draw` (a strength of everyday size, log-uniform, from barely detectable to strong) and `put` (change the session by a
share of it; shares near 0 and 1 give sensitivities). `probes` are the weak samples of a cause with which another may
be confused. Names are those of the critique's causes; those after OUTSIDE have no name there.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from borrowed import blind, rb
from forces import POWER_REFERENCE
from scene import Mount, Scene, Slip, sense
from scene import move as moved
from scipy.special import gamma

X, Y, Z, PITCH, YAW = 0, 1, 2, 4, 5  # of the six drag coefficients


@dataclass
class Tape:
    """A dimension read off a tape: true, stated, and which scenes share it."""

    what: str  # line or spacing
    true_m: float
    stated: dict
    scenes: list[int]
    offset_m: float = 0.0  # a mistake on top of the stated uncertainty


@dataclass
class Session:
    """One hull's swings as they truly are."""

    hull: blind.Hull
    hungs: list
    scenes: list[Scene]
    tapes: list[Tape]
    amplitudes: list[dict] = field(default_factory=list)

    def copy(self) -> "Session":
        """For changing: scenes and tapes are new, the rest is shared."""
        tapes = [Tape(t.what, t.true_m, t.stated, t.scenes, t.offset_m) for t in self.tapes]
        return Session(self.hull, self.hungs, [s.copy() for s in self.scenes], tapes, self.amplitudes)

    def omega(self, mode: str) -> float:
        """Of a small motion in the first swing, rad/s."""
        return self.hungs[0].modes[mode].omega_rad_s

    def weight_n(self) -> float:
        """All that hangs."""
        return self.hull.mass_kg * self.hull.gravity_m_s2

    def line_m(self) -> float:
        """Of the first swing."""
        return self.scenes[0].line_m.mean()

    def spacing_m(self) -> float:
        """Of the first swing."""
        return self.scenes[0].spacing_m

    def yaw_stiffness(self) -> float:
        """m g d²/l of the first swing, N m/rad."""
        return self.weight_n() * self.spacing_m() ** 2 / (4 * self.line_m())


@dataclass
class Effect:
    """A way to be wrong."""

    name: str
    draw: Callable
    put: Callable  # (session, parameters, share)
    probes: Callable  # session -> list of parameters
    two_rigs: bool = False  # one geometry cannot show it
    phone_only: bool = False  # the hull moves as without it
    whole: bool = False  # not proportional: compare with and without
    weak: float = 0.02  # share of a probe that is small enough; more where a small share means stiff


EFFECTS: dict[str, Effect] = {}
OUTSIDE: dict[str, Effect] = {}


def sign(rng) -> float:
    """Up or down."""
    return float(rng.choice([-1.0, 1.0]))


def everywhere(session: Session, name: str, value, share: float) -> None:
    """Add a share to a field of every swing's rig."""
    for scene in session.scenes:
        scene.extras[name] += share * np.asarray(value)


# Friction and drag. Strength: the time in which a motion of usual amplitude would decay.


def usual_speeds(session: Session) -> np.ndarray:
    """Speed amplitudes of the six motions in swings of usual size, m/s and rad/s."""
    aside = 0.06 * session.line_m()
    sway, pitch, yaw = session.omega("sway"), session.omega("in_phase"), session.omega("yaw")
    return np.array([pitch * aside, sway * aside, sway * aside, 1.0, 0.05 * pitch, 0.1 * yaw])


def inertias(session: Session) -> np.ndarray:
    """Mass three times, moments of inertia."""
    return np.concatenate([np.full(3, session.hull.mass_kg), np.diag(session.hull.inertia())])


def loss(session: Session, decay_s, exponent: float) -> np.ndarray:
    """Force at the usual speed V such that F |v/V|^n makes amplitudes decay at 1/decay_s: F = 2π m V / (τ B),
    B = ∫|cos|^(n+1) over a turn (energy balance; Nayfeh and Mook 1979, section 3.1)."""
    turn = 2 * np.sqrt(np.pi) * gamma(exponent / 2 + 1) / gamma(exponent / 2 + 1.5)
    return 2 * np.pi * inertias(session) * usual_speeds(session) / (np.asarray(decay_s) * turn)


def draw_times(rng, low: float, high: float) -> list[float]:
    """Decay times by axis: one strength, unequal shapes. None about x, where the hull does not turn."""
    times = blind.log_uniform(rng, low, high) * np.exp(rng.normal(0, 0.4, 6))
    times[3] = np.inf
    return times.tolist()


def one_axis(make: Callable) -> Callable:
    """Probes of drag in surge, sway, pitch and yaw."""
    return lambda session: [make([1000.0 if i == k else np.inf for i in range(6)]) for k in (X, Y, PITCH, YAW)]


def put_quadratic(session: Session, p: dict, share: float) -> None:
    force = loss(session, p["decay_s"], 2.0)
    everywhere(session, "quadratic", force / usual_speeds(session) ** 2, share)


def put_power(session: Session, p: dict, share: float) -> None:
    n = p["exponent"]
    force = loss(session, p["decay_s"], n) * (POWER_REFERENCE / usual_speeds(session)) ** n
    everywhere(session, "power", force, share)
    for scene in session.scenes:
        scene.extras["exponent"] = n


def put_coulomb(session: Session, p: dict, share: float) -> None:
    everywhere(session, "coulomb", loss(session, p["decay_s"], 0.0), share)


def put_presliding(session: Session, p: dict, share: float) -> None:
    force = loss(session, p["decay_s"], 0.0)[[Y, PITCH, YAW]]
    everywhere(session, "contact", force, share)
    for scene in session.scenes:
        scene.extras["contact_give"] = p["give_rad"] * np.array([session.line_m(), 1.0, 1.0])


def put_added(session: Session, p: dict, share: float) -> None:
    """Inertia grows in proportion to the amplitude: Morison's inertia term with a coefficient linear in the
    Keulegan-Carpenter number."""
    per = np.asarray(p["share_at_usual"]) * inertias(session)[[Y, PITCH, YAW]] / [0.06 * session.line_m(), 0.05, 0.1]
    everywhere(session, "added", per, share)
    for scene in session.scenes:
        scene.extras["added_omega"] = [session.omega("sway"), session.omega("in_phase"), session.omega("yaw")]


# Lines and what they hang from.


def put_creep(session: Session, p: dict, share: float) -> None:
    """Logarithmic in time from the start of each recording: between swings the lines were slack and recovered."""
    everywhere(session, "creep", [p["relative"] * session.line_m(), 0.0], share)
    for scene in session.scenes:
        scene.extras["creep"][0, 1] = p["time_s"]


def put_stretch(session: Session, p: dict, share: float) -> None:
    """Springs of stiffness E A / l; `relative` is the strain at rest."""
    if share == 0:
        return
    for scene in session.scenes:
        k = session.weight_n() / (2 * share * p["relative"] * scene.line_m.mean())
        scene.extras["stiffness"] = k
        scene.extras["line_damping"] = 2 * p["damping_ratio"] * np.sqrt(k * scene.mass_kg / 2)


def put_torsion(session: Session, p: dict, share: float) -> None:
    """G J / l: a line twice as long twists twice as easily."""
    for scene in session.scenes:
        k = p["relative"] * session.yaw_stiffness() * session.line_m() / scene.line_m.mean()
        scene.extras["torsion"] += share * k


def put_nonparallel(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.top_spacing_m *= 1 + share * p["relative"]


def put_unequal(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.line_m += share * p["relative"] * scene.line_m.mean() * np.array([0.5, -0.5])


def put_off_centre(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.centre_m[1] += share * p["aside_m"]


def put_support(session: Session, p: dict, share: float) -> None:
    """Both anchors on a beam that yields alike in x and y; `give` is its bending under the hull's weight, sideways."""
    if share == 0:
        return
    k = session.weight_n() / (share * p["give_m"])
    om = 2 * np.pi * p["frequency_hz"]
    for scene in session.scenes:
        scene.extras["support"] = [k / om**2, k, 2 * p["damping_ratio"] * k / om]


def put_tape(what: str) -> Callable:
    """The same mistake on every figure of this kind: a tape with a worn hook, or the wrong knot."""

    def put(session: Session, p: dict, share: float) -> None:
        for tape in session.tapes:
            if tape.what == what:
                tape.offset_m += share * p["offset_m"]

    return put


# Inside and around the hull.


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
    gusts = [[rng.uniform(0.05, 0.25), 2 * np.pi * blind.log_uniform(rng, 0.01, 0.3), rng.uniform(0, 2 * np.pi)] for _ in range(4)]
    return {"mean_m_s": [speed * np.cos(way), speed * np.sin(way)], "arm": rng.uniform(-0.15, 0.15), "gusts": gusts}


def probe_wind(session: Session) -> list[dict]:
    still = np.zeros((4, 3)).tolist()
    return [{"mean_m_s": way, "arm": 0.1, "gusts": still} for way in ([1.0, 0.0], [0.0, 1.0], [0.7, 0.7])]


# The phone.


def put_drift(session: Session, p: dict, share: float) -> None:
    """A sensor that warms up, anew in each swing."""
    for scene in session.scenes:
        scene.flaws.gyro_drift = scene.flaws.gyro_drift + share * np.array(p["gyro_rad_s"])
        scene.flaws.acc_drift = scene.flaws.acc_drift + share * np.array(p["acc_m_s2"])
        scene.flaws.drift_s = p["time_s"]


def draw_drift(rng, session: Session) -> dict:
    way = lambda: rng.normal(size=3) / np.sqrt(3)
    strength = blind.log_uniform(rng, 3e-5, 3e-3)
    return {"gyro_rad_s": (strength * way()).tolist(), "acc_m_s2": (10 * strength * way()).tolist(),
            "time_s": blind.log_uniform(rng, 40, 600)}  # fmt: skip


def put_clock(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.flaws.clock += share * p["relative"]


def put_gyro_scale(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.flaws.gyro_scale += share * p["relative"]


def peaks(session: Session) -> tuple[float, float]:
    """Largest reading of each sensor's axes in the session."""
    both = [sense(s, moved(s, 0.03, 3), 3) for s in session.scenes]
    return tuple(float(max(np.abs(pair[k]).max() for pair in both)) for k in (0, 1))


def put_saturation(session: Session, p: dict, share: float) -> None:
    if share == 0:
        return
    for scene in session.scenes:
        setattr(scene.flaws, f"{p['sensor']}_limit", p["limit"])


def draw_saturation(rng, session: Session) -> dict:
    sensor = str(rng.choice(["gyro", "acc"]))
    gyro, acc = peaks(session)
    # An accelerometer stands at gravity: its swings are a few per cent of its reading.
    limit = gyro * rng.uniform(0.5, 0.97) if sensor == "gyro" else acc - (acc - session.hull.gravity_m_s2 * 0.97) * rng.uniform(0.1, 0.6)
    return {"sensor": sensor, "limit": limit}


def probe_saturation(session: Session) -> list[dict]:
    gyro, acc = peaks(session)
    return [{"sensor": "gyro", "limit": 0.9 * gyro}, {"sensor": "acc", "limit": 0.99 * acc}]


def put_slip(session: Session, p: dict, share: float) -> None:
    """In one swing; later swings begin with the phone as it then is."""
    turn, shift = share * np.array(p["turn_rad"]), share * np.array(p["shift_m"])
    session.scenes[p["swing"]].flaws.slips.append(Slip(p["at_s"], turn, shift))
    for scene in session.scenes[p["swing"] + 1 :]:
        scene.phone.phone_from_hull = rb.product(rb.turn(-turn[:, None]), scene.phone.phone_from_hull)
        scene.phone.position_m = scene.phone.position_m + shift


def draw_slip(rng, session: Session) -> dict:
    swing, way = int(rng.integers(len(session.scenes))), rng.normal(size=3)
    angle = blind.log_uniform(rng, 5e-4, 5e-2)
    return {"swing": swing, "at_s": session.scenes[swing].shown_s[-1] * rng.uniform(0.15, 0.85),
            "turn_rad": (angle * way / np.linalg.norm(way)).tolist(), "shift_m": (0.1 * angle * rng.normal(size=3)).tolist()}  # fmt: skip


def probe_slip(session: Session) -> list[dict]:
    return [
        {"swing": n, "at_s": 60.0, "turn_rad": (1e-3 * way).tolist(), "shift_m": [0.0] * 3}
        for n in range(len(session.scenes)) for way in np.eye(3)
    ]  # fmt: skip


def put_mount(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        om = 2 * np.pi * p["frequency_hz"]
        scene.flaws.mount = Mount(om, p["damping_ratio"], np.array(p["axis"]), np.array(p["lever_per_m"]), share)


def draw_mount(rng, session: Session) -> dict:
    """A phone on foam or on a stick; the lever is across the axis."""
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    lever = np.cross(axis, rng.normal(size=3))
    return {"frequency_hz": blind.log_uniform(rng, 2, 15), "damping_ratio": blind.log_uniform(rng, 0.02, 0.15), "axis": axis.tolist(),
            "lever_per_m": (lever / np.linalg.norm(lever) * blind.log_uniform(rng, 0.5, 5)).tolist()}  # fmt: skip


def probe_mount(session: Session) -> list[dict]:
    return [
        {"frequency_hz": 5.0, "damping_ratio": 0.05, "axis": axis.tolist(), "lever_per_m": lever.tolist()}
        for axis, lever in zip(np.eye(3), np.roll(np.eye(3), 1, 0))
    ]


# Outside the catalogue.


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
    return {"swing": swing, "at_s": session.scenes[swing].shown_s[-1] * rng.uniform(0.15, 0.85), "takes_s": rng.uniform(0.04, 0.15),
            "impulse_n_s": [impulse * np.cos(way), impulse * np.sin(way), 0.0], "arm_m": arm}  # fmt: skip


def put_line_slip(session: Session, p: dict, share: float) -> None:
    """One line gives way at its knot, and stays so."""
    amount = share * p["relative"] * session.line_m()
    e = session.scenes[p["swing"]].extras[0]
    e["slip"][p["line"]] += amount
    e["slip"][2:] = p["at_s"], 0.3
    for scene in session.scenes[p["swing"] + 1 :]:
        scene.line_m[p["line"]] += amount


def draw_line_slip(rng, session: Session) -> dict:
    swing = int(rng.integers(len(session.scenes)))
    return {"swing": swing, "line": int(rng.integers(2)), "at_s": session.scenes[swing].shown_s[-1] * rng.uniform(0.15, 0.85),
            "relative": blind.log_uniform(rng, 1e-4, 1e-2)}  # fmt: skip


def relative(low: float, high: float, either: bool = True) -> Callable:
    """A relative strength, of either sign."""
    return lambda rng, _: {"relative": blind.log_uniform(rng, low, high) * (sign(rng) if either else 1.0)}


def tape_mistake(per: float) -> Callable:
    return lambda rng, session: {"offset_m": round(sign(rng) * blind.log_uniform(rng, 1e-3, 2e-2) * per * session.line_m(), 4)}


def draw_second_slosh(rng, session: Session) -> dict:
    """Two, whose frequencies differ by half at least."""
    first = draw_slider(rng, session, 2e-3, 2e-2)
    while True:
        second = draw_slider(rng, session, 2e-3, 2e-2)
        if abs(np.log(second["frequency_hz"] / first["frequency_hz"])) > np.log(1.5):
            return {"sliders": [first, second]}


def register(into: dict, *args, **more) -> None:
    effect = Effect(*args, **more)
    into[effect.name] = effect


none_of = lambda _: []
axes = lambda: one_axis(lambda times: {"decay_s": times})
three = lambda key, size: lambda _: [{key: (size * row).tolist()} for row in np.eye(3)]
of_three = lambda rng, low, high: (blind.log_uniform(rng, low, high) * np.exp(rng.normal(0, 0.4, 3))).tolist()

register(EFFECTS, "quadratic_drag", lambda r, _: {"decay_s": draw_times(r, 100, 5000)}, put_quadratic, axes())
register(EFFECTS, "power_law_damping", lambda r, _: {"exponent": r.uniform(1.3, 1.7), "decay_s": draw_times(r, 100, 5000)}, put_power,
         one_axis(lambda times: {"exponent": 1.5, "decay_s": times}))  # fmt: skip
register(EFFECTS, "bearing_friction", lambda r, _: {"decay_s": draw_times(r, 400, 20000)}, put_coulomb, axes())
register(EFFECTS, "presliding_bearing", lambda r, _: {"give_rad": blind.log_uniform(r, 5e-3, 5e-2), "decay_s": draw_times(r, 400, 20000)},
         put_presliding, one_axis(lambda times: {"give_rad": 0.015, "decay_s": times}))  # fmt: skip
register(EFFECTS, "amplitude_added_mass", lambda r, _: {"share_at_usual": of_three(r, 2e-4, 1e-2)}, put_added,
         three("share_at_usual", 1e-3))  # fmt: skip
register(EFFECTS, "line_creep", lambda r, _: {"relative": blind.log_uniform(r, 3e-5, 3e-3), "time_s": blind.log_uniform(r, 5, 100)},
         put_creep, lambda _: [{"relative": 3e-4, "time_s": 20.0}])  # fmt: skip
register(EFFECTS, "line_stretch", lambda r, _: {"relative": blind.log_uniform(r, 5e-4, 1e-2), "damping_ratio": r.uniform(0.05, 0.1)},
         put_stretch, lambda _: [{"relative": 3e-3, "damping_ratio": 0.08}], weak=0.3)  # fmt: skip
register(EFFECTS, "line_torsion", relative(2e-4, 2e-2, False), put_torsion, lambda _: [{"relative": 1e-3}], two_rigs=True)
register(EFFECTS, "nonparallel_lines", relative(5e-4, 3e-2), put_nonparallel, lambda _: [{"relative": 1e-3}], two_rigs=True)
register(EFFECTS, "unequal_lines", relative(3e-4, 1e-2), put_unequal, lambda _: [{"relative": 1e-3}])
register(EFFECTS, "off_centre_cm", lambda r, s: {"aside_m": sign(r) * blind.log_uniform(r, 5e-4, 3e-2) * s.spacing_m()}, put_off_centre,
         lambda s: [{"aside_m": 1e-3 * s.spacing_m()}])  # fmt: skip
register(EFFECTS, "support_compliance",
         lambda r, s: {"give_m": blind.log_uniform(r, 5e-5, 5e-3) * s.line_m(), "frequency_hz": r.uniform(8, 18), "damping_ratio": r.uniform(0.03, 0.1)},
         put_support, lambda s: [{"give_m": 1e-2 * s.line_m(), "frequency_hz": 8.0, "damping_ratio": 0.1}], two_rigs=True)  # fmt: skip
register(EFFECTS, "internal_motion", lambda r, s: {"sliders": [draw_slider(r, s, 5e-4, 2e-2)]}, put_sliders, probe_sliders)
register(EFFECTS, "wind", draw_wind, put_wind, probe_wind)
register(EFFECTS, "stated_length", tape_mistake(1.0), put_tape("line"), lambda _: [{"offset_m": 0.01}], two_rigs=True, phone_only=True)
register(EFFECTS, "stated_spacing", tape_mistake(0.5), put_tape("spacing"), lambda _: [{"offset_m": 0.01}], two_rigs=True, phone_only=True)
register(EFFECTS, "bias_drift", draw_drift, put_drift, none_of, phone_only=True)
register(EFFECTS, "clock_scale", relative(3e-4, 2e-2), put_clock, lambda _: [{"relative": 1e-3}])
register(EFFECTS, "gyro_scale", relative(1e-3, 3e-2), put_gyro_scale, lambda _: [{"relative": 1e-3}], phone_only=True)
register(EFFECTS, "saturation", draw_saturation, put_saturation, probe_saturation, phone_only=True, whole=True)
register(EFFECTS, "phone_slip", draw_slip, put_slip, probe_slip, phone_only=True)
register(EFFECTS, "phone_mount_resonance", draw_mount, put_mount, probe_mount, phone_only=True)

register(OUTSIDE, "second_slosh", draw_second_slosh, put_sliders, none_of)
register(OUTSIDE, "hardening_spring", relative(5e-4, 3e-2, False), put_hardening, none_of)
register(OUTSIDE, "rubbing_rope", lambda r, _: {"decay_s": blind.log_uniform(r, 50, 3000), "beyond_rad": sign(r) * r.uniform(0.01, 0.06)},
         put_rub, none_of)  # fmt: skip
register(OUTSIDE, "knock", draw_knock, put_knock, none_of)
register(OUTSIDE, "line_slip", draw_line_slip, put_line_slip, none_of)
