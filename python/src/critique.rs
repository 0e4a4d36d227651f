//! A criticism as Python holds it, and long work that Python watches and may stop.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use gyradius_core::Error;
use gyradius_core::diagnosis::{self, Critique, Progress, SwingTrace};
use numpy::{PyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::errors::{CancelledError, detached, raise};
use crate::measurement::as_json;

/// How often signals are looked for while the work says nothing.
const LISTENING: Duration = Duration::from_millis(100);
/// As much as a main thread has.
const STACK_BYTES: usize = 8 << 20;

/// Swing, channel, unit and noise; times, measured, base and extended.
type Trace<'py> = (String, String, String, f64, Vec<Bound<'py, PyArray1<f64>>>);

/// What the simulation gets wrong, with the samples that pictures are drawn from.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Criticism {
    /// As the core made it.
    pub inner: diagnosis::Criticism,
}

#[pymethods]
impl Criticism {
    /// A criticism from the text of `critique --json` and, as JSON too, its traces.
    #[staticmethod]
    fn from_json(py: Python<'_>, critique: &str, traces: &str) -> PyResult<Self> {
        detached(py, || {
            let critique = Critique::from_json(critique)?;
            let traces = serde_json::from_str(traces)
                .map_err(|error| Error::argument("traces", "its JSON", error))?;
            Ok(Self {
                inner: diagnosis::Criticism { critique, traces },
            })
        })
    }

    /// The `gyradius-critique/1` text.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        detached(py, || as_json(&self.inner.critique))
    }

    /// Each swing against both simulations.
    fn traces<'py>(&self, py: Python<'py>) -> Vec<Trace<'py>> {
        self.inner
            .traces
            .iter()
            .map(|swing| trace(py, swing))
            .collect()
    }
}

fn trace<'py>(py: Python<'py>, trace: &SwingTrace) -> Trace<'py> {
    let SwingTrace {
        swing,
        channel,
        unit,
        noise,
        ..
    } = trace;
    let columns = [&trace.t_s, &trace.measured, &trace.base, &trace.extended];
    let arrays = columns.map(|column| column.to_pyarray(py)).into();
    (
        swing.clone(),
        channel.english.clone(),
        unit.to_string(),
        *noise,
        arrays,
    )
}

/// Runs work on a thread of its own while this one tells Python how far it is and heeds signals.
///
/// The callback gets a share and a text; what it raises, or `CancelledError` where it answers
/// false, is raised when the work has stopped.
pub fn watched<T: Send>(
    py: Python<'_>,
    callback: Option<Py<PyAny>>,
    work: impl FnOnce(&Progress) -> gyradius_core::Result<T> + Send,
) -> PyResult<T> {
    tell(py, callback.as_ref(), Some((0.0, "starting".into())))?;
    let stop = AtomicBool::new(false);
    let (done, stopped) = py.detach(|| {
        let (sender, receiver) = channel();
        thread::scope(|scope| {
            let stop = &stop;
            let run = move || {
                work(&|share, text| {
                    // Nobody listens only after the end.
                    let _ = sender.send((share, text.to_string()));
                    !stop.load(Ordering::Relaxed)
                })
            };
            let worker = thread::Builder::new()
                .stack_size(STACK_BYTES)
                .spawn_scoped(scope, run)?;
            let stopped = listen(&receiver, callback.as_ref(), stop);
            let done = worker
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            Ok::<_, std::io::Error>((done, stopped))
        })
    })?;
    match stopped {
        Some(error) => Err(error),
        None => done.map_err(|error| raise(py, &error)),
    }
}

/// Tells what comes in until the work ends; answers why it was stopped.
fn listen(
    receiver: &Receiver<(f64, String)>,
    callback: Option<&Py<PyAny>>,
    stop: &AtomicBool,
) -> Option<PyErr> {
    let mut stopped = None;
    loop {
        let news = match receiver.recv_timeout(LISTENING) {
            // Of what came in meanwhile the last will do.
            Ok(first) => Some(receiver.try_iter().last().unwrap_or(first)),
            Err(RecvTimeoutError::Timeout) => None,
            Err(RecvTimeoutError::Disconnected) => return stopped,
        };
        if stopped.is_none() {
            stopped = Python::attach(|py| tell(py, callback, news)).err();
            stop.store(stopped.is_some(), Ordering::Relaxed);
        }
    }
}

/// Heeds signals and tells the callback; an error where either wants an end.
fn tell(py: Python<'_>, callback: Option<&Py<PyAny>>, news: Option<(f64, String)>) -> PyResult<()> {
    py.check_signals()?;
    let (Some(callback), Some(news)) = (callback, news) else {
        return Ok(());
    };
    let answer = callback.bind(py).call1(news)?;
    // A callback that answers nothing wants to go on.
    if answer.is_none() || answer.is_truthy()? {
        return Ok(());
    }
    Err(CancelledError::new_err(
        "cancelled by the progress callback",
    ))
}
