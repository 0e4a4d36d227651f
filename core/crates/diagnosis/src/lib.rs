//! What the simulation gets wrong, why, and what fixing it gains.
//!
//! May know `recording`, `signal`, `modes`, `dynamics`, `inertia`.

mod base;
mod by_periods;
mod cause_id;
mod causes;
mod closed_form;
mod coordinate;
mod decision;
mod doubt;
mod evidence;
mod findings;
mod fitted_swing;
mod fitting;
mod found;
mod judged;
mod learned;
mod linear;
mod look;
mod moments;

mod next_swing;
mod one_motion;
mod parameter_id;
mod point;
mod quantities;
mod result;
mod search;
mod seen;
mod selection;
mod shape;
mod tell_apart;
mod term;
mod traces;
mod trial;
mod unit;
mod verdict;
mod white;
mod whole;
mod words;

pub use by_periods::criticise_periods;
pub use cause_id::CauseId;
pub use coordinate::ForceCoordinate;
pub use judged::judged_with;
pub use parameter_id::{ParameterId, ParameterName};
pub use result::{
    CauseResult, CauseVerdict, Criticism, Critique, Discrepancy, DiscrepancyKind, Gain,
    LearnedForce, ModelResult, NextSwing, ParameterResult, Progress, Status, SwingTrace,
};
pub use tell_apart::tell_apart;
pub use unit::{Unit, UnitName};
pub use words::{cause_called, cause_name};

use std::collections::BTreeMap;

use gyradius_base::error::Result;
use gyradius_base::message::Message;
use gyradius_base::progress::tell;
use gyradius_identification::measure::{Prepared, prepare, title};
use gyradius_identification::{MeasureOptions, QuantityName, QuantityResult, analyse};
use gyradius_recording::{LoadedData, LoadedSession, Quantity};

use base::by_periods;
use doubt::widen;
use findings::findings;
use fitted_swing::Base;
use fitting::Fitted;
use found::{Found, Tried};
use learned::learned;
use next_swing::{Explained, next_swing};
use point::Model;
use quantities::quantities;
use search::search;
use traces::traces;
use white::Left;

/// Name and version of the result's format.
pub const FORMAT: &str = "gyradius-critique/1";

/// How causes are looked for in sessions whose whole body is simulated.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Search {
    /// One after another while it pays.
    #[default]
    InRounds,
    /// All sets of up to three are weighed.
    BySets,
}

/// Criticises a session.
pub fn criticise(loaded: &LoadedSession, progress: &Progress) -> Result<Criticism> {
    criticise_by(Search::default(), loaded, progress)
}

/// The same by a search of one's own choice.
pub fn criticise_by(
    search_for: Search,
    loaded: &LoadedSession,
    progress: &Progress,
) -> Result<Criticism> {
    tell(progress, 0.0, "reading the swings")?;
    let by_periods_alone = || {
        let analysis = analyse(loaded, &MeasureOptions::default())?;
        let mut judged = criticise_periods(loaded, &analysis)?;
        judged.critique = judged.critique.with(analysis.measurement.findings);
        Ok(judged)
    };
    if !loaded
        .data
        .iter()
        .any(|data| matches!(data.data, LoadedData::Recording(_)))
    {
        return by_periods_alone();
    }
    let mut prepared = prepare(loaded)?;
    let x = by_periods(&mut prepared);
    tell(progress, 0.05, "fitting each swing")?;
    let Prepared {
        works,
        system,
        inclines,
        warnings,
        findings,
    } = prepared;
    let Some((mut base, start)) = Base::begin(&system, &works, &inclines, &x)? else {
        let turning = one_motion::criticise(loaded, &system, (&works, &x), warnings, progress)?;
        let told = |judged: Criticism| {
            let critique = judged.critique.with(findings);
            Ok(Criticism { critique, ..judged })
        };
        return turning.map_or_else(by_periods_alone, told);
    };
    tell(progress, 0.15, "fitting all swings together")?;
    let Ok(fitted) = base.fit(&start) else {
        let mut judged = by_periods_alone()?;
        judged.critique.warn(words::message("no_fit", []));
        return Ok(judged);
    };
    let model = Model::of(&base);
    if search_for == Search::BySets {
        let judged = whole::criticise(
            loaded,
            (model, start, fitted),
            &inclines,
            warnings,
            progress,
        )?;
        let critique = judged.critique.with(findings);
        return Ok(Criticism { critique, ..judged });
    }
    let found = search(model.clone(), start, fitted, progress)?;
    tell(progress, 0.9, "judging by samples held out")?;
    let judged = conclude(loaded, &model, &found, &inclines, warnings)?;
    let critique = judged.critique.with(findings);
    Ok(Criticism { critique, ..judged })
}

