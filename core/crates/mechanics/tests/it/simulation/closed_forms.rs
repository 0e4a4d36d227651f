//! The base model: the paper's periods, the exact yaw, energy, lengths, slack.

use std::f64::consts::TAU;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_base::frames::Vec3;
use gyradius_mechanics::{Hanging, Moment, Path, Scene, Start, SuspensionAxis};

use crate::simulation::scenes::*;

/// Eq. (16); errata: + is the short (out-of-phase) period. Returns (in phase, out of phase).
fn double_pendulum_s(l1: f64, l2: f64, k: f64) -> (f64, f64) {
    let sum = l1 * l2 + l2 * l2 + k * k;
    let root = (sum * sum - 4.0 * l1 * l2 * k * k).sqrt();
    let period = |s: f64| TAU / (G / (2.0 * l1 * k * k) * s).sqrt();
    // The small root by Vieta: sum − root loses digits.
    (
        period(4.0 * l1 * l2 * k * k / (sum + root)),
        period(sum + root),
    )
}

/// Displacement of the suspension points across for a turn of one about the axis, in a mode of
/// angular frequency ω: the equation of the line's angle, l1 φ̈1 + l2 φ̈2 + g φ1 = 0, in its linear
/// form.
fn across_per_turn(l1: f64, l2: f64, period_s: f64) -> f64 {
    let square = (TAU / period_s).powi(2);
    l1 * square * l2 / (G - l1 * square)
}

/// Period of the mode that a small start along it gives; the turn about the axis is read.
fn double_pendulum_mode_s(axis: SuspensionAxis, l1: f64, period: f64) -> f64 {
    // A turn by the right hand about the axis carries what hangs below backwards across (axis ×
    // up).
    let turn_rad = 1e-5;
    let across_m = -turn_rad * across_per_turn(l1, 0.253, period);
    let scene = model_hull(
        axis,
        l1,
        Start {
            turn_rad,
            across_m,
            ..Start::default()
        },
    );
    let read = if axis == SuspensionAxis::Athwartships {
        pitch
    } else {
        roll
    };
    period_s(&scene.motion(60.0).unwrap(), read)
}

#[test]
fn small_motions_have_the_papers_periods() {
    for (axis, k_swing) in [
        (SuspensionAxis::Athwartships, 0.352),
        (SuspensionAxis::ForeAndAft, 0.204),
    ] {
        for l1 in [0.504, 1.006, 1.560] {
            let motion = |start| model_hull(axis, l1, start).motion(60.0).unwrap();
            // Eq. (5): T = 2π (k/d) sqrt(l/g).
            let yaw = period_s(&motion(yawed(1e-5)), heading);
            assert_close(yaw, TAU * 0.303 / 0.28 * (l1 / G).sqrt(), 1e-8);
            // Eq. (7).
            let sway = motion(Start {
                along_m: 1e-5,
                ..Start::default()
            });
            let along = |m: &Moment<f64>| m.position.dot(&axis.unit());
            assert_close(period_s(&sway, along), TAU * (l1 / G).sqrt(), 1e-8);
            // Eq. (16).
            let (in_phase, out_of_phase) = double_pendulum_s(l1, 0.253, k_swing);
            assert_close(double_pendulum_mode_s(axis, l1, in_phase), in_phase, 1e-8);
            assert_close(
                double_pendulum_mode_s(axis, l1, out_of_phase),
                out_of_phase,
                1e-8,
            );
        }
    }
}

