//! Words of the report, beside those of the result.

use gyradius_base::language::Language;
use gyradius_base::message::{Argument, Message, name};
pub(super) use gyradius_base::message::{id_in, spaced};
use gyradius_diagnosis::{DiscrepancyKind, ForceCoordinate, ParameterId, Unit, UnitName};
use gyradius_identification::{
    Claim, QuantityName, Route, RouteMethod, Subject, quantity_in, route_in, words,
};
use gyradius_recording::{ModeName, Repair, RepairKind};

pub(super) use gyradius_diagnosis::cause_name as cause;
pub(super) use gyradius_identification::words::{mode_text as mode_id, rank, symbol};

/// A text of the report in a language, with what it names.
pub(super) fn say<'a>(
    language: Language,
    key: &str,
    named: impl IntoIterator<Item = (&'a str, Argument)>,
) -> String {
    Message::new(format!("report.{key}"), named).in_language(language)
}

/// A figure, with its unit or without, as an argument.
pub(super) fn figure(written: impl Into<String>) -> Argument {
    Argument::Figure(written.into())
}

/// Text as it stands, as an argument.
pub(super) fn plain(text: impl Into<String>) -> Argument {
    Argument::Plain(text.into())
}

/// Ids of swings, in a row.
pub(super) fn ids<'a>(ids: impl IntoIterator<Item = &'a String>, language: Language) -> String {
    let told: Vec<String> = ids.into_iter().map(|id| id_in(id, language)).collect();
    told.join(", ")
}

/// A quantity's name in words.
pub(super) fn quantity_name(quantity: &QuantityName, language: Language) -> String {
    match (quantity, language) {
        (_, Language::English) => words::quantity_name(quantity),
        (QuantityName::PrincipalGyradii, _) => say(language, "principal_gyradii", []),
        (QuantityName::Inertia, _) => say(language, "moments_of_inertia", []),
        _ => quantity_in(quantity.as_str(), language),
    }
}

/// A quantity's name within a sentence.
pub(super) fn quantity_inside(quantity: &QuantityName, language: Language) -> String {
    let name = quantity_name(quantity, language);
    match language {
        Language::English => name.to_lowercase(),
        Language::German => name,
    }
}

/// A stated figure or a route's quantity as the consistency tests name it.
pub(super) fn claim_name(subject: &Subject, language: Language) -> String {
    match (subject, language) {
        (_, Language::English) => words::claim_name(subject),
        (Subject::Quantity(quantity), _) => quantity_name(quantity, language),
        (Subject::Stated(kind), _) => kind.in_words().in_language(language),
    }
}

/// What implies the other figure of a claim.
pub(super) fn claim_from(claim: &Claim, language: Language) -> String {
    if language == Language::English {
        return claim.from.clone();
    }
    // The sentence of the claim names it, in the case that the sentence asks for.
    let named = &claim.message.arguments;
    let by = match named.get("by") {
        Some(Argument::Texts(by)) => by.first(),
        _ => None,
    };
    let key = match by.map(|by| &*by.key) {
        Some("inertia.by_sway") => "from_sway",
        Some("inertia.by_all") => "from_all",
        _ if named.contains_key("other") => "from_route",
        _ => return claim.from.clone(),
    };
    let arguments = by.map_or(named, |by| &by.arguments);
    let named = arguments
        .iter()
        .map(|(name, value)| (&**name, value.clone()));
    say(language, key, named)
}

/// A mode's name in words.
pub(super) fn mode_text(mode: ModeName, language: Language) -> String {
    let english = words::mode_text(mode);
    name(&format!("inertia.motion.{english}"), language).unwrap_or_else(|| english.into())
}

/// A route in words.
pub(super) fn route(method: RouteMethod, language: Language) -> String {
    route_in(method.name(), language)
}

/// The equations that a route takes.
pub(super) fn equation(route: &Route, language: Language) -> String {
    match route.method {
        RouteMethod::TiltFit => say(language, "equation_of_tilt_fit", []),
        _ => route.equation.clone(),
    }
}

/// What was wrong with a recording.
pub(super) fn repair(kind: RepairKind, language: Language) -> String {
    let key = match kind {
        RepairKind::Jitter => "uneven_stamps",
        RepairKind::RepeatedStamp => "repeated_stamps",
        RepairKind::BackwardStamp => "backward_stamps",
        RepairKind::MissingRows => "missing_rows",
        RepairKind::Stall => "stood_still",
        RepairKind::NotANumber => "not_numbers",
        RepairKind::Saturation => "at_the_limit",
        RepairKind::Pause => "pause_put_back",
        RepairKind::LostByRecorder => "lost_by_recorder",
        RepairKind::SecondSwing => "second_swing_left_out",
        RepairKind::SharedStamps => "shared_stamps",
        RepairKind::StampStep => "stamp_step",
        RepairKind::OtherClock => "other_clock",
        RepairKind::NotImported => "not_imported",
        RepairKind::NoReading => "no_reading",
    };
    say(language, key, [])
}

