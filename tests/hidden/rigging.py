"""Lines that are not what they should be, what they hang from, and what the tape got wrong."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from borrowed import blind
from effect import EFFECTS, OUTSIDE, Session, everywhere, register, relative, sign


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


def tape_mistake(per: float) -> Callable:
    return lambda rng, session: {"offset_m": round(sign(rng) * blind.log_uniform(rng, 1e-3, 2e-2) * per * session.line_m(), 4)}


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


def draw_support(rng, session: Session) -> dict:
    """A beam or a branch."""
    give = blind.log_uniform(rng, 5e-5, 5e-3) * session.line_m()
    return {"give_m": give, "frequency_hz": rng.uniform(8, 18), "damping_ratio": rng.uniform(0.03, 0.1)}


slight = lambda _: [{"relative": 1e-3}]

register(
    EFFECTS, "line_creep",
    lambda rng, _: {"relative": blind.log_uniform(rng, 3e-5, 3e-3), "time_s": blind.log_uniform(rng, 5, 100)},
    put_creep, lambda _: [{"relative": 3e-4, "time_s": 20.0}],
)  # fmt: skip
register(
    EFFECTS, "line_stretch",
    lambda rng, _: {"relative": blind.log_uniform(rng, 5e-4, 1e-2), "damping_ratio": rng.uniform(0.05, 0.1)},
    put_stretch, lambda _: [{"relative": 3e-3, "damping_ratio": 0.08}], weak=1.0,
)  # fmt: skip
register(EFFECTS, "line_torsion", relative(2e-4, 2e-2, False), put_torsion, slight, two_rigs=True)
register(EFFECTS, "nonparallel_lines", relative(5e-4, 3e-2), put_nonparallel, slight, two_rigs=True)
register(EFFECTS, "unequal_lines", relative(3e-4, 1e-2), put_unequal, slight)
register(
    EFFECTS, "off_centre_cm", lambda rng, s: {"aside_m": sign(rng) * blind.log_uniform(rng, 5e-4, 3e-2) * s.spacing_m()},
    put_off_centre, lambda s: [{"aside_m": 1e-3 * s.spacing_m()}],
)  # fmt: skip
register(
    EFFECTS, "support_compliance", draw_support,
    put_support, lambda s: [{"give_m": 1e-2 * s.line_m(), "frequency_hz": 8.0, "damping_ratio": 0.1}], two_rigs=True,
)  # fmt: skip
for name, what, per_line in (("stated_length", "line", 1.0), ("stated_spacing", "spacing", 0.5)):
    probes = lambda _: [{"offset_m": 0.01}]
    register(EFFECTS, name, tape_mistake(per_line), put_tape(what), probes, two_rigs=True, phone_only=True)

register(OUTSIDE, "line_slip", draw_line_slip, put_line_slip, lambda _: [])
