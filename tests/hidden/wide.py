"""Draws full sessions by laws whose forms and ranges differ from the catalogue's, and judges the verdicts of the program.

    python tests/hidden/wide.py --count 40 [--seed N] [--out DIR] [--resume] [--command "gyradius critique"] [--kind gusty_wind]

For each session: `DIR/<number>/` in the program's format, `DIR/<number>.truth.json`, and the program's answer in
`DIR/<number>.answer.json`. With `--resume`, sessions with an answer are not run again. The table is also in `DIR/table.md`.
Without `--seed` a fresh seed is drawn and printed; without `--out` nothing is kept.

# What is drawn
Strengths are log-uniform over about two decades around what is just visible in a usual session. Yaw has an amplitude of 2 to 60
degrees, the lines one of 2 to 35 in sway, pitch one of 2 to 25: less where the lines would go slack or lean by more than 35 degrees in
yaw. Sampling rates are 20 to 200 Hz, in half of the sessions the accelerometer has another rate and other times. A swing lasts 15 s to
10 min, mostly 30 to 180 s. There are 2 to 8 swings. The hull weighs 1 to 300 kg.

# Laws
The new ones are in `forces.py` and `motion.py`. Where the catalogue has a cause of the same sort, naming that one is right; what is
outside the catalogue is rightly called unexplained. The signal in σ is that of `detect.py`: beside the base model alone.
"""

from __future__ import annotations

import argparse
import json
import shlex
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import detect
import judge
import numpy as np
import sessions
from bodies_inside import draw_slider, put_sliders
from borrowed import blind, promises
from effect import Effect, Session, everywhere, none_of, relative, sign
from effects import ALL
from forces import BREEZE_SIZE
from friction import draw_times, loss, usual_speeds
from scene import move, tensions
from sessions import Hidden

log_uniform = blind.log_uniform
BREEZE_STEP_S = 0.5
VISIBLE_SIGMA = 3.0
SILENT_U = 3.0  # a gyradius further off than this, with a model called complete, is a silent failure
OFF_U = judge.ALIKE  # a base model further off than this ought to be improved on
QUANTITIES = ("k_yaw_m", "k_pitch_m", "k_roll_m")
LEAST_WEIGHT = 0.3  # of gravity, on the centre of mass
LEAST_TENSION = 0.1  # of the weight, on each line; at rest it is a half
LINE_LEAN = np.radians(35)
LARGEST_DEG = {"yaw": 60.0, "sway": 35.0, "pitch": 25.0}
LEAST_DEG = 2.0


def put_crossover(session: Session, p: dict, share: float) -> None:
    """Drag -q v √(v² + v₀²): linear well below v₀, quadratic well above."""
    speeds = usual_speeds(session)
    everywhere(session, "quadratic", loss(session, p["decay_s"], 2.0) / speeds**2, share)
    for scene in session.scenes:
        scene.extras["crossover"] = p["crossover"] * speeds


def put_stribeck(session: Session, p: dict, share: float) -> None:
    """Coulomb friction that falls from (1 + dip) times its size as the sliding speeds up (Stribeck 1902)."""
    everywhere(session, "coulomb", loss(session, p["decay_s"], 0.0), share)
    for scene in session.scenes:
        scene.extras["dip"], scene.extras["dip_speed"] = p["dip"], p["dip_speed"] * usual_speeds(session)


def put_power_creep(session: Session, p: dict, share: float) -> None:
    """Primary creep by a power of the time under load (Andrade's law has 1/3), anew in each recording."""
    everywhere(session, "creep", [p["relative"] * session.line_m(), 0.0], share)
    for scene in session.scenes:
        scene.extras["creep"][0, 1], scene.extras["creep_power"] = p["age_s"], p["exponent"]


def put_pendulum(session: Session, p: dict, share: float) -> None:
    """A bob on a rod in the hull; gravity alone brings it back."""
    put_sliders(session, {"sliders": [p]}, share)
    for scene in session.scenes:
        e = scene.extras[0]
        e["slider_spring"][0] = 0.0
        e["slider_rod"][0] = scene.gravity_m_s2 / (2 * np.pi * p["frequency_hz"]) ** 2


