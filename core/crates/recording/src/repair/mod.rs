//! What is wrong with a sensor's samples, and what the analysis leaves out for it.
//!
//! Nothing is resampled: a sample is kept or left out, and every sample left out and every gap is
//! listed. Stamps are used as they stand, but for those that packets share, which are spread. The
//! file itself is never changed.

mod absent;
mod findings;
mod saturation;
mod series;
mod stamps;

pub use findings::MISSING_INTERVALS;
pub use saturation::{CUT_STEPS, RUN_SAMPLES, RUNS, STATED_RANGE};
pub(crate) use series::RawSeries;
pub use stamps::median_interval_s;

use super::domain::MOST;
use super::samples::{Repair, RepairKind};
use gyradius_base::{Error, Result};
use series::Fates;

/// A clock that is set back, once or twice, makes two or three stretches.
const MOST_PIECES: usize = 4;

/// What is left of a series, with the list of what is not.
#[derive(Debug, Clone, Default)]
pub(crate) struct Repaired {
    /// Strictly increasing time stamps, s.
    pub t_s: Vec<f64>,
    /// Finite samples by channel.
    pub channels: Vec<Vec<f64>>,
    /// Everything left out, and every gap.
    pub repairs: Vec<Repair>,
    /// Stamps of the samples left out at the sensor's limit, s.
    pub at_limit_s: Vec<f64>,
}

/// Whether a series is a sampled signal, whose gaps and jitter mean something, or a list of events.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sampling {
    /// Samples at a rate.
    Regular,
    /// Events at their own times.
    Events,
}

/// Repairs the series of one file. Where the file holds two recordings one after the other, the
/// rows of the longer one are kept for every sensor.
pub(crate) fn repair_file(
    series: Vec<RawSeries>,
    file: &str,
    sampling: Sampling,
) -> Result<Vec<Repaired>> {
    for raw in &series {
        refuse_reversed(raw, file)?;
        if sampling == Sampling::Regular {
            refuse_shuffled(raw, file)?;
        }
    }
    let mut series = series;
    let shared: Vec<usize> = match sampling {
        Sampling::Regular => series.iter_mut().map(stamps::spread_shared).collect(),
        Sampling::Events => vec![0; series.len()],
    };
    let windows: Vec<stamps::Window> = series
        .iter()
        .map(|raw| window(&series, raw.table))
        .collect();
    Ok(series
        .into_iter()
        .zip(windows)
        .zip(shared)
        .map(|((raw, window), shared)| repair(raw, &window, shared, sampling))
        .collect())
}

/// Rows to keep of one table, decided by its densest sensor.
fn window(series: &[RawSeries], table: usize) -> stamps::Window {
    let densest = series
        .iter()
        .filter(|raw| raw.table == table)
        .max_by_key(|raw| raw.t_s.len());
    densest.map_or_else(stamps::Window::default, stamps::window)
}

fn repair(raw: RawSeries, window: &stamps::Window, shared: usize, sampling: Sampling) -> Repaired {
    let mut fates: Fates = vec![None; raw.t_s.len()];
    stamps::judge(&raw, window, &mut fates);
    let mut repairs = Vec::new();
    if sampling == Sampling::Regular {
        repairs = findings::gaps_and_jitter(raw.sensor, &kept(&raw.t_s, &fates));
    }
    for channel in &raw.channels {
        for (fate, value) in fates.iter_mut().zip(channel) {
            // Beyond all that a sensor reads it is a damaged cell.
            if !value.is_finite() || value.abs() > MOST {
                fate.get_or_insert(RepairKind::NotANumber);
            }
        }
    }
    if sampling == Sampling::Regular {
        absent::judge(&raw, &mut fates);
    }
    saturation::judge(&raw, &mut fates);
    repairs.extend(findings::left_out(&raw, &fates));
    repairs.extend(findings::shared_stamps(&raw, shared));
    repairs.sort_by_key(|repair| repair.kind);
    let channels = raw
        .channels
        .iter()
        .map(|channel| kept(channel, &fates))
        .collect();
    let at_limit_s = raw
        .t_s
        .iter()
        .zip(&fates)
        .filter(|(_, fate)| **fate == Some(RepairKind::Saturation))
        .map(|(t_s, _)| *t_s)
        .collect();
    Repaired {
        t_s: kept(&raw.t_s, &fates),
        channels,
        repairs,
        at_limit_s,
    }
}

/// Many stretches that have each their own time are one recording whose rows are out of order: to keep
/// the longest would be to keep a small part.
fn refuse_shuffled(raw: &RawSeries, file: &str) -> Result<()> {
    match stamps::pieces_out_of_order(&raw.t_s) {
        0..MOST_PIECES => Ok(()),
        pieces => Err(Error::Malformed {
            file: file.to_owned(),
            line: None,
            expected: "rows in the order of time; sort them by it".to_owned(),
            found: format!(
                "{pieces} pieces of the {}, each with its own time, in another order",
                raw.sensor.name()
            ),
        }),
    }
}

fn kept(values: &[f64], fates: &Fates) -> Vec<f64> {
    values
        .iter()
        .zip(fates)
        .filter(|(_, fate)| fate.is_none())
        .map(|(value, _)| *value)
        .collect()
}

/// A file that runs backwards as a whole is a mistake of whoever wrote it, not damage.
fn refuse_reversed(raw: &RawSeries, file: &str) -> Result<()> {
    let back = raw.t_s.windows(2).filter(|pair| pair[1] < pair[0]).count();
    if raw.t_s.len() < 2 || 2 * back < raw.t_s.len() {
        return Ok(());
    }
    Err(Error::Malformed {
        file: file.to_owned(),
        line: None,
        expected: "time that runs forwards".to_owned(),
        found: format!(
            "{back} of {} steps of the {} backwards",
            raw.t_s.len() - 1,
            raw.sensor.name()
        ),
    })
}
