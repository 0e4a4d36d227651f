//! Words for the names that the result's format uses.

use crate::recording::RepairKind;

/// How a quantity is called and printed.
pub(super) struct QuantityWords {
    /// In words.
    pub name: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
}

/// Scalar quantities in the order of the report.
const QUANTITIES: [(&str, QuantityWords); 5] = [
    ("k_yaw_m", QuantityWords { name: "Yaw gyradius", symbol: "k_yaw" }),
    ("k_pitch_m", QuantityWords { name: "Pitch gyradius", symbol: "k_pitch" }),
    ("k_roll_m", QuantityWords { name: "Roll gyradius", symbol: "k_roll" }),
    ("cm_depth_m", QuantityWords { name: "Depth of the centre of mass", symbol: "l₂" }),
    ("psi_deg", QuantityWords { name: "Tilt of the principal axis", symbol: "ψ" }),
];

/// Words for a quantity.
pub(super) fn quantity(key: &str) -> Option<&'static QuantityWords> {
    QUANTITIES.iter().find(|(name, _)| *name == key).map(|(_, words)| words)
}

/// A quantity's name in words, its key where it has none.
pub(super) fn quantity_name(key: &str) -> String {
    match (quantity(key), key) {
        (Some(words), _) => words.name.into(),
        (None, "principal_gyradii_m") => "Principal gyradii".into(),
        (None, "inertia_kg_m2") => "Moments of inertia".into(),
        (None, other) => spaced(other),
    }
}

/// A quantity's unit, as its key tells it.
pub(super) fn unit_of(key: &str) -> &'static str {
    const ENDINGS: [(&str, &str); 5] =
        [("_kg_m2", "kg m²"), ("_m_s2", "m/s²"), ("_deg", "°"), ("_kg", "kg"), ("_m", "m")];
    ENDINGS.iter().find(|(ending, _)| key.ends_with(ending)).map_or("", |(_, unit)| unit)
}

/// Place of a quantity in the report.
pub(super) fn rank(key: &str) -> usize {
    QUANTITIES.iter().position(|(name, _)| *name == key).unwrap_or(QUANTITIES.len())
}

/// A stated figure or a route's quantity as the court names it.
pub(super) fn claim_name(claim: &str) -> String {
    match quantity(claim) {
        Some(words) => words.name.into(),
        None => sentence_case(&spaced(claim)),
    }
}

/// Unit of a stated figure or a route's quantity.
pub(super) fn claim_unit(claim: &str) -> &'static str {
    match claim {
        "line_length" | "spacing" | "top_spacing" | "axis_height" => "m",
        "gravity" => "m/s²",
        "hull_pitch" => "°",
        other => unit_of(other),
    }
}

/// What was wrong with a recording.
pub(super) fn repair(kind: RepairKind) -> &'static str {
    match kind {
        RepairKind::Jitter => "uneven time stamps",
        RepairKind::RepeatedStamp => "repeated time stamps",
        RepairKind::BackwardStamp => "time stamps stepping back",
        RepairKind::MissingRows => "missing rows",
        RepairKind::Stall => "the record stood still",
        RepairKind::NotANumber => "cells that are not numbers",
        RepairKind::Saturation => "samples at the sensor's limit",
        RepairKind::Pause => "a pause, put back",
        RepairKind::SecondSwing => "a second swing, left out",
    }
}

/// A single route to a quantity, in words.
pub(super) fn route(method: &str) -> String {
    let known = match method {
        "yaw_period" => "yaw period with line length and spacing",
        "period_ratio" => "yaw period over sway period, times half the spacing",
        "beat_count" => "oscillations per beat of yaw and sway",
        "double_pendulum" => "both periods of the double pendulum, sway period as clock",
        "double_pendulum_and_line_length" => "both periods of the double pendulum, with the line length",
        "compound" | "compound_pendulum" => "compound pendulum",
        "lamboley" => "compound pendulum at two heights (Lamboley)",
        "incline" => "inclining by a weight",
        "tilted_yaw" => "yaw with the hull tilted",
        "joint_estimate" => "joint estimate from everything in the session",
        other => return spaced(other),
    };
    known.into()
}

/// A key of the format as words.
pub(super) fn spaced(key: &str) -> String {
    key.replace('_', " ")
}

/// First letter large; a symbol such as `k_yaw_m` stays as it is.
pub(super) fn sentence_case(text: &str) -> String {
    if text.split(' ').next().is_some_and(|word| word.contains('_')) {
        return text.into();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
