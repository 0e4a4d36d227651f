//! Where exported files come from: archives, and loose files by folder.

use std::collections::BTreeMap;

use crate::store::Store;
use gyradius_base::{Error, Result};

/// The files of one folder, in an archive or loose.
pub(super) struct Source {
    /// What messages call it.
    pub name: String,
    /// The archive it is part of. A folder of an archive is one recording, whatever it holds.
    pub archive: Option<String>,
    files: Vec<(String, Vec<u8>)>,
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
pub(super) fn sources(inputs: &[(String, Vec<u8>)]) -> Result<Vec<Source>> {
    let mut sources: Vec<Source> = Vec::new();
    let mut folders: BTreeMap<String, usize> = BTreeMap::new();
    for (name, bytes) in inputs {
        if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
            sources.extend(archive(name, bytes)?);
            continue;
        }
        let place = *folders.entry(folder(name)).or_insert_with(|| {
            sources.push(Source {
                name: name.clone(),
                archive: None,
                files: Vec::new(),
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
    let store = Store::from_zip_bytes(name, bytes)?;
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
    for member in names.iter().filter(|member| is_csv(member)) {
        folders
            .entry(folder(member))
            .or_default()
            .push((member.clone(), store.read(member)?));
    }
    if folders.is_empty() {
        return refused("no CSV file");
    }
    let several = folders.len() > 1;
    let source = |(folder, files): (String, Vec<(String, Vec<u8>)>)| {
        let name = if several && !folder.is_empty() {
            format!("{name}/{folder}")
        } else {
            name.to_owned()
        };
        Source {
            name,
            archive: Some(store.name().to_owned()),
            files,
        }
    };
    Ok(folders.into_iter().map(source).collect())
}

/// Text tables; the resource forks that macOS puts beside them are none.
fn is_csv(member: &str) -> bool {
    let base = base(member);
    let ending = base.rsplit('.').next().unwrap_or_default().to_lowercase();
    matches!(ending.as_str(), "csv" | "txt" | "tsv") && !base.starts_with("._")
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

/// File name without folders.
pub(super) fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// File name without folders and ending.
pub(super) fn stem(name: &str) -> &str {
    let base = base(name);
    base.rsplit_once('.').map_or(base, |(stem, _)| stem)
}
