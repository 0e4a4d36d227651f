//! Practice: a rig file, which says what is stated and what is true, becomes a session that was
//! never swung.
//!
//! The rig format is described in this folder's `README.md`. Knows `recording` (the form of a
//! session) and `dynamics` (the motion); nothing of what is made of a session.

mod draws;
mod feed;
mod hull;
mod job;
mod rehung;
mod rig;
mod sampling;
mod simulated;
mod truth;

pub use feed::{Feed, Heard, Silence};
pub use job::{Practised, practise, save_practised};
pub use rehung::{Mistakes, Release};
pub use rig::{RIG_FORMAT, RigFile, RiggedSwing, read_rig};
pub use sampling::Sampling;
pub use simulated::{Simulated, Variation, read_rig_file};
pub use truth::Truth;
