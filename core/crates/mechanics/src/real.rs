//! The numbers a simulation runs on: plain ones, and ones that carry their derivatives.
//!
//! Every equation of motion, every effect and every sensor is written once over [`Real`]; with
//! [`Dual`] the same lines give the readings and their derivatives. `num-dual` knows the same
//! arithmetic, but its derivatives are optional matrices: with 20 of them a kernel of products and
//! cross products took 38 µs against 8 µs here (and 0.1 µs on plain numbers).

use std::array::from_fn;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::{Matrix3, Scalar, Vector3};
use num_traits::{One, Zero};

/// A real number, with derivatives or without.
pub trait Real:
    Scalar
    + Copy
    + Debug
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// A number that depends on nothing.
    fn constant(value: f64) -> Self;
    /// The number itself.
    fn value(self) -> f64;
    /// Its derivatives, if it has any.
    fn slopes(&self) -> &[f64];
    /// `f(self)`, given f and its derivative at the number.
    fn chain(self, f: f64, slope: f64) -> Self;
    /// `self · factor`.
    fn scale(self, factor: f64) -> Self;
    /// `self += weight · other`.
    fn add_scaled(&mut self, weight: f64, other: Self);

    /// Square root; of zero, with slope zero.
    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }
    /// Sine.
    fn sin(self) -> Self {
        let (sin, cos) = self.value().sin_cos();
        self.chain(sin, cos)
    }
    /// Cosine.
    fn cos(self) -> Self {
        let (sin, cos) = self.value().sin_cos();
        self.chain(cos, -sin)
    }
    /// Exponential.
    fn exp(self) -> Self {
        let e = self.value().exp();
        self.chain(e, e)
    }
    /// Natural logarithm.
    fn ln(self) -> Self {
        self.chain(self.value().ln(), 1.0 / self.value())
    }
    /// Hyperbolic tangent.
    fn tanh(self) -> Self {
        let t = self.value().tanh();
        self.chain(t, 1.0 - t * t)
    }
    /// Size; at zero, with slope zero.
    fn abs(self) -> Self {
        let value = self.value();
        self.chain(value.abs(), if value == 0.0 { 0.0 } else { value.signum() })
    }
    /// Angle of the point (`x`, `self`).
    fn atan2(self, x: Self) -> Self {
        let (y0, x0) = (self.value(), x.value());
        let square = x0 * x0 + y0 * y0;
        let (dy, dx) = (self.chain(0.0, x0 / square), x.chain(0.0, -y0 / square));
        Self::constant(y0.atan2(x0)) + dy + dx
    }
}

impl Real for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn slopes(&self) -> &[f64] {
        &[]
    }
    #[inline]
    fn chain(self, f: f64, _slope: f64) -> Self {
        f
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        self * factor
    }
    #[inline]
    fn add_scaled(&mut self, weight: f64, other: Self) {
        *self += weight * other;
    }
}

/// Whether a number depends on none of the parameters.
pub fn is_still<S: Real>(number: S) -> bool {
    number.slopes().iter().all(|slope| *slope == 0.0)
}

/// A number and its derivatives with respect to `N` parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub value: f64,
    /// Its derivatives.
    pub slope: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The same with the derivatives by the first `M` of its parameters.
    pub(crate) fn narrowed<const M: usize>(self) -> Dual<M> {
        Dual {
            value: self.value,
            slope: from_fn(|lane| self.slope[lane]),
        }
    }

    /// Parameter number `lane` itself.
    pub fn parameter(value: f64, lane: usize) -> Self {
        let mut slope = [0.0; N];
        slope[lane] = 1.0;
        Self { value, slope }
    }

    #[inline]
    fn combined(self, other: &Self, value: f64, own: f64, others: f64) -> Self {
        let mut slope = self.slope;
        for (mine, theirs) in slope.iter_mut().zip(&other.slope) {
            *mine = own * *mine + others * theirs;
        }
        Self { value, slope }
    }
}

