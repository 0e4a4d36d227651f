//! The columns of the linear model, their derivatives, and the inner products that a fit needs.
//!
//! # Conventions
//! Columns: for each atom (modes, then tones) `Re z, −Im z`, so that the coefficients are the real
//! and imaginary part of the amplitude; then Legendre polynomials over the span; then, if wanted,
//! the derivative columns `Re D, −Im D`; then the channels. A tone of multiples n is `Π E_m^|n_m|
//! exp(i Σ n_m φ_m)`.

use nalgebra::{DMatrix, DMatrixView};
use num_complex::Complex64;

use super::compress::Cells;
use super::motion::{Motion, MotionAt};

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

    /// The fastest line that cells must resolve; tones, being weak, may lose 2 % of their
    /// information.
    pub fn highest_omega(&self) -> f64 {
        let modes = self.modes.iter().map(|m| m.omega);
        let tones = self
            .tones
            .iter()
            .map(|n| 0.5 * combined(n, &self.modes).abs());
        modes.chain(tones).fold(0.0, f64::max)
    }

    /// Angular frequency of an atom, and whether an amplitude law moves it.
    pub fn atom_omega(&self, atom: usize) -> (f64, bool) {
        let turns = |m: usize| self.multiple(atom, m);
        let omega: f64 = self
            .modes
            .iter()
            .enumerate()
            .map(|(m, mode)| f64::from(turns(m)) * mode.omega)
            .sum();
        let moved = self
            .modes
            .iter()
            .enumerate()
            .any(|(m, mode)| turns(m) != 0 && mode.law.is_some());
        (omega.abs(), moved)
    }

    /// Envelope of an atom.
    pub fn atom_envelope(&self, atom: usize, tau: f64) -> f64 {
        let factor =
            |(m, mode): (usize, &Motion)| mode.envelope(tau).powi(self.multiple(atom, m).abs());
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
                    levers.push(Lever {
                        parameter: parameter + offset,
                        atom,
                        column,
                        factor,
                    });
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

    /// All columns for every cell, row by row, weighted by the root of its samples; returns rows
    /// and row length.
    pub fn rows(&self, cells: &Cells, derivatives: bool) -> (Vec<f64>, usize) {
        let columns = if derivatives { 2 * self.levers().1 } else { 0 };
        let linear = self.linear();
        let size = linear + columns + cells.channels;
        let mut rows = vec![0.0; size * cells.len()];
        let mut walk = Walk::new(&self.modes);
        for (i, row) in rows.chunks_exact_mut(size).enumerate() {
            let (model, values) = row.split_at_mut(linear + columns);
            let (own, derived) = model.split_at_mut(linear);
            self.linear_row(cells, i, &mut walk, own);
            if derivatives {
                self.derivative_row(cells, i, &walk, own, derived);
            }
            values.copy_from_slice(&cells.mean[i * cells.channels..(i + 1) * cells.channels]);
            let weight = cells.count[i].sqrt();
            row.iter_mut().for_each(|value| *value *= weight);
        }
        (rows, size)
    }

    /// The linear columns of one cell.
    pub fn linear_row(&self, cells: &Cells, i: usize, walk: &mut Walk, row: &mut [f64]) {
        walk.go_to(cells.tau[i]);
        let (swings, baseline) = row.split_at_mut(2 * self.atoms());
        for (atom, columns) in swings.chunks_exact_mut(2).enumerate() {
            let (log_rate, z) = self.atom_at(atom, walk);
            let mean = mean_over_cell(log_rate, z, cells.m2[i]);
            (columns[0], columns[1]) = (mean.re, -mean.im);
        }
        legendre(cells.tau[i], baseline);
    }

    /// Rate and value of an atom where the walk stands.
    #[inline]
    pub fn atom_at(&self, atom: usize, walk: &Walk) -> (Complex64, Complex64) {
        if atom < self.modes.len() {
            return (walk.at[atom].rate, walk.z[atom]);
        }
        let (mut rate, mut z) = (Complex64::ZERO, Complex64::ONE);
        for (mode, &n) in self.tones[atom - self.modes.len()].iter().enumerate() {
            rate += turned(walk.at[mode].rate, n);
            let factor = if n < 0 {
                walk.z[mode].conj()
            } else {
                walk.z[mode]
            };
            (0..n.abs()).for_each(|_| z *= factor);
        }
        (rate, z)
    }

    /// The derivative columns of the cell where the walk stands and whose linear columns are known.
    fn derivative_row(
        &self,
        cells: &Cells,
        i: usize,
        walk: &Walk,
        linear: &[f64],
        derived: &mut [f64],
    ) {
        let mut columns = derived.chunks_exact_mut(2);
        let mut put = |value: Complex64| {
            if let Some(column) = columns.next() {
                (column[0], column[1]) = (value.re, -value.im);
            }
        };
        for atom in 0..self.atoms() {
            let (log_rate, z) = self.atom_at(atom, walk);
            let mean = Complex64::new(linear[2 * atom], -linear[2 * atom + 1]);
            put(mean * cells.tau[i] + z * log_rate * cells.m2[i]);
            for (mode, _) in self
                .modes
                .iter()
                .enumerate()
                .filter(|(_, motion)| motion.law.is_some())
            {
                let n = self.multiple(atom, mode);
                if n != 0 {
                    walk.at[mode].slopes[1..]
                        .iter()
                        .for_each(|slope| put(mean * turned(*slope, n)));
                }
            }
        }
    }
}

