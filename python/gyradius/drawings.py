"""The report's drawings as shapes of reportlab: the part of SVG that the core's pictures use, and no more.

An element, attribute or value that is not known here is an error: a picture with a part missing would still look whole.

# Conventions
Lengths are those of the view box. SVG's y grows downwards, reportlab's grows upwards.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias
from xml.etree.ElementTree import Element

from reportlab.graphics.shapes import (
    Circle,
    Drawing,
    Ellipse,
    Group,
    Line,
    Polygon,
    PolyLine,
    Rect,
    String,
    mmult,
    rotate,
    translate,
)
from reportlab.lib.colors import Color, HexColor

NAMESPACE = "{http://www.w3.org/2000/svg}"
ANCHORS = {"start", "middle", "end"}
LINE_JOINS = {"miter": 0, "round": 1, "bevel": 2}


class UnknownMarkup(ValueError):
    """A drawing has something that cannot be drawn here."""

    def __str__(self) -> str:
        """The message."""
        return f"the PDF cannot draw this: {self.args[0]}"


def drawn(svg: Element, font: str) -> Drawing:
    """An SVG as a drawing, all of its texts in one font."""
    root = _Attributes(svg, {})
    left, top, width, height = root.numbers("viewBox")
    if (left, top) != (0.0, 0.0):
        raise UnknownMarkup(f"a view box that begins at ({left:g}, {top:g}) instead of (0, 0)")
    # Read aloud by a screen reader; the PDF has one font for all.
    for ignored in ("role", "font-family"):
        root.text(ignored, "")
    inherited = {"fill": root.text("fill", "#000000"), "font-size": root.text("font-size", "16")}
    root.refuse_the_rest()
    drawing = Drawing(width, height)
    for element in svg:
        name = element.tag.removeprefix(NAMESPACE)
        if name != "title":
            drawing.add(_Shapes(_Attributes(element, inherited), height, font).shape(name))
    return drawing


class _Attributes:
    """The attributes of an element. Each is taken once; what nobody took is not known."""

    def __init__(self, element: Element, inherited: Mapping[str, str]) -> None:
        self.name = element.tag.removeprefix(NAMESPACE)
        self.content = element.text or ""
        self._own = dict(element.attrib)
        self._inherited = inherited
        self._children = [child.tag.removeprefix(NAMESPACE) for child in element]

    def text(self, key: str, default: str | None = None) -> str:
        """The element's own value, else the inherited one, else the default."""
        value = self._own.pop(key, self._inherited.get(key, default))
        if value is None:
            raise UnknownMarkup(f"<{self.name}> has no {key}")
        return value

    def numbers(self, key: str, default: str | None = None) -> list[float]:
        value = self.text(key, default)
        try:
            return [float(number) for number in re.split(r"[\s,]+", value.strip())]
        except ValueError:
            raise UnknownMarkup(f'<{self.name} {key}="{value}">: not numbers') from None

    def number(self, key: str, default: str | None = None) -> float:
        numbers = self.numbers(key, default)
        if len(numbers) != 1:
            raise UnknownMarkup(f"<{self.name}>: {key} is not one number")
        return numbers[0]

    def one_of(self, key: str, default: str, known: set[str]) -> str:
        value = self.text(key, default)
        if value not in known:
            raise UnknownMarkup(f'<{self.name} {key}="{value}">')
        return value

    def colour(self, key: str, default: str) -> Color | None:
        value = self.text(key, default)
        if value == "none":
            return None
        if not re.fullmatch(r"#[0-9a-fA-F]{6}", value):
            raise UnknownMarkup(f'<{self.name} {key}="{value}">: not a colour as #rrggbb')
        return HexColor(value)

    def refuse_the_rest(self) -> None:
        """Raise where an attribute was not taken."""
        for key, value in self._own.items():
            raise UnknownMarkup(f'<{self.name} {key}="{value[:40]}">')

    def refuse_children(self) -> None:
        """Raise where an element has others inside."""
        for child in self._children:
            raise UnknownMarkup(f"<{child}> in <{self.name}>")


