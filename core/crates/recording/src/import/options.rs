//! What the caller knows and the files may not say.

use super::mapping::ColumnMapping;

/// The system of the phone, where a file's signs depend on it and the file does not say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Platform {
    /// Android: at rest, screen up, z = +g.
    Android,
    /// iOS: at rest, screen up, z = −g.
    Ios,
}

/// What the caller knows and the files may not say.
#[derive(Debug, Clone, Default)]
pub struct ImportOptions {
    /// Columns and units of a file of no known format. Where it is given, it is used for every
    /// file.
    pub mapping: Option<ColumnMapping>,
    /// Which of several trials in one file is meant, as the file numbers or names them.
    pub trial: Option<String>,
    /// The phone's system, for Sensor Logger files that come without their metadata.
    pub platform: Option<Platform>,
}
