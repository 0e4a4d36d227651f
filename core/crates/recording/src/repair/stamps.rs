//! Time stamps that are shared, repeat, step back, start again or step ahead.

use std::collections::HashSet;
use std::ops::Range;

use super::series::{Fates, RawSeries};
use crate::samples::RepairKind;

/// A step back by more than this many median intervals that lasts is a second recording, not a late
/// sample. The same bound separates a stall from missing rows.
const RESTART_INTERVALS: f64 = 10.0;
/// Up to this many rows that stand ahead of all that follow are stray stamps.
const STRAY_ROWS: usize = 10;

/// Part of a record's span that must be recorded, gaps taken off. A free swing does not wait: beyond
/// a gap longer than twice what was recorded, the stamps have another origin, or it is another
/// swing. With it, time and memory follow the number of samples.
const RECORDED_SHARE: f64 = 1.0 / 3.0;
/// A span of so many intervals costs nothing, whatever is recorded of it.
const CHEAP_INTERVALS: f64 = 1e4;
/// Where more than this share of the samples have the stamp of the one before, and other values,
/// the stamps are those of packets: of packets of two, half do.
const SHARED: f64 = 0.4;

/// One stamp in so many may be jitter nearer to the next than half the interval.
const CROWDED: usize = 100;

/// In how many stretches the stamps rise where, put in order, they are as regular as within one (two
/// recordings of the same time would lie between each other's stamps) and none is most of the record.
/// Else 0.
pub(super) fn pieces_out_of_order(t_s: &[f64]) -> usize {
    let mut finite: Vec<f64> = t_s.iter().copied().filter(|t| t.is_finite()).collect();
    let pieces = stretches(&finite, &mut vec![]);
    let longest = pieces.iter().map(Range::len).max().unwrap_or_default();
    let near = 0.5 * median_interval_s(&finite).unwrap_or_default();
    finite.sort_by(f64::total_cmp);
    let crowded = finite.windows(2).filter(|pair| pair[1] - pair[0] < near);
    match CROWDED * crowded.count() < finite.len() && 2 * longest < finite.len() {
        true => pieces.len(),
        false => 0,
    }
}

/// Rows that one table keeps.
#[derive(Debug, Clone, Default)]
pub(super) struct Window {
    /// Those of the longest stretch between restarts of the clock; `None` where there is no
    /// restart.
    restarts: Option<Range<usize>>,
    /// Those before or after a step ahead; `None` where there is no step.
    steps: Option<Range<usize>>,
}

/// The longest stretch of a series, as rows of its table.
pub(super) fn window(raw: &RawSeries) -> Window {
    let finite: Vec<usize> = (0..raw.t_s.len())
        .filter(|&i| raw.t_s[i].is_finite())
        .collect();
    let t_s: Vec<f64> = finite.iter().map(|&i| raw.t_s[i]).collect();
    let mut strays = Vec::new();
    let all = stretches(&t_s, &mut strays);
    // The first of equals: what was recorded on purpose comes before what was left running.
    let is_restarted = all.len() > 1;
    let longest = all.into_iter().rev().max_by_key(Range::len);
    let Some(longest) = longest else {
        return Window::default();
    };
    let rows = |range: Range<usize>| rows_of(raw, &finite, range);
    let strays: HashSet<usize> = strays.into_iter().collect();
    let mut rising: Vec<usize> = Vec::new();
    for i in longest.clone().filter(|i| !strays.contains(i)) {
        if rising.last().is_none_or(|&last| t_s[i] > t_s[last]) {
            rising.push(i);
        }
    }
    let stamps: Vec<f64> = rising.iter().map(|&i| t_s[i]).collect();
    let steps = recorded_part(&stamps).and_then(|part| {
        let end = rising.get(part.end).copied().unwrap_or(longest.end);
        rows(*rising.get(part.start)?..end)
    });
    Window {
        restarts: is_restarted.then(|| rows(longest)).flatten(),
        steps,
    }
}

