//! A first look at every cause: what it would gain, were everything linear about the fitted base.
//!
//! The sensitivity to a cause's strengths is made orthogonal to everything that is fitted; its
//! product with the residual is the score.

use nalgebra::{DMatrix, DVector};

use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_mechanics::{LANES, Path};

use super::fitting::{Fitted, Places};
use super::linear::Wanted;
use super::point::{Cause, Model, Point, Seen};

/// So many strengths of a cause that is looked at alone are in it at once: each of them makes the
/// simulation longer for all.
const A_FEW: usize = 2;
/// First looks are right to this share, where laws are not linear.
pub const RIVAL_SHARE: f64 = 0.3;
/// Gains that differ by a smaller share are those of one law: rounding is below it.
const SAME: f64 = 1e-6;

/// A fitted model as first looks see it. They are made side by side.
pub struct Standing<'a> {
    pub model: Model<'a>,
    pub fitted: Fitted,
    /// What it leaves of each swing, row by row.
    pub residuals: Vec<DVector<f64>>,
    /// Its motions, without what derivatives are taken apart from.
    paths: Vec<Path<f64>>,
}

impl<'a> Standing<'a> {
    /// Derivatives are taken anew: what one cause leaves of another is a small difference of large
    /// things, and those that led a fit are too rough for it.
    pub fn of(model: &Model<'a>, point: &Point) -> Result<Self> {
        let model = Model {
            of_many: true,
            ..model.precise()
        };
        let (reduced, there) = model.reduced(point, model.causes.len());
        let seen = in_parallel(model.base.swings.len(), |s| {
            Ok((
                DVector::from_vec(model.rows(point, s)?),
                reduced.path_of_slopes(&there, s)?,
            ))
        });
        let (residuals, paths) = seen
            .into_iter()
            .collect::<Result<Vec<_>>>()?
            .into_iter()
            .unzip();
        let fitted = model.unmoved(point)?;
        Ok(Self {
            model,
            fitted,
            residuals,
            paths,
        })
    }
}

/// What a first look says of a cause.
#[derive(Clone)]
pub struct Look {
    pub cause: Cause,
    /// Expected gain of the logarithm of the evidence.
    pub gain: f64,
    /// Change of everything that is fitted, the cause's values (from its start) behind the other
    /// causes'.
    pub delta: DVector<f64>,
    /// Other forms of the same cause that promise nearly as much.
    pub others: Vec<Look>,
    /// What it was seen by, where all swings were looked at alike.
    pub score_test: Option<ScoreTest>,
}

/// Strengths of a cause as a first look sees them.
#[derive(Clone)]
pub struct ScoreTest {
    /// The cause, or what is seen in its place.
    pub cause: Cause,
    /// Places of the strengths among its values.
    pub places: Vec<usize>,
    pub sums: Sums,
}

impl Look {
    /// What is seen of a cause beside what is fitted; none where it has no parameters like that.
    pub fn at(standing: &Standing, cause: &Cause, sensitivities: &[DMatrix<f64>]) -> Option<Self> {
        let Some(alike) = &cause.look else {
            return Some(Self::straight(standing, cause, sensitivities));
        };
        let look = Self::straight(standing, &alike.cause, sensitivities);
        let model = &standing.model;
        let swings = model.base.swings.len();
        let (split, size) = (Places::of(model).first_own(0), alike.cause.size(swings));
        let beside = look
            .score_test
            .as_ref()
            .and_then(|score_test| Beside::of(&standing.fitted, &score_test.sums));
        let beside = beside?;
        let strengths = look.delta.rows(split, size).into_owned();
        let seen = Seen {
            strengths,
            information: beside.schur.clone(),
            score: beside.score.clone(),
        };
        let nearest = (alike.nearest)(&seen)?;
        let values: Vec<f64> = (cause.start(swings).iter().enumerate())
            .map(|(k, from)| {
                nearest
                    .parameters
                    .get(k)
                    .filter(|value| value.is_finite())
                    .map_or(0.0, |value| value - from)
            })
            .collect();
        let delta = laid_out(model, &beside.rest(&nearest.strengths), &values);
        Some(Self {
            cause: cause.clone(),
            delta,
            ..look
        })
    }

