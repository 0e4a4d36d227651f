"""Figs. 1, 20 and 22: ellipsoids of inertia, and gyradii about tilted axes."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Ellipse

from ..arrays import evaluate_route
from .checks import Check, Computed, Inputs, by_function, by_route, compared
from .drawing import PRINTED_STYLE, label, panels
from .parts import PaperFigure
from .print_data import DEGREE, Printed, printed

#: Assumed for the gyradii of Table 3, which the print gives to 1 mm and without uncertainty.
U_TABLE_3_M = 1e-3


def figure_1() -> PaperFigure:
    """The equivalent ellipsoid and the inertia ellipsoid."""
    as_printed: Inputs = {f"{name}_m": printed(f"fig1.{name}") for name in ("k_px", "k_py", "k_pz")}
    corrected: Inputs = {**as_printed, "k_py_m": printed("table4.both.k_pitch"), "k_pz_m": printed("table4.both.k_yaw")}
    figure, (solid, inertia) = panels(columns=2, height=3.8)
    for inputs, style, name in ((as_printed, "--", "labels as printed"), (corrected, "-", "pitch and yaw corrected")):
        values = {key: _value(number) for key, number in inputs.items()}
        axes = evaluate_route("equivalent_ellipsoid", values)
        _section(solid, axes["a_m"], axes["c_m"], style, f"{name}: b = {axes['b_m']:.2f} m, c = {axes['c_m']:.2f} m")
        axes = evaluate_route("inertia_ellipsoid", {"mass_kg": 1.0, **values})
        _section(inertia, axes["a"], axes["c"], style, name)
    _framed(solid, 2.7, 2.7, "x, m", "z, m", "a  mass-equivalent ellipsoid, section y = 0")
    _framed(inertia, 1.9, 1.9, "x intercept, 1/m", "z intercept, 1/m", "b  inertia ellipsoid, section y = 0")
    checks = [
        compared(
            f"semi-axis {axis}", f"fig1.{axis}", by_route("equivalent_ellipsoid", f"{axis}_m", as_printed, "Fig. 1")
        )
        for axis in "abc"
    ]
    for name, id_ in (("k_py", "table4.both.k_pitch"), ("k_pz", "table4.both.k_yaw")):
        table = printed(id_)
        found = Computed(table.value, table.rounding, "second Table 4")
        checks.append(compared(f"{name} against the table", f"fig1.{name}", found, "fig1-labels"))
    return PaperFigure(
        "1",
        "Ellipsoids of the keelboat",
        "Sections in the centre plane: a, the uniform ellipsoid that has the hull's mass and inertia; b, the "
        "ellipsoid whose radius is the inverse of the gyradius about it. Dashed: the gyradii under the labels of "
        "the print.",
        figure,
        checks=tuple(checks),
        errata=("tensor",),
    )


def _section(axes: Axes, half_width: float, half_height: float, style: str, name: str) -> None:
    colour = "C0" if style == "-" else "grey"
    axes.add_patch(
        Ellipse((0, 0), 2 * half_width, 2 * half_height, fill=False, color=colour, linestyle=style, label=name)
    )


def _framed(axes: Axes, x: float, y: float, x_name: str, y_name: str, title: str) -> None:
    axes.set(xlim=(-x, x), ylim=(-y, y), aspect="equal")
    label(axes, x_name, y_name, title)
    axes.legend(loc="lower center", fontsize=7.5)


def figure_20() -> PaperFigure:
    """The ellipse of inertia in the centre plane of the model hull."""
    fit = tilt_fit()
    figure, (ellipse, gyradius) = panels(columns=2, height=3.9)
    angles = np.linspace(-90.0, 90.0, 181)
    fitted = np.array([tilted(fit, angle * DEGREE) for angle in angles])
    measured = [(tilt.value, k.value) for tilt, k in _tilts()]
    gyradius.plot(angles, 1e3 * fitted, label="(3), fitted")
    tilt, k = np.array([(tilt / DEGREE, 1e3 * k) for tilt, k in measured]).T
    gyradius.plot(tilt, k, label="Table 3", **PRINTED_STYLE)
    gyradius.set_xticks([-90, -60, -30, 0, 30, 60, 90])
    label(gyradius, "tilt of the axis from the hull's z, °", "gyradius about it, mm")
    gyradius.legend()
    _inverse_ellipse(ellipse, angles * DEGREE, fitted, measured)
    low, high = fit["psi_low_rad"] / DEGREE, fit["psi_high_rad"] / DEGREE
    return PaperFigure(
        "20",
        "Gyradii about tilted axes, and the ellipse of inertia in the centre plane",
        "Model hull. The least-squares ellipse (3) through the level, the two tilted and the roll gyradius of "
        f"Table 3; the radius is 1/k. It gives ψ = {fit['psi_rad'] / DEGREE:.1f}°, 95 % from {low:.1f}° to "
        f"{high:.1f}°, if each gyradius has an uncertainty of {1e3 * U_TABLE_3_M:.0f} mm. Bow up is positive.",
        figure,
        "In print the figure is the sketch of the tilted hull; the ellipse is what its text describes.",
        (*_psi_checks(), _roll_uncertainty()),
    )


def _inverse_ellipse(axes: Axes, angles: np.ndarray, fitted: np.ndarray, measured: list[tuple[float, float]]) -> None:
    for side in (-1.0, 1.0):
        line = axes.plot(side * np.sin(angles) / fitted, side * np.cos(angles) / fitted, color="C0")
        points = np.array([(side * math.sin(tilt) / k, side * math.cos(tilt) / k) for tilt, k in measured])
        dots = axes.plot(*points.T, **PRINTED_STYLE)
    axes.set_aspect("equal")
    label(axes, "x intercept, 1/m", "z intercept, 1/m")
    axes.legend([line[0], dots[0]], ["(3), fitted", "Table 3"], loc="center")


def _tilts() -> list[tuple[Printed | _Right, Printed]]:
    level = (printed("table3.1.pitch"), printed("table3.7.k_yaw"))
    tilted_rows = [(printed(f"table3.{row}.pitch"), printed(f"table3.{row}.k_yaw")) for row in (5, 6)]
    return [level, *tilted_rows, (_Right(), printed("table3.7.k_roll"))]


class _Right:
    """The tilt of the roll axis."""

    value = math.pi / 2.0


def tilt_fit() -> dict[str, float]:
    """ψ and the principal gyradii of the model hull from all of Table 3's tilts."""
    inputs: dict[str, float] = {}
    for place, (tilt, k) in enumerate(_tilts(), start=1):
        inputs[f"pitch_{place}_rad"] = tilt.value
        inputs[f"gyradius_{place}_m"] = k.value
        inputs[f"gyradius_u_{place}_m"] = U_TABLE_3_M
    return evaluate_route("tilt_fit", inputs)


