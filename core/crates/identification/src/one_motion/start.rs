//! Where a fit begins: the first cycles of a motion without damping.

use super::readings::Readings;
use crate::routes::finite_amplitude::pendulum_period_ratio;
use gyradius_mechanics::one_angle::effects::{Scales, Swinging};
use gyradius_mechanics::one_angle::{Law, Now, follow};
use std::f64::consts::{PI, TAU};

/// A reading that is smaller than this share of the largest is too near to rest to have a sign.
const SIGNED: f64 = 0.2;
/// A start is looked for in so many periods.
const CYCLES: f64 = 4.0;
/// Share of critical damping where the spectrum shows none that can be.
const ORDINARY_DAMPING: f64 = 0.01;
const MOST_DAMPING: f64 = 0.3;
/// Steps of the bisection for the amplitude.
const BISECTIONS: usize = 50;
/// The widest swing that a start is looked for at, rad: beyond it a pendulum hardly comes back.
const WIDEST_RAD: f64 = 3.1;

impl Start {
    /// Frequency and width.
    pub fn scales(&self) -> Scales {
        Scales {
            omega_rad_s: self.omega_rad_s,
            reach_rad: self.angle_rad.hypot(self.rate_rad_s / self.omega_rad_s),
        }
    }
}

/// A point to begin at.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    /// Frequency, rad/s: the fit counts from here.
    pub omega_rad_s: f64,
    /// Angle, rad, and rate, rad/s, of the first sample.
    pub angle_rad: f64,
    /// The rate.
    pub rate_rad_s: f64,
    /// α, 1/s.
    pub damping_per_s: f64,
    /// κ, where it is fitted.
    pub hardness: f64,
    /// Reading at rest.
    pub rest: f64,
}

/// Points to begin at, by the first cycles and by the strongest line of the spectrum.
pub fn starts(readings: &Readings, knows_law: bool) -> Vec<Start> {
    let mut all = vec![by_line(readings, knows_law)];
    if let Some(cycle) = Cycle::first(readings) {
        all.extend(cycle.starts(readings, knows_law));
    }
    all
}

fn damping_per_s(readings: &Readings, omega_rad_s: f64) -> f64 {
    let seen = -readings.pole.re;
    let can_be = (0.0..MOST_DAMPING * omega_rad_s).contains(&seen);
    if can_be {
        seen
    } else {
        ORDINARY_DAMPING * omega_rad_s
    }
}

fn by_line(readings: &Readings, knows_law: bool) -> Start {
    let omega_rad_s = readings.pole.norm();
    let (angle, rate) = match readings.is_angle {
        true => (readings.line, readings.line * readings.pole),
        false => (readings.line / readings.pole, readings.line),
    };
    Start {
        omega_rad_s,
        angle_rad: angle.re,
        rate_rad_s: rate.re,
        damping_per_s: damping_per_s(readings, omega_rad_s),
        hardness: f64::from(!knows_law),
        rest: 0.0,
    }
}

/// The first cycle: when the readings cross rest, and how far they go.
struct Cycle {
    /// Three crossings, s.
    crossings_s: [f64; 3],
    /// Sign of the readings between the first two.
    sign: f64,
    peak: f64,
    rest: f64,
}

