//! Eq. (14): a list of periods whose mean drifts and which a second motion modulates at the beat
//! period.
//!
//! The print lost the amplitude of the modulation; with it, T(t) = T0 (1 + bt) + C exp(−t/τ_m)
//! sin(2πt/T_m + φ_m).
//!
//! # Conventions
//! `t` counts from the first period of the list, so `T0` is the unmodulated period there.

use std::f64::consts::TAU;

use gyradius_estimation::{
    Block, ByRows, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted, minimise,
};
use nalgebra::{DMatrix, DVector};

use super::curve_fit::{CurveFit, linear, nonlinear};

/// Eq. (14) fitted to a list of periods; what the data do not support is absent.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodTrend {
    /// T0, s: the period at the first entry, modulation taken off.
    pub t0_s: f64,
    /// Its standard error, s.
    pub t0_se_s: f64,
    /// b, 1/s: relative change of the period per second; 0 where none is seen.
    pub b_per_s: f64,
    /// Its standard error, 1/s; 0 where `b` was not fitted.
    pub b_se_per_s: f64,
    /// Mean period at the middle of the list, modulation taken off, s.
    pub mean_s: f64,
    /// Its standard error, s.
    pub mean_se_s: f64,
    /// The modulation by a second motion.
    pub modulation: Option<Modulation>,
    /// Scatter of the periods about the curve, s.
    pub scatter_s: f64,
}

/// The modulation of eq. (14).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulation {
    /// C, s.
    pub c_s: f64,
    /// Its standard error, s.
    pub c_se_s: f64,
    /// 1/τ_m, 1/s (may be 0 or slightly negative: growing).
    pub decay_per_s: f64,
    /// Its standard error, 1/s.
    pub decay_se_per_s: f64,
    /// T_m, s: the beat period.
    pub t_m_s: f64,
    /// Its standard error, s.
    pub t_m_se_s: f64,
    /// φ_m, rad.
    pub phase_rad: f64,
}

impl Modulation {
    /// τ_m, s; infinite where no decay is seen.
    pub fn tau_m_s(&self) -> f64 {
        if self.decay_per_s > 0.0 {
            1.0 / self.decay_per_s
        } else {
            f64::INFINITY
        }
    }
}

impl PeriodTrend {
    /// The curve at `t_s` after the first entry, s: eq. (14).
    pub fn at(&self, t_s: f64) -> f64 {
        let wave = |m: &Modulation| {
            m.c_s * (-m.decay_per_s * t_s).exp() * (TAU * t_s / m.t_m_s + m.phase_rad).sin()
        };
        self.t0_s * (1.0 + self.b_per_s * t_s) + self.modulation.as_ref().map_or(0.0, wave)
    }
}

/// Evidence (in units of the information criterion) a richer curve must win by: odds of about 20 to
/// 1.
const BIC_MARGIN: f64 = 6.0;

/// Fits eq. (14), falling back to T0 (1 + bt) and to a constant; `None` below two periods.
pub fn fit_period_trend(t_s: &[f64], period_s: &[f64]) -> Option<PeriodTrend> {
    let origin = *t_s.first()?;
    let t: Vec<f64> = t_s.iter().map(|v| v - origin).collect();
    let weight = vec![1.0; t.len()];
    let constant = linear(&[vec![1.0; t.len()]], period_s, &weight)?;
    let straight = linear(&[vec![1.0; t.len()], t.clone()], period_s, &weight);
    let plain = match straight {
        Some(line) if line.bic() + BIC_MARGIN < constant.bic() => line,
        _ => constant,
    };
    let middle = 0.5 * (t[0] + t[t.len() - 1]);
    match modulated(&t, period_s, &plain) {
        Some(fit) => Some(described(&fit, middle, true)),
        None => Some(described(&plain, middle, false)),
    }
}

/// The curve with a modulation, fitted to a list of periods. Parameters T0, T0·b, C cos φ (sine
/// part), C sin φ (cosine part), 1/T_m, 1/τ_m.
struct Modulated<'a> {
    t_s: &'a [f64],
    period_s: &'a [f64],
}

const PARAMETERS: usize = 6;

/// Eq. (14) at a time, and its slopes.
fn curve(p: &[f64], t: f64) -> (f64, [f64; PARAMETERS]) {
    let (sin, cos) = (TAU * p[4] * t).sin_cos();
    let decay = (-p[5] * t).exp();
    let wave = decay * (p[2] * sin + p[3] * cos);
    let turn = TAU * t * decay * (p[2] * cos - p[3] * sin);
    let slopes = [1.0, t, decay * sin, decay * cos, turn, -t * wave];
    (p[0] + p[1] * t + wave, slopes) // eq. (14)
}

impl Rows for Modulated<'_> {
    fn shape(&self) -> Shape {
        Shape::single(PARAMETERS)
    }

    fn rows(&self, _: usize, p: &[f64], _: &[f64], _: Wanted) -> Option<Block> {
        let at: Vec<_> = self.t_s.iter().map(|t| curve(p, *t)).collect();
        let residual = |i: usize, _| at[i].0 - self.period_s[i];
        Some(Block {
            residuals: DVector::from_fn(at.len(), residual),
            jacobian: Some(DMatrix::from_fn(at.len(), PARAMETERS, |i, k| at[i].1[k])),
        })
    }
}

