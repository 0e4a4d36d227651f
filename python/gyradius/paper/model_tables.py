"""Table 3 and the first Table 4: the model hull, and what each suspension shows."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..arrays import decompose, evaluate_route
from ..simulation import simulate
from .checks import Check, Inputs, by_function, by_route, compared, returned
from .double_pendulum import double_pendulum
from .ellipsoids import tilt_inputs, tilted
from .parts import PaperTable, Words
from .print_data import printed
from .rigs import bifilar, keelboat, keelboat_lines, model, model_lines, rig, simulated_swing

ROWS = range(1, 8)
ROLL_ROW = 7
LEVEL = (1, 2, 3, 4, 7)
YAW_DEG, SWAY_M, SURGE_M = 1.0, 0.01, 0.01
RECORD_S = 60.0
# Below this fraction of the largest derivative by a moment of inertia the readings do not depend on it.
LEAST_FRACTION = 0.01
# Chosen: how far a frame on one side lets the hull turn, and the height of the axis.
TURN_DEG, AXIS_HEIGHT_M = 30.0, 0.5
#: Suspension points of the square frame: what the print says that they give.
OPTIONS = {
    "B-F": "k_yaw, k_pitch, l2",
    "H-D": "k_yaw, k_roll, l2",
    "A-G": "k_yaw tilted in pitch, k_pitch, l2",
    "C-E": "k_yaw tilted in pitch, k_pitch, l2",
    "A-C": "k_yaw tilted in roll, k_roll, l2",
    "G-E": "k_yaw tilted in roll, k_roll, l2",
    "A-C+G-E": "k_pitch",
    "A-G+C-E": "k_roll",
}


def table_3() -> PaperTable:
    """The model hull in seven suspensions."""
    checks: list[Check] = [_other_tilt(5, 6), _other_tilt(6, 5), _roll("table3.7.k_roll"), _roll("compound.k_roll")]
    for row in ROWS:
        checks += _round_trip(row)
    return PaperTable(
        "Table 3",
        "Model hull",
        "The periods behind this table are not printed. What can be recomputed: each tilted yaw gyradius from the "
        "other one, and the roll gyradius from three yaw gyradii by (25). The rest are round trips: the hull of "
        "each row is simulated on its lines, the phone's readings are decomposed, and (8), (17), (18) must return "
        "the row.",
        tuple(checks),
        "The angles ψ that the text draws from this table stand with Fig. 20.",
        ("psi-sign", "fig15-parameters"),
    )


def _other_tilt(row: int, other: int) -> Check:
    """A tilted yaw gyradius from the level, the roll and the other tilted one, by (4) and (3)."""
    pitch = printed(f"table3.{row}.pitch")
    found = by_function(
        lambda given: tilted(evaluate_route("principal_from_one_tilt", given), pitch.value),
        tilt_inputs(other),
        "(4), (3)",
    )
    tilt = pitch.text.replace("-", "−")
    return compared(f"row {row}: k_y tilted by {tilt}°, from row {other}", f"table3.{row}.k_yaw", found)


def _roll(id_: str) -> Check:
    inputs: Inputs = {
        "k_yaw_m": printed("table3.7.k_yaw"),
        "k_a_m": printed("table3.5.k_yaw"),
        "pitch_a_rad": printed("table3.5.pitch"),
        "k_b_m": printed("table3.6.k_yaw"),
        "pitch_b_rad": printed("table3.6.pitch"),
    }
    name = "k_r of the fore-and-aft row" if id_.startswith("table3") else "k_r of the compound pendulum"
    return compared(f"{name}, from the tilts", id_, by_route("roll_from_tilts", "k_roll_m", inputs, "(25)"))


def _round_trip(row: int) -> list[Check]:
    """Simulate a row, decompose, and evaluate (8), (17) and (18)."""
    pendulum = double_pendulum(model(row), model_lines(row))
    gyradius = "k_roll" if row == ROLL_ROW else "k_pitch"
    found = [("k_y", "k_yaw", _yaw_m(row), "(8)")] if row in LEVEL else []
    found += [
        ("k_r" if row == ROLL_ROW else "k_p", gyradius, pendulum["gyradius_m"], "(18)"),
        ("l2", "depth", pendulum["cm_depth_m"], "(17)"),
    ]
    return [returned(f"row {row}: {name}", f"table3.{row}.{id_}", value, how) for name, id_, value, how in found]


def _yaw_m(row: int) -> float:
    """The yaw gyradius by the ratio of the two periods, each from a swing of its own."""
    hull, lines = model(row), model_lines(row)
    across = "surge_m" if row == ROLL_ROW else "sway_m"
    yaw = simulated_swing(hull, lines, {"yaw_deg": YAW_DEG, "duration_s": RECORD_S})
    # In the plane of the lines the hull only moves: the accelerometer along it.
    moved = simulated_swing(hull, lines, {across: SWAY_M, "duration_s": RECORD_S})
    along = moved.acc_m_s2[:, 0 if row == ROLL_ROW else 1]
    periods = {
        "yaw_period_s": decompose(yaw.t_s, [yaw.gyro_rad_s[:, 2]]).modes[0].period_s,
        "sway_period_s": decompose(moved.t_s, [along]).modes[0].period_s,
    }
    return evaluate_route("ratio_gyradius", {**periods, "half_spacing_m": lines.half_spacing_m})["gyradius_m"]


def table_4_options() -> PaperTable:
    """What each pair of the frame's points shows."""
    words = tuple(Words(name, printed_words, _shown(name)) for name, printed_words in OPTIONS.items())
    return PaperTable(
        "Table 4 (first)",
        "Suspension options of the square frame",
        "Printed: the gyradii that each pair of points gives. Found: what the readings of the simulated keelboat "
        "depend on, from their derivatives by its moments of inertia and by its depth.",
        (),
        f"The hull hangs tilted by {TURN_DEG:.0f}° where both points are at one end or on one side. A compound "
        "pendulum depends on l2 too, which the print takes as known from the other suspensions.",
        ("table-number",),
        words,
    )