impl Cycle {
    fn first(readings: &Readings) -> Option<Self> {
        let horizon_s = CYCLES * TAU / readings.pole.im;
        let means: Vec<(f64, f64)> = (readings.blocks_to(horizon_s).iter())
            .map(|block| {
                let mean = |of: &[f64]| Readings::mean(block, |i| of[i]);
                (mean(&readings.t_s), mean(&readings.values))
            })
            .collect();
        let low = means.iter().map(|m| m.1).fold(f64::INFINITY, f64::min);
        let high = means.iter().map(|m| m.1).fold(f64::NEG_INFINITY, f64::max);
        let (rest, peak) = (0.5 * (low + high), 0.5 * (high - low));
        let mut crossings = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        for (t, y) in means.iter().map(|(t, y)| (*t, y - rest)) {
            if y.abs() < SIGNED * peak {
                continue;
            }
            if let Some((t0, y0)) = before.filter(|(_, y0)| y0 * y < 0.0) {
                crossings.push((t0 + (t - t0) * y0 / (y0 - y), y.signum()));
            }
            before = Some((t, y));
        }
        let [first, second, third] = crossings.first_chunk()?;
        let within = |t: &f64| (first.0..=third.0).contains(t);
        let sizes = means.iter().filter(|(t, _)| within(t));
        Some(Self {
            crossings_s: [first.0, second.0, third.0],
            sign: first.1,
            peak: sizes.map(|(_, y)| (y - rest).abs()).fold(0.0, f64::max),
            rest,
        })
    }

    fn period_s(&self) -> f64 {
        self.crossings_s[2] - self.crossings_s[0]
    }

    /// As a pendulum, and as a spring where it may be one.
    fn starts(&self, readings: &Readings, knows_law: bool) -> Vec<Start> {
        let mut all = Vec::new();
        if let Some(amplitude) = self.pendulum_rad(readings.is_angle) {
            let ratio = pendulum_period_ratio(amplitude).unwrap_or(1.0);
            let omega_rad_s = TAU * ratio / self.period_s();
            let hardness = f64::from(!knows_law);
            all.extend(self.start(readings, (Law::Pendulum, hardness), amplitude, omega_rad_s));
        }
        if !knows_law {
            let omega_rad_s = TAU / self.period_s();
            let per_rad = if readings.is_angle { 1.0 } else { omega_rad_s };
            let amplitude = self.peak / per_rad;
            all.extend(self.start(readings, (Law::Linear, 0.0), amplitude, omega_rad_s));
        }
        all
    }

    /// The amplitude of a pendulum: the fastest rate is 2 ω sin A/2, the period that of small swings
    /// times the ratio, and their product tells A.
    fn pendulum_rad(&self, is_angle: bool) -> Option<f64> {
        if is_angle {
            return Some(self.peak).filter(|a| *a < PI);
        }
        let product = self.peak * self.period_s() / TAU;
        let of = |a: f64| Some(2.0 * (0.5 * a).sin() * pendulum_period_ratio(a).ok()?);
        if of(WIDEST_RAD)? < product {
            return None;
        }
        let (mut low, mut high) = (0.0, WIDEST_RAD);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            match of(middle)? < product {
                true => low = middle,
                false => high = middle,
            }
        }
        Some(0.5 * (low + high))
    }

    /// From a turning point back to the first sample: without damping the motion is the same forward
    /// and back.
    fn start(
        &self,
        readings: &Readings,
        (law, hardness): (Law, f64),
        amplitude_rad: f64,
        omega_rad_s: f64,
    ) -> Option<Start> {
        // A rate crosses zero where the body turns round, an angle passes rest.
        let [first, second, _] = self.crossings_s;
        let (turned_s, angle) = match readings.is_angle {
            true => (0.5 * (first + second), self.sign * amplitude_rad),
            false => (first, -self.sign * amplitude_rad),
        };
        let free = Swinging {
            law,
            scales: Scales {
                omega_rad_s,
                reach_rad: amplitude_rad,
            },
            omega_rad_s,
            damping_per_s: 0.0,
            effects: vec![],
        };
        let motion = follow(&free, Now::start(angle, 0.0), omega_rad_s, &[turned_s])?;
        let [angle_rad, rate_rad_s] = *motion.first()?;
        Some(Start {
            omega_rad_s,
            angle_rad,
            rate_rad_s: -rate_rad_s,
            damping_per_s: damping_per_s(readings, omega_rad_s),
            hardness,
            rest: if readings.is_angle { self.rest } else { 0.0 },
        })
    }
}
