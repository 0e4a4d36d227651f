//! How the body hangs at rest.

use nalgebra::{Matrix6, Vector2, Vector6};

use super::constraint::{excesses, free_directions, jacobian, reaches};
use super::pose::Pose;
use super::rig::{Rig, RigidBody};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Rotation, Vec3};

/// The body at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// The pose.
    pub pose: Pose,
    /// Tension of each line, N.
    pub tension_n: [f64; 2],
}

/// Finds the rest pose below the lines.
///
/// Where both lines and both halves are alike, the first guess is already the closed form (centre
/// of mass vertically below the mid-point of the suspension) and the iteration only confirms it.
pub(crate) fn equilibrium(rig: &Rig, body: &RigidBody) -> Result<Equilibrium> {
    body.check()?;
    let mut pose = first_guess(rig, body);
    for _ in 0..MAX_ITERATIONS {
        let newton =
            Newton::at(rig, body, &pose).ok_or_else(|| failed("the lines do not hold the body"))?;
        let step = newton
            .step()
            .ok_or_else(|| failed("the body is not stable on the lines"))?;
        pose = pose.displaced(&(step * (MAX_STEP / step.norm()).min(1.0)));
        if step.norm() < CONVERGED {
            return rest(rig, body, pose);
        }
    }
    Err(failed("the rest pose was not found"))
}

const MAX_ITERATIONS: usize = 60;
/// Longest step, m and rad together: keeps Newton's method from leaving the local minimum.
const MAX_STEP: f64 = 0.3;
/// Newton's method doubles the digits: a step this small leaves an error below rounding.
const CONVERGED: f64 = 1e-9;

fn failed(reason: &str) -> Error {
    Error::no_result("rest pose", reason)
}

fn rest(rig: &Rig, body: &RigidBody, pose: Pose) -> Result<Equilibrium> {
    let lambda = Newton::at(rig, body, &pose)
        .ok_or_else(|| failed("the lines do not hold the body"))?
        .lambda;
    let tension_n = [
        lambda[0] * rig.lines[0].length_m,
        lambda[1] * rig.lines[1].length_m,
    ];
    if tension_n.iter().all(|&t| t > 0.0) {
        Ok(Equilibrium { pose, tension_n })
    } else {
        Err(failed("a line is slack at rest"))
    }
}

/// Suspension points level, centre of mass turned about their axis until it is lowest.
fn first_guess(rig: &Rig, body: &RigidBody) -> Pose {
    let [one, two] = rig.lines;
    let axis = rig.axis();
    let body_axis = (two.hull_point_m - one.hull_point_m)
        .try_normalize(0.0)
        .unwrap_or(axis);
    let align = Rotation::rotation_between(&body_axis, &axis).unwrap_or_default();
    let cm = align * body.cm_m;
    let across = cm - axis * cm.dot(&axis);
    let swing = nalgebra::Unit::new_normalize(axis);
    let angle = f64::atan2(across.cross(&-Vec3::z()).dot(&axis), -across.z);
    let world_from_body = Rotation::from_axis_angle(&swing, angle) * align;
    let middle = (one.top_m + two.top_m) * 0.5;
    let gap = 0.5 * ((two.top_m - one.top_m).norm() - (two.hull_point_m - one.hull_point_m).norm());
    let length = 0.5 * (one.length_m + two.length_m);
    let drop = (length * length - gap * gap)
        .max(1e-6 * length * length)
        .sqrt();
    Pose {
        position_m: middle - Vec3::z() * drop + world_from_body * body.cm_m,
        world_from_body,
    }
}

/// Newton's method for a stationary height under the constraints.
pub(super) struct Newton {
    jacobian: nalgebra::Matrix2x6<f64>,
    excess: Vector2<f64>,
    slope: Vector6<f64>,
    /// Line forces over vectors, N/m: the multipliers of the constraints.
    pub lambda: Vector2<f64>,
    /// Hess(V) + Σ λ Hess(c); V is linear in the displacement.
    pub stiffness: Matrix6<f64>,
    /// Basis of displacements that stretch no line.
    pub free: nalgebra::SMatrix<f64, 6, 4>,
}

impl Newton {
    pub fn at(rig: &Rig, body: &RigidBody, pose: &Pose) -> Option<Self> {
        let lines = reaches(rig, body, pose);
        let jacobian = jacobian(&lines);
        let slope = Vector6::ith(2, body.mass_kg * rig.gravity_m_s2);
        // Least squares: exact where the body is at rest.
        let lambda = (jacobian * jacobian.transpose()).try_inverse()? * (jacobian * -slope);
        let stiffness = lines[0].hessian() * lambda[0] + lines[1].hessian() * lambda[1];
        let free = free_directions(&jacobian)?;
        Some(Self {
            jacobian,
            excess: excesses(&lines),
            slope,
            lambda,
            stiffness,
            free,
        })
    }

    fn step(&self) -> Option<Vector6<f64>> {
        let gram = (self.jacobian * self.jacobian.transpose()).try_inverse()?;
        let onto = -(self.jacobian.transpose() * (gram * self.excess));
        let reduced = self.free.transpose() * self.stiffness * self.free;
        let downhill = -(self.free.transpose() * (self.slope + self.stiffness * onto));
        Some(onto + self.free * reduced.cholesky()?.solve(&downhill))
    }
}
