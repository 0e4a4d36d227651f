//! The planner against the paper's figures and closed forms.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use gyradius_identification::routes::compound;
use gyradius_identification::routes::double_pendulum::DepthIs;
use gyradius_planning::{
    Means, Optima, Plan, Request, RoughHull, WarningKind, best_length_over_depth, omega_u, plan,
    yaw_meets_in_phase_m,
};
use gyradius_recording::{ModeName, Quantity};
use serde_json::Value;

fn hull(k_yaw: f64, k_pitch: f64, k_roll: f64, depth: f64) -> RoughHull {
    RoughHull {
        mass_kg: Some(13.18),
        length_m: Some(6.0 * k_yaw),
        beam_m: Some(1.8 * k_yaw),
        k_yaw_m: Some(Quantity::exact(k_yaw)),
        k_pitch_m: Some(Quantity::exact(k_pitch)),
        k_roll_m: Some(Quantity::exact(k_roll)),
        cm_depth_m: Some(Quantity::exact(depth)),
        ..RoughHull::default()
    }
}

/// Lines of one length at one spacing: nothing left to choose.
fn hung(hull: RoughHull, length_m: f64, spacing_m: f64, amplitude_deg: f64) -> Plan {
    let means = Means {
        least_line_length_m: length_m,
        most_line_length_m: length_m,
        least_spacing_m: Some(spacing_m),
        most_spacing_m: Some(spacing_m),
        amplitude_deg,
        ..Means::default()
    };
    plan(&Request {
        hull,
        means,
        ..Request::default()
    })
    .unwrap()
}

/// The paper's model, Fig. 15.
fn model() -> RoughHull {
    hull(0.303, 0.352, 0.204, 0.253)
}

fn warned(plan: &Plan, kind: WarningKind) -> Option<&gyradius_planning::Warning> {
    plan.warnings.iter().find(|w| w.kind == kind)
}

#[test]
fn figure_15_and_its_warning() {
    // Errata: out of phase, in phase, sway, yaw at l1 = 0.504, 1.006, 1.560 m.
    for (length, [out, slow, sway, yaw]) in [
        (0.504, [0.997, 2.006, 1.424, 1.541]),
        (1.006, [1.192, 2.370, 2.012, 2.178]),
        (1.560, [1.272, 2.766, 2.506, 2.712]),
    ] {
        let plan = hung(model(), length, 0.56, 5.0);
        let periods = &plan.predicted[0].periods_s;
        let expected = [
            (ModeName::PitchOutOfPhase, out),
            (ModeName::PitchInPhase, slow),
            (ModeName::Sway, sway),
            (ModeName::Yaw, yaw),
        ];
        for (mode, period) in expected {
            // ψ makes a part in a thousand of the yaw.
            assert_relative_eq!(periods[&mode], period, max_relative = 3e-3);
        }
        let near = warned(&plan, WarningKind::YawNearInPhase);
        assert_eq!(near.is_some(), length > 1.5, "{:?}", plan.warnings);
        if let Some(near) = near {
            assert_relative_eq!(near.numbers["apart_percent"], 2.0, max_relative = 0.2);
            assert!(near.text.contains("Kane and Tseng"));
            // Simultaneous excitation is what couples them: yaw and sway are swung one at a time.
            assert!(
                plan.predicted.iter().any(|s| s.id == "yaw")
                    && plan.predicted.iter().any(|s| s.id == "sway")
            );
        }
    }
}

/// (5) and (16), in phase.
fn periods(l: f64, d: f64, ky: f64, kp: f64, l2: f64) -> [f64; 2] {
    let g = 9.81;
    let s = l * l2 + l2 * l2 + kp * kp;
    let w = g / (2.0 * l * kp * kp) * (s - (s * s - 4.0 * l * l2 * kp * kp).sqrt());
    [TAU * ky / d * (l / g).sqrt(), TAU / w.sqrt()]
}

