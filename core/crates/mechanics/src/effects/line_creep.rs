//! Lines that grow.

use super::effect::{Described, Effect};
use crate::numbers::numbers;
use crate::real::Real;
use crate::suspended::Cord;

numbers! {
    /// l(t) = l₀ (1 + c log₁₀(1 + t/t₀)): creep in proportion to the logarithm of the time under
    /// load, t₀ of which had passed when the swing began (W. N. Findley et al., *Creep and
    /// Relaxation of Nonlinear Viscoelastic Materials*, 1976, ch. 5). The period follows by half of
    /// the lengthening.
    pub struct LineCreep {
        /// Strain in each decade of time, c.
        strain_per_decade: "1",
        /// How long the lines had carried the hull when the swing began, t₀.
        loaded_before_s: "s",
    }
}

impl<S> Described for LineCreep<S> {
    const ID: &'static str = "line_creep";
    const POSITIVE: &'static [&'static str] = &["loaded_before_s"];
}

impl<S: Real> Effect<S> for LineCreep<S> {
    fn lengthen(&self, t_s: S, cord: &Cord<S>, _side: f64, law: &mut [S; 3]) {
        let growth = cord.length_m * self.strain_per_decade.scale(std::f64::consts::LOG10_E);
        let age_s = self.loaded_before_s + t_s;
        law[0] += growth * (age_s / self.loaded_before_s).ln();
        law[1] += growth / age_s;
        law[2] -= growth / (age_s * age_s);
    }
}
