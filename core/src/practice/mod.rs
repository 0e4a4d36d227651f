//! Practice: a rig file, which says what is stated and what is true, becomes a session that was never swung.
//!
//! The rig format is described in this folder's `README.md`. Knows `recording` (the form of a session) and `dynamics`
//! (the motion); nothing of what is made of a session.

mod draws;
mod hull;
mod job;
mod rig;
mod truth;

pub use job::{Practised, practise, save_practised};
pub use rig::{RIG_FORMAT, RigFile, RiggedSwing, Sampling, read_rig, read_rig_bytes};
pub use truth::Truth;
