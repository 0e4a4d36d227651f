"""The laws that only `wide.py` draws against closed forms and quadrature; what it draws; its tables on made-up answers."""

import json
from types import SimpleNamespace

import forces
import motion
import numpy as np
import pytest
import sessions
import wide
from borrowed import blind, rb
from effects import EFFECTS, OUTSIDE
from scene import readings, rig_of, start_of, tensions
from scipy.integrate import quad
from scipy.linalg import eigh
from scipy.special import ellipk
from test_generator import DEPTH, LINE, MASS, SPACING, SWAY, YAW, G, heading, peaks, scene, swung, yaw_period_s

STIFFNESS = MASS * G * SPACING**2 / (4 * LINE)


def test_at_large_amplitudes_the_motion_is_that_of_the_blind_sessions():
    """A hull turned by 50 degrees, its lines by 25: the two integrators agree to 1e-6 m and rad over 20 s."""
    rng = np.random.default_rng(blind.test_seed())
    hull, hungs = sessions.draw_hung(rng, False, sessions.USUAL)
    sizes = {"yaw": (50, 50), "sway": (25, 25), "pitch": (10, 10)}
    base, _ = sessions.draw_scene(rng, hull, hungs[0], blind.draw_phone(rng, hull), sizes)
    t, states = rb.integrate(hungs[0].rig, rb.displaced(hungs[0].rest, base.move, base.rate), 20.0, 0.02)
    rig = rig_of(base)
    start = start_of(base, rig)
    start[:13] = states[0, :, 0]  # put on the lines: far from rest each integrator has its own way to
    ours = motion.swing(rig, start, 0.0, t[1:], 0.0025)
    assert np.degrees(np.abs(heading(ours)).max()) > 30
    assert np.abs(ours[:, :7] - states[1:, :7, 0]).max() < 1e-6


def loss_per_turn(force, amplitude: float, omega: float) -> float:
    """Energy that a force of the rate takes in a turn of a sine."""
    return quad(
        lambda x: force(amplitude * omega * np.cos(x)) * amplitude * np.cos(x), 0, 2 * np.pi, points=[np.pi / 2, 3 * np.pi / 2]
    )[0]


def check_loss(s, force, first: int = 0) -> None:
    """Amplitudes fall from turn to turn by the energy that the force takes: κ A dA = -loss (first order)."""
    omega = 2 * np.pi / yaw_period_s(scene(YAW, 0.05))
    _, size = peaks(s.shown_s, heading(swung(s)))
    whole = size[first::2]
    middle = (whole[1:] + whole[:-1]) / 2
    expected = [loss_per_turn(force, a, omega) / (STIFFNESS * a) for a in middle]
    assert -np.diff(whole) == pytest.approx(expected, rel=0.03)
    assert -np.diff(whole).sum() == pytest.approx(np.sum(expected), rel=1e-2)


@pytest.mark.parametrize("crossover", [0.01, 0.1])
def test_drag_crosses_over_from_linear_to_quadratic(crossover):
    """Below and about the crossover; far above it the law is that of quadratic drag, far below that of linear drag."""
    s = scene(YAW, 0.05)
    s.extras["quadratic"][0, YAW], s.extras["crossover"][0, YAW] = 30.0, crossover
    check_loss(s, lambda u: 30.0 * u * np.hypot(u, crossover))


def test_slow_sliding_holds_more_than_fast():
    """Coulomb friction with Stribeck's dip takes more of small turns than Coulomb's alone."""
    s = scene(YAW, 0.05)
    s.extras["coulomb"][0, YAW], s.extras["dip"], s.extras["dip_speed"][0, YAW] = 0.05, 0.8, 0.04
    check_loss(s, lambda u: 0.05 * np.tanh(u / forces.SLIDING) * (1 + 0.8 * np.exp(-((u / 0.04) ** 2))))


def test_creep_by_a_power_of_time():
    """Nothing at the start, its amount at its span; rate and acceleration are the length's derivatives."""
    rig = motion.blank()
    rig["line"], rig["creep"], rig["creep_power"] = LINE, [0.01, 5.0], 1 / 3
    at = lambda t: motion.length(rig[0], 0, t)
    assert at(1e-12)[0] == pytest.approx(LINE, abs=1e-12)
    assert at(forces.CREEP_SPAN)[0] == pytest.approx(LINE + 0.01, abs=1e-12)
    grown = lambda t: (5.0 + t) ** (1 / 3) - 5.0 ** (1 / 3)
    assert (at(20.0)[0] - LINE) / (at(80.0)[0] - LINE) == pytest.approx(grown(20.0) / grown(80.0), rel=1e-9)
    h = 1e-3
    for k in (0, 1):
        assert at(20.0)[k + 1] == pytest.approx((at(20.0 + h)[k] - at(20.0 - h)[k]) / (2 * h), rel=1e-6)


