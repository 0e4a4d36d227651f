"""Figs. 23 and 24, and the numbers of the text on amplitude, air and coupling."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import decompose, evaluate_route
from ..simulation import Simulation
from .checks import GRAVITY_M_S2, Check, Computed, Inputs, by_function, compared
from .drawing import label, panels
from .keelboat import with_masses
from .parts import PaperFigure, PaperTable
from .print_data import DEGREE, printed
from .rigs import Hull, keelboat, keelboat_lines, simulated_swing

AMPLITUDES_DEG = np.linspace(0.25, 15.0, 60)
# Of Fig. 24; the yaw is chosen.
SWAYS_M = (0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3)
YAW_DEG = 2.0
ADDED_KG = 2.4


def figure_23() -> PaperFigure:
    """Periods against amplitude."""
    figure, (axes,) = panels()
    yaw = np.array([yaw_longer(float(angle)) for angle in AMPLITUDES_DEG])
    pendulum = np.array([pendulum_longer(float(angle)) for angle in AMPLITUDES_DEG])
    axes.plot(AMPLITUDES_DEG, 1e2 * yaw, label="yaw of the keelboat on its lines, heave included")
    axes.plot(
        AMPLITUDES_DEG, 1e2 * pendulum, "--", label="pendulum: pitch about a fixed axis, sway (angle of the lines)"
    )
    label(axes, "amplitude, °", "longer than at zero amplitude, %")
    axes.legend()
    return PaperFigure(
        "23",
        "Periods against amplitude",
        "What exact theory gives for a pendulum and for pure yaw on two lines (3.477 m, d = 0.900 m, k_y = 1057 "
        "mm). Both are parabolas at small amplitude.",
        figure,
        "The measured periods are in the picture alone. The text says that they grow by more than this and "
        "linearly, and fall below 1° in pitch: bearings and air, which these curves leave out.",
    )


def yaw_longer(amplitude_deg: float) -> float:
    """By how much the keelboat's yaw period is longer than at small amplitude, relative."""
    lines = keelboat_lines()
    inputs = {
        "gyradius_m": printed("table4.both.k_yaw").value,
        "line_length_m": lines.line_length_m,
        "half_spacing_m": lines.half_spacing_m,
        "gravity_m_s2": GRAVITY_M_S2,
    }
    wide = evaluate_route("yaw_period_at_amplitude", {**inputs, "amplitude_rad": amplitude_deg * DEGREE})
    return wide["yaw_period_s"] / evaluate_route("yaw_period", inputs)["yaw_period_s"] - 1.0


def pendulum_longer(amplitude_deg: float) -> float:
    """By how much a pendulum's period is longer than at small amplitude, relative."""
    return evaluate_route("pendulum_period_ratio", {"amplitude_rad": amplitude_deg * DEGREE})["period_ratio"] - 1.0


def figure_24() -> PaperFigure:
    """The ratio of the periods against the amplitude of the sway."""
    figure, (axes,) = panels()
    for added, marker in ((0.0, "o"), (ADDED_KG, "s")):
        hull = keelboat(with_masses(added).value)
        ratios = [period_ratio(hull, sway) for sway in SWAYS_M]
        name = f"with {added:g} kg at each end" if added else "bare hull"
        axes.plot(1e2 * np.array(SWAYS_M), ratios, marker=marker, label=f"{name}: simulated, decomposed")
        axes.axhline(hull.k_yaw_m / keelboat_lines().half_spacing_m, color="grey", linestyle=":")
    label(axes, "amplitude of the sway, cm", "T_y / T_s")
    axes.legend(loc="center right")
    return PaperFigure(
        "24",
        "Period ratio against the amplitude of the sway",
        f"The keelboat simulated in yaw ({YAW_DEG:.0f}°) and sway together, bare and with 2.4 kg at each end; the "
        "periods are those that the core's decomposition finds in the phone's readings. Dotted: k_y / d, the ratio "
        "(8).",
        figure,
        "The measured ratios are in the picture alone. Damping is left out, and the depth of the centre of mass is "
        "assumed (465 mm).",
    )


def period_ratio(hull: Hull, sway_m: float) -> float:
    """T_y/T_s of the keelboat in yaw and sway."""
    swing = simulated_swing(hull, keelboat_lines(), {"yaw_deg": YAW_DEG, "sway_m": sway_m, "duration_s": 150.0})
    modes = decompose(swing.t_s, [swing.gyro_rad_s[:, 2], swing.acc_m_s2[:, 1]]).modes
    yaw, sway = (max(modes, key=lambda mode: abs(mode.shape[channel])) for channel in (0, 1))
    return yaw.period_s / sway.period_s


def table_of_text() -> PaperTable:
    """Numbers of the text that no figure or table has."""
    return PaperTable(
        "Text",
        "Air, damping and coupling",
        "Numbers that stand in the text alone. Coupling: the simulated keelboat where it is let go, turned by 10° "
        "and moved by 20 cm.",
        (*_air(), *_coupling()),
        errata=("damped-period", "power-law"),
    )


def _air() -> list[Check]:
    densities: Inputs = {"air_density_kg_m3": printed("air.air_density"), "density_kg_m3": printed("air.hull_density")}

    def lost(given: dict[str, float]) -> float:
        found = evaluate_route("buoyant_gravity", {"gravity_m_s2": GRAVITY_M_S2, **given})
        return 1.0 - found["gravity_m_s2"] / GRAVITY_M_S2

    periods: Inputs = {"period": printed("table1.1.period"), "tau": printed("keelboat.tau_yaw")}
    over_tau = by_function(lambda given: given["period"] / given["tau"], periods, "T/τ")
    decay: Inputs = {"ratio": printed("air.period_over_tau")}
    return [
        compared("gravity less by buoyancy, density 1 g/ml", "air.buoyancy", by_function(lost, densities, "g′")),
        compared("T/τ of the yaw", "air.period_over_tau", over_tau, "period-over-tau"),
        compared("correction of the period for T/τ = 0.0063", "air.correction", by_function(_undamped, decay, "T0")),
    ]


def _undamped(given: dict[str, float]) -> float:
    inputs = {"period_s": 1.0, "decay_time_s": 1.0 / given["ratio"]}
    return 1.0 - evaluate_route("undamped_period", inputs)["period_s"]


def _coupling() -> list[Check]:
    yaw = {"yaw_deg": printed("coupling.yaw").in_unit}
    sway = {"sway_m": printed("coupling.sway").value}
    at_rest, turned, moved, both = (_let_go(start) for start in ({}, yaw, sway, {**yaw, **sway}))
    rise = {
        name: _height_m(swing) - _height_m(at_rest)
        for name, swing in (("yaw", turned), ("sway", moved), ("both", both))
    }
    excess = rise["both"] / (rise["yaw"] + rise["sway"]) - 1.0
    found = (
        ("heave of both beyond the sum", "coupling.heave_excess", excess),
        ("roll", "coupling.roll", float(2.0 * abs(_attitude(both)[1]))),
        ("heave of the sway", "coupling.sway_heave", rise["sway"]),
    )
    return [compared(name, id_, Computed(value, 0.0, "simulated")) for name, id_, value in found]


def _let_go(start: dict[str, float]) -> Simulation:
    return simulated_swing(keelboat(), keelboat_lines(), {**start, "duration_s": 1.0})


def _height_m(swing: Simulation) -> float:
    return float(swing.position_m[0, 2])


def _attitude(swing: Simulation) -> NDArray[np.float64]:
    attitude: NDArray[np.float64] = swing.attitude[0]
    return attitude
