//! Whether the samples of a record exclude a faster motion than the one that was found.
//!
//! Samples at an even rate 1/Δ show the frequencies f, 1/Δ − f and 1/Δ + f alike. Where their stamps
//! scatter, one of them fits better.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use gyradius_recording::median_interval_s;
use gyradius_signal::{ChannelGroup, FittedMode};

/// With so many samples a period, an alias would be faster by this factor less one. Hulls have a
/// size, which is known better than that.
const PLENTY: f64 = 10.0;
/// With fewer, the figures are not stated.
const TOO_FEW: f64 = 5.0;
/// Ratio of likelihoods, as its logarithm, at which one frequency is taken for the other: 1 in 10⁶.
const DECIDED: f64 = 14.0;

/// What the samples say of faster motions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampled {
    /// There is none, or it would be far too fast for a hull.
    Enough,
    /// None is excluded by the samples, but it would be much faster.
    Few { a_period: f64, other_s: f64 },
    /// None is excluded.
    TooFew { a_period: f64, other_s: f64 },
    /// A faster motion fits the stamps better.
    Alias { a_period: f64, other_s: f64 },
}

impl Sampled {
    /// Samples a period, and the period of the fastest alias, s.
    pub fn numbers(self) -> (f64, f64) {
        match self {
            Self::Enough => (f64::INFINITY, 0.0),
            Self::Few { a_period, other_s }
            | Self::TooFew { a_period, other_s }
            | Self::Alias { a_period, other_s } => (a_period, other_s),
        }
    }
}

/// Judges a mode by the group that shows it best.
pub fn sampled_enough(groups: &[ChannelGroup], mode: &FittedMode) -> Option<Sampled> {
    let mut first = 0;
    let mut best: Option<(&ChannelGroup, usize, f64)> = None;
    for group in groups {
        for c in 0..group.channels.len() {
            let ratio = mode.shape.get(first + c)?.norm() / mode.shape_se.get(first + c)?;
            if best.is_none_or(|(_, _, known)| ratio > known) {
                best = Some((group, c, ratio));
            }
        }
        first += group.channels.len();
    }
    let (group, channel, _) = best?;
    // Gaps are few and long: the median step is that of the clock.
    let interval_s = median_interval_s(&group.t_s)?;
    let period_s = mode.period_s();
    let a_period = period_s / interval_s;
    if a_period >= PLENTY {
        return Some(Sampled::Enough);
    }
    let own = 1.0 / period_s;
    let misfit = |hz: f64| misfit(group, channel, TAU * hz, mode.alpha_per_s);
    let here = misfit(own)?;
    // Of two fits to n samples, the logarithm of the ratio of their likelihoods.
    let gain_over = |there: f64| 0.5 * group.t_s.len() as f64 * (there / here).ln();
    let [slower, faster] = [1.0 / interval_s - own, 1.0 / interval_s + own];
    let gains = [gain_over(misfit(slower)?), gain_over(misfit(faster)?)];
    // What the stamps do not tell apart is the slower of the two.
    let (other, gain) = match gains[0] - gains[1] > DECIDED {
        true => (faster, gains[1]),
        false => (slower, gains[0]),
    };
    let other_s = 1.0 / other;
    Some(match gain {
        g if g > DECIDED => Sampled::Enough,
        g if g < -DECIDED => Sampled::Alias { a_period, other_s },
        _ if a_period < TOO_FEW => Sampled::TooFew { a_period, other_s },
        _ => Sampled::Few { a_period, other_s },
    })
}

/// Sum of squares that a damped oscillation about a mean leaves.
fn misfit(group: &ChannelGroup, channel: usize, omega: f64, alpha_per_s: f64) -> Option<f64> {
    let origin = *group.t_s.first()?;
    // Gravity would cost digits.
    let offset = *group.channels[channel].first()?;
    let mut normal = Matrix3::zeros();
    let mut right = Vector3::zeros();
    let mut power = 0.0;
    for (t, y) in group.t_s.iter().zip(&group.channels[channel]) {
        let since = t - origin;
        let (sin, cos) = (omega * since).sin_cos();
        let size = (-alpha_per_s * since).exp();
        let row = Vector3::new(1.0, size * cos, size * sin);
        normal += row * row.transpose();
        right += row * (y - offset);
        power += (y - offset).powi(2);
    }
    let solution = normal.cholesky()?.solve(&right);
    let left = power - solution.dot(&right);
    (left > 0.0).then_some(left)
}
