//! Where exported files come from: archives, and loose files by folder.

use std::collections::BTreeMap;

use super::{json, sqlite, trials, workbook};
use crate::recorder::NamedTables;
use crate::store::Store;
use crate::unzip::{gunzip, is_gzip};
use gyradius_base::{Error, Result};

/// The files of one folder, in an archive or loose.
pub(super) struct Source {
    /// What messages call it.
    pub name: String,
    /// The archive it is part of. A folder of an archive is one recording, whatever it holds.
    pub archive: Option<String>,
    files: Vec<(String, Vec<u8>)>,
    /// Members of the archive that are no tables.
    pub ignored: Vec<String>,
}

/// What is handed over to be imported.
#[derive(Debug, Clone)]
pub enum Input {
    /// A file by name and bytes.
    File(String, Vec<u8>),
    /// A folder as an app exported it, or an unpacked archive.
    Folder(Store),
}

impl Source {
    /// The tables of one file that holds several.
    fn archived(name: &str, files: Vec<(String, Vec<u8>)>) -> Self {
        Self {
            name: name.to_owned(),
            archive: Some(name.to_owned()),
            files,
            ignored: Vec::new(),
        }
    }

    /// Names and bytes in order.
    pub fn members(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.files
            .iter()
            .map(|(name, bytes)| (name.as_str(), bytes.as_slice()))
    }
}

fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

/// Archives by themselves; loose files together with those of the same folder.
pub(super) fn sources(inputs: &[Input]) -> Result<Vec<Source>> {
    let mut sources: Vec<Source> = Vec::new();
    let mut folders: BTreeMap<String, usize> = BTreeMap::new();
    for input in inputs {
        let (name, bytes) = match input {
            Input::File(name, bytes) => (name, bytes),
            Input::Folder(store) => {
                sources.extend(stored(store)?);
                continue;
            }
        };
        let unpacked;
        let (name, bytes) = match is_gzip(bytes) {
            true => {
                unpacked = (plain_name(name), gunzip(name, bytes)?);
                (&unpacked.0, &unpacked.1)
            }
            false => (name, bytes),
        };
        if let Some(tables) = tables_inside(bytes, name) {
            sources.push(Source::archived(name, tables?));
            continue;
        }
        if is_zip(bytes) {
            sources.extend(archive(name, bytes)?);
            continue;
        }
        let place = *folders.entry(folder(name)).or_insert_with(|| {
            sources.push(Source {
                name: name.clone(),
                archive: None,
                files: Vec::new(),
                ignored: Vec::new(),
            });
            sources.len() - 1
        });
        if sources[place].members().any(|(other, _)| other == name) {
            return Err(Error::argument(
                "inputs",
                "each file once, told apart by its folder",
                format!("`{name}` twice"),
            ));
        }
        sources[place].files.push((name.clone(), bytes.clone()));
    }
    Ok(sources)
}

/// The name of a file without what says that it was compressed.
fn plain_name(name: &str) -> String {
    let ending = name.len().saturating_sub(".gz".len());
    match name.get(ending..) {
        Some(end) if end.eq_ignore_ascii_case(".gz") => name[..ending].to_owned(),
        _ => name.to_owned(),
    }
}

/// An archive by folders: some programs put several recordings into one.
fn archive(name: &str, bytes: &[u8]) -> Result<Vec<Source>> {
    let store = Store::from_zip_bytes(name, bytes)?;
    if workbook::is_workbook(&store.names()?) {
        return Ok(vec![Source::archived(name, workbook::tables(bytes, name)?)]);
    }
    stored(&store)
}

/// The tables of a file that holds several, archives apart; `None` where it is none of that.
fn tables_inside(bytes: &[u8], name: &str) -> Option<Result<NamedTables>> {
    if json::looks_like_json(bytes) {
        Some(json::tables(bytes, name))
    } else if sqlite::looks_like_sqlite(bytes) {
        Some(sqlite::tables(bytes, name))
    } else {
        None
    }
}