def draw_pendulum(rng, session: Session) -> dict:
    """A can half full, or a weight on a string: from below the hull's own motions to above them."""
    omegas = [m.omega_rad_s for m in session.hungs[0].modes.values()]
    pace = {
        "frequency_hz": log_uniform(rng, 0.7 * min(omegas), 3 * max(omegas)) / (2 * np.pi),
        "damping_ratio": log_uniform(rng, 5e-3, 0.2),
    }
    return draw_slider(rng, session, 2e-4, 3e-2) | pace


def ornstein_uhlenbeck(rng, sigma: float, correlation_s: float, step_s: float, count: int) -> np.ndarray:
    """Samples of a stationary process with autocovariance σ² exp(-|t| / T), exact at the samples."""
    kept = np.exp(-step_s / correlation_s)
    kicks = rng.normal(0, sigma * np.sqrt(1 - kept**2), count)
    kicks[0] = rng.normal(0, sigma)
    for before in range(count - 1):
        kicks[before + 1] += kept * kicks[before]
    return kicks


def put_gusty_wind(session: Session, p: dict, share: float) -> None:
    """A mean and filtered noise in both level directions, another piece of it in each swing, sampled each half second."""
    speed, hull = float(np.hypot(*p["mean_m_s"])), session.hull
    for n, scene in enumerate(session.scenes):
        rng, e = np.random.default_rng([p["noise_seed"], n]), scene.extras
        gusts = [ornstein_uhlenbeck(rng, p["intensity"] * speed, p["correlation_s"], BREEZE_STEP_S, BREEZE_SIZE) for _ in (0, 1)]
        e["wind_area"] = share * 0.08 * hull.length_m**2 * np.array([0.25, 1.0])
        e["wind_arm"], e["wind"] = p["arm"] * hull.length_m, p["mean_m_s"]
        e["breeze"][0], e["breeze_step"] = np.transpose(gusts), BREEZE_STEP_S


def draw_gusty_wind(rng, session: Session) -> dict:
    """From a draught in a shed to a moderate breeze; `intensity` is the gusts' standard deviation over the mean."""
    speed, way = log_uniform(rng, 0.05, 5.0), rng.uniform(0, 2 * np.pi)
    return {
        "mean_m_s": [speed * np.cos(way), speed * np.sin(way)], "intensity": rng.uniform(0.1, 0.5),
        "correlation_s": log_uniform(rng, 1, 60), "arm": rng.uniform(-0.2, 0.2), "noise_seed": int(rng.integers(2**32)),
    }  # fmt: skip


def put_constant_torsion(session: Session, p: dict, share: float) -> None:
    """A cable or a swivel: the same torque per radian at every line length."""
    everywhere(session, "torsion", p["relative"] * session.yaw_stiffness(), share)


def put_one_sided(session: Session, p: dict, share: float) -> None:
    """A spring that holds positive headings only."""
    everywhere(session, "torsion_one_sided", p["relative"] * session.yaw_stiffness(), share)


def draw_support(rng, session: Session) -> dict:
    return {"give_m": log_uniform(rng, 2e-5, 1e-2) * session.line_m(), "frequency_hz": log_uniform(rng, 4, 25),
            "damping_ratio": log_uniform(rng, 0.01, 0.2)}  # fmt: skip


def draw_knock(rng, session: Session) -> dict:
    impulse = ALL["knock"].draw(rng, session)
    return impulse | {"impulse_n_s": (np.array(impulse["impulse_n_s"]) * log_uniform(rng, 0.2, 2)).tolist()}


def draw_line_slip(rng, session: Session) -> dict:
    return ALL["line_slip"].draw(rng, session) | {"relative": log_uniform(rng, 5e-5, 2e-2)}


def draw_rub(rng, _: Session) -> dict:
    return {"decay_s": log_uniform(rng, 20, 6000), "beyond_rad": sign(rng) * log_uniform(rng, 5e-3, 0.2)}


