"""Simulated swings: a rig, as a file or as a mapping, becomes arrays."""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .files import only_writer

FORMAT = "gyradius-rig/1"


@dataclass(frozen=True)
class Simulation:
    """A simulated swing: the phone's readings and the true motion. N stamps; derivatives with respect to P numbers.

    World axes: z up, origin mid-way between the upper ends of the lines. Hull axes here are those of the hull as it
    hangs; positions in it count from the mid-point of the suspension points.
    """

    #: Id of the swing.
    swing: str
    #: Time stamps of the phone, s (N).
    t_s: NDArray[np.float64]
    #: Angular rate, phone axes, rad/s (N, 3).
    gyro_rad_s: NDArray[np.float64]
    #: Specific force, phone axes, m/s² (N, 3).
    acc_m_s2: NDArray[np.float64]
    #: Centre of mass, world axes, m (N, 3).
    position_m: NDArray[np.float64]
    #: Quaternion w, x, y, z, world from hull (N, 4).
    attitude: NDArray[np.float64]
    #: Velocity of the centre of mass, world axes, m/s (N, 3).
    velocity_m_s: NDArray[np.float64]
    #: Angular rate, hull axes, rad/s (N, 3).
    rate_rad_s: NDArray[np.float64]
    #: Acceleration of the centre of mass, world axes, m/s² (N, 3).
    acceleration_m_s2: NDArray[np.float64]
    #: Angular acceleration, hull axes, rad/s² (N, 3).
    angular_acceleration_rad_s2: NDArray[np.float64]
    #: Value of every number that is simulated.
    numbers: Mapping[str, float]
    #: Unit of every number.
    units: Mapping[str, str]
    #: The numbers that ``derivatives`` belong to, in their order (P).
    parameters: tuple[str, ...]
    #: Derivatives of the six readings, angular rate first (N, 6, P).
    derivatives: NDArray[np.float64]
    #: When a line first went slack, s, and which one; what follows on lines of given length is not to be used.
    slack: tuple[float, int] | None


class Rig:
    """The content of a rig file: a session as stated, and its true values."""

    def __init__(self, core: _core.Rig) -> None:
        """Rigs come from ``gyradius.read_rig``."""
        self._core = core

    @property
    def swing_ids(self) -> list[str]:
        """Ids of the swings in the order of the file."""
        return self._core.swing_ids

    def numbers(self, swing: str | None = None) -> dict[str, float]:
        """Every number that a swing is simulated with.

        Args:
            swing: Id of the swing; may be left out where there is one only.

        Returns:
            Values by name, in the unit that the name ends in. Those of effects are called ``effect.number``, those of
            the phone ``phone.position_x_m`` and so on.
        """
        return {name: value for name, value, _ in self._core.numbers(self._one(swing))}

    def simulate(
        self,
        swing: str | None = None,
        *,
        values: Mapping[str, float] | None = None,
        derivatives: Sequence[str] = (),
        t_s: ArrayLike | None = None,
        seed: int | None = None,
    ) -> Simulation:
        """Simulate one swing, as the phone samples it or at the times given.

        Args:
            swing: Id of the swing; may be left out where there is one only.
            values: Numbers that replace those of the rig, by the names of ``numbers()``.
            derivatives: Names of the numbers to differentiate the readings by (P).
            t_s: Times on the phone's clock, s (N); the phone's own where they are left out.
            seed: Seed of the random errors (noise, jitter, lost samples); without one there are none.

        Returns:
            The readings, the motion and the derivatives.

        Raises:
            InputError: A name or a value is not possible.
        """
        swing = self._one(swing)
        replaced = {name: float(value) for name, value in (values or {}).items()}
        times = None if t_s is None else np.ascontiguousarray(t_s, dtype=np.float64)
        core = self._core.simulate(swing, list(replaced.items()), list(derivatives), times, seed)
        numbers = self._core.numbers(swing)
        return Simulation(
            swing=swing,
            t_s=core.t_s,
            gyro_rad_s=core.readings[:, :3],
            acc_m_s2=core.readings[:, 3:],
            position_m=core.position_m,
            attitude=core.attitude,
            velocity_m_s=core.velocity_m_s,
            rate_rad_s=core.rate_rad_s,
            acceleration_m_s2=core.acceleration_m_s2,
            angular_acceleration_rad_s2=core.angular_acceleration_rad_s2,
            numbers={name: replaced.get(name, value) for name, value, _ in numbers},
            units={name: unit for name, _, unit in numbers},
            parameters=tuple(derivatives),
            derivatives=core.derivatives,
            slack=core.slack,
        )

    def write(
        self,
        folder: str | os.PathLike[str],
        *,
        truth: str | os.PathLike[str] | None = None,
        seed: int | None = None,
        replace: bool = False,
    ) -> tuple[Path, int]:
        """Simulate every swing and write the session into a folder. The same seed gives the same files.

        The true values are never written into the folder, so the session can be used for a blind test.

        Args:
            folder: The session folder to write.
            truth: File for the true values; ``FOLDER.truth.json`` if omitted.
            seed: Seed of all random errors; drawn at random if omitted.
            replace: Overwrite existing files.

        Returns:
            The truth file, and the seed.

        Raises:
            InputError: Files are there already, or another program is writing there.
        """
        drawn = secrets.randbits(53) if seed is None else seed
        file = Path(f"{os.path.normpath(folder)}.truth.json") if truth is None else Path(truth)
        with only_writer(Path(folder)):
            self._core.write(os.fspath(folder), os.fspath(file), drawn, replace)
        return file, drawn

    def _one(self, swing: str | None) -> str:
        if swing is not None:
            return swing
        if len(self.swing_ids) > 1:
            raise _core.InputError(f"swing: one of {', '.join(self.swing_ids)} was expected, found none")
        return self.swing_ids[0]


