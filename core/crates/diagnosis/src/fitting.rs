//! Levenberg and Marquardt over all swings of a session at once.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_base::parallel::in_parallel;
use gyradius_identification::samples::Own;

use super::fitted_swing::HORIZONS_S;
use super::point::{BIAS, DAMPING, Model, OWN, Part, Point};

const MOST_STEPS: usize = 20;
/// So many steps with derivatives that are known count as one with new ones.
const OF_KNOWN: usize = 3;
/// The most by which a step is held back, shares of the information of each that is fitted …
const MOST_DAMPING: f64 = 1e8;
/// … and the least that it comes down to.
const LEAST_DAMPING: f64 = 1e-9;
/// … and what it begins with where a step without any leads nowhere.
const FIRST_DAMPING: f64 = 1e-4;
/// Shares of the way to where derivatives point that are tried without damping.
const SHARES: [f64; 3] = [1.0, 0.4, 0.15];
/// A step that leads uphill is corrected so often at most.
const CORRECTIONS: usize = 3;
/// A step that gains less than this share of what the derivatives promised, or more than its
/// reciprocal, asks for new ones.
const KEPT: f64 = 0.8;
/// … near the data (`FAR`) than this share: there they hold a long way, and learn from each step.
const KEPT_NEAR: f64 = 0.4;
/// A fit ends where an undamped step promises less of χ² than this, a tenth of a standard
/// deviation, or than this share of it; or where a step with new derivatives gains no more than
/// twice that.
const CONVERGED: f64 = 1e-2;
pub const CONVERGED_SHARE: f64 = 1e-7;
/// Of a part of the recordings, this much less exactly.
const NEARLY: f64 = 3e-3;
/// Steps over each of them but the first, which are few and quick there, and where the forms of a
/// cause part.
const EARLY_STEPS: usize = 6;
/// A step that gains less than this share of what was promised is of no use.
const OF_NO_USE: f64 = 0.1;
/// Derivatives are good to about one of χ²: less than that, promised by new ones and not kept, is
/// not there.
const UNKEPT: f64 = 1.0;
/// Derivatives taken within so much of χ² are as good as new ones.
const NEAR: f64 = 0.1;
/// Residual over noise beyond which a model is far from the data …
pub const FAR: f64 = 2.0;
/// … and is not worth more than so many steps of no use one after another.
const PATIENCE: usize = 3;
/// Two steps that each gain less than this share of what is left beyond noise lead nowhere that the
/// model cannot follow …
const SLOW: f64 = 1e-4;
/// … and less than this share where many models are tried side by side: the best is led on.
const SLOW_OF_MANY: f64 = 1e-3;
/// Near the data one of many ends where three steps together gain no more of χ² than this: half of
/// it is what the evidence lacks, and those close behind the best are led on with it.
const SETTLED: f64 = 1.0;
/// Damping rates, 1/s: what hangs makes no motion of itself. What nobody set going had a rate of
/// any sign, and where it was below zero a fit stopped: a step that is short by all derivatives
/// made it grow by e to the power of 12 over a recording.
const PASSIVE: (f64, f64) = (0.0, f64::INFINITY);
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
    /// What its last step gained of χ²: much, where the steps were used up on the way.
    pub last_gained: f64,
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

