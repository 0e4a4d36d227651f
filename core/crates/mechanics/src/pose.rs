//! Where a body is and how it is turned.

use nalgebra::Vector6;

use gyradius_base::frames::{Rotation, Vec3};

/// Where a body is and how it is turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Centre of mass, world axes, m.
    pub position_m: Vec3,
    /// From hanging (body) axes to world axes.
    pub world_from_body: Rotation,
}

impl Pose {
    /// The pose displaced by `[δr; θ]`, world axes.
    pub(super) fn displaced(&self, step: &Vector6<f64>) -> Self {
        let turn = Rotation::from_scaled_axis(step.fixed_rows::<3>(3).into_owned());
        Self {
            position_m: self.position_m + step.fixed_rows::<3>(0),
            world_from_body: Rotation::new_normalize((turn * self.world_from_body).into_inner()),
        }
    }
}
