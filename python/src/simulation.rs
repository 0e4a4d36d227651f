//! Simulated swings as arrays.

use std::path::PathBuf;

use gyradius_core::mechanics::Moment;
use gyradius_core::recording::Overwrite;
use gyradius_core::simulator::{self, RigFile, Simulated, Variation};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::errors::detached;

/// What a rig file says.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Rig {
    inner: RigFile,
}

/// Read a rig file, or its text where it is given.
#[pyfunction]
#[pyo3(signature = (path, text=None))]
pub fn read_rig(py: Python<'_>, path: PathBuf, text: Option<String>) -> PyResult<Rig> {
    let read = || match text {
        Some(text) => simulator::read_rig(&text, &path.display().to_string()),
        None => simulator::read_rig_file(&path),
    };
    detached(py, read).map(|inner| Rig { inner })
}

impl Rig {
    /// The file's content.
    pub fn file(&self) -> &RigFile {
        &self.inner
    }
}

#[pymethods]
impl Rig {
    /// Ids of the swings, in the order of the file.
    #[getter]
    fn swing_ids(&self) -> Vec<&str> {
        self.inner
            .swings
            .iter()
            .map(|swing| swing.id.as_str())
            .collect()
    }

    /// Name, value and unit of every number of a swing.
    fn numbers(&self, swing: &str, py: Python<'_>) -> PyResult<Vec<(String, f64, &'static str)>> {
        let found = detached(py, || self.inner.swing(swing))?;
        let named = found
            .experiment
            .names()
            .into_iter()
            .zip(found.experiment.values());
        Ok(named
            .map(|((name, unit), value)| (name, value, unit))
            .collect())
    }

    /// Simulate all swings and write the session, and beside it what is true.
    fn write(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        truth_file: PathBuf,
        seed: u64,
        replace: bool,
    ) -> PyResult<()> {
        let overwrite = if replace {
            Overwrite::Replace
        } else {
            Overwrite::Refuse
        };
        detached(py, || {
            simulator::save_practised(
                &simulator::practise(&self.inner, seed)?,
                folder,
                truth_file,
                overwrite,
            )
        })
    }

    /// Simulate a swing with other values of some numbers, at these times or as its phone samples;
    /// without a seed there is no chance in it.
    fn simulate(
        &self,
        py: Python<'_>,
        swing: &str,
        values: Vec<(String, f64)>,
        derivatives: Vec<String>,
        t_s: Option<PyReadonlyArray1<'_, f64>>,
        seed: Option<u64>,
    ) -> PyResult<Simulation> {
        let t_s = t_s.map(|t| t.as_slice().map(<[f64]>::to_vec)).transpose()?;
        let parameters = derivatives.len();
        let varied = Variation {
            values,
            derivatives,
            t_s,
            seed,
        };
        let inner = detached(py, || self.inner.swing(swing)?.simulated(&varied))?;
        Ok(Simulation { inner, parameters })
    }
}

/// A simulated swing.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Simulation {
    inner: Simulated,
    parameters: usize,
}

impl Simulation {
    fn flat_readings(&self) -> Vec<f64> {
        self.inner
            .record
            .readings
            .iter()
            .flat_map(|reading| reading.six())
            .collect()
    }

    fn rows<'py, const N: usize>(
        &self,
        py: Python<'py>,
        row: impl Fn(&Moment<f64>) -> [f64; N],
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flat: Vec<f64> = self.inner.record.moments.iter().flat_map(row).collect();
        flat.to_pyarray(py)
            .reshape([self.inner.record.moments.len(), N])
    }
}

#[pymethods]
impl Simulation {
    /// Time stamps, s.
    #[getter]
    fn t_s<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.inner.record.t_s.to_pyarray(py)
    }

    /// Angular rate (rad/s) x, y, z and specific force (m/s²) x, y, z, phone axes: one row per
    /// stamp.
    #[getter]
    fn readings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.flat_readings()
            .to_pyarray(py)
            .reshape([self.inner.record.t_s.len(), 6])
    }

    /// Derivatives of the readings: stamp, reading, number.
    #[getter]
    fn derivatives<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        self.inner.derivatives.to_pyarray(py).reshape([
            self.inner.record.t_s.len(),
            6,
            self.parameters,
        ])
    }

    /// Centre of mass, world axes, m.
    #[getter]
    fn position_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.position.into())
    }

    /// Quaternion w, x, y, z, `world_from_hull`.
    #[getter]
    fn attitude<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.attitude)
    }

    /// Velocity of the centre of mass, world axes, m/s.
    #[getter]
    fn velocity_m_s<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.velocity.into())
    }

    /// Angular rate, hull axes, rad/s.
    #[getter]
    fn rate_rad_s<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.rate.into())
    }

    /// Acceleration of the centre of mass, world axes, m/s².
    #[getter]
    fn acceleration_m_s2<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.acceleration.into())
    }

    /// Angular acceleration, hull axes, rad/s².
    #[getter]
    fn angular_acceleration_rad_s2<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.rows(py, |moment| moment.angular_acceleration.into())
    }

    /// When a line first went slack, s, and which.
    #[getter]
    fn slack(&self) -> Option<(f64, usize)> {
        self.inner
            .record
            .path
            .slack
            .map(|slack| (slack.t_s, slack.line))
    }
}
