"""The report on paper."""

from __future__ import annotations

import io
import math
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import pytest
from pypdf import PageObject, PdfReader
from reportlab.graphics import renderPDF
from reportlab.lib.fonts import tt2ps
from reportlab.pdfbase.pdfmetrics import stringWidth

import gyradius
from gyradius import pdf
from gyradius.drawings import NAMESPACE, SHAPES, UnknownMarkup, drawn
from gyradius.pdf import BOLD, FONT, write_pdf

DRAWING = """<figure><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 20" font-family="system-ui">
<text x="0" y="12">drawn</text></svg></figure>"""


def test_a_drawing_does_not_cost_the_bold_letters_after_it(tmp_path: Path) -> None:
    write_pdf(f"<html><body><h2>before</h2>{DRAWING}<h2>after</h2></body></html>", tmp_path / "r.pdf")
    assert tt2ps(FONT, 1, 0) == BOLD


def test_letters_that_xml_may_not_have_do_not_stop_the_report(tmp_path: Path) -> None:
    write_pdf("<html><body><p>a\uffffb</p></body></html>", tmp_path / "r.pdf")
    assert "a" in page_text(tmp_path / "r.pdf")


# What reaches the PDF, read from its own operators.


@dataclass
class Painted:
    """A path that was painted: its bounds from the top left, and how."""

    operator: str
    bounds: tuple[float, float, float, float]
    stroke: str
    fill: str
    width: float
    dashes: tuple[float, ...]
    join: str
    opacity: float


PAINTING = {"S": "stroke", "f": "fill", "f*": "fill", "B": "both", "B*": "both"}
OPERANDS_OF_A_PATH = {"m", "l", "c"}
JOINS = ("miter", "round", "bevel")
START: dict[str, Any] = {
    "cm": (1, 0, 0, 1, 0, 0),
    "RG": "#000000",
    "rg": "#000000",
    "w": 1.0,
    "d": (),
    "j": "miter",
    "gs": 1.0,
}


def page_of(svg: str | Element) -> PageObject:
    """A drawing alone on a page of its own size."""
    pdf._register_fonts()
    element = ElementTree.fromstring(svg) if isinstance(svg, str) else svg
    return PdfReader(io.BytesIO(renderPDF.drawToString(drawn(element, FONT)))).pages[0]


def painted(page: PageObject) -> list[Painted]:
    """All paths that a page paints, in order."""
    height = float(page.mediabox.height)
    state, stack, path, found = dict(START), [], [], []
    for operands, code in page.get_contents().operations:
        operator = code.decode()
        values = [float(v) for v in operands if isinstance(v, int | float)]
        if operator == "q":
            stack.append(dict(state))
        elif operator == "Q":
            state = stack.pop()
        elif operator == "cm":
            state["cm"] = product(values, state["cm"])
        elif operator in ("RG", "rg"):
            state[operator] = "#" + "".join(f"{round(255 * v):02x}" for v in values)
        elif operator == "w":
            state["w"] = values[0]
        elif operator == "d":
            state["d"] = tuple(float(v) for v in operands[0])
        elif operator == "j":
            state["j"] = JOINS[int(values[0])]
        elif operator == "gs":
            state["gs"] = page["/Resources"]["/ExtGState"][operands[0]].get("/ca", state["gs"])
        elif operator in OPERANDS_OF_A_PATH:
            path += [moved(state["cm"], x, y) for x, y in zip(values[::2], values[1::2], strict=True)]
        elif operator == "re":
            x, y, w, h = values
            path += [moved(state["cm"], x + i * w, y + j * h) for i in (0, 1) for j in (0, 1)]
        elif operator in PAINTING:
            xs, ys = [x for x, _ in path], [height - y for _, y in path]
            bounds = (min(xs), min(ys), max(xs), max(ys))
            found.append(
                Painted(PAINTING[operator], bounds, *(state[key] for key in ("RG", "rg", "w", "d", "j", "gs")))
            )
            path = []
        elif operator == "n":
            path = []
    return found


def product(a: Any, b: Any) -> tuple[float, ...]:
    """The matrix that applies a, then b."""
    return (
        a[0] * b[0] + a[1] * b[2],
        a[0] * b[1] + a[1] * b[3],
        a[2] * b[0] + a[3] * b[2],
        a[2] * b[1] + a[3] * b[3],
        a[4] * b[0] + a[5] * b[2] + b[4],
        a[4] * b[1] + a[5] * b[3] + b[5],
    )


def moved(m: Any, x: float, y: float) -> tuple[float, float]:
    return m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]


def texts(page: PageObject) -> list[tuple[str, float, float]]:
    """Texts with the places where they begin, from the top left."""
    found: list[tuple[str, float, float]] = []

    def visit(text: str, matrix: Any, text_matrix: Any, *_: Any) -> None:
        if text.strip():
            x, y = moved(product(text_matrix, matrix), 0, 0)
            found.append((text.strip(), x, float(page.mediabox.height) - y))

    page.extract_text(visitor_text=visit)
    return found


def page_text(path: Path) -> str:
    return "".join(page.extract_text() for page in PdfReader(path).pages)


