//! A decomposition turned back into samples: for plots, residuals and criticism.

use num_complex::Complex64;

use super::basis::{Model, Walk, legendre};
use super::compress::Clock;
use super::motion::{Law, Motion};
use super::types::{ChannelGroup, Decomposition, FittedMode};

/// Values of all channels at given times: `values[channel][time]`, channels counted through all
/// groups.
pub fn model(t_s: &[f64], decomposition: &Decomposition) -> Vec<Vec<f64>> {
    let channels = 0..decomposition.baseline.len();
    evaluate(t_s, decomposition, channels)
}

/// What the model leaves of each group.
pub fn residuals(groups: &[ChannelGroup], decomposition: &Decomposition) -> Vec<ChannelGroup> {
    let mut first = 0;
    let mut left = Vec::with_capacity(groups.len());
    for group in groups {
        let last = (first + group.channels.len()).min(decomposition.baseline.len());
        let fitted = evaluate(&group.t_s, decomposition, first..last);
        first = last;
        let pairs = group.channels.iter().zip(fitted);
        let channels = pairs
            .map(|(y, fit)| y.iter().zip(fit).map(|(y, f)| y - f).collect())
            .collect();
        left.push(ChannelGroup {
            t_s: group.t_s.clone(),
            channels,
        });
    }
    left
}

fn evaluate(t_s: &[f64], found: &Decomposition, channels: std::ops::Range<usize>) -> Vec<Vec<f64>> {
    let clock = Clock {
        t_ref_s: found.t_ref_s,
        span_s: found.t_end_s - found.t_ref_s,
    };
    let rule = Model {
        modes: found
            .modes
            .iter()
            .map(|mode| motion(mode, clock.span_s))
            .collect(),
        tones: found
            .tones
            .iter()
            .map(|tone| tone.multiples.clone())
            .collect(),
        baseline: found.baseline.first().map_or(0, Vec::len),
    };
    let mut out = vec![Vec::with_capacity(t_s.len()); channels.len()];
    let mut walk = Walk::new(&rule.modes);
    let mut polynomials = vec![0.0; rule.baseline];
    for &t in t_s {
        let tau = clock.tau(t);
        walk.go_to(tau);
        legendre(tau, &mut polynomials);
        let atoms: Vec<Complex64> = (0..rule.atoms())
            .map(|k| rule.atom_at(k, &walk).1)
            .collect();
        for (values, c) in out.iter_mut().zip(channels.clone()) {
            let shapes = found
                .modes
                .iter()
                .map(|m| m.shape[c])
                .chain(found.tones.iter().map(|tone| tone.shape[c]));
            let swing: f64 = shapes.zip(&atoms).map(|(a, z)| (a * z).re).sum();
            let baseline: f64 = found.baseline[c]
                .iter()
                .zip(&polynomials)
                .map(|(a, p)| a * p)
                .sum();
            values.push(swing + baseline);
        }
    }
    out
}

fn motion(mode: &FittedMode, span_s: f64) -> Motion {
    let law = &mode.law;
    let of_amplitude = Law {
        shift: law.shift_rad_s * span_s,
        beta: law.beta_per_s * span_s,
        power: law.power,
    };
    Motion {
        omega: law.omega_small_rad_s * span_s,
        alpha: law.alpha_small_per_s * span_s,
        law: (law.power > 0).then_some(of_amplitude),
    }
}
