//! Weak damped oscillations that a record holds beside the swing: a rocking, a sway.

use gyradius_estimation::Parameter;
use gyradius_signal::{ChannelGroup, DecomposeOptions, Pole, decompose};

/// The logarithm of a line's frequency over that of the spectrum, its damping, and its amplitudes
/// (cosine, sine).
pub const LINE: usize = 4;
/// So many are fitted at most.
const MOST_LINES: usize = 4;
/// A line nearer to the swing's own frequencies than this, relative, is what the motion leaves of
/// itself; so is one nearer than the second to a multiple of them.
const OWN: f64 = 0.1;
const MULTIPLE: f64 = 0.03;
/// A line stays where the spectrum has it to this, relative: one that wandered to the swing's own
/// frequency would take a part of the swing.
const STAYS: f64 = 0.05;

/// A line where the spectrum has it.
#[derive(Debug, Clone)]
pub struct Line {
    omega_rad_s: f64,
    alpha_per_s: f64,
    amplitudes: [f64; 2],
}

impl Line {
    /// The lines of what a motion left of its readings, which has these frequencies, rad/s.
    pub fn beside(t_s: &[f64], left: Vec<f64>, own_rad_s: [f64; 2]) -> Vec<Self> {
        let group = ChannelGroup {
            t_s: t_s.to_vec(),
            channels: vec![left],
        };
        let Ok(found) = decompose(&[group], &DecomposeOptions::default()) else {
            return vec![];
        };
        let others = (found.modes.iter()).filter(|mode| !is_own(mode.omega_rad_s, own_rad_s));
        let lines = others.take(MOST_LINES).filter_map(|mode| {
            let at_start = mode.shape.first()?;
            Some(Self {
                omega_rad_s: mode.omega_rad_s,
                alpha_per_s: mode.alpha_per_s.max(0.0),
                amplitudes: [at_start.re, -at_start.im],
            })
        });
        lines.collect()
    }

    /// Where a fit begins.
    pub fn start(&self) -> [f64; LINE] {
        [
            0.0,
            self.alpha_per_s,
            self.amplitudes[0],
            self.amplitudes[1],
        ]
    }

    /// Priors and bounds.
    pub fn parameters(&self) -> [Parameter; LINE] {
        let damping = Parameter {
            low: 0.0,
            ..Parameter::FREE.with_prior(self.alpha_per_s, OWN * self.omega_rad_s)
        };
        let size = self.amplitudes[0].hypot(self.amplitudes[1]);
        let amplitude = |mean: f64| Parameter::FREE.with_prior(mean, size);
        let frequency = Parameter::FREE.with_prior(0.0, STAYS).within(-STAYS, STAYS);
        [
            frequency,
            damping,
            amplitude(self.amplitudes[0]),
            amplitude(self.amplitudes[1]),
        ]
    }

    fn omega_rad_s(&self, own: &[f64]) -> f64 {
        self.omega_rad_s * own[0].exp()
    }

    /// Poles of lines.
    pub fn poles(lines: &[Self], all: &[f64]) -> Vec<Pole> {
        let each = lines.iter().zip(all.chunks_exact(LINE));
        each.map(|(line, own)| Pole {
            omega_rad_s: line.omega_rad_s(own),
            alpha_per_s: own[1],
        })
        .collect()
    }

    /// What lines read at a time.
    pub fn sum(lines: &[Self], all: &[f64], t_s: f64) -> f64 {
        let each = lines.iter().zip(all.chunks_exact(LINE));
        each.map(|(line, own)| line.at(own, t_s)).sum()
    }

    fn at(&self, own: &[f64], t_s: f64) -> f64 {
        let (sin, cos) = (self.omega_rad_s(own) * t_s).sin_cos();
        (own[2] * cos + own[3] * sin) * (-own[1] * t_s).exp()
    }

    /// Derivatives by its numbers.
    pub fn slopes(&self, own: &[f64], t_s: f64) -> [f64; LINE] {
        let omega = self.omega_rad_s(own);
        let ((sin, cos), decay) = ((omega * t_s).sin_cos(), (-own[1] * t_s).exp());
        [
            omega * t_s * (own[3] * cos - own[2] * sin) * decay,
            -t_s * self.at(own, t_s),
            cos * decay,
            sin * decay,
        ]
    }
}

/// Whether a line is what a motion of these frequencies leaves of itself.
pub fn is_own(omega_rad_s: f64, [low, high]: [f64; 2]) -> bool {
    let is_near =
        |n: f64, by: f64| (n * low * (1.0 - by)..=n * high * (1.0 + by)).contains(&omega_rad_s);
    let multiple = (omega_rad_s / high).round().max(1.0);
    is_near(1.0, OWN) || is_near(multiple, MULTIPLE) || is_near(multiple + 1.0, MULTIPLE)
}
