//! Sessions and bare recordings.

use std::path::Path;
use std::sync::Arc;

use gyradius_core::diagnosis::{CauseId, criticise};
use gyradius_core::identification::{MeasureOptions, analyse_watched, measure_recording};
use gyradius_core::import::{Loaded, load_any};
use gyradius_core::planning::{Request, plan_on, plan_to_tell_apart};
use gyradius_core::recording::write_session;

use crate::analysis::Analysis;
use crate::criticism::Criticism;
use crate::error::Result;
use crate::planning::Plan;
use crate::work::{Listener, announced, watched};

/// One hull, measured in one sitting; or one bare recording, which gives modes alone.
#[derive(Debug, uniffi::Object)]
pub struct Session {
    loaded: Arc<Loaded>,
}

#[uniffi::export]
impl Session {
    /// Reads a session folder, a session's zip, or a bare recording in any format that can be
    /// imported.
    ///
    /// `mapping` names the columns of a CSV that is not recognised: `gx=xGyro:deg/s`.
    #[uniffi::constructor]
    pub fn load(path: &str, mapping: Vec<String>) -> Result<Arc<Self>> {
        let loaded = load_any(Path::new(path), &mapping)?;
        Ok(Arc::new(Self {
            loaded: Arc::new(loaded),
        }))
    }

    /// The session's title, or the recording's name.
    pub fn title(&self) -> String {
        self.loaded.title().into()
    }

    /// Ids of the swings, in session order.
    pub fn swing_ids(&self) -> Vec<String> {
        self.loaded
            .swing_ids()
            .into_iter()
            .map(String::from)
            .collect()
    }

    /// The session as stated, as the text of a `session.toml`; absent for a bare recording.
    pub fn stated_toml(&self) -> Option<String> {
        self.loaded
            .session()
            .map(|loaded| write_session(&loaded.session))
    }

    /// Modes, inertia, uncertainty and consistency: seconds.
    ///
    /// `limits` are class limits such as `k_pitch_m>=1.100`, each of which gets a verdict. A bare
    /// recording's listener is asked before and after, not in between.
    pub fn measure_blocking(
        &self,
        limits: Vec<String>,
        listener: Listener,
    ) -> Result<Arc<Analysis>> {
        let limits = limits
            .iter()
            .map(|limit| limit.parse())
            .collect::<gyradius_core::Result<_>>()?;
        let options = MeasureOptions { limits };
        let inner = match &*self.loaded {
            Loaded::Session(loaded) => watched(&listener, |progress| {
                analyse_watched(loaded, &options, progress)
            }),
            Loaded::Bare(recording) => announced(&listener, "measuring", || {
                measure_recording(recording, &options)
            }),
        }?;
        Ok(Analysis::new(inner, Arc::clone(&self.loaded)))
    }

    /// What the simulation gets wrong, why, and what mending it gains: minutes.
    pub fn critique_blocking(&self, listener: Listener) -> Result<Arc<Criticism>> {
        let loaded = self.loaded.with_dimensions()?;
        watched(&listener, |progress| criticise(loaded, progress)).map(Criticism::new)
    }

    /// The plan from what was measured so far; what the request tells of the hull goes before that.
    pub fn plan_blocking(&self, request: Request, listener: Listener) -> Result<Arc<Plan>> {
        let loaded = self.loaded.with_dimensions()?;
        announced(&listener, "planning", || plan_on(loaded, &request)).map(Plan::new)
    }

    /// The plan of the swing that tells two causes of the criticism apart: minutes.
    pub fn plan_to_tell_apart_blocking(
        &self,
        one: &str,
        other: &str,
        request: Request,
        listener: Listener,
    ) -> Result<Arc<Plan>> {
        let loaded = self.loaded.with_dimensions()?;
        let causes = [one.parse::<CauseId>()?, other.parse()?];
        watched(&listener, |progress| {
            plan_to_tell_apart(loaded, causes, &request, progress)
        })
        .map(Plan::new)
    }
}