#[test]
fn yaw_meets_the_in_phase_mode_where_the_equations_cross() {
    for (d, ky, kp, l2) in [
        (0.28, 0.303, 0.352, 0.253),
        (0.9, 1.057, 1.156, 0.4),
        (0.5, 1.1, 1.1, 0.3),
    ] {
        let l = yaw_meets_in_phase_m(d, ky, kp, l2).unwrap();
        let [yaw, slow] = periods(l, d, ky, kp, l2);
        assert_relative_eq!(yaw, slow, max_relative = 1e-9);
    }
    assert_eq!(yaw_meets_in_phase_m(1.1, 1.057, 1.156, 0.4), None);
}

#[test]
fn figure_17() {
    // The paper's 0.5 m for the model, 1.7 m for the keelboat (K_P2 of about 1.5); errata 0.498 and
    // 0.29 m.
    let of = |k_yaw, k_pitch, k_roll, depth| {
        hung(hull(k_yaw, k_pitch, k_roll, depth), 1.0, 0.5 * k_yaw, 5.0).optima
    };
    let model: Optima = of(0.303, 0.352, 0.204, 0.253);
    assert_relative_eq!(
        model.line_length_depth_known_m.unwrap(),
        0.498,
        epsilon = 0.0006
    );
    assert_relative_eq!(model.line_length_joint_m.unwrap(), 0.29, epsilon = 0.005);
    let keelboat = of(1.057, 1.156, 0.623, 1.156 / 1.5);
    assert_relative_eq!(
        keelboat.line_length_depth_known_m.unwrap(),
        1.7,
        epsilon = 0.08
    );
    // The whole curves, at 30 digits by tests/oracles.
    let text = include_str!("../../../../../../tests/vectors/double_pendulum_best_length.json");
    let vectors: Value = serde_json::from_str(text).unwrap();
    let mut points = 0;
    for case in vectors["tests"].as_array().unwrap() {
        if !case["comment"]
            .as_str()
            .unwrap()
            .starts_with("Fig. 17 in units of the depth")
        {
            continue;
        }
        let known = case["inputs"]["depth_known"] == 1;
        let depth = if known {
            DepthIs::Known
        } else {
            DepthIs::SolvedFor
        };
        let found =
            best_length_over_depth(case["inputs"]["gyradius_m"].as_f64().unwrap(), depth).unwrap();
        let expected: f64 = case["expected"]["line_length_m"]
            .as_str()
            .unwrap()
            .parse()
            .unwrap();
        assert_relative_eq!(found, expected, max_relative = 1e-6);
        points += 1;
    }
    assert_eq!(points, 11);
}

#[test]
fn the_compound_pendulums_height_makes_an_error_of_it_harmless() {
    let optima = hung(model(), 1.0, 0.5, 5.0).optima;
    for (k, a) in [
        (0.352, optima.compound_pitch_axis_to_cm_m),
        (0.204, optima.compound_roll_axis_to_cm_m),
    ] {
        assert!(compound::slopes(k, a, 9.81).unwrap().by_axis_to_cm.abs() < 1e-12); // (24)
    }
    assert_relative_eq!(
        optima.compound_pitch_axis_height_m,
        0.352 - 0.253,
        epsilon = 1e-12
    );
}

#[test]
fn the_beat_is_that_of_the_paper() {
    // (13): n = 25 makes k_y = 51/49 d (Fig. 4); 7.33 of Fig. 3 for 4.39 and 3.83 s.
    let (d, g) = (0.5, 9.80665);
    // The depths keep the in-phase mode away from the yaw, which would else be swung by itself.
    for (ratio, n, depth) in [(51.0 / 49.0, 25.0, 1.5), (4.39 / 3.83, 7.33, 0.05)] {
        let k = ratio * d;
        let exact = RoughHull {
            psi_deg: Some(Quantity::exact(0.0)),
            ..hull(k, k, 0.5 * k, depth)
        };
        let plan = hung(exact, 3.644, 2.0 * d, 5.0);
        let beat = plan.predicted.iter().find_map(|s| s.beat).unwrap();
        // The paper cuts 7.339 to 7.33.
        assert_relative_eq!(beat.oscillations.unwrap(), n, max_relative = 1.5e-3);
        let sway = TAU * (3.644_f64 / g).sqrt();
        assert_relative_eq!(
            beat.period_s.unwrap(),
            ratio * sway / (ratio - 1.0),
            max_relative = 1e-6
        ); // (11)
        assert!(
            warned(&plan, WarningKind::NoBeat).is_none(),
            "{:?}",
            plan.warnings
        );
    }
    let k = 0.5;
    let exact = RoughHull {
        psi_deg: Some(Quantity::exact(0.0)),
        ..hull(k, k, 0.5 * k, 1.0)
    };
    let plan = hung(exact, 2.0, 1.0, 5.0);
    let warning = warned(&plan, WarningKind::NoBeat).unwrap();
    assert_relative_eq!(warning.numbers["twice_k_yaw_m"], 1.0, epsilon = 1e-12);
}

