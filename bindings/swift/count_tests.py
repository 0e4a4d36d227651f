"""count_tests.py EVENTS: fails where another number of tests ran than there are, or one did not pass.

There are as many as the test sources have annotations: ``@Test`` one, with a list of arguments one for each, and with
``Case.all`` one for each case of the shared vectors.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
VECTORS = HERE.parents[1] / "tests" / "vectors"


def written() -> int:
    files = [json.loads(path.read_text(encoding="utf-8")) for path in VECTORS.glob("*.json") if path.stem != "schema"]
    cases = sum(file["number_of_tests"] for file in files)
    text = "".join(path.read_text(encoding="utf-8") for path in (HERE / "Tests").rglob("*.swift"))
    tests = re.findall(r"@Test\b(?:\((.*)\)$)?", text, re.MULTILINE)
    return sum(times(arguments, cases) for arguments in tests)


def times(arguments: str, cases: int) -> int:
    """How often a test with these words behind its annotation runs."""
    if "arguments: Case.all" in arguments:
        return cases
    listed = re.search(r"arguments: \[(.*)\]", arguments)
    return len(listed.group(1).split(",")) if listed else 1


def ran(events: Path) -> Counter[str]:
    """What happened how often. A test without arguments ends once itself; of others each case ends."""
    lines = [json.loads(line) for line in events.read_text(encoding="utf-8").splitlines()]
    tests = [line["payload"] for line in lines if line["kind"] == "test"]
    plain = {test["id"] for test in tests if test["kind"] == "function" and not test["isParameterized"]}
    happened = [line["payload"] for line in lines if line["kind"] == "event"]
    ended = sum(event["kind"] == "testEnded" and event["testID"] in plain for event in happened)
    return Counter(event["kind"] for event in happened) + Counter(ended=ended)


def main() -> None:
    expected, found = written(), ran(Path(sys.argv[1]))
    ended, failures, skipped = found["ended"] + found["testCaseEnded"], found["issueRecorded"], found["testSkipped"]
    print(f"{ended} Swift tests ran, {expected} are written; {failures} failures, {skipped} skipped")
    if (ended, failures, skipped) != (expected, 0, 0):
        sys.exit("not every Swift test ran, or not every one passed")


if __name__ == "__main__":
    main()
