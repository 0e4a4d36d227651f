"""Fails where Surefire ran another number of tests than there are: Maven is green, too, when it finds none.

There are as many as the test sources have annotations: ``@Test`` one, ``@ValueSource`` one for each value, and
``@TestFactory`` one for each case of the shared vectors.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
VECTORS = HERE.parents[1] / "tests" / "vectors"


def written() -> int:
    files = [json.loads(path.read_text(encoding="utf-8")) for path in VECTORS.glob("*.json") if path.stem != "schema"]
    cases = sum(file["number_of_tests"] for file in files)
    text = "".join(path.read_text(encoding="utf-8") for path in (HERE / "src/test/kotlin").rglob("*.kt"))
    values = re.findall(r"@ValueSource\(strings = \[([^\]]*)\]\)", text)
    plain = len(re.findall(r"@Test\b", text))
    return plain + sum(len(one.split(",")) for one in values) + cases * len(re.findall(r"@TestFactory\b", text))


def ran() -> dict[str, int]:
    suites = [ElementTree.parse(path).getroot() for path in (HERE / "target/surefire-reports").glob("TEST-*.xml")]
    return {name: sum(int(suite.get(name, 0)) for suite in suites) for name in ("tests", "failures", "errors", "skipped")}


def main() -> None:
    expected, found = written(), ran()
    print(f"{found['tests']} Kotlin tests ran, {expected} are written; {found}")
    if found != {"tests": expected, "failures": 0, "errors": 0, "skipped": 0}:
        sys.exit("not every Kotlin test ran, or not every one passed")


if __name__ == "__main__":
    main()
