//! From what the search found to what is said.

use std::collections::BTreeMap;

use super::super::causes::UNKNOWN;
use super::super::result::{CauseResult, CauseVerdict, ParameterResult};
use super::super::verdict::{EXPONENT_NEAR, EXPONENT_U, LEFT_SHARE, NOT_TOLD, in_words, sentence};
use super::search::{Found, Round, Tried};

impl Found<'_> {
    fn names(&self) -> Vec<String> {
        self.best.causes.iter().map(|place| self.id(*place).into()).collect()
    }

    /// Whether structure remains that nothing accounts for.
    pub fn is_unexplained(&self) -> bool {
        let left = &self.best.left;
        let unnamed = self.names().iter().any(|id| id == UNKNOWN);
        unnamed || (!left.is_white() && left.excess() > LEFT_SHARE * self.base.left.excess())
    }

    fn decisive(&self) -> Option<&Round> {
        self.rounds.iter().rev().find(|round| round.taken)
    }

    /// Causes that do as well as the last one taken, best first.
    pub fn rivals(&self) -> Vec<&Tried> {
        let Some([best, others @ ..]) = self.decisive().map(|round| &round.tried[..]) else { return vec![] };
        // Where structure remains, evidence counts for less: in proportion to what is left.
        let allowed = NOT_TOLD.max(0.02 * best.with.left.excess());
        let near = |t: &&Tried| best.gain - t.gain < allowed && t.id != UNKNOWN;
        others.iter().filter(near).filter(|t| !self.is_special_case(best, t)).collect()
    }

    /// A power law whose exponent comes out as 1 is the quadratic drag itself, not another cause.
    fn is_special_case(&self, best: &Tried, other: &Tried) -> bool {
        let pair = [best.id, other.id];
        if !(pair.contains(&"quadratic_drag") && pair.contains(&"power_law_damping")) {
            return false;
        }
        let power = if best.id == "power_law_damping" { best } else { other };
        let is_one = |e: &ParameterResult| e.u < EXPONENT_U && (e.value - 1.0).abs() < EXPONENT_NEAR * e.u;
        let found = self.parameters(power);
        found.iter().filter(|(name, _)| name.starts_with("exponent")).all(|(_, e)| is_one(e))
    }

    pub fn verdict(&self) -> CauseVerdict {
        let mut causes = self.names();
        let rivals: Vec<String> = self.rivals().iter().map(|t| t.id.into()).collect();
        let status = match (self.is_unexplained(), causes.is_empty(), rivals.is_empty()) {
            (true, ..) => "unexplained",
            (false, true, _) => "adequate",
            (false, false, true) => "explained",
            (false, false, false) => "ambiguous",
        };
        if status == "unexplained" && !causes.iter().any(|id| id == UNKNOWN) {
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
            let most = round.tried.first().map_or(0.0, |t| t.gain.max(0.0));
            let odds = |gain: f64| (gain - most).exp();
            let all: f64 = odds(0.0) + round.tried.iter().map(|t| odds(t.gain)).sum::<f64>();
            for (n, tried) in round.tried.iter().enumerate() {
                let taken = round.taken && n == 0;
                if taken || list.iter().all(|known| known.id != tried.id) {
                    list.retain(|known| known.id != tried.id);
                    list.push(CauseResult {
                        id: tried.id.into(),
                        probability: odds(tried.gain) / all,
                        log_evidence_gain: tried.gain,
                        parameters: self.parameters(tried),
                        text: sentence(tried.id),
                        taken,
                    });
                }
            }
        }
        if self.is_unexplained() && list.iter().all(|c| c.id != UNKNOWN) {
            list.push(self.unknown());
        }
        list.sort_by(|a, b| b.taken.cmp(&a.taken).then(b.probability.total_cmp(&a.probability)));
        list
    }

    fn unknown(&self) -> CauseResult {
        CauseResult {
            id: UNKNOWN.into(),
            probability: 1.0,
            log_evidence_gain: 0.5 * self.best.left.excess(),
            parameters: BTreeMap::new(),
            text: sentence(UNKNOWN),
            taken: false,
        }
    }

    /// Parameters of the last cause of those tried, swing by swing.
    fn parameters(&self, tried: &Tried) -> BTreeMap<String, ParameterResult> {
        let mut all = BTreeMap::new();
        let Some(place) = tried.with.causes.last() else { return all };
        for (s, (swing, fitted)) in self.swings.iter().zip(&tried.with.fits).enumerate() {
            let parameters = &swing.catalogue[*place].parameters;
            let first = fitted.point.len() - parameters.len();
            let covariance = fitted.covariance();
            for (k, parameter) in parameters.iter().enumerate() {
                let at = first + k;
                let u = covariance.as_ref().map_or(f64::INFINITY, |c| c[(at, at)].max(0.0).sqrt());
                let (value, scale) = if parameter.is_log {
                    (fitted.point[at].exp(), fitted.point[at].exp())
                } else {
                    (fitted.point[at] * parameter.factor, parameter.factor)
                };
                let name = match self.swings.len() {
                    1 => parameter.name.into(),
                    _ => format!("{}_{}", parameter.name, s + 1),
                };
                all.insert(name, ParameterResult { value, u: u * scale, unit: parameter.unit.into() });
            }
        }
        all
    }
}
