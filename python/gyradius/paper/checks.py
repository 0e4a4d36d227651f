"""Printed beside computed: how far apart, and whether rounding explains it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, TypeAlias

from ..arrays import evaluate_route
from .print_data import UNITS, Printed, errata, printed

#: Not a printed number: the standard gravity; the print does not state the site's.
GRAVITY_M_S2 = 9.80665
#: Room for the last digit of a float beside a limit.
SLACK = 1.0 + 1e-9

Verdict: TypeAlias = Literal["reproduced", "input rounding", "differs"]
Inputs: TypeAlias = Mapping[str, Printed | float]


@dataclass(frozen=True, slots=True)
class Computed:
    """A computed number, SI units."""

    value: float
    #: How far the rounding of the printed inputs can move it, all of them together.
    spread: float
    #: The equation, or what else it comes from.
    how: str


@dataclass(frozen=True, slots=True)
class Check:
    """A printed number beside the computed one."""

    #: What it is, such as ``k_y, added 1.2 kg``.
    label: str
    printed: Printed
    computed: Computed
    #: Id of the erratum that explains a difference.
    erratum: str | None = None
    #: The printed number went into a simulation, and the analysis of its record returns it: no test of the print.
    is_round_trip: bool = False

    @property
    def difference(self) -> float:
        """Computed less printed, in the unit of the print."""
        return self.computed_in_unit - self.printed.in_unit

    @property
    def computed_in_unit(self) -> float:
        """In the unit of the print."""
        return self.computed.value / UNITS[self.printed.unit]

    @property
    def spread_in_unit(self) -> float:
        """In the unit of the print."""
        return self.computed.spread / UNITS[self.printed.unit]

    @property
    def verdict(self) -> Verdict:
        """Whether the print's own rounding covers the difference, that of its inputs, or neither."""
        if self.printed.is_bound:
            return "reproduced" if self.difference < 0.0 else "differs"
        beyond = abs(self.difference)
        if beyond <= self.printed.rounding_in_unit * SLACK:
            return "reproduced"
        covered = (self.printed.rounding_in_unit + self.spread_in_unit) * SLACK
        return "input rounding" if beyond <= covered else "differs"


def compared(label: str, printed_id: str, computed: Computed, erratum: str | None = None) -> Check:
    """A check of a printed number; an erratum must be one of the list."""
    if erratum is not None and erratum not in errata():
        raise KeyError(erratum)
    return Check(label, printed(printed_id), computed, erratum)


def returned(label: str, printed_id: str, value: float, how: str) -> Check:
    """A printed number that went into a simulation, beside the one that came out."""
    return Check(label, printed(printed_id), Computed(value, 0.0, f"simulated, {how}"), is_round_trip=True)


def by_route(route: str, output: str, inputs: Inputs, how: str) -> Computed:
    """One output of a closed-form estimator of the core, with the spread by its printed inputs."""
    return by_function(lambda given: evaluate_route(route, given)[output], inputs, how)


def by_function(function: Callable[[dict[str, float]], float], inputs: Inputs, how: str) -> Computed:
    """A function of several numbers, with the spread by the rounding of those that are printed."""
    given = {name: _value(number) for name, number in inputs.items()}
    value = function(given)
    rounded = [(name, number) for name, number in inputs.items() if isinstance(number, Printed) and number.rounding]
    moved = [
        max(abs(function({**given, name: given[name] + side * number.rounding}) - value) for side in (-1.0, 1.0))
        for name, number in rounded
    ]
    return Computed(value, sum(moved), how)


def _value(number: Printed | float) -> float:
    return number.value if isinstance(number, Printed) else float(number)
