//! What a selection comes to: the causes that the data ask for.

use std::collections::BTreeMap;

use super::cause_id::CauseId;
use super::parameter_id::ParameterId;
use super::result::{CauseResult, ParameterResult};
use super::selection::{Candidate, Competing, Selection, Set};
use super::verdict::{are_one_drag, result, taken_first};

/// A law is nearly right where no more than this share of what it does is done otherwise, squared: the
/// share of what causes take of χ² that a force of unknown form may take beside them, and that a
/// residual may be beside that of the base ([`Left`](super::white::Left)).
pub const NEARLY: f64 = 1e-3;

/// Models of a smaller share of the posterior move no interval of 95 %.
pub const LEAST_SHARE: f64 = 1e-3;

/// What competes and can be judged by what is held out.
pub trait Decided: Competing {
    /// χ² of the stretches that are held out, and their rows; the model fitted to the others.
    fn held_out(&self, model: &Self::Model) -> Option<(f64, usize)>;
    /// A smaller set fitted from where a larger one is.
    fn without(&self, set: &Set, larger: &Self::Model) -> Option<Self::Model>;
    /// χ² of all samples by a model that was fitted.
    fn chi2(&self, model: &Self::Model) -> f64;
}

/// What is asked for.
pub struct Decision<M> {
    pub selection: Selection<M>,
    pub base: M,
    /// The model with what is asked for, and its set.
    pub best: M,
    pub set: Set,
    /// The causes asked for.
    pub names: Vec<CauseId>,
    /// Whether an unknown force takes what they do not.
    pub is_unknown: bool,
    /// χ² of what is held out by the base and by the best, and its rows.
    pub held_out: (f64, f64, usize),
}

/// Decides by evidence and by what is held out: a cause that foretells that no better is none,
/// whatever it gained of the rest.
pub fn decide<C: Decided>(
    competing: &C,
    mut selection: Selection<C::Model>,
) -> Option<Decision<C::Model>> {
    let in_full = |candidate: &Candidate<C::Model>| {
        if candidate.is_fitted {
            return Some(candidate.model.clone());
        }
        competing.fitted(&candidate.set, Some(&candidate.model))
    };
    let base = in_full(selection.best(Vec::is_empty)?)?;
    let (before, rows) = competing.held_out(&base)?;
    loop {
        let (names, unknown) = selection.asked();
        let is_it = |set: &Set| {
            selection.names(set) == names && selection.has(set, CauseId::Unknown) == unknown
        };
        let candidate = selection.best(is_it)?;
        let (best, set) = (in_full(candidate)?, candidate.set.clone());
        let (after, _) = competing.held_out(&best)?;
        let foretells = |id: &CauseId| {
            let others = set.iter().copied();
            let others: Set = others.filter(|form| selection.id(*form) != *id).collect();
            let without = competing.without(&others, &best)?;
            Some(competing.held_out(&without)?.0 > after)
        };
        let ids: Vec<CauseId> = set.iter().map(|form| selection.id(*form)).collect();
        if let Some(id) = ids.iter().find(|id| foretells(id) != Some(true)) {
            selection = selection.without(*id);
            continue;
        }
        let is_unknown = takes_unknown(competing, &selection, &base, (&best, &set))?;
        return Some(Decision {
            held_out: (before, after, rows),
            selection,
            base,
            best,
            set,
            names,
            is_unknown,
        });
    }
}

/// Whether an unknown force in the best model takes what the causes do not explain.
fn takes_unknown<C: Decided>(
    competing: &C,
    selection: &Selection<C::Model>,
    base: &C::Model,
    (best, set): (&C::Model, &Set),
) -> Option<bool> {
    if !selection.has(set, CauseId::Unknown) {
        return Some(false);
    }
    let is_named = |form: &usize| selection.id(*form) != CauseId::Unknown;
    let named: Set = set.iter().copied().filter(is_named).collect();
    let without = competing.without(&named, best)?;
    let all = competing.chi2(base) - competing.chi2(best);
    Some(competing.chi2(&without) - competing.chi2(best) > NEARLY * all)
}

impl<M> Decision<M> {
    /// Every cause with its share of the posterior and what the best set with it gains over the best
    /// without; those asked for first. `parameters` are those of a cause in a model, `left` what no
    /// cause explains, χ², `by_itself` what shows beside them without a fit.
    pub fn causes(
        &self,
        parameters: impl Fn(&M, CauseId) -> BTreeMap<ParameterId, ParameterResult>,
        left: Option<f64>,
        by_itself: Option<CauseResult>,
    ) -> Vec<CauseResult> {
        let selection = &self.selection;
        let mut all: Vec<CauseResult> = Vec::new();
        for id in selection.ids() {
            let evidence = |c: &Candidate<M>| selection.log_evidence(c);
            let best = |with: bool| {
                let of = selection.candidates.iter();
                let of = of.filter(|c| selection.has(&c.set, id) == with);
                of.max_by(|a, b| evidence(a).total_cmp(&evidence(b)))
            };
            let (Some(with), Some(without)) = (best(true), best(false)) else {
                continue;
            };
            let asked = self.names.contains(&id) || (id == CauseId::Unknown && self.is_unknown);
            let model = if asked { &self.best } else { &with.model };
            all.push(CauseResult {
                probability: selection.mass(|set| selection.has(set, id)),
                taken: asked,
                ..result(
                    id,
                    evidence(with) - evidence(without),
                    parameters(model, id),
                )
            });
        }
        let lacks = |c: &CauseResult| c.id != CauseId::Unknown || !c.taken;
        if let Some(left) = left.filter(|_| all.iter().all(lacks)) {
            all.retain(|cause| cause.id != CauseId::Unknown);
            all.push(result(CauseId::Unknown, 0.5 * left, BTreeMap::new()));
        }
        all.extend(by_itself);
        taken_first(&mut all);
        all
    }

    /// Causes that do as well in the place of those asked for, the best first.
    pub fn instead(
        &self,
        parameters: impl Fn(&M, CauseId) -> BTreeMap<ParameterId, ParameterResult>,
    ) -> Vec<CauseId> {
        let selection = &self.selection;
        let best = |id| {
            let with = selection.best(|set| selection.has(set, id));
            with.map_or_else(BTreeMap::new, |c| parameters(&c.model, id))
        };
        let is_other = |id: &CauseId| {
            let mut names = self.names.iter();
            !names.any(|known| are_one_drag([*known, *id], |k| best([*known, *id][k])))
        };
        let all = selection.instead(&self.names).into_iter();
        all.filter(is_other).collect()
    }

    /// The causes asked for, an unknown force among them.
    pub fn all_names(&self) -> Vec<CauseId> {
        let unknown = self.is_unknown.then_some(CauseId::Unknown);
        self.names.iter().copied().chain(unknown).collect()
    }
}
