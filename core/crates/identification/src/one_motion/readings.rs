//! What a sensor reads of a turn about one axis.

use std::ops::Range;

use gyradius_base::frames::Vec3;
use gyradius_signal::{ChannelGroup, Decomposition, FittedMode, white_level};
use num_complex::Complex64;

use crate::modes::{CVec3, in_phase};
use crate::samples::{BLOCK_OF_PERIOD, blocks};

/// The readings along the axis of a swing.
#[derive(Debug, Clone)]
pub struct Readings {
    /// Times of the samples from the first, s.
    pub t_s: Vec<f64>,
    /// The readings.
    pub values: Vec<f64>,
    /// The blocks, as places of samples.
    pub blocks: Vec<Range<usize>>,
    /// White noise of a sample.
    pub noise: f64,
    /// What the damped oscillations leave for it.
    pub spectrum_noise: f64,
    /// Whether they are the angle (rad), not its rate (rad/s).
    pub is_angle: bool,
    /// Axis among the sensor's channels.
    pub axis: Vec3,
    /// The start by its clock, s.
    pub start_s: f64,
    /// Mean level of each channel.
    pub level: Vec3,
    /// Pole of the strongest line of the spectrum.
    pub pole: Complex64,
    /// What that line reads at the first sample.
    pub line: Complex64,
    /// Its place among the modes.
    pub mode: usize,
}

/// A record in which something turns.
#[derive(Debug, Clone, Copy)]
pub struct Turn<'a> {
    /// The channels of the sensor that tells it, by its axes.
    pub group: &'a ChannelGroup,
    /// The damped oscillations that were found; the channels of that sensor are the first ones.
    pub found: &'a Decomposition,
    /// Whether the sensor tells the angle (rad), not its rate (rad/s).
    pub is_angle: bool,
}

impl Turn<'_> {
    /// What a mode reads in the sensor's channels.
    pub fn shape<'a>(&self, mode: &'a FittedMode) -> &'a [Complex64] {
        &mode.shape[..self.group.channels.len().min(mode.shape.len())]
    }

    /// What a mode reads in all of them, unit of the readings.
    pub fn size(&self, mode: &FittedMode) -> f64 {
        let squares = self.shape(mode).iter().map(Complex64::norm_sqr);
        squares.sum::<f64>().sqrt()
    }

    /// Places of the modes that may be the swing, in the order in which they are tried: what turns
    /// widest, and where that is a drift, what the sensor reads most of.
    pub fn strongest(&self) -> Vec<usize> {
        let modes = &self.found.modes;
        let angle = |m: usize| match self.is_angle {
            true => self.size(&modes[m]),
            false => self.size(&modes[m]) / modes[m].undamped_omega_rad_s(),
        };
        let most =
            |of: &dyn Fn(usize) -> f64| (0..modes.len()).max_by(|a, b| of(*a).total_cmp(&of(*b)));
        let mut places: Vec<usize> = most(&angle).into_iter().collect();
        places.extend(most(&|m| self.size(&modes[m])));
        // Of a wide swing the lines of an overtone may cancel: then it is the slowest of what is as
        // large as the readings themselves.
        let square: f64 = self.group.channels.iter().map(|c| variance(c)).sum();
        let is_large = |m: &usize| self.size(&modes[*m]).powi(2) > square;
        let slowness = |m: &usize| -modes[*m].omega_rad_s;
        let large = (0..modes.len()).filter(is_large);
        places.extend(large.max_by(|a, b| slowness(a).total_cmp(&slowness(b))));
        let mut distinct: Vec<usize> = Vec::new();
        for place in places {
            if !distinct.contains(&place) {
                distinct.push(place);
            }
        }
        distinct
    }
}

impl Readings {
    /// Along the axis of a mode, within a part by the sensor's clock, s.
    pub fn of(turn: &Turn, (start_s, end_s): (f64, f64), mode: usize) -> Option<Self> {
        let strongest = turn.found.modes.get(mode)?;
        let shape = turn.shape(strongest);
        let vector = CVec3::from_fn(|c, _| shape.get(c).copied().unwrap_or_default());
        let axis = in_phase(&vector).try_normalize(f64::MIN_POSITIVE)?;
        let all = &turn.group.t_s;
        let used = all.partition_point(|t| *t < start_s)..all.partition_point(|t| *t <= end_s);
        let t_s: Vec<f64> = all.get(used.clone())?.iter().map(|t| t - start_s).collect();
        let along = |of: &dyn Fn(usize) -> f64| (0..shape.len()).map(|c| axis[c] * of(c)).sum();
        let noise = |c: usize| turn.found.noise.get(c).copied().unwrap_or_default();
        let square: f64 = (0..shape.len()).map(|c| (axis[c] * noise(c)).powi(2)).sum();
        let pole = Complex64::new(-strongest.alpha_per_s, strongest.omega_rad_s);
        let at_start = (pole * (start_s - turn.found.t_ref_s)).exp();
        let line: Complex64 = shape.iter().zip(axis.iter()).map(|(c, a)| c * *a).sum();
        let level = |c: usize| turn.found.level.get(c).copied().unwrap_or_default();
        let level = Vec3::from_fn(|c, _| if c < shape.len() { level(c) } else { 0.0 });
        Some(Self {
            values: used
                .map(|i| along(&|c| turn.group.channels[c][i]))
                .collect(),
            noise: Some(square.sqrt()).filter(|noise| *noise > 0.0)?,
            spectrum_noise: square.sqrt(),
            blocks: blocks(&t_s, strongest.period_s() * BLOCK_OF_PERIOD),
            t_s,
            is_angle: turn.is_angle,
            axis,
            start_s,
            level,
            pole,
            line: line * at_start,
            mode,
        })
    }

    /// Length of the record, s.
    pub fn duration_s(&self) -> f64 {
        self.t_s.last().copied().unwrap_or_default()
    }

    /// Blocks that begin within a part.
    pub fn blocks_to(&self, horizon_s: f64) -> &[Range<usize>] {
        let end = (self.blocks).partition_point(|block| self.t_s[block.start] <= horizon_s);
        &self.blocks[..end]
    }

    /// With no more noise than a motion leaves of them: what damped oscillations leave of a wide swing
    /// is none.
    pub fn quieter(mut self, left: &[f64]) -> Option<Self> {
        self.noise = Some(white_level(left).min(self.noise)).filter(|n| *n > 0.0)?;
        Some(self)
    }

    /// Mean of a figure over a block.
    pub fn mean(block: &Range<usize>, at: impl Fn(usize) -> f64) -> f64 {
        block.clone().map(at).sum::<f64>() / block.len() as f64
    }
}

/// Mean square about the mean.
pub fn variance(channel: &[f64]) -> f64 {
    let count = channel.len().max(1) as f64;
    let mean = channel.iter().sum::<f64>() / count;
    channel.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / count
}