def tilted(principal: dict[str, float], pitch_rad: float) -> float:
    """The gyradius about an axis tilted from the hull's z, m."""
    inputs = {name: principal[name] for name in ("k_px_m", "k_pz_m", "psi_rad")}
    return evaluate_route("tilted_gyradius", {**inputs, "pitch_rad": pitch_rad})["gyradius_m"]


def _psi_checks() -> list[Check]:
    return [
        compared(f"ψ, {name.replace('_', ' ')}", f"table3.psi_{name}", one_tilt(row, "psi_rad"), "psi-sign")
        for name, row in (("bow_down", 5), ("stern_down", 6))
    ]


def tilt_inputs(row: int) -> Inputs:
    """The level, the roll and one tilted gyradius of Table 3, as (4) takes them."""
    return {
        "k_roll_m": printed("table3.7.k_roll"),
        "k_yaw_m": printed("table3.7.k_yaw"),
        "k_tilted_m": printed(f"table3.{row}.k_yaw"),
        "pitch_rad": printed(f"table3.{row}.pitch"),
    }


def one_tilt(row: int, output: str) -> Computed:
    """What they give by (4)."""
    return by_route("principal_from_one_tilt", output, tilt_inputs(row), "(4)")


def _roll_uncertainty() -> Check:
    """The uncertainty of the keelboat's roll gyradius by (25), from three yaw gyradii."""
    hull = {
        "k_px_m": printed("keelboat.k_roll").value,
        "k_pz_m": printed("table4.both.k_yaw").value,
        "psi_rad": printed("fig22.psi").value,
    }
    tilts = (0.0, printed("tilts.angle").value, -printed("tilts.angle").value)
    inputs: dict[str, float] = {}
    for place, tilt in enumerate(tilts, start=1):
        inputs[f"pitch_{place}_rad"] = tilt
        inputs[f"gyradius_{place}_m"] = tilted(hull, tilt)
        inputs[f"gyradius_u_{place}_m"] = printed("tilts.u").value
    found = Computed(evaluate_route("tilt_fit", inputs)["k_roll_u_m"], 0.0, "(25), propagated")
    return compared("keelboat: uncertainty of k_r from tilts of 30°", "tilts.k_roll_u", found)


