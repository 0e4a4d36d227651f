"""The core on arrays: oscillations in any record, and the paper's routes one by one."""

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

    period_s: float
    period_se_s: float
    omega_rad_s: float
    omega_se_rad_s: float
    alpha_per_s: float
    alpha_se_per_s: float
    shape: NDArray[np.complex128]
    snr_db: float


@dataclass(frozen=True)
class Decomposition:
    """The damped oscillations of a record.

    Channel c is ``level[c] + Re Σ shape[c] · exp((−α + iω)(t − t_ref_s))`` where period and decay do not depend on
    the amplitude; ``data`` is everything the core gives, amplitude laws and combination tones included.
    """

    t_ref_s: float
    t_end_s: float
    modes: tuple[Mode, ...]
    noise: tuple[float, ...]
    level: tuple[float, ...]
    rms_over_noise: float
    warnings: tuple[str, ...]
    data: Mapping[str, Any]
    _core: _core.Decomposition

    def evaluate(self, t_s: ArrayLike) -> NDArray[np.float64]:
        """The fitted oscillations at any times, without the baseline: one row per channel."""
        return self._core.evaluate(_float64(t_s))


def decompose(t_s: ArrayLike, channels: Sequence[ArrayLike]) -> Decomposition:
    """Find the damped oscillations of channels that share one clock.

    Arrays that are contiguous float64 cross without a copy.
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
    """The routes of the paper: name, equation, inputs with units, outputs."""
    return list(json.loads(_core.routes()))


def evaluate_route(name: str, inputs: Mapping[str, float]) -> dict[str, float]:
    """One route of the paper for given inputs."""
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
