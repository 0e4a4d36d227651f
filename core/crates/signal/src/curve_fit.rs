//! Fitted curves: linear combinations of columns by QR, and what else is fitted to unknown noise.

use gyradius_estimation::Fit;
use nalgebra::{DMatrix, DVector};

/// A fitted curve. The covariance is scaled by the residual variance.
#[derive(Debug, Clone)]
pub(super) struct CurveFit {
    pub(super) parameters: Vec<f64>,
    /// (JᵀJ)⁻¹ · rss / dof.
    pub(super) covariance: DMatrix<f64>,
    /// Residual sum of squares (of weighted residuals where weights were given).
    pub(super) rss: f64,
    pub(super) dof: usize,
}

impl CurveFit {
    /// Standard error of parameter `k`.
    pub(super) fn se(&self, k: usize) -> f64 {
        self.covariance[(k, k)].max(0.0).sqrt()
    }

    /// Bayesian information criterion up to a constant (Schwarz 1978), error variance unknown.
    pub(super) fn bic(&self) -> f64 {
        let n = (self.dof + self.parameters.len()) as f64;
        n * (self.rss.max(f64::MIN_POSITIVE) / n).ln() + self.parameters.len() as f64 * n.ln()
    }
}

/// Weighted straight combination of columns: minimises Σ w² (y − Σ c_k x_k)².
pub(super) fn linear(columns: &[Vec<f64>], y: &[f64], weight: &[f64]) -> Option<CurveFit> {
    let (rows, count) = (y.len(), columns.len());
    if rows <= count || count == 0 {
        return None;
    }
    let matrix = DMatrix::from_fn(rows, count, |r, c| columns[c][r] * weight[r]);
    let right = DVector::from_fn(rows, |r, _| y[r] * weight[r]);
    let inverse = inverse_normal(&matrix)?;
    let parameters = &inverse * matrix.transpose() * &right;
    let rss = (&matrix * &parameters - right).norm_squared();
    Some(finished(
        parameters.iter().copied().collect(),
        inverse,
        rss,
        rows - count,
    ))
}

/// A curve that the solver has found; `None` without degrees of freedom, or where the data do not
/// determine its parameters.
pub(super) fn nonlinear(fit: &Fit, rows: usize) -> Option<CurveFit> {
    let dof = rows.checked_sub(fit.x.len()).filter(|d| *d > 0)?;
    let inverse = fit.covariance().ok()?;
    Some(finished(fit.x.clone(), inverse, fit.chi2, dof))
}

fn finished(parameters: Vec<f64>, inverse: DMatrix<f64>, rss: f64, dof: usize) -> CurveFit {
    CurveFit {
        parameters,
        covariance: inverse * (rss / dof as f64),
        rss,
        dof,
    }
}

/// (MᵀM)⁻¹ by QR: the condition number is not squared.
fn inverse_normal(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let size: Vec<f64> = matrix.column_iter().map(|c| c.norm()).collect();
    if size.iter().any(|s| !s.is_finite() || *s == 0.0) {
        return None;
    }
    let unit = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |r, c| {
        matrix[(r, c)] / size[c]
    });
    let r = unit.qr().r();
    let inverse = r.try_inverse()?;
    let normal = &inverse * inverse.transpose();
    Some(DMatrix::from_fn(size.len(), size.len(), |i, j| {
        normal[(i, j)] / (size[i] * size[j])
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_with_its_textbook_errors() {
        // y = 1 + 2x with residuals +1, −1, −1, +1: slope and intercept stay, s² = 4/2, Σ(x − x̄)²
        // = 5.
        let columns = [vec![1.0; 4], vec![0.0, 1.0, 2.0, 3.0]];
        let fit = linear(&columns, &[2.0, 2.0, 4.0, 8.0], &[1.0; 4]).unwrap();
        assert!((fit.parameters[0] - 1.0).abs() < 1e-12 && (fit.parameters[1] - 2.0).abs() < 1e-12);
        assert!((fit.se(1) - (2.0f64 / 5.0).sqrt()).abs() < 1e-12);
        assert_eq!(fit.dof, 2);
    }

    #[test]
    fn columns_that_do_not_differ_have_no_fit() {
        assert!(linear(&[vec![0.0; 4]], &[1.0; 4], &[1.0; 4]).is_none());
        assert!(linear(&[vec![1.0; 2], vec![1.0; 2]], &[1.0; 2], &[1.0; 2]).is_none());
    }
}
