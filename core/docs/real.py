"""Draws what real recordings leave of the simulations of one motion (`python core/docs/real.py FOLDER`).

FOLDER holds `phone-pendulum/Gyroscope.csv` and `ducted-fan/*InertiaP*.csv`, which the project does not hand on (see
`real.md` for where they come from). For each recording: the residual of both simulations over the noise, and the
period of each swing against its amplitude, measured and simulated. The figures of `real.md` go to standard output.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import gyradius
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from gyradius.imports import import_files
from numpy.typing import NDArray

HERE = Path(__file__).parent
Numbers = NDArray[np.float64]
GYROSCOPE = ["t=Time:ms", "gx=xGyro:deg/s", "gy=yGyro:deg/s", "gz=ZGyro:deg/s"]
ACCELERATION = ["lx=xAcc:m/s2", "ly=yAcc:m/s2", "lz=zAcc:m/s2"]
PENDULUM = {"suspension": "compound", "axis_height": (0.43, 0.0)}
FAN = {
    "mapping": GYROSCOPE + ACCELERATION,
    "suspension": "bifilar",
    "mass": (3.34, 0.0),
    "line_length": (0.74, 0.0),
    "spacing": (0.16, 0.0),
}
#: Picture, recording, what was stated of it.
RECORDINGS = [
    ("phone-pendulum", "phone-pendulum/Gyroscope.csv", PENDULUM),
    ("ducted-fan-yaw", "ducted-fan/YawInertiaPendel01.csv", FAN),
    ("ducted-fan-pitch", "ducted-fan/PitchInertiaPendel01.csv", FAN),
    ("ducted-fan-roll", "ducted-fan/RollInertiapendel01.csv", FAN),
]
#: Cycles that are averaged for a point.
CYCLES = 4


def session(recording: Path, stated: dict[str, object], folder: Path) -> Path:
    """The recording as a session; on two lines every run turned about the vertical, and the operator's word names it."""
    import_files([str(recording)], folder, title=recording.stem, **stated)
    path = folder / "session.toml"
    if stated["suspension"] == "bifilar":
        path.write_text(path.read_text().replace("[swing.suspension]", 'excited = ["yaw"]\n[swing.suspension]'))
    return folder


def periods(t_s: Numbers, rate_rad_s: Numbers) -> tuple[Numbers, Numbers]:
    """Amplitude of the angle, rad, and period, s, over every few cycles, by upward crossings of zero."""
    rate = rate_rad_s - np.median(rate_rad_s)
    usual_s = 2 * np.pi * np.sqrt(rate.var() / np.gradient(rate, t_s).var())
    smooth = np.convolve(rate, np.hanning(11) / np.hanning(11).sum(), "same")
    at = np.flatnonzero((smooth[:-1] < 0) & (smooth[1:] >= 0))
    crossings = t_s[at] - smooth[at] * (t_s[at + 1] - t_s[at]) / (smooth[at + 1] - smooth[at])
    crossings = crossings[np.concatenate([[True], np.diff(crossings) > 0.5 * usual_s])]
    edges = crossings[::CYCLES]
    period = np.diff(edges) / CYCLES
    inside = [(t_s >= a) & (t_s < b) for a, b in zip(edges[:-1], edges[1:], strict=True)]
    amplitude = np.array([rate[i].std() * np.sqrt(2) for i in inside]) * period / (2 * np.pi)
    return amplitude, period


def draw(name: str, critique: gyradius.Critique) -> None:
    """The residuals and the periods of a session of one swing."""
    trace = critique.traces[0]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2), constrained_layout=True)
    colours = {"base simulation": "tab:orange", "with what is missing": "tab:blue"}
    simulated = dict(zip(colours, (trace.base, trace.extended), strict=True))
    for label, colour in colours.items():
        left.plot(trace.t_s, (trace.measured - simulated[label]) / trace.noise, ".", markersize=0.8, color=colour)
        amplitude, period = periods(trace.t_s, simulated[label])
        right.plot(np.degrees(amplitude), period, "-", linewidth=1.2, color=colour, label=label)
    amplitude, period = periods(trace.t_s, trace.measured)
    right.plot(np.degrees(amplitude), period, ".", color="black", markersize=5, label="measured")
    left.set(xlabel="time, s", ylabel="measured less simulated, over noise", title="What is left")
    right.set(xlabel="amplitude, degrees", ylabel="period, s", title=f"Period of {CYCLES} swings")
    right.legend(frameon=False)
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(HERE / "real" / f"{name}.png", dpi=110)
    plt.close(figure)


def tell(name: str, critique: gyradius.Critique) -> None:
    """What `real.md` quotes."""
    print(f"{name}: {critique.verdict.status}: {', '.join(critique.verdict.causes)}")
    for part, model in (("base", critique.baseline), ("extended", critique.extended)):
        print(f"  {part}: {model.rms_over_noise:.2f} times the noise, held out {model.heldout_rms_over_noise:.2f}")
    for cause in critique.causes:
        print(f"  {cause.id}: {cause.log_evidence_gain:.0f}{' (taken)' if cause.taken else ''}")
    for discrepancy in critique.discrepancies:
        print(f"  {discrepancy.text}")


def main() -> None:
    """Every recording that is there."""
    (HERE / "real").mkdir(exist_ok=True)
    for name, path, stated in RECORDINGS:
        recording = Path(sys.argv[1]) / path
        with tempfile.TemporaryDirectory() as folder:
            critique = gyradius.load(session(recording, stated, Path(folder) / name)).critique()
        tell(name, critique)
        draw(name, critique)


if __name__ == "__main__":
    main()
