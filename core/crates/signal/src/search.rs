//! A fit in the making, the spectrum of its residual over the floor, and the strongest peak of
//! that.

use std::cell::RefCell;

use rustfft::FftPlanner;

use super::basis::Model;
use super::compress::Cells;
use super::fit::{Fit, project};
use super::floor::Floor;
use super::record::Record;
use super::spectrum::{Periodogram, cell_residuals, periodogram};
use super::types::DecomposeOptions;

/// Chance of one false line per record; the floor's own scatter is covered by [`FLOOR_MARGIN`].
const FALSE_ALARM: f64 = 1e-5;
/// Factor on the bound because the floor is itself estimated, to about a tenth.
const FLOOR_MARGIN: f64 = 1.2;
/// Cells for the mean and slope before there are modes.
const START_CELLS: f64 = 256.0;

/// A fit in the making.
pub(super) struct Search<'a> {
    pub record: &'a Record<'a>,
    pub options: &'a DecomposeOptions,
    /// Cells of the whole band, for spectra.
    band_cells: Vec<Cells>,
    band_width: f64,
    /// Cells of the fit.
    pub cells: Vec<Cells>,
    pub width: f64,
    pub fit: Fit,
    /// Transforms, planned once for each length.
    planner: RefCell<FftPlanner<f64>>,
    /// Largest decay over frequency of an oscillation.
    pub most_damping: f64,
    /// Bound on the whitened power of a line.
    pub bound: f64,
    /// Modes whose decay is held at zero because they would grow.
    pub held_growing: usize,
    /// Noise power of each channel at the top of the band.
    pub top_floor: Vec<f64>,
}

/// Whitened residual spectrum with its floors.
pub(super) struct Whitened {
    pub spectrum: Periodogram,
    pub floors: Vec<Floor>,
    /// Sum over channels of power over floor.
    pub sum: Vec<f64>,
}

/// A peak of the whitened residual spectrum: cycles per span, height, half-power width.
#[derive(Debug, Clone, Copy)]
pub(super) struct Peak {
    pub k: f64,
    pub power: f64,
    pub width: f64,
    /// Residual variance over the floor here, in the channel where it stands highest.
    pub over_floor: f64,
}

impl<'a> Search<'a> {
    pub fn new(
        record: &'a Record<'a>,
        options: &'a DecomposeOptions,
        most_damping: f64,
    ) -> Option<Self> {
        let band_width = record.band_width();
        let band_cells = record.gather(band_width);
        let model = Model {
            baseline: 2,
            ..Model::default()
        };
        let width = band_width.max(1.0 / START_CELLS);
        let cells = record.gather(width);
        let fit = project(&model, &cells)?;
        let bound = bound(record.channels(), 2.0 * (record.band.1 - record.band.0)) * FLOOR_MARGIN;
        let planner = RefCell::new(FftPlanner::new());
        Some(Self {
            record,
            options,
            band_cells,
            band_width,
            cells,
            width,
            fit,
            planner,
            most_damping,
            bound,
            held_growing: 0,
            top_floor: vec![],
        })
    }

    /// Residual spectrum of a fit over its floor, on the finer of the two sets of cells.
    pub fn whiten(&self, fit: &Fit) -> Whitened {
        let finer = if self.width < self.band_width {
            &self.cells
        } else {
            &self.band_cells
        };
        let width = self.width.min(self.band_width);
        Whitened::of(self.residual_spectrum(fit, finer, width), self.record.band)
    }

    /// Residual spectrum of a fit as far as the cells of the fit resolve it: beyond every mode.
    pub fn spectrum_about_modes(&self, fit: &Fit) -> Periodogram {
        self.residual_spectrum(fit, &self.cells, self.width)
    }

    fn residual_spectrum(&self, fit: &Fit, cells: &[Cells], width: f64) -> Periodogram {
        periodogram(
            &mut self.planner.borrow_mut(),
            cells,
            &cell_residuals(fit, cells),
            width,
        )
    }
}

