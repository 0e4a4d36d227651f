//! Small turns on top of large ones.

use gyradius_base::frames::{Mat3, Vec3};

/// Turns (rad, about the axes that are turned) that a change of a rotation vector brings on top of
/// it: `exp(v + δ) = exp(v)·exp(J δ)` to first order. The right Jacobian of the rotations (G. S.
/// Chirikjian, *Stochastic Models, Information Theory, and Lie Groups*, vol. 2 (2012), sec. 10.6).
pub fn turn_slopes(v: Vec3) -> Mat3 {
    /// Below this the next terms of both series are rounding.
    const SMALL_RAD: f64 = 1e-4;
    let (cross, angle) = (v.cross_matrix(), v.norm());
    let (first, second) = if angle < SMALL_RAD {
        (0.5, 1.0 / 6.0)
    } else {
        let half = (0.5 * angle).sin() / angle;
        (2.0 * half * half, (angle - angle.sin()) / angle.powi(3))
    };
    Mat3::identity() - cross * first + cross * cross * second
}

#[cfg(test)]
mod tests {
    use super::*;
    use gyradius_base::frames::Rotation;

    #[test]
    fn a_change_of_a_turn_is_a_turn_on_top_of_it() {
        let step = 1e-6;
        for v in [
            Vec3::new(0.4, -1.1, 0.7),
            Vec3::new(2.0, 1.0, -1.5),
            Vec3::new(3e-5, -2e-5, 5e-5),
            Vec3::zeros(),
        ] {
            let slopes = turn_slopes(v);
            for k in 0..3 {
                let there = |sign: f64| Rotation::new(v + Vec3::ith(k, sign * step));
                let turned = there(-1.0).inverse() * there(1.0);
                let by_differences = turned.scaled_axis() / (2.0 * step);
                assert!((by_differences - slopes.column(k)).norm() < 1e-8, "{v}");
            }
        }
    }
}
