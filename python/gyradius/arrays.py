"""The core on arrays: oscillations in any record, and the paper's equations one by one."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core


@dataclass(frozen=True, slots=True)
class Mode:
    """One damped oscillation, shared by all channels."""

    #: Period, s.
    period_s: float
    #: Standard error of the period, s.
    period_se_s: float
    #: Angular frequency ω, rad/s.
    omega_rad_s: float
    #: Standard error of ω, rad/s.
    omega_se_rad_s: float
    #: Damping rate α, 1/s; the decay time is 1/α.
    alpha_per_s: float
    #: Standard error of α, 1/s.
    alpha_se_per_s: float
    #: Complex amplitude at ``t_ref_s`` in each channel, in the channel's unit (C).
    shape: NDArray[np.complex128]
    #: Signal over noise, dB.
    snr_db: float


@dataclass(frozen=True)
class Decomposition:
    """The damped oscillations of a record of C channels.

    Channel c is ``level[c] + Re Σ shape[c] · exp((−α + iω)(t − t_ref_s))`` where period and decay do not depend on
    the amplitude; ``data`` is everything the core gives, amplitude laws and combination tones included.
    """

    #: Time that the shapes belong to, s.
    t_ref_s: float
    #: End of the record, s.
    t_end_s: float
    #: The oscillations, the strongest first.
    modes: tuple[Mode, ...]
    #: Noise of one sample in each channel, in the channel's unit (C).
    noise: tuple[float, ...]
    #: Baseline of each channel, in the channel's unit (C).
    level: tuple[float, ...]
    #: Root mean square of the residual over the noise; 1 where the fit describes everything.
    rms_over_noise: float
    #: What a reader must know.
    warnings: tuple[str, ...]
    #: Everything that the core gives.
    data: Mapping[str, Any]
    _core: _core.Decomposition

    def evaluate(self, t_s: ArrayLike) -> NDArray[np.float64]:
        """The fitted oscillations at any times, without the baseline.

        Args:
            t_s: Times, s (N).

        Returns:
            One row for each channel, in its unit (C, N).
        """
        return self._core.evaluate(_float64(t_s))


def decompose(t_s: ArrayLike, channels: Sequence[ArrayLike]) -> Decomposition:
    """Find the damped oscillations of channels that share one clock.

    Contiguous float64 arrays are passed without a copy.

    Args:
        t_s: Time stamps, s (N); they need not be evenly spaced.
        channels: C arrays of readings, each in any unit (N).

    Returns:
        The oscillations; the data decide how many.

    Raises:
        InputError: The arrays differ in length, or the stamps do not rise.
        NoResultError: The record is too short, or no oscillation stands above the noise.
    """
    core = _core.decompose(_float64(t_s), [_float64(channel) for channel in channels])
    data = json.loads(core.to_json())
    return Decomposition(
        t_ref_s=data["t_ref_s"],
        t_end_s=data["t_end_s"],
        noise=tuple(data["noise"]),
        level=tuple(data["level"]),
        rms_over_noise=data["rms_over_noise"],
        warnings=tuple(data["warnings"]),
        modes=tuple(_mode(item) for item in data["modes"]),
        data=data,
        _core=core,
    )


def routes() -> list[dict[str, Any]]:
    """The equations of the paper that can be evaluated one by one.

    Returns:
        The ``name``, ``equation``, ``inputs`` and ``outputs`` of each; units are in the names.
    """
    return list(json.loads(_core.routes()))


def evaluate_route(name: str, inputs: Mapping[str, float]) -> dict[str, float]:
    """Evaluate one equation of the paper.

    Args:
        name: One of the names of ``routes()``.
        inputs: Values by name, in the unit that the name ends in.

    Returns:
        The outputs by name, in the unit that the name ends in.

    Raises:
        InputError: There is no such route, or an input is missing or impossible.
    """
    return _core.evaluate_route(name, {key: float(value) for key, value in inputs.items()})


def _mode(item: dict[str, Any]) -> Mode:
    omega = item["omega_rad_s"]
    period = 2.0 * np.pi / omega
    return Mode(
        period_s=period,
        period_se_s=period * item["omega_se_rad_s"] / omega,
        shape=np.array([complex(*pair) for pair in item["shape"]]),
        **{key: item[key] for key in ("omega_rad_s", "omega_se_rad_s")},
        **{key: item[key] for key in ("alpha_per_s", "alpha_se_per_s", "snr_db")},
    )


def _float64(values: ArrayLike) -> NDArray[np.float64]:
    return np.ascontiguousarray(values, dtype=np.float64)
