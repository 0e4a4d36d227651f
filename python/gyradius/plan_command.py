"""The command ``gyradius plan``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from . import _core
from .arguments import Json, exact_value, given, plain_value, stated, with_uncertainty
from .console import error_console, output_console
from .files import can_be_written, write_whole
from .interrupt import heard_during
from .outcome import reported, write_json
from .plan_tables import show_plan
from .planning import FORMAT as PLAN
from .planning import plan as make_plan
from .progress import counted
from .tasks import loaded


def plan(
    session: Annotated[
        str | None, typer.Argument(metavar="[SESSION]", help="A session that has already measured the hull.")
    ] = None,
    mass: Annotated[str | None, typer.Option(metavar="KG", help="Mass of everything that hangs.")] = None,
    length: Annotated[str | None, typer.Option(metavar="M", help="Length overall.")] = None,
    beam: Annotated[str | None, typer.Option(metavar="M", help="Largest beam.")] = None,
    type_: Annotated[
        str | None, typer.Option("--type", metavar="TYPE", help="keelboat, dinghy, model_keelboat or uniform_bar.")
    ] = None,
    k_yaw: Annotated[str | None, stated("metres", "where known")] = None,
    k_pitch: Annotated[str | None, stated("metres", "where known")] = None,
    k_roll: Annotated[str | None, stated("metres", "where known")] = None,
    depth: Annotated[str | None, stated("metres", "of the centre of mass below the points, where known")] = None,
    wanted: Annotated[
        list[str] | None,
        typer.Option(
            metavar="QUANTITY=U", help="Wanted u, such as k_yaw=0.1%, k_pitch=2mm, depth=5mm, psi=1deg; repeatable."
        ),
    ] = None,
    max_height: Annotated[str | None, typer.Option(metavar="M", help="Height available for the lines (3).")] = None,
    max_spacing: Annotated[
        str | None, typer.Option(metavar="M", help="Largest distance between the points (1.25 beams).")
    ] = None,
    u_line_length: Annotated[
        str | None, typer.Option(metavar="M", help="Uncertainty of the line length (0.003).")
    ] = None,
    u_spacing: Annotated[str | None, typer.Option(metavar="M", help="Uncertainty of the spacing (0.001).")] = None,
    amplitude: Annotated[str | None, typer.Option(metavar="DEG", help="Amplitude of a release (5).")] = None,
    gravity: Annotated[str | None, stated("m/s²", "default: 9.80665:0.015")] = None,
    tell_apart: Annotated[
        str | None,
        typer.Option(metavar="CAUSE,CAUSE", help="Plan the swing that tells two causes of `critique` apart."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write a session.toml to fill in.")
    ] = None,
    rig: Annotated[Path | None, typer.Option(metavar="FILE", help="Write a rig file to rehearse with.")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Overwrite existing files.")] = False,
    title: Annotated[str, typer.Option(help="What the plan is for.")] = "",
    json: Json = None,
) -> None:
    """Plan the suspensions and swings for a wanted uncertainty; warns of resonances."""
    with reported(error_console(), json, PLAN):
        for file in (output, rig):
            if file is not None:
                _can_be_made(file, replace)
        means = {
            "most_line_length_m": plain_value("--max-height", max_height, "metres"),
            "most_spacing_m": plain_value("--max-spacing", max_spacing, "metres"),
            "u_line_length_m": plain_value("--u-line-length", u_line_length, "metres"),
            "u_spacing_m": plain_value("--u-spacing", u_spacing, "metres"),
            "amplitude_deg": plain_value("--amplitude", amplitude, "degrees"),
            "gravity_m_s2": with_uncertainty(given("--gravity", gravity, "m/s²")),
        }
        known = None if session is None else loaded(session)
        with counted(error_console(), "planning") as told:
            found = heard_during(
                make_plan,
                known,
                mass=plain_value("--mass", mass, "kilograms"),
                length=plain_value("--length", length, "metres"),
                beam=plain_value("--beam", beam, "metres"),
                boat_type=type_,
                k_yaw=exact_value("--k-yaw", k_yaw, "metres"),
                k_pitch=exact_value("--k-pitch", k_pitch, "metres"),
                k_roll=exact_value("--k-roll", k_roll, "metres"),
                depth=exact_value("--depth", depth, "metres"),
                wanted=wanted or [],
                means={name: value for name, value in means.items() if value is not None},
                title=title,
                tell_apart=_two(tell_apart),
                progress=told,
            )
        if output is not None:
            write_whole(output, found.session_toml())
        if rig is not None:
            write_whole(rig, found.rig_toml())
        if json is not None:
            write_json(found.to_json(), json)
        console = output_console(json)
        show_plan(console, found)
        for name, file in (("Session to fill in", output), ("Rig", rig)):
            if file is not None:
                console.print(f"{name}: {file}", soft_wrap=True)


def _two(text: str | None) -> tuple[str, str] | None:
    if text is None:
        return None
    one, comma, other = (part.strip() for part in text.partition(","))
    if not (one and comma and other):
        raise _core.InputError(f"--tell-apart: expected two causes separated by a comma, found `{text}`")
    return one, other


def _can_be_made(file: Path, replace: bool) -> None:
    can_be_written(file)
    if file.exists() and not replace:
        raise _core.InputError(f"{file}: it exists already; use --replace to overwrite it")
