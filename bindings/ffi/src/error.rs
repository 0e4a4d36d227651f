//! The one place where an error of the core becomes the one that apps see.

use std::fmt;

use gyradius_core::Error;

/// What went wrong: `text` says it in a sentence, the other fields say where.
#[derive(Debug, Clone, PartialEq, uniffi::Error)]
#[uniffi::export(Display)]
pub enum GyradiusError {
    /// A file or folder cannot be read, or is not what it must be.
    BadFile {
        /// What is wrong, file and line included.
        text: String,
        /// The file as the user knows it.
        file: String,
        /// The line, from 1, where one is known.
        line: Option<u32>,
    },
    /// A file or folder cannot be written: it is there already, it may not be written.
    Unwritable {
        /// What is wrong, file included.
        text: String,
        /// The file as the user knows it.
        file: String,
    },
    /// A file cannot be written because the disk has no room left.
    DiskFull {
        /// What is wrong, file included.
        text: String,
        /// The file as the user knows it.
        file: String,
    },
    /// The input is well formed but does not allow a result.
    NoResult {
        /// What has no result, and why.
        text: String,
        /// Which record, swing or quantity.
        what: String,
    },
    /// An argument outside its domain.
    BadArgument {
        /// What was expected and what was found.
        text: String,
        /// The argument.
        name: String,
    },
    /// The work was stopped by whoever watched it.
    Cancelled {
        /// That it was.
        text: String,
    },
}

/// Result of everything here that can fail.
pub type Result<T> = std::result::Result<T, GyradiusError>;

impl From<Error> for GyradiusError {
    fn from(error: Error) -> Self {
        let text = error.to_string();
        match error {
            Error::Unreadable { file, .. } | Error::UnsafeArchive { file, .. } => Self::BadFile {
                text,
                file,
                line: None,
            },
            Error::Malformed { file, line, .. } | Error::UnknownKey { file, line, .. } => {
                Self::BadFile {
                    text,
                    file,
                    line: line.and_then(|line| line.try_into().ok()),
                }
            }
            Error::Unwritable { file, .. } => Self::Unwritable { text, file },
            Error::DiskFull { file } => Self::DiskFull { text, file },
            Error::NoResult { what, .. } => Self::NoResult { text, what },
            Error::Argument { name, .. } => Self::BadArgument { text, name },
            Error::Cancelled => Self::Cancelled { text },
        }
    }
}

impl fmt::Display for GyradiusError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadFile { text, .. }
            | Self::Unwritable { text, .. }
            | Self::DiskFull { text, .. }
            | Self::NoResult { text, .. }
            | Self::BadArgument { text, .. }
            | Self::Cancelled { text } => out.write_str(text),
        }
    }
}

impl std::error::Error for GyradiusError {}

/// An argument that this facade refuses itself.
pub fn bad_argument(name: &str, expected: &str, found: impl ToString) -> GyradiusError {
    Error::argument(name, expected, found).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn malformed(line: usize) -> Error {
        let (file, expected, found) = ("a.toml".into(), "a number".into(), "`x`".into());
        Error::Malformed {
            file,
            line: Some(line),
            expected,
            found,
        }
    }

    #[test]
    fn every_error_keeps_its_sentence_and_its_place() {
        let (file, reason) = (String::from("a.zip"), String::from("it climbs"));
        let unsafe_archive = Error::UnsafeArchive {
            file: file.clone(),
            reason: reason.clone(),
        };
        let unwritable = Error::Unwritable { file, reason };
        let place = |error: Error| {
            let text = error.to_string();
            let public = GyradiusError::from(error);
            assert_eq!(public.to_string(), text);
            match public {
                GyradiusError::BadFile { file, line, .. } => format!("{file} {line:?}"),
                GyradiusError::Unwritable { file, .. } => format!("to {file}"),
                GyradiusError::DiskFull { file, .. } => format!("no room for {file}"),
                GyradiusError::NoResult { what, .. } => format!("of {what}"),
                GyradiusError::BadArgument { name, .. } => format!("`{name}`"),
                GyradiusError::Cancelled { .. } => "stopped".into(),
            }
        };
        assert_eq!(place(malformed(7)), "a.toml Some(7)");
        assert_eq!(place(unsafe_archive), "a.zip None");
        assert_eq!(place(unwritable), "to a.zip");
        assert_eq!(place(Error::no_result("yaw", "too short")), "of yaw");
        assert_eq!(place(Error::argument("wanted", "above 0", 0)), "`wanted`");
        assert_eq!(place(Error::Cancelled), "stopped");
    }
}
