//! A force that is known by what it does alone.

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// F = −Σ c_ij x^i v^j over one coordinate of the hull, x its position and v its rate, both
    /// over a scale; and terms that grow with the time since the start. A force along the
    /// suspension or across it acts at the centre of mass, a torque about the suspension or about
    /// the vertical on the turn.
    pub struct LearnedForce {
        /// 0: along x, 1: along y, 2: about the suspension, 3: about the vertical.
        coordinate: "1",
        /// Scale of the position, m or rad.
        scale_of_position: "m or rad",
        /// Scale of the rate, m/s or rad/s.
        scale_of_rate: "m/s or rad/s",
        /// Of x².
        xx: "N or N m",
        /// Of x v.
        xv: "N or N m",
        /// Of v².
        vv: "N or N m",
        /// Of x³.
        xxx: "N or N m",
        /// Of x² v.
        xxv: "N or N m",
        /// Of x v².
        xvv: "N or N m",
        /// Of v³.
        vvv: "N or N m",
        /// Of x t/100 s.
        xt: "N or N m",
        /// Of v t/100 s.
        vt: "N or N m",
    }
}

impl<S> Described for LearnedForce<S> {
    const ID: &'static str = "learned_force";
    const POSITIVE: &'static [&'static str] = &["scale_of_position", "scale_of_rate"];
}

/// Time over which the terms that grow reach their coefficient, s.
const GROWTH_S: f64 = 100.0;

impl<S: Real> LearnedForce<S> {
    /// The force at a position and a rate.
    fn at(&self, position: S, rate: S, t_s: S) -> S {
        let (x, v) = (position / self.scale_of_position, rate / self.scale_of_rate);
        let t = t_s.scale(1.0 / GROWTH_S);
        let second = x * x * self.xx + x * v * self.xv + v * v * self.vv;
        let third = x * x * (x * self.xxx + v * self.xxv) + v * v * (x * self.xvv + v * self.vvv);
        -(second + third + (x * self.xt + v * self.vt) * t)
    }
}

impl<S: Real> Effect<S> for LearnedForce<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], system: &Suspended<S>, loads: &mut Loads<S>) {
        let (zero, axis) = (S::zero(), system.axis());
        match self.coordinate.value().round() as i64 {
            k @ (0 | 1) => {
                let k = k as usize;
                let place = now.turn.tr_mul(&now.level_position());
                let mut force = V3::new(zero, zero, zero);
                force[k] = self.at(place[k], now.velocity_hull()[k], now.t_s);
                loads.force += now.turn * force;
            }
            2 => {
                // The turn about the suspension takes the vertical out of the hull's z.
                let up = -now.down();
                let across = axis.cross(&V3::new(zero, zero, S::one()));
                let turn = (-up.dot(&across)).atan2(up.z);
                loads.torque += axis * self.at(turn, now.rate.dot(&axis), now.t_s);
            }
            _ => {
                let (heading, gradient) = now.twist();
                loads.torque += gradient * self.at(heading, now.rate.dot(&gradient), now.t_s);
            }
        }
    }
}
