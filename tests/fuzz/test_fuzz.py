"""The fuzz in short: the whole inputs, some hundreds of mutations with a fixed seed, and the inputs that once failed."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from random import Random

import pytest

pytest.importorskip("resource", reason="no limits on memory on this system")

from inputs import Input  # noqa: E402
from mutate import mutated  # noqa: E402
from runner import Runner  # noqa: E402
from seeds import seeds  # noqa: E402
from sessions import CORPUS, SLOW, drawn  # noqa: E402

COUNT = 300
# Inputs that are known to fail, and why; strict, so that the one who mends it takes the line out.
KNOWN: dict[str, str] = {}


def seed() -> int:
    """The same in every run, unless ``GYRADIUS_SEED`` is ``random`` or a number."""
    wanted = os.environ.get("GYRADIUS_SEED", "20140101")
    found = time.time_ns() % 2**32 if wanted == "random" else int(wanted)
    print("seed", found, file=sys.stderr)
    return found


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    with Runner() as started:
        yield started


def test_whole_inputs_are_read(runner: Runner) -> None:
    # One of those that are fitted by simulation is enough here.
    ends = {given.name: runner.run(given) for given in seeds() if given.name not in SLOW - {"with-phone"}}
    assert not {name: found for name, found in ends.items() if found.failed}
    for name in ("typed", "tilted", "whole", "compound", "gates", "with-phone"):
        assert ends[name].text == "measured", f"{name}: {ends[name]}"


def test_mutated_inputs_are_measured_or_refused(runner: Runner) -> None:
    ends = []
    for number, given in drawn(seed(), COUNT):
        found = runner.run(given)
        ends.append(found.kind)
        assert not found.failed, f"input {number}, {given.name}: {found}"
    # Where all were refused nothing would have been tested.
    assert ends.count("ok") > COUNT / 10


def test_a_failure_is_seen(runner: Runner) -> None:
    given = next(one for one in seeds() if one.name not in SLOW and one.action == "session")
    assert runner.run(given, most_s=0.0).kind == "too_slow"
    assert not runner.run(given).failed


def test_a_mutation_depends_on_its_seed_alone() -> None:
    given = seeds()[0]
    assert mutated(Random("1:2"), given).to_json() == mutated(Random("1:2"), given).to_json()
    assert len({mutated(Random(f"1:{i}"), given).to_json() for i in range(50)}) > 40


@pytest.mark.parametrize("name", sorted(path.name for path in CORPUS.glob("*.json")))
def test_what_once_failed(runner: Runner, name: str, request: pytest.FixtureRequest) -> None:
    if name in KNOWN:
        request.node.add_marker(pytest.mark.xfail(reason=KNOWN[name]))
    given = Input.from_json((CORPUS / name).read_text(encoding="utf-8"))
    found = runner.run(given)
    assert not found.failed, found
