//! What the operator is told while the hull swings: period, amplitude, decay, unwanted motion, what
//! the sensors do.
//!
//! May know `error`, `recording` and `signal`. Samples are gathered into cells of time, bounded in
//! number; every now and then the estimator of the whole record (`signal`) is run on the cells. The
//! live figure is therefore the final one of a shorter record; its uncertainty says how far the
//! final one may still be from it.
//!
//! # Conventions
//! Times are seconds from the first stamp; angles are degrees where the name says so. A standard
//! uncertainty is `u`.

mod advice;
mod cells;
mod disturbance;
mod estimate;
mod estimator;
mod forecast;
mod gaps;
mod phone;
mod sensor;
mod spread;
mod state;
mod swing;

pub use advice::Advice;
pub use estimate::Estimate;
pub use estimator::{Live, LiveOptions};
pub use gaps::{Gap, GapList};
pub use state::{Line, LineKind, SensorState, SwingState, TimeLeft};
