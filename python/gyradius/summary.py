"""The first screen of a measurement: what was found, and what to look at before one relies on it."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from .labels import LABELS, UNITS, label
from .measurement import Finding, Measurement, SwingResult, Verdict
from .numbers import interval, with_u

# Shown unasked; the rest is in the details.
FINDINGS = 4
# The gravest first; what is only noted is a detail.
GRAVE = {"refused": "not given", "widened": "uncertainty widened", "warned": "warning"}
COLOURS = {"refused": "bold red", "widened": "yellow", "warned": "yellow"}
VERDICTS = {"pass": "green", "fail": "bold red"}


def show_summary(console: Console, measurement: Measurement) -> None:
    """The result, then the findings that matter."""
    show_result(console, measurement)
    show_findings(console, measurement, FINDINGS)
    hidden = _hidden(measurement)
    console.print(Text(f"Details (-v): {hidden}.", style="dim"))


def show_brief(console: Console, measurement: Measurement) -> None:
    """The result, and how many findings there are."""
    show_result(console, measurement)
    grave, noted = len(grave_findings(measurement)), len(notes(measurement))
    if grave + noted:
        console.print(Text(f"  {_count(grave, 'warning')}, {_count(noted, 'note')}: see the report", style="yellow"))


def show_result(console: Console, measurement: Measurement) -> None:
    """Title, quantities, verdicts on limits and what they rest on."""
    console.print(Text(measurement.title or "measurement", style="bold"))
    console.print(Padding(_result(measurement), (0, 0, 0, 2)))
    for verdict in measurement.verdicts:
        console.print(_verdict(verdict))
    console.print(Text(f"  {basis(measurement)}", style="dim"))


def show_findings(console: Console, measurement: Measurement, most: int | None = None) -> None:
    """Findings by severity, each with what to do; at most so many."""
    found = grave_findings(measurement)
    for severity, text in found[:most]:
        line = Text(f"{GRAVE[severity].capitalize()}: ", style=COLOURS[severity])
        console.print(Padding(line.append(text, style="default"), (0, 0, 0, 2)))
    rest = len(found) - len(found[:most])
    if rest:
        console.print(Text(f"  {_count(rest, 'more warning')}: -v shows all", style="yellow"))


def show_swings(console: Console, measurement: Measurement) -> None:
    """A line for each swing: how long it swung freely, and the modes that were found in it."""
    for swing in measurement.swings:
        lasting = f"{swing.span_s[1] - swing.span_s[0]:.0f} s; " if swing.span_s else ""
        modes = [f"{label(mode.mode)} {mode.period_s:.4g} s" for mode in swing.modes if not mode.parasitic]
        console.print(Text(f"  {swing.id}: {lasting}{', '.join(modes) or 'no oscillation found'}"))


def grave_findings(measurement: Measurement) -> list[tuple[str, str]]:
    """Severity and text of what a reader must know, the gravest first.

    A contradiction is told once: what the single tests of it say is in the table of consistency.
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
    """What is only noted."""
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


def _result(measurement: Measurement) -> Table:
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    for justify in ("left", "right", "left", "left"):
        table.add_column(justify=justify, no_wrap=True)
    if not measurement.quantities:
        for row in _modes(measurement.swings):
            table.add_row(*row)
    for name in sorted(measurement.quantities, key=_rank):
        quantity = measurement.quantities[name]
        if not isinstance(quantity.value, tuple):
            bounds = interval(quantity.interval_95, quantity.u)
            value = with_u(quantity.value, quantity.u)
            table.add_row(label(name), value, UNITS.get(name, ""), bounds and f"95 %: {bounds}")
    return table


def _rank(name: str) -> int:
    """The order in which people ask for quantities; what is not in it comes last."""
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


def _told(finding: Finding) -> str:
    where = f"{finding.swing}: " if finding.swing else ""
    return f"{where}{finding.text}. {finding.advice}"


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
