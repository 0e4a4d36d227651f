//! Recordings into a session that is there already.
//!
//! The session's text is kept as it stands: new swings are put at its end, and of a planned swing
//! only the figures that the caller states anew are changed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::draft::{Draft, figure_key, read_draft, set_stated};
use super::gather::{Gathered, gather};
use super::hanging::Hanging;
use super::import::{ImportRequest, draft_note, missing};
use super::places::Places;
use gyradius_base::error::{Error, Result};
use gyradius_recording::{
    HungAs, Overwrite, Recorded, SESSION_FILE, Session, Store, Suspension, Swing, SwingData, utf8,
    write_files, write_swings_to_fill_in,
};

/// Which swings of a session the recordings are, and how new ones hung.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Growth {
    /// The swing of the session that the recording is of, where the session has it without one.
    /// Without it, a recording is of the swing that has its name.
    pub swing: Option<String>,
    /// The swing of the session that new ones hung like, but for what is stated anew.
    pub like: Option<String>,
    /// What is stated of how they hung.
    pub hung: Hanging,
}

/// Adds a swing to the session in a folder for each recording, or gives a swing that is planned
/// there its recording; returns what a reader must know.
///
/// Nothing that the session holds is dropped or renamed: ids and file names that are taken make
/// the new swing take another. All files are written or none. The folder's lock is the caller's.
/// Of the request, title, mass and gravity must be empty: they are the session's. Its suspension is
/// not looked at: how swings hung stands in `growth`.
pub fn import_into(
    files: &[PathBuf],
    folder: &Path,
    request: &ImportRequest,
    growth: &Growth,
) -> Result<Vec<String>> {
    refuse_what_is_the_sessions(request)?;
    let store = session_folder(folder)?;
    let file = store.describe(SESSION_FILE);
    let bytes = store.read(SESSION_FILE)?;
    let text = utf8(&bytes, &file)?;
    let before = read_draft(text, &file)?;
    before.refuse_lists_in_line(&file)?;
    let (hung, copied) = growth.new_ones(&before)?;
    let mut places = places(&before.session, &store)?;
    if let Some(swing) = &growth.swing {
        places.mean(swing)?;
    }
    let mut gathered = gather(files, request, &hung, &mut places)?;
    refuse_same_samples(&gathered, &store)?;
    leave_what_the_session_says(&mut gathered.recorded, &before.session);

    let mut notes = std::mem::take(&mut gathered.notes);
    for (name, id) in &places.renamed {
        notes.push(format!(
            "the session has a swing or a file `{name}` already; the new swing is `{id}`"
        ));
    }
    let is_planned = |swing: &&Swing| before.session.swings.iter().any(|old| old.id == swing.id);
    let (planned, new): (Vec<&Swing>, Vec<&Swing>) = gathered.swings.iter().partition(is_planned);
    let mut after = text.to_owned();
    for swing in planned {
        after = growth.fill(&after, &before.session, swing)?;
        notes.push(format!(
            "the swing `{}` of the session has its recording; what it states beside is kept",
            swing.id
        ));
    }
    let lacks = missing(&hung);
    if !new.is_empty() && !lacks.is_empty() {
        if before.is_complete() {
            return Err(lacking(&lacks));
        }
        notes.push(draft_note(&lacks));
    }
    let added = added(new, gathered.recorded, &copied);
    after = with_tables(after, &write_swings_to_fill_in(&added));
    // What cannot be read back is not written.
    read_draft(&after, &file)?;

    let folder = store_path(folder);
    let place = |name: &String| folder.join(name);
    for (name, _) in &gathered.files {
        if fs::symlink_metadata(place(name)).is_ok() {
            return Err(Error::Unwritable {
                file: place(name).display().to_string(),
                reason: "it exists already and is not overwritten".to_owned(),
            });
        }
    }
    let session_file = folder.join(SESSION_FILE);
    // A link stays one.
    let session_file = fs::canonicalize(&session_file).unwrap_or(session_file);
    let mut all: Vec<(PathBuf, &[u8])> = gathered
        .files
        .iter()
        .map(|(name, bytes)| (place(name), &**bytes))
        .collect();
    all.push((session_file, after.as_bytes()));
    write_files(&all, Overwrite::Replace)?;
    Ok(notes)
}