class _Shapes:
    """An element of a drawing of a height as a shape."""

    def __init__(self, attributes: _Attributes, height: float, font: str) -> None:
        self._attributes = attributes
        self._height = height
        self._font = font

    def shape(self, name: str) -> Any:
        draw = SHAPES.get(name)
        if draw is None:
            raise UnknownMarkup(f"<{name}>")
        self._attributes.refuse_children()
        shape = self._turned(draw(self))
        self._attributes.refuse_the_rest()
        return shape

    def line(self) -> Line:
        number = self._attributes.number
        start, end = (number("x1"), self._up("y1")), (number("x2"), self._up("y2"))
        return Line(*start, *end, **self._stroke())

    def polyline(self) -> PolyLine:
        if self._attributes.colour("fill", "#000000") is not None:
            raise UnknownMarkup("<polyline> with a fill")
        return PolyLine(self._points(), **self._stroke())

    def polygon(self) -> Polygon:
        return Polygon(self._points(), **self._fill(), **self._stroke())

    def rect(self) -> Rect:
        number = self._attributes.number
        x, top, width, height = number("x", "0"), self._up("y", "0"), number("width"), number("height")
        return Rect(x, top - height, width, height, **self._fill(), **self._stroke())

    def circle(self) -> Circle:
        number = self._attributes.number
        return Circle(number("cx"), self._up("cy"), number("r"), **self._fill(), **self._stroke())

    def ellipse(self) -> Ellipse:
        number = self._attributes.number
        radii = number("rx"), number("ry")
        return Ellipse(number("cx"), self._up("cy"), *radii, **self._fill(), **self._stroke())

    def text(self) -> String:
        attributes = self._attributes
        return String(
            attributes.number("x"),
            self._up("y"),
            attributes.content,
            fontName=self._font,
            fontSize=attributes.number("font-size"),
            fillColor=attributes.colour("fill", "#000000"),
            textAnchor=attributes.one_of("text-anchor", "start", ANCHORS),
        )

    def _up(self, key: str, default: str | None = None) -> float:
        return self._height - self._attributes.number(key, default)

    def _points(self) -> list[float]:
        numbers = self._attributes.numbers("points")
        if len(numbers) % 2:
            raise UnknownMarkup(f"<{self._attributes.name}>: a point without y")
        return [self._height - number if i % 2 else number for i, number in enumerate(numbers)]

    def _fill(self) -> dict[str, Any]:
        attributes = self._attributes
        return {
            "fillColor": attributes.colour("fill", "#000000"),
            "fillOpacity": attributes.number("fill-opacity", "1"),
        }

    def _stroke(self) -> dict[str, Any]:
        attributes = self._attributes
        dashes = attributes.text("stroke-dasharray", "none")
        join = attributes.one_of("stroke-linejoin", "miter", set(LINE_JOINS))
        return {
            "strokeColor": attributes.colour("stroke", "none"),
            "strokeWidth": attributes.number("stroke-width", "1"),
            "strokeDashArray": None if dashes == "none" else [float(dash) for dash in dashes.split()],
            "strokeLineJoin": LINE_JOINS[join],
        }

    def _turned(self, shape: Any) -> Any:
        """A shape turned about a point; SVG's angles are positive clockwise, reportlab's counterclockwise."""
        transform = self._attributes.text("transform", "")
        if not transform:
            return shape
        turn = re.fullmatch(r"rotate\((\S+) (\S+) (\S+)\)", transform)
        if turn is None:
            raise UnknownMarkup(f'<{self._attributes.name} transform="{transform}">')
        degrees, x, y = (float(number) for number in turn.groups())
        about, back = translate(x, self._height - y), translate(-x, y - self._height)
        return Group(shape, transform=mmult(mmult(about, rotate(-degrees)), back))


Draw: TypeAlias = Callable[[_Shapes], Any]
SHAPES: dict[str, Draw] = {
    "circle": _Shapes.circle,
    "ellipse": _Shapes.ellipse,
    "line": _Shapes.line,
    "polygon": _Shapes.polygon,
    "polyline": _Shapes.polyline,
    "rect": _Shapes.rect,
    "text": _Shapes.text,
}
