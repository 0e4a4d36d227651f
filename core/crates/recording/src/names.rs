//! The names of suspensions, orientations and motions in files.

use super::samples::{RepairKind, Sensor};
use super::session::{Excitation, InstrumentKind, ModeName, Orientation, SuspensionKind};

pub(crate) const KINDS: &[(&str, SuspensionKind)] = &[
    ("bifilar", SuspensionKind::Bifilar),
    ("compound", SuspensionKind::Compound),
    ("trifilar", SuspensionKind::Trifilar),
    ("free", SuspensionKind::Free),
];
pub(crate) const INSTRUMENTS: &[(&str, InstrumentKind)] = &[
    ("tape", InstrumentKind::Tape),
    ("clock", InstrumentKind::Clock),
    ("protractor", InstrumentKind::Protractor),
    ("scale", InstrumentKind::Scale),
];
pub(crate) const ORIENTATIONS: &[(&str, Orientation)] = &[
    ("athwartships", Orientation::Athwartships),
    ("fore_and_aft", Orientation::ForeAndAft),
];
pub(crate) const EXCITATIONS: &[(&str, Excitation)] = &[
    ("yaw", Excitation::Yaw),
    ("sway", Excitation::Sway),
    ("surge", Excitation::Surge),
    ("pitch", Excitation::Pitch),
    ("roll", Excitation::Roll),
];
pub(crate) const MODES: &[(&str, ModeName)] = &[
    ("yaw", ModeName::Yaw),
    ("sway", ModeName::Sway),
    ("pitch_in_phase", ModeName::PitchInPhase),
    ("pitch_out_of_phase", ModeName::PitchOutOfPhase),
    ("roll_in_phase", ModeName::RollInPhase),
    ("roll_out_of_phase", ModeName::RollOutOfPhase),
    ("compound", ModeName::Compound),
    ("other", ModeName::Other),
];
pub(crate) const SENSORS: &[(&str, Sensor)] = &[
    ("gyroscope", Sensor::Gyroscope),
    ("accelerometer", Sensor::Accelerometer),
    ("linear_accelerometer", Sensor::LinearAccelerometer),
    ("displacement", Sensor::Displacement),
    ("timer", Sensor::Timer),
];
pub(crate) const REPAIR_KINDS: &[(&str, RepairKind)] = &[
    ("jitter", RepairKind::Jitter),
    ("repeated_stamp", RepairKind::RepeatedStamp),
    ("backward_stamp", RepairKind::BackwardStamp),
    ("missing_rows", RepairKind::MissingRows),
    ("stall", RepairKind::Stall),
    ("not_a_number", RepairKind::NotANumber),
    ("saturation", RepairKind::Saturation),
    ("pause", RepairKind::Pause),
    ("lost_by_recorder", RepairKind::LostByRecorder),
    ("second_swing", RepairKind::SecondSwing),
    ("shared_stamps", RepairKind::SharedStamps),
    ("stamp_step", RepairKind::StampStep),
    ("other_clock", RepairKind::OtherClock),
    ("not_imported", RepairKind::NotImported),
    ("no_reading", RepairKind::NoReading),
];

impl Excitation {
    /// As files and texts call it.
    pub fn name(self) -> &'static str {
        name_of(self, EXCITATIONS)
    }
}

impl SuspensionKind {
    /// As files call it.
    pub fn name(self) -> &'static str {
        name_of(self, KINDS)
    }

    /// The kind that files call so.
    pub fn named(name: &str) -> Option<Self> {
        of_name(name, KINDS)
    }

    /// All names, for messages.
    pub fn names() -> String {
        listed(KINDS)
    }
}

impl Orientation {
    /// As files call it.
    pub fn name(self) -> &'static str {
        name_of(self, ORIENTATIONS)
    }

    /// The orientation that files call so.
    pub fn named(name: &str) -> Option<Self> {
        of_name(name, ORIENTATIONS)
    }

    /// All names, for messages.
    pub fn names() -> String {
        listed(ORIENTATIONS)
    }
}

impl ModeName {
    /// As files call it.
    pub fn name(self) -> &'static str {
        name_of(self, MODES)
    }
}

/// Every variant stands in its list of names, which the round-trip test holds.
pub(crate) fn name_of<T: PartialEq>(value: T, names: &[(&'static str, T)]) -> &'static str {
    names
        .iter()
        .find(|(_, named)| *named == value)
        .map_or("", |(name, _)| name)
}

fn of_name<T: Copy>(name: &str, names: &[(&'static str, T)]) -> Option<T> {
    let mut known = names.iter().filter(|(known, _)| *known == name);
    known.next().map(|(_, value)| *value)
}

/// `a, b or c`.
fn listed<T>(names: &[(&'static str, T)]) -> String {
    let names: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => names.concat(),
    }
}
