//! Finite amplitude: what the full motion does to the observed periods.
//!
//! The small-oscillation theory holds at no amplitude. A simulation of each swing (the estimated body on
//! the stated lines, with the amplitudes, phases and decays that were observed) is simulated, its
//! modal coordinates are fitted as the record was, and the ratio of the theory's period to the
//! simulation's takes finite amplitude out of the observed period: the exact yaw law with heave included,
//! the pendulum law, the influence of each mode on the others and the damping at once.

use nalgebra::{DMatrix, DVector, Vector6};

use gyradius_base::frames::Vec3;
use gyradius_mechanics::{
    Damping, ModalPart, Rig, RigidBody, Sampling, SmallModes, Trajectory,
    compound_pendulum_period_s, initial_state, simulate, small_modes,
};
use gyradius_recording::{ModeName, SuspensionKind, Swing};

use super::measurement::{ModeResult, SwingResult};
use super::names::AmplitudeUnit;
use super::parameters::{Layout, SwingIndex};
use super::routes::finite_amplitude::{pendulum_period_ratio, yaw_period_at_amplitude_s};
use super::routes::yaw::{Lines, yaw_period_s};
use super::theory::{axis, mode_names, swing_body, swing_lines, swing_rig};

/// Share of a correction that counts as its standard uncertainty: amplitudes are known to a percent
/// or two, and the simulation knows no air and no bearing.
const CORRECTION_U_SHARE: f64 = 0.05;
/// Samples per period of the fastest mode.
const SAMPLES_PER_PERIOD: f64 = 12.0;
/// A record longer than this adds nothing: the amplitudes have had their effect, s.
const LONGEST_S: f64 = 180.0;
/// A typed period is simulated over this many cycles.
const TYPED_CYCLES: f64 = 10.0;

/// The square root of the rounding of numbers: a period changes with the square of the amplitude, and
/// a motion below this is all rounding.
const LEAST_RAD: f64 = 1.5e-8;

/// What brings an observed period to small amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Small-amplitude over observed period.
    pub factor: f64,
    /// Its standard uncertainty.
    pub u_relative: f64,
}

impl Default for Correction {
    fn default() -> Self {
        Correction {
            factor: 1.0,
            u_relative: 0.0,
        }
    }
}

impl Correction {
    /// The same correction, less certain by its change under another body.
    fn or(self, other: &Correction) -> Self {
        Correction {
            u_relative: self.u_relative.hypot(self.factor - other.factor),
            ..self
        }
    }

    /// The same correction, less certain by another doubt of the period, relative.
    pub fn and(self, u_relative: f64) -> Self {
        Correction {
            u_relative: self.u_relative.hypot(u_relative),
            ..self
        }
    }

    /// One that leaves nothing open.
    pub fn known(small_over_observed: f64) -> Self {
        Correction {
            factor: small_over_observed,
            u_relative: 0.0,
        }
    }

    /// Before there is a body to simulate: the pendulum's law A²/16, and yaw's that is up to twice
    /// that, may be missing.
    pub fn unknown(mode: &ModeResult) -> Self {
        let amplitude_rad = mode
            .amplitude
            .filter(|_| mode.amplitude_unit == AmplitudeUnit::Radian)
            .unwrap_or(0.0);
        Correction {
            factor: 1.0,
            u_relative: amplitude_rad * amplitude_rad / 8.0,
        }
    }

    fn of(small_over_observed: f64) -> Self {
        Correction {
            factor: small_over_observed,
            u_relative: CORRECTION_U_SHARE * (1.0 - small_over_observed).abs(),
        }
    }
}

/// A mode of the simulated swing.
struct Part {
    /// Index into the swing's modes.
    observed: usize,
    /// Index into the small modes.
    small: usize,
    amplitude: f64,
    phase_rad: f64,
    alpha_per_s: f64,
}

