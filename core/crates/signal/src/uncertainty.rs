//! Standard errors that stay true when the noise is coloured or the model incomplete.
//!
//! The covariance is the sandwich `H⁻¹ (Σ_c s_c J_cᵀJ_c/σ_c²) H⁻¹`: H the curvature of the fit,
//! `s_c` the power of the residual about a mode's frequency over the variance the fit assumed.
//! Colour and misfit near the line both stand in that power. For white noise `s_c` scatters about 1
//! by a fifth; it counts only as far as it is significantly above 1, so that intervals of white
//! records keep their level.

use nalgebra::DMatrix;

use super::basis::Model;
use super::fit::{Curvature, Fit};
use super::motion::{Law, Motion};
use super::spectrum::Periodogram;

/// Half-width, in cycles per span, of the neighbourhood in which the residual's power is taken.
const NEIGHBOURHOOD: f64 = 12.0;
/// z at which an excess counts by half.
const HALF_SIGNIFICANCE: f64 = 3.0;

/// Covariances of a fit.
pub(super) struct Errors {
    /// Of the nonlinear parameters, per span.
    pub covariance: DMatrix<f64>,
    /// Standard error of real and imaginary parts by channel and mode.
    pub shape_se: Vec<Vec<f64>>,
}

impl Errors {
    pub fn of(fit: &Fit, curvature: &Curvature, residual: &Periodogram) -> Option<Self> {
        let bread = curvature.hessian.clone().cholesky()?.inverse();
        let owner = owners(&fit.model);
        let excess: Vec<Vec<f64>> = (0..fit.channels())
            .map(|c| excess(fit, residual, c))
            .collect();
        let mut filling = DMatrix::zeros(owner.len(), owner.len());
        for (c, square) in curvature.by_channel.iter().enumerate() {
            let weight = 1.0 / fit.variance(c);
            filling += square.map_with_location(|i, j, v| {
                v * weight * (excess[c][owner[i]] * excess[c][owner[j]]).sqrt()
            });
        }
        let covariance = &bread * filling * &bread;
        let shape_se = shape_errors(fit, curvature, &covariance, &excess);
        Some(Self {
            covariance,
            shape_se,
        })
    }

    /// Variance of a function of a mode's parameters, by its numerical gradient.
    pub fn se_of(&self, model: &Model, mode: usize, function: impl Fn(&Motion) -> f64) -> f64 {
        let motion = model.modes[mode];
        let (p, offset) = (motion.parameters(), model.parameter_offset(mode));
        let gradient: Vec<f64> = (0..p.len())
            .map(|i| {
                let h = 1e-5 * (1.0 + p[i].abs());
                let (mut up, mut down) = (p.clone(), p.clone());
                up[i] += h;
                down[i] -= h;
                (function(&motion.with_parameters(&up)) - function(&motion.with_parameters(&down)))
                    / (2.0 * h)
            })
            .collect();
        let mut variance = 0.0;
        for (i, a) in gradient.iter().enumerate() {
            for (j, b) in gradient.iter().enumerate() {
                variance += a * b * self.covariance[(offset + i, offset + j)];
            }
        }
        variance.max(0.0).sqrt()
    }
}

/// The mode that each parameter belongs to.
fn owners(model: &Model) -> Vec<usize> {
    let modes = model.modes.iter().enumerate();
    modes
        .flat_map(|(m, mode)| std::iter::repeat_n(m, mode.parameter_count()))
        .collect()
}

