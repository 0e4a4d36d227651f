//! The noise floor of a periodogram, coloured as it may be.
//!
//! Sensors have white noise with 1/f noise and drift below. The floor of each channel is `a +
//! b·k^−γ` (γ = 1 or 2), fitted by Whittle's likelihood to medians over short stretches so that
//! lines do not lift it, and raised where a wider stretch of the spectrum stands above that law.

use super::spectrum::Periodogram;

/// Median of an exponential variable over its mean.
const EXPONENTIAL_MEDIAN: f64 = std::f64::consts::LN_2;

/// A stretch of the spectrum: middle, typical power, independent bins.
struct Stretch {
    k: f64,
    power: f64,
    bins: f64,
}

/// The floor of one channel.
#[derive(Debug, Clone)]
pub(super) struct Floor {
    white: f64,
    red: f64,
    gamma: i32,
    /// Knots: k, factor of the raising.
    raised: Vec<(f64, f64)>,
}

impl Floor {
    /// Floor of every channel between two frequencies.
    pub fn of(spectrum: &Periodogram, lowest: f64, highest: f64) -> Vec<Self> {
        spectrum
            .power
            .iter()
            .map(|power| Self::fit(power, spectrum.step, lowest, highest))
            .collect()
    }

    /// Expected power of the noise.
    pub fn at(&self, k: f64) -> f64 {
        self.law(k) * interpolate(&self.raised, k)
    }

    fn fit(power: &[f64], step: f64, lowest: f64, highest: f64) -> Self {
        let stretches = stretches(power, step, lowest, highest);
        let mut best = (
            f64::INFINITY,
            Self {
                white: f64::MIN_POSITIVE,
                red: 0.0,
                gamma: 1,
                raised: vec![],
            },
        );
        for gamma in [1, 2] {
            let (white, red) = whittle(&stretches, gamma);
            let floor = Self {
                white,
                red,
                gamma,
                raised: vec![],
            };
            let misfit = stretches.iter().map(|s| s.misfit(floor.law(s.k))).sum();
            if misfit < best.0 {
                best = (misfit, floor);
            }
        }
        let mut floor = best.1;
        floor.raised = raised(&stretches, &floor);
        floor
    }

    fn law(&self, k: f64) -> f64 {
        self.white + self.red * k.powi(-self.gamma)
    }
}

impl Stretch {
    /// Whittle's −ln L, an outlying stretch counted with a bound.
    fn misfit(&self, law: f64) -> f64 {
        self.bins * (law.ln() + (self.power / law).min(6.0))
    }
}

/// Single bins below k ≈ 16, then stretches of an eighth, each taken as its median.
fn stretches(power: &[f64], step: f64, lowest: f64, highest: f64) -> Vec<Stretch> {
    let stride = (1.0 / step).round().max(1.0) as usize;
    let mut out = Vec::new();
    let mut k = lowest.max(1.0);
    while k < highest {
        let width = if k < 16.0 { 1.0 } else { k / 8.0 };
        let (from, to) = (
            (k / step) as usize,
            (((k + width) / step) as usize).min(power.len()),
        );
        if from >= to {
            break;
        }
        let mut bins: Vec<f64> = power[from..to].iter().step_by(stride).copied().collect();
        let middle = bins.len() / 2;
        let single = bins.len() < 4;
        let typical = if single {
            bins.iter().sum::<f64>() / bins.len() as f64
        } else {
            *bins.select_nth_unstable_by(middle, f64::total_cmp).1 / EXPONENTIAL_MEDIAN
        };
        out.push(Stretch {
            k: k + 0.5 * width,
            power: typical.max(f64::MIN_POSITIVE),
            bins: bins.len() as f64,
        });
        k += width;
    }
    out
}

/// Iterated weighted least squares for `a + b·k^−γ`, both not negative.
fn whittle(stretches: &[Stretch], gamma: i32) -> (f64, f64) {
    let mut powers: Vec<f64> = stretches.iter().map(|s| s.power).collect();
    if powers.is_empty() {
        return (f64::MIN_POSITIVE, 0.0);
    }
    let middle = powers.len() / 2;
    let start = *powers.select_nth_unstable_by(middle, f64::total_cmp).1;
    let (mut white, mut red) = (start, 0.0);
    let shape: Vec<f64> = stretches.iter().map(|s| s.k.powi(-gamma)).collect();
    for _ in 0..10 {
        let mut s = [0.0; 5];
        for (stretch, &x) in stretches.iter().zip(&shape) {
            let law = white + red * x;
            let weight = stretch.bins / (law * law);
            let y = stretch.power.min(5.0 * law);
            let terms = [1.0, x, x * x, y, x * y];
            s.iter_mut()
                .zip(terms)
                .for_each(|(s, term)| *s += weight * term);
        }
        let determinant = s[0] * s[2] - s[1] * s[1];
        let solved = (
            (s[3] * s[2] - s[4] * s[1]) / determinant,
            (s[0] * s[4] - s[1] * s[3]) / determinant,
        );
        (white, red) = if determinant.is_nan() || determinant <= 0.0 || solved.1 < 0.0 {
            (s[3] / s[0], 0.0)
        } else if solved.0 <= 0.0 {
            (1e-6 * start, s[4] / s[2])
        } else {
            solved
        };
        white = white.max(f64::MIN_POSITIVE);
    }
    (white, red)
}

/// Where nine neighbouring stretches stand above the law in the median, the floor stands there too.
fn raised(stretches: &[Stretch], floor: &Floor) -> Vec<(f64, f64)> {
    let ratio: Vec<f64> = stretches.iter().map(|s| s.power / floor.law(s.k)).collect();
    let mut knots = Vec::new();
    for (i, stretch) in stretches.iter().enumerate() {
        let from = i.saturating_sub(4);
        let to = (i + 5).min(ratio.len());
        let mut near = ratio[from..to].to_vec();
        let middle = near.len() / 2;
        let typical = *near.select_nth_unstable_by(middle, f64::total_cmp).1;
        knots.push((stretch.k, typical.max(1.0)));
    }
    knots
}

fn interpolate(knots: &[(f64, f64)], x: f64) -> f64 {
    let after = knots.partition_point(|knot| knot.0 < x);
    match (
        after.checked_sub(1).and_then(|i| knots.get(i)),
        knots.get(after),
    ) {
        (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0),
        (Some(end), None) | (None, Some(end)) => end.1,
        (None, None) => 1.0,
    }
}
