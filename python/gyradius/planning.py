"""What to do before anything swings: views over the plan that the core writes.

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
    """A swing to be made; ``suspension`` as in a session, each dimension with ``value`` and ``u``."""

    id: str
    suspension: Mapping[str, Any]
    excited: tuple[str, ...]
    amplitude_deg: float
    duration_s: float
    periods_s: Mapping[str, float]
    #: Relative standard uncertainty of the period that is enough.
    period_u_wanted: float


@dataclass(frozen=True, slots=True)
class PlannedIncline:
    """An incline test to be made."""

    end: str
    mass_kg: float
    arm_m: float
    depth_m: float
    pitch_deg: float


@dataclass(frozen=True, slots=True)
class HangingAdvice:
    """One way to hang the hull: points of the square frame (Table 4 of the paper) and dimensions."""

    frame_points: str
    suspension: Mapping[str, Any]
    gives: tuple[str, ...]
    swings: tuple[str, ...]
    text: str


@dataclass(frozen=True, slots=True)
class Beat:
    """The beat of yaw against sway; without a period where they keep step."""

    period_s: float | None
    oscillations: float | None
    average_period_s: float


@dataclass(frozen=True, slots=True)
class PredictedSwing:
    """What a planned swing will show."""

    id: str
    periods_s: Mapping[str, float]
    longer_at_release_ppm: Mapping[str, float]
    beat: Beat | None


@dataclass(frozen=True, slots=True)
class PredictedQuantity:
    """A quantity as it is assumed, and how well it will be known; ``u`` is None where it will not be determined."""

    value: float
    u: float | None
    wanted_u: float | None
    is_reached: bool | None


@dataclass(frozen=True, slots=True)
class PlanWarning:
    """What to know before the first swing; ``kind`` is the key of the sentence."""

    kind: str
    swing: str | None
    numbers: Mapping[str, float]
    names: Mapping[str, str]
    text: str


@dataclass(frozen=True)
class Plan:
    """What to do, and what it is expected to give."""

    format: str
    title: str
    hull: Mapping[str, Any]
    means: Mapping[str, Any]
    suspensions: tuple[HangingAdvice, ...]
    steps: tuple[PlannedSwing | PlannedIncline, ...]
    predicted: tuple[PredictedSwing, ...]
    quantities: Mapping[str, PredictedQuantity]
    budget: Mapping[str, tuple[BudgetLine, ...]]
    optima: Mapping[str, float | None]
    effort_s: float
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
        """A rig file that rehearses the plan (:func:`gyradius.read_rig`, ``gyradius simulate``)."""
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

    The hull is told by ``mass`` (kg, everything that hangs), ``length`` and ``beam`` (m) and a ``boat_type`` (keelboat,
    dinghy, model_keelboat, uniform_bar), or by its gyradii and the depth of its centre of mass (m, each a number or a
    pair with its standard uncertainty); or by a ``session`` that measured it so far. ``wanted`` are standard
    uncertainties such as ``"k_yaw=0.1%"`` or ``"psi=1deg"``. ``means`` replaces what is taken to be at hand, by the
    names of ``Plan.means`` (``most_line_length_m``, ``u_spacing_m``, ``amplitude_deg``, …).

    With ``tell_apart``, two causes by the names of the criticism, the plan is the one swing that would tell them apart
    for the ``session``; this may take a minute, is told to ``progress`` and can be stopped as ``Session.critique`` can.
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
