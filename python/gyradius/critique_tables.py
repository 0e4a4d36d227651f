"""A criticism as text and tables on a terminal."""

from __future__ import annotations

from itertools import zip_longest

from rich.console import Console, Group, RenderableType
from rich.text import Text

from .critique import CauseResult, Critique, LearnedForce, ModelResult, NextSwing, ParameterResult
from .labels import UNITS
from .measurement import Quantity
from .numbers import decimals_for, short, with_u
from .tables import elements, grid, spaced, warning_line

STATUS = {
    "adequate": ("Nothing is missing", "bold green"),
    "explained": ("Explained", "bold green"),
    "ambiguous": ("Ambiguous", "bold yellow"),
    "unexplained": ("Unexplained", "bold red"),
}
# Discrepancies that are worth a row; the rest is in the JSON.
DISCREPANCY_ROWS = 10
# A parameter less certain than so many times its size is not determined.
UNDETERMINED = 3.0
RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def show_critique(console: Console, critique: Critique) -> None:
    """Print everything, the verdict first."""
    console.rule(Text(critique.title or "criticism", style="bold"))
    for part in _parts(critique):
        console.print(part)
        console.print()
    for text in critique.warnings:
        console.print(warning_line(text))


def _parts(critique: Critique) -> list[RenderableType]:
    parts: list[RenderableType] = [_verdict(critique)]
    if critique.causes:
        parts.append(_causes(critique))
    if critique.discrepancies:
        parts.append(_discrepancies(critique))
    if critique.baseline.quantities or critique.extended.quantities:
        parts.append(_quantities(critique))
    parts.append(_gain(critique))
    if critique.verdict.next_swing:
        parts.append(_next_swing(critique.verdict.next_swing))
    if critique.learned:
        parts.append(_learned(critique.learned))
    return parts


def _verdict(critique: Critique) -> Text:
    word, style = STATUS.get(critique.verdict.status, (critique.verdict.status, "bold"))
    said = critique.verdict.text or ", ".join(map(spaced, critique.verdict.causes))
    return Text.assemble((word, style), f". {said[0].upper()}{said[1:]}" if said else "")


def _causes(critique: Critique) -> RenderableType:
    table = grid("Causes tried", "cause", "probability", "log evidence", "parameters", words=("parameters",))
    for cause in critique.causes:
        parameters = [parameter_text(name, parameter) for name, parameter in cause.parameters.items()]
        told_apart = cause.id not in critique.verdict.indistinguishable_from
        remark = " (extended model)" if cause.taken else "" if told_apart else " (not told apart)"
        evidence = "–" if cause.log_evidence_gain is None else f"{cause.log_evidence_gain:+.5g}"
        table.add_row(
            spaced(cause.id) + remark,
            percent(cause.probability),
            evidence,
            "\n".join(parameters),
            style="bold" if cause.taken else "",
        )
    return Group(table, *(_said(cause) for cause in critique.causes if cause.taken and cause.text))


def _said(cause: CauseResult) -> Text:
    return Text(f"  {spaced(cause.id)}: {cause.text}")


def parameter_text(name: str, parameter: ParameterResult) -> str:
    """``yaw torque coefficient 12.10 ± 0.30 N m s²``; the unit that a name ends in is not said twice."""
    ending = parameter.unit.lower().replace("^", "").replace(" ", "_").replace("/", "_")
    name = spaced(name.removesuffix(f"_{ending}"))
    value, u = parameter.value, parameter.u
    if value is None or u is None or u > UNDETERMINED * abs(value):
        return f"{name} not determined"
    return f"{name} {with_u(value, u, unit_text(parameter.unit))}"


def unit_text(unit: str) -> str:
    """``N m s^2`` as it is printed: ``N m s²``; the unit of a bare number is not."""
    first, *parts = ("" if unit == "1" else unit).split("^")
    ends = [len(part) - len(part.lstrip("-0123456789")) for part in parts]
    return first + "".join(part[:end].translate(RAISED) + part[end:] for part, end in zip(parts, ends, strict=True))


def percent(probability: float | None) -> str:
    """A probability that does not round to certainty."""
    if probability is None:
        return "–"
    if probability > 0.999:
        return "> 99.9 %"
    return "< 0.1 %" if probability < 0.001 else f"{100.0 * probability:.1f} %"


