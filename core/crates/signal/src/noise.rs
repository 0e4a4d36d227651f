//! The white noise of each channel and the size of the residual, at full resolution.
//!
//! Two figures for each channel. The white level: residuals are cut into runs of 16 samples; the
//! median over the runs of the variance about the run's own mean knows nothing of misfit, drift or
//! single knocks. The root mean square of the whole residual: it contains them. Their ratio tells
//! whether the model is complete.
//!
//! The model is not evaluated at each sample but expanded to third order about each cell's
//! centroid, which is exact to 2e-5 of a mode's amplitude and costs three multiplications a sample
//! for any number of modes.

use num_complex::Complex64;

use super::basis::{Walk, legendre, legendre_slopes};
use super::compress::{Cells, Clock};
use super::fit::Fit;
use super::types::ChannelGroup;

/// Samples in a run.
const RUN: usize = 16;
/// Median over mean of χ² with 15 degrees of freedom: 14.3389/15.
const RUN_MEDIAN: f64 = 0.955_926;

/// Noise of one channel.
#[derive(Debug, Clone, Copy)]
pub(super) struct ChannelNoise {
    /// White level, standard deviation per sample.
    pub white: f64,
    /// Residual sum of squares over all samples.
    pub rss: f64,
    /// Samples.
    pub samples: f64,
}

/// Noise of every channel of one group; `first` is its first channel in the fit.
pub(super) fn group_noise(
    fit: &Fit,
    first: usize,
    cells: &Cells,
    group: &ChannelGroup,
    offsets: &[f64],
    clock: Clock,
) -> Vec<ChannelNoise> {
    let expansions = expansions(fit, first, cells, offsets);
    let from_centroid = from_centroid(cells, group, clock);
    let of_channel = |(c, values): (usize, &Vec<f64>)| {
        let mut residuals = values.clone();
        for (bounds, poly) in cells
            .start
            .windows(2)
            .zip(expansions.iter().skip(c).step_by(cells.channels))
        {
            let own = bounds[0]..bounds[1];
            for (y, s) in residuals[own.clone()].iter_mut().zip(&from_centroid[own]) {
                *y -= poly[0] + s * (poly[1] + s * (poly[2] + s * poly[3]));
            }
        }
        ChannelNoise::of(&residuals)
    };
    group.channels.iter().enumerate().map(of_channel).collect()
}

/// Scaled time of every sample from the centroid of its cell.
fn from_centroid(cells: &Cells, group: &ChannelGroup, clock: Clock) -> Vec<f64> {
    let scale = 1.0 / clock.span_s;
    let mut all = Vec::with_capacity(group.t_s.len());
    for (bounds, tau) in cells.start.windows(2).zip(&cells.tau) {
        let centroid_s = clock.t_ref_s + tau * clock.span_s;
        all.extend(
            group.t_s[bounds[0]..bounds[1]]
                .iter()
                .map(|t| (t - centroid_s) * scale),
        );
    }
    all
}

/// Taylor coefficients of the model about every cell's centroid, channel by channel within a cell.
fn expansions(fit: &Fit, first: usize, cells: &Cells, offsets: &[f64]) -> Vec<[f64; 4]> {
    let mut walk = Walk::new(&fit.model.modes);
    let mut atoms = vec![(Complex64::ZERO, Complex64::ZERO); fit.model.atoms()];
    let mut values = vec![0.0; fit.model.baseline];
    let mut all = Vec::with_capacity(cells.len() * cells.channels);
    for &tau in &cells.tau {
        walk.go_to(tau);
        atoms
            .iter_mut()
            .enumerate()
            .for_each(|(k, atom)| *atom = fit.model.atom_at(k, &walk));
        legendre(tau, &mut values);
        let slopes = legendre_slopes(&values);
        all.extend(
            offsets
                .iter()
                .enumerate()
                .map(|(c, offset)| expansion(fit, first + c, &atoms, (&values, &slopes), *offset)),
        );
    }
    all
}

/// Taylor coefficients of the model of a channel about a cell's centroid.
fn expansion(
    fit: &Fit,
    channel: usize,
    atoms: &[(Complex64, Complex64)],
    baseline: (&[f64], &[f64]),
    offset: f64,
) -> [f64; 4] {
    let mut poly = [offset, 0.0, 0.0, 0.0];
    for (k, &(rate, z)) in atoms.iter().enumerate() {
        let mut term = fit.amplitude(channel, k) * z;
        for (n, p) in poly.iter_mut().enumerate() {
            *p += term.re;
            term *= rate / (n + 1) as f64;
        }
    }
    let own = &fit.coefficients[channel][2 * atoms.len()..];
    poly[0] += own.iter().zip(baseline.0).map(|(a, p)| a * p).sum::<f64>();
    poly[1] += own.iter().zip(baseline.1).map(|(a, p)| a * p).sum::<f64>();
    poly
}

impl ChannelNoise {
    fn of(residuals: &[f64]) -> Self {
        let samples = residuals.len() as f64;
        let rss: f64 = residuals.iter().map(|r| r * r).sum();
        let mut variances: Vec<f64> = residuals.chunks_exact(RUN).map(run_variance).collect();
        let middle = variances.len() / 2;
        let median = if variances.is_empty() {
            rss / samples
        } else {
            *variances.select_nth_unstable_by(middle, f64::total_cmp).1 / RUN_MEDIAN
        };
        // Coarsely quantised channels can have runs without any scatter; then the residual speaks
        // alone.
        let variance = if median > 0.0 { median } else { rss / samples };
        Self {
            white: variance.sqrt(),
            rss,
            samples,
        }
    }
}

/// White level of what a model of any kind leaves of a channel, standard deviation per sample.
pub fn white_level(residuals: &[f64]) -> f64 {
    ChannelNoise::of(residuals).white
}

/// Variance of a run about its own mean.
fn run_variance(run: &[f64]) -> f64 {
    let (sum, squares) = run.iter().fold((0.0, 0.0), |(s, q), r| (s + r, q + r * r));
    let n = run.len() as f64;
    (squares - sum * sum / n) / (n - 1.0)
}
