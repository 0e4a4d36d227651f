//! Lines that are not what the theory takes them for.

use std::f64::consts::TAU;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_base::frames::Vec3;
use gyradius_mechanics::{Fineness, Line, Rig, RigidBody, Scene, Start, small_modes};

use crate::simulation::scenes::*;

fn yaw_s(scene: &Scene) -> f64 {
    period_s(&scene.motion(60.0).unwrap(), heading)
}

fn sway_s(scene: &Scene) -> f64 {
    period_s(&scene.motion(60.0).unwrap(), |m| m.position.y)
}

#[test]
fn creep_lengthens_a_pendulum() {
    let numbers = [("strain_per_decade", 2e-3), ("loaded_before_s", 30.0)];
    let scene = with(keelboat(swayed(0.1)), "line_creep", &numbers);
    let path = scene.motion(600.0).unwrap();
    // l φ̈ + 2 l̇ φ̇ + g sin φ = 0.
    let length = |t: f64| LINE_M * (1.0 + 2e-3 * (1.0 + t / 30.0).log10());
    let growth = |t: f64| LINE_M * 2e-3 / std::f64::consts::LN_10 / (30.0 + t);
    let slope =
        |t: f64, y: &[f64; 2]| [y[1], -(G * y[0].sin() + 2.0 * growth(t) * y[1]) / length(t)];
    let mut worst = 0.0f64;
    // The start's rate along the axis, l̇ sin φ + l φ̇ cos φ, is zero.
    let rate = -growth(0.0) / length(0.0) * 0.1f64.tan();
    runge_kutta([0.1, rate], 120.0, 0.1, slope, |t, y| {
        worst = worst.max((path.at(t).position.y - length(t) * y[0].sin()).abs());
    });
    println!("creep {worst:.1e} m");
    assert!(worst < 1e-9);
    // The period drifts by half of the strain: its means over the first and the last forty half
    // swings.
    let at = zeros(&path, |m| m.position.y);
    let n = at.len() - 1;
    let drift = (at[n] - at[n - 40]) / (at[40] - at[0]) - 1.0;
    // ∫ log₁₀(1 + x) dx = ((1 + x) ln(1 + x) − x)/ln 10, x = t/30 s.
    let integral = |t: f64| {
        let x = t / 30.0;
        30.0 * ((1.0 + x) * (1.0 + x).ln() - x) / std::f64::consts::LN_10
    };
    let strain = |i: usize, j: usize| 2e-3 * (integral(at[j]) - integral(at[i])) / (at[j] - at[i]);
    let expected = 0.5 * (strain(n - 40, n) - strain(0, 40));
    println!(
        "drift {:.1} ppm, half the strain {:.1}",
        1e6 * drift,
        1e6 * expected
    );
    assert_close(drift, expected, 0.005);
}

