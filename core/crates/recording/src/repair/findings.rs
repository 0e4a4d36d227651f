//! Gaps, jitter and left-out samples, counted, placed and put into a sentence.

use super::series::{Fates, RawSeries};
use super::stamps::median_interval_s;
use crate::samples::{Repair, RepairKind, Sensor};

/// An interval longer than this many median intervals means that a row is missing.
pub const MISSING_INTERVALS: f64 = 1.5;
/// … and longer than this, that the record stood still.
const STALL_INTERVALS: f64 = 10.0;
/// Intervals that scatter by more than this part of their median are reported as jitter.
const JITTER_FRACTION: f64 = 1.0 / 20.0;

/// What the accepted stamps show: gaps left as gaps, and scatter used as it stands.
pub(super) fn gaps_and_jitter(sensor: Sensor, t_s: &[f64]) -> Vec<Repair> {
    let Some(median) = median_interval_s(t_s) else {
        return Vec::new();
    };
    let name = sensor.name();
    let steps = || t_s.windows(2).map(|pair| (pair[0], pair[1] - pair[0]));
    let missing = |step: f64| step > MISSING_INTERVALS * median;
    let stall = |step: f64| step > STALL_INTERVALS * median;
    let long: Vec<(f64, f64)> = steps()
        .filter(|&(_, step)| missing(step) && !stall(step))
        .collect();
    let longest: Vec<(f64, f64)> = steps().filter(|&(_, step)| stall(step)).collect();
    let mut found = Vec::new();
    found.extend(gap_repair(
        RepairKind::MissingRows,
        sensor,
        &long,
        |n, worst| {
            format!("{name}: rows are missing in {n}, up to {worst:.3} s long; left as gaps")
        },
    ));
    found.extend(gap_repair(
        RepairKind::Stall,
        sensor,
        &longest,
        |n, worst| {
            format!("{name}: the record stood still in {n}, up to {worst:.3} s long; left as gaps")
        },
    ));
    let regular: Vec<(f64, f64)> = steps().filter(|&(_, step)| !missing(step)).collect();
    found.extend(jitter(sensor, median, &regular));
    found
}

fn gap_repair(
    kind: RepairKind,
    sensor: Sensor,
    gaps: &[(f64, f64)],
    sentence: impl Fn(String, f64) -> String,
) -> Option<Repair> {
    let (first, last) = (gaps.first()?, gaps.last()?);
    let worst = gaps.iter().map(|gap| gap.1).fold(0.0, f64::max);
    let text = sentence(counted(gaps.len(), "gap"), worst);
    Some(Repair {
        kind,
        sensor,
        count: gaps.len(),
        first_s: first.0,
        last_s: last.0,
        text,
    })
}

fn jitter(sensor: Sensor, median: f64, steps: &[(f64, f64)]) -> Option<Repair> {
    let n = steps.len() as f64;
    let mean = steps.iter().map(|step| step.1).sum::<f64>() / n;
    let sd = (steps
        .iter()
        .map(|step| (step.1 - mean).powi(2))
        .sum::<f64>()
        / n)
        .sqrt();
    if steps.len() < 2 || sd.is_nan() || sd <= JITTER_FRACTION * median {
        return None;
    }
    let off: Vec<f64> = steps
        .iter()
        .filter(|step| (step.1 - median).abs() > JITTER_FRACTION * median)
        .map(|step| step.0)
        .collect();
    let text = format!(
        "{}: time stamps scatter about their rate by {:.2} ms ({:.0} % of the interval); used as they stand",
        sensor.name(),
        1e3 * sd,
        100.0 * sd / median
    );
    Some(Repair {
        kind: RepairKind::Jitter,
        sensor,
        count: off.len(),
        first_s: *off.first()?,
        last_s: *off.last()?,
        text,
    })
}

/// Samples that share the stamp of their packet.
pub(super) fn shared_stamps(raw: &RawSeries, shared: usize) -> Option<Repair> {
    let last = raw.t_s.len().checked_sub(1).filter(|_| shared > 0)?;
    let own = raw.t_s.len() - shared;
    Some(Repair {
        kind: RepairKind::SharedStamps,
        sensor: raw.sensor,
        count: shared,
        first_s: time_near(&raw.t_s, 0),
        last_s: time_near(&raw.t_s, last),
        text: format!(
            "{}: {} samples share {own} stamps, {:.0} to a stamp; spread evenly from one stamp to the next",
            raw.sensor.name(),
            raw.t_s.len(),
            raw.t_s.len() as f64 / own.max(1) as f64
        ),
    })
}

/// One repair for each reason that samples were left out for.
pub(super) fn left_out(raw: &RawSeries, fates: &Fates) -> Vec<Repair> {
    let kinds = [
        RepairKind::RepeatedStamp,
        RepairKind::BackwardStamp,
        RepairKind::NotANumber,
        RepairKind::Saturation,
        RepairKind::NoReading,
        RepairKind::SecondSwing,
        RepairKind::StampStep,
    ];
    kinds
        .into_iter()
        .filter_map(|kind| left_out_as(kind, raw, fates))
        .collect()
}

fn left_out_as(kind: RepairKind, raw: &RawSeries, fates: &Fates) -> Option<Repair> {
    let rows: Vec<usize> = (0..fates.len())
        .filter(|&i| fates[i] == Some(kind))
        .collect();
    let (first, last) = (*rows.first()?, *rows.last()?);
    let n = rows.len();
    let what = match kind {
        RepairKind::RepeatedStamp => format!("{} the stamp before", plural(n, "repeats", "repeat")),
        RepairKind::BackwardStamp => format!("{} back in time", plural(n, "steps", "step")),
        RepairKind::NotANumber => {
            format!("{} a value that is not a number", plural(n, "has", "have"))
        }
        RepairKind::Saturation => format!("{} at the sensor's limit", plural(n, "is", "are")),
        RepairKind::NoReading => format!(
            "{} what a recorder writes where it has no reading, far from all others",
            plural(n, "has", "have")
        ),
        RepairKind::StampStep => {
            format!("{} beyond a step of the clock", plural(n, "lies", "lie"))
        }
        _ => format!(
            "{} to a second recording in the same file",
            plural(n, "belongs", "belong")
        ),
    };
    let text = format!(
        "{}: {} {what}; left out",
        raw.sensor.name(),
        counted(n, "sample")
    );
    Some(Repair {
        kind,
        sensor: raw.sensor,
        count: n,
        first_s: time_near(&raw.t_s, first),
        last_s: time_near(&raw.t_s, last),
        text,
    })
}

/// The stamp at a row, or the nearest finite one before or after it.
fn time_near(t_s: &[f64], row: usize) -> f64 {
    let finite = |t: &&f64| t.is_finite();
    let before = t_s[..=row].iter().rev().find(finite);
    before
        .or_else(|| t_s[row..].iter().find(finite))
        .copied()
        .unwrap_or_default()
}

fn counted(n: usize, what: &str) -> String {
    format!("{n} {}", plural(n, what, &format!("{what}s")))
}

fn plural(n: usize, one: &str, many: &str) -> String {
    if n == 1 {
        one.to_owned()
    } else {
        many.to_owned()
    }
}
