//! Inertia of a rigid body from the recordings of a phone that swings with it on two lines.
//!
//! The rooms of this crate, and which may know which, are described in `ARCHITECTURE.md` and held
//! by the test `core/tests/rooms.rs`.
//!
//! # Conventions
//! SI units inside, named in the identifiers (`period_s`). **Hull axes**: x forward, y to port, z
//! up, right-handed; yaw turns about z, pitch about y, roll about x. Positive pitch *angles in the
//! session file* (`hull_pitch_deg`) and ψ are bow up. A standard uncertainty is `u` (or `_se_` for
//! a fitted figure), one sigma.

pub mod constants;
pub mod critique;
pub mod dynamics;
pub mod error;
pub mod frames;
pub mod inertia;
pub mod intake;
pub mod language;
pub mod live;
pub mod modes;
mod parallel;
pub mod plan;
pub mod practice;
pub mod procedure;
pub mod progress;
pub mod recorder;
pub mod recording;
pub mod report;
pub mod signal;

pub use error::{Error, Result};
