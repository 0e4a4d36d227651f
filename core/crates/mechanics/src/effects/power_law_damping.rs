//! Drag between linear and quadratic.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

/// The rate (rad/s) and the speed (m/s) at which the coefficients hold: those of an ordinary swing.
const REFERENCE: f64 = 0.1;
/// Part of the reference below which the drag is linear: the power has no derivative at zero.
const LINEAR_BELOW: f64 = 1e-4;

numbers! {
    /// M = −c |ω/ω₁|^β ω about each hull axis, F = −c |v/v₁|^β v along each, with ω₁ = 0.1 rad/s,
    /// v₁ = 0.1 m/s.
    ///
    /// The decay time is then ∝ θ0^(−β) (errata to the paper, which prints θ0^(1−β)); β = 0 is
    /// linear damping, β = 1 quadratic drag. The paper found β = 0.3. |x| is √(x² + 10⁻⁸): linear
    /// below a ten-thousandth of ω₁ and v₁.
    pub struct PowerLawDamping {
        /// β.
        exponent: "1",
        /// Along x at 0.1 m/s.
        surge_n_s_m: "N s/m",
        /// Along y at 0.1 m/s.
        sway_n_s_m: "N s/m",
        /// Along z at 0.1 m/s.
        heave_n_s_m: "N s/m",
        /// About x at 0.1 rad/s.
        roll_n_m_s: "N m s",
        /// About y at 0.1 rad/s.
        pitch_n_m_s: "N m s",
        /// About z at 0.1 rad/s.
        yaw_n_m_s: "N m s",
    }
}

impl<S> Described for PowerLawDamping<S> {
    const ID: &'static str = "power_law_damping";
    const KINKED: bool = true;
}

impl<S: Real> PowerLawDamping<S> {
    /// |x/reference|^β x.
    fn powered(&self, x: S) -> S {
        let part = x.scale(1.0 / REFERENCE);
        let square = part * part + S::constant(LINEAR_BELOW * LINEAR_BELOW);
        (square.ln() * self.exponent.scale(0.5)).exp() * x
    }
}

impl<S: Real> Effect<S> for PowerLawDamping<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let force = V3::new(self.surge_n_s_m, self.sway_n_s_m, self.heave_n_s_m);
        let torque = V3::new(self.roll_n_m_s, self.pitch_n_m_s, self.yaw_n_m_s);
        loads.force -=
            now.turn * force.component_mul(&now.velocity_hull().map(|x| self.powered(x)));
        loads.torque -= torque.component_mul(&now.rate.map(|x| self.powered(x)));
    }
}
