//! A line that gives way at its knot.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Cord;

numbers! {
    /// Lines that are longer from a moment on, by a smooth rise s(x) = x³ (10 − 15 x + 6 x²), x =
    /// (t − t₀)/τ, whose speed and acceleration are zero at both ends. The hull then hangs lower
    /// and aslant, and swings about another rest.
    pub struct LineSlip {
        /// When it begins, t₀.
        at_s: "s",
        /// How long it lasts, τ; 0: there is none.
        over_s: "s",
        /// How much longer the line on the positive side of the axis becomes (of two Vs: its legs).
        positive_m: "m",
        /// The same on the negative side.
        negative_m: "m",
    }
}

impl<S> Described for LineSlip<S> {
    const ID: &'static str = "line_slip";
    const KINKED: bool = true;
}

impl<S: Real> Effect<S> for LineSlip<S> {
    fn lengthen(&self, t_s: S, _cord: &Cord<S>, side: f64, law: &mut [S; 3]) {
        if self.over_s.value() <= 0.0 {
            return;
        }
        let more = if side > 0.0 {
            self.positive_m
        } else {
            self.negative_m
        };
        let x = (t_s - self.at_s) / self.over_s;
        if x.value() >= 1.0 {
            law[0] += more;
        } else if x.value() > 0.0 {
            let poly = |c: [f64; 3]| (x.scale(c[2]) + S::constant(c[1])) * x + S::constant(c[0]);
            law[0] += more * x * x * x * poly([10.0, -15.0, 6.0]);
            law[1] += more * x * x * poly([30.0, -60.0, 30.0]) / self.over_s;
            law[2] += more * x * poly([60.0, -180.0, 120.0]) / (self.over_s * self.over_s);
        }
    }

    fn event_s(&self) -> Option<[f64; 2]> {
        Some([self.at_s.value(), self.over_s.value()])
    }
}
