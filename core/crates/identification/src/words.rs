//! Words for the names that the result's format uses.

use gyradius_base::language::Language;
use gyradius_base::message::{name, spaced};
use gyradius_recording::ModeName;

/// How a quantity is called and printed.
pub struct QuantityWords {
    /// In words.
    pub name: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
}

/// Scalar quantities in the order of the report.
const QUANTITIES: [(&str, QuantityWords); 5] = [
    (
        "k_yaw_m",
        QuantityWords {
            name: "Yaw gyradius",
            symbol: "k_yaw",
        },
    ),
    (
        "k_pitch_m",
        QuantityWords {
            name: "Pitch gyradius",
            symbol: "k_pitch",
        },
    ),
    (
        "k_roll_m",
        QuantityWords {
            name: "Roll gyradius",
            symbol: "k_roll",
        },
    ),
    (
        "cm_depth_m",
        QuantityWords {
            name: "Depth of the centre of mass",
            symbol: "l₂",
        },
    ),
    (
        "psi_deg",
        QuantityWords {
            name: "Tilt of the principal axis",
            symbol: "ψ",
        },
    ),
];

/// Words for a quantity.
pub fn quantity(key: &str) -> Option<&'static QuantityWords> {
    QUANTITIES
        .iter()
        .find(|(name, _)| *name == key)
        .map(|(_, words)| words)
}

/// A quantity's name in words, its key where it has none.
pub fn quantity_name(key: &str) -> String {
    match (quantity(key), key) {
        (Some(words), _) => words.name.into(),
        (None, "principal_gyradii_m") => "Principal gyradii".into(),
        (None, "inertia_kg_m2") => "Moments of inertia".into(),
        (None, other) => spaced(other),
    }
}

/// Units by the ending of a key; what ends another stands after it.
const ENDINGS: [(&str, &str); 6] = [
    ("_kg_m2", "kg m²"),
    ("_m_s2", "m/s²"),
    ("_deg", "°"),
    ("_kg", "kg"),
    ("_m", "m"),
    ("_s", "s"),
];

/// A quantity's unit, as its key tells it.
pub fn unit_of(key: &str) -> &'static str {
    ENDINGS
        .iter()
        .find(|(ending, _)| key.ends_with(ending))
        .map_or("", |(_, unit)| unit)
}

/// Place of a quantity in the report.
pub fn rank(key: &str) -> usize {
    QUANTITIES
        .iter()
        .position(|(name, _)| *name == key)
        .unwrap_or(QUANTITIES.len())
}

/// A stated figure or a route's quantity as the court names it.
pub fn claim_name(claim: &str) -> String {
    match quantity(claim) {
        Some(words) => words.name.into(),
        None => spaced(claim),
    }
}

/// Unit of a stated figure or a route's quantity.
pub fn claim_unit(claim: &str) -> &'static str {
    match claim {
        "line_length" | "spacing" | "top_spacing" | "axis_height" => "m",
        "gravity" => "m/s²",
        "hull_pitch" => "°",
        other => unit_of(other),
    }
}

/// A mode's name in words.
pub fn mode_text(mode: ModeName) -> &'static str {
    match mode {
        ModeName::Yaw => "yaw",
        ModeName::Sway => "sway",
        ModeName::PitchInPhase => "pitch in phase",
        ModeName::PitchOutOfPhase => "pitch out of phase",
        ModeName::RollInPhase => "roll in phase",
        ModeName::RollOutOfPhase => "roll out of phase",
        ModeName::Compound => "compound pendulum",
        ModeName::Other => "unnamed motion",
    }
}

/// A single route to a quantity, in words.
pub fn route(method: &str) -> String {
    route_in(method, Language::English)
}

/// The same in a language.
pub fn route_in(method: &str, language: Language) -> String {
    name(&format!("inertia.route.{method}"), language).unwrap_or_else(|| spaced(method))
}

/// A quantity in words in a language, without its unit.
pub fn quantity_in(key: &str, language: Language) -> String {
    let bare = ENDINGS
        .iter()
        .find_map(|(ending, _)| key.strip_suffix(ending))
        .unwrap_or(key);
    match quantity(key) {
        Some(_) => name(&format!("inertia.quantity.{key}"), language),
        None => None,
    }
    .unwrap_or_else(|| spaced(bare))
}

/// Name of a period in budgets.
pub fn period_label(mode: ModeName, swing: &str) -> String {
    format!("{} period of {swing}", mode_text(mode))
}
