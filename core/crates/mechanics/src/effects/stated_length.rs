//! Lines that are not as long as stated.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Suspended;

numbers! {
    /// Every line is longer than was stated, by the same length.
    pub struct StatedLength {
        /// True length less the stated one.
        excess_m: "m",
    }
}

impl<S> Described for StatedLength<S> {
    const ID: &'static str = "stated_length";
}

impl<S: Real> Effect<S> for StatedLength<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        system
            .cords
            .iter_mut()
            .for_each(|cord| cord.length_m += self.excess_m);
    }
}
