"""The native module: thin conversions around the Rust core."""

from collections.abc import Callable
from typing import final

import numpy as np
from numpy.typing import NDArray

from .imports import ImportPlan

__all__ = [
    "CancelledError",
    "Criticism",
    "Decomposition",
    "GyradiusError",
    "InputError",
    "Live",
    "Measurement",
    "NoResultError",
    "Plan",
    "Practice",
    "RecorderFile",
    "Rig",
    "Session",
    "Simulation",
    "__version__",
    "decompose",
    "evaluate_route",
    "import_files",
    "load",
    "plan_swings",
    "read_recorder",
    "read_rig",
    "routes",
    "silence_panics",
]

__version__: str

class GyradiusError(ValueError):
    """What went wrong, with its `file` and `line`."""

    file: str | None
    line: int | None

class InputError(GyradiusError):
    """The input cannot be read or used."""

class NoResultError(GyradiusError):
    """The data do not allow a result."""

class CancelledError(GyradiusError):
    """The work was stopped by whoever watched it."""

@final
class Session:
    """A session with its recordings."""

    @property
    def title(self) -> str: ...
    @property
    def swing_ids(self) -> list[str]: ...
    def measure(self, limits: list[str]) -> Measurement: ...
    def critique(self, progress: Callable[[float, str], object] | None = None) -> Criticism: ...
    def plan(self, request: str) -> Plan: ...
    def plan_to_tell_apart(
        self, one: str, other: str, request: str, progress: Callable[[float, str], object] | None = None
    ) -> Plan: ...

@final
class Measurement:
    """The result of a session, as the core made it."""

    def to_json(self) -> str: ...
    def to_html(self, critique: Criticism | None, no_critique: str | None, language: str) -> str: ...
    @property
    def recorded_swings(self) -> list[str]: ...
    def fits(
        self, swing_id: str
    ) -> list[tuple[list[str], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]]: ...
    def spectrum(self, swing_id: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

@final
class Criticism:
    """What the simulation gets wrong, as the core made it."""

    @staticmethod
    def from_json(critique: str, traces: str) -> Criticism: ...
    def to_json(self) -> str: ...
    def traces(self) -> list[tuple[str, str, str, float, list[NDArray[np.float64]]]]: ...

@final
class Plan:
    """What to do, and what it is expected to give, as the core made it."""

    def to_json(self) -> str: ...
    def session_toml(self) -> str: ...
    def rig_toml(self) -> str: ...

@final
class Live:
    """What is known while a hull swings, from the samples so far."""

    def __new__(
        cls,
        wanted: float,
        gyroscope_full_scale: float | None = None,
        accelerometer_full_scale: float | None = None,
    ) -> Live: ...
    def push(self, sensor: str, stamps_ns: NDArray[np.int64], values: NDArray[np.float64]) -> None: ...
    def estimate(self) -> str: ...
    def advice(self) -> list[str]: ...

@final
class RecorderFile:
    """All of a recorder's file."""

    @property
    def phone(self) -> str: ...
    @property
    def notes(self) -> list[tuple[str, str]]: ...
    @property
    def sensors(self) -> list[tuple[str, str, float | None]]: ...
    @property
    def events(self) -> list[tuple[int, str]]: ...
    @property
    def damage(self) -> list[str]: ...
    def tracks(self) -> list[tuple[str, NDArray[np.int64], NDArray[np.float64]]]: ...

@final
class Practice:
    """A procedure on a simulated hull."""

    def __new__(cls, rig: Rig, folder: str, seed: int, resume: bool) -> Practice: ...
    def state(self) -> str: ...
    def handle(self, event: str) -> None: ...
    def advance(self, seconds: float) -> float: ...
    def by_the_book(self, at_utc: str) -> str | None: ...
    def mishap(self, step: str, take: int, what: str) -> None: ...
    def work(self, progress: Callable[[float, str], object] | None = None) -> None: ...
    def truth(self) -> dict[str, float]: ...

@final
class Decomposition:
    """The damped oscillations of a record."""

    def to_json(self) -> str: ...
    def evaluate(self, t_s: NDArray[np.float64]) -> NDArray[np.float64]: ...

@final
class Rig:
    """What a rig file says."""

    @property
    def swing_ids(self) -> list[str]: ...
    def numbers(self, swing: str) -> list[tuple[str, float, str]]: ...
    def simulate(
        self,
        swing: str,
        values: list[tuple[str, float]],
        derivatives: list[str],
        t_s: NDArray[np.float64] | None,
        seed: int | None,
    ) -> Simulation: ...
    def write(self, folder: str, truth_file: str, seed: int, replace: bool) -> None: ...

@final
class Simulation:
    """A simulated swing."""

    @property
    def t_s(self) -> NDArray[np.float64]: ...
    @property
    def readings(self) -> NDArray[np.float64]: ...
    @property
    def derivatives(self) -> NDArray[np.float64]: ...
    @property
    def position_m(self) -> NDArray[np.float64]: ...
    @property
    def attitude(self) -> NDArray[np.float64]: ...
    @property
    def velocity_m_s(self) -> NDArray[np.float64]: ...
    @property
    def rate_rad_s(self) -> NDArray[np.float64]: ...
    @property
    def acceleration_m_s2(self) -> NDArray[np.float64]: ...
    @property
    def angular_acceleration_rad_s2(self) -> NDArray[np.float64]: ...
    @property
    def slack(self) -> tuple[float, int] | None: ...

def silence_panics() -> None: ...
def load(path: str, mapping: list[str]) -> Session: ...
def plan_swings(request: str) -> Plan: ...
def read_recorder(path: str) -> RecorderFile: ...
def read_rig(path: str, text: str | None = None) -> Rig: ...
def decompose(t_s: NDArray[np.float64], channels: list[NDArray[np.float64]]) -> Decomposition: ...
def routes() -> str: ...
def evaluate_route(name: str, inputs: dict[str, float]) -> dict[str, float]: ...
def import_files(files: list[str], folder: str, plan: ImportPlan) -> list[str]: ...
