//! Which sets of causes the data ask for: all sets of up to three compete by their evidence, with and
//! without a force of unknown form.
//!
//! Every model that was fitted tells, linearised, the evidence of every other set in closed form. The
//! set that promises most among those within 100 : 1 of the best is fitted in full and tells anew,
//! until none is left that does. A cause so weak that it changes the evidence by less than
//! [`WEAK`] is linear: nothing is fitted for it.

use std::collections::BTreeSet;

use statrs::function::factorial::ln_binomial;

use super::cause_id::CauseId;

/// So many causes with a name at once.
const MOST_CAUSES: usize = 3;
/// Odds at which the data tell two sets from each other: 100 to 1, natural logarithm.
pub const TOLD: f64 = 4.6;
/// A cause that changes the evidence by less (natural logarithm) moves a fit by so little that all of it
/// is linear: two standard deviations.
const WEAK: f64 = 2.0;
/// What is linear tells gains to this share: laws are not.
const LINEAR: f64 = 0.03;
/// So many sets are fitted in full at most: as many as there are pairs of a dozen causes.
const MOST_FITS: usize = 66;

/// A set of forms of causes, rising places in the catalogue.
pub type Set = Vec<usize>;

/// What competes.
pub trait Competing {
    /// A model with a set of causes.
    type Model: Clone;
    /// What it says of other sets, linearised.
    type Linear;

    /// The forms in the catalogue.
    fn forms(&self) -> Vec<Form>;
    /// The logarithm of a model's evidence; `None` where it has none or stands at a prior's edge.
    fn log_evidence(&self, model: &Self::Model) -> Option<f64>;
    /// A set fitted in full, from where another model points or from elsewhere, whichever ends
    /// better.
    fn fitted(&self, set: &Set, pointed: Option<&Self::Model>) -> Option<Self::Model>;
    /// A model linearised.
    fn linear(&self, set: &Set, model: &Self::Model) -> Option<Self::Linear>;
    /// Another set by it.
    fn predicted(&self, linear: &Self::Linear, set: &Set) -> Option<Self::Model>;
}

/// A form of a cause.
#[derive(Debug, Clone, Copy)]
pub struct Form {
    /// The cause.
    pub id: CauseId,
    /// How many numbers it has.
    pub numbers: usize,
    /// Whether it can show.
    pub shows: bool,
}

/// Names with or without an unknown force.
struct Weighed {
    log_mass: f64,
    numbers: usize,
    names: Vec<CauseId>,
    unknown: bool,
}

/// A set that competes.
#[derive(Debug, Clone)]
pub struct Candidate<M> {
    /// Its forms.
    pub set: Set,
    /// Logarithm of the evidence times the prior.
    pub log_posterior: f64,
    /// The model.
    pub model: M,
    /// Whether it was fitted in full.
    pub is_fitted: bool,
}

/// All sets, weighed.
pub struct Selection<M> {
    forms: Vec<Form>,
    /// The best first.
    pub candidates: Vec<Candidate<M>>,
}

/// A model that was fitted in full.
struct Fitted<M, L> {
    set: Set,
    model: M,
    linear: Option<L>,
    log_posterior: f64,
}

/// What the model that differs least from a set says of it.
struct Prediction<M> {
    by: usize,
    candidate: Option<Candidate<M>>,
}

struct Search<'a, C: Competing> {
    competing: &'a C,
    forms: Vec<Form>,
    sets: Vec<Set>,
    fitted: Vec<Fitted<C::Model, C::Linear>>,
    failed: Vec<Set>,
    /// One for each set.
    predictions: Vec<Prediction<C::Model>>,
}

/// Weighs all sets; the empty one and `seeds` are fitted first. `None` where the empty one cannot be
/// fitted.
pub fn select<C: Competing>(competing: &C, seeds: &[Set]) -> Option<Selection<C::Model>> {
    let forms = competing.forms();
    let mut search = Search {
        competing,
        sets: sets(&forms),
        forms,
        fitted: vec![],
        failed: vec![],
        predictions: vec![],
    };
    search.add(vec![], competing.fitted(&vec![], None)?);
    for seed in seeds {
        if let Some(model) = competing.fitted(seed, None) {
            search.add(seed.clone(), model);
        }
    }
    search.predict();
    while search.fitted.len() + search.failed.len() < MOST_FITS {
        let Some(next) = search.next() else { break };
        match competing.fitted(&next.set, Some(&next.model)) {
            Some(model) => search.add(next.set, model),
            None => search.failed.push(next.set),
        }
        search.predict();
    }
    Some(Selection {
        forms: search.forms.clone(),
        candidates: search.candidates(),
    })
}

