//! From what the search found to what is said.

use std::collections::BTreeMap;

use gyradius_recording::{RepairKind, Sensor};

use super::cause_id::CauseId;
use super::fitted_swing::Base;
use super::fitting::Fitted;
use super::found::{Found, Round, Tried};
use super::parameter_id::{ParameterId, ParameterName};
use super::point::{Cause, Form};
use super::result::{CauseResult, CauseVerdict, ParameterResult, Status};
use super::unit::UnitName;
use super::words;
use gyradius_base::message::{Argument, Message};

/// Causes within this of the best, natural logarithm of the evidence, are not told from it: odds of
/// 100 to 1.
pub const NOT_TOLD: f64 = 4.6;
/// Two causes at once happen. Where more are needed together, each for what the others leave, one
/// that is not known is likelier.
pub const MOST_NAMED: usize = 2;
/// Gusts are irregular: a few tones account for most of them, not for all: what is left is held
/// against what showed before, or against the χ² that wind and tones took, much of which need not
/// show in any one band.
const LEFT_SHARE_OF_GUSTS: f64 = 0.3;
/// A model that leaves more than this, in noises, explains no session, however much it took: what
/// is held out must come within it.
pub const MOST_LEFT_RMS: f64 = 1.1;
/// A drag whose exponent is known to this and lies this near to 1, in standard uncertainties, is
/// quadratic.
const EXPONENT_U: f64 = 0.2;
const EXPONENT_NEAR: f64 = 3.0;

impl Found<'_> {
    /// Whether structure remains that nothing accounts for, or nothing but many causes together.
    pub fn is_unexplained(&self) -> bool {
        let many = self.model.named().count() > MOST_NAMED;
        let unnamed = self
            .model
            .causes
            .iter()
            .any(|cause| cause.id == CauseId::Unknown);
        many || unnamed || !self.leaves_little()
    }

    /// Whether what is left beyond noise is next to nothing beside what the base left.
    pub fn leaves_little(&self) -> bool {
        let gusts = self
            .model
            .causes
            .iter()
            .any(|cause| cause.form == Form::Gust);
        let explained = self
            .base_left
            .excess()
            .max(self.base.cost - self.fitted.cost);
        let of_gusts = gusts && self.left.excess() <= LEFT_SHARE_OF_GUSTS * explained;
        let is_little = of_gusts || self.left.is_next_to_nothing(&self.base_left);
        is_little && self.fitted.rms() <= MOST_LEFT_RMS
    }

    /// The round in which the last cause was taken.
    pub fn decisive(&self) -> Option<&Round> {
        self.rounds.iter().rev().find(|round| round.taken)
    }

    /// Causes that do as well as the last one taken, best first.
    pub fn rivals(&self) -> Vec<&Tried> {
        let Some(round) = self.decisive() else {
            return vec![];
        };
        let Some(best) = round.tried.first() else {
            return vec![];
        };
        // Where structure remains, evidence counts for less: in proportion to what is left.
        let allowed = NOT_TOLD.max(0.02 * best.left.excess());
        let near = |t: &&Tried| best.gain - t.gain < allowed && t.cause.id != CauseId::Unknown;
        let special =
            |t: &&Tried| are_one_drag([best.cause.id, t.cause.id], |k| parameters([best, t][k]));
        round.tried[1..]
            .iter()
            .filter(near)
            .filter(|t| !special(t))
            .collect()
    }

    pub fn verdict(&self) -> CauseVerdict {
        let mut named: Vec<CauseId> = self.model.named().map(|cause| cause.id).collect();
        named.extend(saturation(self.model.base).map(|cause| cause.id));
        let rivals: Vec<CauseId> = self.rivals().iter().map(|t| t.cause.id).collect();
        judged(named, rivals, self.is_unexplained())
    }

    /// Every cause of the rounds with its probability in its round; those taken first.
    pub fn causes(&self) -> Vec<CauseResult> {
        // Those taken have the values that they have beside all others.
        let place = |t: &Tried| {
            self.model
                .causes
                .iter()
                .position(|c| (c.id, c.form) == (t.cause.id, t.cause.form))
        };
        let of_taken =
            |t: &Tried| place(t).map(|k| parameters_of(&self.model.causes, &self.fitted, k));
        let results = |round: &Round| -> Vec<CauseResult> {
            let is_taken = |n: usize| round.taken && n == 0;
            let found = |(n, t): (usize, &Tried)| {
                let of_taken = is_taken(n).then(|| of_taken(t)).flatten();
                result(
                    t.cause.id,
                    t.gain,
                    of_taken.unwrap_or_else(|| parameters(t)),
                )
            };
            round.tried.iter().enumerate().map(found).collect()
        };
        let rounds = self
            .rounds
            .iter()
            .map(|round| (round.taken, results(round)));
        let left = self.is_unexplained().then(|| self.left.excess());
        ranked(rounds, left, saturation(self.model.base))
    }
}

