"""A measurement and a criticism as notebooks show them: a small HTML table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from .critique import Critique
from .critique_tables import STATUS
from .labels import UNITS
from .measurement import Measurement, Quantity
from .numbers import interval, with_u
from .tables import elements

CELL = "text-align:left;white-space:nowrap;padding:0.1em 0.8em 0.1em 0"
HEAD = ("quantity", "value ± u", "95 %", "unit")


def measurement_html(measurement: Measurement) -> str:
    """Title, quantities, verdicts against class limits, and how many warnings there are."""
    parts = [_title(measurement.title or "measurement")]
    if measurement.quantities:
        parts.append(_table(HEAD, _rows(measurement.quantities)))
    else:
        parts.append(_line("No quantity is determined; the modes are in <code>.swings</code>."))
    for verdict in measurement.verdicts:
        told = f"{verdict.quantity} {verdict.relation} {verdict.limit:g}: {verdict.verdict}"
        chance = f"conformance probability {verdict.conformance_probability:.4f}"
        parts.append(_line(f"<b>{escape(told)}</b> ({chance})"))
    return _block([*parts, *_warnings(measurement.warnings)])


def critique_html(critique: Critique) -> str:
    """Title, verdict, and the quantities by the base and by the extended simulation."""
    word, _ = STATUS.get(critique.verdict.status, (critique.verdict.status, ""))
    parts = [_title(critique.title or "criticism"), _line(f"<b>{escape(word)}.</b> {escape(critique.verdict.text)}")]
    models = (critique.baseline, critique.extended)
    base, extended = ({row[0]: row for row in _rows(model.quantities)} for model in models)
    names = list(dict.fromkeys([*extended, *base]))
    if names:
        head = ("quantity", "base simulation", "extended simulation", "95 %", "unit")
        parts.append(_table(head, [_compared(base.get(name), extended.get(name)) for name in names]))
    return _block([*parts, *_warnings(critique.warnings)])


def short_text(kind: str, title: str, facts: Iterable[str]) -> str:
    """``<gyradius.Measurement 'title': fact, fact>``."""
    return f"<gyradius.{kind} {title!r}: {', '.join(facts)}>"


def figures(quantities: Mapping[str, Quantity]) -> list[str]:
    """``k_yaw_m = 1.0453 ± 0.0054`` of each scalar."""
    scalars = {name: quantity for name, quantity in quantities.items() if not isinstance(quantity.value, tuple)}
    return [f"{name} = {with_u(quantity.value, quantity.u)}" for name, quantity in scalars.items()]


def _rows(quantities: Mapping[str, Quantity]) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    for name, quantity in quantities.items():
        unit = UNITS.get(name, "")
        if isinstance(quantity.value, tuple):
            rows += [(f"{name} {label}", with_u(value, u), "", unit) for label, value, u in elements(quantity)]
        else:
            rows.append((name, with_u(quantity.value, quantity.u), interval(quantity.interval_95, quantity.u), unit))
    return rows


def _compared(base: tuple[str, ...] | None, extended: tuple[str, ...] | None) -> tuple[str, ...]:
    """A quantity by both simulations; the interval is that of the extended one, and empty where it has none."""
    name, *_, unit = extended or base or ("", "")
    value, interval_95 = extended[1:3] if extended else ("–", "")
    return name, base[1] if base else "–", value, interval_95, unit


def _table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    lines = [_row("th", head), *(_row("td", row) for row in rows)]
    return f"<table><thead>{lines[0]}</thead><tbody>{''.join(lines[1:])}</tbody></table>"


def _row(tag: str, cells: Iterable[str]) -> str:
    made = [f'<{tag} style="{CELL}">{escape(cell)}</{tag}>' for cell in cells]
    return f"<tr>{''.join(made)}</tr>"


def _title(text: str) -> str:
    return _line(f"<b>{escape(text)}</b>")


def _line(html: str) -> str:
    return f'<div style="margin:0.3em 0">{html}</div>'


def _warnings(warnings: tuple[str, ...]) -> list[str]:
    if not warnings:
        return []
    items = "".join(f"<li>{escape(text)}</li>" for text in warnings)
    count = "1 warning" if len(warnings) == 1 else f"{len(warnings)} warnings"
    return [f"<details><summary>{count}</summary><ul>{items}</ul></details>"]


def _block(parts: Iterable[str]) -> str:
    return f"<div>{''.join(parts)}</div>"
