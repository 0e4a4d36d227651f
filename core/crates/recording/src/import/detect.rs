//! Which program wrote a table, told by its header.

use super::labels;
use super::source::Source;
use super::table::Table;
use super::{gcsv, labelled, phyphox, sensor_logger};
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
    Gcsv,
    Track,
    Periods,
    Channel,
    /// One channel that the words and the units of its header tell.
    Labelled,
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

pub(super) fn content(table: &Table, name: &str) -> Content {
    let header: Vec<String> = table
        .header()
        .iter()
        .map(|name| name.to_lowercase())
        .collect();
    let has = |wanted: &str| header.iter().any(|name| name == wanted);
    let starts = |wanted: &str| header.iter().any(|name| name.starts_with(wanted));
    let only = |names: [&str; 2]| header.len() == 2 && names.into_iter().all(has);
    let axes = crate::samples::TRIADS.iter().flat_map(|triad| triad.1);
    if gcsv::recognises(table) {
        Content::Gcsv
    } else if has("t") && axes.into_iter().any(has) {
        Content::Native
    } else if only(["t", "y"]) {
        Content::Track
    } else if only(["t", "period"]) {
        Content::Periods
    } else if only(["t", "angle"]) || only(["t", "rate"]) {
        Content::Channel
    } else if has("event time") && has("state at a") {
        Content::LightGate
    } else if has("event") && has("experiment time") {
        Content::PhyphoxTime
    } else if has("property") && has("value") {
        Content::PhyphoxDevice
    } else if sensor_logger::recognises(table, name) {
        Content::SensorLogger
    } else if has("platform") && (has("standardisation") || has("device name")) {
        Content::SensorLoggerMetadata
    } else if starts("accelerometeraccelerationx")
        || starts("gyrorotationx")
        || starts("motionrotationratex")
    {
        Content::SensorLog
    } else if has("time") && (has("gfx") || has("wx")) {
        Content::PhysicsToolbox
    } else if phyphox::recognises(table, name) {
        Content::Phyphox
    } else if labelled::recognises(table) {
        Content::Labelled
    } else {
        Content::Unknown
    }
}

/// The error for a source in which nothing was recognised: what it holds, and the mapping that it
/// suggests.
pub(super) fn unknown(source: &Source) -> Result<Error> {
    let contents = contents(source)?;
    let tables = contents
        .iter()
        .filter_map(|(name, bytes, _)| Table::open(bytes, name).ok());
    let mut found = Vec::new();
    let mut proposed = None;
    for table in tables.take(3) {
        found.push(if table.is_named() {
            format!("the header `{}`", table.header_text())
        } else {
            format!("{} columns without a header", table.header().len())
        });
        proposed = proposed.or_else(|| labels::proposal(&table));
    }
    let way_out = match proposed {
        Some(entries) => format!(
            "a column mapping that names its columns, for example (check columns and units; words in capitals are yours to fill in): {entries}"
        ),
        None => {
            "a column mapping that names its columns (--map t=…:s --map gx=…:rad/s …)".to_owned()
        }
    };
    Ok(Error::Malformed {
        file: source.name.clone(),
        line: None,
        expected: format!(
            "an export of phyphox, Sensor Logger, Physics Toolbox, SensorLog, Gyroflow or a light \
             gate, or {way_out}"
        ),
        found: if found.is_empty() {
            "no table".to_owned()
        } else {
            found.join(", ")
        },
    })
}
