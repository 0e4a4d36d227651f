"""The JSON that the program writes holds to the schemas under tests/schemas, and the package's classes to both."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import jsonschema
import pytest
from conftest import ROOT

import gyradius
from gyradius import critique, measurement, planning

SCHEMAS = ROOT / "tests" / "schemas"
SESSIONS = ROOT / "python" / "gyradius" / "sessions"
# Classes whose name in the core is another.
IN_THE_CORE = {"Quantity": "QuantityResult"}
CLASSES = [
    ("measurement", measurement.Measurement),
    *(
        ("measurement", getattr(measurement, name))
        for name in (
            "AmplitudePoint",
            "ModeResult",
            "Repair",
            "SwingResult",
            "Quantity",
            "Route",
            "BudgetLine",
            "Verdict",
        )
    ),
    ("measurement", measurement.Claim),
    ("critique", critique.Critique),
    *(
        ("critique", getattr(critique, name))
        for name in (
            "ModelResult",
            "Discrepancy",
            "ParameterResult",
            "CauseResult",
            "NextSwing",
            "CauseVerdict",
            "Gain",
        )
    ),
    ("critique", critique.Gain),
    ("critique", critique.LearnedForce),
    *(("plan", getattr(planning, name)) for name in ("HangingAdvice", "Beat", "PredictedSwing", "PredictedQuantity")),
]


def schema(name: str) -> dict[str, Any]:
    """One of the committed schemas."""
    return json.loads((SCHEMAS / f"{name}.json").read_text(encoding="utf-8"))  # type: ignore[no-any-return]


@pytest.mark.parametrize(("name", "kind"), CLASSES, ids=lambda value: getattr(value, "__name__", value))
def test_a_class_has_fields_that_the_schema_knows(name: str, kind: type) -> None:
    whole = schema(name)
    called = IN_THE_CORE.get(kind.__name__, kind.__name__)
    described = whole if whole["title"] == called else whole["$defs"][called]
    fields = {field.name for field in dataclasses.fields(kind) if not field.name.startswith("_")}
    assert fields <= set(described["properties"]), fields - set(described["properties"])


@pytest.mark.parametrize("session", ["boat-park", "keelboat", "model-hull"])
def test_a_measurement_holds_to_its_schema(session: str) -> None:
    measured = gyradius.load(SESSIONS / session).measure()
    jsonschema.validate(json.loads(measured.to_json()), schema("measurement"))


def test_a_criticism_holds_to_its_schema() -> None:
    for path in sorted((ROOT / "core/crates/report/tests/it/report/critiques").glob("*.json")):
        jsonschema.validate(json.loads(path.read_text(encoding="utf-8")), schema("critique"))
    criticised = gyradius.load(SESSIONS / "keelboat").critique()
    jsonschema.validate(json.loads(criticised.to_json()), schema("critique"))


def test_a_plan_holds_to_its_schema() -> None:
    plan = gyradius.plan(mass=622, length=6.35, beam=1.73, boat_type="keelboat")
    jsonschema.validate(json.loads(plan.to_json()), schema("plan"))


def test_what_does_not_hold_is_refused() -> None:
    measured = json.loads(gyradius.load(SESSIONS / "keelboat").measure().to_json())
    measured["quantities"]["k_yaw_m"]["u"] = "small"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(measured, schema("measurement"))