    fn straight(standing: &Standing, cause: &Cause, sensitivities: &[DMatrix<f64>]) -> Self {
        let model = &standing.model;
        let swings = model.base.swings.len();
        let strengths = cause.strengths(swings);
        let all = cause.expanded(swings);
        let u = DVector::from_fn(strengths.len(), |k, _| all[strengths[k]].0.prior.1);
        let mut equations = Equations::new(standing, u);
        for (s, sensitivity) in sensitivities.iter().enumerate() {
            let (jacobian, residual) = (&standing.fitted.jacobians[s], &standing.residuals[s]);
            equations.add(s, &Part::of(jacobian, sensitivity, residual));
        }
        let Some(solved) = equations.solved(cause.one_sided) else {
            let delta = DVector::zeros(Places::of(model).all() + cause.size(swings));
            let (cause, gain) = (cause.clone(), f64::NEG_INFINITY);
            return Self {
                cause,
                gain,
                delta,
                others: vec![],
                score_test: None,
            };
        };
        let mut values = vec![0.0; cause.size(swings)];
        strengths
            .iter()
            .zip(solved.strength.iter())
            .for_each(|(place, strength)| values[*place] = *strength);
        let delta = laid_out(model, &solved.rest, &values);
        let score_test = ScoreTest {
            cause: cause.clone(),
            places: strengths,
            sums: equations.sums,
        };
        Self {
            cause: cause.clone(),
            gain: solved.gain,
            delta,
            others: vec![],
            score_test: Some(score_test),
        }
    }

    /// Keeps another form of the same cause beside this one if it promises nearly as much.
    pub fn keep(&mut self, other: &Self) {
        if other.gain > RIVAL_SHARE * self.gain && !self.is_seen_as(other) {
            self.others.push(other.clone());
        }
    }

    /// Whether another form of the same cause promises just the same: a length is a share of the
    /// spacing where there is but one.
    fn is_seen_as(&self, other: &Self) -> bool {
        let mut looks = [self].into_iter().chain(&self.others);
        looks.any(|known| (known.gain - other.gain).abs() < SAME * known.gain.abs())
    }

    /// The point that the look leads to, by a share of the way.
    pub fn start(&self, model: &Model, fitted: &Fitted, share: f64) -> Point {
        let swings = model.base.swings.len();
        let mut at = fitted.point.clone();
        at.causes.push(self.cause.start(swings));
        let extended = model.with(&self.cause);
        extended.bounded(extended.moved(&at, &(&self.delta * share)))
    }
}

/// A change of everything that is fitted, with the values of one more cause behind the other
/// causes'.
pub fn laid_out(model: &Model, rest: &DVector<f64>, values: &[f64]) -> DVector<f64> {
    let split = Places::of(model).first_own(0);
    let mut delta = rest.clone().insert_rows(split, values.len(), 0.0);
    delta.rows_mut(split, values.len()).copy_from_slice(values);
    delta
}

/// Strengths beside everything that is fitted: the equations that all swings together make for
/// them.
pub struct Equations<'a> {
    standing: &'a Standing<'a>,
    sums: Sums,
}

/// Products of derivatives by strengths with those by what is fitted, with each other and with what
/// is left.
#[derive(Clone)]
pub struct Sums {
    /// Of the strengths' priors.
    pub u: DVector<f64>,
    pub outer: DMatrix<f64>,
    /// Priors included.
    pub inner: DMatrix<f64>,
    pub score: DVector<f64>,
}

/// Strengths that solve the equations, and the change of everything else that goes with them.
pub struct Solved {
    pub strength: DVector<f64>,
    pub rest: DVector<f64>,
    pub gain: f64,
}

impl<'a> Equations<'a> {
    pub fn new(standing: &'a Standing<'a>, u: DVector<f64>) -> Self {
        let outer = DMatrix::zeros(Places::of(&standing.model).all(), u.len());
        let inner = DMatrix::from_diagonal(&u.map(|u: f64| u.powi(-2)));
        let score = DVector::zeros(u.len());
        Self {
            standing,
            sums: Sums {
                u,
                outer,
                inner,
                score,
            },
        }
    }

