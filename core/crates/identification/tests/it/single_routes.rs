//! Single routes own up to what their equations leave out: a roll pendulum whose hull's principal
//! axes are turned by a ψ that nobody knows.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use gyradius_base::frames::{Mat3, Vec3};
use gyradius_identification::{MeasureOptions, Measurement, RouteMethod, measure};
use gyradius_mechanics::{Rig, RigidBody, SuspensionAxis, small_modes};
use gyradius_recording::{LoadedData, LoadedSession, LoadedSwing, Swing, read_session};
use gyradius_test_support::rng;
use rand::RngExt;

const GRAVITY: f64 = 9.80665;
const MASS_KG: f64 = 13.18;
const DEPTH_M: f64 = 0.253;
/// Roll, pitch, yaw gyradius, m.
const GYRADII_M: [f64; 3] = [0.15, 0.352, 0.353];
/// Length and spacing of the lines, level and in roll, m.
const LEVEL_M: (f64, f64) = (1.006, 0.56);
const ROLL_M: (f64, f64) = (0.8, 0.3);

/// A hull of the size of the model in Fig. 15 with its principal axes turned by ψ (eq. 3 in tensor
/// form).
fn hull(psi_rad: f64) -> RigidBody {
    let [k_x, k_y, k_z] = GYRADII_M;
    let (s, c) = psi_rad.sin_cos();
    let (xx, zz) = (k_x * k_x, k_z * k_z);
    let product = (zz - xx) * s * c;
    let k2 = Mat3::new(
        c * c * xx + s * s * zz,
        0.0,
        product,
        0.0,
        k_y * k_y,
        0.0,
        product,
        0.0,
        s * s * xx + c * c * zz,
    );
    RigidBody {
        mass_kg: MASS_KG,
        inertia_kg_m2: k2 * MASS_KG,
        cm_m: Vec3::new(0.0, 0.0, -DEPTH_M),
    }
}

/// The small periods of the full linear theory that lie nearest to those of the simple equations.
fn nearest(
    body: &RigidBody,
    axis: SuspensionAxis,
    (length_m, spacing_m): (f64, f64),
    simple: &[f64],
) -> Vec<f64> {
    let rig = Rig::bifilar(axis, length_m, spacing_m, spacing_m, GRAVITY).unwrap();
    let modes = small_modes(&rig, body).unwrap();
    let off = |s: f64, i: usize| (modes.period_s(i) / s).ln().abs();
    let of = |s: &f64| {
        (0..4)
            .min_by(|a, b| off(*s, *a).total_cmp(&off(*s, *b)))
            .unwrap()
    };
    simple.iter().map(|s| modes.period_s(of(s))).collect()
}

/// Both periods of the double pendulum by (16).
fn double_pendulum(k: f64, l1: f64) -> [f64; 2] {
    let (l2, k2) = (DEPTH_M, k * k);
    let sum = l1 * l2 + l2 * l2 + k2;
    let root = (sum * sum - 4.0 * l1 * l2 * k2).sqrt();
    [-1.0, 1.0].map(|sign| TAU / (GRAVITY * (sum + sign * root) / (2.0 * l1 * k2)).sqrt())
}

/// Somebody hung the hull level, moved the suspension points forward and read the tilt: the depth
/// is Δ/tan φ, its uncertainty that of both readings; the law of propagation by hand.
#[test]
fn moved_suspension_points_give_the_depth() {
    let (tilt_deg, u_deg, u_m) = (20.0_f64, 0.2_f64, 0.001);
    let (sin, tan) = (tilt_deg.to_radians().sin(), tilt_deg.to_radians().tan());
    let moved_m = DEPTH_M * tan;
    let yaw = swing("level", "athwartships", LEVEL_M, &[("yaw", 2.0)]);
    let tilted = swing("tilted", "athwartships", LEVEL_M, &[("yaw", 1.9)]).replace(
        "hull_pitch_deg = 0.0",
        &format!(
            "hull_pitch_deg = {{ value = {tilt_deg}, u = {u_deg} }}\npoints_moved = {{ value = {moved_m:?}, u = {u_m} }}"
        ),
    );
    let result = measured_text(&(yaw + &tilted));
    let u = (u_m / tan).hypot(moved_m / (sin * sin) * u_deg.to_radians());
    let depth = &result.quantities["cm_depth_m"];
    assert!(
        (depth.value.scalar().unwrap() - DEPTH_M).abs() < 0.02 * u,
        "{depth:?}"
    );
    // The yaw of a tilted hull says a little of its tilt, too, and the unknown axes take a little
    // away.
    assert!(
        (depth.u.scalar().unwrap() / u - 1.0).abs() < 0.1,
        "{depth:?} {u}"
    );
    let route = result.alternatives["cm_depth_m"]
        .iter()
        .find(|r| r.method == RouteMethod::PointsMoved)
        .unwrap();
    assert!(
        (route.value - DEPTH_M).abs() < 1e-9 && (route.u / u - 1.0).abs() < 0.02,
        "{route:?} {u}"
    );
}