def _suspension(name: str) -> dict[str, Any]:
    """The keys of a suspension from the frame's points."""
    lines = bifilar(keelboat_lines())
    along = {"orientation": "fore_and_aft"}
    compound = {"kind": "compound", "axis_height": AXIS_HEIGHT_M}
    return {
        "B-F": lines,
        "H-D": {**lines, **along},
        "A-G": {**lines, "hull_pitch_deg": TURN_DEG},
        "C-E": {**lines, "hull_pitch_deg": -TURN_DEG},
        "A-C": {**lines, **along, "hull_roll_deg": TURN_DEG},
        "G-E": {**lines, **along, "hull_roll_deg": -TURN_DEG},
        "A-C+G-E": {**compound, "orientation": "athwartships"},
        "A-G+C-E": {**compound, **along},
    }[name]


def _shown(name: str) -> str:
    """The names of what the readings depend on."""
    keys = _suspension(name)
    turn = "pitch_deg" if keys["orientation"] == "athwartships" else "roll_deg"
    start = {turn: YAW_DEG} | ({} if keys["kind"] == "compound" else {"yaw_deg": YAW_DEG})
    by = ("inertia_zz_kg_m2", "inertia_yy_kg_m2", "inertia_xx_kg_m2")
    swing = simulate(rig(keelboat(), keys, start), derivatives=[*by, "cm_z_m"])
    sizes = np.abs(swing.derivatives).max((0, 1))
    found = [axis for axis, size in zip(by, sizes, strict=False) if size > LEAST_FRACTION * sizes[:3].max()]
    tilt = " tilted in pitch" if "hull_pitch_deg" in keys else " tilted in roll" if "hull_roll_deg" in keys else ""
    names = {by[0]: f"k_yaw{tilt}", by[1]: "k_pitch", by[2]: "k_roll"}
    return ", ".join([names[axis] for axis in found] + (["l2"] if sizes[3] > 0.0 else []))
