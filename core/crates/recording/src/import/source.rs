//! Where exported files come from: archives, and loose files by folder.

use std::collections::BTreeMap;

use super::{json, trials};
use crate::store::Store;
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
    /// Names and bytes in order.
    pub fn members(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.files
            .iter()
            .map(|(name, bytes)| (name.as_str(), bytes.as_slice()))
    }
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
        if json::looks_like_json(bytes) {
            sources.push(Source {
                name: name.clone(),
                archive: Some(name.clone()),
                files: json::tables(bytes, name)?,
                ignored: Vec::new(),
            });
            continue;
        }
        if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
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

/// An archive by folders: some programs put several recordings into one.
fn archive(name: &str, bytes: &[u8]) -> Result<Vec<Source>> {
    stored(&Store::from_zip_bytes(name, bytes)?)
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
    if names
        .iter()
        .any(|member| member == "[Content_Types].xml" || member.starts_with("xl/"))
    {
        return refused("an Excel workbook (xlsx); export as CSV");
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
            if !json::looks_like_json(&bytes) {
                files.push((member.clone(), bytes));
            } else if let Ok(tables) = json::tables(&bytes, &store.describe(member)) {
                files.extend(tables);
            } else {
                ignored
                    .entry(folder(member))
                    .or_default()
                    .push(member.clone());
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
    let known = ["csv", "txt", "tsv", "json", "gcsv", "log", "dat"];
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

/// File name without folders and ending.
pub(super) fn stem(name: &str) -> &str {
    let base = base(name);
    base.rsplit_once('.').map_or(base, |(stem, _)| stem)
}
