"""The whole procedure on a simulated hull: what the command ``practise`` plays."""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Callable
from datetime import datetime, timezone
from typing import Any

from . import _core
from .simulation import Rig

# Quantities that are compared with what is true, by the name that the rig tells it by, and what they are called.
COMPARED = {
    "k_yaw_m": ("yaw gyradius", "m"),
    "k_pitch_m": ("pitch gyradius", "m"),
    "k_roll_m": ("roll gyradius", "m"),
    "cm_depth_m": ("depth of the centre of mass", "m"),
    "psi_deg": ("principal axis, bow up", "°"),
}


class Practice:
    """A procedure on a simulated hull and phone: hang it, let it swing, judge, measure.

    Time passes only in ``advance``; the same rig, seed and events give the same session.
    """

    def __init__(
        self, rig: Rig, folder: str | os.PathLike[str], *, seed: int | None = None, resume: bool = False
    ) -> None:
        """Begin in a folder, or go on there with what was left.

        Args:
            rig: The hull and what is planned for it; its swings are the steps.
            folder: Where the journal, the recordings and the session go.
            seed: Of all chance; one is drawn where it is left out.
            resume: Go on with what is in the folder.
        """
        self.seed = secrets.randbits(32) if seed is None else seed
        self._core = _core.Practice(rig._core, os.fspath(folder), self.seed, resume)

    @property
    def state(self) -> dict[str, Any]:
        """Everything that a screen shows: ``phase``, ``instruction``, ``actions``, ``recording``, ``judgement`` …"""
        return dict(json.loads(self._core.state()))

    def handle(self, event: str, **data: Any) -> None:
        """Report what the operator did.

        Args:
            event: One of ``state["actions"]``.
            data: What the event carries, by name.

        Raises:
            InputError: The event is not possible now; the message says which are.
        """
        self._core.handle(json.dumps({"event": event, **data}))

    def advance(self, seconds: float) -> float:
        """Let time pass.

        Args:
            seconds: How long, s.

        Returns:
            The time that passed, s; zero while nothing reads the phone.
        """
        return self._core.advance(seconds)

    def by_the_book(self) -> dict[str, Any] | None:
        """What a careful operator does now; None while time has to pass or work has to be done."""
        event = self._core.by_the_book(datetime.now(timezone.utc).isoformat(timespec="seconds"))
        return None if event is None else dict(json.loads(event))

    def mishap(self, step: str, take: int, what: str) -> None:
        """Make something go wrong.

        Args:
            step: Id of the step.
            take: Number of the recording of that step, from 1.
            what: ``bad_release``, ``sway``, ``touch``, ``slip`` or ``silence``.
        """
        self._core.mishap(step, take, what)

    def work(self, progress: Callable[[float, str], object] | None = None) -> None:
        """Do the work that ``state["work"]`` names: measure (seconds) or criticise (minutes).

        Args:
            progress: Called with the fraction that is done, 0 to 1, and what is being done; False stops it.
        """
        self._core.work(progress)

    @property
    def truth(self) -> dict[str, float]:
        """The true values of the hull, by name, in the unit that the name ends in."""
        return self._core.truth()

    def compared(self) -> list[dict[str, Any]]:
        """Every measured figure beside the true one.

        Returns:
            Rows with ``name``, ``title``, ``unit``, ``value``, ``u``, ``true`` and ``sigma``, the difference in
            standard uncertainties.
        """
        result = self.state["result"] or {"quantities": {}}
        truth, rows = self.truth, []
        for name, (title, unit) in COMPARED.items():
            quantity = result["quantities"].get(name)
            if quantity is None or name not in truth:
                continue
            value, u, true = quantity["value"], quantity["u"], truth[name]
            sigma = (value - true) / u if u > 0 else None
            rows.append(
                {"name": name, "title": title, "unit": unit, "value": value, "u": u, "true": true, "sigma": sigma}
            )
        return rows
