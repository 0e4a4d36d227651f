"""MATLAB files of version 5: written here byte by byte, as MathWorks documents the format."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

import pytest
from conftest import swing_csv

import gyradius
from gyradius.matlab import readable


def element(kind: int, content: bytes) -> bytes:
    return struct.pack("<II", kind, len(content)) + content + bytes(-len(content) % 8)


def matrix(name: str, columns: list[list[float]], shape: tuple[int, int] | None = None) -> bytes:
    rows, count = shape or (len(columns[0]), len(columns))
    numbers = [number for column in columns for number in column]
    return element(
        14,
        element(6, struct.pack("<II", 6, 0))
        + element(5, struct.pack("<ii", rows, count))
        + element(1, name.encode())
        + element(9, struct.pack(f"<{len(numbers)}d", *numbers)),
    )


def text(name: str, letters: str) -> bytes:
    return element(
        14,
        element(6, struct.pack("<II", 4, 0))
        + element(5, struct.pack("<ii", 1, len(letters)))
        + element(1, name.encode())
        + element(4, letters.encode("utf-16-le")),
    )


def mat(path: Path, *variables: bytes) -> Path:
    header = b"MATLAB 5.0 MAT-file, written by a test".ljust(116) + bytes(8) + struct.pack("<H", 0x0100) + b"IM"
    path.write_bytes(header + b"".join(variables))
    return path


def swing() -> list[list[float]]:
    rows = [[float(cell) for cell in line.split(",")] for line in swing_csv().splitlines()[1:]]
    return [list(column) for column in zip(*rows, strict=True)]


def test_columns_with_names_of_their_own_are_a_recording(tmp_path: Path) -> None:
    pytest.importorskip("scipy")
    names = ["t", "gx", "gy", "gz", "ax", "ay", "az"]
    file = mat(tmp_path / "yaw.mat", *(matrix(n, [c]) for n, c in zip(names, swing(), strict=True)), text("who", "me"))
    modes = gyradius.load(file).measure().swings[0].modes
    assert modes[0].period_s == pytest.approx(2.0, abs=1e-3)
    notes = gyradius.import_files([file], tmp_path / "s", line_length=2.0, spacing=1.0)
    assert notes[0] == "yaw.mat: who: no columns of numbers, not used"
    assert gyradius.load(tmp_path / "s").swing_ids == ["yaw"]


def test_a_matrix_has_numbered_columns_and_errors_name_the_file(tmp_path: Path) -> None:
    pytest.importorskip("scipy")
    t, gx, gy, gz, *_ = swing()
    file = mat(tmp_path / "log.mat", matrix("data", [[1000 * x for x in t], gx, gy, gz]))
    mapping = ["t=data1:ms", "gx=data2:rad/s", "gy=data3:rad/s", "gz=data4:rad/s"]
    assert gyradius.load(file, mapping=mapping).measure().swings[0].modes[0].period_s == pytest.approx(2.0, abs=1e-3)
    with pytest.raises(gyradius.InputError, match="data5") as told:
        gyradius.import_files([file], tmp_path / "s", mapping=[*mapping[:3], "gz=data5:rad/s"])
    assert str(told.value).startswith(str(file))


def test_vectors_may_lie_and_clocks_may_differ(tmp_path: Path) -> None:
    pytest.importorskip("scipy")
    lying = matrix("t", [[0.0, 0.1, 0.2]], (1, 3)) + matrix("y", [[1.0, 2.0, 1.0]], (1, 3))
    file = mat(tmp_path / "two.mat", lying, matrix("z", [[5.0, 6.0]]))
    with readable([file]) as found:
        texts = {Path(path).name: Path(path).read_text() for path in found.paths}
    assert texts == {"two-t.csv": "t,y\n0.0,1.0\n0.1,2.0\n0.2,1.0\n", "two-z.csv": "z\n5.0\n6.0\n"}
    assert not any(Path(path).exists() for path in found.paths)


def test_without_scipy_the_way_out_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy.io", None)
    file = mat(tmp_path / "log.mat", matrix("data", [[1.0, 2.0]]))
    with pytest.raises(gyradius.InputError, match=r"log.mat.*gyradius\[matlab\].*writetable"):
        gyradius.load(file)


def test_a_damaged_file_is_an_error_of_its_own(tmp_path: Path) -> None:
    pytest.importorskip("scipy")
    file = tmp_path / "cut.mat"
    file.write_bytes(mat(file, matrix("data", [[1.0, 2.0]])).read_bytes()[:150])
    with pytest.raises(gyradius.InputError, match="cut.mat"):
        gyradius.load(file)
