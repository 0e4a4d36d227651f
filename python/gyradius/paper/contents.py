"""Every table and figure, in the order of the paper."""

from __future__ import annotations

from collections.abc import Callable

from .amplitude import figure_23, figure_24, table_of_text
from .beats import figure_3, figure_4
from .double_pendulum import figure_11, figure_12, figure_13, figure_14
from .drawing import style
from .ellipsoids import figure_1, figure_20, figure_22
from .keelboat import figure_6, figure_7, figure_8, figure_9
from .keelboat_tables import table_1, table_2, table_4_keel
from .lengths import figure_15, figure_16, figure_17, figure_18
from .model_tables import table_3, table_4_options
from .parts import Paper, PaperFigure, PaperTable
from .suspension import figure_19, figure_21

TABLES: tuple[Callable[[], PaperTable], ...] = (
    table_1,
    table_2,
    table_3,
    table_4_options,
    table_4_keel,
    table_of_text,
)
FIGURES: tuple[Callable[[], PaperFigure], ...] = (
    figure_1,
    figure_3,
    figure_4,
    figure_6,
    figure_7,
    figure_8,
    figure_9,
    figure_11,
    figure_12,
    figure_13,
    figure_14,
    figure_15,
    figure_16,
    figure_17,
    figure_18,
    figure_19,
    figure_20,
    figure_21,
    figure_22,
    figure_23,
    figure_24,
)
#: Figures of the paper that are not drawn again.
WITHOUT_DATA = (
    ("2", "sketch of the suspension"),
    ("5", "photograph of the keelboat"),
    ("10", "photograph of the model hull"),
    ("25", "outline of the keel; its shape is in the picture alone"),
    ("26", "photograph of the keel"),
)


def recompute(progress: Callable[[float, str], object] | None = None) -> Paper:
    """Compute every table and draw every figure; ``progress`` gets the fraction done and what is being done."""
    done: list[PaperTable | PaperFigure] = []
    makers: tuple[Callable[[], PaperTable | PaperFigure], ...] = (*TABLES, *FIGURES)
    for place, make in enumerate(makers):
        if progress is not None:
            progress(place / len(makers), make.__name__.replace("_", " "))
        with style():
            done.append(make())
    tables = tuple(part for part in done if isinstance(part, PaperTable))
    figures = tuple(part for part in done if isinstance(part, PaperFigure))
    return Paper(tables, figures, WITHOUT_DATA)
