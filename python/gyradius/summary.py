"""The first screen of a measurement: the result, and what to check before relying on it."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from .labels import LABELS, UNITS, label
from .measurement import Finding, Measurement, SwingResult, Verdict
from .numbers import interval, with_u

# How many warnings are shown without -v.
NARROW = 76
FINDINGS = 4
# The most severe first; notes are shown with -v.
GRAVE = {"refused": "not given", "widened": "uncertainty widened", "warned": "warning"}
COLOURS = {"refused": "bold red", "widened": "yellow", "warned": "yellow"}
VERDICTS = {"pass": "green", "fail": "bold red"}


def show_summary(console: Console, measurement: Measurement, details: str = "-v") -> None:
    """The result, then the findings that matter; ``details`` is how to see the rest."""
    show_result(console, measurement)
    show_findings(console, measurement, FINDINGS)
    hidden = _hidden(measurement)
    console.print(Text(f"Details ({details}): {hidden}.", style="dim"))


def show_brief(console: Console, measurement: Measurement) -> None:
    """The result, and how many findings there are."""
    show_result(console, measurement)
    grave, noted = len(grave_findings(measurement)), len(notes(measurement))
    if grave + noted:
        console.print(Text(f"  {_count(grave, 'warning')}, {_count(noted, 'note')}: see the report", style="yellow"))


def show_result(console: Console, measurement: Measurement) -> None:
    """Title, quantities, verdicts on limits and what they rest on."""
    console.print(Text(measurement.title or "measurement", style="bold"))
    rows = list(_rows(measurement))
    if console.width < NARROW:
        for row in rows:
            console.print(Text("  " + " ".join(filter(None, row))), soft_wrap=False)
    else:
        console.print(Padding(_table(rows), (0, 0, 0, 2)))
    for verdict in measurement.verdicts:
        console.print(_verdict(verdict))
    console.print(Text(f"  {basis(measurement)}", style="dim"))


def show_findings(console: Console, measurement: Measurement, most: int | None = None) -> None:
    """Findings by severity, each with advice; ``most`` limits how many."""
    found = grave_findings(measurement)
    for severity, text in found[:most]:
        line = Text(f"{GRAVE[severity].capitalize()}: ", style=COLOURS[severity])
        console.print(Padding(line.append(text, style="default"), (0, 0, 0, 2)))
    rest = len(found) - len(found[:most])
    if rest:
        console.print(Text(f"  {_count(rest, 'more warning')}: -v shows all", style="yellow"))


def show_swings(console: Console, measurement: Measurement) -> None:
    """One line per swing: how long it swung freely, and the modes found in it."""
    for swing in measurement.swings:
        lasting = f"{swing.span_s[1] - swing.span_s[0]:.0f} s; " if swing.span_s else ""
        modes = [f"{label(mode.mode)} {mode.period_s:.4g} s" for mode in swing.modes if not mode.parasitic]
        console.print(Text(f"  {swing.id}: {lasting}{', '.join(modes) or 'no oscillation found'}"))


def grave_findings(measurement: Measurement) -> list[tuple[str, str]]:
    """Severity and text of the warnings, the most severe first.

    A contradiction is reported once; its individual tests are in the table of consistency tests.
    """
    found = [(finding.severity, _told(finding)) for finding in measurement.findings if finding.severity in GRAVE]
    known = [text for _, text in found]
    tests = {claim.text for claim in measurement.consistency if claim.flagged}
    is_told = any(finding.kind == "contradiction" for finding in measurement.findings)
    of_swings = [f"{swing.id}: {text}" for swing in measurement.swings for text in swing.warnings]
    for text in [*measurement.warnings, *of_swings]:
        if not (is_told and text in tests) and not _is_among(text, known):
            found.append(("warned", text))
    return sorted(found, key=lambda one: list(GRAVE).index(one[0]))


def notes(measurement: Measurement) -> list[Finding]:
    """The findings that are only notes."""
    return [finding for finding in measurement.findings if finding.severity not in GRAVE]


def basis(measurement: Measurement) -> str:
    """How many swings a result rests on, and how well they are explained."""
    swings = measurement.swings
    parts = [_count(len(swings), "swing")]
    simulated = [swing.rms_over_noise for swing in swings if swing.simulated and swing.rms_over_noise is not None]
    if simulated:
        low, high = (f"{value:.2f}" for value in (min(simulated), max(simulated)))
        spread = low if low == high else f"{low} to {high}"
        count = "" if len(simulated) == len(swings) else f" of {len(simulated)}"
        parts.append(f"residual of the simulation{count} {spread} times the noise")
    return "; ".join(parts)


def _table(rows: Iterable[tuple[str, ...]]) -> Table:
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    for justify in ("left", "right", "left", "left"):
        table.add_column(justify=justify, no_wrap=True)
    for row in rows:
        table.add_row(*row)
    return table


def _rows(measurement: Measurement) -> Iterable[tuple[str, ...]]:
    """Name, value, unit and interval of each scalar quantity; of the modes where there is none."""
    if not measurement.quantities:
        yield from _modes(measurement.swings)
    for name in sorted(measurement.quantities, key=_rank):
        quantity = measurement.quantities[name]
        if not isinstance(quantity.value, tuple):
            bounds = interval(quantity.interval_95, quantity.u)
            value = with_u(quantity.value, quantity.u)
            yield label(name), value, UNITS.get(name, ""), bounds and f"95 %: {bounds}"


def _rank(name: str) -> int:
    """The usual order of quantities; an unknown one comes last."""
    order = list(LABELS)
    return order.index(name) if name in order else len(order)


def _modes(swings: Iterable[SwingResult]) -> Iterable[tuple[str, ...]]:
    for swing in swings:
        for mode in swing.modes:
            if not mode.parasitic:
                yield f"{swing.id}, {label(mode.mode)}", with_u(mode.period_s, mode.period_se_s), "s", ""


def _verdict(verdict: Verdict) -> Text:
    text = Text(f"  {label(verdict.quantity)} {verdict.relation} {verdict.limit:g} {UNITS.get(verdict.quantity, '')}: ")
    text.append(verdict.verdict, style=VERDICTS.get(verdict.verdict, "yellow"))
    return text.append(f" (probability {verdict.conformance_probability:.4f})", style="dim")


def sentence(finding: Finding) -> str:
    """What was found, and what to do about it."""
    return f"{finding.text}. {finding.advice}"


def _told(finding: Finding) -> str:
    where = f"{finding.swing}: " if finding.swing else ""
    return where + sentence(finding)


def _is_among(text: str, known: list[str]) -> bool:
    """Whether a warning is one of the findings, which it repeats with another introduction."""
    return any(one.partition(": ")[2] in text or one in text or text in one for one in known)


def _hidden(measurement: Measurement) -> str:
    parts = ["swings"]
    if measurement.alternatives:
        parts.append("closed-form estimates")
    if measurement.budget:
        parts.append("uncertainty budget")
    if measurement.consistency:
        parts.append("consistency tests")
    noted = len(notes(measurement))
    return ", ".join([*parts, _count(noted, "note")] if noted else parts)


def _count(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
