"""Tables 1 and 2, and the second Table 4: the keelboat."""

from __future__ import annotations

import math
from collections.abc import Callable

from ..arrays import evaluate_route
from .checks import GRAVITY_M_S2, Check, Computed, Inputs, by_function, by_route, compared
from .parts import PaperTable
from .print_data import Printed, printed

TABLE_1_ROWS = range(1, 8)
TABLE_2_COLUMNS = (1, 4)


def yaw_gyradius(period: Printed) -> Computed:
    """The keelboat's yaw gyradius from one period on the printed lines."""
    inputs: Inputs = {
        "yaw_period_s": period,
        "line_length_m": printed("keelboat.line_length"),
        "half_spacing_m": printed("keelboat.half_spacing"),
        "gravity_m_s2": GRAVITY_M_S2,
    }
    return by_route("yaw_gyradius", "gyradius_m", inputs, "(6)")


def table_1() -> PaperTable:
    """Yaw gyradii from the photogate's periods."""
    checks = []
    for row in TABLE_1_ROWS:
        added, period = printed(f"table1.{row}.added"), printed(f"table1.{row}.period")
        label = f"k_y, T = {period.text} s, {added.text} kg added"
        checks.append(compared(label, f"table1.{row}.gyradius", yaw_gyradius(period)))
    gravity = GRAVITY_M_S2 * (printed("table1.1.gyradius").value / checks[0].computed.value) ** 2
    return PaperTable(
        "Table 1",
        "Photogate yaw periods of the keelboat",
        "The gyradius by (6) from each printed period, l = 3.477 ± 0.006 m, d = 0.900 m and standard gravity.",
        tuple(checks),
        "Every gyradius comes out lower than printed by the same factor (within the rounding of the periods), 0.3 "
        f"mm in the first row. The site's gravity is not printed; {gravity:.3f} m/s², that of a latitude near 52°, "
        "gives the printed figure, and so does a line shorter by 2 mm.",
    )


def table_2() -> PaperTable:
    """Yaw gyradii from the rangefinder's periods, by the ratio and by the yaw period."""
    checks: list[Check] = []
    lengths = []
    for column in TABLE_2_COLUMNS:
        yaw, sway = printed(f"table2.{column}.yaw_period"), printed(f"table2.{column}.sway_period")
        periods: Inputs = {"yaw_period_s": yaw, "sway_period_s": sway}
        by_ratio: Inputs = {**periods, "half_spacing_m": printed("keelboat.half_spacing")}
        found = (
            (
                "T_y / T_s",
                "ratio",
                by_function(lambda given: given["yaw_period_s"] / given["sway_period_s"], periods, "(8)"),
            ),
            ("k_y by the ratio", "k_ratio", by_route("ratio_gyradius", "gyradius_m", by_ratio, "(8)")),
            ("k_y by the yaw period", "k_period", yaw_gyradius(yaw)),
        )
        checks += [compared(f"UMS {column}: {name}", f"table2.{column}.{id_}", one) for name, id_, one in found]
        inputs = {"sway_period_s": sway.value, "gravity_m_s2": GRAVITY_M_S2}
        lengths.append(evaluate_route("line_length_from_sway", inputs)["line_length_m"])
    return PaperTable(
        "Table 2",
        "Ultrasonic yaw data of the keelboat",
        "From the printed periods, d = 0.900 m, and for the last row of each column l = 3.477 m.",
        tuple(checks),
        f"The sway periods need lines of {lengths[0]:.3f} m and {lengths[1]:.3f} m by (7), not of 3.477 ± 0.006 m: "
        "this is why the two gyradii of a column differ by 17 mm and 22 mm.",
        ("line-length",),
    )


def table_4_keel() -> PaperTable:
    """Hull and keel of the keelboat."""
    return PaperTable(
        "Table 4 (second)",
        "Hull and keel of the keelboat",
        "Mass and centre of mass of both as one body; gyradii of the hull from those of the whole and of the keel "
        "by parallel axes; then the moments of inertia of the text.",
        (*_masses(), *_hull_gyradii(), *_moments(), *_offsets()),
        errata=("table-number", "line-of-centres"),
    )


def _of(part: str, name: str) -> Printed:
    return printed(f"table4.{part}.{name}")


