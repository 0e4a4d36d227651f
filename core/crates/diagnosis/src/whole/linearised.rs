//! A fitted model of a session linearised: what it says of all other sets of causes in closed form.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use gyradius_base::error::{Error, Result};

use super::super::fitting::Places;
use super::super::found::Found;
use super::super::look::{Equations, Look, Part, Standing, Sums, seen};
use super::super::point::{Cause, Model, Point};
use super::super::selection::Set;
use super::kind::{Kind, instances};
use super::quadratic::{Number, Quadratic, Solved};

/// A cause that is not in the model, as that sees it.
pub struct Sight {
    /// The instance that promises most by itself, with its others.
    pub look: Look,
    /// Places of its strengths among all numbers.
    places: Range<usize>,
}

pub struct Linearised<'a> {
    pub found: Arc<Found<'a>>,
    pub set: Set,
    /// By form, of those that are in the model: places of their numbers, which come first.
    inside: Vec<Vec<usize>>,
    /// By form, of those that are not.
    pub outside: Vec<Option<Sight>>,
    quadratic: Quadratic,
    /// Changes of everything else: by itself, and by each of the numbers.
    rest: DVector<f64>,
    absorbed: DMatrix<f64>,
    /// Products of new strengths with everything that is fitted, and with each other.
    outer: DMatrix<f64>,
    inner: DMatrix<f64>,
}

/// Derivatives of each swing by the strengths of a cause.
type Sensitivity = Vec<DMatrix<f64>>;

/// The best instance of each form that is not in the model, its strengths behind `numbers`.
fn sights(
    standing: &Standing,
    causes: &[Cause],
    kinds: &[Kind],
    numbers: &mut Vec<Number>,
) -> (Vec<Option<Sight>>, Vec<Sensitivity>) {
    let swings = standing.model.base.swings.len();
    let mut sensitivities = seen(standing, causes);
    let mut columns = vec![];
    let mut sight = |kind: &Kind| {
        let instances = (0..causes.len()).filter(|k| Kind::of(&causes[*k]) == *kind);
        let look = |k: usize| {
            Some((
                Look::at(standing, &causes[k], sensitivities[k].as_ref()?)?,
                k,
            ))
        };
        let looks = instances.filter_map(look);
        let mut looks: Vec<(Look, usize)> = looks
            .filter(|(look, _)| look.score_test.is_some())
            .collect();
        looks.sort_by(|a, b| b.0.gain.total_cmp(&a.0.gain));
        let mut looks = looks.into_iter();
        let (mut best, place) = looks.next()?;
        for (look, _) in looks {
            best.keep(&look);
        }
        columns.push(sensitivities[place].take()?);
        let score_test = best.score_test.as_ref()?;
        let known = score_test.cause.expanded(swings);
        let first = numbers.len();
        numbers.extend(score_test.places.iter().map(|k| Number {
            value: 0.0,
            prior: known[*k].0.prior,
            is_strength: true,
            one_sided: score_test.cause.one_sided,
            is_new: true,
        }));
        Some(Sight {
            look: best,
            places: first..numbers.len(),
        })
    };
    let sights = kinds.iter().map(&mut sight).collect();
    (sights, columns)
}

/// What all swings say of new strengths together.
fn sums(standing: &Standing, columns: &[Sensitivity], new: &[Number]) -> Sums {
    let u = DVector::from_iterator(new.len(), new.iter().map(|number| number.prior.1));
    let mut equations = Equations::new(standing, u);
    for (s, residual) in standing.residuals.iter().enumerate() {
        let mut all = DMatrix::zeros(residual.len(), new.len());
        let mut at = 0;
        for column in columns {
            let width = column[s].ncols();
            all.columns_mut(at, width).copy_from(&column[s]);
            at += width;
        }
        equations.add(s, &Part::of(&standing.fitted.jacobians[s], &all, residual));
    }
    equations.into_sums()
}

