"""``gyradius import`` and ``gyradius.import_files``: a session from exports of phones."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from conftest import assert_refused, run, swing_csv

import gyradius


def foreign_csv(path: Path) -> Path:
    """A logger nobody knows: milliseconds, degrees per second, g with the sign of iOS."""
    rows = ["Clock;wx;wy;wz;fx;fy;fz"]
    for line in swing_csv().splitlines()[1:]:
        t, gx, gy, gz, ax, ay, az = (float(cell) for cell in line.split(","))
        rate = [math.degrees(g) for g in (gx, gy, gz)]
        force = [-a / 9.80665 for a in (ax, ay, az)]
        rows.append(";".join(f"{cell:.7g}" for cell in (1000 * t, *rate, *force)))
    path.write_text("\n".join(rows) + "\n")
    return path


MAPPING = ["t=Clock:ms"]
MAPPING += [f"g{axis}=w{axis}:deg/s" for axis in "xyz"]
MAPPING += [f"a{axis}=f{axis}:-g" for axis in "xyz"]


def test_mapped_columns_become_a_session_that_can_be_measured(tmp_path: Path) -> None:
    source = foreign_csv(tmp_path / "log.csv")
    mapped = [word for entry in MAPPING for word in ("--map", entry)]
    sizes = ["--line-length", "2.0:0.001", "--spacing", "1.0:0.001", "--mass", "100:0.1", "--title", "My boat"]
    done = run("import", source, "-o", tmp_path / "s", *mapped, *sizes)
    assert done.returncode == 0, done.stderr
    session = gyradius.load(tmp_path / "s")
    assert session.title == "My boat"
    assert session.swing_ids == ["log"]
    mode = session.measure().swings[0].modes[0]
    assert mode.mode == "yaw"
    # The file holds a swing of 2 s as it is seen; with the suspension known, the small-amplitude period is shorter.
    assert mode.period_observed_s == pytest.approx(2.0, abs=1e-4)
    assert mode.period_s < mode.period_observed_s


def test_dimensions_stand_in_the_session_as_they_were_stated(tmp_path: Path) -> None:
    (tmp_path / "tilted.csv").write_text(swing_csv())
    sizes = ["--line-length", "2", "--spacing", "1", "--top-spacing", "1.1"]
    tilt = ["--hull-pitch=-12:0.2", "--points-moved=-0.05:0.001"]
    done = run("import", tmp_path / "tilted.csv", "-o", tmp_path / "s", *sizes, *tilt)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "s" / "session.toml").read_text()
    for line in (
        "top_spacing = 1.1",
        "hull_pitch_deg = { value = -12.0, u = 0.2 }",
        "points_moved = { value = -0.05, u = 0.001 }",
    ):
        assert line in text, text
    gyradius.load(tmp_path / "s")


def test_bare_foreign_recording_is_measured_by_its_mapping(tmp_path: Path) -> None:
    session = gyradius.load(foreign_csv(tmp_path / "log.csv"), mapping=MAPPING)
    assert round(session.measure().swings[0].modes[0].period_s, 3) == 2.0


def test_without_dimensions_the_session_says_what_is_missing(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    done = run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s")
    assert done.returncode == 0, done.stderr
    assert "line_length and spacing" in done.stdout
    assert_refused(run("measure", tmp_path / "s"), 2, "line_length")
    assert run("measure", tmp_path / "s" / "yaw.csv").returncode == 0


def test_nothing_is_overwritten_unless_asked(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    sizes = ["--line-length", "2", "--spacing", "1"]
    arguments = ["import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *sizes]
    assert run(*arguments).returncode == 0
    assert_refused(run(*arguments), 2, "exists")
    assert run(*arguments, "--replace").returncode == 0


def test_two_files_of_one_name_become_two_swings(tmp_path: Path) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "yaw.csv").write_text(swing_csv())
    files = [tmp_path / folder / "yaw.csv" for folder in ("a", "b")]
    gyradius.import_files(files, tmp_path / "s", line_length=2.0, spacing=(1.0, 0.001))
    assert gyradius.load(tmp_path / "s").swing_ids == ["yaw", "yaw-2"]


@pytest.mark.parametrize("entry", ["gx", "gx=", "gx=wx", "gx=wx:furlong", "wheel=wx:rad/s", "gx=wx:ms"])
def test_bad_mappings_are_bad_usage(tmp_path: Path, entry: str) -> None:
    assert_refused(run("import", foreign_csv(tmp_path / "log.csv"), "-o", tmp_path / "s", "--map", entry), 2)


@pytest.mark.parametrize("value", ["long", "1:x", ""])
def test_bad_quantities_are_bad_usage(tmp_path: Path, value: str) -> None:
    source = foreign_csv(tmp_path / "log.csv")
    assert_refused(run("import", source, "-o", tmp_path / "s", "--line-length", value), 2)


def test_unknown_table_names_its_header(tmp_path: Path) -> None:
    assert_refused(run("import", foreign_csv(tmp_path / "log.csv"), "-o", tmp_path / "s"), 2, "log.csv", "Clock")


def test_missing_export(tmp_path: Path) -> None:
    assert_refused(run("import", tmp_path / "nothing.zip", "-o", tmp_path / "s"), 2, "nothing.zip")


SIZES = ["--line-length", "2.0:0.001", "--spacing", "1.0:0.001"]


def test_a_session_grows_and_keeps_its_text(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    (tmp_path / "up.csv").write_text(swing_csv(period_s=2.5))
    assert run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *SIZES).returncode == 0
    file = tmp_path / "s" / "session.toml"
    file.write_text(file.read_text() + "# mine\n")
    before = file.read_text()
    done = run("import", tmp_path / "up.csv", "--into", tmp_path / "s", "--like", "yaw", "--hull-pitch", "12:0.2")
    assert done.returncode == 0, done.stderr
    assert file.read_text().startswith(before)
    assert "hull_pitch_deg = { value = 12.0, u = 0.2 }" in file.read_text()[len(before) :]
    assert gyradius.load(tmp_path / "s").swing_ids == ["yaw", "up"]


def test_a_planned_swing_gets_its_recording(tmp_path: Path) -> None:
    plan = gyradius.plan(mass=622.0, length=6.35, beam=1.73, boat_type="keelboat", wanted=["k_yaw=0.2%"])
    folder = tmp_path / "planned"
    folder.mkdir()
    (folder / "session.toml").write_text(plan.session_toml())
    first = next(step.id for step in plan.steps if isinstance(step, gyradius.PlannedSwing))
    (tmp_path / "take.csv").write_text(swing_csv())
    notes = gyradius.import_into([tmp_path / "take.csv"], folder, swing=first)
    assert any(first in note for note in notes)
    assert (folder / f"{first}.csv").is_file()
    assert (folder / "session.toml").read_text() == plan.session_toml()


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--into", "s"], "line_length and spacing"),
        (["--into", "s", *SIZES, "-o", "t"], "together with -o"),
        (["--into", "s", *SIZES, "--title", "T"], "--title"),
        (["--into", "gone", *SIZES], "gone"),
        (["--like", "yaw", "-o", "t"], "--into is missing"),
    ],
)
def test_what_does_not_fit_a_session_is_refused(tmp_path: Path, options: list[str], told: str) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    (tmp_path / "up.csv").write_text(swing_csv(period_s=2.5))
    assert run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *SIZES).returncode == 0
    placed = [str(tmp_path / option) if option in ("s", "t", "gone") else option for option in options]
    assert_refused(run("import", tmp_path / "up.csv", *placed), 2, told)
    assert not (tmp_path / "t").exists()
    assert not (tmp_path / "gone").exists()


def test_import_alone_gives_the_next_command(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    done = run("import", tmp_path / "yaw.csv", "--mass", "100")
    assert done.returncode == 0, done.stderr
    command = done.stdout.splitlines()[-1]
    assert command.strip().startswith("gyradius import")
    assert command.endswith("--output SESSION --mass=100 --line-length M:U --spacing M:U")
    assert [path.name for path in tmp_path.iterdir()] == ["yaw.csv"]


def test_what_is_usual_and_not_stated_stands_as_comments(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    assert run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *SIZES).returncode == 0
    text = (tmp_path / "s" / "session.toml").read_text()
    for key in ("mass", "gravity", "excited", "top_spacing", "hull_pitch_deg"):
        assert f"# {key} = " in text
    assert '# name = "phone"' in text


def test_three_lines_and_a_free_swing_are_imported(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    (tmp_path / "up.csv").write_text(swing_csv(period_s=2.5))
    (tmp_path / "free.csv").write_text(swing_csv(period_s=3.0))
    round_ = ["--suspension", "trifilar", "--line-length", "2:0.002", "--radius", "0.25:0.001", "--mass", "100:0.1"]
    assert run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *round_).returncode == 0
    text = (tmp_path / "s" / "session.toml").read_text()
    assert 'kind = "trifilar"' in text
    assert "radius = { value = 0.25, u = 0.001 }" in text
    alike = run("import", tmp_path / "up.csv", "--into", tmp_path / "s", "--like", "yaw", "--radius", "0.3:0.002")
    assert alike.returncode == 0, alike.stderr
    free = run("import", tmp_path / "free.csv", "--into", tmp_path / "s", "--suspension", "free")
    assert free.returncode == 0, free.stderr
    assert gyradius.load(tmp_path / "s").swing_ids == ["yaw", "up", "free"]


def test_a_figure_of_another_kind_of_suspension_is_refused(tmp_path: Path) -> None:
    (tmp_path / "yaw.csv").write_text(swing_csv())
    assert_refused(run("import", tmp_path / "yaw.csv", "-o", tmp_path / "s", *SIZES, "--radius", "0.3"), 2, "radius")
    assert not (tmp_path / "s").exists()