# What an SVG asks for, computed from its attributes alone.


def expected(svg: Element) -> Iterator[Painted]:
    for element in svg:
        name = element.tag.removeprefix(NAMESPACE)
        if name not in ("title", "text"):
            yield expected_of(name, element)


def expected_of(name: str, element: Element) -> Painted:
    get = element.get
    strokes, fills = get("stroke", "none") != "none", name != "line" and get("fill") != "none"
    dashes = get("stroke-dasharray", "none")
    return Painted(
        "both" if strokes and fills else "stroke" if strokes else "fill",
        bounds_of(name, element),
        get("stroke", "-"),
        get("fill", "-"),
        float(get("stroke-width", "1")),
        () if dashes == "none" else tuple(map(float, dashes.split())),
        get("stroke-linejoin", "miter"),
        float(get("fill-opacity", "1")),
    )


def bounds_of(name: str, element: Element) -> tuple[float, float, float, float]:
    def at(key: str) -> float:
        return float(element.get(key, "0"))

    if name == "line":
        xs, ys = sorted((at("x1"), at("x2"))), sorted((at("y1"), at("y2")))
        return xs[0], ys[0], xs[1], ys[1]
    if name == "rect":
        return at("x"), at("y"), at("x") + at("width"), at("y") + at("height")
    if name in ("circle", "ellipse"):
        rx, ry = (at("r"), at("r")) if name == "circle" else (at("rx"), at("ry"))
        return at("cx") - rx, at("cy") - ry, at("cx") + rx, at("cy") + ry
    numbers = [float(number) for number in re.split("[ ,]", element.get("points", ""))]
    xs, ys = numbers[::2], numbers[1::2]
    return min(xs), min(ys), max(xs), max(ys)


def differences(got: Painted, asked: Painted, turned: bool) -> list[str]:
    """What differs between a painted path and what was asked for; a turned one has other bounds."""
    found = [key for key in ("operator", "opacity") if getattr(got, key) != getattr(asked, key)]
    if asked.operator != "fill":
        found += [key for key in ("stroke", "width", "dashes", "join") if getattr(got, key) != getattr(asked, key)]
    if asked.operator != "stroke" and got.fill != asked.fill:
        found.append("fill")
    if not turned and any(abs(a - b) > 0.01 for a, b in zip(got.bounds, asked.bounds, strict=True)):
        found.append(f"bounds {got.bounds} instead of {asked.bounds}")
    return found


def expected_texts(svg: Element) -> Iterator[tuple[str, float, float]]:
    size = float(svg.get("font-size", "16"))
    for element in svg.iter(f"{NAMESPACE}text"):
        text = element.text or ""
        before = {"start": 0.0, "middle": 0.5, "end": 1.0}[element.get("text-anchor", "start")]
        start = float(element.get("x", "0")) - before * stringWidth(text, FONT, size)
        yield text.strip(), start, float(element.get("y", "0"))


# The reports of the sessions that ship.


@pytest.fixture(scope="module")
def reports() -> dict[str, str]:
    """By session: one of them with its criticism, whose causes are drawn too."""
    found = {}
    for name in ("boat-park", "keelboat", "model-hull"):
        session = gyradius.load(gyradius.shipped_session(name))
        found[name] = session.measure().to_html(session.critique() if name == "model-hull" else None)
    return found


def svgs(report: str) -> list[Element]:
    return list(ElementTree.fromstring(report).iter(f"{NAMESPACE}svg"))


def test_every_shape_of_the_shipped_sessions_is_painted_as_asked(reports: dict[str, str]) -> None:
    for svg in (svg for report in reports.values() for svg in svgs(report)):
        got, asked = painted(page_of(svg)), list(expected(svg))
        elements = [child for child in svg if child.tag.removeprefix(NAMESPACE) not in ("title", "text")]
        title = svg.findtext(f"{NAMESPACE}title")
        assert len(got) == len(asked), title
        for element, one, other in zip(elements, got, asked, strict=True):
            assert not differences(one, other, "transform" in element.attrib), (title, element.attrib)


def test_every_text_of_the_shipped_sessions_stands_where_it_was_put(reports: dict[str, str]) -> None:
    for svg in (svg for report in reports.values() for svg in svgs(report)):
        got, asked = texts(page_of(svg)), list(expected_texts(svg))
        assert Counter(text for text, _, _ in got) == Counter(text for text, _, _ in asked)
        for text, x, y in asked:
            assert any(text == t and math.hypot(x - a, y - b) < 0.01 for t, a, b in got), (text, x, y, got)


def test_the_shipped_sessions_have_every_element_that_is_known(reports: dict[str, str]) -> None:
    names = {e.tag.removeprefix(NAMESPACE) for report in reports.values() for svg in svgs(report) for e in svg}
    assert names - {"title"} == set(SHAPES)


def test_the_texts_of_the_drawings_are_in_the_whole_pdf(reports: dict[str, str], tmp_path: Path) -> None:
    for name, report in reports.items():
        write_pdf(report, tmp_path / f"{name}.pdf")
        whole = page_text(tmp_path / f"{name}.pdf")
        missing = {text for svg in svgs(report) for text, _, _ in expected_texts(svg) if text not in whole}
        assert not missing, name


