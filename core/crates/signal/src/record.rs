//! What a record must have before anything can be looked for in it.

use std::f64::consts::TAU;

use super::compress::{Cells, Clock};
use super::types::{ChannelGroup, DecomposeOptions};
use gyradius_base::{Error, Result};

/// Fewest samples of a group.
const FEWEST_SAMPLES: usize = 16;
/// Fewest cycles of the lowest mode in the span.
const FEWEST_CYCLES: f64 = 1.5;
/// Most cycles of the highest frequency for each sample. A record without gaps has at most 0.45 (its
/// band ends there), one of which a third is recorded three times as many.
const MOST_CYCLES_PER_SAMPLE: f64 = 8.0;
/// Cells per period of the fastest line in the final fit: 1 − sinc² = 0.6 % of the information is
/// lost.
pub(super) const FINAL_CELLS: f64 = 24.0;
/// The same while searching: 3.3 % is lost.
pub(super) const SEARCH_CELLS: f64 = 10.0;

/// A record with its clock, the band to search, and the level taken off each channel beforehand.
pub(super) struct Record<'a> {
    pub groups: &'a [ChannelGroup],
    pub clock: Clock,
    /// Lowest and highest frequency of a mode, cycles per span.
    pub band: (f64, f64),
    /// First sample of each channel by group, taken off so that gravity does not cost digits.
    pub offsets: Vec<Vec<f64>>,
    /// Shortest median interval, scaled.
    interval: f64,
    /// Widest cells, scaled.
    widest: f64,
}

impl<'a> Record<'a> {
    pub fn new(groups: &'a [ChannelGroup], options: &DecomposeOptions) -> Result<Self> {
        groups.iter().try_for_each(check_group)?;
        let Some(interval_s) = median_interval(groups) else {
            return Err(no_result("there are no samples"));
        };
        let clock = Clock::of(groups);
        let band_hz = band_hz(options, clock.span_s, interval_s)?;
        check_span(groups, clock.span_s, band_hz.1)?;
        let band = (band_hz.0 * clock.span_s, band_hz.1 * clock.span_s);
        if band.0 < FEWEST_CYCLES * 0.999 {
            let reason = format!(
                "the lowest frequency asked for has fewer than {FEWEST_CYCLES} cycles in the span"
            );
            return Err(no_result(reason));
        }
        let offsets = groups
            .iter()
            .map(|g| g.channels.iter().map(|c| c[0]).collect())
            .collect();
        let interval = interval_s / clock.span_s;
        Ok(Self {
            groups,
            clock,
            band,
            offsets,
            interval,
            widest: f64::INFINITY,
        })
    }

    /// The same with a cell for every sample: what swings faster than the band must not pass for
    /// slower.
    pub fn by_sample(self) -> Self {
        Self {
            widest: self.interval,
            ..self
        }
    }

    /// Cells of a width, levels taken off.
    pub fn gather(&self, width: f64) -> Vec<Cells> {
        let gathered = self
            .groups
            .iter()
            .map(|group| Cells::gather(group, self.clock, width));
        gathered
            .zip(&self.offsets)
            .map(|(cells, offsets)| cells.less(offsets))
            .collect()
    }

    /// Width of cells for a fit whose fastest line is `omega`, with so many cells in its period.
    pub fn fit_width(&self, omega: f64, per_period: f64) -> f64 {
        (TAU / (per_period * omega))
            .max(self.interval)
            .min(self.widest)
    }

    /// Width of cells for the whole band: a quarter more than the sampling theorem asks for.
    pub fn band_width(&self) -> f64 {
        (1.0 / (2.5 * self.band.1))
            .max(self.interval)
            .min(self.widest)
    }

    pub fn channels(&self) -> usize {
        self.groups.iter().map(|g| g.channels.len()).sum()
    }
}

/// The shortest of the groups' median sampling intervals, s.
pub(super) fn median_interval(groups: &[ChannelGroup]) -> Option<f64> {
    groups
        .iter()
        .filter(|g| g.t_s.len() > 1)
        .map(group_interval)
        .min_by(f64::total_cmp)
}

fn group_interval(group: &ChannelGroup) -> f64 {
    // A thousand intervals spread over the record tell the rate; sorting all of them would cost
    // more than a fit.
    let stride = (group.t_s.len() / 1000).max(1);
    let mut gaps: Vec<f64> = group
        .t_s
        .windows(2)
        .step_by(stride)
        .map(|w| w[1] - w[0])
        .collect();
    let middle = gaps.len() / 2;
    *gaps.select_nth_unstable_by(middle, f64::total_cmp).1
}

fn band_hz(options: &DecomposeOptions, span_s: f64, interval_s: f64) -> Result<(f64, f64)> {
    if let Some((low, high)) = options.band_hz {
        if !(low > 0.0 && high > low && high.is_finite()) {
            return Err(Error::argument(
                "band_hz",
                "0 < lowest < highest",
                format!("{low}, {high}"),
            ));
        }
        return Ok((low.max(FEWEST_CYCLES / span_s), high.min(0.45 / interval_s)));
    }
    let band = (
        (FEWEST_CYCLES / span_s).max(0.02),
        (0.45 / interval_s).min(10.0),
    );
    if span_s * band.1 < 2.0 * FEWEST_CYCLES || band.0 >= band.1 {
        return Err(no_result(format!(
            "{span_s:.3} s are too short a span to hold an oscillation"
        )));
    }
    Ok(band)
}

/// Cells of the search, and with them time and memory, go with the span: it may not be out of
/// proportion to the samples.
fn check_span(groups: &[ChannelGroup], span_s: f64, highest_hz: f64) -> Result<()> {
    let samples: usize = groups.iter().map(|g| g.t_s.len()).sum();
    if span_s.is_finite() && span_s * highest_hz <= MOST_CYCLES_PER_SAMPLE * samples as f64 {
        return Ok(());
    }
    Err(no_result(format!(
        "{samples} samples are spread over {span_s:.0} s: most of the time has none"
    )))
}

fn check_group(group: &ChannelGroup) -> Result<()> {
    let samples = group.t_s.len();
    if group.channels.is_empty() || group.channels.iter().any(|c| c.len() != samples) {
        return Err(Error::argument(
            "groups",
            "channels as long as their time stamps",
            "another length",
        ));
    }
    if samples < FEWEST_SAMPLES {
        return Err(no_result(format!(
            "{samples} samples, at least {FEWEST_SAMPLES} are needed"
        )));
    }
    if group.t_s.windows(2).any(|w| w[1] <= w[0]) || group.t_s.iter().any(|t| !t.is_finite()) {
        return Err(Error::argument(
            "groups",
            "time stamps that increase",
            "stamps that do not",
        ));
    }
    if group
        .channels
        .iter()
        .any(|channel| channel.iter().any(|y| !y.is_finite()))
    {
        return Err(Error::argument(
            "groups",
            "finite samples",
            "NaN or infinity",
        ));
    }
    Ok(())
}

/// The error of a record that allows no result.
pub(super) fn no_result(reason: impl Into<String>) -> Error {
    Error::no_result("oscillations", reason)
}
