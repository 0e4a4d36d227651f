//! The body on its lines against closed forms, the paper's figures and quadrature.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::TAU;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_base::frames::{Rotation, Vec3};
use gyradius_mechanics::{
    Damping, ModalPart, ModeKind, Rig, RigidBody, Sampling, SmallEffects, SmallModes, State,
    SuspensionAxis, Trajectory, ideal_phone, initial_state, mode_kind, simulate, small_modes,
};

fn by_kind(rig: &Rig, body: &RigidBody, modes: &SmallModes, kind: ModeKind) -> usize {
    let mut found = (0..4).filter(|&i| mode_kind(body, &modes.shapes[i], rig.axis()) == kind);
    let first = found
        .next()
        .unwrap_or_else(|| panic!("no {kind:?} in {modes:?}"));
    assert!(found.next().is_none(), "two modes named {kind:?}");
    first
}

fn period(rig: &Rig, body: &RigidBody, kind: ModeKind) -> f64 {
    let modes = small_modes(rig, body).unwrap();
    modes.period_s(by_kind(rig, body, &modes, kind))
}

fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found / expected - 1.0).abs() <= relative,
        "{found} against {expected}"
    );
}

/// Paper, Fig. 15: k_p = 352, k_y = 303, l2 = 253 mm.
fn model_hull() -> RigidBody {
    RigidBody::from_gyradii(13.18, [0.204, 0.352, 0.303], Vec3::new(0.0, 0.0, -0.253))
}

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

#[test]
fn small_oscillations_agree_with_the_closed_forms() {
    for (axis, k_swing) in [
        (SuspensionAxis::Athwartships, 0.352),
        (SuspensionAxis::ForeAndAft, 0.204),
    ] {
        for l1 in [0.504, 1.006, 1.560] {
            let (rig, body) = (Rig::bifilar(axis, l1, 0.56, 0.56, G).unwrap(), model_hull());
            let (in_phase, out_of_phase) = double_pendulum_s(l1, 0.253, k_swing);
            // Eq. (5): T = 2π (k/d) sqrt(l/g).
            assert_close(
                period(&rig, &body, ModeKind::Yaw),
                TAU * 0.303 / 0.28 * (l1 / G).sqrt(),
                1e-10,
            );
            // Eq. (7).
            assert_close(
                period(&rig, &body, ModeKind::SwayLine),
                TAU * (l1 / G).sqrt(),
                1e-10,
            );
            assert_close(
                period(&rig, &body, ModeKind::DoublePendulumInPhase),
                in_phase,
                1e-10,
            );
            assert_close(
                period(&rig, &body, ModeKind::DoublePendulumOutOfPhase),
                out_of_phase,
                1e-10,
            );
        }
    }
}

#[test]
fn periods_of_figure_15() {
    // Errata, Fig. 15; printed to 1 ms.
    let printed = [
        (0.504, 0.997, 2.006, 1.424, 1.541),
        (1.006, 1.192, 2.370, 2.012, 2.178),
        (1.560, 1.272, 2.766, 2.506, 2.712),
    ];
    for (l1, out_of_phase, in_phase, sway, yaw) in printed {
        let rig = Rig::bifilar(SuspensionAxis::Athwartships, l1, 0.56, 0.56, G).unwrap();
        let of = |kind| period(&rig, &model_hull(), kind);
        assert!((of(ModeKind::DoublePendulumOutOfPhase) - out_of_phase).abs() < 0.6e-3);
        assert!((of(ModeKind::DoublePendulumInPhase) - in_phase).abs() < 0.6e-3);
        assert!((of(ModeKind::SwayLine) - sway).abs() < 0.6e-3);
        assert!((of(ModeKind::Yaw) - yaw).abs() < 0.6e-3);
    }
}

#[test]
fn yaw_on_lines_that_are_not_parallel() {
    // T = 2π k sqrt(h / (g d_b d_t)), half spacings below and above, h the drop of the lines.
    for top_m in [1.2, 1.8, 2.6] {
        let rig = Rig::bifilar(SuspensionAxis::Athwartships, 3.477, 1.8, top_m, G).unwrap();
        let body =
            RigidBody::from_gyradii(622.7, [0.625, 1.156, 1.0566], Vec3::new(0.0, 0.0, -0.4));
        let h = (3.477f64.powi(2) - (0.9 - 0.5 * top_m).powi(2)).sqrt();
        let expected = TAU * 1.0566 * (h / (G * 0.9 * 0.5 * top_m)).sqrt();
        assert_close(period(&rig, &body, ModeKind::Yaw), expected, 1e-10);
    }
}

