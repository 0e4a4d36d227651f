"""Real recordings, which lie beside the clone where there are any."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SHARED, run

import gyradius

DATA = SHARED / "data"
FAN = ["t=Time:ms", "gx=xGyro:deg/s", "gy=yGyro:deg/s", "gz=ZGyro:deg/s"]

pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="no ../shared/data beside this clone")


def test_phone_pendulum_has_the_period_of_its_notes() -> None:
    swing = gyradius.load(DATA / "phone-pendulum" / "Gyroscope.csv").measure().swings[0]
    # NOTES.md: 1.338 s ± 0.002 at small amplitude.
    assert abs(swing.modes[0].period_s - 1.338) < 0.002
    assert swing.repairs


@pytest.mark.parametrize("name", ["Pitch", "Roll", "Yaw"])
def test_ducted_fan_comes_through_with_its_stalls(name: str) -> None:
    path = next(path for path in (DATA / "ducted-fan").glob("*.csv") if path.name.startswith(name))
    swing = gyradius.load(path, mapping=FAN).measure().swings[0]
    assert swing.modes
    assert swing.repairs


@pytest.mark.parametrize("path", sorted((DATA / "light-gate-bar").glob("*.csv")), ids=lambda path: Path(path).stem)
def test_light_gate_logs_become_sessions(path: Path, tmp_path: Path) -> None:
    spacing, length = (part.split("-")[1].rstrip("m") for part in path.stem.split("_"))
    sizes = ["--line-length", length, "--spacing", spacing, "--flag-width", "0.006", "--gravity", "9.81256"]
    done = run("import", path, "-o", tmp_path / "s", *sizes)
    assert done.returncode == 0, done.stderr
    assert "k_yaw_m" in gyradius.load(tmp_path / "s").measure().quantities
