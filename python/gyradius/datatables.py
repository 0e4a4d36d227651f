"""A measurement as tables of plain cells: data frames, CSV and Excel workbooks.

One row holds one figure with its uncertainty, as the core gives it. Nothing is rounded; what is not known is empty.
"""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from ._core import InputError
from .console import UNSEEN
from .files import write_whole
from .labels import UNITS
from .measurement import Claim, Measurement, ModeResult
from .tables import elements

if TYPE_CHECKING:
    import pandas as pd

Cell: TypeAlias = "str | float | bool | None"
Row: TypeAlias = "tuple[Cell, ...]"

# Units that every program reads, whatever encoding it takes a file to have.
ASCII_UNITS = str.maketrans({"°": "deg", "²": "^2"})
# Columns of a workbook, in characters.
LEAST_WIDTH, MOST_WIDTH = 8, 60


@dataclass(frozen=True, slots=True)
class DataTable:
    """Names of the columns, and the rows."""

    columns: tuple[str, ...]
    rows: tuple[Row, ...]


def data_table(measurement: Measurement, name: str) -> DataTable:
    """The table of a name: one of ``TABLES``."""
    if name not in TABLES:
        raise InputError(f"table `{name}`: expected one of {', '.join(TABLES)}")
    columns, rows = TABLES[name]
    return DataTable(columns, tuple(rows(measurement)))


def frame(measurement: Measurement, name: str) -> pd.DataFrame:
    """The same as a data frame of pandas."""
    try:
        import pandas as pd
    except ImportError:
        raise InputError("a data frame needs pandas: pip install 'gyradius[pandas]'; to_csv does without") from None
    table = data_table(measurement, name)
    return pd.DataFrame(list(table.rows), columns=list(table.columns))


def write_csv(measurement: Measurement, path: str | os.PathLike[str], name: str) -> None:
    """The same as a CSV file: UTF-8, a comma between cells, a header."""
    table = data_table(measurement, name)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([table.columns, *table.rows])
    write_whole(Path(path), text.getvalue())


def write_workbook(measurement: Measurement, path: str | os.PathLike[str]) -> None:
    """All tables as an Excel workbook, one sheet each."""
    openpyxl = excel_library()
    book = openpyxl.Workbook()
    book.remove(book.active)
    book.properties.title = UNSEEN.sub("", measurement.title)
    for name in TABLES:
        _fill(book.create_sheet(name), data_table(measurement, name))
    packed = io.BytesIO()
    book.save(packed)
    write_whole(Path(path), packed.getvalue())


def excel_library() -> Any:
    """The library that writes workbooks, or an error that says how to get it."""
    try:
        import openpyxl
    except ImportError:
        raise InputError("an Excel workbook needs openpyxl: pip install 'gyradius[xlsx]'; or write .csv") from None
    return openpyxl


def _fill(sheet: Any, table: DataTable) -> None:
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    for i, row in enumerate((table.columns, *table.rows), start=1):
        for j, value in enumerate(row, start=1):
            cell = sheet.cell(i, j, UNSEEN.sub("\ufffd", value) if isinstance(value, str) else value)
            if isinstance(value, str):
                # A text that begins with `=` is no formula.
                cell.data_type = "s"
            if i == 1:
                cell.font = Font(bold=True)
    for j, cells in enumerate(zip(table.columns, *table.rows, strict=True), start=1):
        longest = max(len(str(value)) for value in cells) + 1
        sheet.column_dimensions[get_column_letter(j)].width = min(max(longest, LEAST_WIDTH), MOST_WIDTH)
    sheet.freeze_panes = "A2"


def _quantities(measurement: Measurement) -> Iterator[Row]:
    for name, quantity in measurement.quantities.items():
        unit = plain_unit(name)
        if isinstance(quantity.value, tuple):
            for element, value, u in elements(quantity):
                yield name, element, value, u, None, None, unit, quantity.method
        else:
            low, high = quantity.interval_95 or (None, None)
            yield name, "", quantity.value, quantity.u, low, high, unit, quantity.method


def plain_unit(name: str) -> str:
    """The unit of a quantity in ASCII: ``deg``, ``kg m^2``."""
    return UNITS.get(name, "").translate(ASCII_UNITS)


# What a mode has beside its points by amplitude, which are no cells.
MODE_COLUMNS = tuple(field.name for field in fields(ModeResult) if field.name != "against_amplitude")


def _modes(measurement: Measurement) -> Iterator[Row]:
    for swing in measurement.swings:
        for mode in swing.modes:
            yield (swing.id, *(getattr(mode, name) for name in MODE_COLUMNS))


def _budget(measurement: Measurement) -> Iterator[Row]:
    for name, lines in measurement.budget.items():
        for line in lines:
            yield name, line.input, line.u_contribution, plain_unit(name)


# `source` is `from` in the JSON; the range in sigmas is two cells.
CLAIM_COLUMNS = tuple(field.name for field in fields(Claim) if field.name != "sigma_range")


def _consistency(measurement: Measurement) -> Iterator[Row]:
    for claim in measurement.consistency:
        low, high = claim.sigma_range or (None, None)
        yield (*(getattr(claim, name) for name in CLAIM_COLUMNS), low, high)


def _findings(measurement: Measurement) -> Iterator[Row]:
    for found in measurement.findings:
        yield found.kind, found.severity, found.swing, found.channel, found.text, found.advice


# By name: the columns, and what makes the rows. The order is that of the sheets.
TABLES: dict[str, tuple[tuple[str, ...], Callable[[Measurement], Iterator[Row]]]] = {
    "quantities": (("name", "element", "value", "u", "low_95", "high_95", "unit", "method"), _quantities),
    "modes": (("swing", *MODE_COLUMNS), _modes),
    "budget": (("quantity", "input", "u_contribution", "unit"), _budget),
    "consistency": ((*CLAIM_COLUMNS, "least_sigma", "most_sigma"), _consistency),
    "findings": (("kind", "severity", "swing", "channel", "text", "advice"), _findings),
}
