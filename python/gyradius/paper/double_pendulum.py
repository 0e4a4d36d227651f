"""Figs. 11 to 14: the two modes of pitch and surge, or of roll and sway."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..arrays import decompose, evaluate_route
from ..measurement import Measurement
from ..session import load
from ..simulation import Simulation
from .checks import GRAVITY_M_S2, returned
from .drawing import label, panels
from .keelboat import spectrum
from .parts import PaperFigure
from .print_data import DEGREE
from .rigs import Hull, Lines, model, model_lines, simulated_swing

MODES = ("in_phase", "out_of_phase")
# Chosen: small enough for (16), and drawn larger.
SURGE_M, PITCH_DEG = 0.02, 1.0
RECORD_S = 40.0
# Place of the pitch rate among the channels of a recording.
PITCH_RATE = 1
# Row of Table 3 with the 504 mm suspension, and the one hung fore and aft.
SHORT_ROW, ROLL_ROW = 1, 7
# Angle of the lines in the sketches of the modes.
DRAWN_RAD = 12.0 * DEGREE


@dataclass(frozen=True, slots=True)
class ModeShape:
    """A mode of the double pendulum."""

    period_s: float
    #: Turn of the hull for each metre that its centre of mass moves, rad/m; positive where hull and lines lean alike.
    turn_per_m: float


def turned_and_moved(swing: Simulation, lines: Lines) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Turn of the hull about the line's direction, rad, and displacement of its centre of mass across it, m."""
    axis, across = (1, 1) if lines.orientation == "fore_and_aft" else (2, 0)
    # Bow down moves the centre of mass back below the points: the sign makes both lean alike.
    sign = 1.0 if lines.orientation == "fore_and_aft" else -1.0
    return sign * 2.0 * swing.attitude[:, axis], swing.position_m[:, across]


def modes(hull: Hull, lines: Lines) -> dict[str, ModeShape]:
    """Period and shape of both modes, from the decomposition of a small simulated motion."""
    start = {"sway_m" if lines.orientation == "fore_and_aft" else "surge_m": SURGE_M, "duration_s": RECORD_S}
    swing = simulated_swing(hull, lines, start)
    turn, moved = turned_and_moved(swing, lines)
    noise = np.random.default_rng(1).normal(0.0, 1e-7, (2, turn.size))
    found = decompose(swing.t_s, [turn + noise[0], moved + noise[1]]).modes
    slow, fast = sorted(found[:2], key=lambda mode: -mode.period_s)
    return {
        name: ModeShape(mode.period_s, float((mode.shape[0] / mode.shape[1]).real))
        for name, mode in zip(MODES, (slow, fast), strict=True)
    }


def figure_11() -> PaperFigure:
    """The modes of pitch and surge."""
    return PaperFigure(
        "11",
        "The two modes of pitch and surge",
        "Model hull, first row of Table 3, seen from the side: lines (grey), hull (blue), centre of mass (dot), as "
        "the simulation moves and the core decomposes them; turns are enlarged. Left: in phase, the long period. "
        "Right: out of phase, the short one.",
        _sketch(model(SHORT_ROW), model_lines(SHORT_ROW), "surge"),
        "In print a is mode 1 and b is mode 2.",
        errata=("mode-names",),
    )


def figure_12() -> PaperFigure:
    """The modes of roll and sway."""
    return PaperFigure(
        "12",
        "The two modes of roll and sway",
        "As Fig. 11, on the fore-and-aft suspension of Table 3's last row, seen from astern.",
        _sketch(model(ROLL_ROW), model_lines(ROLL_ROW), "sway"),
        "In print the figure is a sketch of the suspension.",
    )


def _sketch(hull: Hull, lines: Lines, motion: str) -> Figure:
    figure, axes = panels(columns=2, height=4.0, sharex=True, sharey=True)
    for panel, (name, mode) in zip(axes, modes(hull, lines).items(), strict=True):
        for side, alpha in ((1.0, 1.0), (-1.0, 0.3)):
            _pendulum(panel, hull, lines, mode, side, alpha)
        panel.axvline(0.0, color="grey", linestyle=":", linewidth=0.8)
        label(panel, f"{motion}, m", "height, m", f"{name.replace('_', ' ')}, T = {mode.period_s:.3f} s")
        panel.set_aspect("equal")
    return figure


