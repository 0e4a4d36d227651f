"""The command ``gyradius import``."""

from __future__ import annotations

from json import dumps
from pathlib import Path
from typing import Annotated, Any

import typer

from . import _core
from .arguments import Json, Map, Orientation, Platform, Suspension, plain_value, stated, stated_value
from .console import error_console, output_console
from .imports import STATED, ImportPlan, describe_exports, import_files, import_into, pair
from .interrupt import heard_during
from .outcome import reported, write_json


def import_(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Exports of phones and loggers.")],
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="DIR", help="The session folder to write; without it, only describe FILEs."
        ),
    ] = None,
    into: Annotated[
        Path | None, typer.Option(metavar="SESSION", help="Add the swings to this existing session folder.")
    ] = None,
    swing: Annotated[
        str | None, typer.Option(metavar="ID", help="With --into: the planned swing that FILE records.")
    ] = None,
    like: Annotated[
        str | None,
        typer.Option(metavar="ID", help="With --into: same suspension as this swing, except what is stated."),
    ] = None,
    map_: Map = None,
    trial: Annotated[str | None, typer.Option(metavar="K", help="One of several trials in a file.")] = None,
    platform: Annotated[Platform | None, typer.Option(help="The phone's system, if a file does not say.")] = None,
    flag_width: Annotated[
        str | None, typer.Option(metavar="M", help="Width of the flag that breaks a light gate's beam.")
    ] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Overwrite existing files.")] = False,
    title: Annotated[str, typer.Option(help="The session's title.")] = "",
    suspension: Annotated[Suspension | None, typer.Option(help="How all FILEs hung (bifilar).")] = None,
    orientation: Annotated[Orientation | None, typer.Option(help="What joins the points (athwartships).")] = None,
    mass: Annotated[str | None, stated("kilograms", "everything that swings")] = None,
    gravity: Annotated[str | None, stated("m/s²", "")] = None,
    line_length: Annotated[str | None, stated("metres", "")] = None,
    spacing: Annotated[str | None, stated("metres", "between the points on the hull")] = None,
    top_spacing: Annotated[str | None, stated("metres", "between the points above")] = None,
    radius: Annotated[str | None, stated("metres", "of the circle through the lower line ends (trifilar)")] = None,
    top_radius: Annotated[str | None, stated("metres", "of the circle through the upper line ends (trifilar)")] = None,
    hull_pitch: Annotated[str | None, stated("degrees", "bow up")] = None,
    points_moved: Annotated[str | None, stated("metres", "of the points, forward of their place when level")] = None,
    axis_height: Annotated[str | None, stated("metres", "of the swing axis (compound)")] = None,
    json: Json = None,
) -> None:
    """Write a session from phone exports, add them to one, or say what they hold.

    Options apply to all FILEs: import swings on another suspension separately, with --into.
    """
    with reported(error_console(), json):
        of_session: dict[str, object] = {"--replace": replace, "--title": title, "--mass": mass, "--gravity": gravity}
        _refuse_options(output, into, {"--swing": swing, "--like": like}, of_session)
        known: dict[str, Any] = {
            "mapping": map_ or [],
            "trial": trial,
            "platform": None if platform is None else platform.value,
            "flag_width": plain_value("--flag-width", flag_width, "metres"),
            "suspension": None if suspension is None else suspension.value,
            "orientation": None if orientation is None else orientation.value,
            "line_length": stated_value("--line-length", line_length, "metres"),
            "spacing": stated_value("--spacing", spacing, "metres"),
            "top_spacing": stated_value("--top-spacing", top_spacing, "metres"),
            "radius": stated_value("--radius", radius, "metres"),
            "top_radius": stated_value("--top-radius", top_radius, "metres"),
            "hull_pitch": stated_value("--hull-pitch", hull_pitch, "degrees"),
            "points_moved": stated_value("--points-moved", points_moved, "metres"),
            "axis_height": stated_value("--axis-height", axis_height, "metres"),
        }
        new: dict[str, Any] = {
            "mass": stated_value("--mass", mass, "kilograms"),
            "gravity": stated_value("--gravity", gravity, "m/s²"),
            "title": title,
            "replace": replace,
        }
        if output is None and into is None:
            plan = ImportPlan(**{name: _paired(name, value) for name, value in (known | new).items()})
            found = heard_during(describe_exports, files, plan)
            if json is not None:
                write_json(dumps({"found": found}, ensure_ascii=False, indent=2), json)
            for line in found:
                output_console(json).print(line, soft_wrap=True)
            return
        if into is not None:
            notes = heard_during(import_into, files, into, swing=swing, like=like, **known)
        else:
            notes = heard_during(import_files, files, output, **known, **new)
        written = output if into is None else into
        if json is not None:
            write_json(dumps({"session": str(written), "notes": notes}, ensure_ascii=False, indent=2), json)
        for note in notes:
            output_console(json).print(f"  note: {note}", soft_wrap=True)
        output_console(json).print(f"Session: {written}", soft_wrap=True)


def _paired(name: str, value: Any) -> Any:
    return pair(value) if name in STATED else value


def _refuse_options(
    output: Path | None, into: Path | None, of_into: dict[str, object], of_output: dict[str, object]
) -> None:
    """Refuse options of a new session for one that is there, and the other way round."""
    if output is not None and into is not None:
        raise _core.InputError("--into: cannot be used together with -o, which writes a new session")
    wrong = of_into if into is None else of_output
    for name, value in wrong.items():
        if value:
            reason = "--into is missing" if into is None else "cannot be used with --into; the session keeps its own"
            raise _core.InputError(f"{name}: {reason}")
