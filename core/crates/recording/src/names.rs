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
}

impl Orientation {
    /// As files call it.
    pub fn name(self) -> &'static str {
        name_of(self, ORIENTATIONS)
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
