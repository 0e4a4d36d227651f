//! The fit of all swings of a session at once.

use std::cell::{Cell, RefCell};

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix6};

use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_base::parallel::in_parallel;
use gyradius_estimation::{
    Keep, Normal, Options, Parameter, Problem, Progress, Shape, Slopes, UNSTOPPED, minimise,
};
use gyradius_identification::samples::{Own, place};

use super::fitted_swing::HORIZONS_S;
use super::point::{BIAS, DAMPING, HEAVE_DAMPING, Model, OWN, Part, Point};

/// A fit may take new derivatives so often …
const MOST_STEPS: usize = 20;
/// … and so often over each part of the recordings but the first, which are few and quick there,
/// and where the forms of a cause part.
const EARLY_STEPS: usize = 6;
/// So many steps with derivatives that are known count as one with new ones.
const OF_KNOWN: usize = 3;
/// A step that gains less than this share of what the derivatives promised asks for new ones.
const KEPT: f64 = 0.5;
/// A fit ends where a step promises less of χ² than this, a tenth of a standard deviation …
const CONVERGED: f64 = 1e-2;
/// … or than this share of it.
pub const CONVERGED_SHARE: f64 = 1e-7;
/// Of a part of the recordings, this much less exactly.
const NEARLY: f64 = 3e-3;
/// Residual over noise beyond which a model is far from the data.
pub const FAR: f64 = 2.0;
/// Three steps that together gain less than this share of what is left beyond noise lead nowhere
/// that the model cannot follow …
const SLOW: f64 = 3e-4;
/// … and less than this share where many models are tried side by side: the best is led on.
const SLOW_OF_MANY: f64 = 3e-3;
/// Near the data one of many ends where three steps together gain no more of χ² than this: half of
/// it is what the evidence lacks, and those close behind the best are led on with it.
const SETTLED: f64 = 1.0;
/// Weak priors of a phone's place, m, and turn against where the fits of single swings have it,
/// rad.
const PLACE_U_M: f64 = 5.0;
const TURN_U_RAD: f64 = 1.0;

/// A fitted model.
#[derive(Clone)]
pub struct Fitted {
    pub point: Point,
    /// χ² of samples and priors.
    pub cost: f64,
    /// Of the samples alone, and how many rows they have.
    pub chi2: f64,
    pub rows: usize,
    /// Information: half of the second derivative of χ², priors included; of what is held at a
    /// limit that of its prior alone.
    pub matrix: DMatrix<f64>,
    /// Places of those in the list of all that is fitted.
    pub held: Vec<usize>,
    pub gradient: DVector<f64>,
    /// Derivatives of each swing's rows.
    pub jacobians: Vec<DMatrix<f64>>,
    /// What its last step gained of χ² where it ended on the way.
    pub last_gained: f64,
    /// Logarithm of the evidence; none where it cannot be told.
    pub log_evidence: Option<f64>,
    /// Whether the derivatives are all there, over short steps: none taken without a cause or to
    /// one side of it alone.
    pub is_fine: bool,
}

/// Where a fit's derivatives come from.
pub enum Derivatives {
    /// Taken at the start, and anew where they are of no use any more.
    Taken,
    /// Good near the start; taken anew where they are of no use any more.
    Known(Vec<DMatrix<f64>>),
    /// Good where the fit will end: none are taken anew.
    Kept(Vec<DMatrix<f64>>),
}

/// How far a fit has come.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    pub cost: f64,
    /// The larger gain of its last two steps.
    pub gained: f64,
    pub steps: usize,
    pub steps_left: usize,
}

/// Whether a fit that has come so far is hopeless.
pub type Stop<'a> = dyn Fn(Pace) -> bool + Sync + 'a;

/// Where the parts of the list of all that is fitted begin.
pub struct Places {
    pub free: usize,
    mounts: usize,
    pub causes: usize,
    swings: usize,
}

impl Places {
    pub fn of(model: &Model) -> Self {
        let swings = model.base.swings.len();
        let causes = model.causes.iter().map(|c| c.size(swings)).sum();
        Self {
            free: model.base.free.len(),
            mounts: model.base.mounts,
            causes,
            swings,
        }
    }

    pub fn first_cause(&self) -> usize {
        self.free + 6 * self.mounts
    }

    pub fn first_own(&self, s: usize) -> usize {
        self.first_cause() + self.causes + OWN * s
    }

