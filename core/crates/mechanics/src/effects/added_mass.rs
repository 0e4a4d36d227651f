//! Air that moves with the hull.

use super::effect::{AddedMass, Described, Effect};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// Kirchhoff's equations in hull axes: p = A v, L = B ω; F = −(ṗ + ω × p), M = −(L̇ + ω × L + v
    /// × p).
    ///
    /// A and B are diagonal, about the centre of mass. They conserve ½ v·A v + ½ ω·B ω with the
    /// rest of the energy (H. Lamb, *Hydrodynamics*, 6th ed., art. 124). A pure turn becomes slower
    /// by √(1 + B/I).
    pub struct EntrainedAir {
        /// Along x.
        surge_kg: "kg",
        /// Along y.
        sway_kg: "kg",
        /// Along z.
        heave_kg: "kg",
        /// About x.
        roll_kg_m2: "kg m^2",
        /// About y.
        pitch_kg_m2: "kg m^2",
        /// About z.
        yaw_kg_m2: "kg m^2",
    }
}

impl<S> Described for EntrainedAir<S> {
    const ID: &'static str = "added_mass";
}

impl<S: Real> Effect<S> for EntrainedAir<S> {
    fn adds_mass(&self) -> bool {
        true
    }

    fn add_mass(
        &self,
        now: &Now<S>,
        _memory: &[S],
        _system: &Suspended<S>,
        mass: &mut AddedMass<S>,
    ) {
        let a = V3::new(self.surge_kg, self.sway_kg, self.heave_kg);
        let b = V3::new(self.roll_kg_m2, self.pitch_kg_m2, self.yaw_kg_m2);
        mass.add_diagonal(&a, &b);
        let (v, rate) = (now.velocity_hull(), now.rate);
        let (p, l) = (a.component_mul(&v), b.component_mul(&rate));
        // v̇ in hull axes is the acceleration less ω × v.
        mass.force += a.component_mul(&rate.cross(&v)) - rate.cross(&p);
        mass.torque -= rate.cross(&l) + v.cross(&p);
    }
}
