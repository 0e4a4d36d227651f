//! One line longer than the other.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Suspended;

numbers! {
    /// The line on the positive side of the axis is longer by half of the difference, the other
    /// shorter by half (of two Vs: their legs). The hull hangs aslant, and yaw, sway and roll mix.
    pub struct UnequalLines {
        /// Length on the positive side less that on the negative.
        difference_m: "m",
    }
}

impl<S> Described for UnequalLines<S> {
    const ID: &'static str = "unequal_lines";
}

impl<S: Real> Effect<S> for UnequalLines<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        let axis = system.axis();
        for cord in &mut system.cords {
            cord.length_m += self.difference_m.scale(0.5 * cord.side(&axis));
        }
    }
}
