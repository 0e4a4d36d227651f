//! What surrounds the hull: the gantry, the wind, the air that carries.

use std::f64::consts::TAU;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_mechanics::{Fineness, Start};

use crate::simulation::scenes::*;

/// Gantry x and sway y, small: m ẍ = −k x − c ẋ + M g (y − x)/l, M ÿ = −M g (y − x)/l. Of a motion
/// of two minutes, how far the sway is from that, shares of its size.
fn worst_beside_a_second_mass((m, k, c): (f64, f64, f64), fineness: Fineness) -> f64 {
    const LASTS_S: f64 = 120.0;
    let numbers = [
        ("mass_kg", m),
        ("stiffness_x_n_m", 2.0 * k),
        ("stiffness_y_n_m", k),
        ("damping_y_n_s_m", c),
    ];
    let small = 1e-5;
    let scene = with(
        keelboat(Start {
            along_m: small,
            ..Start::default()
        }),
        "support_compliance",
        &numbers,
    );
    let path = scene.motion_as(fineness, LASTS_S).unwrap();
    let pull = MASS_KG * G / LINE_M;
    let slope = |_: f64, y: &[f64; 4]| {
        let pull = pull * (y[1] - y[0]);
        [
            y[2],
            y[3],
            (pull - k * y[0] - c * y[2]) / m,
            -pull / MASS_KG,
        ]
    };
    let mut worst = 0.0f64;
    // The gantry starts where the pull holds it: k x = pull (y − x).
    let held = small * pull / (k + pull);
    runge_kutta([held, small, 0.0, 0.0], LASTS_S, 0.1, slope, |t, y| {
        worst = worst.max((path.at(t).position.y - y[1]).abs());
    });
    println!("gantry {:.1e} of the swing", worst / small);
    worst / small
}

#[test]
fn a_gantry_that_gives_way_swings_as_a_second_mass() {
    assert!(worst_beside_a_second_mass((150.0, 6e4, 40.0), Fineness::FULL) < 1e-7);
}

/// Fits compute motions less finely: of a beam of 8 Hz that dies away within a second, and of one
/// that rings for longer.
#[test]
fn a_gantry_as_fits_see_it() {
    let rings_rad_s = TAU * 8.0;
    for (k, ratio) in [(6e4, 0.07), (6e3, 0.07), (6e4, 0.005)] {
        let beam = (
            k / (rings_rad_s * rings_rad_s),
            k,
            2.0 * ratio * k / rings_rad_s,
        );
        assert!(worst_beside_a_second_mass(beam, Fineness::OF_FITS) < 1e-6);
    }
}

#[test]
fn a_gantry_that_gives_way_conserves_energy() {
    let start = Start {
        along_m: 0.5,
        across_m: 0.3,
        turn_rad: 0.1,
        yaw_rad: 0.2,
        ..Start::default()
    };
    let numbers = [
        ("mass_kg", 150.0),
        ("stiffness_x_n_m", 1e4),
        ("stiffness_y_n_m", 6e3),
    ];
    let scene = with(keelboat(start), "support_compliance", &numbers);
    let path = scene.motion(60.0).unwrap();
    // The gantry is not part of what is read: where it is follows from the lines' lengths at the
    // two ends. Its energy is zero whenever it stands still in the middle, so the hull's never
    // exceeds the start's total.
    let hull = |t: f64| {
        let m = path.at(t);
        let inertia = scene.body.inertia();
        0.5 * (MASS_KG * m.velocity.norm_squared() + m.rate.dot(&(inertia * m.rate)))
            + MASS_KG * G * m.position.z
    };
    let most = (0..600)
        .map(|i| hull(f64::from(i) * 0.1))
        .fold(f64::NEG_INFINITY, f64::max);
    let swing = hull(0.0) + MASS_KG * G * (LINE_M + 0.4);
    // At rest at the start; the springs hold k x²/2 with x below M g (y/l)/k.
    let springs = 0.5 * (MASS_KG * G * 0.5 / LINE_M).powi(2) / 6e3
        + 0.5 * (MASS_KG * G * 0.3 / LINE_M).powi(2) / 1e4;
    println!(
        "swing {swing} J, most {} J more, springs at most {springs}",
        most - hull(0.0)
    );
    assert!(most - hull(0.0) < springs && springs < swing);
}

