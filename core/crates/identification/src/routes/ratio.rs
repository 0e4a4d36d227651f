//! The period ratio: sway as the clock that times the yaw (eqs. 7, 8). Length, gravity and buoyancy
//! drop out.
//!
//! # Conventions
//! Parallel lines. With unequal spacings above and below the hull rolls as it sways and (7) no
//! longer holds.

use std::f64::consts::TAU;

use super::domain::{positive, result};
use gyradius_base::Result;

/// Small-amplitude sway period, s: a simple pendulum as long as the lines.
pub fn sway_period_s(line_length_m: f64, gravity_m_s2: f64) -> Result<f64> {
    let length = positive("line_length_m", line_length_m)?;
    result(
        "sway period",
        TAU * (length / positive("gravity_m_s2", gravity_m_s2)?).sqrt(),
    ) // (7)
}

/// Line length that a sway period implies, m.
pub fn line_length_m(sway_period_s: f64, gravity_m_s2: f64) -> Result<f64> {
    let period = positive("sway_period_s", sway_period_s)?;
    result(
        "line length",
        positive("gravity_m_s2", gravity_m_s2)? * (period / TAU).powi(2),
    ) // (7)
}

/// Yaw gyradius, m, from two periods and the half spacing alone.
pub fn yaw_gyradius_m(yaw_period_s: f64, sway_period_s: f64, half_spacing_m: f64) -> Result<f64> {
    let yaw = positive("yaw_period_s", yaw_period_s)?;
    let sway = positive("sway_period_s", sway_period_s)?;
    result(
        "yaw gyradius",
        yaw / sway * positive("half_spacing_m", half_spacing_m)?,
    ) // (8)
}
