//! The beat of yaw against sway, counted in the record itself (eqs. 9–13).

use gyradius_recording::{ModeName, Quantity};
use gyradius_signal::{FittedMode, beat_count};

use super::measurement::SwingResult;
use super::observe::Evidence;

/// Other motions above this share of the weaker of the two spoil the envelope's minima.
const MOST_DISTURBANCE: f64 = 0.2;
/// The weaker motion over the stronger, below which no channel is worth counting in.
const LEAST_BALANCE: f64 = 0.15;

/// Oscillations per beat, and what (13) needs beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CountedBeat {
    /// n.
    pub count: Quantity,
    /// Whether the yaw is the slower of the two, as the fitted periods say.
    pub yaw_is_slower: bool,
    /// Ratio of yaw to sway period at small amplitude over that ratio as swung.
    pub small_over_observed: f64,
}

/// Counts in the channel that shows yaw and sway most alike; none where no channel beats.
pub fn counted(evidence: &Evidence, result: &SwingResult) -> Option<CountedBeat> {
    let place = |name: ModeName| evidence.named.iter().position(|n| n.name == name);
    let (yaw, sway) = (place(ModeName::Yaw)?, place(ModeName::Sway)?);
    let modes = &evidence.found.modes;
    let channels = 0..modes[yaw].shape.len();
    let balanced = |c: &usize| balance(modes, (yaw, sway), *c);
    let best = channels.max_by(|a, b| balanced(a).total_cmp(&balanced(b)))?;
    if balanced(&best) < LEAST_BALANCE {
        return None;
    }
    let (t_s, x) = channel(evidence, best)?;
    let beat = beat_count(t_s, x).ok()?;
    // The swing's modes are not the lines of its spectrum: where the simulation explains it, they
    // are the simulation's.
    let small_over_observed = |name: ModeName| {
        let mode = result.modes.iter().find(|mode| mode.mode == name)?;
        Some(mode.period_s / mode.period_observed_s)
    };
    Some(CountedBeat {
        count: Quantity::new(beat.n, beat.n_u),
        yaw_is_slower: modes[yaw].period_s() > modes[sway].period_s(),
        small_over_observed: small_over_observed(ModeName::Yaw)?
            / small_over_observed(ModeName::Sway)?,
    })
}

/// The weaker of the two motions over the stronger in a channel; 0 where others disturb.
fn balance(modes: &[FittedMode], (yaw, sway): (usize, usize), channel: usize) -> f64 {
    let size = |i: usize| modes[i].shape[channel].norm();
    let (weak, strong) = (size(yaw).min(size(sway)), size(yaw).max(size(sway)));
    let others: f64 = (0..modes.len())
        .filter(|i| *i != yaw && *i != sway)
        .map(size)
        .sum();
    if others > MOST_DISTURBANCE * weak || strong == 0.0 {
        0.0
    } else {
        weak / strong
    }
}

/// Times and samples of a channel, counted through all groups.
fn channel(evidence: &Evidence, index: usize) -> Option<(&[f64], &[f64])> {
    let mut first = 0;
    for group in &evidence.groups {
        if let Some(samples) = group.channels.get(index - first) {
            return Some((&group.t_s, samples));
        }
        first += group.channels.len();
    }
    None
}
