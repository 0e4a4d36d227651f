//! Samples that are not taken, or not stamped, when they should be.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::real::Real;

numbers! {
    /// Both scatter with a normal distribution about an even rate. Late sampling shows in the
    /// stamps; a wrong stamp does not show in the readings.
    pub struct Jitter {
        /// Standard deviation of the times at which samples are taken.
        sampling_s: "s",
        /// Standard deviation of the stamps about those times.
        stamp_s: "s",
    }
}

impl<S> SensorDescribed for Jitter<S> {
    const ID: &'static str = "jitter";
}

impl<S: Real> SensorEffect<S> for Jitter<S> {
    fn draws(&self) -> usize {
        2
    }
    fn stamp_error_s(&self, draws: &[f64]) -> f64 {
        self.sampling_s.value() * draws[0] + self.stamp_s.value() * draws[1]
    }
    fn bend(&self, t_s: &mut S, draws: &[f64]) {
        *t_s += self.sampling_s.scale(draws[0]);
    }
}
