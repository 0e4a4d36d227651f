//! The body under a fitted simulation.

use std::collections::BTreeMap;

use nalgebra::DMatrix;

use gyradius_base::error::{Error, Result};
use gyradius_identification::outputs::write_quantities;
use gyradius_identification::samples::Statement;
use gyradius_identification::{Measurement, QuantityName, QuantityResult};
use gyradius_recording::Quantity;

use super::fitting::Places;
use super::point::{Model, Point};

/// Information below this share of a prior's own is left out.
const LEAST_INFORMATION: f64 = 1e-3;

/// Quantities of the hull alone at a fitted point with its information, with uncertainties widened
/// by a factor on the variance of what the samples say.
pub fn quantities(
    model: &Model,
    (point, matrix): (&Point, &DMatrix<f64>),
    inflation: f64,
    inclines: &[Option<Quantity>],
) -> Result<BTreeMap<QuantityName, QuantityResult>> {
    let said = statements(model, (point, matrix), inflation)?;
    let base = model.base;
    let mut system = base.system.with(base.layout().clone());
    let first = base.swings.first().map_or(0, |swing| swing.number);
    let mut by_swing = vec![vec![]; base.session.swings.len()];
    by_swing[first] = said;
    let numbers: Vec<usize> = base.swings.iter().map(|swing| swing.number).collect();
    let others: Vec<_> = system
        .periods
        .iter()
        .filter(|o| !o.is_of(&numbers))
        .cloned()
        .collect();
    system.state(&others, &by_swing, inclines);
    let mut solution = system.solve(&point.x)?;
    // Contradictions between swings and tape are what the criticism is about: they widen nothing by
    // themselves.
    solution.birge = 1.0;
    let mut result = Measurement::default();
    write_quantities(&system, &solution, &mut result);
    Ok(result.quantities)
}

/// What all samples together say of the session's parameters, everything else left open.
fn statements(
    model: &Model,
    (point, information): (&Point, &DMatrix<f64>),
    inflation: f64,
) -> Result<Vec<Statement>> {
    let failed = || Error::no_result("criticism", "the samples do not decide the parameters");
    let free = &model.base.free;
    let (count, all) = (free.len(), Places::of(model).all());
    let layout = model.base.layout();
    let prior = |k: usize| layout.parameters[free[k]].prior;
    let inner = information
        .view((count, count), (all - count, all - count))
        .into_owned();
    let outer = information
        .view((0, count), (count, all - count))
        .into_owned();
    let solved = inner.cholesky().ok_or_else(failed)?;
    let mut matrix = information.view((0, 0), (count, count)).into_owned();
    (0..count).for_each(|k| matrix[(k, k)] -= prior(k).u.powi(-2));
    matrix -= &outer * solved.solve(&outer.transpose());
    let u: Vec<f64> = (0..count).map(|k| prior(k).u).collect();
    let scaled = DMatrix::from_fn(count, count, |i, j| {
        matrix[(i, j)] * u[i] * u[j] / inflation
    });
    let eigen = scaled.symmetric_eigen();
    // The priors pull at the fitted point; the samples alone would lead on.
    let x: Vec<f64> = free.iter().map(|i| point.x[*i]).collect();
    let pull: Vec<f64> = (0..count).map(|k| (x[k] - prior(k).value) / u[k]).collect();
    let statement = |k: usize| {
        let (vector, root) = (eigen.eigenvectors.column(k), eigen.eigenvalues[k].sqrt());
        let row: Vec<(usize, f64)> = (0..count)
            .map(|i| (free[i], root * vector[i] / u[i]))
            .collect();
        let here: f64 = row.iter().zip(&x).map(|((_, r), x)| r * x).sum();
        let pulled: f64 = (0..count).map(|i| vector[i] * pull[i]).sum();
        Statement {
            row,
            value: here + pulled / root,
        }
    };
    Ok((0..count)
        .filter(|k| eigen.eigenvalues[*k] > LEAST_INFORMATION)
        .map(statement)
        .collect())
}
