"""Runs the program on sessions with hidden effects and judges what it says of them.

    python tests/hidden/judge.py --count 200 [--seed N] [--command "gyradius critique"] [--keep DIR] [--report FILE.md]

Exit status 0 when the program may be one that meets the rates below. One that does is failed here less than once in a
thousand runs: that risk is shared equally among the rates (Bonferroni), each judged by its own binomial bound. A session without
an answer fails at once.

An effect is *testable* where it stands out by more than 10 standard deviations and no other cause points its way (largest
cosine below 0.95, `detect.py`: of 11 standard deviations that leaves as few as 3 beside the nearest cause, so that those are told
of by themselves of which 10 are left); one outside the catalogue, where it stands out so far beside the cause that is nearest; one of
two, where it does so beside the other, every number of which is open. A set of causes that are not told apart must hold all of the hidden that
stands out by so much, or the strongest: one of 1 standard deviation beside it is nobody's to see.
"""

from __future__ import annotations

import argparse
import shlex
import sys
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np
import sessions
from borrowed import blind, promises
from scipy.stats import binom

COMMAND = f"{sys.executable} -m gyradius critique"
DETECTABLE_SIGMA, SEPARABLE_COSINE = 10.0, 0.95
HELDOUT_LIMIT = 1.1  # of the noise
ALIKE = 2.0  # extended uncertainties: a base model no further from the truth than this is not told from a right one
QUANTITIES = ("k_yaw_m", "k_pitch_m")
RATES = {
    "named right, where testable": 0.95,
    "named right, where 10 σ stand out beside the nearest cause too": 0.95,
    "complete models called adequate": 0.98,
    "outside the catalogue called unexplained": 0.90,
    "ambiguous sets hold the truth": 0.95,
    "both of two named": 0.80,
    "k_yaw_m inside its 95 % interval": 0.92,
    "k_pitch_m inside its 95 % interval": 0.92,
    "k_yaw_m nearer than the base model's, where that is off": 0.90,
    "k_pitch_m nearer than the base model's, where that is off": 0.90,
    "held-out error within 1.1 of the noise": 0.95,
}
# What is judged together on a few sessions; no session has two marks in one of these.
A_FEW = {
    "verdict": ["named right, where testable", "complete models called adequate", "outside the catalogue called unexplained"],
    "k_yaw_m": ["k_yaw_m inside its 95 % interval"],
    "k_pitch_m": ["k_pitch_m inside its 95 % interval"],
    "held-out error": ["held-out error within 1.1 of the noise"],
}
AT_MOST = {q: 0.98 for q in RATES if "inside" in q}  # intervals too wide are wrong too


@dataclass
class Outcome:
    """What was hidden in a session and what the program says."""

    name: str
    truth: dict
    result: dict | None = None
    trouble: str = ""
    marks: dict = field(default_factory=dict)  # rate -> whether this session meets it; absent where it does not apply

    @property
    def hidden(self) -> set[str]:
        """Names of what is hidden."""
        return {h["name"] for h in self.truth["hidden"]}

    @property
    def verdict(self) -> dict:
        """The program's."""
        return (self.result or {}).get("verdict") or {}

    @property
    def named(self) -> set[str]:
        """Causes that the verdict names."""
        return set(self.verdict.get("causes") or [])

    @property
    def held(self) -> set[str]:
        """Those, and the ones not told from them."""
        return self.named | set(self.verdict.get("indistinguishable_from") or [])

    @property
    def to_hold(self) -> set[str]:
        """Of what is hidden, what a set of causes that are not told apart must hold: what stands out, or the strongest."""
        strengths = {e["name"]: e["signal_sigma"] for e in self.truth["detection"]["effects"]}
        return {n for n, sigma in strengths.items() if sigma > DETECTABLE_SIGMA or sigma == max(strengths.values())}

    def testable(self) -> bool:
        """Whether every hidden effect stands out and looks like no other."""
        key = {"outside": "beyond_best_cause_sigma", "two": "beside_others_sigma"}.get(self.truth["sort"], "signal_sigma")
        found = self.truth["detection"]["effects"]
        apart = self.truth["sort"] == "outside" or all(e["largest_cosine"] < SEPARABLE_COSINE for e in found)
        return bool(found) and apart and all(e[key] > DETECTABLE_SIGMA for e in found)

    def detectable(self) -> bool:
        """Whether every hidden effect stands out."""
        found = self.truth["detection"]["effects"]
        return bool(found) and all(e["signal_sigma"] > DETECTABLE_SIGMA for e in found)


def critique(command: list[str], session: Path, timeout_s: float = 600.0) -> tuple[dict | None, str]:
    """The program's JSON, or what went wrong."""
    return promises.answer([*command, str(session), "--json", "-"], timeout_s)


