//! What does not enter the estimate; and where nothing follows from what does, why.

use gyradius_base::message::Argument;
use gyradius_recording::{ModeName, Suspension, SuspensionKind, Swing, SwingData};

use super::{Finding, FindingKind as Kind, Severity};
use crate::estimate::{Observed, System};
use crate::measurement::{Measurement, ModeResult};
use crate::sentences::motion;
use crate::swing_work::{SwingWork, WEAKEST_DB};
use crate::theory::has_motion;
use crate::words::mode_text;

/// Periods that somebody typed for motions which the suspension does not have. Of a result without a
/// quantity, why (`has_failed`: the estimate did): what each swing lacks that gives the estimate no period, and what the periods of
/// the others do not tell.
pub fn not_used(
    system: &System,
    works: &[SwingWork],
    result: &Measurement,
    has_failed: bool,
) -> Vec<Finding> {
    if !result.quantities.is_empty() {
        let swings = system.session.swings.iter();
        return swings.filter_map(left_out).collect();
    }
    if works.is_empty() {
        return vec![of_session("no_swings", [])];
    }
    let is_refused = |id: &str| {
        let told = result.findings.iter().filter(|one| one.refuses());
        told.into_iter().any(|one| one.swing.as_deref() == Some(id))
    };
    let enters = |i: usize| {
        let is_its = |what: &Observed| matches!(what, Observed::Period(of, _) if *of == i);
        system.periods.iter().any(|one| is_its(&one.what))
    };
    let mut found: Vec<Finding> = works
        .iter()
        .enumerate()
        .filter(|(i, work)| !enters(*i) && !is_refused(&work.result.id))
        .map(|(i, work)| unused(work, &system.session.swings[i].suspension))
        .collect();
    let mut seen: Vec<ModeName> = Vec::new();
    for observation in &system.periods {
        if let Observed::Period(_, mode) = observation.what
            && !seen.contains(&mode)
        {
            seen.push(mode);
        }
    }
    // Where the estimate failed or a figure was taken out, that is told.
    let is_told = has_failed || result.findings.iter().any(Finding::refuses);
    if !seen.is_empty() && !is_told {
        found.push(of_session("no_quantity", [("motions", motions(&seen))]));
    }
    found
}

/// Typed periods of motions that the suspension does not have.
fn left_out(swing: &Swing) -> Option<Finding> {
    let (SwingData::PeriodsS(typed), hung) = (&swing.data, &swing.suspension) else {
        return None;
    };
    let is_foreign = |mode: &ModeName| *mode != ModeName::Other && !has_motion(hung, *mode);
    let foreign: Vec<ModeName> = typed.keys().copied().filter(is_foreign).collect();
    if foreign.is_empty() || hung.kind == SuspensionKind::Free {
        return None;
    }
    let arguments = [("motions", motions(&foreign)), ("kind", stated_kind(hung))];
    let what = (Kind::NotIdentifiable, Severity::Warned);
    Some(Finding::new(what, "unused_kind", arguments).of_swing(&swing.id))
}

/// Kind and direction as a session states them.
fn stated_kind(hung: &Suspension) -> Argument {
    let (kind, way) = (hung.kind.name(), hung.orientation.name());
    Argument::Plain(match hung.kind.has_direction() {
        true => format!("kind = \"{kind}\", orientation = \"{way}\""),
        false => format!("kind = \"{kind}\""),
    })
}

/// Why a swing gives the estimate no period.
fn unused(work: &SwingWork, hung: &Suspension) -> Finding {
    let modes = &work.result.modes;
    let named = || modes.iter().filter(|mode| mode.mode != ModeName::Other);
    let is_weak = |mode: &ModeResult| mode.relative_db <= WEAKEST_DB;
    let periods = |modes: &[&ModeResult]| {
        let each = modes.iter().map(|mode| format!("{:.3} s", mode.period_s));
        Argument::Plain(each.collect::<Vec<_>>().join(", "))
    };
    let all: Vec<&ModeResult> = modes.iter().collect();
    let names: Vec<ModeName> = named().map(|mode| mode.mode).collect();
    let (key, arguments) = if modes.is_empty() {
        let why = Argument::Texts(work.result.warnings.clone());
        match work.result.warnings.is_empty() {
            true => ("unused_motionless", vec![]),
            false => ("unused_unread", vec![("why", why)]),
        }
    } else if hung.kind == SuspensionKind::Free {
        ("unused_free", vec![("periods", periods(&all))])
    } else if names.is_empty() {
        ("unused_unnamed", vec![("periods", periods(&all))])
    } else if !work.periods.is_empty() {
        let arguments = vec![("motions", motions(&names)), ("kind", stated_kind(hung))];
        ("unused_kind", arguments)
    } else if named().all(is_weak) {
        let strong: Vec<&ModeResult> = modes.iter().filter(|mode| !is_weak(mode)).collect();
        let arguments = vec![("motions", motions(&names)), ("periods", periods(&strong))];
        ("unused_weak", arguments)
    } else {
        ("unused_growing", vec![("motions", motions(&names))])
    };
    Finding::new((Kind::NotIdentifiable, Severity::Refused), key, arguments)
        .of_swing(&work.result.id)
}

fn of_session<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Finding {
    Finding::new((Kind::NotIdentifiable, Severity::Refused), key, arguments)
}

fn motions(modes: &[ModeName]) -> Argument {
    let each = modes.iter().map(|mode| motion(mode_text(*mode)));
    let texts = each.filter_map(|one| match one {
        Argument::Texts(texts) => Some(texts),
        _ => None,
    });
    Argument::Texts(texts.flatten().collect())
}
