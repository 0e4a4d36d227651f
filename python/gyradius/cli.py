"""The command ``gyradius``."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from json import dumps
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from . import _core
from .arguments import Language, Orientation, Platform, Suspension, quantity, reading, stated
from .arrays import routes as catalogue
from .console import error_console, output_console
from .critique import FORMAT as CRITIQUE
from .critique import Critique
from .critique_tables import show_critique
from .files import can_be_written, only_writer, write_whole
from .imports import STATED, ImportPlan, describe_exports, import_files, import_into, pair
from .interrupt import heard_during
from .measurement import Measurement
from .outcome import end_without_result, reason_without_result, reported, with_reason, write_json
from .plan_tables import show_plan
from .planning import FORMAT as PLAN
from .planning import plan as make_plan
from .practice import Practice
from .practise_screen import Left, play, show_compared
from .progress import counted, working
from .session import Session, load, shipped_sessions
from .simulation import read_rig, shipped_rigs
from .tables import show

app = typer.Typer(
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)

SessionPath = Annotated[str, typer.Argument(metavar="SESSION", help="Session folder, session zip, or a recording.")]
Json = Annotated[
    str | None,
    typer.Option("--json", metavar="FILE", help="Write the same numbers as JSON (- for standard output)."),
]
Limits = Annotated[
    list[str] | None,
    typer.Option("--limit", metavar="LIMIT", help="Class limit such as k_pitch>=1.100; may be repeated."),
]
Map = Annotated[
    list[str] | None,
    typer.Option("--map", metavar="FIELD=COLUMN:UNIT", help="A column of a CSV that is not recognised; repeat."),
]


def _show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"gyradius {_core.__version__}")
        raise typer.Exit


@app.callback()
def every_command(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """Inertia of a hull hung on two lines, from the recordings of a phone that swings with it."""


@app.command()
def demo(
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Where reports and JSON go.")] = Path(
        "gyradius-demo"
    ),
    critique: Annotated[
        bool, typer.Option("--critique", help="Criticise the simulation too: minutes, not seconds.")
    ] = False,
    json: Json = None,
) -> None:
    """Run the main job on the sessions that come with the package."""
    with reported(error_console(), json):
        sessions = shipped_sessions()
        if not sessions:
            raise _core.InputError("no sessions came with this package")
        output.mkdir(parents=True, exist_ok=True)
        console = output_console(json)
        measured = {name: _demo_one(console, name, path, output, critique) for name, path in sessions.items()}
        if json is not None:
            write_json(_joined(measured), json)
        console.print("Reports:")
        for name in sessions:
            console.print(f"  {output / name}.html", soft_wrap=True)


@app.command()
def measure(session: SessionPath, json: Json = None, limit: Limits = None, map_: Map = None) -> None:
    """Periods, gyradii, centre of mass and principal axes, each with its uncertainty and budget."""
    with reported(error_console(), json):
        measurement = _measured(_loaded(session, map_), limit)
        reason = _written(measurement, json)
        show(output_console(json), measurement)
        if reason is not None:
            end_without_result(error_console(), reason)


@app.command()
def critique(
    session: SessionPath,
    json: Json = None,
    by_sets: Annotated[
        bool,
        typer.Option("--by-sets", help="Weigh all sets of causes at once, not one cause after another (being tried)."),
    ] = False,
) -> None:
    """What the simulation gets wrong, why, the extended model and the gain."""
    with reported(error_console(), json, CRITIQUE):
        found = _criticised(_loaded(session), by_sets)
        if json is not None:
            write_json(found.to_json(), json)
        show_critique(output_console(json), found)


@app.command()
def report(
    session: SessionPath,
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="FILE", help="The report: .html, or PDF where it ends in .pdf."),
    ],
    json: Json = None,
    limit: Limits = None,
    critique: Annotated[
        bool, typer.Option("--critique/--no-critique", help="With what the simulation gets wrong, which takes minutes.")
    ] = True,
    language: Annotated[Language, typer.Option(help="The report's language: English or German.")] = Language.en,
) -> None:
    """Write one self-contained HTML file with pictures, or a PDF."""
    with reported(error_console(), json):
        can_be_written(output)
        loaded = _loaded(session)
        measurement = _measured(loaded, limit)
        criticism = _critique_or_reason(loaded) if critique else None
        write_report(measurement, output, criticism, language)
        reason = _written(measurement, json, criticism if isinstance(criticism, Critique) else None)
        output_console(json).print(f"Report: {output}", soft_wrap=True)
        if reason is not None:
            end_without_result(error_console(), reason)


@app.command("import")
def import_(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Exports of phones and loggers.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="The session folder to write; without it, what is found."),
    ] = None,
    into: Annotated[
        Path | None, typer.Option(metavar="SESSION", help="A session folder that is there: swings are added to it.")
    ] = None,
    swing: Annotated[
        str | None, typer.Option(metavar="ID", help="With --into: the planned swing that FILE is the recording of.")
    ] = None,
    like: Annotated[
        str | None, typer.Option(metavar="ID", help="With --into: hung like this swing, but for what is stated.")
    ] = None,
    map_: Map = None,
    trial: Annotated[str | None, typer.Option(metavar="K", help="One of several trials in a file.")] = None,
    platform: Annotated[Platform | None, typer.Option(help="The phone's system, where a file does not say.")] = None,
    flag_width: Annotated[float | None, typer.Option(metavar="M", help="Flag in a light gate, m.")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Write over files that are there.")] = False,
    title: Annotated[str, typer.Option(help="The session's title.")] = "",
    suspension: Annotated[Suspension | None, typer.Option(help="How all FILEs hung (bifilar).")] = None,
    orientation: Annotated[Orientation | None, typer.Option(help="What joins the points (athwartships).")] = None,
    mass: Annotated[str | None, stated("kg, everything that swings")] = None,
    gravity: Annotated[str | None, stated("m/s²")] = None,
    line_length: Annotated[str | None, stated("m")] = None,
    spacing: Annotated[str | None, stated("m, between the points on the hull")] = None,
    top_spacing: Annotated[str | None, stated("m, between the points above")] = None,
    radius: Annotated[str | None, stated("m, of the circle through the line ends below (trifilar)")] = None,
    top_radius: Annotated[str | None, stated("m, of the circle above (trifilar)")] = None,
    hull_pitch: Annotated[str | None, stated("degrees, bow up")] = None,
    points_moved: Annotated[str | None, stated("m, of the points, forward from level hanging")] = None,
    axis_height: Annotated[str | None, stated("m, of the swing axis (compound)")] = None,
    json: Json = None,
) -> None:
    """Write a session from phone exports, add them to one, or say what they hold.

    Options hold for all FILEs: import files that hung otherwise by themselves, with --into.
    """
    with reported(error_console(), json):
        of_session: dict[str, object] = {"--replace": replace, "--title": title, "--mass": mass, "--gravity": gravity}
        _refuse_options(output, into, {"--swing": swing, "--like": like}, of_session)
        known: dict[str, Any] = {
            "mapping": map_ or [],
            "trial": trial,
            "platform": None if platform is None else platform.value,
            "flag_width": flag_width,
            "suspension": None if suspension is None else suspension.value,
            "orientation": None if orientation is None else orientation.value,
            "line_length": reading(line_length),
            "spacing": reading(spacing),
            "top_spacing": reading(top_spacing),
            "radius": reading(radius),
            "top_radius": reading(top_radius),
            "hull_pitch": reading(hull_pitch),
            "points_moved": reading(points_moved),
            "axis_height": reading(axis_height),
        }
        new: dict[str, Any] = {"mass": reading(mass), "gravity": reading(gravity), "title": title, "replace": replace}
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
        raise _core.InputError("--into: expected it without -o, which writes a new session")
    wrong = of_into if into is None else of_output
    for name, given in wrong.items():
        if given:
            reason = "--into is missing" if into is None else "the session is there already and keeps its own"
            raise _core.InputError(f"{name}: {reason}")


@app.command()
def simulate(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="Rig file: a session's keys, [truth] and [[effect]].")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The session folder to write.")],
    seed: Annotated[int | None, typer.Option(metavar="N", min=0, max=2**64 - 1, help="Of all chance.")] = None,
    truth: Annotated[
        Path | None, typer.Option(metavar="FILE", help="What is true; DIR.truth.json where it is left out.")
    ] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Write over files that are there.")] = False,
    json: Json = None,
) -> None:
    """Write a session that was never swung, and beside it what is true."""
    with reported(error_console(), json):
        with working(error_console(), f"simulating {rig}"):
            file, drawn = heard_during(read_rig(rig).write, output, truth=truth, seed=seed, replace=replace)
        if json is not None:
            found = {"session": str(output), "truth": str(file), "seed": drawn}
            write_json(dumps(found, ensure_ascii=False, indent=2), json)
        console = output_console(json)
        for name, value in (("Seed", drawn), ("Truth", file), ("Session", output)):
            console.print(f"{name}: {value}", soft_wrap=True)


@app.command()
def practise(
    rig: Annotated[
        str | None, typer.Argument(metavar="RIG", help="The hull to practise on; the keelboat that ships otherwise.")
    ] = None,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Where everything goes.")] = Path(
        "gyradius-practice"
    ),
    speed: Annotated[
        float | None, typer.Option(metavar="X", min=0.01, help="Times real time: 1, or as fast as can be by itself.")
    ] = None,
    auto: Annotated[bool, typer.Option("--auto", help="A careful operator plays it; nothing is asked.")] = False,
    seed: Annotated[int | None, typer.Option(metavar="N", min=0, max=2**64 - 1, help="Of all chance.")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with what was left in DIR.")] = False,
    mishap: Annotated[
        list[str] | None,
        typer.Option(
            metavar="STEP:TAKE:WHAT",
            help="Let go wrong: bad_release, sway, touch, slip or silence, as in yaw-sway:1:touch; repeat.",
        ),
    ] = None,
    critique: Annotated[
        bool, typer.Option("--critique", help="Criticise the result too, which takes minutes.")
    ] = False,
    json: Json = None,
) -> None:
    """Practise the whole measurement on a simulated hull, from hanging it to the result."""
    with reported(error_console(), json):
        if not auto and not (sys.stdin.isatty() and sys.stdout.isatty()):
            raise _core.InputError("practise: expected a terminal, or --auto, which asks nothing")
        with only_writer(output):
            practice = Practice(read_rig(rig or shipped_rigs()["keelboat"]), output, seed=seed, resume=resume)
            for one in mishap or []:
                practice.mishap(*_mishap(one))
            console = output_console(json)
            console.print(f"Seed: {practice.seed}")
            try:
                play(console, practice, speed=speed, auto=auto, critique=critique)
            except Left:
                console.print(f"Left; go on with: gyradius practise -o {output} --resume")
                raise typer.Exit(0) from None
            if practice.state["result"] is None:
                raise _core.NoResultError(practice.state["instruction"]["english"])
            show_compared(console, practice)
            if json is not None:
                session = output / practice.state["result"]["session"]
                found = {"session": str(session), "seed": practice.seed, "compared": practice.compared()}
                write_json(dumps(found, ensure_ascii=False, indent=2), json)
            console.print(f"Session: {output / 'session'}", soft_wrap=True)


def _mishap(text: str) -> tuple[str, int, str]:
    step, _, rest = text.partition(":")
    take, _, what = rest.partition(":")
    if not (take.isdigit() and what):
        raise typer.BadParameter(f"expected STEP:TAKE:WHAT, found `{text}`", param_hint="--mishap")
    return step, int(take), what


@app.command()
def routes(json: Json = None) -> None:
    """List the paper's equations and what each needs."""
    with reported(error_console(), json):
        found = catalogue()
        if json is not None:
            write_json(_core.routes(), json)
        table = Table("route", "equation", "needs", "gives")
        for route in found:
            needs, gives = (_slots(route[key]) for key in ("inputs", "outputs"))
            table.add_row(route["name"], route["equation"], needs, gives)
        output_console(json).print(table)


