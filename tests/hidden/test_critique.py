"""The program as its users run it, on fresh sessions with and without something hidden.

So few sessions say little about rates: a program that errs in one of three may pass. What is caught: no answer, an answer that is
not of the contract's form, and an answer that is wrong in every session. `make hidden` judges the rates, on many.
"""

import json
import math
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial

import judge
import numpy as np
import pytest
import sessions
from borrowed import blind

APART = ["amplitude_added_mass", "bearing_friction", "bias_drift", "phone_slip", "unequal_lines"]  # about every second is testable
HIDDEN = [["none"], APART, APART, ["hardening_spring"]]
SMALL = sessions.Kind(((("yaw", "sway"), ("pitch",)), (("yaw", "sway", "pitch"),) * 2), lasting_s=(70, 80), one_rig=True)
LEAST_GAIN = 0.8  # held-out error, base over extended: an extension may cost a little on samples that it has not seen
AT_A_MOMENT = {"phone_slip"}  # when it happened cannot be learned where that stretch is held out: no gain is asked
TRIES = 8  # for one that is testable; else the last is taken, and its verdict does not count
TIMEOUT_S = 900.0  # against a program that hangs: a slow machine with other work takes five minutes for what two idle cores do in one


def draw(folder, seed: int, number: int) -> str:
    """One session with its truth; of those with something hidden, one where it stands out and looks like no other."""
    rng = np.random.default_rng([seed, number])
    for _ in range(TRIES):
        session, hidden = sessions.draw(rng, str(rng.choice(HIDDEN[number])), SMALL)
        if not hidden:
            detection = {"effects": []}
            break
        detection = sessions.studied(session, hidden)
        sort = "one" if hidden[0].name in APART else "outside"
        if judge.Outcome("", {"sort": sort, "detection": detection}).testable():
            break
    return sessions.save(rng, folder, [seed, number], session, hidden, detection)


def test_answers_on_unseen_sessions(tmp_path):
    """One complete session, two with one cause, one with a spring that the catalogue lacks."""
    pytest.importorskip("gyradius", reason="the package is not installed")
    seed = blind.test_seed()
    print("seed", seed, flush=True)
    with ProcessPoolExecutor(2) as pool:
        names = list(pool.map(partial(draw, tmp_path, seed), range(len(HIDDEN))))
    outcomes = judge.run(tmp_path, names, judge.COMMAND.split(), 2, TIMEOUT_S)
    print(judge.report(outcomes, "Four sessions", f"Seed {seed}.")[0])
    assert judge.reasons_in_a_few(outcomes) == []
    assert {o.name: against_contract(o.result) for o in outcomes} == {o.name: [] for o in outcomes}
    gains = {o.name: o.result["gain"]["heldout_rms_ratio"] for o in outcomes if not o.hidden & AT_A_MOMENT}
    assert [f"{name}: {gain}" for name, gain in gains.items() if gain <= LEAST_GAIN] == []


def draw_heavy_slide(folder, seed: int, number: int) -> str:
    """A session with something inside of one to two hundredths of the hull's mass, at the pace of the hull's own motions."""
    rng = np.random.default_rng([seed, number])
    session, hidden = sessions.draw(rng, "internal_motion", SMALL)
    omegas = [mode.omega_rad_s for mode in session.hungs[0].modes.values()]
    slider = {"mass_share": rng.uniform(0.01, 0.02), "frequency_hz": rng.uniform(1.3 * min(omegas), max(omegas)) / (2 * np.pi)}
    hidden[0].parameters["sliders"][0] |= slider
    return sessions.save(rng, folder, [seed, number], session, hidden, None)


def test_heavy_slides_are_named(tmp_path):
    """The base leaves many times the noise of such sessions, and no fit that begins near it comes near the truth. Where 95 % are named
    right, fewer than two of four are once in 2000 runs."""
    pytest.importorskip("gyradius", reason="the package is not installed")
    seed = blind.test_seed()
    print("seed", seed, flush=True)
    names = [draw_heavy_slide(tmp_path, seed, number) for number in range(4)]
    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(lambda name: judge.critique(judge.COMMAND.split(), tmp_path / name, TIMEOUT_S), names))
    print([(trouble, result and result["verdict"]["causes"], result and result["baseline"]["rms_over_noise"]) for result, trouble in answers])
    assert [trouble for _, trouble in answers if trouble] == []
    assert sum(result["verdict"]["causes"] == ["internal_motion"] for result, _ in answers) >= 2


