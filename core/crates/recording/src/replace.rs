//! Files that are replaced whole, alone or several together.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Result, Write};
use std::path::{Path, PathBuf};
use std::process;

use gyradius_base::error::Error;

/// Puts a file in the place of another, or where none was: a reader sees the old file or the new
/// one, never half of one, even after the power has failed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> Result<()> {
    Partial::on_disk(path, bytes)?.take_place()
}

/// Puts several files in their places once all of them are on the disk: where one cannot be
/// written, none of the old ones is touched. Folders are made where they are missing.
pub fn replace_files(files: &[(PathBuf, &[u8])]) -> gyradius_base::error::Result<()> {
    let named = |path: &Path, error: std::io::Error| Error::unwritable(path.display(), "", &error);
    let mut partials = Vec::new();
    for (path, bytes) in files {
        let folder = path.parent().unwrap_or(Path::new(""));
        fs::create_dir_all(folder).map_err(|error| named(path, error))?;
        partials.push(Partial::on_disk(path, bytes).map_err(|error| named(path, error))?);
    }
    for (partial, (path, _)) in partials.into_iter().zip(files) {
        partial.take_place().map_err(|error| named(path, error))?;
    }
    Ok(())
}

/// A file beside its place, under a name that no other program writes to; removed unless it takes
/// its place.
pub(crate) struct Partial {
    file: Option<File>,
    path: PathBuf,
    place: PathBuf,
}

impl Partial {
    /// An empty one.
    pub fn create(place: &Path) -> Result<Self> {
        // Programs in two containers may have one number, and one that crashed leaves its file.
        let mut count = 0_u32;
        loop {
            let mut name: OsString = place.as_os_str().to_owned();
            name.push(format!(".{}-{count}.partial", process::id()));
            let path = PathBuf::from(name);
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    return Ok(Self {
                        file: Some(file),
                        path,
                        place: place.to_owned(),
                    });
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => count += 1,
                Err(error) => return Err(error),
            }
        }
    }

    /// One with these bytes, on the disk.
    fn on_disk(place: &Path, bytes: &[u8]) -> Result<Self> {
        let mut partial = Self::create(place)?;
        partial.write_all(bytes)?;
        if let Some(file) = partial.file.take() {
            file.sync_data()?;
        }
        Ok(partial)
    }

    /// Renames it to its place.
    pub fn take_place(mut self) -> Result<()> {
        // Some systems rename no open file.
        self.file = None;
        fs::rename(&self.path, &self.place)?;
        self.path.clear();
        // The name itself is on the disk once the folder is; systems that cannot sync a folder do
        // it by themselves.
        let folder = self
            .place
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
            .unwrap_or(Path::new("."));
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

impl Write for Partial {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        match &mut self.file {
            Some(file) => file.write(bytes),
            None => Err(ErrorKind::BrokenPipe.into()),
        }
    }

    fn flush(&mut self) -> Result<()> {
        self.file.as_mut().map_or(Ok(()), File::flush)
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        self.file = None;
        if !self.path.as_os_str().is_empty() {
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn two_partials_of_one_file_are_two_files() {
        let dir = tempfile::tempdir().unwrap();
        let place = dir.path().join("a.csv");
        let (mut one, mut other) = (
            Partial::create(&place).unwrap(),
            Partial::create(&place).unwrap(),
        );
        one.write_all(b"one").unwrap();
        other.write_all(b"other").unwrap();
        one.take_place().unwrap();
        assert_eq!(fs::read(&place).unwrap(), b"one");
        drop(other);
        assert_eq!(names(dir.path()), ["a.csv"]);
    }

    #[test]
    fn where_one_file_cannot_be_written_all_stay() {
        let dir = tempfile::tempdir().unwrap();
        let kept = dir.path().join("a.csv");
        fs::write(&kept, b"old").unwrap();
        // A file stands where the second one's folder would have to be.
        let barred = kept.join("b.csv");
        let files: [(PathBuf, &[u8]); 2] = [(kept.clone(), b"new"), (barred, b"new")];
        let refused = replace_files(&files).unwrap_err();
        assert!(refused.to_string().contains("b.csv"), "{refused}");
        assert_eq!(fs::read(&kept).unwrap(), b"old");
        assert_eq!(names(dir.path()), ["a.csv"]);
    }
}
