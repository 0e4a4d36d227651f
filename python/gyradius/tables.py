"""A measurement as tables on a terminal."""

from __future__ import annotations

from typing import Any

from rich import box
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from .labels import UNITS, label
from .measurement import Claim, Measurement, ModeResult, OneMotion, PeriodTrend, Quantity, SwingResult
from .numbers import interval, short, with_u
from .summary import VERDICTS, notes, sentence, show_findings, show_result

# Lines of a budget that get a row; the rest is in the JSON and the report.
BUDGET_ROWS = 5
# Columns that hold words wherever they stand.
WORDS = ("method", "from")
# Contradictions written out in words; one wrong dimension contradicts many estimators at once.
FLAGGED_SENTENCES = 5


def show(console: Console, measurement: Measurement) -> None:
    """Print everything, the result first."""
    show_result(console, measurement)
    show_findings(console, measurement)
    console.print()
    for part in _parts(measurement):
        console.print(part)
        console.print()
    for finding in notes(measurement):
        console.print(Text(f"note: {sentence(finding)}", style="dim"))


def _parts(measurement: Measurement) -> list[RenderableType]:
    parts: list[RenderableType] = [_swings(measurement.swings)]
    if any(isinstance(quantity.value, tuple) for quantity in measurement.quantities.values()):
        parts.append(_tensors(measurement))
    if measurement.alternatives:
        parts.append(_alternatives(measurement))
    if measurement.budget:
        parts.append(_budget(measurement))
    if measurement.consistency:
        parts.append(_consistency(measurement))
    if measurement.verdicts:
        parts.append(_verdicts(measurement))
    return parts


def grid(title: str, *columns: str, left: int = 1, words: tuple[str, ...] = WORDS) -> Table:
    """An empty table; the first columns and those with words are left-aligned."""
    table = Table(
        title=title, title_justify="left", title_style="bold", header_style="dim", box=box.SIMPLE_HEAD, pad_edge=False
    )
    for position, column in enumerate(columns):
        # Names may break; a number and its uncertainty stay on one line.
        is_name = position < left or column in words
        table.add_column(column, justify="left" if is_name else "right", no_wrap=not is_name, overflow="fold")
    return table


def _swings(swings: tuple[SwingResult, ...]) -> RenderableType:
    table = grid("Swings", "swing", "mode", "period, s", "decay time, s", "amplitude", "dB", left=2)
    for swing in swings:
        for place, mode in enumerate(swing.modes):
            table.add_row("" if place else swing.id, *_mode_cells(mode), style="dim" if mode.parasitic else "")
        table.add_section()
    notes = [Text(f"  {swing.id}: {repair.text}", style="dim") for swing in swings for repair in swing.repairs]
    notes += [Text(f"  {swing.id}: {_trend(swing.trend)}", style="dim") for swing in swings if swing.trend]
    notes += [Text(f"  {swing.id}: {_motion(swing.motion)}", style="dim") for swing in swings if swing.motion]
    return Group(table, *notes, *(warning_line(f"{swing.id}: {text}") for swing in swings for text in swing.warnings))


def _trend(trend: PeriodTrend) -> str:
    """Eq. (14) of a list of periods, in one line."""
    text = f"periods by (14): T₀ = {with_u(trend.t0_s, trend.t0_se_s, 's')}"
    if trend.b_per_s:
        text += f", b = {with_u(trend.b_per_s, trend.b_se_per_s, '1/s')}"
    if (wave := trend.modulation) is not None:
        text += f", C = {with_u(wave.c_s, wave.c_se_s, 's')}, T_m = {with_u(wave.t_m_s, wave.t_m_se_s, 's')}"
        if wave.tau_m_s is not None:
            text += f", τ_m = {short(wave.tau_m_s)} s"
    return text


def _motion(motion: OneMotion) -> str:
    """Restoring law and damping of a body that turns about one axis, in one line."""
    parts = (
        ("restoring law κ", motion.hardness, motion.hardness_se, ""),
        ("damping α", motion.damping_per_s, motion.damping_per_s_se, "1/s"),
        ("drag b", motion.drag_per_rad, motion.drag_per_rad_se, "1/rad"),
        ("dry friction c", motion.friction_rad_s2, motion.friction_rad_s2_se, "rad/s²"),
    )
    told = (f"{name} = {with_u(value, se, unit)}" for name, value, se, unit in parts if se is not None)
    return "one motion: " + ", ".join(told)


