"""The command ``gyradius``."""

from __future__ import annotations

import os
import sys
from json import dumps
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from . import _core
from .arguments import Json, Language, Limits, Map, SessionPath
from .arrays import routes as catalogue
from .console import error_console, output_console
from .critique import FORMAT as CRITIQUE
from .critique import Critique
from .critique_tables import show_critique
from .export_command import export
from .files import can_be_written, only_writer
from .import_command import import_
from .interrupt import heard_during
from .measurement import Measurement
from .outcome import end_without_result, reported, write_json
from .paper_command import paper
from .plan_command import plan
from .practice import Practice
from .practise_screen import Left, play, show_compared
from .progress import working
from .session import shipped_sessions
from .session_commands import check, new
from .simulation import read_rig, shipped_rigs
from .summary import show_brief, show_summary
from .tables import show
from .tasks import criticised, critique_or_reason, loaded, measured, report_form, write_report, written

app = typer.Typer(
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


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
    """Measure the inertia of a hull hung on two lines, from the recordings of a phone that swings with it."""


@app.command()
def demo(
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for reports and JSON.")] = Path(
        "gyradius-demo"
    ),
    critique: Annotated[bool, typer.Option("--critique", help="Also criticise the simulation; takes minutes.")] = False,
    json: Json = None,
) -> None:
    """Measure the sessions that ship with the package and write their reports."""
    with reported(error_console(), json):
        sessions = shipped_sessions()
        if not sessions:
            raise _core.InputError("this package contains no sessions: install it again")
        output.mkdir(parents=True, exist_ok=True)
        console = output_console(json)
        found = {name: _demo_one(console, name, path, output, critique) for name, path in sessions.items()}
        if json is not None:
            write_json(_joined(found), json)
        console.print("Reports:")
        for name in sessions:
            console.print(f"  {output / name}.html", soft_wrap=True)


@app.command()
def measure(
    session: SessionPath,
    json: Json = None,
    limit: Limits = None,
    map_: Map = None,
    verbose: Annotated[
        bool,
        typer.Option("-v", "--verbose", help="Also show swings, estimates, uncertainty budget and consistency tests."),
    ] = False,
) -> None:
    """Measure gyradii, centre of mass and principal axes, with uncertainties and warnings."""
    with reported(error_console(), json):
        measurement = measured(loaded(session, map_), limit)
        reason = written(measurement, json)
        (show if verbose else show_summary)(output_console(json), measurement)
        if reason is not None:
            end_without_result(error_console(), reason)


@app.command()
def critique(
    session: SessionPath,
    json: Json = None,
    by_sets: Annotated[
        bool,
        typer.Option("--by-sets", help="Weigh all sets of causes at once instead of one by one (experimental)."),
    ] = False,
) -> None:
    """Find what the simulation gets wrong and why, and extend it; takes minutes."""
    with reported(error_console(), json, CRITIQUE):
        found = criticised(loaded(session), by_sets)
        if json is not None:
            write_json(found.to_json(), json)
        show_critique(output_console(json), found)


@app.command()
def report(
    session: SessionPath,
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="FILE", help="The report: .html or .pdf."),
    ],
    json: Json = None,
    limit: Limits = None,
    critique: Annotated[
        bool, typer.Option("--critique/--no-critique", help="Include the criticism of the simulation; takes minutes.")
    ] = True,
    language: Annotated[Language, typer.Option(help="The report's language: English or German.")] = Language.en,
) -> None:
    """Write the report as a self-contained HTML file with pictures, or as a PDF."""
    with reported(error_console(), json):
        report_form(output)
        can_be_written(output)
        known = loaded(session)
        measurement = measured(known, limit)
        criticism = critique_or_reason(known) if critique else None
        write_report(measurement, output, criticism, language)
        reason = written(measurement, json, criticism if isinstance(criticism, Critique) else None)
        output_console(json).print(f"Report: {output}", soft_wrap=True)
        if reason is not None:
            end_without_result(error_console(), reason)


app.command()(export)
app.command("import")(import_)
app.command()(new)
app.command()(check)


@app.command()
def simulate(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="Rig file: a session's keys, [truth] and [[effect]].")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The session folder to write.")],
    seed: Annotated[int | None, typer.Option(metavar="N", min=0, max=2**64 - 1, help="Of all chance.")] = None,
    truth: Annotated[
        Path | None, typer.Option(metavar="FILE", help="File for the true values (default: DIR.truth.json).")
    ] = None,
    replace: Annotated[bool, typer.Option("--replace", help="Write over files that are there.")] = False,
    json: Json = None,
) -> None:
    """Write a synthetic session, and the true values beside it."""
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
        str | None, typer.Argument(metavar="RIG", help="The hull to practise on (default: the keelboat that ships).")
    ] = None,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for everything.")] = Path(
        "gyradius-practice"
    ),
    speed: Annotated[
        float | None,
        typer.Option(
            metavar="X", min=0.01, help="Multiple of real time (default: 1; with --auto, as fast as possible)."
        ),
    ] = None,
    auto: Annotated[bool, typer.Option("--auto", help="Play a careful operator; ask nothing.")] = False,
    seed: Annotated[int | None, typer.Option(metavar="N", min=0, max=2**64 - 1, help="Of all chance.")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Continue what was left in DIR.")] = False,
    mishap: Annotated[
        list[str] | None,
        typer.Option(
            metavar="STEP:TAKE:WHAT",
            help="Make a recording go wrong (yaw-sway:1:touch): bad_release, sway, touch, slip, silence; repeatable.",
        ),
    ] = None,
    critique: Annotated[bool, typer.Option("--critique", help="Also criticise the simulation; takes minutes.")] = False,
    json: Json = None,
) -> None:
    """Practise the whole measurement on a simulated hull, from hanging it to the result."""
    with reported(error_console(), json):
        if not auto and not (sys.stdin.isatty() and sys.stdout.isatty()):
            raise _core.InputError("practise: needs a terminal; without one use --auto, which asks nothing")
        with only_writer(output):
            practice = Practice(read_rig(rig or shipped_rigs()["keelboat"]), output, seed=seed, resume=resume)
            for one in mishap or []:
                practice.mishap(*_mishap(one))
            console = output_console(json)
            console.print(f"Seed: {practice.seed}")
            try:
                play(console, practice, speed=speed, auto=auto, critique=critique)
            except Left:
                console.print(f"Stopped. To continue: gyradius practise -o {output} --resume")
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
    """List the paper's equations and the inputs of each."""
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


app.command()(paper)
app.command()(plan)


def _demo_one(console: Console, name: str, path: Path, output: Path, critique: bool) -> Measurement:
    session = loaded(str(path))
    measurement = measured(session)
    show_brief(console, measurement)
    console.print()
    criticism = critique_or_reason(session) if critique else None
    if isinstance(criticism, Critique):
        show_critique(console, criticism)
        write_json(criticism.to_json(), str(output / f"{name}-critique.json"))
    write_report(measurement, output / f"{name}.html", criticism)
    write_json(measurement.to_json(), str(output / f"{name}.json"))
    return measurement


def _joined(measured: dict[str, Measurement]) -> str:
    # The core's own JSON texts, joined without parsing a number.
    members = ",\n".join(f'"{name}": {measurement.to_json()}' for name, measurement in measured.items())
    return "{\n" + members + "\n}"


def run() -> None:
    """Run the command."""
    if not os.environ.get("GYRADIUS_TRACEBACK"):
        # A panic becomes an exception, which is reported in one line.
        _core.silence_panics()
    app(prog_name="gyradius")