/// How far the motion on elastic lines is from that of an elastic pendulum, m and rad.
fn worst_beside_an_elastic_pendulum(
    (force, delay): (f64, f64),
    fineness: Fineness,
    lasts_s: f64,
) -> f64 {
    let scene = with(
        keelboat(swayed(0.3)),
        "line_stretch",
        &[("force_per_strain_n", force), ("delay_s", delay)],
    );
    let path = scene.motion_as(fineness, lasts_s).unwrap();
    let start = path.at(0.0);
    // A plate in the plane of the lines: y, z and roll, on two springs whose ends are 0.4 m above
    // the centre of mass.
    let slope = |_: f64, y: &[f64; 6]| {
        let (sin, cos) = y[2].sin_cos();
        let mut pull = [0.0, -MASS_KG * G, 0.0];
        for side in [-HALF_SPACING_M, HALF_SPACING_M] {
            let arm = [side * cos - 0.4 * sin, side * sin + 0.4 * cos];
            let line = [y[0] + arm[0] - side, y[1] + arm[1]];
            let speed = [y[3] - y[5] * arm[1], y[4] + y[5] * arm[0]];
            let r = line[0].hypot(line[1]);
            let rate = (line[0] * speed[0] + line[1] * speed[1]) / r;
            let force = [0, 1].map(|k| -force / LINE_M * (r - LINE_M + delay * rate) * line[k] / r);
            pull[0] += force[0];
            pull[1] += force[1];
            pull[2] += arm[0] * force[1] - arm[1] * force[0];
        }
        [
            y[3],
            y[4],
            y[5],
            pull[0] / MASS_KG,
            pull[1] / MASS_KG,
            pull[2] / (MASS_KG * 0.625 * 0.625),
        ]
    };
    let state = [
        start.position.y,
        start.position.z,
        roll(&start),
        0.0,
        0.0,
        0.0,
    ];
    let mut worst = 0.0f64;
    runge_kutta(state, lasts_s, 0.1, slope, |t, y| {
        let moment = path.at(t);
        let apart = [
            moment.position.y - y[0],
            moment.position.z - y[1],
            roll(&moment) - y[2],
        ];
        worst = apart.iter().fold(worst, |a, b| a.max(b.abs()));
    });
    println!("elastic {worst:.1e} m");
    worst
}

#[test]
fn elastic_lines_swing_as_an_elastic_pendulum() {
    assert!(worst_beside_an_elastic_pendulum((2e5, 2e-3), Fineness::FULL, 30.0) < 1e-8);
}

/// Fits compute motions less finely.
#[test]
fn elastic_lines_as_fits_see_them() {
    for stretched in [(2e5, 2e-3), (2e4, 2e-3), (2e6, 1e-3), (2e5, 1e-4)] {
        assert!(worst_beside_an_elastic_pendulum(stretched, Fineness::OF_FITS, 120.0) < 1e-6);
    }
}

#[test]
fn torsion_stiffens_the_yaw() {
    let scene = with(
        keelboat(yawed(1e-4)),
        "line_torsion",
        &[("stiffness_n_m_rad", 60.0)],
    );
    let stiffness = MASS_KG * G * HALF_SPACING_M * HALF_SPACING_M / LINE_M + 60.0;
    assert_close(yaw_s(&scene), TAU * (YAW_INERTIA / stiffness).sqrt(), 1e-8);
    let numbers = [("stiffness_n_m_rad", 60.0), ("neutral_rad", 0.05)];
    let scene = with(keelboat(yawed(0.2)), "line_torsion", &numbers);
    assert!(
        worst_yaw(&scene, 60.0, |_, psi, _, _| [
            -60.0 * (psi - 0.05),
            0.0,
            0.0
        ]) < 1e-9
    );
}

#[test]
fn heavy_lines() {
    let each = 0.8 * LINE_M;
    let heavy = |start| {
        with(
            keelboat(start),
            "line_mass",
            &[("linear_density_kg_m", 0.8)],
        )
    };
    // Two rods of mass μ about their upper ends: inertia μ l²/3, weight at l/2.
    let inertia = (MASS_KG + 2.0 * each / 3.0) * LINE_M * LINE_M;
    let stiffness = (MASS_KG + each) * G * LINE_M;
    let expected = TAU * (inertia / stiffness).sqrt();
    assert_close(sway_s(&heavy(swayed(1e-4))), expected, 1e-8);
    let inertia = YAW_INERTIA + 2.0 * each / 3.0 * HALF_SPACING_M.powi(2);
    let stiffness = (MASS_KG + each) * G * HALF_SPACING_M.powi(2) / LINE_M;
    assert_close(
        yaw_s(&heavy(yawed(1e-4))),
        TAU * (inertia / stiffness).sqrt(),
        1e-8,
    );
}

