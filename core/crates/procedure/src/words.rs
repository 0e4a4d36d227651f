//! Pieces of the procedure's messages.

use gyradius_base::error::Error;
use gyradius_base::message::{Argument, Message};
use gyradius_recording::Sensor;

/// Why a recording cannot be written.
pub(super) fn not_written(error: &Error) -> Message {
    match error {
        Error::DiskFull { .. } => Message::new("warn_disk", []),
        other => Message::new("warn_unwritable", [("reason", plain(other.to_string()))]),
    }
}

/// A sensor's name, a word with a key.
pub(super) fn sensor(sensor: Sensor) -> Argument {
    Argument::Word(sensor.name().replace(' ', "_"))
}

/// A number with its decimals.
pub(super) fn number(value: f64, decimals: u8) -> Argument {
    Argument::Number(value, decimals)
}

/// Words with keys, in a row.
pub(super) fn words<'a>(keys: impl Iterator<Item = &'a str>) -> Argument {
    let keys: Vec<&str> = keys.collect();
    Argument::Word(keys.join(" "))
}

/// The id of a step or a swing.
pub(super) fn id(id: impl Into<String>) -> Argument {
    Argument::Id(id.into())
}

pub(super) fn plain(text: impl Into<String>) -> Argument {
    Argument::Plain(text.into())
}
