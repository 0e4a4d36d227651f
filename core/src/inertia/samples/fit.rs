//! The fit of one swing: Levenberg and Marquardt over growing horizons, from rest.

use std::f64::consts::FRAC_PI_4;

use nalgebra::{DMatrix, DVector};

use super::linearise::{Linearised, Simulated};
use super::record::{Samples, Stream};
use super::scene::{OWN, Own, SwingSetup};
use crate::dynamics::small_modes;
use crate::error::{Error, Result};
use crate::frames::{Mat3, Rotation, Vec3};
use crate::inertia::parameters::Role;
use crate::inertia::theory::{swing_body, swing_rig};

/// Horizons in periods of the slowest mode. A phase known over one horizon stays within a quarter of a cycle over the
/// next; the session's parameters move from the second on.
const HORIZONS: [f64; 5] = [1.5, 3.0, 7.0, 16.0, 40.0];
const MOST_STEPS: usize = 25;
const MOST_DAMPING: f64 = 1e6;
/// A step that gains less than this share of what the derivatives promised asks for new ones.
const KEPT: f64 = 0.5;
/// A step of an early horizon that promises less than this share of χ² ends it.
const ENOUGH: f64 = 1e-2;
/// Over the whole record a step that promises less of χ² ends the fit: a hundredth of a standard deviation, squared.
const CONVERGED: f64 = 1e-4;
/// Information below this share of a prior's own is left out of the joint estimate's rows.
const LEAST_INFORMATION: f64 = 0.1;
/// A hull pitched by more tells bow from stern, degrees.
const TELLING_PITCH_DEG: f64 = 3.0;

/// One swing and its samples.
pub struct SwingModel<'a> {
    pub setup: SwingSetup<'a>,
    pub samples: Samples,
}

/// A fitted swing.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The session's parameters as this swing has them, priors included.
    pub x: Vec<f64>,
    pub own: Own,
    /// The session's free parameters.
    pub free: Vec<usize>,
    /// Of the normal equations without priors: session's free parameters first, then the swing's own.
    pub matrix: DMatrix<f64>,
    pub gradient: DVector<f64>,
    /// χ² of samples and priors.
    cost: f64,
    /// Residual over noise, sample by sample.
    pub rms_over_noise: f64,
    /// Factor on the variance of everything: what is left is not white.
    pub inflation: f64,
}

/// When to stop.
#[derive(Debug, Clone, Copy)]
enum Enough {
    Nearly,
    Converged,
}

impl Enough {
    fn is(self, promised: f64, cost: f64) -> bool {
        match self {
            Enough::Nearly => promised < ENOUGH * cost,
            Enough::Converged => promised < CONVERGED,
        }
    }
}

/// What a fit may move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moves {
    /// The swing's own numbers, the session's held.
    Own,
    /// And the body's, the stated dimensions held: a short record says little of them.
    Body,
    All,
}

struct Point {
    x: Vec<f64>,
    own: Own,
    cost: f64,
}

/// What a step did to χ².
#[derive(Debug, Clone, Copy, Default)]
struct Step {
    gained: f64,
    /// By the derivatives.
    promised: f64,
}

/// A linear statement about the session's parameters: `row · x = value`, of unit standard uncertainty.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    pub row: Vec<(usize, f64)>,
    pub value: f64,
}

/// Fits a swing, from rest and from the best of several sets of the session's parameters; over the short horizons only
/// what `early` says moves.
pub fn fit(model: &SwingModel, starts: &[Vec<f64>], early: Moves) -> Result<Fit> {
    let whole_s = model.samples.duration_s;
    let begun = starts.iter().map(|x| -> Result<(Point, f64)> {
        let slowest_s = model.slowest_s(x)?;
        Ok((model.first(x, (HORIZONS[0] * slowest_s).min(whole_s))?, slowest_s))
    });
    let best = begun.flatten().min_by(|(a, _): &(Point, f64), (b, _)| a.cost.total_cmp(&b.cost));
    let (mut point, slowest_s) = best.ok_or_else(no_start)?;
    for horizon in HORIZONS[1..].iter().map(|h| h * slowest_s).take_while(|h| *h < whole_s) {
        point = model.optimised(point, early, horizon, Enough::Nearly)?.0;
    }
    model.finished(model.optimised(point, Moves::All, whole_s, Enough::Converged)?)
}

