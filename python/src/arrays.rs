//! The core on arrays.

use gyradius_core::signal::{self, ChannelGroup, DecomposeOptions};
use numpy::{PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::errors::detached;
use crate::measurement::as_json;

/// The damped oscillations of a record.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Decomposition {
    inner: signal::Decomposition,
}

#[pymethods]
impl Decomposition {
    /// Everything the core gives, as JSON.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || as_json(&self.inner))
    }

    /// The fit at any times: one row per channel.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        t_s: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let t_s = t_s.as_slice()?;
        let fit = py.detach(|| signal::model(t_s, &self.inner));
        rows(py, &fit)
    }
}

/// Find the damped oscillations of channels that share one clock.
#[pyfunction]
pub fn decompose(
    py: Python<'_>,
    t_s: PyReadonlyArray1<'_, f64>,
    channels: Vec<PyReadonlyArray1<'_, f64>>,
) -> PyResult<Decomposition> {
    let group = ChannelGroup {
        t_s: t_s.as_slice()?.to_vec(),
        channels: channels
            .iter()
            .map(|channel| Ok(channel.as_slice()?.to_vec()))
            .collect::<PyResult<_>>()?,
    };
    let inner = detached(py, || {
        signal::decompose(&[group], &DecomposeOptions::default())
    })?;
    Ok(Decomposition { inner })
}

/// Equally long rows as one array.
pub fn rows<'py>(py: Python<'py>, rows: &[Vec<f64>]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    Ok(PyArray2::from_vec2(py, rows)?)
}