#[test]
fn a_line_goes_slack_where_the_moments_say() {
    // Leaning by θ, the tensions stand as d + l2 tan θ to d − l2 tan θ: here d / l2 = 0.2, θ =
    // 11.3°.
    let deep = || hull(1.0, 1.1, 0.6, 1.0);
    assert!(warned(&hung(deep(), 2.0, 0.4, 8.0), WarningKind::SlackLine).is_none());
    let plan = hung(deep(), 2.0, 0.4, 16.0);
    let slack = warned(&plan, WarningKind::SlackLine).unwrap();
    assert_relative_eq!(
        slack.numbers["most_lean_deg"],
        0.2_f64.atan().to_degrees(),
        epsilon = 1e-9
    );
}

#[test]
fn the_period_at_the_release_is_longer_as_the_errata_say() {
    // Keelboat rig: +76, 473, 1893 ppm of yaw at 2, 5, 10 degrees, heave included.
    for (angle, ppm) in [(2.0, 76.0), (5.0, 473.0), (10.0, 1893.0)] {
        let plan = hung(hull(1.0566, 1.156, 0.625, 0.402), 3.477, 1.8, angle);
        let longer = plan
            .predicted
            .iter()
            .find_map(|s| s.longer_at_release_ppm.get(&ModeName::Yaw))
            .unwrap();
        assert_relative_eq!(*longer, ppm, epsilon = 1.0);
    }
}

#[test]
fn the_bound_of_a_frequency() {
    // 120 s at 100 Hz, A = 0.2 rad/s, 0.001 rad/s: 1.4 ppm of 4.39 s at a decay time of 640 s.
    let omega = TAU / 4.39;
    assert_relative_eq!(
        1e6 * omega_u(200.0, 100.0, 120.0, 640.0) / omega,
        1.4,
        epsilon = 0.06
    );
    // Undamped: 24 σ² / (A² f_s T³).
    let undamped = (24.0 / (200.0_f64.powi(2) * 100.0 * 120.0_f64.powi(3))).sqrt();
    assert_relative_eq!(
        omega_u(200.0, 100.0, 120.0, 1e9),
        undamped,
        max_relative = 1e-4
    );
}

#[test]
fn the_tape_between_the_points_is_the_floor() {
    // k = (T_y / T_s) d (8): nothing makes the gyradius better known than the spacing.
    let means = Means {
        u_spacing_m: 0.004,
        most_line_length_m: 2.0,
        ..Means::default()
    };
    let wanted = vec!["k_yaw=0.05%".to_owned()];
    let plan = plan(&Request {
        hull: hull(1.057, 1.156, 0.623, 0.5),
        means,
        wanted,
        ..Request::default()
    })
    .unwrap();
    let warning = warned(&plan, WarningKind::SpacingTooShort).unwrap();
    let spacing = warning.numbers["spacing_m"];
    let u = plan.quantities["k_yaw_m"].u.unwrap();
    assert_relative_eq!(u / 1.057, 0.004 / spacing, max_relative = 0.05);
    // What would be needed: no more than 0.05 % of the spacing, or a spacing at which 4 mm is that.
    let needed = 1e-3 * warning.numbers["u_input_needed_mm"];
    assert!(
        needed < 5e-4 * spacing && needed > 1e-4 * spacing,
        "{needed}"
    );
    assert_relative_eq!(
        warning.numbers["spacing_needed_m"],
        0.004 / needed * spacing,
        max_relative = 1e-9
    );
    // The widest spacing there is serves best.
    assert_relative_eq!(spacing, 1.25 * 1.8 * 1.057, max_relative = 0.01);
}
