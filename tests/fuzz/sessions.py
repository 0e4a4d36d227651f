"""Fuzz of whole sessions: each input must be measured or refused with a reason, within a limit of time and memory.

`make fuzz N=20000` draws a seed and prints it; `python tests/fuzz/sessions.py --count N --seed S` repeats it. Inputs that failed are made
as small as can be and kept in `tests/fuzz/corpus`, which `test_sessions.py` runs again.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from random import Random

from inputs import Input
from mutate import mutated
from runner import Outcome, Runner
from seeds import seeds

CORPUS = Path(__file__).with_name("corpus")
#: Their recordings are fitted by simulation, which takes a second: not as often as the others.
SLOW = {"recorded", "with-phone", "zip", "inclined", "recorder", "phyphox-import", "sensor-logger", "sensor-logger-loose"}
#: Periods alone, which are criticised in a fraction of a second.
TYPED = {"typed", "tilted", "moved", "whole", "incline-recorded"}
#: Tries to make one failing input smaller, and the time for them, s.
TRIES = 80
MOST_S = 90.0


def drawn(seed: int, count: int, only: set[str] | None = None) -> Iterator[tuple[int, Input]]:
    """Mutated inputs with their numbers; each depends on the seed and its own number alone."""
    whole = [one for one in seeds() if only is None or one.name in only]
    weights = [weight(one) for one in whole]
    for number in range(count):
        rng = Random(f"{seed}:{number}")
        yield number, mutated(rng, rng.choices(whole, weights)[0])


def weight(one: Input) -> int:
    """How often an input is drawn: sessions that are measured quickly more than others."""
    if one.name in SLOW:
        return 1
    return 12 if one.name.startswith(("fixture", "described")) else 60


def signature(found: Outcome) -> str:
    """What two failures of one kind have in common: their words without numbers and quoted ids."""
    return f"{found.kind}: {re.sub(r'[-+0-9.e]{2,}|[0-9]', '#', found.text)[:90]}"


def smaller(runner: Runner, given: Input, found: Outcome, critique: bool = False) -> Input:
    """The input with fewer lines that still fails in the same way."""
    left, end = TRIES, time.monotonic() + MOST_S

    def fails(candidate: Input) -> bool:
        nonlocal left
        left = left - 1 if time.monotonic() < end else 0
        return signature(runner.run(candidate, critique=critique)) == signature(found)

    for name in sorted(given.files):
        lines = given.files[name].split(b"\n")
        size = len(lines) // 2
        while size >= 1 and left > 0:
            place = 0
            while place < len(lines) and left > 0:
                kept = lines[:place] + lines[place + size :]
                candidate = replace(given, files={**given.files, name: b"\n".join(kept)})
                if fails(candidate):
                    lines, given = kept, candidate
                else:
                    place += size
            size //= 2
    return given


def kept() -> set[str]:
    """What the corpus holds already."""
    found = [json.loads(path.read_text(encoding="utf-8"))["why"].partition(": ") for path in CORPUS.glob("*.json")]
    return {signature(Outcome(kind, text, 0.0, 0.0)) for kind, _, text in found}


def keep(given: Input, found: Outcome) -> Path:
    """Writes a failing input to the corpus."""
    CORPUS.mkdir(exist_ok=True)
    text = given.to_json(f"{found.kind}: {found.text[:200]}")
    target = CORPUS / f"{found.kind}-{hashlib.sha256(text.encode()).hexdigest()[:10]}.json"
    target.write_text(text, encoding="utf-8")
    return target


def main() -> int:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="Number of the first input.")
    parser.add_argument("--seed", type=int, help="Drawn where it is left out.")
    parser.add_argument("--critique", action="store_true", help="Sessions of typed periods alone, each criticised as well.")
    given = parser.parse_args()
    seed = time.time_ns() % 2**32 if given.seed is None else given.seed
    print(f"seed {seed}", flush=True)
    ends: Counter[str] = Counter()
    known: Counter[str] = Counter()
    before = kept()
    slowest, largest, start = 0.0, 0.0, time.monotonic()
    with Runner() as runner:
        for number, one in drawn(seed, given.count, TYPED if given.critique else None):
            if number < given.first:
                continue
            found = runner.run(one, critique=given.critique)
            ends[found.kind if found.failed else f"{found.kind} {found.text if found.kind == 'ok' else ''}"] += 1
            slowest, largest = max(slowest, found.seconds), max(largest, found.megabytes)
            if found.failed:
                same = signature(found)
                known[same] += 1
                print(f"{number} {one.name} {found.kind} {found.seconds:.1f} s: {found.text[:300]}", flush=True)
                if known[same] == 1 and same not in before:
                    print(f"  kept as {keep(smaller(runner, one, found, given.critique), found).name}", flush=True)
            if number % 500 == 499:
                print(f"{number + 1} inputs, {time.monotonic() - start:.0f} s: {dict(ends)}", flush=True)
    print(f"seed {seed}, {sum(ends.values())} inputs: {dict(ends)}; longest {slowest:.1f} s, largest {largest:.0f} MB")
    for same, count in known.most_common():
        print(f"  {count:5d} {same}")
    return 1 if known else 0


if __name__ == "__main__":
    sys.exit(main())