/// Off centre to every side, with a product of inertia.
fn lopsided() -> RigidBody {
    let mut body = model_hull();
    body.cm_m = Vec3::new(0.05, 0.03, -0.25);
    body.inertia_kg_m2[(0, 2)] = 0.1;
    body.inertia_kg_m2[(2, 0)] = 0.1;
    body
}

#[test]
fn modes_are_mass_normalised_and_the_rest_pose_carries_the_weight() {
    let rig = Rig::bifilar(SuspensionAxis::Athwartships, 1.0, 0.56, 0.5, G).unwrap();
    let body = lopsided();
    let modes = small_modes(&rig, &body).unwrap();
    let turn = modes.equilibrium.pose.world_from_body;
    for i in 0..4 {
        for j in 0..4 {
            let inertia = |v: Vec3| turn * (body.inertia_kg_m2 * (turn.inverse() * v));
            let product = body.mass_kg * modes.displacement(i).dot(&modes.displacement(j))
                + modes.rotation(i).dot(&inertia(modes.rotation(j)));
            assert!(
                (product - f64::from(u8::from(i == j))).abs() < 1e-12,
                "{i} {j} {product}"
            );
        }
    }
    // Statics, written out anew: forces and moments about the centre of mass vanish.
    let rest = modes.equilibrium;
    let (mut force, mut moment) = (Vec3::new(0.0, 0.0, -body.mass_kg * G), Vec3::zeros());
    for (line, tension) in rig.lines.iter().zip(rest.tension_n) {
        let arm = turn * (line.hull_point_m - body.cm_m);
        let up = line.top_m - rest.pose.position_m - arm;
        assert_close(up.norm(), line.length_m, 1e-12);
        force += up.normalize() * tension;
        moment += arm.cross(&(up.normalize() * tension));
    }
    assert!(
        force.norm() < 1e-9 && moment.norm() < 1e-9,
        "{force} {moment}"
    );
}

/// The keelboat: d = 0.900, l = 3.477 m, k_y = 1.0566 m (Table 1).
fn keelboat() -> (Rig, RigidBody) {
    let rig = Rig::bifilar(SuspensionAxis::Athwartships, 3.477, 1.8, 1.8, G).unwrap();
    (
        rig,
        RigidBody::from_gyradii(622.7, [0.625, 1.156, 1.0566], Vec3::new(0.0, 0.0, -0.4)),
    )
}

/// A start in one mode, turned by `angle_rad` or displaced by `shift_m`.
fn start_in(rig: &Rig, body: &RigidBody, kind: ModeKind, size: f64) -> State {
    let modes = small_modes(rig, body).unwrap();
    let mode = by_kind(rig, body, &modes, kind);
    let per_unit = if kind == ModeKind::SwayLine {
        modes.displacement(mode).norm()
    } else {
        modes.rotation(mode).norm()
    };
    initial_state(
        rig,
        body,
        &modes,
        &[ModalPart {
            mode,
            amplitude: size / per_unit,
            phase_rad: 0.0,
        }],
    )
    .unwrap()
}

/// Period from the zero crossings of a signal that starts at its extreme: the sign changes are
/// bracketed by samples, the crossing found by interpolation through the eight samples around.
fn period_of_crossings(t: &[f64], x: &[f64]) -> f64 {
    let crossings: Vec<f64> = (4..x.len() - 4)
        .filter(|&i| x[i - 1] * x[i] < 0.0)
        .map(|i| inverse(&x[i - 4..i + 4], &t[i - 4..i + 4]))
        .collect();
    let last = crossings.len() - 1;
    2.0 * (crossings[last] - crossings[0]) / last as f64
}

/// Value at x = 0 of the polynomial through (x, t): Neville's scheme on the inverse function,
/// monotone here.
fn inverse(x: &[f64], t: &[f64]) -> f64 {
    let mut p = t.to_vec();
    for k in 1..x.len() {
        for i in 0..x.len() - k {
            p[i] = (-x[i + k] * p[i] + x[i] * p[i + 1]) / (x[i] - x[i + k]);
        }
    }
    p[0]
}

fn run(rig: &Rig, body: &RigidBody, start: &State, duration_s: f64, interval_s: f64) -> Trajectory {
    let sampling = Sampling {
        duration_s,
        interval_s,
        step_s: None,
    };
    simulate(rig, body, &Damping::default(), start, &sampling).unwrap()
}

