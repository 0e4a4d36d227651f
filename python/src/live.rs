//! The live estimator as Python feeds it.

use gyradius_core::online::{self, LiveOptions};
use gyradius_core::recording::Sensor;
use gyradius_core::{Error, Result};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::errors::detached;
use crate::measurement::as_json;

/// What is known while a hull swings, from the samples so far.
#[pyclass(module = "gyradius._core")]
pub struct Live {
    inner: online::Live,
}

#[pymethods]
impl Live {
    /// An estimator that has seen nothing; full scales in rad/s and m/s², where the phone tells.
    #[new]
    #[pyo3(signature = (wanted, gyroscope_full_scale=None, accelerometer_full_scale=None))]
    fn new(
        py: Python<'_>,
        wanted: f64,
        gyroscope_full_scale: Option<f64>,
        accelerometer_full_scale: Option<f64>,
    ) -> PyResult<Self> {
        let options = LiveOptions {
            wanted,
            gyroscope_full_scale_rad_s: gyroscope_full_scale,
            accelerometer_full_scale_m_s2: accelerometer_full_scale,
        };
        detached(py, || online::Live::new(options)).map(|inner| Self { inner })
    }

    /// Takes samples of `gyroscope` (rad/s) or `accelerometer` (m/s²): stamps in ns, and a row of
    /// x, y, z each.
    fn push(
        &mut self,
        py: Python<'_>,
        sensor: &str,
        stamps_ns: PyReadonlyArray1<'_, i64>,
        values: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<()> {
        let stamps_ns = stamps_ns.as_slice()?.to_vec();
        let shape = [values.as_array().nrows(), values.as_array().ncols()];
        let values = values.as_slice()?.to_vec();
        detached(py, || {
            if shape[1] != 3 {
                let found = format!("{} by {}", shape[0], shape[1]);
                return Err(Error::argument("values", "rows of x, y, z", found));
            }
            let rows: Vec<[f64; 3]> = values
                .chunks_exact(3)
                .map(|row| [row[0], row[1], row[2]])
                .collect();
            self.inner.push(sensor_of(sensor)?, &stamps_ns, &rows)
        })
    }

    /// What is known now, as JSON.
    fn estimate(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || as_json(&self.inner.estimate()))
    }

    /// What to know or do now, in English, most urgent first.
    fn advice(&self) -> Vec<String> {
        self.inner
            .estimate()
            .advice
            .iter()
            .map(|advice| advice.message().english)
            .collect()
    }
}

fn sensor_of(name: &str) -> Result<Sensor> {
    match name {
        "gyroscope" => Ok(Sensor::Gyroscope),
        "accelerometer" => Ok(Sensor::Accelerometer),
        other => Err(Error::argument(
            "sensor",
            "gyroscope or accelerometer",
            other,
        )),
    }
}