def with_pendulum(s, share: float, rod_m: float, start_m: float) -> None:
    """A bob at the height of the centre, swinging athwartships."""
    e = s.extras[0]
    e["slider_mass"][0], e["slider_place"][0], e["slider_way"][0] = share * MASS, [0.0, 0.0, -DEPTH], [0, 1, 0]
    e["slider_rod"][0], e["slider_start"][0] = rod_m, [start_m, 0.0]


def test_an_internal_pendulum_and_the_hull_swing_as_two_masses():
    """In sway the hull only translates: K = diag(M g / l, m g / L), the bob's mass in both; let go in a mode, they stay in it."""
    rod_m, m = 0.5, 0.05 * MASS
    mass, stiffness = np.array([[MASS, m], [m, m]]), np.diag([MASS * G / LINE, m * G / rod_m])
    squares, shapes = eigh(stiffness, mass)
    for square, (hull, bob) in zip(squares, shapes.T):
        s = scene(SWAY, 0.002, 100.0)
        with_pendulum(s, 0.05, rod_m, 0.002 * bob / hull)
        parts = np.column_stack([f(w * s.shown_s) for w in np.sqrt(squares) for f in (np.cos, np.sin)])
        sizes = np.hypot(*np.linalg.lstsq(parts, swung(s)[:, 1], rcond=None)[0].reshape(2, 2).T)
        assert sizes[squares != square] < 0.01 * sizes[squares == square]


def test_a_light_pendulum_far_out_has_the_period_of_a_circular_pendulum():
    """A bob of a millionth lets the hull hang still; its pull on it has the period 4 √(L/g) K(sin² θ/2) at θ = 1 rad."""
    rod_m = 0.4
    s = scene(SWAY, 0.0, 30.0)
    with_pendulum(s, 1e-6, rod_m, rod_m * 1.0)
    pull = swung(s)[:, 11]
    exact = 4 * np.sqrt(rod_m / G) * ellipk(np.sin(0.5) ** 2)
    slow = np.column_stack([f(np.sqrt(G / LINE) * s.shown_s) for f in (np.cos, np.sin)])
    tones = lambda period: np.column_stack(
        [slow, *(f(2 * np.pi * k / period * s.shown_s)[:, None] for k in (1, 3) for f in (np.cos, np.sin))]
    )
    residual = lambda period: np.linalg.norm(pull - tones(period) @ np.linalg.lstsq(tones(period), pull, rcond=None)[0])
    tried = exact * (1 + np.linspace(-0.01, 0.01, 41))
    assert tried[np.argmin([residual(p) for p in tried])] == pytest.approx(exact, rel=1e-3)
    assert residual(exact) < 0.05 * np.linalg.norm(pull)


def test_a_one_sided_spring_shortens_half_the_turn():
    """π/ω on the free side, π/ω' on the other."""
    s = scene(YAW, 0.02)
    s.extras["torsion_one_sided"] = 20.0
    ratio = yaw_period_s(s) / yaw_period_s(scene(YAW, 0.02))
    assert ratio == pytest.approx((1 + (1 + 20.0 / STIFFNESS) ** -0.5) / 2, rel=2e-5)


def test_filtered_noise_has_its_variance_and_its_correlation_time():
    """Autocovariance σ² exp(-t/T), over 2000 correlation times."""
    noise = wide.ornstein_uhlenbeck(np.random.default_rng(3), 0.7, 10.0, 0.5, 40_000)
    for lag in (0, 1, 20, 40):
        assert np.mean(noise[lag:] * noise[: len(noise) - lag]) == pytest.approx(0.49 * np.exp(-lag * 0.5 / 10), abs=0.05)


def test_a_breeze_blows_as_its_samples_say():
    """At the samples it is theirs, a straight rise stays one; of a constant breeze the hull leans as of a mean."""
    rig = motion.blank()
    rig["breeze_step"], rig["breeze"][0, :, 1] = 0.5, 0.3 * np.arange(forces.BREEZE_SIZE) * 0.5
    for t in (-6.0, 0.1, 20.27, 600.0):
        assert forces.breeze(rig[0], t, 1) == pytest.approx(0.3 * (t - forces.BREEZE_FROM_S), abs=1e-9)
    leans = []
    for mean, breeze in ((3.0, 0.0), (1.0, 2.0)):
        s = scene(SWAY, 0.0, 20.0)
        s.extras["wind_area"], s.extras["wind"], s.extras["linear"] = [1.0, 2.0], [0.0, mean], 20.0
        s.extras["breeze_step"], s.extras["breeze"][0, :, 1] = 0.5, breeze
        leans.append(swung(s)[:, 1])
    assert np.abs(leans[0] - leans[1]).max() < 1e-12
    assert np.abs(leans[0]).max() > 1e-3


