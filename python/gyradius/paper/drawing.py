"""One look for every figure, and its SVG."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

# Inches; the page shows them at this width.
WIDTH, HEIGHT = 7.5, 3.9
STYLE: dict[str, Any] = {
    "font.size": 10,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.4,
    "legend.fontsize": 9,
    "legend.framealpha": 0.9,
    "svg.hashsalt": "gyradius",
}
#: Of points that the paper prints.
PRINTED_STYLE: dict[str, Any] = {"linestyle": "none", "marker": "o", "color": "black", "markersize": 5, "zorder": 5}
#: Of points that are computed.
COMPUTED_STYLE: dict[str, Any] = {"linestyle": "none", "marker": "x", "color": "C3", "markersize": 7, "zorder": 4}


@contextmanager
def style() -> Iterator[None]:
    """The look; figures are drawn and written under it."""
    context: Any = mpl.rc_context
    with context(STYLE):
        yield


def panels(rows: int = 1, columns: int = 1, height: float = HEIGHT, **options: Any) -> tuple[Figure, list[Axes]]:
    """A figure and its axes, row by row."""
    figure = Figure(figsize=(WIDTH, height), layout=ConstrainedLayoutEngine(h_pad=0.08))
    return figure, list(figure.subplots(rows, columns, squeeze=False, **options).flat)


def label(axes: Axes, x: str, y: str, title: str = "") -> None:
    """Name the axes, with their units."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if title:
        axes.set_title(title, fontsize=10)


def svg(figure: Figure) -> str:
    """The figure as SVG, the same bytes every time."""
    out = BytesIO()
    with style():
        figure.savefig(out, format="svg", metadata={"Date": None})
    return out.getvalue().decode("utf-8")
