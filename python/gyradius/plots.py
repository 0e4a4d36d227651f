"""Pictures of a measurement and of its criticism: recordings with their fits and spectra, residuals of simulations.

All arrays come from the core; here they are only drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .critique import Critique, SwingTrace
    from .measurement import Measurement, ModeResult

# Inches.
WIDTH, ROW_HEIGHT, TRACE_HEIGHT = 12.0, 5.0, 3.0
# What channels measure and its unit; the gyroscope's begin with `g`, the accelerometer's with `a`.
MEASURES = {"angle": ("angle", "rad"), "rate": ("rate", "rad/s"), "y": ("displacement", "m")}
MEASURES_BY_SENSOR = {"g": ("rate", "rad/s"), "a": ("specific force", "m/s²")}
# The spectrum shows so many times the highest mode's frequency; above it there is noise.
FREQUENCY_MARGIN = 4.0


def figure(measurement: Measurement, swing_ids: Sequence[str] = ()) -> Figure:
    """One column for each sensor of each swing that has a recording, and one for its spectrum."""
    from matplotlib.figure import Figure

    drawn = recorded(measurement, swing_ids)
    page = Figure(figsize=(WIDTH, ROW_HEIGHT * len(drawn)), layout="constrained")
    for part, id_ in zip(page.subfigures(len(drawn), 1, squeeze=False).flat, drawn, strict=True):
        _swing(part, measurement, id_)
    return page


def recorded(measurement: Measurement, swing_ids: Sequence[str] = ()) -> list[str]:
    """The swings to draw: those that have a recording, or the named ones among them."""
    drawn = [id_ for id_ in measurement.recorded_swings if not swing_ids or id_ in swing_ids]
    if not drawn:
        raise _core.NoResultError("no recording to draw: the periods of these swings were typed in")
    return drawn


def traced(critique: Critique, swing_ids: Sequence[str] = ()) -> list[SwingTrace]:
    """The swings to draw: those that the simulation was fitted to, or the named ones among them."""
    drawn = [trace for trace in critique.traces if not swing_ids or trace.swing in swing_ids]
    if not drawn:
        raise _core.NoResultError("no swing to draw: the simulation was fitted to none")
    return drawn


def unit_of(channels: Sequence[str]) -> str:
    """The unit that channels of one sensor share."""
    return _measure(channels)[1]


def measure_of(channels: Sequence[str]) -> str:
    """What channels of one sensor measure, with its unit: ``rate, rad/s``."""
    return ", ".join(_measure(channels))


def _measure(channels: Sequence[str]) -> tuple[str, str]:
    first = channels[0]
    return MEASURES.get(first) or MEASURES_BY_SENSOR.get(first[:1], (first, ""))


def highest_frequency_hz(measurement: Measurement, swing_id: str, last_hz: float) -> float:
    """Where the axis of a spectrum ends that begins at 0 and holds ``last_hz`` at most."""
    modes = modes_of(measurement, swing_id)
    highest = max((1.0 / mode.period_observed_s for mode in modes), default=last_hz)
    return min(FREQUENCY_MARGIN * highest, last_hz)


def modes_of(measurement: Measurement, swing_id: str) -> tuple[ModeResult, ...]:
    """The modes of a swing."""
    return next(swing for swing in measurement.swings if swing.id == swing_id).modes


def residuals(critique: Critique, swing_ids: Sequence[str] = ()) -> Figure:
    """A row for each swing that was fitted: measured and simulated, and what each simulation leaves over the noise."""
    from matplotlib.figure import Figure

    drawn = traced(critique, swing_ids)
    page = Figure(figsize=(WIDTH, TRACE_HEIGHT * len(drawn)), layout="constrained")
    for axes, trace in zip(page.subplots(len(drawn), 3, squeeze=False, sharex="row"), drawn, strict=True):
        _overlaid(axes[0], trace)
        _over_noise(axes[1], trace, trace.base, "residual of the base simulation")
        _over_noise(axes[2], trace, trace.extended, "residual of the extended simulation")
    return page


def _overlaid(axes: Axes, trace: SwingTrace) -> None:
    axes.plot(trace.t_s, trace.measured, ".", color="grey", markersize=1.5, label="measured")
    axes.plot(trace.t_s, trace.base, color="C1", linewidth=0.8, label="base")
    axes.plot(trace.t_s, trace.extended, color="C0", linewidth=0.8, label="extended")
    axes.set_title(f"{trace.swing}: {trace.channel}", fontsize="small")
    axes.set_ylabel(f"{trace.channel}, {trace.unit}", fontsize="small")
    axes.legend(fontsize="x-small", loc="upper right", ncols=3, markerscale=4.0)
    axes.set_xlabel("t, s")


def _over_noise(axes: Axes, trace: SwingTrace, simulated: NDArray[np.float64], title: str) -> None:
    left = (trace.measured - simulated) / trace.noise
    axes.plot(trace.t_s, left, ".", markersize=1.0, color="C0", label="residual")
    axes.axhspan(-1.0, 1.0, color="C1", alpha=0.3, label=f"noise, ±{trace.noise:.2g} {trace.unit}")
    rms = float(np.sqrt(np.mean(left**2)))
    axes.set_title(f"{title} (rms {rms:.3g})", fontsize="small")
    axes.set_ylabel("residual / noise", fontsize="small")
    axes.legend(fontsize="x-small", loc="upper right", ncols=2, markerscale=6.0)
    axes.set_xlabel("t, s")


def _swing(part: Any, measurement: Measurement, swing_id: str) -> None:
    sensors = measurement.fits(swing_id)
    part.suptitle(f"Swing {swing_id}")
    axes = part.subplots(2, len(sensors) + 1, squeeze=False, height_ratios=(2, 1), sharex="col")
    names = channel_names(sensors)
    for column, (labels, t_s, samples, fit) in enumerate(sensors):
        colours = [f"C{names.index(label)}" for label in labels]
        _record(axes[0][column], labels, colours, t_s, samples, fit)
        _residual(axes[1][column], labels, colours, t_s, samples - fit)
    axes[1][-1].remove()
    axes[0][-1].tick_params(labelbottom=True)
    _spectrum(axes[0][-1], measurement, swing_id, sensors)


def _record(
    axes: Axes,
    labels: Sequence[str],
    colours: Sequence[str],
    t_s: NDArray[np.float64],
    samples: NDArray[np.float64],
    fit: NDArray[np.float64],
) -> None:
    for channel, (label, colour) in enumerate(zip(labels, colours, strict=True)):
        # Levels differ by gravity: each channel is drawn about its own.
        level = float(np.mean(fit[channel]))
        axes.plot(t_s, samples[channel] - level, ".", color=colour, markersize=1.0, alpha=0.4)
        axes.plot(t_s, fit[channel] - level, color=colour, linewidth=0.8, label=label)
    axes.set_title("samples (dots) and fit (lines), less their level", fontsize="small")
    axes.set_ylabel(measure_of(labels), fontsize="small")
    axes.legend(fontsize="x-small", loc="upper right", ncols=len(labels))


def _residual(
    axes: Axes,
    labels: Sequence[str],
    colours: Sequence[str],
    t_s: NDArray[np.float64],
    residual: NDArray[np.float64],
) -> None:
    for colour, channel in zip(colours, residual, strict=True):
        axes.plot(t_s, channel, linewidth=0.4, color=colour)
    axes.set_title("residual, in the same colours", fontsize="small")
    axes.set_ylabel(f"residual, {unit_of(labels)}", fontsize="small")
    axes.set_xlabel("t, s")


def _spectrum(axes: Axes, measurement: Measurement, swing_id: str, sensors: Sequence[Any]) -> None:
    frequency, amplitude = measurement.spectrum(swing_id)
    for label, channel in zip(channel_names(sensors), amplitude, strict=True):
        axes.semilogy(frequency, channel, linewidth=0.6, label=label)
    for mode in modes_of(measurement, swing_id):
        axes.axvline(1.0 / mode.period_observed_s, color="grey", linewidth=0.5, linestyle="--")
        axes.annotate(
            mode.mode,
            (1.0 / mode.period_observed_s, 0.98),
            xycoords=("data", "axes fraction"),
            rotation=90,
            fontsize="x-small",
            va="top",
            ha="right",
        )
    axes.set_xlim(0.0, highest_frequency_hz(measurement, swing_id, float(frequency[-1])))
    axes.set_title("amplitude spectrum", fontsize="small")
    axes.set_xlabel("frequency, Hz")
    axes.set_ylabel(f"amplitude, {units_of(sensors)}", fontsize="small")
    axes.legend(fontsize="x-small", loc="upper right", ncols=2)


def channel_names(sensors: Sequence[Any]) -> list[str]:
    """Names of the channels of all sensors, in their order."""
    return [label for labels, *_ in sensors for label in labels]


def units_of(sensors: Sequence[Any]) -> str:
    """Units of all sensors: ``rad/s or m/s²``."""
    return " or ".join(dict.fromkeys(unit_of(labels) for labels, *_ in sensors))
