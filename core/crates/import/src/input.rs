//! Files that are handed over, and how they are to be read.

use std::fs;
use std::path::Path;

use gyradius_base::error::{Error, Result};
use gyradius_recording::Store;
use gyradius_recording::import::{ColumnMapping, ImportOptions, Input, Platform};

/// A file or a folder by the name that the user knows.
pub(crate) fn read_exported(path: &Path) -> Result<Input> {
    let file = path.display().to_string();
    if path.is_dir() {
        return Store::open(path).map(Input::Folder);
    }
    refuse_open_database(path)?;
    match fs::read(path) {
        Ok(bytes) => Ok(Input::File(file, bytes)),
        Err(error) => Err(Error::Unreadable {
            file,
            reason: error.to_string(),
        }),
    }
}

/// Until a program closes a database, its latest rows stand in the file `…-wal` beside it.
fn refuse_open_database(path: &Path) -> Result<()> {
    let mut beside = path.as_os_str().to_owned();
    beside.push("-wal");
    let holds_rows = fs::metadata(&beside).is_ok_and(|file| file.len() > 0);
    if !holds_rows {
        return Ok(());
    }
    Err(Error::Malformed {
        file: path.display().to_string(),
        line: None,
        expected: "a database that no program has open".to_owned(),
        found: format!(
            "rows in `{}`, which are not in it yet; open and close it with a program for databases",
            Path::new(&beside).display()
        ),
    })
}

/// How files are to be read, with a mapping where entries of one are given.
pub(crate) fn options(mapping: &[String], platform: Option<Platform>) -> Result<ImportOptions> {
    let mapping = (!mapping.is_empty())
        .then(|| ColumnMapping::from_entries(mapping))
        .transpose()?;
    Ok(ImportOptions {
        mapping,
        platform,
        trial: None,
    })
}
