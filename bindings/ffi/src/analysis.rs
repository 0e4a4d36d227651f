//! A measurement with the evidence that pictures are drawn from.

use std::sync::Arc;

use gyradius_core::diagnosis::judged_with;
use gyradius_core::identification::{self, Measurement};
use gyradius_core::import::Loaded;
use gyradius_core::language::Language;
use gyradius_core::report::{self, Figure, RecordingFigureData, ReportSource};

use crate::as_json;
use crate::criticism::Criticism;
use crate::error::Result;
use crate::work::{Listener, announced};

/// The result of a session or a bare recording.
#[derive(Debug, uniffi::Object)]
pub struct Analysis {
    inner: identification::Analysis,
    loaded: Arc<Loaded>,
}

impl Analysis {
    /// An analysis of the core, and what was analysed.
    pub fn new(inner: identification::Analysis, loaded: Arc<Loaded>) -> Arc<Self> {
        Arc::new(Self { inner, loaded })
    }

    fn source(&self, criticism: Option<Arc<Criticism>>, language: Language) -> ReportSource {
        let criticism = criticism.map(|criticism| Ok(criticism.inner().clone()));
        let source = ReportSource::from_analysis(&self.inner, self.loaded.session(), language);
        ReportSource {
            criticism,
            ..source
        }
    }
}

#[uniffi::export]
impl Analysis {
    /// The result.
    pub fn result(&self) -> Measurement {
        self.inner.measurement.clone()
    }

    /// The result with its verdicts on limits as they are after the criticism of the same session, as
    /// the report has them.
    pub fn judged(&self, criticism: Arc<Criticism>) -> Measurement {
        judged_with(&self.inner.measurement, &criticism.result())
    }

    /// The `gyradius-measurement/1` text.
    pub fn json(&self) -> Result<String> {
        as_json(&self.inner.measurement)
    }

    /// What was recorded, with fit, residual and spectrum, thinned for plots; channels and modes by
    /// their names in a language.
    pub fn recordings(&self, language: Language) -> Vec<RecordingFigureData> {
        self.source(None, language).recordings
    }

    /// The report: one self-contained HTML file in a language, with the session's criticism where
    /// one is given.
    /// `measured_on` is the date as the operator writes it, in the place of the session's own; the
    /// report leaves a blank where neither is there.
    pub fn report_html_blocking(
        &self,
        criticism: Option<Arc<Criticism>>,
        measured_on: Option<String>,
        language: Language,
        listener: Listener,
    ) -> Result<String> {
        announced(&listener, "writing the report", || {
            let source = self.source(criticism, language);
            let measured_on = measured_on.or(source.measured_on);
            Ok(report::html(&ReportSource {
                measured_on,
                ..source
            }))
        })
    }

    /// The report's pictures by themselves, in a language.
    pub fn figures(&self, criticism: Option<Arc<Criticism>>, language: Language) -> Vec<Figure> {
        report::figures(&self.source(criticism, language))
    }
}
