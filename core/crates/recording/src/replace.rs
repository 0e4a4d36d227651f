//! A file that is replaced whole.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{Result, Write};
use std::path::{Path, PathBuf};

/// Puts a file in the place of another, or where none was: a reader sees the old file or the new
/// one, never half of one, even after the power has failed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> Result<()> {
    let partial = partial_of(path);
    let mut file = File::create(&partial)?;
    file.write_all(bytes)?;
    file.sync_data()?;
    drop(file);
    fs::rename(&partial, path)?;
    // The name itself is on the disk once the folder is; systems that cannot sync a folder do it by
    // themselves.
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
    Ok(())
}

/// Where a file is written before it takes its name.
pub(crate) fn partial_of(path: &Path) -> PathBuf {
    let mut partial: OsString = path.as_os_str().to_owned();
    partial.push(".partial");
    PathBuf::from(partial)
}