@dataclass(frozen=True)
class Law:
    """How strong a law is drawn, and the catalogue's causes of its sort: none for what is outside."""

    draw: Callable
    names: tuple[str, ...] = ()
    put: Callable | None = None  # None: that of the generator's effect of the same name
    two_lines: bool = False  # one line length cannot show it


LAWS = {
    "crossover_drag": Law(
        lambda rng, _: {"decay_s": draw_times(rng, 50, 8000), "crossover": log_uniform(rng, 0.05, 2)},
        ("quadratic_drag", "power_law_damping"), put_crossover,
    ),
    "stribeck_friction": Law(
        lambda rng, _: {"decay_s": draw_times(rng, 200, 30000), "dip": rng.uniform(0.2, 1.0), "dip_speed": log_uniform(rng, 0.03, 0.3)},
        ("bearing_friction", "presliding_bearing"), put_stribeck,
    ),
    "power_creep": Law(
        lambda rng, _: {"relative": log_uniform(rng, 2e-5, 5e-3), "exponent": rng.uniform(0.15, 0.6), "age_s": log_uniform(rng, 2, 60)},
        ("line_creep",), put_power_creep,
    ),
    "pendulum_slosh": Law(draw_pendulum, ("internal_motion",), put_pendulum),
    "gusty_wind": Law(draw_gusty_wind, ("wind",), put_gusty_wind),
    "constant_torsion": Law(relative(2e-4, 4e-2, False), ("line_torsion",), put_constant_torsion, two_lines=True),
    "support_compliance": Law(draw_support, ("support_compliance",)),
    "unequal_lines": Law(relative(1e-4, 2e-2), ("unequal_lines",)),
    "off_centre_cm": Law(lambda rng, s: {"aside_m": sign(rng) * log_uniform(rng, 2e-4, 6e-2) * s.spacing_m()}, ("off_centre_cm",)),
    "stated_length": Law(lambda rng, s: {"offset_m": round(sign(rng) * log_uniform(rng, 5e-4, 4e-2) * s.line_m(), 4)}, ("stated_length",)),
    "stated_spacing": Law(lambda rng, s: {"offset_m": round(sign(rng) * log_uniform(rng, 5e-4, 4e-2) * s.spacing_m(), 4)}, ("stated_spacing",)),
    "clock_scale": Law(relative(1e-4, 3e-2), ("clock_scale",)),
    "hardening_spring": Law(relative(2e-4, 6e-2, False)),
    "one_sided_spring": Law(relative(2e-4, 5e-2), put=put_one_sided),
    "rubbing_rope": Law(draw_rub),
    "knock": Law(draw_knock),
    "line_slip": Law(draw_line_slip),
}  # fmt: skip
for name, law in LAWS.items():
    if law.put:
        ALL[name] = Effect(name, law.draw, law.put, none_of)
EIGHT = "support_compliance, 8 swings"
KINDS = ("none", *LAWS, EIGHT, "pair")
BOTH = (("yaw", "sway"), ("pitch",))
STYLES = (
    BOTH,
    (("yaw", "sway", "pitch"),) * 2,
    (("yaw",), ("sway",), ("pitch",)),
    BOTH * 2,
    (("yaw",), ("yaw",), ("sway",), ("pitch",), ("pitch",)),
    BOTH * 3,
    BOTH * 4,
)


def drawn_laws(rng, kind: str) -> list[str]:
    """Of a kind: the laws that are hidden."""
    if kind == "pair":
        return rng.choice([name for name, law in LAWS.items() if law.names], 2, replace=False).tolist()
    return [] if kind == "none" else [kind.partition(",")[0]]


def drawn_form(rng, kind: str, names: list[str]) -> tuple[sessions.Kind, bool]:
    """What sort of session: its swings, and whether it has two rigs."""
    styles = STYLES[-1:] if kind == EIGHT else STYLES
    two_lines = any(LAWS[name].two_lines for name in names)
    on_two = [style for style in styles if len(style) <= 4]
    halves = BOTH * 2 if kind == EIGHT else on_two[rng.integers(len(on_two))]
    form = sessions.Kind(styles, lines_differ=1.0 if two_lines else 0.5, on_two_rigs=halves, mass_kg=(1, 300))
    return form, two_lines or rng.random() < 0.3


