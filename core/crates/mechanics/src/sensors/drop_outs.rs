//! Samples that never arrive.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::real::Real;

numbers! {
    /// Each sample is lost with a probability of its own, and all of them during one stall. What is
    /// lost has no derivative.
    pub struct DropOuts {
        /// Probability.
        share: "1",
        /// Start of the stall.
        stall_at_s: "s",
        /// Length of the stall.
        stall_s: "s",
    }
}

impl<S> SensorDescribed for DropOuts<S> {
    const ID: &'static str = "drop_outs";
}

impl<S: Real> SensorEffect<S> for DropOuts<S> {
    fn draws(&self) -> usize {
        1
    }
    fn loses(&self, clock_s: f64, draws: &[f64]) -> bool {
        let into = clock_s - self.stall_at_s.value();
        // Φ(z) is evenly spread where z is normal.
        let chance = 0.5 * libm::erfc(-draws[0] * std::f64::consts::FRAC_1_SQRT_2);
        chance < self.share.value() || (0.0..self.stall_s.value()).contains(&into)
    }
}
