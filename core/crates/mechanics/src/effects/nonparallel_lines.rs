//! Upper ends that are not as far apart as stated.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Suspended;

numbers! {
    /// Moves the upper ends apart along the axis, each by half. With half spacings b below and t
    /// above the yaw's period is 2π k √(h/(g b t)), h the drop of the lines (eq. (5) for b ≠ t).
    pub struct NonparallelLines {
        /// Distance of the upper ends beyond the stated one.
        excess_m: "m",
    }
}

impl<S> Described for NonparallelLines<S> {
    const ID: &'static str = "nonparallel_lines";
}

impl<S: Real> Effect<S> for NonparallelLines<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        let axis = system.axis();
        for cord in &mut system.cords {
            cord.top_m += axis * self.excess_m.scale(0.5 * cord.side(&axis));
        }
    }
}
