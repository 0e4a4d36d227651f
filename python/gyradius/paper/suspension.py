"""Figs. 19 and 21: the incline test, the compound pendulum, and the square frame."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from ..arrays import evaluate_route
from .checks import GRAVITY_M_S2
from .drawing import label, panels
from .parts import PaperFigure
from .print_data import DEGREE, printed

GRAVITY = {"gravity_m_s2": GRAVITY_M_S2}
# Chosen: none of them is printed.
INCLINING_KG = (0.25, 0.5, 1.0)
AXIS_HEIGHTS_M = np.linspace(0.02, 0.6, 59)
CORNERS = {"A": (1, 1), "B": (0, 1), "C": (-1, 1), "D": (-1, 0), "E": (-1, -1), "F": (0, -1), "G": (1, -1), "H": (1, 0)}


def figure_19() -> PaperFigure:
    """The incline test of the model hull."""
    figure, (axes,) = panels()
    angles = np.linspace(2.0, 60.0, 117)
    for mass in INCLINING_KG:
        depths = [_inclined_depth_m(mass, float(angle) * DEGREE) for angle in angles]
        axes.plot(angles, 1e3 * np.array(depths), label=f"{1e3 * mass:.0f} g")
    depth = printed("fig15.depth")
    axes.axhline(1e3 * depth.value, color="grey", linestyle=":", label="l2 of Fig. 15")
    axes.set_ylim(0.0, 600.0)
    label(axes, "incline of the hull, °", "depth l2 of the centre of mass, mm")
    axes.legend()
    return PaperFigure(
        "19",
        "Incline test",
        "The depth that (20) gives for an incline, for several masses hung at the stern of the model hull (13.18 "
        "kg), half of its length from the suspension points and at their height.",
        figure,
        "In print the figure is the sketch of the inclined hull. No angle and no mass are printed: those here are "
        "chosen.",
    )


def _inclined_depth_m(mass_kg: float, angle_rad: float) -> float:
    ratio = mass_kg / printed("model.mass").value
    inputs = {"mass_ratio": ratio, "arm_m": printed("model.length").value / 2.0, "depth_m": 0.0, "angle_rad": angle_rad}
    return evaluate_route("incline_one_end", inputs)["cm_depth_m"]


def figure_21() -> PaperFigure:
    """The square frame with its suspension points, its gyradii, and the compound pendulum on it."""
    figure, axes = panels(2, 2, height=6.6)
    _frame(axes[0])
    _frame_gyradii(axes[1])
    _compound(axes[2], axes[3])
    return PaperFigure(
        "21",
        "Square frame, and the compound pendulum that hangs on it",
        "Top: the frame with its points, and its own gyradii by (27) below the deck of the model hull. Bottom: the "
        "period (22) of the model hull as a compound pendulum, and how the gyradius moves with it (24); thin lines "
        "mark the two printed l0, 305 mm and 441 mm.",
        figure,
        "In print the figure is the frame alone. The periods that gave the printed roll gyradius of 205 mm are not "
        "in the text.",
        errata=("slope",),
    )


def _frame(axes: Axes) -> None:
    ring = np.array([CORNERS[name] for name in "ACEGA"])
    axes.plot(ring[:, 1], ring[:, 0], color="C0")
    for name, (forward, port) in CORNERS.items():
        axes.plot(-port, forward, "o", color="C0")
        axes.annotate(name, (-1.2 * port, 1.2 * forward), ha="center", va="center")
    axes.annotate("forward", (0.0, 0.75), (0.0, -0.5), ha="center", arrowprops={"arrowstyle": "->"})
    axes.set(xlim=(-1.6, 1.6), ylim=(-1.6, 1.6), aspect="equal")
    label(axes, "to starboard, d", "forward, d", "suspension points")


def _frame_gyradii(axes: Axes) -> None:
    depth = printed("fig15.depth").value
    halves = np.linspace(0.05, 0.45, 41)
    inputs = ({"half_spacing_m": float(half), "cm_depth_m": depth} for half in halves)
    found = [evaluate_route("square_frame", one) for one in inputs]
    for name, text in (("k_roll_m", "roll and pitch"), ("k_yaw_m", "yaw")):
        axes.plot(2e3 * halves, [1e3 * one[name] for one in found], label=text)
    label(axes, "side 2d, mm", "gyradius of the frame, mm", "(27), l2 = 253 mm")
    axes.legend()


def _compound(period: Axes, slope: Axes) -> None:
    depth = printed("fig15.depth").value
    bodies = (("roll", printed("compound.k_roll").value), ("pitch", printed("fig15.k_pitch").value))
    for name, gyradius in bodies:
        points = [
            {"gyradius_m": gyradius, "axis_to_cm_m": depth + float(height), **GRAVITY} for height in AXIS_HEIGHTS_M
        ]
        periods = [evaluate_route("compound_period", point)["period_s"] for point in points]
        slopes = [evaluate_route("compound_slopes", point) for point in points]
        period.plot(1e3 * AXIS_HEIGHTS_M, periods, label=f"{name}, k = {1e3 * gyradius:.0f} mm")
        slope.plot(1e3 * AXIS_HEIGHTS_M, [one["by_axis_to_cm"] for one in slopes], label=f"∂k/∂a, {name}")
        slope.plot(1e3 * AXIS_HEIGHTS_M, [one["by_period_m_s"] for one in slopes], "--", label=f"∂k/∂T, {name}, m/s")
    for axes in (period, slope):
        for name in ("l0_short", "l0_long"):
            axes.axvline(printed(f"compound.{name}").in_unit, color="grey", linewidth=0.8)
    period.legend()
    slope.set_ylim(-2.2, 3.6)
    slope.legend(fontsize=8, ncols=2, loc="upper center")
    label(period, "l0, mm", "period, s", "compound pendulum, (22)")
    label(slope, "l0, mm", "slope", "slopes, (24)")
