//! One motion of a swing as a sensor saw it, measured and simulated: period and decay against
//! amplitude, what is left against phase.
//!
//! # Conventions
//! The channel is a turn rate about one axis, rad/s, or its angle, rad. Amplitudes are those of the
//! angle.

use num_complex::Complex64;

use super::result::{Discrepancy, DiscrepancyKind};
use super::unit::UnitName;
use super::words;
use gyradius_base::message::Argument;
use gyradius_recording::ModeName;
use gyradius_signal::{ChannelGroup, Pole, WindowPoint, WindowedMode, against_amplitude};

/// Differences of more standard uncertainties are told of.
const TOLD: f64 = 4.0;
/// A rate above this share of the highest within a swing is that of its middle: half of the time is
/// spent there, 1/√2.
const MIDDLE: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Amplitudes nearer to each other than by this factor say nothing of how the period goes with
/// them.
const GROWN: f64 = 1.1;
/// Fewer samples at either place say nothing of how much is left there.
const FEWEST: f64 = 30.0;

/// A motion in one channel.
pub struct Seen<'a> {
    pub swing: &'a str,
    pub motion: ModeName,
    pub t_s: &'a [f64],
    pub measured: &'a [f64],
    pub simulated: &'a [f64],
    /// Whether the channel is the angle itself, rad.
    pub is_angle: bool,
    pub noise: f64,
    pub duration_s: f64,
    pub mode: Pole,
    /// What else moves.
    pub others: &'a [Pole],
}

/// Means of a third of the windows.
struct Third {
    amplitude_deg: f64,
    measured: f64,
    simulated: f64,
    u: f64,
}

type Pair = (WindowPoint, WindowPoint);

