"""The command: exit status, standard output, JSON and what each kind of bad input gets."""

from __future__ import annotations

import io
import json
import os
import pty
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import TYPED, assert_refused, parsed, run, swing_csv
from typer.testing import CliRunner

import gyradius
from gyradius.cli import app

SWING = """\
format = "gyradius-session/1"
title = "one swing"
[body]
mass = 100.0
[[swing]]
id = "yaw-1"
recording = "yaw-1.csv"
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = 2.0
spacing = 1.0
"""


def test_help_names_the_commands() -> None:
    done = run("--help")
    assert done.returncode == 0
    for command in ("demo", "measure", "critique", "report", "import", "plan", "routes"):
        assert command in done.stdout


def test_no_command_shows_help_and_is_bad_usage() -> None:
    assert run().returncode == 2
    assert run("dance").returncode == 2
    assert run("measure").returncode == 2


def test_json_to_standard_output_is_json_alone() -> None:
    done = run("measure", gyradius.shipped_session("keelboat"), "--json", "-")
    assert done.returncode == 0, done.stderr
    data = parsed(done.stdout)
    assert data["format"] == "gyradius-measurement/1"
    assert done.stderr == ""


def test_json_file_has_the_bytes_of_the_api(tmp_path: Path) -> None:
    target = tmp_path / "m.json"
    path = gyradius.shipped_session("keelboat")
    done = run("measure", path, "--json", target)
    assert done.returncode == 0, done.stderr
    assert target.read_text(encoding="utf-8").rstrip("\n") == gyradius.load(path).measure().to_json().rstrip("\n")
    assert "Yaw gyradius" in done.stdout


def test_json_has_the_keys_of_the_contract() -> None:
    data = json.loads(run("measure", gyradius.shipped_session("boat-park"), "--json", "-").stdout)
    keys = {"format", "swings", "quantities", "alternatives", "budget", "consistency", "warnings"}
    assert keys <= data.keys()
    mode_keys = {
        "mode",
        "period_s",
        "period_se_s",
        "decay_time_s",
        "decay_time_se_s",
        "amplitude",
        "amplitude_unit",
    }
    names = [
        "yaw",
        "sway",
        "pitch_in_phase",
        "pitch_out_of_phase",
        "roll_in_phase",
        "roll_out_of_phase",
        "compound",
        "other",
    ]
    for swing in data["swings"]:
        assert {"id", "modes", "repairs", "warnings"} <= swing.keys()
        for mode in swing["modes"]:
            assert mode_keys <= mode.keys()
            assert mode["mode"] in names
    for quantity in data["quantities"].values():
        assert {"value", "u", "method"} <= quantity.keys()
    for route in (route for routes in data["alternatives"].values() for route in routes):
        assert {"method", "value", "u"} <= route.keys()
    for line in (line for lines in data["budget"].values() for line in lines):
        assert {"input", "u_contribution"} <= line.keys()
    for claim in data["consistency"]:
        assert {"claim", "stated", "implied", "sigma", "from"} <= claim.keys()
    assert {"k_yaw_m", "k_pitch_m", "cm_depth_m"} <= data["quantities"].keys()


def test_keelboat_line_length_is_flagged_as_the_paper_implies() -> None:
    data = json.loads(run("measure", gyradius.shipped_session("keelboat"), "--json", "-").stdout)
    claim = next(claim for claim in data["consistency"] if claim["claim"] == "line_length")
    # Stated 3.477 m; the periods of Tables 1 and 2 imply about 3.59 to 3.63 m.
    assert abs(claim["stated"] - 3.477) < 1e-9
    assert 3.58 < claim["implied"] < 3.64
    assert claim["flagged"]


def test_limit_is_judged_and_a_bad_one_refused() -> None:
    path = gyradius.shipped_session("keelboat")
    done = run("measure", path, "--limit", "k_yaw_m>=1.000", "--json", "-")
    assert json.loads(done.stdout)["verdicts"][0]["quantity"] == "k_yaw_m"
    assert_refused(run("measure", path, "--limit", "k_yaw_m~1"), 2, "limit")


def test_report_as_html_and_pdf(tmp_path: Path) -> None:
    path = gyradius.shipped_session("boat-park")
    html, pdf = tmp_path / "r.html", tmp_path / "r.pdf"
    assert run("report", path, "-o", html, "--no-critique").returncode == 0
    assert html.read_text(encoding="utf-8").lstrip().lower().startswith("<!doctype html>")
    assert run("report", path, "-o", pdf, "--no-critique").returncode == 0
    assert pdf.read_bytes().startswith(b"%PDF-")


def test_report_in_german(tmp_path: Path) -> None:
    path, html = gyradius.shipped_session("keelboat"), tmp_path / "r.html"
    assert run("report", path, "-o", html, "--no-critique", "--language", "de").returncode == 0
    assert '<html lang="de">' in html.read_text(encoding="utf-8")
    assert_refused(run("report", path, "-o", html, "--language", "fr"), 2, "language")


