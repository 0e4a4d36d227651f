"""The hull as a swing in yaw alone: its exact equation, what could be added to it, and least squares with BIC.

(k² + Z'²) ψ'' + Z' Z'' ψ'² + g Z' = torque / mass, Z(ψ) = l - √(l² - d² sin²(ψ/2)) being the rise on two lines of length l, d apart
at both ends (Lagrange). All figures are divided by k²: torques in 1/s², drag in 1/s.
"""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from forces import SLIDING
from scipy.optimize import least_squares
from scipy.signal import butter, hilbert, sosfiltfilt

NAMES = ["none", "quadratic_drag", "power_law_damping", "bearing_friction", "amplitude_added_mass", "hardening_spring"]
SHAPES = {"power_law_damping": [0.5]}  # what an addition has beside its strength: the exponent, less one
MEAN_OF = 5  # samples taken together
SETTLING = 2  # periods left out at both ends of a filtered series


@dataclass
class Swing:
    """Readings of the rotation about the vertical, and the rig as it was stated."""

    step_s: float
    rate_rad_s: np.ndarray
    line_m: float
    spacing_m: float
    gravity_m_s2: float


def about_the_vertical(gyro: np.ndarray) -> np.ndarray:
    """Readings (N, 3) along their first principal axis; its sign is arbitrary, and all equations here are odd."""
    centred = gyro - gyro.mean(0)
    return centred @ np.linalg.svd(centred, full_matrices=False)[2][0]


def omega_of(swing: Swing) -> float:
    """Of the swing, rad/s, by the phase of the analytic signal."""
    rate, tenth = swing.rate_rad_s, swing.rate_rad_s.size // 10
    coarse = np.fft.rfft(rate * np.hanning(rate.size))
    peak = np.abs(coarse[1:]).argmax() + 1
    band = np.array([0.6, 1.4]) * peak / (rate.size * swing.step_s)
    narrow = sosfiltfilt(butter(2, band, "band", fs=1 / swing.step_s, output="sos"), rate)
    phase = np.unwrap(np.angle(hilbert(narrow)))[tenth:-tenth]
    return float(np.polyfit(np.arange(phase.size) * swing.step_s, phase, 1)[0])


def gyradius(swing: Swing) -> float:
    """By the small swing's frequency, m."""
    return swing.spacing_m / 2 * np.sqrt(swing.gravity_m_s2 / swing.line_m) / omega_of(swing)


def filtered(swing: Swing) -> tuple[np.ndarray, np.ndarray]:
    """Angle and rate, less what is faster than the sixth harmonic and less a steady drift; ends cut."""
    omega, step = omega_of(swing), swing.step_s
    rate = sosfiltfilt(butter(3, 6 * omega / (2 * np.pi), fs=1 / step, output="sos"), swing.rate_rad_s)
    angle = (np.cumsum(rate) - 0.5 * rate) * step
    period = round(2 * np.pi / omega / step)
    middle = np.convolve(angle, np.full(period, 1 / period), "valid")
    times = np.arange(angle.size) * step
    drift = np.polynomial.Polynomial.fit(times[: middle.size] + 0.5 * (period - 1) * step, middle, 2)
    kept = slice(SETTLING * period, -SETTLING * period)
    return (angle - drift(times))[kept], (rate - drift.deriv()(times))[kept]


@numba.njit
def acceleration(psi, rate, k, rig, kind, p):
    """ψ'': rig is line, spacing, gravity; p is linear drag, strength, exponent less one, and the rate and frequency of scale."""
    line, spacing, gravity = rig
    drop = np.sqrt(line**2 - (spacing * np.sin(psi / 2)) ** 2)
    slope = spacing**2 * np.sin(psi) / (4 * drop) / k
    curve = spacing**2 * np.cos(psi) / (4 * drop) / k + (spacing**2 * np.sin(psi)) ** 2 / (16 * drop**3) / k
    linear, strength, bend, usual, omega = p
    force, inertia = -linear * rate, 1.0 + slope**2
    if kind == 1:
        force -= strength * abs(rate) * rate
    elif kind == 2:
        force -= strength * abs(rate / usual) ** (1 + bend) * np.sign(rate)
    elif kind == 3:
        force -= strength * np.tanh(rate / SLIDING)
    elif kind == 4:
        inertia += strength * np.hypot(psi, rate / omega)
    elif kind == 5:
        force -= strength * psi**3
    return (force - slope * curve * rate**2 - gravity * slope / k) / inertia