impl<C: Competing> Search<'_, C> {
    fn log_posterior(&self, set: &Set, model: &C::Model) -> Option<f64> {
        Some(self.competing.log_evidence(model)? + log_prior(&self.forms, set))
    }

    fn add(&mut self, set: Set, model: C::Model) {
        self.fitted.push(Fitted {
            linear: self.competing.linear(&set, &model),
            log_posterior: self
                .log_posterior(&set, &model)
                .unwrap_or(f64::NEG_INFINITY),
            set,
            model,
        });
    }

    /// Predicts every set to which a new model is nearer.
    fn predict(&mut self) {
        for place in 0..self.sets.len() {
            let set = &self.sets[place];
            let Some(by) = nearest(&self.fitted, set) else {
                continue;
            };
            if self
                .predictions
                .get(place)
                .is_some_and(|known| known.by == by)
            {
                continue;
            }
            let linear = self.fitted[by].linear.as_ref();
            let model = linear.and_then(|linear| self.competing.predicted(linear, set));
            let candidate = model.and_then(|model| {
                Some(Candidate {
                    log_posterior: self.log_posterior(set, &model)?,
                    set: set.clone(),
                    model,
                    is_fitted: false,
                })
            });
            let prediction = Prediction { by, candidate };
            match self.predictions.get_mut(place) {
                Some(known) => *known = prediction,
                None => self.predictions.push(prediction),
            }
        }
    }

    /// Of what is not fitted, is within reach of the best and is not weak, what promises most; of
    /// promises that are not told from each other, the one with the fewest numbers.
    fn next(&self) -> Option<Candidate<C::Model>> {
        let all = self.fitted.iter().map(|fitted| fitted.log_posterior);
        let best = all.fold(f64::NEG_INFINITY, f64::max);
        let promising = self.predictions.iter().filter_map(|prediction| {
            let candidate = prediction.candidate.as_ref()?;
            let near = &self.fitted[prediction.by];
            let is_worth = candidate.log_posterior > best - TOLD
                && self.is_open(&candidate.set)
                && !self.is_weak(candidate, near);
            let gain = (candidate.log_posterior - near.log_posterior).max(0.0);
            is_worth.then_some((candidate, TOLD + LINEAR * gain))
        });
        let promising: Vec<(&Candidate<C::Model>, f64)> = promising.collect();
        let by_promise = |a: &&Candidate<C::Model>, b: &&Candidate<C::Model>| {
            a.log_posterior.total_cmp(&b.log_posterior)
        };
        let (most, told) = promising
            .iter()
            .copied()
            .max_by(|a, b| by_promise(&a.0, &b.0))?;
        let near = promising.iter().map(|(candidate, _)| *candidate);
        let near = near.filter(|one| one.log_posterior > most.log_posterior - told);
        let numbers = |one: &Candidate<C::Model>| -> usize {
            one.set.iter().map(|form| self.forms[*form].numbers).sum()
        };
        let simplest = near.min_by(|a, b| numbers(a).cmp(&numbers(b)).then(by_promise(b, a)));
        simplest.cloned()
    }

    fn is_open(&self, set: &Set) -> bool {
        self.failed.iter().all(|known| known != set)
            && self.fitted.iter().all(|known| known.set != *set)
    }

    /// Whether a set has one cause more than a model, which hardly changes its evidence.
    fn is_weak(&self, one: &Candidate<C::Model>, near: &Fitted<C::Model, C::Linear>) -> bool {
        let evidence = |set: &Set, log_posterior: f64| log_posterior - log_prior(&self.forms, set);
        let change =
            evidence(&one.set, one.log_posterior) - evidence(&near.set, near.log_posterior);
        let is_one_more = apart(&near.set, &one.set) == 1 && one.set.len() > near.set.len();
        is_one_more && change.abs() < WEAK
    }

    /// Those that were fitted, and what is told of the others, the best first.
    fn candidates(self) -> Vec<Candidate<C::Model>> {
        let open: Vec<bool> = self.sets.iter().map(|set| self.is_open(set)).collect();
        let predicted = self.predictions.into_iter().zip(open);
        let mut all: Vec<Candidate<C::Model>> = predicted
            .filter(|(_, is_open)| *is_open)
            .filter_map(|(prediction, _)| prediction.candidate)
            .collect();
        let fitted = self.fitted.into_iter();
        let fitted = fitted.filter(|fitted| self.sets.contains(&fitted.set));
        all.extend(fitted.map(|fitted| Candidate {
            set: fitted.set,
            log_posterior: fitted.log_posterior,
            model: fitted.model,
            is_fitted: true,
        }));
        all.sort_by(|a, b| b.log_posterior.total_cmp(&a.log_posterior));
        all
    }
}

