//! Phone exports and recorder's files into a session folder.

use std::collections::BTreeSet;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::input::{options, read_exported};
use gyradius_base::error::{Error, Result};
use gyradius_recording::import::{ImportedData, ImportedRecording, Input, Platform, import_inputs};
use gyradius_recording::recorder::{SYNC, convert};
use gyradius_recording::{
    Body, Overwrite, Quantity, Repair, SESSION_FILE, Session, Site, Suspension, SuspensionKind,
    Swing, SwingData, read_period_list, read_recording, read_track, save_session, write_files,
    write_recording, write_session,
};
use gyradius_signal::gate_periods;

/// What the caller knows of the session beside its recordings.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportRequest {
    /// Columns of a CSV that is not recognised, and their units: `gx=xGyro:deg/s`.
    pub mapping: Vec<String>,
    /// Which of several trials in one file is meant, as the file numbers or names them.
    pub trial: Option<String>,
    /// The phone's system, where a file's signs depend on it and the file does not say.
    pub platform: Option<Platform>,
    /// Width of the flag in a light gate's beam, m.
    pub flag_width_m: Option<f64>,
    /// Title of the session, and name of the body.
    pub title: String,
    /// Everything that swings, kg; of this and all lengths, u is NaN where nobody states it.
    pub mass_kg: Option<Quantity>,
    /// Free-fall acceleration, m/s².
    pub gravity_m_s2: Option<Quantity>,
    /// How every swing hung.
    pub suspension: Suspension,
}

/// Writes a session folder, one swing for each recording; returns what a reader must know.
///
/// Where dimensions are missing that a session must have, the recordings are written beside a draft
/// of `session.toml` that says at its top what to fill in. Fails as reading, converting and writing
/// do, and with [`Error::Argument`] for a light gate's log without the flag's width.
pub fn import_session(
    files: &[PathBuf],
    folder: &Path,
    request: &ImportRequest,
    overwrite: Overwrite,
) -> Result<Vec<String>> {
    let (recorded, exported) = split(files)?;
    let mut session = request.session();
    let mut files = Vec::new();
    let mut ids = BTreeSet::new();
    let mut notes = Vec::new();
    if !exported.is_empty() || recorded.is_empty() {
        let mut options = options(&request.mapping, request.platform)?;
        options.trial.clone_from(&request.trial);
        let imported = import_inputs(&exported, &options)?;
        for recording in &imported.recordings {
            let id = free_id(&recording.name, &mut ids);
            let name = format!("{id}.csv");
            let (data, bytes) = contents(recording, &name, request)?;
            let found_again = read_back(&data, &bytes, recording)?;
            session
                .recorded
                .extend(recording.recorded(&name, &found_again));
            let of = |text| match imported.recordings.len() {
                1 => text,
                _ => format!("{id}: {text}"),
            };
            notes.extend(recording.told().into_iter().map(of));
            session.swings.push(request.swing(id, data));
            files.push((name, bytes));
        }
    }
    let imported = session.recorded.len();
    convert_recorded(
        &recorded,
        folder,
        (request, overwrite),
        &mut ids,
        &mut session,
    )?;
    let converted = session.recorded.iter().skip(imported);
    notes.extend(converted.flat_map(|recorded| recorded.repairs.iter().map(|r| r.text.clone())));
    let missing = request.missing();
    if missing.is_empty() {
        save_session(folder, &session, &files, overwrite)?;
        return Ok(notes);
    }
    save_draft(folder, &session, files, &missing, overwrite)?;
    Ok([notes, vec![draft_note(&missing)]].concat())
}

/// What exports hold, line by line: every recording with its format, sensors and samples, and what
/// an import would tell. Nothing is written. Fails as reading does; a table that is not known is an
/// error that proposes a mapping.
pub fn describe_exports(files: &[PathBuf], request: &ImportRequest) -> Result<Vec<String>> {
    let (recorded, exported) = split(files)?;
    let mut lines: Vec<String> = recorded
        .iter()
        .map(|file| format!("{}: a recorder's file", file.display()))
        .collect();
    if !exported.is_empty() {
        let mut options = options(&request.mapping, request.platform)?;
        options.trial.clone_from(&request.trial);
        for recording in import_inputs(&exported, &options)?.recordings {
            lines.push(format!("{}: {}", recording.name, recording.summary()));
            lines.extend(recording.told().into_iter().map(|text| format!("  {text}")));
        }
    }
    Ok(lines)
}

/// Recorder's files by path, and what other programs exported by name and bytes.
type Inputs = (Vec<PathBuf>, Vec<Input>);

