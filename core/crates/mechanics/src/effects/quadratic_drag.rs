//! Drag in proportion to the square of velocity.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// F = −c |v| v along each hull axis, M = −c |ω| ω about each: air at high Reynolds numbers
    /// (paper, "Air damping"). Amplitudes of a pure turn then follow θ(t) = θ0/(1 + 4 c θ0 ω t/(3π
    /// I)): Squire, Am. J. Phys. 54 (1986) 984.
    pub struct QuadraticDrag {
        /// Along x.
        surge_force_coefficient: "N s^2/m^2",
        /// Along y.
        sway_force_coefficient: "N s^2/m^2",
        /// Along z.
        heave_force_coefficient: "N s^2/m^2",
        /// About x.
        roll_torque_coefficient: "N m s^2",
        /// About y.
        pitch_torque_coefficient: "N m s^2",
        /// About z.
        yaw_torque_coefficient: "N m s^2",
    }
}

impl<S> Described for QuadraticDrag<S> {
    const ID: &'static str = "quadratic_drag";
    const KINKED: bool = true;
}

impl<S: Real> Effect<S> for QuadraticDrag<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let force = V3::new(
            self.surge_force_coefficient,
            self.sway_force_coefficient,
            self.heave_force_coefficient,
        );
        let torque = V3::new(
            self.roll_torque_coefficient,
            self.pitch_torque_coefficient,
            self.yaw_torque_coefficient,
        );
        let square = |x: S| x * x.abs();
        loads.force -= now.turn * force.component_mul(&now.velocity_hull().map(square));
        loads.torque -= torque.component_mul(&now.rate.map(square));
    }
}
