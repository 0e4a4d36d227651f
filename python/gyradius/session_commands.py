"""The commands ``gyradius new`` and ``gyradius check``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from .arguments import Json, Map, Orientation, Platform, SessionPath, Suspension, given, stated
from .checking import FORMAT as CHECK
from .checking import check_json, show_check
from .console import error_console, output_console
from .dialogue import MASS, OPTIONAL, PHONE_MASS, REQUIRED, Dialogue, position
from .first_session import REPORT, Known, Recordings, made_json, make_session, open_in_browser
from .outcome import end_without_result, reason_without_result, reported, write_json
from .summary import show_summary, show_swings
from .tasks import loaded, measured, write_report

FIGURES = {one.name: one for kinds in (REQUIRED, OPTIONAL) for kind in kinds.values() for one in kind}
FIGURES |= {one.name: one for one in (MASS, PHONE_MASS)}


def new(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Recordings: exports of phones and loggers.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="The session folder (named after the first file)."),
    ] = None,
    title: Annotated[str, typer.Option(help="The session's title.")] = "",
    suspension: Annotated[Suspension | None, typer.Option(help="How it hung.")] = None,
    orientation: Annotated[Orientation | None, typer.Option(help="What joins the points.")] = None,
    line_length: Annotated[str | None, stated("metres", "")] = None,
    spacing: Annotated[str | None, stated("metres", "between the points on the body")] = None,
    top_spacing: Annotated[str | None, stated("metres", "between the points above")] = None,
    radius: Annotated[str | None, stated("metres", "of the circle through the line ends below (trifilar)")] = None,
    top_radius: Annotated[str | None, stated("metres", "of the circle above (trifilar)")] = None,
    axis_height: Annotated[str | None, stated("metres", "of the swing axis (compound)")] = None,
    hull_pitch: Annotated[str | None, stated("degrees", "bow up")] = None,
    mass: Annotated[str | None, stated("kilograms", "everything that swings, the phone too")] = None,
    phone_mass: Annotated[str | None, stated("kilograms", "taken off the result")] = None,
    phone_position: Annotated[
        str | None, typer.Option(metavar='"X Y Z"', help="Forward, to port, up from the middle of the points, metres.")
    ] = None,
    map_: Map = None,
    trial: Annotated[str | None, typer.Option(metavar="K", help="One of several trials in a file.")] = None,
    platform: Annotated[Platform | None, typer.Option(help="The phone's system, where a file does not say.")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Write over files that are there.")] = False,
    ask: Annotated[bool, typer.Option("--ask/--no-ask", help="Ask for what is not stated (on a terminal).")] = True,
    show: Annotated[bool, typer.Option("--open/--no-open", help="Open the report (on a terminal).")] = True,
    json: Json = None,
) -> None:
    """From recordings to a result: ask what is needed, write the session, measure it, open the report.

    What is stated by options is not asked. Recordings of the same hanging go together; the tilt of each is asked for.
    """
    with reported(error_console(), json):
        stated_texts = dict(
            line_length=line_length,
            spacing=spacing,
            top_spacing=top_spacing,
            radius=radius,
            top_radius=top_radius,
            axis_height=axis_height,
            hull_pitch=hull_pitch,
            mass=mass,
            phone_mass=phone_mass,
        )
        known = Known(
            suspension=None if suspension is None else suspension.value,
            orientation=None if orientation is None else orientation.value,
            figures={name: given(FIGURES[name].option, text, FIGURES[name].of) for name, text in stated_texts.items()},
            phone_position_m=_place(phone_position),
        )
        recordings = Recordings(tuple(files), tuple(map_ or ()), trial, None if platform is None else platform.value)
        folder = output or Path(Path(files[0]).stem)
        has_terminal = is_terminal(json)
        console = output_console(json)
        dialogue = Dialogue(_prompt if ask and has_terminal else None, lambda line: console.print(line, soft_wrap=True))
        notes = make_session(dialogue, recordings, folder, known, title=title or folder.name, replace=replace)
        for note in notes:
            console.print(f"  note: {note}", soft_wrap=True)
        measurement = measured(loaded(str(folder)))
        console.print("Found:")
        show_swings(console, measurement)
        show_summary(console, measurement)
        report = folder / REPORT
        write_report(measurement, report)
        if json is not None:
            write_json(made_json(folder, report, notes, measurement.to_json()), json)
        for name, path in (("Session", folder), ("Report", report)):
            console.print(f"{name}: {path}", soft_wrap=True)
        if show and has_terminal:
            open_in_browser(report)
        reason = reason_without_result(measurement)
        if reason is not None:
            end_without_result(error_console(), reason)


def check(session: SessionPath, json: Json = None, map_: Map = None) -> None:
    """What is missing, implausible or weak, before a long run or a report."""
    with reported(error_console(), json, CHECK):
        measurement = measured(loaded(session, map_))
        if json is not None:
            write_json(check_json(measurement), json)
        show_check(output_console(json), measurement)
        reason = reason_without_result(measurement)
        if reason is not None:
            end_without_result(error_console(), reason)


def is_terminal(json: str | None) -> bool:
    """Whether somebody can be asked, and shown something."""
    return sys.stdin.isatty() and sys.stdout.isatty() and json != "-"


def _place(text: str | None) -> tuple[float, float, float] | None:
    if text is None:
        return None
    try:
        return position(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="--phone-position") from None


def _prompt(words: str) -> str:
    answer: str = typer.prompt(words, default="", show_default=False)
    return answer
