"""The judge on made-up programs: one that keeps its promise passes, one that boasts fails, and no trouble goes by."""

import judge
import numpy as np
from borrowed import blind

NAMES = ["line_creep", "wind", "gyro_scale", "quadratic_drag"]


def made_up_truth(rng, sort: str) -> dict:
    """What a generator might have hidden."""
    count = {"none": 0, "one": 1, "two": 2, "outside": 1}[sort]
    names = ["knock"] if sort == "outside" else rng.choice(NAMES, count, replace=False).tolist()
    effect = {"signal_sigma": 100.0, "largest_cosine": 0.5, "nearest": "wind", "beyond_best_cause_sigma": 80.0,
              "beside_others_sigma": 90.0}
    return {"sort": sort, "hidden": [{"name": n} for n in names], "k_yaw_m": 1.0, "k_pitch_m": 1.1,
            "detection": {"effects": [{**effect, "name": n} for n in names]}}  # fmt: skip


def made_up_answer(rng, truth: dict, skill: float, honest: float) -> dict:
    """A program that is right with probability `skill` and whose errors are 1/`honest` times what it states."""
    names, right = [h["name"] for h in truth["hidden"]], rng.random() < skill
    status = {"none": "adequate", "outside": "unexplained"}.get(truth["sort"], "explained")
    verdict = {"status": status, "causes": names if status == "explained" else [], "indistinguishable_from": []}
    if not right:
        verdict = {"status": "explained", "causes": ["bias_drift"], "indistinguishable_from": []}
    elif status == "explained" and rng.random() < 0.05 and len(names) == 2:
        verdict = {"status": "ambiguous", "causes": names, "indistinguishable_from": ["wind"]}
    value = lambda q: {"value": truth[q] + rng.normal(0, 1e-3), "u": 1e-3 * honest}
    base = {q: {"value": truth[q] + 0.01, "u": 1e-3} for q in judge.QUANTITIES}
    extended = {"heldout_rms_over_noise": 1.02 if right else 1.5, "quantities": {q: value(q) for q in judge.QUANTITIES}}
    return {"verdict": verdict, "baseline": {"quantities": base}, "extended": extended}


def made_up(rng, count: int, skill: float, honest: float = 1.0) -> list[judge.Outcome]:
    """A run over a mixed lot."""
    truths = [made_up_truth(rng, ["none", "one", "one", "two", "outside"][n % 5]) for n in range(count)]
    return [judge.judge_session(str(n), t, made_up_answer(rng, t, skill, honest), "") for n, t in enumerate(truths)]


def test_an_honest_program_passes_and_a_boastful_one_fails():
    """400 programs right in 98 of 100; 20 each that are right in 70, state half their uncertainty, or five times it."""
    seed = blind.test_seed()
    print("seed", seed)
    rng = np.random.default_rng(seed)
    failures = sum(bool(judge.judge(made_up(rng, 20, 0.98))[1]) for _ in range(200))
    failures += sum(bool(judge.judge(made_up(rng, 200, 0.98))[1]) for _ in range(200))
    assert failures <= 5  # at most 0.4 expected; six or more has probability 4e-6
    assert all(judge.judge(made_up(rng, 200, 0.7))[1] for _ in range(20))
    assert all(judge.judge(made_up(rng, 200, 0.98, 0.5))[1] for _ in range(20))
    assert all(judge.judge(made_up(rng, 600, 1.0, 5.0))[1] for _ in range(20))


def test_a_few_sessions_fail_what_is_wrong_in_each():
    """400 programs that just meet the rates on four sessions; one always wrong, one without an answer."""
    seed = blind.test_seed()
    print("seed", seed)
    rng = np.random.default_rng(seed)
    truths = [made_up_truth(rng, sort) for sort in ("none", "one", "one", "outside")]
    few = lambda skill: [judge.judge_session("x", t, made_up_answer(rng, t, skill, 1.0), "") for t in truths]
    failures = sum(bool(judge.reasons_in_a_few(few(0.94))) for _ in range(400))
    assert failures <= 5  # at most 0.4 expected; six or more has probability 4e-6
    assert [r.split(":")[0] for r in judge.reasons_in_a_few(few(0.0))] == ["verdict", "held-out error"]
    assert judge.reasons_in_a_few([*few(1.0), judge.judge_session("y", truths[0], None, "exit 1")]) == ["y: exit 1"]


def test_the_bound_is_that_of_the_binomial_where_all_chances_are_alike():
    """P(0 of 4) = 0.08^4 = 4.1e-5, P(at most 1) = 1.9e-3; of two with 0.95 even none at all has 2.5e-3."""
    assert judge.fewest([0.92] * 4, 2.5e-4) == 1
    assert judge.fewest([0.92] * 4, 2e-3) == 2
    assert judge.fewest([0.95] * 2, 2.5e-4) == 0
    assert judge.fewest([], 2.5e-4) == 0