    pub fn all(&self) -> usize {
        self.first_own(self.swings)
    }

    /// Places of the columns of a swing's derivatives.
    pub fn of_swing(&self, model: &Model, s: usize) -> Vec<usize> {
        let mount = self.free + 6 * model.swing(s).mount;
        let causes = self.first_cause()..self.first_cause() + self.causes;
        let own = self.first_own(s)..self.first_own(s) + OWN;
        (0..self.free)
            .chain(mount..mount + 6)
            .chain(causes)
            .chain(own)
            .collect()
    }
}

/// What simulated readings leave of the samples at a point.
#[derive(Clone)]
struct Misfit {
    x: Vec<f64>,
    rows: Vec<DVector<f64>>,
}

impl Misfit {
    fn chi2(&self) -> f64 {
        self.rows.iter().map(DVector::norm_squared).sum()
    }
}

/// The equations of a fit: of the numbers of a point, with places and turns of the phones counted
/// from where it began.
struct Equations<'a> {
    model: &'a Model<'a>,
    from: &'a Point,
    /// By small moves ([`Model::moved`]) from the last point that had new ones.
    slopes: Vec<DMatrix<f64>>,
    /// Where they were taken; nowhere yet.
    taken_at: Option<Vec<f64>>,
    /// How often.
    taken: &'a Cell<usize>,
    is_kept: bool,
    /// Information of the priors.
    prior: Vec<f64>,
    /// Where normal equations were made last, with their diagonal.
    here: Option<(Misfit, DVector<f64>)>,
    /// Where χ² was asked last.
    asked: Option<Misfit>,
}

impl<'a> Equations<'a> {
    fn about(
        model: &'a Model<'a>,
        from: &'a Point,
        derivatives: Derivatives,
        taken: &'a Cell<usize>,
    ) -> Self {
        let is_kept = matches!(derivatives, Derivatives::Kept(_));
        let slopes = match derivatives {
            Derivatives::Taken => vec![],
            Derivatives::Known(known) | Derivatives::Kept(known) => known,
        };
        let prior = model.parameters(from).into_iter();
        let prior = prior.map(|p| p.prior.map_or(0.0, |(_, u)| u.powi(-2)));
        Self {
            model,
            from,
            slopes,
            taken_at: None,
            taken,
            is_kept,
            prior: prior.collect(),
            here: None,
            asked: None,
        }
    }

    fn misfit(&self, x: &[f64]) -> Option<Misfit> {
        let here = self.here.as_ref().map(|(misfit, _)| misfit);
        let known = self.asked.iter().chain(here).find(|known| known.x == x);
        if let Some(known) = known {
            return Some(known.clone());
        }
        let rows = self
            .model
            .all_rows(&self.model.point_at(self.from, x))
            .ok()?;
        Some(Misfit {
            x: x.to_vec(),
            rows,
        })
    }

    fn take(&mut self, x: &[f64]) -> Result<()> {
        self.slopes = self.model.jacobians(&self.model.point_at(self.from, x))?;
        self.taken_at = Some(x.to_vec());
        self.taken.set(self.taken.get() + 1);
        Ok(())
    }

    /// Derivatives changed by as little as makes them true of a step that was made (C. G. Broyden,
    /// *Math. Comp.* 19 (1965) 577), everything that is fitted counted in its own standard
    /// deviation.
    fn learn(&mut self, to: &Misfit) {
        let Some((from, diagonal)) = &self.here else {
            return;
        };
        let places = Places::of(self.model);
        for (s, slopes) in self.slopes.iter_mut().enumerate() {
            let at = places.of_swing(self.model, s);
            let mut step = DVector::from_fn(at.len(), |k, _| to.x[at[k]] - from.x[at[k]]);
            let moves = self.model.mount_moves(self.from, &from.x, s) * step.rows(places.free, 6);
            step.rows_mut(places.free, 6).copy_from(&moves);
            let weighed = DVector::from_fn(at.len(), |k, _| diagonal[at[k]] * step[k]);
            let size = weighed.dot(&step);
            if size > 0.0 {
                let beyond = &from.rows[s] - &to.rows[s] - &*slopes * &step;
                slopes.ger(1.0 / size, &beyond, &weighed, 1.0);
            }
        }
    }
}

