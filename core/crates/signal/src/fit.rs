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

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use num_complex::Complex64;

use super::basis::{Lever, Model, Products, products};
use super::compress::Cells;

/// Gain in merit that ends a trial: a tenth of a standard error in the whole parameter vector.
const TRIAL_END: f64 = 1e-2;
/// Gain that ends a final fit: a hundredth of a standard error.
const FINAL_END: f64 = 1e-4;
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

/// Second derivatives, gradient and their parts by channel.
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
    let (fit, curvature) = evaluate(model, groups, Wanted::Errors)?;
    Some((fit, curvature?))
}

fn project_for_step(model: &Model, groups: &[Cells]) -> Option<(Fit, Curvature)> {
    let (fit, curvature) = evaluate(model, groups, Wanted::Step)?;
    Some((fit, curvature?))
}

/// What the linearised problem promises to gain in merit.
pub(super) fn promise(model: &Model, groups: &[Cells]) -> Option<f64> {
    let (_, curvature) = project_for_step(model, groups)?;
    Some(curvature.gradient.dot(&damped_step(&curvature, 1e-9, &[])?))
}

/// Levenberg–Marquardt from a start, as far as a trial needs; none where the start itself cannot be
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
    let (mut fit, mut curvature) = project_for_step(start, groups)?;
    let mut damping = 1e-4;
    for _ in 0..iterations {
        let Some(step) = damped_step(&curvature, damping, held) else {
            break;
        };
        let moved: Vec<f64> = fit
            .model
            .parameters()
            .iter()
            .zip(step.iter())
            .map(|(p, d)| p + d)
            .collect();
        let trial = fit.model.with_parameters(&moved);
        let sound = trial.modes.iter().all(|mode| mode.is_sound());
        match sound.then(|| project_for_step(&trial, groups)).flatten() {
            Some((better, its)) if better.merit <= fit.merit => {
                let gain = fit.merit - better.merit;
                (fit, curvature) = (better, its);
                damping = (damping * 0.1).max(1e-12);
                if gain < end {
                    break;
                }
            }
            _ if curvature.gradient.dot(&step) < end => break,
            _ => damping = (damping * 10.0).max(1e-3),
        }
        if damping > 1e8 {
            break;
        }
    }
    Some(fit)
}

fn damped_step(curvature: &Curvature, damping: f64, held: &[usize]) -> Option<DVector<f64>> {
    let (mut hessian, mut gradient) = (curvature.hessian.clone(), curvature.gradient.clone());
    for i in 0..hessian.nrows() {
        hessian[(i, i)] *= 1.0 + damping;
    }
    for &i in held {
        hessian.row_mut(i).fill(0.0);
        hessian.column_mut(i).fill(0.0);
        (hessian[(i, i)], gradient[i]) = (1.0, 0.0);
    }
    Some(Cholesky::new(hessian)?.solve(&gradient))
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