impl Seen<'_> {
    /// All that the simulation gets wrong of it.
    pub fn findings(&self) -> Vec<Discrepancy> {
        let mut pairs = self.pairs();
        pairs.sort_by(|a, b| b.0.amplitude.total_cmp(&a.0.amplitude));
        let thirds = |figure: &dyn Fn(&WindowPoint) -> (f64, f64)| self.thirds(&pairs, figure);
        let period = thirds(&|p| (p.period_s, p.period_se_s)).and_then(|t| self.period(&t));
        let decay = thirds(&|p| (100.0 * p.decrement, 100.0 * p.decrement_se));
        period
            .into_iter()
            .chain(decay.and_then(|t| self.decay(&t)))
            .chain(self.against_phase())
            .collect()
    }

    /// Windows through the record, measured and simulated.
    fn pairs(&self) -> Vec<Pair> {
        let simulated = self.windows(self.simulated);
        let same = |m: &WindowPoint| {
            simulated
                .iter()
                .copied()
                .find(|s| (s.t_s - m.t_s).abs() < 1e-6 * self.duration_s)
        };
        self.windows(self.measured)
            .into_iter()
            .filter_map(|m| Some((m, same(&m)?)))
            .collect()
    }

    fn windows(&self, rates_rad_s: &[f64]) -> Vec<WindowPoint> {
        let group = ChannelGroup {
            t_s: self.t_s.to_vec(),
            channels: vec![rates_rad_s.to_vec()],
        };
        let wanted = WindowedMode {
            span_s: (0.0, self.duration_s),
            mode: self.mode,
            others: self.others,
            project: &[Complex64::new(1.0, 0.0)],
        };
        against_amplitude(&[group], &wanted)
    }

    fn period(&self, thirds: &[Third; 3]) -> Option<Discrepancy> {
        let (wide, narrow, sigma) = most_unlike(thirds)?;
        if wide.amplitude_deg < GROWN * narrow.amplitude_deg {
            return None;
        }
        let growth = |of: &dyn Fn(&Third) -> f64| 100.0 * (of(wide) / of(narrow) - 1.0);
        let (measured, simulated) = (growth(&|t| t.measured), growth(&|t| t.simulated));
        let u = 100.0 * wide.u.hypot(narrow.u) / narrow.measured;
        let [size, its_u, other] = with_digits_of(u, [measured, u, simulated]).map(words::written);
        let said = words::message(
            "growth",
            [
                ("swing", words::id(self.swing)),
                ("from_deg", words::number(narrow.amplitude_deg, 1)),
                ("to_deg", words::number(wide.amplitude_deg, 1)),
                ("motion", words::motion(self.motion)),
                ("measured", size),
                ("u", its_u),
                ("simulated", other),
            ],
        );
        Some(Discrepancy::of(
            self.swing,
            DiscrepancyKind::PeriodVsAmplitude,
            (measured - simulated, UnitName::Percent),
            sigma,
            said,
        ))
    }

    fn decay(&self, thirds: &[Third; 3]) -> Option<Discrepancy> {
        let (wide, narrow, sigma) = most_unlike(thirds)?;
        let loss = |t: &Third| {
            let written = with_digits_of(t.u, [t.measured, t.u, t.simulated]).map(words::written);
            let [measured, u, simulated] = written;
            let amplitude_deg = words::number(t.amplitude_deg, 1);
            words::message(
                "loss",
                [
                    ("measured", measured),
                    ("u", u),
                    ("simulated", simulated),
                    ("amplitude_deg", amplitude_deg),
                ],
            )
        };
        let size = (wide.measured - wide.simulated) - (narrow.measured - narrow.simulated);
        let said = words::message(
            "decay",
            [
                ("swing", words::id(self.swing)),
                ("motion", words::motion(self.motion)),
                ("losses", Argument::Texts(thirds.iter().map(loss).collect())),
            ],
        );
        Some(Discrepancy::of(
            self.swing,
            DiscrepancyKind::DecayVsAmplitude,
            (size, UnitName::Percent),
            sigma,
            said,
        ))
    }

    /// The widest, the middle and the narrowest third; `None` with fewer than three windows.
    fn thirds(
        &self,
        pairs: &[Pair],
        figure: &dyn Fn(&WindowPoint) -> (f64, f64),
    ) -> Option<[Third; 3]> {
        let size = pairs.len() / 3;
        if size == 0 {
            return None;
        }
        let angle = |m: &WindowPoint| match self.is_angle {
            true => m.amplitude,
            false => m.amplitude_over_omega(),
        };
        let third = |part: &[Pair]| {
            let weight = |pair: &Pair| figure(&pair.0).1.max(f64::MIN_POSITIVE).powi(-2);
            let sum: f64 = part.iter().map(weight).sum();
            let mean = |of: &dyn Fn(&Pair) -> f64| {
                part.iter().map(|pair| of(pair) * weight(pair)).sum::<f64>() / sum
            };
            Third {
                amplitude_deg: mean(&|(m, _)| angle(m).to_degrees()),
                measured: mean(&|(m, _)| figure(m).0),
                simulated: mean(&|(_, s)| figure(s).0),
                u: sum.sqrt().recip(),
            }
        };
        Some(
            [
                &pairs[..size],
                &pairs[size..pairs.len() - size],
                &pairs[pairs.len() - size..],
            ]
            .map(third),
        )
    }

    /// Whether more is left where the body passes its middle, or where it turns round.
    fn against_phase(&self) -> Option<Discrepancy> {
        let half_s = 0.5 * std::f64::consts::TAU / self.mode.omega_rad_s;
        let (mut sums, mut counts) = ([0.0; 2], [0.0; 2]);
        let mut from = 0;
        while from < self.t_s.len() {
            let to = self
                .t_s
                .partition_point(|t| *t < self.t_s[from] + half_s)
                .max(from + 1);
            let highest = self.simulated[from..to]
                .iter()
                .fold(0.0, |most: f64, r| most.max(r.abs()));
            for i in from..to {
                // A body is fast in its middle, and wide where it turns round.
                let is_high = self.simulated[i].abs() > MIDDLE * highest;
                let k = usize::from(is_high != self.is_angle);
                sums[k] += ((self.measured[i] - self.simulated[i]) / self.noise).powi(2);
                counts[k] += 1.0;
            }
            from = to;
        }
        if counts.iter().any(|count| *count < FEWEST) {
            return None;
        }
        let [ends, middle] = [0, 1].map(|k| sums[k] / counts[k]);
        // The variance of a squared normal variable is twice the square of its mean.
        let u = [0, 1].map(|k| [ends, middle][k] * (2.0 / counts[k]).sqrt());
        let sigma = (ends - middle).abs() / u[0].hypot(u[1]);
        (sigma > TOLD).then(|| {
            let said = words::message(
                if ends > middle {
                    "at_ends"
                } else {
                    "at_middle"
                },
                [
                    ("swing", words::id(self.swing)),
                    ("motion", words::motion(self.motion)),
                    ("more", words::number(ends.max(middle).sqrt(), 2)),
                    ("less", words::number(ends.min(middle).sqrt(), 2)),
                ],
            );
            Discrepancy::of(
                self.swing,
                DiscrepancyKind::ResidualVsPhase,
                (ends.sqrt() - middle.sqrt(), UnitName::One),
                sigma,
                said,
            )
        })
    }
}

