"""turns.py [--count N] [--seed S]: swings in one turn by laws that are not the catalogue's.

Each session is one channel, a rate or an angle, of a pendulum that this script integrates (scipy's DOP853): drag that
is linear near rest, friction with Stribeck's dip, restoring forces with the third and fifth power of the angle where the
catalogue has a sine, a spring that is stiffer on one side. Printed: what was drawn, the verdict, and how many of its
standard uncertainties the period of small swings is off; at the end how many lie within their 95 % intervals.
"""

from __future__ import annotations

import argparse
import tempfile
from dataclasses import dataclass
from pathlib import Path

import gyradius
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

KINDS = (
    "none",
    "quadratic",
    "cross",
    "dry",
    "stribeck",
    "hard",
    "hard5",
    "scale",
    "onesided",
    "quad+hard",
    "dry+quad",
)
COVERAGE_95 = 1.959963984540054


@dataclass
class Drawn:
    """A swing: its period, s, width, rad, strengths, and how it is recorded."""

    period_s: float
    reach_rad: float
    linear: float
    quadratic: float = 0.0
    crossover: float = 0.0
    dry: float = 0.0
    dip: float = 0.0
    cubic: float = 0.0
    fifth: float = 0.0
    one_sided: float = 0.0
    scale: float = 0.0

    def slope(self, y: NDArray[np.float64]) -> list[float]:
        """Rate and acceleration; strengths are shares of critical damping at the fastest rate, and of gravity's force."""
        x, v = y
        omega = 2 * np.pi / self.period_s
        fastest = omega * self.reach_rad
        u = v / fastest
        drag = self.quadratic * (v * u * u / np.sqrt(u * u + self.crossover**2) if self.crossover else abs(u) * v)
        dry = self.dry * fastest * np.tanh(v / (1e-4 * fastest)) * (1 + self.dip * np.exp(-((u / 0.1) ** 2)))
        force = np.sin(x) + self.cubic * x**3 + self.fifth * x**5 + self.one_sided * x * x
        return [v, -omega * omega * force - 2 * omega * (self.linear * v + drag + dry)]


def log_uniform(rng: np.random.Generator, least: float, most: float) -> float:
    """Each decade alike."""
    return float(np.exp(rng.uniform(np.log(least), np.log(most))))


def drawn(rng: np.random.Generator, kind: str) -> Drawn:
    """A swing of a kind."""
    period_s = rng.uniform(0.8, 3.5)
    reach_rad = np.radians(log_uniform(rng, 4, 50))
    swing = Drawn(period_s, reach_rad, log_uniform(rng, 3e-4, 8e-3))
    if "quad" in kind:
        swing.quadratic = log_uniform(rng, 5e-4, 2e-2)
    if kind == "cross":
        swing.quadratic, swing.crossover = log_uniform(rng, 2e-3, 2e-2), 0.2
    if "dry" in kind:
        swing.dry = log_uniform(rng, 2e-4, 2e-3)
    if kind == "stribeck":
        swing.dry, swing.dip = log_uniform(rng, 3e-4, 2e-3), 0.3
    if "hard" in kind:
        swing.cubic = log_uniform(rng, 0.1, 2) * rng.choice([-0.3, 1.0])
    if kind == "hard5":
        swing.cubic, swing.fifth = 0.3, 1.0
    if kind == "scale":
        swing.scale = rng.normal(0, 0.01)
    if kind == "onesided":
        swing.one_sided = log_uniform(rng, 0.02, 0.2)
    return swing


def recorded(rng: np.random.Generator, swing: Drawn, path: Path) -> str:
    """Writes its channel; the name of what was recorded."""
    omega = 2 * np.pi / swing.period_s
    fastest = omega * swing.reach_rad
    duration_s = min(rng.uniform(12, 60) * swing.period_s, 90.0)
    rate_hz = min(max(log_uniform(rng, 20, 200), 12 / swing.period_s), 200)
    t_s = np.arange(0, duration_s, 1 / rate_hz)
    motion = solve_ivp(
        lambda _, y: swing.slope(y),
        (0, duration_s),
        [swing.reach_rad, 0],
        t_eval=t_s,
        rtol=1e-9,
        atol=1e-11 * swing.reach_rad,
        max_step=swing.period_s / 60,
        method="DOP853",
    ).y
    noise = fastest * log_uniform(rng, 3e-4, 1e-2)
    is_angle = rng.random() < 0.3
    if is_angle:
        values = motion[0] + rng.normal(0, noise / omega, len(t_s))
    else:
        values = (1 + swing.scale) * motion[1] + rng.normal(0, noise, len(t_s)) + rng.normal(0, 0.005)
    rows = [f"{t:.6f},{value:.9g}" for t, value in zip(t_s, values, strict=True)]
    path.write_text("\n".join(["time,y", *rows]))
    return "angle" if is_angle else "rate"


def judged(swing: Drawn, rng: np.random.Generator, folder: Path) -> tuple[str, float]:
    """What the criticism says, and how far the period is off in its standard uncertainties."""
    name = recorded(rng, swing, folder / "turn.csv")
    channel = "angle=y:rad" if name == "angle" else "gz=y:rad/s"
    gyradius.import_files(
        [str(folder / "turn.csv")],
        folder / "session",
        mapping=["t=time:s", channel],
        suspension="compound",
        axis_height=(0.3, 0.001),
    )
    critique = gyradius.load(folder / "session").critique()
    verdict = critique.verdict
    period = critique.extended.quantities["small_period_turn_s"]
    off = (period.value - swing.period_s) / period.u
    others = f" or {', '.join(verdict.indistinguishable_from)}" if verdict.indistinguishable_from else ""
    left = f"{critique.baseline.rms_over_noise:.2f} -> {critique.extended.rms_over_noise:.2f}"
    told = f"{name}: {verdict.status} {', '.join(verdict.causes)}{others}; {left} times the noise; off by {off:.2f} u"
    return told, off


def main() -> None:
    """Draws and judges."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=66)
    parser.add_argument("--seed", type=int, default=2)
    options = parser.parse_args()
    inside = total = 0
    for number in range(options.count):
        rng = np.random.default_rng([options.seed, number])
        kind = KINDS[number % len(KINDS)]
        swing = drawn(rng, kind)
        with tempfile.TemporaryDirectory() as folder:
            try:
                told, off = judged(swing, rng, Path(folder))
            except gyradius.GyradiusError as error:
                print(f"{number} {kind}: {error}", flush=True)
                continue
        total += 1
        inside += abs(off) < COVERAGE_95
        print(f"{number} {kind} {np.degrees(swing.reach_rad):.0f}° {told}", flush=True)
    print(f"{inside} of {total} periods of small swings lie within their 95 % intervals")


if __name__ == "__main__":
    main()
