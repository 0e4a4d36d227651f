//! Whether the motion goes on across a gap of the stamps. A clock that steps leaves one where no
//! time was lost, and one that steps back leaves none where time seems to have passed twice: in
//! either case no sum of damped oscillations goes across.

use gyradius_base::error::Result;
use gyradius_recording::{MISSING_INTERVALS, Repair, RepairKind, median_interval_s};
use gyradius_signal::{
    ChannelGroup, DecomposeOptions, Decomposition, FreeSpan, decompose, undisturbed_span,
};

use super::observe::clipped;

/// Most gaps, the widest first, that are tried: a clock that is set by a network steps once or twice
/// in a swing.
const MOST_BREAKS: usize = 3;
/// Residual beyond the noise that cannot be chance: its variance has a relative standard deviation
/// of √(2/n), and this many of those come once in 10⁶.
const SIGNIFICANT: f64 = 5.0;
/// A gap is not bridged where the part to one side of it leaves less than this of the excess.
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
    if excess(&whole) <= 0.0 {
        return Ok(whole);
    }
    let mut known = disturbed_s.to_vec();
    for at_s in suspects(&whole.groups, repairs) {
        known.push(at_s);
        known.sort_by(f64::total_cmp);
        let Ok(side) = part(all, &known) else {
            continue;
        };
        if excess(&side) < LEFT * excess(&whole) {
            return Ok(Free {
                cut_at_s: Some(at_s),
                ..side
            });
        }
    }
    Ok(whole)
}

fn part(all: &[ChannelGroup], disturbed_s: &[f64]) -> Result<Free> {
    let span = undisturbed_span(all, disturbed_s);
    let groups = clipped(all, span.start_s, span.end_s);
    let found = decompose(&groups, &DecomposeOptions::default())?;
    Ok(Free {
        span,
        groups,
        found,
        cut_at_s: None,
    })
}

/// Residual variance over that of the noise, less what chance explains.
fn excess(free: &Free) -> f64 {
    let samples = free.groups.iter().map(|g| g.t_s.len() * g.channels.len());
    let n = samples.sum::<usize>().max(1) as f64;
    free.found.rms_over_noise.powi(2) - 1.0 - SIGNIFICANT * (2.0 / n).sqrt()
}

/// Where the clock may have stepped, s: the widest gaps, and where stamps ran back.
fn suspects(groups: &[ChannelGroup], repairs: &[Repair]) -> Vec<f64> {
    let mut gaps: Vec<(f64, f64)> = Vec::new();
    let densest = groups.iter().max_by_key(|group| group.t_s.len());
    if let Some((t_s, median)) =
        densest.and_then(|group| Some((&group.t_s, median_interval_s(&group.t_s)?)))
    {
        let steps = t_s.windows(2).map(|pair| (pair[1] - pair[0], pair[0]));
        gaps.extend(steps.filter(|(step, _)| *step > MISSING_INTERVALS * median));
        let back = repairs
            .iter()
            .filter(|repair| repair.kind == RepairKind::BackwardStamp)
            .map(|repair| (repair.count as f64 * median, repair.last_s));
        gaps.extend(back);
    }
    gaps.sort_by(|a, b| b.0.total_cmp(&a.0));
    gaps.truncate(MOST_BREAKS);
    gaps.into_iter().map(|(_, at_s)| at_s).collect()
}
