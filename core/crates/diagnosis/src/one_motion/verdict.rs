//! From what the search found to what is said.

use std::collections::BTreeMap;

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterId;
use super::super::result::{CauseResult, CauseVerdict, ParameterResult};
use super::super::verdict::{MOST_NAMED, NOT_TOLD, Ranked, are_one_drag, judged, ranked, result};
use super::search::{Found, Round, Tried};

impl Ranked for Tried {
    fn id(&self) -> CauseId {
        self.id
    }

    fn gain(&self) -> f64 {
        self.gain
    }
}

impl Found<'_> {
    fn names(&self) -> Vec<CauseId> {
        self.best
            .causes
            .iter()
            .map(|place| self.id(*place))
            .collect()
    }

    /// Whether structure remains that nothing accounts for, or nothing but many causes together.
    pub fn is_unexplained(&self) -> bool {
        let (names, left) = (self.names(), &self.best.left);
        let beyond = names.len() > MOST_NAMED || names.contains(&CauseId::Unknown);
        beyond || !left.is_next_to_nothing(&self.base.left)
    }

    fn decisive(&self) -> Option<&Round> {
        self.rounds.iter().rev().find(|round| round.taken)
    }

    /// Causes that do as well as the last one taken, best first.
    pub fn rivals(&self) -> Vec<&Tried> {
        let Some([best, others @ ..]) = self.decisive().map(|round| &round.tried[..]) else {
            return vec![];
        };
        // Where structure remains, evidence counts for less: in proportion to what is left.
        let allowed = NOT_TOLD.max(0.02 * best.with.left.excess());
        let near = |t: &&Tried| best.gain - t.gain < allowed && t.id != CauseId::Unknown;
        let special = |t: &&Tried| are_one_drag([best.id, t.id], |k| self.parameters([best, t][k]));
        others.iter().filter(near).filter(|t| !special(t)).collect()
    }

    pub fn verdict(&self) -> CauseVerdict {
        let rivals = self.rivals().iter().map(|t| t.id).collect();
        judged(self.names(), rivals, self.is_unexplained())
    }

    /// Every cause of the rounds with its probability in its round; those taken first.
    pub fn causes(&self) -> Vec<CauseResult> {
        let result = |t: &Tried| result(t.id, t.gain, self.parameters(t));
        let rounds = self
            .rounds
            .iter()
            .map(|r| (r.taken, r.tried.iter().map(result).collect()));
        ranked(
            rounds,
            self.is_unexplained().then(|| self.best.left.excess()),
            None,
        )
    }

    /// Parameters of the last cause of those tried, swing by swing.
    pub fn parameters(&self, tried: &Tried) -> BTreeMap<ParameterId, ParameterResult> {
        let mut all = BTreeMap::new();
        let Some(place) = tried.with.causes.last() else {
            return all;
        };
        for (s, (swing, fitted)) in self.swings.iter().zip(&tried.with.fits).enumerate() {
            let parameters = &swing.catalogue[*place].parameters;
            let first = fitted.point.len() - parameters.len();
            let covariance = fitted.covariance();
            for (k, parameter) in parameters.iter().enumerate() {
                let at = first + k;
                let u = covariance
                    .as_ref()
                    .map_or(f64::INFINITY, |c| c[(at, at)].max(0.0).sqrt());
                let own = (self.swings.len() > 1).then_some(s);
                let name = ParameterId::of(parameter.name, own);
                all.insert(name, parameter.result(fitted.point[at], u));
            }
        }
        all
    }
}
