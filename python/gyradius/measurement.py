"""The result of a session as plain data: views over the JSON that the core writes.

Keys are spelled as in ``gyradius-measurement/1``; a key that this version does not know is ignored here and kept in
``Measurement.to_json()``, which gives the core's own bytes.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from .records import frozen, record, records

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from .critique import Critique

FORMAT = "gyradius-measurement/1"


@dataclass(frozen=True, slots=True)
class AmplitudePoint:
    """Period and decay at one amplitude."""

    t_s: float
    amplitude: float
    period_s: float
    period_se_s: float
    decrement: float
    decrement_se: float


@dataclass(frozen=True, slots=True)
class ModeResult:
    """One mode of one swing."""

    mode: str
    period_s: float
    period_se_s: float
    period_observed_s: float
    decay_time_s: float | None
    decay_time_se_s: float | None
    amplitude: float | None
    amplitude_unit: str
    relative_db: float
    parasitic: bool
    doubtful: bool
    against_amplitude: tuple[AmplitudePoint, ...]


@dataclass(frozen=True, slots=True)
class Repair:
    """One kind of damage of one sensor: how often, where first and last, what was done."""

    kind: str
    sensor: str
    count: int
    first_s: float
    last_s: float
    text: str


@dataclass(frozen=True, slots=True)
class Modulation:
    """What a second motion does to a list of periods, eq. (14): C exp(−t/τ_m) sin(2π t/T_m + φ_m), s."""

    c_s: float
    c_se_s: float
    t_m_s: float
    t_m_se_s: float
    tau_m_s: float | None
    phase_rad: float


@dataclass(frozen=True, slots=True)
class PeriodTrend:
    """A list of periods against time, eq. (14): T_0 (1 + b t) and the modulation, s; t from the first entry."""

    t0_s: float
    t0_se_s: float
    b_per_s: float
    b_se_per_s: float
    scatter_s: float
    modulation: Modulation | None = None


@dataclass(frozen=True, slots=True)
class OneMotion:
    """A swing as one motion, f(θ) = θ + κ (sin θ − θ): κ, α (1/s), b (1/rad) and c (rad/s²)."""

    hardness: float
    hardness_se: float
    damping_per_s: float
    damping_per_s_se: float | None
    drag_per_rad: float
    drag_per_rad_se: float | None
    friction_rad_s2: float
    friction_rad_s2_se: float | None


@dataclass(frozen=True, slots=True)
class SwingResult:
    """One swing's modes, strongest first."""

    id: str
    modes: tuple[ModeResult, ...]
    repairs: tuple[Repair, ...]
    warnings: tuple[str, ...]
    span_s: tuple[float, float] | None
    rms_over_noise: float | None
    simulated: bool
    trend: PeriodTrend | None = None
    motion: OneMotion | None = None


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity with one standard uncertainty; vectors and matrices are nested tuples."""

    value: Any
    u: Any
    method: str
    interval_95: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class Route:
    """A closed-form estimate of a quantity."""

    method: str
    value: float
    u: float
    interval_95: tuple[float, float]
    equation: str
    # `from` in the JSON, which is a word of the language here.
    sources: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class BudgetLine:
    """What one input contributes to the uncertainty of a quantity."""

    input: str
    u_contribution: float


@dataclass(frozen=True, slots=True)
class Claim:
    """One stated dimension or closed-form estimate compared with what the rest of the session implies."""

    claim: str
    stated: float
    stated_u: float
    implied: float
    implied_u: float
    sigma: float
    # `from` in the JSON, which is a word of the language here.
    source: str
    flagged: bool
    text: str
    # Of routes: how many pairs of swings stand behind this, the worst, and their range in sigmas.
    pairs: int = 1
    sigma_range: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class Verdict:
    """A guard-banded verdict against a class limit."""

    quantity: str
    relation: str
    limit: float
    guard_band: float
    conformance_probability: float
    verdict: str


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that is implausible, or that the data cannot determine.

    ``severity`` is ``noted``, ``warned``, ``widened`` or ``refused``: what is refused is not stated.
    """

    kind: str
    severity: str
    swing: str | None
    channel: str | None
    numbers: Mapping[str, float]
    text: str
    advice: str


