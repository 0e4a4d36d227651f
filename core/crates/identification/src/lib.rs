//! From periods and dimensions to inertia: single routes, the joint estimate, its budget and its
//! consistency.
//!
//! May know `recording`, `signal`, `modes`, `dynamics` and what they may know.

mod alternatives;
mod amplitude_correction;
mod beats;
mod breaks;
pub mod by_samples;
mod chance;
mod channels;
mod consistency;
mod correlated;
pub mod estimate;
pub mod expected;
mod findings;
pub mod measure;
mod measurement;
pub mod modes;
mod names;
mod observe;
pub mod one_motion;
pub mod outputs;
pub mod parameters;
pub mod routes;
pub mod samples;
mod sentences;
mod spread;
mod suspects;
mod swing_work;
pub mod theory;
mod traced;
mod value;
pub mod words;

pub use findings::{Finding, FindingKind, NEAR_IN_PHASE, Severity};
pub use measure::solved_periods;
pub use measure::{Analysis, MeasureOptions, analyse, analyse_watched, measure, measure_recording};
pub use measurement::{
    AmplitudePoint, BudgetLine, Claim, Measurement, ModeResult, ModulationResult, MotionResult,
    QuantityResult, Route, SwingResult, TrendResult, Verdict,
};
pub use names::{
    AmplitudeUnit, Decision, Input, InputKind, Method, QuantityName, Relation, RouteMethod, Subject,
};
pub use observe::Evidence;
pub use one_motion::OneMotion;
pub use outputs::COVERAGE_95;
pub use sentences::{GRAVITY, NO_GRAVITY, NO_JOINT_ESTIMATE, input};
pub use value::Value;
pub use words::{quantity_in, route_in, unit_of};
