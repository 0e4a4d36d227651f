//! Lines that stretch.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::{Cord, Spring, Suspended};

numbers! {
    /// Tension = (EA/l) (Δl + t_d dΔl/dt), never below zero; l is the length without load (Hooke;
    /// the damping is Kelvin's and Voigt's). Under the weight each line is longer by its share of m
    /// g l/EA, and swings stretch it.
    pub struct LineStretch {
        /// EA of a line: force for each unit of strain.
        force_per_strain_n: "N",
        /// Delay of the stretch behind the force, t_d.
        delay_s: "s",
    }
}

impl<S> Described for LineStretch<S> {
    const ID: &'static str = "line_stretch";
    const POSITIVE: &'static [&'static str] = &["force_per_strain_n"];
}

impl<S: Real> Effect<S> for LineStretch<S> {
    fn set_up(&self, system: &mut Suspended<S>) {
        let length_m = system.mean_length_m();
        let stiffness_n_m = self.force_per_strain_n / length_m;
        let damping_n_s_m = stiffness_n_m * self.delay_s;
        system.spring = Some(Spring {
            stiffness_n_m,
            damping_n_s_m,
        });
    }

    /// The fastest of heave and of the turn about each axis that the lines' ends resist.
    fn fastest_rad_s(&self, system: &Suspended<S>) -> f64 {
        let stiffness = self.force_per_strain_n.value() / system.mean_length_m().value();
        let about = |i: usize| {
            let square =
                |c: &Cord<S>| c.point_m.dot(&c.point_m).value() - c.point_m[i].value().powi(2);
            let arms: f64 = system.cords.iter().map(square).sum();
            arms / system.inertia_kg_m2[(i, i)].value()
        };
        let heave = system.cords.len() as f64 / system.mass_kg.value();
        (stiffness * (heave + about(0).max(about(1)))).sqrt()
    }
}
