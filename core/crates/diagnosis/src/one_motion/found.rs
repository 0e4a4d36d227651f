//! What the selection of causes comes to: those asked for, what they leave, what others may stand in
//! their place.

use std::collections::BTreeMap;

use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_base::progress::{Progress, tell};

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterId;
use super::super::result::{CauseResult, CauseVerdict, ParameterResult};
use super::super::selection::{Candidate, Competing, Selection, Set, select};
use super::super::verdict::{MOST_LEFT_RMS, are_one_drag, judged, result};
use super::super::white::{Left, in_record};
use super::competing::{Model, Swings};
use super::swing::Swing;

/// A law is nearly right where no more than this share of what it does is done otherwise, squared: the
/// share of what causes take of χ² that a force of unknown form may take beside them, and that a
/// residual may be beside that of the base ([`Left`]).
pub const NEARLY: f64 = 1e-3;

/// What was found.
pub struct Found<'a> {
    pub swings: &'a [Swing<'a>],
    pub selection: Selection<Model>,
    pub base: Model,
    /// The model with what is asked for.
    pub best: Model,
    /// The causes asked for.
    pub names: Vec<CauseId>,
    /// Whether an unknown force takes what they do not.
    pub is_unknown: bool,
    /// What each leaves.
    pub base_left: Left,
    pub left: Left,
    /// χ² of what is held out by each, and its rows.
    pub held_out: (f64, f64, usize),
}

