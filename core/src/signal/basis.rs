//! The columns of the linear model, their derivatives, and the inner products that a fit needs.
//!
//! # Conventions
//! Columns: for each atom (modes, then tones) `Re z, −Im z`, so that the coefficients are the real and
//! imaginary part of the amplitude; then Legendre polynomials over the span; then, if wanted, the derivative
//! columns `Re D, −Im D`; then the channels. A tone of multiples n is `Π E_m^|n_m| exp(i Σ n_m φ_m)`.

use nalgebra::{DMatrix, DMatrixView};
use num_complex::Complex64;

use super::compress::Cells;
use super::motion::{Motion, MotionAt};

/// Rows that are multiplied at once.
const BLOCK: usize = 128;

/// What is fitted: modes, tones tied to them, and the number of baseline polynomials.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Model {
    pub modes: Vec<Motion>,
    pub tones: Vec<Vec<i32>>,
    pub baseline: usize,
}

/// A nonlinear parameter acts on an atom through one derivative column: `∂z/∂p = factor · D`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lever {
    pub parameter: usize,
    pub atom: usize,
    pub column: usize,
    pub factor: Complex64,
}

/// Weighted inner products of all columns of one group.
#[derive(Debug, Clone)]
pub(super) struct Products {
    gram: DMatrix<f64>,
}

impl Products {
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.gram[(i, j)]
    }
}

impl Model {
    pub fn atoms(&self) -> usize {
        self.modes.len() + self.tones.len()
    }

    /// Linear columns.
    pub fn linear(&self) -> usize {
        2 * self.atoms() + self.baseline
    }

    pub fn parameter_count(&self) -> usize {
        self.modes.iter().map(Motion::parameter_count).sum()
    }

    pub fn parameters(&self) -> Vec<f64> {
        self.modes.iter().flat_map(Motion::parameters).collect()
    }

    pub fn with_parameters(&self, p: &[f64]) -> Self {
        let mut rest = p;
        let mut model = self.clone();
        for mode in &mut model.modes {
            let (own, later) = rest.split_at(mode.parameter_count());
            *mode = mode.with_parameters(own);
            rest = later;
        }
        model
    }

    /// First parameter of a mode.
    pub fn parameter_offset(&self, mode: usize) -> usize {
        self.modes[..mode].iter().map(Motion::parameter_count).sum()
    }

    /// The fastest line that cells must resolve; tones, being weak, may lose 2 % of their information.
    pub fn highest_omega(&self) -> f64 {
        let modes = self.modes.iter().map(|m| m.omega);
        let tones = self.tones.iter().map(|n| 0.5 * combined(n, &self.modes).abs());
        modes.chain(tones).fold(0.0, f64::max)
    }

    /// Angular frequency of an atom, and whether an amplitude law moves it.
    pub fn atom_omega(&self, atom: usize) -> (f64, bool) {
        let turns = |m: usize| self.multiple(atom, m);
        let omega: f64 =
            self.modes.iter().enumerate().map(|(m, mode)| f64::from(turns(m)) * mode.omega).sum();
        let moved = self.modes.iter().enumerate().any(|(m, mode)| turns(m) != 0 && mode.law.is_some());
        (omega.abs(), moved)
    }

    /// Envelope of an atom.
    pub fn atom_envelope(&self, atom: usize, tau: f64) -> f64 {
        let factor = |(m, mode): (usize, &Motion)| mode.envelope(tau).powi(self.multiple(atom, m).abs());
        self.modes.iter().enumerate().map(factor).product()
    }

    /// How often a mode turns in an atom.
    pub fn multiple(&self, atom: usize, mode: usize) -> i32 {
        match atom.checked_sub(self.modes.len()) {
            None => i32::from(atom == mode),
            Some(tone) => self.tones[tone].get(mode).copied().unwrap_or(0),
        }
    }

    /// Which derivative columns there are, and which parameter acts through which.
    pub fn levers(&self) -> (Vec<Lever>, usize) {
        let (mut levers, mut column) = (Vec::new(), 0);
        for atom in 0..self.atoms() {
            let time_column = column;
            column += 1;
            for (mode, motion) in self.modes.iter().enumerate() {
                let n = f64::from(self.multiple(atom, mode));
                if n == 0.0 {
                    continue;
                }
                let parameter = self.parameter_offset(mode);
                let mut push = |offset: usize, column: usize, factor: Complex64| {
                    levers.push(Lever { parameter: parameter + offset, atom, column, factor });
                };
                push(0, time_column, Complex64::new(0.0, n));
                if motion.law.is_none() {
                    push(1, time_column, Complex64::from(-n.abs()));
                } else {
                    (1..4).for_each(|k| push(k, column + k - 1, Complex64::ONE));
                    column += 3;
                }
            }
        }
        (levers, column)
    }

    /// All columns for every cell, row by row; returns rows and row length.
    pub fn rows(&self, cells: &Cells, derivatives: bool) -> (Vec<f64>, usize) {
        let columns = if derivatives { self.levers().1 } else { 0 };
        let size = self.linear() + 2 * columns + cells.channels;
        let mut rows = Vec::with_capacity(size * cells.len());
        let mut walk = Walk::new(&self.modes);
        let mut late = Vec::with_capacity(2 * columns);
        for i in 0..cells.len() {
            walk.go_to(cells.tau[i]);
            late.clear();
            for atom in 0..self.atoms() {
                let (log_rate, z) = self.atom_at(atom, &walk);
                let mean = z * (log_rate * log_rate * (0.5 * cells.m2[i]) + 1.0);
                rows.extend([mean.re, -mean.im]);
                if derivatives {
                    let by_time = mean * cells.tau[i] + z * log_rate * cells.m2[i];
                    late.extend([by_time.re, -by_time.im]);
                    self.law_columns(atom, &walk, mean, &mut late);
                }
            }
            legendre(cells.tau[i], self.baseline, &mut rows);
            rows.extend_from_slice(&late);
            rows.extend_from_slice(&cells.mean[i * cells.channels..(i + 1) * cells.channels]);
        }
        (rows, size)
    }

