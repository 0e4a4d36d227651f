"""phyphox_export.py SESSION OUTPUT: writes the recordings of a session as phyphox exports them, one zip for each swing.

The tutorial begins with such files. They are made from a simulated session, so that it can be followed without a boat.
"""

from __future__ import annotations

import csv
import io
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path

SETS = {
    "Gyroscope": ("gx", "gy", "gz", "Gyroscope {} (rad/s)"),
    "Accelerometer": ("ax", "ay", "az", "Acceleration {} (m/s^2)"),
}
# phyphox tells the phone's model, the range of its sensors, and when the recording was started.
DEVICE = {
    "deviceModel": "Practice phone",
    "deviceManufacturer": "Nobody",
    "accelerometer Range": "78.4532",
    "gyroscope Range": "34.906586",
}
STARTED = 1_772_877_600.0
# A fixed date in the archives: the same session gives the same bytes.
DATE = (2026, 3, 7, 10, 0, 0)


def table(rows: Sequence[Sequence[object]]) -> str:
    """Rows as phyphox writes them: quoted texts, bare numbers."""
    text = io.StringIO()
    csv.writer(text, quoting=csv.QUOTE_NONNUMERIC, lineterminator="\n").writerows(rows)
    return text.getvalue()


def sensor(recording: list[dict[str, str]], x: str, y: str, z: str, title: str) -> str:
    """One sensor's samples; a row that it has none in is left out."""
    header = ",".join(f'"{name}"' for name in ("Time (s)", *(title.format(axis) for axis in "xyz")))
    rows = [[row["t"], row[x], row[y], row[z]] for row in recording if row[x]]
    lines = (",".join(f"{float(cell):.9E}" for cell in row) for row in rows)
    return "\n".join((header, *lines, ""))


def times(end_s: float) -> str:
    """When the recording was started and stopped."""
    header = ["event", "experiment time", "system time", "system time text"]
    events = [["START", 0.0, STARTED, "2026-03-07 10:00:00"], ["PAUSE", end_s, STARTED + end_s, "2026-03-07 10:02:04"]]
    return table([header, *events])


def export(recording: Path, output: Path) -> None:
    """Write one recording (``t,gx,gy,gz,ax,ay,az`` in s, rad/s, m/s²) as a phyphox zip."""
    with recording.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    files = {f"{name}.csv": sensor(rows, *columns) for name, columns in SETS.items()}
    files["meta/device.csv"] = table([["property", "value"], *([name, value] for name, value in DEVICE.items())])
    files["meta/time.csv"] = times(float(rows[-1]["t"]))
    with zipfile.ZipFile(output, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(zipfile.ZipInfo(name, DATE), text, zipfile.ZIP_DEFLATED)


def main(arguments: list[str]) -> int:
    """Export every recording of a session folder."""
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    session, output = Path(arguments[0]), Path(arguments[1])
    output.mkdir(parents=True, exist_ok=True)
    for recording in sorted(session.glob("*.csv")):
        made = output / f"{recording.stem}.zip"
        export(recording, made)
        print(made)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
