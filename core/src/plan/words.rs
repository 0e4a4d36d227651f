//! The sentences of the plan's warnings in English: the one place where they stand. Other languages have the same keys.

use std::collections::BTreeMap;

use super::german::GERMAN;
use super::warnings::WarningKind;
use crate::language::Language;

/// Sentences by kind; `{name}` stands for a number, a name or the swing.
const ENGLISH: [(WarningKind, &str); 8] = [
    (
        WarningKind::YawNearInPhase,
        "Swing {swing}: yaw ({yaw_period_s} s) and the in-phase pendulum mode ({in_phase_period_s} s) are {apart_percent} % \
         apart and will feed each other (Kane and Tseng): excite yaw and sway one at a time, or change the line length or \
         the spacing.",
    ),
    (
        WarningKind::NoBeat,
        "Swing {swing}: a spacing of {spacing_m} m is so near to twice the yaw gyradius ({twice_k_yaw_m} m) that yaw and \
         sway do not beat within {duration_s} s: count no beats here.",
    ),
    (
        WarningKind::SlackLine,
        "Swing {swing}: released at {amplitude_deg}°, a line goes slack after {t_s} s: release it with less (leaning along the \
         suspension alone, the lines must stay below {most_lean_deg}°).",
    ),
    (
        WarningKind::TiltNeeded,
        "Swing {swing} hangs tilted, {tilt_deg}° (bow up positive): move the points {points_moved_m} m along the deck \
         (forward positive; the frame's corners would give {corner_tilt_deg}°), and read the tilt from the phone.",
    ),
    (
        WarningKind::SpacingTooShort,
        "{quantity} reaches u = {reached_percent} %, not {wanted_percent} %: a spacing of {spacing_m} m known to {u_input_mm} mm is \
         what limits it. Measure it to {u_input_needed_mm} mm; with this tape the points would have to be {spacing_needed_m} m apart.",
    ),
    (
        WarningKind::NotReached,
        "{quantity} reaches u = {reached_u}, not {wanted_u}: most of it comes from {input} ({contribution_u}), which would \
         have to be known {times_better} times better.",
    ),
    (WarningKind::NotDetermined, "{quantity} is not determined by these swings."),
    (
        WarningKind::RoughHull,
        "{quantity} of the hull is known to {u_percent} % only, and what is predicted from it no better: plan again with the \
         first swing's session.",
    ),
];

/// Sentences by kind in a language.
pub fn sentences(language: Language) -> &'static [(WarningKind, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}

/// The sentence of a warning.
pub fn sentence(
    kind: WarningKind,
    swing: Option<&str>,
    numbers: &BTreeMap<String, f64>,
    names: &BTreeMap<String, String>,
    language: Language,
) -> String {
    let found = sentences(language).iter().find(|(key, _)| *key == kind);
    let mut text = found.map_or("", |(_, sentence)| sentence).replace("{swing}", swing.unwrap_or_default());
    for (name, value) in numbers {
        text = text.replace(&format!("{{{name}}}"), &language.number(&shown(name, *value)));
    }
    for (name, value) in names {
        text = text.replace(&format!("{{{name}}}"), value);
    }
    text
}

/// A number with the digits that its unit asks for.
fn shown(name: &str, value: f64) -> String {
    match name.rsplit('_').next() {
        Some("m") => format!("{value:.3}"),
        Some("s" | "deg") => format!("{value:.1}"),
        _ => two_digits(value),
    }
}

/// At least two digits that count.
fn two_digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let places = (1 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
    format!("{value:.places$}")
}