    /// Adds what a swing says.
    pub fn add(&mut self, s: usize, part: &Part) {
        self.sums.inner += &part.inner;
        self.sums.score += &part.score;
        let model = &self.standing.model;
        for (row, place) in Places::of(model).of_swing(model, s).into_iter().enumerate() {
            let mut sum = self.sums.outer.row_mut(place);
            sum += part.outer.row(row);
        }
    }

    pub fn into_sums(self) -> Sums {
        self.sums
    }

    /// With everything else made the best of; strengths that cannot be negative at zero or above.
    pub fn solved(&self, one_sided: bool) -> Option<Solved> {
        let beside = Beside::of(&self.standing.fitted, &self.sums)?;
        let (strength, gain) = strengths(&beside.schur, &beside.score, &self.sums.u, one_sided)?;
        let rest = beside.rest(&strength);
        Some(Solved {
            strength,
            rest,
            gain,
        })
    }
}

/// Strengths, and what everything that is fitted does beside them.
pub struct Beside {
    /// Its change by each of them.
    pub absorbed: DMatrix<f64>,
    /// Its change without them.
    pub moved: DVector<f64>,
    /// What the data and the priors say of the strengths then, and how they pull at them.
    pub schur: DMatrix<f64>,
    pub score: DVector<f64>,
}

impl Beside {
    /// What is held makes up for nothing.
    pub fn of(fitted: &Fitted, sums: &Sums) -> Option<Self> {
        let base = fitted.cholesky()?;
        let absorbed = base.solve(&sums.beside_held(fitted));
        let schur = &sums.inner - sums.outer.tr_mul(&absorbed);
        let score = &sums.score - absorbed.tr_mul(&fitted.gradient);
        Some(Self {
            absorbed,
            moved: base.solve(&fitted.gradient),
            schur,
            score,
        })
    }

    /// The change of everything that is fitted beside given strengths.
    pub fn rest(&self, strengths: &DVector<f64>) -> DVector<f64> {
        &self.moved - &self.absorbed * strengths
    }
}

impl Sums {
    /// Products with derivatives by what is fitted, none with what is held.
    pub fn beside_held(&self, fitted: &Fitted) -> DMatrix<f64> {
        let mut free = self.outer.clone();
        fitted
            .held
            .iter()
            .for_each(|place| free.row_mut(*place).fill(0.0));
        free
    }
}

/// The strengths with the gain of evidence; where they are one-sided, those that would be negative
/// are zero.
pub fn strengths(
    schur: &DMatrix<f64>,
    score: &DVector<f64>,
    u: &DVector<f64>,
    one_sided: bool,
) -> Option<(DVector<f64>, f64)> {
    let mut open: Vec<usize> = (0..score.len()).collect();
    loop {
        let part = DMatrix::from_fn(open.len(), open.len(), |i, j| schur[(open[i], open[j])]);
        let wanted = DVector::from_fn(open.len(), |i, _| score[open[i]]);
        let factor = part.cholesky()?;
        let found = factor.solve(&wanted);
        let worst = (0..open.len()).filter(|i| one_sided && found[*i] < 0.0);
        // In standard deviations of their priors: their units differ.
        let worst =
            worst.min_by(|a, b| (found[*a] / u[open[*a]]).total_cmp(&(found[*b] / u[open[*b]])));
        if let Some(worst) = worst {
            open.remove(worst);
            continue;
        }
        let mut strength = DVector::zeros(score.len());
        open.iter()
            .zip(found.iter())
            .for_each(|(k, x)| strength[*k] = *x);
        let log_determinant: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
        let occam = log_determinant + open.iter().map(|k| u[*k].ln()).sum::<f64>();
        return Some((strength, 0.5 * wanted.dot(&found) - occam));
    }
}

/// What a swing adds to the equations.
#[derive(Clone)]
pub struct Part {
    outer: DMatrix<f64>,
    inner: DMatrix<f64>,
    score: DVector<f64>,
}

impl Part {
    /// Of so many that are fitted, and so many strengths.
    pub fn nothing(fitted: usize, strengths: usize) -> Self {
        Self {
            outer: DMatrix::zeros(fitted, strengths),
            inner: DMatrix::zeros(strengths, strengths),
            score: DVector::zeros(strengths),
        }
    }

