//! A bearing that gives before it slides.

use super::effect::{Described, Effect, Loads, Solved};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// Dahl's friction: M = −M_c z about each hull axis, ż = (ω − |ω| z)/θ_s, z = 0 at the start;
    /// likewise along x and y with a length over which it gives (0: none).
    ///
    /// Within angles small against θ_s the bearing is a spring of M_c/θ_s, which shortens the
    /// period; beyond, it slides with Coulomb's torque M_c (P. R. Dahl, *A Solid Friction Model*,
    /// Aerospace Corporation TOR-0158(3107-18)-1, 1968).
    pub struct PreslidingBearing {
        /// Force once it slides, along x.
        surge_n: "N",
        /// Along y.
        sway_n: "N",
        /// Torque once it slides, about x.
        roll_n_m: "N m",
        /// About y.
        pitch_n_m: "N m",
        /// About z.
        yaw_n_m: "N m",
        /// Angle over which it gives, θ_s.
        give_rad: "rad",
        /// Length over which it gives.
        give_m: "m",
    }
}

impl<S> Described for PreslidingBearing<S> {
    const ID: &'static str = "presliding_bearing";
    const POSITIVE: &'static [&'static str] = &["give_rad"];
    const KINKED: bool = true;
}

impl<S: Real> PreslidingBearing<S> {
    fn torque(&self) -> V3<S> {
        V3::new(self.roll_n_m, self.pitch_n_m, self.yaw_n_m)
    }
}

impl<S: Real> Effect<S> for PreslidingBearing<S> {
    fn load(&self, now: &Now<S>, memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        loads.torque -= self
            .torque()
            .component_mul(&V3::new(memory[0], memory[1], memory[2]));
        let force = V3::new(self.surge_n * memory[3], self.sway_n * memory[4], S::zero());
        loads.force -= now.turn * force;
    }

    fn memory(&self) -> usize {
        5
    }

    fn memory_slope(
        &self,
        now: &Now<S>,
        memory: &[S],
        _system: &Suspended<S>,
        _solved: &Solved<S>,
        out: &mut [S],
    ) {
        for i in 0..3 {
            let rate = now.rate[i];
            out[i] = (rate - rate.abs() * memory[i]) / self.give_rad;
        }
        if self.give_m.value() > 0.0 {
            let velocity = now.velocity_hull();
            for i in 0..2 {
                out[3 + i] = (velocity[i] - velocity[i].abs() * memory[3 + i]) / self.give_m;
            }
        } else {
            out[3..].fill(S::zero());
        }
    }

    /// The frequency of the body on the bearing's spring alone.
    fn fastest_rad_s(&self, system: &Suspended<S>) -> f64 {
        let stiffness = |i: usize| self.torque()[i].value() / self.give_rad.value();
        let square = |i: usize| stiffness(i) / system.inertia_kg_m2[(i, i)].value();
        let along = if self.give_m.value() > 0.0 {
            self.surge_n.value().max(self.sway_n.value())
                / (self.give_m.value() * system.mass_kg.value())
        } else {
            0.0
        };
        (0..3).map(square).fold(along, f64::max).sqrt()
    }
}
