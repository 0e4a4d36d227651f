//! A read-only source of files: a folder, or a `.zip` read into memory.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::member_path::plain_member_path;
use super::unzip::{MAX_MEMBER_BYTES, MAX_MEMBERS, MAX_TOTAL_BYTES, unzip};
use gyradius_base::error::{Error, Result};

/// How deep [`Store::names`] looks into folders.
const MAX_DEPTH: usize = 8;

/// The files of a session or of an export.
///
/// # Conventions
/// Names are relative and joined by `/` on every system. Where a `.zip` keeps everything in one top
/// folder, names are relative to that folder.
#[derive(Debug, Clone)]
pub struct Store {
    name: String,
    files: Files,
}

#[derive(Debug, Clone)]
enum Files {
    Folder(PathBuf),
    Memory(BTreeMap<String, Vec<u8>>),
}

impl Store {
    /// Opens a folder, a `.zip`, or the folder around a `session.toml`.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let meta = fs::metadata(path).map_err(|e| unreadable(&name, e))?;
        if meta.is_dir() {
            return Self::open_folder(path);
        }
        if path.file_name().is_some_and(|file| file == "session.toml") {
            let folder = path
                .parent()
                .filter(|p| !p.as_os_str().is_empty())
                .unwrap_or(Path::new("."));
            return Self::open_folder(folder);
        }
        if !meta.is_file() {
            return Err(unreadable(&name, "neither a file nor a folder"));
        }
        Self::from_zip_bytes(&name, &read_limited(path, &name, MAX_TOTAL_BYTES)?)
    }

    /// A `.zip` whose bytes are at hand; `name` is what messages call it.
    pub fn from_zip_bytes(name: &str, bytes: &[u8]) -> Result<Self> {
        let members = without_top_folder(unzip(name, bytes)?);
        Ok(Self {
            name: name.into(),
            files: Files::Memory(members),
        })
    }

    /// Files at hand, by name.
    pub fn from_files(
        name: &str,
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
    ) -> Result<Self> {
        let mut members = BTreeMap::new();
        for (file, bytes) in files {
            let plain = plain_member_path(&file)
                .map_err(|found| Error::argument("files", "plain relative names", found))?;
            if members.insert(plain, bytes).is_some() {
                return Err(Error::argument(
                    "files",
                    "each name once",
                    format!("`{file}` twice"),
                ));
            }
        }
        Ok(Self {
            name: name.into(),
            files: Files::Memory(members),
        })
    }

    fn open_folder(path: &Path) -> Result<Self> {
        let root =
            fs::canonicalize(path).map_err(|e| unreadable(&path.display().to_string(), e))?;
        Ok(Self {
            name: path.display().to_string(),
            files: Files::Folder(root),
        })
    }

    /// What the user calls this source.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// A file of this source as messages name it.
    pub fn describe(&self, file: &str) -> String {
        format!("{}/{file}", self.name.trim_end_matches('/'))
    }

    /// True where the file is there (it may still prove unreadable).
    pub fn contains(&self, file: &str) -> bool {
        let Ok(plain) = plain_member_path(file) else {
            return false;
        };
        match &self.files {
            Files::Folder(root) => inside(root, &plain).is_ok_and(|path| path.is_file()),
            Files::Memory(members) => members.contains_key(&plain),
        }
    }

    /// The bytes of one file.
    pub fn read(&self, file: &str) -> Result<Vec<u8>> {
        let shown = self.describe(file);
        let plain = plain_member_path(file).map_err(|found| {
            unreadable(
                &shown,
                format!("a plain relative name was expected, found {found}"),
            )
        })?;
        match &self.files {
            Files::Folder(root) => {
                let path = inside(root, &plain).map_err(|reason| unreadable(&shown, reason))?;
                read_limited(&path, &shown, MAX_MEMBER_BYTES)
            }
            Files::Memory(members) => members
                .get(&plain)
                .cloned()
                .ok_or_else(|| unreadable(&shown, "no such file")),
        }
    }

    /// The names of all files, sorted.
    pub fn names(&self) -> Result<Vec<String>> {
        match &self.files {
            Files::Folder(root) => {
                let mut names = BTreeSet::new();
                self.collect_names(root, "", 0, &mut names)?;
                Ok(names.into_iter().collect())
            }
            Files::Memory(members) => Ok(members.keys().cloned().collect()),
        }
    }

    /// Symbolic links are passed over: a listing must not lead out of the folder or in a circle.
    fn collect_names(
        &self,
        folder: &Path,
        prefix: &str,
        depth: usize,
        names: &mut BTreeSet<String>,
    ) -> Result<()> {
        for entry in fs::read_dir(folder).map_err(|e| unreadable(&self.describe(prefix), e))? {
            let entry = entry.map_err(|e| unreadable(&self.describe(prefix), e))?;
            let (Ok(kind), Some(file)) = (
                entry.file_type(),
                entry.file_name().to_str().map(String::from),
            ) else {
                continue;
            };
            if kind.is_dir() && depth < MAX_DEPTH {
                self.collect_names(&entry.path(), &format!("{prefix}{file}/"), depth + 1, names)?;
            } else if kind.is_file() {
                names.insert(format!("{prefix}{file}"));
            }
            if names.len() > MAX_MEMBERS {
                return Err(unreadable(
                    &self.name,
                    format!("a session of more than {MAX_MEMBERS} files"),
                ));
            }
        }
        Ok(())
    }
}