def _masses() -> list[Check]:
    """Both as one body: mass and centre of mass."""
    inputs: Inputs = {
        f"{name}_{number}": _of(part, name)
        for number, part in ((1, "hull"), (2, "keel"))
        for name in ("mass", "x", "z")
    }
    outputs = (("mass", "mass_kg"), ("x", "x_m"), ("z", "z_m"))
    return [
        compared(f"hull and keel: {name}", f"table4.both.{name}", by_function(_joined(output), inputs, "parallel axes"))
        for name, output in outputs
    ]


def _joined(output: str) -> Callable[[dict[str, float]], float]:
    """One number of two points that are joined."""

    def joined(given: dict[str, float]) -> float:
        inputs = {
            f"{axes}_{number}_kg_m2": 0.0 for number in (1, 2) for axes in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
        }
        for number in (1, 2):
            place = {"x": given[f"x_{number}"], "y": 0.0, "z": given[f"z_{number}"]}
            inputs |= {f"{axis}_{number}_m": value for axis, value in place.items()}
            inputs[f"mass_{number}_kg"] = given[f"mass_{number}"]
        return evaluate_route("body_joined", inputs)[output]

    return joined


def _distance(axis: str, given: dict[str, float]) -> float:
    """Between the two centres of mass, across the axis of pitch or of yaw, m."""
    return math.hypot(given["x"], given["z"]) if axis == "pitch" else given["x"]


def _hull_gyradii() -> list[Check]:
    checks = []
    for axis in ("pitch", "yaw"):
        inputs: Inputs = {
            "mass": _of("both", "mass"),
            "k": _of("both", f"k_{axis}"),
            "keel_mass": _of("keel", "mass"),
            "keel_k": _of("keel", f"k_{axis}"),
            "x": printed("table4.offset_x"),
            "z": printed("table4.offset_z"),
        }

        def hull(given: dict[str, float], axis: str = axis) -> float:
            keel = {"mass_2_kg": given["keel_mass"], "gyradius_2_m": given["keel_k"]}
            whole = {"mass_1_kg": given["mass"], "gyradius_1_m": given["k"], "distance_m": _distance(axis, given)}
            return evaluate_route("rest_gyradius", {**whole, **keel})["gyradius_m"]

        found = by_function(hull, inputs, "parallel axes")
        checks.append(compared(f"hull: {axis} gyradius", f"table4.hull.k_{axis}", found))
    return checks


def _moments() -> list[Check]:
    names = {"both": "hull and keel", "hull": "hull", "keel": "keel"}
    checks = []
    for part, name in names.items():
        for axis in ("pitch", "yaw"):
            inputs: Inputs = {"mass_kg": _of(part, "mass"), "gyradius_m": _of(part, f"k_{axis}")}
            found = by_route("moment", "moment_kg_m2", inputs, "(1)")
            checks.append(compared(f"{name}: moment in {axis}", f"table4.{part}.i_{axis}", found))
    return checks


def _offsets() -> list[Check]:
    """What lies between the two centres of mass, and what it adds."""
    checks = []
    for axis in ("x", "z"):
        ends: Inputs = {"hull": _of("hull", axis), "keel": _of("keel", axis)}
        apart = by_function(lambda given: abs(given["keel"] - given["hull"]), ends, "difference")
        checks.append(compared(f"offset of the centres of mass, {axis}", f"table4.offset_{axis}", apart))
    offsets: Inputs = {"x": printed("table4.offset_x"), "z": printed("table4.offset_z")}
    masses: Inputs = {"mass_1_kg": _of("hull", "mass"), "mass_2_kg": _of("keel", "mass")}
    for axis in ("pitch", "yaw"):

        def added(given: dict[str, float], axis: str = axis) -> float:
            pair = {name: given[name] for name in masses}
            return evaluate_route("offset_moment", {**pair, "distance_m": _distance(axis, given)})["moment_kg_m2"]

        found = by_function(added, {**masses, **offsets}, "parallel axes")
        checks.append(compared(f"offset: moment in {axis}", f"table4.offset_i_{axis}", found))
        both: Inputs = {part: _of(part, f"i_{axis}") for part in ("both", "hull")}
        extra = by_function(lambda given: given["both"] - given["hull"], both, "difference")
        checks.append(compared(f"added by the keel in {axis}", f"table4.keel_extra_{axis}", extra))
    angle = by_function(lambda given: math.atan2(given["x"], given["z"]), offsets, "line of the centres")
    checks.append(compared("angle of the line between the centres", "table4.line_angle", angle))
    return checks