fn swing(
    id: &str,
    orientation: &str,
    (length_m, spacing_m): (f64, f64),
    periods: &[(&str, f64)],
) -> String {
    let typed: Vec<String> = periods
        .iter()
        .map(|(mode, t)| format!("{mode} = {{ value = {t:?}, u = 0.0002 }}"))
        .collect();
    format!(
        "[[swing]]\nid = \"{id}\"\nperiods_s = {{ {} }}\n[swing.suspension]\nkind = \"bifilar\"\n\
         orientation = \"{orientation}\"\nline_length = {{ value = {length_m}, u = 0.0005 }}\n\
         spacing = {{ value = {spacing_m}, u = 0.0005 }}\nhull_pitch_deg = 0.0\n",
        typed.join(", ")
    )
}

/// What a level swing and a roll of such a hull give.
fn measured(psi_rad: f64) -> Measurement {
    let body = hull(psi_rad);
    let [pitch_in, pitch_out] = double_pendulum(GYRADII_M[1], LEVEL_M.0);
    let yaw = TAU * GYRADII_M[2] / (0.5 * LEVEL_M.1) * (LEVEL_M.0 / GRAVITY).sqrt(); // (5)
    let sway = TAU * (LEVEL_M.0 / GRAVITY).sqrt(); // (7)
    let level = nearest(
        &body,
        SuspensionAxis::Athwartships,
        LEVEL_M,
        &[yaw, sway, pitch_in, pitch_out],
    );
    let roll = nearest(
        &body,
        SuspensionAxis::ForeAndAft,
        ROLL_M,
        &double_pendulum(GYRADII_M[0], ROLL_M.0),
    );
    let names = ["yaw", "sway", "pitch_in_phase", "pitch_out_of_phase"];
    let of_level: Vec<(&str, f64)> = names.into_iter().zip(level).collect();
    let of_roll: Vec<(&str, f64)> = ["roll_in_phase", "roll_out_of_phase"]
        .into_iter()
        .zip(roll)
        .collect();
    measured_text(
        &(swing("level", "athwartships", LEVEL_M, &of_level)
            + &swing("roll", "fore_and_aft", ROLL_M, &of_roll)),
    )
}

fn measured_text(swings: &str) -> Measurement {
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = {MASS_KG}\n[site]\ngravity = {GRAVITY}\n{swings}"
    );
    let session = read_session(&text, "session.toml").unwrap();
    let typed = |swing: &Swing| LoadedSwing {
        id: swing.id.clone(),
        data: LoadedData::Typed,
    };
    let data = session.swings.iter().map(typed).collect();
    measure(
        &LoadedSession {
            session,
            source: "made".into(),
            data,
            inclines: vec![],
            assumed: vec![],
        },
        &MeasureOptions::default(),
    )
    .unwrap()
}

/// The true depth, and the true gyradius about the hull's x axis, lie within three of each route's
/// uncertainties; no two routes are said to contradict each other.
#[test]
fn a_roll_whose_principal_axes_are_turned_contradicts_nothing() {
    let mut rng = rng();
    for _ in 0..30 {
        let psi_deg = rng.random_range(-7.0..7.0_f64);
        let result = measured(psi_deg.to_radians());
        let k_roll_m = (hull(psi_deg.to_radians()).inertia_kg_m2[(0, 0)] / MASS_KG).sqrt();
        for (quantity, truth) in [("cm_depth_m", DEPTH_M), ("k_roll_m", k_roll_m)] {
            for route in &result.alternatives[quantity] {
                let z = (route.value - truth) / route.u;
                assert!(
                    z.abs() < 3.0,
                    "psi {psi_deg}: {quantity} by {} from {:?}: z {z}",
                    route.method,
                    route.from
                );
            }
        }
        let flagged: Vec<&str> = result
            .consistency
            .iter()
            .filter(|c| c.flagged)
            .map(|c| c.message.english.as_str())
            .collect();
        assert!(flagged.is_empty(), "psi {psi_deg}: {flagged:?}");
    }
}
