"""Runs sessions that nobody has seen through `gyradius measure` and counts how often the stated intervals hold.

    python tests/blind/coverage.py --count 200 [--seed N] [--keep DIR]

Exit status 0 when the program may be what it says it is. A program whose 95 % intervals truly hold 95 % of the time
fails here less than once in a thousand runs: that risk is shared equally among the quantities (Bonferroni), each judged by
its own binomial bound. A crash, a wrong mode name, or a mode that was set going and not found fails at once.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import generate
import numpy as np
from promises import answer, interval_95, judged, least, sessions_in

QUANTITIES = ("k_yaw_m", "k_pitch_m", "cm_depth_m", "k_roll_m", "psi_deg")
CLEAN_PROMISE = 0.97  # sessions with every name right and every quantity given; 96 of 96 when this was written
CONTRADICTIONS = ("not meant to be excited", "does not show in the data")
SAME_PERIOD = 0.01  # a reported mode further than this from the true period of its name bears the wrong name


@dataclass
class Outcome:
    """One session's result against its truth."""

    name: str
    truth: dict
    trouble: str = ""  # how the program ended, where it did not end well
    z: dict = field(default_factory=dict)  # quantity -> error over its standard uncertainty
    inside: dict = field(default_factory=dict)  # quantity -> whether the stated interval holds the truth
    relative_u: dict = field(default_factory=dict)
    absent: list = field(default_factory=list)
    wrong_names: list = field(default_factory=list)
    missed_modes: list = field(default_factory=list)
    unsaid: list = field(default_factory=list)  # wrong hints that the program let pass
    period_ppm: list = field(default_factory=list)


def expected_quantities(truth: dict) -> list[str]:
    """What the swings of this session determine."""
    modes = {name for swing in truth["swings"].values() for name in swing["excited"]}
    found = ["k_yaw_m", "k_pitch_m", "cm_depth_m"]
    compound_roll = "compound" in modes and truth.get("compound_axis") == "fore_and_aft"
    if "roll_in_phase" in modes or compound_roll:
        found.append("k_roll_m")
    tilts = {round(swing["hull_pitch_deg"]) for swing in truth["swings"].values()}
    return found + (["psi_deg"] if len(tilts) > 2 else [])


def measure(session: Path, timeout_s: float = 300.0) -> tuple[dict | None, str]:
    """The program's JSON, or what went wrong."""
    return answer([sys.executable, "-m", "gyradius", "measure", str(session), "--json", "-"], timeout_s)


def judge_session(name: str, truth: dict, result: dict | None, trouble: str) -> Outcome:
    """One session's result against its truth."""
    outcome = Outcome(name, truth, trouble)
    if result is None:
        return outcome
    for quantity in expected_quantities(truth):
        stated = result.get("quantities", {}).get(quantity)
        if stated is None:
            outcome.absent.append(quantity)
            continue
        error, u = stated["value"] - truth[quantity], stated["u"]
        low, high = interval_95(stated)
        outcome.z[quantity] = error / u if u > 0 else float("inf")
        outcome.inside[quantity] = low <= truth[quantity] <= high
        outcome.relative_u[quantity] = u / abs(truth[quantity]) if quantity != "psi_deg" else u
    reported = {swing["id"]: swing for swing in result.get("swings", [])}
    for swing, true in truth["swings"].items():
        judge_modes(outcome, swing, true, reported.get(swing, {}).get("modes", []))
        warnings = " ".join(reported.get(swing, {}).get("warnings", []))
        if true.get("wrong_hint") and not any(words in warnings for words in CONTRADICTIONS):
            outcome.unsaid.append(f"{swing}: a wrong hint was let pass")
    return outcome


def judge_modes(outcome: Outcome, swing: str, true: dict, modes: list[dict]) -> None:
    """Names of the modes of one swing."""
    for mode in modes:
        name, period = mode["mode"], mode["period_s"]
        if name == "other":
            continue
        right = true["modes"].get(name)
        leeway = max(SAME_PERIOD, 4 * mode.get("period_se_s", 0.0) / period)
        if right is None or abs(period / right["period_s"] - 1) > leeway:
            outcome.wrong_names.append(f"{swing}: {name} at {period:.4f} s")
        elif name in true["excited"]:
            clock = 1 + true["clock_error"]
            outcome.period_ppm.append(1e6 * (period / (right["period_s"] * clock) - 1))
    named = {mode["mode"] for mode in modes}
    outcome.missed_modes += [f"{swing}: {name}" for name in true["excited"] if name not in named]


def least_inside(count: int, tests: int) -> int:
    """Fewer intervals than this that hold happen to an honest program with probability below RISK / tests."""
    return least(count, 0.95, tests)


