//! The motion in time: start, integration, samples.

use nalgebra::{Vector2, Vector6};

use super::constraint::{excesses, jacobian, mass_matrix, reaches};
use super::dop853::{advance, dense};
use super::equilibrium::Pose;
use super::motion::{Forces, Motion, StateVector, derivative};
use super::rig::{Rig, RigidBody};
use super::small::{SmallModes, small_modes};
use crate::error::{Error, Result};
use crate::frames::{Rotation, Vec3};

/// Linear damping about the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Damping {
    /// Force per velocity, world axes, N s/m.
    pub force_n_s_m: Vec3,
    /// Torque per angular rate, body (hanging) axes, N m s.
    pub torque_n_m_s: Vec3,
}

/// The body at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Where it is.
    pub pose: Pose,
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity_m_s: Vec3,
    /// Angular rate, body axes, rad/s.
    pub angular_rate_rad_s: Vec3,
}

/// A part of a start: one small mode at one amplitude.
///
/// # Conventions
/// The modal coordinate is amplitude · cos(ωt + phase); it multiplies the mass-normalised shape (unit √kg m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModalPart {
    /// Index into [`SmallModes`].
    pub mode: usize,
    /// Amplitude of the modal coordinate, √kg m.
    pub amplitude: f64,
    /// Phase, rad.
    pub phase_rad: f64,
}

/// What is asked of a simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Length of the motion, s.
    pub duration_s: f64,
    /// Interval of the samples, s.
    pub interval_s: f64,
    /// Longest step of the integration, s; absent: a 30th of the fastest small mode's period.
    pub step_s: Option<f64>,
}

/// A line that went slack: from there on the motion is not that of a body on lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// When its tension first vanished, s.
    pub t_s: f64,
    /// Which line.
    pub line: usize,
}

/// A sampled motion; all series are as long as `t_s`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    /// Time, s, from 0.
    pub t_s: Vec<f64>,
    /// Centre of mass, world axes, m.
    pub position_m: Vec<Vec3>,
    /// Attitude (hanging axes are the body's).
    pub world_from_hull: Vec<Rotation>,
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity_m_s: Vec<Vec3>,
    /// Angular rate, body axes, rad/s.
    pub angular_rate_rad_s: Vec<Vec3>,
    /// Acceleration of the centre of mass, world axes, m/s².
    pub acceleration_m_s2: Vec<Vec3>,
    /// Angular acceleration, body axes, rad/s².
    pub angular_acceleration_rad_s2: Vec<Vec3>,
    /// Tension of each line, N.
    pub tension_n: Vec<[f64; 2]>,
    /// First slack line, if any; the lines then go on as rods, and what follows is not to be used.
    pub slack: Option<Slack>,
    /// Centre of mass in the body, as in [`RigidBody::cm_m`].
    pub cm_m: Vec3,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: f64,
}

/// A start from small modes at finite amplitude, moved onto the constraints (a yaw rises, a sway swings up)
/// without changing the modal coordinates.
pub fn initial_state(rig: &Rig, body: &RigidBody, modes: &SmallModes, parts: &[ModalPart]) -> Result<State> {
    let (mut displacement, mut rate) = (Vector6::zeros(), Vector6::zeros());
    for part in parts {
        if part.mode >= 4 {
            return Err(Error::argument("mode", "0 to 3", part.mode));
        }
        let shape = Vector6::from(modes.shapes[part.mode]);
        let (sin, cos) = part.phase_rad.sin_cos();
        displacement += shape * (part.amplitude * cos);
        rate -= shape * (part.amplitude * modes.omega_rad_s[part.mode] * sin);
    }
    let rest = &modes.equilibrium.pose;
    let start = State {
        pose: raised(rig, body, rest, displacement)?,
        velocity_m_s: rate.fixed_rows::<3>(0).into_owned(),
        angular_rate_rad_s: rest.world_from_body.inverse() * rate.fixed_rows::<3>(3).into_owned(),
    };
    placed(rig, body, &start)
}

/// The pose with these modal coordinates whose lines have nearly their lengths: moved only as the modes do
/// not, so that a start in yaw of 5 degrees has 5 degrees.
fn raised(rig: &Rig, body: &RigidBody, rest: &Pose, displacement: Vector6<f64>) -> Result<Pose> {
    let singular = || Error::no_result("start of the motion", "the lines do not hold the body");
    let gradient = jacobian(&reaches(rig, body, rest));
    let mass = mass_matrix(body, rest).cholesky().ok_or_else(singular)?;
    let aside = mass.solve(&gradient.transpose());
    let yielding = (gradient * aside).try_inverse().ok_or_else(singular)?;
    let mut pose = rest.displaced(&displacement);
    let mut amount = Vector2::zeros();
    for _ in 0..PLACING_ITERATIONS {
        amount -= yielding * excesses(&reaches(rig, body, &pose));
        pose = rest.displaced(&(displacement + aside * amount));
    }
    Ok(pose)
}

