//! The recorder's file as Python reads it.

use std::path::PathBuf;

use gyradius_core::recorder::{Samples, Whole, read_whole};
use numpy::{PyArray1, PyArray2, ToPyArray};
use pyo3::prelude::*;

use crate::errors::detached;

/// Stamps (ns) and rows of x, y, z of one stream, by its name.
type Track<'py> = (
    &'static str,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray2<f64>>,
);
/// Stream, name and full scale of a sensor.
type Sensor = (&'static str, String, Option<f64>);

/// All of a recorder's file.
#[pyclass(frozen, module = "gyradius._core")]
pub struct RecorderFile {
    inner: Whole,
}

/// Reads a recorder's file past whatever is damaged.
#[pyfunction]
pub fn read_recorder(py: Python<'_>, path: PathBuf) -> PyResult<RecorderFile> {
    detached(py, || read_whole(path)).map(|inner| RecorderFile { inner })
}

#[pymethods]
impl RecorderFile {
    /// Model of the phone.
    #[getter]
    fn phone(&self) -> &str {
        &self.inner.header.phone
    }

    /// Anything else that the recorder noted, by key.
    #[getter]
    fn notes(&self) -> Vec<(String, String)> {
        self.inner.header.notes.clone().into_iter().collect()
    }

    /// Stream, name and full scale of every sensor.
    #[getter]
    fn sensors(&self) -> Vec<Sensor> {
        let sensors = self.inner.header.sensors.iter();
        sensors
            .map(|sensor| (sensor.stream.name(), sensor.name.clone(), sensor.full_scale))
            .collect()
    }

    /// Stamp (ns) and key of every mark, in the order of the file.
    #[getter]
    fn events(&self) -> Vec<(i64, String)> {
        self.inner
            .events
            .iter()
            .map(|event| (event.stamp_ns, event.key.clone()))
            .collect()
    }

    /// What is missing in the file, a sentence each.
    #[getter]
    fn damage(&self) -> Vec<String> {
        self.inner
            .damage
            .iter()
            .map(|damage| damage.text())
            .collect()
    }

    /// Samples of every stream that has any.
    fn tracks<'py>(&self, py: Python<'py>) -> PyResult<Vec<Track<'py>>> {
        let filled = self
            .inner
            .tracks
            .iter()
            .filter(|track| !track.stamps_ns.is_empty());
        let track = |Samples {
                         stream,
                         stamps_ns,
                         values,
                     }: &Samples| {
            let rows = numpy::ndarray::ArrayView2::from(values.as_slice()).to_pyarray(py);
            Ok((stream.name(), stamps_ns.to_pyarray(py), rows))
        };
        filled.map(track).collect()
    }
}
