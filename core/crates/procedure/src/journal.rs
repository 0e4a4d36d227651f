//! The journal: one line for each thing that was decided, appended and synced, readable whatever
//! happens to its end.
//!
//! # Conventions
//! A line is the CRC-32 (ISO-HDLC, eight hexadecimal digits) of what follows it, a space, the
//! line's number from 0, a space, and one entry as JSON. Whatever stands behind the last whole line
//! is cut off when the journal is opened again.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::Path;

use super::entry::Entry;
use gyradius_base::error::{Error, Result};
use gyradius_recording::replace_file;

/// Its file in the procedure's folder.
pub(super) const JOURNAL: &str = "procedure.journal";

/// A journal that is being written.
pub(super) struct Journal {
    file: File,
    name: String,
    lines: usize,
}

/// What a journal held when it was opened.
pub(super) struct Opened {
    pub journal: Journal,
    pub entries: Vec<Entry>,
    /// Bytes at its end that were no whole line.
    pub cut_bytes: usize,
}

impl Journal {
    /// Makes a journal with its first entry, which is there whole or not at all. One that holds no
    /// whole line is replaced; any other is an [`Error::Unwritable`].
    pub fn create(folder: &Path, first: &Entry) -> Result<Self> {
        let path = folder.join(JOURNAL);
        let name = path.display().to_string();
        let fail = |doing: &str, error: &std::io::Error| Error::unwritable(&name, doing, error);
        fs::create_dir_all(folder).map_err(|error| fail("making the folder", &error))?;
        if fs::read(&path).is_ok_and(|bytes| !read(&bytes).0.is_empty()) {
            let reason = "a procedure has begun there already".to_owned();
            return Err(Error::Unwritable { file: name, reason });
        }
        replace_file(&path, &line(0, first, &name)?).map_err(|error| fail("making it", &error))?;
        let opened = OpenOptions::new().append(true).open(&path);
        let file = opened.map_err(|error| fail("opening it", &error))?;
        Ok(Self {
            file,
            name,
            lines: 1,
        })
    }

    /// Opens a journal and cuts off what is not whole. Fails with [`Error::Unreadable`], and with
    /// [`Error::Malformed`] where not even its first line is whole.
    pub fn open(folder: &Path) -> Result<Opened> {
        let path = folder.join(JOURNAL);
        let name = path.display().to_string();
        let bytes = fs::read(&path).map_err(|error| Error::Unreadable {
            file: name.clone(),
            reason: error.to_string(),
        })?;
        let (entries, whole) = read(&bytes);
        if entries.is_empty() {
            let expected = "a procedure's journal".to_owned();
            return Err(Error::Malformed {
                file: name,
                line: Some(1),
                expected,
                found: "no whole line".into(),
            });
        }
        let fail = |doing: &str, error: &std::io::Error| Error::unwritable(&name, doing, error);
        let opened = OpenOptions::new().append(true).open(&path);
        let file = opened.map_err(|error| fail("opening it", &error))?;
        file.set_len(whole as u64)
            .map_err(|error| fail("cutting off an incomplete line", &error))?;
        let journal = Self {
            file,
            name,
            lines: entries.len(),
        };
        Ok(Opened {
            journal,
            entries,
            cut_bytes: bytes.len() - whole,
        })
    }

    /// Appends an entry and syncs it. Fails with [`Error::Unwritable`] or [`Error::DiskFull`]; half
    /// a line is taken back.
    pub fn append(&mut self, entry: &Entry) -> Result<()> {
        let bytes = line(self.lines, entry, &self.name)?;
        let before = self.file.metadata().map(|meta| meta.len());
        let written = self
            .file
            .write_all(&bytes)
            .and_then(|()| self.file.sync_data());
        if let Err(error) = written {
            if let Ok(length) = before {
                // Where this fails too, opening cuts the half line off.
                let _ = self.file.set_len(length);
            }
            return Err(Error::unwritable(&self.name, "appending a line", &error));
        }
        self.lines += 1;
        Ok(())
    }
}

fn line(number: usize, entry: &Entry, name: &str) -> Result<Vec<u8>> {
    let json = serde_json::to_string(entry).map_err(|error| Error::Unwritable {
        file: name.to_owned(),
        reason: error.to_string(),
    })?;
    let body = format!("{number} {json}");
    Ok(format!("{:08x} {body}\n", crc32fast::hash(body.as_bytes())).into_bytes())
}

/// The entries of all whole lines up to the first that is not, and where the last of them ends.
fn read(bytes: &[u8]) -> (Vec<Entry>, usize) {
    let mut entries = Vec::new();
    let mut whole = 0;
    for line in bytes.split_inclusive(|byte| *byte == b'\n') {
        let Some(entry) = parsed(line, entries.len()) else {
            break;
        };
        entries.push(entry);
        whole += line.len();
    }
    (entries, whole)
}

fn parsed(line: &[u8], number: usize) -> Option<Entry> {
    let line = std::str::from_utf8(line.strip_suffix(b"\n")?).ok()?;
    let (sum, body) = line.split_once(' ')?;
    let right = u32::from_str_radix(sum, 16).ok()? == crc32fast::hash(body.as_bytes());
    let (place, json) = body.split_once(' ')?;
    let entry = right.then_some(json)?;
    if place.parse() != Ok(number) {
        return None;
    }
    serde_json::from_str(entry).ok()
}
