//! A swing in one angle about a fixed axis, fitted as one motion: at any amplitude, with whatever
//! damps it.
//!
//! θ'' = −ω² f(θ) − 2 α θ' − b |θ'| θ' − c sgn θ', with f the sine of a compound pendulum. Where
//! nobody says how it hangs, f(θ) = θ + κ (sin θ − θ): κ is 0 for a spring, 1 for a pendulum, up to
//! 2 for yaw on two lines, below 0 where the restoring torque hardens. Linear damping, drag that
//! grows with the square of the rate and dry friction are the three that roll decay is told by.
//! What is measured is the period of small undamped swings, 2π/ω.
//!
//! Lines in a spectrum are no start for such a swing: its frequency and the shape of a cycle change
//! as it dies away. It begins with the first cycles, which a law without damping describes, and is
//! led over longer and longer parts of the record.

mod fit;
mod lines;
mod problem;
mod readings;
mod start;
mod summary;

use std::f64::consts::TAU;

use gyradius_mechanics::one_angle::Law;
use gyradius_recording::Quantity;
use gyradius_signal::{AmplitudeLaw, ChannelGroup, FittedMode, residuals};
use num_complex::Complex64;

use crate::chance::SURE;
use crate::findings::{LEAST_DESCRIBED, NOISE_MISMATCH};
pub use fit::{Fitted, fit_from_afar, solve, solve_towards};
pub use lines::Line;
use lines::is_own;
pub use problem::{
    ANGLE, DAMPING, DAMPING_U, DRAG, FREQUENCY, FRICTION, Fitting, HARDNESS_PLACE, Problem, RATE,
    REST, measured,
};
pub use readings::{Readings, Turn, variance};
pub use summary::dispersion;

/// κ of a spring, of a body on a fixed axis that gravity alone brings back, and the most of two lines.
const SPRING: f64 = 0.0;
/// The period grows by A²/16 of itself.
pub const PENDULUM: f64 = 1.0;
const LINES: f64 = 2.0;

/// A swing fitted as one motion.
#[derive(Debug, Clone)]
pub struct OneMotion {
    /// Period of small undamped swings, s.
    pub period_s: Quantity,
    /// Mean period of the record, s.
    pub observed_s: f64,
    /// Widest angle of the first cycle, rad.
    pub amplitude_rad: f64,
    /// Mean rate of decay of the amplitude, 1/s, over the record.
    pub decay_per_s: Quantity,
    /// Its frequencies, rad/s: the lower and the higher of those of its first cycle and of small
    /// swings.
    own_rad_s: [f64; 2],
    /// κ and its standard uncertainty, by this very record.
    pub hardness: Quantity,
    /// α, 1/s, and its standard uncertainty; none where it stands at zero. b and c likewise.
    pub damping_per_s: (f64, Option<f64>),
    /// b, 1/rad.
    pub drag_per_rad: (f64, Option<f64>),
    /// c, rad/s².
    pub friction_rad_s2: (f64, Option<f64>),
    /// Residual over noise.
    pub rms_over_noise: f64,
    /// Whether it describes the turn about as well as the damped oscillations do.
    pub is_described: bool,
    /// Root mean square of what is left, unit of the readings.
    left_rms: f64,
    fitted: Fitted,
}

impl OneMotion {
    /// Of the strongest turn of a record; `None` where no sensor tells the angle or its rate, or
    /// no motion can be fitted. `span_s` is the part by the sensor's clock.
    ///
    /// A pendulum whose period surely does otherwise with the amplitude is none: its law is fitted.
    pub fn of(turn: &Turn, span_s: (f64, f64), is_pendulum: bool) -> Option<Self> {
        let of_mode = |mode| Self::of_mode(turn, span_s, mode, is_pendulum);
        let mut all = turn.strongest().into_iter().filter_map(of_mode);
        let first = all.next()?;
        match first.is_described {
            true => Some(first),
            false => Some(all.find(|motion| motion.is_described).unwrap_or(first)),
        }
    }

    fn of_mode(turn: &Turn, span_s: (f64, f64), mode: usize, is_pendulum: bool) -> Option<Self> {
        let of_law = |law| {
            let readings = Readings::of(turn, span_s, mode)?;
            summary::of(fit_from_afar(readings, law)?)
        };
        let any = of_law(None)?;
        let pendulum = is_pendulum.then(|| of_law(Some(Law::Pendulum)));
        let motion = match pendulum.flatten() {
            Some(pendulum) if !any.is_surely_no_pendulum() => Self {
                hardness: any.hardness,
                ..pendulum
            },
            _ => any,
        };
        // The amplitude is told at the time of those of the spectrum.
        let unseen_s = span_s.0 - turn.found.t_ref_s;
        Some(Self {
            is_described: motion.describes(turn),
            amplitude_rad: motion.amplitude_rad * (motion.decay_per_s.value * unseen_s).exp(),
            ..motion
        })
    }

