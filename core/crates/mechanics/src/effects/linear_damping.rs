//! Drag in proportion to velocity.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// F = −c v in hull axes, M = −c ω: T and τ of the paper's decaying swing, τ = 2 I / c for a
    /// pure turn.
    pub struct LinearDamping {
        /// Along x.
        surge_n_s_m: "N s/m",
        /// Along y.
        sway_n_s_m: "N s/m",
        /// Along z.
        heave_n_s_m: "N s/m",
        /// About x.
        roll_n_m_s: "N m s",
        /// About y.
        pitch_n_m_s: "N m s",
        /// About z.
        yaw_n_m_s: "N m s",
    }
}

impl<S> Described for LinearDamping<S> {
    const ID: &'static str = "linear_damping";
}

impl<S: Real> Effect<S> for LinearDamping<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let force = V3::new(self.surge_n_s_m, self.sway_n_s_m, self.heave_n_s_m);
        let torque = V3::new(self.roll_n_m_s, self.pitch_n_m_s, self.yaw_n_m_s);
        loads.force -= now.turn * force.component_mul(&now.velocity_hull());
        loads.torque -= torque.component_mul(&now.rate);
    }
}
