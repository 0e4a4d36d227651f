//! Compound pendulum: a hull on a fixed horizontal axis (eqs. 22–24), and Lamboley's two heights.
//!
//! # Conventions
//! a is the depth of the centre of mass below the axis; a = l0 + l2, with l0 (`axis_height_m`) the
//! height of the axis above the hull's suspension points and l2 (`cm_depth_m`) the depth of the
//! centre below them.

use std::f64::consts::TAU;

use super::domain::{finite, not_negative, positive, result, root};
use gyradius_base::{Error, Result};

/// Small-amplitude period, s.
pub fn period_s(gyradius_m: f64, axis_to_cm_m: f64, gravity_m_s2: f64) -> Result<f64> {
    let k = not_negative("gyradius_m", gyradius_m)?;
    let a = positive("axis_to_cm_m", axis_to_cm_m)?;
    result(
        "period",
        TAU * ((a * a + k * k) / (a * positive("gravity_m_s2", gravity_m_s2)?)).sqrt(),
    ) // (22)
}

/// Gyradius about the axis through the centre of mass, m.
pub fn gyradius_m(period_s: f64, axis_to_cm_m: f64, gravity_m_s2: f64) -> Result<f64> {
    let a = positive("axis_to_cm_m", axis_to_cm_m)?;
    let reduced = reduced_length_m(period_s, gravity_m_s2)?;
    root("compound-pendulum gyradius", a * (reduced - a)) // (23)
}

/// Length of the simple pendulum of the same period, m.
fn reduced_length_m(period_s: f64, gravity_m_s2: f64) -> Result<f64> {
    Ok(positive("gravity_m_s2", gravity_m_s2)? * (positive("period_s", period_s)? / TAU).powi(2))
}

/// ∂k/∂a (dimensionless) and ∂k/∂T (m/s) of (23).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// ∂k/∂a: zero at a = k.
    pub by_axis_to_cm: f64,
    /// ∂k/∂T, m/s: √(kg/2π²) at a = k (the print after (24) has 4π²).
    pub by_period_m_s: f64,
}

/// Sensitivities of the gyradius.
pub fn slopes(gyradius_m: f64, axis_to_cm_m: f64, gravity_m_s2: f64) -> Result<Slopes> {
    let k = positive("gyradius_m", gyradius_m)?;
    let a = positive("axis_to_cm_m", axis_to_cm_m)?;
    let g = positive("gravity_m_s2", gravity_m_s2)?;
    Ok(Slopes {
        by_axis_to_cm: (k * k - a * a) / (2.0 * k * a), // (24)
        by_period_m_s: (a * g).sqrt() / (TAU * k) * k.hypot(a), // (24)
    })
}

/// One swing of a Lamboley test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeightAndPeriod {
    /// Height of the axis above the hull's suspension points (or any other fixed mark), m.
    pub axis_height_m: f64,
    /// Small-amplitude period, s.
    pub period_s: f64,
}

/// What two heights tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamboley {
    /// Gyradius, m.
    pub gyradius_m: f64,
    /// Centre of mass below the mark that the heights are counted from, m.
    pub cm_depth_m: f64,
}

/// Gyradius and depth from two axis heights: (23) for both, the same k, a₂ = a₁ + Δ.
pub fn lamboley(
    first: HeightAndPeriod,
    second: HeightAndPeriod,
    gravity_m_s2: f64,
) -> Result<Lamboley> {
    let start = finite("axis_height_m", first.axis_height_m)?;
    let rise = finite("axis_height_m", second.axis_height_m)? - start;
    if rise == 0.0 {
        return Err(Error::no_result(
            "Lamboley test",
            "both swings have the same axis height",
        ));
    }
    let reduced = [
        reduced_length_m(first.period_s, gravity_m_s2)?,
        reduced_length_m(second.period_s, gravity_m_s2)?,
    ];
    // c₁ a − a² = c₂ (a + Δ) − (a + Δ)², linear in a = a₁.
    let a = rise * (reduced[1] - rise) / (reduced[0] - reduced[1] + 2.0 * rise);
    if !(a.is_finite() && a > 0.0 && a + rise > 0.0) {
        return Err(Error::no_result(
            "Lamboley test",
            "these heights and periods put the axis below the centre of mass",
        ));
    }
    let gyradius_m = root("Lamboley gyradius", a * (reduced[0] - a))?; // (23)
    Ok(Lamboley {
        gyradius_m,
        cm_depth_m: a - start,
    })
}
