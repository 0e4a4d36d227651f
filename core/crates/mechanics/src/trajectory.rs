//! The motion in time: start, integration, samples.

use nalgebra::{Vector2, Vector6};

use super::constraint::{excesses, jacobian, mass_matrix, reaches};
use super::effects::{Effect, LinearDamping};
use super::equations::Equations;
use super::path::{Fineness, Moment, Path, Slack};
use super::pose::Pose;
use super::rig::{Rig, RigidBody};
use super::small::{SmallModes, small_modes};
use super::state::{ATTITUDE, PLACE, RATE, VELOCITY};
use super::suspended::{Cord, Suspended};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Rotation, Vec3};

/// Linear damping about the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Damping {
    /// Force per velocity, body (hanging) axes, N s/m.
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
/// The modal coordinate is amplitude · cos(ωt + phase); it multiplies the mass-normalised shape
/// (unit √kg m).
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
    /// First slack line, if any; the lines then go on as rods, and what follows is not to be used.
    pub slack: Option<Slack>,
    /// Centre of mass in the body, as in [`RigidBody::cm_m`].
    pub cm_m: Vec3,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: f64,
}

/// A start from small modes at finite amplitude, moved onto the constraints (a yaw rises, a sway
/// swings up) without changing the modal coordinates.
pub fn initial_state(
    rig: &Rig,
    body: &RigidBody,
    modes: &SmallModes,
    parts: &[ModalPart],
) -> Result<State> {
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

/// The pose with these modal coordinates whose lines have nearly their lengths: moved only as the
/// modes do not, so that a start in yaw of 5 degrees has 5 degrees.
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
pub(crate) fn placed(rig: &Rig, body: &RigidBody, state: &State) -> Result<State> {
    let equations = equations(rig, body, &Damping::default())?;
    let mut y = vector(&equations, state);
    equations.project(&mut y, PLACING_ITERATIONS);
    let found = State::from(&y[..]);
    // Asked so that a value that is not a number does not fit either.
    let fits = rig.lines.iter().all(|line| {
        let lower =
            found.pose.world_from_body * (line.hull_point_m - body.cm_m) + found.pose.position_m;
        ((lower - line.top_m).norm() - line.length_m).abs() <= 1e-10 * line.length_m
    });
    if fits {
        Ok(found)
    } else {
        Err(Error::no_result(
            "start of the motion",
            "the lines cannot reach the body there",
        ))
    }
}

/// Newton's method needs about five; a start that needs more than these has no place near it.
const PLACING_ITERATIONS: usize = 30;
/// Steps per period of the fastest small mode.
const STEPS_PER_PERIOD: f64 = 30.0;

fn equations(rig: &Rig, body: &RigidBody, damping: &Damping) -> Result<Equations<f64>> {
    body.check()?;
    let cord = |line: &super::rig::Line| Cord {
        top_m: line.top_m,
        point_m: line.hull_point_m,
        length_m: line.length_m,
    };
    let system = Suspended {
        mass_kg: body.mass_kg,
        inertia_kg_m2: body.inertia_kg_m2,
        cm_m: body.cm_m,
        cords: rig.lines.iter().map(cord).collect(),
        gravity_m_s2: rig.gravity_m_s2,
        spring: None,
    };
    let (force, torque) = (damping.force_n_s_m, damping.torque_n_m_s);
    let drag = LinearDamping {
        surge_n_s_m: force.x,
        sway_n_s_m: force.y,
        heave_n_s_m: force.z,
        roll_n_m_s: torque.x,
        pitch_n_m_s: torque.y,
        yaw_n_m_s: torque.z,
    };
    Ok(Equations::new(
        system,
        vec![Box::new(drag) as Box<dyn Effect<f64>>],
    ))
}

fn vector(equations: &Equations<f64>, state: &State) -> Vec<f64> {
    let q = state.pose.world_from_body.quaternion();
    let mut y = vec![0.0; equations.size()];
    y[PLACE..ATTITUDE].copy_from_slice(state.pose.position_m.as_slice());
    y[ATTITUDE..VELOCITY].copy_from_slice(&[q.w, q.i, q.j, q.k]);
    y[VELOCITY..RATE].copy_from_slice(state.velocity_m_s.as_slice());
    y[RATE..RATE + 3].copy_from_slice(state.angular_rate_rad_s.as_slice());
    y
}

fn turned(q: &[f64]) -> Rotation {
    Rotation::new_normalize(nalgebra::Quaternion::new(q[0], q[1], q[2], q[3]))
}

impl From<&[f64]> for State {
    fn from(y: &[f64]) -> Self {
        let part = |i: usize| Vec3::new(y[i], y[i + 1], y[i + 2]);
        let pose = Pose {
            position_m: part(PLACE),
            world_from_body: turned(&y[ATTITUDE..VELOCITY]),
        };
        Self {
            pose,
            velocity_m_s: part(VELOCITY),
            angular_rate_rad_s: part(RATE),
        }
    }
}

/// Integrates the motion from `start`, which is first moved onto the constraints.
pub fn simulate(
    rig: &Rig,
    body: &RigidBody,
    damping: &Damping,
    start: &State,
    sampling: &Sampling,
) -> Result<Trajectory> {
    let step_s = match sampling.step_s {
        Some(step_s) => step_s,
        None => small_modes(rig, body)?.period_s(3) / STEPS_PER_PERIOD,
    };
    if !(sampling.interval_s.is_finite() && sampling.interval_s > 0.0) {
        return Err(Error::argument(
            "interval_s",
            "a positive number",
            sampling.interval_s,
        ));
    }
    let equations = equations(rig, body, damping)?;
    let y = vector(&equations, &placed(rig, body, start)?);
    let path = Path::integrate(
        &equations,
        y,
        Vec::new(),
        sampling.duration_s,
        step_s,
        Fineness::FULL,
    )?;
    let samples = (sampling.duration_s / sampling.interval_s * (1.0 + 1e-12)).floor() as usize + 1;
    let mut out = Trajectory {
        cm_m: body.cm_m,
        gravity_m_s2: rig.gravity_m_s2,
        slack: path.slack,
        ..Trajectory::default()
    };
    for n in 0..samples {
        let t_s = n as f64 * sampling.interval_s;
        out.push(t_s, &path.at(t_s));
    }
    Ok(out)
}

impl Trajectory {
    fn push(&mut self, t_s: f64, moment: &Moment<f64>) {
        self.t_s.push(t_s);
        self.position_m.push(moment.position);
        self.world_from_hull.push(turned(&moment.attitude));
        self.velocity_m_s.push(moment.velocity);
        self.angular_rate_rad_s.push(moment.rate);
        self.acceleration_m_s2.push(moment.acceleration);
        self.angular_acceleration_rad_s2
            .push(moment.angular_acceleration);
    }
}
