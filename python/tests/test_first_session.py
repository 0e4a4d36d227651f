"""A first result: figures as people write them, the questions, the session that comes of them, and the check."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from conftest import assert_refused, run
from rich.console import Console
from typer.testing import CliRunner

import gyradius
from gyradius import session_commands
from gyradius.arguments import Figure, figure
from gyradius.checking import limits
from gyradius.cli import app
from gyradius.dialogue import Dialogue, Question, hanging, position
from gyradius.summary import show_summary

LINE = Question("line_length", "metres", "length of the lines")


@pytest.mark.parametrize(
    ("text", "of", "value", "u"),
    [
        ("3.477", "metres", 3.477, None),
        ("3.477:0.006", "metres", 3.477, 0.006),
        ("347.7cm", "metres", 3.477, None),
        ("150.3 cm", "metres", 1.503, None),
        ("347.7cm:0.6", "metres", 3.477, 0.006),
        ("3.477m ± 6mm", "metres", 3.477, 0.006),
        ("3.477+/-0.006", "metres", 3.477, 0.006),
        ("11ft", "metres", 3.3528, None),
        ("200g", "kilograms", 0.2, None),
        ("100 lb:1", "kilograms", 45.359237, 0.45359237),
        ("-4.5°:0.3", "degrees", -4.5, 0.3),
        ("9.81 m/s²", "m/s²", 9.81, None),
        ("1e-3", "metres", 0.001, None),
    ],
)
def test_figures_as_people_write_them(text: str, of: str, value: float, u: float | None) -> None:
    # Exact in decimals: a foot is 0.3048 m and a pound 0.45359237 kg by definition.
    assert figure(text, of) == Figure(value, u)


@pytest.mark.parametrize(
    ("text", "of", "hint"),
    [
        ("3,477", "metres", "3.477"),
        ("200kg", "metres", "cm"),
        ("two", "metres", "3.477:0.006"),
        ("3.4:-0.1", "metres", "colon"),
        ("1e999", "metres", "metres"),
        ("3 4", "metres", "metres"),
        ("", "metres", "metres"),
    ],
)
def test_what_is_no_figure_is_told_how_to_write_it(text: str, of: str, hint: str) -> None:
    with pytest.raises(ValueError, match="expected") as error:
        figure(text, of)
    assert hint in str(error.value)


def test_an_option_that_is_no_figure_is_named() -> None:
    done = run("import", "x.csv", "-o", "y", "--line-length", "3,477")
    assert_refused(done, 2, "--line-length", "metres", "point: 3.477")
    assert_refused(run("plan", "--mass", "3 stone"), 2, "--mass", "kilograms")


def answers(*given: str) -> tuple[Callable[[str], str], list[str]]:
    left: Iterator[str] = iter(given)
    asked: list[str] = []

    def ask(words: str) -> str:
        asked.append(words)
        return next(left)

    return ask, asked


def test_a_question_is_asked_until_the_answer_can_be_read() -> None:
    said: list[str] = []
    ask, asked = answers("", "3,4", "3.4 m ± 2 mm")
    assert Dialogue(ask, said.append).figure(LINE, None, True) == Figure(3.4, 0.002)
    assert len(asked) == 3
    assert any("3.4" in line for line in said)


def test_what_is_stated_is_not_asked() -> None:
    ask, asked = answers("", "")
    known = {"line_length": Figure(2.0, None), "spacing": Figure(1.5, 0.001)}
    found = hanging(Dialogue(ask, print), "bifilar", known)
    assert found == {"line_length": 2.0, "spacing": (1.5, 0.001)}
    # The two that may be left out were asked for.
    assert len(asked) == 2


def test_without_a_terminal_the_options_that_are_missing_are_named(recorded: Path, tmp_path: Path) -> None:
    done = run("new", recorded / "yaw-sway.csv", "-o", tmp_path / "s")
    assert_refused(done, 2, "--suspension", "bifilar")
    done = run("new", recorded / "yaw-sway.csv", "-o", tmp_path / "s", "--suspension", "bifilar")
    assert_refused(done, 2, "--orientation", "athwartships")
    done = run("new", recorded / "yaw-sway.csv", "-o", tmp_path / "s", *HUNG)
    assert_refused(done, 2, "--line-length", "metres")
    assert not (tmp_path / "s").exists()


def test_positions() -> None:
    assert position("0.5 0 -10cm") == (0.5, 0.0, -0.1)
    with pytest.raises(ValueError, match="three numbers"):
        position("0.5 0")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two recordings of the rig that ships, whose truth is known."""
    folder = tmp_path_factory.mktemp("recorded") / "rig"
    gyradius.read_rig(gyradius.shipped_rigs()["keelboat"]).write(folder, seed=5)
    return folder