@numba.njit
def rates(start, k, rig, kind, p, h, count):
    """Means (count,) of MEAN_OF rates, sampled `h` apart, by steps of fourth order."""
    psi, rate, out = start[0], start[1], np.zeros(count)
    for n in range(count * MEAN_OF):
        out[n // MEAN_OF] += rate / MEAN_OF
        a = acceleration(psi, rate, k, rig, kind, p)
        b = acceleration(psi + 0.5 * h * rate, rate + 0.5 * h * a, k, rig, kind, p)
        c = acceleration(psi + 0.5 * h * (rate + 0.5 * h * a), rate + 0.5 * h * b, k, rig, kind, p)
        d = acceleration(psi + h * (rate + 0.5 * h * b), rate + h * c, k, rig, kind, p)
        psi += h * (rate + h / 6 * (a + b + c))
        rate += h / 6 * (a + 2 * b + 2 * c + d)
    return out


@dataclass
class Fit:
    """One equation's least squares: all swings share k, drag and what is added; each has its release and its offset."""

    name: str
    bic: float
    k_m: float
    strength: float


def scales(swings: list[Swing], name: str) -> tuple[np.ndarray, np.ndarray]:
    """First guess and unit of every parameter: k, drag, strength, shape, then each swing's angle, rate and offset."""
    k = gyradius(swings[0])
    omega, usual = omega_of(swings[0]), max(np.abs(s.rate_rad_s).max() for s in swings)
    unit = {"quadratic_drag": omega / usual, "amplitude_added_mass": omega / usual, "hardening_spring": omega**4 / usual**2}
    unit |= {"power_law_damping": omega * usual, "bearing_friction": omega * usual}
    shared, units = [k, 0.01 * omega], [k * 1e-3, 0.01 * omega]
    if name != "none":
        shared, units = [*shared, 1e-3 * unit[name]], [*units, 1e-3 * unit[name]]
    shared, units = shared + SHAPES.get(name, []), units + SHAPES.get(name, [])
    for swing in swings:
        angle, rate = released(swing)
        shared, units = [*shared, angle, rate, 0.0], [*units, 0.01 * usual / omega, 0.01 * usual, 0.01 * usual]
    return np.array(shared), np.array(units)


def released(swing: Swing) -> tuple[float, float]:
    """Angle and rate at the first sample, from a sine through the first two periods."""
    omega = omega_of(swing)
    t = np.arange(int(4 * np.pi / omega / swing.step_s)) * swing.step_s
    waves = np.column_stack([np.cos(omega * t), np.sin(omega * t), np.ones_like(t)])
    c, s, _ = np.linalg.lstsq(waves, swing.rate_rad_s[: t.size], rcond=None)[0]
    return -s / omega, c


def fit(swings: list[Swing], name: str) -> Fit:
    """Least squares of one equation on rates that are means of MEAN_OF samples."""
    means = [s.rate_rad_s[: s.rate_rad_s.size // MEAN_OF * MEAN_OF].reshape(-1, MEAN_OF).mean(1) for s in swings]
    first, unit = scales(swings, name)
    own, bends = first.size - 3 * len(swings), len(SHAPES.get(name, []))
    omega, usual = omega_of(swings[0]), max(np.abs(s.rate_rad_s).max() for s in swings)

    def left(x: np.ndarray) -> np.ndarray:
        values, parts = x * unit, []
        strength = values[2] if own > 2 else 0.0
        p = (values[1], strength, values[3] if bends else 0.0, usual, omega)
        for n, (swing, mean) in enumerate(zip(swings, means)):
            angle, rate, offset = values[own + 3 * n : own + 3 * n + 3]
            rig = (swing.line_m, swing.spacing_m, swing.gravity_m_s2)
            said = rates((angle, rate), values[0], rig, NAMES.index(name), p, swing.step_s, mean.size)
            parts.append(said + offset - mean)
        return np.concatenate(parts)

    low = np.full(first.size, -np.inf)
    low[0] = 0.5 * first[0] / unit[0]
    high = np.full(first.size, np.inf)
    if bends:
        low[3], high[3] = 0.1 / unit[3], 1.5 / unit[3]
    found = least_squares(left, first / unit, bounds=(low, high), x_scale="jac", max_nfev=60)
    count = found.fun.size
    bic = count * np.log(2 * found.cost / count) + first.size * np.log(count)
    values = found.x * unit
    return Fit(name, float(bic), float(values[0]), float(values[2]) if own > 2 else 0.0)


def by_bic(swings: list[Swing]) -> tuple[str, list[Fit]]:
    """The equation of least BIC, and all."""
    fits = [fit(swings, name) for name in NAMES]
    return min(fits, key=lambda f: f.bic).name, fits