    /// Adds one row of derivatives by what is fitted and by the strengths, and its residual.
    pub fn add_row(
        &mut self,
        (jacobian, sensitivity): (&DMatrix<f64>, &DMatrix<f64>),
        residual: &DVector<f64>,
        row: usize,
    ) {
        let by_strengths = sensitivity.row(row);
        for (l, by_strength) in by_strengths.iter().enumerate() {
            let add = |to: &mut DMatrix<f64>, from: &DMatrix<f64>| {
                (0..from.ncols()).for_each(|k| to[(k, l)] += by_strength * from[(row, k)]);
            };
            add(&mut self.outer, jacobian);
            add(&mut self.inner, sensitivity);
            self.score[l] += by_strength * residual[row];
        }
    }

    /// From derivatives by what is fitted and by the strengths, and the residual, row by row.
    pub fn of(
        jacobian: &DMatrix<f64>,
        sensitivity: &DMatrix<f64>,
        residual: &DVector<f64>,
    ) -> Self {
        // Not `tr_mul`, which multiplies matrices element by element.
        let by_rows = sensitivity.transpose();
        Self {
            outer: (&by_rows * jacobian).transpose(),
            inner: &by_rows * sensitivity,
            score: &by_rows * residual,
        }
    }
}

/// First looks at causes; none at those that cannot be simulated here.
pub fn looks_at(standing: &Standing, causes: &[Cause]) -> Vec<Look> {
    let seen = seen(standing, causes);
    let looks = in_parallel(causes.len(), |k| {
        Look::at(standing, &causes[k], seen[k].as_ref()?)
    });
    looks.into_iter().flatten().collect()
}

/// Derivatives by the strengths of causes, cause by cause and swing by swing; none of those that
/// cannot be simulated here.
pub fn seen(standing: &Standing, causes: &[Cause]) -> Vec<Option<Vec<DMatrix<f64>>>> {
    let seen: Vec<&Cause> = causes.iter().map(Cause::as_seen).collect();
    let groups = side_by_side(&seen);
    let sensitivities = in_parallel(groups.len(), |g| {
        let group: Vec<&Cause> = groups[g].iter().map(|k| seen[*k]).collect();
        let together = sensitivities(standing, &group);
        together.map_or_else(
            |_| {
                let by_itself = |cause: &&Cause| sensitivities(standing, &[*cause]).ok();
                group.iter().map(|c| by_itself(c)?.pop()).collect()
            },
            |all| all.into_iter().map(Some).collect::<Vec<_>>(),
        )
    });
    let mut of_each: Vec<Option<Vec<DMatrix<f64>>>> = vec![None; causes.len()];
    for (k, found) in groups
        .iter()
        .flatten()
        .zip(sensitivities.into_iter().flatten())
    {
        of_each[*k] = found;
    }
    of_each
}

/// Which causes are looked at in one simulation: as many as its derivatives have room for. At
/// strengths of zero none acts on another.
fn side_by_side(causes: &[&Cause]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Vec<usize>, usize)> = vec![];
    for (k, cause) in causes.iter().enumerate() {
        // Those of one swing.
        let size = cause.parameters.iter().filter(|p| p.is_strength).count();
        let has_room = |(group, taken): &&mut (Vec<usize>, usize)| {
            let first = causes[group[0]];
            !cause.alone && !first.alone && first.kinked == cause.kinked && *taken + size <= LANES
        };
        match groups.iter_mut().find(has_room) {
            Some((group, taken)) => {
                group.push(k);
                *taken += size;
            }
            None => groups.push((vec![k], size)),
        }
    }
    groups.into_iter().map(|(group, _)| group).collect()
}

/// Derivatives of the rows of each swing by the strengths of causes, cause by cause.
fn sensitivities(standing: &Standing, causes: &[&Cause]) -> Result<Vec<Vec<DMatrix<f64>>>> {
    let swings = standing.model.base.swings.len();
    let (mut extended, mut at) = (standing.model.clone(), standing.fitted.point.clone());
    let mut strengths = vec![];
    let mut first = 0;
    for cause in causes {
        extended.causes.push((*cause).clone());
        at.causes.push(cause.start(swings));
        strengths.extend(cause.strengths(swings).iter().map(|k| first + k));
        first += cause.size(swings);
    }
    let all: Vec<DMatrix<f64>> = (0..swings)
        .map(|s| sensitivity(standing, &extended, &at, s, &strengths))
        .collect::<Result<_>>()?;
    let mut first = 0;
    let of_cause = |cause: &&Cause| {
        let count = cause.strengths(swings).len();
        let own = all.iter().map(|all| all.columns(first, count).into_owned());
        let own = own.collect();
        first += count;
        own
    };
    Ok(causes.iter().map(of_cause).collect())
}

