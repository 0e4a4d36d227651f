//! The quadratic model of χ² in a box, held back by a diagonal.
//!
//! Minimises `2·gᵀp + pᵀ(H + λD²)p` over `low ≤ x + p ≤ high` by an active set: C. L. Lawson,
//! R. J. Hanson, *Solving Least Squares Problems* (SIAM 1995), ch. 23, with bounds on both sides
//! (P. B. Stark, R. L. Parker, *Computational Statistics* 10 (1995) 129). Every change of the set
//! lowers the model, so that it ends.

use nalgebra::DVector;

use crate::factor::Factor;
use crate::normal::Normal;
use crate::parameter::{Parameter, Side};

/// A model of χ² about a point.
pub(crate) struct Quadratic<'a> {
    pub normal: &'a Normal,
    /// Half of the slope of χ².
    pub gradient: &'a DVector<f64>,
    pub parameters: &'a [Parameter],
    pub x: &'a DVector<f64>,
    /// Squares of the scales of the parameters.
    pub scale2: &'a DVector<f64>,
}

/// Where the model is least.
pub(crate) struct Least {
    pub step: DVector<f64>,
    /// Of the parameters that stand at no bound there.
    pub factor: Factor,
}

impl Quadratic<'_> {
    /// Which parameters stand at a bound and are pressed against it.
    pub fn pressed(&self) -> Vec<bool> {
        let held = |k: usize| {
            let (parameter, slope) = (&self.parameters[k], self.gradient[k]);
            let side = parameter.side(self.x[k]);
            parameter.is_fixed() || side.is_some_and(|side| side.is_pressed(slope))
        };
        (0..self.x.len()).map(held).collect()
    }

    /// The least point of the model; none where it has none to rounding.
    pub fn least(&self, damping: f64) -> Option<Least> {
        let added = (damping > 0.0).then(|| self.scale2 * damping);
        let mut held = self.pressed();
        let mut step = DVector::zeros(self.x.len());
        // Each change takes a parameter in or lets one go: more than a few times their number is
        // rounding going round in a circle, and the model has fallen all the same.
        for _ in 0..3 * held.len() + 1 {
            let factor = Factor::new(self.normal, added.as_ref(), &held)?;
            let slope = self.slope(&step, added.as_ref());
            let change = -factor.solve(&slope);
            let share = self.room(&step, &change);
            if share < 1.0 {
                self.advance(&mut step, &change, share, &mut held);
                continue;
            }
            step += change;
            let Some(freed) = self.wrongly_held(&step, &held, added.as_ref()) else {
                return Some(Least { step, factor });
            };
            held[freed] = false;
        }
        let factor = Factor::new(self.normal, added.as_ref(), &held)?;
        Some(Least { step, factor })
    }

    /// By how much a step lowers χ².
    pub fn promise(&self, step: &DVector<f64>) -> f64 {
        -(2.0 * self.gradient.dot(step) + step.dot(&self.normal.times(step)))
    }

    /// Half of the slope of the model after a step.
    fn slope(&self, step: &DVector<f64>, added: Option<&DVector<f64>>) -> DVector<f64> {
        let mut slope = self.gradient + self.normal.times(step);
        if let Some(added) = added {
            slope += added.component_mul(step);
        }
        slope
    }

    fn limits(&self, k: usize) -> (f64, f64) {
        let (parameter, x) = (&self.parameters[k], self.x[k]);
        (parameter.low - x, parameter.high - x)
    }

    /// The share of a change that the box leaves room for, 1 at most.
    fn room(&self, step: &DVector<f64>, change: &DVector<f64>) -> f64 {
        (0..step.len()).fold(1.0, |share: f64, k| {
            let (low, high) = self.limits(k);
            let to = step[k] + change[k];
            if to < low {
                share.min((low - step[k]) / change[k])
            } else if to > high {
                share.min((high - step[k]) / change[k])
            } else {
                share
            }
        })
    }

    /// Goes a share of a change; what meets a bound stays there.
    fn advance(
        &self,
        step: &mut DVector<f64>,
        change: &DVector<f64>,
        share: f64,
        held: &mut [bool],
    ) {
        for k in (0..step.len()).filter(|k| change[*k] != 0.0) {
            let (low, high) = self.limits(k);
            let wanted = step[k] + change[k];
            let bound = if change[k] < 0.0 { low } else { high };
            let beyond = wanted < low || wanted > high;
            if beyond && (bound - step[k]) / change[k] <= share {
                (step[k], held[k]) = (bound, true);
            } else {
                step[k] = (step[k] + share * change[k]).clamp(low, high);
            }
        }
    }

    /// The held parameter that the model would most rather have back inside: that with the
    /// steepest slope inwards, in units of its scale.
    fn wrongly_held(
        &self,
        step: &DVector<f64>,
        held: &[bool],
        added: Option<&DVector<f64>>,
    ) -> Option<usize> {
        let slope = self.slope(step, added);
        // A slope this small is rounding of the products that it is made of.
        let rounding = f64::EPSILON * held.len() as f64;
        let inward = |k: usize| {
            let side = self.side_after(step, k)?;
            let unit = self.scale2[k].sqrt();
            let least = rounding * (self.gradient[k].abs() + unit * self.reach(step));
            let wrong = !side.is_pressed(slope[k]) && slope[k].abs() > least;
            wrong.then(|| (k, slope[k].abs() / unit))
        };
        (0..held.len())
            .filter(|k| held[*k] && !self.parameters[*k].is_fixed())
            .filter_map(inward)
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(k, _)| k)
    }

    /// Length of a step in units of the scales.
    pub fn reach(&self, step: &DVector<f64>) -> f64 {
        step.component_mul(step).dot(self.scale2).sqrt()
    }

    fn side_after(&self, step: &DVector<f64>, k: usize) -> Option<Side> {
        let (low, high) = self.limits(k);
        if step[k] <= low {
            Some(Side::Low)
        } else if step[k] >= high {
            Some(Side::High)
        } else {
            None
        }
    }
}