def judge_session(name: str, truth: dict, result: dict | None, trouble: str) -> Outcome:
    """One session's answer against its truth."""
    outcome = Outcome(name, truth, result, trouble)
    if result is None:
        return outcome
    mark_verdict(outcome)
    for quantity in QUANTITIES:
        mark_quantity(outcome, quantity)
    heldout = (result.get("extended") or {}).get("heldout_rms_over_noise")
    if truth["sort"] != "outside":
        outcome.marks["held-out error within 1.1 of the noise"] = heldout is not None and heldout <= HELDOUT_LIMIT
    return outcome


def mark_verdict(outcome: Outcome) -> None:
    """Status and names."""
    sort, status, marks = outcome.truth["sort"], outcome.verdict.get("status"), outcome.marks
    if sort == "none":
        marks["complete models called adequate"] = status == "adequate"
    if sort == "one" and outcome.testable():
        right = status == "explained" and outcome.named == outcome.hidden
        marks["named right, where testable"] = right
        if all(e["beyond_best_cause_sigma"] > DETECTABLE_SIGMA for e in outcome.truth["detection"]["effects"]):
            marks["named right, where 10 σ stand out beside the nearest cause too"] = right
    if sort == "two" and outcome.testable():
        marks["both of two named"] = outcome.hidden <= outcome.named
    if sort == "outside" and outcome.testable():
        marks["outside the catalogue called unexplained"] = status == "unexplained"
    if sort in ("one", "two") and status == "ambiguous":
        marks["ambiguous sets hold the truth"] = outcome.to_hold <= outcome.held


def mark_quantity(outcome: Outcome, quantity: str) -> None:
    """An extended gyradius: inside its interval, and nearer than the base model's where that is off."""
    given = lambda model: ((outcome.result.get(model) or {}).get("quantities") or {}).get(quantity)
    extended, base, true = given("extended"), given("baseline"), outcome.truth[quantity]
    if extended is None:
        outcome.marks[f"{quantity} inside its 95 % interval"] = False
        return
    error, u = abs(extended["value"] - true), extended["u"]
    low, high = promises.interval_95(extended)
    outcome.marks[f"{quantity} inside its 95 % interval"] = low <= true <= high
    if base and outcome.truth["sort"] in ("one", "two") and outcome.detectable() and abs(base["value"] - true) > ALIKE * u:
        outcome.marks[f"{quantity} nearer than the base model's, where that is off"] = error < abs(base["value"] - true)


def most(count: int, rate: float, tests: int) -> int:
    """More than this happen to a program that keeps this rate with probability below RISK / tests."""
    return int(binom.isf(promises.RISK / tests, count, rate))


def fewest(chances: list[float], risk: float) -> int:
    """Fewer of these events than this happen with probability below `risk`, each having its own chance."""
    spread = np.ones(1)
    for chance in chances:
        spread = np.convolve(spread, [1 - chance, chance])
    return int(np.searchsorted(np.cumsum(spread), risk, "right"))


def reasons_in_a_few(outcomes: list[Outcome]) -> list[str]:
    """What fails a program on a few sessions: no answer, or so few right in one of the groups of A_FEW that one that meets
    the rates does so less than once in a thousand runs. (`judge` looks at every rate by itself, and is for many sessions.)"""
    reasons = [f"{o.name}: {o.trouble}" for o in outcomes if o.trouble]
    for label, rates in A_FEW.items():
        marks = [(RATES[rate], o.marks[rate]) for o in outcomes for rate in rates if rate in o.marks]
        met, needed = sum(mark for _, mark in marks), fewest([chance for chance, _ in marks], promises.RISK / len(A_FEW))
        if met < needed:
            reasons.append(f"{label}: {met} of {len(marks)}, {needed} needed")
    return reasons


def judge(outcomes: list[Outcome]) -> tuple[list[str], list[str]]:
    """Lines of a Markdown table of the rates, and reasons to fail."""
    reasons = [f"{o.name}: {o.trouble}" for o in outcomes if o.trouble]
    lines = ["| rate | required | cases | met | share | bound |", "|---|---|---|---|---|---|"]
    tests = len(RATES) + len(AT_MOST)
    for rate, required in RATES.items():
        marks = [o.marks[rate] for o in outcomes if rate in o.marks]
        if not marks:
            lines.append(f"| {rate} | {required:.0%} | 0 | | | |")
            continue
        count, met = len(marks), sum(marks)
        low, high = promises.least(count, required, tests), most(count, AT_MOST[rate], tests) if rate in AT_MOST else count
        bound = f"≥ {low}" + (f", ≤ {high}" if rate in AT_MOST else "")
        lines.append(f"| {rate} | {required:.0%} | {count} | {met} | {met / count:.3f} | {bound} |")
        if not low <= met <= high:
            reasons.append(f"{rate}: {met} of {count}, wanted {bound}")
    return lines, reasons


def answer(outcome: Outcome) -> str:
    """The verdict in a word, as a column of the confusion matrix."""
    status = outcome.verdict.get("status")
    if outcome.result is None:
        return "no answer"
    if status == "ambiguous":
        return "ambiguous, with it" if outcome.hidden and outcome.to_hold <= outcome.held else "ambiguous, without it"
    if status == "explained":
        return "right" if outcome.named == outcome.hidden else "+".join(sorted(outcome.named)) or "nothing named"
    return str(status)


