"""The report on paper: the HTML report's text, tables and drawings, laid out as PDF.

Only what the report uses is understood: headings, paragraphs, lists, tables, figures and inline SVG. What is hidden
behind a click on a screen (``details``) is open on paper; scripts and styles are left out, and JSON is attached to the
file. The core's report is well-formed XML: the standard library parses it.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.sax.saxutils import escape

from reportlab.lib import colors
from reportlab.lib.pagesizes import A4
from reportlab.lib.styles import ParagraphStyle, getSampleStyleSheet
from reportlab.lib.units import mm
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFName, PDFStream, PDFString
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.platypus import Flowable, KeepTogether, Paragraph, SimpleDocTemplate, Spacer, Table, TableStyle

from .drawings import NAMESPACE, drawn
from .files import write_whole

MARGIN = 15 * mm
WIDTH, HEIGHT = A4[0] - 2 * MARGIN, A4[1] - 2 * MARGIN
# Points for a unit of the drawings: letters of 12 units are then printed at 6 points.
SCALE = 0.5
# The standard fonts of PDF have no Greek letters, no ± in all encodings, no arrows: matplotlib brings one that has.
FONT = "DejaVuSans"
BOLD = "DejaVuSans-Bold"
JSON = "application/json"
SKIPPED = {"script", "style", "head", "nav", "template", "button"}
INLINE = {
    "b",
    "i",
    "u",
    "em",
    "strong",
    "sub",
    "sup",
    "span",
    "a",
    "code",
    "small",
    "abbr",
    "br",
    "time",
    "q",
    "var",
}
KEPT_MARKUP = {
    "b": "b",
    "strong": "b",
    "i": "i",
    "em": "i",
    "var": "i",
    "u": "u",
    "sub": "sub",
    "sup": "super",
}
# Pictures stand in so many columns.
COLUMNS, GAP = 2, 5 * mm
PICTURES = TableStyle(
    [
        ("VALIGN", (0, 0), (-1, -1), "TOP"),
        ("LEFTPADDING", (0, 0), (-1, -1), 0),
        ("RIGHTPADDING", (0, 0), (-1, -1), GAP),
        ("TOPPADDING", (0, 0), (-1, -1), 0),
        ("BOTTOMPADDING", (0, 0), (-1, -1), 2 * mm),
    ]
)
GRID = TableStyle(
    [
        ("FONT", (0, 0), (-1, -1), FONT, 7.5),
        ("LINEBELOW", (0, 0), (-1, -1), 0.25, colors.lightgrey),
        ("VALIGN", (0, 0), (-1, -1), "TOP"),
        ("LEFTPADDING", (0, 0), (-1, -1), 2),
        ("RIGHTPADDING", (0, 0), (-1, -1), 4),
        ("TOPPADDING", (0, 0), (-1, -1), 1.5),
        ("BOTTOMPADDING", (0, 0), (-1, -1), 1.5),
    ]
)


def write_pdf(html: str, output: Path) -> None:
    """Lay the report out as PDF."""
    write_whole(output, laid_out(html))


def laid_out(html: str) -> bytes:
    """The report as PDF; what it holds as JSON is attached to it."""
    _register_fonts()
    # HTML may have two characters that XML may not.
    page = ElementTree.fromstring(re.sub("[\ufffe\uffff]", "\ufffd", html))
    title = page.findtext("head/title") or "gyradius"
    story = [flowable for body in page.iter("body") for flowable in _walk(body, _styles())]
    buffer = io.BytesIO()
    margins = {f"{side}Margin": MARGIN for side in ("left", "right", "top", "bottom")}
    document = SimpleDocTemplate(buffer, pagesize=A4, title=title, lang=page.get("lang"), **margins)
    document.build(story, onFirstPage=_attached(page), onLaterPages=_number)
    return buffer.getvalue()


def _attached(page: Element) -> Callable[[Any, Any], None]:
    """Attaches the JSON of the report, where it has any."""
    results = {node.get("id"): node.text or "" for node in page.iter("script") if node.get("type") == JSON}

    def attach(canvas: Any, _document: Any) -> None:
        names: list[Any] = []
        for name, text in sorted((f"{id_}.json", text) for id_, text in results.items()):
            stream = PDFStream(PDFDictionary({"Type": PDFName("EmbeddedFile")}), text.encode())
            file = {"Type": PDFName("Filespec"), "F": PDFString(name), "UF": PDFString(name)}
            file["EF"] = PDFDictionary({"F": canvas._doc.Reference(stream)})
            names += [PDFString(name), canvas._doc.Reference(PDFDictionary(file))]
        if names:
            embedded = PDFDictionary({"Names": PDFArray(names)})
            canvas._doc.Catalog.Names = PDFDictionary({"EmbeddedFiles": embedded})

    return attach


def _register_fonts() -> None:
    import matplotlib

    folder = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    for name in (FONT, BOLD):
        if name not in pdfmetrics.getRegisteredFontNames():
            pdfmetrics.registerFont(TTFont(name, str(folder / f"{name}.ttf")))
    pdfmetrics.registerFontFamily(FONT, normal=FONT, bold=BOLD, italic=FONT, boldItalic=BOLD)


def _number(canvas: Any, document: Any) -> None:
    canvas.setFont(FONT, 7)
    canvas.drawRightString(A4[0] - MARGIN, MARGIN / 2, str(document.page))


def _styles() -> dict[str, ParagraphStyle]:
    sheet = getSampleStyleSheet()
    body = ParagraphStyle("body", sheet["BodyText"], fontName=FONT, fontSize=8, leading=10, spaceBefore=3)
    heads = {f"h{level}": (18 - 3 * level, 4 + 2 * (3 - level)) for level in (1, 2, 3)}
    styles = {
        name: ParagraphStyle(
            name, body, fontName=BOLD, fontSize=size, leading=1.3 * size, spaceBefore=before, keepWithNext=1
        )
        for name, (size, before) in heads.items()
    }
    styles["h4"] = styles["summary"] = styles["caption"] = styles["h3"]
    styles["figcaption"] = ParagraphStyle("small", body, fontSize=7.5, leading=10, textColor=colors.dimgrey)
    styles["picture"] = ParagraphStyle("picture", body, fontName=BOLD, fontSize=7, leading=9, keepWithNext=1)
    styles["picture_caption"] = ParagraphStyle("pictured", styles["figcaption"], fontSize=6, leading=7.5)
    styles["term"] = ParagraphStyle("term", body, fontSize=7.5, leading=9, spaceBefore=1)
    styles["cell"] = ParagraphStyle("cell", body, fontSize=7.5, leading=9.5, spaceBefore=0, spaceAfter=0)
    styles["p"] = body
    return styles


def _walk(node: Element, styles: dict[str, ParagraphStyle]) -> Iterator[Flowable]:
    """Flowables of a block: runs of text and inline elements become paragraphs, blocks are entered."""
    run = [escape(node.text or "")]
    for child in node:
        if _is_inline(child):
            run.append(_markup(child))
        else:
            yield from _paragraph("".join(run), _style_of(node, styles))
            run = []
            yield from _block(child, styles)
        run.append(escape(child.tail or ""))
    yield from _paragraph("".join(run), _style_of(node, styles))


def _block(node: Element, styles: dict[str, ParagraphStyle]) -> Iterator[Flowable]:
    if node.tag in SKIPPED:
        return
    if node.tag.removeprefix(NAMESPACE) == "svg":
        yield from _drawing(node)
    elif node.tag == "table":
        yield from _table(node, styles)
    elif node.get("class") == "figures":
        yield from _pictures(node, styles)
    elif node.tag == "figure":
        yield KeepTogether(list(_walk(node, styles)))
    elif node.tag == "li":
        yield from _paragraph("• " + _inner(node), styles["p"])
    elif node.tag == "dl":
        yield from _terms(node, styles)
    elif node.tag == "hr":
        yield Spacer(1, 3 * mm)
    else:
        yield from _walk(node, styles)


def _terms(node: Element, styles: dict[str, ParagraphStyle]) -> Iterator[Flowable]:
    """Each term with its meaning in one paragraph."""
    texts = [_inner(child) for child in node if child.tag in ("dt", "dd")]
    for term, meaning in zip(texts[::2], texts[1::2], strict=False):
        yield from _paragraph(f"<b>{term}.</b> {meaning}", styles["term"])


def _style_of(node: Element, styles: dict[str, ParagraphStyle]) -> ParagraphStyle:
    return styles.get(node.tag, styles["p"])


def _paragraph(text: str, style: ParagraphStyle) -> Iterator[Flowable]:
    text = re.sub(r"\s+", " ", text).strip()
    if text:
        yield Paragraph(text, style)


def _is_inline(node: Element) -> bool:
    return node.tag in INLINE


def _markup(node: Element) -> str:
    """The markup that a paragraph of reportlab understands."""
    if node.tag == "br":
        return "<br/>"
    kept = KEPT_MARKUP.get(node.tag)
    return f"<{kept}>{_inner(node)}</{kept}>" if kept else _inner(node)


def _inner(node: Element) -> str:
    parts = [escape(node.text or "")]
    for child in node:
        if child.tag not in SKIPPED:
            parts.append(_markup(child))
        parts.append(escape(child.tail or ""))
    return "".join(parts)


def _table(node: Element, styles: dict[str, ParagraphStyle]) -> Iterator[Flowable]:
    caption = node.find("caption")
    if caption is not None:
        yield from _paragraph(_inner(caption), styles["caption"])
    rows = [[_cell(cell, styles) for cell in row if cell.tag in ("td", "th")] for row in node.iter("tr")]
    width = max((len(row) for row in rows), default=0)
    if not width:
        return
    padded = [row + [""] * (width - len(row)) for row in rows]
    yield Table(
        padded,
        colWidths=_widths(node, width),
        style=GRID,
        repeatRows=1 if node.find(".//th") is not None else 0,
    )
    yield Spacer(1, 3 * mm)


def _cell(cell: Element, styles: dict[str, ParagraphStyle]) -> Flowable:
    text = re.sub(r"\s+", " ", _inner(cell)).strip()
    return Paragraph(f"<b>{text}</b>" if cell.tag == "th" else text, styles["cell"])


def _widths(node: Element, columns: int) -> list[float]:
    """Columns as wide as their longest text asks, within the page."""
    longest = [1.0] * columns
    for row in node.iter("tr"):
        for i, cell in enumerate(cell for cell in row if cell.tag in ("td", "th")):
            # Beyond 40 characters a cell wraps, between words only.
            text = " ".join(cell.itertext()).strip()
            word = max(map(len, text.split()), default=0) + 2.0
            longest[i] = max(longest[i], word, min(40.0, len(text)))
    return [WIDTH * length / sum(longest) for length in longest]


def _pictures(node: Element, styles: dict[str, ParagraphStyle]) -> Iterator[Flowable]:
    """Figures side by side, each with its title and caption."""
    small = {**styles, "h4": styles["picture"], "figcaption": styles["picture_caption"]}
    cells = [list(_walk(figure, small)) for figure in node.iter("figure")]
    rows = [cells[i : i + COLUMNS] for i in range(0, len(cells), COLUMNS)]
    padded = [row + [[]] * (COLUMNS - len(row)) for row in rows]
    if padded:
        yield Table(padded, colWidths=[WIDTH / COLUMNS] * COLUMNS, style=PICTURES)


def _drawing(node: Element) -> Iterator[Flowable]:
    drawing = drawn(node, FONT)
    # All in one size of type; half a page at most, so that picture and caption stay together.
    room = WIDTH / COLUMNS - GAP
    scale = min(room / drawing.width, HEIGHT / 2 / drawing.height, SCALE)
    drawing.scale(scale, scale)
    drawing.width, drawing.height = drawing.width * scale, drawing.height * scale
    yield drawing
