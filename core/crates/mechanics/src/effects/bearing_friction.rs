//! Dry friction.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// M = −M_c tanh(ω/ω_t) about each hull axis: Coulomb's law, whose jump is spread over the
    /// transition rate ω_t; and F = −F_c tanh(v/v_t) along x and y, v_t the same figure in m/s.
    ///
    /// A pure turn loses 4 M_c/K of its amplitude in each period (K its stiffness): a straight
    /// line, not an exponential (Squire, Am. J. Phys. 54 (1986) 984). Below ω_t the law is a linear
    /// drag: the body creeps to rest and does not stick. For sticking see `presliding_bearing`.
    pub struct BearingFriction {
        /// Along x.
        surge_n: "N",
        /// Along y.
        sway_n: "N",
        /// About x.
        roll_n_m: "N m",
        /// About y.
        pitch_n_m: "N m",
        /// About z.
        yaw_n_m: "N m",
        /// Rate over which the friction turns its sign; small against the rate of the swing.
        transition_rad_s: "rad/s",
    }
}

impl<S> Described for BearingFriction<S> {
    const ID: &'static str = "bearing_friction";
    const POSITIVE: &'static [&'static str] = &["transition_rad_s"];
    const KINKED: bool = true;
}

impl<S: Real> Effect<S> for BearingFriction<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let torque = V3::new(self.roll_n_m, self.pitch_n_m, self.yaw_n_m);
        let sign = |rate: S| (rate / self.transition_rad_s).tanh();
        loads.torque -= torque.component_mul(&now.rate.map(sign));
        if !(self.surge_n.is_zero() && self.sway_n.is_zero()) {
            let force = V3::new(self.surge_n, self.sway_n, S::zero());
            loads.force -= now.turn * force.component_mul(&now.velocity_hull().map(sign));
        }
    }

    /// The rate at which a slow turn dies: a step longer than that would not hold it.
    fn fastest_rad_s(&self, system: &Suspended<S>) -> f64 {
        let torques = [self.roll_n_m, self.pitch_n_m, self.yaw_n_m];
        let rate = |i: usize| {
            torques[i].value()
                / (system.inertia_kg_m2[(i, i)].value() * self.transition_rad_s.value())
        };
        let force = self.surge_n.value().max(self.sway_n.value());
        let slide = force / (system.mass_kg.value() * self.transition_rad_s.value());
        (0..3).map(rate).fold(slide, f64::max)
    }
}