def outcome(sort: str, verdict: dict, **more) -> judge.Outcome:
    """One made-up answer, otherwise right."""
    rng = np.random.default_rng(3)
    truth = made_up_truth(rng, sort)
    result = made_up_answer(rng, truth, 1.0, 1.0) | more
    result["verdict"] = verdict
    return judge.judge_session("x", truth, result, "")


def test_marks_follow_the_verdict():
    """Each way to be wrong misses the rate that it should, and no other."""
    named = lambda *names: {"status": "explained", "causes": list(names)}
    assert outcome("none", {"status": "adequate"}).marks["complete models called adequate"]
    assert not outcome("none", named("wind")).marks["complete models called adequate"]
    truth = next(iter(outcome("one", {}).hidden))
    other = "clock_scale"
    right = "named right, where testable"
    assert outcome("one", named(truth)).marks[right]
    assert not outcome("one", named(other)).marks[right]
    assert not outcome("one", named(truth, other)).marks[right]
    both = {"status": "ambiguous", "causes": [other], "indistinguishable_from": [truth]}
    assert outcome("one", both).marks["ambiguous sets hold the truth"]
    assert not outcome("one", both).marks[right]
    assert not outcome("one", both | {"indistinguishable_from": []}).marks["ambiguous sets hold the truth"]
    unknown = {"status": "unexplained", "causes": ["unknown"]}
    assert outcome("outside", unknown).marks["outside the catalogue called unexplained"]
    assert not outcome("outside", named("wind")).marks["outside the catalogue called unexplained"]
    assert not outcome("two", named(truth)).marks["both of two named"]


def test_what_is_too_faint_or_looks_alike_does_not_count():
    """Below 10 standard deviations, or beside a cause that points the same way: no mark for the name."""
    rng = np.random.default_rng(4)
    for sort, change in (("one", {"signal_sigma": 9.0}), ("one", {"largest_cosine": 0.97}), ("two", {"beside_others_sigma": 9.0})):
        truth = made_up_truth(rng, sort)
        truth["detection"]["effects"][0] |= change
        marks = judge.judge_session("x", truth, made_up_answer(rng, truth, 1.0, 1.0), "").marks
        assert not {"named right, where testable", "both of two named"} & set(marks)


def test_a_set_of_causes_need_not_hold_what_nobody_can_see():
    """Of two effects one of 1 σ may be left out; one of 11 may not, nor the strongest of two that are faint, nor one alone."""
    rng = np.random.default_rng(6)

    def holds(sigmas: list[float], held: int) -> bool:
        truth = made_up_truth(rng, {1: "one", 2: "two"}[len(sigmas)])
        effects = truth["detection"]["effects"]
        for effect, sigma in zip(effects, sigmas):
            effect["signal_sigma"] = sigma
        verdict = {"status": "ambiguous", "causes": ["clock_scale"], "indistinguishable_from": [effects[held]["name"]]}
        answer = made_up_answer(rng, truth, 1.0, 1.0) | {"verdict": verdict}
        return judge.judge_session("x", truth, answer, "").marks["ambiguous sets hold the truth"]

    assert holds([50.0, 1.0], 0) and not holds([50.0, 1.0], 1)
    assert not holds([50.0, 11.0], 0)
    assert holds([8.0, 5.0], 0) and not holds([8.0, 5.0], 1)
    assert holds([2.0], 0)


def test_no_answer_and_absent_figures_are_counted():
    """A crash is a reason by itself; a missing gyradius is outside its interval; a missing held-out error is too large."""
    truth = made_up_truth(np.random.default_rng(5), "one")
    assert judge.judge([judge.judge_session("x", truth, None, "exit 1: no")])[1] == ["x: exit 1: no"]
    bare = judge.judge_session("x", truth, {"verdict": {"status": "adequate"}}, "")
    assert not any(bare.marks.values())
    assert "no answer" in "".join(judge.confusion([judge.judge_session("x", truth, None, "exit 1")]))


def test_a_command_is_run_and_its_troubles_told(tmp_path):
    """A command that answers, one that fails, one that babbles."""
    say = lambda text: ["python3", "-c", text]
    assert judge.critique(say("print('{}')"), tmp_path) == ({}, "")
    assert judge.critique(say("import sys; sys.exit('sorry')"), tmp_path) == (None, "exit 1: sorry")
    assert judge.critique(say("print('well')"), tmp_path)[1].startswith("not JSON")
    assert judge.critique(say("while True: pass"), tmp_path, 0.5)[1].startswith("no answer")
