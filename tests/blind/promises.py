"""What a program says of a session, and how often it may be wrong by chance: shared by those that judge it on many."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scipy.stats import binom

RISK = 1e-3  # of failing a program that keeps its promise
HALF_WIDTH = 1.959964  # standard uncertainties in half a 95 % interval of a normal distribution


def answer(command: list[str], timeout_s: float) -> tuple[dict | None, str]:
    """The program's JSON from its standard output, or what went wrong."""
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=timeout_s)
    except subprocess.TimeoutExpired:
        return None, f"no answer in {timeout_s:.0f} s"
    lines = run.stderr.strip().splitlines()
    if run.returncode != 0:
        return None, f"exit {run.returncode}: {lines[-1] if lines else ''}"
    try:
        return json.loads(run.stdout), ""
    except json.JSONDecodeError as error:
        return None, f"not JSON: {error}"


def interval_95(stated: dict) -> tuple[float, float]:
    """The 95 % interval of a stated quantity."""
    value, u = stated["value"], stated["u"]
    return stated.get("interval_95") or (value - HALF_WIDTH * u, value + HALF_WIDTH * u)


def least(count: int, rate: float, tests: int) -> int:
    """Fewer than this happen to a program that keeps this rate with probability below RISK / tests."""
    return int(binom.ppf(RISK / tests, count, rate))


def sessions_in(folder: Path) -> list[str]:
    """Names of a folder's sessions, each with its truth beside."""
    return sorted(path.name.removesuffix(".truth.json") for path in folder.glob("*.truth.json"))


def judged(folder: Path, names: list[str], ask: Callable, judge_session: Callable, workers: int) -> list:
    """Ask the program about the sessions of a folder, and judge each answer against its truth."""
    with ThreadPoolExecutor(workers) as pool:
        answers = list(pool.map(ask, [folder / name for name in names]))
    truths = [json.loads((folder / f"{name}.truth.json").read_text()) for name in names]
    return [judge_session(n, t, *a) for n, t, a in zip(names, truths, answers)]