fn no_start() -> Error {
    Error::no_result("fit of the motion", "it cannot be begun")
}

impl SwingModel<'_> {
    fn free(&self) -> Vec<usize> {
        let parameters = &self.setup.layout.parameters;
        (0..parameters.len()).filter(|i| parameters[*i].prior.u > 0.0).collect()
    }

    fn slowest_s(&self, x: &[f64]) -> Result<f64> {
        let SwingSetup { layout, swing, index } = self.setup;
        let body = swing_body(layout, x, swing, index)?;
        Ok(small_modes(&swing_rig(layout, x, swing, index)?, &body)?.period_s(0))
    }

    /// The best start over the headings that the phone may have.
    fn first(&self, x: &[f64], horizon_s: f64) -> Result<Point> {
        let tried = self.headings().into_iter().map(|nominal| -> Result<Point> {
            let start = Point { x: x.to_vec(), own: Own::at_rest(nominal), cost: f64::INFINITY };
            Ok(self.optimised(start, Moves::Own, horizon_s, Enough::Nearly)?.0)
        });
        tried.flatten().min_by(|a: &Point, b| a.cost.total_cmp(&b.cost)).ok_or_else(no_start)
    }

    /// `hanging_from_phone` for the vertical seen, with headings all round.
    fn headings(&self) -> Vec<Rotation> {
        let up = self.samples.up;
        let level = |v: Vec3| (v - up * up.dot(&v)).try_normalize(0.5);
        let Some(start) = level(Vec3::x()).or_else(|| level(Vec3::y())) else { return vec![] };
        // Columns: x, y and z of the hanging axes in phone axes.
        let turned = |eighth: i32| {
            let ahead = Rotation::from_scaled_axis(up * (FRAC_PI_4 * f64::from(eighth))) * start;
            let phone_from_hanging = Mat3::from_columns(&[ahead, up.cross(&ahead), up]);
            let matrix = nalgebra::Rotation3::from_matrix_unchecked(phone_from_hanging.transpose());
            Rotation::from_rotation_matrix(&matrix)
        };
        (0..8).map(turned).collect()
    }

    fn cost(&self, x: &[f64], own: &Own, horizon_s: f64) -> f64 {
        match Simulated::new(&self.setup, x, own, horizon_s, self.samples.duration_s) {
            Ok(simulated) => simulated.chi2(&self.samples, horizon_s) + self.prior_cost(x, own),
            Err(_) => f64::INFINITY,
        }
    }

    fn prior_cost(&self, x: &[f64], own: &Own) -> f64 {
        let session = self.setup.layout.parameters.iter().zip(x).filter(|(p, _)| p.prior.u > 0.0);
        let session: f64 = session.map(|(p, x)| ((x - p.prior.value) / p.prior.u).powi(2)).sum();
        let own: f64 = own.values.iter().zip(Own::prior_u()).map(|(v, u)| (v / u).powi(2)).sum();
        session + own
    }

    /// Information and gradient of the priors, session's free parameters first.
    fn priors(&self, x: &[f64], own: &Own, free: &[usize]) -> (DVector<f64>, DVector<f64>) {
        let of_session = free.iter().map(|i| {
            let prior = self.setup.layout.parameters[*i].prior;
            (prior.u.powi(-2), (prior.value - x[*i]) / prior.u.powi(2))
        });
        let of_own = own.values.iter().zip(Own::prior_u()).map(|(v, u)| (u.powi(-2), -v / (u * u)));
        let both: Vec<(f64, f64)> = of_session.chain(of_own).collect();
        let column = |f: fn(&(f64, f64)) -> f64| DVector::from_iterator(both.len(), both.iter().map(f));
        (column(|p| p.0), column(|p| p.1))
    }

    /// Levenberg–Marquardt. The derivatives are kept while the steps they give do what they promise: they cost some
    /// thirty times what a motion does.
    fn optimised(
        &self,
        mut at: Point,
        moves: Moves,
        horizon_s: f64,
        enough: Enough,
    ) -> Result<(Point, Linearised)> {
        let free = self.free();
        at.cost = self.cost(&at.x, &at.own, horizon_s);
        let mut slopes = self.linearised(&mut at, &free, horizon_s)?;
        let (mut fresh, mut damping) = (true, 1e-3);
        for _ in 0..MOST_STEPS {
            let normal = self.normal(&at, &slopes, &free)?;
            let step = self.step(&mut at, moves, &free, &normal, &mut damping, horizon_s);
            if enough.is(step.promised, at.cost) || (fresh && step.gained == 0.0) {
                break;
            }
            fresh = step.gained < KEPT * step.promised;
            if fresh {
                slopes = self.linearised(&mut at, &free, horizon_s)?;
            }
        }
        Ok((at, slopes))
    }

    fn linearised(&self, at: &mut Point, free: &[usize], horizon_s: f64) -> Result<Linearised> {
        at.own = at.own.clone().folded();
        Linearised::at(&self.setup, (&at.x, &at.own), free, &self.samples, horizon_s)
    }

    /// Matrix and gradient with the priors in them.
    fn normal(
        &self,
        at: &Point,
        slopes: &Linearised,
        free: &[usize],
    ) -> Result<(DMatrix<f64>, DVector<f64>)> {
        let simulated =
            Simulated::new(&self.setup, &at.x, &at.own, slopes.horizon_s, self.samples.duration_s)?;
        let (information, pull) = self.priors(&at.x, &at.own, free);
        let gradient = slopes.gradient(&simulated, &self.samples) + pull;
        Ok((&slopes.matrix + DMatrix::from_diagonal(&information), gradient))
    }

    /// Places of what may move: session's free parameters first, then the swing's own.
    fn moving(&self, moves: Moves, free: &[usize]) -> Vec<usize> {
        let parameters = &self.setup.layout.parameters;
        let may = |k: &usize| match (moves, free.get(*k)) {
            (Moves::All, _) | (_, None) => true,
            (Moves::Body, Some(i)) => parameters[*i].role == Role::Unknown,
            (Moves::Own, Some(_)) => false,
        };
        (0..free.len() + OWN).filter(may).collect()
    }

    /// What holds an unknown of the body near where it is: a direction of which the swing says nothing is not worth a
    /// long way.
    fn hold(&self, place: usize, free: &[usize]) -> f64 {
        let parameter = free.get(place).map(|i| &self.setup.layout.parameters[*i]);
        parameter.filter(|p| p.role == Role::Unknown).map_or(0.0, |p| p.prior.u.powi(-2))
    }

    /// One accepted step; nothing gained where no step is downhill.
    fn step(
        &self,
        at: &mut Point,
        moves: Moves,
        free: &[usize],
        (matrix, gradient): &(DMatrix<f64>, DVector<f64>),
        damping: &mut f64,
        horizon_s: f64,
    ) -> Step {
        let moving = self.moving(moves, free);
        let size = moving.len();
        let matrix = DMatrix::from_fn(size, size, |i, j| matrix[(moving[i], moving[j])]);
        let gradient = DVector::from_fn(size, |i, _| gradient[moving[i]]);
        let mut taken = Step::default();
        while *damping < MOST_DAMPING {
            let mut damped = matrix.clone();
            for (k, place) in moving.iter().enumerate() {
                damped[(k, k)] = damped[(k, k)] * (1.0 + *damping) + self.hold(*place, free);
            }
            let Some(factor) = damped.cholesky() else { break };
            let step = factor.solve(&gradient);
            let promised = 2.0 * gradient.dot(&step) - step.dot(&(&matrix * &step));
            taken = Step { gained: 0.0, promised };
            let (mut x, mut own) = (at.x.clone(), at.own.clone());
            for (k, s) in moving.iter().zip(step.iter()) {
                match free.get(*k) {
                    Some(i) => x[*i] += s,
                    None => own.values[k - free.len()] += s,
                }
            }
            let cost = self.cost(&x, &own, horizon_s);
            if cost <= at.cost {
                let gained = at.cost - cost;
                *at = Point { x, own, cost };
                *damping = (*damping * 0.1).max(1e-9);
                return Step { gained, ..taken };
            }
            *damping *= 10.0;
        }
        *damping = 1e-3;
        taken
    }

    /// The swing's own numbers fitted anew at other parameters of the session; what it leaves open stays its own.
    pub fn moved(&self, fitted: &Fit, x: &[f64]) -> Result<Fit> {
        let mut x = x.to_vec();
        let product = self.setup.layout.product_xz;
        if !self.tells_bow_from_stern() {
            x[product] = fitted.x[product];
        }
        let there = Point { x, own: fitted.own.clone(), cost: f64::INFINITY };
        self.finished(self.optimised(there, Moves::Own, self.samples.duration_s, Enough::Converged)?)
    }

    /// The fit begun anew at other parameters of the session: the better of the two.
    pub fn again(&self, fitted: Fit, x: &[f64]) -> Result<Fit> {
        let whole_s = self.samples.duration_s;
        // Bow and stern look alike to most of a swing: both headings are tried.
        let tried = [fitted.own.clone(), fitted.own.turned_round()].map(|own| {
            let there = Point { x: x.to_vec(), own, cost: f64::INFINITY };
            self.optimised(there, Moves::Own, whole_s, Enough::Nearly)
        });
        let near =
            tried.into_iter().flatten().map(|(point, _)| point).min_by(|a, b| a.cost.total_cmp(&b.cost));
        let near = near.ok_or_else(no_start)?;
        let found = self.finished(self.optimised(near, Moves::All, whole_s, Enough::Converged)?)?;
        Ok(if found.cost < fitted.cost { found } else { fitted })
    }

    fn finished(&self, (mut point, slopes): (Point, Linearised)) -> Result<Fit> {
        let free = self.free();
        let whole_s = self.samples.duration_s;
        let simulated = Simulated::new(&self.setup, &point.x, &point.own, whole_s, whole_s)?;
        let gradient = slopes.gradient(&simulated, &self.samples);
        point.own = point.own.folded();
        let rms_over_noise = rms(&simulated, &self.samples);
        let inflation = inflation(&simulated, &self.samples);
        Ok(Fit {
            cost: point.cost,
            x: point.x,
            own: point.own,
            free,
            matrix: slopes.matrix,
            gradient,
            rms_over_noise,
            inflation,
        })
    }

    /// How far the fit pitches the hull from what was stated, in standard uncertainties.
    pub fn pitch_pull(&self, fit: &Fit) -> f64 {
        let prior = self.setup.layout.parameters[self.setup.index.pitch_deg].prior;
        let pull = (fit.x[self.setup.index.pitch_deg] - prior.value).abs();
        if prior.u > 0.0 { pull / prior.u } else { 0.0 }
    }

    fn tells_bow_from_stern(&self) -> bool {
        self.setup.layout.parameters[self.setup.index.pitch_deg].prior.value.abs() > TELLING_PITCH_DEG
    }

    /// What the swing says of the session's parameters, its own numbers left open.
    ///
    /// A level hull looks the same from both ends, so the sign of its product of inertia hangs on a heading that
    /// nobody knows: there the product is left open too.
    pub fn statements(&self, fit: &Fit) -> Option<Vec<Statement>> {
        let (information, pull) = self.priors(&fit.x, &fit.own, &fit.free);
        let tells = self.tells_bow_from_stern();
        let is_open =
            |k: usize| k >= fit.free.len() || (fit.free[k] == self.setup.layout.product_xz && !tells);
        let all = fit.free.len() + OWN;
        let (open, kept): (Vec<usize>, Vec<usize>) = (0..all).partition(|k| is_open(*k));
        let part = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |i, j| fit.matrix[(rows[i], columns[j])])
        };
        let mut inner = part(&open, &open);
        open.iter().enumerate().for_each(|(i, k)| inner[(i, i)] += information[*k]);
        let outer = part(&kept, &open);
        let solved = inner.cholesky()?;
        let open_gradient = DVector::from_fn(open.len(), |i, _| fit.gradient[open[i]] + pull[open[i]]);
        let matrix = part(&kept, &kept) - &outer * solved.solve(&outer.transpose());
        let gradient = DVector::from_fn(kept.len(), |i, _| fit.gradient[kept[i]])
            - &outer * solved.solve(&open_gradient);
        let u = DVector::from_fn(kept.len(), |i, _| information[kept[i]].powf(-0.5));
        let scaled = DMatrix::from_fn(kept.len(), kept.len(), |i, j| matrix[(i, j)] * u[i] * u[j]);
        let eigen = scaled.symmetric_eigen();
        let statement = |k: usize| {
            let (vector, root) = (eigen.eigenvectors.column(k), eigen.eigenvalues[k].sqrt());
            let scale = 1.0 / fit.inflation.sqrt();
            let row: Vec<(usize, f64)> =
                (0..kept.len()).map(|i| (fit.free[kept[i]], scale * root * vector[i] / u[i])).collect();
            let here: f64 = row.iter().map(|(i, r)| r * fit.x[*i]).sum();
            let pulled: f64 = (0..kept.len()).map(|i| vector[i] * u[i] * gradient[i]).sum();
            Statement { row, value: here + scale * pulled / root }
        };
        let telling = (0..kept.len()).filter(|k| eigen.eigenvalues[*k] > LEAST_INFORMATION);
        Some(telling.map(statement).collect())
    }

    /// Covariance of the session's free parameters and the swing's own, priors included.
    pub fn covariance(&self, fit: &Fit) -> Option<DMatrix<f64>> {
        let (information, _) = self.priors(&fit.x, &fit.own, &fit.free);
        let matrix = &fit.matrix / fit.inflation + DMatrix::from_diagonal(&information);
        Some(matrix.cholesky()?.inverse())
    }
}

