//! Yaw on two lines: gyradius from period, line length and spacing (eqs. 5, 6), lines that are not
//! parallel included.
//!
//! # Conventions
//! `half_spacing_m` is the paper's d: half the distance between the points on the hull;
//! `top_half_spacing_m` half the distance above. The vertical projection of a line is
//! h = √(l² − (d_t − d_b)²), and l in (5), (6) becomes h, d² becomes d_b d_t. Small amplitude.

use std::f64::consts::TAU;

use super::domain::{positive, result};
use gyradius_base::{Error, Result};

/// Two lines at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lines {
    /// Length of each line, m.
    pub length_m: f64,
    /// Half the distance between the points on the hull, m.
    pub half_spacing_m: f64,
    /// Half the distance between the points above, m.
    pub top_half_spacing_m: f64,
}

impl Lines {
    /// Parallel lines: the same spacing above and below.
    pub fn parallel(length_m: f64, half_spacing_m: f64) -> Self {
        Self {
            length_m,
            half_spacing_m,
            top_half_spacing_m: half_spacing_m,
        }
    }

    /// Vertical distance between the two pairs of points, m.
    pub fn height_m(&self) -> Result<f64> {
        let length = positive("line_length_m", self.length_m)?;
        let bottom = positive("half_spacing_m", self.half_spacing_m)?;
        let top = positive("top_half_spacing_m", self.top_half_spacing_m)?;
        let square = length * length - (top - bottom).powi(2);
        if square <= 0.0 {
            let expected = format!(
                "a length greater than {}, the difference of the half spacings",
                (top - bottom).abs()
            );
            return Err(Error::argument("line_length_m", expected, length));
        }
        Ok(square.sqrt())
    }

    /// √(h / (g d_b d_t)), s/m: period = 2π · gyradius · this.
    pub(super) fn slowness_s_m(&self, gravity_m_s2: f64) -> Result<f64> {
        let gravity = positive("gravity_m_s2", gravity_m_s2)?;
        Ok((self.height_m()? / (gravity * self.half_spacing_m * self.top_half_spacing_m)).sqrt())
    }
}

/// Small-amplitude yaw period, s.
pub fn yaw_period_s(gyradius_m: f64, lines: &Lines, gravity_m_s2: f64) -> Result<f64> {
    let period = TAU * positive("gyradius_m", gyradius_m)? * lines.slowness_s_m(gravity_m_s2)?; // (5)
    result("yaw period", period)
}

/// Yaw gyradius about the vertical through the centre of mass, m.
pub fn yaw_gyradius_m(yaw_period_s: f64, lines: &Lines, gravity_m_s2: f64) -> Result<f64> {
    let gyradius =
        positive("yaw_period_s", yaw_period_s)? / (TAU * lines.slowness_s_m(gravity_m_s2)?); // (6)
    result("yaw gyradius", gyradius)
}
