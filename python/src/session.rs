//! Sessions and bare recordings as Python holds them.

use std::path::PathBuf;
use std::sync::Arc;

use gyradius_core::Result;
use gyradius_core::diagnosis::{CauseId, Progress, Search, criticise_by};
use gyradius_core::identification::{Analysis, MeasureOptions, analyse, measure_recording};
use gyradius_core::import::{self, Loaded, load_any};
use gyradius_core::planning::{Request, plan_on, plan_to_tell_apart};
use pyo3::prelude::*;

use crate::critique::{Criticism, watched};
use crate::errors::{detached, raise};
use crate::measurement::Measurement;
use crate::plan::Plan;

/// A session or a bare recording.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Session {
    loaded: Arc<Loaded>,
}

#[pymethods]
impl Session {
    /// The session's title, or the recording's name.
    #[getter]
    fn title(&self) -> &str {
        self.loaded.title()
    }

    /// Ids of the swings, in session order.
    #[getter]
    fn swing_ids(&self) -> Vec<&str> {
        self.loaded.swing_ids()
    }

    /// Measure, with a verdict for each limit.
    fn measure(&self, py: Python<'_>, limits: Vec<String>) -> PyResult<Measurement> {
        let inner = detached(py, || measured(&self.loaded, &limits))?;
        Ok(Measurement::new(inner, Arc::clone(&self.loaded)))
    }

    /// Criticise the simulation; the callback is told a share and a text, and stops it by answering
    /// false. All sets of causes are weighed at once, or causes one after another.
    #[pyo3(signature = (progress=None, by_sets=false))]
    fn critique(
        &self,
        py: Python<'_>,
        progress: Option<Py<PyAny>>,
        by_sets: bool,
    ) -> PyResult<Criticism> {
        let loaded = self
            .loaded
            .with_dimensions()
            .map_err(|error| raise(py, &error))?;
        let search = if by_sets {
            Search::BySets
        } else {
            Search::InRounds
        };
        watched(py, progress, |progress| {
            criticise_by(search, loaded, progress)
        })
        .map(|inner| Criticism { inner })
    }

    /// The plan from what was measured so far; the request is JSON.
    fn plan(&self, py: Python<'_>, request: &str) -> PyResult<Plan> {
        detached(py, || {
            plan_on(
                self.loaded.with_dimensions()?,
                &Request::from_json(request)?,
            )
        })
        .map(Plan::new)
    }

    /// The plan of the swing that tells two causes apart; the callback as of `critique`.
    #[pyo3(signature = (one, other, request, progress=None))]
    fn plan_to_tell_apart(
        &self,
        py: Python<'_>,
        one: &str,
        other: &str,
        request: &str,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Plan> {
        let loaded = self
            .loaded
            .with_dimensions()
            .map_err(|error| raise(py, &error))?;
        let request = Request::from_json(request).map_err(|error| raise(py, &error))?;
        let cause = |id: &str| id.parse::<CauseId>().map_err(|error| raise(py, &error));
        let causes = [cause(one)?, cause(other)?];
        let work = |progress: &Progress| plan_to_tell_apart(loaded, causes, &request, progress);
        watched(py, progress, work).map(Plan::new)
    }
}

fn measured(loaded: &Loaded, limits: &[String]) -> Result<Analysis> {
    let limits = limits
        .iter()
        .map(|limit| limit.parse())
        .collect::<Result<_>>()?;
    let options = MeasureOptions { limits };
    match loaded {
        Loaded::Session(loaded) => analyse(loaded, &options),
        Loaded::Bare(recording) => measure_recording(recording, &options),
    }
}

/// Read a session folder, a session zip or a bare recording; a mapping names the columns of a
/// foreign CSV.
#[pyfunction]
pub fn load(py: Python<'_>, path: PathBuf, mapping: Vec<String>) -> PyResult<Session> {
    detached(py, || load_any(&path, &mapping)).map(|loaded| Session {
        loaded: Arc::new(loaded),
    })
}

/// Read a bare recording from tables, by name and bytes, into which a file was taken apart.
#[pyfunction]
pub fn load_tables(
    py: Python<'_>,
    path: PathBuf,
    tables: Vec<(String, Vec<u8>)>,
    mapping: Vec<String>,
) -> PyResult<Session> {
    detached(py, || import::load_tables(&path, tables, &mapping)).map(|loaded| Session {
        loaded: Arc::new(loaded),
    })
}
