//! The white noise of each channel and the size of the residual, at full resolution.
//!
//! Two figures for each channel. The white level: residuals are cut into runs of 16 samples; the median over the
//! runs of the variance about the run's own mean knows nothing of misfit, drift or single knocks. The root mean
//! square of the whole residual: it contains them. Their ratio tells whether the model is complete.
//!
//! The model is not evaluated at each sample but expanded to third order about each cell's centroid, which is
//! exact to 1e-4 of the amplitude and costs three multiplications a sample for any number of modes.

use num_complex::Complex64;

use super::basis::{Walk, legendre};
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
    let mut runs: Vec<Runs> = vec![Runs::default(); cells.channels];
    let mut walk = Walk::new(&fit.model.modes);
    let mut atoms = vec![(Complex64::ZERO, Complex64::ZERO); fit.model.atoms()];
    let scale = 1.0 / clock.span_s;
    for i in 0..cells.len() {
        walk.go_to(cells.tau[i]);
        atoms.iter_mut().enumerate().for_each(|(k, atom)| *atom = fit.model.atom_at(k, &walk));
        let (from, to) = (cells.start[i], cells.start[i + 1]);
        let centroid_s = clock.t_ref_s + cells.tau[i] * clock.span_s;
        let baseline = baseline_at(cells.tau[i], fit.model.baseline);
        for (c, run) in runs.iter_mut().enumerate() {
            let poly = expansion(fit, first + c, &atoms, &baseline, offsets[c]);
            for (t, y) in group.t_s[from..to].iter().zip(&group.channels[c][from..to]) {
                let s = (t - centroid_s) * scale;
                run.push(y - (poly[0] + s * (poly[1] + s * (poly[2] + s * poly[3]))));
            }
        }
    }
    runs.into_iter().map(Runs::finish).collect()
}

/// Taylor coefficients of the model of a channel about a cell's centroid.
fn expansion(
    fit: &Fit,
    channel: usize,
    atoms: &[(Complex64, Complex64)],
    baseline: &(Vec<f64>, Vec<f64>),
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
    poly[0] += own.iter().zip(&baseline.0).map(|(a, p)| a * p).sum::<f64>();
    poly[1] += own.iter().zip(&baseline.1).map(|(a, p)| a * p).sum::<f64>();
    poly
}

/// Baseline polynomials and their slopes.
fn baseline_at(tau: f64, count: usize) -> (Vec<f64>, Vec<f64>) {
    let h = 1e-4;
    let (mut low, mut here, mut high) = (vec![], vec![], vec![]);
    legendre(tau - h, count, &mut low);
    legendre(tau, count, &mut here);
    legendre(tau + h, count, &mut high);
    let slopes = high.iter().zip(&low).map(|(b, a)| (b - a) / (2.0 * h)).collect();
    (here, slopes)
}

/// Residuals gathered in runs.
#[derive(Debug, Clone, Default)]
struct Runs {
    count: usize,
    sum: f64,
    squares: f64,
    rss: f64,
    samples: f64,
    variances: Vec<f64>,
}

impl Runs {
    fn push(&mut self, residual: f64) {
        self.count += 1;
        self.sum += residual;
        self.squares += residual * residual;
        if self.count == RUN {
            let n = RUN as f64;
            self.variances.push((self.squares - self.sum * self.sum / n) / (n - 1.0));
            self.close();
        }
    }

    fn close(&mut self) {
        self.rss += self.squares;
        self.samples += self.count as f64;
        (self.count, self.sum, self.squares) = (0, 0.0, 0.0);
    }

    fn finish(mut self) -> ChannelNoise {
        self.close();
        let middle = self.variances.len() / 2;
        let median = if self.variances.is_empty() {
            self.rss / self.samples
        } else {
            *self.variances.select_nth_unstable_by(middle, f64::total_cmp).1 / RUN_MEDIAN
        };
        // Coarsely quantised channels can have runs without any scatter; then the residual speaks alone.
        let variance = if median > 0.0 { median } else { self.rss / self.samples };
        ChannelNoise { white: variance.sqrt(), rss: self.rss, samples: self.samples }
    }
}