/// Information with so much more of each's own.
fn damped(matrix: &DMatrix<f64>, by: f64) -> DMatrix<f64> {
    let mut damped = matrix.clone();
    (0..damped.nrows()).for_each(|k| damped[(k, k)] *= 1.0 + by);
    damped
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

/// χ² at a point, and the rows that it is made of.
struct Misfit {
    rows: Vec<DVector<f64>>,
    cost: f64,
}

impl Misfit {
    fn chi2(&self) -> f64 {
        self.rows.iter().map(DVector::norm_squared).sum()
    }

    fn count(&self) -> usize {
        self.rows.iter().map(|rows| rows.len()).sum()
    }

    /// What a swing's readings did beyond their derivatives along a step from here to another
    /// misfit.
    fn beyond(
        &self,
        to: &Self,
        s: usize,
        jacobian: &DMatrix<f64>,
        own: &DVector<f64>,
    ) -> DVector<f64> {
        &self.rows[s] - &to.rows[s] - jacobian * own
    }

    fn rms(&self) -> f64 {
        (self.chi2() / self.count().max(1) as f64).sqrt()
    }
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
        let mut point = self.bounded(start.clone());
        let mut misfit = self.misfit(&point)?;
        let is_kept = matches!(derivatives, Derivatives::Kept(_));
        let mut fresh = matches!(derivatives, Derivatives::Taken);
        // Of χ², since derivatives were taken.
        let mut gained_since = if fresh { 0.0 } else { f64::INFINITY };
        let mut jacobians = match derivatives {
            Derivatives::Taken => self.jacobians(&point)?,
            Derivatives::Known(known) | Derivatives::Kept(known) => known,
        };
        let mut damping = LEAST_DAMPING;
        let mut of_no_use = 0;
        let slow_share = if self.of_many { SLOW_OF_MANY } else { SLOW };
        let mut was_slow = false;
        let exact = !self.is_apart();
        // Of the last step, and of the last three.
        let (mut last_gained, mut lately) = (0.0, [f64::INFINITY; 3]);
        // Of its steps, in those with known derivatives.
        let mut left = self.most_steps() * OF_KNOWN;
        for n in 0.. {
            left = left.saturating_sub(if fresh { OF_KNOWN } else { 1 });
            let (mut matrix, mut gradient) = self.normal(&point, &misfit, &jacobians);
            self.pin(&point, &mut matrix, &mut gradient);
            let equations = (&matrix, &gradient, &jacobians[..]);
            let Some(step) = self.step(&point, &misfit, equations, &mut damping) else {
                let is_known_here = gained_since < NEAR || is_kept;
                let renewed = if is_known_here {
                    None
                } else {
                    self.jacobians(&point).ok()
                };
                let Some(renewed) = renewed else { break };
                (jacobians, fresh, gained_since) = (renewed, true, 0.0);
                continue;
            };
            let gained = misfit.cost - step.misfit.cost;
            let pace = Pace {
                cost: step.misfit.cost,
                gained: gained.max(last_gained),
                steps: n,
                steps_left: left / OF_KNOWN,
            };
            last_gained = gained;
            lately = [gained, lately[0], lately[1]];
            gained_since += gained;
            let before = std::mem::replace(&mut misfit, step.misfit);
            point = step.point;
            let is_slow = gained < slow_share * (misfit.cost - misfit.count() as f64);
            // While the damping comes down, steps grow by themselves.
            let is_slow_twice = is_slow && was_slow && (step.strained || damping <= LEAST_DAMPING);
            // Derivatives of elsewhere may be what holds a fit back.
            let crawls = is_slow_twice && (fresh || is_kept || !exact);
            was_slow = is_slow;
            of_no_use = if gained < OF_NO_USE * step.promised {
                of_no_use + 1
            } else {
                0
            };
            let is_near = misfit.rms() <= FAR;
            let creeps = of_no_use >= PATIENCE && !is_near;
            let is_settled = self.of_many && is_near && lately.iter().sum::<f64>() <= SETTLED;
            let unkept = gained < OF_NO_USE * step.hoped && step.hoped < UNKEPT;
            let enough = step.promised < CONVERGED.max(enough_share * misfit.cost);
            let arrived = enough || unkept || (!step.strained && gained < 2.0 * CONVERGED);
            let is_known_there = gained_since < NEAR || is_kept || !exact;
            if (is_known_there && arrived)
                || creeps
                || crawls
                || is_settled
                || left == 0
                || stop(pace)
            {
                break;
            }
            let share = if is_near { KEPT_NEAR } else { KEPT };
            let as_promised = (share..share.recip()).contains(&(gained / step.promised));
            // Derivatives that leave a cause out are no better when they are taken anew: those made
            // true of steps are.
            fresh = if exact {
                enough || is_slow_twice || !as_promised
            } else {
                step.strained && !fresh
            };
            fresh = fresh && !is_kept;
            if fresh {
                // At the edge of what can be simulated there are none: the fit ends there.
                let Ok(renewed) = self.jacobians(&point) else {
                    break;
                };
                (jacobians, gained_since) = (renewed, 0.0);
            } else if !exact || is_kept || (is_near && gained_since >= NEAR) {
                self.learn_from_step(&mut jacobians, (&before, &misfit), &step.delta, &matrix);
            }
        }
        Ok(self.ended(point, &misfit, jacobians, last_gained))
    }

    /// Whether derivatives are taken without one of the causes.
    pub fn is_apart(&self) -> bool {
        self.causes.iter().any(|cause| cause.apart)
    }

    /// Derivatives changed by as little as makes them true of a step that was made (C. G. Broyden,
    /// *Math. Comp.* 19 (1965) 577), everything that is fitted counted in its own standard
    /// deviation.
    fn learn_from_step(
        &self,
        jacobians: &mut [DMatrix<f64>],
        (from, to): (&Misfit, &Misfit),
        delta: &DVector<f64>,
        matrix: &DMatrix<f64>,
    ) {
        let places = Places::of(self);
        for (s, jacobian) in jacobians.iter_mut().enumerate() {
            let at = places.of_swing(self, s);
            let own = delta.select_rows(&at);
            let weighed = matrix.diagonal().select_rows(&at).component_mul(&own);
            let size = weighed.dot(&own);
            if size > 0.0 {
                let beyond = from.beyond(to, s, jacobian, &own);
                jacobian.ger(1.0 / size, &beyond, &weighed, 1.0);
            }
        }
    }

    /// A point as it is, with all derivatives there.
    pub fn unmoved(&self, point: &Point) -> Result<Fitted> {
        let (jacobians, misfit) = (self.jacobians(point)?, self.misfit(point)?);
        Ok(self.ended(point.clone(), &misfit, jacobians, 0.0))
    }

    fn ended(
        &self,
        point: Point,
        misfit: &Misfit,
        jacobians: Vec<DMatrix<f64>>,
        last_gained: f64,
    ) -> Fitted {
        let (mut matrix, mut gradient) = self.normal(&point, misfit, &jacobians);
        let held = self.pin(&point, &mut matrix, &mut gradient);
        let (cost, chi2, rows) = (misfit.cost, misfit.chi2(), misfit.count());
        let is_fine = self.fine && !self.is_apart();
        Fitted {
            point,
            cost,
            chi2,
            rows,
            matrix,
            held,
            gradient,
            jacobians,
            last_gained,
            is_fine,
        }
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

    fn misfit(&self, point: &Point) -> Result<Misfit> {
        let rows = self.each(|s| self.rows(point, s).map(DVector::from_vec));
        let rows = rows.into_iter().collect::<Result<Vec<_>>>()?;
        let cost = rows.iter().map(DVector::norm_squared).sum::<f64>() + self.prior_cost(point);
        if cost.is_finite() {
            Ok(Misfit { rows, cost })
        } else {
            Err(Error::no_result(
                "fit of the motion",
                "it runs out of the numbers",
            ))
        }
    }

    /// χ² of samples and priors at a point.
    pub fn cost(&self, point: &Point) -> Result<f64> {
        Ok(self.misfit(point)?.cost)
    }

    /// χ² of the samples at a point.
    pub fn chi2(&self, point: &Point) -> Result<f64> {
        Ok(self.misfit(point)?.chi2())
    }

    /// Distances from the priors' means and their standard deviations, by place; none where a prior
    /// says nothing here.
    pub fn priors(&self, point: &Point) -> Vec<(f64, f64)> {
        let layout = self.base.layout();
        let prior = |i: &usize| layout.parameters[*i].prior;
        let of_session = self
            .base
            .free
            .iter()
            .map(|i| (point.x[*i] - prior(i).value, prior(i).u));
        let of_mounts = point.mounts.iter().flat_map(|m| {
            let places = [0, 1, 2].map(|k| (m.place[k], PLACE_U_M));
            places.into_iter().chain([(0.0, TURN_U_RAD); 3])
        });
        let swings = self.base.swings.len();
        let of_causes = self
            .causes
            .iter()
            .zip(&point.causes)
            .flat_map(|(cause, values)| {
                let expanded = cause.expanded(swings).into_iter().zip(values);
                expanded
                    .map(|((p, _), v)| (v - p.prior.0, p.prior.1))
                    .collect::<Vec<_>>()
            });
        let u = Own::prior_u();
        let of_own = |k: usize| if k < BIAS { u[k] } else { u[k + 6] };
        let owns = point
            .owns
            .iter()
            .flat_map(|own| own.iter().enumerate().map(|(k, v)| (*v, of_own(k))));
        of_session
            .chain(of_mounts)
            .chain(of_causes)
            .chain(owns)
            .collect()
    }

    fn prior_cost(&self, point: &Point) -> f64 {
        self.priors(point)
            .iter()
            .map(|(away, u)| (away / u).powi(2))
            .sum()
    }

    fn normal(
        &self,
        point: &Point,
        misfit: &Misfit,
        jacobians: &[DMatrix<f64>],
    ) -> (DMatrix<f64>, DVector<f64>) {
        let places = Places::of(self);
        let size = places.all();
        let (mut matrix, mut gradient) = (DMatrix::zeros(size, size), DVector::zeros(size));
        let parts = self.each(|s| {
            let j = &jacobians[s];
            // Not `tr_mul`, which multiplies matrices element by element.
            (j.transpose() * j, j.tr_mul(&misfit.rows[s]))
        });
        for (s, (own_matrix, own_gradient)) in parts.iter().enumerate() {
            let at = places.of_swing(self, s);
            for (k, place) in at.iter().enumerate() {
                gradient[*place] += own_gradient[k];
                at.iter()
                    .enumerate()
                    .for_each(|(l, other)| matrix[(*place, *other)] += own_matrix[(k, l)]);
            }
        }
        for (k, (away, u)) in self.priors(point).iter().enumerate() {
            matrix[(k, k)] += u.powi(-2);
            gradient[k] -= away / (u * u);
        }
        (matrix, gradient)
    }

    /// A step downhill: the whole way to where the derivatives point or a share of it, or, where
    /// none of these leads down, one held back by damping. What is known least is held back first,
    /// and a fit that is damped creeps along valleys in which, say, gyradius and spacing grow
    /// alike.
    fn step(
        &self,
        point: &Point,
        misfit: &Misfit,
        equations: (&DMatrix<f64>, &DVector<f64>, &[DMatrix<f64>]),
        damping: &mut f64,
    ) -> Option<Step> {
        let (matrix, gradient, jacobians) = equations;
        let begun = *damping;
        let mut hoped = None;
        while *damping < MOST_DAMPING {
            let whole = within_limits(
                self.limited(point),
                damped(matrix, *damping),
                gradient.clone(),
            )?;
            let stiff = damped(matrix, damping.max(FIRST_DAMPING)).cholesky()?;
            let promised =
                |delta: &DVector<f64>| 2.0 * gradient.dot(delta) - delta.dot(&(matrix * delta));
            let all_promised = promised(&whole);
            let hoped = *hoped.get_or_insert(all_promised);
            let shares = if *damping > LEAST_DAMPING {
                &SHARES[..1]
            } else {
                &SHARES
            };
            let found = shares.iter().find_map(|share| {
                let delta = &whole * *share;
                let promised = promised(&delta);
                Some((
                    promised,
                    self.downhill((point, misfit), jacobians, &stiff, delta)?,
                ))
            });
            if let Some((promised, (point, better, delta))) = found {
                let strained = *damping > begun;
                *damping = (*damping * 0.1).max(LEAST_DAMPING);
                return Some(Step {
                    point,
                    misfit: better,
                    delta,
                    promised,
                    hoped,
                    strained,
                });
            }
            *damping = (*damping * 10.0).max(FIRST_DAMPING);
            if all_promised < CONVERGED {
                break;
            }
        }
        *damping = FIRST_DAMPING;
        None
    }

    /// Where a step leads, if not uphill. Where it does, the readings bend along it: what they do
    /// beyond their derivatives is made up for (a second-order correction; J. Nocedal, S. J.
    /// Wright, *Numerical Optimization*, 2nd ed., sec. 18.3) by what is known well, and again while
    /// that brings it lower.
    fn downhill(
        &self,
        (point, misfit): (&Point, &Misfit),
        jacobians: &[DMatrix<f64>],
        stiff: &Cholesky<f64, Dyn>,
        straight: DVector<f64>,
    ) -> Option<(Point, Misfit, DVector<f64>)> {
        let at = |delta: DVector<f64>| {
            let there = self.bounded(self.moved(point, &delta));
            self.misfit(&there)
                .ok()
                .map(|misfit| (there, misfit, delta))
        };
        let mut tried = at(straight.clone())?;
        for _ in 0..CORRECTIONS {
            if tried.1.cost <= misfit.cost {
                break;
            }
            let bent = self.bend(misfit, &tried.1, jacobians, &tried.2);
            let corrected = at(&straight - stiff.solve(&bent))?;
            if corrected.1.cost >= tried.1.cost {
                return None;
            }
            tried = corrected;
        }
        (tried.1.cost <= misfit.cost).then_some(tried)
    }

    /// What the readings did beyond their derivatives along a step from one misfit to another,
    /// times these.
    fn bend(
        &self,
        from: &Misfit,
        to: &Misfit,
        jacobians: &[DMatrix<f64>],
        delta: &DVector<f64>,
    ) -> DVector<f64> {
        let places = Places::of(self);
        let mut all = DVector::zeros(places.all());
        let parts = self.each(|s| {
            let at = places.of_swing(self, s);
            let beyond = from.beyond(to, s, &jacobians[s], &delta.select_rows(&at));
            (at, jacobians[s].tr_mul(&beyond))
        });
        for (at, part) in parts {
            at.iter()
                .zip(part.iter())
                .for_each(|(place, x)| all[*place] += x);
        }
        all
    }

    /// What stands at a limit and would go beyond is held there (a strength at zero): its places.
    fn pin(
        &self,
        point: &Point,
        matrix: &mut DMatrix<f64>,
        gradient: &mut DVector<f64>,
    ) -> Vec<usize> {
        let mut held = Vec::new();
        for Limited {
            place,
            value,
            limits: (low, high),
            u,
        } in self.limited(point)
        {
            let goes_out = (value <= low && gradient[place] <= 0.0)
                || (value >= high && gradient[place] >= 0.0);
            if goes_out {
                // Its width is that of its prior, so that it neither gains nor costs evidence.
                set_apart(matrix, place, u.powi(-2));
                gradient[place] = 0.0;
                held.push(place);
            }
        }
        held
    }

    /// What has limits: values of causes (strengths that cannot be below zero among them), and
    /// damping rates.
    fn limited(&self, point: &Point) -> Vec<Limited> {
        let (swings, places) = (self.base.swings.len(), Places::of(self));
        let values = self
            .causes
            .iter()
            .zip(&point.causes)
            .flat_map(|(cause, values)| {
                let parameters = cause
                    .expanded(swings)
                    .into_iter()
                    .zip(cause.limits(swings))
                    .zip(values);
                parameters
                    .map(|(((p, _), limits), value)| (*value, limits, p.prior.1))
                    .collect::<Vec<_>>()
            });
        let of_causes = values
            .enumerate()
            .map(|(k, (value, limits, u))| (places.first_cause() + k, value, limits, u));
        let u = Own::prior_u();
        let rates = |(s, own): (usize, &[f64; OWN])| {
            let (first, own) = (places.first_own(s), *own);
            (DAMPING..BIAS).map(move |k| (first + k, own[k], PASSIVE, u[k]))
        };
        let all = of_causes.chain(point.owns.iter().enumerate().flat_map(rates));
        all.map(|(place, value, limits, u)| Limited {
            place,
            value,
            limits,
            u,
        })
        .collect()
    }

    /// With a body that there can be, and nothing beyond its limits.
    pub fn bounded(&self, mut point: Point) -> Point {
        self.base.keep_a_body(&mut point.x);
        let swings = self.base.swings.len();
        for (cause, values) in self.causes.iter().zip(&mut point.causes) {
            let limits = cause.limits(swings).into_iter();
            values
                .iter_mut()
                .zip(limits)
                .for_each(|(v, (low, high))| *v = v.clamp(low, high));
        }
        let rates = point
            .owns
            .iter_mut()
            .flat_map(|own| &mut own[DAMPING..BIAS]);
        rates.for_each(|rate| *rate = rate.clamp(PASSIVE.0, PASSIVE.1));
        point
    }

    /// A point with a change of everything that is fitted added.
    pub fn moved(&self, point: &Point, delta: &DVector<f64>) -> Point {
        let mut there = point.clone();
        let mut next = delta.iter().copied();
        let mut take = || next.next().unwrap_or(0.0);
        self.base.free.iter().for_each(|i| there.x[*i] += take());
        for mount in &mut there.mounts {
            let mut three = || Vec3::new(take(), take(), take());
            *mount = mount.moved(three(), three());
        }
        there.causes.iter_mut().flatten().for_each(|v| *v += take());
        there.owns.iter_mut().flatten().for_each(|v| *v += take());
        there
    }
}

/// What has limits: its place in the list of all that is fitted, its value, and the width of its
/// prior.
struct Limited {
    place: usize,
    value: f64,
    limits: (f64, f64),
    u: f64,
}

/// Makes what is at a place hang together with nothing.
fn set_apart(matrix: &mut DMatrix<f64>, place: usize, information: f64) {
    matrix.row_mut(place).fill(0.0);
    matrix.column_mut(place).fill(0.0);
    matrix[(place, place)] = information;
}

/// The change that takes a gradient away; what would go beyond a limit goes as far as that, and all
/// else makes the best of it.
fn within_limits(
    mut open: Vec<Limited>,
    mut matrix: DMatrix<f64>,
    mut gradient: DVector<f64>,
) -> Option<DVector<f64>> {
    loop {
        let change = matrix.clone().cholesky()?.solve(&gradient);
        let there = |limited: &Limited| limited.value + change[limited.place];
        let goes_beyond = |l: &Limited| there(l) < l.limits.0 || there(l) > l.limits.1;
        let (beyond, within) = open.into_iter().partition::<Vec<_>, _>(goes_beyond);
        if beyond.is_empty() {
            return Some(change);
        }
        for limited in &beyond {
            let as_far = there(limited).clamp(limited.limits.0, limited.limits.1) - limited.value;
            gradient.axpy(-as_far, &matrix.column(limited.place), 1.0);
            set_apart(&mut matrix, limited.place, 1.0);
            gradient[limited.place] = as_far;
        }
        open = within;
    }
}

struct Step {
    point: Point,
    misfit: Misfit,
    delta: DVector<f64>,
    promised: f64,
    /// What the longest that was tried promised.
    hoped: f64,
    /// Whether a longer one led nowhere.
    strained: bool,
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

    /// Half of the logarithm of the determinant of the information.
    pub fn half_log_determinant(&self) -> Option<f64> {
        let l = self.cholesky()?;
        Some(l.l_dirty().diagonal().iter().map(|d| d.ln()).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_go_beyond_a_limit_stops_there_and_all_else_makes_the_best_of_it() {
        let a = DMatrix::from_row_slice(
            4,
            3,
            &[1.0, 0.9, 0.2, 0.3, 1.0, 0.8, 0.5, 0.4, 1.0, 0.2, 0.1, 0.7],
        );
        let b = DVector::from_row_slice(&[-1.0, 2.0, 0.5, -0.3]);
        let (matrix, gradient) = (a.tr_mul(&a), a.tr_mul(&b));
        let change = |limits: [(f64, f64); 2]| {
            let limited = |k: usize| Limited {
                place: 2 * k,
                value: 1.0,
                limits: limits[k],
                u: 1.0,
            };
            within_limits(
                vec![limited(0), limited(1)],
                matrix.clone(),
                gradient.clone(),
            )
            .unwrap()
        };
        let close = |found: DVector<f64>, expected: [f64; 3]| {
            assert!((found - DVector::from_row_slice(&expected)).amax() < 1e-8);
        };
        // scipy.optimize.lsq_linear(a, b, bounds, method="bvls", tol=1e-14).
        let free = (f64::NEG_INFINITY, f64::INFINITY);
        close(
            change([free, free]),
            [-3.188286314, 2.341246561, 0.8011712927],
        );
        close(
            change([(0.0, f64::INFINITY), free]),
            [-1.0, 0.8298619024, 0.7219816781],
        );
        close(change([(0.0, 2.0), (0.0, 0.6)]), [-1.0, 1.651515152, -0.4]);
    }
}