#[test]
fn figure_15_from_the_motion_itself() {
    // Errata, Fig. 15: out of phase, in phase, sway, yaw; printed to 1 ms.
    let printed = [
        (0.504, [0.997, 2.006, 1.424, 1.541]),
        (1.006, [1.192, 2.370, 2.012, 2.178]),
        (1.560, [1.272, 2.766, 2.506, 2.712]),
    ];
    let axis = SuspensionAxis::Athwartships;
    for (l1, periods) in printed {
        let motion = |start| model_hull(axis, l1, start).motion(60.0).unwrap();
        let (in_phase, out_of_phase) = double_pendulum_s(l1, 0.253, 0.352);
        let found = [
            double_pendulum_mode_s(axis, l1, out_of_phase),
            double_pendulum_mode_s(axis, l1, in_phase),
            period_s(
                &motion(Start {
                    along_m: 1e-3,
                    ..Start::default()
                }),
                |m| m.position.y,
            ),
            period_s(&motion(yawed(1e-3)), heading),
        ];
        println!("l1 = {l1} m: {found:.4?} s, printed {periods:?}");
        for (found, printed) in found.iter().zip(periods) {
            assert!(
                (found - printed).abs() < 0.6e-3,
                "{found} against {printed}"
            );
        }
    }
}

/// Two inverted Vs: apexes on an axis `height` above the points.
fn compound(axis: SuspensionAxis, height: f64, start: Start) -> Scene {
    let mut scene = model_hull(axis, 1.0, start);
    scene.hanging = Hanging::Compound(axis);
    scene.dimensions.axis_height_m = height;
    scene.dimensions.spread_m = 0.5;
    scene
}

#[test]
fn two_inverted_vs_make_a_compound_pendulum() {
    for (axis, k) in [
        (SuspensionAxis::Athwartships, 0.352),
        (SuspensionAxis::ForeAndAft, 0.204),
    ] {
        let read = if axis == SuspensionAxis::Athwartships {
            pitch
        } else {
            roll
        };
        for height in [0.3, 0.8] {
            let arm = height + 0.253;
            // Eq. (22): T = 2π sqrt((k² + a²)/(g a)).
            let small = TAU * ((k * k + arm * arm) / (G * arm)).sqrt();
            let motion = |turn_rad| {
                compound(
                    axis,
                    height,
                    Start {
                        turn_rad,
                        ..Start::default()
                    },
                )
                .motion(60.0)
                .unwrap()
            };
            assert_close(period_s(&motion(1e-5), read), small, 1e-8);
            // At 0.2 rad a pendulum is slower by θ²/16 + 11 θ⁴/3072 + 173 θ⁶/737280.
            let series = 1.0 + 0.04 / 16.0 + 11.0 * 0.0016 / 3072.0 + 173.0 * 0.000_064 / 737_280.0;
            assert_close(period_s(&motion(0.2), read), small * series, 2e-9);
        }
    }
}

#[test]
fn two_inverted_vs_sway_along_their_axis() {
    // Along the axis each leg swings as a line of the height of the V: eq. (7).
    let scene = compound(
        SuspensionAxis::Athwartships,
        0.8,
        Start {
            along_m: 1e-5,
            ..Start::default()
        },
    );
    assert_close(
        period_s(&scene.motion(60.0).unwrap(), |m| m.position.y),
        TAU * (0.8 / G).sqrt(),
        1e-8,
    );
}

/// Exact yaw period by quadrature of the energy, heave included:
/// ½ (k² + z'²) θ̇² = g (z(θ0) − z(θ)), z = l − h, h² = l² − 4 d² sin²(θ/2), with θ = θ0 sin u.
fn yaw_quadrature_s(theta0: f64) -> f64 {
    let (k, d, l) = (YAW_GYRADIUS_M, HALF_SPACING_M, LINE_M);
    let h = |th: f64| (l * l - 4.0 * d * d * (0.5 * th).sin().powi(2)).sqrt();
    let du = std::f64::consts::FRAC_PI_2 / 400.0;
    let integrand = |u: f64| {
        let th = theta0 * u.sin();
        let rise = d * d * th.sin() / h(th);
        let drop = 4.0 * d * d * (0.5 * (theta0 + th)).sin() * (0.5 * (theta0 - th)).sin()
            / (h(th) + h(theta0));
        ((k * k + rise * rise) / (2.0 * G * drop)).sqrt() * theta0 * u.cos()
    };
    4.0 * du
        * (0..400)
            .map(|i| integrand((f64::from(i) + 0.5) * du))
            .sum::<f64>()
}

