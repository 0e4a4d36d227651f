//! Phone exports and recorder's files into a new session folder.

use std::path::{Path, PathBuf};

use super::gather::{Gathered, gather};
use super::places::Places;
use gyradius_base::error::{Error, Result};
use gyradius_recording::import::Platform;
use gyradius_recording::{
    Body, Overwrite, Quantity, Recorded, SESSION_FILE, Session, Site, Suspension, read_session,
    write_files, write_session_to_fill_in,
};

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
/// What is usual and not stated stands in `session.toml` as comments. Where dimensions are missing
/// that a session must have, it is a draft that says at its top what to fill in. All files are
/// written or none. Fails as reading, converting and writing do, and with [`Error::Argument`] for a
/// light gate's log without the flag's width.
///
/// [`Error::Argument`]: gyradius_base::Error::Argument
pub fn import_session(
    files: &[PathBuf],
    folder: &Path,
    request: &ImportRequest,
    overwrite: Overwrite,
) -> Result<Vec<String>> {
    refuse_session_there(folder, overwrite)?;
    let Gathered {
        swings,
        recorded,
        mut files,
        mut notes,
    } = gather(files, request, &request.suspension, &mut Places::default())?;
    let mut session = Session {
        swings,
        recorded,
        ..request.session()
    };
    state_what_all_say(&mut session);
    // What is stated once of all of them is one reading.
    let session = session.with_same_hangings();
    let mut text = write_session_to_fill_in(&session);
    let missing = missing(&request.suspension);
    if missing.is_empty() {
        read_session(&text, SESSION_FILE)?;
    } else {
        text = format!("# To be filled in: {}.\n{text}", missing.join(", "));
        notes.push(draft_note(&missing));
    }
    files.push((SESSION_FILE.into(), text.into_bytes()));
    let paths: Vec<(PathBuf, &[u8])> = files
        .iter()
        .map(|(name, bytes)| (folder.join(name), &**bytes))
        .collect();
    write_files(&paths, overwrite)?;
    Ok(notes)
}

/// A session is added to, or replaced as a whole: its text may hold what a person wrote.
fn refuse_session_there(folder: &Path, overwrite: Overwrite) -> Result<()> {
    let file = folder.join(SESSION_FILE);
    if overwrite == Overwrite::Replace || !file.exists() {
        return Ok(());
    }
    Err(Error::Unwritable {
        file: file.display().to_string(),
        reason: "it exists already and is not overwritten (--into adds swings to it)".to_owned(),
    })
}

/// The day, the phone and the program stand at the top where all recordings have the same.
fn state_what_all_say(session: &mut Session) {
    let Some(first) = session.recorded.first().cloned() else {
        return;
    };
    let all_recordings = session.recorded.len() == session.swings.len();
    let all = &mut session.recorded;
    if all_recordings && all.iter().all(|one| one.measured_on == first.measured_on) {
        session.measured_on = first.measured_on;
        all.iter_mut().for_each(|one| one.measured_on.clear());
    }
    if all_recordings && all.iter().all(|one| one.phone == first.phone) {
        session.phone = first.phone;
        all.iter_mut().for_each(|one| one.phone.clear());
    }
    if all_recordings && all.iter().all(|one| one.logger == first.logger) {
        session.logger = first.logger;
        all.iter_mut().for_each(|one| one.logger.clear());
    }
    all.retain(Recorded::says_anything);
}

pub(crate) fn draft_note(missing: &[&str]) -> String {
    let keys = missing.join(" and ");
    format!(
        "{SESSION_FILE} still lacks {keys} of each swing; until then each recording can be measured by itself"
    )
}

/// Keys of a suspension that a session must have and the caller did not give.
pub(crate) fn missing(hung: &Suspension) -> Vec<&'static str> {
    let needed = hung.kind.needs().iter().copied();
    needed.filter(|key| hung.figure(key).is_none()).collect()
}

impl ImportRequest {
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
}
