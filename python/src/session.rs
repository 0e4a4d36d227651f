//! Sessions and bare recordings as Python holds them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gyradius_core::critique::{Progress, criticise};
use gyradius_core::inertia::{Analysis, MeasureOptions, analyse, measure_recording};
use gyradius_core::plan::{Request, plan_on, plan_to_tell_apart};
use gyradius_core::recording::import::{ImportedData, import_files};
use gyradius_core::recording::{LoadedSession, Recording, SESSION_FILE, Store, load_session, load_store};
use gyradius_core::{Error, Result};
use pyo3::prelude::*;

use crate::critique::{Criticism, watched};
use crate::errors::{detached, raise};
use crate::import::{import_options, read_input};
use crate::measurement::Measurement;
use crate::plan::Plan;

/// What was loaded.
pub enum Loaded {
    /// A session with everything that it names.
    Session(Arc<LoadedSession>),
    /// One recording, which gives modes alone.
    Bare(Box<Recording>),
}

/// A session or a bare recording.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Session {
    loaded: Loaded,
}

#[pymethods]
impl Session {
    /// The session's title, or the recording's name.
    #[getter]
    fn title(&self) -> &str {
        match &self.loaded {
            Loaded::Session(loaded) => &loaded.session.title,
            Loaded::Bare(recording) => &recording.name,
        }
    }

    /// Ids of the swings, in session order.
    #[getter]
    fn swing_ids(&self) -> Vec<&str> {
        match &self.loaded {
            Loaded::Session(loaded) => loaded.session.swings.iter().map(|swing| swing.id.as_str()).collect(),
            Loaded::Bare(recording) => vec![&recording.name],
        }
    }

    /// Measure, with a verdict for each limit.
    fn measure(&self, py: Python<'_>, limits: Vec<String>) -> PyResult<Measurement> {
        let inner = detached(py, || self.loaded.analyse(&limits))?;
        Ok(Measurement::new(inner, self.loaded.session()))
    }

    /// Criticise the simulation; the callback is told a share and a text, and stops it by answering false.
    #[pyo3(signature = (progress=None))]
    fn critique(&self, py: Python<'_>, progress: Option<Py<PyAny>>) -> PyResult<Criticism> {
        let loaded = self.loaded.with_dimensions().map_err(|error| raise(py, &error))?;
        watched(py, progress, |progress| criticise(loaded, progress)).map(|inner| Criticism { inner })
    }

    /// The plan from what was measured so far; the request is JSON.
    fn plan(&self, py: Python<'_>, request: &str) -> PyResult<Plan> {
        detached(py, || plan_on(self.loaded.with_dimensions()?, &Request::from_json(request)?)).map(Plan::new)
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
        let loaded = self.loaded.with_dimensions().map_err(|error| raise(py, &error))?;
        let request = Request::from_json(request).map_err(|error| raise(py, &error))?;
        let work = |progress: &Progress| plan_to_tell_apart(loaded, [one, other], &request, progress);
        watched(py, progress, work).map(Plan::new)
    }
}

impl Loaded {
    fn session(&self) -> Option<Arc<LoadedSession>> {
        match self {
            Loaded::Session(loaded) => Some(Arc::clone(loaded)),
            Loaded::Bare(_) => None,
        }
    }

    /// What can be simulated.
    fn with_dimensions(&self) -> Result<&LoadedSession> {
        match self {
            Loaded::Session(loaded) => Ok(loaded),
            Loaded::Bare(recording) => {
                let reason = "a bare recording tells no dimensions to simulate it by";
                Err(Error::no_result(&recording.name, reason))
            }
        }
    }

    fn analyse(&self, limits: &[String]) -> Result<Analysis> {
        let limits = limits.iter().map(|limit| limit.parse()).collect::<Result<_>>()?;
        let options = MeasureOptions { limits };
        match self {
            Loaded::Session(loaded) => analyse(loaded, &options),
            Loaded::Bare(recording) => measure_recording(recording, &options),
        }
    }
}

/// Read a session folder, a session zip or a bare recording; a mapping names the columns of a foreign CSV.
#[pyfunction]
pub fn load(py: Python<'_>, path: PathBuf, mapping: Vec<String>) -> PyResult<Session> {
    detached(py, || load_any(&path, &mapping)).map(|loaded| Session { loaded })
}

fn load_any(path: &Path, mapping: &[String]) -> Result<Loaded> {
    let session = |loaded| Loaded::Session(Arc::new(loaded));
    match path.extension().and_then(|ending| ending.to_str()) {
        _ if path.is_dir() => load_session(path).map(session),
        Some("toml") => load_session(path).map(session),
        // A zip is a session, or what a phone's logger exported.
        Some("zip") => {
            let store = Store::open(path)?;
            if store.contains(SESSION_FILE) { load_store(&store).map(session) } else { bare(path, mapping) }
        }
        _ => bare(path, mapping),
    }
}

fn bare(path: &Path, mapping: &[String]) -> Result<Loaded> {
    let imported = import_files(&[read_input(path)?], &import_options(mapping, None)?)?;
    let mut data = imported.recordings.into_iter().map(|recording| recording.data);
    match (data.next(), data.next()) {
        (Some(ImportedData::Recording(recording)), None) => Ok(Loaded::Bare(Box::new(recording))),
        (Some(ImportedData::Track(_) | ImportedData::GateEvents(_)), None) => {
            Err(no_phone(path, "a track or a list of events, which becomes a session with `gyradius import`"))
        }
        _ => Err(no_phone(path, "several recordings, which become a session with `gyradius import`")),
    }
}

fn no_phone(path: &Path, found: &str) -> Error {
    let (file, expected) = (path.display().to_string(), "a session or one phone's recording".into());
    Error::Malformed { file, line: None, expected, found: found.into() }
}
