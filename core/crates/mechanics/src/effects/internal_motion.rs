//! Something inside that moves.

use super::effect::{AddedMass, Described, Effect, Solved};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// A mass m that slides through a point of the hull along a given direction u, on a spring and
    /// a damper: m u·(a − g) = −k s − c ṡ, a its acceleration in the world; across u it is carried
    /// along. Water and gear, to first order (J. R. Roberts et al., *Slosh Design Handbook I*, NASA
    /// CR-406, 1966, ch. 3).
    ///
    /// The body's mass, centre of mass and inertia are those with the mass at its point (s = 0),
    /// where the spring has no load.
    pub struct InternalMotion {
        /// Mass, m.
        mass_kg: "kg",
        /// Its point, hull axes, from the mid-point of the suspension points.
        place_x_m: "m",
        /// The same.
        place_y_m: "m",
        /// The same.
        place_z_m: "m",
        /// Direction, hull axes; of any size.
        along_x: "1",
        /// The same.
        along_y: "1",
        /// The same.
        along_z: "1",
        /// Of the spring, k.
        stiffness_n_m: "N/m",
        /// Of the damper, c.
        damping_n_s_m: "N s/m",
        /// s at the start.
        start_m: "m",
        /// Its rate.
        start_m_s: "m/s",
    }
}

impl<S> Described for InternalMotion<S> {
    const ID: &'static str = "internal_motion";
    const POSITIVE: &'static [&'static str] = &["mass_kg"];
}

impl<S: Real> InternalMotion<S> {
    fn direction(&self) -> V3<S> {
        let along = V3::new(self.along_x, self.along_y, self.along_z);
        along / along.dot(&along).sqrt()
    }

    /// From the centre of mass.
    fn place(&self, system: &Suspended<S>) -> V3<S> {
        V3::new(self.place_x_m, self.place_y_m, self.place_z_m) - system.cm_m
    }

    /// Spring and damper on the hull, along the direction.
    fn grip(&self, memory: &[S]) -> S {
        self.stiffness_n_m * memory[0] + self.damping_n_s_m * memory[1]
    }
}

impl<S: Real> Effect<S> for InternalMotion<S> {
    fn adds_mass(&self) -> bool {
        true
    }

    /// The mass leaves its point; where it is, it moves with the hull across u alone.
    fn add_mass(&self, now: &Now<S>, memory: &[S], system: &Suspended<S>, mass: &mut AddedMass<S>) {
        let (u, place) = (self.direction(), self.place(system));
        let weight = now.down() * (self.mass_kg * system.gravity_m_s2);
        mass.add_point(-self.mass_kg, &place, &-weight, now);
        let arm = place + u * memory[0];
        let coriolis = now.rate.cross(&u) * (self.mass_kg * memory[1]);
        let applied = weight - coriolis - coriolis;
        mass.add_point(self.mass_kg, &arm, &applied, now);
        let spin = now.rate.cross(&now.rate.cross(&arm)) * self.mass_kg;
        let along = u.dot(&(applied - spin));
        mass.free_along(self.mass_kg, &u, &arm.cross(&u), self.grip(memory) - along);
    }

    fn memory(&self) -> usize {
        2
    }

    fn memory_given(&self, memory: &mut [S]) {
        memory.copy_from_slice(&[self.start_m, self.start_m_s]);
    }

    fn memory_slope(
        &self,
        now: &Now<S>,
        memory: &[S],
        system: &Suspended<S>,
        solved: &Solved<S>,
        out: &mut [S],
    ) {
        let u = self.direction();
        let arm = self.place(system) + u * memory[0];
        let hull = now.turn.tr_mul(&solved.acceleration)
            + solved.angular_acceleration.cross(&arm)
            + now.rate.cross(&now.rate.cross(&arm));
        out[0] = memory[1];
        let fall = now.down() * system.gravity_m_s2;
        out[1] = u.dot(&(fall - hull)) - self.grip(memory) / self.mass_kg;
    }

    /// Faster on a light hull, which gives way: bounded by what the rest of the mass leaves.
    fn fastest_rad_s(&self, system: &Suspended<S>) -> f64 {
        let rest = 1.0 - (self.mass_kg / system.mass_kg).value();
        (self.stiffness_n_m / self.mass_kg).value().max(0.0).sqrt() / rest.max(0.1).sqrt()
    }
}