fn yaw_angles(motion: &Trajectory) -> Vec<f64> {
    motion
        .world_from_hull
        .iter()
        .map(|turn| turn.scaled_axis().z)
        .collect()
}

/// Exact yaw period by quadrature of the energy, heave included:
/// ½ (k² + z'²) θ̇² = g (z(θ0) − z(θ)), z = l − h, h² = l² − 4 d² sin²(θ/2), with θ = θ0 sin u.
fn yaw_quadrature_s(k: f64, d: f64, l: f64, theta0: f64) -> f64 {
    let h = |th: f64| (l * l - 4.0 * d * d * (0.5 * th).sin().powi(2)).sqrt();
    let n = 400;
    let du = std::f64::consts::FRAC_PI_2 / n as f64;
    let integrand = |u: f64| {
        let th = theta0 * u.sin();
        let rise = d * d * th.sin() / h(th);
        let drop = 4.0 * d * d * (0.5 * (theta0 + th)).sin() * (0.5 * (theta0 - th)).sin()
            / (h(th) + h(theta0));
        ((k * k + rise * rise) / (2.0 * G * drop)).sqrt() * theta0 * u.cos()
    };
    4.0 * du
        * (0..n)
            .map(|i| integrand((f64::from(i) + 0.5) * du))
            .sum::<f64>()
}

#[test]
fn yaw_at_finite_amplitude_is_the_exact_law() {
    let (rig, body) = keelboat();
    let small_s = TAU * 1.0566 / 0.9 * (3.477 / G).sqrt();
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
        let exact_ppm = (yaw_quadrature_s(1.0566, 0.9, 3.477, theta0) / small_s - 1.0) * 1e6;
        let motion = run(
            &rig,
            &body,
            &start_in(&rig, &body, ModeKind::Yaw, theta0),
            60.0,
            0.02,
        );
        let found_ppm =
            (period_of_crossings(&motion.t_s, &yaw_angles(&motion)) / small_s - 1.0) * 1e6;
        println!(
            "yaw {degrees} deg: {found_ppm:.4} ppm, quadrature {exact_ppm:.4}, table {table_ppm}"
        );
        assert!(
            (found_ppm - exact_ppm).abs() < 0.01,
            "{degrees} deg: {found_ppm} against {exact_ppm}"
        );
        assert!(
            (found_ppm - table_ppm).abs() < 0.6,
            "{degrees} deg: {found_ppm} against the table"
        );
    }
}

#[test]
fn sway_is_a_simple_pendulum() {
    let (rig, body) = keelboat();
    for phi in [0.02f64, 0.1, 0.2] {
        let start = start_in(&rig, &body, ModeKind::SwayLine, 3.477 * phi);
        // The projection decides the exact angle: read it off.
        let phi = (start.pose.position_m.y / 3.477).asin();
        let motion = run(&rig, &body, &start, 60.0, 0.02);
        let y: Vec<f64> = motion.position_m.iter().map(|p| p.y).collect();
        // Next term of the series: 173 φ⁶/737280.
        let series = 1.0
            + phi.powi(2) / 16.0
            + 11.0 * phi.powi(4) / 3072.0
            + 173.0 * phi.powi(6) / 737_280.0;
        assert_close(
            period_of_crossings(&motion.t_s, &y),
            TAU * (3.477 / G).sqrt() * series,
            2e-8,
        );
    }
}

#[test]
fn the_small_limit_of_the_motion_is_the_closed_form() {
    let (rig, body) = keelboat();
    let (in_phase, out_of_phase) = double_pendulum_s(3.477, 0.4, 1.156);
    let yaw = TAU * 1.0566 / 0.9 * (3.477 / G).sqrt();
    for (kind, expected) in [
        (ModeKind::Yaw, yaw),
        (ModeKind::DoublePendulumInPhase, in_phase),
        (ModeKind::DoublePendulumOutOfPhase, out_of_phase),
    ] {
        // 1e-4 rad moves the period by parts in 1e9.
        let motion = run(&rig, &body, &start_in(&rig, &body, kind, 1e-4), 60.0, 0.02);
        let angle: Vec<f64> = motion
            .world_from_hull
            .iter()
            .map(|turn| {
                if kind == ModeKind::Yaw {
                    turn.scaled_axis().z
                } else {
                    turn.scaled_axis().y
                }
            })
            .collect();
        assert_close(period_of_crossings(&motion.t_s, &angle), expected, 1e-8);
    }
}

