//! Ids and file names that swings get in a session, and those that are taken.

use std::collections::BTreeSet;
use std::path::Path;

use gyradius_base::error::{Error, Result};

/// A swing's place in a session.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    pub id: String,
    pub file: String,
    /// Whether the session has the swing already and lacks its recording.
    pub is_planned: bool,
}

/// Places that are taken, and those that wait for a recording.
#[derive(Debug, Default)]
pub(crate) struct Places {
    taken_ids: BTreeSet<String>,
    /// In small letters: some systems tell no others apart.
    taken_files: BTreeSet<String>,
    /// Swings without their recordings, by id and file.
    planned: Vec<(String, String)>,
    /// The planned swing that is meant, whatever the recording is called.
    meant: Option<String>,
    /// Recordings that got another id than their name.
    pub renamed: Vec<(String, String)>,
}

impl Places {
    pub fn take_id(&mut self, id: &str) {
        self.taken_ids.insert(id.to_owned());
    }

    pub fn take_file(&mut self, file: &str) {
        self.taken_files.insert(file.to_lowercase());
    }

    /// A swing whose recording is still to come.
    pub fn plan(&mut self, id: &str, file: &str) {
        self.planned.push((id.to_owned(), file.to_owned()));
    }

    /// The planned swing that the recording is of; there can be but one recording then.
    pub fn mean(&mut self, id: &str) -> Result<()> {
        if self.planned.iter().any(|(planned, _)| planned == id) {
            self.meant = Some(id.to_owned());
            return Ok(());
        }
        let waiting: Vec<&str> = self.planned.iter().map(|(id, _)| id.as_str()).collect();
        let expected = match waiting.is_empty() {
            true => "a swing that has no recording yet; there is none, and a new swing needs no id"
                .to_owned(),
            false => format!("a swing that has no recording yet: {}", waiting.join(", ")),
        };
        Err(Error::argument("swing", expected, format!("`{id}`")))
    }

    /// The place of a recording: the planned swing that is meant, or whose id or file has its name,
    /// or a new one. A recording may have a file for the bias beside it.
    pub fn of(&mut self, name: &str, with_bias: bool) -> Result<Place> {
        let wanted = plain(name);
        let planned = match &self.meant {
            Some(meant) => self.planned.iter().position(|(id, _)| id == meant),
            None => {
                let by_id = self.planned.iter().position(|(id, _)| plain(id) == wanted);
                by_id.or_else(|| {
                    let is_it = |file: &str| {
                        let stem = Path::new(file).file_stem().unwrap_or_default();
                        plain(&stem.to_string_lossy()) == wanted
                    };
                    self.planned.iter().position(|(_, file)| is_it(file))
                })
            }
        };
        if let Some(planned) = planned {
            let (id, file) = self.planned.remove(planned);
            return Ok(Place {
                id,
                file,
                is_planned: true,
            });
        }
        if let Some(meant) = &self.meant {
            return Err(Error::argument(
                "swing",
                format!("one recording, of the swing `{meant}`"),
                "several; import each by itself",
            ));
        }
        Ok(self.free(wanted, with_bias))
    }

    /// The name, with a number where its id or its files are taken.
    fn free(&mut self, plain: String, with_bias: bool) -> Place {
        let mut number = 1;
        loop {
            let id = match number {
                1 => plain.clone(),
                _ => format!("{plain}-{number}"),
            };
            let bias = with_bias.then(|| format!("{id}-bias.csv"));
            let file = format!("{id}.csv");
            let files: Vec<&String> = std::iter::once(&file).chain(&bias).collect();
            let is_free = |file: &&String| !self.taken_files.contains(&file.to_lowercase());
            if !self.taken_ids.contains(&id) && files.iter().all(is_free) {
                self.take_id(&id);
                files.into_iter().for_each(|file| self.take_file(file));
                if number > 1 {
                    self.renamed.push((plain, id.clone()));
                }
                return Place {
                    id,
                    file,
                    is_planned: false,
                };
            }
            number += 1;
        }
    }
}

/// A name of letters, digits, `-` and `_`.
fn plain(name: &str) -> String {
    let plain = |c: char| match c {
        c if c.is_alphanumeric() || c == '_' => c,
        _ => '-',
    };
    if name.is_empty() {
        return "recording".to_owned();
    }
    name.chars().map(plain).collect()
}
