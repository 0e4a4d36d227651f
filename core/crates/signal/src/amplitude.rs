//! Period and decay of one mode against its amplitude: the mode is fitted window by window through
//! the record.
//!
//! A global fit knows one law for the whole record; windows show what the law really is (a
//! pendulum's 1 + A²/16, drag, dry friction, a shift linear in amplitude that goes on to the
//! smallest swing).

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use super::basis::Model;
use super::compress::{Cells, Clock};
use super::fit::{polish, project_with_curvature};
use super::motion::Motion;
use super::record::FINAL_CELLS;
use super::types::ChannelGroup;

/// A damped oscillation, by its two constants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pole {
    /// Angular frequency, rad/s.
    pub omega_rad_s: f64,
    /// Decay rate, 1/s.
    pub alpha_per_s: f64,
}

/// What is wanted of [`against_amplitude`].
///
/// # Conventions
/// Channels count through the groups in the order given. A window's amplitude is `|Σ_c project_c ·
/// a_c|` with a_c the channel's complex amplitude at the middle of the window: to read an angle
/// from a rate, divide by ω ([`WindowPoint::amplitude_over_omega`]).
#[derive(Debug, Clone)]
pub struct WindowedMode<'a> {
    /// Start and end of the free swing, s.
    pub span_s: (f64, f64),
    /// The mode followed; its frequency and decay are free in each window.
    pub mode: Pole,
    /// Other modes; fixed frequency and decay, free amplitudes.
    pub others: &'a [Pole],
    /// Weights that combine the channels into the mode's coordinate.
    pub project: &'a [Complex64],
}

/// Period and decay in one window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowPoint {
    /// Middle of the window, s.
    pub t_s: f64,
    /// Amplitude there, unit of the projection.
    pub amplitude: f64,
    /// Period, s.
    pub period_s: f64,
    /// Its standard error from the window's own residual, as noise of each channel; the other modes
    /// as given, s.
    pub period_se_s: f64,
    /// Logarithmic decrement per cycle.
    pub decrement: f64,
    /// Its standard error.
    pub decrement_se: f64,
}

impl WindowPoint {
    /// Amplitude of the angle where the projection is an angular rate (of the displacement where it
    /// is a speed).
    pub fn amplitude_over_omega(&self) -> f64 {
        self.amplitude * self.period_s / TAU
    }
}

/// Cycles per window: the fewest that separate a mode from its own drift in frequency and from a
/// slope.
const CYCLES: f64 = 6.0;
/// A neighbour must turn this many times against the mode within a window to be told from it.
const BEATS: f64 = 1.25;
/// A window's period is dropped where its standard error exceeds this share of it.
const WORST_RELATIVE_SE: f64 = 0.02;

/// Most iterations in a window.
const ITERATIONS: usize = 20;

/// Follows a mode through the record in windows that do not overlap.
pub fn against_amplitude(groups: &[ChannelGroup], wanted: &WindowedMode<'_>) -> Vec<WindowPoint> {
    let (start_s, end_s) = wanted.span_s;
    let period_s = TAU / wanted.mode.omega_rad_s;
    let nearest = wanted
        .others
        .iter()
        .map(|o| (o.omega_rad_s - wanted.mode.omega_rad_s).abs())
        .fold(f64::INFINITY, f64::min);
    let apart_s = BEATS * TAU / nearest;
    let wanted_s = (CYCLES * period_s).max(if apart_s.is_finite() { apart_s } else { 0.0 });
    let count = ((end_s - start_s) / wanted_s).floor();
    if !(1.0..1e5).contains(&count) {
        return Vec::new();
    }
    let width_s = (end_s - start_s) / count;
    let mut mode = wanted.mode;
    let mut points = Vec::new();
    for k in 0..count as usize {
        let from_s = start_s + k as f64 * width_s;
        let Some(point) = window(groups, wanted, mode, (from_s, from_s + width_s)) else {
            continue;
        };
        // The next window starts from here: the frequency of a strong swing drifts a long way.
        mode.omega_rad_s = TAU / point.period_s;
        points.push(point);
    }
    points
}

/// Cells of the groups that have enough samples in a window, and the weights of their channels.
struct Cut {
    cells: Vec<Cells>,
    project: Vec<Complex64>,
}

