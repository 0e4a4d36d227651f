//! Somebody or something knocks at the hull.

use std::f64::consts::{FRAC_PI_2, PI};

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// A push in the shape of half a sine, F(t) = (π J/2τ) sin(π (t − t₀)/τ) for 0 < t − t₀ < τ,
    /// whose impulse is J; in hull axes, at and about the centre of mass.
    pub struct Knock {
        /// When it begins, t₀.
        at_s: "s",
        /// How long it lasts, τ; 0: there is none.
        over_s: "s",
        /// Impulse along x.
        impulse_x_n_s: "N s",
        /// Along y.
        impulse_y_n_s: "N s",
        /// Impulse of the torque about x.
        turn_x_n_m_s: "N m s",
        /// About y.
        turn_y_n_m_s: "N m s",
        /// About z.
        turn_z_n_m_s: "N m s",
    }
}

impl<S> Described for Knock<S> {
    const ID: &'static str = "knock";
    const KINKED: bool = true;
}

impl<S: Real> Effect<S> for Knock<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        if self.over_s.value() <= 0.0 {
            return;
        }
        let part = (now.t_s - self.at_s) / self.over_s;
        if part.value() <= 0.0 || part.value() >= 1.0 {
            return;
        }
        let size = part.scale(PI).sin().scale(FRAC_PI_2) / self.over_s;
        let force = V3::new(self.impulse_x_n_s, self.impulse_y_n_s, S::zero()) * size;
        loads.force += now.turn * force;
        loads.torque += V3::new(self.turn_x_n_m_s, self.turn_y_n_m_s, self.turn_z_n_m_s) * size;
    }

    fn event_s(&self) -> Option<[f64; 2]> {
        Some([self.at_s.value(), self.over_s.value()])
    }
}
