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
from .dialogue import QUESTIONS, Dialogue, position
from .first_session import FORMAT as NEW
from .first_session import REPORT, Known, Recordings, check_before, made_json, make_session, open_in_browser
from .outcome import end_without_result, reason_without_result, reported, write_json
from .summary import show_summary, show_swings
from .tasks import loaded, measured, write_report


def new(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Recordings exported from phones and loggers.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="The session folder (default: named after the first file)."),
    ] = None,
    title: Annotated[str, typer.Option(help="The session's title.")] = "",
    suspension: Annotated[Suspension | None, typer.Option(help="How the body hung.")] = None,
    orientation: Annotated[
        Orientation | None, typer.Option(help="Direction of the line that joins the points.")
    ] = None,
    line_length: Annotated[str | None, stated("metres", "")] = None,
    spacing: Annotated[str | None, stated("metres", "between the points on the body")] = None,
    top_spacing: Annotated[str | None, stated("metres", "between the points above")] = None,
    radius: Annotated[str | None, stated("metres", "of the circle through the lower line ends (trifilar)")] = None,
    top_radius: Annotated[str | None, stated("metres", "of the circle through the upper line ends (trifilar)")] = None,
    axis_height: Annotated[str | None, stated("metres", "of the swing axis (compound)")] = None,
    hull_pitch: Annotated[str | None, stated("degrees", "bow up")] = None,
    mass: Annotated[str | None, stated("kilograms", "everything that swings, phone included")] = None,
    gravity: Annotated[str | None, stated("m/s²", "at the place")] = None,
    phone_mass: Annotated[str | None, stated("kilograms", "taken off the result")] = None,
    phone_position: Annotated[
        str | None,
        typer.Option(metavar='"X Y Z"', help="Metres forward, to port and up from the middle of the points."),
    ] = None,
    map_: Map = None,
    trial: Annotated[str | None, typer.Option(metavar="K", help="One of several trials in a file.")] = None,
    platform: Annotated[Platform | None, typer.Option(help="The phone's system, if a file does not say.")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Overwrite existing files.")] = False,
    ask: Annotated[
        bool, typer.Option("--ask/--no-ask", help="Ask for figures that are not stated (on a terminal).")
    ] = True,
    show: Annotated[bool, typer.Option("--open/--no-open", help="Open the report (on a terminal).")] = True,
    json: Json = None,
) -> None:
    """Make a session from recordings: ask for what is needed, measure it, open the report.

    Figures stated by options are not asked for. All FILEs share one suspension; the tilt of each is asked for.
    """
    with reported(error_console(), json, NEW):
        stated_texts = dict(
            line_length=line_length,
            spacing=spacing,
            top_spacing=top_spacing,
            radius=radius,
            top_radius=top_radius,
            axis_height=axis_height,
            hull_pitch=hull_pitch,
            mass=mass,
            gravity=gravity,
            phone_mass=phone_mass,
        )
        known = Known(
            suspension=None if suspension is None else suspension.value,
            orientation=None if orientation is None else orientation.value,
            figures={
                name: given(QUESTIONS[name].option, text, QUESTIONS[name].of) for name, text in stated_texts.items()
            },
            phone_position_m=_place(phone_position),
        )
        recordings = Recordings(tuple(files), tuple(map_ or ()), trial, None if platform is None else platform.value)
        folder = output or Path(Path(files[0]).stem)
        has_terminal = is_terminal(json)
        console = output_console(json)
        is_asked = ask and has_terminal
        check_before(recordings, folder, known, is_asked, replace)
        dialogue = Dialogue(_prompt if is_asked else None, lambda line: console.print(line, soft_wrap=True))
        session, notes = make_session(dialogue, recordings, folder, known, title=title or folder.name, replace=replace)
        for note in notes:
            console.print(f"  note: {note}", soft_wrap=True)
        measurement = measured(session)
        console.print("Found:")
        show_swings(console, measurement)
        show_summary(console, measurement, f"gyradius measure {folder} -v")
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
    """Check a session for what is missing, implausible or weak; takes seconds."""
    with reported(error_console(), json, CHECK):
        measurement = measured(loaded(session, map_))
        if json is not None:
            write_json(check_json(measurement), json)
        show_check(output_console(json), measurement)
        reason = reason_without_result(measurement)
        if reason is not None:
            end_without_result(error_console(), reason)


def is_terminal(json: str | None) -> bool:
    """Whether a user can be asked questions and shown results."""
    return sys.stdin.isatty() and sys.stdout.isatty() and json != "-"


def _place(text: str | None) -> tuple[float, float, float] | None:
    if text is None:
        return None
    try:
        return position(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="--phone-position") from None


def _prompt(words: str) -> str:
    try:
        answer: str = typer.prompt(words, default="", show_default=False)
    except typer.Abort:
        # The end of the input, by Ctrl-D: nobody answers any more.
        raise KeyboardInterrupt from None
    return answer
