//! Words for the names that the result's format uses.

use gyradius_base::language::Language;
use gyradius_base::message::{name, spaced};
use gyradius_recording::ModeName;

use super::names::{QuantityName, RouteMethod, Subject};

/// A quantity's symbol; none of what is no number of the hull.
pub fn symbol(quantity: &QuantityName) -> Option<&'static str> {
    match quantity {
        QuantityName::KYaw => Some("k_yaw"),
        QuantityName::KPitch => Some("k_pitch"),
        QuantityName::KRoll => Some("k_roll"),
        QuantityName::CmDepth => Some("l₂"),
        QuantityName::Psi => Some("ψ"),
        QuantityName::InertiaYaw => Some("I_yaw"),
        QuantityName::InertiaPitch => Some("I_pitch"),
        QuantityName::InertiaRoll => Some("I_roll"),
        QuantityName::PrincipalGyradii | QuantityName::Inertia | QuantityName::SmallPeriod(_) => {
            None
        }
    }
}

/// A quantity's name in words.
pub fn quantity_name(quantity: &QuantityName) -> String {
    match quantity {
        QuantityName::PrincipalGyradii => "Principal gyradii".into(),
        QuantityName::Inertia => "Moments of inertia".into(),
        QuantityName::SmallPeriod(_) => spaced(quantity.as_str()),
        scalar => quantity_in(scalar.as_str(), Language::English),
    }
}

/// Units by the ending of a name; what ends another stands after it.
const ENDINGS: [(&str, &str); 6] = [
    ("_kg_m2", "kg m²"),
    ("_m_s2", "m/s²"),
    ("_deg", "°"),
    ("_kg", "kg"),
    ("_m", "m"),
    ("_s", "s"),
];

/// The unit that a name of a file tells, as it is printed.
pub fn unit_of(name: &str) -> &'static str {
    ENDINGS
        .iter()
        .find(|(ending, _)| name.ends_with(ending))
        .map_or("", |(_, unit)| unit)
}

/// Place of a quantity in the report.
pub fn rank(quantity: &QuantityName) -> usize {
    let place = QuantityName::SCALARS.iter().position(|q| q == quantity);
    place.unwrap_or(QuantityName::SCALARS.len())
}

/// A stated figure or a route's quantity in words.
pub fn claim_name(subject: &Subject) -> String {
    match subject {
        Subject::Stated(kind) => spaced(kind.name()),
        Subject::Quantity(name) => quantity_name(name),
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
pub fn route(method: RouteMethod) -> String {
    route_in(method.name(), Language::English)
}

/// The same in a language, by its name in files.
pub fn route_in(method: &str, language: Language) -> String {
    name(&format!("inertia.route.{method}"), language).unwrap_or_else(|| spaced(method))
}

/// A quantity in words in a language, without its unit, by its name in files.
pub fn quantity_in(key: &str, language: Language) -> String {
    let scalar = key.parse::<QuantityName>().ok();
    let known = scalar.and_then(|quantity| symbol(&quantity));
    let known = known.and_then(|_| name(&format!("inertia.quantity.{key}"), language));
    let bare = ENDINGS
        .iter()
        .find_map(|(ending, _)| key.strip_suffix(ending))
        .unwrap_or(key);
    known.unwrap_or_else(|| spaced(bare))
}
