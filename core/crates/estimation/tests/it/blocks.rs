//! Shared and own parameters: closed forms, and the Schur complement against the dense solution.

use nalgebra::{DMatrix, DVector};
use rand::RngExt;

use gyradius_estimation::{
    Block, ByRows, Fit, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted, minimise,
};
use gyradius_test_support::fresh;

fn solve(problem: &impl Rows, parameters: &[Parameter], start: &[f64]) -> Fit {
    let options = Options {
        gain: 1e-20,
        ..Options::default()
    };
    minimise(
        &mut ByRows::new(problem),
        parameters,
        start,
        &options,
        UNSTOPPED,
    )
    .unwrap()
}

/// A common mean, and a deviation from it of each group, every reading to 1.
struct Groups(Vec<Vec<f64>>);

impl Rows for Groups {
    fn shape(&self) -> Shape {
        Shape::new(1, &vec![1; self.0.len()])
    }

    fn rows(&self, b: usize, mean: &[f64], own: &[f64], _: Wanted) -> Option<Block> {
        let readings = &self.0[b];
        let residual = |k: usize, _| mean[0] + own[0] - readings[k];
        Some(Block {
            residuals: DVector::from_fn(readings.len(), residual),
            jacobian: Some(DMatrix::from_element(readings.len(), 2, 1.0)),
        })
    }
}

/// One-way random effects (S. R. Searle, *Linear Models* (1971), ch. 10): with `n` readings of each
/// of `B` groups and deviations of 0 ± τ the mean is that of all, a deviation shrinks by
/// `nτ²/(1 + nτ²)`, and the mean's variance is `(τ² + 1/n)/B`.
#[test]
fn balanced_groups_have_their_closed_form() {
    let (groups, n, tau) = (7, 5, 0.8);
    let mut random = fresh("balanced_groups");
    let mut draw = |b: usize| (0..n).map(|_| b as f64 + random.random::<f64>()).collect();
    let data = Groups((0..groups).map(&mut draw).collect());
    let mut parameters = vec![Parameter::FREE];
    parameters.extend(vec![Parameter::FREE.with_prior(0.0, tau); groups]);
    let fit = solve(&data, &parameters, &vec![0.0; groups + 1]);

    let means: Vec<f64> = data
        .0
        .iter()
        .map(|g| g.iter().sum::<f64>() / n as f64)
        .collect();
    let mean = means.iter().sum::<f64>() / groups as f64;
    let (n, b) = (n as f64, groups as f64);
    assert!((fit.x[0] - mean).abs() < 1e-12);
    let shrink = n * tau * tau / (1.0 + n * tau * tau);
    for (x, group) in fit.x[1..].iter().zip(&means) {
        assert!((x - shrink * (group - mean)).abs() < 1e-12);
    }
    let u = fit.standard_deviations().unwrap();
    assert!((u[0].powi(2) - (tau * tau + 1.0 / n) / b).abs() < 1e-12);
    let own = n + tau.powi(-2);
    let log_det = b * own.ln() + (n * b - b * n * n / own).ln();
    assert!((fit.factor().unwrap().half_log_determinant() - log_det / 2.0).abs() < 1e-12);
    let prior: f64 = fit.x[1..].iter().map(|x| (x / tau).powi(2)).sum();
    assert!((fit.prior_chi2 - prior).abs() < 1e-12 && prior > 0.0);
}

/// Decays that share a rate and an offset, each with its own amplitude and phase.
struct Decays {
    readings: Vec<Vec<f64>>,
}

impl Decays {
    const STEP: f64 = 0.1;
    const NOISE: f64 = 0.01;

    fn drawn(blocks: usize, rows: usize) -> Self {
        let mut random = fresh("decays");
        let mut block = |b: usize| {
            let (a, phase) = (1.0 + b as f64 % 3.0, 0.2 * (b as f64).sin());
            let mut reading = |i: usize| {
                let t = i as f64 * Self::STEP;
                let noise = Self::NOISE * (random.random::<f64>() - 0.5);
                0.3 + a * (-0.7 * t).exp() * (2.0 * t + phase).cos() + noise
            };
            (0..rows).map(&mut reading).collect()
        };
        Self {
            readings: (0..blocks).map(&mut block).collect(),
        }
    }
}

impl Rows for Decays {
    fn shape(&self) -> Shape {
        Shape::new(2, &vec![2; self.readings.len()])
    }