@dataclass(frozen=True, repr=False)
class Measurement:
    """The result of a session.

    ::

        measurement = gyradius.load("yngling").measure()
        k = measurement.quantities["k_yaw_m"]
        k.value, k.u, k.interval_95  # m, one standard uncertainty, 95 %

    Units are in the names (``k_yaw_m``); axes are x forward, y to port, z up. ``quantities`` holds what the swings
    determine, ``budget`` the contributions to each uncertainty, ``swings`` the modes, ``consistency`` the tests of the
    stated dimensions, ``findings`` what is implausible. ``plot`` and ``to_html`` show it, ``to_dict``, ``to_frame``,
    ``to_csv`` and ``to_xlsx`` hand it on, ``to_urdf``, ``to_mjcf`` and ``to_sdf`` give the hull to a simulator.
    """

    format: str
    title: str
    swings: tuple[SwingResult, ...]
    quantities: Mapping[str, Quantity]
    alternatives: Mapping[str, tuple[Route, ...]]
    budget: Mapping[str, tuple[BudgetLine, ...]]
    correlations: tuple[tuple[str, str, float], ...]
    consistency: tuple[Claim, ...]
    verdicts: tuple[Verdict, ...]
    findings: tuple[Finding, ...]
    warnings: tuple[str, ...]
    _core: _core.Measurement

    def to_json(self, critique: Critique | None = None) -> str:
        """The JSON text, byte for byte as the core writes it.

        If the same session's criticism is given, the verdicts take it into account, as in the report.
        """
        return self._core.to_json() if critique is None else self._core.to_json(critique._core)

    def to_html(self, critique: Critique | str | None = None, language: str = "en") -> str:
        """The report: one self-contained HTML file.

        ``critique`` is the same session's criticism, or the reason why there is none; ``language`` is ``en`` or ``de``.
        """
        if critique is None or isinstance(critique, str):
            return self._core.to_html(None, critique, language)
        return self._core.to_html(critique._core, None, language)

    def to_dict(self) -> dict[str, Any]:
        """What ``to_json`` writes, as dictionaries and lists."""
        return dict(json.loads(self.to_json()))

    def to_frame(self, table: str = "quantities") -> pd.DataFrame:
        """A table as a data frame (``pip install gyradius[pandas]``).

        ``table`` is ``quantities`` (a row for each scalar: name, element of a vector or matrix, value, u, low_95,
        high_95, unit, method), ``modes`` (a row for each mode of each swing), ``budget``, ``consistency`` or
        ``findings``.
        """
        from .datatables import frame

        return frame(self, table)

    def to_csv(self, path: str | os.PathLike[str], table: str = "quantities") -> None:
        """Write a table of ``to_frame`` as a CSV file; needs no pandas."""
        from .datatables import write_csv

        write_csv(self, path, table)

    def to_xlsx(self, path: str | os.PathLike[str]) -> None:
        """Write all tables of ``to_frame`` as an Excel workbook, a sheet each (``pip install gyradius[xlsx]``)."""
        from .datatables import write_workbook

        write_workbook(self, path)

    def to_urdf(self, *, model: bool = False) -> str:
        """The hull alone as ``<inertial>`` of URDF; with ``model`` as a robot of one link.

        Mass in kg, inertia about the centre of mass in kg m², along hull axes, whose origin is the mid-point of the
        suspension points. Comments say what is not known. Raises ``NoResultError`` where the swings do not determine
        the inertia, or the session does not state the mass.
        """
        from .inertial import urdf

        return urdf(self, model=model)

    def to_mjcf(self, *, model: bool = False) -> str:
        """The same as ``<inertial>`` of MuJoCo's XML; with ``model`` as a model of one free body."""
        from .inertial import mjcf

        return mjcf(self, model=model)

    def to_sdf(self, *, model: bool = False) -> str:
        """The same as ``<inertial>`` of SDFormat (Gazebo); with ``model`` as a model of one link."""
        from .inertial import sdf

        return sdf(self, model=model)

    @property
    def recorded_swings(self) -> list[str]:
        """Ids of the swings that have a recording with a fit."""
        return self._core.recorded_swings

    def fits(
        self, swing_id: str
    ) -> list[tuple[list[str], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]]:
        """By sensor: names of the channels, time stamps (n), samples (channels, n) and the fit (channels, n)."""
        return self._core.fits(swing_id)

    def spectrum(self, swing_id: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Frequencies, Hz (n), and amplitudes (channels, n), thinned for plots."""
        return self._core.spectrum(swing_id)

    def plot(self, swing_id: str | None = None, *, interactive: bool = False) -> Figure | Any:
        """Each recording with its fit, the residual and the spectrum (one swing, or all).

        A figure of matplotlib, or with ``interactive`` one of plotly (``pip install gyradius[interactive]``).
        """
        if interactive:
            from .interactive import figure as zoomable

            return zoomable(self, [swing_id] if swing_id else [])
        from .plots import figure

        return figure(self, [swing_id] if swing_id else [])

    def __repr__(self) -> str:
        """Title and scalar quantities in one line."""
        from .notebook import figures, short_text

        return short_text("Measurement", self.title, figures(self.quantities) or ["no quantity determined"])

    def _repr_html_(self) -> str:
        from .notebook import measurement_html

        return measurement_html(self)


def view(core: _core.Measurement) -> Measurement:
    """The views over a measurement of the core."""
    data = json.loads(core.to_json())
    return Measurement(
        format=data["format"],
        title=data["title"],
        swings=tuple(_swing(item) for item in data["swings"]),
        quantities={name: record(Quantity, item) for name, item in data["quantities"].items()},
        alternatives={name: tuple(map(_route, items)) for name, items in data["alternatives"].items()},
        budget={name: records(BudgetLine, items) for name, items in data["budget"].items()},
        correlations=frozen(data["correlations"]),
        consistency=tuple(record(Claim, {**item, "source": item["from"]}) for item in data["consistency"]),
        verdicts=records(Verdict, data["verdicts"]),
        findings=records(Finding, data["findings"]),
        warnings=tuple(data["warnings"]),
        _core=core,
    )


def _swing(item: dict[str, Any]) -> SwingResult:
    modes = tuple(_mode(mode) for mode in item["modes"])
    parts = {"modes": modes, "repairs": records(Repair, item["repairs"]), "trend": _trend(item.get("trend"))}
    motion = item.get("motion")
    return record(SwingResult, {**item, **parts, "motion": motion and record(OneMotion, motion)})


def _trend(item: dict[str, Any] | None) -> PeriodTrend | None:
    if item is None:
        return None
    modulation = item.get("modulation")
    return record(PeriodTrend, {**item, "modulation": modulation and record(Modulation, modulation)})


def _mode(item: dict[str, Any]) -> ModeResult:
    return record(ModeResult, {**item, "against_amplitude": records(AmplitudePoint, item["against_amplitude"])})


def _route(item: dict[str, Any]) -> Route:
    return record(Route, {**item, "sources": item["from"]})
