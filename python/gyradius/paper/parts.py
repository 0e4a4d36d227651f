"""What the paper's figures and tables become here."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .checks import Check, Verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VERDICTS: tuple[Verdict, ...] = ("reproduced", "input rounding", "differs")


@dataclass(frozen=True)
class PaperFigure:
    """A figure, drawn again."""

    #: As the paper counts, such as ``15``.
    number: str
    title: str
    #: What is drawn, and by which equations.
    caption: str
    drawing: Figure
    #: What the text does not give, and what is assumed for it.
    remark: str = ""
    checks: tuple[Check, ...] = ()
    #: Ids of the errata that it meets without a number to compare.
    errata: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Of its files."""
        return f"figure-{int(self.number):02}"


@dataclass(frozen=True)
class PaperTable:
    """A table, or numbers of the text, computed again."""

    #: ``Table 1``; the two tables that are both printed as 4 are ``Table 4 (first)`` and ``Table 4 (second)``.
    heading: str
    title: str
    caption: str
    checks: tuple[Check, ...]
    remark: str = ""
    errata: tuple[str, ...] = ()
    #: Words that the print has in place of numbers, beside what was found.
    words: tuple[Words, ...] = ()

    @property
    def name(self) -> str:
        """Of its files."""
        return self.heading.lower().replace(" (", "-").replace(")", "").replace(" ", "-")


@dataclass(frozen=True, slots=True)
class Words:
    """A row of a table that holds names: those printed and those found."""

    label: str
    printed: str
    found: str

    @property
    def agrees(self) -> bool:
        """Whether the same names stand in both."""
        return set(self.printed.split(", ")) == set(self.found.split(", "))


@dataclass(frozen=True)
class Paper:
    """Every table and figure."""

    tables: tuple[PaperTable, ...]
    figures: tuple[PaperFigure, ...]
    #: Number of each figure that holds no data, and what it shows.
    without_data: tuple[tuple[str, str], ...] = ()

    @property
    def checks(self) -> tuple[Check, ...]:
        """Every printed number that is recomputed, once."""
        return _once(check for check in _all_checks(self) if not check.is_round_trip)

    @property
    def round_trips(self) -> tuple[Check, ...]:
        """Every printed number that a simulation was made of, and its record returns."""
        return _once(check for check in _all_checks(self) if check.is_round_trip)

    def counts(self) -> dict[Verdict, int]:
        """How many of the recomputed numbers have each verdict."""
        verdicts = [check.verdict for check in self.checks]
        return {verdict: verdicts.count(verdict) for verdict in VERDICTS}


def _once(checks: Iterable[Check]) -> tuple[Check, ...]:
    found: dict[str, Check] = {}
    for check in checks:
        found.setdefault(check.printed.id, check)
    return tuple(found.values())


def _all_checks(paper: Paper) -> Iterable[Check]:
    parts: tuple[PaperTable | PaperFigure, ...] = (*paper.tables, *paper.figures)
    for part in parts:
        yield from part.checks