def _slots(slots: list[dict[str, Any]]) -> str:
    return ", ".join(slot["name"] if slot.get("required", True) else f"({slot['name']})" for slot in slots)


@app.command()
def plan(
    session: Annotated[
        str | None, typer.Argument(metavar="[SESSION]", help="A session that has measured the hull so far.")
    ] = None,
    mass: Annotated[float | None, typer.Option(metavar="KG", help="Everything that hangs.")] = None,
    length: Annotated[float | None, typer.Option(metavar="M", help="Length overall.")] = None,
    beam: Annotated[float | None, typer.Option(metavar="M", help="Largest beam.")] = None,
    type_: Annotated[
        str | None, typer.Option("--type", metavar="TYPE", help="keelboat, dinghy, model_keelboat or uniform_bar.")
    ] = None,
    k_yaw: Annotated[str | None, stated("m, where known")] = None,
    k_pitch: Annotated[str | None, stated("m, where known")] = None,
    k_roll: Annotated[str | None, stated("m, where known")] = None,
    depth: Annotated[str | None, stated("m, of the centre of mass below the suspension points, where known")] = None,
    wanted: Annotated[
        list[str] | None,
        typer.Option(metavar="QUANTITY=U", help="Such as k_yaw=0.1%, k_pitch=2mm, depth=5mm, psi=1deg; repeat."),
    ] = None,
    max_height: Annotated[float | None, typer.Option(metavar="M", help="Room for the lines (3).")] = None,
    max_spacing: Annotated[float | None, typer.Option(metavar="M", help="Between the points (1.25 beams).")] = None,
    u_line_length: Annotated[float | None, typer.Option(metavar="M", help="Tape on the lines (0.003).")] = None,
    u_spacing: Annotated[float | None, typer.Option(metavar="M", help="Tape between the points (0.001).")] = None,
    amplitude: Annotated[float | None, typer.Option(metavar="DEG", help="Of a release (5).")] = None,
    gravity: Annotated[str | None, stated("m/s² (9.80665:0.015)")] = None,
    tell_apart: Annotated[
        str | None, typer.Option(metavar="CAUSE,CAUSE", help="The swing that tells two causes of `critique` apart.")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write a session.toml to fill in.")
    ] = None,
    rig: Annotated[Path | None, typer.Option(metavar="FILE", help="Write a rig file to rehearse with.")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Write over files that are there.")] = False,
    title: Annotated[str, typer.Option(help="What the plan is for.")] = "",
    json: Json = None,
) -> None:
    """What to hang and swing for a wanted uncertainty, and what to expect; warns of resonances."""
    with reported(error_console(), json, PLAN):
        for file in (output, rig):
            if file is not None:
                _can_be_made(file, replace)
        means = {
            "most_line_length_m": max_height,
            "most_spacing_m": max_spacing,
            "u_line_length_m": u_line_length,
            "u_spacing_m": u_spacing,
            "amplitude_deg": amplitude,
            "gravity_m_s2": _figure(gravity),
        }
        loaded = None if session is None else _loaded(session)
        with counted(error_console(), "planning") as told:
            found = heard_during(
                make_plan,
                loaded,
                mass=mass,
                length=length,
                beam=beam,
                boat_type=type_,
                k_yaw=quantity(k_yaw),
                k_pitch=quantity(k_pitch),
                k_roll=quantity(k_roll),
                depth=quantity(depth),
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


def _figure(text: str | None) -> dict[str, float] | None:
    figure = quantity(text)
    return None if figure is None else {"value": figure[0], "u": figure[1]}


def _two(text: str | None) -> tuple[str, str] | None:
    if text is None:
        return None
    one, comma, other = (part.strip() for part in text.partition(","))
    if not (one and comma and other):
        raise _core.InputError(f"--tell-apart: expected two causes with a comma between, found `{text}`")
    return one, other


def _can_be_made(file: Path, replace: bool) -> None:
    can_be_written(file)
    if file.exists() and not replace:
        raise _core.InputError(f"{file}: it exists already and is not overwritten (--replace does)")


def write_report(
    measurement: Measurement,
    output: Path,
    critique: Critique | str | None = None,
    language: Language = Language.en,
) -> None:
    """Write a report as HTML, or as PDF where the name ends so; with a criticism, or why there is none."""
    html = measurement.to_html(critique, language.value)
    if output.suffix.lower() == ".pdf":
        from .pdf import laid_out

        # Layout takes seconds, and reportlab may swallow Ctrl-C.
        write_whole(output, heard_during(laid_out, html))
    else:
        write_whole(output, html)


def _written(measurement: Measurement, json: str | None, critique: Critique | None = None) -> str | None:
    """Write the JSON where it is wanted; answers why there is no result, where there is none."""
    reason = reason_without_result(measurement)
    if json is not None:
        text = measurement.to_json(critique)
        write_json(text if reason is None else with_reason(text, reason), json)
    return reason


def _loaded(path: str, mapping: list[str] | None = None) -> Session:
    with working(error_console(), f"reading {path}"):
        return heard_during(load, path, mapping=mapping or [])


def _measured(session: Session, limits: list[str] | None = None) -> Measurement:
    with working(error_console(), f"measuring {session.title}"):
        return heard_during(session.measure, limits or [])


def _criticised(session: Session, by_sets: bool = False) -> Critique:
    def criticised(progress: Callable[[float, str], object]) -> Critique:
        return session.critique(progress, by_sets=by_sets)

    with counted(error_console(), "criticising") as told:
        return heard_during(criticised, told)


def _critique_or_reason(session: Session) -> Critique | str:
    try:
        return _criticised(session)
    except _core.GyradiusError as error:
        error_console().print(f"no criticism: {error}", soft_wrap=True)
        return str(error)


def _demo_one(console: Console, name: str, path: Path, output: Path, critique: bool) -> Measurement:
    session = _loaded(str(path))
    measurement = _measured(session)
    show(console, measurement)
    criticism = _critique_or_reason(session) if critique else None
    if isinstance(criticism, Critique):
        show_critique(console, criticism)
        write_json(criticism.to_json(), str(output / f"{name}-critique.json"))
    write_report(measurement, output / f"{name}.html", criticism)
    write_json(measurement.to_json(), str(output / f"{name}.json"))
    return measurement


def _joined(measured: dict[str, Measurement]) -> str:
    # The core's own texts, put side by side without reading a number.
    members = ",\n".join(f'"{name}": {measurement.to_json()}' for name, measurement in measured.items())
    return "{\n" + members + "\n}"


def run() -> None:
    """Run the command."""
    if not os.environ.get("GYRADIUS_TRACEBACK"):
        # A panic becomes an exception, which is told in one line.
        _core.silence_panics()
    app(prog_name="gyradius")
