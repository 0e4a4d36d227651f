"""Inertia of a hull hung on two lines, from the recordings of a phone that swings with it.

>>> import gyradius
>>> session = gyradius.load(gyradius.shipped_session("keelboat"))
>>> measurement = session.measure(limits=["k_pitch_m>=1.100"])
>>> measurement.quantities["k_yaw_m"].value  # doctest: +SKIP

The science is in the Rust core; this package converts, prints and draws.
"""

from ._core import CancelledError, GyradiusError, InputError, NoResultError, __version__
from .arrays import Decomposition, Mode, decompose, evaluate_route, routes
from .critique import (
    CauseResult,
    CauseVerdict,
    Critique,
    Discrepancy,
    Gain,
    LearnedForce,
    ModelResult,
    NextSwing,
    ParameterResult,
    SwingTrace,
)
from .imports import import_files
from .live import Live
from .measurement import (
    AmplitudePoint,
    BudgetLine,
    Claim,
    Finding,
    Measurement,
    ModeResult,
    Quantity,
    Repair,
    Route,
    SwingResult,
    Verdict,
)
from .planning import (
    Beat,
    HangingAdvice,
    Plan,
    PlannedIncline,
    PlannedSwing,
    PlanWarning,
    PredictedQuantity,
    PredictedSwing,
    plan,
)
from .practice import Practice
from .recorder import RecordedSamples, RecordedSensor, RecorderFile, read_recorder
from .session import Session, load, shipped_session, shipped_sessions
from .simulation import Rig, Simulation, read_rig, shipped_rigs, simulate

__all__ = [
    "AmplitudePoint",
    "Beat",
    "BudgetLine",
    "CancelledError",
    "CauseResult",
    "CauseVerdict",
    "Claim",
    "Critique",
    "Decomposition",
    "Discrepancy",
    "Finding",
    "Gain",
    "GyradiusError",
    "HangingAdvice",
    "InputError",
    "LearnedForce",
    "Live",
    "Measurement",
    "Mode",
    "ModeResult",
    "ModelResult",
    "NextSwing",
    "NoResultError",
    "ParameterResult",
    "Plan",
    "PlanWarning",
    "PlannedIncline",
    "PlannedSwing",
    "Practice",
    "PredictedQuantity",
    "PredictedSwing",
    "Quantity",
    "RecordedSamples",
    "RecordedSensor",
    "RecorderFile",
    "Repair",
    "Rig",
    "Route",
    "Session",
    "Simulation",
    "SwingResult",
    "SwingTrace",
    "Verdict",
    "__version__",
    "decompose",
    "evaluate_route",
    "import_files",
    "load",
    "plan",
    "read_recorder",
    "read_rig",
    "routes",
    "shipped_rigs",
    "shipped_session",
    "shipped_sessions",
    "simulate",
]