impl Cut {
    fn new(parts: &[ChannelGroup], project: &[Complex64], clock: Clock, model: &Model) -> Self {
        let width = TAU / (FINAL_CELLS * model.highest_omega());
        let mut cut = Self {
            cells: Vec::new(),
            project: Vec::new(),
        };
        let mut weights = project;
        for part in parts {
            let (own, later) = weights.split_at(part.channels.len().min(weights.len()));
            weights = later;
            if part.t_s.len() >= 2 * model.linear() {
                let levels: Vec<f64> = part.channels.iter().map(|c| c[0]).collect();
                cut.cells
                    .push(Cells::gather(part, clock, width).less(&levels));
                cut.project.extend_from_slice(own);
            }
        }
        cut
    }
}

/// A group's samples within the clock's span.
fn part(group: &ChannelGroup, clock: Clock) -> ChannelGroup {
    let first = group.t_s.partition_point(|t| *t < clock.t_ref_s);
    let end = group
        .t_s
        .partition_point(|t| *t < clock.t_ref_s + clock.span_s);
    ChannelGroup {
        t_s: group.t_s[first..end].to_vec(),
        channels: group
            .channels
            .iter()
            .map(|x| x[first..end].to_vec())
            .collect(),
    }
}

/// The mode followed, the others, a straight baseline, and the mode's harmonics where they stand
/// alone.
fn window_model(mode: Pole, wanted: &WindowedMode<'_>, width_s: f64, samples: usize) -> Model {
    let scaled =
        |pole: &Pole| Motion::plain(pole.omega_rad_s * width_s, pole.alpha_per_s * width_s);
    let modes: Vec<Motion> = std::iter::once(&mode)
        .chain(wanted.others)
        .map(scaled)
        .collect();
    let harmonic = |k: i32| {
        let omega = f64::from(k) * modes[0].omega;
        let alone = modes[1..]
            .iter()
            .all(|other| (other.omega - omega).abs() > TAU);
        let multiples = std::iter::once(k)
            .chain(modes[1..].iter().map(|_| 0))
            .collect();
        (alone && omega < 0.25 * PI * samples as f64).then_some(multiples)
    };
    let tones = [2, 3].into_iter().filter_map(harmonic).collect();
    Model {
        modes,
        tones,
        baseline: 2,
    }
}

fn window(
    groups: &[ChannelGroup],
    wanted: &WindowedMode<'_>,
    start: Pole,
    (from_s, to_s): (f64, f64),
) -> Option<WindowPoint> {
    let clock = Clock {
        t_ref_s: from_s,
        span_s: to_s - from_s,
    };
    let parts: Vec<ChannelGroup> = groups.iter().map(|group| part(group, clock)).collect();
    let samples = parts.iter().map(|part| part.t_s.len()).max()?;
    let model = window_model(start, wanted, clock.span_s, samples);
    let cut = Cut::new(&parts, wanted.project, clock, &model);
    let others: Vec<usize> = (2..model.parameter_count()).collect();
    let fit = polish(&model, &cut.cells, ITERATIONS, &others)?;
    let (fit, curvature) = project_with_curvature(&fit.model, &cut.cells)?;
    let covariance = curvature.hessian.fixed_view::<2, 2>(0, 0).try_inverse()?;
    let mode = fit.model.modes[0];
    let period_s = TAU * clock.span_s / mode.omega;
    let together: Complex64 = cut
        .project
        .iter()
        .enumerate()
        .map(|(c, p)| p * fit.amplitude(c, 0))
        .sum();
    let point = WindowPoint {
        t_s: 0.5 * (from_s + to_s),
        amplitude: together.norm() * mode.envelope(0.5),
        period_s,
        period_se_s: period_s * covariance[(0, 0)].sqrt() / mode.omega,
        decrement: TAU * mode.alpha / mode.omega,
        decrement_se: TAU * covariance[(1, 1)].sqrt() / mode.omega,
    };
    // A window that ran away to another line is no window of this mode.
    let omega_rad_s = TAU / period_s;
    let stayed = (omega_rad_s - wanted.mode.omega_rad_s).abs() < 0.2 * wanted.mode.omega_rad_s;
    (stayed && point.period_se_s < WORST_RELATIVE_SE * period_s).then_some(point)
}
