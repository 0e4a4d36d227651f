//! Inclines whose angle a phone recorded: what their figures share, by closed form.
#![allow(clippy::unwrap_used)]

use gyradius_identification::{MeasureOptions, QuantityName, measure};
use gyradius_recording::{LoadedData, LoadedSession, LoadedSwing, read_recording, read_session};

use crate::findings::SWING;

const GRAVITY: f64 = 9.80665;
const MASS_KG: f64 = 20.0;
const WEIGHT_KG: f64 = 0.4;
const ARM_M: f64 = 0.4;
const DEPTH_M: f64 = 0.1;
/// Standard uncertainty of the scale's zero.
const ZERO_U_KG: f64 = 0.04;

/// A phone at rest on a hull that is pitched, by its specific force.
fn at_rest(angle_rad: f64) -> String {
    let (sin, cos) = angle_rad.sin_cos();
    let row = |i: usize| {
        let t = 0.01 * i as f64;
        format!("{t},{},0,{}\n", GRAVITY * sin, GRAVITY * cos)
    };
    format!("t,ax,ay,az\n{}", (0..300).map(row).collect::<String>())
}

/// The depth and its uncertainty by two inclines, one at each end, each with its weight as read.
fn depth(weight: &str) -> (f64, f64) {
    let incline = |end: &str| {
        format!(
            "[[incline]]\nend = \"{end}\"\nmass = {weight}\narm = {{ value = {ARM_M}, u = 0.0 }}\n\
             depth = {{ value = 0.0, u = 0.0 }}\nrecording = \"{end}.csv\"\n"
        )
    };
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = {{ value = {MASS_KG:?}, u = 0.0 }}\n\
         [site]\ngravity = {{ value = {GRAVITY}, u = 0.0005 }}\n\
         [[instrument]]\nid = \"scale\"\nkind = \"scale\"\nzero_u = {ZERO_U_KG}\n\
         [[swing]]\nid = \"level\"\nrecording = \"level.csv\"\n[swing.suspension]\n\
         kind = \"bifilar\"\norientation = \"athwartships\"\nline_length = {{ value = 1.2, u = 0.001 }}\n\
         spacing = {{ value = 0.4, u = 0.001 }}\n{}{}",
        incline("bow"),
        incline("stern")
    );
    let session = read_session(&text, "session.toml").unwrap();
    let read = |csv: &str, name: &str| read_recording(csv.as_bytes(), name).unwrap();
    // (20): tan φ = m L / (M l2) where the weight hangs at the height of the points.
    let angle_rad = (WEIGHT_KG * ARM_M / (MASS_KG * DEPTH_M)).atan();
    let data = LoadedData::Recording(read(&SWING.csv("level"), "level.csv"));
    let loaded = LoadedSession {
        session,
        source: "written".into(),
        data: vec![LoadedSwing {
            id: "level".into(),
            data,
        }],
        inclines: [angle_rad, -angle_rad]
            .map(|angle| Some(read(&at_rest(angle), "incline.csv")))
            .to_vec(),
        assumed: vec![],
    };
    let result = measure(&loaded, &MeasureOptions::default()).unwrap();
    let found = &result.quantities[&QuantityName::CmDepth];
    (found.value.scalar().unwrap(), found.u.scalar().unwrap())
}

/// l2 goes as the weight: what a scale adds to both readings of it stays, what each has of its own
/// is halved in square. Beside it stands the phone's tilt, 0.15° in each angle.
#[test]
fn inclines_that_were_recorded_share_the_scale() {
    let tangent = WEIGHT_KG * ARM_M / (MASS_KG * DEPTH_M);
    let of_tilt = 0.15_f64.to_radians() * (1.0 + tangent * tangent) / tangent;
    let relative = ZERO_U_KG / WEIGHT_KG;
    let own = format!("{{ value = {WEIGHT_KG}, u = {ZERO_U_KG} }}");
    let (value, u) = depth(&own);
    assert!((value - DEPTH_M).abs() < 0.02 * DEPTH_M, "{value}");
    let expected = (relative.powi(2) + of_tilt.powi(2)).sqrt() / 2.0_f64.sqrt();
    assert!((u / value / expected - 1.0).abs() < 0.05, "{u} {expected}");
    let (value, u) = depth(&format!(
        "{{ value = {WEIGHT_KG}, u = 0.0, instrument = \"scale\" }}"
    ));
    assert!((value - DEPTH_M).abs() < 0.02 * DEPTH_M, "{value}");
    let expected = (relative.powi(2) + 0.5 * of_tilt.powi(2)).sqrt();
    assert!((u / value / expected - 1.0).abs() < 0.05, "{u} {expected}");
}