def drawn_duration_s(rng) -> float:
    """Mostly usual, some short or long."""
    return log_uniform(rng, 30, 180) if rng.random() < 0.85 else log_uniform(rng, 15, 600)


def drawn_sizes(rng, hung, at_most: float) -> dict:
    """Amplitudes of a swing's motions, degrees: log-uniform up to a fraction of the largest."""
    plan = hung.plan
    yaw = np.degrees(2 * np.arcsin(min(1.0, plan.line_m * np.sin(LINE_LEAN) / plan.spacing_m)))
    largest = LARGEST_DEG | {"yaw": min(LARGEST_DEG["yaw"], yaw)}
    sizes = {name: log_uniform(rng, LEAST_DEG, max(at_most * most, 1.01 * LEAST_DEG)) for name, most in largest.items()}
    return {name: (size, size) for name, size in sizes.items()}


def drawn_phone(rng, hull: blind.Hull) -> blind.Phone:
    """Any phone, at 20 to 200 Hz."""
    phone = blind.draw_phone(rng, hull)
    phone.gyro_rate_hz = phone.acc_rate_hz = log_uniform(rng, 20, 200)
    phone.one_clock = bool(rng.random() < 0.5)
    if not phone.one_clock:
        phone.acc_rate_hz = log_uniform(rng, 20, 200)
    return phone


def taut(session: Session) -> bool:
    """Whether the hull weighs something and both lines pull at every moment, and the hull turns no further than asked for."""
    for scene in session.scenes:
        at = move(scene, 0.02, detect.every(scene))
        turn = 2 * np.arctan2(np.linalg.norm(at[:, 4:7], axis=1), np.abs(at[:, 3]))
        weight = scene.mass_kg * (at[:, 12] + scene.gravity_m_s2)
        least = LEAST_WEIGHT * scene.mass_kg * scene.gravity_m_s2
        if not (weight > least).all() or turn.max() > np.radians(1.3 * LARGEST_DEG["yaw"]):
            return False
        if not (tensions(scene, at) > LEAST_TENSION * scene.mass_kg * scene.gravity_m_s2).all():
            return False
    return True


def draw(rng, kind: str) -> tuple[Session, list[Hidden], dict]:
    """A session, what is hidden in it, and the amplitudes drawn, degrees by swing."""
    names = drawn_laws(rng, kind)
    form, two_rigs = drawn_form(rng, kind, names)
    hull, hungs = sessions.draw_hung(rng, two_rigs, form)
    phone = drawn_phone(rng, hull)
    for hung in hungs:
        hung.plan.phone, hung.plan.duration_s = phone, drawn_duration_s(rng)
    for at_most in 0.8 ** np.arange(20):
        sizes = [drawn_sizes(rng, hung, at_most) for hung in hungs]
        scenes, amplitudes = zip(*(sessions.draw_scene(rng, hull, h, phone, s) for h, s in zip(hungs, sizes)))
        session = Session(hull, hungs, list(scenes), sessions.tapes_of(hungs), list(amplitudes))
        hidden = [Hidden(name, LAWS[name].draw(rng, session)) for name in names]
        if taut(sessions.spoiled(session, hidden)):
            break
    if not phone.one_clock:
        for scene in session.scenes:
            acc_s = blind.stamps(rng, phone.acc_rate_hz, scene.shown_s[-1])
            scene.acc_shown_s = acc_s * (1 + phone.clock_error)
    excited = [{name: round(s[name][0], 1) for name in hung.plan.excited} for hung, s in zip(hungs, sizes)]
    return session, hidden, {hung.plan.id: e for hung, e in zip(hungs, excited)}


def signals(session: Session, hidden: list[Hidden]) -> list[float]:
    """How many standard deviations each law stands out beside the base model. `detect` knows one set of times: the accelerometer's
    noise is scaled to its number of readings."""
    other = session.copy()
    for scene in other.scenes:
        scene.phone.acc_noise *= np.sqrt(scene.phone.gyro_rate_hz / scene.phone.acc_rate_hz)
    return [float(np.linalg.norm(v)) for v in detect.standing_out(other, hidden)[2]]