    /// Whether κ is surely not that of a pendulum.
    fn is_surely_no_pendulum(&self) -> bool {
        (self.hardness.value - PENDULUM).abs() > SURE * self.hardness.u
    }

    /// Whether drag or dry friction surely damps it.
    pub fn is_damped_otherwise(&self) -> bool {
        let is_sure = |(value, u): (f64, Option<f64>)| u.is_some_and(|u| value > SURE * u);
        is_sure(self.drag_per_rad) || is_sure(self.friction_rad_s2)
    }

    /// Place of the mode that it is among those of the spectrum.
    pub fn mode(&self) -> usize {
        self.fitted.readings.mode
    }

    /// As a mode, of the line of the spectrum that it is.
    pub fn as_mode(&self, turn: &Turn) -> FittedMode {
        let line = &turn.found.modes[self.mode()];
        let omega_rad_s = TAU / self.observed_s;
        let alpha_per_s = self.decay_per_s.value;
        let per_rad = if turn.is_angle {
            1.0
        } else {
            omega_rad_s.hypot(alpha_per_s)
        };
        let factor = self.amplitude_rad * per_rad / turn.size(line).max(f64::MIN_POSITIVE);
        let omega_se_rad_s = omega_rad_s * self.period_s.u / self.period_s.value;
        FittedMode {
            omega_rad_s,
            omega_se_rad_s,
            alpha_per_s,
            alpha_se_per_s: self.decay_per_s.u,
            shape: line.shape.iter().map(|c| c * factor).collect(),
            law: AmplitudeLaw {
                omega_small_rad_s: omega_rad_s,
                omega_small_se_rad_s: omega_se_rad_s,
                alpha_small_per_s: alpha_per_s,
                ..AmplitudeLaw::default()
            },
            ..line.clone()
        }
    }

    /// Whether a line of the spectrum is what damped oscillations make of it: it turns about its axis
    /// rather than across it, with one of its frequencies or a multiple.
    pub fn explains(&self, turn: &Turn, line: &FittedMode) -> bool {
        let shape = turn.shape(line);
        let axis = self.fitted.readings.axis.iter();
        let about: Complex64 = shape.iter().zip(axis).map(|(c, a)| c * *a).sum();
        let all: f64 = shape.iter().map(Complex64::norm_sqr).sum();
        let noise = turn.found.noise.iter().take(shape.len());
        // What other sensors saw need not turn at all.
        let is_alone = turn.found.noise.len() == shape.len();
        let is_seen = is_alone || all > noise.map(|n| n * n).sum::<f64>();
        is_seen && about.norm_sqr() > 0.5 * all && is_own(line.omega_rad_s, self.own_rad_s)
    }

    /// What is left of the channels of its sensor.
    pub fn residuals(&self, group: &ChannelGroup) -> Option<ChannelGroup> {
        let readings = &self.fitted.readings;
        let problem = self.fitted.problem();
        let along = problem.at(&self.fitted.fit.x, &group.t_s)?;
        let level_along = readings.axis.dot(&readings.level);
        let channel = |(c, samples): (usize, &Vec<f64>)| {
            // Across the axis the channels read their levels, along it what is fitted.
            let (axis, level) = (readings.axis[c], readings.level[c]);
            let across = level - axis * level_along;
            let pairs = samples.iter().zip(&along);
            pairs.map(|(y, along)| y - across - axis * along).collect()
        };
        Some(ChannelGroup {
            t_s: group.t_s.clone(),
            channels: group.channels.iter().enumerate().map(channel).collect(),
        })
    }

    /// Whether κ may be that of a spring, a pendulum, two lines or between.
    fn is_ordinary(&self) -> bool {
        let Quantity { value, u } = self.hardness;
        value + u >= SPRING && value - u <= LINES
    }

    /// Whether it describes most of the turn about its axis. A law that is not ordinary is believed
    /// where it does so about as well as the damped oscillations, which follow anything if they are
    /// many.
    fn describes(&self, turn: &Turn) -> bool {
        let readings = &self.fitted.readings;
        let lines = residuals(std::slice::from_ref(turn.group), turn.found);
        let Some(group) = lines.first() else {
            return false;
        };
        let (start_s, end_s) = (readings.start_s, readings.start_s + readings.duration_s());
        let used =
            group.t_s.partition_point(|t| *t < start_s)..group.t_s.partition_point(|t| *t <= end_s);
        let along = |i: usize| {
            let channels = group.channels.iter().zip(readings.axis.iter());
            channels.map(|(samples, a)| a * samples[i]).sum::<f64>()
        };
        let count = readings.values.len().max(1) as f64;
        let by_lines = used.map(|i| along(i).powi(2)).sum::<f64>() / count;
        let all = variance(&readings.values);
        let most = NOISE_MISMATCH * by_lines.sqrt().max(readings.spectrum_noise);
        let is_as_good = self.left_rms <= most || self.is_ordinary();
        is_as_good && self.left_rms.powi(2) <= (1.0 - LEAST_DESCRIBED) * all
    }
}