impl Problem for Equations<'_> {
    fn shape(&self) -> Shape {
        let places = Places::of(self.model);
        Shape::new(places.first_own(0), &vec![OWN; places.swings])
    }

    fn chi2(&mut self, x: &[f64]) -> Option<f64> {
        let there = self.misfit(x)?;
        let chi2 = there.chi2();
        self.asked = Some(there);
        Some(chi2)
    }

    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal> {
        let there = self.misfit(x)?;
        let begins = self.here.is_none();
        if slopes == Slopes::New && !self.is_kept && (!begins || self.slopes.is_empty()) {
            self.take(x).ok()?;
        } else if let Some((here, _)) = &self.here {
            // Of the step that led here, or of one from here that led astray.
            let ends = || [&there].into_iter().chain(&self.asked);
            let end = ends().find(|to| to.x != here.x).cloned();
            if let Some(to) = end {
                self.learn(&to);
            }
        }
        let normal = self.model.normal((self.from, x), &there.rows, &self.slopes);
        let mut diagonal = normal.diagonal();
        diagonal
            .iter_mut()
            .zip(&self.prior)
            .for_each(|(d, prior)| *d += prior);
        self.here = Some((there, diagonal));
        Some(normal)
    }
}

/// The course of a fit, by which it may end before it has converged.
struct Course {
    steps: usize,
    /// Gains of the last steps, the last one first.
    lately: [f64; 3],
}

