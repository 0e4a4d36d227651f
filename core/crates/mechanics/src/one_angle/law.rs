//! How a body swings in one angle without anything that brakes it.

use crate::real::Real;

/// What brings the body back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// In proportion to the angle.
    Linear,
    /// A compound pendulum: with the sine of the angle.
    Pendulum,
    /// Yaw on two lines, the heave that goes with it included.
    TwoLines(TwoLines),
}

/// Two lines and gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoLines {
    /// Product d_b d_t of the half spacings, m².
    product_m2: f64,
    /// Square of the vertical distance of the points at rest, m².
    rest_m2: f64,
    gravity_m_s2: f64,
}

impl TwoLines {
    /// Of half spacings below and above, the vertical distance of their points at rest, and gravity.
    pub fn new(half_spacings_m: [f64; 2], height_m: f64, gravity_m_s2: f64) -> Self {
        Self {
            product_m2: half_spacings_m[0] * half_spacings_m[1],
            rest_m2: height_m * height_m,
            gravity_m_s2,
        }
    }
}

impl Law {
    /// Torque over inertia that brings the body back, rad/s², and the inertia's factor, at an angle
    /// (rad) and a rate (rad/s); ω is the angular frequency of small swings, rad/s.
    pub fn at<R: Real>(&self, omega_rad_s: R, angle_rad: R, rate_rad_s: R) -> (R, R) {
        let square = omega_rad_s * omega_rad_s;
        match self {
            Law::Linear => (-square * angle_rad, R::one()),
            Law::Pendulum => (-square * angle_rad.sin(), R::one()),
            Law::TwoLines(lines) => lines.at(square, angle_rad, rate_rad_s),
        }
    }

    /// Whether the period tells how wide the body swings.
    pub fn knows_the_angle(&self) -> bool {
        *self != Law::Linear
    }
}

impl TwoLines {
    /// From the energy (k² + z'²) θ'²/2 + g z(θ) with h² = h₀² − 2 d_b d_t (1 − cos θ), z = h₀ − h;
    /// k² = g d_b d_t/(h₀ ω²), eq. (5).
    fn at<R: Real>(&self, square: R, angle_rad: R, rate_rad_s: R) -> (R, R) {
        let (sin, cos) = (angle_rad.sin(), angle_rad.cos());
        let rest = R::constant(self.rest_m2);
        let h2 = rest - (R::one() - cos).scale(2.0 * self.product_m2);
        // Lines that cross hold nothing: a fit that gets there is far off, and is kept finite.
        let least = 1e-6 * self.rest_m2;
        let h2 = if h2.value() > least {
            h2
        } else {
            R::constant(least)
        };
        let h = h2.sqrt();
        let slope = sin.scale(self.product_m2) / h;
        let bend = cos.scale(self.product_m2) / h + slope * slope / h;
        let of_one = self.gravity_m_s2 * self.product_m2 / self.rest_m2.sqrt();
        let k2 = R::constant(of_one) / square;
        let back = slope.scale(self.gravity_m_s2) + slope * bend * rate_rad_s * rate_rad_s;
        (-back / k2, R::one() + slope * slope / k2)
    }
}
