//! Periods at finite amplitude by the exact laws, and back to the small-amplitude limit.
//!
//! The pendulum's by the arithmetic–geometric mean. Pure yaw on two lines by quadrature of its
//! energy (k² + z'²) θ'²/2 + g z(θ) = g z(A), the heave's kinetic energy z'² θ'²/2 included, which
//! (5) leaves out; there is no damping in either.
//!
//! # Conventions
//! Amplitudes in rad from rest to the turning point. Lines as in [`super::yaw`].

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::domain::{between, positive, result};
use super::yaw::{Lines, yaw_period_s};
use gyradius_base::{Error, Result};

/// Relative change at which the quadrature stops. It converges geometrically, so what is left is
/// far below it.
const QUADRATURE: f64 = 1e-13;
/// Relative step at which the secant stops: the error left is of the order of the product of the
/// last two.
const SECANT: f64 = 1e-10;

/// Period of a pendulum of amplitude A over its small-amplitude period: 1 / agm(1, cos A/2).
pub fn pendulum_period_ratio(amplitude_rad: f64) -> Result<f64> {
    let amplitude = between("amplitude_rad", amplitude_rad, -PI, PI)?;
    let (mut a, mut g) = (1.0_f64, (0.5 * amplitude).cos());
    while (a - g).abs() > 4.0 * f64::EPSILON * a {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    result("pendulum period", 2.0 / (a + g))
}

/// Small-amplitude period of a pendulum (sway; a compound pendulum alike), s.
pub fn pendulum_small_period_s(period_s: f64, amplitude_rad: f64) -> Result<f64> {
    Ok(positive("period_s", period_s)? / pendulum_period_ratio(amplitude_rad)?)
}

/// Yaw period at amplitude A, s.
pub fn yaw_period_at_amplitude_s(
    gyradius_m: f64,
    lines: &Lines,
    gravity_m_s2: f64,
    amplitude_rad: f64,
) -> Result<f64> {
    let k = positive("gyradius_m", gyradius_m)?;
    let g = positive("gravity_m_s2", gravity_m_s2)?;
    let turn = Turn::new(lines, amplitude_rad)?;
    let mut points = 8_u32;
    let mut before = turn.period_s(k, g, points);
    while points < 1 << 16 {
        points *= 2;
        let now = turn.period_s(k, g, points);
        if (now - before).abs() <= QUADRATURE * now {
            return result("yaw period", now);
        }
        before = now;
    }
    Err(Error::no_result(
        "yaw period at this amplitude",
        "the quadrature does not settle: the lines come near to crossing",
    ))
}

/// Yaw gyradius from the period at amplitude A, m.
pub fn yaw_gyradius_at_amplitude_m(
    period_s: f64,
    lines: &Lines,
    gravity_m_s2: f64,
    amplitude_rad: f64,
) -> Result<f64> {
    let period = positive("period_s", period_s)?;
    let unit = yaw_period_s(1.0, lines, gravity_m_s2)?;
    let excess = |k: f64| {
        Ok::<f64, Error>(yaw_period_at_amplitude_s(k, lines, gravity_m_s2, amplitude_rad)? - period)
    };
    // The period grows with k, and at finite amplitude faster than (5): the gyradius of (6) is too
    // large, and by no more than the heave's share; secant steps from there converge in a few
    // rounds.
    let mut high = period / unit;
    let mut low = 0.9 * high;
    let (mut at_low, mut at_high) = (excess(low)?, excess(high)?);
    for _ in 0..60 {
        if at_high == at_low || (high - low).abs() <= SECANT * high.abs() {
            return result("yaw gyradius", high);
        }
        let next = high - at_high * (high - low) / (at_high - at_low);
        if !(next.is_finite() && next > 0.0) {
            break;
        }
        (low, at_low) = (high, at_high);
        high = next;
        at_high = excess(high)?;
    }
    Err(Error::no_result(
        "yaw gyradius",
        "so short a period is not possible on these lines at this amplitude",
    ))
}

/// Small-amplitude yaw period from the period at amplitude A, s.
pub fn yaw_small_period_s(
    period_s: f64,
    lines: &Lines,
    gravity_m_s2: f64,
    amplitude_rad: f64,
) -> Result<f64> {
    yaw_period_s(
        yaw_gyradius_at_amplitude_m(period_s, lines, gravity_m_s2, amplitude_rad)?,
        lines,
        gravity_m_s2,
    )
}

/// Geometry of one turn.
struct Turn {
    /// d_b d_t, m².
    product_m2: f64,
    /// h² at rest, m².
    rest_m2: f64,
    /// sin A/2.
    half_sin: f64,
}

impl Turn {
    fn new(lines: &Lines, amplitude_rad: f64) -> Result<Self> {
        let rest_m2 = lines.height_m()?.powi(2);
        let product_m2 = lines.half_spacing_m * lines.top_half_spacing_m;
        let half_sin = (0.5 * between("amplitude_rad", amplitude_rad, -PI, PI)?).sin();
        if rest_m2 <= 4.0 * product_m2 * half_sin * half_sin {
            return Err(Error::argument(
                "amplitude_rad",
                "an amplitude that these lines can reach",
                amplitude_rad,
            ));
        }
        Ok(Self {
            product_m2,
            rest_m2,
            half_sin,
        })
    }

    /// h(θ), m, from sin θ/2: h² = h0² − 4 d_b d_t sin²(θ/2).
    fn height_m(&self, half_sin: f64) -> f64 {
        (self.rest_m2 - 4.0 * self.product_m2 * half_sin * half_sin).sqrt()
    }

    /// With sin θ/2 = sin A/2 · sin u the quarter period has a smooth, periodic integrand, for
    /// which the mid-point rule converges faster than any power of the number of points.
    fn period_s(&self, k: f64, g: f64, points: u32) -> f64 {
        let turning = self.height_m(self.half_sin);
        let sum: f64 = (0..points)
            .map(|i| {
                let u = FRAC_PI_2 * (f64::from(i) + 0.5) / f64::from(points);
                let sin = self.half_sin * u.sin();
                let cos2 = 1.0 - sin * sin;
                let height = self.height_m(sin);
                let heave2 = (2.0 * self.product_m2 * sin / height).powi(2) * cos2; // z'² = (d_b d_t sin θ / h)²
                ((k * k + heave2) * (height + turning) / (2.0 * g * self.product_m2 * cos2)).sqrt()
            })
            .sum();
        TAU * sum / f64::from(points)
    }
}
