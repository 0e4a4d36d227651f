//! What the operator should do: which lines, which swings, how far and how long.

mod step;

pub use step::{PlannedIncline, PlannedSwing, Step};