/// The verdict from the names of the causes taken, of those that do as well as the last of them,
/// and whether structure remains.
pub fn judged(mut causes: Vec<CauseId>, rivals: Vec<CauseId>, unexplained: bool) -> CauseVerdict {
    let status = match (unexplained, causes.is_empty(), rivals.is_empty()) {
        (true, ..) => Status::Unexplained,
        (false, true, _) => Status::Adequate,
        (false, false, true) => Status::Explained,
        (false, false, false) => Status::Ambiguous,
    };
    if unexplained && !causes.contains(&CauseId::Unknown) {
        causes.push(CauseId::Unknown);
    }
    let indistinguishable_from = if status == Status::Ambiguous {
        rivals
    } else {
        vec![]
    };
    let mut verdict = CauseVerdict {
        status,
        causes,
        indistinguishable_from,
        ..Default::default()
    };
    verdict.message = in_words(&verdict);
    verdict
}

/// A cause that was tried, not ranked yet.
pub fn result(
    id: CauseId,
    gain: f64,
    parameters: BTreeMap<ParameterId, ParameterResult>,
) -> CauseResult {
    CauseResult {
        id,
        probability: 1.0,
        log_evidence_gain: gain,
        parameters,
        message: words::message("cause", [("cause", named(id))]),
        taken: false,
    }
}

/// Every cause of the rounds (whether their first was taken; what was tried, the best first) with
/// its probability in its round, what is left unexplained (χ²) and what shows by itself beside
/// them; those taken first.
pub fn ranked(
    rounds: impl Iterator<Item = (bool, Vec<CauseResult>)>,
    unexplained: Option<f64>,
    by_itself: Option<CauseResult>,
) -> Vec<CauseResult> {
    let mut list: Vec<CauseResult> = Vec::new();
    for (first_taken, mut tried) in rounds {
        // A power law that comes out as the quadratic drag before it is that drag, and shares no
        // probability with it.
        if let Some(drag) = tried
            .first()
            .filter(|first| first.id == CauseId::QuadraticDrag)
            .cloned()
        {
            tried.retain(|t| !are_one_drag([drag.id, t.id], |k| [&drag, t][k].parameters.clone()));
        }
        // The first need not be the one that gains most: where much is left, what was learned
        // without a name comes first.
        let most = tried
            .iter()
            .map(|t| t.log_evidence_gain)
            .fold(0.0, f64::max);
        let odds = |gain: f64| (gain - most).exp();
        let all: f64 = odds(0.0) + tried.iter().map(|t| odds(t.log_evidence_gain)).sum::<f64>();
        for (n, tried) in tried.into_iter().enumerate() {
            let taken = first_taken && n == 0;
            if taken || list.iter().all(|known| known.id != tried.id) {
                list.retain(|known| known.id != tried.id);
                let probability = odds(tried.log_evidence_gain) / all;
                list.push(CauseResult {
                    probability,
                    taken,
                    ..tried
                });
            }
        }
    }
    if let Some(excess) = unexplained.filter(|_| list.iter().all(|c| c.id != CauseId::Unknown)) {
        list.push(result(CauseId::Unknown, 0.5 * excess, BTreeMap::new()));
    }
    list.extend(by_itself);
    taken_first(&mut list);
    list
}

/// Causes that were taken before all others, each the most probable first.
pub fn taken_first(causes: &mut [CauseResult]) {
    causes.sort_by(|a, b| {
        let by = b.taken.cmp(&a.taken);
        by.then(b.probability.total_cmp(&a.probability))
    });
}