/// Every set of at most so many causes in one form each, with and without an unknown force.
fn sets(forms: &[Form]) -> Vec<Set> {
    let open = |k: &usize| forms[*k].shows;
    let places: Vec<usize> = (0..forms.len()).filter(open).collect();
    let mut all: Vec<Set> = vec![vec![]];
    let mut longest = all.clone();
    for _ in 0..=MOST_CAUSES {
        let mut longer: Vec<Set> = Vec::new();
        for set in &longest {
            let from = set.last().map_or(0, |last| last + 1);
            for place in places.iter().filter(|place| **place >= from) {
                let is_new = set.iter().all(|known| forms[*known].id != forms[*place].id);
                let mut with = set.clone();
                with.push(*place);
                let named = with.iter().filter(|k| forms[**k].id != CauseId::Unknown);
                if is_new && named.count() <= MOST_CAUSES {
                    longer.push(with);
                }
            }
        }
        all.extend(longer.iter().cloned());
        longest = longer;
    }
    all
}

/// Before the data each number of causes is half as likely as one less, and sets of as many alike;
/// the forms of a cause share its odds. A force without a name can be bent to do what causes with a
/// name do: it has to be told from them.
fn log_prior(forms: &[Form], set: &Set) -> f64 {
    let mut ids: Vec<CauseId> = forms.iter().map(|form| form.id).collect();
    ids.sort_unstable();
    ids.dedup();
    let of_form = |form: &usize| {
        let same = forms.iter().filter(|one| one.id == forms[*form].id);
        (same.count() as f64).ln()
    };
    let size = set.len();
    let of_size = (size + 1) as f64 * std::f64::consts::LN_2;
    let is_nameless = set.iter().any(|form| forms[*form].id == CauseId::Unknown);
    let nameless = if is_nameless { TOLD } else { 0.0 };
    -of_size
        - ln_binomial(ids.len() as u64, size as u64)
        - set.iter().map(of_form).sum::<f64>()
        - nameless
}

/// In how many forms two sets differ.
fn apart(a: &Set, b: &Set) -> usize {
    let missing = |of: &Set, other: &Set| of.iter().filter(|form| !other.contains(form)).count();
    missing(a, b) + missing(b, a)
}

/// The model that differs least from a set, the best of several.
fn nearest<M, L>(fitted: &[Fitted<M, L>], set: &Set) -> Option<usize> {
    let told = (0..fitted.len()).filter(|k| fitted[*k].linear.is_some());
    told.min_by(|a, b| {
        let (a, b) = (&fitted[*a], &fitted[*b]);
        let by = apart(&a.set, set).cmp(&apart(&b.set, set));
        by.then(b.log_posterior.total_cmp(&a.log_posterior))
    })
}

impl<M> Selection<M> {
    /// Names of a set, rising, an unknown force left out.
    pub fn names(&self, set: &Set) -> Vec<CauseId> {
        let ids = set.iter().map(|form| self.forms[*form].id);
        ids.filter(|id| *id != CauseId::Unknown).collect()
    }

    /// The cause of a form.
    pub fn id(&self, form: usize) -> CauseId {
        self.forms[form].id
    }

    /// Every cause, once.
    pub fn ids(&self) -> Vec<CauseId> {
        let mut ids: Vec<CauseId> = Vec::new();
        for form in &self.forms {
            if !ids.contains(&form.id) {
                ids.push(form.id);
            }
        }
        ids
    }

