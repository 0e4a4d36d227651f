"""Speed and precision of the periods beside other methods: one record, one process, all called from Python.

    python tests/bench_peers.py [--draws N] [--seed N]

The record is that of a hull (0.2 rad/s, 4.39 s, decay time 640 s, 120 s at 100 Hz, noise 0.005 rad/s), alone and with a
second mode 3 % away. Printed for each method: the rms error of the frequency over its Cramér–Rao bound, the median
processor time of a call (one thread; what else the machine does hardly counts), and that time over ours. Ours finds start values and the number of modes by itself and gives
standard errors; the least squares of scipy are given the number of modes and, for two of them, the truth as a start.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from dataclasses import dataclass

# One thread for every method; read when numpy loads.
os.environ.update({f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL")})

import gyradius  # noqa: E402
import numpy as np  # noqa: E402
from scipy.optimize import least_squares  # noqa: E402

RATE_HZ, DURATION_S, SIGMA = 100.0, 120.0, 0.005
TAU = 2.0 * np.pi
PADDED = 2**17
T_S = np.arange(int(RATE_HZ * DURATION_S)) / RATE_HZ


@dataclass(frozen=True)
class Mode:
    """A cos(ωt) e^(−αt) + B sin(ωt) e^(−αt)."""

    period_s: float
    decay_time_s: float
    cosine: float
    sine: float

    @property
    def parameters(self) -> list[float]:
        return [TAU / self.period_s, 1.0 / self.decay_time_s, self.cosine, self.sine]


ONE = (Mode(4.39, 640.0, 0.16, 0.12),)
TWO = (*ONE, Mode(4.26, 400.0, -0.08, 0.06))


def columns(omega: float, alpha: float) -> tuple[np.ndarray, np.ndarray]:
    envelope = np.exp(-alpha * T_S)
    return envelope * np.cos(omega * T_S), envelope * np.sin(omega * T_S)


def model(p: np.ndarray) -> np.ndarray:
    """Modes of four parameters each, then a constant."""
    swings = (c * p[i + 2] + s * p[i + 3] for i in range(0, len(p) - 1, 4) for c, s in [columns(p[i], p[i + 1])])
    return sum(swings, np.full_like(T_S, p[-1]))


def jacobian(p: np.ndarray) -> np.ndarray:
    slopes = []
    for i in range(0, len(p) - 1, 4):
        c, s = columns(p[i], p[i + 1])
        slopes += [T_S * (p[i + 3] * c - p[i + 2] * s), -T_S * (p[i + 2] * c + p[i + 3] * s), c, s]
    return np.column_stack([*slopes, np.ones_like(T_S)])


def truth(modes: tuple[Mode, ...]) -> np.ndarray:
    return np.array([x for mode in modes for x in mode.parameters] + [0.02])


def bound_rad_s(modes: tuple[Mode, ...]) -> float:
    """Cramér–Rao bound of the first mode's ω: inverse Fisher matrix, all other parameters unknown."""
    j = jacobian(truth(modes))
    return SIGMA * np.sqrt(np.linalg.inv(j.T @ j)[0, 0])


def spectral_peak(y: np.ndarray) -> float:
    """ω of the highest line under a Hann window, ten times padded, by a parabola through its three highest bins."""
    power = np.log(np.abs(np.fft.rfft((y - y.mean()) * np.hanning(len(y)), PADDED)) + 1e-300)
    k = int(np.argmax(power[1:-1])) + 1
    left, top, right = power[k - 1 : k + 2]
    return TAU * (k + 0.5 * (left - right) / (left - 2.0 * top + right)) * RATE_HZ / PADDED


def crossings(y: np.ndarray) -> float:
    """ω from the slope of crossing time against count; each crossing from a line through 0.15 s about it."""
    y = y - y.mean()
    smooth = np.convolve(y, np.ones(31) / 31.0, mode="same")
    found = np.flatnonzero(np.diff(np.signbit(smooth)))
    times = []
    for i in found[(found > 15) & (found < len(y) - 16)]:
        near = slice(i - 15, i + 17)
        slope, level = np.polyfit(T_S[near] - T_S[i], y[near], 1)
        times.append(T_S[i] - level / slope)
    return np.pi / np.polyfit(np.arange(len(times)), times, 1)[0]


def scipy_fit(y: np.ndarray, modes: tuple[Mode, ...], analytic: bool) -> float:
    if len(modes) == 1:
        omega = spectral_peak(y)
        start = np.array([omega, 1e-3, *linear_start(y, omega), y.mean()])
    else:
        start = truth(modes)
    scale = np.tile([1e-3, 1e-3, 0.1, 0.1], len(modes)).tolist() + [0.1]
    slopes = jacobian if analytic else "2-point"
    fit = least_squares(lambda p: model(p) - y, start, jac=slopes, x_scale=scale, method="lm")
    return float(fit.x[0])


def linear_start(y: np.ndarray, omega: float) -> np.ndarray:
    return np.linalg.lstsq(np.column_stack(columns(omega, 0.0)), y - y.mean(), rcond=None)[0]


def ours(y: np.ndarray) -> float:
    found = gyradius.decompose(T_S, [y])
    return min((mode.omega_rad_s for mode in found.modes), key=lambda omega: abs(omega - TAU / ONE[0].period_s))


def run(methods: dict[str, Callable[[np.ndarray], float]], modes: tuple[Mode, ...], draws: int, seed: int) -> None:
    """Every method on the same draws, in turn, so that what else the machine does meets them alike."""
    rng = np.random.default_rng(seed)
    errors: dict[str, list[float]] = {name: [] for name in methods}
    seconds: dict[str, list[float]] = {name: [] for name in methods}
    for _ in range(draws):
        y = model(truth(modes)) + SIGMA * rng.standard_normal(len(T_S))
        for name, method in methods.items():
            begun = time.process_time()
            omega = method(y)
            seconds[name].append(time.process_time() - begun)
            errors[name].append(omega - TAU / modes[0].period_s)
    bound, own = bound_rad_s(modes), float(np.median(seconds["gyradius"]))
    print(f"\n{len(modes)} mode(s), 1 channel, {draws} draws, seed {seed}; bound {1e6 * bound / truth(modes)[0]:.2f} ppm")
    print(f"{'method':38} {'rmse/CRB':>9} {'CPU ms':>8} {'of ours':>8}")
    for name in methods:
        rmse = float(np.sqrt(np.mean(np.square(errors[name])))) / bound
        median = float(np.median(seconds[name]))
        print(f"{name:38} {rmse:9.3f} {1e3 * median:8.2f} {median / own:8.2f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--seed", type=int, default=int(np.random.SeedSequence().generate_state(1)[0]))
    options = parser.parse_args()
    one = {
        "gyradius": ours,
        "scipy least squares, own derivatives": lambda y: scipy_fit(y, ONE, True),
        "scipy least squares, differences": lambda y: scipy_fit(y, ONE, False),
        "zero crossings, regression": crossings,
        "FFT, Hann, parabola": spectral_peak,
    }
    two = {
        "gyradius": ours,
        "scipy least squares, own derivatives": lambda y: scipy_fit(y, TWO, True),
        "scipy least squares, differences": lambda y: scipy_fit(y, TWO, False),
        "FFT, Hann, parabola": spectral_peak,
    }
    run(one, ONE, options.draws, options.seed)
    run(two, TWO, max(options.draws // 4, 20), options.seed + 1)


if __name__ == "__main__":
    main()