fn refuse_what_is_the_sessions(request: &ImportRequest) -> Result<()> {
    let given = [
        ("title", !request.title.is_empty()),
        ("mass", request.mass_kg.is_some()),
        ("gravity", request.gravity_m_s2.is_some()),
    ];
    match given.into_iter().find(|(_, is_given)| *is_given) {
        Some((name, _)) => Err(Error::argument(
            name,
            format!("none for a session that is there: write it into its {SESSION_FILE}"),
            "one",
        )),
        None => Ok(()),
    }
}

/// The folder of a session, by its own name or by that of its `session.toml`.
fn store_path(folder: &Path) -> PathBuf {
    match folder.file_name() {
        Some(name) if name == SESSION_FILE => folder.with_file_name(""),
        _ => folder.to_owned(),
    }
}

fn session_folder(folder: &Path) -> Result<Store> {
    let path = store_path(folder);
    let path = if path.as_os_str().is_empty() {
        PathBuf::from(".")
    } else {
        path
    };
    let refused = |found: &str| {
        Err(Error::Malformed {
            file: folder.display().to_string(),
            line: None,
            expected: format!("the folder of a session, with its {SESSION_FILE}"),
            found: found.to_owned(),
        })
    };
    if path.is_file() {
        return refused(
            "a file; unpack a zip first, put another file into a folder as session.toml",
        );
    }
    if !path.is_dir() {
        return refused("nothing; -o instead of --into writes a new session");
    }
    let store = Store::open(&path)?;
    if !store.contains(SESSION_FILE) {
        return refused("none; -o instead of --into writes a new session");
    }
    Ok(store)
}

/// What is taken in a session, and the swings that wait for their recordings.
fn places(session: &Session, store: &Store) -> Result<Places> {
    let mut places = Places::default();
    store
        .names()?
        .iter()
        .for_each(|file| places.take_file(file));
    let of_recorded = session.recorded.iter();
    of_recorded
        .flat_map(|one| std::iter::once(&one.file).chain(&one.bias))
        .for_each(|file| places.take_file(file));
    for swing in &session.swings {
        places.take_id(&swing.id);
        if let Some(file) = file_of(&swing.data) {
            places.take_file(file);
            if !store.contains(file) {
                places.plan(&swing.id, file);
            }
        }
    }
    for incline in &session.inclines {
        if let gyradius_recording::InclineAngle::Recording(file) = &incline.angle {
            places.take_file(file);
        }
    }
    Ok(places)
}

fn file_of(data: &SwingData) -> Option<&str> {
    match data {
        SwingData::Recording(file)
        | SwingData::Displacement { file, .. }
        | SwingData::Periods(file) => Some(file),
        SwingData::PeriodsS(_) => None,
    }
}

/// The same samples twice are not two measurements.
fn refuse_same_samples(gathered: &Gathered, store: &Store) -> Result<()> {
    let is_table = |name: &&String| name.to_lowercase().ends_with(".csv");
    for name in store.names()?.iter().filter(is_table) {
        let there = store.read(name)?;
        if let Some((new, _)) = gathered.files.iter().find(|(_, bytes)| *bytes == there) {
            return Err(Error::argument(
                "files",
                "recordings that the session does not hold yet",
                format!("the samples of `{name}` again, as `{new}`"),
            ));
        }
    }
    Ok(())
}

/// What the session says of all recordings needs no repeating.
fn leave_what_the_session_says(recorded: &mut Vec<Recorded>, session: &Session) {
    for one in recorded.iter_mut() {
        for (said, of_all) in [
            (&mut one.measured_on, &session.measured_on),
            (&mut one.phone, &session.phone),
            (&mut one.logger, &session.logger),
        ] {
            if said == of_all {
                said.clear();
            }
        }
    }
    recorded.retain(Recorded::says_anything);
}

fn lacking(lacks: &[&str]) -> Error {
    Error::argument(
        "suspension",
        format!(
            "how the new swing hung: {}, or the id of a swing that hung alike (--like)",
            lacks.join(" and ")
        ),
        "neither; without it the session could not be measured any more",
    )
}