def _discrepancies(critique: Critique) -> RenderableType:
    columns = ("swing", "what", "size", "sigma", "in words")
    table = grid("What the base simulation gets wrong", *columns, left=2, words=("in words",))
    for found in critique.discrepancies[:DISCREPANCY_ROWS]:
        size = f"{short(found.size)} {unit_text(found.unit)}".rstrip()
        table.add_row(
            found.swing or "between",
            spaced(found.what.replace("_vs_", " against ")),
            size,
            short(found.sigma),
            found.text,
        )
    rest = len(critique.discrepancies) - DISCREPANCY_ROWS
    return Group(table, Text(f"  and {rest} more, in the JSON", style="dim")) if rest > 0 else table


def _quantities(critique: Critique) -> RenderableType:
    table = grid("The body", "quantity", "base", "extended", "shift")
    base, extended = critique.baseline.quantities, critique.extended.quantities
    for name in dict.fromkeys([*base, *extended]):
        unit = UNITS.get(name, "")
        for (label, old, u_old), (_, new, u_new) in _pairs(base.get(name), extended.get(name)):
            figures = with_u(old, u_old, unit), with_u(new, u_new, unit), _shift(old, new, u_old, unit)
            table.add_row(f"{name} {label}".rstrip(), *figures)
    return table


Element = tuple[str, "float | None", "float | None"]


def _pairs(base: Quantity | None, extended: Quantity | None) -> list[tuple[Element, Element]]:
    """Elements of both, label, value and uncertainty; those of one alone face none."""
    both = zip_longest(_scalars(base), _scalars(extended))
    return [(old or (new[0], None, None), new or (old[0], None, None)) for old, new in both]


def _scalars(quantity: Quantity | None) -> list[Element]:
    if quantity is None:
        return []
    return elements(quantity) if isinstance(quantity.value, tuple) else [("", quantity.value, quantity.u)]


def _shift(old: float | None, new: float | None, u: float | None, unit: str) -> str:
    if old is None or new is None:
        return "–"
    shift = f"{new - old:+.{decimals_for(u)}f}" if u else f"{new - old:+.3g}"
    return f"{shift} {unit}".rstrip()


def _gain(critique: Critique) -> RenderableType:
    table = grid("Residual over noise", "simulation", "samples fitted", "samples held out")
    rows: list[tuple[str, ModelResult]] = [("base", critique.baseline), ("extended", critique.extended)]
    for name, model in rows:
        table.add_row(name, short(model.rms_over_noise), short(model.heldout_rms_over_noise))
    gain = critique.gain
    said = [
        Text(f"  {text} {short(value)}")
        for text, value in (
            ("held-out residual, base over extended:", gain.heldout_rms_ratio),
            ("gain of the log density of each held-out sample:", gain.log_score_per_sample),
        )
        if value is not None and critique.verdict.status != "adequate"
    ]
    return Group(table, *said)


def _next_swing(following: NextSwing) -> RenderableType:
    table = grid("The next swing", "what", "set to")
    table.add_row("same suspension as swing", following.like)
    table.add_row("length of the lines", f"{short(following.line_length_m, 4)} m")
    table.add_row("spacing of the lines", f"{short(following.spacing_m, 4)} m")
    table.add_row("bow-up angle", f"{short(following.hull_pitch_deg)} °")
    table.add_row("set going", ", ".join(following.excited))
    table.add_row("angle of the release", f"{short(following.amplitude_deg)} °")
    table.add_row("length of the recording", f"{short(following.duration_s)} s")
    table.add_row("causes then differ by", f"{short(following.sigma)} sigma")
    return Group(table, Text(f"  {following.text}"))


def _learned(force: LearnedForce) -> RenderableType:
    table = grid("The force that no known cause gives", "of", "residual over noise of the samples held out")
    table.add_row(f"the learned force ({spaced(force.coordinate)})", short(force.heldout_rms_over_noise))
    table.add_row("the equation", short(force.closed_heldout_rms_over_noise))
    equation = f"  {force.equation}  [{unit_text(force.unit)}]" if force.equation else ""
    return Group(table, Text(f"  {force.text}"), Text(equation, style="bold"))