/// Where a fit of periods ends: their noise is not known, so that a share of their scatter counts.
const OPTIONS: Options = Options {
    most_steps: 100,
    gain: 0.0,
    // A millionth of a standard error.
    gain_share: 1e-12,
    keep: None,
};

fn modulated(t: &[f64], y: &[f64], plain: &CurveFit) -> Option<CurveFit> {
    if t.len() < 12 {
        return None;
    }
    let span = t[t.len() - 1];
    let steps: Vec<f64> = t.windows(2).map(|w| w[1] - w[0]).collect();
    let step = super::crossings::median(&steps).filter(|s| *s > 0.0)?;
    let tried = (2.0 * span / step) as usize;
    let start = (3..tried.min(4000))
        .flat_map(|k| [0.0, 1.0, 3.0].map(|decay| (k as f64 / (4.0 * span), decay / span)))
        .filter_map(|(f, decay)| at_frequency(t, y, f, decay))
        .min_by(|a, b| a.1.total_cmp(&b.1))?
        .0;
    let rows = Modulated {
        t_s: t,
        period_s: y,
    };
    let free = [Parameter::FREE; PARAMETERS];
    let fit = minimise(&mut ByRows::new(&rows), &free, &start, &OPTIONS, UNSTOPPED)
        .ok()
        .filter(|fit| fit.ending.is_converged())?;
    let fit = nonlinear(&fit, t.len())?;
    // Looking at many frequencies finds something in any noise: each independent one costs.
    let look_elsewhere = 2.0 * (tried as f64 / 2.0).max(1.0).ln();
    let cycles = fit.parameters[4] * span;
    let sane = cycles > 0.75 && fit.parameters[4] < 0.5 / step && fit.parameters[5] * span < 12.0;
    (sane && fit.bic() + look_elsewhere + BIC_MARGIN < plain.bic()).then_some(fit)
}

fn at_frequency(t: &[f64], y: &[f64], f: f64, decay: f64) -> Option<([f64; 6], f64)> {
    let part = |sine: bool| {
        let of = |t: &f64| {
            (-decay * t).exp()
                * if sine {
                    (TAU * f * t).sin()
                } else {
                    (TAU * f * t).cos()
                }
        };
        t.iter().map(of).collect::<Vec<f64>>()
    };
    let fit = linear(
        &[vec![1.0; t.len()], t.to_vec(), part(true), part(false)],
        y,
        &vec![1.0; t.len()],
    )?;
    let p = &fit.parameters;
    Some(([p[0], p[1], p[2], p[3], f, decay], fit.rss))
}

fn described(fit: &CurveFit, middle: f64, with_modulation: bool) -> PeriodTrend {
    let p = &fit.parameters;
    let v = &fit.covariance;
    let sloped = p.len() > 1;
    let (slope, slope_se) = if sloped {
        (p[1], fit.se(1))
    } else {
        (0.0, 0.0)
    };
    let mean_variance = if sloped {
        v[(0, 0)] + 2.0 * middle * v[(0, 1)] + middle * middle * v[(1, 1)]
    } else {
        v[(0, 0)]
    };
    PeriodTrend {
        t0_s: p[0],
        t0_se_s: fit.se(0),
        b_per_s: slope / p[0],
        b_se_per_s: slope_se / p[0].abs(),
        mean_s: p[0] + slope * middle,
        mean_se_s: mean_variance.max(0.0).sqrt(),
        modulation: with_modulation.then(|| modulation(fit)),
        scatter_s: (fit.rss / fit.dof as f64).sqrt(),
    }
}

fn modulation(fit: &CurveFit) -> Modulation {
    let p = &fit.parameters;
    let c_s = p[2].hypot(p[3]);
    let v = &fit.covariance;
    let c_variance =
        (p[2] * p[2] * v[(2, 2)] + 2.0 * p[2] * p[3] * v[(2, 3)] + p[3] * p[3] * v[(3, 3)])
            / (c_s * c_s);
    Modulation {
        c_s,
        c_se_s: c_variance.max(0.0).sqrt(),
        decay_per_s: p[5],
        decay_se_per_s: fit.se(5),
        t_m_s: 1.0 / p[4],
        t_m_se_s: fit.se(4) / (p[4] * p[4]),
        phase_rad: p[3].atan2(p[2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_of_the_curve_are_those_of_its_values() {
        let p = [1.3, 1e-4, 0.02, -0.03, 0.07, 0.011];
        for t in [0.0, 3.7, 41.0] {
            for k in 0..PARAMETERS {
                let at = |by: f64| {
                    let mut q = p;
                    q[k] += by;
                    curve(&q, t).0
                };
                let step = 1e-8;
                let difference = (at(step) - at(-step)) / (2.0 * step);
                let slope = curve(&p, t).1[k];
                assert!((slope - difference).abs() < 1e-6, "{k} at {t} s");
            }
        }
    }
}
