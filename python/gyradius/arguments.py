"""What a user types: quantities and choices."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from enum import Enum
from typing import Annotated, Any

import typer

SessionPath = Annotated[str, typer.Argument(metavar="SESSION", help="Session folder, session zip or bare recording.")]
Json = Annotated[
    str | None,
    typer.Option("--json", metavar="FILE", help="Also write the numbers as JSON (- for standard output)."),
]
Limits = Annotated[
    list[str] | None,
    typer.Option("--limit", metavar="LIMIT", help="Class limit, such as k_pitch>=1.100; repeatable."),
]
Map = Annotated[
    list[str] | None,
    typer.Option("--map", metavar="FIELD=COLUMN:UNIT", help="Column of an unrecognised table; repeatable."),
]


class Suspension(str, Enum):
    """How the body hung."""

    bifilar = "bifilar"
    compound = "compound"
    trifilar = "trifilar"
    free = "free"


class Orientation(str, Enum):
    """The direction that joins the suspension points."""

    athwartships = "athwartships"
    fore_and_aft = "fore_and_aft"


class Platform(str, Enum):
    """The phone's system."""

    android = "android"
    ios = "ios"


class Language(str, Enum):
    """The language of a report, by its tag."""

    en = "en"
    de = "de"


# Units that may follow a number, by kind of figure, in SI units or degrees; the first is the default.
UNITS = {
    "metres": {"m": "1", "cm": "0.01", "mm": "0.001", "in": "0.0254", "ft": "0.3048"},
    "kilograms": {"kg": "1", "g": "0.001", "t": "1000", "lb": "0.45359237", "lbs": "0.45359237"},
    "degrees": {"deg": "1", "°": "1"},
    "m/s²": {"m/s²": "1", "m/s2": "1"},
}
EXAMPLES = {
    "metres": "3.477, 347.7cm or 3.477:0.006",
    "kilograms": "622.7, 622.7kg or 622.7:0.5",
    "degrees": "12.5 or 12.5:0.2",
    "m/s²": "9.81 or 9.8127:0.0005",
}
NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
UNIT = r"[^\d\s:±,.+-]\S*?"
ONE = rf"({NUMBER})\s*({UNIT})?"
FIGURE = re.compile(rf"\s*{ONE}\s*(?:(?::|±|\+/?-)\s*{ONE}\s*)?")
DECIMAL_COMMA = re.compile(r"(\d),(\d)")


@dataclass(frozen=True)
class Figure:
    """A stated number in SI units or degrees, with its standard uncertainty if one is stated."""

    value: float
    u: float | None

    def stated(self) -> float | tuple[float, float]:
        """For an import: a figure without an uncertainty gets the usual one of its kind."""
        return self.value if self.u is None else (self.value, self.u)

    def exact(self) -> tuple[float, float]:
        """For a plan: a figure without an uncertainty is exact."""
        return self.value, self.u or 0.0


def figure(text: str, of: str) -> Figure:
    """``3.477``, ``3.477:0.006``, ``347.7cm ± 6mm``; ``of`` is a key of :data:`UNITS`.

    A unit after the first number alone applies to both. ValueError says what was expected and how to write it.
    """
    known = UNITS[of]
    found = FIGURE.fullmatch(text)
    first = next(iter(known))
    written = (found[2] or first, found[4] or found[2] or first) if found else ("", "")
    units = [unit.lower() for unit in written]
    if not found or any(unit not in known for unit in units):
        raise ValueError(_expected(text, of))
    value, u = _scaled(found[1], known[units[0]]), found[3]
    u_si = None if u is None else _scaled(u, known[units[1]])
    if not math.isfinite(value) or (u_si is not None and not 0.0 <= u_si < math.inf):
        raise ValueError(_expected(text, of))
    return Figure(value, u_si)


def _scaled(number: str, factor: str) -> float:
    """Exact in decimals: 150.3 cm is 1.503 m, without a rounding error."""
    return float(Decimal(number) * Decimal(factor))


def _expected(text: str, of: str) -> str:
    point = DECIMAL_COMMA.sub(r"\1.\2", text)
    hint = "" if point == text or "." in text else f"; write a decimal point: {point}"
    accepted = ", ".join(UNITS[of])
    return (
        f"expected {of}, such as {EXAMPLES[of]} with one standard uncertainty after a colon "
        f"(units: {accepted}; {next(iter(UNITS[of]))} where none is written), found `{text}`{hint}"
    )


def given(option: str, text: str | None, of: str) -> Figure | None:
    """The figure of an option; an error names the option."""
    if text is None:
        return None
    try:
        return figure(text, of)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint=option) from None


def stated(of: str, note: str) -> Any:
    """An option that holds a figure."""
    return typer.Option(metavar="VALUE[:U]", help=f"{of}; {note}" if note else of)


def stated_value(option: str, text: str | None, of: str) -> float | tuple[float, float] | None:
    """The figure of an option, for an import."""
    found = given(option, text, of)
    return None if found is None else found.stated()


def exact_value(option: str, text: str | None, of: str) -> tuple[float, float] | None:
    """The figure of an option, for a plan."""
    found = given(option, text, of)
    return None if found is None else found.exact()


def plain_value(option: str, text: str | None, of: str) -> float | None:
    """The figure of an option that takes no uncertainty."""
    found = given(option, text, of)
    if found is not None and found.u is not None:
        raise typer.BadParameter(f"expected one number, found `{text}`", param_hint=option)
    return None if found is None else found.value


def with_uncertainty(found: Figure | None) -> dict[str, float] | None:
    """A figure in the form that a plan's request holds."""
    return None if found is None else {"value": found.value, "u": found.u or 0.0}
