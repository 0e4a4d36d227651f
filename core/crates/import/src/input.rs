//! Files that are handed over, and how they are to be read.

use std::fs;
use std::path::Path;

use gyradius_base::error::{Error, Result};
use gyradius_recording::import::{ColumnMapping, ImportOptions, Platform};

/// A file by the name that the user knows.
pub(crate) fn read_input(path: &Path) -> Result<(String, Vec<u8>)> {
    let file = path.display().to_string();
    match fs::read(path) {
        Ok(bytes) => Ok((file, bytes)),
        Err(error) => Err(Error::Unreadable {
            file,
            reason: error.to_string(),
        }),
    }
}

/// How files are to be read, with a mapping where entries of one are given.
pub(crate) fn options(mapping: &[String], platform: Option<Platform>) -> Result<ImportOptions> {
    let mapping = (!mapping.is_empty())
        .then(|| ColumnMapping::from_entries(mapping))
        .transpose()?;
    Ok(ImportOptions { mapping, platform })
}
