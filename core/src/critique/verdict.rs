//! From what the search found to what is said.

use crate::recording::{RepairKind, Sensor};

use super::base::Base;
use super::causes::UNKNOWN;
use super::fitting::Fitted;
use super::point::{Cause, Form, Model};
use super::result::{CauseResult, CauseVerdict, ParameterResult};
use super::search::{Found, Round, Tried};

/// Causes within this of the best, natural logarithm of the evidence, are not told from it: odds of 100 to 1.
pub const NOT_TOLD: f64 = 4.6;
/// What is left may be this share of what the base simulation left: laws differ a little from nature's.
pub const LEFT_SHARE: f64 = 0.01;
/// Gusts are irregular: a few tones account for most of them, not for all.
const LEFT_SHARE_OF_GUSTS: f64 = 0.3;
/// A drag whose exponent is known to this and lies this near to 1, in standard uncertainties, is quadratic.
pub const EXPONENT_U: f64 = 0.2;
pub const EXPONENT_NEAR: f64 = 3.0;

impl Found<'_> {
    /// Whether structure remains that nothing accounts for.
    pub fn is_unexplained(&self) -> bool {
        let unnamed = self.model.causes.iter().any(|cause| cause.id == UNKNOWN);
        let gusts = self.model.causes.iter().any(|cause| cause.form == Form::Gust);
        let share = if gusts { LEFT_SHARE_OF_GUSTS } else { LEFT_SHARE };
        unnamed || (!self.left.is_white() && self.left.excess() > share * self.base_left.excess())
    }

    /// The round in which the last cause was taken.
    fn decisive(&self) -> Option<&Round> {
        self.rounds.iter().rev().find(|round| round.taken)
    }

    /// Causes that do as well as the last one taken, best first.
    pub fn rivals(&self) -> Vec<&Tried> {
        let Some(round) = self.decisive() else { return vec![] };
        let Some(best) = round.tried.first() else { return vec![] };
        // Where structure remains, evidence counts for less: in proportion to what is left.
        let allowed = NOT_TOLD.max(0.02 * best.left.excess());
        let near = |t: &&Tried| best.gain - t.gain < allowed && t.cause.id != UNKNOWN;
        round.tried[1..].iter().filter(near).filter(|t| !is_special_case(best, t)).collect()
    }

    /// The rivals as models, each with its weight beside the cause taken.
    pub fn rivals_in_full(&self) -> Vec<(f64, Model<'_>, Fitted)> {
        let Some(best) = self.decisive().and_then(|round| round.tried.first()) else { return vec![] };
        let rivals = self.rivals();
        self.weighed(best.gain, &rivals)
    }

    /// Causes that were not taken and yet may be there, as models: where no more is to be seen, each has the odds of its evidence over
    /// that which would have been asked of it.
    pub fn doubts(&self) -> Vec<(f64, Model<'_>, Fitted)> {
        let Some(round) = self.rounds.last().filter(|round| !round.taken && self.left.is_white()) else {
            return vec![];
        };
        let known = |t: &&Tried| t.causes.len() == self.model.causes.len() + 1;
        self.weighed(self.asked(), &round.tried.iter().filter(known).collect::<Vec<_>>())
    }

    /// Causes as models, weighed by their evidence beside a model of a given one.
    fn weighed(&self, gain: f64, others: &[&Tried]) -> Vec<(f64, Model<'_>, Fitted)> {
        let odds = |t: &Tried| (t.gain - gain).exp();
        let all: f64 = 1.0 + others.iter().map(|t| odds(t)).sum::<f64>();
        let model = |t: &Tried| Model { causes: t.causes.clone(), ..self.model.clone() };
        others.iter().map(|t| (odds(t) / all, model(t), t.fitted.clone())).collect()
    }

    pub fn verdict(&self) -> CauseVerdict {
        let mut named: Vec<String> = self.model.named().map(|cause| cause.id.into()).collect();
        named.extend(saturation(self.model.base).map(|cause| cause.id));
        let rivals: Vec<String> = self.rivals().iter().map(|t| t.cause.id.into()).collect();
        let unexplained = self.is_unexplained();
        let status = match (unexplained, named.is_empty(), rivals.is_empty()) {
            (true, ..) => "unexplained",
            (false, true, _) => "adequate",
            (false, false, true) => "explained",
            (false, false, false) => "ambiguous",
        };
        let mut causes = named;
        if unexplained && !causes.iter().any(|id| id == UNKNOWN) {
            causes.push(UNKNOWN.into());
        }
        let indistinguishable_from = if status == "ambiguous" { rivals } else { vec![] };
        let mut verdict =
            CauseVerdict { status: status.into(), causes, indistinguishable_from, ..Default::default() };
        verdict.text = in_words(&verdict);
        verdict
    }

    /// Every cause of the rounds with its probability in its round; those taken first.
    pub fn causes(&self) -> Vec<CauseResult> {
        let mut list: Vec<CauseResult> = Vec::new();
        for round in &self.rounds {
            let best = round.tried.first().map_or(0.0, |t| t.gain.max(0.0));
            let odds = |gain: f64| (gain - best).exp();
            let all: f64 = odds(0.0) + round.tried.iter().map(|t| odds(t.gain)).sum::<f64>();
            for (n, tried) in round.tried.iter().enumerate() {
                let taken = round.taken && n == 0;
                if !taken && list.iter().any(|known| known.id == tried.cause.id) {
                    continue;
                }
                list.retain(|known| known.id != tried.cause.id);
                list.push(CauseResult {
                    id: tried.cause.id.into(),
                    probability: odds(tried.gain) / all,
                    log_evidence_gain: tried.gain,
                    parameters: parameters(tried),
                    text: sentence(tried.cause.id),
                    taken,
                });
            }
        }
        if self.is_unexplained() && !list.iter().any(|c| c.id == UNKNOWN) {
            list.push(CauseResult {
                id: UNKNOWN.into(),
                probability: 1.0,
                log_evidence_gain: 0.5 * self.left.excess(),
                parameters: Default::default(),
                text: sentence(UNKNOWN),
                taken: false,
            });
        }
        list.extend(saturation(self.model.base));
        list.sort_by(|a, b| b.taken.cmp(&a.taken).then(b.probability.total_cmp(&a.probability)));
        list
    }
}

