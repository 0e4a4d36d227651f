//! Lines that are not as far apart as stated.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Suspended;

numbers! {
    /// The lines are farther apart than was stated, above and below alike: what was parallel stays
    /// so.
    pub struct StatedSpacing {
        /// True spacing less the stated one.
        excess_m: "m",
    }
}

impl<S> Described for StatedSpacing<S> {
    const ID: &'static str = "stated_spacing";
}

impl<S: Real> Effect<S> for StatedSpacing<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        let axis = system.axis();
        for cord in &mut system.cords {
            let shift = axis * self.excess_m.scale(0.5 * cord.side(&axis));
            cord.top_m += shift;
            cord.point_m += shift;
        }
    }
}
