//! What an import yields.

use std::collections::BTreeMap;

use super::source::stem;
use crate::samples::{GateEvents, Recording, Track};

/// Which program wrote a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Format {
    /// The project's own recording.
    Native,
    /// phyphox.
    Phyphox,
    /// Sensor Logger.
    SensorLogger,
    /// Physics Toolbox.
    PhysicsToolbox,
    /// SensorLog for iOS.
    SensorLog,
    /// A two-gate timer's event log.
    LightGate,
    /// Columns named by the caller.
    Mapped,
}

/// What an import yields.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// Recordings, in the order of the inputs.
    pub recordings: Vec<ImportedRecording>,
    /// What the files say of the phone.
    pub device: BTreeMap<String, String>,
    /// Format of the first recording.
    pub source: Format,
}

/// One recording of an import.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedRecording {
    /// Name of its file or archive without the ending.
    pub name: String,
    /// Format it came in.
    pub format: Format,
    /// The data.
    pub data: ImportedData,
    /// What a reader should know: choices made, files not used.
    pub notes: Vec<String>,
}

/// The kinds of data an import can yield.
#[derive(Debug, Clone, PartialEq)]
// There are as many as files: boxing the largest would buy nothing.
#[allow(clippy::large_enum_variant)]
pub enum ImportedData {
    /// A phone's recording.
    Recording(Recording),
    /// A rangefinder's track.
    Track(Track),
    /// A light gate's edges.
    GateEvents(GateEvents),
}

impl ImportedRecording {
    pub(super) fn new(
        file: &str,
        format: Format,
        recording: Recording,
        notes: Vec<String>,
    ) -> Self {
        let data = ImportedData::Recording(recording);
        Self {
            name: stem(file).to_owned(),
            format,
            data,
            notes,
        }
    }
}