def test_a_german_report_becomes_a_german_pdf(tmp_path: Path) -> None:
    report = gyradius.load(gyradius.shipped_session("keelboat")).measure().to_html(language="de")
    write_pdf(report, tmp_path / "r.pdf")
    assert PdfReader(tmp_path / "r.pdf").trailer["/Root"]["/Lang"] == "de"
    whole = page_text(tmp_path / "r.pdf")
    assert "Trägheitsradius Gieren" in whole
    assert "Woher die Unsicherheit kommt" in whole
    assert "uncertainty" not in whole
    assert "Yaw gyradius" not in whole


def test_drawings_stay_vectors(reports: dict[str, str], tmp_path: Path) -> None:
    write_pdf(reports["keelboat"], tmp_path / "r.pdf")
    reader = PdfReader(tmp_path / "r.pdf")
    assert not [image for page in reader.pages for image in page.images]
    strokes = sum(one.operator == "stroke" for page in reader.pages for one in painted(page))
    assert strokes >= sum(one.operator == "stroke" for svg in svgs(reports["keelboat"]) for one in expected(svg))


# By hand: what the shipped sessions may come to lack.


def svg_of(inner: str, more: str = "") -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50" font-size="10"{more}>{inner}</svg>'


def test_a_turn_is_clockwise_about_its_point() -> None:
    ellipse = '<ellipse cx="40" cy="20" rx="10" ry="5" fill="#dce8f3" transform="rotate({} 40 20)"/>'
    [upright] = painted(page_of(svg_of(ellipse.format(90))))
    assert upright.bounds == pytest.approx((35, 10, 45, 30), abs=0.01)
    polygon = '<polygon points="40,20 60,20" fill="#000000" transform="rotate(30 40 20)"/>'
    # On a page y grows downwards: a clockwise turn lowers the right end.
    [turned] = painted(page_of(svg_of(polygon)))
    assert turned.bounds == pytest.approx((40, 20, 40 + 20 * math.cos(math.radians(30)), 30), abs=0.01)


def test_dashes_opacity_and_colours_reach_the_page() -> None:
    line = '<line x1="1" y1="2" x2="30" y2="2" stroke="#b3261e" stroke-width="0.8" stroke-dasharray="2 3"/>'
    rect = '<rect x="1" y="2" width="3" height="4" fill="#8a5a00" fill-opacity="0.15"/>'
    plain = '<circle cx="5" cy="5" r="2" fill="#ffffff" stroke="#0b5c9e" stroke-width="1.4"/>'
    dashed, faint, dot = painted(page_of(svg_of(line + rect + plain)))
    assert dashed == Painted("stroke", (1, 2, 30, 2), "#b3261e", dashed.fill, 0.8, (2, 3), "miter", 1.0)
    assert (faint.operator, faint.fill, faint.opacity) == ("fill", "#8a5a00", 0.15)
    assert (dot.operator, dot.fill, dot.stroke, dot.dashes, dot.opacity) == ("both", "#ffffff", "#0b5c9e", (), 1.0)


def test_what_a_shape_does_not_say_it_has_from_the_drawing() -> None:
    page = page_of(svg_of('<rect width="3" height="4"/><text x="1" y="9">a</text>', ' fill="#1f2933"'))
    assert painted(page)[0].fill == "#1f2933"
    sizes = [operands[1] for operands, code in page.get_contents().operations if code == b"Tf"]
    assert sizes[-1] == 10


@pytest.mark.parametrize(
    "inner",
    [
        '<path d="M 0 0 L 1 1"/>',
        '<g><line x1="0" y1="0" x2="1" y2="1"/></g>',
        '<text x="0" y="0">a<tspan>b</tspan></text>',
        '<text x="0" y="0" rotate="3">a</text>',
        '<text x="0" y="0" text-anchor="inherit">a</text>',
        '<line x1="0" y1="0" x2="1" y2="1" stroke-linecap="round"/>',
        '<line x1="0" y1="0" x2="1"/>',
        '<line x1="0" y1="0" x2="1" y2="50%"/>',
        '<rect width="1" height="1" fill="red"/>',
        '<rect width="1" height="1" style="fill:#000000"/>',
        '<rect width="1" height="1" transform="scale(2)"/>',
        '<polyline points="0,0 1,1" fill="#000000"/>',
        '<polyline points="0,0 1" fill="none"/>',
    ],
)
def test_what_is_not_known_is_refused_and_not_left_out(inner: str, tmp_path: Path) -> None:
    with pytest.raises(UnknownMarkup, match="<"):
        write_pdf(f"<html><body><figure>{svg_of(inner)}</figure></body></html>", tmp_path / "r.pdf")


def test_an_unknown_attribute_of_the_drawing_itself_is_refused() -> None:
    with pytest.raises(UnknownMarkup, match="preserveAspectRatio"):
        page_of(svg_of("", ' preserveAspectRatio="none"'))