#[test]
fn dimensions_that_are_not_the_stated_ones() {
    let yaw = |b: f64, t: f64, l: f64| {
        let h = (l * l - (b - t) * (b - t)).sqrt();
        TAU * YAW_GYRADIUS_M * (h / (G * b * t)).sqrt()
    };
    let (d, l) = (HALF_SPACING_M, LINE_M);
    let of = |id, number, value| yaw_s(&with(keelboat(yawed(1e-5)), id, &[(number, value)]));
    assert_close(
        of("nonparallel_lines", "excess_m", 0.3),
        yaw(d, d + 0.15, l),
        1e-8,
    );
    assert_close(
        of("stated_length", "excess_m", 0.07),
        yaw(d, d, l + 0.07),
        1e-8,
    );
    assert_close(
        of("stated_spacing", "excess_m", -0.02),
        yaw(d - 0.01, d - 0.01, l),
        1e-8,
    );
}

/// Each line is as long as its law says: before, half way (s(½) = ½ by symmetry) and after. Both
/// alike, the hull hangs lower by as much, and swings as on lines of that length from the start.
#[test]
fn a_line_that_slips_is_longer_from_then_on() {
    let more = [-0.004, 0.02];
    let numbers = [
        ("at_s", 10.0),
        ("over_s", 0.5),
        ("negative_m", more[0]),
        ("positive_m", more[1]),
    ];
    let scene = with(keelboat(swayed(0.05)), "line_slip", &numbers);
    let path = scene.motion(30.0).unwrap();
    for (t_s, share) in [(9.0, 0.0), (10.25, 0.5), (11.0, 1.0), (29.0, 1.0)] {
        let moment = path.at(t_s);
        for (side, more) in [-HALF_SPACING_M, HALF_SPACING_M].into_iter().zip(more) {
            let arm = moment.turn() * (Vec3::new(0.0, side, 0.0) - scene.body.cm());
            let line = moment.position + arm - Vec3::new(0.0, side, 0.0);
            let expected = LINE_M + share * more;
            assert!(
                (line.norm() - expected).abs() < 1e-9,
                "{t_s} s: {} m, not {expected} m",
                line.norm()
            );
        }
    }
    let alike = [
        ("at_s", 1.0),
        ("over_s", 0.5),
        ("negative_m", 0.1),
        ("positive_m", 0.1),
    ];
    let still = with(keelboat(Start::default()), "line_slip", &alike)
        .motion(5.0)
        .unwrap();
    assert!((still.at(0.5).position.z - still.at(4.0).position.z - 0.1).abs() < 1e-9);
    assert!(still.at(4.0).velocity.norm() < 1e-9);
    let slipped = with(
        keelboat(yawed(1e-4)),
        "line_slip",
        &[("at_s", -9.0), ("over_s", 0.5), alike[2], alike[3]],
    );
    let longer = with(keelboat(yawed(1e-4)), "stated_length", &[("excess_m", 0.1)]);
    assert_close(yaw_s(&slipped), yaw_s(&longer), 1e-9);
}

/// Both lines alike, the hull at rest falls with them: z̈ = −L s̈(x)/τ², s̈ = 60 x (1 − x) (1 − 2
/// x). Steps that were long against the slip once left 0.2 m/s² of it.
#[test]
fn a_slip_is_felt_as_it_goes_by_coarse_steps_too() {
    let (at_s, over_s, more) = (1.23, 0.3, 8e-3);
    let numbers = [
        ("at_s", at_s),
        ("over_s", over_s),
        ("negative_m", more),
        ("positive_m", more),
    ];
    let scene = with(keelboat(Start::default()), "line_slip", &numbers);
    for fineness in [Fineness::FULL, Fineness::OF_KINKED_FITS] {
        let path = scene.motion_as(fineness, 3.0).unwrap();
        let error = |n: u32| {
            let t_s = at_s + over_s * (f64::from(n) / 20.0 - 0.5);
            let x = ((t_s - at_s) / over_s).clamp(0.0, 1.0);
            let felt = -more * 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x) / (over_s * over_s);
            (path.at(t_s).acceleration.z - felt).abs()
        };
        let worst = (0..=40).map(error).fold(0.0, f64::max);
        // A tenth of what the best accelerometer of the catalogue of phones scatters.
        assert!(worst < 5e-4, "{worst} m/s²");
    }
}

