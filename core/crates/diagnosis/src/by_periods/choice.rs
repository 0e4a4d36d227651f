//! Which causes the evidence takes.

use super::causes::{CAUSES, Cause};
use super::figures;
use super::model::{Fitted, Setting};
use crate::cause_id::CauseId;
use crate::result::{CauseResult, Status};
use gyradius_base::error::{Error, Result};
use gyradius_identification::estimate::Observed;

/// A cause is taken where it gains as much: odds of 1000 to 1.
const ENOUGH: f64 = 7.0;
/// Causes whose evidence differs by less are not told apart: the widths that are believed of them
/// beforehand, which enter the evidence, are known to a factor of a few only.
const ALIKE: f64 = 5.0;
/// So many causes are looked for.
const MOST_CAUSES: usize = 3;
/// Chance beyond which a session contradicts itself.
const CONTRADICTION: f64 = 1e-4;

/// Causes tried in one place.
pub struct Round<'a> {
    /// Evidence without any of them.
    before: f64,
    /// The model with each of them, the best first.
    pub tried: Vec<Fitted<'a>>,
}

/// What was tried and what was taken.
pub struct Choice<'a> {
    /// The model without causes.
    pub base: Fitted<'a>,
    /// One for each cause taken, and the last, in which none was.
    pub rounds: Vec<Round<'a>>,
    /// Models that do as well with another cause in the place of one of those taken.
    pub rivals: Vec<Fitted<'a>>,
}

impl<'a> Choice<'a> {
    /// Looks for causes, one after the other.
    pub fn of(setting: &Setting<'a>) -> Result<Self> {
        let base = setting.fit(&[]).ok_or_else(|| {
            Error::no_result(
                "joint estimate",
                "the stated dimensions and the periods have no common solution",
            )
        })?;
        let seen: Vec<&'static Cause> = CAUSES.iter().filter(|c| setting.is_seen(c)).collect();
        let mut choice = Self {
            base,
            rounds: vec![],
            rivals: vec![],
        };
        while choice.rounds.len() < MOST_CAUSES {
            let round = Round::beside(setting, choice.extended(), &seen);
            let is_enough = round.gains();
            choice.rounds.push(round);
            if !is_enough {
                break;
            }
        }
        choice.rivals = choice.rivals(setting, &seen);
        Ok(choice)
    }

    /// The model without a swing, with the cause that then gains enough, if one does; `None` where
    /// the swing shows nothing.
    pub fn without(&self, setting: &Setting<'a>, swing: usize) -> Option<Fitted<'a>> {
        let is_its = |what: Observed| matches!(what, Observed::Period(i, _) if i == swing);
        setting
            .system
            .observations
            .iter()
            .find(|o| is_its(o.what))?;
        let bare = setting.fit_without(&[], &is_its)?;
        let causes = self.rounds.first().map_or(&[][..], |round| &round.tried);
        let best = causes
            .iter()
            .filter_map(|tried| setting.fit_without(&tried.causes, &is_its))
            .max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence));
        match best {
            Some(best) if best.log_evidence - bare.log_evidence >= ENOUGH => Some(best),
            _ => Some(bare),
        }
    }

    /// The rounds in which a cause was taken.
    pub fn taken(&self) -> impl Iterator<Item = &Round<'a>> {
        self.rounds.iter().take_while(|round| round.gains())
    }

    /// The model with all causes that were taken.
    pub fn extended(&self) -> &Fitted<'a> {
        self.taken()
            .last()
            .and_then(|round| round.tried.first())
            .unwrap_or(&self.base)
    }

    fn rivals(&self, setting: &Setting<'a>, seen: &[&'static Cause]) -> Vec<Fitted<'a>> {
        let best = self.extended();
        let mut rivals = Vec::new();
        for place in 0..best.causes.len() {
            for cause in seen
                .iter()
                .filter(|c| best.causes.iter().all(|t| t.id != c.id))
            {
                let mut causes = best.causes.clone();
                causes[place] = cause;
                let rival = setting.fit(&causes);
                rivals.extend(rival.filter(|r| best.log_evidence - r.log_evidence < ALIKE));
            }
        }
        rivals.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
        rivals
    }

    /// Causes of the rivals that the best model does not have.
    pub fn rival_names(&self) -> Vec<CauseId> {
        let mut names: Vec<CauseId> = Vec::new();
        for cause in self.rivals.iter().flat_map(|r| &r.causes) {
            let is_taken = self.extended().causes.iter().any(|t| t.id == cause.id);
            if !is_taken && !names.contains(&cause.id) {
                names.push(cause.id);
            }
        }
        names
    }

    /// What follows.
    pub fn standing(&self) -> Status {
        let extended = self.extended();
        match (
            extended.p_value() < CONTRADICTION,
            extended.causes.is_empty(),
            self.rivals.is_empty(),
        ) {
            (true, _, _) => Status::Unexplained,
            (false, true, _) => Status::Adequate,
            (false, false, true) => Status::Explained,
            (false, false, false) => Status::Ambiguous,
        }
    }
}

impl<'a> Round<'a> {
    fn beside(setting: &Setting<'a>, known: &Fitted<'a>, seen: &[&'static Cause]) -> Self {
        let is_known = |cause: &Cause| known.causes.iter().any(|k| k.id == cause.id);
        let with = |cause: &'static Cause| {
            let mut causes = known.causes.clone();
            causes.push(cause);
            setting.fit(&causes)
        };
        let mut tried: Vec<Fitted> = seen
            .iter()
            .filter(|c| !is_known(c))
            .filter_map(|c| with(c))
            .collect();
        tried.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
        Self {
            before: known.log_evidence,
            tried,
        }
    }

    fn gain(&self, fitted: &Fitted) -> f64 {
        fitted.log_evidence - self.before
    }

    fn gains(&self) -> bool {
        self.tried
            .first()
            .is_some_and(|best| self.gain(best) >= ENOUGH)
    }

    /// Each cause, the most probable first.
    pub fn results(&self, setting: &Setting) -> Vec<CauseResult> {
        let most = self
            .tried
            .first()
            .map_or(0.0, |best| self.gain(best))
            .max(0.0);
        let all: f64 = self
            .tried
            .iter()
            .map(|f| (self.gain(f) - most).exp())
            .sum::<f64>()
            + (-most).exp();
        let result = |fitted: &Fitted| {
            let cause = fitted.causes.last()?;
            let gain = self.gain(fitted);
            let said = figures::cause(setting, fitted);
            Some(CauseResult {
                id: cause.id,
                probability: (gain - most).exp() / all,
                log_evidence_gain: gain,
                parameters: figures::parameters(setting, fitted),
                message: said,
                taken: false,
            })
        };
        self.tried.iter().filter_map(result).collect()
    }
}
