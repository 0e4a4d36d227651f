//! Whether the motion goes on across a gap of the stamps. A clock that steps leaves one where no
//! time was lost, and one that steps back leaves none where time seems to have passed twice: in
//! either case no sum of damped oscillations goes across.

use gyradius_base::error::Result;
use gyradius_recording::{MISSING_INTERVALS, Repair, RepairKind, median_interval_s};
use gyradius_signal::{
    ChannelGroup, DecomposeOptions, Decomposition, FreeSpan, decompose, decompose_heavily_damped,
    undisturbed_span,
};

use super::chance::beyond_chance;
use super::observe::clipped;

/// Most gaps, the widest first, that are tried: a clock that is set by a network steps once or twice
/// in a swing.
const MOST_GAPS: usize = 3;
/// The clock stepped where less than this share of the excess is left once the gap is closed: closing
/// one in which time did pass makes it larger.
const LEFT: f64 = 0.5;

/// The free part of a record with what was found in it.
pub struct Free {
    /// The part.
    pub span: FreeSpan,
    /// The channels of that part.
    pub groups: Vec<ChannelGroup>,
    /// What was found in them.
    pub found: Decomposition,
    /// The gap at which the record was cut because no motion goes across, s.
    pub cut_at_s: Option<f64>,
}

/// What swings freely in a record that is known to have been disturbed at these times, s.
pub fn free_part(all: &[ChannelGroup], disturbed_s: &[f64], repairs: &[Repair]) -> Result<Free> {
    let whole = part(all, disturbed_s)?;
    let excess = beyond_noise(&whole.groups, &whole.found);
    if excess <= 0.0 {
        return Ok(whole);
    }
    for gap in gaps(&whole.groups, repairs) {
        let closed = gap.closed(&whole.groups);
        let Ok(found) = decompose(&closed, &DecomposeOptions::default()) else {
            continue;
        };
        if beyond_noise(&closed, &found) > LEFT * excess {
            continue;
        }
        let mut known = disturbed_s.to_vec();
        known.push(gap.at_s);
        known.sort_by(f64::total_cmp);
        if let Ok(side) = part(all, &known) {
            return Ok(Free {
                cut_at_s: Some(gap.at_s),
                ..side
            });
        }
    }
    Ok(whole)
}

fn part(all: &[ChannelGroup], disturbed_s: &[f64]) -> Result<Free> {
    let span = undisturbed_span(all, disturbed_s);
    let groups = clipped(all, span.start_s, span.end_s);
    let found = match decompose(&groups, &DecomposeOptions::default()) {
        Ok(found) => found,
        Err(error) => match decompose_heavily_damped(&groups) {
            Ok(found) => found,
            Err(_) => return heavily_damped(all, disturbed_s).ok_or(error),
        },
    };
    Ok(Free {
        span,
        groups,
        found,
        cut_at_s: None,
    })
}

/// The whole record, where oscillations describe all of it: what dies away within a cycle or two looks
/// like a disturbance, and what is left is rest.
fn heavily_damped(all: &[ChannelGroup], disturbed_s: &[f64]) -> Option<Free> {
    let stamps = || all.iter().flat_map(|group| group.t_s.iter().copied());
    let span = FreeSpan {
        start_s: stamps().fold(f64::INFINITY, f64::min),
        end_s: stamps().fold(f64::NEG_INFINITY, f64::max),
        notes: vec![],
    };
    let found = decompose_heavily_damped(all).ok()?;
    let is_whole = disturbed_s.is_empty() && beyond_noise(all, &found) <= 0.0;
    is_whole.then(|| Free {
        span,
        groups: all.to_vec(),
        found,
        cut_at_s: None,
    })
}

/// Residual variance over that of the noise, less what chance explains.
fn beyond_noise(groups: &[ChannelGroup], found: &Decomposition) -> f64 {
    let samples = groups.iter().map(|g| g.t_s.len() * g.channels.len());
    let n = samples.sum::<usize>().max(1) as f64;
    beyond_chance(found.rms_over_noise.powi(2), n)
}

/// Where the clock may have stepped.
struct Gap {
    /// The last stamp before it, s.
    at_s: f64,
    /// By how much it would have stepped ahead, s.
    ahead_s: f64,
}

impl Gap {
    /// The channels with the step taken out.
    fn closed(&self, groups: &[ChannelGroup]) -> Vec<ChannelGroup> {
        let closed = |t: &f64| if *t > self.at_s { t - self.ahead_s } else { *t };
        let each = groups.iter().map(|group| ChannelGroup {
            t_s: group.t_s.iter().map(closed).collect(),
            channels: group.channels.clone(),
        });
        each.collect()
    }
}

/// The widest gaps, and where stamps ran back.
fn gaps(groups: &[ChannelGroup], repairs: &[Repair]) -> Vec<Gap> {
    let densest = groups.iter().max_by_key(|group| group.t_s.len());
    let Some((t_s, median)) =
        densest.and_then(|group| Some((&group.t_s, median_interval_s(&group.t_s)?)))
    else {
        return vec![];
    };
    let steps = t_s.windows(2).map(|pair| (pair[1] - pair[0], pair[0]));
    let mut all: Vec<Gap> = steps
        .filter(|(step, _)| *step > MISSING_INTERVALS * median)
        .map(|(step, at_s)| Gap {
            at_s,
            ahead_s: step - median,
        })
        .collect();
    for repair in repairs {
        let is_known = |gap: &Gap| (gap.at_s - repair.last_s).abs() <= median;
        if repair.kind == RepairKind::BackwardStamp && !all.iter().any(is_known) {
            all.push(Gap {
                at_s: repair.last_s,
                ahead_s: -(repair.count as f64) * median,
            });
        }
    }
    all.sort_by(|a, b| b.ahead_s.abs().total_cmp(&a.ahead_s.abs()));
    all.truncate(MOST_GAPS);
    all
}