/// A verdict as a sentence.
fn in_words(verdict: &CauseVerdict) -> Message {
    let all = |ids: &[CauseId], join: &str| {
        words::row(ids.iter().map(|id| named(*id)).collect(), join, join)
    };
    let causes = verdict.causes.iter().copied();
    let known: Vec<CauseId> = causes.filter(|id| *id != CauseId::Unknown).collect();
    let causes = || ("causes", all(&known, "and_also"));
    match verdict.status {
        Status::Adequate => words::message("adequate", []),
        Status::Explained => words::message("explained", [causes()]),
        Status::Ambiguous => {
            let others = all(&verdict.indistinguishable_from, "or_also");
            words::message("ambiguous", [causes(), ("others", others)])
        }
        Status::Unexplained if known.is_empty() => words::message("unexplained", []),
        Status::Unexplained if known.len() > MOST_NAMED => words::message(
            "many",
            [("count", words::number(known.len() as f64, 0)), causes()],
        ),
        Status::Unexplained => words::message("remains", [causes()]),
    }
}

/// What a cause is, as a part of a sentence.
fn named(id: CauseId) -> Argument {
    words::word(&format!("cause.{id}"))
}

/// Fewer readings at a sensor's limit than this are no matter.
const LEAST_SATURATED: usize = 10;

/// Readings at the end of a sensor's range show it by themselves: they were left out, and nothing
/// needs to be fitted. Each of them, exactly alike as they are, counts for one nat at least.
pub fn saturation(base: &Base) -> Option<CauseResult> {
    let mut limits = BTreeMap::new();
    let mut count = 0;
    for fitted_swing in &base.swings {
        for repair in fitted_swing
            .evidence
            .repairs
            .iter()
            .filter(|r| r.kind == RepairKind::Saturation)
        {
            count += repair.count;
            let (name, unit, k) = match repair.sensor {
                Sensor::Gyroscope => (ParameterName::GyroRadS, UnitName::RadianPerSecond, 0),
                _ => (ParameterName::AccMS2, UnitName::MetrePerSecondSquared, 1),
            };
            let largest = fitted_swing.samples.streams[k]
                .values
                .iter()
                .map(|v| v.amax())
                .fold(0.0, f64::max);
            let noise = fitted_swing.samples.streams[k].noise.max();
            let known: &mut ParameterResult =
                limits.entry(name.into()).or_insert(ParameterResult {
                    value: largest,
                    u: noise,
                    unit: unit.into(),
                });
            known.value = known.value.max(largest);
        }
    }
    (count >= LEAST_SATURATED).then(|| CauseResult {
        taken: true,
        ..result(CauseId::Saturation, count as f64, limits)
    })
}

/// A power law whose exponent comes out as 1 is the quadratic drag itself, not another cause.
/// `parameters` are those of the first or the second of the two.
pub fn are_one_drag(
    ids: [CauseId; 2],
    parameters: impl Fn(usize) -> BTreeMap<ParameterId, ParameterResult>,
) -> bool {
    let Some(power) = ids.iter().position(|id| *id == CauseId::PowerLawDamping) else {
        return false;
    };
    if !ids.contains(&CauseId::QuadraticDrag) {
        return false;
    }
    let is_one =
        |e: &ParameterResult| e.u < EXPONENT_U && (e.value - 1.0).abs() < EXPONENT_NEAR * e.u;
    let found = parameters(power);
    found
        .iter()
        .filter(|(id, _)| id.name == ParameterName::Exponent)
        .all(|(_, e)| is_one(e))
}

/// What a cause that was tried is called, and what it gained: the logarithm of the evidence.
pub trait Ranked {
    fn id(&self) -> CauseId;
    fn gain(&self) -> f64;
}

impl Ranked for Tried {
    fn id(&self) -> CauseId {
        self.cause.id
    }

    fn gain(&self) -> f64 {
        self.gain
    }
}

/// Puts the quadratic drag before a power law that comes out as it and gains next to nothing more:
/// of two names for one thing the simpler stands. `tried` comes and goes with the best first.
pub fn simplest_first<T: Ranked>(
    tried: &mut [T],
    parameters: impl Fn(&T) -> BTreeMap<ParameterId, ParameterResult>,
) {
    let Some(best) = tried.first() else { return };
    let is_simpler = |t: &T| {
        t.id() == CauseId::QuadraticDrag
            && best.gain() - t.gain() < NOT_TOLD
            && are_one_drag([best.id(), t.id()], |k| parameters([best, t][k]))
    };
    if let Some(place) = tried.iter().position(is_simpler) {
        tried[..=place].rotate_right(1);
    }
}