def judge(outcomes: list[Outcome]) -> tuple[list[str], list[str]]:
    """Lines of the table, and reasons to fail."""
    troubled = [o for o in outcomes if o.trouble]
    reasons = [f"{o.name}: {o.trouble}" for o in troubled]
    expected = {q: [o for o in outcomes if not o.trouble and q in expected_quantities(o.truth)] for q in QUANTITIES}
    tested = [q for q in QUANTITIES if expected[q]]
    table = [f"{'quantity':12}{'n':>5}{'inside':>8}{'needed':>8}{'share':>8}{'mean z':>8}{'sd z':>7}{'max |z|':>9}{'median u':>10}"]
    for q in tested:
        with_value = [o for o in expected[q] if q in o.z]
        count, inside = len(expected[q]), sum(o.inside[q] for o in with_value)
        needed = least_inside(count, len(tested))
        z, u = np.array([o.z[q] for o in with_value]), [o.relative_u[q] for o in with_value]
        figures = f"{z.mean():8.2f}{z.std():7.2f}{np.abs(z).max():9.1f}{np.median(u):10.1e}" if z.size else ""
        table.append(f"{q:12}{count:5}{inside:8}{needed:8}{inside / count:8.3f}{figures}")
        if inside < needed:
            reasons.append(f"{q}: {inside} of {count} intervals hold, {needed} needed")
    ppm = [p for o in outcomes for p in o.period_ppm]
    if ppm:
        marks = np.percentile(np.abs(ppm), [50, 90, 99])
        table.append("periods of modes set going, |error|: " + ", ".join(f"{p} % {m:.1f} ppm" for p, m in zip((50, 90, 99), marks)))
    for label, lists in (
        ("absent", [(o.name, o.absent) for o in outcomes]),
        ("wrong mode name", [(o.name, o.wrong_names) for o in outcomes]),
        ("mode not found", [(o.name, o.missed_modes) for o in outcomes]),
        ("hint not contradicted", [(o.name, o.unsaid) for o in outcomes]),
    ):
        found = [f"{name}: {item}" for name, items in lists for item in items]
        table.append(f"{label}: {len(found)}")
        reasons += [f"{label}: {item}" for item in found]
    table.append(f"no result: {len(troubled)} of {len(outcomes)}")
    return table, reasons


def least_clean(count: int) -> int:
    """Fewer sessions without a wrong, missed or absent item than this happen to a program that keeps its promise of
    CLEAN_PROMISE with probability below RISK."""
    return least(count, CLEAN_PROMISE, 1)


def reasons_in_a_few(outcomes: list[Outcome]) -> list[str]:
    """What fails a program on a few sessions: any crash, too few intervals that hold, or too many sessions with a wrong,
    missed or absent item. (`judge` allows no such item at all, and is for many sessions.)"""
    reasons = [f"{o.name}: {o.trouble}" for o in outcomes if o.trouble]
    clean = sum(not (o.trouble or o.absent or o.wrong_names or o.missed_modes or o.unsaid) for o in outcomes)
    if clean < least_clean(len(outcomes)):
        reasons.append(f"{clean} of {len(outcomes)} sessions are clean, {least_clean(len(outcomes))} needed")
    for q in QUANTITIES:
        given = [o for o in outcomes if q in o.inside]
        inside = sum(o.inside[q] for o in given)
        if given and inside < least_inside(len(given), len(QUANTITIES)):
            reasons.append(f"{q}: {inside} of {len(given)} intervals hold")
    return reasons


def outliers(outcomes: list[Outcome], limit: float = 3.0) -> list[str]:
    """Sessions whose error is over `limit` standard uncertainties, with what is special about their rig."""
    lines = []
    for o in outcomes:
        for q, z in o.z.items():
            if abs(z) > limit:
                swings = o.truth["swings"].values()
                near = min((s.get("period_separation", 1.0) for s in swings), default=1.0)
                kane = min((s.get("kane_tseng_separation", 1.0) for s in swings), default=1.0)
                lines.append(
                    f"  {o.name} {q}: z = {z:+.1f} (periods {100 * near:.1f} %, Kane-Tseng {100 * kane:.1f} % apart, "
                    f"psi {o.truth['psi_deg']:+.1f} deg)"
                )
    return lines


def run(folder: Path, names: list[str], workers: int = 2) -> list[Outcome]:
    """Measure and judge the sessions of a folder."""
    return judged(folder, names, measure, judge_session, workers)


def report(outcomes: list[Outcome]) -> list[str]:
    """Print the table, the outliers and the reasons to fail; return the reasons."""
    table, reasons = judge(outcomes)
    print(*table, *outliers(outcomes), *(f"FAILS {r}" for r in reasons), sep="\n")
    return reasons


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=28)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--kinds", default="".join(generate.KINDS))
    parser.add_argument("--keep", type=Path, default=None, help="folder to keep the sessions in")
    parser.add_argument("--again", type=Path, default=None, help="measure the sessions of this folder, generate none")
    options = parser.parse_args()
    if options.again:
        return 1 if report(run(options.again, sessions_in(options.again))) else 0
    seed = generate.fresh_seed() if options.seed is None else options.seed
    print(f"seed {seed}, {options.count} sessions", flush=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or Path(temporary)
        names = generate.generate(folder, seed, options.count, options.kinds)
        return 1 if report(run(folder, names)) else 0


if __name__ == "__main__":
    sys.exit(main())
