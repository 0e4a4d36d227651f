//! Periodograms of cell residuals, and the public amplitude spectrum.
//!
//! # Conventions
//! Frequency is `k`, in cycles per span. A power is scaled to the variance per sample: white noise
//! of standard deviation σ has the expectation σ² at every k, and fitting a line takes `2P` off the
//! sum of squares.

use num_complex::Complex64;
use rustfft::FftPlanner;

use super::basis::{Model, Walk};
use super::compress::{Cells, Clock};
use super::fit::Fit;
use super::types::{ChannelGroup, Spectrum};

/// Power of each channel on an even grid of frequencies.
#[derive(Debug, Clone)]
pub(super) struct Periodogram {
    /// Step in k.
    pub step: f64,
    /// Power by channel.
    pub power: Vec<Vec<f64>>,
}

impl Periodogram {
    pub fn len(&self) -> usize {
        self.power.first().map_or(0, Vec::len)
    }
}

/// Residual of every cell under a fit, by group, `channels` per cell.
pub(super) fn cell_residuals(fit: &Fit, groups: &[Cells]) -> Vec<Vec<f64>> {
    let mut first = 0;
    let mut all = Vec::new();
    for cells in groups {
        let coefficients = &fit.coefficients[first..first + cells.channels];
        all.push(group_residuals(&fit.model, coefficients, cells));
        first += cells.channels;
    }
    all
}

fn group_residuals(model: &Model, coefficients: &[Vec<f64>], cells: &Cells) -> Vec<f64> {
    let (mut walk, mut row) = (Walk::new(&model.modes), vec![0.0; model.linear()]);
    let mut out = Vec::with_capacity(cells.mean.len());
    for (i, values) in cells.mean.chunks_exact(cells.channels).enumerate() {
        model.linear_row(cells, i, &mut walk, &mut row);
        let fitted = |a: &Vec<f64>| row.iter().zip(a).map(|(x, a)| x * a).sum::<f64>();
        out.extend(values.iter().zip(coefficients).map(|(y, a)| y - fitted(a)));
    }
    out
}

/// Periodograms of cell values: cells stand on their grid, a missing cell counts nothing.
pub(super) fn periodogram(
    planner: &mut FftPlanner<f64>,
    groups: &[Cells],
    values: &[Vec<f64>],
    width: f64,
) -> Periodogram {
    let slots = groups
        .iter()
        .filter_map(|g| g.slot.last())
        .max()
        .map_or(1, |s| s + 1);
    let length = (2 * slots).next_power_of_two();
    let plan = planner.plan_fft_forward(length);
    let mut buffer = vec![Complex64::ZERO; length];
    let mut scratch = vec![Complex64::ZERO; plan.get_inplace_scratch_len()];
    let channels: Vec<Channel> = groups.iter().zip(values).flat_map(Channel::all).collect();
    let mut power = Vec::with_capacity(channels.len());
    for pair in channels.chunks(2) {
        buffer.fill(Complex64::ZERO);
        pair[0].each(|slot, value| buffer[slot].re = value);
        pair[1..]
            .iter()
            .for_each(|second| second.each(|slot, value| buffer[slot].im = value));
        plan.process_with_scratch(&mut buffer, &mut scratch);
        power.extend(unpaired(&buffer, pair));
    }
    Periodogram {
        step: 1.0 / (length as f64 * width),
        power,
    }
}

/// Cell values of one channel.
struct Channel<'a> {
    cells: &'a Cells,
    values: &'a [f64],
    channel: usize,
}

impl<'a> Channel<'a> {
    fn all((cells, values): (&'a Cells, &'a Vec<f64>)) -> impl Iterator<Item = Self> {
        (0..cells.channels).map(move |channel| Channel {
            cells,
            values,
            channel,
        })
    }

