//! A session or a bare recording, told apart by what lies at a path.

use std::path::Path;

use super::gather::is_recorded;
use super::input::{options, read_exported};
use gyradius_base::error::{Error, Result};
use gyradius_recording::import::{ImportedData, Input, import_inputs};
use gyradius_recording::{LoadedSession, Recording, SESSION_FILE, Store, load_session, load_store};

/// What was loaded.
#[derive(Debug, Clone, PartialEq)]
pub enum Loaded {
    /// A session with everything that it names.
    Session(Box<LoadedSession>),
    /// One recording, which gives modes alone.
    Bare(Box<Recording>),
}

impl Loaded {
    /// The session's title, or the recording's name.
    pub fn title(&self) -> &str {
        match self {
            Loaded::Session(loaded) => &loaded.session.title,
            Loaded::Bare(recording) => &recording.name,
        }
    }

    /// Ids of the swings, in session order; a bare recording's name.
    pub fn swing_ids(&self) -> Vec<&str> {
        match self {
            Loaded::Session(loaded) => loaded
                .session
                .swings
                .iter()
                .map(|swing| swing.id.as_str())
                .collect(),
            Loaded::Bare(recording) => vec![&recording.name],
        }
    }

    /// The session, where it is one.
    pub fn session(&self) -> Option<&LoadedSession> {
        match self {
            Loaded::Session(loaded) => Some(loaded),
            Loaded::Bare(_) => None,
        }
    }

    /// What can be simulated. Fails with [`Error::NoResult`] for a bare recording.
    pub fn with_dimensions(&self) -> Result<&LoadedSession> {
        let reason = "a bare recording tells no dimensions to simulate it by";
        self.session()
            .ok_or_else(|| Error::no_result(self.title(), reason))
    }
}

/// Reads a session folder, its `session.toml`, a session's zip or a bare recording in any format
/// that can be imported; a mapping (`gx=xGyro:deg/s`) names the columns of a foreign CSV.
pub fn load_any(path: &Path, mapping: &[String]) -> Result<Loaded> {
    let session = |loaded| Loaded::Session(Box::new(loaded));
    match path.extension().and_then(|ending| ending.to_str()) {
        // A folder is a session, or what an app exported.
        _ if path.is_dir() => {
            let store = Store::open(path)?;
            let is_export = |name: &String| !name.starts_with('.');
            if store.contains(SESSION_FILE) || !store.names()?.iter().any(is_export) {
                load_session(path).map(session)
            } else {
                bare(path, mapping)
            }
        }
        Some("toml") => load_session(path).map(session),
        // A zip is a session, or what a phone's logger exported.
        Some("zip") => {
            let store = Store::open(path)?;
            if store.contains(SESSION_FILE) {
                load_store(&store).map(session)
            } else {
                bare(path, mapping)
            }
        }
        _ => bare(path, mapping),
    }
}

fn bare(path: &Path, mapping: &[String]) -> Result<Loaded> {
    if is_recorded(path) {
        let found =
            "a file of the phone's recorder, which becomes a session with `gyradius import`";
        return Err(no_phone(path, found));
    }
    recording(path, read_exported(path)?, mapping)
}

/// Reads a bare recording from the tables of a file that another program took apart; `file` is what
/// messages call it.
pub fn load_tables(
    file: &Path,
    tables: Vec<(String, Vec<u8>)>,
    mapping: &[String],
) -> Result<Loaded> {
    let store = Store::from_files(&file.display().to_string(), tables)?;
    recording(file, Input::Folder(store), mapping)
}

/// The one recording that an export holds.
fn recording(path: &Path, input: Input, mapping: &[String]) -> Result<Loaded> {
    let imported = import_inputs(&[input], &options(mapping, None)?)?;
    let mut data = imported
        .recordings
        .into_iter()
        .map(|recording| recording.data);
    match (data.next(), data.next()) {
        (Some(ImportedData::Recording(recording)), None) => Ok(Loaded::Bare(Box::new(recording))),
        (Some(ImportedData::Channel(channel)), None) => Ok(Loaded::Bare(Box::new(channel.into()))),
        (
            Some(ImportedData::Track(_) | ImportedData::Periods(_) | ImportedData::GateEvents(_)),
            None,
        ) => Err(no_phone(
            path,
            "a track or a list of events, which becomes a session with `gyradius import`",
        )),
        _ => Err(no_phone(
            path,
            "several recordings, which become a session with `gyradius import`",
        )),
    }
}

fn no_phone(path: &Path, found: &str) -> Error {
    let (file, expected) = (
        path.display().to_string(),
        "a session or one phone's recording".into(),
    );
    Error::Malformed {
        file,
        line: None,
        expected,
        found: found.into(),
    }
}
