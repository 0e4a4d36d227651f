//! A session with all its recordings, from a folder, a `.zip` or bytes.

use std::path::Path;

use super::csv;
use super::keys::AssumedU;
use super::named_file::NamedFile;
use super::recorded::Recorded;
use super::samples::{PeriodList, Recording, Repair, Track};
use super::session::{InclineAngle, Session, SwingData};
use super::store::Store;
use super::toml_read::parse_session;
use gyradius_base::error::{Error, Result};

/// The file that makes a folder a session.
pub const SESSION_FILE: &str = "session.toml";

/// A session and everything that it names.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedSession {
    /// The session as stated.
    pub session: Session,
    /// Where it came from, as the user knows it.
    pub source: String,
    /// What each swing left behind, in the order of `session.swings`.
    pub data: Vec<LoadedSwing>,
    /// The recording of each incline test, in the order of `session.inclines`; none where the angle
    /// is stated.
    pub inclines: Vec<Option<Recording>>,
    /// Figures that are stated without an uncertainty, and the usual one that each got.
    pub assumed: Vec<AssumedU>,
}

/// One swing's data.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedSwing {
    /// The swing's id.
    pub id: String,
    /// The data.
    pub data: LoadedData,
}

/// What a swing's file held.
// A session has tens of these and mostly of the large kind: a box would buy nothing.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone, PartialEq)]
pub enum LoadedData {
    /// A phone's recording.
    Recording(Recording),
    /// A rangefinder's track.
    Track(Track),
    /// A list of periods.
    Periods(PeriodList),
    /// Periods typed into the session itself: there is no file.
    Typed,
}

/// Loads a session from a folder, a `.zip` or the path of a `session.toml`.
pub fn load_session(path: impl AsRef<Path>) -> Result<LoadedSession> {
    load_store(&Store::open(path)?)
}

/// Loads a session from an opened source.
pub fn load_store(store: &Store) -> Result<LoadedSession> {
    let file = store.describe(SESSION_FILE);
    let bytes = store.read(SESSION_FILE)?;
    let parsed = parse_session(utf8(&bytes, &file)?, &file)?;
    parsed
        .files
        .iter()
        .try_for_each(|named| refuse_missing(store, &file, named))?;
    let session = parsed.session;
    let load = |swing: &super::session::Swing| {
        Ok(LoadedSwing {
            id: swing.id.clone(),
            data: swing_data(store, &session, &swing.data)?,
        })
    };
    let data = session.swings.iter().map(load).collect::<Result<_>>()?;
    let inclines = session
        .inclines
        .iter()
        .map(|one| incline_data(store, &session, &one.angle))
        .collect::<Result<_>>()?;
    Ok(LoadedSession {
        session,
        source: store.name().into(),
        data,
        inclines,
        assumed: parsed.assumed,
    })
}

/// A file's bytes as text; fails where they are not UTF-8.
pub fn utf8<'a>(bytes: &'a [u8], file: &str) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()]
            .iter()
            .filter(|&&byte| byte == b'\n')
            .count();
        let (expected, found) = ("text in UTF-8".into(), "other bytes".into());
        Error::Malformed {
            file: file.into(),
            line: Some(line),
            expected,
            found,
        }
    })
}

/// A missing file is an error of the line that names it.
fn refuse_missing(store: &Store, session_file: &str, named: &NamedFile) -> Result<()> {
    if store.contains(&named.file) {
        return Ok(());
    }
    Err(Error::Malformed {
        file: session_file.into(),
        line: named.line,
        expected: format!("`{}` to name a file of the session", named.key),
        found: format!("`{}`, which is not there", named.file),
    })
}

/// A phone's recording, with what the recorder had lost of it told first, and when it was
/// disturbed.
fn phone_recording(store: &Store, session: &Session, file: &str) -> Result<Recording> {
    let mut recording = csv::read_recording(&store.read(file)?, &store.describe(file))?;
    add_told(session, file, &mut recording.repairs);
    let of_file = session.recorded.iter().filter(|told| told.file == file);
    recording.disturbed_s = of_file.flat_map(Recorded::disturbed_s).collect();
    Ok(recording)
}

/// What the session tells of a file, ahead of what the file itself shows.
fn add_told(session: &Session, file: &str, repairs: &mut Vec<Repair>) {
    let of_file = session.recorded.iter().filter(|told| told.file == file);
    repairs.splice(0..0, of_file.flat_map(Recorded::as_repairs));
}

fn swing_data(store: &Store, session: &Session, data: &SwingData) -> Result<LoadedData> {
    match data {
        SwingData::Recording(file) => {
            phone_recording(store, session, file).map(LoadedData::Recording)
        }
        SwingData::Displacement { file, .. } => {
            let mut track = csv::read_track(&store.read(file)?, &store.describe(file))?;
            add_told(session, file, &mut track.repairs);
            Ok(LoadedData::Track(track))
        }
        SwingData::Periods(file) => {
            let mut list = csv::read_period_list(&store.read(file)?, &store.describe(file))?;
            add_told(session, file, &mut list.repairs);
            Ok(LoadedData::Periods(list))
        }
        SwingData::PeriodsS(_) => Ok(LoadedData::Typed),
    }
}

fn incline_data(
    store: &Store,
    session: &Session,
    angle: &InclineAngle,
) -> Result<Option<Recording>> {
    match angle {
        InclineAngle::Stated(_) => Ok(None),
        InclineAngle::Recording(file) => {
            let recording = phone_recording(store, session, file)?;
            refuse_without_gravity(&recording, &store.describe(file))?;
            Ok(Some(recording))
        }
    }
}

/// A direction needs all three axes: what is missing is not zero.
fn refuse_without_gravity(recording: &Recording, file: &str) -> Result<()> {
    if recording.accelerometer.is_some() {
        return Ok(());
    }
    let sensors = recording.sensors().into_iter();
    let names: Vec<&str> = sensors
        .flat_map(|sensor| sensor.channels)
        .map(|(name, _)| name)
        .collect();
    Err(Error::Malformed {
        file: file.into(),
        line: None,
        expected: "the accelerometer's ax, ay and az, whose gravity gives the angle of the incline"
            .into(),
        found: format!("{} alone", names.join(", ")),
    })
}