#[test]
fn buoyancy_lightens_the_hull() {
    let numbers = [("displaced_air_kg", 0.9)];
    let scene = |start| with(keelboat(start), "buoyancy", &numbers);
    let reduced = (1.0 - 0.9 / MASS_KG) * G; // paper: g' = (1 − ρ_a/ρ) g
    let sway = period_s(&scene(swayed(1e-5)).motion(60.0).unwrap(), |m| m.position.y);
    assert_close(sway, TAU * (LINE_M / reduced).sqrt(), 1e-8);
    let yaw = period_s(&scene(yawed(1e-5)).motion(60.0).unwrap(), heading);
    assert_close(
        yaw,
        TAU * YAW_GYRADIUS_M / HALF_SPACING_M * (LINE_M / reduced).sqrt(),
        1e-8,
    );
}

#[test]
fn steady_wind_pushes_a_pendulum() {
    let numbers = [
        ("force_coefficient", 3.0),
        ("steady_y_m_s", 4.0),
        ("gust_time_s", 5.0),
    ];
    let scene = with(keelboat(swayed(0.2)), "wind", &numbers);
    let path = scene.motion(60.0).unwrap();
    let slope = |_: f64, y: &[f64; 2]| {
        let (sin, cos) = y[0].sin_cos();
        let own = LINE_M * y[1] * cos;
        let force = 3.0 * ((4.0 - own) * (4.0 - own).abs() + own * own.abs());
        [y[1], (force * cos / MASS_KG - G * sin) / LINE_M]
    };
    let mut worst = 0.0f64;
    runge_kutta([0.2, 0.0], 60.0, 0.1, slope, |t, y| {
        worst = worst.max((path.at(t).position.y - LINE_M * y[0].sin()).abs());
    });
    println!("wind {worst:.1e} m");
    // Its kinks are crossed with errors of 1e-9 each.
    assert!(worst < 2e-7);
}

/// The keelboat hangs from points abeam of each other and swings fore and aft as a double pendulum:
/// what acts along it is c less its share, what acts across it is c.
#[test]
fn wind_finds_less_of_a_hull_from_ahead() {
    let moved = |c: f64, less_along: f64, [x, y]: [f64; 2]| {
        let numbers = [
            ("force_coefficient", c),
            ("less_along", less_along),
            ("steady_x_m_s", x),
            ("steady_y_m_s", y),
            ("gust_time_s", 5.0),
        ];
        with(keelboat(Start::default()), "wind", &numbers)
            .motion(30.0)
            .unwrap()
            .at(25.0)
            .position
    };
    let (ahead, abeam) = ([4.0, 0.0], [0.0, 4.0]);
    let (quarter, alike) = (moved(4.0, 0.75, ahead), moved(1.0, 0.0, ahead));
    assert!(
        alike.x.abs() > 1e-4 && (quarter - alike).norm() < 1e-9,
        "{quarter} {alike}"
    );
    assert!((moved(4.0, 0.75, abeam) - moved(4.0, 0.0, abeam)).norm() < 1e-9);
}

#[test]
fn gusts_can_be_had_again_and_differ_by_seed() {
    let of = |seed: f64| {
        let numbers = [
            ("force_coefficient", 3.0),
            ("gust_m_s", 2.0),
            ("gust_time_s", 3.0),
            ("seed", seed),
        ];
        with(keelboat(Start::default()), "wind", &numbers)
            .motion(60.0)
            .unwrap()
            .at(55.0)
            .position
    };
    assert_eq!(of(1.0), of(1.0));
    assert!((of(1.0) - of(2.0)).norm() > 1e-4);
}