def test_report_into_a_folder_that_is_not_there(tmp_path: Path) -> None:
    missing = tmp_path / "no" / "r.html"
    assert_refused(run("report", gyradius.shipped_session("keelboat"), "-o", missing, "--no-critique"), 2, str(missing))


def test_json_into_a_folder_that_is_not_there_is_refused_before_the_work(tmp_path: Path) -> None:
    missing = tmp_path / "no" / "r.json"
    refused = run("measure", gyradius.shipped_session("keelboat"), "--json", missing)
    assert_refused(refused, 2, str(missing))
    assert not refused.stdout, "it has measured before it refused"


def test_demo_ends_by_naming_the_report(tmp_path: Path) -> None:
    done = run("demo", "-o", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    last = tmp_path / done.stdout.strip().splitlines()[-1].split()[-1]
    assert last.suffix == ".html"
    assert last.is_file()
    for name in gyradius.shipped_sessions():
        assert (tmp_path / "out" / f"{name}.json").is_file()


def test_routes_are_listed() -> None:
    done = run("routes", "--json", "-")
    assert done.returncode == 0, done.stderr
    assert len(json.loads(done.stdout)) >= 10


def test_runner_agrees_with_the_process(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["measure", str(tmp_path / "nothing"), "--json", "-"])
    assert result.exit_code == 2
    assert json.loads(result.stdout)["error"]["kind"] == "input"


def test_a_reader_that_goes_away_is_no_error() -> None:
    command = [sys.executable, "-m", "gyradius", "measure", str(gyradius.shipped_session("boat-park"))]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    assert b"Traceback" not in process.stderr.read()
    process.wait()


def test_terminal_gets_tables_and_nothing_breaks() -> None:
    master, slave = pty.openpty()
    command = [sys.executable, "-m", "gyradius", "measure", str(gyradius.shipped_session("keelboat"))]
    environment = {**os.environ, "TERM": "xterm-256color", "COLUMNS": "120"}
    done = subprocess.Popen(command, stdout=slave, stderr=slave, env=environment)
    os.close(slave)
    shown = b""
    while True:
        try:
            block = os.read(master, 65536)
        except OSError:
            break
        if not block:
            break
        shown += block
    assert done.wait() == 0
    assert b"Yaw gyradius" in shown


# What a user can hand over that is not a session, and the words that must come back.


def test_nothing_there(tmp_path: Path) -> None:
    assert_refused(run("measure", tmp_path / "nothing"), 2, "nothing")


def test_folder_without_session(tmp_path: Path) -> None:
    assert_refused(run("measure", tmp_path), 2, "session.toml")


def test_error_is_in_the_json_too(tmp_path: Path) -> None:
    target = tmp_path / "m.json"
    done = run("measure", tmp_path / "nothing", "--json", target)
    assert done.returncode == 2
    error = json.loads(target.read_text())["error"]
    assert error["message"] in done.stderr


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ["session.toml", "format"]),
        ("this is not toml", ["session.toml", "line 1"]),
        (TYPED.replace("gyradius-session/1", "gyradius-session/9"), ["format", "line 1"]),
        (TYPED.replace("line_length", "line_lenght"), ["line_lenght", "line_length", "line 14"]),
        (TYPED.replace("3.477", "-3.477"), ["line_length", "line 14"]),
        (TYPED.replace("u = 0.006", "u = -0.006"), ["line_length", "line 14"]),
        (TYPED.replace("3.477", '"long"'), ["line_length", "line 14"]),
        (TYPED.replace('"bifilar"', '"quadrifilar"'), ["bifilar", "line 12"]),
        (TYPED.replace("spacing = ", "# "), ["spacing"]),
        (TYPED + TYPED[TYPED.index("[[swing]]") :], ["table-1"]),
        (SWING, ["yaw-1.csv", "line 7"]),
        (SWING.replace('"yaw-1.csv"', '"../yaw-1.csv"'), ["line 7"]),
        (SWING.replace('"yaw-1.csv"', '"/etc/passwd"'), ["line 7"]),
    ],
)
def test_bad_session_files(folder: Callable[..., Path], text: str, words: list[str]) -> None:
    assert_refused(run("measure", folder(text)), 2, *words)


HEADER = "t,gx,gy,gz,ax,ay,az\n"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", ["yaw-1.csv"]),
        (HEADER, ["yaw-1.csv"]),
        ("some,other,columns\n1,2,3\n", ["yaw-1.csv", "t"]),
        (swing_csv().replace("0.4000,", "0.4000,fast", 1), ["yaw-1.csv", "line"]),
        (HEADER + "0,nan,nan,nan,nan,nan,nan\n" * 100, ["yaw-1.csv"]),
    ],
)
def test_recordings_that_cannot_be_read(folder: Callable[..., Path], content: str, words: list[str]) -> None:
    session = folder(SWING)
    (session / "yaw-1.csv").write_text(content)
    done = run("measure", session)
    assert_refused(done, 2, *words)


