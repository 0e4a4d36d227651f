//! Inertia of a rigid body from the recordings of a phone that swings with it on two lines.
//!
//! This crate holds no science of its own: it is what the faces (Python, Kotlin, Swift) see of the
//! member crates, and the schemas of what they write. The crates stand under `core/crates`. Which of them uses which is shown in `ARCHITECTURE.md` and
//! held by their `Cargo.toml`.
//!
//! # Conventions
//! SI units inside, named in the identifiers (`period_s`). **Hull axes**: x forward, y to port, z
//! up, right-handed; yaw turns about z, pitch about y, roll about x. Positive pitch *angles in the
//! session file* (`hull_pitch_deg`) and ψ are bow up. A standard uncertainty is `u` (or `_se_` for
//! a fitted figure), one sigma.

pub mod schemas;

pub use gyradius_base::{Error, Result, constants, error, frames, language, message, progress};
pub use gyradius_diagnosis as diagnosis;
pub use gyradius_identification as identification;
pub use gyradius_import as import;
pub use gyradius_mechanics as mechanics;
pub use gyradius_planning as planning;
pub use gyradius_procedure as procedure;
pub use gyradius_recording as recording;
pub use gyradius_recording::recorder;
pub use gyradius_report as report;
pub use gyradius_signal as signal;
pub use gyradius_signal::online;
pub use gyradius_simulator as simulator;
