"""Figs. 6 to 9: the keelboat under the photogate and the ultrasonic rangefinder."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ..arrays import evaluate_route
from ..measurement import Measurement, PeriodTrend
from ..session import load
from .beats import of_periods
from .checks import GRAVITY_M_S2, Check, Computed, Inputs, by_route, compared, returned
from .drawing import COMPUTED_STYLE, PRINTED_STYLE, label, panels
from .parts import PaperFigure
from .print_data import printed
from .rigs import SEED, Hull, Lines, linear_damping, sideways_m, simulated_swing

YAW_DEG = 1.0
# Sway beside the yaw of the photogate's record: it makes the first modulation 1.8 %.
GATE_SWAY_M = 0.0058
GATE_SECONDS = 110.0
# The rangefinder of the paper: 20 ms, and a resolution of about 0.1 mm.
RANGE_STEP_S, RANGE_NOISE_M = 0.02, 1e-4
RANGE_SWAY_M = 0.04
FITTED_S = 50.0
# Of the samples one in so many is drawn.
SHOWN_EVERY = 10
SESSION = """\
format = "gyradius-session/1"
title = "{title}"
[body]
mass = {mass}
[[swing]]
id = "swing"
{source}
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = {length}
spacing = {spacing}
"""


def ultrasonic_hull() -> tuple[Hull, Lines]:
    """The keelboat on lines that have the periods of Table 2's first column."""
    return of_periods(printed("table2.1.yaw_period").value, printed("table2.1.sway_period").value)


def _released(sway_m: float, t_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far the stern is to port after a release in yaw and sway, with the paper's decay times, m."""
    hull, lines = ultrasonic_hull()
    damping = linear_damping(hull, printed("keelboat.tau_yaw").value, printed("keelboat.tau_sway").value)
    swing = simulated_swing(hull, lines, {"yaw_deg": YAW_DEG, "sway_m": sway_m}, [damping], t_s)
    return sideways_m(swing, -printed("keelboat.aft_mass").value)


def measured(table: Mapping[str, NDArray[np.float64]], source: str) -> Measurement:
    """Measure one table of a keelboat's swing as the core does any session."""
    hull, lines = ultrasonic_hull()
    text = SESSION.format(
        title="keelboat",
        mass=hull.mass_kg,
        source=source,
        length=lines.line_length_m,
        spacing=2.0 * lines.half_spacing_m,
    )
    rows = np.column_stack(list(table.values()))
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "session.toml").write_text(text, encoding="utf-8")
        np.savetxt(Path(folder) / "table.csv", rows, "%.9f", ",", header=",".join(table), comments="")
        return load(folder).measure()


def figure_6() -> PaperFigure:
    """Yaw periods at the stern, modulated by the sway."""
    t_s = np.arange(0.0, GATE_SECONDS, 0.01)
    at_s, period_s = _gate_periods(t_s, _released(GATE_SWAY_M, t_s))
    trend = measured({"t": at_s, "period": period_s}, 'periods = "table.csv"').swings[0].trend
    figure, (axes,) = panels()
    axes.plot(at_s, period_s, label="simulated photogate", **COMPUTED_STYLE)
    assert trend is not None
    _trend_line(axes, trend, at_s)
    axes.set_ylim(4.28, 4.54)
    label(axes, "time, s", "yaw period at the stern, s")
    axes.legend(loc="upper right", ncols=3)
    return PaperFigure(
        "6",
        "Yaw period with a modulation by sway",
        "The simulated keelboat (periods of Table 2, decay times 640 s and 124 s) passes a photogate at the stern; "
        "the line is (14) as the core fits it, with an amplitude of the modulation.",
        figure,
        "The periods of the print are in the picture alone. The sway is chosen so that the first modulation is 1.8 "
        f"%; it has {_last_modulation(trend, at_s):.1%} after {GATE_SECONDS:.0f} s. The print's goes down to 0.9 %, "
        "and does not say when.",
        errata=("modulation",),
    )


