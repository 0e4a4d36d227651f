//! Vectors, rotations and the frames they live in.
//!
//! # Conventions
//! Hull axes: x forward, y to port, z up. A rotation is named by what it maps: `world_from_hull`
//! takes a vector given in hull axes to world axes, and chains read `world_from_phone =
//! world_from_hull * hull_from_phone`. Pitch (bow-up) angle φ > 0 is a *negative* right-handed turn
//! about +y (port): the bow rises.

/// A vector of three components, m, rad/s or m/s² as its name says.
pub type Vec3 = nalgebra::Vector3<f64>;
/// A 3 × 3 matrix.
pub type Mat3 = nalgebra::Matrix3<f64>;
/// A proper rotation.
pub type Rotation = nalgebra::UnitQuaternion<f64>;

/// Hull-to-world rotation of a hull pitched bow up by `bow_up_rad`.
pub fn world_from_hull_pitched(bow_up_rad: f64) -> Rotation {
    Rotation::from_axis_angle(&Vec3::y_axis(), -bow_up_rad)
}

/// The same of a hull that is heeled about its own x axis first, starboard down by `heel_rad`: a
/// right-handed turn about x, which is forward.
pub fn world_from_hull_heeled(bow_up_rad: f64, heel_rad: f64) -> Rotation {
    world_from_hull_pitched(bow_up_rad) * Rotation::from_axis_angle(&Vec3::x_axis(), heel_rad)
}
