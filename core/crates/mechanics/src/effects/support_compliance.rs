//! A gantry that gives way.

use super::effect::{Described, Effect, Solved, Support};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// m s̈ = −k s − c ṡ + pull of the lines, along the world's x and y: all upper ends move
    /// together by s. The height stays. Slow swings see a support that gives by 1/k: sway becomes
    /// slower by 1 + m_hull g/(2 k l).
    ///
    /// At the start the gantry stands where the lines' pull would hold it at rest.
    pub struct SupportCompliance {
        /// Mass that moves, m.
        mass_kg: "kg",
        /// Along x, k.
        stiffness_x_n_m: "N/m",
        /// Along y.
        stiffness_y_n_m: "N/m",
        /// Along x, c.
        damping_x_n_s_m: "N s/m",
        /// Along y.
        damping_y_n_s_m: "N s/m",
    }
}

/// A gantry moves with the lines' pull: how it rings by itself, faster than any swing, need not be
/// followed so finely as a swing, and this share of its frequency counts. Steps then turn it by 1.6
/// rad in fits and by 2.5 in their derivatives; up to 5.6 the integration lets no ringing grow
/// (|R(iy)| ≤ 1 of its coefficients), and errors are looked at where a motion is followed finely.
const FOLLOWED: f64 = 0.5;

impl<S> Described for SupportCompliance<S> {
    const ID: &'static str = "support_compliance";
    const POSITIVE: &'static [&'static str] = &["mass_kg", "stiffness_x_n_m", "stiffness_y_n_m"];
}

impl<S: Real> SupportCompliance<S> {
    /// Acceleration by spring and damper alone.
    fn free(&self, memory: &[S]) -> V3<S> {
        let x = self.stiffness_x_n_m * memory[0] + self.damping_x_n_s_m * memory[2];
        let y = self.stiffness_y_n_m * memory[1] + self.damping_y_n_s_m * memory[3];
        V3::new(-x / self.mass_kg, -y / self.mass_kg, S::zero())
    }
}

impl<S: Real> Effect<S> for SupportCompliance<S> {
    fn support(&self, _now: &Now<S>, memory: &[S]) -> Option<Support<S>> {
        let (zero, inverse) = (S::zero(), S::one() / self.mass_kg);
        Some(Support {
            offset: V3::new(memory[0], memory[1], zero),
            velocity: V3::new(memory[2], memory[3], zero),
            free_acceleration: self.free(memory),
            inverse_mass: V3::new(inverse, inverse, zero),
        })
    }

    fn memory(&self) -> usize {
        4
    }

    fn memory_start(&self, solved: &Solved<S>, memory: &mut [S]) {
        memory[0] = solved.pull_on_support.x / self.stiffness_x_n_m;
        memory[1] = solved.pull_on_support.y / self.stiffness_y_n_m;
    }

    fn memory_slope(
        &self,
        _now: &Now<S>,
        memory: &[S],
        _system: &Suspended<S>,
        solved: &Solved<S>,
        out: &mut [S],
    ) {
        let acceleration = self.free(memory) + solved.pull_on_support / self.mass_kg;
        out.copy_from_slice(&[memory[2], memory[3], acceleration.x, acceleration.y]);
    }

    fn fastest_rad_s(&self, system: &Suspended<S>) -> f64 {
        let drawn = (system.mass_kg * system.gravity_m_s2 / system.mean_length_m()).value();
        let stiffest = self
            .stiffness_x_n_m
            .value()
            .max(self.stiffness_y_n_m.value());
        FOLLOWED * ((stiffest + drawn) / self.mass_kg.value()).sqrt()
    }
}
