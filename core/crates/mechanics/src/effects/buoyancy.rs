//! Air that carries a part of the weight.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// F = M′ g upwards at the centre of the displaced air (Archimedes): gravity becomes (1 − M′/m)
    /// g (paper, "Air damping and added aerodynamic mass") where that centre is the centre of mass.
    pub struct Buoyancy {
        /// Mass of the air that the hull displaces, M′.
        displaced_air_kg: "kg",
        /// Its centre from the centre of mass, hull axes.
        centre_x_m: "m",
        /// The same.
        centre_y_m: "m",
        /// The same.
        centre_z_m: "m",
    }
}

impl<S> Described for Buoyancy<S> {
    const ID: &'static str = "buoyancy";
}

impl<S: Real> Effect<S> for Buoyancy<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], system: &Suspended<S>, loads: &mut Loads<S>) {
        let lift = self.displaced_air_kg * system.gravity_m_s2;
        let arm = V3::new(self.centre_x_m, self.centre_y_m, self.centre_z_m);
        loads.force.z += lift;
        loads.torque -= arm.cross(&(now.down() * lift));
    }
}
