//! Ellipsoids that stand for a hull (Fig. 1): the homogeneous one of the same mass and inertia, and
//! the inertia ellipsoid.
//!
//! # Conventions
//! Gyradii about, and semi-axes along, the principal x, y, z.

use super::domain::{positive, root};
use gyradius_base::Result;

/// Semi-axes of the homogeneous ellipsoid with these gyradii, m: k_x² = (b² + c²)/5, so a² = 5/2
/// (k_y² + k_z² − k_x²).
///
/// # Errors
/// Gyradii that no body can have (one square greater than the sum of the other two) have no such
/// ellipsoid.
pub fn equivalent_semi_axes_m(gyradii_m: [f64; 3]) -> Result<[f64; 3]> {
    let [x2, y2, z2] = squares(gyradii_m)?;
    let semi_axis = |along: f64| {
        root(
            "semi-axis of the equivalent ellipsoid",
            2.5 * (x2 + y2 + z2 - 2.0 * along),
        )
    };
    Ok([semi_axis(x2)?, semi_axis(y2)?, semi_axis(z2)?])
}

/// Gyradii of a homogeneous ellipsoid, m.
pub fn gyradii_of_ellipsoid_m(semi_axes_m: [f64; 3]) -> Result<[f64; 3]> {
    let [a2, b2, c2] = squares(semi_axes_m)?;
    Ok([
        ((b2 + c2) / 5.0).sqrt(),
        ((a2 + c2) / 5.0).sqrt(),
        ((a2 + b2) / 5.0).sqrt(),
    ])
}

/// Semi-axes 1/√I of Poinsot's inertia ellipsoid for a mass, kg^(−1/2) m^(−1): the distance to its
/// surface along any direction is 1/√I about that direction.
pub fn inertia_ellipsoid_semi_axes(mass_kg: f64, gyradii_m: [f64; 3]) -> Result<[f64; 3]> {
    let mass = positive("mass_kg", mass_kg)?;
    Ok(squares(gyradii_m)?.map(|k2| 1.0 / (mass * k2).sqrt()))
}

fn squares(lengths_m: [f64; 3]) -> Result<[f64; 3]> {
    let [x, y, z] = lengths_m;
    Ok([
        positive("x_m", x)?.powi(2),
        positive("y_m", y)?.powi(2),
        positive("z_m", z)?.powi(2),
    ])
}