/// Tells recorder's files, which may be long and are read piece by piece, from what other programs
/// exported.
fn split(files: &[PathBuf]) -> Result<Inputs> {
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
pub(super) fn is_recorded(file: &Path) -> bool {
    let mut start = [0; SYNC.len()];
    let read = fs::File::open(file).and_then(|mut file| file.read_exact(&mut start));
    read.is_ok() && start == SYNC
}

/// Writes recorder's files as recordings of the session; refused before anything is written where a
/// file is there.
fn convert_recorded(
    recorded: &[PathBuf],
    folder: &Path,
    (request, overwrite): (&ImportRequest, Overwrite),
    ids: &mut BTreeSet<String>,
    session: &mut Session,
) -> Result<()> {
    let name = |file: &PathBuf| {
        file.file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
    };
    let named: Vec<(&PathBuf, String)> = recorded
        .iter()
        .map(|file| (file, free_id(&name(file).unwrap_or_default(), ids)))
        .collect();
    let written = named
        .iter()
        .flat_map(|(_, id)| [format!("{id}.csv"), format!("{id}-bias.csv")]);
    let mut all = written
        .chain([SESSION_FILE.to_owned()])
        .map(|file| folder.join(file));
    if let (Overwrite::Refuse, false, Some(path)) = (
        overwrite,
        recorded.is_empty(),
        all.find(|path| path.exists()),
    ) {
        return Err(unwritable(
            &path,
            "it exists already and is not overwritten",
        ));
    }
    for (file, id) in named {
        session.recorded.push(convert(file, folder, &id)?);
        session
            .swings
            .push(request.swing(id.clone(), SwingData::Recording(format!("{id}.csv"))));
    }
    Ok(())
}

/// A session that lacks dimensions cannot be read back, so the core does not save it: its
/// recordings and a `session.toml` that says at its top what to fill in.
fn save_draft(
    folder: &Path,
    session: &Session,
    mut files: Vec<(String, Vec<u8>)>,
    missing: &[&str],
    overwrite: Overwrite,
) -> Result<()> {
    let text = format!(
        "# To be filled in: {}.\n{}",
        missing.join(", "),
        write_session(session)
    );
    files.push((SESSION_FILE.into(), text.into_bytes()));
    let paths: Vec<(PathBuf, &[u8])> = files
        .iter()
        .map(|(name, bytes)| (folder.join(name), &**bytes))
        .collect();
    write_files(&paths, overwrite)
}

fn unwritable(path: &Path, reason: impl ToString) -> Error {
    Error::Unwritable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    }
}

fn draft_note(missing: &[&str]) -> String {
    let keys = missing.join(" and ");
    format!(
        "{SESSION_FILE} still lacks {keys} of each swing; until then each recording can be measured by itself"
    )
}

fn free_id(name: &str, taken: &mut BTreeSet<String>) -> String {
    let plain: String = name
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || c == '_' {
                c
            } else {
                '-'
            }
        })
        .collect();
    let mut candidates =
        std::iter::once(plain.clone()).chain((2..).map(|number| format!("{plain}-{number}")));
    candidates
        .find(|id| taken.insert(id.clone()))
        .unwrap_or(plain)
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

impl ImportRequest {
    /// Keys of a suspension that a session must have and the caller did not give.
    fn missing(&self) -> Vec<&'static str> {
        let hung = &self.suspension;
        let needed = match hung.kind {
            SuspensionKind::Compound => vec![("axis_height", hung.axis_height_m)],
            SuspensionKind::Free => vec![],
            SuspensionKind::Trifilar => vec![
                ("line_length", hung.line_length_m),
                ("radius", hung.spacing_m),
            ],
            SuspensionKind::Bifilar => {
                vec![
                    ("line_length", hung.line_length_m),
                    ("spacing", hung.spacing_m),
                ]
            }
        };
        needed
            .into_iter()
            .filter(|(_, stated)| stated.is_none())
            .map(|(key, _)| key)
            .collect()
    }

    fn session(&self) -> Session {
        Session {
            title: self.title.clone(),
            body: Body {
                name: self.title.clone(),
                mass_kg: self.mass_kg,
                ..Body::default()
            },
            site: Site {
                gravity_m_s2: self.gravity_m_s2,
                ..Site::default()
            },
            ..Session::default()
        }
    }

    fn swing(&self, id: String, data: SwingData) -> Swing {
        Swing {
            id,
            data,
            excited: Vec::new(),
            added_masses: Vec::new(),
            amplitude_deg: Default::default(),
            suspension: self.suspension.clone(),
        }
    }
}