/// The nearest state that keeps the lines' lengths.
pub fn placed(rig: &Rig, body: &RigidBody, state: &State) -> Result<State> {
    let motion = Motion::new(rig, body, &Damping::default())?;
    let y = motion.projected(&state.to_vector(), PLACING_ITERATIONS);
    let found = State::from(&y);
    // Asked so that a value that is not a number does not fit either.
    let fits = rig.lines.iter().all(|line| {
        let lower = found.pose.world_from_body * (line.hull_point_m - body.cm_m) + found.pose.position_m;
        ((lower - line.top_m).norm() - line.length_m).abs() <= 1e-10 * line.length_m
    });
    if fits {
        Ok(found)
    } else {
        Err(Error::no_result("start of the motion", "the lines cannot reach the body there"))
    }
}

/// Newton's method needs about five; a start that needs more than these has no place near it.
const PLACING_ITERATIONS: usize = 30;
/// Steps per period of the fastest small mode.
const STEPS_PER_PERIOD: f64 = 30.0;

/// Integrates the motion from `start`, which is first moved onto the constraints.
pub fn simulate(
    rig: &Rig,
    body: &RigidBody,
    damping: &Damping,
    start: &State,
    sampling: &Sampling,
) -> Result<Trajectory> {
    let step_s = step_length(rig, body, sampling)?;
    let motion = Motion::new(rig, body, damping)?;
    let samples = (sampling.duration_s / sampling.interval_s * (1.0 + 1e-12)).floor() as usize + 1;
    let mut out = Trajectory { cm_m: body.cm_m, gravity_m_s2: rig.gravity_m_s2, ..Trajectory::default() };
    let slope = |y: &StateVector| derivative(y, &motion.forces(y));
    let mut y = placed(rig, body, start)?.to_vector();
    let mut forces = motion.forces(&y);
    out.note_slack(0.0, 0.0, &forces, &forces);
    let mut n = 0usize;
    while out.t_s.len() < samples {
        let from_s = n as f64 * step_s;
        let (raw, stages) = advance(&slope, &y, &derivative(&y, &forces), step_s);
        // A step leaves the constraints by rounding or a little more: one Newton step brings it back.
        let end = motion.projected(&raw, 1);
        let end_forces = motion.forces(&end);
        if !end.iter().all(|x| x.is_finite()) {
            return Err(Error::no_result("motion", format!("it cannot be continued after {from_s} s")));
        }
        let between = dense(&slope, &y, &end, &derivative(&end, &end_forces), stages, step_s);
        while out.t_s.len() < samples {
            let t_s = out.t_s.len() as f64 * sampling.interval_s;
            let x = (t_s - from_s) / step_s;
            if x > 1.0 {
                break;
            }
            let inside = between.at(x);
            out.push(t_s, &inside, &motion.forces(&inside));
        }
        out.note_slack(from_s, step_s, &forces, &end_forces);
        (y, forces) = (end, end_forces);
        n += 1;
    }
    Ok(out)
}

fn step_length(rig: &Rig, body: &RigidBody, sampling: &Sampling) -> Result<f64> {
    let step_s = match sampling.step_s {
        Some(step_s) => step_s,
        None => small_modes(rig, body)?.period_s(3) / STEPS_PER_PERIOD,
    };
    let positive = |name: &str, x: f64| {
        if x.is_finite() && x > 0.0 { Ok(()) } else { Err(Error::argument(name, "a positive number", x)) }
    };
    positive("step_s", step_s)?;
    positive("interval_s", sampling.interval_s)?;
    positive("duration_s", sampling.duration_s)?;
    Ok(step_s)
}

impl Trajectory {
    fn push(&mut self, t_s: f64, y: &StateVector, forces: &Forces) {
        let state = State::from(y);
        self.t_s.push(t_s);
        self.position_m.push(state.pose.position_m);
        self.world_from_hull.push(state.pose.world_from_body);
        self.velocity_m_s.push(state.velocity_m_s);
        self.angular_rate_rad_s.push(state.angular_rate_rad_s);
        self.acceleration_m_s2.push(forces.acceleration);
        self.angular_acceleration_rad_s2.push(forces.angular_acceleration);
        self.tension_n.push(forces.tension_n);
    }

    /// Keeps the first zero of a tension, by a straight line between the ends of the step.
    fn note_slack(&mut self, from_s: f64, step_s: f64, start: &Forces, end: &Forces) {
        if self.slack.is_some() {
            return;
        }
        let zero = |line: usize| {
            let (before, after) = (start.tension_n[line], end.tension_n[line]);
            let part = if before > after { (before / (before - after)).clamp(0.0, 1.0) } else { 0.0 };
            (after <= 0.0).then_some(Slack { t_s: from_s + part * step_s, line })
        };
        let found = [zero(0), zero(1)].into_iter().flatten();
        self.slack = found.min_by(|a, b| a.t_s.total_cmp(&b.t_s));
    }
}
