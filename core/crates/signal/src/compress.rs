//! Samples gathered into short cells of time.
//!
//! Modes of a hull lie near 0.1–3 Hz, samples at 100 Hz: the mean over a cell of a 24th of a period
//! keeps all but 0.6 % of the information (1 − sinc²) and white noise stays white. Nothing is
//! resampled: each cell keeps the centroid and the variance of the stamps that really fell into it,
//! and the model is averaged over the same stamps (`z̄ = z(t̄)(1 + λ²m₂/2)`), so that the estimate
//! has no bias from it.
//!
//! # Conventions
//! Time inside the fit is `τ = (t − t_ref)/span`, in [0, 1]; frequencies and decays are per span.

use super::types::ChannelGroup;

/// The map between seconds and scaled time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    pub t_ref_s: f64,
    pub span_s: f64,
}

impl Clock {
    pub fn of(groups: &[ChannelGroup]) -> Self {
        let first = groups
            .iter()
            .filter_map(|g| g.t_s.first())
            .fold(f64::INFINITY, |a, &b| a.min(b));
        let last = groups
            .iter()
            .filter_map(|g| g.t_s.last())
            .fold(f64::NEG_INFINITY, |a, &b| a.max(b));
        Self {
            t_ref_s: first,
            span_s: last - first,
        }
    }

    pub fn tau(&self, t_s: f64) -> f64 {
        (t_s - self.t_ref_s) / self.span_s
    }
}

/// The cells of one group.
#[derive(Debug, Clone, Default)]
pub(super) struct Cells {
    /// Channels.
    pub channels: usize,
    /// First sample of each cell, and the end.
    pub start: Vec<usize>,
    /// Place of each cell on the grid of equal cells.
    pub slot: Vec<usize>,
    /// Samples in the cell.
    pub count: Vec<f64>,
    /// Centroid τ.
    pub tau: Vec<f64>,
    /// Variance of τ about the centroid.
    pub m2: Vec<f64>,
    /// Means, `channels` per cell.
    pub mean: Vec<f64>,
}

impl Cells {
    /// Cells of `width` (scaled time).
    pub fn gather(group: &ChannelGroup, clock: Clock, width: f64) -> Self {
        let mut cells = Self::bounds(group, clock, width);
        let bounds: Vec<(usize, usize)> = cells.start.windows(2).map(|w| (w[0], w[1])).collect();
        cells.mean = vec![0.0; bounds.len() * cells.channels];
        for (c, channel) in group.channels.iter().enumerate() {
            for (row, &(from, to)) in cells.mean.chunks_exact_mut(cells.channels).zip(&bounds) {
                row[c] = sum(&channel[from..to]) / (to - from) as f64;
            }
        }
        for (from, to) in bounds {
            cells.add_moments(&group.t_s[from..to], clock);
        }
        cells
    }

    /// The same with a level taken off each channel.
    pub fn less(mut self, levels: &[f64]) -> Self {
        for row in self.mean.chunks_exact_mut(levels.len()) {
            row.iter_mut()
                .zip(levels)
                .for_each(|(y, level)| *y -= level);
        }
        self
    }

    pub fn len(&self) -> usize {
        self.tau.len()
    }

    fn bounds(group: &ChannelGroup, clock: Clock, width: f64) -> Self {
        let scale = 1.0 / (width * clock.span_s);
        let (mut start, mut slot) = (Vec::new(), Vec::new());
        let mut last = usize::MAX;
        for (i, &t) in group.t_s.iter().enumerate() {
            let here = ((t - clock.t_ref_s) * scale) as usize;
            if here != last {
                start.push(i);
                slot.push(here);
                last = here;
            }
        }
        start.push(group.t_s.len());
        let channels = group.channels.len();
        Self {
            channels,
            start,
            slot,
            ..Self::default()
        }
    }

    fn add_moments(&mut self, stamps: &[f64], clock: Clock) {
        let n = stamps.len() as f64;
        let anchor = stamps[0];
        let (sum, squares) = stamps.iter().fold((0.0, 0.0), |(s, q), &t| {
            let d = t - anchor;
            (s + d, q + d * d)
        });
        let mean = sum / n;
        self.count.push(n);
        self.tau.push(clock.tau(anchor + mean));
        self.m2
            .push((squares / n - mean * mean).max(0.0) / (clock.span_s * clock.span_s));
    }
}

/// Sum in four strands, which need not wait for each other.
fn sum(values: &[f64]) -> f64 {
    let fours = values.chunks_exact(4);
    let rest: f64 = fours.remainder().iter().sum();
    let strands = fours.fold([0.0; 4], |s, v| {
        [s[0] + v[0], s[1] + v[1], s[2] + v[2], s[3] + v[3]]
    });
    rest + strands.iter().sum::<f64>()
}