HUNG = ("--suspension", "bifilar", "--orientation", "athwartships")
FIGURES = (*HUNG, "--line-length", "347.7cm:3mm", "--spacing", "1.8:0.001", "--mass", "622.7:0.5", "--no-open")


def test_recordings_become_a_result_and_a_report(recorded: Path, tmp_path: Path) -> None:
    files = [recorded / "yaw-sway.csv", recorded / "surge-pitch.csv"]
    phone = ("--phone-mass", "200g:1", "--phone-position", "0.5 0 -10cm")
    done = run("new", *files, "-o", tmp_path / "boat", *FIGURES, *phone, "--json", tmp_path / "out.json")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert any(line.startswith("  Yaw gyradius") for line in lines)
    # The rig's yaw takes 4.391 s, Table 1 of the paper.
    assert any(line.startswith("  yaw-sway: ") and "yaw 4.39" in line for line in lines), lines
    assert (tmp_path / "boat" / "report.html").read_text(encoding="utf-8").startswith("<!")
    found = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    assert found["report"].endswith("report.html")
    yaw = found["measurement"]["quantities"]["k_yaw_m"]
    truth = json.loads(Path(f"{recorded}.truth.json").read_text(encoding="utf-8"))
    true = truth_of(truth, "k_yaw_m")
    # Fixed seed; five standard uncertainties, and room for the phone that nobody weighed in the rig.
    assert abs(yaw["value"] - true) < 5.0 * yaw["u"] + 2e-4
    session = gyradius.load(tmp_path / "boat")
    assert sorted(session.swing_ids) == ["surge-pitch", "yaw-sway"]
    text = (tmp_path / "boat" / "session.toml").read_text(encoding="utf-8")
    assert "mass = { value = 0.2, u = 0.001 }" in text
    assert "position = [0.5, 0.0, -0.1]" in text
    assert "line_length = { value = 3.477, u = 0.003 }" in text


def truth_of(truth: dict[str, object], name: str) -> float:
    """A figure of the truth file, wherever it stands."""
    if name in truth:
        return float(truth[name])  # type: ignore[arg-type]
    inner = [value for value in truth.values() if isinstance(value, dict) and name in value]
    return float(inner[0][name])


