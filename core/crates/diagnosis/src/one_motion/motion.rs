//! The motion in one angle: Runge and Kutta's rule of order 4, stopped and begun anew wherever the
//! body turns round, where friction and drag change their sense.

use super::causes::{Cause, Now, Scales};
use super::law::Law;

/// Steps in a period: the phase is then right to 5e-8 of itself, (2π/128)⁴/120.
const STEPS: f64 = 128.0;
/// Newton steps to the moment at which the body turns round.
const TURNING: usize = 3;

/// What moves the body.
pub struct Equation<'a> {
    pub law: Law,
    /// Angular frequency of small swings, rad/s, and linear damping α, 1/s.
    pub omega_rad_s: f64,
    pub alpha_per_s: f64,
    /// Causes with their values.
    pub causes: Vec<(&'a Cause, &'a [f64])>,
    pub scales: Scales,
}

/// Rate and acceleration at even times from zero.
pub struct Motion {
    step_s: f64,
    nodes: Vec<[f64; 2]>,
}

impl Motion {
    /// From a start over a duration; `None` where it runs out of the numbers.
    pub fn of(
        equation: &Equation,
        angle_rad: f64,
        rate_rad_s: f64,
        duration_s: f64,
    ) -> Option<Self> {
        let step_s = std::f64::consts::TAU / (equation.scales.omega_rad_s * STEPS);
        let count = (duration_s / step_s).ceil() as usize + 1;
        let sense = if rate_rad_s != 0.0 {
            rate_rad_s.signum()
        } else {
            -angle_rad.signum()
        };
        let mut now = Now {
            t_s: 0.0,
            angle_rad,
            rate_rad_s,
            sense,
            given: 0.0,
        };
        let mut nodes = Vec::with_capacity(count + 1);
        for _ in 0..=count {
            nodes.push([now.rate_rad_s, equation.acceleration(&now)]);
            now = equation.advanced(&now, step_s);
        }
        now.rate_rad_s.is_finite().then_some(Self { step_s, nodes })
    }

    /// Rate at a time within the duration, rad/s.
    pub fn rate_rad_s(&self, t_s: f64) -> f64 {
        let place = (t_s / self.step_s).max(0.0);
        let i = (place as usize).min(self.nodes.len() - 2);
        hermite(
            place - i as f64,
            self.step_s,
            self.nodes[i],
            self.nodes[i + 1],
        )
    }
}

/// The cubic through values and slopes at both ends of a step of length `h`, at the fraction `x` of
/// it.
fn hermite(x: f64, h: f64, [a, slope_a]: [f64; 2], [b, slope_b]: [f64; 2]) -> f64 {
    let (y, x2) = (1.0 - x, x * x);
    let y2 = y * y;
    a * y2 * (1.0 + 2.0 * x) + b * x2 * (1.0 + 2.0 * y) + h * (slope_a * x * y2 - slope_b * x2 * y)
}

impl Equation<'_> {
    fn acceleration(&self, now: &Now) -> f64 {
        let (mut torque, mut inertia) =
            self.law.at(self.omega_rad_s, now.angle_rad, now.rate_rad_s);
        torque -= 2.0 * self.alpha_per_s * now.rate_rad_s;
        for (cause, q) in &self.causes {
            torque += cause.torque(q, &self.scales, now);
            inertia += cause.added_inertia(q, &self.scales, now);
        }
        torque / inertia
    }

    /// A step later; where the body turns round within it, in two parts.
    fn advanced(&self, now: &Now, h: f64) -> Now {
        let whole = self.step(now, h);
        if whole.rate_rad_s * now.sense >= 0.0 {
            return whole;
        }
        let mut part_s = h * now.rate_rad_s / (now.rate_rad_s - whole.rate_rad_s);
        for _ in 0..TURNING {
            let there = self.step(now, part_s);
            part_s = (part_s - there.rate_rad_s / self.acceleration(&there)).clamp(0.0, h);
        }
        let turned = Now {
            rate_rad_s: 0.0,
            sense: -now.sense,
            ..self.step(now, part_s)
        };
        if self.acceleration(&turned) * turned.sense <= 0.0 {
            // Friction holds the body.
            return Now {
                t_s: now.t_s + h,
                ..turned
            };
        }
        self.step(&turned, h - part_s)
    }

    fn step(&self, now: &Now, h: f64) -> Now {
        let moved = |slope: (f64, f64), by: f64| {
            let angle_rad = now.angle_rad + by * slope.0;
            Now {
                t_s: now.t_s + by,
                angle_rad,
                rate_rad_s: now.rate_rad_s + by * slope.1,
                sense: now.sense,
                given: self.given(now, angle_rad),
            }
        };
        let slope = |at: &Now| (at.rate_rad_s, self.acceleration(at));
        let a = slope(now);
        let b = slope(&moved(a, 0.5 * h));
        let c = slope(&moved(b, 0.5 * h));
        let d = slope(&moved(c, h));
        let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * (b + c) + d) / 6.0;
        moved((mean(a.0, b.0, c.0, d.0), mean(a.1, b.1, c.1, d.1)), h)
    }

    /// Dahl's law along a way in one sense: the bearing gives as 1 − exp(−way/θ_s) of what is left.
    fn given(&self, now: &Now, angle_rad: f64) -> f64 {
        let give_rad = self.causes.iter().find_map(|(cause, q)| cause.give_rad(q));
        give_rad.map_or(0.0, |give_rad| {
            let way = (now.sense * (angle_rad - now.angle_rad)).max(0.0);
            now.sense + (now.given - now.sense) * (-way / give_rad).exp()
        })
    }
}
