//! Which program wrote a table, told by its header.

use super::phyphox;
use super::source::Source;
use super::table::Table;
use gyradius_base::{Error, Result};

/// What one file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    Native,
    Phyphox,
    PhyphoxTime,
    PhyphoxDevice,
    SensorLogger,
    SensorLoggerMetadata,
    PhysicsToolbox,
    SensorLog,
    LightGate,
    Unknown,
}

/// Every file of a source with what it holds. A file that is no table is an error when it is the
/// only one.
pub(super) fn contents(source: &Source) -> Result<Vec<(&str, &[u8], Content)>> {
    let alone = source.members().count() == 1;
    let mut out = Vec::new();
    for (name, bytes) in source.members() {
        let content = match Table::open(bytes, name) {
            Ok(table) => content(&table, name),
            Err(error) if alone || source.archive.is_none() => return Err(error),
            Err(_) => Content::Unknown,
        };
        out.push((name, bytes, content));
    }
    Ok(out)
}

fn content(table: &Table, name: &str) -> Content {
    let header: Vec<String> = table
        .header()
        .iter()
        .map(|name| name.to_lowercase())
        .collect();
    let has = |wanted: &str| header.iter().any(|name| name == wanted);
    let starts = |wanted: &str| header.iter().any(|name| name.starts_with(wanted));
    if has("t") {
        Content::Native
    } else if has("event time") && has("state at a") {
        Content::LightGate
    } else if has("event") && has("experiment time") {
        Content::PhyphoxTime
    } else if has("property") && has("value") {
        Content::PhyphoxDevice
    } else if has("seconds_elapsed") {
        Content::SensorLogger
    } else if has("platform") && (has("standardisation") || has("device name")) {
        Content::SensorLoggerMetadata
    } else if starts("accelerometeraccelerationx(")
        || starts("gyrorotationx(")
        || starts("motionrotationratex(")
    {
        Content::SensorLog
    } else if has("time") && (has("gfx") || has("wx")) {
        Content::PhysicsToolbox
    } else if phyphox::recognises(table, name) {
        Content::Phyphox
    } else {
        Content::Unknown
    }
}

/// The error for a source in which nothing was recognised.
pub(super) fn unknown(source: &Source) -> Result<Error> {
    let contents = contents(source)?;
    let headers = contents.iter().filter_map(|(name, bytes, _)| {
        let table = Table::open(bytes, name).ok()?;
        Some(format!("`{}`", table.header_text()))
    });
    let found = headers.take(3).collect::<Vec<_>>().join(", ");
    Ok(Error::Malformed {
        file: source.name.clone(),
        line: None,
        expected:
            "an export of phyphox, Sensor Logger, Physics Toolbox, SensorLog or a light gate, or a column \
                   mapping that names its columns"
                .to_owned(),
        found: if found.is_empty() { "no CSV file".to_owned() } else { format!("the header {found}") },
    })
}
