"""What a notebook shows: tables in HTML, one-line texts, help, and plots with units and legends."""

from __future__ import annotations

import inspect
import pydoc
import re
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import swing_csv
from test_critique import made

import gyradius


class Cells(HTMLParser):
    """The texts of a table's cells by row; refuses tags that are not closed in order."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.open: list[str] = []
        self.said = ""
        self.feed(html)
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in {"td", "th"}:
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open[-1] in {"td", "th"}:
            self.rows[-1][-1] += data
        else:
            self.said += data + "\n"


@pytest.fixture(scope="module")
def yaw(tmp_path_factory: pytest.TempPathFactory) -> gyradius.Measurement:
    """A recording by a phone on a hull that yaws."""
    path = tmp_path_factory.mktemp("recording") / "yaw.csv"
    path.write_text(swing_csv())
    return gyradius.load(path).measure()


def test_a_measurement_is_a_table(keelboat: gyradius.Measurement) -> None:
    shown = Cells(keelboat._repr_html_())
    assert shown.rows[0] == ["quantity", "value ± u", "95 %", "unit"]
    rows = {row[0]: row[1:] for row in shown.rows[1:]}
    assert set(rows) == set(keelboat.quantities)
    k = keelboat.quantities["k_yaw_m"]
    value, u = map(float, rows["k_yaw_m"][0].split(" ± "))
    low, high = map(float, rows["k_yaw_m"][1].split(" … "))
    assert (value, u) == pytest.approx((k.value, k.u), abs=k.u / 50)
    assert (low, high) == pytest.approx(k.interval_95, abs=k.u / 50)
    assert rows["k_yaw_m"][2] == "m"
    assert rows["inertia_yaw_kg_m2"][2] == "kg m²"
    assert f"k_yaw_m >= 1: {keelboat.verdicts[0].verdict}" in shown.said
    assert f"{len(keelboat.warnings)} warning" in shown.said


def test_texts_are_no_markup(keelboat: gyradius.Measurement) -> None:
    shown = replace(keelboat, title="<script>alert(1)</script>", warnings=("<b>&",))._repr_html_()
    assert "<script>" not in shown
    assert "&lt;b&gt;&amp;" in shown


def test_no_quantity_is_said(yaw: gyradius.Measurement) -> None:
    assert "No quantity is determined" in Cells(yaw._repr_html_()).said
    assert repr(yaw) == f"<gyradius.Measurement {yaw.title!r}: no quantity determined>"


def test_a_critique_is_a_verdict_and_a_table() -> None:
    critique = made()
    shown = Cells(critique._repr_html_())
    assert "Ambiguous." in shown.said
    assert critique.verdict.text in shown.said
    assert shown.rows[0] == ["quantity", "base simulation", "extended simulation", "95 %", "unit"]
    rows = {row[0]: row[1:] for row in shown.rows[1:]}
    # As the hand-written file has them.
    assert rows["k_yaw_m"] == ["1.05660 ± 0.00093", "1.0591 ± 0.0010", "1.0571 … 1.0611", "m"]
    assert rows["cm_depth_m"][0] == "–"
    assert rows["k_pitch_m"][:3] == ["1.1560 ± 0.0031", "–", ""]


def test_one_line_says_the_figures(keelboat: gyradius.Measurement) -> None:
    assert re.fullmatch(r"<gyradius\.Measurement '.*': .*k_yaw_m = 1\.04\d+ ± 0\.00\d+>", repr(keelboat))
    assert repr(made()) == "<gyradius.Critique 'Keelboat of the paper': ambiguous, quadratic_drag>"


@pytest.mark.parametrize("kind", [gyradius.Measurement, gyradius.Critique, gyradius.Session])
def test_help_says_what_each_method_does(kind: type) -> None:
    text = pydoc.plain(pydoc.render_doc(kind))
    methods = [name for name, _ in inspect.getmembers(kind, inspect.isfunction) if name[0] != "_"]
    assert [name for name in methods if not inspect.getdoc(getattr(kind, name))] == []
    assert all(name in text for name in methods)
    assert len((inspect.getdoc(kind) or "").splitlines()) < 15


def axes_texts(figure: Any) -> list[tuple[str, str]]:
    return [(axes.get_xlabel(), axes.get_ylabel()) for axes in figure.findobj(lambda one: hasattr(one, "get_xlabel"))]


def test_plots_have_units_and_legends(yaw: gyradius.Measurement) -> None:
    figure = yaw.plot()
    texts = axes_texts(figure)
    assert ("", "rate, rad/s") in texts
    assert ("", "specific force, m/s²") in texts
    assert ("t, s", "residual, rad/s") in texts
    assert ("frequency, Hz", "amplitude, rad/s or m/s²") in texts
    legends = [[t.get_text() for t in axes.get_legend().get_texts()] for axes in with_legend(figure)]
    assert legends == [["gx", "gy", "gz"], ["ax", "ay", "az"], ["gx", "gy", "gz", "ax", "ay", "az"]]
    assert all(x and y for x, y in axes_texts(made().plot()))


def with_legend(figure: Any) -> list[Any]:
    return [axes for part in figure.subfigs for axes in part.axes if axes.get_legend()]


def test_a_single_channel_has_its_unit(tmp_path: Path) -> None:
    t_s = np.arange(0.0, 60.0, 0.05)
    noise = np.random.default_rng(1).normal(0.0, 1e-3, t_s.size)
    rows = np.column_stack([t_s, 0.2 * np.exp(-t_s / 200.0) * np.cos(np.pi * t_s) + noise])
    np.savetxt(tmp_path / "angle.csv", rows, delimiter=",", header="t,angle", comments="")
    texts = axes_texts(gyradius.load(tmp_path / "angle.csv").measure().plot())
    assert ("", "angle, rad") in texts
    assert ("frequency, Hz", "amplitude, rad") in texts


def test_interactive_plots_show_the_same_arrays(yaw: gyradius.Measurement) -> None:
    pytest.importorskip("plotly")
    figure = yaw.plot(interactive=True)
    swing = yaw.recorded_swings[0]
    (labels, t_s, samples, fit), _ = yaw.fits(swing)
    curves = {(trace.name, trace.mode, trace.xaxis, trace.yaxis): trace for trace in figure.data}
    measured, fitted = curves["gz", "markers", "x", "y"], curves["gz", "lines", "x", "y"]
    channel, level = labels.index("gz"), np.mean(fit[labels.index("gz")])
    assert np.allclose(measured.x, t_s, rtol=0, atol=0)
    assert np.allclose(np.asarray(measured.y) + level, samples[channel], rtol=0, atol=1e-12)
    assert np.allclose(np.asarray(fitted.y) + level, fit[channel], rtol=0, atol=1e-12)
    in_legend = [trace.name for trace in figure.data if trace.showlegend]
    assert in_legend == ["gx", "gy", "gz", "ax", "ay", "az"]
    titles = plotly_titles(figure)
    for title in ("rate, rad/s", "specific force, m/s²", "residual, rad/s", "t, s", "frequency, Hz"):
        assert title in titles
    assert yaw.plot(swing, interactive=True).data[0].hovertemplate.endswith("rad/s measured")


def test_interactive_residuals_are_over_the_noise() -> None:
    pytest.importorskip("plotly")
    critique = made()
    figure = critique.plot("yaw-1", interactive=True)
    trace = next(trace for trace in critique.traces if trace.swing == "yaw-1")
    assert [curve.name for curve in figure.data if curve.showlegend] == [
        "measured",
        "base simulation",
        "extended simulation",
    ]
    residual = next(curve for curve in figure.data if curve.xaxis == "x3")
    assert np.allclose(residual.y, (trace.measured - trace.extended) / 0.002)
    assert {"t, s", "turn rate about z, rad/s", "residual / noise"} == plotly_titles(figure)


def plotly_titles(figure: Any) -> set[str]:
    axes = [*figure.select_xaxes(), *figure.select_yaxes()]
    return {axis.title.text for axis in axes if axis.title.text}


def test_nothing_to_draw_is_said(keelboat: gyradius.Measurement) -> None:
    pytest.importorskip("plotly")
    draw: Callable[..., Any] = keelboat.plot
    with pytest.raises(gyradius.NoResultError, match="no recording to draw"):
        draw(interactive=True)
