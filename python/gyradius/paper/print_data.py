"""What the paper prints: numbers with their units and rounding (``printed.csv``), and misprints (``errata.csv``)."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from functools import cache
from importlib import resources

from .._core import InputError

DEGREE = math.pi / 180.0
#: One of each unit of the print, in SI units.
UNITS = {
    "1": 1.0,
    "%": 1e-2,
    "m": 1.0,
    "cm": 1e-2,
    "mm": 1e-3,
    "s": 1.0,
    "kg": 1.0,
    "deg": DEGREE,
    "mm/deg": 1e-3 / DEGREE,
    "kg m2": 1.0,
    "kg/m3": 1.0,
}
#: What each unit is called on the page.
SHOWN_UNITS = {"1": "", "deg": "°", "kg m2": "kg m²", "kg/m3": "kg/m³", "mm/deg": "mm/°"}


@dataclass(frozen=True, slots=True)
class Printed:
    """A number of the print."""

    id: str
    #: As it stands there; ``<`` before it makes it an upper bound.
    text: str
    unit: str
    where: str
    #: Half of a unit of its last digit, or the limits that the print states, in its unit.
    rounding_in_unit: float

    @property
    def value(self) -> float:
        """In SI units."""
        return self.in_unit * UNITS[self.unit]

    @property
    def in_unit(self) -> float:
        """In the unit of the print."""
        return float(self.text.removeprefix("<"))

    @property
    def rounding(self) -> float:
        """How far from it the number before rounding may have been, in SI units."""
        return self.rounding_in_unit * UNITS[self.unit]

    @property
    def is_bound(self) -> bool:
        """Whether the print says less than this."""
        return self.text.startswith("<")

    @property
    def decimals(self) -> int:
        """Digits after its point."""
        return len(self.text.partition(".")[2])


@dataclass(frozen=True, slots=True)
class Erratum:
    """A place where the print is wrong, or contradicts itself."""

    id: str
    place: str
    printed: str
    correct: str
    #: Known before; the others came out of the recomputation.
    is_known: bool


def printed(id_: str) -> Printed:
    """The printed number of an id."""
    found = all_printed().get(id_)
    if found is None:
        raise InputError(f"{id_}: the paper's data (printed.csv) hold no such number")
    return found


def erratum(id_: str) -> Erratum:
    """The erratum of an id."""
    return errata()[id_]


@cache
def errata() -> dict[str, Erratum]:
    """Every erratum by its id."""
    return {row["id"]: _erratum(row) for row in _rows("errata.csv")}


@cache
def all_printed() -> dict[str, Printed]:
    """Every printed number by its id."""
    return {row["id"]: _printed(row) for row in _rows("printed.csv")}


def _rows(name: str) -> list[dict[str, str]]:
    text = resources.files(__package__).joinpath(name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))


def _printed(row: dict[str, str]) -> Printed:
    rounding = float(row["rounding"]) if row["rounding"] else _half_unit(row["printed"])
    return Printed(row["id"], row["printed"], row["unit"], row["where"], rounding)


def _half_unit(text: str) -> float:
    """Half of a unit of the last digit."""
    return 0.5 * 10.0 ** -len(text.partition(".")[2])


def _erratum(row: dict[str, str]) -> Erratum:
    return Erratum(row["id"], row["place"], row["printed"], row["correct"], row["known"] == "yes")
