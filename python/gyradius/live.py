"""The online estimator: what the samples so far say while the hull swings."""

from __future__ import annotations

import json
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core


class Live:
    """Period, amplitude, decay, unwanted motion and advice, from samples as they come; from several threads if need be.

    >>> live = Live(wanted=1e-4)
    >>> live.push_gyroscope([0, 10_000_000], [[0.0, 0.0, 0.1], [0.0, 0.0, 0.1]])
    >>> live.estimate["swing"] is None
    True
    """

    def __init__(
        self,
        wanted: float = 1e-4,
        *,
        gyroscope_full_scale: float | None = None,
        accelerometer_full_scale: float | None = None,
    ) -> None:
        """Begin with no samples.

        Args:
            wanted: Relative standard uncertainty of the period that is enough.
            gyroscope_full_scale: rad/s at which the gyroscope saturates, where it is known.
            accelerometer_full_scale: m/s² at which the accelerometer saturates, where it is known.
        """
        self._core = _core.Live(wanted, gyroscope_full_scale, accelerometer_full_scale)
        # Each call has the estimator to itself; another thread's waits for it.
        self._alone = Lock()

    def push_gyroscope(self, stamps_ns: ArrayLike, values: ArrayLike) -> None:
        """Take samples of the gyroscope.

        Args:
            stamps_ns: Stamps, ns of the phone's clock (N).
            values: Angular rate, phone axes, rad/s (N, 3).
        """
        self._push("gyroscope", stamps_ns, values)

    def push_accelerometer(self, stamps_ns: ArrayLike, values: ArrayLike) -> None:
        """Take samples of the accelerometer.

        Args:
            stamps_ns: Stamps, ns of the phone's clock (N).
            values: Specific force, phone axes, m/s² (N, 3).
        """
        self._push("accelerometer", stamps_ns, values)

    def _push(self, sensor: str, stamps_ns: ArrayLike, values: ArrayLike) -> None:
        batch = _batch(stamps_ns, values)
        with self._alone:
            self._core.push(sensor, *batch)

    @property
    def estimate(self) -> dict[str, Any]:
        """Everything that is known now: ``now_s``, ``sensors``, ``gaps``, ``swing`` (None before
        four periods), ``advice``.
        """
        with self._alone:
            text = self._core.estimate()
        return dict(json.loads(text))

    @property
    def advice(self) -> list[str]:
        """What to know or do now, in English, most urgent first."""
        with self._alone:
            return self._core.advice()


def _batch(stamps_ns: ArrayLike, values: ArrayLike) -> tuple[Any, Any]:
    # An empty list has no second axis.
    rows = np.ascontiguousarray(values, dtype=np.float64)
    return np.ascontiguousarray(stamps_ns, dtype=np.int64), rows.reshape(0, 3) if rows.size == 0 else rows