    /// The logarithm of a candidate's evidence.
    pub fn log_evidence(&self, candidate: &Candidate<M>) -> f64 {
        candidate.log_posterior - log_prior(&self.forms, &candidate.set)
    }

    /// Whether a cause is in a set.
    pub fn has(&self, set: &Set, id: CauseId) -> bool {
        set.iter().any(|form| self.forms[*form].id == id)
    }

    /// Without the sets that hold a cause.
    pub fn without(mut self, id: CauseId) -> Self {
        let candidates = std::mem::take(&mut self.candidates).into_iter();
        self.candidates = candidates.filter(|c| !self.has(&c.set, id)).collect();
        self
    }

    /// The share of the posterior that sets have of which something holds.
    pub fn mass(&self, holds: impl Fn(&Set) -> bool) -> f64 {
        let weights = self.weights();
        let pairs = self.candidates.iter().zip(&weights);
        pairs.filter(|(c, _)| holds(&c.set)).map(|(_, w)| w).sum()
    }

    /// The share of each candidate.
    pub fn weights(&self) -> Vec<f64> {
        let most = self.candidates.first().map_or(0.0, |c| c.log_posterior);
        let each = self
            .candidates
            .iter()
            .map(|c| (c.log_posterior - most).exp());
        let odds: Vec<f64> = each.collect();
        let all: f64 = odds.iter().sum();
        odds.into_iter().map(|o| o / all).collect()
    }

    /// The logarithm of the posterior of the sets of which something holds.
    fn log_mass(&self, holds: impl Fn(&Set) -> bool) -> f64 {
        let held = || self.candidates.iter().filter(|c| holds(&c.set));
        let most = held()
            .map(|c| c.log_posterior)
            .fold(f64::NEG_INFINITY, f64::max);
        if most == f64::NEG_INFINITY {
            return most;
        }
        most + held()
            .map(|c| (c.log_posterior - most).exp())
            .sum::<f64>()
            .ln()
    }

    /// The logarithm of the posterior of names, with an unknown force or without.
    fn of_names(&self, names: &[CauseId], is_unknown: bool) -> f64 {
        self.log_mass(|set| {
            self.names(set) == names && self.has(set, CauseId::Unknown) == is_unknown
        })
    }

    /// The names that the data ask for, and whether an unknown force beside them: of the names that the
    /// data do not tell from the most probable ones, those with the fewest numbers.
    pub fn asked(&self) -> (Vec<CauseId>, bool) {
        let key = |c: &Candidate<M>| (self.has(&c.set, CauseId::Unknown), self.names(&c.set));
        let distinct: BTreeSet<(bool, Vec<CauseId>)> = self.candidates.iter().map(key).collect();
        let weighed = distinct.into_iter().map(|(unknown, names)| Weighed {
            log_mass: self.of_names(&names, unknown),
            numbers: self.numbers(&names),
            names,
            unknown,
        });
        let all: Vec<Weighed> = weighed.collect();
        let Some(best) = all.iter().max_by(|a, b| a.log_mass.total_cmp(&b.log_mass)) else {
            return (vec![], false);
        };
        let is_near =
            |one: &&Weighed| one.unknown == best.unknown && one.log_mass > best.log_mass - TOLD;
        let near = all.iter().filter(is_near).min_by(|a, b| {
            let by = a.numbers.cmp(&b.numbers);
            by.then(b.log_mass.total_cmp(&a.log_mass))
        });
        let named = near.unwrap_or(best);
        (named.names.clone(), named.unknown)
    }

    /// How many numbers causes have together.
    fn numbers(&self, names: &[CauseId]) -> usize {
        let of = |id: &CauseId| self.forms.iter().find(|form| form.id == *id);
        names.iter().filter_map(of).map(|form| form.numbers).sum()
    }

