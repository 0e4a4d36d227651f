//! The criticism of sessions that hold periods alone: typed in, or listed by a gate or a stopwatch.
//!
//! No single swing shows a cause here; swings against each other and against the tape do. The joint
//! estimate with its stated dimensions as priors is the base; each cause joins it as one or two
//! more parameters, and the evidence decides.

mod causes;
mod choice;
mod figures;
mod model;
mod next_swing;
mod words;

use std::collections::BTreeMap;

use gyradius_base::error::{Error, Result};
use gyradius_base::message::Message;
use gyradius_identification::outputs::write_quantities;
use gyradius_identification::{
    Analysis, Measurement, QuantityName, QuantityResult, solved_periods,
};
use gyradius_identification::{GRAVITY, NO_GRAVITY, NO_JOINT_ESTIMATE};
use gyradius_recording::LoadedSession;

use super::cause_id::CauseId;
use super::result::{
    CauseResult, CauseVerdict, Criticism, Critique, Gain, ModelResult, NextSwing, Status,
};
use super::words::message;
use super::{FORMAT, shifts};
pub use causes::CAUSES;
use choice::Choice;
use model::{Fitted, HeldOut, Setting};

/// Criticises a session by its periods; `analysis` is that of the same session.
///
/// # Errors
/// Where the session's periods and dimensions have no common solution.
pub fn criticise_periods(loaded: &LoadedSession, analysis: &Analysis) -> Result<Criticism> {
    let setting = Setting::new(solved_periods(loaded)?, analysis)?;
    let choice = Choice::of(&setting)?;
    let warnings_said = warnings(analysis);
    let critique = Critique {
        format: FORMAT.into(),
        title: analysis.measurement.title.clone(),
        baseline: model_result(&choice.base),
        discrepancies: words::discrepancies(&choice.base),
        causes: cause_results(&setting, &choice),
        verdict: verdict(&setting, &choice),
        extended: model_result(choice.extended()),
        gain: gain(&choice.base, choice.extended()),
        learned: None,
        findings: Vec::new(),
        warnings: warnings_said,
    };
    Ok(Criticism {
        critique,
        traces: vec![],
    })
}

/// The swing that would tell two causes apart, each fitted to the periods beside nothing
/// else; `None` where none thought of does.
///
/// # Errors
/// [`Error::Argument`] for a cause that periods do not show; [`Error::NoResult`] where one
/// cannot be fitted.
pub fn tell_apart_by_periods(
    loaded: &LoadedSession,
    analysis: &Analysis,
    names: [CauseId; 2],
) -> Result<Option<NextSwing>> {
    let setting = Setting::new(solved_periods(loaded)?, analysis)?;
    let [one, other] = [fitted(&setting, names[0])?, fitted(&setting, names[1])?];
    Ok(next_swing::next_swing(&setting, &one, &[other]))
}

fn fitted<'a>(setting: &Setting<'a>, name: CauseId) -> Result<Fitted<'a>> {
    let cause = CAUSES
        .iter()
        .find(|cause| cause.id == name)
        .ok_or_else(|| {
            let names: Vec<&str> = CAUSES.iter().map(|cause| cause.id.name()).collect();
            Error::argument(
                "cause",
                format!("one of {} (what periods show)", names.join(", ")),
                name,
            )
        })?;
    setting
        .fit(&[cause])
        .ok_or_else(|| Error::no_result(name.name(), "it cannot be fitted to this session"))
}

fn warnings(analysis: &Analysis) -> Vec<Message> {
    // What the joint estimate says of contradictions, the criticism says itself.
    let other = |w: &&Message| {
        let about = [NO_GRAVITY, GRAVITY, NO_JOINT_ESTIMATE];
        about.iter().any(|key| w.is_about(key))
    };
    let others = analysis.measurement.warnings.iter().filter(other).cloned();
    [message("periods_alone", [])]
        .into_iter()
        .chain(others)
        .collect()
}

fn quantities(fitted: &Fitted) -> BTreeMap<QuantityName, QuantityResult> {
    let mut result = Measurement::default();
    write_quantities(&fitted.system, &fitted.solution, &mut result);
    result.quantities
}

fn model_result(fitted: &Fitted) -> ModelResult {
    let held_out = observed(fitted);
    let z: Vec<f64> = held_out.iter().flatten().map(|h| h.z).collect();
    ModelResult {
        rms_over_noise: fitted.rms_over_noise(),
        heldout_rms_over_noise: rms(&z),
        quantities: quantities(fitted),
    }
}

/// Observations against all other rows; the stated figures are no observations.
fn observed(fitted: &Fitted) -> Vec<Option<HeldOut>> {
    let mut held_out = fitted.held_out();
    held_out.truncate(fitted.system.observations.len());
    held_out
}

fn rms(z: &[f64]) -> Option<f64> {
    (!z.is_empty()).then(|| (z.iter().map(|z| z * z).sum::<f64>() / z.len() as f64).sqrt())
}

/// By observations that both models predict.
fn gain(base: &Fitted, extended: &Fitted) -> Gain {
    let (base_held, extended_held) = (observed(base), observed(extended));
    let both: Vec<(HeldOut, HeldOut)> = base_held
        .into_iter()
        .zip(extended_held)
        .filter_map(|(a, b)| a.zip(b))
        .collect();
    let z =
        |pick: fn(&(HeldOut, HeldOut)) -> f64| rms(&both.iter().map(pick).collect::<Vec<f64>>());
    let score = |h: &HeldOut| -0.5 * h.z * h.z - h.u.ln();
    let scores: f64 = both.iter().map(|(a, b)| score(b) - score(a)).sum();
    let shifts = shifts(&quantities(base), &quantities(extended));
    Gain {
        heldout_rms_ratio: z(|(a, _)| a.z).zip(z(|(_, b)| b.z)).map(|(a, b)| a / b),
        log_score_per_sample: (!both.is_empty()).then(|| scores / both.len() as f64),
        k_yaw_shift_m: shifts.get(&QuantityName::KYaw).copied(),
        shifts,
    }
}

/// Taken ones in the order in which they were found, then what is left unexplained, then the others
/// by evidence.
fn cause_results(setting: &Setting, choice: &Choice) -> Vec<CauseResult> {
    let mut taken = Vec::new();
    for (i, round) in choice.taken().enumerate() {
        taken.extend(
            round
                .results(setting)
                .into_iter()
                .filter(|c| c.id == choice.extended().causes[i].id),
        );
    }
    taken.iter_mut().for_each(|cause| cause.taken = true);
    let mut others: Vec<CauseResult> = choice.rounds.first().map_or(vec![], |r| r.results(setting));
    others.retain(|cause| taken.iter().all(|t| t.id != cause.id));
    let unknown =
        (choice.standing() == Status::Unexplained).then(|| words::unknown(setting, choice));
    taken.into_iter().chain(unknown).chain(others).collect()
}

fn verdict(setting: &Setting, choice: &Choice) -> CauseVerdict {
    let standing = choice.standing();
    let mut causes: Vec<CauseId> = choice.extended().causes.iter().map(|c| c.id).collect();
    if standing == Status::Unexplained {
        causes.push(CauseId::Unknown);
    }
    let next_swing = next_swing::next_swing(setting, choice.extended(), &choice.rivals);
    let said = words::verdict(choice);
    CauseVerdict {
        status: standing,
        causes,
        indistinguishable_from: choice.rival_names(),
        message: said,
        next_swing,
    }
}
