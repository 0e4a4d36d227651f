//! The incline test: depth of the centre of mass from a weight at one end or at both (eqs. 20, 21),
//! and the tilt from a phone's gravity before and after.

use std::f64::consts::FRAC_PI_2;

use super::domain::{between, finite, positive, result};
use gyradius_base::frames::Vec3;
use gyradius_base::{Error, Result};

/// The weight at one end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// Its mass over the hull's (the hull's without it).
    pub mass_ratio: f64,
    /// L_s: horizontal distance from the suspension points, hull level, m.
    pub arm_m: f64,
    /// b_s: depth below the suspension points, hull level, m.
    pub depth_m: f64,
    /// Angle it makes, rad, counted positive towards the weight.
    pub angle_rad: f64,
}

/// Depth of the centre of mass below the suspension points, m, from one end.
pub fn cm_depth_m(weight: &Weight) -> Result<f64> {
    let ratio = positive("mass_ratio", weight.mass_ratio)?;
    let tan = between("angle_rad", weight.angle_rad, 0.0, FRAC_PI_2)?.tan();
    let arm = positive("arm_m", weight.arm_m)?;
    let depth = ratio * (arm / tan - finite("depth_m", weight.depth_m)?); // (20)
    deep("incline test", depth)
}

/// Both ends, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BothEnds {
    /// Mass of the weight over the hull's.
    pub mass_ratio: f64,
    /// L_0: distance between the two places of the weight along the hull, m.
    pub length_m: f64,
    /// b_b: depth of the place at the bow, m.
    pub bow_depth_m: f64,
    /// b_s: depth of the place at the stern, m.
    pub stern_depth_m: f64,
    /// Angle with the weight at the bow, rad, positive.
    pub bow_angle_rad: f64,
    /// Angle with the weight at the stern, rad, positive.
    pub stern_angle_rad: f64,
}

/// Depth from both ends: where the suspension points stand along the hull is not needed.
pub fn cm_depth_from_both_ends_m(test: &BothEnds) -> Result<f64> {
    let ratio = positive("mass_ratio", test.mass_ratio)?;
    let length = positive("length_m", test.length_m)?;
    let bow = between("bow_angle_rad", test.bow_angle_rad, 0.0, FRAC_PI_2)?.tan();
    let stern = between("stern_angle_rad", test.stern_angle_rad, 0.0, FRAC_PI_2)?.tan();
    let depths = finite("bow_depth_m", test.bow_depth_m)? * bow
        + finite("stern_depth_m", test.stern_depth_m)? * stern;
    deep("incline test", ratio * (length - depths) / (bow + stern)) // (21)
}

/// Depth from moving the suspension points by `shift_m` along the deck and the tilt that follows:
/// l2 = Δ / tan φ.
pub fn cm_depth_from_shift_m(shift_m: f64, angle_rad: f64) -> Result<f64> {
    let tan = between("angle_rad", angle_rad, -FRAC_PI_2, FRAC_PI_2)?.tan();
    deep("suspension shift", finite("shift_m", shift_m)? / tan)
}

fn deep(what: &str, depth: f64) -> Result<f64> {
    if depth > 0.0 {
        result(what, depth)
    } else {
        Err(Error::no_result(
            what,
            format!("the centre of mass comes out {depth} m below the suspension points"),
        ))
    }
}

/// Angle between two directions of gravity as one sensor saw them, rad, 0 to π. Any orientation,
/// any scale.
pub fn tilt_rad(before: &Vec3, after: &Vec3) -> Result<f64> {
    for (name, vector) in [("before", before), ("after", after)] {
        if !vector.iter().all(|x| x.is_finite()) || vector.norm() == 0.0 {
            return Err(Error::argument(
                name,
                "a vector of finite length greater than 0",
                format!("{vector:?}"),
            ));
        }
    }
    let (a, b) = (before.normalize(), after.normalize());
    Ok(a.cross(&b).norm().atan2(a.dot(&b)))
}