/// Mean of z over a cell of stamps with variance `m2`: z̄ = z(t̄)(1 + λ²m₂/2).
#[inline]
fn mean_over_cell(rate: Complex64, z: Complex64, m2: f64) -> Complex64 {
    z * (rate * rate * (0.5 * m2) + 1.0)
}

/// A logarithm of z taken n times round.
fn turned(log: Complex64, n: i32) -> Complex64 {
    Complex64::new(log.re * f64::from(n.abs()), log.im * f64::from(n))
}

/// Angular frequency of a combination.
pub(super) fn combined(multiples: &[i32], modes: &[Motion]) -> f64 {
    multiples
        .iter()
        .zip(modes)
        .map(|(&n, mode)| f64::from(n) * mode.omega)
        .sum()
}

/// Legendre polynomials on [0, 1].
#[inline]
pub(super) fn legendre(tau: f64, out: &mut [f64]) {
    let x = 2.0 * tau - 1.0;
    let (mut previous, mut now) = (0.0, 1.0);
    for (k, value) in out.iter_mut().enumerate() {
        *value = now;
        let n = k as f64;
        let next = ((2.0 * n + 1.0) * x * now - n * previous) / (n + 1.0);
        (previous, now) = (now, next);
    }
}

/// Their slopes against τ from their values: P'ₖ₊₁ = P'ₖ₋₁ + (2k + 1) Pₖ.
pub(super) fn legendre_slopes(values: &[f64]) -> Vec<f64> {
    let mut slopes = vec![0.0; values.len()];
    for k in 1..values.len() {
        let before = if k > 1 { slopes[k - 2] } else { 0.0 };
        slopes[k] = before + 2.0 * (2 * k - 1) as f64 * values[k - 1];
    }
    slopes
}

/// Inner products of rows.
pub(super) fn products(rows: &[f64], size: usize) -> Products {
    let count = rows.len() / size;
    let columns = DMatrixView::from_slice_with_strides(rows, count, size, size, 1);
    // Rows that follow one another are the columns of the transposed matrix.
    let transposed = DMatrixView::from_slice(rows, size, count);
    let mut gram = DMatrix::zeros(size, size);
    gram.gemm(1.0, &transposed, &columns, 0.0);
    Products { gram }
}

/// Phasors of all modes, carried from stamp to stamp.
///
/// A plain mode is turned by `exp(λΔ)`, corrected by a short series for the uneven part of the step
/// and set anew every 32 steps, which is exact to 1e-9 and spares the sine and exponential of every
/// stamp.
pub(super) struct Walk<'a> {
    modes: &'a [Motion],
    tau: f64,
    step: f64,
    turn: Vec<Complex64>,
    fastest: f64,
    age: u32,
    pub at: Vec<MotionAt>,
    pub z: Vec<Complex64>,
}

impl<'a> Walk<'a> {
    pub fn new(modes: &'a [Motion]) -> Self {
        let at: Vec<MotionAt> = modes.iter().map(|mode| mode.at(0.0)).collect();
        let ones = vec![Complex64::ONE; modes.len()];
        let fastest = modes.iter().map(|m| m.omega).fold(0.0, f64::max);
        Self {
            modes,
            tau: 0.0,
            step: 0.0,
            turn: ones.clone(),
            fastest,
            age: u32::MAX,
            at,
            z: ones,
        }
    }

    #[inline]
    pub fn go_to(&mut self, tau: f64) {
        let step = tau - self.tau;
        let fresh = self.age >= 32;
        let new_step = fresh || (step - self.step).abs() * self.fastest > 0.03;
        if new_step {
            self.step = step;
        }
        self.age = if fresh { 0 } else { self.age + 1 };
        let uneven = step - self.step;
        let states = self.at.iter_mut().zip(&mut self.z).zip(&mut self.turn);
        for (mode, ((at, z), turn)) in self.modes.iter().zip(states) {
            if mode.law.is_some() {
                *at = mode.at(tau);
                *z = at.log.exp();
                continue;
            }
            if new_step {
                *turn = (at.rate * step).exp();
            }
            *z = if fresh {
                (at.rate * tau).exp()
            } else {
                *z * *turn * near_one(at.rate * uneven)
            };
        }
        self.tau = tau;
    }
}

/// exp of a small number.
#[inline]
fn near_one(x: Complex64) -> Complex64 {
    ((x * (1.0 / 3.0) + 1.0) * (x * 0.5) + 1.0) * x + 1.0
}
