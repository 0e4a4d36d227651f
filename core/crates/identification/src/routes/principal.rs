//! Principal axes in the centre plane: ψ and the principal gyradii (eqs. 3, 4), roll gyradius and ψ
//! from tilted yaw (25, 26), and least squares over three or more tilts.
//!
//! # Conventions
//! Angles φ (hull pitched) and ψ (from the hull's x axis up to the principal x axis) are positive
//! **bow up**; the hull hangs pitched by φ and turns about the vertical. The print's (4) with its φ
//! of −31.1° (bow down) and +22.8° gives ψ = +5.7° and +5.6°, not the −5.5° it states. "Principal
//! x" is the principal axis within 45° of the hull's x. `xz` is the element of the inertia tensor
//! over the mass, −Σ m x z / M, m²: k_φ² = k_xx² sin²φ + k_zz² cos²φ + xz sin 2φ, linear in all
//! three, which is why the fit is linear.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::domain::{between, finite, not_negative, positive, root};
use gyradius_base::frames::{Mat3, Vec3};
use gyradius_base::{Error, Result};
use gyradius_recording::Quantity;

/// Two-sided 95 % point of the normal distribution.
const Z_95: f64 = 1.959_963_984_540_054;

/// Elements of the inertia tensor in the centre plane over the mass, m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentrePlane {
    /// k_xx² (roll).
    pub xx_m2: f64,
    /// k_zz² (yaw).
    pub zz_m2: f64,
    /// Product element.
    pub xz_m2: f64,
}

/// Principal gyradii and the angle of the principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// ψ, rad, bow up.
    pub psi_rad: f64,
    /// k_px, m.
    pub k_px_m: f64,
    /// k_pz, m.
    pub k_pz_m: f64,
}

/// Gyradius about the vertical of a hull pitched by φ, m.
pub fn tilted_gyradius_m(principal: &Principal, pitch_rad: f64) -> Result<f64> {
    let x = not_negative("k_px_m", principal.k_px_m)?;
    let z = positive("k_pz_m", principal.k_pz_m)?;
    let (sin, cos) =
        (finite("pitch_rad", pitch_rad)? + finite("psi_rad", principal.psi_rad)?).sin_cos();
    root("tilted gyradius", (x * sin).powi(2) + (z * cos).powi(2)) // (3), third line
}

/// Hull-axes elements from the principal ones.
pub fn centre_plane(principal: &Principal) -> Result<CentrePlane> {
    let x2 = not_negative("k_px_m", principal.k_px_m)?.powi(2);
    let z2 = not_negative("k_pz_m", principal.k_pz_m)?.powi(2);
    let (sin, cos) = finite("psi_rad", principal.psi_rad)?.sin_cos();
    Ok(CentrePlane {
        xx_m2: x2 * cos * cos + z2 * sin * sin, // (3)
        zz_m2: x2 * sin * sin + z2 * cos * cos, // (3)
        xz_m2: (x2 - z2) * sin * cos,
    })
}

/// Principal gyradii and ψ from the hull-axes elements.
pub fn principal(plane: &CentrePlane) -> Result<Principal> {
    let (half_sum, half_difference) = (
        0.5 * (plane.xx_m2 + plane.zz_m2),
        0.5 * (plane.xx_m2 - plane.zz_m2),
    );
    let radius = half_difference.hypot(plane.xz_m2);
    if !radius.is_finite() || half_difference == 0.0 {
        return Err(Error::no_result(
            "psi",
            "roll and yaw gyradii are equal: the axes have no preferred direction",
        ));
    }
    let psi_rad = 0.5 * (plane.xz_m2 / half_difference).atan(); // (4): tan 2ψ = 2 xz / (xx − zz)
    let radius = radius.copysign(half_difference);
    Ok(Principal {
        psi_rad,
        k_px_m: root("k_px", half_sum + radius)?, // (4), free of its 0/0 at ψ = 45°
        k_pz_m: root("k_pz", half_sum - radius)?, // (4)
    })
}

/// ψ and principal gyradii from roll, yaw and one tilted gyradius.
pub fn from_one_tilt(
    k_roll_m: f64,
    k_yaw_m: f64,
    k_tilted_m: f64,
    pitch_rad: f64,
) -> Result<Principal> {
    let xx_m2 = positive("k_roll_m", k_roll_m)?.powi(2);
    let zz_m2 = positive("k_yaw_m", k_yaw_m)?.powi(2);
    let (sin, cos) = usable_tilt("pitch_rad", pitch_rad)?.sin_cos();
    let excess =
        positive("k_tilted_m", k_tilted_m)?.powi(2) - xx_m2 * sin * sin - zz_m2 * cos * cos;
    principal(&CentrePlane {
        xx_m2,
        zz_m2,
        xz_m2: excess / (2.0 * sin * cos),
    }) // (4)
}

fn usable_tilt(name: &str, pitch_rad: f64) -> Result<f64> {
    if between(name, pitch_rad, -FRAC_PI_2, FRAC_PI_2)? == 0.0 {
        return Err(Error::no_result(
            name,
            "a level hull says nothing about the other axes",
        ));
    }
    Ok(pitch_rad)
}

