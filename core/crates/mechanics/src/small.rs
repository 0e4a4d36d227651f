//! Small oscillations of the body about its rest pose: four modes of six coordinates less two
//! lines.

use nalgebra::{Matrix4, Matrix6, Matrix6x4, SymmetricEigen, Vector4, Vector6};

use super::constraint::mass_matrix;
use super::equilibrium::{Equilibrium, Newton, equilibrium};
use super::rig::{Rig, RigidBody};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;

/// The four modes, slowest first.
///
/// # Conventions
/// `shapes[i]` is `[δr; θ]`: displacement of the centre of mass, m, and small rotation vector, rad,
/// both in world axes, per unit of the modal coordinate; shapes are normalised by mass (½ q̇² is
/// the kinetic energy).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmallModes {
    /// The rest pose.
    pub equilibrium: Equilibrium,
    /// Angular frequencies, rad/s, ascending.
    pub omega_rad_s: [f64; 4],
    /// Mass-normalised shapes.
    pub shapes: [[f64; 6]; 4],
}

impl SmallModes {
    /// Period of mode `i`, s.
    pub fn period_s(&self, i: usize) -> f64 {
        std::f64::consts::TAU / self.omega_rad_s[i]
    }

    /// Rotation per unit of the modal coordinate, world axes, rad.
    pub fn rotation(&self, i: usize) -> Vec3 {
        Vec3::from_column_slice(&self.shapes[i][3..])
    }

    /// Displacement of the centre of mass per unit of the modal coordinate, world axes, m.
    pub fn displacement(&self, i: usize) -> Vec3 {
        Vec3::from_column_slice(&self.shapes[i][..3])
    }
}

/// What effects add to the small oscillations of a body on its lines.
///
/// # Conventions
/// Matrices act on `[δr; θ]` as the shapes of [`SmallModes`] have it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SmallEffects {
    /// Beside the stiffness that gravity and the lines give.
    pub stiffness: Matrix6<f64>,
    /// Mass that moves along without weight.
    pub mass: Matrix6<f64>,
    /// How far what the lines hang from gives way along each world axis, m/N; its own mass is left
    /// out.
    pub support_m_n: Vec3,
}

impl SmallModes {
    /// The modes with effects beside: exact for small oscillations about the same rest pose, as the
    /// lines leave the body the same four coordinates.
    ///
    /// A support that gives by s/F lets the body follow by the same: to the flexibility K⁻¹ of the
    /// modal coordinates is added w wᵀ s/F, w the pull on the support by unit modal forces.
    pub fn with(&self, body: &RigidBody, effects: &SmallEffects) -> Result<Self> {
        let shapes = Matrix6x4::from_fn(|row, mode| self.shapes[mode][row]);
        let squares = Vector4::from(self.omega_rad_s.map(|omega| omega * omega));
        let stiffness =
            Matrix4::from_diagonal(&squares) + shapes.transpose() * effects.stiffness * shapes;
        let mass = Matrix4::identity() + shapes.transpose() * effects.mass * shapes;
        let mut flexibility = stiffness
            .try_inverse()
            .ok_or_else(|| failed("the stiffness is singular"))?;
        for axis in 0..3 {
            let pull = shapes.row(axis).transpose() * body.mass_kg;
            flexibility += pull * pull.transpose() * effects.support_m_n[axis];
        }
        let lower = mass
            .cholesky()
            .ok_or_else(|| failed("the mass matrix is singular"))?
            .l();
        let upper_inverse = lower
            .transpose()
            .try_inverse()
            .ok_or_else(|| failed("the mass matrix is singular"))?;
        let eigen = SymmetricEigen::new(lower.transpose() * flexibility * lower);
        let mut order = [0, 1, 2, 3];
        order.sort_by(|&i, &j| eigen.eigenvalues[j].total_cmp(&eigen.eigenvalues[i]));
        if eigen.eigenvalues[order[3]] <= 0.0 {
            return Err(failed("the rest pose is not stable"));
        }
        let changed = shapes * upper_inverse * eigen.eigenvectors;
        Ok(Self {
            equilibrium: self.equilibrium,
            omega_rad_s: order.map(|i| 1.0 / eigen.eigenvalues[i].sqrt()),
            shapes: order.map(|i| changed.column(i).into_owned().into()),
        })
    }
}

