//! Plans as Python holds them.

use gyradius_core::planning::{self, Request};
use pyo3::prelude::*;

use crate::errors::detached;
use crate::measurement::as_json;

/// What to do, and what it is expected to give.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Plan {
    inner: planning::Plan,
}

impl Plan {
    /// A plan of the core.
    pub fn new(inner: planning::Plan) -> Self {
        Self { inner }
    }
}

#[pymethods]
impl Plan {
    /// The `gyradius-plan/1` text.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || as_json(&self.inner))
    }

    /// The `session.toml` that its swings will fill.
    fn session_toml(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || Ok(planning::session_toml(&self.inner)))
    }

    /// The rig file that rehearses it.
    fn rig_toml(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || planning::rig_toml(&self.inner))
    }
}

/// The plan for a hull of which rough figures are known; the request is JSON.
#[pyfunction]
pub fn plan_swings(py: Python<'_>, request: &str) -> PyResult<Plan> {
    detached(py, || planning::plan(&Request::from_json(request)?)).map(Plan::new)
}
