"""Phone exports into a session folder."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from . import _core
from .files import only_writer
from .matlab import readable

# A number, or a number with one standard uncertainty.
Stated = float | tuple[float, float]
Pair = tuple[float, float]
# How it hung: on two lines, on a fixed axis, on three lines; of a free one nothing is stated.
Kind = Literal["bifilar", "compound", "trifilar", "free"]

SESSION_FILE = "session.toml"

#: What may carry an uncertainty.
STATED = frozenset(
    (
        "mass",
        "gravity",
        "line_length",
        "spacing",
        "top_spacing",
        "radius",
        "top_radius",
        "hull_pitch",
        "points_moved",
        "axis_height",
    )
)


@dataclass(frozen=True)
class ImportPlan:
    """What is known of the session besides its recordings; lengths in m, each with its standard uncertainty."""

    mapping: list[str]
    trial: str | None = None
    platform: str | None = None
    flag_width: float | None = None
    replace: bool = False
    title: str = ""
    suspension: str | None = None
    orientation: str | None = None
    swing: str | None = None
    like: str | None = None
    mass: Pair | None = None
    gravity: Pair | None = None
    line_length: Pair | None = None
    spacing: Pair | None = None
    top_spacing: Pair | None = None
    radius: Pair | None = None
    top_radius: Pair | None = None
    hull_pitch: Pair | None = None
    points_moved: Pair | None = None
    axis_height: Pair | None = None


def import_files(
    files: Iterable[str | os.PathLike[str]],
    output: str | os.PathLike[str],
    *,
    mapping: Sequence[str] = (),
    trial: str | int | None = None,
    platform: Literal["android", "ios"] | None = None,
    flag_width: float | None = None,
    replace: bool = False,
    title: str = "",
    suspension: Kind | None = None,
    orientation: Literal["athwartships", "fore_and_aft"] | None = None,
    mass: Stated | None = None,
    gravity: Stated | None = None,
    line_length: Stated | None = None,
    spacing: Stated | None = None,
    top_spacing: Stated | None = None,
    radius: Stated | None = None,
    top_radius: Stated | None = None,
    hull_pitch: Stated | None = None,
    points_moved: Stated | None = None,
    axis_height: Stated | None = None,
) -> list[str]:
    """Write a session folder from phone exports, one swing for each file.

    A stated figure is a number, or a pair with its standard uncertainty in the same unit.

    Args:
        files: The exports.
        output: The session folder to write.
        mapping: Columns of a CSV that is not recognised, with their units, such as ``"gx=xGyro:deg/s"``.
        trial: One of several trials in a file, as the file numbers or names them.
        platform: The phone's system, where a file's signs depend on it and the file does not say.
        flag_width: m, of the flag in a light gate's beam.
        replace: Write over files that are there.
        title: The session's title; the folder's name where it is left out.
        suspension: How it hung; on two lines where it is left out.
        orientation: What joins the points, or the axis; athwartships where it is left out.
        mass: kg, of everything that swings.
        gravity: m/s².
        line_length: m, of the lines.
        spacing: m, between the points on the hull.
        top_spacing: m, between the points above; as ``spacing`` where it is left out.
        radius: m, of the circle through the line ends below (three lines).
        top_radius: m, of the circle through the line ends above (three lines).
        hull_pitch: Degrees, bow up.
        points_moved: m, of the points, forward from those of a level hanging.
        axis_height: m, of the axis above the hull's suspension points (fixed axis).

    Returns:
        What a reader must know, a sentence each.

    Raises:
        InputError: A file cannot be read, or files are there already.
    """
    plan = ImportPlan(
        mapping=[*mapping],
        trial=None if trial is None else str(trial),
        platform=platform,
        flag_width=flag_width,
        replace=replace,
        title=title or Path(output).name,
        suspension=suspension,
        orientation=orientation,
        mass=pair(mass),
        gravity=pair(gravity),
        line_length=pair(line_length),
        spacing=pair(spacing),
        top_spacing=pair(top_spacing),
        radius=pair(radius),
        top_radius=pair(top_radius),
        hull_pitch=pair(hull_pitch),
        points_moved=pair(points_moved),
        axis_height=pair(axis_height),
    )
    with readable(files) as found, only_writer(Path(output)):
        return [*found.not_used, *_core.import_files(found.paths, os.fspath(output), plan)]


def import_into(
    files: Iterable[str | os.PathLike[str]],
    session: str | os.PathLike[str],
    *,
    swing: str | None = None,
    like: str | None = None,
    mapping: Sequence[str] = (),
    trial: str | int | None = None,
    platform: Literal["android", "ios"] | None = None,
    flag_width: float | None = None,
    suspension: Kind | None = None,
    orientation: Literal["athwartships", "fore_and_aft"] | None = None,
    line_length: Stated | None = None,
    spacing: Stated | None = None,
    top_spacing: Stated | None = None,
    radius: Stated | None = None,
    top_radius: Stated | None = None,
    hull_pitch: Stated | None = None,
    points_moved: Stated | None = None,
    axis_height: Stated | None = None,
) -> list[str]:
    """Add phone exports to an existing session folder, one new swing for each.

    Nothing that the session holds is dropped. A swing that the session has without its recording (from a plan) gets
    the recording of its name, or the one that is imported with its id as ``swing``; dimensions that are stated take the
    place of the planned ones. What is stated holds for all of ``files``: files that hung otherwise are imported by
    another call. A stated figure is a number, or a pair with its standard uncertainty in the same unit.

    Args:
        files: The exports.
        session: The session folder.
        swing: Id of the planned swing that the file is the recording of.
        like: Id of a swing that the new ones hung like, but for what is stated.
        mapping: Columns of a CSV that is not recognised, with their units.
        trial: One of several trials in a file.
        platform: The phone's system, where a file's signs depend on it and the file does not say.
        flag_width: m, of the flag in a light gate's beam.
        suspension: How it hung.
        orientation: What joins the points, or the axis.
        line_length: m, of the lines.
        spacing: m, between the points on the hull.
        top_spacing: m, between the points above; as ``spacing`` where it is left out.
        radius: m, of the circle through the line ends below (three lines).
        top_radius: m, of the circle through the line ends above (three lines).
        hull_pitch: Degrees, bow up.
        points_moved: m, of the points, forward from those of a level hanging.
        axis_height: m, of the axis above the hull's suspension points (fixed axis).

    Returns:
        What a reader must know, a sentence each.

    Raises:
        InputError: A file cannot be read, or the session holds the same samples already.
    """
    plan = ImportPlan(
        mapping=[*mapping],
        trial=None if trial is None else str(trial),
        platform=platform,
        flag_width=flag_width,
        suspension=suspension,
        orientation=orientation,
        swing=swing,
        like=like,
        line_length=pair(line_length),
        spacing=pair(spacing),
        top_spacing=pair(top_spacing),
        radius=pair(radius),
        top_radius=pair(top_radius),
        hull_pitch=pair(hull_pitch),
        points_moved=pair(points_moved),
        axis_height=pair(axis_height),
    )
    folder = Path(session)
    folder = folder.parent if folder.name == SESSION_FILE else folder
    # The core says what is wrong with a folder that is not there; it is not made.
    lock = only_writer(folder) if folder.is_dir() else nullcontext()
    with readable(files) as found, lock:
        return [*found.not_used, *_core.import_into(found.paths, os.fspath(session), plan)]


def describe_exports(files: Iterable[str | os.PathLike[str]], plan: ImportPlan) -> list[str]:
    """What exports hold, what an import would note, and the command for it, line by line; nothing is written.

    A table that is not recognised is an error that proposes a mapping.
    """
    with readable(files) as found:
        lines = _core.describe_exports(found.paths, plan)
        return [*found.not_used, *(found.renamed(line) for line in lines)]


def pair(stated: Stated | None) -> Pair | None:
    """A figure as the core takes it."""
    if stated is None:
        return None
    # NaN: nobody stated one, and the session is written without.
    return (float(stated[0]), float(stated[1])) if isinstance(stated, tuple) else (float(stated), math.nan)