/// The two thirds, the wider first, between which measured less simulated changes most, and by how
/// many standard uncertainties; `None` where that is chance.
fn most_unlike(thirds: &[Third; 3]) -> Option<(&Third, &Third, f64)> {
    let off = |t: &Third| t.measured - t.simulated;
    let pairs = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| (&thirds[i], &thirds[j]));
    let unlike = pairs.map(|(a, b)| (a, b, (off(a) - off(b)).abs() / a.u.hypot(b.u)));
    unlike
        .into_iter()
        .max_by(|a, b| a.2.total_cmp(&b.2))
        .filter(|(.., sigma)| *sigma > TOLD)
}

/// Figures with two digits of an uncertainty.
fn with_digits_of(u: f64, figures: [f64; 3]) -> [String; 3] {
    let decimals = (1.0 - u.log10().floor()).clamp(0.0, 9.0) as usize;
    figures.map(|x| format!("{x:.decimals$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OMEGA: f64 = 2.0;
    const ALPHA: f64 = 0.01;
    const START_RAD: f64 = 0.3;
    const NOISE: f64 = 1e-4;

    /// Rates of an oscillation that decays as e^{−αt} while ω = ω₀ (1 − softening A²), noise of a
    /// fixed pattern on top.
    fn rates(softening: f64, noise: f64, t_s: &[f64]) -> Vec<f64> {
        let rate = |(i, t): (usize, &f64)| {
            let left = (-2.0 * ALPHA * t).exp();
            let phase =
                OMEGA * t - OMEGA * softening * START_RAD.powi(2) * (1.0 - left) / (2.0 * ALPHA);
            // Hashed by a product with the golden ratio: uniform, variance 1/12.
            let chance = ((i as f64 * 0.618_033_988_749_895).fract() * 7919.0).fract() - 0.5;
            OMEGA * START_RAD * left.sqrt() * phase.cos() + noise * 12f64.sqrt() * chance
        };
        t_s.iter().enumerate().map(rate).collect()
    }

    fn findings(softening: f64, simulated: f64) -> Vec<Discrepancy> {
        let t_s: Vec<f64> = (0..12000).map(|i| 0.01 * f64::from(i)).collect();
        let seen = Seen {
            swing: "s",
            motion: ModeName::Yaw,
            t_s: &t_s,
            measured: &rates(softening, NOISE, &t_s),
            simulated: &rates(simulated, 0.0, &t_s),
            is_angle: false,
            noise: NOISE,
            duration_s: 120.0,
            mode: Pole {
                omega_rad_s: OMEGA,
                alpha_per_s: ALPHA,
            },
            others: &[],
        };
        seen.findings()
    }

    #[test]
    fn the_period_s_growth_is_told_at_its_amplitudes() {
        let all = findings(1.0 / 16.0, 0.0);
        let told = all
            .iter()
            .find(|d| d.what == DiscrepancyKind::PeriodVsAmplitude)
            .unwrap();
        let amplitudes: Vec<f64> = told
            .message
            .english
            .split_whitespace()
            .filter_map(|word| word.strip_suffix('°')?.parse::<f64>().ok())
            .map(f64::to_radians)
            .collect();
        // T = T₀ (1 + A²/16 + …).
        let expected = 100.0 * (amplitudes[1].powi(2) - amplitudes[0].powi(2)) / 16.0;
        assert!(
            amplitudes[1] > 2.0 * amplitudes[0],
            "{}",
            told.message.english
        );
        assert!(
            (told.size / expected - 1.0).abs() < 0.05,
            "{} against {expected}",
            told.message.english
        );
    }

    #[test]
    fn nothing_is_told_of_what_is_simulated() {
        let all = findings(1.0 / 16.0, 1.0 / 16.0);
        assert!(all.is_empty(), "{all:?}");
    }

    /// A motion faster than the samples shows its middle alone.
    #[test]
    fn nothing_is_told_of_a_place_that_no_sample_shows() {
        let t_s: Vec<f64> = (0..1000).map(|i| 0.01 * f64::from(i)).collect();
        let measured: Vec<f64> = (0..1000)
            .map(|i| if i % 2 == 0 { NOISE } else { -NOISE })
            .collect();
        let seen = Seen {
            swing: "s",
            motion: ModeName::PitchInPhase,
            t_s: &t_s,
            measured: &measured,
            simulated: &vec![1.0; 1000],
            is_angle: false,
            noise: NOISE,
            duration_s: 10.0,
            mode: Pole {
                omega_rad_s: 500.0,
                alpha_per_s: ALPHA,
            },
            others: &[],
        };
        assert!(seen.against_phase().is_none());
    }

    #[test]
    fn a_lag_is_left_where_the_rate_changes_fastest() {
        let all = findings(0.0, 1e-3 / 16.0);
        let told = all
            .iter()
            .find(|d| d.what == DiscrepancyKind::ResidualVsPhase)
            .unwrap();
        assert!(
            told.message.english.contains("turns round"),
            "{}",
            told.message.english
        );
    }
}
