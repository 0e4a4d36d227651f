//! Cholesky factor of normal equations by the Schur complement: own parameters are eliminated
//! block by block, so that the cost grows linearly with the number of blocks.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use crate::normal::Normal;
use crate::shape::Shape;

/// A block's own part.
struct OwnFactor {
    /// Of its own matrix.
    lower: Cholesky<f64, Dyn>,
    /// `L⁻¹·cross`.
    cross: DMatrix<f64>,
}

/// The factor. Parameters that are held move with nothing: their rows and columns are those of
/// the unit matrix.
pub struct Factor {
    shape: Shape,
    own: Vec<OwnFactor>,
    /// Of the shared matrix less what the own parameters take.
    shared: Cholesky<f64, Dyn>,
    held: Vec<bool>,
}

impl Factor {
    /// Of the matrix with a diagonal added to it; none where it is not positive definite to
    /// rounding.
    pub fn new(normal: &Normal, added: Option<&DVector<f64>>, held: &[bool]) -> Option<Self> {
        let shape = normal.shape().clone();
        let add = |place: usize| added.map_or(0.0, |d| d[place]);
        let isolate = |matrix: &DMatrix<f64>, first: usize| {
            let mut matrix = matrix.clone();
            for k in 0..matrix.nrows() {
                matrix[(k, k)] += add(first + k);
                if held[first + k] {
                    matrix.row_mut(k).fill(0.0);
                    matrix.column_mut(k).fill(0.0);
                    matrix[(k, k)] = 1.0;
                }
            }
            matrix
        };
        let mut shared = isolate(&normal.information, 0);
        let before = shared.diagonal();
        let mut own = Vec::with_capacity(normal.own.len());
        for (b, part) in normal.own.iter().enumerate() {
            let first = shape.own(b).start;
            let matrix = isolate(&part.information, first);
            let diagonal = matrix.diagonal();
            let lower = positive(matrix, &diagonal)?;
            let mut cross = part.cross.clone();
            (0..cross.nrows())
                .filter(|k| held[first + k])
                .for_each(|k| cross.row_mut(k).fill(0.0));
            (0..cross.ncols())
                .filter(|k| held[*k])
                .for_each(|k| cross.column_mut(k).fill(0.0));
            lower.l_dirty().solve_lower_triangular_mut(&mut cross);
            shared -= cross.transpose() * &cross;
            own.push(OwnFactor { lower, cross });
        }
        Some(Self {
            shared: positive(shared, &before)?,
            own,
            held: held.to_vec(),
            shape,
        })
    }

    /// What the matrix makes this of. Held parameters stay at zero.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut x = right.clone();
        (0..x.len())
            .filter(|k| self.held[*k])
            .for_each(|k| x[k] = 0.0);
        let count = self.shape.shared();
        let mut top = x.rows(0, count).into_owned();
        for (b, own) in self.own.iter().enumerate() {
            let places = self.shape.own(b);
            let mut mine = x.rows_mut(places.start, places.len());
            own.lower.l_dirty().solve_lower_triangular_mut(&mut mine);
            top -= own.cross.tr_mul(&mine);
        }
        self.shared.solve_mut(&mut top);
        for (b, own) in self.own.iter().enumerate() {
            let places = self.shape.own(b);
            let mut mine = x.rows_mut(places.start, places.len());
            mine -= &own.cross * &top;
            own.lower.l_dirty().tr_solve_lower_triangular_mut(&mut mine);
        }
        x.rows_mut(0, count).copy_from(&top);
        x
    }

    /// Half of the logarithm of the determinant; held parameters count nothing.
    pub fn half_log_determinant(&self) -> f64 {
        let log = |c: &Cholesky<f64, Dyn>| c.l_dirty().diagonal().map(f64::ln).sum();
        log(&self.shared) + self.own.iter().map(|own| log(&own.lower)).sum::<f64>()
    }

    /// Inverse, by the shared parameters alone; zero where one is held.
    pub fn shared_covariance(&self) -> DMatrix<f64> {
        let mut inverse = self.shared.inverse();
        for k in (0..inverse.nrows()).filter(|k| self.held[*k]) {
            inverse[(k, k)] = 0.0;
        }
        inverse
    }

    /// The whole inverse; zero where a parameter is held.
    pub fn covariance(&self) -> DMatrix<f64> {
        let total = self.shape.total();
        let shared = self.shared_covariance();
        let mut whole = DMatrix::zeros(total, total);
        whole.view_mut((0, 0), shared.shape()).copy_from(&shared);
        // Change of the own parameters by the shared ones, sign reversed.
        let slopes: Vec<DMatrix<f64>> = self.own.iter().map(OwnFactor::slopes).collect();
        for (b, own) in self.own.iter().enumerate() {
            let first = self.shape.own(b).start;
            let cross = -(&slopes[b] * &shared);
            whole.view_mut((first, 0), cross.shape()).copy_from(&cross);
            whole
                .view_mut((0, first), (cross.ncols(), cross.nrows()))
                .copy_from(&cross.transpose());
            for (c, other) in slopes.iter().enumerate() {
                let mut part = -(&cross * other.transpose());
                if b == c {
                    part += own.lower.inverse();
                }
                let at = (first, self.shape.own(c).start);
                whole.view_mut(at, part.shape()).copy_from(&part);
            }
        }
        for k in (0..total).filter(|k| self.held[*k]) {
            whole.row_mut(k).fill(0.0);
            whole.column_mut(k).fill(0.0);
        }
        whole
    }

    /// Variances of all parameters, linear in the number of blocks; zero where one is held.
    pub fn variances(&self) -> DVector<f64> {
        let shared = self.shared_covariance();
        let mut all = shared.diagonal().as_slice().to_vec();
        for own in &self.own {
            let slopes = own.slopes();
            let by_shared = (&slopes * &shared).component_mul(&slopes).column_sum();
            all.extend((own.lower.inverse().diagonal() + by_shared).iter());
        }
        for (variance, _) in all.iter_mut().zip(&self.held).filter(|(_, held)| **held) {
            *variance = 0.0;
        }
        DVector::from_vec(all)
    }
}

impl OwnFactor {
    fn slopes(&self) -> DMatrix<f64> {
        let mut slopes = self.cross.clone();
        self.lower
            .l_dirty()
            .tr_solve_lower_triangular_mut(&mut slopes);
        slopes
    }
}

/// Cholesky, none where a pivot has lost all its digits: what is left of a diagonal element after
/// `n` subtractions is rounding below `n·ε` of it (N. J. Higham, *Accuracy and Stability of
/// Numerical Algorithms*, 2nd ed., sec. 10.1).
fn positive(matrix: DMatrix<f64>, before: &DVector<f64>) -> Option<Cholesky<f64, Dyn>> {
    let lost = matrix.nrows() as f64 * f64::EPSILON;
    let factor = Cholesky::new(matrix)?;
    let pivots = factor.l_dirty().diagonal();
    let kept = |(pivot, whole): (&f64, &f64)| pivot * pivot > lost * whole;
    pivots.iter().zip(before).all(kept).then_some(factor)
}
