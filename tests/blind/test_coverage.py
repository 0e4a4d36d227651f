"""The stated intervals on sessions that nobody has seen, and the judge that counts them on made-up programs."""

import os

import coverage
import generate
import numpy as np
import pytest

COUNT = int(os.environ.get("BLIND_N", "14"))


def test_intervals_hold_on_unseen_sessions(tmp_path):
    """Fresh sessions of every kind, the program as its users run it, the strict table printed."""
    pytest.importorskip("gyradius", reason="the package is not installed")
    seed = generate.test_seed()
    print(f"seed {seed}, {COUNT} sessions: tests/blind/coverage.py --count {COUNT} --seed {seed}")
    outcomes = coverage.run(tmp_path, generate.generate(tmp_path, seed, COUNT))
    coverage.report(outcomes)
    assert coverage.reasons_in_a_few(outcomes) == []


def made_up(rng, count: int, honest: float) -> list[coverage.Outcome]:
    """A program whose errors are `1 / honest` times what it states."""
    outcomes = []
    truth = {"k_yaw_m": 1.0, "k_pitch_m": 1.0, "cm_depth_m": 0.3, "psi_deg": 0.0}
    mode = {"yaw": {"period_s": 2.0}}
    truth["swings"] = {"s": {"excited": ["yaw"], "modes": mode, "hull_pitch_deg": 0.0, "clock_error": 0.0}}
    for n in range(count):
        quantities = {}
        for q in ("k_yaw_m", "k_pitch_m", "cm_depth_m"):
            quantities[q] = {"value": truth[q] + rng.normal(0, 0.001), "u": 0.001 * honest}
        result = {"quantities": quantities, "swings": [{"id": "s", "modes": [{"mode": "yaw", "period_s": 2.0}]}]}
        outcomes.append(coverage.judge_session(str(n), truth, result, ""))
    return outcomes


def test_an_honest_program_passes_and_a_boastful_one_fails():
    """400 honest programs, and 20 whose stated uncertainty is half of what it should be."""
    seed = generate.test_seed()
    print("seed", seed)
    rng = np.random.default_rng(seed)
    failures = sum(bool(coverage.judge(made_up(rng, 14, 1.0))[1]) for _ in range(400))
    assert failures <= 5  # at most 0.4 expected; six or more has probability 4e-6
    assert all(coverage.judge(made_up(rng, 200, 0.5))[1] for _ in range(20))


def test_every_trouble_is_a_reason_to_fail():
    """A crash, a wrong name, a mode not found, a quantity that is absent."""
    truth = made_up(np.random.default_rng(1), 1, 1.0)[0].truth
    fine = {q: {"value": truth[q], "u": 0.001} for q in ("k_yaw_m", "k_pitch_m", "cm_depth_m")}
    modes = lambda *pairs: [{"id": "s", "modes": [{"mode": m, "period_s": t} for m, t in pairs]}]
    cases = {
        "exit -6": (None, "exit -6: "),
        "wrong mode name: x: s: sway": ({"quantities": fine, "swings": modes(("yaw", 2.0), ("sway", 1.5))}, ""),
        "wrong mode name: x: s: yaw": ({"quantities": fine, "swings": modes(("yaw", 2.1))}, ""),
        "mode not found": ({"quantities": fine, "swings": modes(("other", 2.0))}, ""),
        "absent": ({"quantities": {}, "swings": modes(("yaw", 2.0))}, ""),
    }
    for reason, (result, trouble) in cases.items():
        reasons = coverage.judge([coverage.judge_session("x", truth, result, trouble)])[1]
        assert any(reason in r for r in reasons), reason
    clean = coverage.judge_session("x", truth, {"quantities": fine, "swings": modes(("yaw", 2.0))}, "")
    assert coverage.judge([clean])[1] == []
