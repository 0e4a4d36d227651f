//! A criticism kept beside its session: its result as `gyradius-critique/1`, and the curves that
//! its pictures are drawn from.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

use gyradius_base::error::{Error, Result};
use gyradius_diagnosis::{Criticism, Critique, SwingTrace};
use gyradius_recording::replace_file;

const CRITIQUE: &str = "critique.json";
const TRACES: &str = "critique-traces.json";

/// Keeps a criticism in a folder, in the place of an earlier one. The result is written last: where
/// it is, the curves are.
pub fn keep_criticism(folder: impl AsRef<Path>, criticism: &Criticism) -> Result<()> {
    let folder = folder.as_ref();
    forget_criticism(folder)?;
    // JSON has no word for what is not a number.
    let is_sound = |trace: &&SwingTrace| {
        [&trace.measured, &trace.base, &trace.extended]
            .into_iter()
            .flatten()
            .all(|value| value.is_finite())
    };
    let traces: Vec<&SwingTrace> = criticism.traces.iter().filter(is_sound).collect();
    write(&folder.join(TRACES), serde_json::to_string(&traces))?;
    write_json(&folder.join(CRITIQUE), &criticism.critique)
}

/// The criticism that a folder keeps, if it keeps one; without curves where there are none.
pub fn kept_criticism(folder: impl AsRef<Path>) -> Result<Option<Criticism>> {
    let folder = folder.as_ref();
    let Some(critique) = read::<Critique>(&folder.join(CRITIQUE))? else {
        return Ok(None);
    };
    let traces = read(&folder.join(TRACES))?.unwrap_or_default();
    Ok(Some(Criticism { critique, traces }))
}

/// Takes away what is kept, if anything is.
pub(super) fn forget_criticism(folder: &Path) -> Result<()> {
    for name in [CRITIQUE, TRACES] {
        let path = folder.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(Error::unwritable(path.display(), "removing it", &error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Writes a value for people to read, too.
pub(super) fn write_json(path: &Path, value: &impl Serialize) -> Result<()> {
    write(path, serde_json::to_string_pretty(value))
}

fn write(path: &Path, text: serde_json::Result<String>) -> Result<()> {
    let file = path.display().to_string();
    let text = text.map_err(|error| Error::Unwritable {
        file: file.clone(),
        reason: error.to_string(),
    })?;
    replace_file(path, text.as_bytes()).map_err(|error| Error::unwritable(file, "", &error))
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<Option<T>> {
    let file = path.display().to_string();
    let text = match fs::read_to_string(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => {
            return Err(Error::Unreadable {
                file,
                reason: error.to_string(),
            });
        }
        Ok(text) => text,
    };
    let malformed = |error: serde_json::Error| Error::Malformed {
        file,
        line: Some(error.line()),
        expected: "what was kept of a criticism".into(),
        found: error.to_string(),
    };
    serde_json::from_str(&text).map(Some).map_err(malformed)
}
