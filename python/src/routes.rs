//! The paper's routes one by one.

use gyradius_core::identification::routes::catalogue::{Numbers, catalogue, evaluate};
use pyo3::prelude::*;

use crate::errors::detached;
use crate::measurement::as_json;

/// The catalogue as JSON: name, equation, summary, inputs and outputs with units.
#[pyfunction]
pub fn routes(py: Python<'_>) -> PyResult<String> {
    detached(py, || as_json(&catalogue()))
}

/// Outputs of one route for given inputs.
#[pyfunction]
pub fn evaluate_route(py: Python<'_>, name: &str, inputs: Numbers) -> PyResult<Numbers> {
    detached(py, || evaluate(name, &inputs))
}