/// Selects; `None` where no simulation can be fitted to a swing.
pub fn find<'a>(swings: &'a [Swing<'a>], progress: &Progress) -> Result<Option<Found<'a>>> {
    tell(progress, 0.3, "weighing every set of causes")?;
    let measured = swings[0].measured_set();
    let mut learned = measured.clone();
    learned.extend(swings[0].form_of(CauseId::Unknown));
    let Some(selection) = select(&Swings(swings), &[measured, learned]) else {
        return Ok(None);
    };
    tell(progress, 0.9, "judging by samples held out")?;
    Ok(concluded(swings, selection))
}

fn concluded<'a>(swings: &'a [Swing<'a>], mut selection: Selection<Model>) -> Option<Found<'a>> {
    let base = in_full(swings, selection.best(Vec::is_empty)?)?;
    let (before, rows) = held_out(swings, &base)?;
    loop {
        let (names, unknown) = selection.asked();
        let is_it = |set: &Set| {
            selection.names(set) == names && selection.has(set, CauseId::Unknown) == unknown
        };
        let best = selection.best(is_it)?;
        let best = in_full(swings, best)?;
        let (after, _) = held_out(swings, &best)?;
        // What foretells no better what was held out is none, whatever it gained of the rest.
        let foretells = |id: &CauseId| {
            let set: Set = best
                .set
                .iter()
                .copied()
                .filter(|form| selection.id(*form) != *id)
                .collect();
            let without = fitted(swings, &set, &best)?;
            Some(held_out(swings, &without)?.0 > after)
        };
        let ids: Vec<CauseId> = best.set.iter().map(|form| selection.id(*form)).collect();
        if let Some(id) = ids.iter().find(|id| foretells(id) != Some(true)) {
            selection = selection.without(*id);
            continue;
        }
        let is_unknown = takes_unknown(swings, &selection, &base, &best)?;
        return Some(Found {
            base_left: left(swings, &base)?,
            left: left(swings, &best)?,
            held_out: (before, after, rows),
            swings,
            selection,
            base,
            best,
            names,
            is_unknown,
        });
    }
}

fn in_full(swings: &[Swing], candidate: &Candidate<Model>) -> Option<Model> {
    if candidate.is_fitted {
        return Some(candidate.model.clone());
    }
    Swings(swings).fitted(&candidate.set, Some(&candidate.model))
}

/// A smaller set fitted from where a larger one is.
fn fitted(swings: &[Swing], set: &Set, larger: &Model) -> Option<Model> {
    let mut from = larger.clone();
    from.set = set.clone();
    for (swing, one) in swings.iter().zip(&mut from.swings) {
        let mut kept = one.x[..swing.first_cause()].to_vec();
        for (form, _, places) in swing.causes_of(&larger.set) {
            if set.contains(&form) {
                kept.extend(&one.x[places]);
            }
        }
        one.x = kept;
    }
    Swings(swings).fitted(set, Some(&from))
}

/// Whether an unknown force in the best model takes what the causes do not explain.
fn takes_unknown(
    swings: &[Swing],
    selection: &Selection<Model>,
    base: &Model,
    best: &Model,
) -> Option<bool> {
    if !selection.has(&best.set, CauseId::Unknown) {
        return Some(false);
    }
    let is_named = |form: &usize| selection.id(*form) != CauseId::Unknown;
    let set: Set = best.set.iter().copied().filter(is_named).collect();
    let without = fitted(swings, &set, best)?;
    let all = base.chi2() - best.chi2();
    Some(without.chi2() - best.chi2() > NEARLY * all)
}

/// χ² of the stretches that are held out, over the noise of the samples, and their rows; the model
/// fitted to the others.
fn held_out(swings: &[Swing], model: &Model) -> Option<(f64, usize)> {
    let of_swing = |s: usize| {
        let swing = &swings[s];
        let rows = swing.held_out(&swing.fittings(&model.set), &model.swings[s].x)?;
        Some((rows.norm_squared(), rows.len()))
    };
    let parts = in_parallel(swings.len(), of_swing);
    let parts = parts.into_iter().collect::<Option<Vec<_>>>()?;
    let sum = |(a, b): (f64, usize), (c, d): (f64, usize)| (a + c, b + d);
    Some(parts.into_iter().fold((0.0, 0), sum))
}

/// What a model leaves of the blocks beside white noise.
fn left(swings: &[Swing], model: &Model) -> Option<Left> {
    let mut left = Left::default();
    for (s, (swing, one)) in swings.iter().zip(&model.swings).enumerate() {
        let rows = swing.left(&model.set, &one.x)?;
        let bands = in_record(
            (s, 0),
            &swing.block_times_s(),
            rows.as_slice(),
            swings.len(),
        );
        left.bands.extend(bands);
    }
    Some(left)
}

/// Numbers of a cause in a model, swing by swing.
fn parameters(
    swings: &[Swing],
    model: &Model,
    id: CauseId,
) -> BTreeMap<ParameterId, ParameterResult> {
    let mut all = BTreeMap::new();
    for (s, (swing, one)) in swings.iter().zip(&model.swings).enumerate() {
        let of_cause = swing.causes_of(&model.set);
        for (_, cause, places) in of_cause.filter(|(_, cause, _)| cause.id == id) {
            let own = (swings.len() > 1).then_some(s);
            for (place, parameter) in places.zip(&cause.parameters) {
                let u = one.covariance.as_ref();
                let u = u.map_or(f64::INFINITY, |c| c[(place, place)].max(0.0).sqrt());
                let name = ParameterId::of(parameter.name, own);
                all.insert(name, parameter.result(one.x[place], u));
            }
        }
    }
    all
}

impl Found<'_> {
    /// Whether structure remains that nothing with a name accounts for.
    pub fn is_unexplained(&self) -> bool {
        let is_noise = self.rms(&self.best) <= MOST_LEFT_RMS;
        self.is_unknown || !is_noise || !self.left.is_next_to_nothing(&self.base_left)
    }

    /// Causes that do as well in the place of those asked for, the best first.
    pub fn instead(&self) -> Vec<CauseId> {
        if self.is_unexplained() {
            return vec![];
        }
        let is_other = |id: &CauseId| {
            let known = self.names.iter().find(|known| {
                are_one_drag([**known, *id], |k| {
                    let id = [**known, *id][k];
                    let with = self.selection.best(|set| self.selection.has(set, id));
                    with.map_or_else(BTreeMap::new, |c| parameters(self.swings, &c.model, id))
                })
            });
            known.is_none()
        };
        self.selection
            .instead(&self.names)
            .into_iter()
            .filter(is_other)
            .collect()
    }

    pub fn verdict(&self) -> CauseVerdict {
        let mut names = self.names.clone();
        if self.is_unknown {
            names.push(CauseId::Unknown);
        }
        judged(names, self.instead(), self.is_unexplained())
    }

    /// Every cause with its share of the posterior and what the best set with it gains over the best
    /// without; those asked for first.
    pub fn causes(&self) -> Vec<CauseResult> {
        let selection = &self.selection;
        let mut all: Vec<CauseResult> = Vec::new();
        for id in selection.ids() {
            let evidence = |c: &Candidate<Model>| selection.log_evidence(c);
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
                    parameters(self.swings, model, id),
                )
            });
        }
        let lacks = all
            .iter()
            .all(|cause| cause.id != CauseId::Unknown || !cause.taken);
        if self.is_unexplained() && lacks {
            all.retain(|cause| cause.id != CauseId::Unknown);
            all.push(result(
                CauseId::Unknown,
                0.5 * self.left.excess(),
                BTreeMap::new(),
            ));
        }
        all.sort_by(|a, b| (b.taken.cmp(&a.taken)).then(b.probability.total_cmp(&a.probability)));
        all
    }

    /// Residual over noise of a model.
    pub fn rms(&self, model: &Model) -> f64 {
        let scaled = self.swings.iter().zip(&model.swings);
        let square = |(swing, one): (&Swing, &super::competing::One)| {
            one.chi2 * (swing.noise / swing.readings().noise).powi(2)
        };
        let rows: usize = self.swings.iter().map(|s| s.readings().blocks.len()).sum();
        (scaled.map(square).sum::<f64>() / rows.max(1) as f64).sqrt()
    }
}
