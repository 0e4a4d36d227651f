"""What a user types: quantities and choices."""

from __future__ import annotations

from enum import Enum
from typing import Any

import typer


class Suspension(str, Enum):
    """How it hung."""

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


def quantity(text: str | None) -> tuple[float, float] | None:
    """``3.477:0.006`` or ``3.477``."""
    if text is None:
        return None
    value, _, u = text.partition(":")
    try:
        return float(value), float(u) if u else 0.0
    except ValueError:
        raise typer.BadParameter(f"expected VALUE or VALUE:U, found `{text}`") from None


def reading(text: str | None) -> float | tuple[float, float] | None:
    """The same of a reading, which gets the usual uncertainty of its kind where none is stated."""
    pair = quantity(text)
    return pair[0] if pair and text and ":" not in text else pair


def stated(unit: str) -> Any:
    """An option that holds a quantity."""
    return typer.Option(metavar="VALUE[:U]", help=f"{unit}; standard uncertainty after a colon.")
