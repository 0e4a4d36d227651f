"""The procedure on a simulated hull, the live estimator and the recorder's file, as Python and the command see them."""

from __future__ import annotations

import io
import json
import math
import shutil
import time
from contextlib import nullcontext
from pathlib import Path

import numpy as np
import pytest
from conftest import assert_refused, run, seed
from rich.console import Console

import gyradius
from gyradius import practise_screen


@pytest.fixture(scope="module")
def practised(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, object], str]:
    """One practice run by itself, its first recording touched; the folder, its JSON and what it said."""
    folder = tmp_path_factory.mktemp("practice") / "hull"
    done = run("practise", "--auto", "-o", folder, "--mishap", "yaw-sway:1:slip", "--json", folder.parent / "out.json")
    assert done.returncode == 0, done.stderr
    return folder, json.loads((folder.parent / "out.json").read_text()), done.stdout


def test_a_practice_run_ends_at_the_truth(practised: tuple[Path, dict[str, object], str]) -> None:
    folder, found, said = practised
    assert "the phone moved on the hull" in said
    assert "you measured" in said
    assert "the simulated hull has 1.0566" in said
    compared = {row["name"]: row for row in found["compared"]}  # type: ignore[attr-defined]
    # A correct program is off by more than four of its own uncertainties less than once in 10 000 for each figure.
    for name in ("k_yaw_m", "k_pitch_m"):
        assert abs(compared[name]["value"] - compared[name]["true"]) < 4.0 * compared[name]["u"], compared[name]
    session = gyradius.load(folder / "session")
    assert session.swing_ids == ["yaw-sway", "surge-pitch"]
    # Nothing recorded is lost: the recording that slipped is there, and not in the session.
    assert len(list((folder / "takes").glob("*.gyr"))) == 3


def test_a_practice_that_was_begun_is_not_written_over_and_goes_on(
    practised: tuple[Path, dict[str, object], str],
) -> None:
    folder = practised[0]
    assert_refused(run("practise", "--auto", "-o", folder), 2, "has begun there already")
    done = run("practise", "--auto", "-o", folder, "--resume")
    assert done.returncode == 0, done.stderr
    assert "you measured" in done.stdout


def test_bad_use_is_refused(tmp_path: Path) -> None:
    assert_refused(run("practise", "-o", tmp_path / "a"), 2, "--auto")
    done = run("practise", "--auto", "-o", tmp_path / "b", "--mishap", "yaw")
    assert done.returncode == 2
    assert "STEP:TAKE:WHAT" in done.stderr
    assert_refused(run("practise", "--auto", "-o", tmp_path / "c", "--mishap", "yaw:1:flood"), 2, "bad_release")
    assert_refused(run("practise", "--auto", "-o", tmp_path / "d", "--resume"), 2, "procedure.journal")


def test_the_state_offers_what_may_be_done_and_refuses_the_rest(tmp_path: Path) -> None:
    rig = gyradius.read_rig(gyradius.shipped_rigs()["keelboat"])
    practice = gyradius.Practice(rig, tmp_path / "hull", seed=1)
    assert practice.state["phase"] == "start"
    with pytest.raises(gyradius.InputError, match="one of: begin"):
        practice.handle("accept")
    with pytest.raises(gyradius.InputError, match="an event as JSON"):
        practice.handle("dance")
    assert practice.advance(10.0) == 0.0
    event = practice.by_the_book()
    assert event is not None
    practice.handle(event.pop("event"), **event)
    assert practice.advance(3.0) == pytest.approx(3.0, abs=0.02)
    assert practice.state["tilt"]["against"] == "nothing"
    practice.handle("set_reference")
    assert practice.state["tilt"]["angle_deg"] < 0.1


