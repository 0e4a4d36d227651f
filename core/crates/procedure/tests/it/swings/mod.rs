//! Swings in closed form, as a phone would feel them: damped turns whose period depends on the
//! amplitude, sway, a touch.
//!
//! Shares nothing with the core. A turn of angle θ(t) = A e^{−αt} cos φ(t) about an axis, with φ' =
//! ω(1 − c A² e^{−2αt}); c = 1/16 is a pendulum's (first order of the elliptic integral), c = 0 a
//! harmonic one's.

use std::f64::consts::TAU;

use rand::{Rng, RngExt};
use rand_distr::{Distribution, StandardNormal};

pub const GRAVITY_M_S2: f64 = 9.81;

/// One damped oscillation.
#[derive(Debug, Clone, Copy)]
pub struct Oscillation {
    pub omega_rad_s: f64,
    pub alpha_per_s: f64,
    pub angle_rad: f64,
    pub phase: f64,
    /// Relative change of the frequency over the square of the angle, taken off.
    pub softening: f64,
}

impl Oscillation {
    /// Angle and its rate, by the closed form and its derivative.
    pub fn at(&self, t_s: f64) -> (f64, f64) {
        let Self {
            omega_rad_s,
            alpha_per_s,
            angle_rad,
            phase,
            softening,
        } = *self;
        let fall = (-alpha_per_s * t_s).exp();
        let soft = omega_rad_s * softening * angle_rad * angle_rad;
        let turned = if alpha_per_s > 0.0 {
            omega_rad_s * t_s - soft * (1.0 - fall * fall) / (2.0 * alpha_per_s) + phase
        } else {
            (omega_rad_s - soft) * t_s + phase
        };
        let rate = omega_rad_s - soft * fall * fall;
        let envelope = angle_rad * fall;
        let angle = envelope * turned.cos();
        (angle, -alpha_per_s * angle - envelope * rate * turned.sin())
    }

    /// Period where the amplitude is gone, s.
    pub fn period_s(&self) -> f64 {
        TAU / self.omega_rad_s
    }
}

/// A hull with a phone on it.
#[derive(Debug, Clone)]
pub struct Scene {
    pub turn: Oscillation,
    /// The lines' angle; the hull does not turn with it.
    pub sway: Option<Oscillation>,
    /// Axis of the turn, direction of sway and of gravity in the phone, unit vectors.
    pub axis: [f64; 3],
    pub across: [f64; 3],
    pub up: [f64; 3],
    pub gyroscope_noise_rad_s: f64,
    pub accelerometer_noise_m_s2: f64,
    pub gyroscope_hz: f64,
    pub accelerometer_hz: f64,
}

impl Scene {
    /// A swing as hulls make it: 2 to 6 s, 3 to 12 degrees, dying in one to ten minutes, on an
    /// ordinary phone.
    pub fn draw(rng: &mut impl Rng) -> Self {
        let period_s = rng.random_range(2.0..6.0);
        let turn = Oscillation {
            omega_rad_s: TAU / period_s,
            alpha_per_s: 1.0 / rng.random_range(80.0..600.0),
            angle_rad: rng.random_range(3.0..12.0_f64).to_radians(),
            phase: TAU * rng.random::<f64>(),
            softening: rng.random_range(0.0..1.0 / 16.0),
        };
        let (axis, across) = frame(rng);
        Self {
            turn,
            sway: None,
            axis,
            across,
            up: axis,
            gyroscope_noise_rad_s: 1e-3 * rng.random_range(0.5..2.0),
            accelerometer_noise_m_s2: 0.02 * rng.random_range(0.5..2.0),
            gyroscope_hz: rng.random_range(95.0..105.0),
            accelerometer_hz: rng.random_range(48.0..52.0),
        }
    }

    /// The same with sway of a share of the turn's angle, its period 10 to 30 % away.
    pub fn with_sway(self, rng: &mut impl Rng, share: f64) -> Self {
        let apart = rng.random_range(0.1..0.3_f64);
        let factor = if rng.random() {
            1.0 + apart
        } else {
            1.0 - apart
        };
        let sway = Oscillation {
            omega_rad_s: self.turn.omega_rad_s * factor,
            alpha_per_s: 1.0 / rng.random_range(80.0..600.0),
            angle_rad: share * self.turn.angle_rad,
            phase: TAU * rng.random::<f64>(),
            softening: 1.0 / 16.0,
        };
        Self {
            sway: Some(sway),
            ..self
        }
    }

    pub fn gyroscope(&self, t_s: f64, rng: &mut impl Rng) -> [f64; 3] {
        let rate = self.turn.at(t_s).1;
        self.axis
            .map(|axis| axis * rate + self.gyroscope_noise_rad_s * normal(rng) + 2e-3)
    }

    pub fn accelerometer(&self, t_s: f64, rng: &mut impl Rng) -> [f64; 3] {
        let lines = self.sway.map_or(0.0, |sway| sway.at(t_s).0);
        let mut felt = [0.0; 3];
        for i in 0..3 {
            let swing = GRAVITY_M_S2 * (self.up[i] + self.across[i] * lines);
            felt[i] = swing + self.accelerometer_noise_m_s2 * normal(rng);
        }
        felt
    }

    /// Stamps (ns) of a sensor over a span, with jitter of a hundredth of the interval.
    pub fn stamps(hz: f64, from_s: f64, to_s: f64, rng: &mut impl Rng) -> Vec<i64> {
        let (first, end) = ((from_s * hz).ceil() as i64, (to_s * hz).ceil() as i64);
        (first..end)
            .map(|i| ((i as f64 + 0.01 * normal(rng)) / hz * 1e9) as i64)
            .collect()
    }
}

pub fn normal(rng: &mut impl Rng) -> f64 {
    StandardNormal.sample(rng)
}

/// Two unit vectors at right angles, of any direction.
fn frame(rng: &mut impl Rng) -> ([f64; 3], [f64; 3]) {
    let axis = unit([normal(rng), normal(rng), normal(rng)]);
    let other = unit([normal(rng), normal(rng), normal(rng)]);
    let along: f64 = (0..3).map(|i| axis[i] * other[i]).sum();
    let mut across = other;
    for i in 0..3 {
        across[i] -= along * axis[i];
    }
    (axis, unit(across))
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}
