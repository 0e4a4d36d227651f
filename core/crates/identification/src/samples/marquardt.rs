//! Levenberg and Marquardt over the samples of one swing or of several at once: one body and one
//! set of dimensions for all, and for each swing what is its own.

use nalgebra::{DMatrix, DVector};

use super::linearise::{Linearised, Simulated};
use super::model::{Statement, SwingModel};
use super::scene::{OWN, Own};
use crate::parameters::{Layout, Role};
use gyradius_base::error::Result;

const MOST_STEPS: usize = 25;
const MOST_DAMPING: f64 = 1e6;
/// A step that gains less than this share of what the derivatives promised asks for new ones.
const KEPT: f64 = 0.5;
/// A step of an early horizon that promises less than this share of χ² ends it.
const ENOUGH: f64 = 1e-2;
/// Over the whole record a step that promises less of χ² ends the fit: a hundredth of a standard
/// deviation, squared.
const CONVERGED: f64 = 1e-4;

/// What is fitted.
pub struct Fitting<'a> {
    pub models: Vec<&'a SwingModel<'a>>,
    /// What is known of the session's parameters beside their priors.
    pub known: &'a [Statement],
}

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub enum Enough {
    Nearly,
    Converged,
}

impl Enough {
    fn is(self, left: f64, cost: f64) -> bool {
        match self {
            Enough::Nearly => left < ENOUGH * cost,
            Enough::Converged => left < CONVERGED,
        }
    }
}

/// What a fit may move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moves {
    /// The swings' own numbers, the session's held.
    Own,
    /// And the body's, the stated dimensions held: a short record says little of them.
    Body,
    All,
}

/// The session's parameters, and what belongs to each swing.
#[derive(Debug, Clone)]
pub struct Point {
    pub x: Vec<f64>,
    pub owns: Vec<Own>,
    /// χ² of samples, priors and what is known.
    pub cost: f64,
}

impl Point {
    pub fn new(x: &[f64], owns: Vec<Own>) -> Self {
        Self {
            x: x.to_vec(),
            owns,
            cost: f64::INFINITY,
        }
    }
}

/// What a step did to χ².
#[derive(Debug, Clone, Copy, Default)]
struct Step {
    gained: f64,
    /// By the derivatives.
    promised: f64,
    /// What an undamped step would gain by the derivatives.
    left: f64,
}

/// The session's parameters in play.
pub fn free(layout: &Layout) -> Vec<usize> {
    (0..layout.parameters.len())
        .filter(|i| layout.parameters[*i].is_free_in_motion())
        .collect()
}

