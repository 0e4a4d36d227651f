"""Comparisons and summaries as text, for the page, the Markdown and the tables' files."""

from __future__ import annotations

from .checks import Check
from .parts import Paper
from .print_data import SHOWN_UNITS, Printed, all_printed, errata

HEADER = ("quantity", "printed", "computed", "difference", "rounding", "by the inputs", "from", "result")
CSV_HEADER = (
    "quantity",
    "printed_id",
    "printed",
    "unit",
    "computed",
    "difference",
    "print_rounding",
    "input_rounding",
    "from",
    "round_trip",
    "verdict",
    "erratum",
)
WORDS_HEADER = ("suspension", "printed", "found", "result")
VERDICT_TEXTS = {
    "reproduced": "reproduced",
    "input rounding": "within input rounding",
    "differs": "differs",
}
READING = (
    "Rounding: half of a unit of the printed number's last digit, or the limits that the print states. By the "
    "inputs: how far the rounding of the printed inputs can move the computed number. A number is reproduced where "
    "the difference is within its own rounding; it is within input rounding where both together cover "
    "the difference; otherwise it differs, and the erratum says why."
)
MODE_OF_WORK = (
    "Gravity is the standard one, 9.80665 m/s², because the paper does not print its own. Every number comes from "
    "the equations of the core (gyradius routes), from its simulation or from its decomposition."
)


def row(check: Check) -> tuple[str, ...]:
    """A comparison as the page shows it."""
    printed = check.printed
    return (
        check.label,
        _with_unit(printed),
        _number(check, check.computed_in_unit),
        _number(check, check.difference, sign="+"),
        f"{printed.rounding_in_unit:g}",
        f"{check.spread_in_unit:.2g}" if check.spread_in_unit else "–",
        check.computed.how,
        result(check),
    )


def _with_unit(printed: Printed) -> str:
    unit = SHOWN_UNITS.get(printed.unit, printed.unit)
    text = printed.text.replace("-", "−")
    return text + unit if unit == "°" else f"{text} {unit}".strip()


def result(check: Check) -> str:
    """The verdict in words, with its erratum."""
    text = "returned" if check.is_round_trip and check.verdict == "reproduced" else VERDICT_TEXTS[check.verdict]
    return f"{text}: {check.erratum}" if check.erratum else text


def _number(check: Check, value: float, sign: str = "") -> str:
    """With one digit more than the print."""
    if "e" in check.printed.text:
        return f"{value:{sign}.1e}".replace("-", "−")
    digits = check.printed.decimals + 1
    # Adding zero turns -0 into 0.
    rounded = round(value, digits) + 0.0
    return f"{rounded:{sign if rounded else ''}.{digits}f}".replace("-", "−")


def csv_row(check: Check) -> tuple[str, ...]:
    """A comparison for a table's file, numbers in the unit of the print."""
    return (
        check.label,
        check.printed.id,
        check.printed.text,
        check.printed.unit,
        f"{check.computed_in_unit:.8g}",
        f"{check.difference:.4g}",
        f"{check.printed.rounding_in_unit:g}",
        f"{check.spread_in_unit:.4g}",
        check.computed.how,
        "yes" if check.is_round_trip else "no",
        check.verdict,
        check.erratum or "",
    )


def summary(paper: Paper) -> list[str]:
    """What the page says at its head, sentence by sentence."""
    counts, trips = paper.counts(), paper.round_trips
    back = sum(check.verdict == "reproduced" for check in trips)
    new = sum(not one.is_known for one in errata().values())
    compared = {check.printed.id for check in (*paper.checks, *trips)}
    return [
        f"{len(paper.checks)} printed numbers are recomputed from other printed numbers.",
        f"{counts['reproduced']} agree within their own rounding, and {counts['input rounding']} more within the "
        f"rounding of the numbers that they are computed from. {counts['differs']} do not.",
        f"{len(trips)} further printed numbers are put into a simulation, and the analysis of its record returns "
        f"{back} of them within rounding. {len(all_printed().keys() - compared)} serve as inputs alone.",
        f"{len(errata())} places where the print is wrong or contradicts itself are listed at the end; {new} of them "
        "came out of this recomputation.",
    ]


def reasons(paper: Paper) -> list[tuple[str, str]]:
    """What differs, and why: one entry for each erratum."""
    found: dict[str, list[str]] = {}
    for check in paper.checks:
        if check.verdict == "differs" and check.erratum:
            said = f"{check.label}: printed {row(check)[1]}, computed {row(check)[2]}"
            found.setdefault(check.erratum, []).append(said)
    return [("; ".join(said), _sentence(errata()[id_].correct)) for id_, said in found.items()]


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
