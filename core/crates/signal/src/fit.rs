//! Variable projection: amplitudes and baselines are eliminated, the shared poles iterated.
//!
//! The crate `varpro` solves the same problem in general; here all channels of a group share their
//! columns, so that one small matrix of inner products serves every channel and every derivative,
//! and an iteration costs one pass over the cells. That is what brings six channels of 12 000
//! samples under 2 ms.
//!
//! Channels have their own units and noise: with the noise of each channel eliminated too, the
//! function that falls is `Σ_c N_c ln RSS_c`, and the weights are 1/σ_c² of the current iterate.
//! The derivative of the projection is Kaufman's (1975): its second term is of the order of the
//! residual times the curvature.

use gyradius_estimation::{
    Normal, Options, Parameter, Problem, Shape, Slopes, UNSTOPPED, minimise,
};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use num_complex::Complex64;

use super::basis::{Lever, Model, Products, products};
use super::compress::Cells;

/// Gain in merit that is not worth a step of a trial: 0.03 of a standard error in the whole
/// parameter vector.
const TRIAL_END: f64 = 1e-3;
/// That of a final fit: a thousandth of a standard error.
const FINAL_END: f64 = 1e-6;
/// Keeps a nearly singular curvature solvable.
const RIDGE: f64 = 1e-9;
/// Relative size below which a residual is rounding.
const ROUNDING: f64 = 1e-26;

/// A model with its amplitudes, and what is needed for errors.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    pub model: Model,
    /// Linear coefficients by channel.
    pub coefficients: Vec<Vec<f64>>,
    /// Residual sum of squares by channel.
    pub rss: Vec<f64>,
    /// Cells by channel.
    pub cells: Vec<f64>,
    /// `Σ N ln RSS`.
    pub merit: f64,
}

/// Second derivatives, downhill gradient and their parts by channel: halves of those of the merit.
pub(super) struct Curvature {
    pub hessian: DMatrix<f64>,
    pub gradient: DVector<f64>,
    /// Projected `JᵀJ` of each channel, not weighted.
    pub by_channel: Vec<DMatrix<f64>>,
    /// The group of each channel.
    pub group_of: Vec<usize>,
    /// Covariance of the linear coefficients for unit noise, by group.
    pub linear_covariance: Vec<DMatrix<f64>>,
    /// `∂a/∂p` by channel: linear columns × parameters.
    pub coefficient_slopes: Vec<DMatrix<f64>>,
}

impl Fit {
    /// Noise variance per sample of a channel as the residual shows it; infinite for a channel that
    /// is constant.
    pub fn variance(&self, channel: usize) -> f64 {
        if self.rss[channel] <= f64::MIN_POSITIVE {
            return f64::INFINITY;
        }
        self.rss[channel] / (self.cells[channel] - self.model.linear() as f64).max(1.0)
    }

    pub fn channels(&self) -> usize {
        self.rss.len()
    }

    /// Complex amplitude of an atom in a channel.
    pub fn amplitude(&self, channel: usize, atom: usize) -> Complex64 {
        let a = &self.coefficients[channel];
        Complex64::new(a[2 * atom], a[2 * atom + 1])
    }
}

/// Amplitudes for given poles; none where the columns are not independent.
pub(super) fn project(model: &Model, groups: &[Cells]) -> Option<Fit> {
    evaluate(model, groups, Wanted::Fit).map(|(fit, _)| fit)
}

/// Like [`project`], with the curvature and all that errors need.
pub(super) fn project_with_curvature(model: &Model, groups: &[Cells]) -> Option<(Fit, Curvature)> {
    with_curvature(evaluate(model, groups, Wanted::Errors)?)
}

fn with_curvature((fit, curvature): (Fit, Option<Curvature>)) -> Option<(Fit, Curvature)> {
    Some((fit, curvature?))
}

