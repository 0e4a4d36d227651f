//! What moves the body.

use gyradius_mechanics::Real;
use gyradius_mechanics::one_angle::{Law, Now, Torque, follow, follow_each};

/// What brings the body back, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Restoring {
    /// A law with nothing left open.
    Known(Law),
    /// Between a spring and more than a pendulum: κ is fitted.
    Unknown,
}

/// Places of the numbers of the motion among all that is fitted: angle and rate at the start, the
/// logarithm of the frequency over that of the start, α, b, c, κ.
pub const ANGLE: usize = 0;
pub const RATE: usize = 1;
pub const FREQUENCY: usize = 2;
pub const DAMPING: usize = 3;
pub const DRAG: usize = 4;
pub const FRICTION: usize = 5;
pub const HARDNESS: usize = 6;
/// How many they are.
pub const OF_MOTION: usize = 7;

/// The torque over inertia.
pub struct Base<R> {
    restoring: Restoring,
    omega_rad_s: R,
    numbers: [R; OF_MOTION],
}

impl<R: Real> Base<R> {
    /// Of the numbers of the motion, about a frequency of the start, rad/s.
    pub fn new(restoring: Restoring, omega_rad_s: f64, numbers: [R; OF_MOTION]) -> Self {
        let omega_rad_s = numbers[FREQUENCY].exp().scale(omega_rad_s);
        Self {
            restoring,
            omega_rad_s,
            numbers,
        }
    }

    /// Angle and rate at rising times from zero; `None` where it runs out of the numbers.
    pub fn motion(&self, times_s: &[f64]) -> Option<Vec<[R; 2]>> {
        let start = Now::start(self.numbers[ANGLE], self.numbers[RATE]);
        follow(self, start, self.omega_rad_s.value(), times_s)
    }

    /// The same, handed over one by one.
    pub fn each(
        &self,
        times_s: impl IntoIterator<Item = f64>,
        take: impl FnMut([R; 2]),
    ) -> Option<()> {
        let start = Now::start(self.numbers[ANGLE], self.numbers[RATE]);
        follow_each(self, start, self.omega_rad_s.value(), times_s, take)
    }
}

impl<R: Real> Torque<R> for Base<R> {
    fn acceleration(&self, now: &Now<R>) -> R {
        let (angle, rate) = (now.angle_rad, now.rate_rad_s);
        let (mut torque, inertia) = match self.restoring {
            Restoring::Known(law) => law.at(self.omega_rad_s, angle, rate),
            Restoring::Unknown => {
                let bent = angle + self.numbers[HARDNESS] * (angle.sin() - angle);
                (-(self.omega_rad_s * self.omega_rad_s) * bent, R::one())
            }
        };
        torque -= (self.numbers[DAMPING] * rate).scale(2.0);
        torque.add_scaled(-now.sense, self.numbers[DRAG] * rate * rate);
        torque.add_scaled(-now.sense, self.numbers[FRICTION]);
        torque / inertia
    }
}
