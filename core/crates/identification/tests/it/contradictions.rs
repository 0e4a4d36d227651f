//! Sessions that contradict themselves: which stated figure is wrong, by closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use gyradius_identification::{FindingKind, Severity};

use crate::instruments::{k_yaw, typed};

const GRAVITY: f64 = 9.80665;
const GYRADIUS_M: f64 = 1.1;
const LINES_M: f64 = 2.0;
const MASS_KG: f64 = 100.0;
/// Added masses: two of so many kg, so far to either side.
const ADDED: [(&str, f64, f64); 3] = [
    ("bare", 0.0, 1.0),
    ("light", 5.0, 1.5),
    ("heavy", 12.0, 1.5),
];

/// Yaw of a body that carries two equal masses fore and aft, by (5).
fn yaw_s(spacing_m: f64, added_kg: f64, at_m: f64) -> f64 {
    let mass_kg = MASS_KG + 2.0 * added_kg;
    let inertia = MASS_KG * GYRADIUS_M.powi(2) + 2.0 * added_kg * at_m.powi(2);
    TAU * (inertia / mass_kg).sqrt() / (0.5 * spacing_m) * (LINES_M / GRAVITY).sqrt()
}

fn session(is_m: [f64; 3], typed_m: [f64; 3]) -> String {
    let mut text = format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = {{ value = {MASS_KG:?}, u = 0.0 }}\n\
         [site]\ngravity = {{ value = {GRAVITY}, u = 0.0005 }}\n"
    );
    for (k, (id, added_kg, at_m)) in ADDED.into_iter().enumerate() {
        let period_s = yaw_s(is_m[k], added_kg, at_m);
        let mass = |x: f64| {
            format!(
                "{{ mass = {{ value = {added_kg:?}, u = 0.0 }}, position = [{x:?}, 0.0, 0.0] }}"
            )
        };
        let added = match added_kg {
            0.0 => String::new(),
            _ => format!("added_mass = [{}, {}]\n", mass(at_m), mass(-at_m)),
        };
        text += &format!(
            "[[swing]]\nid = \"{id}\"\nperiods_s = {{ yaw = {{ value = {period_s:?}, u = 1e-4 }} }}\n\
             amplitude_deg = {{ yaw = 0 }}\n{added}[swing.suspension]\nkind = \"bifilar\"\n\
             orientation = \"athwartships\"\nline_length = {{ value = {LINES_M:?}, u = 0.001 }}\n\
             spacing = {{ value = {:?}, u = 0.001 }}\n",
            typed_m[k]
        );
    }
    text
}

/// A tape read once and typed wrong for three swings is one slip: the masses that were added tell
/// the spacing, and with it the gyradius.
#[test]
fn one_slip_in_several_swings_is_one_suspect() {
    let right = typed(&session([1.3; 3], [1.3; 3]));
    let is_told = |f: &&gyradius_identification::Finding| f.kind == FindingKind::Contradiction;
    assert!(!right.findings.iter().any(|f| is_told(&f)));
    let wrong = typed(&session([1.3; 3], [1.03; 3]));
    let told = wrong.findings.iter().find(is_told).unwrap();
    assert_eq!(told.severity, Severity::Widened);
    let text = &told.message.english;
    assert!(text.contains("spacing of bare, light, heavy"), "{text}");
    let (value, u) = k_yaw(&wrong);
    // By the wrong tape it would be 1.1 · 1.03/1.3 = 0.87.
    assert!(
        (value - GYRADIUS_M).abs() < 3.0 * u && u < 0.05,
        "{value} {u}"
    );
    // Of three that were read apart, the one that is wrong is found by itself.
    let one = typed(&session([1.3, 1.301, 1.302], [1.3, 1.301, 1.032]));
    let text = &one.findings.iter().find(is_told).unwrap().message.english;
    assert!(
        text.contains("spacing") && !text.contains("spacing of"),
        "{text}"
    );
}
