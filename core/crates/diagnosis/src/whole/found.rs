//! From the selection to what is said.

use std::collections::BTreeMap;
use std::sync::Arc;

use gyradius_base::error::{Error, Result};
use gyradius_base::message::Message;
use gyradius_base::progress::{Progress, tell};
use gyradius_identification::measure::title;
use gyradius_identification::{QuantityName, QuantityResult};
use gyradius_recording::{LoadedSession, Quantity};

use super::super::cause_id::CauseId;
use super::super::decision::{Decision, LEAST_SHARE, decide};
use super::super::doubt::{Otherwise, widen};
use super::super::findings::findings;
use super::super::fitting::Fitted;
use super::super::found::Found;
use super::super::learned::learned;
use super::super::next_swing::{self, next_swing};
use super::super::parameter_id::ParameterId;
use super::super::point::{Model, Point};
use super::super::quantities::quantities;
use super::super::result::{CauseVerdict, Criticism, Critique, NextSwing, ParameterResult};
use super::super::selection::{Set, select};
use super::super::traces::traces;
use super::super::verdict::{judged, parameters_of, saturation};
use super::super::{FORMAT, gain, model_result};
use super::competing::{Explained, Session};

struct Judged<'a> {
    session: Session<'a>,
    decision: Decision<Explained<'a>>,
    base: Arc<Found<'a>>,
    best: Found<'a>,
}

/// Criticises a session whose base simulation was fitted.
pub fn criticise<'a>(
    loaded: &LoadedSession,
    (base, begin, fitted): (Model<'a>, Point, Fitted),
    inclines: &[Option<Quantity>],
    warnings: Vec<Message>,
    progress: &'a Progress,
) -> Result<Criticism> {
    let failed = || Error::no_result("criticism", "no set of causes can be weighed");
    let session = Session::of(base, begin, fitted, progress)?;
    let selection = select(&session, &[]);
    session.not_stopped()?;
    let selection = selection.ok_or_else(failed)?;
    tell(progress, 0.9, "judging by samples held out")?;
    let decision = decide(&session, selection);
    session.not_stopped()?;
    let decision = decision.ok_or_else(failed)?;
    let (Explained::Fitted(base), Explained::Fitted(best)) = (&decision.base, &decision.best)
    else {
        return Err(failed());
    };
    let base = base.clone();
    let best = Found {
        base: base.fitted.clone(),
        base_left: base.left.clone(),
        ..polished(best)?
    };
    let judged = Judged {
        session,
        decision,
        base,
        best,
    };
    judged.concluded(loaded, inclines, warnings)
}

/// With all derivatives, and what has no name last.
fn polished<'a>(found: &Found<'a>) -> Result<Found<'a>> {
    let mut model = found.model.clone();
    let mut point = found.fitted.point.clone();
    let pairs = model.causes.into_iter().zip(point.causes);
    let (last, first): (Vec<_>, Vec<_>) = pairs.partition(|(c, _)| c.id == CauseId::Unknown);
    (model.causes, point.causes) = first.into_iter().chain(last).unzip();
    model.fine = true;
    let fitted = if model.causes.is_empty() {
        found.fitted.clone()
    } else {
        model.whole().fit(&point, &|_| false)?
    };
    let looked_from = found.looked_from.clone();
    Ok(Found {
        looked_from,
        ..Found::begun(model, found.begin.clone(), fitted)?
    })
}

/// Numbers of a cause in a model that was fitted.
fn parameters(model: &Explained, id: CauseId) -> BTreeMap<ParameterId, ParameterResult> {
    match model {
        Explained::Fitted(found) => parameters_in(found, id),
        Explained::Promised(..) => BTreeMap::new(),
    }
}

fn parameters_in(found: &Found, id: CauseId) -> BTreeMap<ParameterId, ParameterResult> {
    let causes = &found.model.causes;
    let place = causes.iter().position(|cause| cause.id == id);
    place.map_or_else(BTreeMap::new, |k| parameters_of(causes, &found.fitted, k))
}