fn residual(simulated: &Simulated, stream: &Stream, i: usize) -> Vec3 {
    (stream.values[i] - simulated.at(stream.sensor, stream.t_s[i])).component_div(&stream.noise)
}

fn rms(simulated: &Simulated, samples: &Samples) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for stream in &samples.streams {
        sum += (0..stream.t_s.len()).map(|i| residual(simulated, stream, i).norm_squared()).sum::<f64>();
        count += 3 * stream.t_s.len();
    }
    (sum / count.max(1) as f64).sqrt()
}

/// Variance of the block means over what white noise gives them, at least 1: what is left at the frequencies of the
/// swing counts, and a block passes them. The worst axis counts where it stands out from chance.
fn inflation(simulated: &Simulated, samples: &Samples) -> f64 {
    let mut worst: f64 = 1.0;
    for stream in &samples.streams {
        let mut sum = Vec3::zeros();
        for block in &stream.blocks {
            let mean =
                block.clone().map(|i| residual(simulated, stream, i)).sum::<Vec3>() / block.len() as f64;
            sum += mean.component_mul(&mean) * block.len() as f64;
        }
        let ratio = (sum / stream.blocks.len().max(1) as f64).max();
        // Four standard deviations of the mean of so many χ² of one degree of freedom.
        let chance = 4.0 * (2.0 / stream.blocks.len().max(1) as f64).sqrt();
        if ratio > 1.0 + chance {
            worst = worst.max(ratio);
        }
    }
    worst
}