fn energy_j(body: &RigidBody, motion: &Trajectory, i: usize) -> f64 {
    let (v, w) = (motion.velocity_m_s[i], motion.angular_rate_rad_s[i]);
    let kinetic = 0.5 * (body.mass_kg * v.norm_squared() + w.dot(&(body.inertia_kg_m2 * w)));
    kinetic + body.mass_kg * G * motion.position_m[i].z
}

/// Everything excited: 10 degrees of yaw, 6 of each pitch mode, 0.15 m of sway.
fn lively(rig: &Rig, body: &RigidBody) -> State {
    let modes = small_modes(rig, body).unwrap();
    let part = |kind, size: f64, phase_rad| {
        let mode = by_kind(rig, body, &modes, kind);
        let unit = if kind == ModeKind::SwayLine {
            modes.displacement(mode)
        } else {
            modes.rotation(mode)
        };
        ModalPart {
            mode,
            amplitude: size / unit.norm(),
            phase_rad,
        }
    };
    let parts = [
        part(ModeKind::Yaw, 0.17, 0.3),
        part(ModeKind::SwayLine, 0.15, 1.1),
        part(ModeKind::DoublePendulumInPhase, 0.1, 2.0),
        part(ModeKind::DoublePendulumOutOfPhase, 0.1, 0.7),
    ];
    initial_state(rig, body, &modes, &parts).unwrap()
}

#[test]
fn energy_is_kept_and_the_lines_keep_their_length() {
    let rig = Rig::bifilar(SuspensionAxis::Athwartships, 1.0, 0.56, 0.5, G).unwrap();
    let body = lopsided();
    let motion = run(&rig, &body, &lively(&rig, &body), 600.0, 0.05);
    assert!(motion.slack.is_none());
    let rest = small_modes(&rig, &body)
        .unwrap()
        .equilibrium
        .pose
        .position_m
        .z
        * body.mass_kg
        * G;
    let start = energy_j(&body, &motion, 0) - rest;
    let (mut loss, mut drift) = (0.0f64, 0.0f64);
    for i in 0..motion.t_s.len() {
        loss = loss.max((energy_j(&body, &motion, i) - rest - start).abs() / start);
        for line in &rig.lines {
            let arm = motion.world_from_hull[i] * (line.hull_point_m - body.cm_m);
            drift =
                drift.max(((motion.position_m[i] + arm - line.top_m).norm() - line.length_m).abs());
        }
    }
    println!("energy {loss:.2e} of the energy of the motion, lines {drift:.2e} m");
    assert!(loss < 1e-10, "energy {loss}");
    assert!(drift < 1e-9, "lines {drift} m");
}

#[test]
fn linear_damping_gives_the_decay_of_a_yaw() {
    let (rig, body) = keelboat();
    let inertia = 622.7 * 1.0566 * 1.0566;
    let damping = Damping {
        torque_n_m_s: Vec3::new(0.0, 0.0, 0.02 * inertia),
        ..Damping::default()
    };
    let start = start_in(&rig, &body, ModeKind::Yaw, 1e-3);
    let sampling = Sampling {
        duration_s: 60.0,
        interval_s: 0.02,
        step_s: None,
    };
    let motion = simulate(&rig, &body, &damping, &start, &sampling).unwrap();
    // θ'' + 2 α θ' + ω0² θ = 0 from rest: θ = θ0 e^(−αt) (cos ω t + α/ω sin ω t), α = 0.01.
    let omega0: f64 = 0.9 / 1.0566 * (G / 3.477).sqrt();
    let omega = (omega0 * omega0 - 1e-4).sqrt();
    for (t, angle) in motion.t_s.iter().zip(yaw_angles(&motion)) {
        let expected =
            1e-3 * (-0.01 * t).exp() * ((omega * t).cos() + 0.01 / omega * (omega * t).sin());
        // The finite amplitude turns the phase by 2e-8 · 86 rad in 60 s.
        assert!(
            (angle - expected).abs() < 3e-9,
            "{t} s: {angle} against {expected}"
        );
    }
}

