//! Recordings out of exports and recorder's files, as the swings of a session.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::import::ImportRequest;
use super::input::{options, read_exported};
use super::places::{Place, Places};
use gyradius_base::error::{Error, Result};
use gyradius_recording::import::{ImportedData, ImportedRecording, Input, import_inputs};
use gyradius_recording::recorder::{SYNC, converted};
use gyradius_recording::{
    Recorded, Repair, Suspension, Swing, SwingData, read_period_list, read_recording, read_track,
    write_recording,
};
use gyradius_signal::gate_periods;

/// The program that writes the recorder's files.
const RECORDER: &str = "gyradius";

/// Swings that came in.
#[derive(Debug, Default)]
pub(crate) struct Gathered {
    pub swings: Vec<Swing>,
    pub recorded: Vec<Recorded>,
    /// Recordings by name and bytes.
    pub files: Vec<(String, Vec<u8>)>,
    /// What a reader must know.
    pub notes: Vec<String>,
}

/// Reads files into swings that hung alike; each gets a place that nothing else has.
pub(crate) fn gather(
    files: &[PathBuf],
    request: &ImportRequest,
    suspension: &Suspension,
    places: &mut Places,
) -> Result<Gathered> {
    let (recorded, exported) = split(files)?;
    let mut gathered = Gathered::default();
    if !exported.is_empty() || recorded.is_empty() {
        let mut options = options(&request.mapping, request.platform)?;
        options.trial.clone_from(&request.trial);
        let imported = import_inputs(&exported, &options)?;
        let several = imported.recordings.len() + recorded.len() > 1;
        for recording in &imported.recordings {
            let place = places.of(&recording.name, false)?;
            let (data, bytes) = contents(recording, &place.file, request)?;
            let found_again = read_back(&data, &bytes, recording)?;
            let kept = recording.recorded(&place.file, &found_again);
            gathered.recorded.extend(kept);
            let told = recording.told().into_iter();
            gathered.notes.extend(told.map(|text| match several {
                true => format!("{}: {text}", place.id),
                false => text,
            }));
            gathered.files.push((place.file.clone(), bytes));
            gathered.add(place, data, suspension);
        }
    }
    for file in &recorded {
        gathered.add_recorded(file, suspension, places)?;
    }
    Ok(gathered)
}

impl Gathered {
    fn add(&mut self, place: Place, data: SwingData, suspension: &Suspension) {
        self.swings.push(Swing {
            id: place.id,
            data,
            excited: Vec::new(),
            added_masses: Vec::new(),
            amplitude_deg: Default::default(),
            suspension: suspension.clone(),
        });
    }

    fn add_recorded(
        &mut self,
        file: &Path,
        suspension: &Suspension,
        places: &mut Places,
    ) -> Result<()> {
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let place = places.of(&stem, true)?;
        let name = place.file.strip_suffix(".csv").unwrap_or(&place.file);
        let (mut recorded, mut tables) = converted(file, name)?;
        if let Some(samples) = tables.first_mut() {
            samples.0.clone_from(&place.file);
        }
        recorded.file.clone_from(&place.file);
        recorded.logger = RECORDER.to_owned();
        let repairs = recorded.repairs.iter();
        self.notes.extend(repairs.map(|repair| repair.text.clone()));
        self.recorded.push(recorded);
        self.files.extend(tables);
        let data = SwingData::Recording(place.file.clone());
        self.add(place, data, suspension);
        Ok(())
    }
}

/// Recorder's files by path, and what other programs exported by name and bytes.
type Inputs = (Vec<PathBuf>, Vec<Input>);

/// Tells recorder's files, which may be long and are read piece by piece, from what other programs
/// exported.
pub(crate) fn split(files: &[PathBuf]) -> Result<Inputs> {
    let mut inputs = Inputs::default();
    for file in files {
        if is_recorded(file) {
            inputs.0.push(file.clone())
        } else {
            inputs.1.push(read_exported(file)?)
        }
    }
    Ok(inputs)
}

/// Whether a file is one that a phone's recorder wrote.
pub(crate) fn is_recorded(file: &Path) -> bool {
    let mut start = [0; SYNC.len()];
    let read = fs::File::open(file).and_then(|mut file| file.read_exact(&mut start));
    read.is_ok() && start == SYNC
}

fn contents(
    recording: &ImportedRecording,
    file: &str,
    request: &ImportRequest,
) -> Result<(SwingData, Vec<u8>)> {
    match &recording.data {
        ImportedData::Recording(data) => {
            Ok((SwingData::Recording(file.into()), write_recording(data)))
        }
        ImportedData::Track(track) => {
            let data = SwingData::Displacement {
                file: file.into(),
                at_m: None,
            };
            Ok((data, columns("t,y", &track.t_s, &track.y_m)))
        }
        ImportedData::Periods(list) => Ok((
            SwingData::Periods(file.into()),
            columns("t,period", &list.t_s, &list.period_s),
        )),
        ImportedData::Channel(channel) => Ok((
            SwingData::Recording(file.into()),
            write_recording(&channel.clone().into()),
        )),
        ImportedData::GateEvents(events) => {
            let wanted =
                || Error::argument("flag_width", "the width of the flag in the beam, m", "none");
            let list = gate_periods(events, request.flag_width_m.ok_or_else(wanted)?)?.list(file);
            Ok((
                SwingData::Periods(file.into()),
                columns("t,period", &list.t_s, &list.period_s),
            ))
        }
    }
}

/// Reads what is about to be written as a later analysis will; the repairs that reading finds. A
/// file that would be refused then is refused now, with what the import found.
fn read_back(data: &SwingData, bytes: &[u8], from: &ImportedRecording) -> Result<Vec<Repair>> {
    let read = match data {
        SwingData::Recording(file) => read_recording(bytes, file).map(|read| read.repairs),
        SwingData::Displacement { file, .. } => read_track(bytes, file).map(|read| read.repairs),
        SwingData::Periods(file) => read_period_list(bytes, file).map(|read| read.repairs),
        SwingData::PeriodsS(_) => return Ok(Vec::new()),
    };
    read.map_err(|error| Error::Malformed {
        file: from.name.clone(),
        line: None,
        expected: "samples that can be analysed once they are imported".to_owned(),
        found: [vec![error.to_string()], from.told()].concat().join("; "),
    })
}

fn columns(header: &str, left: &[f64], right: &[f64]) -> Vec<u8> {
    let rows = left
        .iter()
        .zip(right)
        .map(|(left, right)| format!("{left},{right}\n"));
    std::iter::once(format!("{header}\n"))
        .chain(rows)
        .collect::<String>()
        .into_bytes()
}