def _mode_cells(mode: ModeResult) -> tuple[str, ...]:
    amplitude = "–" if mode.amplitude is None else f"{short(mode.amplitude)} {mode.amplitude_unit}"
    remark = " (doubtful)" if mode.doubtful else " (parasitic)" if mode.parasitic else ""
    return (
        spaced(mode.mode) + remark,
        with_u(mode.period_s, mode.period_se_s),
        with_u(mode.decay_time_s, mode.decay_time_se_s),
        amplitude,
        # Adding zero turns -0 into 0.
        f"{round(mode.relative_db) + 0}",
    )


def _tensors(measurement: Measurement) -> Table:
    table = grid("Inertia about the centre of mass, hull axes", "quantity", "element", "value ± u", left=2)
    for name, quantity in measurement.quantities.items():
        if isinstance(quantity.value, tuple):
            for place, (element, value, u) in enumerate(elements(quantity)):
                table.add_row("" if place else label(name), element, with_u(value, u, UNITS.get(name, "")))
            table.add_section()
    return table


def elements(quantity: Quantity) -> list[tuple[str, Any, Any]]:
    """Label, value and uncertainty: a vector by axis, a symmetric matrix by its six elements, zeros left out."""
    axes = "xyz"
    if not isinstance(quantity.value[0], tuple):
        return list(zip(axes, quantity.value, quantity.u, strict=True))
    places = [(i, j) for i in range(3) for j in range(i, 3)]
    found = [(axes[i] + axes[j], quantity.value[i][j], quantity.u[i][j]) for i, j in places]
    return [element for element in found if element[1]]


def _alternatives(measurement: Measurement) -> Table:
    table = grid("Closed-form estimates", "estimator", "equation", "from", "value", left=3)
    table.columns[0].no_wrap = True
    for name, estimates in measurement.alternatives.items():
        table.add_row(_heading(name))
        for estimate in estimates:
            value = with_u(estimate.value, estimate.u, UNITS.get(name, ""))
            if name == "psi_deg":
                # Never without its interval: a millimetre in a gyradius changes it by tenths of a degree.
                value += f" ({interval(estimate.interval_95, estimate.u)})"
            method = spaced(estimate.method)
            table.add_row(f"  {method}", estimate.equation, ", ".join(estimate.sources), value)
    return table


def _budget(measurement: Measurement) -> Table:
    table = grid("Uncertainty budget", "input", "contribution", left=1)
    for name, lines in measurement.budget.items():
        table.add_row(_heading(name))
        for line in lines[:BUDGET_ROWS]:
            table.add_row(f"  {spaced(line.input)}", f"{line.u_contribution:.2g} {UNITS.get(name, '')}")
    return table


def _heading(name: str) -> Text:
    """A heading row: the quantity of the rows below."""
    return Text(label(name), style="bold")


def _consistency(measurement: Measurement) -> RenderableType:
    table = grid("Consistency tests", "tested", "stated", "implied", "sigma", "from")
    for claim in measurement.consistency:
        table.add_row(*_claim_cells(claim), style="bold red" if claim.flagged else "")
    flagged = [claim for claim in measurement.consistency if claim.flagged]
    said = [Text(f"  ! {claim.text}", style="red") for claim in flagged[:FLAGGED_SENTENCES]]
    rest = len(flagged) - len(said)
    more = [Text(f"  ! {rest} more contradictions are marked in red above", style="red")] if rest else []
    return Group(table, *said, *more)


def _claim_cells(claim: Claim) -> tuple[str, ...]:
    stated = with_u(claim.stated, claim.stated_u)
    low, high = claim.sigma_range or (claim.sigma, claim.sigma)
    sigma = f"{high:.1f}" if claim.pairs == 1 else f"{low:.1f} … {high:.1f}"
    return label(claim.claim), stated, with_u(claim.implied, claim.implied_u), sigma, claim.source


def _verdicts(measurement: Measurement) -> Table:
    table = grid("Class limits", "quantity", "limit", "guard band", "probability", "verdict")
    for verdict in measurement.verdicts:
        limit = f"{verdict.relation} {verdict.limit:g}"
        band, probability = f"{verdict.guard_band:.2g}", f"{verdict.conformance_probability:.4f}"
        colour = VERDICTS.get(verdict.verdict, "yellow")
        table.add_row(label(verdict.quantity), limit, band, probability, Text(verdict.verdict, style=colour))
    return table


def spaced(key: str) -> str:
    """A key of the format as words; the name of a quantity is kept, because its unit is part of it."""
    return key if key in UNITS else key.replace("_", " ")


def warning_line(text: str) -> Text:
    """A warning as a line of text."""
    return Text(f"  warning: {text}", style="yellow")
