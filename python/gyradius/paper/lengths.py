"""Figs. 15 to 18: periods against line length, the best length, and the model hull with masses at its ends."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes

from .._core import NoResultError
from ..arrays import evaluate_route
from .checks import GRAVITY_M_S2, Check, Inputs, by_function, compared
from .drawing import PRINTED_STYLE, label, panels
from .parts import PaperFigure
from .print_data import printed

GRAVITY = {"gravity_m_s2": GRAVITY_M_S2}
#: Names of the four periods, in the order of their drawing.
PERIODS = ("yaw", "in_phase", "sway", "out_of_phase")
# Of Table 3: level, athwartships, d = 0.280 m.
LEVEL_ROWS = (1, 2, 4)
# Of Fig. 16: a keelboat's k_p / l2, what lies between, and the dinghies'.
RATIOS = ("fig16.keelboat_ratio", "fig16.dinghy_ratio_low", "fig16.dinghy_ratio_high")
# Chosen, for the print does not give the masses of Fig. 18: at each end.
MOST_ADDED_KG = 0.1


def all_periods_s(
    line_length_m: float, half_spacing_m: float, k_yaw_m: float, k_pitch_m: float, cm_depth_m: float
) -> dict[str, float]:
    """The four periods of a hull on an athwartships suspension by (5), (7) and (16), s."""
    length = {"line_length_m": line_length_m, **GRAVITY}
    yaw = evaluate_route("yaw_period", {"gyradius_m": k_yaw_m, "half_spacing_m": half_spacing_m, **length})
    sway = evaluate_route("sway_period", length)
    pitch = evaluate_route("double_pendulum_periods", {"gyradius_m": k_pitch_m, "cm_depth_m": cm_depth_m, **length})
    return {
        "yaw": yaw["yaw_period_s"],
        "sway": sway["sway_period_s"],
        "in_phase": pitch["in_phase_period_s"],
        "out_of_phase": pitch["out_of_phase_period_s"],
    }


def curves_15(line_length_m: float) -> dict[str, float]:
    """The periods of Fig. 15's curves at a line length, s."""
    names = ("half_spacing", "k_yaw", "k_pitch", "depth")
    half, k_yaw, k_pitch, depth = (printed(f"fig15.{name}").value for name in names)
    return all_periods_s(line_length_m, half, k_yaw, k_pitch, depth)


def implied_by_row(row: int) -> tuple[float, dict[str, float]]:
    """Line length of a level row of Table 3, m, and the periods that its gyradii and depth need, s."""
    names = ("line_length", "half_spacing", "k_yaw", "k_pitch", "depth")
    length, half, k_yaw, k_pitch, depth = (printed(f"table3.{row}.{name}").value for name in names)
    return length, all_periods_s(length, half, k_yaw, k_pitch, depth)


def figure_15() -> PaperFigure:
    """Four periods of the model hull against the line length."""
    figure, (axes,) = panels(height=4.4)
    lengths = np.linspace(0.3, 1.7, 141)
    curves = [curves_15(float(length)) for length in lengths]
    rows = [implied_by_row(row) for row in LEVEL_ROWS]
    for place, name in enumerate(PERIODS):
        axes.plot(lengths, [curve[name] for curve in curves], color=f"C{place}", label=name.replace("_", " "))
        points = np.array([(length, periods[name]) for length, periods in rows])
        marks = axes.plot(*points.T, **{**PRINTED_STYLE, "color": f"C{place}"})
    marks[0].set_label("implied by Table 3")
    label(axes, "line length l1, m", "period, s")
    axes.legend()
    return PaperFigure(
        "15",
        "Periods of the model hull against the line length",
        "Curves: (5), (7) and (16) with the printed d = 0.280 m, k_p = 0.352 m, k_y = 0.303 m, l2 = 0.253 m. At "
        "1.56 m yaw and the in-phase mode are 2 % apart; there the paper saw pitching.",
        figure,
        "The measured periods are in the picture alone. The dots are the periods that the gyradii and depths of "
        "Table 3 need (its rows with d = 0.280 m). They show that the curves' parameters are not those of Table 3.",
        errata=("mode-names", "fig15-parameters"),
    )