/// What the linearised problem promises to gain in merit.
pub(super) fn promise(model: &Model, groups: &[Cells]) -> Option<f64> {
    let (_, curvature) = with_curvature(evaluate(model, groups, Wanted::Step)?)?;
    let mut hessian = curvature.hessian;
    (0..hessian.nrows()).for_each(|i| hessian[(i, i)] *= 1.0 + RIDGE);
    let step = Cholesky::new(hessian)?.solve(&curvature.gradient);
    Some(curvature.gradient.dot(&step))
}

/// The best poles from a start, as far as a trial needs; none where the start itself cannot be
/// evaluated.
pub(super) fn refine(start: &Model, groups: &[Cells], iterations: usize) -> Option<Fit> {
    descend(start, groups, iterations, TRIAL_END, &[])
}

/// The same to the end, with some parameters held.
pub(super) fn polish(
    start: &Model,
    groups: &[Cells],
    iterations: usize,
    held: &[usize],
) -> Option<Fit> {
    descend(start, groups, iterations, FINAL_END, held)
}

fn descend(
    start: &Model,
    groups: &[Cells],
    iterations: usize,
    end: f64,
    held: &[usize],
) -> Option<Fit> {
    let at = start.parameters();
    let mut parameters = vec![Parameter::FREE; at.len()];
    held.iter()
        .for_each(|i| parameters[*i] = Parameter::FREE.fixed(at[*i]));
    let options = Options {
        most_steps: iterations,
        gain: end,
        gain_share: 0.0,
        keep: None,
    };
    let mut poles = Poles {
        start,
        groups,
        tried: None,
        best: None,
    };
    minimise(&mut poles, &parameters, &at, &options, UNSTOPPED).ok()?;
    poles.best
}

/// The poles of a model as parameters, its amplitudes eliminated; the merit takes the place of χ².
struct Poles<'a> {
    start: &'a Model,
    groups: &'a [Cells],
    tried: Option<(Fit, Curvature)>,
    /// The fit at the last point with derivatives: the best.
    best: Option<Fit>,
}

impl Problem for Poles<'_> {
    fn shape(&self) -> Shape {
        Shape::single(self.start.parameter_count())
    }

    fn chi2(&mut self, p: &[f64]) -> Option<f64> {
        let model = self.start.with_parameters(p);
        let is_start = self.best.is_none();
        let sound = is_start || model.modes.iter().all(|mode| mode.is_sound());
        let found = sound.then(|| evaluate(&model, self.groups, Wanted::Step));
        self.tried = with_curvature(found.flatten()?);
        self.tried.as_ref().map(|(fit, _)| fit.merit)
    }

    /// At the point that was tried last.
    fn normal(&mut self, _: &[f64], _: Slopes) -> Option<Normal> {
        let (fit, curvature) = self.tried.take()?;
        self.best = Some(fit);
        Some(Normal::single(curvature.hessian, -curvature.gradient))
    }
}

/// How much of an evaluation is needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    Fit,
    Step,
    Errors,
}

fn evaluate(model: &Model, groups: &[Cells], wanted: Wanted) -> Option<(Fit, Option<Curvature>)> {
    let derivatives = wanted != Wanted::Fit;
    let (levers, columns) = if derivatives {
        model.levers()
    } else {
        (vec![], 0)
    };
    let mut fit = Fit {
        model: model.clone(),
        coefficients: vec![],
        rss: vec![],
        cells: vec![],
        merit: 0.0,
    };
    let parameters = model.parameter_count();
    let mut curvature = Curvature {
        hessian: DMatrix::zeros(parameters, parameters),
        gradient: DVector::zeros(parameters),
        by_channel: vec![],
        group_of: vec![],
        linear_covariance: vec![],
        coefficient_slopes: vec![],
    };
    for cells in groups {
        let (rows, size) = model.rows(cells, derivatives);
        let group = Group {
            products: products(&rows, size),
            linear: model.linear(),
            columns,
        };
        let factor = group.factor()?;
        let first = fit.rss.len();
        for channel in 0..cells.channels {
            group.solve_channel(channel, &factor, cells.len() as f64, &mut fit);
        }
        if derivatives {
            group.add_curvature(
                &levers,
                &factor,
                &fit,
                first,
                wanted == Wanted::Errors,
                &mut curvature,
            );
        }
    }
    fit.merit = fit
        .rss
        .iter()
        .zip(&fit.cells)
        .map(|(rss, n)| n * rss.ln())
        .sum();
    fit.merit
        .is_finite()
        .then_some((fit, derivatives.then_some(curvature)))
}

