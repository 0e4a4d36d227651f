//! Period and decay of one mode against its amplitude: the mode is fitted window by window through the record.
//!
//! A global fit knows one law for the whole record; windows show what the law really is (a pendulum's 1 + A²/16,
//! drag, dry friction, a shift linear in amplitude that goes on to the smallest swing).

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::marquardt::nonlinear;
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
/// Channels count through the groups in the order given. A window's amplitude is `|Σ_c project_c · a_c|` with a_c the
/// channel's complex amplitude at the middle of the window: to read an angle from a rate, divide by ω
/// ([`WindowPoint::amplitude_over_omega`]).
#[derive(Debug, Clone)]
pub struct WindowedMode<'a> {
    /// Start and end of the free swing, s.
    pub span_s: (f64, f64),
    /// The mode followed; its frequency and decay are free in each window.
    pub mode: Pole,
    /// Other modes; fixed frequency and decay, free amplitudes.
    pub others: &'a [Pole],
    /// Noise of each channel, channel unit.
    pub noise: &'a [f64],
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
    /// Its standard error from the window's own residual, s.
    pub period_se_s: f64,
    /// Logarithmic decrement per cycle.
    pub decrement: f64,
    /// Its standard error.
    pub decrement_se: f64,
}

impl WindowPoint {
    /// Amplitude of the angle where the projection is an angular rate (of the displacement where it is a speed).
    pub fn amplitude_over_omega(&self) -> f64 {
        self.amplitude * self.period_s / std::f64::consts::TAU
    }
}

/// Cycles per window: the fewest that separate a mode from its own drift in frequency and from a slope.
const CYCLES: f64 = 6.0;
/// A neighbour must turn this many times against the mode within a window to be told from it.
const BEATS: f64 = 1.25;
/// A window's period is dropped where its standard error exceeds this share of it.
const WORST_RELATIVE_SE: f64 = 0.02;

/// Follows a mode through the record in windows that do not overlap.
pub fn against_amplitude(groups: &[ChannelGroup], wanted: &WindowedMode<'_>) -> Vec<WindowPoint> {
    let (start_s, end_s) = wanted.span_s;
    let period_s = std::f64::consts::TAU / wanted.mode.omega_rad_s;
    let nearest = wanted
        .others
        .iter()
        .map(|o| (o.omega_rad_s - wanted.mode.omega_rad_s).abs())
        .fold(f64::INFINITY, f64::min);
    let apart_s = BEATS * std::f64::consts::TAU / nearest;
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
        let Some(point) = window(groups, wanted, mode, (from_s, from_s + width_s)) else { continue };
        // The next window starts from here: the frequency of a strong swing drifts a long way.
        mode.omega_rad_s = std::f64::consts::TAU / point.period_s;
        points.push(point);
    }
    points
}

/// One group's samples within a window, time from the window's middle, channels in units of their noise.
struct Cut {
    u_s: Vec<f64>,
    channels: Vec<DVector<f64>>,
}

fn cut(groups: &[ChannelGroup], noise: &[f64], (from_s, to_s): (f64, f64)) -> Vec<Cut> {
    let middle_s = 0.5 * (from_s + to_s);
    let mut first_channel = 0;
    let mut cuts = Vec::new();
    for g in groups {
        let first = g.t_s.partition_point(|t| *t < from_s);
        let end = g.t_s.partition_point(|t| *t < to_s);
        let scaled = |(c, x): (usize, &Vec<f64>)| {
            let sigma = noise.get(first_channel + c).copied().filter(|s| *s > 0.0).unwrap_or(1.0);
            DVector::from_iterator(end - first, x[first..end].iter().map(|v| v / sigma))
        };
        cuts.push(Cut {
            u_s: g.t_s[first..end].iter().map(|t| t - middle_s).collect(),
            channels: g.channels.iter().enumerate().map(scaled).collect(),
        });
        first_channel += g.channels.len();
    }
    cuts
}

