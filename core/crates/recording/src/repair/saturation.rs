//! Samples at the limit of a sensor's range.
//!
//! A stated range decides by itself. Without one, a channel is taken as clipped where it stays at
//! exactly its extreme value for several samples, several times over, and comes and goes in steps
//! that are large against the sensor's resolution: a slow signal of coarse resolution rests at its
//! peaks too, but one step below is where it comes from.

use super::series::{Fates, RawSeries};
use crate::samples::RepairKind;

/// Samples that must stay at the extreme in one go …
pub const RUN_SAMPLES: usize = 3;
/// … and how often, before the extreme counts as a limit.
pub const RUNS: usize = 2;
/// Mean step into and out of a run, in steps of resolution, above which the signal was cut off.
pub const CUT_STEPS: f64 = 3.0;
/// A sample above this part of a stated range is at its limit: 2000 °/s are stated, 1999.9 °/s
/// written.
pub const STATED_RANGE: f64 = 0.999;

/// Marks the samples that are at a limit.
pub(super) fn judge(raw: &RawSeries, fates: &mut Fates) {
    let left: Vec<usize> = (0..fates.len()).filter(|&i| fates[i].is_none()).collect();
    for channel in &raw.channels {
        let values: Vec<f64> = left.iter().map(|&i| channel[i]).collect();
        let stated = raw.limit.map(|limit| STATED_RANGE * limit.abs());
        let (low, high) = match stated {
            Some(limit) => (-limit, limit),
            None => observed_limits(&values),
        };
        for (&i, &value) in left.iter().zip(&values) {
            if value <= low || value >= high {
                fates[i].get_or_insert(RepairKind::Saturation);
            }
        }
    }
}

/// The limits that the samples themselves show, each side by itself (an offset or a converter may
/// cut one side alone); infinite where they show none.
fn observed_limits(values: &[f64]) -> (f64, f64) {
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let size = highest.abs().max(lowest.abs());
    let mut steps = Vec::new();
    let mut runs = |extreme: f64| match extreme != 0.0 && lowest < highest {
        true => runs_at(values, extreme, &mut steps),
        false => 0,
    };
    let (low_runs, high_runs) = (runs(lowest), runs(highest));
    let all = low_runs + high_runs;
    let mean_step = steps.iter().sum::<f64>() / steps.len().max(1) as f64;
    let cut = mean_step > CUT_STEPS * resolution(values, size);
    if all < RUNS || !cut || held_runs(values, (lowest, highest)) > all {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    let low = if low_runs > 0 {
        lowest
    } else {
        f64::NEG_INFINITY
    };
    let high = if high_runs > 0 {
        highest
    } else {
        f64::INFINITY
    };
    (low, high)
}

/// Counts the runs at `extreme` and collects the steps by which the signal enters and leaves them.
fn runs_at(values: &[f64], extreme: f64, steps: &mut Vec<f64>) -> usize {
    let mut runs = 0;
    let mut start = 0;
    while start < values.len() {
        let length = values[start..]
            .iter()
            .take_while(|&&v| v == extreme)
            .count();
        if length >= RUN_SAMPLES {
            runs += 1;
            let neighbours = [start.checked_sub(1), Some(start + length)];
            let outside = neighbours
                .into_iter()
                .flatten()
                .filter_map(|i| values.get(i));
            steps.extend(outside.map(|v| (v - extreme).abs()));
        }
        start += length.max(1);
    }
    runs
}

/// Runs short of the extremes, which only a channel shows that holds its value over several rows.
fn held_runs(values: &[f64], (lowest, highest): (f64, f64)) -> usize {
    let inside = |v: f64| v != lowest && v != highest && v.abs() >= 0.5 * highest.max(-lowest);
    values
        .chunk_by(|a, b| a == b)
        .filter(|run| run.len() >= RUN_SAMPLES && inside(run[0]))
        .count()
}

/// The smallest step between neighbouring samples that a converter of 16 bits can make over
/// ±`size`; anything smaller is rounding.
fn resolution(values: &[f64], size: f64) -> f64 {
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    steps
        .filter(|step| *step > 1e-5 * size)
        .fold(f64::INFINITY, f64::min)
}
