//! Time stamps that repeat, step back or start again.

use std::ops::Range;

use super::series::{Fates, RawSeries};
use crate::samples::RepairKind;

/// A step back by more than this many median intervals that lasts is a second recording, not a late
/// sample. The same bound separates a stall from missing rows.
const RESTART_INTERVALS: f64 = 10.0;
/// Up to this many rows that stand ahead of all that follow are stray stamps.
const STRAY_ROWS: usize = 10;

/// Rows of the longest stretch between restarts of the clock; `None` where there is no restart.
pub(super) fn longest_stretch(raw: &RawSeries) -> Option<Range<usize>> {
    let finite: Vec<usize> = (0..raw.t_s.len())
        .filter(|&i| raw.t_s[i].is_finite())
        .collect();
    let t_s: Vec<f64> = finite.iter().map(|&i| raw.t_s[i]).collect();
    let stretches = stretches(&t_s, &mut Vec::new());
    if stretches.len() < 2 {
        return None;
    }
    // The first of equals: what was recorded on purpose comes before what was left running.
    let longest = stretches.into_iter().rev().max_by_key(Range::len)?;
    let row = |i: usize| finite.get(i).and_then(|&i| raw.row.get(i)).copied();
    let (first, last) = (row(longest.start)?, row(longest.end.checked_sub(1)?)?);
    // Rows before the very first or after the very last sample of this sensor may belong to another
    // sensor.
    let from = if longest.start == 0 { 0 } else { first };
    let to = if longest.end == finite.len() {
        usize::MAX
    } else {
        last + 1
    };
    Some(from..to)
}

/// Decides which samples stay as far as their stamps are concerned.
pub(super) fn judge(raw: &RawSeries, rows: Option<Range<usize>>, fates: &mut Fates) {
    for (i, fate) in fates.iter_mut().enumerate() {
        if !raw.t_s[i].is_finite() {
            *fate = Some(RepairKind::NotANumber);
        } else if rows
            .as_ref()
            .is_some_and(|rows| !rows.contains(&raw.row[i]))
        {
            *fate = Some(RepairKind::SecondSwing);
        }
    }
    let left: Vec<usize> = (0..fates.len()).filter(|&i| fates[i].is_none()).collect();
    let t_s: Vec<f64> = left.iter().map(|&i| raw.t_s[i]).collect();
    let mut strays = Vec::new();
    let stretches = stretches(&t_s, &mut strays);
    for stray in strays {
        fates[left[stray]] = Some(RepairKind::BackwardStamp);
    }
    let longest = stretches
        .into_iter()
        .rev()
        .max_by_key(Range::len)
        .unwrap_or_default();
    let mut latest = f64::NEG_INFINITY;
    for (k, &i) in left.iter().enumerate() {
        if fates[i].is_some() {
            continue;
        }
        if !longest.contains(&k) {
            fates[i] = Some(RepairKind::SecondSwing);
        } else if raw.t_s[i] > latest {
            latest = raw.t_s[i];
        } else if raw.t_s[i] == latest {
            fates[i] = Some(RepairKind::RepeatedStamp);
        } else {
            fates[i] = Some(RepairKind::BackwardStamp);
        }
    }
}

/// Splits stamps where the clock starts again. Stray rows, far ahead of everything after them, are
/// put into `strays` and do not split.
fn stretches(t_s: &[f64], strays: &mut Vec<usize>) -> Vec<Range<usize>> {
    let far = RESTART_INTERVALS * median_interval_s(t_s).unwrap_or(f64::INFINITY);
    let mut stretches = Vec::new();
    let mut start = 0;
    // Rows of the present stretch whose stamps rise: the stamps that a later one is held against.
    let mut rising: Vec<usize> = Vec::new();
    for (i, &t) in t_s.iter().enumerate() {
        let Some(&last) = rising.last() else {
            rising.push(i);
            continue;
        };
        if t > t_s[last] {
            rising.push(i);
        } else if t < t_s[last] - far && stays_below(&t_s[i..], t_s[last]) {
            let before = rising.partition_point(|&row| t_s[row] < t);
            if before > 0 && rising.len() - before <= STRAY_ROWS {
                strays.extend(rising.drain(before..));
            } else {
                stretches.push(start..i);
                start = i;
                rising.clear();
            }
            rising.push(i);
        }
    }
    if start < t_s.len() {
        stretches.push(start..t_s.len());
    }
    stretches
}

fn stays_below(following: &[f64], t_s: f64) -> bool {
    following.len() > STRAY_ROWS && following.iter().take(STRAY_ROWS).all(|&t| t <= t_s)
}

/// Median of the intervals between stamps that rise.
pub fn median_interval_s(t_s: &[f64]) -> Option<f64> {
    let mut steps: Vec<f64> = t_s
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .filter(|step| *step > 0.0 && step.is_finite())
        .collect();
    let middle = steps.len() / 2;
    (!steps.is_empty()).then(|| *steps.select_nth_unstable_by(middle, f64::total_cmp).1)
}
