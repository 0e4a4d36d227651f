"""Friction and drag, and air that moves along. Strength: the time in which a motion of usual size would decay."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from borrowed import blind
from effect import EFFECTS, Session, everywhere, register
from forces import POWER_REFERENCE
from scipy.special import gamma

X, Y, Z, PITCH, YAW = 0, 1, 2, 4, 5  # of the six drag coefficients


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


def one_axis(make: Callable, along: tuple = (X, Y, PITCH, YAW)) -> Callable:
    """Probes of drag in surge, sway, pitch and yaw, each alone."""
    return lambda session: [make([1000.0 if i == k else np.inf for i in range(6)]) for k in along]


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
    for scene, hung in zip(session.scenes, session.hungs):
        scene.extras["added_omega"] = [hung.modes[mode].omega_rad_s for mode in ("sway", "in_phase", "yaw")]


def draw_added(rng, session: Session) -> dict:
    """Sway, pitch, yaw."""
    return {"share_at_usual": (blind.log_uniform(rng, 2e-4, 1e-2) * np.exp(rng.normal(0, 0.4, 3))).tolist()}


register(
    EFFECTS, "quadratic_drag", lambda rng, _: {"decay_s": draw_times(rng, 100, 5000)},
    put_quadratic, one_axis(lambda times: {"decay_s": times}),
)  # fmt: skip
register(
    EFFECTS, "power_law_damping", lambda rng, _: {"exponent": rng.uniform(1.3, 1.7), "decay_s": draw_times(rng, 100, 5000)},
    put_power, one_axis(lambda times: {"exponent": 1.5, "decay_s": times}),
)  # fmt: skip
register(
    EFFECTS, "bearing_friction", lambda rng, _: {"decay_s": draw_times(rng, 400, 20000)},
    put_coulomb, one_axis(lambda times: {"decay_s": times}),
)  # fmt: skip
register(
    EFFECTS, "presliding_bearing",
    lambda rng, _: {"give_rad": blind.log_uniform(rng, 5e-3, 5e-2), "decay_s": draw_times(rng, 400, 20000)},
    put_presliding, one_axis(lambda times: {"give_rad": 0.015, "decay_s": times}, (Y, PITCH, YAW)),
)  # fmt: skip
register(
    EFFECTS, "amplitude_added_mass", draw_added,
    put_added, lambda _: [{"share_at_usual": row.tolist()} for row in 1e-3 * np.eye(3)],
)  # fmt: skip
