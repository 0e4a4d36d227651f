"""The page: HTML that needs no other file, and Markdown beside the drawings."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from html import escape

from .checks import Check
from .parts import Paper, PaperFigure, PaperTable
from .print_data import errata, erratum
from .rows import HEADER, MODE_OF_WORK, READING, WORDS_HEADER, reasons, row, summary

TITLE = "Bifilar suspension measurement of boat inertia parameters, recomputed"
SOURCE = (
    "P. F. Hinrichsen, Bifilar suspension measurement of boat inertia parameters, Journal of Sailboat Technology, "
    "article 2014-01. Numbers in brackets are its equations."
)
STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1a1a1a; max-width: 66rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { margin-top: 2.5rem; border-bottom: 1px solid #ccc; } h3 { margin-top: 2rem; }
img { width: 100%; max-width: 52rem; display: block; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.85rem; margin: 0.7rem 0; }
th, td { padding: 0.2rem 0.6rem; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top; }
th { background: #f3f3f3; } td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.differs td { background: #fde8e6; } tr.inputs td { background: #fff8e0; }
.remark { color: #555; } .summary { background: #eef4fa; padding: 0.8rem 1.2rem; }
@media print { h3 { break-after: avoid; } img, tr { break-inside: avoid; } }
"""
# Columns of numbers, from the printed one to the rounding by the inputs.
NUMBERS = range(1, 6)
CLASSES = {"reproduced": "", "input rounding": "inputs", "differs": "differs"}
NEW_ERRATA = "Where the print is wrong or contradicts itself. Those marked as new came out of this recomputation."
ERRATA_HEADER = ("erratum", "place", "printed", "correct")


def html(paper: Paper, drawings: dict[str, str]) -> str:
    """The whole page; ``drawings`` are the SVGs by the figures' names."""
    body = [f"<h1>{escape(TITLE)}</h1>", _p(SOURCE), *_html_head(paper)]
    body.append("<h2>Tables</h2>")
    body += [part for table in paper.tables for part in _html_table(table)]
    body.append("<h2>Figures</h2>")
    body += [part for figure in paper.figures for part in _html_figure(figure, drawings[figure.name])]
    body += ["<h2>Figures that are not drawn</h2>", _html_grid(("figure", "what it is"), paper.without_data)]
    body += ["<h2>Errata</h2>", _p(NEW_ERRATA), _html_grid(ERRATA_HEADER, _errata_rows())]
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{escape(TITLE)}</title>'
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}<style>{STYLE}</style></head><body>\n'
        + "\n".join(body)
        + "\n</body></html>\n"
    )


def _errata_rows() -> list[tuple[str, ...]]:
    return [
        (one.id if one.is_known else f"{one.id} (new)", one.place, one.printed, one.correct)
        for one in errata().values()
    ]


def _html_head(paper: Paper) -> Iterable[str]:
    listed = "".join(f"<li>{escape(what)}. {escape(why)}.</li>" for what, why in reasons(paper))
    yield f'<div class="summary">{_p(" ".join(summary(paper)))}<p>What does not agree:</p><ul>{listed}</ul></div>'
    yield _p(READING)
    yield _p(MODE_OF_WORK)


def _html_table(table: PaperTable) -> Iterable[str]:
    yield f'<h3 id="{table.name}">{escape(table.heading)}: {escape(table.title)}</h3>'
    yield _p(table.caption)
    if table.checks:
        yield _html_checks(table.checks)
    if table.words:
        rows = [(one.label, one.printed, one.found, _agreement(one.agrees)) for one in table.words]
        yield _html_grid(WORDS_HEADER, rows)
    yield from _html_remarks(table)


def _agreement(agrees: bool) -> str:
    return "reproduced" if agrees else "more than printed"


def _html_figure(figure: PaperFigure, drawing: str) -> Iterable[str]:
    image = base64.b64encode(drawing.encode("utf-8")).decode("ascii")
    yield f'<h3 id="{figure.name}">Figure {figure.number}: {escape(figure.title)}</h3>'
    yield f'<img alt="{escape(figure.title)}" src="data:image/svg+xml;base64,{image}">'
    yield _p(figure.caption)
    if figure.checks:
        yield _html_checks(figure.checks)
    yield from _html_remarks(figure)


def _html_remarks(part: PaperTable | PaperFigure) -> Iterable[str]:
    for remark in _remarks(part):
        yield f'<p class="remark">{escape(remark)}</p>'


def _remarks(part: PaperTable | PaperFigure) -> list[str]:
    """The remark, and the errata that no comparison names."""
    named = {check.erratum for check in part.checks}
    found = [erratum(id_) for id_ in part.errata if id_ not in named]
    said = [f"Erratum {one.id}, {one.place}. Printed: {one.printed}. Correct: {one.correct}." for one in found]
    return [part.remark, *said] if part.remark else said


def _html_checks(checks: Sequence[Check]) -> str:
    rows = "".join(f'<tr class="{CLASSES[check.verdict]}">{_cells(row(check))}</tr>' for check in checks)
    return f'<div class="scroll"><table><tr>{_headers(HEADER)}</tr>{rows}</table></div>'


def _html_grid(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>" for cells in rows)
    return f'<div class="scroll"><table><tr>{_headers(header)}</tr>{body}</table></div>'


def _headers(header: Sequence[str]) -> str:
    return "".join(f"<th>{escape(name)}</th>" for name in header)


def _cells(cells: Sequence[str]) -> str:
    return "".join(
        f"<td{' class=n' if place in NUMBERS else ''}>{escape(cell)}</td>" for place, cell in enumerate(cells)
    )


def _p(text: str) -> str:
    return f"<p>{escape(text)}</p>"


def markdown(paper: Paper) -> str:
    """The same as Markdown; the drawings are in ``figures/``."""
    parts = [f"# {TITLE}", SOURCE, " ".join(summary(paper)), "What does not agree:"]
    parts.append("\n".join(f"- {what}. {why}." for what, why in reasons(paper)))
    parts += [READING, MODE_OF_WORK, "## Tables"]
    for table in paper.tables:
        parts += [f"### {table.heading}: {table.title}", table.caption, *_md_checks(table.checks)]
        if table.words:
            rows = [(one.label, one.printed, one.found, _agreement(one.agrees)) for one in table.words]
            parts.append(_md_grid(WORDS_HEADER, rows))
        parts += _remarks(table)
    parts.append("## Figures")
    for figure in paper.figures:
        image = f"![{figure.title}](figures/{figure.name}.svg)"
        parts += [f"### Figure {figure.number}: {figure.title}", image, figure.caption, *_md_checks(figure.checks)]
        parts += _remarks(figure)
    parts += ["## Figures that are not drawn", _md_grid(("figure", "what it is"), paper.without_data)]
    parts += ["## Errata", NEW_ERRATA, _md_grid(ERRATA_HEADER, _errata_rows())]
    return "\n\n".join(parts) + "\n"


def _md_checks(checks: Sequence[Check]) -> list[str]:
    if not checks:
        return []
    rows = [
        (*row(check)[:-1], f"**{row(check)[-1]}**" if check.verdict == "differs" else row(check)[-1])
        for check in checks
    ]
    return [_md_grid(HEADER, rows)]


def _md_grid(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    cells = [[cell.replace("|", "\\|") for cell in line] for line in (header, ["---"] * len(header), *rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in cells)