    /// Place on the grid and weighted value of each cell.
    fn each(&self, mut put: impl FnMut(usize, f64)) {
        let rows = self.values.chunks_exact(self.cells.channels);
        for ((slot, count), row) in self.cells.slot.iter().zip(&self.cells.count).zip(rows) {
            put(*slot, row[self.channel] * count);
        }
    }

    fn samples(&self) -> f64 {
        self.cells.count.iter().sum()
    }
}

/// Powers of two real channels that went through one complex transform.
fn unpaired(buffer: &[Complex64], pair: &[Channel]) -> Vec<Vec<f64>> {
    let half = buffer.len() / 2;
    let power = |(part, channel): (usize, &Channel)| {
        let scale = 0.25 / channel.samples();
        let sign = if part == 0 { 1.0 } else { -1.0 };
        let of = |plus: &Complex64, minus: &Complex64| {
            ((plus.re + sign * minus.re).powi(2) + (plus.im - sign * minus.im).powi(2)) * scale
        };
        let mut power = Vec::with_capacity(half);
        power.push(of(&buffer[0], &buffer[0]));
        let mirrored = buffer[half + 1..].iter().rev();
        power.extend(
            buffer[1..half]
                .iter()
                .zip(mirrored)
                .map(|(plus, minus)| of(plus, minus)),
        );
        power
    };
    pair.iter().enumerate().map(power).collect()
}

/// Amplitude spectrum of every channel, mean taken off, at most about 2000 points up to the Nyquist
/// frequency or 20 Hz; a point shows the largest amplitude among those it stands for.
pub fn spectrum(groups: &[ChannelGroup]) -> Spectrum {
    let groups: Vec<ChannelGroup> = groups.iter().filter(|g| g.t_s.len() > 3).cloned().collect();
    let clock = Clock::of(&groups);
    let Some(interval) = super::record::median_interval(&groups) else {
        return Spectrum::default();
    };
    if clock.span_s <= 0.0 {
        return Spectrum::default();
    }
    let width = interval.max(1.0 / 50.0) / clock.span_s;
    let cells: Vec<Cells> = groups
        .iter()
        .map(|g| Cells::gather(g, clock, width))
        .collect();
    let centred: Vec<Vec<f64>> = cells.iter().map(centred).collect();
    let spectrum = periodogram(&mut FftPlanner::new(), &cells, &centred, width);
    let top_hz = (0.5 / interval).min(20.0);
    let kept = ((top_hz * clock.span_s / spectrum.step) as usize).min(spectrum.len());
    let samples = cells
        .iter()
        .flat_map(|g| vec![g.count.iter().sum::<f64>(); g.channels]);
    let stride = kept.div_ceil(2000).max(1);
    let frequency = |block: usize| (block * stride) as f64 * spectrum.step / clock.span_s;
    Spectrum {
        freq_hz: (0..kept.div_ceil(stride)).map(frequency).collect(),
        amplitude: spectrum
            .power
            .iter()
            .zip(samples)
            .map(|(p, n)| thinned(&p[..kept], stride, n))
            .collect(),
    }
}

fn thinned(power: &[f64], stride: usize, samples: f64) -> Vec<f64> {
    let peak = |block: &[f64]| block.iter().copied().fold(0.0, f64::max);
    power
        .chunks(stride)
        .map(|block| 2.0 * (peak(block) / samples).sqrt())
        .collect()
}

fn centred(cells: &Cells) -> Vec<f64> {
    let total: f64 = cells.count.iter().sum();
    let mut sums = vec![0.0; cells.channels];
    for (row, n) in cells.mean.chunks_exact(cells.channels).zip(&cells.count) {
        sums.iter_mut().zip(row).for_each(|(s, y)| *s += n * y);
    }
    let rows = cells.mean.chunks_exact(cells.channels);
    rows.flat_map(|row| {
        row.iter()
            .zip(&sums)
            .map(|(y, s)| y - s / total)
            .collect::<Vec<_>>()
    })
    .collect()
}
