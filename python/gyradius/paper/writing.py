"""The folder that ``gyradius paper`` writes, and its JSON."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from ..files import only_writer, write_whole
from .checks import GRAVITY_M_S2, Check
from .contents import recompute
from .drawing import svg
from .page import html, markdown
from .parts import Paper, PaperFigure, PaperTable
from .print_data import Erratum, errata
from .rows import CSV_HEADER, WORDS_HEADER, csv_row

Progress: TypeAlias = Callable[[float, str], object]
FORMAT = "gyradius-paper/1"
PAGE, TEXT, FIGURES, TABLES = "paper.html", "paper.md", "figures", "tables"


def write_paper(folder: Path, progress: Progress | None = None) -> Paper:
    """Recompute the paper into a folder, which is made where there is none.

    ``progress`` gets the fraction done and what is being done. ``InputError`` where another program is writing there.
    """
    tell = progress or (lambda _done, _doing: None)
    with only_writer(folder):
        paper = recompute(lambda done, doing: tell(done / 2.0, doing))
        write_files(paper, folder, lambda done, doing: tell((1.0 + done) / 2.0, doing))
    return paper


def write_files(paper: Paper, folder: Path, progress: Progress | None = None) -> None:
    """Write page, Markdown, drawings and tables into a folder that is there."""
    drawings = _drawings(paper, progress)
    for name in (FIGURES, TABLES):
        (folder / name).mkdir(exist_ok=True)
    for name, drawing in drawings.items():
        write_whole(folder / FIGURES / f"{name}.svg", drawing)
    for table in paper.tables:
        write_whole(folder / TABLES / f"{table.name}.csv", _table_csv(table))
    of_figures = [check for figure in paper.figures for check in figure.checks]
    write_whole(folder / TABLES / "figures.csv", _csv(CSV_HEADER, map(csv_row, of_figures)))
    write_whole(folder / PAGE, html(paper, drawings))
    write_whole(folder / TEXT, markdown(paper))


def _drawings(paper: Paper, progress: Progress | None) -> dict[str, str]:
    found = {}
    for place, figure in enumerate(paper.figures):
        if progress is not None:
            progress(place / len(paper.figures), f"drawing figure {figure.number}")
        found[figure.name] = svg(figure.drawing)
    return found


def _table_csv(table: PaperTable) -> str:
    if table.words:
        rows = ((one.label, one.printed, one.found, "reproduced" if one.agrees else "more") for one in table.words)
        return _csv(WORDS_HEADER, rows)
    return _csv(CSV_HEADER, map(csv_row, table.checks))


def _csv(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return out.getvalue()


def paper_json(paper: Paper) -> str:
    """Every comparison, with the errata and the files."""
    found = {
        "format": FORMAT,
        "gravity_m_s2": GRAVITY_M_S2,
        "summary": {
            "recomputed": len(paper.checks),
            **{verdict.replace(" ", "_"): count for verdict, count in paper.counts().items()},
            "round_trips": len(paper.round_trips),
            "round_trips_returned": sum(check.verdict == "reproduced" for check in paper.round_trips),
        },
        "tables": [_table(table) for table in paper.tables],
        "figures": [_figure(figure) for figure in paper.figures],
        "figures_without_data": [{"number": number, "what": what} for number, what in paper.without_data],
        "errata": [_erratum(one) for one in errata().values()],
    }
    return json.dumps(found, ensure_ascii=False, indent=2)


def _table(table: PaperTable) -> dict[str, Any]:
    words = [
        {"label": one.label, "printed": one.printed, "found": one.found, "agrees": one.agrees} for one in table.words
    ]
    return {"heading": table.heading, "file": f"{TABLES}/{table.name}.csv", **_part(table), "words": words}


def _figure(figure: PaperFigure) -> dict[str, Any]:
    return {"number": figure.number, "file": f"{FIGURES}/{figure.name}.svg", **_part(figure)}


def _part(part: PaperTable | PaperFigure) -> dict[str, Any]:
    checks = [_check(check) for check in part.checks]
    texts = {"title": part.title, "caption": part.caption, "remark": part.remark}
    return {**texts, "checks": checks, "errata": list(part.errata)}


def _check(check: Check) -> dict[str, Any]:
    printed = check.printed
    return {
        "quantity": check.label,
        "printed_id": printed.id,
        "where": printed.where,
        "printed": printed.text,
        "unit": printed.unit,
        "computed": check.computed_in_unit,
        "difference": check.difference,
        "rounding": printed.rounding_in_unit,
        "input_rounding": check.spread_in_unit,
        "from": check.computed.how,
        "round_trip": check.is_round_trip,
        "verdict": check.verdict.replace(" ", "_"),
        "erratum": check.erratum,
    }


def _erratum(one: Erratum) -> dict[str, Any]:
    return {"id": one.id, "place": one.place, "printed": one.printed, "correct": one.correct, "known": one.is_known}
