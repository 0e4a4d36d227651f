//! Which part of a record is a free swing: after the release, before anybody touches the hull
//! again.
//!
//! A freely swinging hull is a sum of a few damped oscillations, whatever their beats, so every
//! sample follows linearly from the ones before it, by one rule for all channels (linear
//! prediction). A hand, a release, a stop or a phone picked up is what the rule does not foresee,
//! from neither side. An envelope would not do: two modes of equal strength beat to nothing and
//! back without anybody touching the hull. Rest follows every such rule too; where motion meets
//! rest, the prediction is judged more strictly.

use super::prediction::{BlockSeries, Surprise};
use super::types::ChannelGroup;
use super::words::message;
use gyradius_base::message::Message;

/// The part of a record that swings freely.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeSpan {
    /// Start, s.
    pub start_s: f64,
    /// End, s.
    pub end_s: f64,
    /// What was left out, in time order.
    pub notes: Vec<SpanNote>,
}

/// Why a part of a record was left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpanNoteKind {
    /// Waiting, handling and release before the swing.
    LeadIn,
    /// What came after the swing ended.
    LeadOut,
    /// Another free swing in the same record: the recording's repairs list it as `SecondSwing`.
    SecondSwing,
}

/// A part of a record that was left out.
#[derive(Debug, Clone, PartialEq)]
pub struct SpanNote {
    /// Why.
    pub kind: SpanNoteKind,
    /// From, s.
    pub from_s: f64,
    /// To, s.
    pub to_s: f64,
    /// In words.
    pub message: Message,
}

/// A stretch without a disturbance, in blocks (end excluded), and its size.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    first: usize,
    end: usize,
    rms: f64,
}

impl Stretch {
    /// What the stretch is worth: the Cramér–Rao bound of a period falls as amplitude ×
    /// duration^1.5.
    fn worth(&self) -> f64 {
        self.rms * ((self.end - self.first) as f64).powf(1.5)
    }
}

/// A free swing shorter than this many cycles is not worth a note of its own.
const SHORTEST_SWING_CYCLES: f64 = 8.0;
/// Fewer cycles say nothing of a period: what is so short (a phone that is picked up) is the swing
/// only where nothing longer moves.
const FEWEST_CYCLES: f64 = 4.0;
/// A stretch moves where its size is more than so many times the noise of a sample.
const MOVES: f64 = 3.0;
/// A stretch with less than this share of the swing's amplitude is waiting, not another swing.
const WAITING_SHARE: f64 = 0.15;

/// Finds the freely decaying part of a record; the whole record where nothing disturbs it.
pub fn free_swing_span(groups: &[ChannelGroup]) -> FreeSpan {
    undisturbed_span(groups, &[])
}

/// The same of a record whose swing is known to have been disturbed at these times, s.
pub fn undisturbed_span(groups: &[ChannelGroup], disturbed_s: &[f64]) -> FreeSpan {
    let (first_s, last_s) = extent(groups);
    let whole = FreeSpan {
        start_s: first_s,
        end_s: last_s,
        notes: Vec::new(),
    };
    let Some(series) = BlockSeries::new(groups) else {
        return whole;
    };
    let Some(surprise) = Surprise::new(&series) else {
        return whole;
    };
    let stretches = stretches(&series, &surprise.breaks(&series, disturbed_s));
    let fewest = (FEWEST_CYCLES * series.period_s() / series.step_s()).ceil() as usize;
    let swings = |s: &Stretch| s.end - s.first >= fewest && s.rms > MOVES;
    let better = |a: &Stretch, b: &Stretch| {
        swings(a)
            .cmp(&swings(b))
            .then(a.worth().total_cmp(&b.worth()))
    };
    let Some(best) = stretches.iter().copied().max_by(better) else {
        return whole;
    };
    let start_s = if best.first == 0 {
        first_s
    } else {
        series.time_s(best.first)
    };
    let end_s = if best.end == series.len() {
        last_s
    } else {
        series.time_s(best.end)
    };
    let notes = notes(
        &series,
        &stretches,
        &best,
        (first_s, start_s, end_s, last_s),
    );
    FreeSpan {
        start_s,
        end_s,
        notes,
    }
}

