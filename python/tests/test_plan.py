"""The plan: what the command says, what the API gives, and what each kind of bad input gets."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from conftest import TYPED, assert_refused, parsed, run

import gyradius

KEELBOAT = {"mass": 622.7, "length": 6.35, "beam": 1.73, "boat_type": "keelboat"}
OPTIONS = ("--mass", "622.7", "--length", "6.35", "--beam", "1.73", "--type", "keelboat")


@pytest.fixture(scope="module")
def plan() -> gyradius.Plan:
    """The paper's keelboat, lines of no more than four metres."""
    return gyradius.plan(**KEELBOAT, wanted=["k_yaw=0.2%", "k_pitch=0.5%"], means={"most_line_length_m": 4.0})


def test_views_agree_with_the_json(plan: gyradius.Plan) -> None:
    data = json.loads(plan.to_json())
    assert data["format"] == plan.format == "gyradius-plan/1"
    assert data == plan.to_dict()
    assert [swing.id for swing in plan.predicted] == [step["swing"]["id"] for step in data["steps"]]
    assert plan.quantities["k_yaw_m"].u == data["quantities"]["k_yaw_m"]["u"]
    assert plan.warnings[0].text == data["warnings"][0]["text"]


def test_the_plan_reaches_what_is_wanted(plan: gyradius.Plan) -> None:
    for name, relative in (("k_yaw_m", 2e-3), ("k_pitch_m", 5e-3)):
        quantity = plan.quantities[name]
        assert quantity.u is not None
        assert quantity.is_reached
        assert quantity.u <= quantity.wanted_u == pytest.approx(relative * quantity.value)
        contributions = sum(line.u_contribution**2 for line in plan.budget[name])
        assert math.sqrt(contributions) == pytest.approx(quantity.u, rel=1e-3)


def test_periods_are_those_of_the_equations(plan: gyradius.Plan) -> None:
    swing = next(step for step in plan.steps if isinstance(step, gyradius.PlannedSwing))
    length, half = (swing.suspension[key]["value"] for key in ("line_length_m", "spacing_m"))
    k = plan.hull["k_yaw_m"]["value"]
    # (5) and (7)
    assert swing.periods_s["sway"] == pytest.approx(2.0 * math.pi * math.sqrt(length / 9.80665), rel=1e-9)
    assert swing.periods_s["yaw"] == pytest.approx(swing.periods_s["sway"] * k / (0.5 * half), rel=2e-2)
    assert length <= 4.0


def test_a_rehearsal_of_the_plan_measures_the_assumed_hull(plan: gyradius.Plan, tmp_path: Path) -> None:
    rig = tmp_path / "rig.toml"
    rig.write_text(plan.rig_toml(), encoding="utf-8")
    gyradius.read_rig(rig).write(tmp_path / "session", seed=5)
    found = gyradius.load(tmp_path / "session").measure().quantities
    for name in ("k_yaw_m", "k_pitch_m", "cm_depth_m"):
        expected = plan.hull[name]["value"]
        assert abs(found[name].value - expected) < 5.0 * found[name].u, name
        planned = plan.quantities[name].u
        assert planned is not None
        assert 0.5 < planned / found[name].u < 2.0, name


def test_the_command_prints_and_writes(tmp_path: Path) -> None:
    session, rig = tmp_path / "session.toml", tmp_path / "rig.toml"
    done = run("plan", *OPTIONS, "--wanted", "k_yaw=0.2%", "-o", session, "--rig", rig)
    assert done.returncode == 0, done.stderr
    for word in ("B-F", "yaw", "What is expected", "reached", "Session to fill in"):
        assert word in done.stdout
    text = session.read_text(encoding="utf-8")
    assert 'format = "gyradius-session/1"' in text
    assert 'format = "gyradius-rig/1"' in rig.read_text(encoding="utf-8")
    assert_refused(run("plan", *OPTIONS, "-o", session), 2, "exists already")


def test_json_to_standard_output_is_json_alone() -> None:
    done = run("plan", *OPTIONS, "--wanted", "k_yaw=0.2%", "--json", "-")
    assert done.returncode == 0, done.stderr
    assert parsed(done.stdout)["format"] == "gyradius-plan/1"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], ("mass",)),
        (["--mass", "600"], ("length",)),
        (["--mass", "600", "--length", "6", "--beam", "2"], ("type of boat",)),
        ([*OPTIONS[:-1], "submarine"], ("keelboat, dinghy", "submarine")),
        ([*OPTIONS, "--wanted", "k_yaw"], ("QUANTITY=UNCERTAINTY",)),
        ([*OPTIONS, "--wanted", "k_surge=1%"], ("k_yaw, k_pitch", "k_surge")),
        ([*OPTIONS, "--wanted", "k_yaw=-1%"], ("above 0",)),
        ([*OPTIONS, "--max-height", "0"], ("most_line_length_m", "positive")),
        ([*OPTIONS, "--tell-apart", "line_creep,line_torsion"], ("session",)),
        (["no-such-session"], ("no-such-session",)),
    ],
)
def test_bad_input_is_named(arguments: list[str], words: tuple[str, ...]) -> None:
    assert_refused(run("plan", *arguments), 2, *words)


def test_what_cannot_be_reached_says_what_limits() -> None:
    plan = gyradius.plan(**KEELBOAT, wanted=["k_yaw=0.01%"])
    assert plan.quantities["k_yaw_m"].is_reached is False
    limit = next(w for w in plan.warnings if w.kind == "spacing_too_short")
    assert "k_yaw" in limit.text
    assert limit.numbers["u_input_needed_mm"] < 1.0 < limit.numbers["spacing_needed_m"]


def test_a_session_of_periods_is_planned_on(tmp_path: Path) -> None:
    (tmp_path / "session.toml").write_text(TYPED, encoding="utf-8")
    session = gyradius.load(tmp_path)
    plan = gyradius.plan(session, wanted=["k_yaw=0.2%"])
    measured = session.measure().quantities["k_yaw_m"]
    assert plan.hull["k_yaw_m"] == {"value": measured.value, "u": measured.u}
    assert plan.hull["sources"]["k_yaw_m"] == "measured so far"


def test_two_causes_are_told_apart_by_a_swing_on_other_lines(tmp_path: Path) -> None:
    # A line that is longer than stated and one that stretches look alike until the length changes.
    (tmp_path / "session.toml").write_text(TYPED, encoding="utf-8")
    session = gyradius.load(tmp_path)
    with pytest.raises(gyradius.InputError, match="stated_length"):
        gyradius.plan(session, tell_apart=("stated_length", "gremlins"))
    with pytest.raises(gyradius.InputError, match="different"):
        gyradius.plan(session, tell_apart=("stated_length", "stated_length"))
    plan = gyradius.plan(session, tell_apart=("stated_length", "stated_spacing"))
    assert plan.tells_apart is not None
    (swing,) = plan.steps
    assert isinstance(swing, gyradius.PlannedSwing)
    assert swing.suspension["line_length_m"]["value"] == plan.tells_apart.line_length_m
    assert plan.tells_apart.sigma > 3.0