/// The part of rising stamps of which enough is recorded, without rows that stand alone at its ends;
/// `None` where that is the whole.
fn recorded_part(t_s: &[f64]) -> Option<Range<usize>> {
    let median_s = median_interval_s(t_s)?;
    let far = RESTART_INTERVALS * median_s;
    let gap = |i: usize| t_s[i] - t_s[i - 1];
    let mut part = 0..t_s.len();
    loop {
        part = without_lone_ends(part, |i| gap(i) > far);
        let steps = || (part.start + 1..part.end).map(|i| (i, gap(i)));
        let recorded_s: f64 = steps().map(|(_, step)| step.min(far)).sum();
        let (widest, gap_s) = steps().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let span_s = t_s[part.end - 1] - t_s[part.start];
        let is_short = span_s <= CHEAP_INTERVALS * median_s;
        if is_short || recorded_s >= RECORDED_SHARE * span_s || gap_s <= far {
            return (part.len() < t_s.len()).then_some(part);
        }
        part = if widest - part.start >= part.end - widest {
            part.start..widest
        } else {
            widest..part.end
        };
    }
}

/// Without the few rows that a gap divides from the rest. Where gaps are the rule, as with a sensor
/// that sends bursts, no row is alone.
fn without_lone_ends(part: Range<usize>, is_gap: impl Fn(usize) -> bool) -> Range<usize> {
    let gaps = (part.start + 1..part.end).filter(|&i| is_gap(i)).count();
    if gaps == 0 || gaps * 10 * STRAY_ROWS > part.len() {
        return part;
    }
    let first = (part.start + 1..=part.start + STRAY_ROWS).rfind(|&i| is_gap(i));
    let end = (part.end - STRAY_ROWS..part.end).find(|&i| is_gap(i));
    first.unwrap_or(part.start)..end.unwrap_or(part.end)
}

/// Stamps of packets spread from one packet's to the next; how many samples had no stamp of their
/// own. A sample of a packet was taken after the packet before.
pub(super) fn spread_shared(raw: &mut RawSeries) -> usize {
    let same = |i: usize, j: usize| {
        raw.channels
            .iter()
            .all(|c| c[i].to_bits() == c[j].to_bits())
    };
    let shared = (1..raw.t_s.len())
        .filter(|&i| raw.t_s[i] == raw.t_s[i - 1] && !same(i, i - 1))
        .count();
    if (shared as f64) < SHARED * raw.t_s.len() as f64 {
        return 0;
    }
    let packets: Vec<Range<usize>> = raw
        .t_s
        .chunk_by(|a, b| a == b)
        .scan(0, |from, packet| {
            let first = *from;
            *from += packet.len();
            Some(first..*from)
        })
        .collect();
    let stamps = raw.t_s.clone();
    let ahead = |n: usize| {
        let (before, packet) = (&packets[n - 1], &packets[n]);
        (stamps[packet.start] - stamps[before.start]) / packet.len() as f64
    };
    let mut intervals: Vec<f64> = (1..packets.len()).map(ahead).filter(|s| *s > 0.0).collect();
    if intervals.is_empty() {
        return 0;
    }
    let middle = intervals.len() / 2;
    let usual = *intervals.select_nth_unstable_by(middle, f64::total_cmp).1;
    for (n, packet) in packets.iter().enumerate() {
        let own = (n > 0).then(|| ahead(n)).filter(|s| *s > 0.0);
        // After a pause a packet holds what was taken since, at the usual rate.
        let interval = own.map_or(usual, |own| own.min(2.0 * usual));
        for (k, i) in packet.clone().rev().enumerate() {
            raw.t_s[i] = stamps[packet.start] - k as f64 * interval;
        }
    }
    shared
}

fn rows_of(raw: &RawSeries, finite: &[usize], longest: Range<usize>) -> Option<Range<usize>> {
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
pub(super) fn judge(raw: &RawSeries, window: &Window, fates: &mut Fates) {
    let outside = |rows: &Option<Range<usize>>, i: usize| {
        rows.as_ref()
            .is_some_and(|rows| !rows.contains(&raw.row[i]))
    };
    for (i, fate) in fates.iter_mut().enumerate() {
        if !raw.t_s[i].is_finite() {
            *fate = Some(RepairKind::NotANumber);
        } else if outside(&window.restarts, i) {
            *fate = Some(RepairKind::SecondSwing);
        } else if outside(&window.steps, i) {
            *fate = Some(RepairKind::StampStep);
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