#[test]
fn what_is_too_quick_is_refused() {
    let of = |over_s: f64| {
        let numbers = [
            ("at_s", 1.23),
            ("over_s", over_s),
            ("negative_m", 1e-3),
            ("positive_m", 1e-3),
        ];
        with(keelboat(Start::default()), "line_slip", &numbers)
            .motion(3.0)
            .map(|_| ())
    };
    assert!(of(1e-300).unwrap_err().to_string().contains("too quick"));
    assert!(of(1e-5).is_ok());
}

/// Frequencies that the turn of the hull and its displacement show, by small modes of a rig made
/// apart.
#[test]
fn unequal_lines_and_a_centre_of_mass_off_the_middle() {
    let mut scene = with(
        keelboat(Start::default()),
        "unequal_lines",
        &[("difference_m", 0.06)],
    );
    scene = with(
        scene,
        "off_centre_cm",
        &[("forward_m", 0.02), ("to_port_m", 0.05)],
    );
    let line = |side: f64| Line {
        top_m: Vec3::new(0.0, side * HALF_SPACING_M, 0.0),
        hull_point_m: Vec3::new(0.0, side * HALF_SPACING_M, 0.0),
        length_m: LINE_M + 0.03 * side,
    };
    let rig = Rig {
        lines: [line(-1.0), line(1.0)],
        gravity_m_s2: G,
    };
    let body = RigidBody::from_gyradii(
        MASS_KG,
        [0.625, 1.156, YAW_GYRADIUS_M],
        Vec3::new(0.02, 0.05, -0.4),
    );
    let modes = small_modes(&rig, &body).unwrap();
    // At rest where that rig rests: the simulated hull, started there, does not move.
    let rest = modes.equilibrium.pose;
    let hull = rest.world_from_body * -body.cm_m + rest.position_m;
    // World from hull is yaw about z · roll about x · turn about y.
    let turn = rest.world_from_body.to_rotation_matrix();
    let pitch = (-turn[(2, 0)]).atan2(turn[(2, 2)]);
    let yaw = (-turn[(0, 1)]).atan2(turn[(1, 1)]);
    let at_rest = |yaw_rad: f64| {
        let mut scene = scene.clone();
        scene.start = Start {
            along_m: hull.y,
            across_m: hull.x,
            turn_rad: pitch,
            yaw_rad: yaw + yaw_rad,
            ..Start::default()
        };
        scene.motion(60.0).unwrap()
    };
    let still = at_rest(0.0);
    println!("rest: pitch {pitch}, rate {:e}", still.at(7.0).rate.norm());
    assert!(still.at(7.0).rate.norm() < 1e-6);
    assert!((still.at(7.0).position - rest.position_m).norm() < 1e-6);
    // What the yaw then does is a sum of the four modes: fit their sines to the heading and nothing
    // is left.
    let path = at_rest(1e-4);
    let times: Vec<f64> = (0..600).map(|i| f64::from(i) * 0.1).collect();
    let columns = |t: &f64| {
        modes
            .omega_rad_s
            .iter()
            .flat_map(|w| [(w * t).cos(), (w * t).sin()])
            .collect::<Vec<_>>()
    };
    let rows: Vec<f64> = times.iter().flat_map(columns).collect();
    let matrix = nalgebra::DMatrix::from_row_slice(times.len(), 8, &rows);
    let headings = nalgebra::DVector::from_iterator(600, times.iter().map(|t| path.at(*t).rate.z));
    let fit = matrix
        .clone()
        .svd(true, true)
        .solve(&headings, 1e-12)
        .unwrap();
    let left = (matrix * fit - &headings).amax() / headings.amax();
    println!("left of the yaw beside the four modes: {left:.1e}");
    assert!(left < 1e-4);
}
