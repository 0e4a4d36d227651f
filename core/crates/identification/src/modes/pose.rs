//! The phone's orientation on the hull, as far as a swing shows it.
//!
//! # Conventions
//! `up` and all directions are unit vectors in phone axes. Horizontal directions have no sign: fore
//! and aft, port and starboard look alike to a swing; a stated pitch or an incline tells them
//! apart.

use super::motion::{ChannelMap, PhoneMotion};
use super::naming::NamedMode;
use gyradius_base::frames::Vec3;
use gyradius_recording::ModeName;
use gyradius_signal::Decomposition;

/// The vertical in phone axes and the size of the mean specific force, m/s²; none without an
/// accelerometer that sees gravity.
pub fn up_direction(found: &Decomposition, map: ChannelMap) -> Option<(Vec3, f64)> {
    let first = map.accelerometer.filter(|_| !map.gravity_free)?;
    let force = Vec3::from_fn(|i, _| found.level.get(first + i).copied().unwrap_or(0.0));
    let size = force.norm();
    // A tenth of gravity: anything less is not a rest reading of an accelerometer.
    (size > 1.0).then(|| (force / size, size))
}

/// The level direction of the line through the suspension points: a sway goes along it, a double
/// pendulum turns about it.
pub fn line_direction(motions: &[PhoneMotion], named: &[NamedMode], up: &Vec3) -> Option<Vec3> {
    let strongest = named
        .iter()
        .zip(motions)
        .filter(|(n, _)| is_level_motion(n.name))
        .max_by(|a, b| {
            a.0.angle_rad
                .unwrap_or(0.0)
                .total_cmp(&b.0.angle_rad.unwrap_or(0.0))
        })?;
    let vector = match strongest.0.name {
        ModeName::Sway => strongest.1.acceleration_m_s2,
        _ => strongest.1.rotation_rad,
    }?;
    PhoneMotion::principal_direction(&vector, up)
}

fn is_level_motion(name: ModeName) -> bool {
    !matches!(name, ModeName::Yaw | ModeName::Other)
}

/// The angle between the verticals of two swings with the phone taped on alike, rad, unsigned.
pub fn tilt_between_rad(up_a: &Vec3, up_b: &Vec3) -> f64 {
    up_a.cross(up_b).norm().atan2(up_a.dot(up_b))
}