def make(out: Path, seed: int, number: int, kind: str) -> None:
    """Write a session and its truth."""
    rng, name = np.random.default_rng([seed, number]), f"{number:04d}"
    session, hidden, sizes = draw(rng, kind)
    shutil.rmtree(out / name, ignore_errors=True)  # of a run that was stopped
    sessions.write(rng, out / name, f"Hull {seed}/{number}", sessions.spoiled(session, hidden))
    phone, lasting = session.scenes[0].phone, [round(float(s.shown_s[-1]), 1) for s in session.scenes]
    sigma = signals(session, hidden)
    more = {"kind": kind, "sigma": sigma, "sizes_deg": sizes, "lasting_s": lasting}
    more |= {"rates_hz": [phone.gyro_rate_hz, phone.acc_rate_hz], "outside": any(not LAWS[h.name].names for h in hidden)}
    truth = sessions.truth_of([seed, number], session, hidden) | more
    (out / f"{name}.truth.json").write_text(json.dumps(truth, indent=1, default=float))


@dataclass
class Judged:
    """A session's truth and the program's answer."""

    name: str
    truth: dict
    result: dict | None
    trouble: str
    took_s: float

    @property
    def hidden(self) -> list[str]:
        """Laws."""
        return [h["name"] for h in self.truth["hidden"]]

    @property
    def status(self) -> str:
        """Of the verdict."""
        return self.result["verdict"]["status"] if self.result else "no answer"

    @property
    def causes(self) -> list[str]:
        """Named by the verdict."""
        return self.result["verdict"]["causes"] if self.result else []

    @property
    def held(self) -> list[str]:
        """Those, and the ones that cannot be distinguished from them."""
        return self.causes + (self.result["verdict"]["indistinguishable_from"] if self.result else [])

    def hold(self, causes: list[str]) -> bool:
        """Whether causes hold one of each law's sort."""
        return bool(self.hidden) and all(set(LAWS[name].names) & set(causes) for name in self.hidden)

    def answer(self) -> str:
        """The verdict in a word, as a column of the table."""
        if self.status == "explained":
            right = self.hold(self.causes) and len(self.causes) == len(self.hidden)
            return "named right" if right else "named otherwise"
        if self.status == "ambiguous":
            return "ambiguous with it" if self.hold(self.held) else "ambiguous without it"
        return self.status

    def given(self, model: str, quantity: str) -> dict | None:
        """A model's gyradius."""
        return ((self.result or {}).get(model) or {}).get("quantities", {}).get(quantity)

    def off(self, model: str, quantity: str) -> float:
        """Error of a model's gyradius in standard uncertainties of the extended model; NaN where it is not given."""
        given, extended = self.given(model, quantity), self.given("extended", quantity)
        return (given["value"] - self.truth[quantity]) / extended["u"] if given and extended and extended["u"] > 0 else np.nan

    def inside(self, quantity: str) -> bool | None:
        """Whether the truth is inside the extended model's 95 % interval."""
        extended = self.given("extended", quantity)
        if extended is None:
            return None
        low, high = promises.interval_95(extended)
        return low <= self.truth[quantity] <= high

    def is_silent(self) -> bool:
        """Whether a gyradius is far off, with a model called complete."""
        return self.status in ("adequate", "explained") and any(abs(self.off("extended", q)) > SILENT_U for q in QUANTITIES)


def judged(out: Path, name: str, command: list[str]) -> Judged:
    """The program's answer, kept beside the session; asked for where there is none yet."""
    truth, path = json.loads((out / f"{name}.truth.json").read_text()), out / f"{name}.answer.json"
    if not path.exists():
        began = time.monotonic()
        result, trouble = judge.critique(command, out / name)
        path.write_text(json.dumps({"result": result, "trouble": trouble, "took_s": time.monotonic() - began}, indent=1))
    kept = json.loads(path.read_text())
    return Judged(name, truth, kept["result"], kept["trouble"], kept["took_s"])


