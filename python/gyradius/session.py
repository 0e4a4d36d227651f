"""Sessions: a folder, a zip or a bare recording, and what is measured from it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from . import _core
from . import critique as critiques
from .critique import Critique
from .matlab import is_matlab, tables
from .measurement import Measurement, view

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Session:
    """One hull, measured in one sitting; or one bare recording, which gives modes alone."""

    def __init__(self, core: _core.Session) -> None:
        """Sessions come from :func:`load`."""
        self._core = core

    @property
    def core(self) -> _core.Session:
        """The session as the native module holds it."""
        return self._core

    @property
    def title(self) -> str:
        """The session's title, or the recording's name."""
        return self._core.title

    @property
    def swing_ids(self) -> list[str]:
        """Ids of the swings in session order."""
        return self._core.swing_ids

    def measure(self, limits: Iterable[str] = ()) -> Measurement:
        """Modes, inertia, uncertainty and consistency.

        ``limits`` are class limits such as ``"k_pitch_m>=1.100"``, each of which gets a verdict.
        """
        return view(self._core.measure(list(limits)))

    def critique(self, progress: Callable[[float, str], object] | None = None, *, by_sets: bool = False) -> Critique:
        """What the simulation gets wrong, why, and what mending it gains.

        This may take minutes. ``progress`` is told the share that is done and what is being done, and stops the work by
        answering False (``CancelledError``); Ctrl-C stops it too. ``by_sets`` weighs all sets of up to three causes at
        once, instead of looking for one cause after another; it is being tried.
        """
        return critiques.view(self._core.critique(progress, by_sets))

    def plot(self, swing_id: str | None = None) -> Figure:
        """Each recording with its fit, the residual and the spectrum (one swing, or all)."""
        return self.measure().plot(swing_id)

    def __repr__(self) -> str:
        """Title and swings."""
        return f"<gyradius.Session {self.title!r}, swings {', '.join(self.swing_ids)}>"


def load(path: str | os.PathLike[str], *, mapping: Iterable[str] = ()) -> Session:
    """Read a session folder, a session zip, or a bare recording in any format that can be imported.

    ``mapping`` names the columns of a CSV that is not recognised: ``"gx=xGyro:deg/s"``.
    """
    file = os.fspath(path)
    if is_matlab(file):
        return Session(_core.load_tables(file, tables(file)[0], list(mapping)))
    return Session(_core.load(file, list(mapping)))


def shipped_sessions() -> dict[str, Path]:
    """The sessions that come with the package, by name."""
    folder = Path(str(resources.files("gyradius"))) / "sessions"
    found = sorted(path.parent for path in folder.glob("*/session.toml"))
    return {path.name: path for path in found}


def shipped_session(name: str) -> Path:
    """Where a session that comes with the package lies."""
    sessions = shipped_sessions()
    if name not in sessions:
        raise _core.InputError(f"session `{name}`: expected one of {', '.join(sessions) or 'none'}")
    return sessions[name]
