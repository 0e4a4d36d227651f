"""Sessions: a folder, a zip or a bare recording, and the results measured from it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _core
from . import critique as critiques
from .critique import Critique
from .matlab import is_matlab, tables
from .measurement import Measurement, view

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Session:
    """One hull, measured on one occasion; or one bare recording, which gives modes only."""

    def __init__(self, core: _core.Session) -> None:
        """Sessions come from ``gyradius.load``."""
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

        Args:
            limits: Class limits such as ``"k_pitch_m>=1.100"``, in the unit of the quantity; each gets a verdict.

        Returns:
            The result. A quantity that the swings do not determine is absent from it.

        Raises:
            NoResultError: The data do not allow any result.
        """
        return view(self._core.measure(list(limits)))

    def critique(self, progress: Callable[[float, str], object] | None = None, *, by_sets: bool = False) -> Critique:
        """Find what the simulation gets wrong, why, and what extending it gains; this may take minutes.

        Args:
            progress: Called with the completed fraction, 0 to 1, and the current task. It stops the work by returning
                False; Ctrl-C stops it too.
            by_sets: Weigh all sets of up to three causes at once, instead of one cause after another (experimental).

        Returns:
            Discrepancies, causes, verdict, the extended simulation and its gain.

        Raises:
            CancelledError: ``progress`` stopped the work.
            NoResultError: The session holds nothing that can be criticised.
        """
        return critiques.view(self._core.critique(progress, by_sets))

    def plot(self, swing_id: str | None = None, *, interactive: bool = False) -> Figure | Any:
        """Each recording with its fit, the residual and the spectrum.

        Args:
            swing_id: The swing to draw; all swings if omitted.
            interactive: With plotly (``pip install gyradius[interactive]``).

        Returns:
            A figure of matplotlib, or one of plotly.
        """
        return self.measure().plot(swing_id, interactive=interactive)

    def __repr__(self) -> str:
        """Title and swings."""
        return f"<gyradius.Session {self.title!r}, swings {', '.join(self.swing_ids)}>"


def load(path: str | os.PathLike[str], *, mapping: Iterable[str] = ()) -> Session:
    """Read a session folder, a session zip, or a bare recording in any format that can be imported.

    Args:
        path: Folder, zip or recording.
        mapping: Columns of a CSV that is not recognised, with their units, such as ``"gx=xGyro:deg/s"``.

    Returns:
        The session. One made from a bare recording gives modes only.

    Raises:
        InputError: Something in the file is wrong; ``file`` and ``line`` say where.
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
    """Where a session that comes with the package lies.

    Args:
        name: One of the names of ``shipped_sessions()``.

    Returns:
        The session's folder.

    Raises:
        InputError: There is no session of that name.
    """
    sessions = shipped_sessions()
    if name not in sessions:
        raise _core.InputError(f"session `{name}`: expected one of {', '.join(sessions) or 'none'}")
    return sessions[name]