fn unreadable(file: &str, reason: impl ToString) -> Error {
    Error::Unreadable {
        file: file.into(),
        reason: reason.to_string(),
    }
}

/// The path of a member, links followed, if it is still inside the folder.
fn inside(root: &Path, plain: &str) -> std::result::Result<PathBuf, String> {
    let path = fs::canonicalize(root.join(plain)).map_err(|e| e.to_string())?;
    if path.starts_with(root) {
        Ok(path)
    } else {
        Err("a link that leads out of the session".into())
    }
}

fn read_limited(path: &Path, shown: &str, limit: u64) -> Result<Vec<u8>> {
    let meta = fs::metadata(path).map_err(|e| unreadable(shown, e))?;
    if !meta.is_file() {
        return Err(unreadable(shown, "not a file"));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|e| unreadable(shown, e))?;
    file.take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| unreadable(shown, e))?;
    if bytes.len() as u64 > limit {
        return Err(unreadable(
            shown,
            format!("larger than {} MiB", limit >> 20),
        ));
    }
    Ok(bytes)
}

/// A zipped folder holds `boat/session.toml`: its names are taken relative to `boat`.
fn without_top_folder(members: BTreeMap<String, Vec<u8>>) -> BTreeMap<String, Vec<u8>> {
    let mut tops = members
        .keys()
        .map(|name| name.split_once('/').map(|(top, _)| top));
    let Some(Some(top)) = tops.next() else {
        return members;
    };
    if !tops.all(|other| other == Some(top)) {
        return members;
    }
    let skip = top.len() + 1;
    members
        .into_iter()
        .map(|(name, bytes)| (name[skip..].to_string(), bytes))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_gives_names_and_bytes() {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join("sub")).unwrap();
        fs::write(dir.path().join("a.csv"), b"1").unwrap();
        fs::write(dir.path().join("sub/b.csv"), b"2").unwrap();
        let store = Store::open(dir.path()).unwrap();
        assert_eq!(store.names().unwrap(), ["a.csv", "sub/b.csv"]);
        assert_eq!(store.read("sub/b.csv").unwrap(), b"2");
        assert!(store.contains("a.csv") && !store.contains("c.csv") && !store.contains("sub"));
    }

    #[test]
    fn a_session_toml_opens_its_folder() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("session.toml"), b"x").unwrap();
        let store = Store::open(dir.path().join("session.toml")).unwrap();
        assert_eq!(store.read("session.toml").unwrap(), b"x");
    }

    #[test]
    fn a_missing_file_and_a_folder_are_clear_errors() {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join("sub")).unwrap();
        let store = Store::open(dir.path()).unwrap();
        for name in ["gone.csv", "sub", "../x", "/etc/hostname"] {
            let message = store.read(name).unwrap_err().to_string();
            assert!(
                message.contains(name) && message.contains("cannot be read"),
                "{message}"
            );
        }
        assert!(matches!(
            Store::open(dir.path().join("gone")),
            Err(Error::Unreadable { .. })
        ));
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_folder_is_refused_and_not_listed() {
        let dir = tempfile::tempdir().unwrap();
        let outside = tempfile::NamedTempFile::new().unwrap();
        std::os::unix::fs::symlink(outside.path(), dir.path().join("link.csv")).unwrap();
        let store = Store::open(dir.path()).unwrap();
        assert!(
            store
                .read("link.csv")
                .unwrap_err()
                .to_string()
                .contains("leads out")
        );
        assert!(store.names().unwrap().is_empty() && !store.contains("link.csv"));
    }

    #[test]
    fn one_top_folder_is_taken_off_two_are_not() {
        let files = |names: &[&str]| {
            names
                .iter()
                .map(|n| (n.to_string(), vec![]))
                .collect::<BTreeMap<_, _>>()
        };
        let names = |m: BTreeMap<String, Vec<u8>>| m.into_keys().collect::<Vec<_>>();
        assert_eq!(
            names(without_top_folder(files(&["b/s.toml", "b/c/d.csv"]))),
            ["c/d.csv", "s.toml"]
        );
        assert_eq!(
            names(without_top_folder(files(&["a/x", "b/x"]))),
            ["a/x", "b/x"]
        );
        assert_eq!(
            names(without_top_folder(files(&["b/x", "y"]))),
            ["b/x", "y"]
        );
        assert!(without_top_folder(BTreeMap::new()).is_empty());
    }
}
