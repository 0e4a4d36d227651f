//! The whole procedure against the simulation, as the command `practise` plays it.

use std::collections::BTreeMap;
use std::path::PathBuf;

use gyradius_core::procedure::{Event, Rehearsal, practice_task};
use gyradius_core::{Error, Result};
use pyo3::prelude::*;

use crate::critique::watched;
use crate::errors::{detached, raise};
use crate::measurement::as_json;
use crate::simulation::Rig;

/// A procedure on a simulated hull.
#[pyclass(module = "gyradius._core")]
pub struct Practice {
    inner: Rehearsal,
}

#[pymethods]
impl Practice {
    /// Begins in a folder, or goes on there where `resume` is true.
    #[new]
    fn new(py: Python<'_>, rig: &Rig, folder: PathBuf, seed: u64, resume: bool) -> PyResult<Self> {
        let rig = rig.file().clone();
        let made = || match resume {
            true => Rehearsal::open(folder, rig, seed),
            false => {
                let task = practice_task(&rig);
                Rehearsal::create(folder, rig, task, seed)
            }
        };
        detached(py, made).map(|inner| Self { inner })
    }

    /// Where it stands, as JSON.
    fn state(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || as_json(&self.inner.state()))
    }

    /// Takes an event, as JSON.
    fn handle(&mut self, py: Python<'_>, event: &str) -> PyResult<()> {
        detached(py, || {
            let event: Event = serde_json::from_str(event)
                .map_err(|error| Error::argument("event", "an event as JSON", error))?;
            self.inner.handle(event)
        })
    }

    /// Lets so much time go by, s; returns what did.
    fn advance(&mut self, py: Python<'_>, seconds: f64) -> PyResult<f64> {
        detached(py, || self.inner.advance(seconds))
    }

    /// What an operator who plays by the book does now, as JSON; nothing while there is to be
    /// waited or worked.
    fn by_the_book(&self, py: Python<'_>, at_utc: &str) -> PyResult<Option<String>> {
        let event = || -> Result<Option<String>> {
            self.inner
                .by_the_book(at_utc)?
                .map(|event| as_json(&event))
                .transpose()
        };
        detached(py, event)
    }

    /// Lets something go wrong with a recording of a step, counted from 1.
    fn mishap(&mut self, py: Python<'_>, step: &str, take: usize, what: &str) -> PyResult<()> {
        let mishap = detached(py, || what.parse())?;
        self.inner.mishap(step, take, mishap);
        Ok(())
    }

    /// Does the work that is wanted; the callback is told a share and a text, and stops it by
    /// answering false.
    #[pyo3(signature = (progress=None))]
    fn work(&mut self, py: Python<'_>, progress: Option<Py<PyAny>>) -> PyResult<()> {
        let Some(job) = self.inner.procedure().job() else {
            return Ok(());
        };
        let outcome = watched(py, progress, |progress| job.run(progress))?;
        self.inner
            .procedure()
            .finish(outcome)
            .map_err(|error| raise(py, &error))
    }

    /// What is true of the hull, by name.
    fn truth(&self) -> BTreeMap<String, f64> {
        self.inner.truth()
    }
}
