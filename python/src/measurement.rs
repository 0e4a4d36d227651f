//! A measurement as Python holds it.

use std::sync::Arc;

use gyradius_core::Error;
use gyradius_core::diagnosis::judged_with;
use gyradius_core::identification::{Analysis, Evidence};
use gyradius_core::import::Loaded;
use gyradius_core::report::{self, ReportSource};
use gyradius_core::signal::{ChannelGroup, model, spectrum};
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::arrays::rows;
use crate::critique::Criticism;
use crate::errors::{detached, raise};

/// Names of the channels, time stamps, samples and fit of one sensor.
type Fit<'py> = (
    Vec<String>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
);

/// Frequencies and amplitudes by channel.
type Spectrum<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// The result of a session, with the evidence that pictures are drawn from.
#[pyclass(frozen, module = "gyradius._core")]
pub struct Measurement {
    inner: Analysis,
    /// What was measured, for the report.
    loaded: Arc<Loaded>,
}

impl Measurement {
    /// A measurement of the core.
    pub fn new(inner: Analysis, loaded: Arc<Loaded>) -> Self {
        Self { inner, loaded }
    }

    fn evidence(&self, py: Python<'_>, swing_id: &str) -> PyResult<&Evidence> {
        let mut found = self.inner.evidence.iter().flatten();
        found
            .find(|evidence| evidence.id == swing_id)
            .ok_or_else(|| {
                raise(
                    py,
                    &Error::argument("swing_id", "a swing that has a recording", swing_id),
                )
            })
    }
}

#[pymethods]
impl Measurement {
    /// The `gyradius-measurement/1` text; with a criticism, its class limits are judged by that too.
    #[pyo3(signature = (critique=None))]
    fn to_json(&self, py: Python<'_>, critique: Option<Bound<'_, Criticism>>) -> PyResult<String> {
        let critique = critique.map(|critique| critique.get().inner.critique.clone());
        let measurement = &self.inner.measurement;
        detached(py, || match &critique {
            Some(critique) => as_json(&judged_with(measurement, critique)),
            None => as_json(measurement),
        })
    }

    /// The report: one self-contained HTML file in the language of a tag, with the session's
    /// criticism or the reason why there is none.
    fn to_html(
        &self,
        py: Python<'_>,
        critique: Option<Bound<'_, Criticism>>,
        no_critique: Option<String>,
        language: &str,
    ) -> PyResult<String> {
        let criticism = critique.map(|critique| critique.get().inner.clone());
        detached(py, || {
            let (loaded, language) = (self.loaded.session(), language.parse()?);
            let mut source = ReportSource::from_analysis(&self.inner, loaded, language);
            source.criticism = criticism.map(Ok).or(no_critique.map(Err));
            Ok(report::html(&source))
        })
    }

    /// Ids of the swings that have a recording with a fit.
    #[getter]
    fn recorded_swings(&self) -> Vec<&str> {
        self.inner
            .evidence
            .iter()
            .flatten()
            .map(|evidence| evidence.id.as_str())
            .collect()
    }

    /// Names of the channels, time stamps, samples and fit, by sensor.
    fn fits<'py>(&self, py: Python<'py>, swing_id: &str) -> PyResult<Vec<Fit<'py>>> {
        let evidence = self.evidence(py, swing_id)?;
        evidence
            .groups
            .iter()
            .enumerate()
            .map(|(place, group)| fit(py, evidence, place, group))
            .collect()
    }

    /// Frequencies, Hz, and amplitude spectra by channel, thinned for plots.
    fn spectrum<'py>(&self, py: Python<'py>, swing_id: &str) -> PyResult<Spectrum<'py>> {
        let evidence = self.evidence(py, swing_id)?;
        let found = py.detach(|| spectrum(&evidence.groups));
        Ok((found.freq_hz.into_pyarray(py), rows(py, &found.amplitude)?))
    }
}

/// A value of the core as its JSON text.
pub fn as_json<T: serde::Serialize>(value: &T) -> gyradius_core::Result<String> {
    serde_json::to_string_pretty(value).map_err(|error| Error::no_result("JSON", error.to_string()))
}

fn fit<'py>(
    py: Python<'py>,
    evidence: &Evidence,
    place: usize,
    group: &ChannelGroup,
) -> PyResult<Fit<'py>> {
    let first: usize = evidence.groups[..place]
        .iter()
        .map(|before| before.channels.len())
        .sum();
    let fitted = py.detach(|| model(&group.t_s, &evidence.found));
    let labels = evidence.channels[first..first + group.channels.len()]
        .iter()
        .map(|name| (*name).to_owned())
        .collect();
    let fitted = &fitted[first..first + group.channels.len()];
    Ok((
        labels,
        group.t_s.clone().into_pyarray(py),
        rows(py, &group.channels)?,
        rows(py, fitted)?,
    ))
}