def test_ten_samples_give_no_result(folder: Callable[..., Path]) -> None:
    session = folder(SWING)
    (session / "yaw-1.csv").write_text("\n".join(swing_csv().splitlines()[:11]) + "\n")
    done = run("measure", session, "--json", "-")
    assert_refused(done, 1)
    assert parsed(done.stdout)["error"]


def test_hull_at_rest_gives_no_result(folder: Callable[..., Path]) -> None:
    session = folder(SWING)
    rows = [f"{i / 50:.2f},0.001,0.0,0.0,0.0,0.0,9.81" for i in range(3000)]
    (session / "yaw-1.csv").write_text(HEADER + "\n".join(rows) + "\n")
    done = run("measure", session, "--json", "-")
    assert_refused(done, 1)


def _gyroscope_only(text: str) -> str:
    return "\n".join(",".join(row.split(",")[:4]) for row in text.splitlines()) + "\n"


def _two_swings(text: str) -> str:
    """At 40 s of 60 the hull is touched: from there it swings the other way round."""
    rows = [row.split(",") for row in text.splitlines()]
    turned = [[*row[:3], str(-float(row[3])), *row[4:]] if float(row[0]) > 40.0 else row for row in rows[1:]]
    return "\n".join(",".join(row) for row in [rows[0], *turned]) + "\n"


def _nan_run(text: str) -> str:
    rows = text.splitlines()
    rows[500:520] = [row.split(",")[0] + ",nan,nan,nan,nan,nan,nan" for row in rows[500:520]]
    return "\n".join(rows) + "\n"


def _backwards(text: str) -> str:
    rows = text.splitlines()
    rows[500], rows[501] = rows[501], rows[500]
    return "\n".join(rows) + "\n"


@pytest.mark.parametrize(
    ("damage", "repairs", "status"),
    [
        # Its period is found; which motion it belongs to cannot be told.
        (_gyroscope_only, set(), 1),
        (_nan_run, {"not_a_number"}, 0),
        (_backwards, {"backward_stamp"}, 0),
        (_two_swings, {"second_swing"}, 0),
    ],
)
def test_damage_is_survived_and_reported(
    folder: Callable[..., Path], damage: Callable[[str], str], repairs: set[str], status: int
) -> None:
    session = folder(SWING)
    (session / "yaw-1.csv").write_text(damage(swing_csv(period_s=2.0)))
    done = run("measure", session, "--json", "-")
    assert done.returncode == status, done.stderr
    swing = json.loads(done.stdout)["swings"][0]
    assert abs(swing["modes"][0]["period_s"] - 2.0) < 0.002
    assert repairs <= {repair["kind"] for repair in swing["repairs"]}


def _zip(path: Path, members: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return path


def test_zip_gives_what_the_folder_gives(tmp_path: Path) -> None:
    source = gyradius.shipped_session("keelboat")
    members = {path.name: path.read_bytes() for path in source.iterdir() if path.is_file()}
    path = _zip(tmp_path / "keelboat.zip", members)
    assert gyradius.load(path).measure().to_json() == gyradius.load(source).measure().to_json()


@pytest.mark.parametrize(
    ("name", "reason"), [("../yaw-1.csv", "climbs out"), ("/yaw-1.csv", "absolute"), ("a\\yaw-1.csv", "backslash")]
)
def test_zip_that_climbs_out_is_refused(tmp_path: Path, name: str, reason: str) -> None:
    path = _zip(tmp_path / "climb.zip", {"session.toml": SWING.encode(), name: swing_csv().encode()})
    assert_refused(run("measure", path), 2, "climb.zip", name, reason)


def test_zip_with_a_link_is_refused(tmp_path: Path) -> None:
    path = _zip(tmp_path / "link.zip", {"session.toml": SWING.encode()})
    link = zipfile.ZipInfo("yaw-1.csv")
    link.create_system, link.external_attr = 3, 0o120777 << 16
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(link, "/etc/passwd")
    assert_refused(run("measure", path), 2, "link.zip", "yaw-1.csv", "symbolic link")


def test_zip_with_two_files_of_one_name_is_refused(tmp_path: Path) -> None:
    path = _zip(tmp_path / "doubled.zip", {"session.toml": SWING.encode(), "yaw-1.csv": swing_csv().encode()})
    with zipfile.ZipFile(path, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("yaw-1.csv", swing_csv())
    assert_refused(run("measure", path), 2, "doubled.zip", "two files of one name")


def test_zip_bomb_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("session.toml", SWING)
        with archive.open("yaw-1.csv", "w", force_zip64=True) as member:
            block = bytes(1 << 20)
            for _ in range(1200):
                member.write(block)
    assert_refused(run("measure", path), 2, "bomb.zip", "yaw-1.csv", "200 times")


def test_file_that_is_cut_zip_is_refused(tmp_path: Path) -> None:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("session.toml", TYPED)
    path = tmp_path / "cut.zip"
    path.write_bytes(buffer.getvalue()[:60])
    assert_refused(run("measure", path), 2, "cut.zip")