impl<const N: usize> Real for Dual<N> {
    fn constant(value: f64) -> Self {
        Self {
            value,
            slope: [0.0; N],
        }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn slopes(&self) -> &[f64] {
        &self.slope
    }
    // In place: `map` of a long array is a call for each of its numbers.
    #[inline]
    fn chain(mut self, f: f64, slope: f64) -> Self {
        self.value = f;
        self.slope.iter_mut().for_each(|mine| *mine *= slope);
        self
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        self.chain(self.value * factor, factor)
    }
    #[inline]
    fn add_scaled(&mut self, weight: f64, other: Self) {
        self.value += weight * other.value;
        for (mine, theirs) in self.slope.iter_mut().zip(&other.slope) {
            *mine += weight * theirs;
        }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(mut self, other: Self) -> Self {
        self.add_scaled(1.0, other);
        self
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(mut self, other: Self) -> Self {
        self.add_scaled(-1.0, other);
        self
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.combined(&other, self.value * other.value, other.value, self.value)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        let value = self.value * inverse;
        self.combined(&other, value, inverse, -value * inverse)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.scale(-1.0)
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        self.scale(factor)
    }
}

impl<const N: usize> Add<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(mut self, more: f64) -> Self {
        self.value += more;
        self
    }
}

macro_rules! assigning {
    ($($trait:ident $method:ident $operator:tt),*) => {$(
        impl<const N: usize> $trait for Dual<N> {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}
assigning!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl<const N: usize> Zero for Dual<N> {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<const N: usize> One for Dual<N> {
    fn one() -> Self {
        Self::constant(1.0)
    }
}

/// A vector over [`Real`].
pub type V3<S> = Vector3<S>;
/// A matrix over [`Real`].
pub type M3<S> = Matrix3<S>;

/// A constant vector.
pub(crate) fn constant<S: Real>(v: &Vector3<f64>) -> V3<S> {
    v.map(S::constant)
}

/// `m v`. The product of nalgebra moves whole columns about, which took a third of the time of
/// numbers with derivatives.
#[inline]
pub(crate) fn times<S: Real>(m: &M3<S>, v: &V3<S>) -> V3<S> {
    let row = |i: usize| m[(i, 0)] * v.x + m[(i, 1)] * v.y + m[(i, 2)] * v.z;
    V3::new(row(0), row(1), row(2))
}

/// Solves the `n` equations in the upper left of `a x = b` in place, the largest pivot of a column
/// first.
///
/// A singular matrix gives values that are not finite.
pub(crate) fn solve<S: Real, const N: usize>(a: &mut [[S; N]; N], b: &mut [S; N], n: usize) {
    for column in 0..n {
        let size = |row: &usize| a[*row][column].value().abs();
        let pivot = (column..n)
            .max_by(|i, j| size(i).total_cmp(&size(j)))
            .unwrap_or(column);
        a.swap(column, pivot);
        b.swap(column, pivot);
        let inverse = S::one() / a[column][column];
        for row in column + 1..n {
            let factor = a[row][column] * inverse;
            for k in column + 1..n {
                let above = a[column][k];
                a[row][k] -= factor * above;
            }
            let above = b[column];
            b[row] -= factor * above;
        }
    }
    for row in (0..n).rev() {
        for k in row + 1..n {
            let known = a[row][k] * b[k];
            b[row] -= known;
        }
        b[row] /= a[row][row];
    }
}

/// A positive definite matrix, its values decomposed, to solve `a x = b` with many right sides.
///
/// With A₀ = A's values and x₀ = A₀⁻¹ b, x₀ + A₀⁻¹ (b − A x₀) has the derivatives of the solution:
/// the decomposition has none.
#[derive(Debug, Clone)]
pub(crate) struct Decomposed<'a, S: Real, const N: usize> {
    matrix: &'a [[S; N]; N],
    /// L D Lᵀ: L below the diagonal, 1/D on it.
    parts: [[f64; N]; N],
}

impl<'a, S: Real, const N: usize> Decomposed<'a, S, N> {
    /// A singular matrix gives solutions that are not finite.
    pub fn new(matrix: &'a [[S; N]; N]) -> Self {
        let mut parts: [[f64; N]; N] = from_fn(|i| from_fn(|j| matrix[i][j].value()));
        for k in 0..N {
            let inverse = 1.0 / parts[k][k];
            let column: [f64; N] = from_fn(|i| parts[i][k]);
            for i in k + 1..N {
                parts[i][k] *= inverse;
                for j in k + 1..=i {
                    parts[i][j] -= parts[i][k] * column[j];
                }
            }
            parts[k][k] = inverse;
        }
        Self { matrix, parts }
    }

    /// The solution for a right side.
    pub fn solve(&self, b: &[S; N]) -> [S; N] {
        let mut values = b.map(S::value);
        self.divide(&mut values);
        if b[0].slopes().is_empty() {
            return values.map(S::constant);
        }
        let mut left = *b;
        for (left, row) in left.iter_mut().zip(self.matrix) {
            row.iter()
                .zip(values)
                .for_each(|(cell, x)| left.add_scaled(-x, *cell));
        }
        self.divide(&mut left);
        left.iter_mut()
            .zip(values)
            .for_each(|(left, x)| left.add_scaled(x, S::one()));
        left
    }

    /// By the values of the matrix.
    fn divide<T: Real>(&self, x: &mut [T; N]) {
        for i in 0..N {
            let (known, rest) = x.split_at_mut(i);
            known
                .iter()
                .zip(&self.parts[i])
                .for_each(|(known, l)| rest[0].add_scaled(-l, *known));
        }
        for i in (0..N).rev() {
            x[i] = x[i].scale(self.parts[i][i]);
            let (rest, known) = x.split_at_mut(i + 1);
            known
                .iter()
                .zip(&self.parts[i + 1..])
                .for_each(|(known, row)| rest[i].add_scaled(-row[i], *known));
        }
    }
}

/// Inverse of a 3 × 3 matrix by its cofactors.
pub(crate) fn inverse<S: Real>(m: &M3<S>) -> M3<S> {
    let rows = [
        m.row(0).transpose(),
        m.row(1).transpose(),
        m.row(2).transpose(),
    ];
    let columns = [
        rows[1].cross(&rows[2]),
        rows[2].cross(&rows[0]),
        rows[0].cross(&rows[1]),
    ];
    let determinant = S::one() / rows[0].dot(&columns[0]);
    M3::from_columns(&columns) * determinant
}
