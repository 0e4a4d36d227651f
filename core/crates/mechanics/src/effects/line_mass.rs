//! Lines that weigh something.

use super::effect::{AddedMass, Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// A straight line of mass m, its upper end at rest, has the kinetic energy of m/3 and the
    /// weight of m/2 at its lower end: its points move in proportion to their distance from the
    /// top. Exact for straight lines of fixed length; that heavy lines sag is left out.
    pub struct LineMass {
        /// Mass for each metre of line.
        linear_density_kg_m: "kg/m",
    }
}

impl<S> Described for LineMass<S> {
    const ID: &'static str = "line_mass";
}

impl<S: Real> Effect<S> for LineMass<S> {
    fn adds_mass(&self) -> bool {
        true
    }

    fn add_mass(
        &self,
        now: &Now<S>,
        _memory: &[S],
        system: &Suspended<S>,
        mass: &mut AddedMass<S>,
    ) {
        for cord in &system.cords {
            let line = self.linear_density_kg_m * cord.length_m;
            let arm = cord.point_m - system.cm_m;
            let weight = now.down() * (system.gravity_m_s2 * line.scale(0.5));
            mass.add_point(line.scale(1.0 / 3.0), &arm, &weight, now);
        }
    }
}
