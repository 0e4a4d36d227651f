"""What the simulation gets wrong, why, and what mending it gains: views over the JSON that the core writes.

Keys are spelled as in ``gyradius-critique/1``; a key that this version does not know is ignored here and kept in
``Critique.to_json()``, which gives the core's own bytes.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from .measurement import Finding, Quantity
from .records import record, records

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMAT = "gyradius-critique/1"


@dataclass(frozen=True, slots=True)
class ModelResult:
    """A simulation fitted to the session: residual over noise, of the samples fitted and of those held out."""

    rms_over_noise: float | None
    heldout_rms_over_noise: float | None
    quantities: Mapping[str, Quantity]


@dataclass(frozen=True, slots=True)
class Discrepancy:
    """One thing that the base simulation gets wrong; ``swing`` is empty for what shows between swings."""

    swing: str
    what: str
    size: float
    unit: str
    sigma: float
    text: str


@dataclass(frozen=True, slots=True)
class ParameterResult:
    """A fitted parameter of a cause."""

    value: float | None
    u: float | None
    unit: str


@dataclass(frozen=True, slots=True)
class CauseResult:
    """A cause that was tried; ``taken`` where the extended simulation has it."""

    id: str
    probability: float
    log_evidence_gain: float
    parameters: Mapping[str, ParameterResult]
    text: str = ""
    taken: bool = False


@dataclass(frozen=True, slots=True)
class NextSwing:
    """The swing that would tell the causes in doubt apart, by ``sigma`` standard deviations, else hung as ``like``."""

    line_length_m: float
    spacing_m: float
    excited: tuple[str, ...]
    amplitude_deg: float
    duration_s: float
    hull_pitch_deg: float
    sigma: float
    text: str
    like: str = ""


@dataclass(frozen=True, slots=True)
class CauseVerdict:
    """``adequate``, ``explained``, ``ambiguous`` or ``unexplained``, and what follows."""

    status: str
    causes: tuple[str, ...]
    indistinguishable_from: tuple[str, ...]
    next_swing: NextSwing | None
    text: str = ""


@dataclass(frozen=True, slots=True)
class Gain:
    """What the extended simulation gains over the base one."""

    heldout_rms_ratio: float | None
    log_score_per_sample: float | None
    k_yaw_shift_m: float | None
    shifts: Mapping[str, float | None]


@dataclass(frozen=True, slots=True)
class LearnedForce:
    """A force learned from the data: ``points`` are rows of position, rate, time, force and its uncertainty."""

    coordinate: str
    unit: str
    points: tuple[tuple[float, float, float, float, float], ...]
    equation: str
    text: str
    heldout_rms_over_noise: float | None
    closed_heldout_rms_over_noise: float | None


@dataclass(frozen=True, slots=True)
class SwingTrace:
    """Samples of a swing's most telling channel against both simulations; all arrays have one length."""

    swing: str
    channel: str
    unit: str
    noise: float
    #: Times from the start of the part analysed, s.
    t_s: NDArray[np.float64]
    measured: NDArray[np.float64]
    base: NDArray[np.float64]
    extended: NDArray[np.float64]


@dataclass(frozen=True)
class Critique:
    """What the simulation gets wrong, why, and what mending it gains."""

    format: str
    title: str
    baseline: ModelResult
    discrepancies: tuple[Discrepancy, ...]
    causes: tuple[CauseResult, ...]
    verdict: CauseVerdict
    extended: ModelResult
    gain: Gain
    learned: LearnedForce | None
    findings: tuple[Finding, ...]
    warnings: tuple[str, ...]
    _core: _core.Criticism

    def to_json(self) -> str:
        """The JSON text, byte for byte as the core writes it."""
        return self._core.to_json()

    def to_dict(self) -> dict[str, Any]:
        """The same as dictionaries and lists."""
        return dict(json.loads(self.to_json()))

    @property
    def traces(self) -> tuple[SwingTrace, ...]:
        """Each swing that was fitted against both simulations."""
        found = self._core.traces()
        return tuple(SwingTrace(swing, channel, unit, noise, *arrays) for swing, channel, unit, noise, arrays in found)

    def plot(self, swing_id: str | None = None) -> Figure:
        """Each swing against both simulations, and what they leave in units of the noise (one swing, or all)."""
        from .plots import residuals

        return residuals(self, [swing_id] if swing_id else [])


def view(core: _core.Criticism) -> Critique:
    """The views over a criticism of the core."""
    data = json.loads(core.to_json())
    learned = data.get("learned")
    return Critique(
        format=data["format"],
        title=data["title"],
        baseline=_model(data["baseline"]),
        discrepancies=records(Discrepancy, data["discrepancies"]),
        causes=tuple(_cause(item) for item in data["causes"]),
        verdict=_verdict(data["verdict"]),
        extended=_model(data["extended"]),
        gain=record(Gain, data["gain"]),
        learned=record(LearnedForce, learned) if learned else None,
        findings=records(Finding, data["findings"]),
        warnings=tuple(data["warnings"]),
        _core=core,
    )


def _model(item: dict[str, Any]) -> ModelResult:
    quantities = {name: record(Quantity, quantity) for name, quantity in item["quantities"].items()}
    return record(ModelResult, {**item, "quantities": quantities})


def _cause(item: dict[str, Any]) -> CauseResult:
    parameters = {name: record(ParameterResult, parameter) for name, parameter in item["parameters"].items()}
    return record(CauseResult, {**item, "parameters": parameters})


def _verdict(item: dict[str, Any]) -> CauseVerdict:
    following = item["next_swing"]
    return record(CauseVerdict, {**item, "next_swing": record(NextSwing, following) if following else None})