/// A text with tables at its end, in its own line ends.
fn with_tables(mut text: String, tables: &str) -> String {
    if tables.is_empty() {
        return text;
    }
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    if !text.ends_with('\n') {
        text.push_str(end);
    }
    text.push_str(&tables.replace('\n', end));
    text
}

impl Growth {
    /// How new swings hung, and what they have of another swing.
    fn new_ones(&self, draft: &Draft) -> Result<(Suspension, Copied)> {
        let Some(like) = &self.like else {
            return Ok((self.hung.alone()?, Copied::Nothing));
        };
        let swings = &draft.session.swings;
        let found = swings.iter().position(|swing| swing.id == *like);
        let (base, mut read_with) = found.and_then(|at| draft.hung(at)).ok_or_else(|| {
            let ids: Vec<&str> = swings.iter().map(|swing| &*swing.id).collect();
            Error::argument(
                "like",
                format!("a swing of the session: {}", ids.join(", ")),
                format!("`{like}`"),
            )
        })?;
        read_with.retain(|key, _| !self.hung.figures.contains_key(key));
        let hung = self.hung.over(&base)?;
        if hung.kind != base.kind || hung.orientation != base.orientation {
            return Ok((hung, Copied::Figures(read_with)));
        }
        let but_for: BTreeSet<String> = self.hung.figures.keys().cloned().collect();
        let hung = base.but_for(&but_for, &hung);
        let swing = like.clone();
        Ok((hung, Copied::Hanging(HungAs { swing, but_for })))
    }

    /// The text with what is stated of a planned swing, whose recording is of the kind that it
    /// waits for.
    fn fill(&self, text: &str, session: &Session, swing: &Swing) -> Result<String> {
        let place = session.swings.iter().position(|old| old.id == swing.id);
        let Some((place, old)) = place.and_then(|at| Some((at, session.swings.get(at)?))) else {
            return Ok(text.to_owned());
        };
        if std::mem::discriminant(&old.data) != std::mem::discriminant(&swing.data) {
            return Err(Error::argument(
                "files",
                format!(
                    "what the swing `{}` waits for, a {}",
                    old.id,
                    kind_of(&old.data)
                ),
                format!("a {}", kind_of(&swing.data)),
            ));
        }
        set_stated(text, place, &old.suspension, &self.hung)
    }
}

/// What new swings have of the swing that they hung like.
enum Copied {
    /// There is none.
    Nothing,
    /// Its figures as readings of their own, as it hung another way: the instruments that they were
    /// read with, by the key of the figure.
    Figures(BTreeMap<String, String>),
    /// Its readings, but for what is stated.
    Hanging(HungAs),
}

/// What is put at the end of a session. What was stated of them all is one reading: the first has
/// it, and the others hang as the first.
fn added(swings: Vec<&Swing>, recorded: Vec<Recorded>, copied: &Copied) -> Session {
    let mut added = Session {
        swings: swings.into_iter().cloned().collect(),
        recorded,
        ..Session::default()
    };
    let Some(first) = added.swings.first().map(|swing| swing.id.clone()) else {
        return added;
    };
    for swing in &added.swings[1..] {
        added
            .hung_as
            .insert(swing.id.clone(), HungAs::swing(&first));
    }
    match copied {
        Copied::Nothing => {}
        Copied::Figures(read_with) => {
            let of_first = read_with.iter();
            let keys = of_first.map(|(key, instrument)| (figure_key(0, key), instrument.clone()));
            added.read_with = keys.collect();
        }
        Copied::Hanging(hung) => {
            added.hung_as.insert(first, hung.clone());
        }
    }
    added
}

fn kind_of(data: &SwingData) -> &'static str {
    match data {
        SwingData::Recording(_) => "recording of a phone",
        SwingData::Displacement { .. } => "track",
        SwingData::Periods(_) | SwingData::PeriodsS(_) => "list of periods",
    }
}

impl Draft {
    /// Tables can be put at the end of a text only where they are not a list in one line.
    fn refuse_lists_in_line(&self, file: &str) -> Result<()> {
        match self.in_line {
            Some(list) => Err(Error::Malformed {
                file: file.to_owned(),
                line: None,
                expected: format!("each entry of `{list}` as a table of its own, [[{list}]]"),
                found: format!("`{list} = [ … ]`, to which no table can be added"),
            }),
            None => Ok(()),
        }
    }
}