def figure_16() -> PaperFigure:
    """How precisely the periods give the pitch gyradius."""
    figure, axes = panels(columns=2, height=3.9, sharey=True)
    for panel, known, title in ((axes[0], 1.0, "l2 known"), (axes[1], 0.0, "l2 from the same periods")):
        _sensitivities(panel, known)
        label(panel, "L12 = l1 / l2", "∂k_p/∂T, m/s" if known else "", title)
    axes[0].set(ylim=(0.3, 10.0), yticks=[0.5, 1, 2, 5, 10], yticklabels=["0.5", "1", "2", "5", "10"])
    axes[1].legend(loc="lower right")
    return PaperFigure(
        "16",
        "Slope of the pitch gyradius by the period",
        "The root of the sum of the squares of both slopes, from (19), for a depth of 0.253 m (the slopes scale "
        "with the root of l2). Left: l2 held fixed, as in print. Right: k_p and l2 both solved for by (17) and "
        "(18). Triangles: the least slope.",
        figure,
        "The print names 1.5 for keelboats and 2.5 to 4.5 for dinghies; which ratios its curves have is in the "
        "picture alone.",
        errata=("fig17-optimum",),
    )


def _sensitivities(axes: Axes, depth_known: float) -> None:
    depth = printed("fig15.depth").value
    for place, id_ in enumerate(RATIOS):
        ratio = printed(id_).value
        hull = {"gyradius_m": ratio * depth, "cm_depth_m": depth, "depth_known": depth_known, **GRAVITY}
        shown = np.geomspace(0.3, 60.0, 160)
        slopes = [_sensitivity(hull, float(length) * depth) for length in shown]
        axes.plot(shown, slopes, color=f"C{place}", label=f"K_P2 = {ratio:g}")
        best = evaluate_route("double_pendulum_best_length", hull)["line_length_m"]
        axes.plot(best / depth, _sensitivity(hull, best), "v", color=f"C{place}")
    axes.set(xscale="log", yscale="log", xticks=[0.5, 1, 2, 5, 10, 20, 50])
    axes.set(xticklabels=["0.5", "1", "2", "5", "10", "20", "50"])


def _sensitivity(hull: Mapping[str, float], line_length_m: float) -> float:
    return evaluate_route("double_pendulum_sensitivity", {**hull, "line_length_m": line_length_m})["sensitivity_m_s"]


def figure_17() -> PaperFigure:
    """The line length that serves best."""
    figure, (axes,) = panels()
    ratios = np.linspace(1.0, 5.0, 81)
    for known, name, line in ((1.0, "l2 known (print)", "-"), (0.0, "l2 from the same periods", "--")):
        axes.plot(ratios, [best_line_length_m(float(ratio), 1.0, known) for ratio in ratios], line, label=name)
    model = printed("fig15.k_pitch").value / printed("fig15.depth").value
    points = (("keelboat", printed("fig16.keelboat_ratio").value), ("model hull", model))
    for place, (name, ratio) in enumerate(points, start=2):
        axes.axvline(ratio, color=f"C{place}", linestyle=":", label=f"{name}, K_P2 = {ratio:.2f}")
    label(axes, "K_P2 = k_p / l2", "best L12 = l1 / l2")
    axes.legend()
    return PaperFigure(
        "17",
        "Best line length",
        "L12 of the least slope of Fig. 16 against K_P2. The keelboat's l2 is not printed; it follows from its k_p "
        "and the ratio of 1.5.",
        figure,
        checks=_optima(),
        errata=("fig17-optimum",),
    )


def best_line_length_m(gyradius_m: float, cm_depth_m: float, depth_known: float) -> float:
    """The line length of the least slope, m; not a number where the slope has no minimum."""
    inputs = {"gyradius_m": gyradius_m, "cm_depth_m": cm_depth_m, "depth_known": depth_known, **GRAVITY}
    try:
        return evaluate_route("double_pendulum_best_length", inputs)["line_length_m"]
    except NoResultError:
        return math.nan


def _optima() -> tuple[Check, ...]:
    keelboat: Inputs = {"k": printed("table4.both.k_pitch"), "ratio": printed("fig16.keelboat_ratio")}
    hull: Inputs = {"k": printed("fig15.k_pitch"), "depth": printed("fig15.depth")}
    return (
        compared(
            "best line length, keelboat",
            "fig17.keelboat_length",
            by_function(
                lambda given: best_line_length_m(given["k"], given["k"] / given["ratio"], 1.0),
                keelboat,
                "(19), l2 known",
            ),
        ),
        compared(
            "best line length, model hull",
            "fig17.model_length",
            by_function(lambda given: best_line_length_m(given["k"], given["depth"], 1.0), hull, "(19), l2 known"),
        ),
    )