def _gate_periods(
    t_s: NDArray[np.float64], y_m: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """When the stern is back at the gate in the same direction, and the time since it was there before."""
    before = np.flatnonzero(np.sign(y_m[:-1]) != np.sign(y_m[1:]))
    fraction = y_m[before] / (y_m[before] - y_m[before + 1])
    crossings = t_s[before] + fraction * (t_s[1] - t_s[0])
    return crossings[2:], crossings[2:] - crossings[:-2]


def _trend_line(axes: Axes, trend: PeriodTrend, at_s: NDArray[np.float64]) -> None:
    """Draw (14); its time counts from the first period of the list."""
    wave = trend.modulation
    assert wave is not None
    t_s = np.linspace(0.0, at_s[-1] - at_s[0], 600)
    decay = 1.0 if wave.tau_m_s is None else np.exp(-t_s / wave.tau_m_s)
    line = trend.t0_s * (1.0 + trend.b_per_s * t_s)
    modulated = line + wave.c_s * decay * np.sin(2.0 * np.pi * t_s / wave.t_m_s + wave.phase_rad)
    axes.plot(at_s[0] + t_s, modulated, label="(14), fitted")
    axes.plot(at_s[0] + t_s, line, "--", color="grey", label=f"T_y0 = {trend.t0_s:.3f} s")


def _last_modulation(trend: PeriodTrend, at_s: NDArray[np.float64]) -> float:
    """The amplitude of the modulation at the last period, relative to the period."""
    wave = trend.modulation
    assert wave is not None
    decay = 1.0 if wave.tau_m_s is None else float(np.exp(-at_s[-1] / wave.tau_m_s))
    return wave.c_s * decay / trend.t0_s


def figure_7() -> PaperFigure:
    """The yaw gyradius with masses at the ends."""
    figure, (axes,) = panels()
    added = np.linspace(0.0, 4.0, 41)
    axes.plot(added, [1e3 * with_masses(float(mass)).value for mass in added], label="computed from k_y = 1056.6 mm")
    rows = [(printed(f"table1.{row}.added").value, printed(f"table1.{row}.gyradius").in_unit) for row in range(1, 8)]
    axes.plot(*np.array(rows).T, label="Table 1", **PRINTED_STYLE)
    label(axes, "mass added at each end, kg", "yaw gyradius, mm")
    axes.legend()
    return PaperFigure(
        "7",
        "Yaw gyradius with masses added at bow and stern",
        "k_y of the hull with equal masses 3.088 m forward and 2.717 m aft, beside the gyradii of Table 1. The "
        "line is no fit.",
        figure,
        checks=(_largest_deviation(),),
    )


def _largest_deviation() -> Check:
    """How far Table 1 is from the line, relative: the precision that the text claims."""
    apart = []
    for row in range(1, 8):
        line = with_masses(printed(f"table1.{row}.added").value).value
        apart.append(abs(printed(f"table1.{row}.gyradius").value / line - 1.0))
    return compared("largest deviation of Table 1 from the line", "fig7.precision", Computed(max(apart), 0.0, "Fig. 7"))


def with_masses(added_kg: float) -> Computed:
    """The keelboat's yaw gyradius with a mass at each end."""
    inputs: Inputs = {
        "mass_kg": printed("keelboat.mass"),
        "gyradius_m": printed("table1.1.gyradius"),
        "added_kg": added_kg,
        "fore_m": printed("keelboat.fore_mass"),
        "aft_m": printed("keelboat.aft_mass"),
    }
    return by_route("end_masses", "gyradius_m", inputs, "Fig. 7")


def _range_record(seconds: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    t_s = np.arange(0.0, seconds, RANGE_STEP_S)
    noise = np.random.default_rng(SEED).normal(0.0, RANGE_NOISE_M, t_s.size)
    return t_s, _released(RANGE_SWAY_M, t_s) + noise


def figure_8() -> PaperFigure:
    """The stern before the rangefinder."""
    t_s, y_m = _range_record(300.0)
    figure, (axes,) = panels()
    axes.plot(t_s, 1e3 * y_m, linewidth=0.8)
    label(axes, "time, s", "displacement of the stern, mm")
    return PaperFigure(
        "8",
        "The stern after a release in yaw and sway",
        "The simulated keelboat with the periods of Table 2's first column and linear damping, τ_y = 640 s and τ_s "
        "= 124 s, as a rangefinder sees its stern every 20 ms with 0.1 mm of noise. The modulation goes before the "
        "oscillation does.",
        figure,
        f"The record is in the picture alone. Released here at {YAW_DEG:.0f}° and {1e2 * RANGE_SWAY_M:.0f} cm. The "
        "depth of the centre of mass below the suspension points is not printed; 465 mm is assumed, its depth "
        "below the hull datum point. " + _resonance(),
    )


def _resonance() -> str:
    """What the text's ratio of k_p to l2 would mean on these lines."""
    _, lines = ultrasonic_hull()
    gyradius, ratio = printed("table4.both.k_pitch").value, printed("fig16.keelboat_ratio")
    hull = {"gyradius_m": gyradius, "cm_depth_m": gyradius / ratio.value}
    on_lines = {"line_length_m": lines.line_length_m, "gravity_m_s2": GRAVITY_M_S2}
    period_s = evaluate_route("double_pendulum_periods", {**hull, **on_lines})["in_phase_period_s"]
    return (
        f"With the text's rough k_p / l2 = {ratio.text} for keelboats the in-phase pitch would have a period of "
        f"{period_s:.2f} s beside the yaw's {printed('table2.1.yaw_period').value:.2f} s, and the two would "
        "exchange energy."
    )


def figure_9() -> PaperFigure:
    """The two damped oscillations of the first 50 s, and their spectrum."""
    t_s, y_m = _range_record(FITTED_S)
    at = f'displacement = "table.csv"\nat = [{-printed("keelboat.aft_mass").value}, 0.0, 0.0]'
    result = measured({"t": t_s, "y": y_m}, at)
    _, at_s, samples, fit = result.fits("swing")[0]
    figure, axes = panels(2, 1, height=5.6)
    axes[0].plot(at_s, 1e3 * fit[0], linewidth=1.0, label="(15), fitted")
    shown = slice(None, None, SHOWN_EVERY)
    axes[0].plot(at_s[shown], 1e3 * samples[0][shown], ".", color="black", markersize=3, label="simulated")
    label(axes[0], "time, s", "stern, mm")
    axes[0].set_ylim(-125.0, 125.0)
    axes[0].legend(loc="upper right", ncols=2)
    periods = {mode.mode: mode.period_s for mode in result.swings[0].modes}
    spectrum(axes[1], result, periods, 0.5)
    return PaperFigure(
        "9",
        "Fit of two damped oscillations, and spectrum",
        "The first 50 s of Fig. 8: (15) as the core fits it, and the amplitude spectrum with the frequencies of "
        "the fit.",
        figure,
        "Samples are simulated with the periods of Table 2, which the fit must return.",
        tuple(_fit_checks(periods)),
    )


def _fit_checks(periods: Mapping[str, float]) -> list[Check]:
    return [
        returned(f"{mode} period, fitted", f"table2.1.{mode}_period", periods[mode], "(15)") for mode in ("yaw", "sway")
    ]


def spectrum(
    axes: Axes, result: Measurement, periods_s: Mapping[str, float], highest_hz: float, channel: int = 0
) -> None:
    """The amplitude spectrum of one channel of the only record, and lines at given periods."""
    frequency, amplitude = result.spectrum(result.recorded_swings[0])
    shown = frequency <= highest_hz
    height = amplitude[channel][shown]
    axes.plot(frequency[shown], height / height.max(), color="C0", linewidth=1.0)
    for place, (name, period) in enumerate(periods_s.items()):
        text = f"{name.replace('_', ' ')}, {period:.3f} s"
        axes.axvline(1.0 / period, color=f"C{place + 1}", linestyle="--", label=text)
    axes.set_xlim(0.0, highest_hz)
    label(axes, "frequency, Hz", "amplitude, relative")
    axes.legend()