/// Corrections of every mode of a swing; 1 where nothing is known of its amplitude.
///
/// A pitching hull yaws about an axis tilted in it, so its roll inertia shares in the yaw:
/// `other_x` is the same body with its roll gyradius one standard uncertainty off, where no swing
/// measures it, and what that changes widens the corrections.
pub fn corrections(
    layout: &Layout,
    (x, other_x): (&[f64], Option<&[f64]>),
    swing: &Swing,
    index: &SwingIndex,
    result: &SwingResult,
) -> Vec<Correction> {
    let here = corrections_of(layout, x, swing, index, result);
    let Some(other_x) = other_x else { return here };
    let there = corrections_of(layout, other_x, swing, index, result);
    here.into_iter()
        .zip(&there)
        .map(|(here, there)| here.or(there))
        .collect()
}

fn corrections_of(
    layout: &Layout,
    x: &[f64],
    swing: &Swing,
    index: &SwingIndex,
    result: &SwingResult,
) -> Vec<Correction> {
    let none = vec![Correction::default(); result.modes.len()];
    let duration_s = result.duration_s();
    let Ok(body) = swing_body(layout, x, swing, index) else {
        return none;
    };
    if let Some(height) = index.axis_height {
        return result
            .modes
            .iter()
            .map(|m| compound(&body, swing, x[height], x[layout.gravity], (m, duration_s)))
            .collect();
    }
    if swing.suspension.kind == SuspensionKind::Trifilar {
        let Ok(lines) = swing_lines(x, swing, index) else {
            return none;
        };
        let of_mode = |m: &ModeResult| trifilar(&body, &lines, x[layout.gravity], (m, duration_s));
        return result.modes.iter().map(of_mode).collect();
    }
    let Ok(rig) = swing_rig(layout, x, swing, index) else {
        return none;
    };
    bifilar(&rig, &body, swing, result).unwrap_or(none)
}

/// Three lines: by the exact laws of yaw and of a pendulum.
fn trifilar(
    body: &RigidBody,
    lines: &Lines,
    gravity_m_s2: f64,
    (mode, duration_s): (&ModeResult, f64),
) -> Correction {
    let k = (body.inertia_kg_m2[(2, 2)] / body.mass_kg).sqrt();
    let small = yaw_period_s(k, lines, gravity_m_s2).unwrap_or(f64::NAN);
    match mode.mode {
        ModeName::Yaw => by_law((mode, duration_s), small, |amplitude| {
            let large = yaw_period_at_amplitude_s(k, lines, gravity_m_s2, amplitude);
            large.map_or(1.0, |large| large / small)
        }),
        ModeName::Sway => by_law((mode, duration_s), mode.period_observed_s, pendulum),
        _ => Correction::default(),
    }
}

fn pendulum(amplitude_rad: f64) -> f64 {
    pendulum_period_ratio(amplitude_rad).unwrap_or(1.0)
}

fn bifilar(
    rig: &Rig,
    body: &RigidBody,
    swing: &Swing,
    result: &SwingResult,
) -> Option<Vec<Correction>> {
    let modes = small_modes(rig, body).ok()?;
    let parts = parts(body, &modes, swing, result);
    let mut corrections = vec![Correction::default(); result.modes.len()];
    if parts.is_empty() {
        return Some(corrections);
    }
    let together = result.span_s.is_some();
    let runs: Vec<Vec<Part>> = if together {
        vec![parts]
    } else {
        parts.into_iter().map(|p| vec![p]).collect()
    };
    for run in runs {
        for (part, omega) in run
            .iter()
            .zip(simulated_frequencies(rig, body, &modes, &run, result)?)
        {
            corrections[part.observed] = Correction::of(omega / modes.omega_rad_s[part.small]);
        }
    }
    Some(corrections)
}

fn parts(body: &RigidBody, modes: &SmallModes, swing: &Swing, result: &SwingResult) -> Vec<Part> {
    let unit = axis(swing.suspension.orientation).unit();
    let names = mode_names(body, modes, swing.suspension.orientation);
    let find = |name: ModeName| (0..4).find(|i| names[*i] == name);
    let part = |(observed, mode): (usize, &ModeResult)| {
        let small = find(mode.mode)?;
        let angle = mode
            .amplitude
            .filter(|_| mode.amplitude_unit == AmplitudeUnit::Radian)
            .filter(|angle| *angle > LEAST_RAD)?;
        let size = angle_of_shape(modes, small, mode.mode, &unit);
        Some(Part {
            observed,
            small,
            amplitude: angle / size.max(f64::MIN_POSITIVE),
            phase_rad: mode.phase_rad.unwrap_or(0.0),
            alpha_per_s: mode.decay_time_s.map_or(0.0, |tau| 1.0 / tau),
        })
    };
    result.modes.iter().enumerate().filter_map(part).collect()
}

