"""Inertia of a hull hung on two lines, from the recordings of a phone that swings with it.

>>> import gyradius
>>> session = gyradius.load(gyradius.shipped_session("keelboat"))
>>> measurement = session.measure(limits=["k_pitch_m>=1.100"])
>>> measurement.quantities["k_yaw_m"].value  # doctest: +SKIP

The science is in the Rust core; this package converts, prints and draws.
"""

from __future__ import annotations

# Nothing is loaded here: the command must hear Ctrl-C while numpy and all else loads.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

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
    from .imports import import_files, import_into
    from .live import Live
    from .measurement import (
        AmplitudePoint,
        BudgetLine,
        Claim,
        Finding,
        Measurement,
        ModeResult,
        Modulation,
        OneMotion,
        PeriodTrend,
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
    "Modulation",
    "NextSwing",
    "NoResultError",
    "OneMotion",
    "ParameterResult",
    "PeriodTrend",
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
    "import_into",
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

# Each module is loaded when a name of it is first used.
_MODULES = {
    "_core": ("CancelledError", "GyradiusError", "InputError", "NoResultError", "__version__"),
    "arrays": ("Decomposition", "Mode", "decompose", "evaluate_route", "routes"),
    "critique": (
        "CauseResult",
        "CauseVerdict",
        "Critique",
        "Discrepancy",
        "Gain",
        "LearnedForce",
        "ModelResult",
        "NextSwing",
        "ParameterResult",
        "SwingTrace",
    ),
    "imports": ("import_files", "import_into"),
    "live": ("Live",),
    "measurement": (
        "AmplitudePoint",
        "BudgetLine",
        "Claim",
        "Finding",
        "Measurement",
        "ModeResult",
        "Modulation",
        "OneMotion",
        "PeriodTrend",
        "Quantity",
        "Repair",
        "Route",
        "SwingResult",
        "Verdict",
    ),
    "planning": (
        "Beat",
        "HangingAdvice",
        "Plan",
        "PlannedIncline",
        "PlannedSwing",
        "PlanWarning",
        "PredictedQuantity",
        "PredictedSwing",
        "plan",
    ),
    "practice": ("Practice",),
    "recorder": ("RecordedSamples", "RecordedSensor", "RecorderFile", "read_recorder"),
    "session": ("Session", "load", "shipped_session", "shipped_sessions"),
    "simulation": ("Rig", "Simulation", "read_rig", "shipped_rigs", "simulate"),
}
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> Any:
    """A public name, or a module of the package, when it is first used."""
    from importlib import import_module

    if name in _MODULE_OF:
        found = getattr(import_module(f".{_MODULE_OF[name]}", __name__), name)
        globals()[name] = found
        return found
    if name in _MODULES:
        return import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """Public names, loaded or not."""
    return sorted({*globals(), *__all__})