/// An archive or a folder by its folders.
fn stored(store: &Store) -> Result<Vec<Source>> {
    let name = store.name();
    let names = store.names()?;
    let refused = |found: &str| {
        Err(Error::Malformed {
            file: name.to_owned(),
            line: None,
            expected: "exported CSV files".to_owned(),
            found: found.to_owned(),
        })
    };
    if workbook::is_workbook(&names) {
        return refused("an unpacked Excel workbook (xlsx); hand over the file itself");
    }
    if names.iter().any(|member| member == "session.toml") {
        return refused("a session, which needs no import");
    }
    let mut folders: BTreeMap<String, Vec<(String, Vec<u8>)>> = BTreeMap::new();
    let mut ignored: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for member in &names {
        let shadow = base(member).starts_with("._") || base(member) == ".DS_Store";
        if is_table(member) {
            let bytes = store.read(member)?;
            let files = folders.entry(folder(member)).or_default();
            let shown = store.describe(member);
            let inside = match is_zip(&bytes) {
                true => Some(workbook::tables(&bytes, &shown)),
                false => tables_inside(&bytes, &shown),
            };
            match inside {
                None => files.push((member.clone(), bytes)),
                Some(Ok(tables)) => files.extend(tables),
                Some(Err(_)) => ignored
                    .entry(folder(member))
                    .or_default()
                    .push(member.clone()),
            }
        } else if !shadow {
            ignored
                .entry(folder(member))
                .or_default()
                .push(member.clone());
        }
    }
    if folders.is_empty() {
        return refused("no CSV file");
    }
    let several = folders.len() > 1;
    let mut source = |(folder, files): (String, Vec<(String, Vec<u8>)>)| {
        let name = if several && !folder.is_empty() {
            format!("{name}/{folder}")
        } else {
            name.to_owned()
        };
        Source {
            name,
            archive: Some(store.name().to_owned()),
            files,
            ignored: ignored.remove(&folder).unwrap_or_default(),
        }
    };
    let mut sources: Vec<Source> = folders.into_iter().map(&mut source).collect();
    // Folders without a table.
    if let Some(last) = sources.last_mut() {
        last.ignored.extend(ignored.into_values().flatten());
    }
    Ok(sources)
}

/// Text tables; the resource forks that macOS puts beside them are none.
fn is_table(member: &str) -> bool {
    let base = base(member);
    let ending = base.rsplit('.').next().unwrap_or_default().to_lowercase();
    let known = [
        "csv", "txt", "tsv", "json", "gcsv", "log", "dat", "sqlite", "sqlite3", "db", "xlsx",
    ];
    known.contains(&ending.as_str()) && !base.starts_with("._")
}

/// The folder of a loose file; phyphox's `meta` belongs to the folder around it.
fn folder(name: &str) -> String {
    let parts: Vec<&str> = name.split(['/', '\\']).collect();
    let mut folders = &parts[..parts.len() - 1];
    if folders.last() == Some(&"meta") {
        folders = &folders[..folders.len() - 1];
    }
    folders.join("/")
}

/// Keeps the rows of one trial in every table that holds several; false where none does.
pub(super) fn keep_trial(sources: &mut [Source], trial: &str) -> Result<bool> {
    let mut any = false;
    for (name, bytes) in sources.iter_mut().flat_map(|source| &mut source.files) {
        if let Some(chosen) = trials::choose(bytes, name, trial)? {
            *bytes = chosen;
            any = true;
        }
    }
    Ok(any)
}

/// File name without folders.
pub(super) fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// The same without the number that a browser puts behind a second copy: `Gyroscope (1)`.
pub(super) fn stem_of_copy(name: &str) -> &str {
    let stem = stem(name);
    let number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    match stem
        .strip_suffix(')')
        .and_then(|bare| bare.rsplit_once(" ("))
    {
        Some((bare, copy)) if number(copy) => bare,
        _ => stem,
    }
}

/// File name without folders and ending.
pub(super) fn stem(name: &str) -> &str {
    let base = base(name);
    base.rsplit_once('.').map_or(base, |(stem, _)| stem)
}