impl<'a> Linearised<'a> {
    pub fn of(found: Arc<Found<'a>>, set: Set, kinds: &[Kind]) -> Result<Self> {
        let failed = || Error::no_result("criticism", "the samples do not decide the parameters");
        let standing = Standing::of(&found.model, &found.fitted.point)?;
        let causes = instances(&standing, &found.left)?;
        let (mut numbers, inside) = of_model(&found, kinds);
        let (outside, columns) = sights(&standing, &causes, kinds, &mut numbers);
        let places = Places::of(&found.model);
        let (first, count) = (places.first_cause(), places.causes);
        let sums = sums(&standing, &columns, &numbers[count..]);
        let outer = sums.beside_held(&standing.fitted);
        let (inner, score) = (sums.inner, sums.score);
        // Everything else is eliminated.
        let own: Vec<usize> = (first..first + count).collect();
        let others: Vec<usize> = (0..first).chain(first + count..places.all()).collect();
        let fitted = &standing.fitted;
        let of_others = fitted.matrix.select_rows(&others);
        let across = beside(of_others.select_columns(&own), outer.select_rows(&others));
        let mut pull = fitted.gradient.select_rows(&own);
        pull = pull.insert_rows(count, score.len(), 0.0);
        pull.rows_mut(count, score.len()).copy_from(&score);
        let of_own = fitted.matrix.select_rows(&own).select_columns(&own);
        let by_new = outer.select_rows(&own);
        let above = beside(of_own, by_new.clone());
        let below = beside(by_new.transpose(), inner.clone());
        let mut information = above.transpose();
        information = beside(information, below.transpose());
        let factor = of_others
            .select_columns(&others)
            .cholesky()
            .ok_or_else(failed)?;
        let absorbed = factor.solve(&across);
        let gradient = fitted.gradient.select_rows(&others);
        information -= across.transpose() * &absorbed;
        pull -= absorbed.tr_mul(&gradient);
        let log_evidence = found.fitted.log_evidence.ok_or_else(failed)?;
        Ok(Self {
            set,
            inside,
            outside,
            quadratic: Quadratic::of(numbers, information, pull, log_evidence)
                .ok_or_else(failed)?,
            rest: factor.solve(&gradient),
            absorbed,
            outer,
            inner,
            found,
        })
    }

    /// Another set, everything linear; `None` where one of its causes is not seen from here.
    pub fn solved(&self, set: &Set) -> Option<Solved> {
        let mut with: Vec<usize> = vec![];
        for form in set {
            match &self.outside[*form] {
                Some(sight) => with.extend(sight.places.clone()),
                None if self.inside[*form].is_empty() => return None,
                None => with.extend(&self.inside[*form]),
            }
        }
        self.quadratic.solved(&with)
    }

    /// The model of another set and where its fit begins: a share of the way to where everything
    /// linear leads.
    pub fn start(&self, set: &Set, kinds: &[Kind], share: f64) -> Option<(Model<'a>, Point)> {
        let delta = self.solved(set)?.delta;
        let model = &self.found.model;
        let swings = model.base.swings.len();
        let rest = &self.rest - &self.absorbed * &delta;
        let places = Places::of(model);
        let (first, count) = (places.first_cause(), places.causes);
        let mut change = rest.insert_rows(first, count, 0.0);
        change
            .rows_mut(first, count)
            .copy_from(&delta.rows(0, count));
        let moved = model.moved(&self.found.fitted.point, &(change * share));
        let (mut extended, mut point) = only(model, &moved, set, kinds);
        for form in set {
            let Some(sight) = &self.outside[*form] else {
                continue;
            };
            let (cause, score_test) = (&sight.look.cause, sight.look.score_test.as_ref()?);
            let mut values = cause.start(swings);
            if cause.look.is_some() {
                // What it is nearest to by itself.
                let by_itself = sight.look.delta.rows(places.first_own(0), values.len());
                let all = values.iter_mut().zip(by_itself.iter());
                all.for_each(|(value, change)| *value += share * change);
            } else {
                for (k, place) in score_test.places.iter().zip(sight.places.clone()) {
                    values[*k] += share * delta[place];
                }
            }
            extended = extended.with(cause);
            point.causes.push(values);
        }
        let point = extended.bounded(point);
        Some((extended, point))
    }