def confusion(outcomes: list[Outcome]) -> list[str]:
    """Markdown: what was hidden, against what was said of it; each also where it is testable."""
    fixed = ["right", "adequate", "ambiguous, with it", "ambiguous, without it", "unexplained", "no answer"]
    rows: dict[str, list[Outcome]] = {}
    for o in outcomes:
        label = "two" if o.truth["sort"] == "two" else next(iter(o.hidden), "none")
        rows.setdefault(label, []).append(o)
    lines = ["| hidden | drawn | testable | " + " | ".join(fixed) + " | named otherwise |", "|---" * (len(fixed) + 4) + "|"]
    for label in sorted(rows, key=lambda x: (x != "none", x)):
        said = Counter(answer(o) for o in rows[label])
        others = ", ".join(f"{k} ({v})" for k, v in said.most_common() if k not in fixed)
        testable = sum(o.testable() for o in rows[label])
        counts = " | ".join(str(said[k] or "") for k in fixed)
        lines.append(f"| {label} | {len(rows[label])} | {testable} | {counts} | {others} |")
    return lines


def gains(outcomes: list[Outcome]) -> list[str]:
    """Markdown: held-out error of the base model over that of the extended one, by what was hidden."""
    lines = ["| hidden | sessions | held-out error, base over extended: median | least | largest |", "|---|---|---|---|---|"]
    for sort in sessions.SHARES:
        ratios = [((o.result or {}).get("gain") or {}).get("heldout_rms_ratio") for o in outcomes if o.truth["sort"] == sort]
        known = [r for r in ratios if r is not None]
        if known:
            lines.append(f"| {sort} | {len(known)} | {np.median(known):.2f} | {min(known):.2f} | {max(known):.1f} |")
    return lines


def missed(outcomes: list[Outcome]) -> list[str]:
    """Sessions that miss a verdict where it counts, so that they can be looked into."""
    lines = []
    for o in outcomes:
        if any(not met for rate, met in o.marks.items() if "inside" not in rate and "nearer" not in rate):
            told = ", ".join(f"{e['name']} {e['signal_sigma']:.0f} σ (like {e['nearest']} {e['largest_cosine']:.2f}, "
                             f"{e['beyond_best_cause_sigma']:.0f} σ beside it)"
                             for e in o.truth["detection"]["effects"]) or "none"  # fmt: skip
            lines.append(f"- {o.name}: {told}: {answer(o)}")
    return lines


def run(folder: Path, names: list[str], command: list[str], workers: int = 2, timeout_s: float = 600.0) -> list[Outcome]:
    """Ask the program about the sessions of a folder, and judge."""
    return promises.judged(folder, names, partial(critique, command, timeout_s=timeout_s), judge_session, workers)


def generate(folder: Path, seed: int, count: int, effect: str | None = None, workers: int = 2) -> list[str]:
    """Sessions with their truths, detection included."""
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(partial(sessions.make, folder, seed, wanted=effect, detect=True), range(count)))


def report(outcomes: list[Outcome], title: str, drawn_by: str) -> tuple[str, list[str]]:
    """Markdown, and the reasons to fail."""
    rates, reasons = judge(outcomes)
    failing = [f"- FAILS {r}" for r in reasons] or ["- nothing fails"]
    parts = [[f"# {title}"], [drawn_by], rates, failing, confusion(outcomes), gains(outcomes), missed(outcomes)]
    return "\n\n".join("\n".join(p) for p in parts if p) + "\n", reasons


def again(options: argparse.Namespace, seed: int) -> str:
    """The command that draws the same sessions."""
    effect = f" --effect {options.effect}" if options.effect else ""
    return f"python tests/hidden/judge.py --count {options.count} --seed {seed}{effect}"


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--effect", default=None, help="hide this in every session")
    parser.add_argument("--command", default=COMMAND)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--keep", type=Path, default=None, help="folder to keep the sessions in")
    parser.add_argument("--again", type=Path, default=None, help="judge on the sessions of this folder, generate none")
    parser.add_argument("--report", type=Path, default=None, help="Markdown file, beside standard output")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder, seed = options.again or options.keep or Path(temporary), options.seed
        if options.again:
            names = promises.sessions_in(folder)
        else:
            seed = blind.fresh_seed() if seed is None else seed
            print(f"seed {seed}, {options.count} sessions", flush=True)
            names = generate(folder, seed, options.count, options.effect, options.workers)
        outcomes = run(folder, names, shlex.split(options.command), options.workers)
    drawn_by = f"Drawn by `{again(options, seed)}`." if seed is not None else f"Drawn before, in {folder}."
    text, reasons = report(outcomes, f"Hidden effects: {len(outcomes)} sessions", drawn_by)
    print(text)
    if options.report:
        options.report.write_text(text)
    return 1 if reasons else 0


if __name__ == "__main__":
    sys.exit(main())
