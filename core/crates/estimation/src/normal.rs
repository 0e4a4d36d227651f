//! Normal equations by block.
//!
//! # Conventions
//! With residuals `r` (in standard deviations of the noise) and their Jacobian `J = ∂r/∂x`:
//! `information = JᵀJ`, `gradient = Jᵀr`, so that a step `p` changes χ² by
//! `2·gradientᵀp + pᵀ·information·p` to second order.

use nalgebra::{DMatrix, DVector};

use crate::shape::Shape;

/// What one block says of its own parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Own {
    /// Own by own.
    pub information: DMatrix<f64>,
    /// Own by shared.
    pub cross: DMatrix<f64>,
    /// Own.
    pub gradient: DVector<f64>,
}

/// Normal equations: what all blocks say of the shared parameters, and each of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Normal {
    shape: Shape,
    /// Shared by shared.
    pub information: DMatrix<f64>,
    /// Shared.
    pub gradient: DVector<f64>,
    /// By block.
    pub own: Vec<Own>,
}

impl Normal {
    /// Nothing known yet.
    pub fn zero(shape: &Shape) -> Self {
        let shared = shape.shared();
        let own = (0..shape.blocks()).map(|b| {
            let count = shape.own(b).len();
            Own {
                information: DMatrix::zeros(count, count),
                cross: DMatrix::zeros(count, shared),
                gradient: DVector::zeros(count),
            }
        });
        Self {
            information: DMatrix::zeros(shared, shared),
            gradient: DVector::zeros(shared),
            own: own.collect(),
            shape: shape.clone(),
        }
    }

    /// Of one block whose parameters are all shared: its matrix and its gradient.
    pub fn single(information: DMatrix<f64>, gradient: DVector<f64>) -> Self {
        let mut normal = Self::zero(&Shape::single(gradient.len()));
        (normal.information, normal.gradient) = (information, gradient);
        normal
    }

    /// The order of the parameters.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Adds the residuals of a block and their Jacobian; its columns are those of the shared
    /// parameters, then the block's own.
    pub fn add_rows(&mut self, block: usize, residuals: &DVector<f64>, jacobian: &DMatrix<f64>) {
        // Not `tr_mul`, which multiplies matrices element by element.
        let square = jacobian.transpose() * jacobian;
        self.add(block, &square, &jacobian.tr_mul(residuals));
    }

    /// Adds a block's matrix and gradient; the shared parameters first, then the block's own.
    pub fn add(&mut self, block: usize, information: &DMatrix<f64>, gradient: &DVector<f64>) {
        let (shared, count) = (self.shape.shared(), self.shape.own(block).len());
        let own = &mut self.own[block];
        self.information += information.view((0, 0), (shared, shared));
        self.gradient += gradient.rows(0, shared);
        own.information += information.view((shared, shared), (count, count));
        own.cross += information.view((shared, 0), (count, shared));
        own.gradient += gradient.rows(shared, count);
    }

    /// Adds a prior of one parameter: `(x − mean)/u` is a residual.
    pub(crate) fn add_prior(&mut self, place: usize, away: f64, u: f64) {
        let (information, gradient, k) = self.part_mut(place);
        information[(k, k)] += u.powi(-2);
        gradient[k] += away / (u * u);
    }

    /// Matrix and gradient that a parameter is in, and its place there.
    fn part_mut(&mut self, place: usize) -> (&mut DMatrix<f64>, &mut DVector<f64>, usize) {
        match self.shape.block_of(place) {
            Some(b) => {
                let own = &mut self.own[b];
                let first = self.shape.own(b).start;
                (&mut own.information, &mut own.gradient, place - first)
            }
            None => (&mut self.information, &mut self.gradient, place),
        }
    }

    /// Gradient by all parameters: half of the derivative of χ².
    pub fn whole_gradient(&self) -> DVector<f64> {
        let own = self.own.iter().flat_map(|o| o.gradient.iter());
        let all: Vec<f64> = self.gradient.iter().chain(own).copied().collect();
        DVector::from_vec(all)
    }

    /// Diagonal of the whole matrix.
    pub fn diagonal(&self) -> DVector<f64> {
        let own = self.own.iter().map(|o| o.information.diagonal());
        let all: Vec<f64> = std::iter::once(self.information.diagonal())
            .chain(own)
            .flat_map(|d| d.as_slice().to_vec())
            .collect();
        DVector::from_vec(all)
    }

    /// The whole matrix times a vector, linear in the number of blocks.
    pub fn times(&self, x: &DVector<f64>) -> DVector<f64> {
        let shared = self.shape.shared();
        let first = x.rows(0, shared);
        let mut product = DVector::zeros(x.len());
        let mut top = &self.information * first;
        for (b, own) in self.own.iter().enumerate() {
            let places = self.shape.own(b);
            let mine = x.rows(places.start, places.len());
            top += own.cross.tr_mul(&mine);
            let below = &own.information * mine + &own.cross * first;
            product
                .rows_mut(places.start, places.len())
                .copy_from(&below);
        }
        product.rows_mut(0, shared).copy_from(&top);
        product
    }

    /// The whole matrix.
    pub fn dense(&self) -> DMatrix<f64> {
        let total = self.shape.total();
        let mut whole = DMatrix::zeros(total, total);
        let mut put = |at: (usize, usize), part: &DMatrix<f64>| {
            whole.view_mut(at, part.shape()).copy_from(part);
        };
        put((0, 0), &self.information);
        for (b, own) in self.own.iter().enumerate() {
            let first = self.shape.own(b).start;
            put((first, first), &own.information);
            put((first, 0), &own.cross);
            put((0, first), &own.cross.transpose());
        }
        whole
    }

    /// Whether every number in it is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let finite = |m: &DMatrix<f64>| m.iter().all(|v| v.is_finite());
        let own = |o: &Own| finite(&o.information) && finite(&o.cross);
        finite(&self.information)
            && self.own.iter().all(own)
            && self.whole_gradient().iter().all(|v| v.is_finite())
    }
}
