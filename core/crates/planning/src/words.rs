//! Messages of the plan.

use super::warnings::{Warning, WarningKind};
use gyradius_base::message::{Argument, Message};

/// A message of the plan with what it names.
pub fn message<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Message {
    Message::new(format!("plan.{key}"), arguments)
}

impl Warning {
    /// Its sentence.
    pub fn message(&self) -> Message {
        let swing = self
            .swing
            .iter()
            .map(|id| ("swing", Argument::Id(id.clone())));
        let numbers = self
            .numbers
            .iter()
            .map(|(n, value)| (n.as_str(), Argument::Figure(shown(n, *value))));
        let names = self.names.iter().map(|(n, name)| {
            (
                n.as_str(),
                Argument::Texts(vec![gyradius_identification::input(name)]),
            )
        });
        message(key(self.kind), swing.chain(numbers).chain(names))
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
