//! The `[[recorded]]` tables of `session.toml`.

use super::domain::Domain;
use super::keys::{Field, Table};
use super::named_file::NamedFile;
use super::names::{REPAIR_KINDS, SENSORS};
use super::recorded::{Recorded, RecordedEvent, RecordedRepair, RecordedSensor};
use gyradius_base::error::Result;

pub(crate) const RECORDED: &[&str] = &[
    "file",
    "origin_ns",
    "measured_on",
    "phone",
    "logger",
    "bias",
    "sensors",
    "notes",
    "events",
    "repair",
    "repairs",
];
const SENSOR: &[&str] = &["stream", "name", "full_scale"];
const EVENT: &[&str] = &["t", "key"];
const REPAIR: &[&str] = &["from", "to", "text", "kind", "sensor", "count"];

pub(crate) fn recorded(table: &Table<'_>, files: &mut Vec<NamedFile>) -> Result<Recorded> {
    let named = table.require("file", "the recording that is meant")?;
    let file = named.file_name()?;
    files.push(NamedFile::new(&named, &file));
    let mut recorded = Recorded {
        file,
        measured_on: table.text_or_empty("measured_on")?,
        phone: table.text_or_empty("phone")?,
        logger: table.text_or_empty("logger")?,
        ..Recorded::default()
    };
    if let Some(origin) = table.get("origin_ns") {
        recorded.origin_ns = origin.whole()?;
    }
    if let Some(bias) = table.get("bias") {
        let file = bias.file_name()?;
        files.push(NamedFile::new(&bias, &file));
        recorded.bias = Some(file);
    }
    recorded.notes = table
        .get("notes")
        .map_or_else(|| Ok(Default::default()), |field| field.texts())?;
    recorded.sensors = table
        .tables("sensors", SENSOR)?
        .iter()
        .map(sensor)
        .collect::<Result<_>>()?;
    recorded.events = table
        .tables("events", EVENT)?
        .iter()
        .map(event)
        .collect::<Result<_>>()?;
    // The name of the list in sessions that were written before it had tables of its own.
    for list in ["repairs", "repair"] {
        for one in table.tables(list, REPAIR)? {
            recorded.repairs.push(repair(&one)?);
        }
    }
    Ok(recorded)
}

fn sensor(table: &Table<'_>) -> Result<RecordedSensor> {
    Ok(RecordedSensor {
        stream: table
            .require("stream", "what it measured")?
            .text()?
            .to_owned(),
        name: table.text_or_empty("name")?,
        full_scale: table.number("full_scale", Domain::FULL_SCALE)?,
    })
}

fn event(table: &Table<'_>) -> Result<RecordedEvent> {
    Ok(RecordedEvent {
        t_s: table.require("t", "when, s")?.number(Domain::TIME)?,
        key: table.require("key", "what it marks")?.text()?.to_owned(),
    })
}

fn repair(table: &Table<'_>) -> Result<RecordedRepair> {
    let choice = |key| table.get(key);
    Ok(RecordedRepair {
        kind: choice("kind")
            .map(|field| field.choice(REPAIR_KINDS))
            .transpose()?,
        sensor: choice("sensor")
            .map(|field| field.choice(SENSORS))
            .transpose()?,
        count: choice("count").map(|field| count(&field)).transpose()?,
        from_s: table.number("from", Domain::TIME)?,
        to_s: table.number("to", Domain::TIME)?,
        text: table
            .require("text", "what was found and what was done")?
            .text()?
            .to_owned(),
    })
}

fn count(field: &Field<'_>) -> Result<usize> {
    usize::try_from(field.whole()?)
        .map_err(|_| field.error("a count, 0 or above", "a negative number"))
}