def read_rig(rig: str | os.PathLike[str] | Mapping[str, Any]) -> Rig:
    """Read a rig.

    Args:
        rig: A rig file, or a mapping with the same keys; that may leave ``format`` out.

    Returns:
        The rig.

    Raises:
        InputError: Something in it is wrong; ``file`` and ``line`` say where.
    """
    if isinstance(rig, Mapping):
        return Rig(_core.read_rig("rig", _toml({"format": FORMAT, **rig})))
    return Rig(_core.read_rig(os.fspath(rig)))


def simulate(
    rig: str | os.PathLike[str] | Mapping[str, Any],
    swing: str | None = None,
    *,
    values: Mapping[str, float] | None = None,
    derivatives: Sequence[str] = (),
    t_s: ArrayLike | None = None,
    seed: int | None = None,
) -> Simulation:
    """Simulate a swing of a rig.

    Args:
        rig: A rig file, or a mapping with the same keys.
        swing: Id of the swing; may be left out where there is one only.
        values: Numbers that replace those of the rig, by name.
        derivatives: Names of the numbers to differentiate the readings by (P).
        t_s: Times on the phone's clock, s (N); the phone's own where they are left out.
        seed: Seed of the random errors; without one there are none.

    Returns:
        The readings, the motion and the derivatives.
    """
    return read_rig(rig).simulate(swing, values=values, derivatives=derivatives, t_s=t_s, seed=seed)


def shipped_rigs() -> dict[str, Path]:
    """The rig files that come with the package, by name."""
    folder = Path(str(resources.files("gyradius"))) / "rigs"
    return {path.stem: path for path in sorted(folder.glob("*.toml"))}


def _toml(rig: Mapping[str, Any]) -> str:
    return "".join(f"{json.dumps(key)} = {_value(value)}\n" for key, value in rig.items())


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(key)} = {_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, str | bool):
        return json.dumps(value).replace("\x7f", "\\u007f")
    if isinstance(value, Sequence | np.ndarray):
        return "[" + ", ".join(_value(item) for item in value) + "]"
    return repr(float(value))
