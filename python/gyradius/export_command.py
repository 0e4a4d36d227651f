"""The command ``gyradius export``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .arguments import Json, Map, SessionPath
from .console import error_console, output_console
from .export import Table, kind_of, write_export
from .outcome import end_without_result, reported
from .tasks import loaded, measured, written


def export(
    session: SessionPath,
    output: Annotated[
        Path,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help="The extension decides: .csv, .xlsx, .urdf, .sdf, or .xml for MuJoCo.",
        ),
    ],
    table: Annotated[Table | None, typer.Option(help="The table in a .csv (quantities); an .xlsx holds all.")] = None,
    json: Json = None,
    map_: Map = None,
) -> None:
    """Write the result as a table, or the hull's inertia for a simulator."""
    with reported(error_console(), json):
        kind = kind_of(output, table)
        measurement = measured(loaded(session, map_))
        write_export(measurement, output, kind, table)
        reason = written(measurement, json)
        output_console(json).print(f"Export: {output}", soft_wrap=True)
        if reason is not None:
            end_without_result(error_console(), reason)
