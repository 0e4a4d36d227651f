//! Levenberg and Marquardt for one swing.

use nalgebra::{DMatrix, DVector};

use super::super::fitted_swing::HORIZONS_S;
use super::super::point::Part;
use super::causes::Cause;
use super::swing::{DAMPING, Swing};

const MOST_STEPS: usize = 30;
const MOST_DAMPING: f64 = 1e8;
/// A fit ends where a step promises less of χ² than this, or than this share of it.
const CONVERGED: f64 = 1e-3;
const CONVERGED_SHARE: f64 = 1e-7;

/// A swing fitted.
#[derive(Clone)]
pub struct Fitted {
    pub point: Vec<f64>,
    /// χ² of samples and priors, of the samples alone, and how many rows they have.
    pub cost: f64,
    pub chi2: f64,
    pub rows: usize,
    /// Half of the second derivative of the cost.
    pub matrix: DMatrix<f64>,
}

impl Fitted {
    pub fn covariance(&self) -> Option<DMatrix<f64>> {
        Some(self.matrix.clone().cholesky()?.inverse())
    }

    /// Half of the logarithm of the determinant of the information.
    pub fn half_log_determinant(&self) -> Option<f64> {
        let factor = self.matrix.clone().cholesky()?;
        Some(factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum())
    }
}

/// What is fitted to which part of a swing.
struct Problem<'a> {
    swing: &'a Swing<'a>,
    causes: &'a [&'a Cause],
    part: Part,
    priors: Vec<(f64, f64)>,
    one_sided: Vec<usize>,
}

/// Fits a swing with causes from a start; `None` where no motion can be computed there.
pub fn fit(swing: &Swing, causes: &[&Cause], part: Part, start: &[f64]) -> Option<Fitted> {
    let (priors, one_sided) = (swing.priors(causes), swing.one_sided(causes));
    Problem {
        swing,
        causes,
        part,
        priors,
        one_sided,
    }
    .fit(start)
}

/// The same from what the spectrum says, led over longer and longer parts of the recording: a phase
/// known over one stays within a quarter of a cycle over the next.
pub fn fit_from_afar(swing: &Swing) -> Option<Fitted> {
    let mut point = swing.start.clone();
    for horizon_s in HORIZONS_S.into_iter().filter(|h| *h < swing.duration_s) {
        if let Some(fitted) = fit(swing, &[], Part::First(horizon_s), &point) {
            point = fitted.point;
            // A few swings say little of how they die away, and a rate that is wrong runs away over
            // the next part.
            point[DAMPING] = swing.start_damping_per_s();
        }
    }
    fit(swing, &[], Part::All, &point)
}

impl Problem<'_> {
    fn fit(&self, start: &[f64]) -> Option<Fitted> {
        let mut point = self.bounded(start.to_vec());
        let mut residual = self.swing.residual(&point, self.causes, self.part)?;
        let mut damping = 1e-4;
        let (mut matrix, mut gradient) = self.normal(&point, &residual)?;
        for _ in 0..MOST_STEPS {
            let Some(step) = self.step(&point, &residual, (&matrix, &gradient), &mut damping)
            else {
                break;
            };
            let enough = step.promised < CONVERGED.max(CONVERGED_SHARE * residual.norm_squared());
            (point, residual) = (step.point, step.residual);
            let Some(renewed) = self.normal(&point, &residual) else {
                break;
            };
            (matrix, gradient) = renewed;
            if enough {
                break;
            }
        }
        let chi2 = residual.norm_squared();
        let cost = chi2 + self.prior_cost(&point);
        Some(Fitted {
            point,
            cost,
            chi2,
            rows: residual.len(),
            matrix,
        })
    }

    fn prior_cost(&self, point: &[f64]) -> f64 {
        point
            .iter()
            .zip(&self.priors)
            .map(|(p, (mean, u))| ((p - mean) / u).powi(2))
            .sum()
    }

    fn bounded(&self, mut point: Vec<f64>) -> Vec<f64> {
        self.one_sided
            .iter()
            .for_each(|k| point[*k] = point[*k].max(0.0));
        self.swing
            .line_limits()
            .for_each(|(k, most)| point[k] = point[k].clamp(-most, most));
        point
    }

    /// Normal equations, priors included; what stands at zero and would go below is held there.
    fn normal(
        &self,
        point: &[f64],
        residual: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let jacobian = self.swing.jacobian(point, self.causes, self.part)?;
        let (mut matrix, mut gradient) = (jacobian.tr_mul(&jacobian), jacobian.tr_mul(residual));
        for (k, (mean, u)) in self.priors.iter().enumerate() {
            matrix[(k, k)] += u.powi(-2);
            gradient[k] -= (point[k] - mean) / (u * u);
        }
        let mut held = self.one_sided.clone();
        held.retain(|k| point[*k] <= 0.0 && gradient[*k] <= 0.0);
        for k in held {
            matrix.row_mut(k).fill(0.0);
            matrix.column_mut(k).fill(0.0);
            // Its width is that of its prior, so that it neither gains nor costs evidence.
            (matrix[(k, k)], gradient[k]) = (self.priors[k].1.powi(-2), 0.0);
        }
        Some((matrix, gradient))
    }

    fn step(
        &self,
        point: &[f64],
        residual: &DVector<f64>,
        (matrix, gradient): (&DMatrix<f64>, &DVector<f64>),
        damping: &mut f64,
    ) -> Option<Step> {
        let cost = residual.norm_squared() + self.prior_cost(point);
        while *damping < MOST_DAMPING {
            let mut damped = matrix.clone();
            (0..damped.nrows()).for_each(|k| damped[(k, k)] *= 1.0 + *damping);
            let delta = damped.cholesky()?.solve(gradient);
            let promised = 2.0 * gradient.dot(&delta) - delta.dot(&(matrix * &delta));
            let there = self.bounded(point.iter().zip(delta.iter()).map(|(p, d)| p + d).collect());
            if let Some(residual) = self.swing.residual(&there, self.causes, self.part)
                && residual.norm_squared() + self.prior_cost(&there) <= cost
            {
                *damping = (*damping * 0.1).max(1e-9);
                return Some(Step {
                    point: there,
                    residual,
                    promised,
                });
            }
            *damping *= 10.0;
            if promised < CONVERGED {
                break;
            }
        }
        None
    }
}

struct Step {
    point: Vec<f64>,
    residual: DVector<f64>,
    promised: f64,
}