/// What was found in a recording and what was done; where there is no more of it than English, the
/// sensor and the times.
pub(super) fn repair_text(repair: &Repair, language: Language) -> String {
    if language == Language::English {
        return repair.text.clone();
    }
    let sensor = name(repair.sensor.name(), language);
    let named = [
        ("sensor", plain(sensor.unwrap_or_default())),
        ("from", Argument::Number(repair.first_s, 2)),
        ("to", Argument::Number(repair.last_s, 2)),
    ];
    say(language, "repair_place", named)
}

/// What kind of thing the simulation gets wrong, in words.
pub(super) fn discrepancy(kind: DiscrepancyKind, language: Language) -> String {
    let key = match kind {
        DiscrepancyKind::AcrossTheAxis => "across_the_axis",
        DiscrepancyKind::BetweenSwings => "between_swings",
        DiscrepancyKind::DecayVsAmplitude => "decay_against_amplitude",
        DiscrepancyKind::Dimension => "dimension",
        DiscrepancyKind::LineInSpectrum => "line_in_spectrum",
        DiscrepancyKind::PeriodVsAmplitude => "period_against_amplitude",
        DiscrepancyKind::ResidualVsPhase => "residual_against_phase",
        DiscrepancyKind::ResidualVsTime => "residual_against_time",
        DiscrepancyKind::Saturated => "saturated",
        DiscrepancyKind::Structure => "structure",
    };
    say(language, key, [])
}

/// A parameter of a cause in words, without its unit.
pub(super) fn parameter(id: ParameterId, unit: Unit, language: Language) -> String {
    let bare = without_unit(id, unit);
    name(&format!("critique.number.{bare}"), language).unwrap_or_else(|| spaced(&bare))
}

/// A generalised force along a coordinate, in words.
pub(super) fn force(coordinate: ForceCoordinate, language: Language) -> String {
    let key = match coordinate {
        ForceCoordinate::Yaw => "torque_about_vertical",
        ForceCoordinate::Pitch
        | ForceCoordinate::PitchInPhase
        | ForceCoordinate::PitchOutOfPhase
        | ForceCoordinate::Roll
        | ForceCoordinate::RollInPhase
        | ForceCoordinate::RollOutOfPhase => "torque_of_turn",
        ForceCoordinate::Surge => "force_along",
        ForceCoordinate::Sway => "force_across",
        ForceCoordinate::All | ForceCoordinate::Compound | ForceCoordinate::Other => "some_force",
    };
    say(language, key, [])
}

/// `N m s^2` as it is printed: `N m s²`; the unit of a bare number is not.
pub(super) fn unit_text(unit: Unit) -> String {
    match unit {
        Unit::Of(UnitName::One) => String::new(),
        unit => with_powers(&unit.to_string()),
    }
}

fn with_powers(unit: &str) -> String {
    let mut parts = unit.split('^');
    let first = parts.next().unwrap_or_default().to_string();
    parts.fold(first, |text, part| {
        let end = part
            .find(|c: char| !matches!(c, '-' | '0'..='9'))
            .unwrap_or(part.len());
        text + &part[..end].chars().map(raised).collect::<String>() + &part[end..]
    })
}

/// A name less the unit that it ends in: `yaw_n_m_s` in `N m s` is `yaw`.
pub(super) fn without_unit(id: ParameterId, unit: Unit) -> String {
    match (id.swing, unit) {
        (None, Unit::Of(unit)) => id.name.without(unit).into(),
        _ => id.to_string(),
    }
}

/// A digit or a minus set high.
pub(super) fn raised(character: char) -> char {
    match character {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit
            .to_digit(10)
            .and_then(|n| char::from_u32(0x2070 + n))
            .unwrap_or(digit),
    }
}

/// First letter large; a symbol such as `k_yaw_m` stays as it is.
pub(super) fn sentence_case(text: &str) -> String {
    if text
        .split(' ')
        .next()
        .is_some_and(|word| word.contains('_'))
    {
        return text.into();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_set_high() {
        let written = [
            "m/s^2",
            "N m s^2",
            "rad s^-1",
            "kg m^2/rad",
            "N^2 m^-10 s",
            "1",
            "",
        ]
        .map(with_powers);
        assert_eq!(
            written,
            [
                "m/s²",
                "N m s²",
                "rad s⁻¹",
                "kg m²/rad",
                "N² m⁻¹⁰ s",
                "1",
                ""
            ]
        );
    }

    #[test]
    fn a_unit_is_not_said_twice() {
        let told = |id: &str, unit: &str| without_unit(id.parse().unwrap(), unit.parse().unwrap());
        assert_eq!(told("yaw_n_m_s", "N m s"), "yaw");
        assert_eq!(told("yaw_kg_m2_rad", "kg m^2/rad"), "yaw");
        assert_eq!(told("speed_m_s", "m/s"), "speed");
        assert_eq!(
            told("yaw_torque_coefficient", "N m s^2"),
            "yaw_torque_coefficient"
        );
        assert_eq!(told("exponent", "1"), "exponent");
        assert_eq!(told("start_kg_m_2", "kg m"), "start_kg_m_2");
        assert_eq!(unit_text("1".parse().unwrap()), "");
    }
}