def shown(value) -> str:
    """A parameter in few digits."""
    if isinstance(value, list):
        return "[" + " ".join(map(shown, value)) + "]"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def drawn_text(one: Judged) -> str:
    """What was drawn, in words."""
    t, parts = one.truth, []
    for hidden, sigma in zip(t["hidden"], t["sigma"]):
        strengths = ", ".join(f"{k} {shown(v)}" for k, v in hidden["parameters"].items() if k != "noise_seed")
        parts.append(f"{hidden['name']} ({strengths}) {sigma:.1f} σ")
    widest = {}
    for sizes in t["sizes_deg"].values():
        for motion, size in sizes.items():
            widest.setdefault(motion, []).append(size)
    sizes = ", ".join(f"{motion} {min(s):.0f}-{max(s):.0f}°" for motion, s in widest.items())
    rates = "/".join(f"{rate:.0f}" for rate in dict.fromkeys(t["rates_hz"]))
    lasting = f"{min(t['lasting_s']):.0f}-{max(t['lasting_s']):.0f} s"
    return f"{' + '.join(parts) or 'none'}; {t['mass_kg']:.1f} kg, {len(t['swings'])} swings, {lasting}, {rates} Hz, {sizes}"


def verdict_text(one: Judged) -> str:
    """The verdict, and the errors of the gyradii."""
    if one.result is None:
        return f"no answer: {one.trouble}"
    others = one.held[len(one.causes) :]
    named = " + ".join(one.causes) + (f" or {', '.join(others)}" if others else "")
    rms = " → ".join(f"{one.result[model]['rms_over_noise']:.2f}" for model in ("baseline", "extended"))
    offs = [
        f"{q[:-2]} {one.off('baseline', q):+.1f} → {one.off('extended', q):+.1f} u"
        for q in QUANTITIES
        if one.given("extended", q)
    ]
    return f"{one.status} {named}; {', '.join(offs)}; rms {rms}".replace(" ;", ";")


ANSWERS = ("named right", "ambiguous with it", "ambiguous without it", "adequate", "unexplained", "named otherwise", "no answer")


def by_kind(found: list[Judged]) -> list[str]:
    """Markdown: what was hidden, against the verdict."""
    lines = ["| hidden | drawn | σ | " + " | ".join(ANSWERS) + " | named |", "|---" * (len(ANSWERS) + 4) + "|"]
    for kind in dict.fromkeys(one.truth["kind"] for one in found):
        ones = [one for one in found if one.truth["kind"] == kind]
        counts = [sum(one.answer() == answer for one in ones) or "" for answer in ANSWERS]
        sigmas = ", ".join(f"{sigma:.0f}" for one in ones for sigma in one.truth["sigma"])
        named = ", ".join("+".join(one.causes) for one in ones if one.answer() == "named otherwise")
        lines.append(f"| {kind} | {len(ones)} | {sigmas} | {' | '.join(map(str, counts))} | {named} |")
    return lines


def fraction(marks: list[bool]) -> str:
    """Such as 3/4."""
    return f"{sum(marks)}/{len(marks)}" if marks else ""


def coverage(found: list[Judged]) -> list[str]:
    """Markdown: 95 % intervals that hold the truth, by verdict."""
    given = [q for q in QUANTITIES if any(one.inside(q) is not None for one in found)]
    lines = ["| verdict | " + " | ".join(f"{q} inside 95 %" for q in given) + " |", "|---" * (len(given) + 1) + "|"]
    for status in (*dict.fromkeys(one.status for one in found if one.result), "all"):
        ones = [one for one in found if status in ("all", one.status)]
        marks = [fraction([one.inside(q) for one in ones if one.inside(q) is not None]) for q in given]
        lines.append(f"| {status} | {' | '.join(marks)} |")
    return lines


def gains(found: list[Judged]) -> list[str]:
    """Markdown: how often the extended model is nearer the truth, where the base model is off."""
    lines = [f"| quantity | base more than {OFF_U:.0f} u off | extended nearer | alike | extended further |", "|---" * 5 + "|"]
    for quantity in QUANTITIES:
        pairs = [(abs(one.off("baseline", quantity)), abs(one.off("extended", quantity))) for one in found]
        off = [(base, extended) for base, extended in pairs if base > OFF_U]
        nearer, further = sum(e < b - 0.1 for b, e in off), sum(e > b + 0.1 for b, e in off)
        lines.append(f"| {quantity} | {len(off)} | {nearer} | {len(off) - nearer - further} | {further} |")
    return lines