impl Model<'_> {
    /// Something for each swing, side by side as far as cores are idle.
    pub fn each<T: Send>(&self, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
        in_parallel(self.base.swings.len(), of)
    }

    /// Fits from a start, until nothing is left to gain or `stop` says that it is hopeless.
    pub fn fit(&self, start: &Point, stop: &Stop) -> Result<Fitted> {
        self.fit_with(start, Derivatives::Taken, CONVERGED_SHARE, stop)
    }

    /// Where fits over longer and longer parts of the recordings lead: a phase known over one stays
    /// within a quarter of a cycle over the next.
    pub fn grown(&self, start: &Point) -> Point {
        HORIZONS_S.iter().fold(start.clone(), |point, horizon_s| {
            self.over_first(*horizon_s, &point, start).0
        })
    }

    /// Where a fit over the first part of the recordings leads, and its χ²; a part that cannot be
    /// simulated from here leads nowhere, the next may. The motion began at a start.
    pub fn over_first(&self, horizon_s: f64, from: &Point, start: &Point) -> (Point, f64) {
        let early = Model {
            part: Part::First(horizon_s),
            ..self.clone()
        };
        let Ok(fitted) = early.fit_with(from, Derivatives::Taken, NEARLY, &|_| false) else {
            return (from.clone(), f64::INFINITY);
        };
        let mut point = fitted.point;
        // A few swings say little of how they die away, and a rate that is wrong runs away over the
        // next part.
        for (own, begun) in point.owns.iter_mut().zip(&start.owns) {
            own[DAMPING..BIAS].copy_from_slice(&begun[DAMPING..BIAS]);
        }
        (point, fitted.cost)
    }

    /// Fits from where that leads; where it leads astray, from the start itself.
    pub fn fit_from_afar(&self, start: &Point) -> Result<Fitted> {
        self.fit(&self.grown(start), &|_| false)
            .or_else(|_| self.fit(start, &|_| false))
    }

    /// The same with derivatives that are known already, until a step promises less than a share of
    /// χ².
    pub fn fit_with(
        &self,
        start: &Point,
        derivatives: Derivatives,
        enough_share: f64,
        stop: &Stop,
    ) -> Result<Fitted> {
        let from = self.bounded(start.clone());
        let taken = Cell::new(0);
        let mut equations = Equations::about(self, &from, derivatives, &taken);
        let budget = OF_KNOWN * self.most_steps();
        let is_apart = self.is_apart();
        let options = Options {
            most_steps: budget,
            gain: CONVERGED,
            gain_share: enough_share,
            // Those that leave a cause out are no better when they are taken anew: those made true
            // of steps are.
            keep: Some(Keep {
                share: if is_apart { f64::NEG_INFINITY } else { KEPT },
                to_the_end: is_apart,
            }),
        };
        let course = RefCell::new(Course {
            steps: 0,
            lately: [f64::INFINITY; 3],
        });
        let ends_here = |progress: Progress| {
            let spent = progress.steps + (OF_KNOWN - 1) * taken.get();
            let steps_left = budget.saturating_sub(spent) / OF_KNOWN;
            let mut course = course.borrow_mut();
            steps_left == 0
                || progress.gained > 0.0
                    && (stop(course.went_on(progress, steps_left))
                        || self.is_slow(progress.cost, &course.lately))
        };
        let parameters = self.with_a_body(&from);
        let found = minimise(
            &mut equations,
            &parameters,
            &self.coordinates(&from),
            &options,
            &ends_here,
        )
        .map_err(|_| out_of_numbers())?;
        let is_fresh = equations.taken_at.as_ref() == Some(&found.x);
        // Others go on from those of the whole recordings.
        let is_lasting = self.part == Part::All && !self.of_many && !is_apart;
        if !is_fresh && is_lasting && !equations.is_kept {
            // At the edge of what can be simulated there are none.
            let _ = equations.take(&found.x);
        }
        let last_gained = if found.ending.is_converged() {
            0.0
        } else {
            course.borrow().lately[0]
        };
        let there = equations.misfit(&found.x).ok_or_else(out_of_numbers)?;
        let point = self.point_at(&from, &found.x);
        self.ended(point, there.rows, equations.slopes, last_gained)
    }

    /// Whether derivatives are taken without one of the causes.
    pub fn is_apart(&self) -> bool {
        self.causes.iter().any(|cause| cause.apart)
    }

    /// Whether a fit that has come so far is not worth going on with.
    fn is_slow(&self, cost: f64, lately: &[f64; 3]) -> bool {
        let rows = self.row_count() as f64;
        let (share, settled) = if self.of_many {
            (SLOW_OF_MANY, SETTLED)
        } else {
            (SLOW, 0.0)
        };
        let is_near = cost <= FAR * FAR * rows;
        let least = share * (cost - rows);
        lately.iter().sum::<f64>() <= if is_near { least.max(settled) } else { least }
    }

    /// A point as it is, with all derivatives there.
    pub fn unmoved(&self, point: &Point) -> Result<Fitted> {
        let (jacobians, rows) = (self.jacobians(point)?, self.all_rows(point)?);
        self.ended(point.clone(), rows, jacobians, 0.0)
    }

    /// What is known at a point.
    fn ended(
        &self,
        point: Point,
        rows: Vec<DVector<f64>>,
        jacobians: Vec<DMatrix<f64>>,
        last_gained: f64,
    ) -> Result<Fitted> {
        let taken = Cell::new(0);
        let x = self.coordinates(&point);
        let mut equations = Equations::about(self, &point, Derivatives::Kept(jacobians), &taken);
        equations.asked = Some(Misfit { x: x.clone(), rows });
        let options = Options {
            most_steps: 0,
            ..Options::default()
        };
        let parameters = self.parameters(&point);
        let found = minimise(&mut equations, &parameters, &x, &options, UNSTOPPED)
            .map_err(|_| out_of_numbers())?;
        let pressed = found.edges.iter().filter(|edge| edge.is_pressed);
        let held: Vec<usize> = pressed.map(|edge| edge.place).collect();
        let mut gradient = -found.normal.whole_gradient();
        held.iter().for_each(|place| gradient[*place] = 0.0);
        Ok(Fitted {
            cost: found.cost(),
            chi2: found.chi2,
            rows: self.row_count(),
            matrix: found.information(),
            held,
            gradient,
            jacobians: equations.slopes,
            last_gained,
            log_evidence: found.log_evidence().ok(),
            is_fine: self.fine && !self.is_apart(),
            point,
        })
    }

    fn most_steps(&self) -> usize {
        match self.part {
            Part::First(horizon_s) if horizon_s > HORIZONS_S[0] && !self.causes.is_empty() => {
                EARLY_STEPS
            }
            _ => MOST_STEPS,
        }
    }

    fn jacobians(&self, point: &Point) -> Result<Vec<DMatrix<f64>>> {
        self.each(|s| self.jacobian(point, s)).into_iter().collect()
    }

    fn row_count(&self) -> usize {
        (0..self.base.swings.len())
            .map(|s| 3 * self.blocks(s).len())
            .sum()
    }

    fn all_rows(&self, point: &Point) -> Result<Vec<DVector<f64>>> {
        let rows = self.each(|s| self.rows(point, s).map(DVector::from_vec));
        rows.into_iter().collect()
    }

    /// χ² of samples and priors at a point.
    pub fn cost(&self, point: &Point) -> Result<f64> {
        let priors = self.priors(point);
        let of_priors: f64 = priors.iter().map(|(away, u)| (away / u).powi(2)).sum();
        Ok(self.chi2(point)? + of_priors)
    }

    /// χ² of the samples at a point.
    pub fn chi2(&self, point: &Point) -> Result<f64> {
        let chi2 = self
            .all_rows(point)?
            .iter()
            .map(DVector::norm_squared)
            .sum();
        if f64::is_finite(chi2) {
            Ok(chi2)
        } else {
            Err(out_of_numbers())
        }
    }

    /// Distances from the priors' means and their standard deviations, by place.
    pub fn priors(&self, point: &Point) -> Vec<(f64, f64)> {
        let all = self.parameters(point).into_iter();
        let prior = |p: Parameter| p.prior.unwrap_or((0.0, f64::INFINITY));
        all.zip(self.coordinates(point))
            .map(|(p, x)| (x - prior(p).0, prior(p).1))
            .collect()
    }

    /// Priors and limits of everything that is fitted, places and turns of the phones counted from
    /// a point.
    fn parameters(&self, from: &Point) -> Vec<Parameter> {
        let layout = self.base.layout();
        let of_session = self.base.free.iter().map(|i| {
            let prior = layout.parameters[*i].prior;
            Parameter::FREE.with_prior(prior.value, prior.u)
        });
        let of_mounts = from.mounts.iter().flat_map(|mount| {
            let place = |k: usize| Parameter::FREE.with_prior(-mount.place[k], PLACE_U_M);
            let turn = Parameter::FREE.with_prior(0.0, TURN_U_RAD);
            [place(0), place(1), place(2), turn, turn, turn]
        });
        let swings = self.base.swings.len();
        let of_causes = self.causes.iter().flat_map(|cause| {
            let limits = cause.limits(swings).into_iter();
            let with_limits = cause.expanded(swings).into_iter().zip(limits);
            let known = with_limits.map(|((p, _), (low, high))| {
                Parameter::FREE
                    .with_prior(p.prior.0, p.prior.1)
                    .within(low, high)
            });
            known.collect::<Vec<_>>()
        });
        let u = Own::prior_u();
        let of_own = |k: usize| {
            let place = match k {
                HEAVE_DAMPING => DAMPING,
                _ if k < BIAS => k,
                _ => place::BIAS.start + k - BIAS,
            };
            let known = Parameter::FREE.with_prior(0.0, u[place]);
            // What hangs makes no motion of itself: no rate of damping is below zero. What nobody
            // set going had a rate of any sign, and where it was below zero a fit stopped.
            if (DAMPING..BIAS).contains(&k) {
                known.within(0.0, f64::INFINITY)
            } else {
                known
            }
        };
        let owns = (0..swings).flat_map(|_| (0..OWN).map(of_own));
        of_session
            .chain(of_mounts)
            .chain(of_causes)
            .chain(owns)
            .collect()
    }

    /// The same with the limits of a body, which guard the way: what is known at its end is known
    /// as without them.
    fn with_a_body(&self, from: &Point) -> Vec<Parameter> {
        let mut parameters = self.parameters(from);
        for (i, (low, high)) in self.base.body_limits(&from.x) {
            let place = self.base.free.iter().position(|free| *free == i);
            if let Some(k) = place {
                parameters[k] = parameters[k].within(low, high);
            }
        }
        parameters
    }

    /// The numbers of a point, places and turns of the phones counted from there.
    fn coordinates(&self, point: &Point) -> Vec<f64> {
        let of_session = self.base.free.iter().map(|i| point.x[*i]);
        let of_mounts = std::iter::repeat_n(0.0, 6 * point.mounts.len());
        of_session
            .chain(of_mounts)
            .chain(point.causes.iter().flatten().copied())
            .chain(point.owns.iter().flatten().copied())
            .collect()
    }

    /// The point with such numbers, places and turns of the phones counted from another.
    fn point_at(&self, from: &Point, x: &[f64]) -> Point {
        let mut there = from.clone();
        let mut next = x.iter().copied();
        let mut take = || next.next().unwrap_or(0.0);
        self.base.free.iter().for_each(|i| there.x[*i] = take());
        for mount in &mut there.mounts {
            let mut three = || Vec3::new(take(), take(), take());
            *mount = mount.moved(three(), three());
        }
        there.causes.iter_mut().flatten().for_each(|v| *v = take());
        there.owns.iter_mut().flatten().for_each(|v| *v = take());
        there
    }

    /// A point with a change of everything that is fitted added.
    pub fn moved(&self, point: &Point, delta: &DVector<f64>) -> Point {
        let from = self.coordinates(point).into_iter();
        let there: Vec<f64> = from.zip(delta).map(|(x, change)| x + change).collect();
        self.point_at(point, &there)
    }

    /// With a body that there can be, and nothing beyond its limits.
    pub fn bounded(&self, point: Point) -> Point {
        let all = self.coordinates(&point).into_iter();
        let inside = all.zip(self.with_a_body(&point));
        let inside: Vec<f64> = inside.map(|(x, p)| x.clamp(p.low, p.high)).collect();
        self.point_at(&point, &inside)
    }

    /// Small moves of a swing's phone by changes of its six numbers in a fit, to first order.
    fn mount_moves(&self, from: &Point, x: &[f64], s: usize) -> Matrix6<f64> {
        let mount = self.swing(s).mount;
        let first = self.base.free.len() + 6 * mount;
        let three = |k: usize| Vec3::new(x[first + k], x[first + k + 1], x[first + k + 2]);
        from.mounts[mount].moves(three(0), three(3))
    }

    /// Normal equations of the samples.
    fn normal(
        &self,
        (from, x): (&Point, &[f64]),
        rows: &[DVector<f64>],
        slopes: &[DMatrix<f64>],
    ) -> Normal {
        let places = Places::of(self);
        let shared = places.first_own(0);
        let parts = self.each(|s| {
            let mut j = slopes[s].clone();
            let by_phone = j.columns(places.free, 6) * self.mount_moves(from, x, s);
            j.columns_mut(places.free, 6).copy_from(&by_phone);
            // Not `tr_mul`, which multiplies matrices element by element.
            (j.transpose() * &j, j.tr_mul(&rows[s]))
        });
        let mut normal = Normal::zero(&Shape::new(shared, &vec![OWN; places.swings]));
        for (s, (square, pull)) in parts.into_iter().enumerate() {
            let own = places.first_own(s) - shared;
            let at = places.of_swing(self, s).into_iter();
            let at: Vec<usize> = at.map(|k| if k < shared { k } else { k - own }).collect();
            let mut information = DMatrix::zeros(shared + OWN, shared + OWN);
            let mut gradient = DVector::zeros(shared + OWN);
            for (k, place) in at.iter().enumerate() {
                // Derivatives are of readings, which what is left has with the other sign.
                gradient[*place] = -pull[k];
                at.iter()
                    .enumerate()
                    .for_each(|(l, other)| information[(*place, *other)] = square[(k, l)]);
            }
            normal.add(s, &information, &gradient);
        }
        normal
    }
}