/// The angle that one unit of a mode's coordinate makes, by the conventions of the modes' sizes.
pub(super) fn angle_of_shape(modes: &SmallModes, i: usize, name: ModeName, unit: &Vec3) -> f64 {
    match name {
        ModeName::Yaw => modes.rotation(i).z.abs(),
        // |a| / g with a = ω² × displacement
        ModeName::Sway => {
            modes.displacement(i).dot(unit).abs() * modes.omega_rad_s[i].powi(2)
                / gyradius_base::constants::STANDARD_GRAVITY_M_S2
        }
        _ => modes.rotation(i).dot(unit).abs(),
    }
}

fn simulated_frequencies(
    rig: &Rig,
    body: &RigidBody,
    modes: &SmallModes,
    parts: &[Part],
    result: &SwingResult,
) -> Option<Vec<f64>> {
    let fastest = parts
        .iter()
        .map(|p| modes.omega_rad_s[p.small])
        .fold(0.0, f64::max);
    let slowest = parts
        .iter()
        .map(|p| modes.omega_rad_s[p.small])
        .fold(f64::INFINITY, f64::min);
    let duration_s = match result.span_s {
        Some([start, end]) => (end - start).min(LONGEST_S),
        None => TYPED_CYCLES * std::f64::consts::TAU / slowest,
    };
    let interval_s = std::f64::consts::TAU / fastest / SAMPLES_PER_PERIOD;
    let modal: Vec<ModalPart> = parts
        .iter()
        .map(|p| ModalPart {
            mode: p.small,
            amplitude: p.amplitude,
            phase_rad: p.phase_rad,
        })
        .collect();
    let start = initial_state(rig, body, modes, &modal).ok()?;
    let sampling = Sampling {
        duration_s,
        interval_s,
        step_s: None,
    };
    let motion = simulate(rig, body, &damping(body, modes, parts), &start, &sampling).ok()?;
    let coordinates: Vec<Vec<f64>> = parts
        .iter()
        .map(|p| modal_coordinate(&motion, body, modes, p.small))
        .collect();
    let mut poles: Vec<Pole> = parts
        .iter()
        .map(|p| Pole {
            omega: modes.omega_rad_s[p.small],
            alpha: p.alpha_per_s,
        })
        .collect();
    // Damping and large motion mix the coordinates a little: each is fitted beside the others'
    // lines, twice round.
    for _ in 0..2 {
        for k in 0..poles.len() {
            poles[k] = fitted(&motion.t_s, &coordinates[k], &poles, k)?;
        }
    }
    Some(poles.iter().map(|p| p.omega).collect())
}

/// Frequency and decay of a line, rad/s and 1/s.
#[derive(Debug, Clone, Copy)]
struct Pole {
    omega: f64,
    alpha: f64,
}

/// Damping about the centre of mass that lets each mode decay as it was observed to.
///
/// A mass-normalised mode decays at α = ½ Σ c v² over the coefficients c; a double pendulum's two
/// modes share a force and a torque coefficient, solved from both decays (or from one, each charged
/// alike).
fn damping(body: &RigidBody, modes: &SmallModes, parts: &[Part]) -> Damping {
    let mut damping = Damping::default();
    let mut pendulum: Vec<(f64, f64, f64)> = Vec::new();
    let mut axes = (0, 1);
    for part in parts {
        let (shift, turn) = (modes.displacement(part.small), modes.rotation(part.small));
        let shifting = shift.component_mul(&shift) * body.mass_kg;
        let turning = Vec3::from_fn(|i, _| body.inertia_kg_m2[(i, i)] * turn[i] * turn[i]);
        let (i, j) = (shifting.imax(), turning.imax());
        let rate = 2.0 * part.alpha_per_s;
        if turning[j] < 0.01 * shifting[i] {
            damping.force_n_s_m[i] = rate / (shift[i] * shift[i]);
        } else if j == 2 {
            damping.torque_n_m_s[j] = rate / (turn[j] * turn[j]);
        } else {
            axes = (i, j);
            pendulum.push((shift[i] * shift[i], turn[j] * turn[j], rate));
        }
    }
    let (force, torque) = pendulum_damping(
        &pendulum,
        body.mass_kg,
        body.inertia_kg_m2[(axes.1, axes.1)],
    );
    damping.force_n_s_m[axes.0] = damping.force_n_s_m[axes.0].max(force);
    damping.torque_n_m_s[axes.1] = damping.torque_n_m_s[axes.1].max(torque);
    damping
}