/// Small oscillations about the rest pose.
pub fn small_modes(rig: &Rig, body: &RigidBody) -> Result<SmallModes> {
    let rest = equilibrium(rig, body)?;
    let newton = Newton::at(rig, body, &rest.pose)
        .ok_or_else(|| failed("the lines do not hold the body"))?;
    let reduced = |full: nalgebra::Matrix6<f64>| -> Matrix4<f64> {
        newton.free.transpose() * full * newton.free
    };
    let mass = reduced(mass_matrix(body, &rest.pose));
    let lower = mass
        .cholesky()
        .ok_or_else(|| failed("the mass matrix is singular"))?
        .l();
    let lower_inverse = lower
        .try_inverse()
        .ok_or_else(|| failed("the mass matrix is singular"))?;
    let dynamic = lower_inverse * reduced(newton.stiffness) * lower_inverse.transpose();
    let eigen = SymmetricEigen::new((dynamic + dynamic.transpose()) * 0.5);
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    let shapes = newton.free * lower_inverse.transpose() * eigen.eigenvectors;
    if eigen.eigenvalues[order[0]] <= 0.0 {
        return Err(failed("the rest pose is not stable"));
    }
    Ok(SmallModes {
        equilibrium: rest,
        omega_rad_s: order.map(|i| eigen.eigenvalues[i].sqrt()),
        shapes: order.map(|i| shapes.column(i).into_owned().into()),
    })
}

fn failed(reason: &str) -> Error {
    Error::no_result("small oscillations", reason)
}

/// What a mode is, by its motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModeKind {
    /// Turns about the vertical.
    Yaw,
    /// Translates along the line that joins the suspension points: a simple pendulum.
    SwayLine,
    /// Turns about that line, hull and lines swinging to the same side: the long period.
    DoublePendulumInPhase,
    /// The same, to opposite sides: the short period.
    DoublePendulumOutOfPhase,
}

/// Names a mode by where its kinetic energy is; `axis` is the horizontal unit vector that joins the
/// suspension points ([`Rig::axis`]).
///
/// Errata to eq. (16): "in phase" is the long period, whatever the number of the mode.
pub fn mode_kind(body: &RigidBody, shape: &[f64; 6], axis: Vec3) -> ModeKind {
    let shape = Vector6::from_column_slice(shape);
    let shift: Vec3 = shape.fixed_rows::<3>(0).into_owned();
    let turn: Vec3 = shape.fixed_rows::<3>(3).into_owned();
    let across = axis.cross(&Vec3::z());
    let shifting = |e: &Vec3| body.mass_kg * shift.dot(e).powi(2);
    let turning = |e: &Vec3| e.dot(&(body.inertia_kg_m2 * e)) * turn.dot(e).powi(2);
    let yaw = turning(&Vec3::z());
    let sway = shifting(&axis) + turning(&across);
    let pendulum = shifting(&across) + turning(&axis);
    if yaw >= sway && yaw >= pendulum {
        ModeKind::Yaw
    } else if sway >= pendulum {
        ModeKind::SwayLine
    } else if shift.dot(&across) * turn.dot(&axis) < 0.0 {
        // Only the lines push the centre of mass sideways, so it is displaced to the side they lean
        // to; a centre of mass that leans to +across needs a negative turn about the axis.
        ModeKind::DoublePendulumInPhase
    } else {
        ModeKind::DoublePendulumOutOfPhase
    }
}

/// Period of a compound pendulum of gyradius k that swings about an axis a above its centre of
/// mass, eq. (22).
pub fn compound_pendulum_period_s(gyradius_m: f64, axis_height_m: f64, gravity_m_s2: f64) -> f64 {
    let reduced_length_m =
        (gyradius_m * gyradius_m + axis_height_m * axis_height_m) / axis_height_m;
    std::f64::consts::TAU * (reduced_length_m / gravity_m_s2).sqrt()
}
