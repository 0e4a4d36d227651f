//! Words of the report, beside those of the result.

use gyradius_base::language::Language;
pub(super) use gyradius_base::message::spaced;
use gyradius_diagnosis::cause_name;
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
pub(super) fn cause(id: &str) -> String {
    cause_name(id, Language::English)
}

/// A generalised force along a coordinate, in words.
pub(super) fn force(coordinate: &str) -> &'static str {
    match coordinate {
        "yaw" => "torque about the vertical",
        "turn" => "torque in pitch or roll",
        "across" => "force across the suspension",
        "along" => "force along the suspension",
        _ => "force",
    }
}

/// `N m s^2` as it is printed: `N m s²`; the unit of a bare number is not.
pub(super) fn unit_text(unit: &str) -> String {
    if unit == "1" {
        return String::new();
    }
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
pub(super) fn without_unit<'a>(name: &'a str, unit: &str) -> &'a str {
    let ending = unit
        .to_lowercase()
        .replace('^', "")
        .replace([' ', '/'], "_");
    name.strip_suffix(&format!("_{ending}")).unwrap_or(name)
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
        .map(unit_text);
        assert_eq!(
            written,
            [
                "m/s²",
                "N m s²",
                "rad s⁻¹",
                "kg m²/rad",
                "N² m⁻¹⁰ s",
                "",
                ""
            ]
        );
    }

    #[test]
    fn a_unit_is_not_said_twice() {
        assert_eq!(without_unit("yaw_n_m_s", "N m s"), "yaw");
        assert_eq!(without_unit("yaw_kg_m2_rad", "kg m^2/rad"), "yaw");
        assert_eq!(without_unit("steady_x_m_s", "m/s"), "steady_x");
        assert_eq!(
            without_unit("yaw_torque_coefficient", "N m s^2"),
            "yaw_torque_coefficient"
        );
        assert_eq!(without_unit("exponent", "1"), "exponent");
    }
}
