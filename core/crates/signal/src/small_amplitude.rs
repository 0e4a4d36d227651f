//! The period of an infinitely small swing, from periods against amplitude.
//!
//! No law is known beforehand: a pendulum is quadratic, other hangings are nearly linear. The laws
//! are weighed by their evidence, and the result carries the spread between them.

use super::amplitude::WindowPoint;
use super::curve_fit::{CurveFit, linear};

/// How the period depends on the amplitude A.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PeriodLaw {
    /// T0.
    Constant,
    /// T0 + c₂ A².
    Quadratic,
    /// T0 + c₁ A.
    Linear,
    /// T0 + c₁ A + c₂ A².
    LinearQuadratic,
}

/// The period at vanishing amplitude.
#[derive(Debug, Clone, PartialEq)]
pub struct SmallAmplitude {
    /// T0, averaged over the laws by evidence, s.
    pub period_s: f64,
    /// Its standard error: within the laws and between them, s.
    pub period_se_s: f64,
    /// The law with the most evidence.
    pub law: PeriodLaw,
    /// Its coefficients c₁ and c₂, s per unit of amplitude and per its square; 0 where the law has
    /// none.
    pub coefficients: [f64; 2],
    /// Weighted residual squares of that law, with the windows' own standard errors.
    pub chi2: f64,
    /// Degrees of freedom.
    pub dof: usize,
    /// A sentence for the report.
    pub text: String,
}

const LAWS: [(PeriodLaw, &[i32]); 4] = [
    (PeriodLaw::Constant, &[]),
    (PeriodLaw::Quadratic, &[2]),
    (PeriodLaw::Linear, &[1]),
    (PeriodLaw::LinearQuadratic, &[1, 2]),
];

/// Extrapolates periods to amplitude zero; `None` without a point.
pub fn small_amplitude_limit(points: &[WindowPoint]) -> Option<SmallAmplitude> {
    if points.len() < 2 {
        return points.first().map(single);
    }
    let fits: Vec<(PeriodLaw, &[i32], CurveFit)> = LAWS
        .iter()
        .filter_map(|(law, powers)| Some((*law, *powers, fit(points, powers)?)))
        .collect();
    // The scatter about the law that follows the points best is the scale of all of them.
    let scale = fits
        .iter()
        .map(|f| f.2.rss / f.2.dof as f64)
        .fold(f64::INFINITY, f64::min)
        .max(1.0);
    let n = points.len() as f64;
    let criterion = |f: &CurveFit| f.rss / scale + f.parameters.len() as f64 * n.ln();
    let best = fits
        .iter()
        .min_by(|a, b| criterion(&a.2).total_cmp(&criterion(&b.2)))?;
    let evidence: Vec<f64> = fits
        .iter()
        .map(|f| (-0.5 * (criterion(&f.2) - criterion(&best.2))).exp())
        .collect();
    let sum: f64 = evidence.iter().sum();
    let mean = fits
        .iter()
        .zip(&evidence)
        .map(|(f, w)| w * f.2.parameters[0])
        .sum::<f64>()
        / sum;
    let variance = |f: &CurveFit| {
        let own = f.covariance[(0, 0)] / (f.rss / f.dof as f64).max(f64::MIN_POSITIVE) * scale;
        own + (f.parameters[0] - mean).powi(2)
    };
    let spread = fits
        .iter()
        .zip(&evidence)
        .map(|(f, w)| w * variance(&f.2))
        .sum::<f64>()
        / sum;
    let (mean, spread) = match witness(points).filter(|_| scale > NO_LAW_FITS) {
        // Neither knows better: their middle, and half their distance as a further uncertainty.
        Some(other) => (0.5 * (mean + other), spread + 0.25 * (mean - other).powi(2)),
        None => (mean, spread),
    };
    Some(described(best, mean, spread.sqrt(), points))
}

/// χ² per degree of freedom above which none of the laws describes the points (windows three sigma
/// off).
const NO_LAW_FITS: f64 = 9.0;

/// Limit of the smaller half of the swings by the law of every smooth symmetric restoring force, T0
/// + c₂ A².
fn witness(points: &[WindowPoint]) -> Option<f64> {
    let mut smaller = points.to_vec();
    smaller.sort_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
    smaller.truncate(points.len().div_ceil(2));
    fit(&smaller, &[2]).map(|f| f.parameters[0])
}

fn fit(points: &[WindowPoint], powers: &[i32]) -> Option<CurveFit> {
    let mut columns = vec![vec![1.0; points.len()]];
    columns.extend(powers.iter().map(|k| {
        points
            .iter()
            .map(|p| p.amplitude.powi(*k))
            .collect::<Vec<f64>>()
    }));
    let period: Vec<f64> = points.iter().map(|p| p.period_s).collect();
    let weight: Vec<f64> = points
        .iter()
        .map(|p| 1.0 / p.period_se_s.max(1e-9 * p.period_s))
        .collect();
    linear(&columns, &period, &weight)
}

fn single(point: &WindowPoint) -> SmallAmplitude {
    SmallAmplitude {
        period_s: point.period_s,
        period_se_s: point.period_se_s,
        law: PeriodLaw::Constant,
        coefficients: [0.0, 0.0],
        chi2: 0.0,
        dof: 0,
        text: "one window only: the dependence on amplitude is not known".into(),
    }
}

fn described(
    (law, powers, fit): &(PeriodLaw, &[i32], CurveFit),
    period_s: f64,
    period_se_s: f64,
    points: &[WindowPoint],
) -> SmallAmplitude {
    let mut coefficients = [0.0, 0.0];
    for (k, c) in powers.iter().zip(&fit.parameters[1..]) {
        coefficients[(*k - 1) as usize] = *c;
    }
    let largest = points.iter().map(|p| p.amplitude).fold(0.0, f64::max);
    let change = coefficients[0] * largest + coefficients[1] * largest * largest;
    let text = match law {
        PeriodLaw::Constant => {
            "the period does not depend on the amplitude within its error".to_string()
        }
        _ => {
            let shape = match law {
                PeriodLaw::Quadratic => "with the square of the amplitude",
                PeriodLaw::Linear => "linearly with the amplitude",
                _ => "with the amplitude and its square",
            };
            format!(
                "the period changes {shape}, by {:+.2} % at the largest swing",
                100.0 * change / period_s
            )
        }
    };
    SmallAmplitude {
        period_s,
        period_se_s,
        law: *law,
        coefficients,
        chi2: fit.rss,
        dof: fit.dof,
        text,
    }
}
