//! From periods and dimensions to inertia: single routes, the joint estimate, its budget and its
//! consistency.
//!
//! May know `recording`, `signal`, `modes`, `dynamics` and what they may know.

mod alternatives;
mod beats;
pub(crate) mod by_samples;
mod court;
pub(crate) mod estimate;
pub(crate) mod expected;
mod german;
pub(crate) mod measure;
mod measurement;
mod observe;
pub(crate) mod outputs;
pub(crate) mod parameters;
pub mod routes;
pub(crate) mod samples;
mod sentences;
pub(crate) mod theory;
mod traced;
mod twin;
pub(crate) mod words;

pub(crate) use measure::solved_periods;
pub use measure::{Analysis, MeasureOptions, analyse, analyse_watched, measure, measure_recording};
pub use measurement::{
    AmplitudePoint, BudgetLine, Claim, Measurement, ModeResult, QuantityResult, Route, SwingResult,
    Verdict,
};
pub use observe::Evidence;
pub(crate) use outputs::COVERAGE_95;
pub(crate) use sentences::sentence;
pub use sentences::{input, sentences};
pub use words::{quantity_in, route_in, routes as routes_in, unit_of};
