"""A measurement plan: views of the plan that the core writes.

Keys are spelled as in ``gyradius-plan/1``; a key that this version does not know is ignored here and kept in
``Plan.to_json()``, which gives the core's own bytes.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from . import _core
from .critique import NextSwing
from .measurement import BudgetLine
from .records import record, records
from .session import Session

FORMAT = "gyradius-plan/1"

#: A figure, or a figure with one standard uncertainty.
Figure = float | tuple[float, float]


@dataclass(frozen=True, slots=True)
class PlannedSwing:
    """A swing to be made."""

    id: str
    #: As in a session; each dimension has ``value`` and ``u``.
    suspension: Mapping[str, Any]
    #: What to set going: ``yaw``, ``sway``, ``surge``, ``pitch``, ``roll``.
    excited: tuple[str, ...]
    #: Amplitude at the release, degrees.
    amplitude_deg: float
    #: How long to record after the release, s.
    duration_s: float
    #: Small-amplitude period by mode, s.
    periods_s: Mapping[str, float]
    #: Relative standard uncertainty of the period that is enough.
    period_u_wanted: float


@dataclass(frozen=True, slots=True)
class PlannedIncline:
    """An incline test to be made."""

    #: Where the weight hangs: ``bow`` or ``stern``.
    end: str
    #: The weight, kg.
    mass_kg: float
    #: Horizontal distance from the suspension points to the weight's, m.
    arm_m: float
    #: Depth of the weight's suspension point below the hull's, m.
    depth_m: float
    #: The angle to expect, degrees.
    pitch_deg: float


@dataclass(frozen=True, slots=True)
class HangingAdvice:
    """One way to hang the hull."""

    #: Points of the square frame, as in Table 4 of the paper.
    frame_points: str
    #: As in a session; each dimension has ``value`` and ``u``.
    suspension: Mapping[str, Any]
    #: Names of the quantities that it determines.
    gives: tuple[str, ...]
    #: Ids of the swings that hang so.
    swings: tuple[str, ...]
    #: The same in a sentence.
    text: str


@dataclass(frozen=True, slots=True)
class Beat:
    """The beat of yaw against sway, eqs. (10) to (12)."""

    #: Beat period, s; None where yaw and sway keep step.
    period_s: float | None
    #: Oscillations in a beat; None where yaw and sway keep step.
    oscillations: float | None
    #: Period of the oscillation that beats, s.
    average_period_s: float


@dataclass(frozen=True, slots=True)
class PredictedSwing:
    """What a planned swing will show."""

    id: str
    #: Small-amplitude period by mode, s.
    periods_s: Mapping[str, float]
    #: By how much yaw and sway take longer at the amplitude of the release, parts per million.
    longer_at_release_ppm: Mapping[str, float]
    #: None where yaw and sway are not both set going.
    beat: Beat | None


@dataclass(frozen=True, slots=True)
class PredictedQuantity:
    """A quantity as it is assumed, and how well it will be known; its name tells the unit."""

    #: As it is assumed.
    value: float
    #: Standard uncertainty to expect; None where the swings will not determine it.
    u: float | None
    #: Standard uncertainty that is wanted; None where none is.
    wanted_u: float | None
    #: None where nothing is wanted.
    is_reached: bool | None


@dataclass(frozen=True, slots=True)
class PlanWarning:
    """What to know before the first swing."""

    #: Key of the sentence, such as ``yaw_near_in_phase`` or ``slack_line``.
    kind: str
    #: The swing that is meant; None where it is all of them.
    swing: str | None
    #: Numbers in the sentence.
    numbers: Mapping[str, float]
    #: Names in the sentence.
    names: Mapping[str, str]
    text: str


@dataclass(frozen=True)
class Plan:
    """What to do, and what it is expected to give."""

    format: str
    title: str
    #: The hull as it is assumed.
    hull: Mapping[str, Any]
    #: What is taken to be at hand: room, tape, sensors.
    means: Mapping[str, Any]
    #: Ways to hang the hull.
    suspensions: tuple[HangingAdvice, ...]
    #: What to do, in order.
    steps: tuple[PlannedSwing | PlannedIncline, ...]
    #: What each swing will show.
    predicted: tuple[PredictedSwing, ...]
    #: How well each quantity will be known, by name.
    quantities: Mapping[str, PredictedQuantity]
    #: What the uncertainty of each quantity will come from.
    budget: Mapping[str, tuple[BudgetLine, ...]]
    #: Line lengths, spacing and axis heights that would be best, m; None where there is none.
    optima: Mapping[str, float | None]
    #: Time that it takes, rigging included, s.
    effort_s: float
    #: The swing that tells two causes apart, where that was asked.
    tells_apart: NextSwing | None
    warnings: tuple[PlanWarning, ...]
    _core: _core.Plan

    def to_json(self) -> str:
        """The JSON text, byte for byte as the core writes it."""
        return self._core.to_json()

    def to_dict(self) -> dict[str, Any]:
        """The same as dictionaries and lists."""
        return dict(json.loads(self.to_json()))

    def session_toml(self) -> str:
        """The ``session.toml`` that the planned swings will fill."""
        return self._core.session_toml()

    def rig_toml(self) -> str:
        """A rig file that rehearses the plan (``gyradius.read_rig``, ``gyradius simulate``)."""
        return self._core.rig_toml()


def plan(
    session: Session | None = None,
    *,
    mass: float | None = None,
    length: float | None = None,
    beam: float | None = None,
    boat_type: str | None = None,
    k_yaw: Figure | None = None,
    k_pitch: Figure | None = None,
    k_roll: Figure | None = None,
    depth: Figure | None = None,
    psi: Figure | None = None,
    wanted: Iterable[str] = (),
    means: Mapping[str, Any] | None = None,
    title: str = "",
    tell_apart: tuple[str, str] | None = None,
    progress: Callable[[float, str], object] | None = None,
) -> Plan:
    """Recommend suspension, swings, amplitudes and durations, and predict periods, beat and uncertainties.

    The hull is described by mass, length, beam and type, or by its gyradii and the depth of its centre of mass, or by a
    session that has already measured it. A figure is a number, or a pair with its standard uncertainty.

    Args:
        session: A session that has already measured the hull.
        mass: kg, of everything that hangs.
        length: m, overall.
        beam: m, the largest.
        boat_type: ``keelboat``, ``dinghy``, ``model_keelboat`` or ``uniform_bar``.
        k_yaw: Yaw gyradius, m, where it is known.
        k_pitch: Pitch gyradius, m, where it is known.
        k_roll: Roll gyradius, m, where it is known.
        depth: m, of the centre of mass below the suspension points, where it is known.
        psi: Tilt of the principal axes, degrees, bow up, where it is known.
        wanted: Standard uncertainties such as ``"k_yaw=0.1%"`` or ``"psi=1deg"``.
        means: The equipment available, by the names of ``Plan.means``: ``most_line_length_m``, ``u_spacing_m``,
            ``amplitude_deg``, …
        title: What the plan is for.
        tell_apart: Two causes by the names of the criticism. The plan is then the one swing that would tell them apart
            for the session; this may take a minute.
        progress: Called with the completed fraction, 0 to 1, and the current task; returning False stops the work.

    Returns:
        What to do, and what to expect of it.

    Raises:
        InputError: Too little is known of the hull, or a figure is impossible.
        CancelledError: ``progress`` stopped the work.
    """
    hull = {
        "mass_kg": mass,
        "length_m": length,
        "beam_m": beam,
        "boat_type": boat_type,
        "k_yaw_m": _quantity(k_yaw),
        "k_pitch_m": _quantity(k_pitch),
        "k_roll_m": _quantity(k_roll),
        "cm_depth_m": _quantity(depth),
        "psi_deg": _quantity(psi),
    }
    request = json.dumps({"title": title, "hull": hull, "wanted": list(wanted), "means": dict(means or {})})
    if session is None:
        if tell_apart is not None:
            raise _core.InputError("tell_apart: a session was expected, found none")
        return view(_core.plan_swings(request))
    if tell_apart is not None:
        return view(session.core.plan_to_tell_apart(*tell_apart, request, progress))
    return view(session.core.plan(request))


def _quantity(figure: Figure | None) -> dict[str, float] | None:
    if figure is None:
        return None
    value, u = figure if isinstance(figure, tuple) else (figure, 0.0)
    return {"value": value, "u": u}


def view(core: _core.Plan) -> Plan:
    """The views over a plan of the core."""
    data = json.loads(core.to_json())
    following = data["tells_apart"]
    return Plan(
        format=data["format"],
        title=data["title"],
        hull=data["hull"],
        means=data["means"],
        suspensions=records(HangingAdvice, data["suspensions"]),
        steps=tuple(_step(item) for item in data["steps"]),
        predicted=tuple(_predicted(item) for item in data["predicted"]),
        quantities={name: record(PredictedQuantity, item) for name, item in data["quantities"].items()},
        budget={name: records(BudgetLine, lines) for name, lines in data["budget"].items()},
        optima=data["optima"],
        effort_s=data["effort_s"],
        tells_apart=record(NextSwing, following) if following else None,
        warnings=records(PlanWarning, data["warnings"]),
        _core=core,
    )


def _step(item: dict[str, Any]) -> PlannedSwing | PlannedIncline:
    if "swing" in item:
        return record(PlannedSwing, item["swing"])
    return record(PlannedIncline, item["incline"])


def _predicted(item: dict[str, Any]) -> PredictedSwing:
    beat = item["beat"]
    return record(PredictedSwing, {**item, "beat": record(Beat, beat) if beat else None})
