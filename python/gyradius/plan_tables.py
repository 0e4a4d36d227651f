"""A plan as text and tables on a terminal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rich.console import Console, RenderableType
from rich.text import Text

from .measurement import BudgetLine
from .numbers import decimals_for, short, with_u
from .planning import HangingAdvice, Plan, PlannedIncline, PlannedSwing, PlanWarning, PredictedQuantity, PredictedSwing
from .tables import grid, spaced, warning_line

# Inputs of a budget that are worth a word.
BUDGET_INPUTS = 3
UNITS = {"psi_deg": "°"}
MODES = ("yaw", "sway", "pitch_in_phase", "pitch_out_of_phase", "roll_in_phase", "roll_out_of_phase")


def show_plan(console: Console, plan: Plan) -> None:
    """Print what to hang where, what to swing, what to expect, and what to beware of."""
    console.rule(Text(plan.title or "plan", style="bold"))
    for part in _parts(plan):
        console.print(part)
        console.print()
    for warning in plan.warnings:
        console.print(_warning(warning))


def _parts(plan: Plan) -> list[RenderableType]:
    parts: list[RenderableType] = [_hull(plan.hull), _hangings(plan.suspensions), _swings(plan)]
    inclines = [step for step in plan.steps if isinstance(step, PlannedIncline)]
    parts.extend(_incline(step) for step in inclines)
    if plan.tells_apart is not None:
        parts.append(Text(f"Why: {plan.tells_apart.text}"))
    if plan.quantities:
        parts.append(_quantities(plan))
    parts.append(_optima(plan))
    parts.append(Text(f"Takes about {plan.effort_s / 60.0:.0f} minutes, rigging included.", style="dim"))
    return parts


def _hull(hull: Mapping[str, Any]) -> RenderableType:
    size = f"{hull['mass_kg']:.4g} kg, {hull['length_m']:.3g} m by {hull['beam_m']:.3g} m"
    table = grid(f"The hull as it is assumed: {size}", "", "value", "from", words=("from",))
    for name in ("k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m"):
        table.add_row(_name(name), with_u(hull[name]["value"], hull[name]["u"], "m"), hull["sources"].get(name, ""))
    return table


def _hangings(hangings: tuple[HangingAdvice, ...]) -> RenderableType:
    table = grid("How to hang it (points of the square frame, Table 4 of the paper)", "points", "how", words=("how",))
    for hanging in hangings:
        table.add_row(hanging.frame_points, hanging.text)
    return table


def _swings(plan: Plan) -> RenderableType:
    shown = {swing.id: swing for swing in plan.predicted}
    hung = {swing: hanging for hanging in plan.suspensions for swing in hanging.swings}
    columns = ("swing", "points", "lines", "set going", "release", "record", "expect", "beat")
    table = grid("Swings", *columns, words=("set going", "expect", "beat"))
    for step in plan.steps:
        if isinstance(step, PlannedSwing):
            length = step.suspension["line_length_m"]["value"]
            table.add_row(
                step.id,
                hung[step.id].frame_points,
                f"{length:.3f} m",
                ", ".join(step.excited),
                f"{step.amplitude_deg:.3g}°",
                f"{step.duration_s:.0f} s",
                _periods(step, shown.get(step.id)),
                _beat(shown.get(step.id)),
            )
    return table


def _periods(step: PlannedSwing, shown: PredictedSwing | None) -> str:
    longer = shown.longer_at_release_ppm if shown else {}

    def line(mode: str) -> str:
        at_release = f" (+{longer[mode]:.0f} ppm at release)" if mode in longer else ""
        return f"{spaced(mode)} {step.periods_s[mode]:.3f} s{at_release}"

    return "\n".join(line(mode) for mode in MODES if mode in step.periods_s)


def _beat(shown: PredictedSwing | None) -> str:
    if shown is None or shown.beat is None:
        return "–"
    if shown.beat.period_s is None or shown.beat.oscillations is None:
        return "none"
    return f"{shown.beat.period_s:.1f} s\n(n = {shown.beat.oscillations:.1f})"


def _incline(step: PlannedIncline) -> Text:
    return Text(
        f"Incline: hang {step.mass_kg:.3g} kg from the {step.end}, {step.arm_m:.2f} m from the suspension points, "
        f"{step.depth_m:.2f} m below them; about {step.pitch_deg:.1f}°."
    )


def _quantities(plan: Plan) -> RenderableType:
    table = grid("What is expected", "quantity", "u", "wanted", "", "comes from", words=("comes from",))
    for name, quantity in plan.quantities.items():
        mark = {True: "reached", False: "not reached", None: ""}[quantity.is_reached]
        style = "bold yellow" if quantity.is_reached is False else ""
        said = _budget(plan.budget.get(name, ()), quantity)
        table.add_row(
            _name(name), _u(name, quantity.u, quantity), _u(name, quantity.wanted_u, quantity), mark, said, style=style
        )
    return table


def _u(name: str, u: float | None, quantity: PredictedQuantity) -> str:
    if u is None:
        return "–"
    if name in UNITS:
        return f"{u:.2g} {UNITS[name]}"
    return f"{1e3 * u:.{decimals_for(1e3 * u)}f} mm ({100.0 * u / quantity.value:.2g} %)"


def _budget(lines: tuple[BudgetLine, ...], quantity: PredictedQuantity) -> str:
    if not lines or not quantity.u:
        return ""
    whole = sum(line.u_contribution**2 for line in lines)
    shares = [f"{spaced(line.input)} {100.0 * line.u_contribution**2 / whole:.0f} %" for line in lines[:BUDGET_INPUTS]]
    return ", ".join(shares)


def _optima(plan: Plan) -> Text:
    best = plan.optima
    said = [
        f"lines of {short(best['line_length_joint_m'])} m for the pitch gyradius with the depth solved for too "
        f"({short(best['line_length_depth_known_m'])} m were the depth known: the paper's Fig. 17)",
        f"a spacing near {short(best['spacing_m'])} m, twice the yaw gyradius",
        f"as a compound pendulum an axis {short(best['compound_pitch_axis_to_cm_m'])} m above the centre of mass in "
        f"pitch and {short(best['compound_roll_axis_to_cm_m'])} m in roll",
    ]
    return Text("Best, were there room for it: " + "; ".join(said) + ".")


def _warning(warning: PlanWarning) -> Text:
    return warning_line(warning.text)


def _name(name: str) -> str:
    return spaced({"cm_depth_m": "depth"}.get(name, name.rsplit("_", 1)[0]))