impl Fitting<'_> {
    fn layout(&self) -> &Layout {
        self.models[0].setup.layout
    }

    /// The derivatives are kept while the steps they give do what they promise: they cost some
    /// thirty times what a motion does. Those from far away, at rest above all, cannot tell that
    /// nothing is left to gain.
    pub fn optimised(
        &self,
        mut at: Point,
        moves: Moves,
        horizon_s: f64,
        enough: Enough,
    ) -> Result<(Point, Vec<Linearised>)> {
        let free = free(self.layout());
        at.cost = self.cost(&at.x, &at.owns, horizon_s);
        let mut slopes = self.linearised(&mut at, &free, horizon_s)?;
        let (mut fresh, mut damping, mut cost_there) = (true, 1e-3, at.cost);
        for _ in 0..MOST_STEPS {
            let normal = self.normal(&at, &slopes, &free)?;
            let step = self.step(&mut at, moves, &free, &normal, &mut damping, horizon_s);
            let far = at.cost < KEPT * cost_there;
            let enough = enough.is(step.left, at.cost);
            if (enough && !far) || (fresh && step.gained == 0.0) {
                break;
            }
            fresh = enough || step.gained < KEPT * step.promised;
            if fresh {
                (slopes, cost_there) = (self.linearised(&mut at, &free, horizon_s)?, at.cost);
            }
        }
        Ok((at, slopes))
    }

    pub fn cost(&self, x: &[f64], owns: &[Own], horizon_s: f64) -> f64 {
        let of = |(model, own): (&&SwingModel, &Own)| model.own_cost(x, own, horizon_s);
        self.models.iter().zip(owns).map(of).sum::<f64>() + self.session_cost(x)
    }

    fn session_cost(&self, x: &[f64]) -> f64 {
        let priors = self
            .layout()
            .parameters
            .iter()
            .zip(x)
            .filter(|(p, _)| p.is_free_in_motion());
        let priors: f64 = priors
            .map(|(p, x)| ((x - p.prior.value) / p.prior.u).powi(2))
            .sum();
        priors + self.known.iter().map(|s| s.misfit(x).powi(2)).sum::<f64>()
    }

    fn linearised(
        &self,
        at: &mut Point,
        free: &[usize],
        horizon_s: f64,
    ) -> Result<Vec<Linearised>> {
        at.owns
            .iter_mut()
            .for_each(|own| *own = own.clone().folded());
        let x = &at.x;
        let each = self.models.iter().zip(&at.owns);
        each.map(|(m, own)| Linearised::at(&m.setup, (x, own), free, &m.samples, horizon_s))
            .collect()
    }

    /// Matrix and gradient with the priors in them: session's free parameters first, then each
    /// swing's own.
    fn normal(
        &self,
        at: &Point,
        slopes: &[Linearised],
        free: &[usize],
    ) -> Result<(DMatrix<f64>, DVector<f64>)> {
        let shared = free.len();
        let size = shared + OWN * self.models.len();
        let (mut matrix, mut gradient) = self.of_session(&at.x, free, size);
        for (i, (model, slopes)) in self.models.iter().zip(slopes).enumerate() {
            let own = &at.owns[i];
            let samples = &model.samples;
            let simulated = Simulated::new(
                &model.setup,
                &at.x,
                own,
                slopes.horizon_s,
                samples.duration_s,
            )?;
            let pull = slopes.gradient(&simulated, samples);
            let place = |k: usize| if k < shared { k } else { k + OWN * i };
            for k in 0..shared + OWN {
                gradient[place(k)] += pull[k];
                (0..shared + OWN)
                    .for_each(|l| matrix[(place(k), place(l))] += slopes.matrix[(k, l)]);
            }
            for (k, (value, u)) in own.values.iter().zip(Own::prior_u()).enumerate() {
                let at = shared + OWN * i + k;
                matrix[(at, at)] += u.powi(-2);
                gradient[at] -= value / (u * u);
            }
        }
        Ok((matrix, gradient))
    }

    /// The priors of the session's parameters and what is known of them.
    fn of_session(&self, x: &[f64], free: &[usize], size: usize) -> (DMatrix<f64>, DVector<f64>) {
        let (mut matrix, mut gradient) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for (k, i) in free.iter().enumerate() {
            let prior = self.layout().parameters[*i].prior;
            matrix[(k, k)] += prior.u.powi(-2);
            gradient[k] += (prior.value - x[*i]) / prior.u.powi(2);
        }
        for statement in self.known {
            let row = statement.by_place(free);
            for (k, a) in &row {
                gradient[*k] += a * statement.misfit(x);
                row.iter().for_each(|(l, b)| matrix[(*k, *l)] += a * b);
            }
        }
        (matrix, gradient)
    }

    /// Places of what may move: session's free parameters first, then the swings' own.
    fn moving(&self, moves: Moves, free: &[usize]) -> Vec<usize> {
        let may = |k: &usize| match (moves, free.get(*k)) {
            (Moves::All, _) | (_, None) => true,
            (Moves::Body, Some(i)) => self.layout().parameters[*i].role == Role::Unknown,
            (Moves::Own, Some(_)) => false,
        };
        (0..free.len() + OWN * self.models.len())
            .filter(may)
            .collect()
    }

    /// What holds an unknown of the body near where it is: a direction of which the swing says
    /// nothing is not worth a long way.
    fn hold(&self, place: usize, free: &[usize]) -> f64 {
        let parameter = free.get(place).map(|i| &self.layout().parameters[*i]);
        parameter
            .filter(|p| p.role == Role::Unknown)
            .map_or(0.0, |p| p.prior.u.powi(-2))
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
        let left = matrix.clone().cholesky().map_or(f64::INFINITY, |factor| {
            gradient.dot(&factor.solve(&gradient))
        });
        let mut taken = Step {
            left,
            ..Step::default()
        };
        while *damping < MOST_DAMPING {
            let mut damped = matrix.clone();
            for (k, place) in moving.iter().enumerate() {
                damped[(k, k)] = damped[(k, k)] * (1.0 + *damping) + self.hold(*place, free);
            }
            let Some(factor) = damped.cholesky() else {
                break;
            };
            let step = factor.solve(&gradient);
            let promised = 2.0 * gradient.dot(&step) - step.dot(&(&matrix * &step));
            taken.promised = promised;
            let mut there = moved(at, &moving, free, &step);
            there.cost = self.cost(&there.x, &there.owns, horizon_s);
            if there.cost <= at.cost {
                let gained = at.cost - there.cost;
                *at = there;
                *damping = (*damping * 0.1).max(1e-9);
                return Step { gained, ..taken };
            }
            *damping *= 10.0;
        }
        *damping = 1e-3;
        taken
    }
}

fn moved(at: &Point, moving: &[usize], free: &[usize], step: &DVector<f64>) -> Point {
    let mut there = at.clone();
    for (k, s) in moving.iter().zip(step.iter()) {
        match free.get(*k) {
            Some(i) => there.x[*i] += s,
            None => {
                let own = k - free.len();
                there.owns[own / OWN].values[own % OWN] += s;
            }
        }
    }
    there
}