def faint(found: list[Judged]) -> str:
    """A line: of the adequate ones, how many hide what can be seen."""
    adequate = [one for one in found if one.status == "adequate" and one.hidden]
    visible = [one.name for one in adequate if max(one.truth["sigma"]) > VISIBLE_SIGMA]
    return f"Called adequate with something hidden: {len(adequate)}; above {VISIBLE_SIGMA:.0f} σ: {', '.join(visible) or 'none'}."


def silent(found: list[Judged]) -> list[str]:
    """Markdown: silent failures, the worst first."""
    worst = lambda one: -np.nanmax([abs(one.off("extended", q)) for q in QUANTITIES])
    lines = []
    for one in sorted((one for one in found if one.is_silent()), key=worst):
        values = ", ".join(
            f"{q} base {one.given('baseline', q)['value']:.5f}, extended {one.given('extended', q)['value']:.5f} ± "
            f"{one.given('extended', q)['u']:.5f}, true {one.truth[q]:.5f}"
            for q in QUANTITIES if one.given("extended", q) and one.given("baseline", q)
        )  # fmt: skip
        lines.append(f"- {one.name}: {drawn_text(one)}: {verdict_text(one)}: {values}")
    return lines or ["none"]


def report(found: list[Judged]) -> str:
    """Markdown of all tables."""
    heading = f"Silent failures (adequate or explained, a gyradius more than {SILENT_U:.0f} u off):"
    parts = [by_kind(found), [faint(found)], coverage(found), gains(found), [heading], silent(found)]
    each = [f"- {one.name} {one.truth['kind']}: {drawn_text(one)}: {verdict_text(one)}; {one.took_s:.0f} s" for one in found]
    return "\n\n".join("\n".join(part) for part in [*parts, each]) + "\n"


def judge_all(options: argparse.Namespace, seed: int, out: Path) -> list[Judged]:
    """Draw what is not there, ask the program, print a line for each session."""
    command, found = shlex.split(options.command), []
    for number in range(options.first, options.first + options.count):
        name, kind = f"{number:04d}", options.kind or KINDS[number % len(KINDS)]
        if not (out / f"{name}.truth.json").exists():
            make(out, seed, number, kind)
        found.append(judged(out, name, command))
        print(f"{name} {kind}: {drawn_text(found[-1])}\n     {verdict_text(found[-1])}; {found[-1].took_s:.0f} s", flush=True)
    return found


def checked(out: Path, seed: int, is_resumed: bool) -> None:
    """Raise where a folder holds sessions and is not to be resumed, or holds those of another seed."""
    out.mkdir(parents=True, exist_ok=True)
    truths = sorted(out.glob("*.truth.json"))
    if truths and not is_resumed:
        raise SystemExit(f"{out} holds sessions: give --resume to go on with them, or another folder")
    seeds = {json.loads(path.read_text())["seed"][0] for path in truths}
    if not seeds <= {seed}:
        raise SystemExit(
            f"{out} holds sessions of the seed {', '.join(map(str, seeds))}, not {seed}: give that one, or another folder"
        )


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=2 * len(KINDS))
    parser.add_argument("--first", type=int, default=0, help="number of the first session")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--out", type=Path, default=None, help="folder to keep sessions, truths and answers in")
    parser.add_argument("--command", default=judge.COMMAND)
    parser.add_argument("--kind", default=None, choices=KINDS, help="hide this in every session")
    parser.add_argument("--resume", action="store_true", help="go on with the sessions in --out")
    options = parser.parse_args()
    seed = blind.fresh_seed() if options.seed is None else options.seed
    print(f"seed {seed}")
    with tempfile.TemporaryDirectory() as temporary:
        out = options.out or Path(temporary)
        checked(out, seed, options.resume)
        text = report(judge_all(options, seed, out))
        (out / "table.md").write_text(text)
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