/// Parameters of the cause that was tried.
pub fn parameters(tried: &Tried) -> BTreeMap<ParameterId, ParameterResult> {
    parameters_of(
        &tried.causes,
        &tried.fitted,
        tried.causes.len().saturating_sub(1),
    )
}

/// Parameters of one of the causes of a fitted model, in units of the rig.
pub fn parameters_of(
    causes: &[Cause],
    fitted: &Fitted,
    number: usize,
) -> BTreeMap<ParameterId, ParameterResult> {
    let Some((cause, values)) = causes.get(number).zip(fitted.point.causes.get(number)) else {
        return BTreeMap::new();
    };
    let swings = fitted.point.owns.len();
    let behind: usize = causes[number..]
        .iter()
        .map(|cause| cause.size(swings))
        .sum();
    let first = fitted.place_of_last(behind);
    let covariance = fitted.covariance();
    let mut found = BTreeMap::new();
    for (k, (parameter, own)) in cause.expanded(swings).into_iter().enumerate() {
        let u = covariance
            .as_ref()
            .map_or(f64::INFINITY, |c| c[(first + k, first + k)].max(0.0).sqrt());
        let name = ParameterId::of(parameter.name, own);
        found.insert(name, parameter.result(values[k], u));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Drag(CauseId, f64);

    impl Ranked for Drag {
        fn id(&self) -> CauseId {
            self.0
        }

        fn gain(&self) -> f64 {
            self.1
        }
    }

    /// Which of a power law of an exponent, with its uncertainty and its gain, and a quadratic drag
    /// that gained 100 stands first.
    fn first(exponent: f64, u: f64, gain: f64) -> CauseId {
        let mut tried = vec![
            Drag(CauseId::PowerLawDamping, gain),
            Drag(CauseId::Wind, 99.9),
            Drag(CauseId::QuadraticDrag, 100.0),
        ];
        tried.sort_by(|a, b| b.1.total_cmp(&a.1));
        let found = ParameterResult {
            value: exponent,
            u,
            unit: UnitName::One.into(),
        };
        simplest_first(&mut tried, |_| {
            BTreeMap::from([(ParameterName::Exponent.into(), found.clone())])
        });
        tried[0].0
    }

    #[test]
    fn a_power_law_that_is_the_quadratic_drag_is_called_so() {
        assert_eq!(first(1.1, 0.1, 100.5), CauseId::QuadraticDrag);
        assert_eq!(first(1.1, 0.1, 99.0), CauseId::QuadraticDrag);
        // Another exponent, one that is hardly known, and far more evidence.
        assert_eq!(first(0.5, 0.1, 100.5), CauseId::PowerLawDamping);
        assert_eq!(first(1.1, 0.5, 100.5), CauseId::PowerLawDamping);
        assert_eq!(first(1.1, 0.1, 110.0), CauseId::PowerLawDamping);
    }

    #[test]
    fn a_power_law_that_is_the_quadratic_drag_takes_no_probability_from_it() {
        let ranking = |exponent: f64| {
            let found = ParameterResult {
                value: exponent,
                u: 0.1,
                unit: UnitName::One.into(),
            };
            let of_power = BTreeMap::from([(ParameterName::Exponent.into(), found)]);
            let tried = vec![
                result(CauseId::QuadraticDrag, 100.0, BTreeMap::new()),
                result(CauseId::PowerLawDamping, 100.0, of_power),
                result(CauseId::Wind, 60.0, BTreeMap::new()),
            ];
            let ranked = ranked([(true, tried)].into_iter(), None, None);
            let ids: Vec<CauseId> = ranked.iter().map(|cause| cause.id).collect();
            (ids, ranked[0].probability)
        };
        let (ids, probability) = ranking(1.1);
        assert_eq!(ids, [CauseId::QuadraticDrag, CauseId::Wind]);
        assert!(probability > 0.999);
        // Another law that does as well halves it.
        let (ids, probability) = ranking(0.5);
        let three = [
            CauseId::QuadraticDrag,
            CauseId::PowerLawDamping,
            CauseId::Wind,
        ];
        assert_eq!(ids, three);
        assert!((probability - 0.5).abs() < 1e-3);
    }
}
