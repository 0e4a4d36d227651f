//! The missing torque where no known cause accounts for it, and the simplest closed form that does
//! as well.

use super::super::cause_id::CauseId;
use super::super::causes::TERMS;
use super::super::evidence::LEAST_GAIN;
use super::super::learned::{grid, shapes, written};
use super::super::point::Part;
use super::super::result::LearnedForce;
use super::super::term::Term;
use super::super::unit::UnitName;
use super::super::words::message;
use super::causes::{Cause, Kind, learned};
use super::fitting::{Fitted, fit};
use super::search::Found;

/// Terms that do as well as all of them, and the fit with them.
struct Closed {
    terms: Vec<Term>,
    fitted: Fitted,
}

/// The torque over inertia that the last cause is in the first swing, where it is one without a
/// name.
pub fn force(found: &Found, heldout_rms: f64) -> Option<LearnedForce> {
    let place = *found
        .best
        .causes
        .last()
        .filter(|place| found.id(**place) == CauseId::Unknown)?;
    let (swing, fitted) = (&found.swings[0], &found.best.fits[0]);
    let cause = &swing.catalogue[place];
    let Kind::Learned(terms) = &cause.kind else {
        return None;
    };
    let closed = closed_form(found)?;
    let scales = &swing.scales;
    let reach = (scales.reach_rad, scales.rate_rad_s());
    let factor = cause.parameters.first()?.factor;
    let (first, size) = (fitted.point.len() - terms.len(), terms.len());
    let covariance = fitted
        .covariance()?
        .view((first, first), (size, size))
        .into_owned();
    let values = &closed.fitted.point[closed.fitted.point.len() - closed.terms.len()..];
    let sum: Vec<String> = closed
        .terms
        .iter()
        .zip(values)
        .map(|(term, q)| {
            let (powers, scale) = written(*term, ("θ", "ω"), reach.0, reach.1);
            format!("{:+.4e} {powers}", -q * factor / scale)
        })
        .collect();
    let looks = shapes(closed.terms.iter().copied());
    Some(LearnedForce {
        coordinate: swing.mode.into(),
        unit: UnitName::RadianPerSecondSquared.into(),
        points: grid(terms, (&fitted.point[first..], &covariance), factor, reach),
        equation: format!("M/I = {} rad/s^2", sum.join(" ")),
        message: message("learned_looks", [("shapes", looks)]),
        heldout_rms_over_noise: Some(heldout_rms),
        closed_heldout_rms_over_noise: heldout_rms_of(found, &closed),
    })
}

fn with<'a>(found: &'a Found, last: &'a Cause) -> Vec<&'a Cause> {
    let mut causes = found.best.causes_of(&found.swings[0]);
    causes.pop();
    causes.push(last);
    causes
}

/// The best single term, and a second where it pays.
fn closed_form(found: &Found) -> Option<Closed> {
    let (swing, without) = (&found.swings[0], &found.before.as_ref()?.fits[0]);
    let mut best: Option<Closed> = None;
    for _ in 0..2 {
        let known = best.as_ref().map_or(vec![], |closed| closed.terms.clone());
        let further = TERMS
            .iter()
            .filter(|term| !known.contains(term))
            .filter_map(|term| {
                let terms = [&known[..], &[*term]].concat();
                let cause = learned(&swing.scales, &terms);
                let start: Vec<f64> = without.point.iter().copied().chain(cause.start()).collect();
                let fitted = fit(swing, &with(found, &cause), Part::All, &start)?;
                Some(Closed { terms, fitted })
            });
        let next = further.min_by(|a, b| a.fitted.cost.total_cmp(&b.fitted.cost))?;
        let pays = |closed: &Closed| closed.fitted.cost - next.fitted.cost > 2.0 * LEAST_GAIN;
        if best.as_ref().is_some_and(|closed| !pays(closed)) {
            break;
        }
        best = Some(next);
    }
    best
}

fn heldout_rms_of(found: &Found, closed: &Closed) -> Option<f64> {
    let swing = &found.swings[0];
    let cause = learned(&swing.scales, &closed.terms);
    let causes = with(found, &cause);
    let there = fit(swing, &causes, Part::Fitted, &closed.fitted.point)?;
    let rows = swing.residual(&there.point, &causes, Part::HeldOut)?;
    Some((rows.norm_squared() / rows.len().max(1) as f64).sqrt())
}
