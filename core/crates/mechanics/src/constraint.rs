//! The lengths of the lines as constraints, to second order in a displacement of the body.
//!
//! # Conventions
//! The constraint of line i is c = (|q|² − l²)/2 with q from its upper to its lower end. A
//! displacement is `[δr; θ]`: δr of the centre of mass, θ a rotation vector, both in world axes,
//! applied as `R ← exp([θ]×) R`. The line's force on the body is −λ q, so that the tension is λ l.

use nalgebra::{Matrix2x6, Matrix6, SMatrix, Vector2, Vector6};

use super::pose::Pose;
use super::rig::{Rig, RigidBody};
use gyradius_base::frames::{Mat3, Vec3};

/// One line in one pose.
pub(super) struct Reach {
    /// From the upper to the lower end, world axes, m.
    pub q: Vec3,
    /// From the centre of mass to the lower end, world axes, m.
    pub b: Vec3,
    length_m: f64,
}

/// Both lines in a pose.
pub(super) fn reaches(rig: &Rig, body: &RigidBody, pose: &Pose) -> [Reach; 2] {
    rig.lines.map(|line| {
        let b = pose.world_from_body * (line.hull_point_m - body.cm_m);
        Reach {
            q: pose.position_m + b - line.top_m,
            b,
            length_m: line.length_m,
        }
    })
}

impl Reach {
    /// (|q|² − l²)/2, as a product so that it does not lose digits.
    pub fn excess(&self) -> f64 {
        let norm = self.q.norm();
        0.5 * (norm - self.length_m) * (norm + self.length_m)
    }

    fn gradient(&self) -> Vector6<f64> {
        let moment = self.b.cross(&self.q);
        Vector6::new(self.q.x, self.q.y, self.q.z, moment.x, moment.y, moment.z)
    }

    /// Second derivative, the second-order part ½ θ×(θ×b) of the rotation included.
    pub fn hessian(&self) -> Matrix6<f64> {
        let mut point = SMatrix::<f64, 3, 6>::zeros();
        point
            .fixed_view_mut::<3, 3>(0, 0)
            .copy_from(&Mat3::identity());
        point
            .fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&-self.b.cross_matrix());
        let mut hessian = point.transpose() * point;
        let outer = self.q * self.b.transpose();
        let turning = (outer + outer.transpose()) * 0.5 - Mat3::identity() * self.q.dot(&self.b);
        let mut corner = hessian.fixed_view_mut::<3, 3>(3, 3);
        corner += turning;
        hessian
    }
}

/// Gradients of both constraints, one per row.
pub(super) fn jacobian(reaches: &[Reach; 2]) -> Matrix2x6<f64> {
    Matrix2x6::from_rows(&[
        reaches[0].gradient().transpose(),
        reaches[1].gradient().transpose(),
    ])
}

/// Values of both constraints, m².
pub(super) fn excesses(reaches: &[Reach; 2]) -> Vector2<f64> {
    Vector2::new(reaches[0].excess(), reaches[1].excess())
}

/// Mass matrix of `[δr; θ]`, world axes.
pub(super) fn mass_matrix(body: &RigidBody, pose: &Pose) -> Matrix6<f64> {
    let turn = pose.world_from_body.to_rotation_matrix();
    let inertia = turn.matrix() * body.inertia_kg_m2 * turn.matrix().transpose();
    let mut mass = Matrix6::identity() * body.mass_kg;
    mass.fixed_view_mut::<3, 3>(3, 3).copy_from(&inertia);
    mass
}

/// Orthonormal basis of the displacements that stretch no line: Gram–Schmidt, always on the unit
/// vector that has most left, twice for orthogonality to rounding.
pub(super) fn free_directions(jacobian: &Matrix2x6<f64>) -> Option<SMatrix<f64, 6, 4>> {
    let mut basis = Vec::with_capacity(6);
    for row in jacobian.row_iter() {
        basis.push(perpendicular(row.transpose(), &basis)?);
    }
    while basis.len() < 6 {
        let left = |k: usize| {
            1.0 - basis
                .iter()
                .map(|b: &Vector6<f64>| b[k] * b[k])
                .sum::<f64>()
        };
        let best = (0..6).max_by(|&i, &j| left(i).total_cmp(&left(j)))?;
        basis.push(perpendicular(Vector6::ith(best, 1.0), &basis)?);
    }
    Some(SMatrix::from_columns(&basis[2..]))
}

fn perpendicular(mut vector: Vector6<f64>, basis: &[Vector6<f64>]) -> Option<Vector6<f64>> {
    let size = vector.norm();
    for _ in 0..2 {
        for b in basis {
            vector -= b * b.dot(&vector);
        }
    }
    vector.try_normalize(1e-10 * size)
}
