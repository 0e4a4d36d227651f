//! The paper's routes one by one.

use std::collections::HashMap;

use gyradius_core::identification::routes::catalogue;

use crate::as_json;
use crate::error::Result;

/// The catalogue of routes as JSON: name, equation, summary, inputs and outputs with units.
#[uniffi::export]
pub fn routes_json() -> Result<String> {
    as_json(&catalogue::catalogue())
}

/// Outputs of one route of the paper for given inputs, SI units.
///
/// Fails with `BadArgument` for an unknown route, an unknown or missing input and whatever is
/// outside the domain, with `NoResult` where the inputs contradict each other.
#[uniffi::export]
pub fn evaluate_route(name: &str, inputs: HashMap<String, f64>) -> Result<HashMap<String, f64>> {
    let outputs = catalogue::evaluate(name, &inputs.into_iter().collect())?;
    Ok(outputs.into_iter().collect())
}
