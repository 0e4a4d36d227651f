"""What is missing, implausible or weak in a session, to be checked before a long run or a report."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

from rich.console import Console
from rich.padding import Padding
from rich.text import Text

from .labels import UNITS, label
from .measurement import BudgetLine, Measurement, Quantity
from .numbers import short
from .summary import grave_findings, notes, sentence, show_result

FORMAT = "gyradius-check/1"


@dataclass(frozen=True, slots=True)
class Limit:
    """The input that limits a quantity most, and its fraction of the variance."""

    quantity: str
    relative_u: float | None
    input: str
    u_contribution: float
    fraction: float


def limits(measurement: Measurement) -> tuple[Limit, ...]:
    """The largest contribution to each scalar quantity that has a budget."""
    found = []
    for name, lines in measurement.budget.items():
        quantity = measurement.quantities.get(name)
        if quantity is not None and lines and not isinstance(quantity.value, tuple):
            found.append(_limit(name, quantity, lines))
    return tuple(found)


def _limit(name: str, quantity: Quantity, lines: tuple[BudgetLine, ...]) -> Limit:
    # A budget begins with its largest line.
    most = lines[0]
    variance = sum(line.u_contribution**2 for line in lines)
    # An uncertainty relative to an angle means nothing.
    is_relative = bool(quantity.value) and UNITS.get(name) != "°"
    return Limit(
        quantity=name,
        relative_u=quantity.u / abs(quantity.value) if is_relative else None,
        input=most.input,
        u_contribution=most.u_contribution,
        fraction=most.u_contribution**2 / variance if variance else 0.0,
    )


def check_json(measurement: Measurement) -> str:
    """Findings and limits as JSON."""
    severe = [{"severity": severity, "text": text} for severity, text in grave_findings(measurement)]
    noted = [{"severity": one.severity, "text": sentence(one)} for one in notes(measurement)]
    body = {
        "format": FORMAT,
        "title": measurement.title,
        "findings": severe + noted,
        "limits": [asdict(limit) for limit in limits(measurement)],
    }
    return json.dumps(body, ensure_ascii=False, indent=2)


def show_check(console: Console, measurement: Measurement) -> None:
    """Print the result, what to fix, what to note, and what limits each quantity."""
    show_result(console, measurement)
    severe = [text for _, text in grave_findings(measurement)]
    noted = [sentence(finding) for finding in notes(measurement)]
    _section(console, "To fix", severe, "yellow")
    _section(console, "To note", noted, "dim")
    _section(console, "What limits each quantity", [_limiting(limit) for limit in limits(measurement)], "dim")
    if not severe:
        console.print(Text("Nothing is missing or implausible.", style="green"))


def _section(console: Console, title: str, texts: list[str], style: str) -> None:
    if texts:
        console.print(Text(f"{title}:", style="bold"))
    for text in texts:
        console.print(Padding(Text("- ", style=style).append(text, style="default"), (0, 0, 0, 2)))


def _limiting(limit: Limit) -> str:
    """``Yaw gyradius, u 0.042 %: spacing (73 % of the variance)``."""
    size = f", u {short(100.0 * limit.relative_u, 2)} %" if limit.relative_u is not None else ""
    cause = limit.input.replace("_", " ")
    return f"{label(limit.quantity)}{size}: {cause} ({100.0 * limit.fraction:.0f} % of the variance)"
