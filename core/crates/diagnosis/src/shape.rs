//! How a mode turns the phone.

use std::ops::Range;

use nalgebra::Matrix3;
use num_complex::Complex64;

use gyradius_base::frames::Vec3;
use gyradius_signal::FittedMode;

/// The readings that a mode's shape has in the gyroscope, 0 beyond the axes that there are; `None`
/// without any.
pub fn shape(mode: &FittedMode, rates: &Range<usize>) -> Option<[Complex64; 3]> {
    let seen = mode.shape.get(rates.clone())?;
    seen.first()?;
    let axis = |k: usize| seen.get(k).copied().unwrap_or_default();
    Some([0, 1, 2].map(axis))
}

/// How strong a shape is, squared.
pub fn energy(shape: &[Complex64; 3]) -> f64 {
    shape.iter().map(Complex64::norm_sqr).sum()
}

/// The direction along which a shape moves most.
pub fn direction(shape: &[Complex64; 3]) -> Vec3 {
    let (re, im) = (
        Vec3::from_fn(|k, _| shape[k].re),
        Vec3::from_fn(|k, _| shape[k].im),
    );
    let matrix: Matrix3<f64> = re * re.transpose() + im * im.transpose();
    let eigen = matrix.symmetric_eigen();
    let most = eigen.eigenvalues.imax();
    eigen.eigenvectors.column(most).into_owned()
}
