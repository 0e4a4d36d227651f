//! The phone's turn while a fit runs: tilts about two horizontal axes, then a heading about the
//! vertical.
//!
//! Gravity sees the tilts alone, to minutes of arc; the heading of a hull that only yaws shows in
//! nothing. Three numbers that mix them bend the way to the minimum, and a fit creeps along it.

use gyradius_base::frames::{Mat3, Rotation, Vec3};
use nalgebra::Matrix6;

/// `hanging_from_phone` and the phone's place (hanging axes, m) after a turn, from those before it.
/// The place goes with the heading: what a phone feels of a yaw shows its place in its own axes.
pub fn turned(turn: Vec3, nominal: &Rotation, place_m: Vec3) -> (Rotation, Vec3) {
    let (tilt, heading) = parts(turn);
    (heading * tilt * nominal, heading * place_m)
}

fn parts(turn: Vec3) -> (Rotation, Rotation) {
    let tilt = Rotation::new(Vec3::new(turn.x, turn.y, 0.0));
    (tilt, Rotation::new(Vec3::z() * turn.z))
}

/// Of changes of the place's three numbers and of the turn's: the move (m, hanging axes), then the
/// turn on top of that before it (rad, phone axes), to first order.
pub fn turned_slopes(turn: Vec3, nominal: &Rotation, place_m: Vec3) -> Matrix6<f64> {
    let (tilt, heading) = parts(turn);
    let phone_from_hanging = nominal.inverse();
    let by_tilt = phone_from_hanging.to_rotation_matrix().into_inner()
        * turn_slopes(Vec3::new(turn.x, turn.y, 0.0));
    let by_heading = phone_from_hanging * (tilt.inverse() * Vec3::z());
    let mut slopes = Matrix6::zeros();
    let moved = heading.to_rotation_matrix().into_inner();
    slopes.fixed_view_mut::<3, 3>(0, 0).copy_from(&moved);
    slopes
        .fixed_view_mut::<3, 1>(0, 5)
        .copy_from(&Vec3::z().cross(&(heading * place_m)));
    slopes.fixed_view_mut::<3, 3>(3, 3).copy_from(&by_tilt);
    slopes.fixed_view_mut::<3, 1>(3, 5).copy_from(&by_heading);
    slopes
}

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

    /// Central differences of [`turned`].
    #[test]
    fn a_change_of_a_turn_is_a_turn_on_top_of_it() {
        let (step, place_m) = (1e-6, Vec3::new(0.6, -0.2, 0.1));
        let nominal = Rotation::new(Vec3::new(1.2, -0.4, 2.0));
        for turn in [
            Vec3::new(0.4, -1.1, 0.7),
            Vec3::new(2.0, 1.0, -1.5),
            Vec3::new(3e-5, -2e-5, 5e-5),
            Vec3::zeros(),
        ] {
            let slopes = turned_slopes(turn, &nominal, place_m);
            for k in 0..6 {
                let there = |sign: f64| {
                    let by = |from: usize| {
                        let unit = |i: usize| if from + i == k { sign * step } else { 0.0 };
                        Vec3::from_fn(|i, _| unit(i))
                    };
                    turned(turn + by(3), &nominal, place_m + by(0))
                };
                let ((before, from_m), (after, to_m)) = (there(-1.0), there(1.0));
                let on_top = (before.inverse() * after).scaled_axis() / (2.0 * step);
                let column = slopes.column(k);
                assert!(
                    (on_top - column.fixed_rows::<3>(3)).norm() < 1e-8,
                    "{turn} {k}"
                );
                let moved = (to_m - from_m) / (2.0 * step);
                assert!(
                    (moved - column.fixed_rows::<3>(0)).norm() < 1e-8,
                    "{turn} {k}"
                );
            }
        }
    }
}
