"""What the simulation gets wrong, why, and what extending it gains: views of the JSON that the core writes.

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
    """A simulation fitted to the session."""

    #: Root mean square of the residual over the noise, of the samples that were fitted.
    rms_over_noise: float | None
    #: The same of samples that took no part in the fit.
    heldout_rms_over_noise: float | None
    #: Results under this simulation, by name.
    quantities: Mapping[str, Quantity]


@dataclass(frozen=True, slots=True)
class Discrepancy:
    """One thing that the base simulation gets wrong."""

    #: Id of the swing; empty for what shows between swings.
    swing: str
    #: Key of what it is.
    what: str
    #: How large it is, in ``unit``.
    size: float
    unit: str
    #: How clear it is, in standard deviations.
    sigma: float
    #: The same in a sentence.
    text: str


@dataclass(frozen=True, slots=True)
class ParameterResult:
    """A fitted parameter of a cause."""

    #: Value, in ``unit``.
    value: float | None
    #: Its standard uncertainty, in ``unit``.
    u: float | None
    unit: str


@dataclass(frozen=True, slots=True)
class CauseResult:
    """A cause that was tried."""

    #: Name of the cause, such as ``quadratic_drag``.
    id: str
    #: Probability that it is there, 0 to 1.
    probability: float
    #: Gain of the natural logarithm of the evidence over the simulation without it.
    log_evidence_gain: float
    #: Its fitted parameters, by name.
    parameters: Mapping[str, ParameterResult]
    #: The same in a sentence.
    text: str = ""
    #: Whether the extended simulation has it.
    taken: bool = False


@dataclass(frozen=True, slots=True)
class NextSwing:
    """The swing that would tell the causes in doubt apart."""

    #: Length of the lines, m.
    line_length_m: float
    #: Spacing of the points on the hull, m.
    spacing_m: float
    #: What to set going.
    excited: tuple[str, ...]
    #: Amplitude at the release, degrees.
    amplitude_deg: float
    #: How long to record after the release, s.
    duration_s: float
    #: Pitch of the hull, degrees, bow up.
    hull_pitch_deg: float
    #: By how many standard deviations the causes will then differ.
    sigma: float
    #: The same in a sentence.
    text: str
    #: Id of the swing that it hangs like, but for what stands above.
    like: str = ""


@dataclass(frozen=True, slots=True)
class CauseVerdict:
    """What the criticism concludes."""

    #: ``adequate``, ``explained``, ``ambiguous`` or ``unexplained``.
    status: str
    #: Names of the causes; ``unknown`` for what no known cause accounts for.
    causes: tuple[str, ...]
    #: Causes that the data cannot tell from the one named.
    indistinguishable_from: tuple[str, ...]
    #: The swing that would decide, where the data cannot.
    next_swing: NextSwing | None
    #: The same in a sentence.
    text: str = ""


@dataclass(frozen=True, slots=True)
class Gain:
    """What the extended simulation gains over the base one."""

    #: Held-out residual of the base simulation over that of the extended one.
    heldout_rms_ratio: float | None
    #: Gain of the logarithmic score of held-out samples, for each sample.
    log_score_per_sample: float | None
    #: By how much the yaw gyradius moves, m.
    k_yaw_shift_m: float | None
    #: By how much each quantity moves, by name, in the unit that the name ends in.
    shifts: Mapping[str, float | None]


@dataclass(frozen=True, slots=True)
class LearnedForce:
    """A force learned from the data."""

    #: The coordinate that it acts on.
    coordinate: str
    #: Unit of the force.
    unit: str
    #: Rows of position, rate, time, force and the standard uncertainty of the force.
    points: tuple[tuple[float, float, float, float, float], ...]
    #: The simplest closed form that does as well.
    equation: str
    #: The same in a sentence.
    text: str
    #: Held-out residual over noise, with the force as it was learned.
    heldout_rms_over_noise: float | None
    #: The same with the closed form.
    closed_heldout_rms_over_noise: float | None


@dataclass(frozen=True, slots=True)
class SwingTrace:
    """Samples of a swing's most telling channel against both simulations; all arrays have one length, N."""

    #: Id of the swing.
    swing: str
    #: The channel that is shown.
    channel: str
    #: Unit of the samples.
    unit: str
    #: Noise of one sample, in ``unit``.
    noise: float
    #: Times from the start of the part analysed, s (N).
    t_s: NDArray[np.float64]
    #: Samples, in ``unit`` (N).
    measured: NDArray[np.float64]
    #: The base simulation, in ``unit`` (N).
    base: NDArray[np.float64]
    #: The extended simulation, in ``unit`` (N).
    extended: NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class Critique:
    """What the simulation gets wrong, why, and what extending it gains: ``gyradius.load("yngling").critique()``.

    ``verdict`` names the causes, ``causes`` are all that were tried, with their probabilities. ``baseline`` and
    ``extended`` hold the quantities without and with the causes named; ``discrepancies`` is what the base simulation
    gets wrong. ``plot`` and ``Measurement.to_html(critique)`` show it; ``to_dict`` gives its data.
    """

    format: str
    title: str
    #: The simulation without any cause.
    baseline: ModelResult
    #: What the base simulation gets wrong, the clearest first.
    discrepancies: tuple[Discrepancy, ...]
    #: What was tried, the most probable first.
    causes: tuple[CauseResult, ...]
    #: What it comes to.
    verdict: CauseVerdict
    #: The simulation with the causes that were named.
    extended: ModelResult
    #: What the extended simulation gains.
    gain: Gain
    #: The force learned from the data; None where none was needed.
    learned: LearnedForce | None
    #: What is not plausible in the data.
    findings: tuple[Finding, ...]
    #: What a reader must know.
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

    def plot(self, swing_id: str | None = None, *, interactive: bool = False) -> Figure | Any:
        """Each swing against both simulations, and their residuals in units of the noise.

        Args:
            swing_id: The swing to draw; all swings if omitted.
            interactive: With plotly (``pip install gyradius[interactive]``).

        Returns:
            A figure of matplotlib, or one of plotly.
        """
        if interactive:
            from .interactive import residuals as zoomable

            return zoomable(self, [swing_id] if swing_id else [])
        from .plots import residuals

        return residuals(self, [swing_id] if swing_id else [])

    def __repr__(self) -> str:
        """Title, verdict and causes in one line."""
        from .notebook import short_text

        return short_text("Critique", self.title, [self.verdict.status, *self.verdict.causes])

    def _repr_html_(self) -> str:
        from .notebook import critique_html

        return critique_html(self)


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