/// Force and torque coefficients of a double pendulum from rows (shift², turn², 2α).
fn pendulum_damping(rows: &[(f64, f64, f64)], mass_kg: f64, inertia_kg_m2: f64) -> (f64, f64) {
    let alike = |rate: f64| (rate * mass_kg, rate * inertia_kg_m2);
    match rows {
        [] => (0.0, 0.0),
        [(a, b, p), (c, d, q)] => {
            let determinant = a * d - b * c;
            let (force, torque) = ((p * d - b * q) / determinant, (a * q - p * c) / determinant);
            if force >= 0.0 && torque >= 0.0 {
                (force, torque)
            } else {
                alike(0.5 * (p + q))
            }
        }
        [(_, _, rate), ..] => alike(*rate),
    }
}

/// The coordinate of a mode along a motion: its mass-normalised shape times the mass matrix times
/// the displacement.
fn modal_coordinate(
    motion: &Trajectory,
    body: &RigidBody,
    modes: &SmallModes,
    i: usize,
) -> Vec<f64> {
    let rest = &modes.equilibrium.pose;
    let inertia = {
        let turn = rest.world_from_body.to_rotation_matrix();
        turn.matrix() * body.inertia_kg_m2 * turn.matrix().transpose()
    };
    let shape = Vector6::from(modes.shapes[i]);
    let push: Vec3 = shape.fixed_rows::<3>(0) * body.mass_kg;
    let twist: Vec3 = inertia * shape.fixed_rows::<3>(3);
    motion
        .position_m
        .iter()
        .zip(&motion.world_from_hull)
        .map(|(position, attitude)| {
            let turned = (attitude * rest.world_from_body.inverse()).scaled_axis();
            push.dot(&(position - rest.position_m)) + twist.dot(&turned)
        })
        .collect()
}

/// The pole of the damped oscillation that fits a series best beside the lines of the other poles
/// (Gauss–Newton).
fn fitted(t_s: &[f64], series: &[f64], poles: &[Pole], k: usize) -> Option<Pole> {
    let y = DVector::from_column_slice(series);
    let others: Vec<Pole> = poles
        .iter()
        .enumerate()
        .filter(|(j, _)| *j != k)
        .map(|(_, p)| *p)
        .collect();
    let mut pole = poles[k];
    let mut best = f64::INFINITY;
    // Beyond a tenth of a cycle over the record the linearisation does not hold: take a shorter
    // step.
    let most = 0.5 / (t_s.last()? - t_s.first()?).max(f64::MIN_POSITIVE);
    for _ in 0..30 {
        let linear = solve(&basis(t_s, &pole, &others, None), &y)?;
        let step = solve(
            &basis(t_s, &pole, &others, Some((linear[0], linear[1]))),
            &y,
        )?;
        let (d_omega, d_alpha) = (step[2], step[3]);
        let shorten = (most / d_omega.hypot(d_alpha).max(f64::MIN_POSITIVE)).min(1.0);
        pole.omega += d_omega * shorten;
        pole.alpha += d_alpha * shorten;
        if d_omega.abs() < 1e-11 * pole.omega {
            return Some(pole);
        }
        best = d_omega.abs().min(best);
    }
    (best < 1e-6 * pole.omega).then_some(pole)
}