/// The inner products of one group, cut into their blocks.
struct Group {
    products: Products,
    linear: usize,
    columns: usize,
}

impl Group {
    fn factor(&self) -> Option<Cholesky<f64, Dyn>> {
        let n = self.linear;
        // A ridge of rounding size keeps nearly equal columns solvable.
        let entry = |i, j| self.products.get(i, j) * if i == j { 1.0 + 1e-13 } else { 1.0 };
        Cholesky::new(DMatrix::from_fn(n, n, entry))
    }

    fn first_channel(&self) -> usize {
        self.linear + 2 * self.columns
    }

    fn solve_channel(
        &self,
        channel: usize,
        factor: &Cholesky<f64, Dyn>,
        cells: f64,
        fit: &mut Fit,
    ) {
        let y = self.first_channel() + channel;
        let b = DVector::from_fn(self.linear, |i, _| self.products.get(i, y));
        let a = factor.solve(&b);
        let total = self.products.get(y, y);
        fit.rss.push(
            (total - a.dot(&b))
                .max(total * ROUNDING)
                .max(f64::MIN_POSITIVE),
        );
        fit.coefficients.push(a.as_slice().to_vec());
        fit.cells.push(cells);
    }

    fn add_curvature(
        &self,
        levers: &[Lever],
        factor: &Cholesky<f64, Dyn>,
        fit: &Fit,
        first: usize,
        for_errors: bool,
        out: &mut Curvature,
    ) {
        let (n, d) = (self.linear, 2 * self.columns);
        let cross = DMatrix::from_fn(n, d, |i, j| self.products.get(i, n + j));
        let solved = factor.solve(&cross);
        let mut schur = DMatrix::from_fn(d, d, |i, j| self.products.get(n + i, n + j));
        schur -= cross.transpose() * &solved;
        for channel in first..fit.rss.len() {
            let pull = lever_matrix(levers, d, out.hessian.nrows(), fit, channel);
            let y = self.first_channel() + channel - first;
            let a = DVector::from_column_slice(&fit.coefficients[channel]);
            let residual =
                DVector::from_fn(d, |i, _| self.products.get(n + i, y)) - cross.tr_mul(&a);
            let square = pull.tr_mul(&(&schur * &pull));
            let weight = 1.0 / fit.variance(channel);
            out.gradient += pull.tr_mul(&residual) * weight;
            out.hessian += &square * weight;
            if for_errors {
                out.by_channel.push(square);
                out.group_of.push(out.linear_covariance.len());
                out.coefficient_slopes.push(-(&solved * &pull));
            }
        }
        if for_errors {
            out.linear_covariance.push(factor.inverse());
        }
    }
}

/// Coefficients of the derivative columns for each parameter: `Re(a·factor·D)`.
fn lever_matrix(
    levers: &[Lever],
    d: usize,
    parameters: usize,
    fit: &Fit,
    channel: usize,
) -> DMatrix<f64> {
    let mut pull = DMatrix::zeros(d, parameters);
    for lever in levers {
        let amplitude = fit.amplitude(channel, lever.atom) * lever.factor;
        pull[(2 * lever.column, lever.parameter)] += amplitude.re;
        pull[(2 * lever.column + 1, lever.parameter)] += amplitude.im;
    }
    pull
}