#[test]
fn yaw_at_finite_amplitude_is_the_exact_law() {
    let small_s = TAU * YAW_GYRADIUS_M / HALF_SPACING_M * (LINE_M / G).sqrt();
    // Errata, "Pure yaw at finite amplitude", ppm.
    for (degrees, table_ppm) in [
        (1.0, 19.0),
        (2.0, 76.0),
        (5.0, 473.0),
        (8.0, 1211.0),
        (10.0, 1893.0),
        (15.0, 4263.0),
    ] {
        let theta0 = f64::to_radians(degrees);
        let exact_ppm = (yaw_quadrature_s(theta0) / small_s - 1.0) * 1e6;
        let found_s = period_s(&keelboat(yawed(theta0)).motion(120.0).unwrap(), heading);
        let found_ppm = (found_s / small_s - 1.0) * 1e6;
        println!(
            "yaw {degrees} deg: {found_ppm:.4} ppm, quadrature {exact_ppm:.4}, table {table_ppm}"
        );
        assert!(
            (found_ppm - exact_ppm).abs() < 0.001,
            "{degrees} deg: {found_ppm} against {exact_ppm}"
        );
        assert!(
            (found_ppm - table_ppm).abs() < 0.6,
            "{degrees} deg: {found_ppm} against the table"
        );
    }
}

/// Off centre to every side, products of inertia, lines not parallel, everything moving.
fn lively() -> Scene {
    let start = Start {
        along_m: 0.1,
        across_m: 0.08,
        turn_rad: 0.1,
        yaw_rad: 0.17,
        along_m_s: 0.1,
        turn_rad_s: -0.2,
        yaw_rad_s: 0.3,
        ..Start::default()
    };
    let mut scene = model_hull(SuspensionAxis::Athwartships, 1.0, start);
    scene.dimensions.top_spacing_m = 0.5;
    (scene.body.cm_x_m, scene.body.cm_y_m) = (0.05, 0.03);
    (scene.body.inertia_xz_kg_m2, scene.body.inertia_xy_kg_m2) = (0.1, -0.05);
    scene
}

/// Kinetic energy and height of the body alone, J.
fn energy_j(scene: &Scene, moment: &Moment<f64>) -> f64 {
    let (v, w) = (moment.velocity, moment.rate);
    let kinetic =
        0.5 * (scene.body.mass_kg * v.norm_squared() + w.dot(&(scene.body.inertia() * w)));
    kinetic + scene.body.mass_kg * G * moment.position.z
}

/// Largest change of an energy, of the largest kinetic energy of the motion.
fn loss(scene: &Scene, path: &Path<f64>, energy_j: impl Fn(&Moment<f64>) -> f64) -> f64 {
    let (first, mut worst, mut kinetic) = (energy_j(&path.at(0.0)), 0.0f64, 0.0f64);
    let inertia = scene.body.inertia();
    for n in 0..(path.duration_s() / 0.1) as usize {
        let moment = path.at(n as f64 * 0.1);
        worst = worst.max((energy_j(&moment) - first).abs());
        let turning = moment.rate.dot(&(inertia * moment.rate));
        kinetic =
            kinetic.max(0.5 * (scene.body.mass_kg * moment.velocity.norm_squared() + turning));
    }
    worst / kinetic
}

