"""What stands out: nothing of what the base model can do, a known ramp by its formula, and strengths in proportion."""

import detect
import numpy as np
import pytest
import sessions
from borrowed import blind
from scene import move, sense

SHORT = 3000  # samples of each swing


@pytest.fixture(scope="module")
def drawn() -> sessions.Session:
    """Two short swings of the base model."""
    seed = blind.test_seed()
    print("seed", seed)
    session, _ = sessions.draw(np.random.default_rng(seed), "none")
    session.scenes, session.hungs = session.scenes[:2], session.hungs[:2]
    for tape in session.tapes:
        tape.scenes = [n for n in tape.scenes if n < 2]
    for scene in session.scenes:
        scene.shown_s = scene.shown_s[:SHORT]
    return session


@pytest.fixture(scope="module")
def reduced(drawn) -> tuple[detect.Study, detect.Reduced]:
    """Linearised, a steady drift among the base model's freedoms."""
    study = detect.Study(drawn)
    return study, detect.Reduced(study, True)


def test_what_the_base_model_can_do_leaves_nothing(reduced):
    """Another step, a mixture of parameters, both signs: below a hundredth of what it does to the readings."""
    study, base = reduced

    def put(session):
        for scene in session.scenes:
            scene.inertia_kg_m2 = scene.inertia_kg_m2 + np.diag([0, 1e-5, -2e-5]) * scene.inertia_kg_m2
            scene.centre_m = scene.centre_m + [0, 0, 3e-6]
            scene.phone.position_m = scene.phone.position_m + [1e-5, -2e-5, 1e-5]
            scene.extras["linear"] *= 1.0001
            scene.move = scene.move + 2e-5 * session.hungs[0].modes["yaw"].shape

    parts = study.difference(detect.Change(put, 1.0))
    whole = np.linalg.norm(np.concatenate(parts))
    priors = 2e-5 * detect.LOOSE["inertia"] + 1e-5 * detect.LOOSE["depth"]
    assert np.linalg.norm(base.orthogonal(parts)) < 0.01 * whole + priors


def test_beside_another_effect_all_that_it_may_be_is_open(drawn):
    """A drift along x beside one along y stands out of the base; a drift along any axis takes it up wholly, in both places."""
    drift = lambda rates: sessions.Hidden("bias_drift", {"gyro_rad_s": rates, "acc_m_s2": [0.0, 0.0, 0.0], "time_s": 1e7})
    found = detect.study(drawn, [drift([1e-2, 0.0, 0.0]), drift([0.0, 1e-2, 0.0])])["effects"]
    for effect in found:
        assert effect["signal_sigma"] > 10
        assert effect["beside_others_sigma"] < 0.01 * effect["signal_sigma"]


def test_a_drift_stands_out_as_a_ramp_does(drawn):
    """A slope b on one channel over N samples: b T √(N/12) / σ, less the little that the motion's parameters absorb."""
    hidden = [sessions.Hidden("bias_drift", {"gyro_rad_s": [1e-3, 0.0, 0.0], "acc_m_s2": [0.0, 0.0, 0.0], "time_s": 1e7})]
    found = detect.study(drawn, hidden)["effects"][0]
    expected = 0.0
    for scene in drawn.scenes:
        span, count = np.ptp(scene.shown_s), scene.shown_s.size
        expected += (1e-3 * span / 120.0 / scene.phone.gyro_noise) ** 2 * count / 12
    assert 0.9 * np.sqrt(expected) < found["signal_sigma"] < 1.01 * np.sqrt(expected)


def test_signals_are_in_proportion_to_weak_strengths(drawn):
    """Twice the drag stands out twice as far, and points the same way: along drag, and away from a drifting gyroscope."""
    make = lambda times: [sessions.Hidden("quadratic_drag", {"decay_s": [times] * 3 + [np.inf] + [times] * 2})]
    weak, strong = (detect.study(drawn, make(t))["effects"][0] for t in (2e5, 1e5))
    assert strong["signal_sigma"] == pytest.approx(2 * weak["signal_sigma"], rel=0.02)
    assert strong["largest_cosine"] == pytest.approx(weak["largest_cosine"], abs=0.02)
    assert weak["nearest"] == "power_law_damping"


def test_a_mistaken_tape_stands_out_by_what_contradicts_it(drawn):
    """A tape's mistake changes no reading; it is at most the mistake over the stated uncertainty, by figure."""
    line = next(t for t in drawn.tapes if t.what == "line")
    offset = 20 * line.stated["u"]
    found = detect.study(drawn, [sessions.Hidden("stated_length", {"offset_m": offset})])["effects"][0]
    figures = sum(t.what == "line" and bool(t.scenes) for t in drawn.tapes)
    most = np.sqrt(sum((offset / t.stated["u"]) ** 2 for t in drawn.tapes if t.what == "line" and t.scenes))
    assert figures and 0 < found["signal_sigma"] <= most * 1.001


def test_what_is_absorbed_does_not_stand_out_by_what_bends(drawn, monkeypatch):
    """Twisted lines raise the stiffness in yaw by a twentieth, which another inertia does as well: what is left does not depend on the
    step over which it is found. (Of a difference to one side a fiftieth of the bend is left, and a quarter of that over a quarter of it.)"""
    hidden = [sessions.Hidden("line_torsion", {"relative": 0.05})]
    found = []
    for back in (0.02, 0.005):
        monkeypatch.setattr(detect, "BACK", back)
        found.append(detect.study(drawn, hidden)["effects"][0]["signal_sigma"])
    assert found[0] == pytest.approx(found[1], rel=0.1, abs=0.5)


def test_a_limit_takes_away_from_what_shows(drawn):
    """Beside an accelerometer at its limit for a fifth of the time a clock shows no better than without: readings are a part of those."""
    clock = sessions.Hidden("clock_scale", {"relative": 0.05})
    readings = np.abs(np.concatenate([sense(s, move(s))[1] for s in drawn.scenes]))
    limit = sessions.Hidden("saturation", {"sensor": "acc", "limit": float(np.quantile(readings.max(axis=1), 0.8))})
    alone = detect.study(drawn, [clock])["effects"][0]["signal_sigma"]
    beside = detect.study(drawn, [limit, clock])["effects"][1]["signal_sigma"]
    assert 0 < beside <= 1.01 * alone


def test_a_second_slosh_that_weighs_nothing_leaves_nothing_beside_the_first(drawn):
    """However strong or weak the first, all of it is that of one; with a second as heavy, elsewhere and along another way, much is not."""
    seed = blind.test_seed()
    print("sliders' seed", seed)
    rng = np.random.default_rng(seed)
    omega = max(mode.omega_rad_s for mode in drawn.hungs[0].modes.values())
    slider = lambda share, way, times: {
        "mass_share": share, "place_m": [*rng.uniform(0.1, 0.2, 2), -0.1], "way": way, "damping_ratio": 0.05,
        "frequency_hz": times * omega / (2 * np.pi),
    }  # fmt: skip
    for share, stands_out in ((1e-12, False), (0.02, True)):
        sliders = [slider(0.02, [0.8, 0.6, 0.0], 1.1), slider(share, [-0.6, 0.8, 0.0], 0.7)]
        found = detect.study(drawn, [sessions.Hidden("second_slosh", {"sliders": sliders})])["effects"][0]
        assert found["signal_sigma"] > 0
        assert (found["beyond_best_cause_sigma"] > 1e-3 * found["signal_sigma"]) == stands_out
