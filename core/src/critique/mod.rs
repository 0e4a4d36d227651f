//! What the simulation gets wrong, why, and what fixing it gains.
//!
//! May know `recording`, `signal`, `modes`, `dynamics`, `inertia`.

mod by_periods;
mod result;

pub use by_periods::criticise_periods;
pub use result::{
    CauseResult, CauseVerdict, Criticism, Critique, Discrepancy, Gain, LearnedForce, ModelResult, NextSwing,
    ParameterResult, Progress, SwingTrace,
};

use crate::error::{Error, Result};
use crate::recording::LoadedSession;

/// Name and version of the result's format.
pub const FORMAT: &str = "gyradius-critique/1";

/// Criticises a session.
pub fn criticise(loaded: &LoadedSession, _progress: &Progress) -> Result<Criticism> {
    Err(Error::no_result(&loaded.source, "under construction"))
}
