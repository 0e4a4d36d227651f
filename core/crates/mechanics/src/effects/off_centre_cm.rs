//! A centre of mass that is not below the mid-point of the lines.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Suspended;

numbers! {
    /// Moves the centre of mass, inertia about it unchanged. Along the axis the lines carry unequal
    /// shares and yaw mixes with sway; across it, the hull tilts about its suspension.
    pub struct OffCentreCm {
        /// Along x, beyond the stated place.
        forward_m: "m",
        /// Along y, beyond the stated place.
        to_port_m: "m",
    }
}

impl<S> Described for OffCentreCm<S> {
    const ID: &'static str = "off_centre_cm";
}

impl<S: Real> Effect<S> for OffCentreCm<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        system.cm_m.x += self.forward_m;
        system.cm_m.y += self.to_port_m;
    }
}