/// Roll gyradius from yaw level and at two tilts, m.
pub fn roll_gyradius_m(k_yaw_m: f64, tilt_a: (f64, f64), tilt_b: (f64, f64)) -> Result<f64> {
    let yaw2 = positive("k_yaw_m", k_yaw_m)?.powi(2);
    let (a2, b2) = (
        positive("k_a_m", tilt_a.0)?.powi(2),
        positive("k_b_m", tilt_b.0)?.powi(2),
    );
    let (a, b) = (
        usable_tilt("pitch_a_rad", tilt_a.1)?,
        usable_tilt("pitch_b_rad", tilt_b.1)?,
    );
    if a == b {
        return Err(Error::no_result(
            "roll gyradius",
            "the two tilts are the same",
        ));
    }
    let tilted =
        (a2 * (2.0 * b).sin() - b2 * (2.0 * a).sin()) / (2.0 * (a - b).sin() * a.sin() * b.sin());
    root("roll gyradius", tilted + yaw2 / (a.tan() * b.tan())) // (25)
}

/// (25) where the tilts stand a right angle apart, φ_A = φ_B + π/2.
pub fn roll_gyradius_right_angle_m(k_yaw_m: f64, k_a_m: f64, k_b_m: f64) -> Result<f64> {
    let (yaw, a, b) = (
        positive("k_yaw_m", k_yaw_m)?,
        positive("k_a_m", k_a_m)?,
        positive("k_b_m", k_b_m)?,
    );
    root("roll gyradius", a * a + b * b - yaw * yaw) // (26)
}

/// A yaw gyradius measured with the hull pitched; the roll gyradius is the tilt of π/2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Pitch, rad, bow up.
    pub pitch_rad: Quantity,
    /// Gyradius about the vertical, m.
    pub gyradius_m: Quantity,
}

/// Least-squares result over tilts, with its covariance.
#[derive(Debug, Clone, PartialEq)]
pub struct TiltFit {
    /// The elements.
    pub plane: CentrePlane,
    /// Their covariance, m⁴, order (xx, zz, xz).
    pub covariance_m4: Mat3,
    /// Principal gyradii and ψ.
    pub principal: Principal,
    /// Standard uncertainty of ψ by first order, rad.
    pub psi_u_rad: f64,
    /// 95 % interval of ψ, rad (Fieller's: it does not rely on first order, and is −45°…45° where ψ
    /// is not determined).
    pub psi_interval_95_rad: [f64; 2],
    /// Standard uncertainty of k_px and k_pz, m.
    pub k_px_u_m: f64,
    /// Standard uncertainty of k_pz, m.
    pub k_pz_u_m: f64,
    /// Roll gyradius k_xx = √xx and its standard uncertainty, m.
    pub k_roll_m: Quantity,
    /// Yaw gyradius k_zz = √zz, m.
    pub k_yaw_m: Quantity,
    /// Weighted sum of squared residuals.
    pub chi_squared: f64,
    /// Tilts less three.
    pub degrees_of_freedom: usize,
}

/// ψ, principal, roll and yaw gyradii from three or more tilts (level and π/2 = roll included among
/// them).
///
/// Every gyradius needs u > 0: the weights come from them and from the u of the angles.
/// `common_relative_u` is the relative standard uncertainty that all gyradii share (spacing,
/// clock): it scales the tensor and leaves ψ alone.
pub fn fit_tilts(tilts: &[Tilt], common_relative_u: f64) -> Result<TiltFit> {
    check(tilts)?;
    let common = not_negative("common_relative_u", common_relative_u)?;
    let mut plane = CentrePlane {
        xx_m2: 0.0,
        zz_m2: 0.0,
        xz_m2: 0.0,
    };
    let mut covariance = Mat3::zeros();
    // The weight of a tilt depends, through the u of its angle, on the answer: three rounds settle
    // it.
    for round in 0..4 {
        (plane, covariance) = weighted_fit(tilts, (round > 0).then_some(&plane))?;
    }
    let chi_squared = tilts
        .iter()
        .map(|tilt| misfit(tilt, &plane).powi(2) / variance(tilt, Some(&plane)))
        .sum();
    let solution = Vec3::new(plane.xx_m2, plane.zz_m2, plane.xz_m2);
    covariance += solution * solution.transpose() * (2.0 * common).powi(2);
    describe(plane, covariance, chi_squared, tilts.len() - 3)
}

fn check(tilts: &[Tilt]) -> Result<()> {
    if tilts.len() < 3 {
        return Err(Error::no_result(
            "tilted yaw",
            format!("three tilts are needed, found {}", tilts.len()),
        ));
    }
    for tilt in tilts {
        finite("pitch_rad", tilt.pitch_rad.value)?;
        not_negative("pitch_rad.u", tilt.pitch_rad.u)?;
        positive("gyradius_m", tilt.gyradius_m.value)?;
        positive("gyradius_m.u", tilt.gyradius_m.u)?;
    }
    Ok(())
}

fn design(pitch_rad: f64) -> Vec3 {
    let (sin, cos) = pitch_rad.sin_cos();
    Vec3::new(sin * sin, cos * cos, 2.0 * sin * cos) // (3) written in hull axes
}