#[test]
fn the_phone_feels_the_motion_of_its_own_place() {
    let rig = Rig::bifilar(SuspensionAxis::Athwartships, 1.0, 0.56, 0.5, G).unwrap();
    let body = lopsided();
    let motion = run(&rig, &body, &lively(&rig, &body), 5.0, 0.005);
    let (place, mount) = (
        Vec3::new(0.7, -0.2, 0.1),
        Rotation::from_euler_angles(0.4, -1.1, 2.0),
    );
    let phone = ideal_phone(&motion, place, mount);
    let at: Vec<Vec3> = (0..motion.t_s.len())
        .map(|i| motion.position_m[i] + motion.world_from_hull[i] * (place - body.cm_m))
        .collect();
    for i in 2..at.len() - 2 {
        // Five-point second difference of the phone's own path; error h⁴/90 x⁽⁶⁾, below 1e-6 here.
        let second = (-at[i - 2] + at[i - 1] * 16.0 - at[i] * 30.0 + at[i + 1] * 16.0 - at[i + 2])
            / (12.0 * 0.005 * 0.005);
        let world_from_phone = motion.world_from_hull[i] * mount;
        let felt = world_from_phone.inverse() * (second + Vec3::new(0.0, 0.0, G));
        assert!((phone.specific_force_m_s2[i] - felt).norm() < 1e-5, "{i}");
        let turn = motion.world_from_hull[i - 1].inverse() * motion.world_from_hull[i + 1];
        let rate = mount.inverse() * (turn.scaled_axis() / 0.01);
        assert!((phone.gyro_rad_s[i] - rate).norm() < 1e-3, "{i}");
    }
}

#[test]
fn a_slack_line_is_reported() {
    let (rig, body) = keelboat();
    let modes = small_modes(&rig, &body).unwrap();
    let mut start = State {
        pose: modes.equilibrium.pose,
        velocity_m_s: Vec3::new(0.0, 9.0, 0.0),
        angular_rate_rad_s: Vec3::zeros(),
    };
    // 9 m/s carries a simple pendulum of 3.477 m past the horizontal, not over the top (13 m/s).
    let motion = run(&rig, &body, &start, 3.0, 0.02);
    let slack = motion.slack.unwrap();
    assert!(slack.t_s > 0.3 && slack.t_s < 3.0, "{slack:?}");
    start.velocity_m_s = Vec3::new(0.0, 1.0, 0.0);
    assert!(run(&rig, &body, &start, 3.0, 0.02).slack.is_none());
}

/// Yaw stiffness m g d²/l + κ, sway mass m + a, and a support in series, which adds m/k to l/g; the
/// double pendulum with a support that gives across swings on lines longer by m g/k in its
/// translation alone.
#[test]
fn effects_on_small_oscillations_are_closed_forms() {
    let body = model_hull();
    let (l, d, mass) = (1.006, 0.28, body.mass_kg);
    let rig = Rig::bifilar(SuspensionAxis::Athwartships, l, 2.0 * d, 2.0 * d, G).unwrap();
    let modes = small_modes(&rig, &body).unwrap();
    let period = |effects: &SmallEffects, kind: ModeKind| {
        let changed = modes.with(&body, effects).unwrap();
        changed.period_s(by_kind(&rig, &body, &changed, kind))
    };
    let (kappa, air_kg, gives_m_n) = (0.4, 1.3, Vec3::new(3e-4, 2e-4, 0.0));
    let mut effects = SmallEffects {
        support_m_n: gives_m_n,
        ..SmallEffects::default()
    };
    effects.stiffness[(5, 5)] = kappa;
    effects.mass[(1, 1)] = air_kg;
    let inertia = body.inertia_kg_m2[(2, 2)];
    assert_close(
        period(&effects, ModeKind::Yaw),
        TAU * (inertia / (mass * G * d * d / l + kappa)).sqrt(),
        1e-9,
    );
    // The support's spring carries the air as well: T² = 4π² (m + a) (l/(m g) + 1/k).
    let sway = TAU * ((mass + air_kg) * (l / (mass * G) + gives_m_n.y)).sqrt();
    assert_close(period(&effects, ModeKind::SwayLine), sway, 1e-9);
    // In the translation of the suspension points the lines' spring m g/l and the support's are in
    // series.
    let (in_phase, out_of_phase) = double_pendulum_s(l + mass * G * gives_m_n.x, 0.253, 0.352);
    assert_close(
        period(&effects, ModeKind::DoublePendulumInPhase),
        in_phase,
        1e-9,
    );
    assert_close(
        period(&effects, ModeKind::DoublePendulumOutOfPhase),
        out_of_phase,
        1e-9,
    );
}
