//! What these data cannot decide, and what it leaves open of the body: causes that do as well as
//! the one named, and causes too weak to be seen that may yet be there.
//!
//! A clock that is wrong by 0.1 % shows at 3 standard deviations and moves a gyradius by 30 of its
//! own: the model without it is believed, and its uncertainty alone would be wrong. Each such cause
//! is a model of its own, with the odds of its evidence and of what was known before, and an
//! interval holds 95 % of all of them together (Bayesian model averaging: J. A. Hoeting et al.,
//! *Statistical Science* 14 (1999) 382).

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal};

use gyradius_identification::{COVERAGE_95, QuantityName, QuantityResult};
use gyradius_recording::Quantity;

use super::cause_id::CauseId;
use super::fitting::{Fitted, Places};
use super::found::Found;
use super::found::Tried;
use super::look::{Beside, Look, ScoreTest, Sums, laid_out, strengths};
use super::point::{Cause, Model, Point};
use super::quantities::quantities;

/// Odds below this move no interval of 95 %.
const LEAST_ODDS: f64 = 1e-3;
/// Standard deviations of a dimension of the body by which the ends of two fits differ that are not
/// one.
const ELSEWHERE: f64 = 0.1;
/// Halvings of the bracket of an interval.
const HALVINGS: usize = 60;

/// The body by another model, with that model's odds against the one that is believed.
pub struct Otherwise {
    odds: f64,
    quantities: BTreeMap<QuantityName, QuantityResult>,
}

impl Otherwise {
    /// No model counts for more than the one that is believed: what is passed over for the
    /// structure that it leaves may have gained far more.
    pub fn new(odds: f64, quantities: BTreeMap<QuantityName, QuantityResult>) -> Self {
        Self {
            odds: odds.min(1.0),
            quantities,
        }
    }
}

impl Found<'_> {
    /// What else may be: rivals of the cause taken last, what was not taken where no more is to be
    /// seen, and the causes with a name alone.
    pub fn otherwise(&self, inclines: &[Option<Quantity>]) -> Vec<Otherwise> {
        let mut all = self.instead(inclines);
        all.extend(self.besides(inclines));
        all.extend(self.named_alone(inclines));
        all
    }

    /// The body by the causes with a name alone, where something without one is beside them. What that
    /// does to the body's figures is known no better than its law: the truth may be anywhere from
    /// there to here.
    pub fn named_alone(&self, inclines: &[Option<Quantity>]) -> Option<Otherwise> {
        let has_name = |_, cause: &Cause| cause.id != CauseId::Unknown;
        let (model, start) = self.model.whole().only(&self.fitted.point, has_name);
        if model.causes.len() == self.model.causes.len() {
            return None;
        }
        let fitted = if model.causes.is_empty() {
            self.base.clone()
        } else {
            model.fit(&start, &|_| false).ok()?
        };
        let body = quantities(&model, fitted.at(), 1.0, inclines).ok()?;
        Some(Otherwise::new(1.0, body))
    }

    /// Rivals of the cause taken last, and other valleys of its own. Rivals that a verdict calls
    /// alike count alike.
    fn instead(&self, inclines: &[Option<Quantity>]) -> Vec<Otherwise> {
        let rivals = self.rivals();
        let Some(best) = self.decisive().and_then(|round| round.tried.first()) else {
            return vec![];
        };
        let by_evidence = |t: &Tried| (t.gain - best.gain).exp();
        let odds = |t: &Tried| {
            if self.is_unexplained() {
                by_evidence(t)
            } else {
                1.0
            }
        };
        let rivals = rivals
            .into_iter()
            .filter_map(|t| self.by(t, odds(t), inclines));
        let elsewhere = best
            .ends
            .iter()
            .filter(|end| by_evidence(end) > LEAST_ODDS && self.is_elsewhere(end, best));
        rivals
            .chain(elsewhere.filter_map(|end| self.by(end, by_evidence(end), inclines)))
            .collect()
    }

    /// Whether a fit ended with another body than the best: two that did not are one model.
    fn is_elsewhere(&self, end: &Tried, best: &Tried) -> bool {
        let Some(covariance) = best.fitted.covariance() else {
            return false;
        };
        let moved = |i: usize| (end.fitted.point.x[i] - best.fitted.point.x[i]).abs();
        let free = self.model.base.free.iter().enumerate();
        free.map(|(k, i)| moved(*i) / covariance[(k, k)].sqrt())
            .any(|z| z > ELSEWHERE)
    }

    /// Causes that were not taken: those fitted in full, and the weak ones by what first looks saw
    /// of them.
    fn besides(&self, inclines: &[Option<Quantity>]) -> Vec<Otherwise> {
        let last = self
            .rounds
            .last()
            .filter(|round| !round.taken && self.left.is_white());
        let Some((round, looked)) =
            last.and_then(|round| round.looked.as_ref().map(|looked| (round, looked)))
        else {
            return vec![];
        };
        let odds_before = odds_before(&looked.looks);
        // Something may have been taken out of the model since.
        let is_beside = |t: &&Tried| t.causes.len() == self.model.causes.len() + 1;
        let tried: Vec<&Tried> = round.tried.iter().filter(is_beside).collect();
        let in_full = tried
            .iter()
            .filter_map(|t| self.by(t, odds_before * t.gain.exp(), inclines));
        let of_name = |id: CauseId| {
            looked
                .looks
                .iter()
                .filter(|look| look.cause.id == id)
                .count()
        };
        let weak = looked
            .looks
            .iter()
            .filter(|look| tried.iter().all(|t| t.cause.id != look.cause.id));
        let weak = weak.filter_map(|look| {
            let weak = Weak::of(look.score_test.as_ref()?, &self.model, &looked.fitted)?;
            // The forms of a cause share its odds.
            let odds = odds_before * weak.gain.exp() / of_name(look.cause.id) as f64;
            let body = || quantities(&weak.model, (&weak.point, &weak.matrix), 1.0, inclines).ok();
            let quantities = (odds > LEAST_ODDS).then(body).flatten()?;
            Some(Otherwise::new(odds, quantities))
        });
        in_full.chain(weak).collect()
    }

    /// The body by a model that was tried, with its odds.
    fn by(&self, t: &Tried, odds: f64, inclines: &[Option<Quantity>]) -> Option<Otherwise> {
        let model = Model {
            causes: t.causes.clone(),
            ..self.model.clone()
        };
        let quantities = quantities(&model, t.fitted.at(), 1.0, inclines).ok()?;
        Some(Otherwise::new(odds, quantities))
    }
}

