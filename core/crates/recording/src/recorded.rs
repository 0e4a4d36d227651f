//! What is known of how a recording came about: the clock, the phone, the marks, what was lost, and
//! what an import left out.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::samples::{Repair, RepairKind, Sensor};

/// Where a recording came from, as `[[recorded]]` of the session.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Recorded {
    /// The recording: file name in the session.
    pub file: String,
    /// Stamp of t = 0, ns of the phone's clock; 0 where it is not known.
    pub origin_ns: i64,
    /// When it was recorded, as the file says; empty where it does not.
    #[serde(default)]
    pub measured_on: String,
    /// Model of the phone; empty where it is not known.
    pub phone: String,
    /// Program that recorded; empty where it is not known.
    #[serde(default)]
    pub logger: String,
    /// The phone's own estimate of the gyroscope's bias, not taken off: file name in the session,
    /// `t,gx,gy,gz`.
    pub bias: Option<String>,
    /// The phone's sensors.
    pub sensors: Vec<RecordedSensor>,
    /// Anything else, by key.
    pub notes: BTreeMap<String, String>,
    /// Marks, in file order.
    pub events: Vec<RecordedEvent>,
    /// What the recorder's file had lost, or the import left out.
    pub repairs: Vec<RecordedRepair>,
}

/// One sensor as the phone describes it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct RecordedSensor {
    /// The stream that it filled, e.g. `gyroscope`.
    pub stream: String,
    /// The phone's name for it.
    pub name: String,
    /// Its full scale, rad/s or m/s², where the phone tells.
    pub full_scale: Option<f64>,
}

/// Key of the mark at which the swing was disturbed.
pub const DISTURBED: &str = "disturbed";

/// A mark.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct RecordedEvent {
    /// When, s of the recording.
    pub t_s: f64,
    /// What it marks.
    pub key: String,
}

/// Something that the recorder's file had lost, or that an import left out.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct RecordedRepair {
    /// Last sample before it, s of the recording.
    pub from_s: Option<f64>,
    /// First sample after it, s.
    pub to_s: Option<f64>,
    /// What was found and what was done.
    pub text: String,
    /// Kind; absent where the recorder lost it.
    pub kind: Option<RepairKind>,
    /// Sensor, where it is one sensor's.
    pub sensor: Option<Sensor>,
    /// How many samples or gaps, where they were counted.
    pub count: Option<usize>,
}

impl From<&Repair> for RecordedRepair {
    fn from(repair: &Repair) -> Self {
        Self {
            from_s: Some(repair.first_s),
            to_s: Some(repair.last_s),
            text: repair.text.clone(),
            kind: Some(repair.kind),
            sensor: Some(repair.sensor),
            count: Some(repair.count),
        }
    }
}

impl Recorded {
    /// Whether anything is known beside the name of the file.
    pub fn says_anything(&self) -> bool {
        *self
            != Self {
                file: self.file.clone(),
                ..Self::default()
            }
    }

    /// When the swing was disturbed, s of the recording.
    pub(super) fn disturbed_s(&self) -> impl Iterator<Item = f64> {
        self.events
            .iter()
            .filter(|event| event.key == DISTURBED)
            .map(|event| event.t_s)
    }

    /// What was lost or left out, as repairs of the recording; what the recorder lost may be of
    /// either sensor.
    pub(super) fn as_repairs(&self) -> Vec<Repair> {
        let repair = |repair: &RecordedRepair| {
            let first_s = repair.from_s.or(repair.to_s).unwrap_or_default();
            Repair {
                kind: repair.kind.unwrap_or(RepairKind::LostByRecorder),
                sensor: repair.sensor.unwrap_or(Sensor::Gyroscope),
                count: repair.count.unwrap_or(1),
                first_s,
                last_s: repair.to_s.unwrap_or(first_s),
                text: repair.text.clone(),
            }
        };
        self.repairs.iter().map(repair).collect()
    }
}