    /// Rate and value of an atom where the walk stands.
    pub fn atom_at(&self, atom: usize, walk: &Walk) -> (Complex64, Complex64) {
        if atom < self.modes.len() {
            return (walk.at[atom].rate, walk.z[atom]);
        }
        let (mut rate, mut z) = (Complex64::ZERO, Complex64::ONE);
        for (mode, &n) in self.tones[atom - self.modes.len()].iter().enumerate() {
            rate += turned(walk.at[mode].rate, n);
            let factor = if n < 0 { walk.z[mode].conj() } else { walk.z[mode] };
            (0..n.abs()).for_each(|_| z *= factor);
        }
        (rate, z)
    }

    fn law_columns(&self, atom: usize, walk: &Walk, mean: Complex64, out: &mut Vec<f64>) {
        for (mode, motion) in self.modes.iter().enumerate() {
            let n = self.multiple(atom, mode);
            if n == 0 || motion.law.is_none() {
                continue;
            }
            for slope in &walk.at[mode].slopes[1..] {
                let column = mean * turned(*slope, n);
                out.extend([column.re, -column.im]);
            }
        }
    }
}

/// A logarithm of z taken n times round.
fn turned(log: Complex64, n: i32) -> Complex64 {
    Complex64::new(log.re * f64::from(n.abs()), log.im * f64::from(n))
}

/// Angular frequency of a combination.
pub(super) fn combined(multiples: &[i32], modes: &[Motion]) -> f64 {
    multiples.iter().zip(modes).map(|(&n, mode)| f64::from(n) * mode.omega).sum()
}

/// Legendre polynomials on [0, 1].
pub(super) fn legendre(tau: f64, count: usize, out: &mut Vec<f64>) {
    let x = 2.0 * tau - 1.0;
    let (mut previous, mut now) = (0.0, 1.0);
    for k in 0..count {
        out.push(now);
        let n = k as f64;
        let next = ((2.0 * n + 1.0) * x * now - n * previous) / (n + 1.0);
        (previous, now) = (now, next);
    }
}

/// Inner products of rows, weighted by the samples in each cell; in blocks that stay in the cache.
pub(super) fn products(rows: &[f64], size: usize, count: &[f64]) -> Products {
    let mut gram = DMatrix::zeros(size, size);
    for (block, count) in rows.chunks(size * BLOCK).zip(count.chunks(BLOCK)) {
        // Rows that follow one another are the columns of the transposed matrix.
        let transposed = DMatrixView::from_slice(block, size, count.len());
        let weighted = DMatrix::from_fn(count.len(), size, |i, j| block[i * size + j] * count[i]);
        gram.gemm(1.0, &transposed, &weighted, 1.0);
    }
    Products { gram }
}

/// Phasors of all modes, carried from stamp to stamp.
///
/// A plain mode is turned by `exp(λΔ)`, corrected by a short series for the uneven part of the step and set
/// anew every 32 steps, which is exact to 1e-9 and spares the sine and exponential of every stamp.
pub(super) struct Walk<'a> {
    modes: &'a [Motion],
    tau: f64,
    step: f64,
    turn: Vec<Complex64>,
    age: u32,
    pub at: Vec<MotionAt>,
    pub z: Vec<Complex64>,
}

impl<'a> Walk<'a> {
    pub fn new(modes: &'a [Motion]) -> Self {
        let at: Vec<MotionAt> = modes.iter().map(|mode| mode.at(0.0)).collect();
        let ones = vec![Complex64::ONE; modes.len()];
        Self { modes, tau: 0.0, step: 0.0, turn: ones.clone(), age: u32::MAX, at, z: ones }
    }

    pub fn go_to(&mut self, tau: f64) {
        let step = tau - self.tau;
        let fresh = self.age >= 32;
        let new_step = fresh || (step - self.step).abs() * self.fastest() > 0.03;
        if new_step {
            self.step = step;
        }
        self.age = if fresh { 0 } else { self.age + 1 };
        for (m, mode) in self.modes.iter().enumerate() {
            if mode.law.is_some() {
                self.at[m] = mode.at(tau);
                self.z[m] = self.at[m].log.exp();
                continue;
            }
            let rate = self.at[m].rate;
            if new_step {
                self.turn[m] = (rate * step).exp();
            }
            self.z[m] = if fresh {
                (rate * tau).exp()
            } else {
                self.z[m] * self.turn[m] * near_one(rate * (step - self.step))
            };
        }
        self.tau = tau;
    }

    fn fastest(&self) -> f64 {
        self.modes.iter().map(|m| m.omega).fold(0.0, f64::max)
    }
}

/// exp of a small number.
fn near_one(x: Complex64) -> Complex64 {
    ((x * (1.0 / 3.0) + 1.0) * (x * 0.5) + 1.0) * x + 1.0
}
