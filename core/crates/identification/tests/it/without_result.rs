//! Sessions that give no quantity: each says why, where, and what to do.
#![allow(clippy::unwrap_used)]

use gyradius_base::language::Language;
use gyradius_identification::{FindingKind, Measurement, Severity};

use crate::instruments::typed;

const HEAD: &str = "format = \"gyradius-session/1\"\n[body]\nmass = { value = 100.0, u = 0.1 }\n\
    [site]\ngravity = { value = 9.81, u = 0.0005 }\n";
const LINES: &str = "kind = \"bifilar\"\norientation = \"athwartships\"\n\
    line_length = { value = 2.0, u = 0.002 }\nspacing = { value = 1.2, u = 0.002 }\n";
const INCLINE: &str = "[[incline]]\nend = \"bow\"\nmass = { value = 1.0, u = 0.001 }\n\
    arm = { value = 1.0, u = 0.001 }\ndepth = { value = 0.0, u = 0.001 }\n\
    angle_deg = { value = 5.0, u = 0.1 }\n";

fn swing(id: &str, periods: &str, hung: &str) -> String {
    format!("[[swing]]\nid = \"{id}\"\nperiods_s = {{ {periods} }}\n[swing.suspension]\n{hung}")
}

/// The refusals that say why, by swing.
fn reasons(result: &Measurement) -> Vec<(Option<String>, String)> {
    assert!(result.quantities.is_empty(), "{:?}", result.quantities);
    let refused = result.findings.iter().filter(|one| {
        one.kind == FindingKind::NotIdentifiable && one.severity == Severity::Refused
    });
    refused
        .map(|one| {
            for said in [&one.message, &one.advice] {
                for language in [Language::English, Language::German] {
                    assert!(!said.in_language(language).is_empty());
                }
            }
            (one.swing.clone(), one.message.english.clone())
        })
        .collect()
}

fn assert_told(text: &str, swing: Option<&str>, part: &str) {
    let result = typed(text);
    let told = reasons(&result);
    let is_it =
        |(of, said): &(Option<String>, String)| of.as_deref() == swing && said.contains(part);
    assert!(
        told.iter().any(is_it),
        "{part}: {told:?} {:?}",
        result.warnings
    );
}

#[test]
fn a_session_without_a_quantity_says_why() {
    let sway = swing("a", "sway = { value = 2.837, u = 0.001 }", LINES);
    assert_told(&format!("{HEAD}{sway}"), None, "sway alone");
    let unnamed = swing("b", "other = { value = 3.1, u = 0.001 }", LINES);
    assert_told(&format!("{HEAD}{unnamed}"), Some("b"), "3.100 s");
    let free = swing("c", "yaw = { value = 3.1, u = 0.001 }", "kind = \"free\"\n");
    assert_told(
        &format!("{HEAD}{free}"),
        Some("c"),
        "nothing is stated of the suspension",
    );
    let axle = "kind = \"compound\"\norientation = \"athwartships\"\naxis_height = { value = 0.5, u = 0.001 }\n";
    let other = swing("d", "yaw = { value = 3.1, u = 0.001 }", axle);
    assert_told(&format!("{HEAD}{other}"), Some("d"), "yaw is no motion");
    let roll = swing("e", "roll_in_phase = { value = 3.1, u = 0.001 }", LINES);
    assert_told(
        &format!("{HEAD}{roll}"),
        Some("e"),
        "orientation = \"athwartships\"",
    );
    assert_told(&format!("{HEAD}{INCLINE}"), None, "no swing in the session");
    // Each that does not enter by itself.
    let two = format!("{HEAD}{sway}{free}");
    assert_told(&two, None, "sway alone");
    assert_told(&two, Some("c"), "nothing is stated");
}

/// A period that its suspension does not have takes nothing from the others.
#[test]
fn a_motion_that_the_suspension_does_not_have_spoils_nothing() {
    // T = 2π k/d √(L/g)
    let yaw_s = std::f64::consts::TAU * 1.1 / 0.6 * (2.0_f64 / 9.81).sqrt();
    let periods = format!(
        "yaw = {{ value = {yaw_s:?}, u = 0.001 }}, other = {{ value = 3.1, u = 0.001 }}, roll_in_phase = 2.9"
    );
    let result = typed(&format!("{HEAD}{}", swing("a", &periods, LINES)));
    let (value, u) = crate::instruments::k_yaw(&result);
    assert!((value - 1.1).abs() < u && u < 0.005, "{value} {u}");
    let is_told = |one: &gyradius_identification::Finding| {
        one.severity == Severity::Warned && one.message.english.starts_with("roll in phase")
    };
    assert!(result.findings.iter().any(is_told), "{:?}", result.findings);
}