fn conclude(
    loaded: &LoadedSession,
    base: &Model,
    found: &Found,
    inclines: &[Option<Quantity>],
    warnings: Vec<Message>,
) -> Result<Criticism> {
    let (before, rows) = Found::held_out(base, &found.base)?;
    let after = match found.model.causes[..] {
        [] => before,
        _ => Found::held_out(&found.model, &found.fitted)?.0,
    };
    let rms = |chi2: f64| (chi2 / rows.max(1) as f64).sqrt();
    let base_fit = (&found.base, &found.base_left);
    let baseline = model_result(base, base_fit, rms(before), inclines)?;
    let fit = (&found.fitted, &found.left);
    let mut extended = model_result(&found.model, fit, rms(after), inclines)?;
    let otherwise = found.otherwise(inclines);
    widen(&mut extended.quantities, &otherwise);
    let next = found
        .rivals()
        .first()
        .filter(|_| !found.is_unexplained())
        .and_then(|t| would_tell(found, t));
    let gain = gain((before, after), rows, &baseline, &extended);
    let critique = Critique {
        format: FORMAT.into(),
        title: title(&loaded.session),
        discrepancies: findings(base, &found.base, &found.base_left)?,
        causes: found.causes(),
        verdict: CauseVerdict {
            next_swing: next,
            ..found.verdict()
        },
        baseline,
        extended,
        gain,
        learned: learned(found, rms(after)),
        findings: Vec::new(),
        warnings,
    };
    Ok(Criticism {
        critique,
        traces: traces(base, found)?,
    })
}

/// What a fitted model says of the body, by what it leaves and by its residual over noise where that
/// was held out.
fn model_result(
    model: &Model,
    (fitted, left): (&Fitted, &Left),
    heldout_rms: f64,
    inclines: &[Option<Quantity>],
) -> Result<ModelResult> {
    Ok(ModelResult {
        rms_over_noise: Some(fitted.rms()),
        heldout_rms_over_noise: Some(heldout_rms),
        quantities: quantities(model, fitted.at(), left.inflation(), inclines)?,
    })
}

/// The swing that would tell the cause taken last from a rival.
fn would_tell(found: &Found, rival: &Tried) -> Option<NextSwing> {
    let other = Model {
        causes: rival.causes.clone(),
        ..found.model.clone()
    };
    next_swing(
        &Explained {
            model: &found.model,
            point: &found.fitted.point,
            id: found.model.causes.last()?.id,
        },
        &Explained {
            model: &other,
            point: &rival.fitted.point,
            id: rival.cause.id,
        },
    )
}

/// What the extended model gains: χ² of so many samples held out before and after, and how the
/// figures moved.
fn gain(
    (before, after): (f64, f64),
    rows: usize,
    baseline: &ModelResult,
    extended: &ModelResult,
) -> Gain {
    let shifts = shifts(&baseline.quantities, &extended.quantities);
    Gain {
        heldout_rms_ratio: Some((before / after).sqrt()),
        log_score_per_sample: Some(0.5 * (before - after) / rows.max(1) as f64),
        k_yaw_shift_m: shifts.get(&QuantityName::KYaw).copied(),
        shifts,
    }
}

/// Changes of every quantity that both models give as a number.
fn shifts(
    before: &BTreeMap<QuantityName, QuantityResult>,
    after: &BTreeMap<QuantityName, QuantityResult>,
) -> BTreeMap<QuantityName, f64> {
    let change = |(name, new): (&QuantityName, &QuantityResult)| {
        let old = before.get(name)?.value.scalar()?;
        Some((name.clone(), new.value.scalar()? - old))
    };
    after.iter().filter_map(change).collect()
}