def figure_22() -> PaperFigure:
    """The measured gyradius of a hull that is not level."""
    figure, (axes,) = panels()
    pitches = np.linspace(-20.0, 20.0, 81)
    for roll in (0.0, 5.0, 10.0, 15.0):
        k = [_levelled(_keelboat(), pitch * DEGREE, roll * DEGREE) for pitch in pitches]
        axes.plot(pitches, 1e3 * np.array(k), label=f"roll {roll:.0f}°")
    psi = printed("fig22.psi").in_unit
    axes.axvline(psi, color="grey", linestyle=":", label=f"level hull, ψ = {psi:.0f}°")
    label(axes, "pitch from the principal z axis, °", "gyradius about the vertical, mm")
    axes.legend(loc="lower center", ncols=3)
    return PaperFigure(
        "22",
        "Gyradius of a hull that is not level",
        "Keelboat, (28), with k_px = 623 mm, k_py = 1156 mm, k_pz = 1058 mm.",
        figure,
        "The range of the angles is chosen here. The printed slopes are differences over 1° (roll) and slopes over "
        "± 0.1° (pitch).",
        tuple(_slopes()),
    )


def _keelboat() -> dict[str, Printed]:
    return {"k_px_m": printed("fig22.k_px"), "k_py_m": printed("table4.both.k_pitch"), "k_pz_m": printed("fig22.k_pz")}


def _slopes() -> list[Check]:
    psi, far = printed("fig22.psi").value, printed("fig22.far_pitch").value

    def roll_slope(hull: dict[str, float]) -> float:
        return (_levelled(hull, 0.0, DEGREE) - _levelled(hull, 0.0, 0.0)) / DEGREE

    def pitch_slope(at_rad: float) -> Computed:
        step = 0.1 * DEGREE
        return by_function(
            lambda hull: (_levelled(hull, at_rad - step, 0.0) - _levelled(hull, at_rad + step, 0.0)) / (2.0 * step),
            _keelboat(),
            "(28)",
        )

    return [
        compared("slope in roll, level", "fig22.roll_slope", by_function(roll_slope, _keelboat(), "(28)")),
        compared("slope in pitch, level", "fig22.pitch_slope", pitch_slope(psi)),
        compared("slope in pitch, tilted by 18°", "fig22.far_slope", pitch_slope(psi + far), "far-slope"),
    ]


def _levelled(hull: dict[str, float] | dict[str, Printed], pitch_rad: float, roll_rad: float) -> float:
    given = {name: _value(number) for name, number in hull.items()}
    return evaluate_route("levelling", {**given, "pitch_rad": pitch_rad, "roll_rad": roll_rad})["gyradius_m"]


def _value(number: Printed | float) -> float:
    return number.value if isinstance(number, Printed) else number
