"""The vectors of ``tests/vectors``, as every language runs them."""

from __future__ import annotations

import json
from typing import Any

import pytest
from conftest import ROOT

import gyradius

FOLDER = ROOT / "tests" / "vectors"
FILES = [
    json.loads(path.read_text(encoding="utf-8")) for path in sorted(FOLDER.glob("*.json")) if path.stem != "schema"
]
CASES = [(file["algorithm"], case) for file in FILES for case in file["tests"]]


def test_every_file_is_known_and_whole() -> None:
    assert sorted(file["algorithm"] for file in FILES) == sorted(route["name"] for route in gyradius.routes())
    assert [len(file["tests"]) for file in FILES] == [file["number_of_tests"] for file in FILES]
    assert len({case["id"] for _, case in CASES}) == len(CASES) > 200


def test_every_file_follows_the_schema() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((FOLDER / "schema.json").read_text(encoding="utf-8"))
    for file in FILES:
        jsonschema.validate(file, schema)


@pytest.mark.parametrize(("algorithm", "case"), CASES, ids=[case["id"] for _, case in CASES])
def test_vector(algorithm: str, case: dict[str, Any]) -> None:
    if case["result"] == "invalid":
        # An argument outside its domain is bad input; arguments that contradict each other have no result.
        refused = {"argument": gyradius.InputError, "no_result": gyradius.NoResultError}[case["error"]]
        with pytest.raises(refused):
            gyradius.evaluate_route(algorithm, case["inputs"])
        return
    found = gyradius.evaluate_route(algorithm, case["inputs"])
    for name, text in case["expected"].items():
        tolerance = case["tolerance"][name]
        allowed = tolerance.get("abs", 0.0) + tolerance.get("rel", 0.0) * abs(float(text))
        assert abs(found[name] - float(text)) <= allowed, (name, found[name], text)
