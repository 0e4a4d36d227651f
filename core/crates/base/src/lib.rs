//! What every crate of the core shares: constants, errors, frames, messages, progress.
//!
//! # Conventions
//! SI units inside, named in the identifiers (`period_s`). **Hull axes**: x forward, y to port, z
//! up, right-handed; yaw turns about z, pitch about y, roll about x. Positive pitch *angles in the
//! session file* (`hull_pitch_deg`) and ψ are bow up. A standard uncertainty is `u` (or `_se_` for
//! a fitted figure), one sigma.

mod catalogue;
pub mod constants;
pub mod error;
pub mod frames;
pub mod language;
pub mod message;
pub mod named;
pub mod parallel;
pub mod progress;

pub use error::{Error, Result};
