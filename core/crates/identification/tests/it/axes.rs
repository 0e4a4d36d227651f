//! Recordings of some of a phone's axes: what they show is measured, what they do not is said.
//!
//! A pure yaw on two parallel lines in closed form, (5): T = 2π (k/d) √(l/g), the phone 0.2 m off the
//! axis and flat: gz has the turn, ay the force along the path, ax that towards the axis, which has
//! twice the frequency.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use gyradius_identification::{
    FindingKind, MeasureOptions, Measurement, QuantityName, measure, measure_recording,
};
use gyradius_recording::{
    LoadedData, LoadedSession, LoadedSwing, ModeName, Recording, read_recording, read_session,
};
use gyradius_test_support::fresh;
use rand_distr::{Distribution, StandardNormal};

const ALL: [&str; 6] = ["gx", "gy", "gz", "ax", "ay", "az"];
const GRAVITY: f64 = 9.80665;
const LINES_M: f64 = 1.2;
const SPACING_M: f64 = 0.4;
const GYRADIUS_M: f64 = 0.129;
const LEVER_M: f64 = 0.2;
const AMPLITUDE_RAD: f64 = 0.08;

fn omega() -> f64 {
    0.5 * SPACING_M / GYRADIUS_M * (GRAVITY / LINES_M).sqrt()
}

/// A yaw as these axes have it.
fn recorded(axes: &str) -> Recording {
    let mut draws = fresh(axes);
    let mut noise = |size: f64| -> f64 {
        let draw: f64 = StandardNormal.sample(&mut draws);
        size * draw
    };
    let omega = omega();
    let mut text = format!("t,{axes}\n");
    for i in 0..6000 {
        let t = i as f64 / 100.0;
        let size = AMPLITUDE_RAD * (-t / 200.0).exp();
        let (sin, cos) = (omega * t).sin_cos();
        let motion = [
            0.0,
            0.0,
            -size * omega * sin,
            -LEVER_M * (size * omega * sin).powi(2),
            -LEVER_M * size * omega * omega * cos,
            GRAVITY,
        ];
        text += &format!("{t:.5}");
        for (c, name) in ALL.iter().enumerate() {
            let read = motion[c] + noise(if c < 3 { 1e-3 } else { 0.01 });
            if axes.split(',').any(|axis| axis == *name) {
                text += &format!(",{read}");
            }
        }
        text += "\n";
    }
    read_recording(text.as_bytes(), "s.csv").unwrap()
}

fn session(axes: &str) -> Measurement {
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\nlength_overall = 1.0\n\
         [site]\ngravity = {{ value = 9.80665, u = 0.0005 }}\n\
         [[swing]]\nid = \"s\"\nrecording = \"s.csv\"\nexcited = [\"yaw\"]\n\
         [swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
         line_length = {{ value = {LINES_M}, u = 0.001 }}\n\
         spacing = {{ value = {SPACING_M}, u = 0.0005 }}\n"
    );
    let loaded = LoadedSession {
        session: read_session(&text, "session.toml").unwrap(),
        source: "written".into(),
        data: vec![LoadedSwing {
            id: "s".into(),
            data: LoadedData::Recording(recorded(axes)),
        }],
        inclines: vec![],
        assumed: vec![],
    };
    measure(&loaded, &MeasureOptions::default()).unwrap()
}

/// Channels of the findings that say which axes are missing.
fn told(result: &Measurement) -> Vec<String> {
    let all = result.findings.iter();
    let missing = all
        .filter(|one| one.kind == FindingKind::NotIdentifiable && one.numbers.contains_key("axes"));
    missing.filter_map(|one| one.channel.clone()).collect()
}

#[test]
fn the_period_comes_from_whichever_axes_show_it() {
    for (axes, missing) in [
        ("gz", &["gz"][..]),
        ("ay", &["ay"]),
        ("gx,gz", &["gx, gz"]),
        ("ax,ay", &["ax, ay"]),
        ("gz,ay", &["gz", "ay"]),
        ("gx,gz,ax,ay,az", &["gx, gz"]),
        ("gx,gy,ax,ay,az", &["gx, gy"]),
        ("gx,gy,gz,ay", &["ay"]),
        ("gx,gy,gz,ax,ay,az", &[]),
    ] {
        let analysis = measure_recording(&recorded(axes), &MeasureOptions::default()).unwrap();
        let result = &analysis.measurement;
        let mode = &result.swings[0].modes[0];
        let off = (mode.period_observed_s - TAU / omega()) / mode.period_se_s;
        assert!(
            off.abs() < 5.0 && mode.period_se_s < 1e-3,
            "{axes}: {mode:?}"
        );
        assert_eq!(told(result), missing, "{axes}");
        let evidence = analysis.evidence[0].as_ref().unwrap();
        assert_eq!(evidence.channels.join(","), axes);
        // An amplitude is told where a gyroscope's axis tells it.
        let angle = mode.amplitude.filter(|_| axes.contains("gz"));
        let is_right = |angle: f64| (angle / AMPLITUDE_RAD - 1.0).abs() < 0.05;
        assert!(angle.is_none_or(is_right), "{axes}: {angle:?}");
        assert_eq!(angle.is_some(), axes.contains("gz"), "{axes}");
    }
}

/// The yaw gyradius follows from a gyroscope's axis that sees the turn, on the operator's word; from
/// axes that do not see it nothing follows.
#[test]
fn a_yaw_is_taken_for_one_only_where_its_axis_was_recorded() {
    for axes in ["gz", "gx,gz", "gz,ay", "gz,ax,ay,az"] {
        let result = session(axes);
        assert_eq!(result.swings[0].modes[0].mode, ModeName::Yaw, "{axes}");
        let k = &result.quantities[&QuantityName::KYaw];
        let (value, u) = (k.value.scalar().unwrap(), k.u.scalar().unwrap());
        assert!(
            (value - GYRADIUS_M).abs() < 3.0 * u,
            "{axes}: {value} ± {u}"
        );
    }
    for axes in ["ay", "ax,ay", "gx,gy,ax,ay,az", "gx,ax,ay,az"] {
        let result = session(axes);
        assert!(
            result.quantities.is_empty(),
            "{axes}: {:?}",
            result.quantities
        );
        let modes = &result.swings[0].modes;
        assert!(
            modes.iter().all(|mode| mode.mode == ModeName::Other),
            "{axes}"
        );
    }
}