def test_lines_pull_as_a_pendulum_does():
    """In sway both carry m (g cos θ + l θ'²), shared so that there is no torque on the hull; one with its weight aside hangs by levers."""
    s = scene(SWAY, 0.8, 10.0)
    at = swung(s)
    sine = at[:, 1] / LINE
    cosine = np.sqrt(1 - sine**2)
    both = MASS * G * (3 * cosine - 2 * cosine.min())
    unlike = -both * DEPTH * sine / cosine / (SPACING / 2)
    assert tensions(s, at) == pytest.approx((both[:, None] + unlike[:, None] * [1, -1]) / 2, rel=2e-3)
    s = scene(SWAY, 0.0, 1.0)
    s.centre_m[1] += 0.1
    at = np.zeros((1, motion.OUT))
    at[0, :4] = [0, 0.1, -LINE - DEPTH, 1]
    assert tensions(s, at)[0] == pytest.approx(MASS * G * np.array([0.6, 0.4]))


def test_steps_are_fine_enough(drawn):
    """Halving the step moves readings by less than a twentieth of their noise, at the amplitudes that are drawn."""
    for kind in ("none", "stribeck_friction", "pendulum_slosh", "gusty_wind", "support_compliance", "one_sided_spring"):
        s = sessions.spoiled(*drawn[kind][:2]).scenes[0]
        for a, b, noise in zip(readings(s, 0.005), readings(s, 0.0025), (s.phone.gyro_noise, s.phone.acc_noise)):
            assert np.abs(a - b).max() < noise / 20, kind


@pytest.fixture(scope="module")
def drawn() -> dict[str, tuple]:
    """A session of every kind, its swings as short as may be."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(wide, "drawn_duration_s", lambda rng: 15.0)
        return {kind: wide.draw(np.random.default_rng([7, n]), kind) for n, kind in enumerate(wide.KINDS)}


def test_every_kind_is_drawn_as_asked(drawn):
    """Its laws, line lengths where one would not do, eight swings where asked for, rates and lengths within their ranges."""
    for kind, (session, hidden, _) in drawn.items():
        assert [h.name for h in hidden] == [kind.partition(",")[0]] or kind in ("none", "pair")
        assert 2 <= len(session.scenes) <= 8
        phone = session.scenes[0].phone
        assert 20 <= min(phone.gyro_rate_hz, phone.acc_rate_hz) <= max(phone.gyro_rate_hz, phone.acc_rate_hz) <= 200
    rng = np.random.default_rng(1)
    lasting = np.array([wide.drawn_duration_s(rng) for _ in range(1000)])
    assert 15 <= lasting.min() <= 30 and 300 <= lasting.max() <= 600 and 0.85 < np.mean((lasting > 30) & (lasting < 180))
    assert len(drawn[wide.EIGHT][0].scenes) == 8
    assert len({scene.line_m[0] for scene in drawn["constant_torsion"][0].scenes}) == 2
    assert len(drawn["pair"][1]) == 2
    assert any(scene.acc_shown_s is not None for session, *_ in drawn.values() for scene in session.scenes)


def test_a_constant_torsion_does_not_scale_with_the_line(drawn):
    """The same torque per radian at both line lengths."""
    session, hidden, _ = drawn["constant_torsion"]
    assert len({float(scene.extras["torsion"][0]) for scene in sessions.spoiled(session, hidden).scenes}) == 1


def test_names_are_those_of_the_catalogue():
    """Causes that are right are in the catalogue; the laws that are outside it have none; none is drawn by the generator unasked."""
    for name, law in wide.LAWS.items():
        assert set(law.names) <= set(EFFECTS)
        assert not (law.names and name in OUTSIDE)
        assert law.put is None or name not in EFFECTS | OUTSIDE


def test_a_seed_gives_the_same_session(tmp_path, monkeypatch):
    """Twice the same text, with a rate of its own for each sensor where the truth says so."""
    monkeypatch.setattr(wide, "drawn_duration_s", lambda rng: 15.0)
    monkeypatch.setattr(wide, "STYLES", wide.STYLES[:1])
    number = next(n for n in range(20) if not wide.draw(np.random.default_rng([5, n]), "gusty_wind")[0].scenes[0].phone.one_clock)
    for folder in (tmp_path / "a", tmp_path / "b"):
        folder.mkdir()
        wide.make(folder, 5, number, "gusty_wind")
    texts = [{p.name: p.read_text() for p in folder.rglob("*") if p.is_file()} for folder in (tmp_path / "a", tmp_path / "b")]
    assert texts[0] == texts[1]
    truth = json.loads(texts[0][f"{number:04d}.truth.json"])
    rows = [line.split(",") for line in next(text for name, text in texts[0].items() if name.endswith(".csv")).splitlines()[1:]]
    gyro, acc = sum(row[1] != "" for row in rows), sum(row[4] != "" for row in rows)
    assert gyro / acc == pytest.approx(truth["rates_hz"][0] / truth["rates_hz"][1], rel=0.05)
    assert len(rows) == gyro + acc
    assert truth["sigma"][0] > 0


def made_up(kind: str, status: str, causes=(), others=(), yaw_off: float = 0.0, base_off: float = 0.0) -> wide.Judged:
    """A session with an answer; offsets in uncertainties of 1 mm."""
    laws = [] if kind == "none" else kind.split("+")
    truth = {"kind": kind, "hidden": [{"name": name, "parameters": {"relative": 0.01}} for name in laws], "sigma": [20.0] * len(laws),
             "k_yaw_m": 1.0, "k_pitch_m": 1.0, "sizes_deg": {"a": {"yaw": 5.0}}, "rates_hz": [50.0, 50.0], "lasting_s": [60.0],
             "mass_kg": 10.0, "swings": {"a": {}}}  # fmt: skip
    model = lambda off: {
        "rms_over_noise": 1.0,
        "quantities": {q: {"value": 1 + 1e-3 * off, "u": 1e-3} for q in ("k_yaw_m", "k_pitch_m")},
    }
    verdict = {"status": status, "causes": list(causes), "indistinguishable_from": list(others)}
    return wide.Judged("x", truth, {"verdict": verdict, "baseline": model(base_off), "extended": model(yaw_off)}, "", 1.0)


def test_answers_are_distinguished():
    """Each column of the table, the cause's sort counting; a silent failure; an answer that is missing."""
    assert made_up("gusty_wind", "explained", ["wind"]).answer() == "named right"
    assert made_up("crossover_drag", "explained", ["power_law_damping"]).answer() == "named right"
    assert made_up("gusty_wind", "explained", ["wind", "line_creep"]).answer() == "named otherwise"
    assert made_up("knock", "explained", ["wind"]).answer() == "named otherwise"
    assert made_up("power_creep", "ambiguous", ["wind"], ["line_creep"]).answer() == "ambiguous with it"
    assert made_up("knock", "ambiguous", ["wind"], ["line_creep"]).answer() == "ambiguous without it"
    assert made_up("gusty_wind+power_creep", "explained", ["line_creep", "wind"]).answer() == "named right"
    assert made_up("gusty_wind+power_creep", "explained", ["line_creep"]).answer() == "named otherwise"
    missing = wide.Judged("x", made_up("none", "adequate").truth, None, "exit 1", 1.0)
    assert missing.answer() == "no answer"
    assert made_up("none", "adequate", yaw_off=4.0).is_silent()
    assert not made_up("none", "adequate", yaw_off=2.5).is_silent()
    assert not made_up("none", "unexplained", yaw_off=9.0).is_silent()
    assert not missing.is_silent()