def _pendulum(axes: Axes, hull: Hull, lines: Lines, mode: ModeShape, side: float, alpha: float) -> None:
    # The larger of the two angles is drawn with the chosen size.
    line_per_m = (1.0 - hull.cm_depth_m * mode.turn_per_m) / lines.line_length_m
    scale = side * DRAWN_RAD / max(abs(line_per_m), abs(mode.turn_per_m))
    first, second = scale * line_per_m, scale * mode.turn_per_m
    point = lines.line_length_m * np.array([np.sin(first), -np.cos(first)])
    down, along = np.array([np.sin(second), -np.cos(second)]), np.array([np.cos(second), np.sin(second)])
    centre = point + hull.cm_depth_m * down
    half = 0.3 if lines.orientation == "athwartships" else 0.14
    axes.plot(*np.array([(0.0, 0.0), point]).T, color="grey", alpha=alpha)
    deck = np.array([point + half * along, point - half * along, centre, point + half * along])
    axes.plot(*deck.T, color="C0", alpha=alpha)
    axes.plot(*centre, "o", color="C0", alpha=alpha)


def _records() -> dict[str, Simulation]:
    """The model hull on 504 mm lines: let go in surge, and in each mode alone."""
    hull, lines = model(SHORT_ROW), model_lines(SHORT_ROW)
    found = {"surge": simulated_swing(hull, lines, {"surge_m": SURGE_M, "duration_s": RECORD_S})}
    for name, mode in modes(hull, lines).items():
        pitch_rad = PITCH_DEG * DEGREE
        moved_m = pitch_rad / mode.turn_per_m
        # A start names the place of the suspension points, and bow up.
        start = {"surge_m": moved_m - hull.cm_depth_m * pitch_rad, "pitch_deg": PITCH_DEG, "duration_s": RECORD_S}
        found[name] = simulated_swing(hull, lines, start)
    return found


def figure_13() -> PaperFigure:
    """What a gyroscope reads of the double pendulum."""
    figure, axes = panels(3, 1, height=6.2, sharex=True)
    titles = ("moved in surge and let go: both modes", "in-phase mode alone", "out-of-phase mode alone")
    for panel, swing, title in zip(axes, _records().values(), titles, strict=True):
        shown = swing.t_s <= 20.0
        panel.plot(swing.t_s[shown], swing.gyro_rad_s[shown, 1] / DEGREE, linewidth=1.0)
        label(panel, "", "pitch rate, °/s", title)
    axes[-1].set_xlabel("time, s")
    return PaperFigure(
        "13",
        "Double pendulum of the model hull on 504 mm lines",
        "The pitch rate that a phone reads on the simulated hull (first row of Table 3).",
        figure,
        f"The record is in the picture alone; amplitudes are chosen here ({1e3 * SURGE_M:.0f} mm of surge; "
        f"{PITCH_DEG:.0f}° of pitch), and damping is left out.",
        errata=("mode-names",),
    )


def figure_14() -> PaperFigure:
    """The spectrum of the double pendulum's record."""
    hull, lines = model(SHORT_ROW), model_lines(SHORT_ROW)
    inputs = {"gyradius_m": hull.k_pitch_m, "cm_depth_m": hull.cm_depth_m, "line_length_m": lines.line_length_m}
    periods = evaluate_route("double_pendulum_periods", {**inputs, "gravity_m_s2": GRAVITY_M_S2})
    figure, (axes,) = panels()
    swing = simulated_swing(hull, lines, {"surge_m": SURGE_M, "duration_s": RECORD_S})
    by_16 = {name: periods[f"{name}_period_s"] for name in MODES}
    spectrum(axes, _bare_recording(swing), by_16, 2.0, PITCH_RATE)
    found = double_pendulum(hull, lines)
    return PaperFigure(
        "14",
        "Spectrum of the double pendulum",
        "Amplitude spectrum of the first record of Fig. 13, and the frequencies of (16).",
        figure,
        "The print's spectrum is in the picture alone.",
        (
            returned("k_p by (18)", f"table3.{SHORT_ROW}.k_pitch", found["gyradius_m"], "(17), (18)"),
            returned("l2 by (17)", f"table3.{SHORT_ROW}.depth", found["cm_depth_m"], "(17), (18)"),
        ),
    )


def _bare_recording(swing: Simulation) -> Measurement:
    """What the phone reads, measured as any bare recording."""
    table = np.column_stack([swing.t_s, swing.gyro_rad_s, swing.acc_m_s2])
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "swing.csv"
        np.savetxt(file, table, "%.9f", ",", header="t,gx,gy,gz,ax,ay,az", comments="")
        return load(file).measure()


def double_pendulum(hull: Hull, lines: Lines) -> dict[str, float]:
    """Gyradius and depth by (17) and (18) from the periods of a simulated record."""
    inputs = {f"{name}_period_s": mode.period_s for name, mode in modes(hull, lines).items()}
    known = {"line_length_m": lines.line_length_m, "gravity_m_s2": GRAVITY_M_S2}
    return evaluate_route("double_pendulum_from_length", {**inputs, **known})