impl Whitened {
    pub fn of(spectrum: Periodogram, band: (f64, f64)) -> Self {
        let floors = Floor::of(&spectrum, 1.0, band.1);
        let length = spectrum.len().min((band.1 / spectrum.step) as usize + 2);
        let mut sum = vec![0.0; length];
        let mut from = 0;
        while from < length {
            // The floor is smooth: neighbours share one value of it.
            let to = (from + 4.max(from / 32)).min(length);
            let k = 0.5 * (from + to - 1) as f64 * spectrum.step;
            for (power, floor) in spectrum.power.iter().zip(&floors) {
                let scale = 1.0 / floor.at(k);
                sum[from..to]
                    .iter_mut()
                    .zip(&power[from..to])
                    .for_each(|(s, p)| *s += p * scale);
            }
            from = to;
        }
        Self {
            spectrum,
            floors,
            sum,
        }
    }

    /// The same over each channel's mean power in place of its floor.
    pub fn over_mean_power(mut self) -> Self {
        self.sum.fill(0.0);
        for power in &self.spectrum.power {
            let power = &power[..self.sum.len()];
            let mean = power.iter().sum::<f64>() / power.len().max(1) as f64;
            self.sum
                .iter_mut()
                .zip(power)
                .for_each(|(s, p)| *s += p / mean.max(f64::MIN_POSITIVE));
        }
        self
    }

    fn index(&self, k: f64) -> usize {
        ((k / self.spectrum.step).round() as usize).min(self.sum.len().saturating_sub(1))
    }

    /// Largest whitened power between two frequencies.
    pub fn highest(&self, from: f64, to: f64) -> f64 {
        let (from, to) = (self.index(from), self.index(to));
        self.sum[from.min(to)..=to]
            .iter()
            .copied()
            .fold(0.0, f64::max)
    }

    /// The strongest peak of the band away from masked frequencies, with its half-power width.
    pub fn peak(&self, band: (f64, f64), masked: &[f64], fit: &Fit) -> Option<Peak> {
        let step = self.spectrum.step;
        let free = |j: &usize| masked.iter().all(|k| (*j as f64 * step - k).abs() > 1.5);
        let range = self.index(band.0)..=self.index(band.1);
        let top = range
            .filter(free)
            .max_by(|&a, &b| self.sum[a].total_cmp(&self.sum[b]))?;
        let power = self.sum[top];
        let above = self.sum[top..]
            .iter()
            .take_while(|&&s| s > 0.5 * power)
            .count();
        let below = self.sum[..top]
            .iter()
            .rev()
            .take_while(|&&s| s > 0.5 * power)
            .count();
        let centre = (above as f64 - 1.0 - below as f64) * 0.5;
        let shift = if above + below > 6 { 0.0 } else { centre };
        let k = (top as f64 + shift) * step;
        let over = self
            .floors
            .iter()
            .enumerate()
            .map(|(c, floor)| fit.variance(c) / floor.at(k));
        let over_floor = over.filter(|ratio| ratio.is_finite()).fold(1.0, f64::max);
        Some(Peak {
            k,
            power,
            width: (above + below) as f64 * step,
            over_floor,
        })
    }
}

/// Whitened power that the largest of `bins` noise bins of `channels` channels exceeds with
/// [`FALSE_ALARM`].
fn bound(channels: usize, bins: f64) -> f64 {
    let tail = |x: f64| {
        let (mut term, mut sum) = (1.0, 1.0);
        for j in 1..channels {
            term *= x / j as f64;
            sum += term;
        }
        -x + f64::ln(sum)
    };
    let wanted = (FALSE_ALARM / bins.max(1.0)).ln();
    let (mut low, mut high) = (0.0, 1000.0 + 4.0 * channels as f64);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if tail(middle) > wanted {
            low = middle
        } else {
            high = middle
        }
    }
    high
}
