//! A file that a session names, and where it names it.

use super::keys::Field;

/// Where the text names a file.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedFile {
    pub key: String,
    pub line: Option<usize>,
    pub file: String,
}

impl NamedFile {
    pub(crate) fn new(field: &Field<'_>, file: &str) -> Self {
        Self {
            key: field.path.clone(),
            line: field.line,
            file: file.into(),
        }
    }
}
