//! Lines that resist a twist.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::Real;
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// V = ½ κ (ψ − ψ₀)², ψ the turn about the vertical (`Now::twist`): both ends of the lines are
    /// held. The yaw's stiffness m g d²/l grows by κ.
    pub struct LineTorsion {
        /// Of all lines together, κ = Σ G J/l.
        stiffness_n_m_rad: "N m/rad",
        /// Heading at which the lines have no twist, ψ₀.
        neutral_rad: "rad",
    }
}

impl<S> Described for LineTorsion<S> {
    const ID: &'static str = "line_torsion";
}

impl<S: Real> Effect<S> for LineTorsion<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let (twist, gradient) = now.twist();
        loads.torque -= gradient * (self.stiffness_n_m_rad * (twist - self.neutral_rad));
    }
}
