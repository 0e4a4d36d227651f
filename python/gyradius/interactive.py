"""The pictures of a measurement and of its criticism for notebooks, where one can zoom into them; drawn by plotly.

They show the same arrays of the core as those of :mod:`gyradius.plots`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._core import InputError
from .plots import channel_names, highest_frequency_hz, measure_of, modes_of, recorded, traced, unit_of, units_of

if TYPE_CHECKING:
    from .critique import Critique, SwingTrace
    from .measurement import Measurement

# Pixels.
RECORD_HEIGHT, RESIDUAL_HEIGHT, TRACE_HEIGHT, GAP = 300, 170, 240, 90
MARGIN = {"t": 70, "b": 50}
COLUMN_GAP = 0.07
# One colour for each channel of a phone; measured, base and extended simulation.
COLOURS = ("#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b")
MEASURED, BASE, EXTENDED = "#7f7f7f", "#ff7f0e", "#1f77b4"

Place: TypeAlias = "tuple[int, int]"


def figure(measurement: Measurement, swing_ids: Sequence[str] = ()) -> Any:
    """Two rows for each swing: samples with their fit, and the residual; a column for each sensor and the spectrum."""
    subplots = _plotly()
    drawn = {id_: measurement.fits(id_) for id_ in recorded(measurement, swing_ids)}
    columns = max(map(len, drawn.values())) + 1
    heights = [RECORD_HEIGHT, RESIDUAL_HEIGHT] * len(drawn)
    page = _page(subplots, measurement.title, heights, columns, _titles(drawn, columns))
    for place, (id_, sensors) in enumerate(drawn.items()):
        row = 2 * place + 1
        for column, sensor in enumerate(sensors, start=1):
            _record(page, (row, column), channel_names(sensors), *sensor)
        _spectrum(page, (row, columns), measurement, id_, sensors)
    return page


def residuals(critique: Critique, swing_ids: Sequence[str] = ()) -> Any:
    """A row for each swing that was fitted: measured and simulated, and the residuals in units of the noise."""
    subplots = _plotly()
    drawn = traced(critique, swing_ids)
    titles: list[str] = []
    for trace in drawn:
        residuals_of = (f"residual of the {kind} simulation (band: noise)" for kind in ("base", "extended"))
        titles += [trace.swing, *(f"{trace.swing}: {residual}" for residual in residuals_of)]
    page = _page(subplots, critique.title, [TRACE_HEIGHT] * len(drawn), 3, titles)
    for row, trace in enumerate(drawn, start=1):
        _overlaid(page, (row, 1), trace)
        _over_noise(page, (row, 2), trace, trace.base, "base", BASE)
        _over_noise(page, (row, 3), trace, trace.extended, "extended", EXTENDED)
    return page


def _plotly() -> Any:
    try:
        from plotly import subplots
    except ImportError:
        raise InputError(
            "an interactive plot needs plotly: pip install 'gyradius[interactive]'; plot() draws without it"
        ) from None
    return subplots


def _page(subplots: Any, title: str, heights: list[int], columns: int, titles: list[str]) -> Any:
    height = sum(heights) + GAP * (len(heights) - 1)
    page = subplots.make_subplots(
        rows=len(heights),
        cols=columns,
        row_heights=heights,
        vertical_spacing=GAP / height,
        horizontal_spacing=COLUMN_GAP,
        subplot_titles=titles,
    )
    page.update_annotations(font={"size": 11})
    legend = {"itemsizing": "constant"}
    page.update_layout(
        title=title, height=height + sum(MARGIN.values()), margin=MARGIN, template="plotly_white", legend=legend
    )
    return page


def _titles(drawn: dict[str, list[Any]], columns: int) -> list[str]:
    titles = []
    for id_, sensors in drawn.items():
        blanks = [""] * (columns - 1 - len(sensors))
        shown = [f"{id_}: samples (dots) and fit (lines), less their level"] * len(sensors)
        titles += [*shown, *blanks, f"{id_}: amplitude spectrum"]
        titles += [*[f"{id_}: residual"] * len(sensors), *blanks, ""]
    return titles


def _record(
    page: Any,
    place: Place,
    channels: Sequence[str],
    labels: Sequence[str],
    t_s: NDArray[np.float64],
    samples: NDArray[np.float64],
    fit: NDArray[np.float64],
) -> None:
    (row, column), unit = place, unit_of(labels)
    for channel, label in enumerate(labels):
        colour = _colour(channels, label)
        level = float(np.mean(fit[channel]))
        measured, fitted = samples[channel] - level, fit[channel] - level
        _add(page, place, t_s, measured, label, _dots(colour), f"s, %{{y:.5g}} {unit} measured")
        _add(page, place, t_s, fitted, label, _line(colour), f"s, %{{y:.5g}} {unit} fit", in_legend=True)
        residual = f"s, %{{y:.5g}} {unit} residual"
        _add(page, (row + 1, column), t_s, measured - fitted, label, _line(colour), residual)
    _name_axes(page, place, "t, s", measure_of(labels))
    _name_axes(page, (row + 1, column), "t, s", f"residual, {unit}")
    # Zooming into the one shows the same time of the other.
    upper = next(page.select_xaxes(row=row, col=column)).plotly_name
    page.update_xaxes(matches=upper.replace("axis", ""), row=row + 1, col=column)


def _spectrum(page: Any, place: Place, measurement: Measurement, swing_id: str, sensors: Sequence[Any]) -> None:
    frequency, amplitude = measurement.spectrum(swing_id)
    channels = channel_names(sensors)
    for label, values in zip(channels, amplitude, strict=True):
        shown = f"Hz, %{{y:.3g}} {unit_of([label])}"
        _add(page, place, frequency, values, label, _line(_colour(channels, label)), shown)
    row, column = place
    for mode in modes_of(measurement, swing_id):
        at = 1.0 / mode.period_observed_s
        page.add_vline(x=at, line={"color": MEASURED, "width": 1, "dash": "dash"}, row=row, col=column)
        label_of = {"text": mode.mode, "textangle": -90, "showarrow": False, "font": {"size": 10}}
        page.add_annotation(
            x=at, y=1.0, yref="y domain", xanchor="right", yanchor="top", row=row, col=column, **label_of
        )
    end = highest_frequency_hz(measurement, swing_id, float(frequency[-1]))
    _name_axes(page, place, "frequency, Hz", f"amplitude, {units_of(sensors)}")
    page.update_xaxes(range=(0.0, end), row=row, col=column)
    page.update_yaxes(type="log", dtick=1, exponentformat="power", row=row, col=column)


def _overlaid(page: Any, place: Place, trace: SwingTrace) -> None:
    shown = f"s, %{{y:.5g}} {trace.unit}"
    _add(page, place, trace.t_s, trace.measured, "measured", _dots(MEASURED), shown, in_legend=True)
    _add(page, place, trace.t_s, trace.base, "base simulation", _line(BASE), shown, in_legend=True)
    _add(page, place, trace.t_s, trace.extended, "extended simulation", _line(EXTENDED), shown, in_legend=True)
    _name_axes(page, place, "t, s", f"{trace.channel}, {trace.unit}")


def _over_noise(
    page: Any, place: Place, trace: SwingTrace, simulated: NDArray[np.float64], name: str, colour: str
) -> None:
    left = (trace.measured - simulated) / trace.noise
    _add(page, place, trace.t_s, left, f"{name} simulation", _dots(colour), "s, %{y:.3g} times the noise")
    _name_axes(page, place, "t, s", "residual / noise")
    row, column = place
    page.add_hrect(y0=-1.0, y1=1.0, fillcolor=MEASURED, opacity=0.3, line_width=0, row=row, col=column)


def _colour(channels: Sequence[str], label: str) -> str:
    return COLOURS[channels.index(label) % len(COLOURS)]


def _dots(colour: str) -> dict[str, Any]:
    return {"mode": "markers", "marker": {"color": colour, "size": 2, "opacity": 0.5}}


def _line(colour: str) -> dict[str, Any]:
    return {"mode": "lines", "line": {"color": colour, "width": 1}}


def _add(
    page: Any, place: Place, x: Any, y: Any, name: str, look: dict[str, Any], shown: str, *, in_legend: bool = False
) -> None:
    """Add a curve. Curves of one name are in the legend once, and a click there hides them all."""
    from plotly.graph_objects import Scatter

    is_first = in_legend and not any(trace.name == name and trace.showlegend for trace in page.data)
    curve = Scatter(
        x=x, y=y, name=name, legendgroup=name, showlegend=is_first, hovertemplate=f"%{{x:.5g}} {shown}", **look
    )
    page.add_trace(curve, row=place[0], col=place[1])


def _name_axes(page: Any, place: Place, x: str, y: str) -> None:
    page.update_xaxes(title_text=x, row=place[0], col=place[1])
    page.update_yaxes(title_text=y, row=place[0], col=place[1])