/// Before the data a session is as likely as not to have something that the simulation lacks, and
/// that may be any of the causes alike: odds of each against none of them.
fn odds_before(looks: &[Look]) -> f64 {
    let names: BTreeSet<CauseId> = looks.iter().map(|look| look.cause.id).collect();
    (names.len().max(1) as f64).recip()
}

/// A model with one more cause so weak that all is linear in it.
struct Weak<'a> {
    model: Model<'a>,
    point: Point,
    matrix: DMatrix<f64>,
    /// Of the logarithm of the evidence.
    gain: f64,
}

impl<'a> Weak<'a> {
    fn of(score_test: &ScoreTest, model: &Model<'a>, fitted: &Fitted) -> Option<Self> {
        let ScoreTest {
            cause,
            places,
            sums,
        } = score_test;
        if fitted.matrix.nrows() != Places::of(model).all() {
            return None;
        }
        let beside = Beside::of(fitted, sums)?;
        let mut inner = sums.inner.clone();
        let (strength, gain) = match (cause.one_sided, places.len()) {
            (true, 1) => {
                let (strength, information, gain) =
                    above_zero(beside.score[0], beside.schur[(0, 0)], sums.u[0])?;
                inner[(0, 0)] += information - beside.schur[(0, 0)];
                (DVector::from_element(1, strength), gain)
            }
            _ => strengths(&beside.schur, &beside.score, &sums.u, cause.one_sided)?,
        };
        if strength.iter().all(|s| *s == 0.0) {
            return None;
        }
        let swings = model.base.swings.len();
        let mut values = vec![0.0; cause.size(swings)];
        places
            .iter()
            .zip(strength.iter())
            .for_each(|(place, strength)| values[*place] = *strength);
        let delta = laid_out(model, &beside.rest(&strength), &values);
        let mut at = fitted.point.clone();
        at.causes.push(cause.start(swings));
        let extended = model.with(cause);
        let point = extended.bounded(extended.moved(&at, &delta));
        let u: Vec<f64> = cause
            .expanded(swings)
            .iter()
            .map(|(parameter, _)| parameter.prior.1)
            .collect();
        let matrix = with_strengths(
            model,
            fitted,
            &Sums {
                inner,
                ..sums.clone()
            },
            (places, &u),
        );
        Some(Self {
            model: extended,
            point,
            matrix,
            gain,
        })
    }
}

/// Information with that of a cause's values behind the other causes': of those that are no
/// strengths, that of their priors.
fn with_strengths(
    model: &Model,
    fitted: &Fitted,
    sums: &Sums,
    (places, u): (&[usize], &[f64]),
) -> DMatrix<f64> {
    let split = Places::of(model).first_own(0);
    let count = u.len();
    let grown = fitted
        .matrix
        .clone()
        .insert_rows(split, count, 0.0)
        .insert_columns(split, count, 0.0);
    let outer = sums.beside_held(fitted).insert_rows(split, count, 0.0);
    let mut matrix = grown;
    (0..count).for_each(|k| matrix[(split + k, split + k)] = u[k].powi(-2));
    for (k, place) in places.iter().enumerate() {
        let at = split + place;
        matrix.set_column(at, &outer.column(k));
        matrix.set_row(at, &outer.column(k).transpose());
        places
            .iter()
            .enumerate()
            .for_each(|(l, other)| matrix[(at, split + other)] = sums.inner[(k, l)]);
    }
    matrix
}