fn extent(groups: &[ChannelGroup]) -> (f64, f64) {
    let firsts = groups.iter().filter_map(|g| g.t_s.first()).copied();
    let lasts = groups.iter().filter_map(|g| g.t_s.last()).copied();
    let first_s = firsts.fold(f64::INFINITY, f64::min);
    let last_s = lasts.fold(f64::NEG_INFINITY, f64::max);
    if first_s <= last_s {
        (first_s, last_s)
    } else {
        (0.0, 0.0)
    }
}

/// The runs of blocks between disturbances.
fn stretches(series: &BlockSeries, disturbed: &[bool]) -> Vec<Stretch> {
    let mut found = Vec::new();
    let mut first = 0;
    // The end of the record ends a stretch as a disturbed block does.
    for (n, ends) in disturbed.iter().copied().chain([true]).enumerate() {
        if ends && n > first + 2 {
            found.push(Stretch {
                first,
                end: n,
                rms: series.rms(first, n),
            });
        }
        if ends {
            first = n + 1;
        }
    }
    found
}

fn notes(
    series: &BlockSeries,
    stretches: &[Stretch],
    best: &Stretch,
    (first_s, start_s, end_s, last_s): (f64, f64, f64, f64),
) -> Vec<SpanNote> {
    let shortest = (SHORTEST_SWING_CYCLES * series.period_s() / series.step_s()).ceil() as usize;
    let another = |s: &&Stretch| s.rms > WAITING_SHARE * best.rms && s.end - s.first >= shortest;
    let before: Vec<&Stretch> = stretches
        .iter()
        .filter(|s| s.end <= best.first)
        .filter(another)
        .collect();
    let after: Vec<&Stretch> = stretches
        .iter()
        .filter(|s| s.first >= best.end)
        .filter(another)
        .collect();
    let mut notes = Vec::new();
    if start_s > first_s {
        let kind = if before.is_empty() {
            SpanNoteKind::LeadIn
        } else {
            SpanNoteKind::SecondSwing
        };
        notes.push(note(kind, first_s, start_s));
    }
    if end_s < last_s {
        let kind = if after.is_empty() {
            SpanNoteKind::LeadOut
        } else {
            SpanNoteKind::SecondSwing
        };
        notes.push(note(kind, end_s, last_s));
    }
    notes
}

fn note(kind: SpanNoteKind, from_s: f64, to_s: f64) -> SpanNote {
    let length = ("length_s", to_s - from_s, 1);
    let (from, to) = (("from_s", from_s, 1), ("to_s", to_s, 1));
    let message = match kind {
        SpanNoteKind::LeadIn => message("lead_in", [length]),
        SpanNoteKind::LeadOut => message("lead_out", [length, from]),
        SpanNoteKind::SecondSwing => message("second_swing", [from, to]),
    };
    SpanNote {
        kind,
        from_s,
        to_s,
        message,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_nothing_out() {
        let span = free_swing_span(&[]);
        assert_eq!((span.start_s, span.end_s, span.notes.len()), (0.0, 0.0, 0));
        let one = ChannelGroup {
            t_s: vec![3.0],
            channels: vec![vec![1.0]],
        };
        assert_eq!(free_swing_span(&[one]).start_s, 3.0);
    }

    #[test]
    fn a_record_without_oscillation_is_kept_whole() {
        let t_s: Vec<f64> = (0..5000).map(|i| i as f64 * 0.01).collect();
        let group = ChannelGroup {
            channels: vec![vec![0.0; t_s.len()]],
            t_s,
        };
        let span = free_swing_span(&[group]);
        assert_eq!((span.start_s, span.end_s), (0.0, 49.99));
    }
}
