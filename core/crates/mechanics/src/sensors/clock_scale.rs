//! A clock that runs fast or slow.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::real::Real;

numbers! {
    /// The phone's clock shows (1 + e) t at the true time t.
    pub struct ClockScale {
        /// e.
        error: "1",
    }
}

impl<S> SensorDescribed for ClockScale<S> {
    const ID: &'static str = "clock_scale";
}

impl<S: Real> SensorEffect<S> for ClockScale<S> {
    fn bend(&self, t_s: &mut S, _draws: &[f64]) {
        *t_s /= S::one() + self.error;
    }
}
