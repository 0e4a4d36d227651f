//! Equations of motion of the body on two inextensible lines.
//!
//! Six coordinates (centre of mass, attitude) and the two line forces; the forces follow from the demand that
//! the lines keep their length (index 1), and what numerical drift is left is projected away.
//!
//! # Conventions
//! State vector: centre of mass (world), attitude quaternion i, j, k, w (world from body), velocity (world),
//! angular rate (body). The constraint of a line is (|q|² − l²)/2 = 0; its force on the body is −λ q.

use nalgebra::{Matrix2, Quaternion, SVector, Vector2};

use super::equilibrium::Pose;
use super::rig::{Rig, RigidBody};
use super::trajectory::{Damping, State};
use crate::error::{Error, Result};
use crate::frames::{Mat3, Rotation, Vec3};

pub(super) type StateVector = SVector<f64, 13>;

/// The body, its lines and what brakes it.
pub(super) struct Motion {
    mass_kg: f64,
    inertia: Mat3,
    inertia_inverse: Mat3,
    gravity: Vec3,
    damping: Damping,
    /// Lower ends from the centre of mass, body axes, m.
    points: [Vec3; 2],
    tops: [Vec3; 2],
    lengths: [f64; 2],
}

/// Accelerations and line forces at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces {
    /// Of the centre of mass, world axes.
    pub acceleration: Vec3,
    /// Body axes.
    pub angular_acceleration: Vec3,
    /// N.
    pub tension_n: [f64; 2],
}

/// How the two constraints take hold of the body.
struct Grip {
    q: [Vec3; 2],
    /// Gradient with respect to a turn, body axes.
    moment: [Vec3; 2],
    /// I⁻¹ moment.
    turn: [Vec3; 2],
    /// Inverse of G M⁻¹ Gᵀ.
    yielding: Matrix2<f64>,
}

impl Motion {
    pub fn new(rig: &Rig, body: &RigidBody, damping: &Damping) -> Result<Self> {
        body.check()?;
        let inertia_inverse = body
            .inertia_kg_m2
            .try_inverse()
            .ok_or_else(|| Error::argument("inertia_kg_m2", "an invertible inertia", body.inertia_kg_m2))?;
        Ok(Self {
            mass_kg: body.mass_kg,
            inertia: body.inertia_kg_m2,
            inertia_inverse,
            gravity: Vec3::new(0.0, 0.0, -rig.gravity_m_s2),
            damping: *damping,
            points: rig.lines.map(|line| line.hull_point_m - body.cm_m),
            tops: rig.lines.map(|line| line.top_m),
            lengths: rig.lines.map(|line| line.length_m),
        })
    }

    fn grip(&self, position: &Vec3, turn: &Mat3) -> Grip {
        let q = [0, 1].map(|i| position + turn * self.points[i] - self.tops[i]);
        let moment = [0, 1].map(|i| self.points[i].cross(&turn.tr_mul(&q[i])));
        let lever = moment.map(|m| self.inertia_inverse * m);
        let w = |i: usize, j: usize| q[i].dot(&q[j]) / self.mass_kg + moment[i].dot(&lever[j]);
        let (a, b, d) = (w(0, 0), w(0, 1), w(1, 1));
        // A singular matrix gives values that are not finite; the step is then refused.
        let yielding = Matrix2::new(d, -b, -b, a) / (a * d - b * b);
        Grip { q, moment, turn: lever, yielding }
    }

    /// Accelerations at a state.
    pub fn forces(&self, y: &StateVector) -> Forces {
        let (position, attitude, velocity, rate) = unpack(y);
        let turn = *attitude.to_rotation_matrix().matrix();
        let grip = self.grip(&position, &turn);
        let drag = self.damping.force_n_s_m.component_mul(&velocity);
        let mut acceleration = self.gravity - drag / self.mass_kg;
        let torque = -self.damping.torque_n_m_s.component_mul(&rate) - rate.cross(&(self.inertia * rate));
        let mut angular_acceleration = self.inertia_inverse * torque;
        let due = |i: usize| {
            let speed = rate.cross(&self.points[i]);
            let centripetal = grip.q[i].dot(&(turn * rate.cross(&speed)));
            let stretching = (velocity + turn * speed).norm_squared() + centripetal;
            grip.q[i].dot(&acceleration) + grip.moment[i].dot(&angular_acceleration) + stretching
        };
        let lambda = grip.yielding * Vector2::new(due(0), due(1));
        for i in 0..2 {
            acceleration -= grip.q[i] * (lambda[i] / self.mass_kg);
            angular_acceleration -= grip.turn[i] * lambda[i];
        }
        let tension_n = [lambda[0] * self.lengths[0], lambda[1] * self.lengths[1]];
        Forces { acceleration, angular_acceleration, tension_n }
    }

