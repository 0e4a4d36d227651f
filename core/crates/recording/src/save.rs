//! A session written as a folder or as a `.zip`.

use std::collections::BTreeSet;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::load::SESSION_FILE;
use super::member_path::plain_member_path;
use super::replace::replace_files;
use super::session::Session;
use super::toml_read::parse_session;
use super::toml_write::write_session;
use gyradius_base::error::{Error, Result};

/// What happens to files that are already there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Overwrite {
    /// They stay, and writing is an error before anything is written.
    #[default]
    Refuse,
    /// They are replaced.
    Replace,
}

/// Writes a session and its recordings, by name and bytes, into a folder, which is made if it is
/// not there.
///
/// A file that the session names must be among `recordings` or in the folder already.
pub fn save_session(
    dir: impl AsRef<Path>,
    session: &Session,
    recordings: &[(String, Vec<u8>)],
    overwrite: Overwrite,
) -> Result<()> {
    save_session_with(dir, session, recordings, &[], overwrite)
}

/// As [`save_session`], and with it other files, by path and bytes: all of them are written, or
/// none.
pub fn save_session_with(
    dir: impl AsRef<Path>,
    session: &Session,
    recordings: &[(String, Vec<u8>)],
    others: &[(PathBuf, &[u8])],
    overwrite: Overwrite,
) -> Result<()> {
    let dir = dir.as_ref();
    let files = session_files(session, recordings, |name| dir.join(name).is_file())?;
    let mut all: Vec<(PathBuf, &[u8])> = files
        .iter()
        .map(|(name, bytes)| (dir.join(name), &**bytes))
        .collect();
    all.extend_from_slice(others);
    write_files(&all, overwrite)
}

/// A session and its recordings, by name and bytes, as the bytes of a `.zip`.
///
/// The same session always gives the same bytes: members carry no time.
pub fn session_zip_bytes(session: &Session, recordings: &[(String, Vec<u8>)]) -> Result<Vec<u8>> {
    let files = session_files(session, recordings, |_| false)?;
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        zip.start_file(&*name, SimpleFileOptions::default())
            .map_err(|e| unwritable(&name, e))?;
        zip.write_all(&bytes).map_err(|e| unwritable(&name, e))?;
    }
    Ok(zip
        .finish()
        .map_err(|e| unwritable("the .zip", e))?
        .into_inner())
}

/// Writes a session and its recordings as a `.zip` file.
pub fn save_session_zip(
    path: impl AsRef<Path>,
    session: &Session,
    recordings: &[(String, Vec<u8>)],
    overwrite: Overwrite,
) -> Result<()> {
    let bytes = session_zip_bytes(session, recordings)?;
    write_files(&[(path.as_ref().to_owned(), bytes.as_slice())], overwrite)
}

/// All files of a session, the recordings first: whoever finds a `session.toml` finds all that it
/// names.
fn session_files(
    session: &Session,
    recordings: &[(String, Vec<u8>)],
    is_there: impl Fn(&str) -> bool,
) -> Result<Vec<(String, Vec<u8>)>> {
    let text = write_session(session);
    let parsed = parse_session(&text, SESSION_FILE)?;
    let mut names = BTreeSet::new();
    let mut files = Vec::new();
    for (name, bytes) in recordings {
        let plain = plain_member_path(name)
            .map_err(|found| Error::argument("recordings", "plain relative names", found))?;
        if plain == SESSION_FILE || !names.insert(plain.clone()) {
            return Err(Error::argument(
                "recordings",
                "each name once",
                format!("`{name}` again"),
            ));
        }
        files.push((plain, bytes.clone()));
    }
    match parsed
        .files
        .iter()
        .find(|named| !names.contains(&named.file) && !is_there(&named.file))
    {
        Some(named) => {
            let found = format!("no `{}`, named by `{}`", named.file, named.key);
            Err(Error::argument(
                "recordings",
                "every file that the session names",
                found,
            ))
        }
        None => {
            files.push((SESSION_FILE.into(), text.into_bytes()));
            Ok(files)
        }
    }
}

fn refuse_existing(path: &Path) -> Result<()> {
    if fs::symlink_metadata(path).is_ok() {
        return Err(unwritable(
            &path.display().to_string(),
            "it exists already and is not overwritten",
        ));
    }
    Ok(())
}

/// Writes all files or none: they take their places when the last one is on the disk.
pub fn write_files(files: &[(PathBuf, &[u8])], overwrite: Overwrite) -> Result<()> {
    if overwrite == Overwrite::Refuse {
        files
            .iter()
            .try_for_each(|(path, _)| refuse_existing(path))?;
    }
    replace_files(files)
}

fn unwritable(file: &str, reason: impl ToString) -> Error {
    Error::Unwritable {
        file: file.into(),
        reason: reason.to_string(),
    }
}
