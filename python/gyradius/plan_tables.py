"""A plan as text and tables on a terminal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rich.console import Console, Group, RenderableType
from rich.text import Text

from .measurement import BudgetLine
from .numbers import decimals_for, short, with_u
from .planning import (
    Beat,
    HangingAdvice,
    Plan,
    PlannedIncline,
    PlannedSwing,
    PlanWarning,
    PredictedQuantity,
    PredictedSwing,
)
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
    table = grid("The hull as assumed", size, "value", left=1)
    by_source: dict[str, list[str]] = {}
    for name in ("k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m"):
        table.add_row(_name(name), with_u(hull[name]["value"], hull[name]["u"], "m"))
        by_source.setdefault(hull["sources"].get(name, ""), []).append(_name(name))
    said = [Text(f"  {', '.join(names)}: {source}", style="dim") for source, names in by_source.items() if source]
    return Group(table, *said)


def _hangings(hangings: tuple[HangingAdvice, ...]) -> RenderableType:
    table = grid("How to hang it (points of the square frame, Table 4 of the paper)", "points", "how", words=("how",))
    for hanging in hangings:
        table.add_row(hanging.frame_points, hanging.text)
    return table


def _swings(plan: Plan) -> RenderableType:
    hung = {swing: hanging for hanging in plan.suspensions for swing in hanging.swings}
    table = grid("Swings", "swing", "on", "excited", "release", "record", "periods at small amplitude", left=3)
    for step in plan.steps:
        if isinstance(step, PlannedSwing):
            periods = [mode for mode in MODES if mode in step.periods_s]
            table.add_row(
                step.id,
                hung[step.id].frame_points,
                "\n".join(step.excited),
                f"{step.amplitude_deg:.3g}°",
                f"{step.duration_s:.0f} s",
                "\n".join(f"{spaced(mode)} {step.periods_s[mode]:.3f} s" for mode in periods),
            )
            table.add_section()
    return Group(table, *(Text(f"  {swing.id}: {said}") for swing in plan.predicted if (said := _shown(swing))))


def _shown(swing: PredictedSwing) -> str:
    longer = [f"{spaced(mode)} takes {ppm:.0f} ppm longer" for mode, ppm in swing.longer_at_release_ppm.items()]
    said = [_beat(swing.beat)] if swing.beat is not None else []
    if longer:
        said.append(f"just released, {', '.join(longer)}")
    return "; ".join(said)


def _beat(beat: Beat) -> str:
    if beat.period_s is None or beat.oscillations is None:
        return "yaw and sway stay in step and do not beat"
    return f"yaw and sway beat every {beat.period_s:.1f} s, {beat.oscillations:.1f} oscillations per beat"


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
        f"({short(best['line_length_depth_known_m'])} m if the depth were known: the paper's Fig. 17)",
        f"a spacing near {short(best['spacing_m'])} m, twice the yaw gyradius",
        f"as a compound pendulum an axis {short(best['compound_pitch_axis_to_cm_m'])} m above the centre of mass in "
        f"pitch and {short(best['compound_roll_axis_to_cm_m'])} m in roll",
    ]
    return Text("Best, if there were room for it: " + "; ".join(said) + ".")


def _warning(warning: PlanWarning) -> Text:
    return warning_line(warning.text)


def _name(name: str) -> str:
    return spaced({"cm_depth_m": "depth"}.get(name, name.rsplit("_", 1)[0]))
