"""Sparse regression (PySINDy) on swings in yaw: which terms does the acceleration need beside the loss-free swing and linear drag?

The library holds the exact loss-free acceleration on two lines and one term for each thing that may be hidden, all without
dimension. Both ways of PySINDy to meet noise are tried: smoothed finite differences, and the weak form. Terms are taken away one
by one, each time the one that is missed least (SSR; thresholds choose badly among terms so alike). Nothing is tuned by hand: of all
models on that path, fitted to the first two thirds of every swing, the one with the fewest terms whose error on the last third is
within ENOUGH of the least.
"""

from __future__ import annotations

import numpy as np
import peers_yaw as yaw
import pysindy as ps
from pysindy.utils import AxesArray

ENOUGH = 1.01
PER_PERIOD = 100  # samples
FITTED = 2 / 3  # of each swing, the rest being held out
WINDOWS = 400  # of the weak form, each half a period long
BASE = {"swing", "linear_drag"}
TERMS = {
    "swing": None,  # set by `library`
    "linear_drag": lambda x, y: y,
    "quadratic_drag": lambda x, y: np.abs(y) * y,
    "power_law_damping": lambda x, y: np.sqrt(np.abs(y)) * y,
    "bearing_friction": lambda x, y: np.sign(y),
    "amplitude_added_mass": lambda x, y: x * np.hypot(x, y),
    "hardening_spring": lambda x, y: x**3,
}


def library(swing: yaw.Swing, k: float, omega: float, size: float) -> ps.CustomLibrary:
    """Terms of angle x and rate y, in units of `size` and of size·omega."""
    rig, free = (swing.line_m, swing.spacing_m, swing.gravity_m_s2), (0.0, 0.0, 0.0, 1.0, 1.0)
    loss_free = np.vectorize(lambda x, y: yaw.acceleration(x * size, y * size * omega, k, rig, 0, free) / (size * omega**2))
    terms = [(lambda x, y: loss_free(x, y)) if name == "swing" else term for name, term in TERMS.items()]
    names = [lambda x, y, n=name: n for name in TERMS]
    return ps.CustomLibrary(library_functions=terms, function_names=names)


def rows(swings: list[yaw.Swing], weak: bool) -> list[tuple[np.ndarray, np.ndarray]]:
    """The terms (N, terms) and the acceleration (N,): to be fitted, and held out."""
    k, omega = yaw.gyradius(swings[0]), yaw.omega_of(swings[0])
    series = [yaw.filtered(s) for s in swings]
    size = max(np.abs(angle).max() for angle, _ in series)
    parts = []
    for swing, (angle, rate) in zip(swings, series):
        every = max(1, int(2 * np.pi / omega / swing.step_s / PER_PERIOD))
        states, step = np.column_stack([angle / size, rate / (size * omega)])[::every], every * swing.step_s * omega
        terms, cut = library(swing, k, omega, size), int(FITTED * len(states))
        for part in (states[:cut], states[cut:]):
            labelled, times = AxesArray(part, {"ax_time": 0, "ax_coord": 1}), np.arange(len(part)) * step
            parts.append((weak_rows if weak else smooth_rows)(labelled, times, terms))
    stacked = lambda some: tuple(np.concatenate(x) for x in zip(*some))
    return [stacked(parts[0::2]), stacked(parts[1::2])]


def smooth_rows(states, times: np.ndarray, terms) -> tuple[np.ndarray, np.ndarray]:
    """By smoothed finite differences."""
    slope = ps.SmoothedFiniteDifference()(states, times)
    return np.asarray(terms.fit_transform(states)), np.asarray(slope)[:, 1]


def weak_rows(states, times: np.ndarray, terms) -> tuple[np.ndarray, np.ndarray]:
    """Integrals over windows, by which nothing is differentiated."""
    weak = ps.WeakPDELibrary(terms, spatiotemporal_grid=times, K=WINDOWS, H_xt=[np.pi / 2])
    table = np.asarray(weak.fit_transform(states))
    return table, np.asarray(weak.convert_u_dot_integral(states))[:, 1]


def needed(swings: list[yaw.Swing], weak: bool) -> set[str]:
    """Terms beside the base's that the sparsest model of nearly the least error on what is held out has."""
    (table, slope), (other_table, other_slope) = rows(swings, weak)
    size = np.linalg.norm(table, axis=0)
    solver = ps.SSR(alpha=1e-12, criteria="model_residual", max_iter=len(TERMS))
    solver.fit(table / size * np.linalg.norm(slope), slope[:, None])
    models = []
    for path in solver.history_:
        coefficients = np.ravel(path) / size * np.linalg.norm(slope)
        error = float(np.sum((other_table @ coefficients - other_slope) ** 2))
        models.append((np.count_nonzero(coefficients), error, coefficients))
    least = min(error for _, error, _ in models)
    _, _, chosen = min((m for m in models if m[1] <= ENOUGH * least), key=lambda m: m[:2])
    return {name for name, c in zip(TERMS, chosen) if c != 0} - BASE
