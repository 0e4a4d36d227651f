//! One thing that the operator is to do, as plain data: made by the planner, followed by the
//! procedure.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use gyradius_recording::{AddedMass, End, Excitation, ModeName, Suspension};

/// One thing to do, in the order of the plan.
// A plan has a handful of steps and mostly of the large kind: a box would buy nothing.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    /// Hang it so, set it going, record.
    Swing(PlannedSwing),
    /// Hang a weight from an end, read the tilt.
    Incline(PlannedIncline),
}

/// A swing to be made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PlannedSwing {
    /// Unique id, that of the swing in the session to come.
    pub id: String,
    /// How to hang it; dimensions with the uncertainty they are to be measured to.
    pub suspension: Suspension,
    /// Masses to fix to the hull for this swing.
    pub added_masses: Vec<AddedMass>,
    /// What to set going.
    pub excited: Vec<Excitation>,
    /// Angle of the release of the turning that is excited, or of the lines where none is, degrees.
    pub amplitude_deg: f64,
    /// Length of the recording, s.
    pub duration_s: f64,
    /// Periods to expect, s.
    pub periods_s: BTreeMap<ModeName, f64>,
    /// Standard uncertainty of the period, as a part of it, that is enough for what is wanted.
    pub period_u_wanted: f64,
}

/// An incline test to be made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PlannedIncline {
    /// The end that the weight hangs from.
    pub end: End,
    /// The weight, kg.
    pub mass_kg: f64,
    /// Horizontal distance from the suspension points to the weight's, m.
    pub arm_m: f64,
    /// Depth of the weight's suspension point below the hull's, m.
    pub depth_m: f64,
    /// Tilt to expect, bow up positive, degrees.
    pub pitch_deg: f64,
}
