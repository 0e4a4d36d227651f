//! The one error of the core: what is wrong, and where.
//!
//! Variants are rich because a facade must be able to decide how a phone shows each of them.
//! Conversion to a smaller public error happens once, in the facade, without a catch-all arm.

use std::fmt::Display;
use std::io;

use thiserror::Error;

/// Result of everything in the core that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// What went wrong, with the place it went wrong at.
///
/// `line` counts from 1 and is absent where a file as a whole is meant.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// A file or folder cannot be opened or read.
    #[error("{file}: cannot be read: {reason}")]
    Unreadable {
        /// The file as the user knows it.
        file: String,
        /// The operating system's or decoder's reason.
        reason: String,
    },
    /// A file or folder cannot be written.
    #[error("{file}: cannot be written: {reason}")]
    Unwritable {
        /// The file as the user knows it.
        file: String,
        /// The operating system's reason, or that it exists already.
        reason: String,
    },
    /// A file cannot be written because the disk has no room left.
    #[error("{file}: cannot be written: the disk is full")]
    DiskFull {
        /// The file as the user knows it.
        file: String,
    },
    /// A file can be read but is not what its place requires (syntax, header, value, missing key
    /// …).
    #[error("{file}{}: expected {expected}, found {found}", at_line(*.line))]
    Malformed {
        /// The file as the user knows it.
        file: String,
        /// Line, from 1.
        line: Option<usize>,
        /// What was expected there, key included.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// A key the format does not know.
    #[error("{file}{}: unknown key `{key}`{}", at_line(*.line), did_you_mean(.nearest))]
    UnknownKey {
        /// The file as the user knows it.
        file: String,
        /// Line, from 1.
        line: Option<usize>,
        /// The key with its table, e.g. `swing[1].suspension.line_lenght`.
        key: String,
        /// The nearest known key.
        nearest: Option<String>,
    },
    /// An archive that must not be unpacked: a path that climbs out, a size that explodes.
    #[error("{file}: unsafe archive: {reason}")]
    UnsafeArchive {
        /// The archive.
        file: String,
        /// Which member, and why it is refused.
        reason: String,
    },
    /// The input is well formed but does not allow a result.
    #[error("{what}: {reason}")]
    NoResult {
        /// Which record, swing or quantity.
        what: String,
        /// Why there is no result.
        reason: String,
    },
    /// The caller asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// A caller gave an argument outside its domain (a programmer's or a command line's mistake).
    #[error("argument `{name}`: expected {expected}, found {found}")]
    Argument {
        /// The argument.
        name: String,
        /// The domain.
        expected: String,
        /// What was given.
        found: String,
    },
}

/// How a command or an app reacts to an [`enum@Error`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// The input cannot be read or used (exit status 2).
    Input,
    /// The data do not allow a result (exit status 1).
    NoResult,
}

impl Error {
    /// Which of the two reactions this error asks for.
    pub fn kind(&self) -> ErrorKind {
        match self {
            Error::Unreadable { .. }
            | Error::Unwritable { .. }
            | Error::DiskFull { .. }
            | Error::Malformed { .. }
            | Error::UnknownKey { .. }
            | Error::UnsafeArchive { .. }
            | Error::Argument { .. } => ErrorKind::Input,
            Error::NoResult { .. } | Error::Cancelled => ErrorKind::NoResult,
        }
    }

    /// The file that is wrong, as the user knows it, where one is.
    pub fn file(&self) -> Option<&str> {
        match self {
            Error::Unreadable { file, .. }
            | Error::Unwritable { file, .. }
            | Error::DiskFull { file }
            | Error::Malformed { file, .. }
            | Error::UnknownKey { file, .. }
            | Error::UnsafeArchive { file, .. } => Some(file),
            Error::NoResult { .. } | Error::Argument { .. } | Error::Cancelled => None,
        }
    }

    /// The line that is wrong, from 1, where one is known.
    pub fn line(&self) -> Option<usize> {
        match self {
            Error::Malformed { line, .. } | Error::UnknownKey { line, .. } => *line,
            Error::Unreadable { .. }
            | Error::Unwritable { .. }
            | Error::DiskFull { .. }
            | Error::UnsafeArchive { .. }
            | Error::NoResult { .. }
            | Error::Cancelled
            | Error::Argument { .. } => None,
        }
    }

    /// What the system says of a file that cannot be written: [`Error::DiskFull`] or
    /// [`Error::Unwritable`]. `doing` stands before the system's reason, where it is not empty.
    pub fn unwritable(file: impl Display, doing: &str, error: &io::Error) -> Self {
        let file = file.to_string();
        match error.kind() {
            // A file that may grow no further leaves the writer in the same place, and asks for the
            // same of the user.
            io::ErrorKind::StorageFull
            | io::ErrorKind::QuotaExceeded
            | io::ErrorKind::FileTooLarge => Error::DiskFull { file },
            _ if doing.is_empty() => Error::Unwritable {
                file,
                reason: error.to_string(),
            },
            _ => Error::Unwritable {
                file,
                reason: format!("{doing}: {error}"),
            },
        }
    }

    /// Shorthand for [`Error::NoResult`].
    pub fn no_result(what: impl Into<String>, reason: impl Into<String>) -> Self {
        Error::NoResult {
            what: what.into(),
            reason: reason.into(),
        }
    }

    /// Shorthand for [`Error::Argument`].
    pub fn argument(name: &str, expected: impl Into<String>, found: impl ToString) -> Self {
        Error::Argument {
            name: name.into(),
            expected: expected.into(),
            found: found.to_string(),
        }
    }
}

fn at_line(line: Option<usize>) -> String {
    line.map(|n| format!(", line {n}")).unwrap_or_default()
}

fn did_you_mean(nearest: &Option<String>) -> String {
    nearest
        .as_ref()
        .map(|key| format!("; the nearest known key is `{key}`"))
        .unwrap_or_default()
}