/// A verdict as a sentence.
pub fn in_words(verdict: &CauseVerdict) -> String {
    let named = verdict
        .causes
        .iter()
        .filter(|id| *id != UNKNOWN)
        .map(|id| named_of(id))
        .collect::<Vec<_>>()
        .join(", and ");
    match &*verdict.status {
        "adequate" => "The simulation accounts for everything that the recordings show.".into(),
        "explained" => format!("What the simulation left out: {named}."),
        "ambiguous" => {
            let others: Vec<&str> = verdict.indistinguishable_from.iter().map(|id| named_of(id)).collect();
            format!(
                "What the simulation left out: {named}; but these recordings cannot tell that from: {}.",
                others.join("; or: ")
            )
        }
        _ if named.is_empty() => {
            "Something acts on the hull or the phone that no known cause accounts for.".into()
        }
        _ => format!(
            "The simulation left out that {named}; and something remains that no known cause accounts for."
        ),
    }
}

/// Fewer readings at a sensor's limit than this are no matter.
const LEAST_SATURATED: usize = 10;

/// Readings at the end of a sensor's range show it by themselves: they were left out, and nothing needs to be fitted. Each
/// of them, exactly alike as they are, counts for one nat at least.
pub fn saturation(base: &Base) -> Option<CauseResult> {
    let mut limits = std::collections::BTreeMap::new();
    let mut count = 0;
    for swung in &base.swings {
        for repair in swung.evidence.repairs.iter().filter(|r| r.kind == RepairKind::Saturation) {
            count += repair.count;
            let (name, unit, k) = match repair.sensor {
                Sensor::Gyroscope => ("gyro_rad_s", "rad/s", 0),
                _ => ("acc_m_s2", "m/s^2", 1),
            };
            let largest = swung.samples.streams[k].values.iter().map(|v| v.amax()).fold(0.0, f64::max);
            let noise = swung.samples.streams[k].noise.max();
            let known: &mut ParameterResult = limits.entry(name.to_string()).or_insert(ParameterResult {
                value: largest,
                u: noise,
                unit: unit.into(),
            });
            known.value = known.value.max(largest);
        }
    }
    (count >= LEAST_SATURATED).then(|| CauseResult {
        id: "saturation".into(),
        probability: 1.0,
        log_evidence_gain: count as f64,
        parameters: limits,
        text: sentence("saturation"),
        taken: true,
    })
}

/// A power law whose exponent comes out as 1 is the quadratic drag itself, not another cause.
fn is_special_case(best: &Tried, other: &Tried) -> bool {
    let pair = [best.cause.id, other.cause.id];
    if !(pair.contains(&"quadratic_drag") && pair.contains(&"power_law_damping")) {
        return false;
    }
    let power = if best.cause.id == "power_law_damping" { best } else { other };
    let found = parameters(power).remove("exponent");
    found.is_some_and(|e| e.u < EXPONENT_U && (e.value - 1.0).abs() < EXPONENT_NEAR * e.u)
}

/// Parameters of a cause in units of the rig.
fn parameters(tried: &Tried) -> std::collections::BTreeMap<String, ParameterResult> {
    let cause: &Cause = &tried.cause;
    let values = tried.fitted.point.causes.last().cloned().unwrap_or_default();
    let first = tried.fitted.place_of_last(values.len());
    let covariance = tried.fitted.covariance();
    let swings = tried.fitted.jacobians.len();
    let mut found = std::collections::BTreeMap::new();
    for (k, (parameter, own)) in cause.expanded(swings).into_iter().enumerate() {
        let u = covariance.as_ref().map_or(f64::INFINITY, |c| c[(first + k, first + k)].max(0.0).sqrt());
        let (value, u) = if parameter.is_log {
            (values[k].exp(), values[k].exp() * u)
        } else {
            (values[k] * parameter.factor, u * parameter.factor)
        };
        let name = own.map_or(parameter.name.into(), |s| format!("{}_{}", parameter.name, s + 1));
        found.insert(name, ParameterResult { value, u, unit: parameter.unit.into() });
    }
    found
}

/// What a cause is, as a sentence.
pub fn sentence(id: &str) -> String {
    let text = named_of(id);
    let mut letters = text.chars();
    letters
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(letters).chain(['.']).collect())
}

/// What a cause is, in words.
pub fn named_of(id: &str) -> &'static str {
    if id == UNKNOWN {
        return "something that no known cause accounts for";
    }
    let hull = crate::dynamics::effects::catalogue().into_iter();
    let known = hull.chain(crate::dynamics::sensors::catalogue()).find(|kind| kind.id == id);
    known.map_or("a cause without a description", |kind| kind.sentence)
}