    /// The same state moved onto the constraints, positions first, then velocities: by the least change, as
    /// kinetic energy measures it.
    pub fn projected(&self, y: &StateVector, iterations: usize) -> StateVector {
        let (mut position, mut attitude, mut velocity, mut rate) = unpack(y);
        for _ in 0..iterations {
            let grip = self.grip(&position, attitude.to_rotation_matrix().matrix());
            let excess = |i: usize| {
                let norm: f64 = grip.q[i].norm();
                0.5 * (norm - self.lengths[i]) * (norm + self.lengths[i])
            };
            let (shift, turn) = self.push(&grip, Vector2::new(excess(0), excess(1)));
            position -= shift;
            attitude = Rotation::new_normalize((attitude * Rotation::from_scaled_axis(-turn)).into_inner());
        }
        let grip = self.grip(&position, attitude.to_rotation_matrix().matrix());
        let stretching = |i: usize| grip.q[i].dot(&velocity) + grip.moment[i].dot(&rate);
        let (shift, turn) = self.push(&grip, Vector2::new(stretching(0), stretching(1)));
        velocity -= shift;
        rate -= turn;
        pack(&position, &attitude, &velocity, &rate)
    }

    /// The least change that moves the constraints by `amount`.
    fn push(&self, grip: &Grip, amount: Vector2<f64>) -> (Vec3, Vec3) {
        let mu = grip.yielding * amount;
        let shift = (grip.q[0] * mu[0] + grip.q[1] * mu[1]) / self.mass_kg;
        (shift, grip.turn[0] * mu[0] + grip.turn[1] * mu[1])
    }
}

/// Time derivative of the state, given the forces there.
pub(super) fn derivative(y: &StateVector, forces: &Forces) -> StateVector {
    let turning = y_quaternion(y) * Quaternion::from_imag(y.fixed_rows::<3>(10) * 0.5);
    let mut slope = StateVector::zeros();
    slope.fixed_rows_mut::<3>(0).copy_from(&y.fixed_rows::<3>(7));
    slope.fixed_rows_mut::<4>(3).copy_from(&turning.coords);
    slope.fixed_rows_mut::<3>(7).copy_from(&forces.acceleration);
    slope.fixed_rows_mut::<3>(10).copy_from(&forces.angular_acceleration);
    slope
}

fn y_quaternion(y: &StateVector) -> Quaternion<f64> {
    Quaternion::from(y.fixed_rows::<4>(3).into_owned())
}

fn unpack(y: &StateVector) -> (Vec3, Rotation, Vec3, Vec3) {
    let part = |i: usize| Vec3::new(y[i], y[i + 1], y[i + 2]);
    (part(0), Rotation::new_normalize(y_quaternion(y)), part(7), part(10))
}

fn pack(position: &Vec3, attitude: &Rotation, velocity: &Vec3, rate: &Vec3) -> StateVector {
    let mut y = StateVector::zeros();
    y.fixed_rows_mut::<3>(0).copy_from(position);
    y.fixed_rows_mut::<4>(3).copy_from(&attitude.coords);
    y.fixed_rows_mut::<3>(7).copy_from(velocity);
    y.fixed_rows_mut::<3>(10).copy_from(rate);
    y
}

impl State {
    pub(super) fn to_vector(self) -> StateVector {
        let Pose { position_m, world_from_body } = &self.pose;
        pack(position_m, world_from_body, &self.velocity_m_s, &self.angular_rate_rad_s)
    }
}

impl From<&StateVector> for State {
    fn from(y: &StateVector) -> Self {
        let (position_m, world_from_body, velocity_m_s, angular_rate_rad_s) = unpack(y);
        Self { pose: Pose { position_m, world_from_body }, velocity_m_s, angular_rate_rad_s }
    }
}
