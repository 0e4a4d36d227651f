"""The paper's two hulls on their lines, simulated by the core."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..simulation import Simulation, simulate
from .checks import GRAVITY_M_S2
from .print_data import printed

#: Noise of a phone's sensors that is far below the motion, and what its chance begins with.
NOISE = {"id": "white_noise", "gyro_rad_s": 1e-4, "acc_m_s2": 1e-3}
SEED = 2014


@dataclass(frozen=True, slots=True)
class Hull:
    """What hangs."""

    mass_kg: float
    k_yaw_m: float
    k_pitch_m: float
    k_roll_m: float
    cm_depth_m: float


@dataclass(frozen=True, slots=True)
class Lines:
    """How it hangs."""

    line_length_m: float
    half_spacing_m: float
    orientation: str = "athwartships"


def keelboat(k_yaw_m: float | None = None) -> Hull:
    """The keelboat, its depth counted from the hull datum point: that of the suspension points is not printed.

    With the text's rough k_p / l2 = 1.5 instead, pitch would be in resonance with yaw on these lines.
    """
    return Hull(
        mass_kg=printed("keelboat.mass").value,
        k_yaw_m=printed("table4.both.k_yaw").value if k_yaw_m is None else k_yaw_m,
        k_pitch_m=printed("table4.both.k_pitch").value,
        k_roll_m=printed("keelboat.k_roll").value,
        cm_depth_m=-printed("table4.both.z").value,
    )


def keelboat_lines(line_length_m: float | None = None) -> Lines:
    """The keelboat's suspension, as it is printed or with lines of another length."""
    length = printed("keelboat.line_length").value if line_length_m is None else line_length_m
    return Lines(length, printed("keelboat.half_spacing").value)


def model(row: int) -> Hull:
    """The model hull as a row of Table 3 has it; what a row leaves empty comes from another."""
    k_pitch = printed("table3.2.k_pitch" if row == 7 else f"table3.{row}.k_pitch")
    return Hull(
        mass_kg=printed("model.mass").value,
        k_yaw_m=printed(f"table3.{row}.k_yaw").value,
        k_pitch_m=k_pitch.value,
        k_roll_m=printed("table3.7.k_roll").value,
        cm_depth_m=printed(f"table3.{row}.depth").value,
    )


def model_lines(row: int) -> Lines:
    """The model hull's suspension in a row of Table 3."""
    length, half = printed(f"table3.{row}.line_length").value, printed(f"table3.{row}.half_spacing").value
    return Lines(length, half, "fore_and_aft" if row == 7 else "athwartships")


def rig(
    hull: Hull,
    suspension: Mapping[str, Any],
    start: Mapping[str, float],
    effects: Sequence[Mapping[str, Any]] = (),
) -> dict[str, Any]:
    """A rig of one swing, as :func:`gyradius.simulate` takes it."""
    truth = {
        "k_yaw_m": hull.k_yaw_m,
        "k_pitch_m": hull.k_pitch_m,
        "k_roll_m": hull.k_roll_m,
        "cm_depth_m": hull.cm_depth_m,
        "gravity_m_s2": GRAVITY_M_S2,
    }
    swing = {"id": "swing", "recording": "swing.csv", "suspension": dict(suspension), "truth": dict(start)}
    body = {"mass": hull.mass_kg}
    return {"title": "paper", "body": body, "truth": truth, "effect": list(effects), "swing": [swing]}


def bifilar(lines: Lines) -> dict[str, Any]:
    """The keys of two lines."""
    return {
        "kind": "bifilar",
        "orientation": lines.orientation,
        "line_length": lines.line_length_m,
        "spacing": 2.0 * lines.half_spacing_m,
    }


def simulated_swing(
    hull: Hull,
    lines: Lines,
    start: Mapping[str, float],
    effects: Sequence[Mapping[str, Any]] = (),
    t_s: NDArray[np.float64] | None = None,
) -> Simulation:
    """A swing on two lines; the sensors' noise is always the same."""
    return simulate(rig(hull, bifilar(lines), start, [*effects, NOISE]), t_s=t_s, seed=SEED)


def linear_damping(hull: Hull, tau_yaw_s: float, tau_sway_s: float) -> dict[str, Any]:
    """The core's linear damping with the decay times of yaw and sway: the coefficient is 2 I / τ, or 2 M / τ."""
    yaw = 2.0 * hull.mass_kg * hull.k_yaw_m**2 / tau_yaw_s
    return {"id": "linear_damping", "sway_n_s_m": 2.0 * hull.mass_kg / tau_sway_s, "yaw_n_m_s": yaw}


def sideways_m(swing: Simulation, forward_m: float) -> NDArray[np.float64]:
    """How far to port a point is that lies so far forward of the centre of mass, m."""
    w, x, y, z = swing.attitude.T
    return np.asarray(swing.position_m[:, 1] + forward_m * 2.0 * (x * y + w * z))
