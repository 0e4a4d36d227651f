"""Figs. 3 and 4: yaw and sway together, seen at one end of the hull, beat."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ..arrays import evaluate_route
from .checks import GRAVITY_M_S2, Check, Computed, Inputs, by_function, by_route, compared
from .drawing import label, panels
from .parts import PaperFigure
from .print_data import Printed, printed
from .rigs import Hull, Lines, keelboat, keelboat_lines, sideways_m, simulated_swing

# Of the yaw and of the sway at the end that is seen; small enough for (9), and not printed.
AMPLITUDE_M = 0.02


def figure_3() -> PaperFigure:
    """Two equal oscillations of the keelboat, and their beat."""
    periods: dict[str, Printed] = {f"{name}_period_s": printed(f"fig3.{name}_period") for name in ("yaw", "sway")}
    found = evaluate_route("beat", {name: period.value for name, period in periods.items()})
    hull, lines = of_periods(**{name: period.value for name, period in periods.items()})
    t_s = np.linspace(0.0, 70.0, 2801)
    figure, (axes,) = panels()
    _beat(axes, t_s, _stern_m(hull, lines, t_s), found["beat_period_s"])
    label(axes, "time, s", "displacement of the stern, mm")
    return PaperFigure(
        "3",
        "Sum of two equal oscillations",
        "The simulated keelboat, released with the stern at its rest position and the bow moved to one side; line "
        "length and gyradius give periods of 4.39 s and 3.83 s. Dashed: the envelope of (9) with the beat period "
        "of (11).",
        figure,
        f"The amplitude is chosen here ({1e3 * AMPLITUDE_M:.0f} mm each).",
        tuple(_beat_checks(periods)),
        ("envelope",),
    )


def of_periods(yaw_period_s: float, sway_period_s: float) -> tuple[Hull, Lines]:
    """The keelboat with the gyradius and the line length that have these periods."""
    length = evaluate_route("line_length_from_sway", {"sway_period_s": sway_period_s, "gravity_m_s2": GRAVITY_M_S2})
    lines = keelboat_lines(length["line_length_m"])
    inputs = {"yaw_period_s": yaw_period_s, "sway_period_s": sway_period_s, "half_spacing_m": lines.half_spacing_m}
    return keelboat(evaluate_route("ratio_gyradius", inputs)["gyradius_m"]), lines


def _stern_m(hull: Hull, lines: Lines, t_s: NDArray[np.float64]) -> NDArray[np.float64]:
    aft_m = printed("keelboat.aft_mass").value
    start = {"yaw_deg": float(np.degrees(np.arcsin(AMPLITUDE_M / aft_m))), "sway_m": AMPLITUDE_M}
    return sideways_m(simulated_swing(hull, lines, start, t_s=t_s), -aft_m)


def _beat(axes: Axes, t: NDArray[np.float64], y_m: NDArray[np.float64], beat_period: float) -> None:
    axes.plot(t, 1e3 * y_m, linewidth=1.0, label="simulated")
    envelope = 2e3 * AMPLITUDE_M * np.abs(np.sin(np.pi * t / beat_period))
    axes.plot(t, envelope, "--", color="C1", label="envelope, (9) and (11)")
    axes.plot(t, -envelope, "--", color="C1")
    axes.set_ylim(-2.9e3 * AMPLITUDE_M, 2.9e3 * AMPLITUDE_M)
    axes.legend(loc="upper right", ncols=2)


def _beat_checks(periods: Inputs) -> list[Check]:
    def by_beat(output: str) -> Computed:
        return by_route("beat", output, periods, "(9)–(12)")

    ratio = by_function(lambda given: given["yaw_period_s"] / given["sway_period_s"], periods, "(8)")
    checks = [
        compared("average period", "fig3.average_period", by_beat("average_period_s")),
        compared("beat period", "fig3.beat_period", by_beat("beat_period_s")),
        compared("oscillations per beat", "fig3.per_beat", by_beat("oscillations_per_beat")),
        compared("period ratio", "fig3.ratio", ratio),
    ]
    for name in ("7_5", "7"):
        counted = counted_ratio(printed(f"fig3.counted_{name}"))
        error = Computed(counted.value / ratio.value - 1.0, ratio.spread / ratio.value, "(13)")
        checks.append(compared(f"ratio for n = {name.replace('_', '.')}", f"fig3.ratio_{name}", counted))
        checks.append(compared(f"its error for n = {name.replace('_', '.')}", f"fig3.error_{name}", error))
    return checks


def counted_ratio(per_beat: Printed) -> Computed:
    """The period ratio from the oscillations counted per beat, yaw being the slower."""
    inputs: Inputs = {"oscillations_per_beat": per_beat, "half_spacing_m": 1.0, "yaw_is_slower": 1.0}
    return by_route("beat_gyradius", "period_ratio", inputs, "(13)")


def figure_4() -> PaperFigure:
    """The beat of a hull whose gyradius is close to half of the spacing."""
    ratio = counted_ratio(printed("fig4.per_beat"))
    sway = evaluate_route(
        "sway_period", {"line_length_m": keelboat_lines().line_length_m, "gravity_m_s2": GRAVITY_M_S2}
    )
    sway_s = sway["sway_period_s"]
    hull, lines = of_periods(ratio.value * sway_s, sway_s)
    found = evaluate_route("beat", {"yaw_period_s": ratio.value * sway_s, "sway_period_s": sway_s})
    average_s = found["average_period_s"]
    oscillations = np.linspace(0.0, 55.0, 4401)
    figure, (axes,) = panels()
    y_m = _stern_m(hull, lines, oscillations * average_s)
    _beat(axes, oscillations, y_m, found["oscillations_per_beat"])
    label(axes, "time, average periods of (10)", "displacement of one end, mm")
    return PaperFigure(
        "4",
        "Beat of 25 oscillations",
        "A simulated hull with k_y = 1.0408 d, which (13) gives for n = 25; time is counted in average periods, so "
        "that neither line length nor spacing matters.",
        figure,
        "The record of the dinghy is in the picture alone: neither its lines, its spacing nor its amplitudes are "
        "in the text. The damping that its picture may show is left out.",
        (compared("k_y / d", "fig4.ratio", ratio),),
    )