def figure_18() -> PaperFigure:
    """The model hull with masses on the deck at both ends."""
    figure, axes = panels(columns=2, height=3.9)
    added = np.linspace(0.0, MOST_ADDED_KG, 21)
    loaded = [loaded_model(float(mass)) for mass in added]
    for name, text in (("k_yaw", "k_y"), ("k_pitch", "k_p"), ("depth", "l2")):
        values = np.array([one[name] for one in loaded])
        axes[0].plot(1e3 * added, 1e2 * (values / values[0] - 1.0), label=f"{text}, {1e3 * values[0]:.0f} mm without")
    periods = [all_periods_s(1.006, 0.28, one["k_yaw"], one["k_pitch"], one["depth"]) for one in loaded]
    for name in PERIODS:
        values = np.array([one[name] for one in periods])
        axes[1].plot(1e3 * added, 1e2 * (values / values[0] - 1.0), label=name.replace("_", " "))
    for panel, title in zip(axes, ("gyradii and depth", "periods at l1 = 1.006 m"), strict=True):
        label(panel, "mass added at each end, g", "change, %", title)
        panel.legend()
    return PaperFigure(
        "18",
        "Model hull with masses added at bow and stern",
        "Masses on the deck 883 mm forward and 859 mm aft. k_y by the formula of Fig. 7, k_p and l2 by parallel "
        "axes, with the hull of Fig. 15; right: the periods that follow. The period that shifts with k_p is the "
        "out-of-phase one, and the in-phase one hardly does: the text's T_1 and T_2 have here the order of the "
        "signs in (16).",
        figure,
        "The measured points and the masses are in the picture alone; the masses are taken to lie at the height of "
        "the suspension points.",
        errata=("mode-names",),
    )


def loaded_model(added_kg: float) -> dict[str, float]:
    """Gyradii and depth of the loaded hull, m; z from the suspension points, x from the hull's centre of mass."""
    mass, depth = printed("model.mass").value, printed("fig15.depth").value
    fore, aft = printed("fig18.fore").value, printed("fig18.aft").value
    k_yaw, k_pitch = printed("fig15.k_yaw").value, printed("fig15.k_pitch").value
    ends = {"mass_kg": mass, "gyradius_m": k_yaw, "added_kg": added_kg, "fore_m": fore, "aft_m": aft}
    hull = _body(mass, 0.0, -depth, k_pitch, k_yaw)
    for x in (fore, -aft):
        if added_kg:
            hull = _joined(hull, _body(added_kg, x, 0.0, 0.0, 0.0))
    found = {"k_yaw": evaluate_route("end_masses", ends)["gyradius_m"], "depth": -hull["z_m"]}
    return {**found, "k_pitch": float(np.sqrt(hull["iyy_kg_m2"] / hull["mass_kg"]))}


def _body(mass_kg: float, x_m: float, z_m: float, k_pitch_m: float, k_yaw_m: float) -> dict[str, float]:
    roll = printed("table3.7.k_roll").value if k_yaw_m else 0.0
    moments = {
        name: evaluate_route("moment", {"mass_kg": mass_kg, "gyradius_m": k})["moment_kg_m2"] if k else 0.0
        for name, k in (("ixx", roll), ("iyy", k_pitch_m), ("izz", k_yaw_m), ("ixy", 0.0), ("ixz", 0.0), ("iyz", 0.0))
    }
    place = {"mass_kg": mass_kg, "x_m": x_m, "y_m": 0.0, "z_m": z_m}
    return {**place, **{f"{name}_kg_m2": value for name, value in moments.items()}}


def _joined(one: Mapping[str, float], other: Mapping[str, float]) -> dict[str, float]:
    """Two bodies as one, by the core."""
    inputs: dict[str, float] = {}
    for number, body in ((1, one), (2, other)):
        for name, value in body.items():
            quantity, _, unit = name.partition("_")
            inputs[f"{quantity}_{number}_{unit}"] = value
    return evaluate_route("body_joined", inputs)
