//! The cells' decomposition, read as one main motion and what swings beside it.

use std::f64::consts::{LN_2, TAU};

use super::forecast::time_left;
use super::spread::{Envelope, MainMode, Spread};
use super::state::{Line, LineKind, SwingState};
use crate::{ChannelGroup, DecomposeOptions, Decomposition, FittedMode, decompose, residuals};

/// Cycles of the main motion before anything is said of it.
const FEWEST_CYCLES: f64 = 4.0;
/// A fit that leaves more than this part of the main motion has not found what swings.
const MOST_MISFIT: f64 = 0.5;
/// Cosine between two axes of turn above which they are the same.
const SAME_AXIS: f64 = 0.7;

/// Which sensors the channels of a decomposition come from: three each, gyroscope first.
#[derive(Debug, Clone, Copy)]
struct Layout {
    gyroscope: bool,
    accelerometer: bool,
}

/// Reads the cells of a free swing of both sensors, either of which may be absent. None where there
/// is no swing yet.
pub(super) fn read(
    gyroscope: Option<ChannelGroup>,
    accelerometer: Option<ChannelGroup>,
    wanted: f64,
) -> Option<SwingState> {
    let both = gyroscope.is_some() && accelerometer.is_some();
    let alone = gyroscope.clone().filter(|_| both);
    read_of(gyroscope, accelerometer, wanted)
        .or_else(|| alone.and_then(|gyroscope| read_of(Some(gyroscope), None, wanted)))
}

fn read_of(
    gyroscope: Option<ChannelGroup>,
    accelerometer: Option<ChannelGroup>,
    wanted: f64,
) -> Option<SwingState> {
    let layout = Layout {
        gyroscope: gyroscope.is_some(),
        accelerometer: accelerometer.is_some(),
    };
    let groups: Vec<ChannelGroup> = gyroscope.into_iter().chain(accelerometer).collect();
    let found = decompose(&groups, &DecomposeOptions::default()).ok()?;
    swing(&found, &groups, layout, wanted)
}

/// Size of the motion that the fit leaves in the first sensor, over that of a mode: roots of their
/// energies.
fn misfit(
    found: &Decomposition,
    sensor: &ChannelGroup,
    mode: &FittedMode,
    envelope: Envelope,
) -> f64 {
    let left = residuals(std::slice::from_ref(sensor), found);
    let excess = |(channel, noise): (&Vec<f64>, &f64)| {
        channel.iter().map(|y| y * y).sum::<f64>() - channel.len() as f64 * noise * noise
    };
    let excess: f64 = left
        .iter()
        .flat_map(|group| &group.channels)
        .zip(&found.noise)
        .map(excess)
        .sum();
    let span_s = found.t_end_s - found.t_ref_s;
    let energy =
        0.5 * norm(mode, 0).powi(2) * envelope.mean_square(span_s) * sensor.t_s.len() as f64;
    (excess.max(0.0) / energy).sqrt()
}

fn swing(
    found: &Decomposition,
    groups: &[ChannelGroup],
    layout: Layout,
    wanted: f64,
) -> Option<SwingState> {
    let main = found.modes.iter().max_by(|a, b| {
        layout
            .turn_or_swing(a, found)
            .total_cmp(&layout.turn_or_swing(b, found))
    })?;
    let span_s = found.t_end_s - found.t_ref_s;
    if span_s * main.omega_rad_s < TAU * FEWEST_CYCLES {
        return None;
    }
    let law = &main.law;
    let envelope = Envelope {
        alpha_per_s: law.alpha_small_per_s,
        beta_per_s: law.beta_per_s,
    };
    let misfit = misfit(found, groups.first()?, main, envelope);
    if misfit > MOST_MISFIT {
        return None;
    }
    let mode = MainMode {
        omega_rad_s: main.omega_rad_s,
        omega_se_rad_s: main.omega_se_rad_s,
        envelope,
        angle_rad: layout.angle_rad(main, found),
        shift_rad_s: law.shift_rad_s,
        law_power: law.power,
        misfit,
    };
    let spread = Spread::of(&mode, span_s);
    let period_s = main.period_s();
    let decay_per_s = envelope.decay_per_s(span_s);
    Some(SwingState {
        from_s: found.t_ref_s,
        at_s: found.t_end_s,
        period_s,
        period_noise_u_s: period_s * spread.noise_rad_s(span_s) / main.omega_rad_s,
        period_u_s: period_s * spread.omega_u_rad_s(span_s) / main.omega_rad_s,
        amplitude_deg: layout
            .gyroscope
            .then(|| (layout.turn_rad(main) * envelope.at(span_s)).to_degrees()),
        decay_per_s,
        half_s: (decay_per_s > 0.0).then(|| LN_2 / decay_per_s),
        lines: lines(found, main, layout),
        time_left: time_left(&spread, main.omega_rad_s, span_s, wanted),
    })
}

/// What swings beside the main motion, largest first.
fn lines(found: &Decomposition, main: &FittedMode, layout: Layout) -> Vec<Line> {
    let angle = |mode: &FittedMode| layout.angle_rad(mode, found);
    let others = found
        .modes
        .iter()
        .filter(|other| !std::ptr::eq(*other, main));
    let mut lines: Vec<Line> = others
        .map(|other| Line {
            period_s: other.period_s(),
            share: angle(other) / angle(main),
            kind: layout.kind(other, main, found),
        })
        .collect();
    lines.sort_by(|a, b| b.share.total_cmp(&a.share));
    lines
}

impl Layout {
    /// Amplitude of the turn at the start, rad: rate over angular frequency.
    fn turn_rad(&self, mode: &FittedMode) -> f64 {
        if self.gyroscope {
            norm(mode, 0) / mode.omega_rad_s
        } else {
            0.0
        }
    }

    /// Angle of the lines that a swing without turning would have, rad: a pendulum's force is g
    /// times its angle.
    fn lines_rad(&self, mode: &FittedMode, found: &Decomposition) -> f64 {
        let first = if self.gyroscope { 3 } else { 0 };
        let gravity = found
            .level
            .iter()
            .skip(first)
            .map(|level| level * level)
            .sum::<f64>()
            .sqrt();
        if self.accelerometer && gravity > 0.0 {
            norm(mode, first) / gravity
        } else {
            0.0
        }
    }

    fn angle_rad(&self, mode: &FittedMode, found: &Decomposition) -> f64 {
        self.turn_rad(mode).max(self.lines_rad(mode, found))
    }

    /// What the main motion is chosen by: the turn, where a gyroscope sees turns.
    fn turn_or_swing(&self, mode: &FittedMode, found: &Decomposition) -> f64 {
        if self.gyroscope {
            self.turn_rad(mode)
        } else {
            self.lines_rad(mode, found)
        }
    }

    fn kind(&self, mode: &FittedMode, main: &FittedMode, found: &Decomposition) -> LineKind {
        if self.lines_rad(mode, found) > self.turn_rad(mode) {
            return LineKind::Sway;
        }
        let dot: num_complex::Complex64 =
            (0..3).map(|c| mode.shape[c] * main.shape[c].conj()).sum();
        let cosine = dot.norm() / (norm(mode, 0) * norm(main, 0));
        if cosine > SAME_AXIS {
            LineKind::SameTurn
        } else {
            LineKind::OtherTurn
        }
    }
}

/// Size of a mode in three channels.
fn norm(mode: &FittedMode, first: usize) -> f64 {
    mode.shape
        .iter()
        .skip(first)
        .take(3)
        .map(|a| a.norm_sqr())
        .sum::<f64>()
        .sqrt()
}
