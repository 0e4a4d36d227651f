"""The other methods on swings without noise, integrated by another solver: each finds what was put in."""

import numpy as np
import peers_yaw as yaw
import pytest
from scipy.integrate import solve_ivp

K, LINE, SPACING, GRAVITY, DRAG = 1.0, 2.0, 1.2, 9.81, 0.008
TORQUES = {  # over m k²
    "none": lambda psi, rate: 0.0,
    "quadratic_drag": lambda psi, rate: -0.05 * abs(rate) * rate,
    "power_law_damping": lambda psi, rate: -0.03 * abs(rate) ** 0.5 * rate,
    "bearing_friction": lambda psi, rate: -3e-4 * np.tanh(rate / 5e-4),
    "hardening_spring": lambda psi, rate: -0.3 * psi**3,
}
LASTING = 60  # s
ADDED = 0.02  # of the inertia, at an amplitude of 1 rad


def swing(name: str, start: float) -> yaw.Swing:
    """From rest; the slope of the rise is taken by differences of the rise itself."""
    rise = lambda psi: LINE - np.sqrt(LINE**2 - (SPACING * np.sin(psi / 2)) ** 2)
    slope = lambda psi: (rise(psi + 1e-5) - rise(psi - 1e-5)) / 2e-5
    curve = lambda psi: (rise(psi + 1e-4) - 2 * rise(psi) + rise(psi - 1e-4)) / 1e-8
    omega = SPACING / 2 / K * np.sqrt(GRAVITY / LINE)

    def derivative(_, y):
        psi, rate = y
        inertia = K**2 + slope(psi) ** 2 + (ADDED * np.hypot(psi, rate / omega) if name == "amplitude_added_mass" else 0.0)
        torque = TORQUES.get(name, TORQUES["none"])(psi, rate) - DRAG * rate
        return rate, (torque - slope(psi) * curve(psi) * rate**2 - GRAVITY * slope(psi)) / inertia

    times = np.arange(0, LASTING, 0.01)
    y = solve_ivp(derivative, (0, LASTING), [start, 0.0], t_eval=times, rtol=1e-8, atol=1e-9, max_step=0.05).y
    return yaw.Swing(0.01, y[1], LINE, SPACING, GRAVITY)


@pytest.fixture(scope="module", params=yaw.NAMES)
def case(request) -> tuple[str, list[yaw.Swing]]:
    """What is hidden, and two swings of unequal size with rounding's worth of noise."""
    rng = np.random.default_rng(7)  # any: the noise is a thousandth of a phone's
    swings = [swing(request.param, start) for start in (0.17, 0.08)]
    for s in swings:
        s.rate_rad_s = s.rate_rad_s + rng.normal(0, 1e-6, s.rate_rad_s.size)
    return request.param, swings


def test_least_squares_with_bic_finds_what_is_there(case):
    """The equation, the gyradius and, where it has one number, its strength."""
    name, swings = case
    chosen, fits = yaw.by_bic(swings)
    assert chosen == name
    best = fits[yaw.NAMES.index(name)]
    assert best.k_m == pytest.approx(K, rel=1e-4)
    strength = {"quadratic_drag": 0.05, "bearing_friction": 3e-4, "amplitude_added_mass": ADDED, "hardening_spring": 0.3}
    assert best.strength == pytest.approx(strength.get(name, best.strength), rel=0.02)


def test_sparse_regression_finds_what_is_there(case):
    """The term in the weak form, which names others beside it at times; and nothing where nothing is, in both forms."""
    pytest.importorskip("pysindy", reason="PySINDy is not installed; make peers installs it and runs this")
    import peers_sindy

    name, swings = case
    if name == "none":
        assert peers_sindy.needed(swings, False) == peers_sindy.needed(swings, True) == set()
    else:
        assert name in peers_sindy.needed(swings, True)