#[test]
fn energy_is_kept_and_the_lines_keep_their_length() {
    let scene = lively();
    let path = scene.motion(600.0).unwrap();
    assert!(path.slack.is_none());
    let loss = loss(&scene, &path, |m| energy_j(&scene, m));
    let mut drift = 0.0f64;
    for n in 0..60000 {
        let moment = path.at(f64::from(n) * 0.01);
        for side in [-0.5, 0.5] {
            let arm = moment.turn() * (Vec3::new(0.0, side * 0.56, 0.0) - scene.body.cm());
            let line = moment.position + arm - Vec3::new(0.0, side * 0.5, 0.0);
            drift = drift.max((line.norm() - 1.0).abs());
        }
    }
    println!("energy {loss:.1e} of the motion's, lines {drift:.1e} m");
    assert!(loss < 1e-10, "energy {loss}");
    assert!(drift < 1e-9, "lines {drift} m");
}

#[test]
fn air_that_moves_along_conserves_energy_with_the_hull() {
    let (a, b) = (Vec3::new(0.3, 1.2, 0.8), Vec3::new(0.02, 0.05, 0.09));
    let numbers = [
        ("surge_kg", a.x),
        ("sway_kg", a.y),
        ("heave_kg", a.z),
        ("roll_kg_m2", b.x),
        ("pitch_kg_m2", b.y),
        ("yaw_kg_m2", b.z),
    ];
    let scene = with(lively(), "added_mass", &numbers);
    let path = scene.motion(600.0).unwrap();
    let energy = |m: &Moment<f64>| {
        let (v, w) = (m.turn().transpose() * m.velocity, m.rate);
        energy_j(&scene, m) + 0.5 * (v.dot(&a.component_mul(&v)) + w.dot(&b.component_mul(&w)))
    };
    let loss = loss(&scene, &path, energy);
    println!("energy {loss:.1e}");
    assert!(loss < 1e-10, "energy {loss}");
}

#[test]
fn elastic_and_twisted_lines_conserve_energy() {
    let mut scene = with(lively(), "line_stretch", &[("force_per_strain_n", 2e4)]);
    scene = with(
        scene,
        "line_torsion",
        &[("stiffness_n_m_rad", 0.8), ("neutral_rad", 0.1)],
    );
    let path = scene.motion(60.0).unwrap();
    let energy = |m: &Moment<f64>| {
        let stretch = [-0.5, 0.5].map(|side| {
            let arm = m.turn() * (Vec3::new(0.0, side * 0.56, 0.0) - scene.body.cm());
            (m.position + arm - Vec3::new(0.0, side * 0.5, 0.0)).norm() - 1.0
        });
        let elastic: f64 = stretch.iter().map(|x| 0.5 * 2e4 * x * x).sum();
        energy_j(&scene, m) + elastic + 0.4 * (heading(m) - 0.1).powi(2)
    };
    let loss = loss(&scene, &path, energy);
    println!("energy {loss:.1e}");
    assert!(loss < 1e-9, "energy {loss}");
}

#[test]
fn a_slack_line_is_an_event() {
    // The hull sways along the axis without turning, its centre of mass a depth c below the points:
    // the moments of the two pulls about it balance where (T2 − T1) d cos φ = (T1 + T2) c sin φ.
    // One line is slack from tan φ = d/c on.
    let v0: f64 = 9.0;
    let start = Start {
        along_m_s: v0,
        ..Start::default()
    };
    let slack = keelboat(start).motion(3.0).unwrap().slack.unwrap();
    let slack_rad = (HALF_SPACING_M / 0.4).atan();
    // t = ∫ l dφ / sqrt(v0² − 2 g l (1 − cos φ)), by the mid-point rule.
    let speed = |phi: f64| (v0 * v0 - 2.0 * G * LINE_M * (1.0 - phi.cos())).sqrt();
    let d = slack_rad / 1e5;
    let expected: f64 = (0..100_000)
        .map(|i| LINE_M * d / speed((f64::from(i) + 0.5) * d))
        .sum();
    println!("slack at {} s, quadrature {expected}", slack.t_s);
    assert!((slack.t_s - expected).abs() < 1e-3);
    assert!(
        keelboat(Start {
            along_m_s: 1.0,
            ..Start::default()
        })
        .motion(3.0)
        .unwrap()
        .slack
        .is_none()
    );
}