    /// Names that do as well in other sets, where one of those asked for is missing; the best first.
    /// What could be left out of such a set does nothing there.
    pub fn instead(&self, asked: &[CauseId]) -> Vec<CauseId> {
        let best = self.log_mass(|set| asked.iter().all(|id| self.has(set, *id)));
        let lacks = |names: &Vec<CauseId>| asked.iter().any(|id| !names.contains(id));
        let near = self
            .candidates
            .iter()
            .filter(|c| c.log_posterior > best - TOLD);
        let near: Vec<Vec<CauseId>> = near.map(|c| self.names(&c.set)).filter(lacks).collect();
        let is_needed = |names: &&Vec<CauseId>| {
            let is_part = |other: &Vec<CauseId>| {
                other.len() < names.len() && other.iter().all(|id| names.contains(id))
            };
            !near.iter().any(is_part)
        };
        let mut found: Vec<CauseId> = Vec::new();
        for id in near.iter().filter(is_needed).flatten() {
            if !asked.contains(id) && !found.contains(id) {
                found.push(*id);
            }
        }
        found
    }

    /// The best candidate of which something holds.
    pub fn best(&self, holds: impl Fn(&Set) -> bool) -> Option<&Candidate<M>> {
        self.candidates.iter().find(|c| holds(&c.set))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;

    /// Readings that are sums of columns, noise of 1, each strength within a prior of width 3.
    struct Columns {
        readings: DVector<f64>,
        columns: DMatrix<f64>,
        /// How often a set was fitted in full.
        fits: std::cell::Cell<usize>,
    }

    impl Columns {
        /// The logarithm of the density of the readings: normal, their covariance 1 + 9 C Cᵀ.
        fn evidence(&self, set: &Set) -> Option<f64> {
            let columns = self.columns.select_columns(set.iter());
            let size = self.readings.len();
            let covariance = DMatrix::identity(size, size) + 9.0 * &columns * columns.transpose();
            let root = covariance.clone().cholesky()?;
            let square = self.readings.dot(&root.solve(&self.readings));
            let volume = (std::f64::consts::TAU * covariance).determinant().ln();
            Some(-0.5 * (square + volume))
        }
    }

    impl Competing for Columns {
        type Model = f64;
        type Linear = ();

        fn forms(&self) -> Vec<Form> {
            let form = |id| Form {
                id,
                numbers: 1,
                shows: true,
            };
            vec![
                form(CauseId::QuadraticDrag),
                form(CauseId::BearingFriction),
                form(CauseId::Unknown),
            ]
        }

        fn log_evidence(&self, model: &f64) -> Option<f64> {
            Some(*model)
        }

        fn fitted(&self, set: &Set, _: Option<&f64>) -> Option<f64> {
            self.fits.set(self.fits.get() + 1);
            self.evidence(set)
        }

        fn linear(&self, _: &Set, _: &f64) -> Option<()> {
            Some(())
        }

        /// All of it is linear: what is predicted is right.
        fn predicted(&self, _: &(), set: &Set) -> Option<f64> {
            self.evidence(set)
        }
    }

    fn selected(readings: [f64; 4]) -> (Selection<f64>, usize) {
        let columns = Columns {
            readings: DVector::from_column_slice(&readings),
            columns: DMatrix::from_column_slice(
                4,
                3,
                &[1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, -1.0, 0.5],
            ),
            fits: std::cell::Cell::new(0),
        };
        let selection = select(&columns, &[]).unwrap();
        (selection, columns.fits.get())
    }

    /// scipy: multivariate_normal.logpdf of the readings, times 2^-(n + 1) over binom(3, n), and
    /// e^-4.6 of it for what has no name.
    #[test]
    fn sets_have_the_posterior_of_their_evidence() {
        let (selection, _) = selected([4.0, 0.3, 3.6, -0.2]);
        let mass = |id| selection.mass(|set| selection.has(set, id));
        for (id, expected) in [
            (CauseId::QuadraticDrag, 0.9999721352897395),
            (CauseId::BearingFriction, 0.1033576101188338),
            (CauseId::Unknown, 0.0012267201604734168),
        ] {
            assert!((mass(id) - expected).abs() < 1e-9, "{id}: {}", mass(id));
        }
        assert_eq!(selection.asked(), (vec![CauseId::QuadraticDrag], false));
        assert!(selection.instead(&[CauseId::QuadraticDrag]).is_empty());
    }

    #[test]
    fn nothing_is_asked_for_where_nothing_shows() {
        let (selection, fits) = selected([0.4, -0.3, 0.2, 0.1]);
        assert_eq!(selection.asked(), (vec![], false));
        // What is weak is not fitted.
        assert_eq!(fits, 1);
    }
}
