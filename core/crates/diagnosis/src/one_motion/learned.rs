//! The missing torque where no known cause accounts for it, and the simplest closed form that does
//! as well.

use gyradius_estimation::Fit;
use gyradius_identification::one_motion::solve;

use super::super::cause_id::CauseId;
use super::super::causes::TERMS;
use super::super::learned::{grid, shapes, written};
use super::super::result::LearnedForce;
use super::super::selection::{Set, TOLD};
use super::super::term::Term;
use super::super::unit::UnitName;
use super::super::words::message;
use super::catalogue::{Cause, unknown};
use super::found::Found;
use super::swing::Swing;

/// Terms that do as well as all of them, and the fit with them.
struct Closed {
    terms: Vec<Term>,
    cause: Cause,
    fit: Fit,
}

/// The torque over inertia that the model has in the first swing beside causes with a name.
pub fn force(found: &Found) -> Option<LearnedForce> {
    let is_unknown = |form: &&usize| found.decision.selection.id(**form) == CauseId::Unknown;
    let form = *found
        .decision
        .best
        .set
        .iter()
        .find(is_unknown)
        .filter(|_| found.decision.is_unknown)?;
    let (swing, one) = (&found.swings[0], &found.decision.best.swings[0]);
    let named: Set = found
        .decision
        .best
        .set
        .iter()
        .copied()
        .filter(|f| *f != form)
        .collect();
    let closed = closed_form(swing, &named, &one.x)?;
    let scales = swing.scales();
    let reach = (scales.reach_rad, scales.rate_rad_s());
    let factor = scales.restoring_rad_s2();
    // It is the last cause of the catalogue, and of every set.
    let (first, size) = (one.x.len() - TERMS.len(), TERMS.len());
    let covariance = one
        .covariance
        .as_ref()?
        .view((first, first), (size, size))
        .into_owned();
    let values = &closed.fit.x[closed.fit.x.len() - closed.terms.len()..];
    let sum = closed.terms.iter().zip(values).map(|(term, q)| {
        let (powers, scale) = written(*term, ("θ", "ω"), reach.0, reach.1);
        format!("{:+.4e} {powers}", -q * factor / scale)
    });
    let sum: Vec<String> = sum.collect();
    let looks = shapes(closed.terms.iter().copied());
    let (_, after, rows) = found.decision.held_out;
    Some(LearnedForce {
        coordinate: swing.mode.into(),
        unit: UnitName::RadianPerSecondSquared.into(),
        points: grid(&TERMS, (&one.x[first..], &covariance), factor, reach),
        equation: format!("M/I = {} rad/s^2", sum.join(" ")),
        message: message("learned_looks", [("shapes", looks)]),
        heldout_rms_over_noise: Some((after / rows.max(1) as f64).sqrt()),
        closed_heldout_rms_over_noise: heldout_rms(swing, &named, &closed),
    })
}

/// The best single term, and further ones while the evidence asks for them.
fn closed_form(swing: &Swing, named: &Set, x: &[f64]) -> Option<Closed> {
    let widest = swing.form_of(CauseId::Unknown)?;
    let u = swing.catalogue[widest].parameters.first()?.prior.1;
    let restoring = swing.scales().restoring_rad_s2();
    let without = &x[..x.len() - TERMS.len()];
    let evidence = |closed: &Closed| closed.fit.log_evidence().unwrap_or(f64::NEG_INFINITY);
    let mut best: Option<Closed> = None;
    for _ in 0..TERMS.len() {
        let known = best.as_ref().map_or(vec![], |closed| closed.terms.clone());
        let start = best.as_ref().map_or(without, |closed| &closed.fit.x);
        let open = TERMS.iter().filter(|term| !known.contains(term));
        let further = open.filter_map(|term| {
            let terms = [&known[..], &[*term]].concat();
            let cause = unknown(&terms, restoring, u);
            let mut effects = swing.fittings(named);
            effects.push(cause.fitting());
            let start: Vec<f64> = start.iter().copied().chain([0.0]).collect();
            let fit = solve(&swing.problem(&effects), &start)?;
            Some(Closed { terms, cause, fit })
        });
        let next = further.max_by(|a, b| evidence(a).total_cmp(&evidence(b)))?;
        if best
            .as_ref()
            .is_some_and(|best| evidence(&next) < evidence(best) + TOLD)
        {
            break;
        }
        best = Some(next);
    }
    best
}

fn heldout_rms(swing: &Swing, named: &Set, closed: &Closed) -> Option<f64> {
    let mut effects = swing.fittings(named);
    effects.push(closed.cause.fitting());
    let rows = swing.held_out(&effects, &closed.fit.x)?;
    Some((rows.norm_squared() / rows.len().max(1) as f64).sqrt())
}
