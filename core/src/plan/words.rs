//! The sentences of the plan in English: the one place where they stand. Other languages have the
//! same keys.

use super::german::GERMAN;
use super::warnings::{Warning, WarningKind};
use crate::inertia;
use crate::language::{Argument, Language, Text, entry};

/// What all keys of the plan begin with.
const OF_PLAN: &str = "plan.";

/// Sentences by key, those of warnings by their kind; `{name}` stands for a number, a name or the
/// swing.
const ENGLISH: [(&str, &str); 12] = [
    (
        "yaw_near_in_phase",
        "Swing {swing}: yaw ({yaw_period_s} s) and the in-phase pendulum mode ({in_phase_period_s} s) are {apart_percent} % \
         apart and will feed each other (Kane and Tseng): excite yaw and sway one at a time, or change the line length or \
         the spacing.",
    ),
    (
        "no_beat",
        "Swing {swing}: a spacing of {spacing_m} m is so near to twice the yaw gyradius ({twice_k_yaw_m} m) that yaw and \
         sway do not beat within {duration_s} s: count no beats here.",
    ),
    (
        "slack_line",
        "Swing {swing}: released at {amplitude_deg}°, a line goes slack after {t_s} s: release it with less (leaning along the \
         suspension alone, the lines must stay below {most_lean_deg}°).",
    ),
    (
        "tilt_needed",
        "Swing {swing} hangs tilted, {tilt_deg}° (bow up positive): move the points {points_moved_m} m along the deck \
         (forward positive; the frame's corners would give {corner_tilt_deg}°), and read the tilt from the phone.",
    ),
    (
        "spacing_too_short",
        "{quantity} reaches u = {reached_percent} %, not {wanted_percent} %: a spacing of {spacing_m} m known to {u_input_mm} mm is \
         what limits it. Measure it to {u_input_needed_mm} mm; with this tape the points would have to be {spacing_needed_m} m apart.",
    ),
    (
        "not_reached",
        "{quantity} reaches u = {reached_u}, not {wanted_u}: most of it comes from {input} ({contribution_u}), which would \
         have to be known {times_better} times better.",
    ),
    (
        "not_determined",
        "{quantity} is not determined by these swings.",
    ),
    (
        "rough_hull",
        "{quantity} of the hull is known to {u_percent} % only, and what is predicted from it no better: plan again with the \
         first swing's session.",
    ),
    (
        "hang_fore_and_aft",
        "level, two lines of {length_m} m, {spacing_m} m apart, one behind the other in the centre plane (H-D)",
    ),
    (
        "hang_level",
        "level, two lines of {length_m} m, {spacing_m} m apart, side by side over the centre of mass (B-F)",
    ),
    (
        "hang_bow_up",
        "two lines of {length_m} m, {spacing_m} m apart, side by side, {moved_m} m forward of the level ones (towards {points}): the bow hangs {tilt_deg}° up",
    ),
    (
        "hang_bow_down",
        "two lines of {length_m} m, {spacing_m} m apart, side by side, {moved_m} m aft of the level ones (towards {points}): the bow hangs {tilt_deg}° down",
    ),
];

/// A sentence of the plan with what it names.
pub fn said<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Text {
    let arguments = arguments
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    Text::of(format!("{OF_PLAN}{key}"), arguments, sentence)
}

impl Warning {
    /// Its sentence.
    pub fn said(&self) -> Text {
        let swing = self
            .swing
            .iter()
            .map(|id| ("swing", Argument::Id(id.clone())));
        let numbers = self
            .numbers
            .iter()
            .map(|(n, value)| (n.as_str(), Argument::Figure(shown(n, *value))));
        let names = self
            .names
            .iter()
            .map(|(n, name)| (n.as_str(), Argument::Texts(vec![inertia::input(name)])));
        said(key(self.kind), swing.chain(numbers).chain(names))
    }
}

/// The key of a warning's sentence: its kind as JSON has it.
fn key(kind: WarningKind) -> &'static str {
    match kind {
        WarningKind::YawNearInPhase => "yaw_near_in_phase",
        WarningKind::NoBeat => "no_beat",
        WarningKind::SlackLine => "slack_line",
        WarningKind::TiltNeeded => "tilt_needed",
        WarningKind::SpacingTooShort => "spacing_too_short",
        WarningKind::NotReached => "not_reached",
        WarningKind::NotDetermined => "not_determined",
        WarningKind::RoughHull => "rough_hull",
    }
}

/// The sentence of a key in a language, those of `inertia` among them; absent where the key is
/// another room's, or unknown.
pub(crate) fn sentence(key: &str, language: Language) -> Option<String> {
    let Some(key) = key.strip_prefix(OF_PLAN) else {
        return inertia::sentence(key, language);
    };
    entry(table(language), key)
}

/// Every sentence by its key in a language.
pub fn sentences(language: Language) -> Vec<(String, String)> {
    let named = |(key, text): &(&str, &str)| (format!("{OF_PLAN}{key}"), (*text).to_owned());
    table(language).iter().map(named).collect()
}

fn table(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
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