/// Of a swing, by the strengths of the causes of a model that are new, places among all their
/// values, at a point where they are zero: what is left there is what the model without them
/// leaves.
fn sensitivity(
    standing: &Standing,
    extended: &Model,
    at: &Point,
    s: usize,
    strengths: &[usize],
) -> Result<DMatrix<f64>> {
    let known = standing.model.causes.len();
    let is_alone = extended.causes[known..].iter().any(|cause| cause.alone);
    let blocks = extended.blocks(s);
    let new: usize = at.causes[known..].iter().map(Vec::len).sum();
    let (extended, at) = &extended.reduced(at, known);
    let places = Places::of(extended);
    let first = places.free + 6 + places.causes - new;
    let wanted: Vec<Wanted> = (strengths.iter().enumerate())
        .map(|(to, k)| Wanted {
            column: first + k,
            to,
        })
        .collect();
    let mut sensitivity = DMatrix::zeros(standing.residuals[s].len(), strengths.len());
    let path = Some(&standing.paths[s]);
    for group in wanted.chunks(if is_alone { A_FEW } else { LANES }) {
        extended.fill((at, s), &blocks, group, path, &mut sensitivity)?;
    }
    Ok(sensitivity)
}

/// What a swing adds to the equations of one more cause's strengths, at a point with that cause.
pub fn part(
    standing: &Standing,
    extended: &Model,
    at: &Point,
    s: usize,
    strengths: &[usize],
) -> Result<Part> {
    let sensitivity = sensitivity(standing, extended, at, s, strengths)?;
    let (jacobian, residual) = (&standing.fitted.jacobians[s], &standing.residuals[s]);
    Ok(Part::of(jacobian, &sensitivity, residual))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One strength of three that are fitted is held at zero. What the others leave of a fourth is
    /// what a projection leaves (QR): with the held one counted as if it could follow, less than
    /// nothing was left, and no look found anything.
    #[test]
    fn what_is_held_makes_up_for_nothing() {
        let jacobian = DMatrix::from_fn(40, 3, |i, k| (0.3 * (i * (k + 1)) as f64).sin());
        let sensitivity = DMatrix::from_fn(40, 1, |i, _| {
            2.0 * jacobian[(i, 1)] + (0.02 * i as f64).exp()
        });
        let mut matrix = jacobian.tr_mul(&jacobian);
        matrix.row_mut(1).fill(0.0);
        matrix.column_mut(1).fill(0.0);
        matrix[(1, 1)] = 1e-2;
        let point = Point {
            x: vec![],
            mounts: vec![],
            causes: vec![],
            owns: vec![],
        };
        let (gradient, jacobians) = (DVector::zeros(3), vec![]);
        let held = vec![1];
        let fitted = Fitted {
            point,
            cost: 0.0,
            chi2: 0.0,
            rows: 40,
            matrix,
            held,
            gradient,
            jacobians,
            last_gained: 0.0,
            log_evidence: None,
            is_fine: true,
        };
        let outer = jacobian.tr_mul(&sensitivity);
        let (inner, score) = (sensitivity.tr_mul(&sensitivity), DVector::zeros(1));
        let beside = Beside::of(
            &fitted,
            &Sums {
                u: DVector::zeros(1),
                outer,
                inner,
                score,
            },
        )
        .unwrap();
        let left = beside.schur[(0, 0)];
        let q = jacobian.remove_column(1).qr().q();
        let expected = (&sensitivity - &q * q.tr_mul(&sensitivity)).norm_squared();
        assert!(
            (left - expected).abs() < 1e-9 * expected,
            "{left} for {expected}"
        );
        assert_eq!(beside.absorbed[(1, 0)], 0.0);
    }
}
