"""A result as a file for other programs, of the kind that the file's name ends in."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from pathlib import Path

from ._core import InputError
from .datatables import excel_library, write_csv, write_workbook
from .files import can_be_written, write_whole
from .inertial import mjcf, sdf, urdf
from .measurement import Measurement


class Table(str, Enum):
    """A table of the result."""

    quantities = "quantities"
    modes = "modes"
    budget = "budget"
    consistency = "consistency"
    findings = "findings"


SIMULATORS: dict[str, Callable[..., str]] = {".urdf": urdf, ".sdf": sdf, ".xml": mjcf}
ENDINGS = (".csv", ".xlsx", *SIMULATORS)


def kind_of(output: Path, table: Table | None = None) -> str:
    """The ending of a file that can be written; refused before any work is done where it cannot."""
    kind = output.suffix.lower()
    if kind not in ENDINGS:
        raise InputError(f"{output}: expected a name that ends in one of {', '.join(ENDINGS)}")
    if table is not None and kind != ".csv":
        raise InputError(f"--table {table.value}: only for a .csv; {output} is not one")
    if kind == ".xlsx":
        excel_library()
    can_be_written(output)
    return kind


def write_export(measurement: Measurement, output: Path, kind: str, table: Table | None = None) -> None:
    """Write a measurement to a file of a kind; for simulators the smallest model that holds the hull."""
    if kind == ".csv":
        write_csv(measurement, output, (table or Table.quantities).value)
    elif kind == ".xlsx":
        write_workbook(measurement, output)
    else:
        write_whole(output, SIMULATORS[kind](measurement, model=True))