def test_the_questions_on_a_terminal(recorded: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two lines, across; the length; the spacing; no other figure; the second file hung alike."""
    opened: list[Path] = []
    monkeypatch.setattr(session_commands, "is_terminal", lambda json: True)
    monkeypatch.setattr(session_commands, "open_in_browser", opened.append)
    files = [str(recorded / "yaw-sway.csv"), str(recorded / "surge-pitch.csv")]
    given = "\n".join(["1", "1", "3.477:0.003", "-1.8", "1.8", "", "", "", "", ""]) + "\n"
    done = CliRunner().invoke(app, ["new", *files, "-o", str(tmp_path / "asked")], input=given)
    assert done.exit_code == 0, done.output
    assert opened == [tmp_path / "asked" / "report.html"]
    assert "two lines" in done.output
    assert sorted(gyradius.load(tmp_path / "asked").swing_ids) == ["surge-pitch", "yaw-sway"]


def test_a_report_of_another_form_is_refused_before_the_work(tmp_path: Path) -> None:
    done = run("report", gyradius.shipped_session("keelboat"), "-o", tmp_path / "report.docx")
    assert_refused(done, 2, "report.docx", ".pdf")


def test_check_tells_what_to_mend_and_what_limits() -> None:
    done = run("check", gyradius.shipped_session("keelboat"))
    assert done.returncode == 0, done.stderr
    assert "contradicts itself" in done.stdout
    assert "What limits each quantity" in done.stdout
    found = json.loads(run("check", gyradius.shipped_session("keelboat"), "--json", "-").stdout)
    assert found["format"] == "gyradius-check/1"
    assert {"widened", "warned", "noted"} == {one["severity"] for one in found["findings"]}


def test_the_limit_is_the_largest_part_of_the_variance() -> None:
    measurement = gyradius.load(gyradius.shipped_session("keelboat")).measure()
    (limit,) = [one for one in limits(measurement) if one.quantity == "k_yaw_m"]
    lines = measurement.budget["k_yaw_m"]
    assert limit.input == lines[0].input
    assert math.isclose(limit.fraction, lines[0].u_contribution ** 2 / sum(one.u_contribution**2 for one in lines))
    assert limit.relative_u is not None
    assert math.isclose(limit.relative_u, measurement.quantities["k_yaw_m"].u / measurement.quantities["k_yaw_m"].value)


def test_check_of_a_session_that_lacks_a_figure_names_it(recorded: Path, tmp_path: Path) -> None:
    assert run("import", recorded / "yaw-sway.csv", "-o", tmp_path / "s").returncode == 0
    assert_refused(run("check", tmp_path / "s"), 2, "line_length", "line 2")


def test_the_result_comes_first_and_the_details_on_request() -> None:
    session = gyradius.shipped_session("model-hull")
    short, long = run("measure", session).stdout, run("measure", session, "-v").stdout
    head = [line.strip().split("  ")[0] for line in short.splitlines()[1:6]]
    assert head == [
        "Yaw gyradius",
        "Pitch gyradius",
        "Roll gyradius",
        "Depth of centre of mass",
        "Tilt ψ of principal axes",
    ]
    assert "Uncertainty budget" not in short
    for title in ("Swings", "Closed-form estimates", "Uncertainty budget", "Consistency tests"):
        assert title in long


def test_the_demo_fits_on_a_screen(tmp_path: Path) -> None:
    done = run("demo", "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) <= 40


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--axis-height", "1.2"), ("--axis-height", "bifilar")),
        (("--spacing", "-1.8"), ("--spacing", "above 0")),
        (("--line-length", "3.477:4"), ("--line-length", "uncertainty below")),
        (("--hull-pitch", "100"), ("--hull-pitch", "below 90")),
        (("--phone-mass", "800", "--phone-position", "0 0 0"), ("--phone-mass", "not less")),
        (("--phone-mass", "0.2"), ("--phone-position",)),
    ],
)
def test_what_no_body_can_have_is_refused_and_leaves_nothing(
    options: tuple[str, ...], words: tuple[str, ...], recorded: Path, tmp_path: Path
) -> None:
    done = run("new", recorded / "yaw-sway.csv", "-o", tmp_path / "s", *FIGURES, *options)
    assert_refused(done, 2, *words)
    assert not (tmp_path / "s").exists()


def test_what_cannot_end_well_is_refused_before_anything_is_asked(recorded: Path, tmp_path: Path) -> None:
    one, other = recorded / "yaw-sway.csv", recorded / "surge-pitch.csv"
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "letter.txt").write_text("dear")
    for words, args in {
        "twice": [one, one, "-o", tmp_path / "s"],
        "missing.zip": [one, tmp_path / "missing.zip", "-o", tmp_path / "s"],
        "--replace": [one, "-o", tmp_path / "full"],
        "every recording": [one, other, "-o", tmp_path / "s", "--hull-pitch", "12"],
    }.items():
        assert_refused(run("new", *args, *FIGURES), 2, words)
        assert not (tmp_path / "s").exists()


def test_json_holds_the_reason_of_a_figure_that_cannot_be_read(recorded: Path) -> None:
    done = run("new", recorded / "yaw-sway.csv", "--spacing", "1,8", "--json", "-")
    assert done.returncode == 2
    error = json.loads(done.stdout)["error"]
    assert error["kind"] == "input"
    assert "1.8" in error["message"]


def test_the_end_of_the_input_ends_the_questions(
    recorded: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session_commands, "is_terminal", lambda json: True)
    arguments = ["new", str(recorded / "yaw-sway.csv"), "-o", str(tmp_path / "s")]
    assert CliRunner().invoke(app, arguments, input="1\n").exit_code == 130
    assert not (tmp_path / "s").exists()


def test_a_narrow_terminal_cuts_no_figure() -> None:
    session = gyradius.shipped_session("keelboat")
    value = gyradius.load(session).measure().quantities["k_yaw_m"]
    console = Console(width=40, file=io.StringIO())
    show_summary(console, gyradius.load(session).measure())
    shown = " ".join(console.file.getvalue().split())  # type: ignore[attr-defined]
    assert f"{value.value:.4f} ± {value.u:.4f} m" in shown
