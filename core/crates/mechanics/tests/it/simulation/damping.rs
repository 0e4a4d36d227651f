//! What takes energy from the swing, against the equation of a pure yaw integrated apart and
//! against closed laws.

use std::f64::consts::{PI, TAU};

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_mechanics::{Fineness, Scene};

use crate::simulation::scenes::*;

/// Steps that cross a kink have errors of 1e-9 each; there are some hundred of them.
const KINKS: f64 = 2e-7;

/// Stiffness of a small yaw, N m/rad: m g d²/l.
const STIFFNESS: f64 = MASS_KG * G * HALF_SPACING_M * HALF_SPACING_M / LINE_M;

fn omega() -> f64 {
    (STIFFNESS / YAW_INERTIA).sqrt()
}

/// Sizes of the swing at its extremes: times and headings where the rate is zero.
fn extremes(scene: &Scene, duration_s: f64) -> Vec<(f64, f64)> {
    let path = scene.motion(duration_s).unwrap();
    zeros(&path, |m| m.rate.z)
        .into_iter()
        .map(|t| (t, heading(&path.at(t)).abs()))
        .collect()
}

#[test]
fn linear_damping_of_a_yaw() {
    let scene = with(
        keelboat(yawed(0.2)),
        "linear_damping",
        &[("yaw_n_m_s", 20.0)],
    );
    assert!(worst_yaw(&scene, 60.0, |_, _, rate, _| [-20.0 * rate, 0.0, 0.0]) < 1e-9);
}

/// Fits compute motions less finely.
#[test]
fn damping_of_a_yaw_as_fits_see_it() {
    let scene = with(
        keelboat(yawed(0.2)),
        "linear_damping",
        &[("yaw_n_m_s", 20.0)],
    );
    assert!(
        worst_yaw_as(Fineness::OF_FITS, &scene, 120.0, |_, _, rate, _| [
            -20.0 * rate,
            0.0,
            0.0
        ]) < 1e-6
    );
}

#[test]
fn quadratic_drag_of_a_yaw() {
    let scene = with(
        keelboat(yawed(0.2)),
        "quadratic_drag",
        &[("yaw_torque_coefficient", 120.0)],
    );
    assert!(
        worst_yaw(&scene, 120.0, |_, _, rate, _| [
            -120.0 * rate * rate.abs(),
            0.0,
            0.0
        ]) < KINKS
    );
    // 1/θ grows by 4 c ω/(3π I) in each second (energy of a harmonic swing; right to the square of
    // the decrement).
    let seen = extremes(&scene, 120.0);
    let (first, last) = (seen[0], seen[seen.len() - 1]);
    let slope = (1.0 / last.1 - 1.0 / first.1) / (last.0 - first.0);
    println!("1/θ grows by {slope} /s");
    assert_close(
        slope,
        4.0 * 120.0 * omega() / (3.0 * PI * YAW_INERTIA),
        0.01,
    );
}

#[test]
fn power_law_damping_of_a_yaw() {
    let numbers = [("exponent", 0.3), ("yaw_n_m_s", 30.0)];
    let scene = with(keelboat(yawed(0.2)), "power_law_damping", &numbers);
    let law = |rate: f64| -30.0 * ((rate / 0.1).powi(2) + 1e-8).powf(0.15) * rate;
    assert!(worst_yaw(&scene, 60.0, |_, _, rate, _| [law(rate), 0.0, 0.0]) < KINKS);
    // Errata: τ ∝ θ^(−β), so that θ^(−β) grows evenly: its slope early and late is the same.
    let seen = extremes(&scene, 240.0);
    let powered: Vec<f64> = seen.iter().map(|(_, size)| size.powf(-0.3)).collect();
    let n = powered.len();
    let slope = |i: usize, j: usize| (powered[j] - powered[i]) / (seen[j].0 - seen[i].0);
    println!("from {} to {} rad", seen[0].1, seen[n - 1].1);
    assert!(seen[n - 1].1 < 0.3 * seen[0].1);
    assert_close(slope(n / 2, n - 1), slope(0, n / 2), 0.005);
}

#[test]
fn dry_friction_takes_the_same_angle_off_every_swing() {
    let numbers = [("yaw_n_m", 2.0), ("transition_rad_s", 1e-3)];
    let scene = with(keelboat(yawed(0.1)), "bearing_friction", &numbers);
    assert!(
        worst_yaw(&scene, 60.0, |_, _, rate, _| [
            -2.0 * (rate / 1e-3).tanh(),
            0.0,
            0.0
        ]) < KINKS
    );
    // Half a swing loses 2 M_c/K; the transition takes a part in ω_t²/rate² of it.
    let seen = extremes(&scene, 60.0);
    for pair in seen.windows(2) {
        assert_close(pair[0].1 - pair[1].1, 2.0 * 2.0 / STIFFNESS, 0.01);
    }
}

#[test]
fn a_bearing_that_gives_is_a_spring_at_small_angles() {
    let numbers = [("yaw_n_m", 5.0), ("give_rad", 2e-3)];
    let dahl = |yaw_rad| with(keelboat(yawed(yaw_rad)), "presliding_bearing", &numbers);
    for yaw_rad in [0.1, 1e-3] {
        let law =
            |_: f64, _: f64, rate: f64, z: f64| [-5.0 * z, 0.0, (rate - rate.abs() * z) / 2e-3];
        assert!(worst_yaw(&dahl(yaw_rad), 60.0, law) < KINKS);
    }
    // Far within θ_s the stiffness is K + M_c/θ_s.
    let mut tiny = dahl(0.0);
    tiny.start.yaw_rad_s = 1e-7;
    let small = period_s(&tiny.motion(60.0).unwrap(), heading);
    assert_close(
        small,
        TAU * (YAW_INERTIA / (STIFFNESS + 5.0 / 2e-3)).sqrt(),
        1e-4,
    );
    // Wide swings are slower: the spring gives way.
    assert!(period_s(&dahl(0.1).motion(12.0).unwrap(), heading) > 1.3 * small);
}

#[test]
fn drag_of_a_sway() {
    // A pendulum whose hull stays level: the force acts along the hull's y and z.
    let numbers = [
        ("sway_force_coefficient", 40.0),
        ("heave_force_coefficient", 70.0),
    ];
    let scene = with(keelboat(swayed(0.3)), "quadratic_drag", &numbers);
    let path = scene.motion(60.0).unwrap();
    let slope = |_: f64, y: &[f64; 2]| {
        let (sin, cos) = y[0].sin_cos();
        let (along, up) = (LINE_M * y[1] * cos, LINE_M * y[1] * sin);
        let force = -40.0 * along * along.abs() * cos - 70.0 * up * up.abs() * sin;
        [y[1], -G / LINE_M * sin + force / (MASS_KG * LINE_M)]
    };
    let mut worst = 0.0f64;
    runge_kutta([0.3, 0.0], 60.0, 0.1, slope, |t, y| {
        worst = worst.max((path.at(t).position.y - LINE_M * y[0].sin()).abs());
    });
    println!("sway {worst:.1e} m");
    assert!(worst < KINKS);
}
