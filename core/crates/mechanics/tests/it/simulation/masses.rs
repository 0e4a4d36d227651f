//! Masses that move with the hull, or inside it.

use std::f64::consts::TAU;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_mechanics::Start;

use crate::simulation::scenes::*;

#[test]
fn entrained_air_slows_the_small_swings() {
    let scene = |start| {
        with(
            keelboat(start),
            "added_mass",
            &[("yaw_kg_m2", 30.0), ("sway_kg", 8.0)],
        )
    };
    let yaw = TAU * YAW_GYRADIUS_M / HALF_SPACING_M * (LINE_M / G).sqrt(); // eq. (5)
    let found = period_s(&scene(yawed(1e-5)).motion(60.0).unwrap(), heading);
    assert_close(found, yaw * (1.0 + 30.0 / YAW_INERTIA).sqrt(), 1e-8);
    let sway = TAU * (LINE_M / G).sqrt(); // eq. (7)
    let found = period_s(&scene(swayed(1e-5)).motion(60.0).unwrap(), |m| m.position.y);
    assert_close(found, sway * (1.0 + 8.0 / MASS_KG).sqrt(), 1e-8);
}

#[test]
fn entrained_air_that_grows_with_the_swing() {
    let scene = |yaw_rad| {
        with(
            keelboat(yawed(yaw_rad)),
            "amplitude_added_mass",
            &[("yaw_kg_m2_rad", 60.0)],
        )
    };
    // Amplitude from heading and rate at the frequency of eq. (5).
    let square = G / LINE_M * (HALF_SPACING_M / YAW_GYRADIUS_M).powi(2);
    let law = |_: f64, psi: f64, rate: f64, _: f64| {
        [0.0, 60.0 * (psi * psi + rate * rate / square).sqrt(), 0.0]
    };
    assert!(worst_yaw(&scene(0.2), 60.0, law) < 1e-8);
    // The period grows by half of a A/I beyond the exact law of a bare hull.
    let shift = |yaw_rad: f64| {
        let bare = period_s(&keelboat(yawed(yaw_rad)).motion(60.0).unwrap(), heading);
        period_s(&scene(yaw_rad).motion(60.0).unwrap(), heading) / bare - 1.0
    };
    assert_close(shift(0.1), 0.5 * 60.0 * 0.1 / YAW_INERTIA, 0.01);
    assert_close(shift(0.2) / shift(0.1), 2.0, 0.01);
}

/// Sway y of the hull and displacement s of the slider in it, small: (M − m) ÿ = −M g y/l + k s + c
/// ṡ, m (ÿ + s̈) = −k s − c ṡ. The lines keep the hull level wherever the slider is.
#[test]
fn a_slider_inside_swings_as_a_second_mass() {
    let (m, k, c) = (40.0, 200.0, 6.0);
    let numbers = [
        ("mass_kg", m),
        ("place_x_m", 0.0),
        ("place_z_m", -0.7),
        ("along_y", 2.0),
        ("stiffness_n_m", k),
        ("damping_n_s_m", c),
    ];
    let small = 1e-5;
    let scene = with(
        keelboat(Start {
            along_m: small,
            ..Start::default()
        }),
        "internal_motion",
        &numbers,
    );
    let path = scene.motion(60.0).unwrap();
    let slope = |_: f64, y: &[f64; 4]| {
        let grip = k * y[1] + c * y[3];
        let hull = (-MASS_KG * G / LINE_M * y[0] + grip) / (MASS_KG - m);
        [y[2], y[3], hull, -grip / m - hull]
    };
    let mut worst = 0.0f64;
    runge_kutta([small, 0.0, 0.0, 0.0], 60.0, 0.1, slope, |t, y| {
        worst = worst.max((path.at(t).position.y - y[0]).abs());
    });
    println!("slider {:.1e} of the swing", worst / small);
    assert!(worst < 1e-7 * small);
}

#[test]
fn a_slider_that_is_held_fast_changes_nothing() {
    let start = Start {
        along_m: 0.1,
        across_m: 0.1,
        turn_rad: 0.1,
        yaw_rad: 0.2,
        ..Start::default()
    };
    let numbers = |stiffness| {
        [
            ("mass_kg", 40.0),
            ("place_x_m", 0.5),
            ("place_y_m", -0.2),
            ("place_z_m", -0.7),
            ("along_x", 1.0),
            ("along_y", 1.0),
            ("along_z", 0.3),
            ("stiffness_n_m", stiffness),
        ]
    };
    let bare = keelboat(start).motion(20.0).unwrap();
    let apart = |stiffness| {
        let path = with(keelboat(start), "internal_motion", &numbers(stiffness))
            .motion(20.0)
            .unwrap();
        (path.at(20.0).position - bare.at(20.0).position).norm()
    };
    let (soft, hard) = (apart(1e5), apart(1e6));
    println!("apart by {soft:.1e} and {hard:.1e} m");
    assert!(hard < 0.2 * soft && hard < 2e-3);
}
