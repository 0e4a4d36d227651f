"""The generator's motion against another integrator and against closed forms; its sessions from their seeds."""

import json

import motion
import numpy as np
import pytest
import sessions
import tomllib
from borrowed import blind, rb
from effects import EFFECTS, OUTSIDE
from scene import Flaws, Mount, Scene, move, readings, rig_of, start_of
from scipy.interpolate import CubicSpline
from scipy.linalg import eigh
from scipy.optimize import brentq
from scipy.special import gamma

G, MASS, LINE, SPACING, DEPTH = 9.81, 100.0, 2.0, 1.0, 0.3
INERTIA = np.diag([10.0, 60.0, 64.0])
YAW, SWAY, SURGE = 5, 1, 0
STEP_S = 0.004


def phone(**more) -> blind.Phone:
    """At the middle, axes those of the hull, a perfect clock."""
    zero = np.zeros(3)
    turn = np.array([[1.0], [0], [0], [0]])
    return blind.Phone(zero, turn, 1e-3, 1e-2, zero, zero, 0.0, 100.0, 100.0, True, **more)


def scene(coordinate: int, amplitude: float, duration_s: float = 60.0, **more) -> Scene:
    """A hull released with one coordinate displaced."""
    displaced = np.zeros(6)
    displaced[coordinate] = amplitude
    lines, times = np.full(2, LINE), np.arange(0, duration_s, 0.02)
    centre = np.array([0.0, 0.0, -DEPTH])
    return Scene(MASS, centre, INERTIA.copy(), G, lines, SPACING, SPACING, displaced, np.zeros(6), times, phone(), **more)


def heading(at: np.ndarray) -> np.ndarray:
    """Of a motion, rad."""
    return 2 * np.arctan2(at[:, 6], at[:, 3])


