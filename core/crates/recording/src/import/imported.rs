//! What an import yields.

use std::collections::BTreeMap;

use super::facts::Facts;
use super::source::stem;
use crate::recorded::{Recorded, RecordedRepair};
use crate::samples::{
    GateEvents, PeriodList, Recording, Repair, RepairKind, SensorChannels, SingleChannel, Track,
};

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
    /// Gyroflow's IMU log.
    Gcsv,
    /// Columns named by the caller.
    Mapped,
}

impl Format {
    /// What a message calls it.
    pub const fn name(self) -> &'static str {
        match self {
            Format::Native => "a recording of this program",
            Format::Phyphox => "phyphox, or columns that name sensor and unit",
            Format::SensorLogger => "Sensor Logger",
            Format::PhysicsToolbox => "Physics Toolbox",
            Format::SensorLog => "SensorLog",
            Format::LightGate => "a light gate",
            Format::Gcsv => "Gyroflow",
            Format::Mapped => "by the mapping",
        }
    }

    /// The program, where one alone writes the format.
    pub(super) const fn logger(self) -> Option<&'static str> {
        match self {
            Format::SensorLogger => Some("Sensor Logger"),
            Format::PhysicsToolbox => Some("Physics Toolbox"),
            Format::SensorLog => Some("SensorLog"),
            Format::Native
            | Format::Phyphox
            | Format::LightGate
            | Format::Gcsv
            | Format::Mapped => None,
        }
    }
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
    /// The day, the phone and the program.
    pub facts: Facts,
    /// What a reader should know: choices made, and what looks doubtful.
    pub notes: Vec<String>,
    /// Columns, files and sensors of the export that are not used.
    pub not_used: Vec<String>,
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
    /// A list of periods.
    Periods(PeriodList),
    /// A light gate's edges.
    GateEvents(GateEvents),
    /// One channel of a motion of one degree of freedom.
    Channel(SingleChannel),
}

impl ImportedRecording {
    pub(super) fn new(
        file: &str,
        format: Format,
        recording: Recording,
        notes: Vec<String>,
    ) -> Self {
        Self::of(file, format, ImportedData::Recording(recording), notes)
    }

    /// Data of any kind.
    pub(super) fn of(file: &str, format: Format, data: ImportedData, notes: Vec<String>) -> Self {
        Self {
            name: stem(file).to_owned(),
            format,
            data,
            facts: Facts::default(),
            notes,
            not_used: Vec::new(),
        }
    }

    /// The same, with what of the export is not used.
    pub(super) fn without(mut self, not_used: impl IntoIterator<Item = String>) -> Self {
        self.not_used.extend(not_used);
        self
    }

    /// What was found wrong with the samples, and what was done.
    pub fn repairs(&self) -> &[Repair] {
        match &self.data {
            ImportedData::Recording(recording) => &recording.repairs,
            ImportedData::Track(track) => &track.repairs,
            ImportedData::Periods(list) => &list.repairs,
            ImportedData::GateEvents(_) => &[],
            ImportedData::Channel(channel) => &channel.repairs,
        }
    }

    /// Format, sensors, samples and duration in one line.
    pub fn summary(&self) -> String {
        let series = |name: &str, t_s: &[f64]| {
            let span = t_s
                .last()
                .zip(t_s.first())
                .map_or(0.0, |(last, first)| last - first);
            format!("{name}, {} samples in {span:.1} s", t_s.len())
        };
        let held: Vec<String> = match &self.data {
            ImportedData::Recording(all) => {
                let named = |one: &SensorChannels| match one.channels.len() {
                    3 => one.sensor.name().to_owned(),
                    _ => {
                        let axes: Vec<&str> = one.channels.iter().map(|(name, _)| *name).collect();
                        format!("{} ({} alone)", one.sensor.name(), axes.join(", "))
                    }
                };
                let sensors = all.sensors();
                let each = sensors.iter();
                each.map(|one| series(&named(one), one.t_s)).collect()
            }
            ImportedData::Track(track) => vec![series("track", &track.t_s)],
            ImportedData::Periods(list) => vec![series("periods", &list.t_s)],
            ImportedData::GateEvents(events) => vec![series("edges of a light gate", &events.t_s)],
            ImportedData::Channel(channel) => vec![series(channel.quantity.name(), &channel.t_s)],
        };
        format!("{} ({})", held.join("; "), self.format.name())
    }

    /// Everything that a reader should know: repairs, choices, what is not used.
    pub fn told(&self) -> Vec<String> {
        let repairs = self.repairs().iter().map(|repair| repair.text.clone());
        repairs
            .chain(self.notes.iter().cloned())
            .chain(self.not_used.iter().cloned())
            .collect()
    }

    /// What a session keeps of it for `file`, so that a later analysis tells it too; `None` where
    /// there is nothing to keep. `found_again` are the repairs that reading `file` finds by itself.
    pub fn recorded(&self, file: &str, found_again: &[Repair]) -> Option<Recorded> {
        let left_out = |text: &String| RecordedRepair {
            text: text.clone(),
            kind: Some(RepairKind::NotImported),
            ..RecordedRepair::default()
        };
        let repairs: Vec<RecordedRepair> = self
            .repairs()
            .iter()
            .filter(|repair| !found_again.contains(repair))
            .map(RecordedRepair::from)
            .chain(self.not_used.iter().map(left_out))
            .collect();
        let notes = [("import".to_owned(), self.notes.join("; "))];
        let notes = notes.into_iter().filter(|note| !note.1.is_empty());
        let holds = !repairs.is_empty() || !self.notes.is_empty() || self.facts != Facts::default();
        holds.then(|| Recorded {
            file: file.to_owned(),
            measured_on: self.facts.measured_on.clone(),
            phone: self.facts.phone.clone(),
            logger: self.facts.logger.clone(),
            notes: notes.collect(),
            repairs,
            ..Recorded::default()
        })
    }
}