def answer_to(folder, seed: int, number: int, wanted: str | None = None) -> tuple[dict, dict]:
    """What the program says of a session that it once got wrong, and the truth."""
    pytest.importorskip("gyradius", reason="the package is not installed")
    name = sessions.make(folder, seed, number, wanted, False)
    result, trouble = judge.critique(judge.COMMAND.split(), folder / name, TIMEOUT_S)
    assert trouble == ""
    return result, json.loads((folder / f"{name}.truth.json").read_text())


def test_a_thing_inside_is_no_wind(tmp_path):
    """Something inside that stands out by 197 σ, 154 beside the cause that is nearest, and leaves the base no more than twice the noise: what
    the first look said of all the rest led away from it, and it was called a wind."""
    result, _ = answer_to(tmp_path, 107479795916, 1, "internal_motion")
    assert result["baseline"]["rms_over_noise"] < 2
    assert (result["verdict"]["status"], result["verdict"]["causes"]) == ("explained", ["internal_motion"])


def test_what_friction_holds_still_does_not_grow_without_it(tmp_path):
    """Friction of 22 σ: derivatives were taken of motions without it, which grew beyond all bounds, and there was no answer."""
    result, _ = answer_to(tmp_path, 141905861965385, 21)
    assert (result["verdict"]["status"], result["verdict"]["causes"]) == ("explained", ["bearing_friction"])


def test_slow_gusts_are_nothing_that_moves_inside(tmp_path):
    """A wind of 25 σ, two of its four tones about 0.25 Hz, of which no steady part was seen: it was called something inside at 0.27 Hz."""
    result, truth = answer_to(tmp_path, 562516772598243, 21)
    assert [hidden["name"] for hidden in truth["hidden"]] == ["wind"]
    assert (result["verdict"]["status"], result["verdict"]["causes"]) == ("explained", ["wind"])


def test_no_motion_grows_of_itself(tmp_path):
    """A clock wrong by 0.2 %, of 3 σ. Sway that nobody had set going, in the swing in yaw, was given a damping rate of -0.1/s, beside which no
    step led on: the clock was called right, and k_pitch stood 51 standard uncertainties off."""
    result, truth = answer_to(tmp_path, 600993356818053, 8)
    verdict, k_pitch = result["verdict"], result["extended"]["quantities"]["k_pitch_m"]
    assert truth["hidden"][0]["name"] in verdict["causes"] + verdict["indistinguishable_from"]
    assert abs(k_pitch["value"] - truth["k_pitch_m"]) < 4 * k_pitch["u"]


def test_what_bends_to_much_is_not_taken_for_all(tmp_path):
    """A spring that hardens, of which something that moves inside accounts for all but half a hundredth: that was called explained, and
    k_yaw 11 standard uncertainties off."""
    result, truth = answer_to(tmp_path, 63844334495817, 92)
    assert (truth["hidden"][0]["name"], result["verdict"]["status"]) == ("hardening_spring", "unexplained")
    k_yaw = result["extended"]["quantities"]["k_yaw_m"]
    assert abs(k_yaw["value"] - truth["k_yaw_m"]) < 4 * k_yaw["u"]


def test_a_line_that_gave_way_is_no_gusty_wind(tmp_path):
    """It gave way in the first swing, and was looked for only where a phone seemed to slip, in a later one. When it did is said by the
    recording's own clock. What has no name moves the body's figures by no law that is known: intervals reach back to where they are
    without it."""
    result, truth = answer_to(tmp_path, 141905861965385, 13)
    slip = truth["hidden"][0]["parameters"]
    assert (result["verdict"]["status"], result["verdict"]["causes"]) == ("unexplained", ["unknown"])
    found = result["causes"][0]["parameters"]
    assert abs(found["over_s"]["value"] - 0.3) < 0.02
    assert abs(found["at_s"]["value"] - (slip["at_s"] + 0.15)) < 0.02
    before, after = result["baseline"]["quantities"], result["extended"]["quantities"]
    for name in ("k_yaw_m", "k_pitch_m"):
        low, high = after[name]["interval_95"]
        assert low < before[name]["value"] < high


