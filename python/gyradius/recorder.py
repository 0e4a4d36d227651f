"""The recorder's file: what a phone wrote while a hull swung; damaged parts are skipped."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _core


@dataclass(frozen=True)
class RecordedSamples:
    """Samples of one stream, bit for bit as the phone gave them (N)."""

    #: Stamps, ns of the phone's clock (N); they may jitter, repeat or step back.
    stamps_ns: NDArray[np.int64]
    #: x, y, z in phone axes, rad/s or m/s² of specific force (N, 3).
    values: NDArray[np.float64]


@dataclass(frozen=True)
class RecordedSensor:
    """One sensor as the phone describes it."""

    #: ``gyroscope``, ``accelerometer`` or ``gyroscope_bias``.
    stream: str
    #: The phone's name for it.
    name: str
    #: Where it saturates, rad/s or m/s²; None where the phone does not say.
    full_scale: float | None


@dataclass(frozen=True)
class RecorderFile:
    """The whole content of a recorder's file."""

    #: Model of the phone.
    phone: str
    #: The sensors that were recorded.
    sensors: tuple[RecordedSensor, ...]
    #: What the recorder noted, by name.
    notes: dict[str, str]
    #: Angular rate, rad/s; None where the phone gave none.
    gyroscope: RecordedSamples | None
    #: Specific force, m/s²; None where the phone gave none.
    accelerometer: RecordedSamples | None
    #: The phone's own estimate of an uncalibrated gyroscope's bias, rad/s, which is not taken off the samples.
    gyroscope_bias: RecordedSamples | None
    #: Stamp, ns, and key of every mark: ``release``, ``end`` …
    events: tuple[tuple[int, str], ...]
    #: What is missing, a sentence each; empty where the file is whole.
    damage: tuple[str, ...]


def read_recorder(path: str | os.PathLike[str]) -> RecorderFile:
    """Read a recorder's file, even if it is truncated or damaged.

    ``gyradius.import_files([path], folder, …)`` makes it a session.

    Args:
        path: The file (``.gyr``).

    Returns:
        All that can be read; ``damage`` says what is missing.

    Raises:
        InputError: It is not a recorder's file.
    """
    core = _core.read_recorder(os.fspath(path))
    tracks = {stream: RecordedSamples(stamps_ns, values) for stream, stamps_ns, values in core.tracks()}
    return RecorderFile(
        phone=core.phone,
        sensors=tuple(RecordedSensor(*sensor) for sensor in core.sensors),
        notes=dict(core.notes),
        gyroscope=tracks.get("gyroscope"),
        accelerometer=tracks.get("accelerometer"),
        gyroscope_bias=tracks.get("gyroscope_bias"),
        events=tuple(core.events),
        damage=tuple(core.damage),
    )