/// Residual power about each mode over the assumed variance, as far as it is significant; at least
/// 1.
fn excess(fit: &Fit, residual: &Periodogram, channel: usize) -> Vec<f64> {
    let centre = |mode: &Motion| mode.omega / std::f64::consts::TAU;
    let of_mode = |mode: &Motion| {
        let (from, to) = (
            (centre(mode) - NEIGHBOURHOOD).max(0.5),
            centre(mode) + NEIGHBOURHOOD,
        );
        let bin = |k: f64| ((k / residual.step) as usize).min(residual.len());
        let range = bin(from)..bin(to);
        let near = fit
            .model
            .modes
            .iter()
            .filter(|m| (from..to).contains(&centre(m)))
            .count() as f64;
        // Each fitted mode takes two real numbers of the channel, and a share of the poles, out of
        // the bins.
        let bins = range.len() as f64 * residual.step - near * (1.0 + 1.0 / fit.channels() as f64);
        let sum: f64 = residual.power[channel][range].iter().sum::<f64>() * residual.step;
        let above = (sum / bins.max(1.0) / fit.variance(channel) - 1.0).max(0.0);
        let z4 = (above * bins.max(1.0).sqrt() / HALF_SIGNIFICANCE).powi(4);
        if z4.is_finite() {
            1.0 + above * z4 / (1.0 + z4)
        } else {
            1.0
        }
    };
    fit.model.modes.iter().map(of_mode).collect()
}

fn shape_errors(
    fit: &Fit,
    curvature: &Curvature,
    covariance: &DMatrix<f64>,
    excess: &[Vec<f64>],
) -> Vec<Vec<f64>> {
    (0..fit.channels())
        .map(|c| {
            let linear = &curvature.linear_covariance[curvature.group_of[c]];
            let slopes = &curvature.coefficient_slopes[c];
            let carried = slopes * covariance * slopes.transpose();
            let part = |i: usize, s: f64| linear[(i, i)] * fit.variance(c) * s + carried[(i, i)];
            let mode = |m: usize| 0.5 * (part(2 * m, excess[c][m]) + part(2 * m + 1, excess[c][m]));
            (0..fit.model.modes.len())
                .map(|m| mode(m).max(0.0).sqrt())
                .collect()
        })
        .collect()
}

/// What a damped oscillation of constant frequency and decay reads where they change: the mean of
/// either over the span by [`slope_weights`].
pub(super) fn mean_rates(motion: &Motion) -> (f64, f64) {
    let Some(Law { shift, beta, power }) = motion.law else {
        return (motion.omega, motion.alpha);
    };
    let envelopes: Vec<f64> = middles().map(|t| motion.envelope(t)).collect();
    let weights = slope_weights(&envelopes);
    let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
        let each = envelopes.iter().zip(&weights);
        each.map(|(envelope, weight)| weight * of(*envelope)).sum()
    };
    (
        mean(&|envelope| motion.omega + shift * envelope.powi(i32::from(power))),
        mean(&|envelope| motion.alpha + beta * envelope),
    )
}

/// Steps of the integrals over the span.
const STEPS: u32 = 400;

/// The middles of equal parts of the span, which runs from 0 to 1.
fn middles() -> impl Iterator<Item = f64> {
    (0..STEPS).map(|i| (f64::from(i) + 0.5) / f64::from(STEPS))
}

/// How much the frequency at each moment has in that of the whole record, sum 1. A constant frequency
/// is the slope of a straight line through the phase, each moment of which has the weight E² of its
/// envelope; by parts, the slope is the mean of the phase's own slope with the weight
/// K(t) = ∫ₜ (u − ū) E²(u) du, ū the centre of E².
fn slope_weights(envelopes: &[f64]) -> Vec<f64> {
    let energy = |i: usize| envelopes[i] * envelopes[i];
    let n = envelopes.len();
    let all: f64 = (0..n).map(energy).sum();
    let centre = (0..n).map(|i| i as f64 * energy(i)).sum::<f64>() / all;
    let mut weights = vec![0.0; n];
    let mut beyond = 0.0;
    for i in (0..n).rev() {
        let own = (i as f64 - centre) * energy(i);
        weights[i] = beyond + 0.5 * own;
        beyond += own;
    }
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| weight / sum).collect()
}

/// The mean square of the amplitude, over that at the start, which the frequency of a record answers
/// to whose amplitude falls by e^(−`decays`): a quarter where it decays to nothing.
pub fn mean_square_amplitude(decays: f64) -> f64 {
    // Over one of 50 decays the rest is 10⁻²².
    let decays = decays.min(50.0);
    let envelopes: Vec<f64> = middles().map(|t| (-decays * t).exp()).collect();
    let weights = slope_weights(&envelopes);
    let each = envelopes.iter().zip(&weights);
    each.map(|(envelope, weight)| weight * envelope * envelope)
        .sum()
}
