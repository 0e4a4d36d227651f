//! Small least-squares problems: linear by normal equations, nonlinear by Levenberg–Marquardt.

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

/// Minimises the squares of `residuals` from `start`; `scale` is the size of a change that matters
/// of each parameter.
pub(super) fn nonlinear(
    residuals: &dyn Fn(&[f64]) -> Vec<f64>,
    start: &[f64],
    scale: &[f64],
) -> Option<CurveFit> {
    let mut p = start.to_vec();
    let mut r = DVector::from_vec(residuals(&p));
    let mut damping = 1e-3;
    let mut jacobian = slopes(residuals, &p, scale, r.len());
    for _ in 0..60 {
        let step = damped_step(&jacobian, &r, damping)?;
        let tried: Vec<f64> = p
            .iter()
            .zip(scale)
            .zip(step.iter())
            .map(|((p, s), d)| p + s * d)
            .collect();
        let tried_r = DVector::from_vec(residuals(&tried));
        if tried_r.norm_squared() < r.norm_squared() {
            let gained = 1.0 - tried_r.norm_squared() / r.norm_squared();
            (p, r) = (tried, tried_r);
            damping = (damping * 0.1).max(1e-12);
            jacobian = slopes(residuals, &p, scale, r.len());
            if gained < 1e-12 {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e10 {
                break;
            }
        }
    }
    let dof = r.len().checked_sub(p.len()).filter(|d| *d > 0)?;
    let mut inverse = inverse_normal(&jacobian)?;
    for i in 0..p.len() {
        for j in 0..p.len() {
            inverse[(i, j)] *= scale[i] * scale[j];
        }
    }
    let rss = r.norm_squared();
    rss.is_finite().then(|| finished(p, inverse, rss, dof))
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

/// Central differences with respect to each parameter in units of its scale.
fn slopes(
    residuals: &dyn Fn(&[f64]) -> Vec<f64>,
    p: &[f64],
    scale: &[f64],
    rows: usize,
) -> DMatrix<f64> {
    const STEP: f64 = 1e-4;
    let mut jacobian = DMatrix::zeros(rows, p.len());
    for k in 0..p.len() {
        let shifted = |by: f64| {
            let mut q = p.to_vec();
            q[k] += by * scale[k];
            residuals(&q)
        };
        let (up, down) = (shifted(STEP), shifted(-STEP));
        (0..rows).for_each(|r| jacobian[(r, k)] = (up[r] - down[r]) / (2.0 * STEP));
    }
    jacobian
}

fn damped_step(jacobian: &DMatrix<f64>, r: &DVector<f64>, damping: f64) -> Option<DVector<f64>> {
    let mut normal = jacobian.transpose() * jacobian;
    let floor = 1e-12 * normal.trace() + f64::MIN_POSITIVE;
    (0..normal.nrows()).for_each(|k| normal[(k, k)] += damping * normal[(k, k)] + floor);
    normal
        .cholesky()
        .map(|c| -c.solve(&(jacobian.transpose() * r)))
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
    fn an_exponential_is_found_from_afar() {
        let t: Vec<f64> = (0..50).map(|i| i as f64 * 0.1).collect();
        let residuals = |p: &[f64]| {
            t.iter()
                .map(|t| p[0] * (-p[1] * t).exp() - 3.0 * (-0.7 * t).exp())
                .collect()
        };
        let fit = nonlinear(&residuals, &[1.0, 0.1], &[1.0, 0.1]).unwrap();
        assert!((fit.parameters[0] - 3.0).abs() < 1e-6 && (fit.parameters[1] - 0.7).abs() < 1e-6);
    }

    #[test]
    fn columns_that_do_not_differ_have_no_fit() {
        assert!(linear(&[vec![0.0; 4]], &[1.0; 4], &[1.0; 4]).is_none());
        assert!(linear(&[vec![1.0; 2], vec![1.0; 2]], &[1.0; 2], &[1.0; 2]).is_none());
    }
}
