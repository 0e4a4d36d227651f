//! Words of the report, beside those of the result.

use crate::recording::RepairKind;

pub(super) use crate::inertia::words::{
    claim_name, claim_unit, mode_text, quantity, quantity_name, rank, route, spaced, unit_of,
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
        RepairKind::SecondSwing => "a second swing, left out",
    }
}

/// First letter large; a symbol such as `k_yaw_m` stays as it is.
pub(super) fn sentence_case(text: &str) -> String {
    if text.split(' ').next().is_some_and(|word| word.contains('_')) {
        return text.into();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