    fn rows(&self, b: usize, shared: &[f64], own: &[f64], _: Wanted) -> Option<Block> {
        let (&[rate, offset], &[a, phase]) = (shared, own) else {
            return None;
        };
        let readings = &self.readings[b];
        let at = |i: usize| {
            let t = i as f64 * Self::STEP;
            let (decay, angle) = ((-rate * t).exp(), 2.0 * t + phase);
            let wave = decay * angle.cos();
            (
                offset + a * wave,
                [-t * a * wave, 1.0, wave, -a * decay * angle.sin()],
            )
        };
        let rows = readings.len();
        let residual = |i: usize, _| (at(i).0 - readings[i]) / Self::NOISE;
        Some(Block {
            residuals: DVector::from_fn(rows, residual),
            jacobian: Some(DMatrix::from_fn(rows, 4, |i, k| at(i).1[k] / Self::NOISE)),
        })
    }
}

/// The same as one block whose parameters are all shared.
struct AsOne<'a>(&'a Decays);

impl Rows for AsOne<'_> {
    fn shape(&self) -> Shape {
        Shape::single(self.0.shape().total())
    }

    fn rows(&self, _: usize, x: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
        let shape = self.0.shape();
        let (mut residuals, mut rows) = (vec![], vec![]);
        for b in 0..shape.blocks() {
            let block = self.0.rows(b, &x[..2], &x[shape.own(b)], wanted)?;
            let jacobian = block.jacobian?;
            for (i, r) in block.residuals.iter().enumerate() {
                let mut row = vec![0.0; x.len()];
                row[..2].copy_from_slice(&[jacobian[(i, 0)], jacobian[(i, 1)]]);
                row[shape.own(b)].copy_from_slice(&[jacobian[(i, 2)], jacobian[(i, 3)]]);
                residuals.push(*r);
                rows.extend(row);
            }
        }
        Some(Block {
            jacobian: Some(DMatrix::from_row_slice(residuals.len(), x.len(), &rows)),
            residuals: DVector::from_vec(residuals),
        })
    }
}

fn start_of(blocks: usize) -> Vec<f64> {
    let own = [1.5, 0.0].into_iter().cycle().take(2 * blocks);
    [0.4, 0.0].into_iter().chain(own).collect()
}

#[test]
fn blocks_are_solved_as_the_dense_problem_is() {
    let decays = Decays::drawn(6, 30);
    let start = start_of(6);
    let mut parameters = vec![Parameter::FREE; start.len()];
    // One own parameter with a prior, one pressed against a bound, one fixed.
    parameters[3] = Parameter::FREE.with_prior(0.1, 0.05);
    parameters[6] = Parameter::FREE.within(0.0, 2.5);
    parameters[9] = Parameter::FREE.fixed(0.05);
    let (blocks, dense) = (
        solve(&decays, &parameters, &start),
        solve(&AsOne(&decays), &parameters, &start),
    );
    let (x, y) = (
        DVector::from_vec(blocks.x.clone()),
        DVector::from_vec(dense.x.clone()),
    );
    assert!((&x - &y).amax() < 1e-10, "{x} {y}");
    assert_eq!((blocks.steps, &blocks.edges), (dense.steps, &dense.edges));
    assert_eq!(blocks.held(), dense.held());
    let (c, d) = (blocks.covariance().unwrap(), dense.covariance().unwrap());
    assert!((&c - &d).amax() < 1e-10 * d.amax());
    let u = blocks.standard_deviations().unwrap();
    assert!((u.component_mul(&u) - d.diagonal()).amax() < 1e-10 * d.amax());
    let logs = [&blocks, &dense].map(|f| f.log_evidence().unwrap());
    assert!((logs[0] - logs[1]).abs() < 1e-9);
    assert!((blocks.information() - dense.information()).amax() < 1e-6);
    // What is held has no variance, and all that is free has the inverse of the information.
    let held = blocks.held();
    assert_eq!(held.iter().filter(|h| **h).count(), 2);
    let free: Vec<usize> = (0..held.len()).filter(|k| !held[*k]).collect();
    let part = |m: &DMatrix<f64>| m.select_rows(&free).select_columns(&free);
    let unit = part(&c) * part(&blocks.information());
    assert!((unit - DMatrix::identity(free.len(), free.len())).amax() < 1e-8);
    assert!(
        held.iter()
            .enumerate()
            .all(|(k, h)| *h == (c[(k, k)] == 0.0))
    );
}

/// The dense matrix of 40 002 parameters would be 13 GB.
#[test]
fn the_cost_grows_with_the_number_of_blocks_alone() {
    let blocks = 20_000;
    let decays = Decays::drawn(blocks, 12);
    let parameters = vec![Parameter::FREE; 2 * blocks + 2];
    let fit = solve(&decays, &parameters, &start_of(blocks));
    let u = fit.standard_deviations().unwrap();
    let errors = [(fit.x[0] - 0.7) / u[0], (fit.x[1] - 0.3) / u[1]];
    // Uniform noise has a variance of 1/12 of its width's square.
    assert!(
        errors.iter().all(|e| e.abs() < 5.0 / 12f64.sqrt()),
        "{errors:?}"
    );
    assert!(u[0] < 1e-3);
}