def is_number(value) -> bool:
    """A finite one."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def is_text(value) -> bool:
    return isinstance(value, str)


def is_share(value) -> bool:
    return is_number(value) and 0 <= value <= 1


def is_positive(value) -> bool:
    return is_number(value) and value > 0


QUANTITY = {"value": is_number, "u": is_positive}
MODEL = {"rms_over_noise": is_positive, "heldout_rms_over_noise": is_positive,
         "quantities": {name: QUANTITY for name in judge.QUANTITIES}}  # fmt: skip
# A dict names keys that must be there, others may; a list holds the form of each of its items.
CRITIQUE = {
    "format": "gyradius-critique/1".__eq__,
    "baseline": MODEL,
    "discrepancies": [{"swing": is_text, "what": is_text, "size": is_number, "unit": is_text, "sigma": is_number, "text": is_text}],
    "causes": [{"id": is_text, "probability": is_share, "log_evidence_gain": is_number, "parameters": lambda v: isinstance(v, dict)}],
    "verdict": {
        "status": ["adequate", "explained", "ambiguous", "unexplained"].__contains__,
        "causes": [is_text],
        "indistinguishable_from": [is_text],
        "next_swing": lambda v: v is None or isinstance(v, dict),
    },
    "extended": MODEL,
    "gain": {"heldout_rms_ratio": is_positive, "log_score_per_sample": is_number, "k_yaw_shift_m": is_number},
}
PARAMETER = {"value": is_number, "u": is_number, "unit": is_text}


def misfits(value, form, where: str = "") -> list[str]:
    """Places where a value is not of a form."""
    if isinstance(form, dict):
        if not isinstance(value, dict):
            return [f"{where}: {value!r}"]
        return [m for key, f in form.items() for m in misfits(value.get(key), f, f"{where}.{key}")]
    if isinstance(form, list):
        if not isinstance(value, list):
            return [f"{where}: {value!r}"]
        return [m for n, item in enumerate(value) for m in misfits(item, form[0], f"{where}[{n}]")]
    return [] if form(value) else [f"{where}: {value!r}"]


def against_contract(result: dict) -> list[str]:
    """Where an answer is not what `critique --json` promises."""
    found = misfits(result, CRITIQUE)
    if found:
        return found
    for cause in result["causes"]:
        found += [m for name, p in cause["parameters"].items() for m in misfits(p, PARAMETER, f"{cause['id']}.{name}")]
    verdict = result["verdict"]
    if (verdict["causes"] == []) != (verdict["status"] == "adequate"):
        found.append(f"{verdict['status']} with causes {verdict['causes']}")
    return found


def answered() -> dict:
    """A made-up answer of the contract's form."""
    model = {"rms_over_noise": 1.0, "heldout_rms_over_noise": 1.0, "quantities": {q: {"value": 1.0, "u": 0.1} for q in judge.QUANTITIES}}
    return {
        "format": "gyradius-critique/1", "baseline": model, "discrepancies": [], "extended": model,
        "causes": [{"id": "wind", "probability": 1.0, "log_evidence_gain": 9.0, "parameters": {"x": {"value": 1, "u": 0.1, "unit": "1"}}}],
        "verdict": {"status": "explained", "causes": ["wind"], "indistinguishable_from": [], "next_swing": None},
        "gain": {"heldout_rms_ratio": 1.1, "log_score_per_sample": 0.1, "k_yaw_shift_m": 0.0},
    }  # fmt: skip


@pytest.mark.parametrize(
    "part, key, value",
    [
        ("format", None, "gyradius-critique/2"),
        ("verdict", "status", "fine"),
        ("verdict", "status", "adequate"),
        ("verdict", "causes", []),
        ("gain", "heldout_rms_ratio", 0.0),
        ("gain", "log_score_per_sample", math.nan),
        ("gain", "k_yaw_shift_m", None),
        ("extended", "quantities", {}),
        ("discrepancies", None, [{}]),
        ("causes", None, [answered()["causes"][0] | {"probability": 1.1}]),
        ("causes", None, [answered()["causes"][0] | {"parameters": {"x": {"value": math.inf, "u": 0.1, "unit": "1"}}}]),
    ],
)
def test_each_breach_of_the_contract_is_seen(part, key, value):
    """One change to an answer that is right."""
    assert against_contract(answered()) == []
    changed = answered()
    changed[part] = value if key is None else changed[part] | {key: value}
    assert against_contract(changed) != []