fn misfit(tilt: &Tilt, plane: &CentrePlane) -> f64 {
    let solution = Vec3::new(plane.xx_m2, plane.zz_m2, plane.xz_m2);
    tilt.gyradius_m.value.powi(2) - design(tilt.pitch_rad.value).dot(&solution)
}

/// Variance of k², the angle's share included, m⁴.
fn variance(tilt: &Tilt, plane: Option<&CentrePlane>) -> f64 {
    let own = (2.0 * tilt.gyradius_m.value * tilt.gyradius_m.u).powi(2);
    let slope = plane.map_or(0.0, |p| {
        let (sin2, cos2) = (2.0 * tilt.pitch_rad.value).sin_cos();
        (p.xx_m2 - p.zz_m2) * sin2 + 2.0 * p.xz_m2 * cos2
    });
    own + (slope * tilt.pitch_rad.u).powi(2)
}

fn weighted_fit(tilts: &[Tilt], before: Option<&CentrePlane>) -> Result<(CentrePlane, Mat3)> {
    let (mut normal, mut right) = (Mat3::zeros(), Vec3::zeros());
    for tilt in tilts {
        let (row, weight) = (design(tilt.pitch_rad.value), 1.0 / variance(tilt, before));
        normal += row * row.transpose() * weight;
        right += row * (tilt.gyradius_m.value.powi(2) * weight);
    }
    let alike = || {
        Error::no_result(
            "tilted yaw",
            "fewer than three different tilts: the centre plane is not determined",
        )
    };
    // Conditioned on a scale-free matrix, so that the verdict does not depend on units.
    let scale = normal.trace() / 3.0;
    if (normal / scale).determinant().abs() < 1e-13 {
        return Err(alike());
    }
    let covariance = normal.try_inverse().ok_or_else(alike)?;
    let solution = covariance * right;
    Ok((
        CentrePlane {
            xx_m2: solution[0],
            zz_m2: solution[1],
            xz_m2: solution[2],
        },
        covariance,
    ))
}

fn describe(
    plane: CentrePlane,
    covariance_m4: Mat3,
    chi_squared: f64,
    degrees_of_freedom: usize,
) -> Result<TiltFit> {
    let axes = principal(&plane)?;
    let spread = |gradient: Vec3| gradient.dot(&(covariance_m4 * gradient)).max(0.0).sqrt();
    let (sin, cos) = axes.psi_rad.sin_cos();
    let along_x = Vec3::new(cos * cos, sin * sin, 2.0 * sin * cos); // ∂k_px²/∂(xx, zz, xz)
    let along_z = Vec3::new(sin * sin, cos * cos, -2.0 * sin * cos);
    let (sin2, cos2) = (2.0 * axes.psi_rad).sin_cos();
    let gap = axes.k_px_m.powi(2) - axes.k_pz_m.powi(2);
    let turning = Vec3::new(-sin2, sin2, 2.0 * cos2) / (2.0 * gap); // ∂ψ/∂(xx, zz, xz)
    let k_roll = root("roll gyradius", plane.xx_m2)?;
    let k_yaw = root("yaw gyradius", plane.zz_m2)?;
    Ok(TiltFit {
        plane,
        principal: axes,
        psi_u_rad: spread(turning),
        psi_interval_95_rad: psi_interval(&plane, &covariance_m4),
        k_px_u_m: spread(along_x) / (2.0 * axes.k_px_m),
        k_pz_u_m: spread(along_z) / (2.0 * axes.k_pz_m),
        k_roll_m: Quantity::new(k_roll, covariance_m4[(0, 0)].sqrt() / (2.0 * k_roll)),
        k_yaw_m: Quantity::new(k_yaw, covariance_m4[(1, 1)].sqrt() / (2.0 * k_yaw)),
        covariance_m4,
        chi_squared,
        degrees_of_freedom,
    })
}

/// Fieller's interval of tan 2ψ = N/D with N = 2 xz, D = xx − zz: all R with (N − R D)² ≤ z² var(N
/// − R D).
fn psi_interval(plane: &CentrePlane, covariance: &Mat3) -> [f64; 2] {
    let (n, d) = (Vec3::new(0.0, 0.0, 2.0), Vec3::new(1.0, -1.0, 0.0));
    let solution = Vec3::new(plane.xx_m2, plane.zz_m2, plane.xz_m2);
    let z2 = Z_95 * Z_95;
    let square = d.dot(&solution).powi(2) - z2 * d.dot(&(covariance * d));
    let cross = n.dot(&solution) * d.dot(&solution) - z2 * n.dot(&(covariance * d));
    let constant = n.dot(&solution).powi(2) - z2 * n.dot(&(covariance * n));
    let inside = cross * cross - square * constant;
    if square <= 0.0 || inside < 0.0 {
        return [-FRAC_PI_4, FRAC_PI_4]; // roll and yaw cannot be told apart: no direction is excluded
    }
    let angle = |r: f64| 0.5 * r.atan();
    [
        angle((cross - inside.sqrt()) / square),
        angle((cross + inside.sqrt()) / square),
    ]
}