def test_the_tables_count_what_happened():
    """Inside, nearer than the base, silent, faint; a missing answer is counted and does no harm."""
    found = [
        made_up("gusty_wind", "explained", ["wind"], yaw_off=1.0, base_off=5.0),
        made_up("power_creep", "adequate", yaw_off=4.0, base_off=4.0),
        wide.Judged("y", made_up("none", "adequate").truth, None, "no answer in 600 s", 600.0),
    ]
    text = wide.report(found)
    assert "| explained | 1/1 | 1/1 |" in text
    assert "| adequate | 0/1 | 0/1 |" in text
    assert "| k_yaw_m | 2 | 1 | 1 | 0 |" in text
    assert "above 3 σ: x." in text
    assert text.count("+4.0 → +4.0 u") == 4  # k_yaw and k_pitch, among the silent ones and among all
    assert "no answer in 600 s" in text


def test_a_run_goes_on_where_it_was_stopped(tmp_path, monkeypatch):
    """Sessions with an answer are not run again, others are; a folder with sessions is refused without --resume, or of another seed."""
    answer = {"verdict": {"status": "adequate", "causes": [], "indistinguishable_from": []}}
    asked = []
    short = made_up("none", "adequate")
    monkeypatch.setattr(
        wide,
        "make",
        lambda out, seed, n, kind: (out / f"{n:04d}.truth.json").write_text(json.dumps(short.truth | {"seed": [1, n]})),
    )
    monkeypatch.setattr(
        wide.judge, "critique", lambda command, folder: (asked.append(folder.name), (short.result | answer, ""))[1]
    )
    options = lambda count: SimpleNamespace(command="gyradius critique", first=0, count=count, kind=None)
    wide.judge_all(options(2), 1, tmp_path)
    wide.judge_all(options(3), 1, tmp_path)
    assert asked == ["0000", "0001", "0002"]
    wide.checked(tmp_path, 1, True)
    for seed, resumed in ((1, False), (2, True)):
        with pytest.raises(SystemExit):
            wide.checked(tmp_path, seed, resumed)