/// Cosine and sine of the mode first, then level, slope, the other modes and the mode's own harmonics.
fn columns(u_s: &[f64], mode: Pole, others: &[Pole], width_s: f64) -> DMatrix<f64> {
    let resolution = std::f64::consts::TAU / width_s;
    let mut poles = vec![mode];
    poles.extend_from_slice(others);
    for k in [2.0, 3.0] {
        let omega = k * mode.omega_rad_s;
        let free = others.iter().all(|o| (o.omega_rad_s - omega).abs() > resolution);
        if free && omega * width_s < std::f64::consts::PI * 0.25 * u_s.len() as f64 {
            poles.push(Pole { omega_rad_s: omega, alpha_per_s: k * mode.alpha_per_s });
        }
    }
    let mut matrix = DMatrix::zeros(u_s.len(), 2 * poles.len() + 2);
    for (row, u) in u_s.iter().enumerate() {
        for (k, pole) in poles.iter().enumerate() {
            let envelope = (-pole.alpha_per_s * u).exp();
            let (sin, cos) = (pole.omega_rad_s * u).sin_cos();
            matrix[(row, 2 * k)] = envelope * cos;
            matrix[(row, 2 * k + 1)] = envelope * sin;
        }
        matrix[(row, 2 * poles.len())] = 1.0;
        matrix[(row, 2 * poles.len() + 1)] = 2.0 * u / width_s;
    }
    matrix
}

/// Residuals of all channels with the linear amplitudes projected out, and each channel's amplitude of the mode.
fn projected(cuts: &[Cut], mode: Pole, others: &[Pole], width_s: f64) -> Option<(Vec<f64>, Vec<Complex64>)> {
    let (mut residuals, mut amplitudes) = (Vec::new(), Vec::new());
    for part in cuts {
        let matrix = columns(&part.u_s, mode, others, width_s);
        if part.u_s.len() < 2 * matrix.ncols() {
            amplitudes.extend(part.channels.iter().map(|_| Complex64::new(0.0, 0.0)));
            continue;
        }
        let cholesky = (matrix.transpose() * &matrix).cholesky()?;
        for x in &part.channels {
            let c = cholesky.solve(&(matrix.transpose() * x));
            // Re[(c − is) e^{iωu}] = c cos ωu + s sin ωu
            amplitudes.push(Complex64::new(c[0], -c[1]));
            residuals.extend((&matrix * c - x).iter());
        }
    }
    (!residuals.is_empty()).then_some((residuals, amplitudes))
}

fn window(
    groups: &[ChannelGroup],
    wanted: &WindowedMode<'_>,
    start: Pole,
    (from_s, to_s): (f64, f64),
) -> Option<WindowPoint> {
    let cuts = cut(groups, wanted.noise, (from_s, to_s));
    let width_s = to_s - from_s;
    let pole = |p: &[f64]| Pole { omega_rad_s: p[0], alpha_per_s: p[1] };
    let rows = projected(&cuts, start, wanted.others, width_s)?.0.len();
    let residuals = |p: &[f64]| {
        projected(&cuts, pole(p), wanted.others, width_s).map_or_else(|| vec![1e9; rows], |(r, _)| r)
    };
    let scale = 0.3 / width_s;
    let fit = nonlinear(&residuals, &[start.omega_rad_s, start.alpha_per_s], &[scale, scale])?;
    let (omega, alpha) = (fit.parameters[0], fit.parameters[1]);
    let (_, amplitudes) = projected(&cuts, pole(&fit.parameters), wanted.others, width_s)?;
    let period_s = std::f64::consts::TAU / omega;
    let point = WindowPoint {
        t_s: 0.5 * (from_s + to_s),
        amplitude: combined(&amplitudes, wanted),
        period_s,
        period_se_s: period_s * fit.se(0) / omega,
        decrement: alpha * period_s,
        decrement_se: fit.se(1) * period_s,
    };
    // A window that ran away to another line is no window of this mode.
    let stayed = (omega - wanted.mode.omega_rad_s).abs() < 0.2 * wanted.mode.omega_rad_s;
    (stayed && point.period_se_s < WORST_RELATIVE_SE * period_s).then_some(point)
}

fn combined(amplitudes: &[Complex64], wanted: &WindowedMode<'_>) -> f64 {
    let term = |((a, p), s): ((&Complex64, &Complex64), &f64)| a * p * if *s > 0.0 { *s } else { 1.0 };
    amplitudes.iter().zip(wanted.project).zip(wanted.noise).map(term).sum::<Complex64>().norm()
}