/// Columns: the line's cosine and sine; with amplitudes given, its derivatives by ω and α; an
/// offset; the other lines.
fn basis(
    t_s: &[f64],
    pole: &Pole,
    others: &[Pole],
    amplitudes: Option<(f64, f64)>,
) -> DMatrix<f64> {
    let own = if amplitudes.is_some() { 4 } else { 2 };
    let mut columns = DMatrix::zeros(t_s.len(), own + 1 + 2 * others.len());
    for (i, t) in t_s.iter().enumerate() {
        let line = |p: &Pole| {
            let (sin, cos) = (p.omega * t).sin_cos();
            let envelope = (-p.alpha * t).exp();
            (envelope * cos, envelope * sin)
        };
        let (cos, sin) = line(pole);
        (columns[(i, 0)], columns[(i, 1)]) = (cos, sin);
        if let Some((c, s)) = amplitudes {
            columns[(i, 2)] = t * (s * cos - c * sin);
            columns[(i, 3)] = -t * (c * cos + s * sin);
        }
        columns[(i, own)] = 1.0;
        for (j, other) in others.iter().enumerate() {
            let (cos, sin) = line(other);
            (columns[(i, own + 1 + 2 * j)], columns[(i, own + 2 + 2 * j)]) = (cos, sin);
        }
    }
    columns
}

fn solve(basis: &DMatrix<f64>, y: &DVector<f64>) -> Option<DVector<f64>> {
    (basis.transpose() * basis)
        .cholesky()
        .map(|c| c.solve(&(basis.transpose() * y)))
}

/// A compound pendulum is a pendulum: its period follows the exact law.
fn compound(
    body: &RigidBody,
    swing: &Swing,
    axis_height_m: f64,
    gravity_m_s2: f64,
    (mode, duration_s): (&ModeResult, f64),
) -> Correction {
    let unit = axis(swing.suspension.orientation).unit();
    let k2 = unit.dot(&(body.inertia_kg_m2 * unit)) / body.mass_kg;
    let period_s = compound_pendulum_period_s(k2.sqrt(), axis_height_m - body.cm_m.z, gravity_m_s2);
    match mode.mode {
        ModeName::Compound => by_law((mode, duration_s), period_s, pendulum),
        _ => Correction::default(),
    }
}

/// By the law of a motion in one degree of freedom: its period at an amplitude over that of small
/// ones, `period_s`; `duration_s` of it was recorded.
fn by_law(
    (mode, duration_s): (&ModeResult, f64),
    period_s: f64,
    law: impl Fn(f64) -> f64,
) -> Correction {
    let in_rad = mode.amplitude_unit == AmplitudeUnit::Radian;
    match mode.amplitude.filter(|_| in_rad && period_s.is_finite()) {
        Some(start) => {
            let mean_square = mode.mean_square(duration_s);
            // Errata, damping row: T0 = T / sqrt(1 + (T / 2πτ)²).
            let damped = mode.decay_time_s.map_or(1.0, |tau| {
                (period_s / (std::f64::consts::TAU * tau)).hypot(1.0)
            });
            let at_amplitude = law(start * mean_square.sqrt());
            Correction::of(1.0 / (at_amplitude * damped))
        }
        None => Correction::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use gyradius_mechanics::SuspensionAxis;
    use gyradius_recording::Orientation;

    /// The errata's table for pure yaw on the keelboat rig (quadrature, heave included): +473 ppm
    /// at 5°.
    #[test]
    fn yaw_at_five_degrees_is_473_ppm_long() {
        let rig = Rig::bifilar(SuspensionAxis::Athwartships, 3.477, 1.8, 1.8, 9.80665).unwrap();
        let body =
            RigidBody::from_gyradii(622.7, [0.6, 1.156, 1.0566], Vec3::new(0.0, 0.0, -0.465));
        let modes = small_modes(&rig, &body).unwrap();
        let names = mode_names(&body, &modes, Orientation::Athwartships);
        let yaw = names
            .iter()
            .position(|name| *name == ModeName::Yaw)
            .unwrap();
        let amplitude = 5f64.to_radians() / modes.rotation(yaw).z.abs();
        let part = Part {
            observed: 0,
            small: yaw,
            amplitude,
            phase_rad: 0.0,
            alpha_per_s: 0.0,
        };
        let result = SwingResult {
            span_s: Some([0.0, 60.0]),
            ..Default::default()
        };
        let omega = simulated_frequencies(&rig, &body, &modes, &[part], &result).unwrap()[0];
        assert_relative_eq!(modes.omega_rad_s[yaw] / omega - 1.0, 473e-6, epsilon = 2e-6);
    }
}
