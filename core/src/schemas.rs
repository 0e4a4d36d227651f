//! JSON schemas of what the program writes, generated from its types: the project's own statement of the contract. They are
//! committed under `tests/schemas`; a test fails where they are stale.

use schemars::{Schema, schema_for};

use crate::diagnosis::{Critique, SwingTrace};
use crate::identification::Measurement;
use crate::online::Estimate;
use crate::planning::{Plan, Request};
use crate::procedure::{State, Task};
use crate::simulator::Truth;

/// Every schema by the name of its file, without the ending.
pub fn schemas() -> Vec<(&'static str, Schema)> {
    vec![
        ("measurement", schema_for!(Measurement)),
        ("critique", schema_for!(Critique)),
        ("critique-traces", schema_for!(Vec<SwingTrace>)),
        ("plan", schema_for!(Plan)),
        ("plan-request", schema_for!(Request)),
        ("truth", schema_for!(Truth)),
        ("online-estimate", schema_for!(Estimate)),
        ("procedure-state", schema_for!(State)),
        ("procedure-task", schema_for!(Task)),
    ]
}

/// A schema as its file has it.
///
/// # Errors
/// None that a schema can cause: the error is serde's.
pub fn written(schema: &Schema) -> serde_json::Result<String> {
    serde_json::to_string_pretty(schema).map(|text| text + "\n")
}