    /// Information of everything that is fitted in another set; of new numbers that are no strengths,
    /// that of their priors.
    pub fn information_of(&self, set: &Set, kinds: &[Kind]) -> Option<DMatrix<f64>> {
        let model = &self.found.model;
        let swings = model.base.swings.len();
        let places = Places::of(model);
        let first = places.first_cause();
        let is_kept = kept(model, set, kinds);
        let own = (0..places.causes)
            .filter(|k| is_kept[*k])
            .map(|k| first + k);
        let mut all: Vec<From> = (0..first).chain(own).map(From::Fitted).collect();
        for sight in set.iter().filter_map(|form| self.outside[*form].as_ref()) {
            let (cause, score_test) = (&sight.look.cause, sight.look.score_test.as_ref()?);
            for (k, (parameter, _)) in cause.expanded(swings).into_iter().enumerate() {
                let strength = score_test.places.iter().position(|place| *place == k);
                all.push(match strength.filter(|_| cause.look.is_none()) {
                    Some(n) => From::New(sight.places.start + n - places.causes),
                    None => From::Prior(parameter.prior.1.powi(-2)),
                });
            }
        }
        all.extend((places.first_own(0)..places.all()).map(From::Fitted));
        let fitted = &self.found.fitted.matrix;
        let cell = |i: usize, j: usize| match (&all[i], &all[j]) {
            (From::Fitted(a), From::Fitted(b)) => fitted[(*a, *b)],
            (From::Fitted(a), From::New(b)) | (From::New(b), From::Fitted(a)) => {
                self.outer[(*a, *b)]
            }
            (From::New(a), From::New(b)) => self.inner[(*a, *b)],
            (From::Prior(information), From::Prior(_)) if i == j => *information,
            _ => 0.0,
        };
        Some(DMatrix::from_fn(all.len(), all.len(), cell))
    }
}

/// Where the information of a number is.
enum From {
    Fitted(usize),
    New(usize),
    Prior(f64),
}

fn beside(left: DMatrix<f64>, right: DMatrix<f64>) -> DMatrix<f64> {
    let (width, more) = (left.ncols(), right.ncols());
    let mut both = left.insert_columns(width, more, 0.0);
    both.columns_mut(width, more).copy_from(&right);
    both
}

/// Numbers of the causes in a model, and by form their places among them.
fn of_model(found: &Found, kinds: &[Kind]) -> (Vec<Number>, Vec<Vec<usize>>) {
    let swings = found.model.base.swings.len();
    let mut numbers = vec![];
    let mut places: Vec<Vec<usize>> = vec![vec![]; kinds.len()];
    for (cause, values) in found.model.causes.iter().zip(&found.fitted.point.causes) {
        let form = kinds.iter().position(|kind| *kind == Kind::of(cause));
        for ((parameter, _), value) in cause.expanded(swings).into_iter().zip(values) {
            form.into_iter()
                .for_each(|form| places[form].push(numbers.len()));
            numbers.push(Number {
                value: *value,
                prior: parameter.prior,
                is_strength: parameter.is_strength,
                one_sided: cause.one_sided && parameter.is_strength,
                is_new: false,
            });
        }
    }
    (numbers, places)
}

fn is_in(cause: &Cause, set: &Set, kinds: &[Kind]) -> bool {
    set.iter().any(|form| kinds[*form] == Kind::of(cause))
}

/// Number by number of the causes in a model, whether its cause is in a set.
fn kept(model: &Model, set: &Set, kinds: &[Kind]) -> Vec<bool> {
    let swings = model.base.swings.len();
    let of = |cause: &Cause| vec![is_in(cause, set, kinds); cause.size(swings)];
    model.causes.iter().flat_map(of).collect()
}

/// A model and its point with those of its causes alone that are in a set.
pub fn only<'a>(model: &Model<'a>, point: &Point, set: &Set, kinds: &[Kind]) -> (Model<'a>, Point) {
    model.only(point, |_, cause| is_in(cause, set, kinds))
}
