"""Recomputes every vector with mpmath and fails on a mismatch; `--fill` writes `expected` where there is none yet.

An expected value that stands in a file is never overwritten. Needs mpmath only.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from mpmath import mp, mpf
from routes import ORACLES

FOLDER = Path(__file__).resolve().parent.parent / "vectors"
DIGITS = 30
# Oracle values carry 30 digits, of which the last is rounded.
ROUNDING = mpf(10) ** -28


def recomputed(algorithm: str, case: dict[str, Any]) -> dict[str, Any]:
    # Inputs are the doubles that every language reads, not the decimals.
    return ORACLES[algorithm]({key: mpf(float(value)) for key, value in case["inputs"].items()})


def mismatches(algorithm: str, case: dict[str, Any]) -> list[str]:
    if case["result"] == "invalid":
        return [] if "expected" not in case else [f"{case['id']}: invalid, but expects values"]
    wrong = []
    values = recomputed(algorithm, case)
    for key, text in case["expected"].items():
        expected, value = mpf(text), values[key]
        tolerance = case["tolerance"][key]
        allowed = mpf(tolerance.get("abs", 0)) + mpf(tolerance.get("rel", 0)) * abs(expected)
        if case["source"].startswith("oracle"):
            allowed = max(ROUNDING * abs(value), ROUNDING)
        if not abs(value - expected) <= allowed:
            wrong.append(f"{case['id']} {key}: {mp.nstr(value, 17)}, expected {text} within {mp.nstr(allowed, 3)}")
    return wrong


def fill(path: Path, document: dict[str, Any]) -> None:
    for case in document["tests"]:
        if case["result"] == "valid" and not case["expected"]:
            values = recomputed(document["algorithm"], case)
            wanted = case["tolerance"]
            case["expected"] = {key: mp.nstr(values[key], DIGITS) for key in wanted}
    path.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def main() -> int:
    files = sorted(path for path in FOLDER.glob("*.json") if path.stem != "schema")
    wrong, cases = [], 0
    for path in files:
        document = json.loads(path.read_text(encoding="utf-8"))
        if "--fill" in sys.argv:
            fill(path, document)
        for case in document["tests"]:
            cases += 1
            wrong += mismatches(document["algorithm"], case)
    missing = set(ORACLES) ^ {path.stem for path in files}
    wrong += [f"{name}: an oracle or a vector file without the other" for name in sorted(missing)]
    print(f"{cases} cases of {len(files)} files recomputed, {len(wrong)} mismatches")
    print("\n".join(wrong))
    return 1 if wrong or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
