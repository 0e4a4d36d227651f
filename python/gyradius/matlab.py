"""MATLAB files of version 5 as tables that the core reads; needs scipy."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from ._core import GyradiusError, InputError

MAGIC = b"MATLAB 5.0"


@dataclass
class Readable:
    """Files that the core can read, and what of MATLAB files is not used."""

    paths: list[str] = field(default_factory=list)
    not_used: list[str] = field(default_factory=list)
    #: Where a MATLAB file's tables lie, and the file.
    places: dict[str, str] = field(default_factory=dict)

    def named(self, error: GyradiusError) -> GyradiusError:
        """The error with the name that the user knows."""
        named = type(error)(self.renamed(str(error)))
        named.file = None if error.file is None else self.renamed(error.file)
        named.line = None
        return named

    def renamed(self, text: str) -> str:
        """A text of the core with the files that the user knows."""
        # Longest first: one place is the beginning of another.
        for place, file in sorted(self.places.items(), key=lambda pair: -len(pair[0])):
            text = text.replace(place, file)
        return text


@contextmanager
def readable(files: Iterable[str | os.PathLike[str]]) -> Iterator[Readable]:
    """Files as they are, and the tables of MATLAB files for as long as they are needed."""
    found = Readable()
    with tempfile.TemporaryDirectory() as folder:
        for number, path in enumerate(files):
            file = os.fspath(path)
            if is_matlab(file):
                place = Path(folder) / str(number)
                place.mkdir()
                _write_tables(file, place, found)
                found.places[str(place)] = file
            else:
                found.paths.append(file)
        try:
            yield found
        except GyradiusError as error:
            if not found.places:
                raise
            raise found.named(error) from None


def is_matlab(file: str | os.PathLike[str]) -> bool:
    """Whether a file is MATLAB's, of version 5 (``save -v6`` and ``-v7``)."""
    try:
        with open(file, "rb") as opened:
            return opened.read(len(MAGIC)) == MAGIC
    except OSError:
        # The core says what is wrong with it.
        return False


def tables(file: str) -> tuple[list[tuple[str, bytes]], list[str]]:
    """The columns of numbers of a MATLAB file as CSV tables, by name and bytes, and the names of other variables."""
    columns: dict[str, np.ndarray[Any, Any]] = {}
    others: list[str] = []
    for name, value in _variables(file).items():
        _collect(name, value, columns, others)
    by_length: dict[int, list[str]] = {}
    for name, column in columns.items():
        by_length.setdefault(len(column), []).append(name)
    if not by_length:
        raise InputError(f"{file}: expected columns of numbers, found {', '.join(others) or 'none'}")
    stem = Path(file).stem
    made = []
    for names in by_length.values():
        # Columns of one length belong together; a sensor with a clock of its own has another.
        table = f"{stem}.csv" if len(by_length) == 1 else f"{stem}-{names[0]}.csv"
        rows = np.column_stack([columns[name] for name in names])
        lines = [",".join(names), *(",".join(map(repr, row)) for row in rows.tolist())]
        made.append((table, ("\n".join(lines) + "\n").encode()))
    return made, others


def _write_tables(file: str, place: Path, found: Readable) -> None:
    made, others = tables(file)
    for name, content in made:
        (place / name).write_bytes(content)
        found.paths.append(str(place / name))
        found.places[str(place / name)] = file
    if others:
        found.not_used.append(f"{Path(file).name}: {', '.join(others)}: no columns of numbers, not used")


def _variables(file: str) -> dict[str, Any]:
    try:
        from scipy.io import loadmat
    except ImportError:
        raise InputError(
            f"{file}: a MATLAB file, which needs scipy to be read: pip install 'gyradius[matlab]'; or let MATLAB write"
            " CSV, with `writetable` or `writematrix`"
        ) from None
    try:
        read = loadmat(file, squeeze_me=True, struct_as_record=False)
    except Exception as error:
        # scipy raises whatever a damaged file leads it to.
        raise InputError(f"{file}: cannot be read: {error}") from None
    return {name: value for name, value in read.items() if not name.startswith("__")}


def _collect(name: str, value: Any, columns: dict[str, np.ndarray[Any, Any]], others: list[str]) -> None:
    """Columns of numbers of a variable: its own, those of a matrix by number, those of a structure by field."""
    fields = getattr(value, "_fieldnames", None)
    if fields is not None:
        for key in fields:
            _collect(f"{name}.{key}", getattr(value, key), columns, others)
        return
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.size < 2 or array.ndim > 2:
        others.append(name)
    elif array.ndim == 1:
        columns[name] = array.astype(float)
    else:
        upright = array if array.shape[0] >= array.shape[1] else array.T
        for number, column in enumerate(upright.T, 1):
            columns[f"{name}{number}"] = column.astype(float)