impl Course {
    /// One step on.
    fn went_on(&mut self, progress: Progress, steps_left: usize) -> Pace {
        let pace = Pace {
            cost: progress.cost,
            gained: progress
                .gained
                .max(if self.steps > 0 { self.lately[0] } else { 0.0 }),
            steps: self.steps,
            steps_left,
        };
        self.steps += 1;
        self.lately = [progress.gained, self.lately[0], self.lately[1]];
        pace
    }
}

fn out_of_numbers() -> Error {
    Error::no_result("fit of the motion", "it runs out of the numbers")
}

impl Fitted {
    /// Where the so many values of the last causes begin in the list of all that is fitted.
    pub fn place_of_last(&self, count: usize) -> usize {
        self.matrix.nrows() - OWN * self.point.owns.len() - count
    }

    /// The point, and what is known there.
    pub fn at(&self) -> (&Point, &DMatrix<f64>) {
        (&self.point, &self.matrix)
    }

    /// Residual over noise, blocks of samples.
    pub fn rms(&self) -> f64 {
        (self.chi2 / self.rows.max(1) as f64).sqrt()
    }

    pub fn cholesky(&self) -> Option<Cholesky<f64, Dyn>> {
        self.matrix.clone().cholesky()
    }

    /// Covariance of everything that is fitted, for noise that is white.
    pub fn covariance(&self) -> Option<DMatrix<f64>> {
        Some(self.cholesky()?.inverse())
    }
}