/// A strength that cannot be negative, by its score and its information, prior of a given width
/// included: mean, information, and the gain of the logarithm of the evidence. (A normal variable
/// cut at zero: N. L. Johnson, S. Kotz, N. Balakrishnan, *Continuous Univariate Distributions* 1,
/// 2nd ed., sec. 13.10.1.)
fn above_zero(score: f64, information: f64, prior_u: f64) -> Option<(f64, f64, f64)> {
    let normal = Normal::standard();
    let s = information.sqrt().recip();
    let mean = score / information;
    let above = normal.cdf(mean / s);
    // Further below zero nothing is left of it.
    if above < 1e-12 {
        return None;
    }
    let ratio = (-0.5 * (mean / s).powi(2)).exp() / (std::f64::consts::TAU.sqrt() * above);
    let variance = s * s * (1.0 - ratio * (mean / s + ratio));
    let gain = (2.0 * above).ln() + 0.5 * (mean / s).powi(2) - (prior_u / s).ln();
    Some((mean + s * ratio, variance.recip(), gain))
}

/// Widens intervals until they hold 95 % of all models together; the uncertainty is the half of one
/// over that of a normal variable.
pub fn widen(quantities: &mut BTreeMap<QuantityName, QuantityResult>, otherwise: &[Otherwise]) {
    let number = |q: &QuantityResult| Some((q.value.scalar()?, q.u.scalar()?));
    for (name, quantity) in quantities {
        let Some((value, u)) = number(quantity) else {
            continue;
        };
        let others = otherwise.iter().filter_map(|other| {
            let (elsewhere, other_u) = number(other.quantities.get(name)?)?;
            // What another model knows better is no doubt about this one.
            Some((other.odds, elsewhere - value, other_u.max(u)))
        });
        let all: Vec<(f64, f64, f64)> = [(1.0, 0.0, u)].into_iter().chain(others).collect();
        let half = half_width_95(&all);
        quantity.u = (half / COVERAGE_95).into();
        quantity.interval_95 = Some([value - half, value + half]);
    }
}

/// Half of the interval about zero that holds 95 % of normal variables of given odds, means and
/// standard deviations.
pub(super) fn half_width_95(all: &[(f64, f64, f64)]) -> f64 {
    let (normal, total) = (
        Normal::standard(),
        all.iter().map(|(odds, ..)| odds).sum::<f64>(),
    );
    let outside = |half: f64| {
        let one = |(odds, mean, u): &(f64, f64, f64)| {
            odds * (normal.sf((half - mean) / u) + normal.cdf((-half - mean) / u))
        };
        all.iter().map(one).sum::<f64>() / total
    };
    let widest = all
        .iter()
        .map(|(_, mean, u)| mean.abs() + COVERAGE_95 * u)
        .fold(0.0, f64::max);
    let (mut low, mut high) = (0.0, widest);
    for _ in 0..HALVINGS {
        let half = 0.5 * (low + high);
        if outside(half) > 0.05 {
            low = half
        } else {
            high = half
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;
    use gyradius_identification::Method;

    #[test]
    fn one_model_keeps_its_interval_and_two_share_theirs() {
        assert!((half_width_95(&[(1.0, 0.0, 2.0)]) - 2.0 * COVERAGE_95).abs() < 1e-9);
        // scipy.optimize.brentq over scipy.stats.norm: 0.9 N(0, 1) + 0.1 N(3, 2^2).
        let two = half_width_95(&[(9.0, 0.0, 1.0), (1.0, 3.0, 2.0)]);
        assert!((two - 3.0947098415).abs() < 1e-9, "{two}");
    }

    /// A rival whose evidence is beyond all numbers (it was passed over for what it leaves) once
    /// took all width from an interval.
    #[test]
    fn a_model_passed_over_counts_like_the_one_believed() {
        let body = |value: f64, u: f64| {
            let method = Method::JointEstimate;
            let quantity = QuantityResult {
                value: value.into(),
                u: u.into(),
                interval_95: None,
                method,
            };
            BTreeMap::from([(QuantityName::KYaw, quantity)])
        };
        let mut believed = body(1.0, 0.1);
        widen(
            &mut believed,
            &[Otherwise::new(f64::INFINITY, body(4.0, 0.1))],
        );
        // Half of all lies 30 of its widths away: of that one in ten beyond the end, at
        // 1.2815515655 of them (scipy.stats.norm.isf(0.1)).
        let half = believed["k_yaw_m"].u.scalar().unwrap() * COVERAGE_95;
        assert!((half - 3.12815515655).abs() < 1e-9, "{half}");
    }

    #[test]
    fn a_strength_above_zero_is_a_truncated_normal_variable() {
        // scipy.stats.truncnorm(-mean / s, inf, mean, s) with mean -0.4, s 0.5; evidence by quad
        // over a half normal prior of width 2 times exp(score x - information_of_data x^2 / 2).
        let (mean, information, gain) = above_zero(-0.4 / 0.25, 4.0, 2.0).unwrap();
        assert!(
            (mean - 0.2837011346).abs() < 1e-9 && (information.recip() - 0.0560332124).abs() < 1e-9,
            "{mean}"
        );
        assert!((gain + 1.9249984997).abs() < 1e-9, "{gain}");
    }
}