impl Judged<'_> {
    fn is_unexplained(&self) -> bool {
        self.decision.is_unknown || !self.best.leaves_little()
    }

    fn instead(&self) -> Vec<CauseId> {
        if self.is_unexplained() {
            return vec![];
        }
        self.decision.instead(parameters)
    }

    fn verdict(&self) -> CauseVerdict {
        let mut names = self.decision.all_names();
        names.extend(saturation(self.base.model.base).map(|cause| cause.id));
        judged(names, self.instead(), self.is_unexplained())
    }

    /// The body by all models, by their shares of the posterior, and by the causes with a name alone.
    fn otherwise(&self, inclines: &[Option<Quantity>]) -> Vec<Otherwise> {
        let selection = &self.decision.selection;
        let weights = selection.weights();
        let own: f64 = selection
            .candidates
            .iter()
            .zip(&weights)
            .filter(|(c, _)| c.set == self.decision.set)
            .map(|(_, w)| w)
            .sum();
        let mut all: Vec<Otherwise> = vec![];
        for (candidate, share) in selection.candidates.iter().zip(&weights) {
            if *share < LEAST_SHARE || candidate.set == self.decision.set {
                continue;
            }
            let body = self.body(&candidate.model, &candidate.set, inclines);
            all.extend(body.map(|body| Otherwise::new(share / own.max(LEAST_SHARE), body)));
        }
        all.extend(self.best.named_alone(inclines));
        all
    }

    fn body(
        &self,
        model: &Explained,
        set: &Set,
        inclines: &[Option<Quantity>],
    ) -> Option<BTreeMap<QuantityName, QuantityResult>> {
        match model {
            Explained::Fitted(found) => {
                quantities(&found.model, found.fitted.at(), 1.0, inclines).ok()
            }
            Explained::Promised(linear, _) => {
                let (model, point) = linear.start(set, &self.session.kinds, 1.0)?;
                let information = linear.information_of(set, &self.session.kinds)?;
                quantities(&model, (&point, &information), 1.0, inclines).ok()
            }
        }
    }

    /// The swing that would tell the causes named from what does as well.
    fn next(&self) -> Option<NextSwing> {
        let rival = *self.instead().first()?;
        let selection = &self.decision.selection;
        let with = selection.best(|set| selection.has(set, rival))?;
        let (model, point) = match &with.model {
            Explained::Fitted(found) => (found.model.clone(), found.fitted.point.clone()),
            Explained::Promised(linear, _) => linear.start(&with.set, &self.session.kinds, 1.0)?,
        };
        let own = self
            .decision
            .names
            .iter()
            .find(|id| !selection.has(&with.set, **id))?;
        next_swing(
            &next_swing::Explained {
                model: &self.best.model,
                point: &self.best.fitted.point,
                id: *own,
            },
            &next_swing::Explained {
                model: &model,
                point: &point,
                id: rival,
            },
        )
    }

    fn concluded(
        &self,
        loaded: &LoadedSession,
        inclines: &[Option<Quantity>],
        warnings: Vec<Message>,
    ) -> Result<Criticism> {
        let (base, best) = (&self.base, &self.best);
        let (before, after, rows) = self.decision.held_out;
        let rms = |chi2: f64| (chi2 / rows.max(1) as f64).sqrt();
        let result = |found: &Found, chi2: f64| {
            let fit = (&found.fitted, &found.left);
            model_result(&found.model, fit, rms(chi2), inclines)
        };
        let baseline = result(base, before)?;
        let mut extended = result(best, after)?;
        widen(&mut extended.quantities, &self.otherwise(inclines));
        let left = self.is_unexplained().then(|| best.left.excess());
        let of_model = |model: &Explained, id: CauseId| {
            if self.decision.names.contains(&id) {
                parameters_in(best, id)
            } else {
                parameters(model, id)
            }
        };
        let causes = self
            .decision
            .causes(of_model, left, saturation(base.model.base));
        let gain = gain((before, after), rows, &baseline, &extended);
        let critique = Critique {
            format: FORMAT.into(),
            title: title(&loaded.session),
            discrepancies: findings(&base.model, &base.fitted, &base.left)?,
            causes,
            verdict: CauseVerdict {
                next_swing: self.next(),
                ..self.verdict()
            },
            baseline,
            extended,
            gain,
            learned: learned(best, rms(after)),
            findings: Vec::new(),
            warnings,
        };
        Ok(Criticism {
            critique,
            traces: traces(&base.model, best)?,
        })
    }
}
