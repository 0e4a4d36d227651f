//! How a body swings in one angle without anything that brakes it.

use gyradius_identification::routes::yaw::Lines;

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
    /// `None` where lines so short cannot hang.
    pub fn new(lines: &Lines, gravity_m_s2: f64) -> Option<Self> {
        let rest_m = lines.height_m().ok()?;
        let product_m2 = lines.half_spacing_m * lines.top_half_spacing_m;
        Some(Self {
            product_m2,
            rest_m2: rest_m * rest_m,
            gravity_m_s2,
        })
    }
}

impl Law {
    /// Torque over inertia that brings the body back, rad/s², and the inertia's factor, at an angle
    /// (rad) and a rate (rad/s); ω is the angular frequency of small swings, rad/s.
    pub fn at(&self, omega_rad_s: f64, angle_rad: f64, rate_rad_s: f64) -> (f64, f64) {
        let square = omega_rad_s * omega_rad_s;
        match self {
            Law::Linear => (-square * angle_rad, 1.0),
            Law::Pendulum => (-square * angle_rad.sin(), 1.0),
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
    fn at(&self, square: f64, angle_rad: f64, rate_rad_s: f64) -> (f64, f64) {
        let (sin, cos) = angle_rad.sin_cos();
        // Lines that cross hold nothing: a fit that gets there is far off, and is kept finite.
        let h2 = (self.rest_m2 - 2.0 * self.product_m2 * (1.0 - cos)).max(1e-6 * self.rest_m2);
        let h = h2.sqrt();
        let slope = self.product_m2 * sin / h;
        let bend = self.product_m2 * cos / h + slope * slope / h;
        let k2 = self.gravity_m_s2 * self.product_m2 / (self.rest_m2.sqrt() * square);
        let back = -(self.gravity_m_s2 * slope + slope * bend * rate_rad_s * rate_rad_s) / k2;
        (back, 1.0 + slope * slope / k2)
    }
}
