//! What an ideal phone fixed to the body feels: no noise, no bias, no bandwidth.

use super::trajectory::Trajectory;
use gyradius_base::frames::{Rotation, Vec3};

/// The readings of an ideal phone, phone axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct IdealPhone {
    /// Angular rate, rad/s.
    pub gyro_rad_s: Vec<Vec3>,
    /// Specific force (acceleration less gravity: +g upwards at rest), m/s².
    pub specific_force_m_s2: Vec<Vec3>,
}

/// Readings of a phone at `phone_position_hull_m`, from the mid-point of the suspension points.
///
/// # Conventions
/// Position and `hull_from_phone` are in the axes of the body that was simulated; where it was
/// turned into hanging axes ([`super::RigidBody::rotated`]), turn the phone alike.
pub fn ideal_phone(
    motion: &Trajectory,
    phone_position_hull_m: Vec3,
    hull_from_phone: Rotation,
) -> IdealPhone {
    let arm = phone_position_hull_m - motion.cm_m;
    let phone_from_hull = hull_from_phone.inverse();
    let up = Vec3::new(0.0, 0.0, motion.gravity_m_s2);
    let specific_force = |i: usize| {
        let (rate, angular) = (
            motion.angular_rate_rad_s[i],
            motion.angular_acceleration_rad_s2[i],
        );
        let centre = motion.world_from_hull[i].inverse() * (motion.acceleration_m_s2[i] + up);
        phone_from_hull * (centre + angular.cross(&arm) + rate.cross(&rate.cross(&arm)))
    };
    IdealPhone {
        gyro_rad_s: motion
            .angular_rate_rad_s
            .iter()
            .map(|rate| phone_from_hull * rate)
            .collect(),
        specific_force_m_s2: (0..motion.t_s.len()).map(specific_force).collect(),
    }
}
