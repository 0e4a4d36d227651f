//! The motion in one angle: Runge and Kutta's rule of order 4, stopped and begun anew wherever the
//! body turns round, where friction and drag change their sense.
//!
//! On [`Dual`](crate::Dual) numbers the derivatives are those of the motion itself, the moment at
//! which it turns round among them: there the rate is zero whatever the parameters are, and that
//! moment moves with them.

use crate::real::Real;

/// Steps in a period: the phase is then right to 5e-8 of itself, (2π/128)⁴/120.
const STEPS: f64 = 128.0;
/// Newton steps to the moment at which the body turns round.
const TURNING: usize = 3;

/// The body at a moment.
#[derive(Debug, Clone, Copy)]
pub struct Now<R> {
    /// Time, s.
    pub t_s: f64,
    /// Angle from rest, rad.
    pub angle_rad: R,
    /// Its rate, rad/s.
    pub rate_rad_s: R,
    /// Sense of the motion, 1 or −1.
    pub sense: f64,
    /// How far a bearing has given, 1 where it slides.
    pub given: R,
}

impl<R: Real> Now<R> {
    /// At the start.
    pub fn start(angle_rad: R, rate_rad_s: R) -> Self {
        let (angle, rate) = (angle_rad.value(), rate_rad_s.value());
        let sense = if rate != 0.0 {
            rate.signum()
        } else {
            -angle.signum()
        };
        Self {
            t_s: 0.0,
            angle_rad,
            rate_rad_s,
            sense,
            given: R::zero(),
        }
    }
}

/// What moves the body.
pub trait Torque<R: Real> {
    /// Torque over inertia, rad/s².
    fn acceleration(&self, now: &Now<R>) -> R;

    /// How far a bearing has given at an angle that is reached in one sense.
    fn given(&self, now: &Now<R>, _angle_rad: R) -> R {
        now.given
    }
}

/// Angle and rate at rising times (s, from zero), in steps of a part of the shortest period at ω.
/// `None` where the motion runs out of the numbers.
pub fn follow<R: Real>(
    torque: &impl Torque<R>,
    start: Now<R>,
    omega_rad_s: f64,
    times_s: &[f64],
) -> Option<Vec<[R; 2]>> {
    let mut all = Vec::with_capacity(times_s.len());
    let times = times_s.iter().copied();
    follow_each(torque, start, omega_rad_s, times, |now| all.push(now))?;
    Some(all)
}

/// The same, handed over one by one.
pub fn follow_each<R: Real>(
    torque: &impl Torque<R>,
    start: Now<R>,
    omega_rad_s: f64,
    times_s: impl IntoIterator<Item = f64>,
    mut take: impl FnMut([R; 2]),
) -> Option<()> {
    let step_s = std::f64::consts::TAU / (omega_rad_s * STEPS);
    let mut here = Node::of(torque, start);
    let mut there = Node::of(torque, advanced(torque, &start, step_s));
    let mut count = 0.0;
    for t_s in times_s {
        while t_s > (count + 1.0) * step_s {
            let next = advanced(torque, &there.now, step_s);
            here = std::mem::replace(&mut there, Node::of(torque, next));
            count += 1.0;
            if !there.now.rate_rad_s.value().is_finite() {
                return None;
            }
        }
        let x = (t_s / step_s - count).max(0.0);
        take(here.between(&there, x, step_s));
    }
    Some(())
}

/// A moment with its acceleration.
struct Node<R> {
    now: Now<R>,
    acceleration: R,
}

impl<R: Real> Node<R> {
    fn of(torque: &impl Torque<R>, now: Now<R>) -> Self {
        let acceleration = torque.acceleration(&now);
        Self { now, acceleration }
    }

    /// Angle and rate at the fraction `x` of the step from here to there.
    fn between(&self, there: &Self, x: f64, h: f64) -> [R; 2] {
        let (a, b) = (&self.now, &there.now);
        let angle = [a.angle_rad, a.rate_rad_s, b.angle_rad, b.rate_rad_s];
        let rate = [
            a.rate_rad_s,
            self.acceleration,
            b.rate_rad_s,
            there.acceleration,
        ];
        [hermite(x, h, angle), hermite(x, h, rate)]
    }
}

/// The cubic through values and slopes at both ends of a step of length `h`, at the fraction `x` of
/// it.
fn hermite<R: Real>(x: f64, h: f64, [a, slope_a, b, slope_b]: [R; 4]) -> R {
    let (y, x2) = (1.0 - x, x * x);
    let y2 = y * y;
    let mut sum = a.scale(y2 * (1.0 + 2.0 * x));
    sum.add_scaled(x2 * (1.0 + 2.0 * y), b);
    sum.add_scaled(h * x * y2, slope_a);
    sum.add_scaled(-h * x2 * y, slope_b);
    sum
}

/// A step later; where the body turns round within it, in two parts.
fn advanced<R: Real>(torque: &impl Torque<R>, now: &Now<R>, h: f64) -> Now<R> {
    let later = now.t_s + h;
    let whole = step(torque, now, R::constant(h));
    if whole.rate_rad_s.value() * now.sense >= 0.0 {
        return Now {
            t_s: later,
            ..whole
        };
    }
    let mut part_s = now.rate_rad_s.scale(h) / (now.rate_rad_s - whole.rate_rad_s);
    for _ in 0..TURNING {
        let there = step(torque, now, part_s);
        part_s -= there.rate_rad_s / torque.acceleration(&there);
        if !(0.0..=h).contains(&part_s.value()) {
            part_s = R::constant(part_s.value().clamp(0.0, h));
        }
    }
    let turned = Now {
        rate_rad_s: R::zero(),
        sense: -now.sense,
        ..step(torque, now, part_s)
    };
    if torque.acceleration(&turned).value() * turned.sense <= 0.0 {
        // Friction holds the body.
        return Now {
            t_s: later,
            ..turned
        };
    }
    let rest = step(torque, &turned, R::constant(h) - part_s);
    Now { t_s: later, ..rest }
}

fn step<R: Real>(torque: &impl Torque<R>, now: &Now<R>, h: R) -> Now<R> {
    let moved = |slope: [R; 2], by: R| {
        let angle_rad = now.angle_rad + by * slope[0];
        Now {
            t_s: now.t_s + by.value(),
            angle_rad,
            rate_rad_s: now.rate_rad_s + by * slope[1],
            sense: now.sense,
            given: torque.given(now, angle_rad),
        }
    };
    let slope = |at: &Now<R>| [at.rate_rad_s, torque.acceleration(at)];
    let half = h.scale(0.5);
    let a = slope(now);
    let b = slope(&moved(a, half));
    let c = slope(&moved(b, half));
    let d = slope(&moved(c, h));
    let mean = |k: usize| {
        let mut sum = a[k] + d[k];
        sum.add_scaled(2.0, b[k]);
        sum.add_scaled(2.0, c[k]);
        sum.scale(1.0 / 6.0)
    };
    moved([mean(0), mean(1)], h)
}
