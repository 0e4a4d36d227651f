"""The recorder's file: what a phone wrote while a hull swung, read past whatever is damaged."""

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

    stream: str
    name: str
    full_scale: float | None


@dataclass(frozen=True)
class RecorderFile:
    """All of a recorder's file."""

    phone: str
    sensors: tuple[RecordedSensor, ...]
    notes: dict[str, str]
    #: None where the phone gave none.
    gyroscope: RecordedSamples | None
    accelerometer: RecordedSamples | None
    #: The phone's own estimate of an uncalibrated gyroscope's bias, which is not taken off the samples.
    gyroscope_bias: RecordedSamples | None
    #: Stamp, ns, and key of every mark: ``release``, ``end`` …
    events: tuple[tuple[int, str], ...]
    #: What is missing, a sentence each; empty where the file is whole.
    damage: tuple[str, ...]


def read_recorder(path: str | os.PathLike[str]) -> RecorderFile:
    """Read a recorder's file, however it was cut or damaged; ``damage`` tells what is missing.

    ``gyradius.import_files([path], folder, …)`` makes it a session.
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
