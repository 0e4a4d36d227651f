//! Words of the report, beside those of the result.

use gyradius_base::language::Language;
pub(super) use gyradius_base::message::spaced;
use gyradius_diagnosis::{CauseId, ForceCoordinate, ParameterId, Unit, UnitName, cause_name};
use gyradius_recording::RepairKind;

pub(super) use gyradius_identification::words::{
    claim_name, claim_unit, mode_text, quantity, quantity_name, rank, route, unit_of,
};

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
        RepairKind::LostByRecorder => "parts lost by the recorder",
        RepairKind::SecondSwing => "a second swing, left out",
    }
}

/// A cause of what the simulation gets wrong, in words.
pub(super) fn cause(id: CauseId) -> String {
    cause_name(id, Language::English)
}

/// A generalised force along a coordinate, in words.
pub(super) fn force(coordinate: ForceCoordinate) -> &'static str {
    match coordinate {
        ForceCoordinate::Yaw => "torque about the vertical",
        ForceCoordinate::Pitch
        | ForceCoordinate::PitchInPhase
        | ForceCoordinate::PitchOutOfPhase
        | ForceCoordinate::Roll
        | ForceCoordinate::RollInPhase
        | ForceCoordinate::RollOutOfPhase => "torque in pitch or roll",
        ForceCoordinate::All
        | ForceCoordinate::Compound
        | ForceCoordinate::Other
        | ForceCoordinate::Surge
        | ForceCoordinate::Sway => "force",
    }
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