def test_by_hand_finished_steps_are_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first step again before the second, and the second again after the result."""
    rig = gyradius.read_rig(gyradius.shipped_rigs()["keelboat"])
    practice = gyradius.Practice(rig, tmp_path / "hull", seed=1)
    console = Console(file=io.StringIO(), force_terminal=True, width=120)
    keys = {"ready": ["1"], "done": ["2"]}
    stood: list[tuple[str, int | None, int | None]] = []

    def pressed(_seconds: float) -> str:
        time.sleep(0.001)
        state = practice.state
        step = state["step"]
        place = None if step is None else step["index"]
        stood.append((state["phase"], place, None if step is None else step["take"]))
        # The key is for the second step; at the first there is nothing to go back to.
        wanted = keys.get(state["phase"], [])
        return wanted.pop() if wanted and place in (1, None) else "\r"

    monkeypatch.setattr(practise_screen, "_keys", lambda: nullcontext(pressed))
    practise_screen.play(console, practice, speed=5000.0, auto=False, critique=False)
    judged = [at[1:] for i, at in enumerate(stood) if at[0] == "judge" and stood[i - 1] != at]
    assert judged == [(0, 1), (0, 2), (1, 1), (1, 2)]
    assert stood[-1][0] == "done"
    screen = console.file.getvalue()
    for shown in (
        "1: make that step again",
        "1 to 2: make that step again",
        "yaw gyradius: you measured",
        "Enter: end",
    ):
        assert shown in screen


def test_a_recorders_file_is_read_and_imported(practised: tuple[Path, dict[str, object], str], tmp_path: Path) -> None:
    take = sorted((practised[0] / "takes").glob("*.gyr"))[-1]
    recorded = gyradius.read_recorder(take)
    assert recorded.phone == "simulated phone"
    assert recorded.damage == ()
    assert [key for _, key in recorded.events] == ["release", "end"]
    assert recorded.gyroscope is not None
    assert recorded.gyroscope.values.shape == (len(recorded.gyroscope.stamps_ns), 3)
    assert recorded.gyroscope_bias is None

    cut = tmp_path / "cut.gyr"
    cut.write_bytes(take.read_bytes()[:100_000])
    part = gyradius.read_recorder(cut)
    assert len(part.damage) == 1
    assert part.gyroscope is not None
    count = len(part.gyroscope.stamps_ns)
    assert np.array_equal(part.gyroscope.values, recorded.gyroscope.values[:count])

    done = run("import", cut, "-o", tmp_path / "session", "--line-length", "3.477:0.003", "--spacing", "1.8:0.001")
    assert done.returncode == 0, done.stderr
    assert "cut off" in done.stdout
    assert gyradius.load(tmp_path / "session").swing_ids == ["cut"]
    again = run("import", cut, "-o", tmp_path / "session", "--line-length", "3.477", "--spacing", "1.8")
    assert_refused(again, 2, "exists already")
    shutil.copy(practised[0] / "procedure.journal", tmp_path / "no.gyr")
    with pytest.raises(gyradius.InputError, match="a recorder's file"):
        gyradius.read_recorder(tmp_path / "no.gyr")


def test_the_live_estimator_follows_arrays() -> None:
    # A turn of 5 degrees with a period of 4 s, and noise of a phone.
    live, omega = gyradius.Live(wanted=1e-3), 2.0 * math.pi / 4.0
    noise = np.random.default_rng(seed())
    assert live.estimate["swing"] is None
    for start in range(0, 6000, 20):
        rows = np.arange(start, start + 20)
        values = noise.normal(0.0, 1e-3, (20, 3))
        values[:, 2] += math.radians(5.0) * omega * np.cos(omega * rows / 100.0)
        live.push_gyroscope(rows * 10_000_000, values)
    swing = live.estimate["swing"]
    assert abs(swing["period_s"] - 4.0) < 5.0 * swing["period_u_s"]
    assert swing["amplitude_deg"] == pytest.approx(5.0, abs=0.1)
    assert any("accelerometer gives no samples" in text for text in live.advice)
    with pytest.raises(gyradius.InputError, match="as many values as stamps"):
        live.push_gyroscope([0, 1], [[0.0, 0.0, 0.0]])
    with pytest.raises(gyradius.InputError, match="rows of x, y, z"):
        live.push_accelerometer([0], [[0.0, 0.0]])
    with pytest.raises(gyradius.InputError, match="above 0"):
        gyradius.Live(wanted=0.0)
