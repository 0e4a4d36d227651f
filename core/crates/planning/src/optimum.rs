//! Dimensions at which a gyradius depends least on what is measured.

use serde::{Deserialize, Serialize};

use super::hull::Hull;
use gyradius_base::error::Result;
use gyradius_identification::routes::double_pendulum::{
    DepthIs, GyradiusAndDepth, best_line_length_m,
};

/// The best dimensions for a hull, whether there is room for them or not.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Optima {
    /// Line length for the pitch gyradius with the depth of the centre of mass held as known, by
    /// (19), m: Figs. 16 and 17 of the paper.
    pub line_length_depth_known_m: Option<f64>,
    /// The same with gyradius and depth both solved for from the two periods, (17) and (18), m.
    pub line_length_joint_m: Option<f64>,
    /// The same two for the roll gyradius, on lines fore and aft.
    pub line_length_roll_depth_known_m: Option<f64>,
    /// With both solved for.
    pub line_length_roll_joint_m: Option<f64>,
    /// Twice the yaw gyradius, m: near to it yaw and sway keep step and the lines' length and
    /// gravity cancel out of the ratio of their periods (8); exactly there they do not beat.
    pub spacing_m: f64,
    /// Depth a = k of the centre of mass below the axis of a compound pendulum at which an error of
    /// a does not matter (24), in pitch, m.
    pub compound_pitch_axis_to_cm_m: f64,
    /// Height of that axis above the suspension points, a − l2, m; below zero it cannot be had.
    pub compound_pitch_axis_height_m: f64,
    /// The same in roll.
    pub compound_roll_axis_to_cm_m: f64,
    /// Height of the axis in roll, m.
    pub compound_roll_axis_height_m: f64,
}

impl Optima {
    /// Of a hull.
    pub fn of(hull: &Hull, gravity_m_s2: f64) -> Self {
        let (pitch, roll) = (hull.k_pitch_m.value, hull.k_roll_m.value);
        let depth = hull.cm_depth_m.value;
        // A hull so shallow that there is no optimum within any length has none to tell.
        let best = |gyradius_m: f64, is: DepthIs| {
            best_line_length_m(
                &GyradiusAndDepth {
                    gyradius_m,
                    cm_depth_m: depth,
                },
                gravity_m_s2,
                is,
            )
            .ok()
        };
        Self {
            line_length_depth_known_m: best(pitch, DepthIs::Known),
            line_length_joint_m: best(pitch, DepthIs::SolvedFor),
            line_length_roll_depth_known_m: best(roll, DepthIs::Known),
            line_length_roll_joint_m: best(roll, DepthIs::SolvedFor),
            spacing_m: 2.0 * hull.k_yaw_m.value,
            compound_pitch_axis_to_cm_m: pitch,
            compound_pitch_axis_height_m: pitch - depth,
            compound_roll_axis_to_cm_m: roll,
            compound_roll_axis_height_m: roll - depth,
        }
    }
}

/// L12 = l1/l2 at which ∂k_p/∂T is least for K_P2 = k_p/l2: one point of Fig. 17 (depth known), or
/// of the same with both solved for. Independent of gravity.
///
/// # Errors
/// Where `k_over_depth` is no positive number or has no optimum.
pub fn best_length_over_depth(k_over_depth: f64, depth: DepthIs) -> Result<f64> {
    best_line_length_m(
        &GyradiusAndDepth {
            gyradius_m: k_over_depth,
            cm_depth_m: 1.0,
        },
        1.0,
        depth,
    )
}

/// Line length at which yaw (5) and the in-phase pitch mode (16) have one period, m; `None` where
/// they have at no length: from d = k_yaw on, yaw is faster than the sway, and the in-phase mode
/// always slower.
///
/// With r = (d/k_y)², ω² = r g/l put into l k² ω⁴ − g (l l2 + l2² + k²) ω² + g² l2 = 0 is linear in
/// l.
pub fn yaw_meets_in_phase_m(
    half_spacing_m: f64,
    k_yaw_m: f64,
    k_pitch_m: f64,
    cm_depth_m: f64,
) -> Option<f64> {
    let r = (half_spacing_m / k_yaw_m).powi(2);
    let (k2, l2) = (k_pitch_m * k_pitch_m, cm_depth_m);
    let length = r * (l2 * l2 + k2 * (1.0 - r)) / (l2 * (1.0 - r));
    (r < 1.0 && length.is_finite() && length > 0.0).then_some(length)
}