def peaks(times: np.ndarray, angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """When and how far: the extremes between zeros of the slope."""
    curve = CubicSpline(times, angle)
    slope = curve.derivative()
    rate = slope(times)
    at = [brentq(slope, times[i], times[i + 1]) for i in np.flatnonzero(rate[:-1] * rate[1:] < 0)]
    return np.array(at), np.abs(curve(at))


def period_s(times: np.ndarray, angle: np.ndarray) -> float:
    """Mean period, from the first to the last zero."""
    curve = CubicSpline(times, angle)
    at = [brentq(curve, times[i], times[i + 1]) for i in np.flatnonzero(angle[:-1] * angle[1:] < 0)]
    return 2 * (at[-1] - at[0]) / (len(at) - 1)


def swung(scene_: Scene) -> np.ndarray:
    """The motion, at a fixed fine step."""
    return move(scene_, STEP_S)


def yaw_period_s(scene_: Scene) -> float:
    return period_s(scene_.shown_s, heading(swung(scene_)))


def test_without_effects_the_motion_is_that_of_the_blind_sessions():
    """A drawn hull with everything set going: the two integrators agree to 1e-7 m and rad over 40 s."""
    seed = blind.test_seed()
    print("seed", seed)
    rng = np.random.default_rng(seed)
    hull, hungs = sessions.draw_hung(rng, False, sessions.USUAL)
    base, _ = sessions.draw_scene(rng, hull, hungs[0], blind.draw_phone(rng, hull))
    rest = hungs[0].rest
    t, states = rb.integrate(hungs[0].rig, rb.displaced(rest, base.move, base.rate), 40.0, 0.02)
    rig = rig_of(base)
    ours = motion.swing(rig, start_of(base, rig), 0.0, t[1:], 0.0025)
    assert np.abs(ours[:, :7] - states[1:, :7, 0]).max() < 1e-7
    assert np.abs(ours[:, 7:10] - states[1:, 10:, 0]).max() < 3e-7


@pytest.mark.parametrize("exponent", [1.6, 2.0])
def test_drag_takes_amplitude_as_its_power_law_says(exponent):
    """d(1/A^(n-1))/dt = (n-1) F B / (2π I V^n) ω^(n-1): exact to first order in the loss (Nayfeh and Mook 1979, 3.1)."""
    s = scene(YAW, 0.05)
    omega = 2 * np.pi / yaw_period_s(s)
    torque = 0.02  # at 0.1 rad/s
    if exponent == 2.0:
        s.extras["quadratic"][0, YAW] = torque / 0.1**2
    else:
        s.extras["power"][0, YAW], s.extras["exponent"] = torque, exponent
    times, size = peaks(s.shown_s, heading(swung(s)))
    law = np.polyfit(times, size ** (1 - exponent), 1)[0]
    turn = 2 * np.sqrt(np.pi) * gamma(exponent / 2 + 1) / gamma(exponent / 2 + 1.5)  # 8/3 at n = 2
    expected = (exponent - 1) * torque / 0.1**exponent * turn * omega ** (exponent - 1) / (2 * np.pi * INERTIA[2, 2])
    assert law == pytest.approx(expected, rel=4e-3)


def test_coulomb_friction_takes_amplitude_linearly():
    """Each half turn takes 2 τ/κ; the heave and the amplitude's part in the stiffness are below 1 % at 3 degrees."""
    s = scene(YAW, 0.05)
    s.extras["coulomb"][0, YAW] = torque = 0.05
    _, size = peaks(s.shown_s, heading(swung(s)))
    stiffness = MASS * G * SPACING**2 / (4 * LINE)
    assert np.diff(size) == pytest.approx(np.full(size.size - 1, -2 * torque / stiffness), rel=0.03)
    assert np.mean(np.diff(size)) == pytest.approx(-2 * torque / stiffness, rel=5e-3)


def test_a_presliding_contact_is_a_spring_when_small():
    """Dahl far below its give: stiffness F/give is added to κ; the period falls accordingly."""
    free = yaw_period_s(scene(YAW, 1e-4))
    s = scene(YAW, 1e-4)
    s.extras["contact"][0, 2], s.extras["contact_give"] = 0.4, [1.0, 1.0, 0.1]
    stiffness = MASS * G * SPACING**2 / (4 * LINE)
    assert yaw_period_s(s) / free == pytest.approx((1 + 4.0 / stiffness) ** -0.5, abs=3e-5)


def test_twisted_lines_add_to_the_stiffness_and_a_cubic_grows_with_amplitude():
    """ω² = (κ + k)/I; a cubic adds ¾ k₃ A² (Duffing, first order)."""
    free, amplitude = yaw_period_s(scene(YAW, 0.02)), 0.02
    stiffness = MASS * G * SPACING**2 / (4 * LINE)
    s = scene(YAW, amplitude)
    s.extras["torsion"] = 3.0
    assert yaw_period_s(s) / free == pytest.approx((1 + 3.0 / stiffness) ** -0.5, rel=2e-6)
    s = scene(YAW, amplitude)
    s.extras["torsion_cubic"] = 500.0
    assert yaw_period_s(s) / free - 1 == pytest.approx(-3 / 8 * 500.0 * amplitude**2 / stiffness, rel=0.01)


def test_entrained_air_slows_in_proportion_to_the_amplitude():
    """I + c A, A constant along an undamped swing: the period grows by c A / 2I."""
    s = scene(YAW, 0.03)
    free = yaw_period_s(scene(YAW, 0.03))
    s.extras["added"][0, 2], s.extras["added_omega"] = 40.0, [1.0, 1.0, 2 * np.pi / free]
    assert yaw_period_s(s) / free - 1 == pytest.approx(40.0 * 0.03 / 2 / INERTIA[2, 2], rel=0.02)


def test_elastic_lines_let_the_hull_heave_and_roll():
    """Heave √(2k/m) about the length at rest; sway and roll as the small motions of a body on two springs."""
    s = scene(2, 1e-3, 20.0)
    s.extras["stiffness"] = k = 2e5
    rig, start = start_and_rig(s)
    start[2] += 1e-3
    at = free_of_lines(rig, start, s.shown_s)
    assert period_s(s.shown_s, at[:, 2] - at[:, 2].mean()) == pytest.approx(2 * np.pi / np.sqrt(2 * k / MASS), rel=2e-4)
    # Sway y of the centre and roll a: points at heights DEPTH; weight as spring m g / l on their sideways motion.
    w, half = MASS * G / LINE, SPACING / 2
    stiffness = np.array([[w, -w * DEPTH], [-w * DEPTH, w * DEPTH**2 + MASS * G * DEPTH + 2 * k * half**2]])
    slow = np.sqrt(eigh(stiffness, np.diag([MASS, INERTIA[0, 0]]), eigvals_only=True)[0])
    s = scene(SWAY, 2e-3, 60.0)
    s.extras["stiffness"], s.extras["line_damping"] = k, 500.0
    assert period_s(s.shown_s, swung(s)[:, 1]) == pytest.approx(2 * np.pi / slow, rel=3e-5)


def start_and_rig(s: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Rig and a state of rest."""
    s.move = np.zeros(6)
    rig = rig_of(s)
    return rig, start_of(s, rig)


def free_of_lines(rig: np.ndarray, start: np.ndarray, times: np.ndarray) -> np.ndarray:
    """A small upward speed in place of a displaced start, which would be put back on the lines."""
    hanging = rig.copy()
    hanging["knock"], hanging["knock_time"] = [0, 0, 1.0], [0.0, 0.02]  # one newton second upwards
    start = start.copy()
    start[2] -= 1e-3
    return motion.swing(hanging, start, 0.0, times + 0.02, 0.001)


def test_a_support_that_yields_lengthens_sway_and_leaves_yaw():
    """ω² = g/(l + m g/k) for a light support; yaw pulls both ends against each other, and the beam does not turn."""
    rigid, yielding = scene(SWAY, 0.02), scene(SWAY, 0.02)
    k = MASS * G / 0.02
    mass = 0.2
    yielding.extras["support"] = [mass, k, 2 * 0.3 * np.sqrt(k * mass)]
    ratio = period_s(rigid.shown_s, swung(yielding)[:, 1]) / period_s(rigid.shown_s, swung(rigid)[:, 1])
    assert ratio == pytest.approx(np.sqrt(1 + 0.02 / LINE), rel=3e-5)
    turning = scene(YAW, 0.02)
    turning.extras["support"] = yielding.extras["support"]
    assert yaw_period_s(turning) == pytest.approx(yaw_period_s(scene(YAW, 0.02)), rel=1e-7)


def test_a_slider_and_the_hull_swing_as_two_masses():
    """In sway the hull only translates: hull and slider are coupled pendulum and spring, (K - ω² M) x = 0."""
    share, om = 0.05, 4.0
    s = scene(SWAY, 0.005, 100.0)
    m = share * MASS
    place = [0.0, 0.0, -DEPTH]
    e = s.extras[0]
    e["slider_mass"][0], e["slider_place"][0], e["slider_way"][0], e["slider_spring"][0] = m, place, [0, 1, 0], m * om**2
    mass = np.array([[MASS, m], [m, m]])
    stiffness = np.diag([MASS * G / LINE, m * om**2])
    expected = np.sqrt(eigh(stiffness, mass, eigvals_only=True))
    y = swung(s)[:, 1]
    columns = lambda w: np.column_stack([f(w_ * s.shown_s) for w_ in w for f in (np.cos, np.sin)])
    left = lambda w: np.linalg.norm(y - columns(w) @ np.linalg.lstsq(columns(w), y, rcond=None)[0]) / np.linalg.norm(y)
    assert left(expected) < 2e-3
    assert left(expected * [1, 1.01]) > 5 * left(expected)
    assert left(expected * [1.001, 1]) > 5 * left(expected)


def test_hull_and_slider_let_go_in_one_of_their_modes_stay_in_it():
    """Where the slider is put at the release by the eigenvector of (K - ω² M) x = 0, hull and slider swing at that ω alone."""
    om, m = 4.0, 0.05 * MASS
    mass, stiffness = np.array([[MASS, m], [m, m]]), np.diag([MASS * G / LINE, m * om**2])
    squares, shapes = eigh(stiffness, mass)
    for square, (hull, slider) in zip(squares, shapes.T):
        s = scene(SWAY, 0.002, 100.0)
        e = s.extras[0]
        e["slider_mass"][0], e["slider_place"][0], e["slider_way"][0] = m, [0.0, 0.0, -DEPTH], [0, 1, 0]
        e["slider_spring"][0], e["slider_start"][0] = m * om**2, [0.002 * slider / hull, 0.0]
        y, both = swung(s)[:, 1], np.sqrt(squares)
        parts = np.column_stack([f(w * s.shown_s) for w in both for f in (np.cos, np.sin)])
        sizes = np.hypot(*np.linalg.lstsq(parts, y, rcond=None)[0].reshape(2, 2).T)
        assert sizes[squares != square] < 0.01 * sizes[squares == square]


def test_lines_further_apart_above_follow_the_small_motions():
    """Yaw with d below and d' above: κ = m g d d'/h, h being the height between (Hinrichsen 2014, unequal spacings)."""
    s = scene(YAW, 1e-3)
    s.top_spacing_m = 1.2
    drop = np.sqrt(LINE**2 - 0.1**2)
    expected = 2 * np.pi * np.sqrt(INERTIA[2, 2] / (MASS * G * 0.5 * 0.6 / drop))
    assert yaw_period_s(s) == pytest.approx(expected, rel=1e-6)


def test_a_weight_aside_couples_yaw_to_surge_and_pitch():
    """Three frequencies of the points' surge x₁, x₂ and the pitch by Lagrange, M q'' + K q = 0; weights shared unequally."""
    aside = 0.1
    s = scene(YAW, 2e-3, 80.0)
    s.centre_m[1] += aside
    half, w = SPACING / 2, MASS * G / LINE
    shares = np.array([half + aside, half - aside]) / SPACING
    # Columns: surge of the +y and the -y point, pitch. Yaw = (x2 - x1) / spacing; the centre is DEPTH below, aside of the middle.
    yaw, surge = np.array([-1, 1, 0]) / SPACING, np.array([*shares, -DEPTH])
    mass = MASS * np.outer(surge, surge) + INERTIA[2, 2] * np.outer(yaw, yaw) + np.diag([0, 0, INERTIA[1, 1]])
    stiffness = np.diag([w * shares[0], w * shares[1], MASS * G * DEPTH])
    expected = np.sqrt(eigh(stiffness, mass, eigvals_only=True))
    angle = heading(swung(s))
    columns = np.column_stack([f(om * s.shown_s) for om in expected for f in (np.cos, np.sin)])
    left = angle - columns @ np.linalg.lstsq(columns, angle, rcond=None)[0]
    assert np.linalg.norm(left) < 2e-3 * np.linalg.norm(angle)


def test_creep_and_a_slipping_line_change_the_length_as_asked():
    """Creep reaches its amount at its span, by the logarithm; a slip ends at its own; the lines hold in between."""
    rig = motion.blank()
    rig["line"], rig["creep"], rig["slip"] = LINE, [0.01, 10.0], [0.0, 0.004, 50.0, 0.3]
    first = lambda t: motion.length(rig[0], 0, t)[0]
    assert first(120.0) == pytest.approx(LINE + 0.01, abs=1e-12)
    assert first(10.0) - LINE == pytest.approx(0.01 * np.log(2) / np.log(13), abs=1e-12)
    assert motion.length(rig[0], 1, 60.0)[0] - first(60.0) == pytest.approx(0.004, abs=1e-12)
    s = scene(SWAY, 0.05)
    s.extras["creep"], s.extras["slip"] = rig["creep"], rig["slip"]
    at = swung(s)
    for i, side in ((0, 1), (1, -1)):
        point = at[:, :3].T + rb.rotate(at[:, 3:7].T, np.array([0, side * SPACING / 2, DEPTH])[:, None] * np.ones(len(at)))
        wanted = [motion.length(rig[0], i, t)[0] for t in s.shown_s]
        assert np.abs(np.linalg.norm(point.T - [0, side * SPACING / 2, 0], axis=1) - wanted).max() < 1e-9


def test_a_knock_gives_its_momentum():
    """Sideways speed J/m more after than before, gravity's part over its short time apart."""
    s = scene(SWAY, 0.0, 2.0)
    s.extras["knock"], s.extras["knock_time"] = [0, 0.5, 0], [1.0, 0.05]
    at = swung(s)
    speed = np.gradient(at[:, 1], s.shown_s)
    assert speed[np.searchsorted(s.shown_s, 1.08)] == pytest.approx(0.5 / MASS, rel=0.03)


def test_a_rope_rubs_only_beyond_its_angle():
    """Below the threshold nothing is lost; above, energy per turn is 2 τ (A - ψc) on one side."""
    below, above = scene(YAW, 0.03), scene(YAW, 0.08)
    for s in (below, above):
        s.extras["rub"] = [0.2, 0.05]
    _, size = peaks(below.shown_s, heading(swung(below)))
    assert np.ptp(size) < 1e-7
    _, size = peaks(above.shown_s, heading(swung(above)))
    stiffness = MASS * G * SPACING**2 / (4 * LINE)
    whole = size[::2]
    lost = stiffness * (whole[:-1] ** 2 - whole[1:] ** 2) / 2
    expected = 2 * 0.2 * ((whole[:-1] + whole[1:]) / 2 - 0.05)
    assert lost[:5] == pytest.approx(expected[:5], rel=0.05)


def test_steady_wind_leans_the_hull_and_its_gusts_push():
    """At rest in a steady wind the lines lean by F / m g."""
    s = scene(SWAY, 0.0, 400.0)
    s.shown_s = s.shown_s[-2000:]
    s.extras["wind_area"], s.extras["wind"], s.extras["linear"] = [1.0, 2.0], [0.0, 3.0], 20.0
    lean = 0.5 * 1.2 * 2.0 * 9.0 / (MASS * G)
    assert swung(s)[:, 1].mean() == pytest.approx(LINE * lean, rel=2e-3)


def test_a_phone_that_rocks_amplifies_by_its_resonance():
    """Rate of a phone on a spring about the vertical: 1/(1 - (ω/Ω)²) times the hull's."""
    s = scene(YAW, 0.02, 30.0)
    omega = 2 * np.pi / yaw_period_s(s)
    plain = readings(s)[0][:, 2]
    s.flaws = Flaws(mount=Mount(12.0, 0.05, np.array([0, 0, 1.0]), np.zeros(3)))
    rocking = readings(s)[0][:, 2]
    late = s.shown_s > 15
    gain = (rocking[late] @ plain[late]) / (plain[late] @ plain[late])
    assert gain == pytest.approx(1 / (1 - (omega / 12.0) ** 2), rel=1e-3)


def test_steps_are_fine_enough():
    """Halving the step of every effect's session moves readings by less than a twentieth of their noise, seen over
    all samples by less than one standard deviation in each hundred."""
    seed = blind.test_seed()
    print("seed", seed)
    for number, name in enumerate(["none", "bearing_friction", "line_stretch", "support_compliance", "internal_motion"]):
        rng = np.random.default_rng([seed, number])
        session, hidden = sessions.draw(rng, name)
        s = sessions.spoiled(session, hidden).scenes[0]
        s.shown_s = s.shown_s[:4000]
        coarse, fine = readings(s, 0.005), readings(s, 0.0025)
        for a, b, noise in zip(coarse, fine, (s.phone.gyro_noise, s.phone.acc_noise)):
            assert np.abs(a - b).max() < noise / 20, name


def test_a_seed_gives_the_same_session(tmp_path):
    """Twice the same text; another number, another hull."""
    names = [sessions.make(tmp_path / k, 5, 3, "line_creep+gyro_scale") for k in "ab"]
    texts = [{p.name: p.read_text() for p in sorted((tmp_path / k / n).iterdir())} for k, n in zip("ab", names)]
    assert texts[0] == texts[1]
    truth = json.loads((tmp_path / "a" / f"{names[0]}.truth.json").read_text())
    assert [h["name"] for h in truth["hidden"]] == ["line_creep", "gyro_scale"]
    sessions.make(tmp_path / "a", 5, 4, "line_creep+gyro_scale")
    other = json.loads((tmp_path / "a" / "0004.truth.json").read_text())
    assert other["k_yaw_m"] != truth["k_yaw_m"]


def test_sessions_do_not_tell_what_they_hide():
    """Names of effects stand in no session file; every cause and every outsider can be drawn."""
    rng = np.random.default_rng(1)
    for name in [*EFFECTS, *OUTSIDE]:
        session, hidden = sessions.draw(rng, name)
        assert [h.name for h in hidden] == [name]
        sessions.spoiled(session, hidden)
    text = blind.session_toml("Hull 1/2", session.hull, session.hungs, True)
    assert not any(name in text for name in [*EFFECTS, *OUTSIDE])


def test_a_shifted_truth_would_be_seen(tmp_path):
    """What the tape got wrong is in the session's text: stated minus true is the offset, to the tape's own error."""
    name = sessions.make(tmp_path, 8, 1, "stated_length")
    truth = json.loads((tmp_path / f"{name}.truth.json").read_text())
    offset = truth["hidden"][0]["parameters"]["offset_m"]
    session = tomllib.loads((tmp_path / name / "session.toml").read_text())
    hung = {swing["id"]: swing["suspension"] for swing in session["swing"]}
    shared = {one["id"]: one["zero_u"] for one in session.get("instrument", [])}
    assert len(hung) == len(truth["swings"])
    for suspension, swing in zip(hung.values(), truth["swings"].values()):
        tape = hung.get(suspension.get("same_as"), suspension)["line_length"]
        u = shared.get(tape.get("instrument"), tape["u"])
        assert abs(tape["value"] - swing["line_length_m"] - offset) < 4.5 * u + 1e-4
