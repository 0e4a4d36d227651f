//! Any table, its columns and units named by the caller.

use std::collections::BTreeMap;

use super::columns::{SensorColumns, assemble, gravity_doubt};
use super::imported::{Format, ImportedData, ImportedRecording};
use super::source::stem;
use super::table::Table;
use super::units::{Dimension, Unit};
use crate::csv::{TRIADS, track};
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::{Error, Result};

/// Which column of a foreign table is which of the project's, and in which unit.
///
/// # Conventions
/// Keys are those of the project's recordings: `t`; `gx,gy,gz`; `ax,ay,az` (specific force);
/// `lx,ly,lz` (gravity taken out); `y` (a rangefinder's track). Separator and decimal mark are
/// found by themselves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ColumnMapping {
    /// Foreign column by the project's name.
    pub columns: BTreeMap<String, MappedColumn>,
}

/// A foreign column.
#[derive(Debug, Clone, PartialEq)]
pub struct MappedColumn {
    /// Name in the file's header.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
}

impl ColumnMapping {
    /// A mapping from entries such as `t=Time:ms`, `gx=xGyro:deg/s`, `az=Acc Z:-g`.
    pub fn from_entries<S: AsRef<str>>(entries: impl IntoIterator<Item = S>) -> Result<Self> {
        let mut columns = BTreeMap::new();
        for entry in entries {
            let entry = entry.as_ref();
            let bad = || Error::argument("mapping", "entries such as gx=xGyro:deg/s", entry);
            let (key, rest) = entry.split_once('=').ok_or_else(bad)?;
            let (name, unit) = rest.rsplit_once(':').ok_or_else(bad)?;
            let column = MappedColumn {
                name: name.trim().to_owned(),
                unit: unit.trim().parse()?,
            };
            let wanted = dimension(key.trim()).ok_or_else(|| unknown_key(key.trim()))?;
            if column.unit.quantity != wanted {
                return Err(Error::argument(
                    "mapping",
                    format!("a unit that fits `{}`", key.trim()),
                    entry,
                ));
            }
            columns.insert(key.trim().to_owned(), column);
        }
        Ok(Self { columns })
    }
}

fn unknown_key(key: &str) -> Error {
    Error::argument(
        "mapping",
        "one of t, gx, gy, gz, ax, ay, az, lx, ly, lz, y",
        key,
    )
}

fn dimension(key: &str) -> Option<Dimension> {
    match key {
        "t" => Some(Dimension::Time),
        "gx" | "gy" | "gz" => Some(Dimension::AngularRate),
        "ax" | "ay" | "az" | "lx" | "ly" | "lz" => Some(Dimension::Acceleration),
        "y" => Some(Dimension::Length),
        _ => None,
    }
}

/// Reads a table by its mapping. A mean acceleration that contradicts its unit is an error that
/// names the likely one.
pub(super) fn import(
    bytes: &[u8],
    name: &str,
    mapping: &ColumnMapping,
) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let (time, time_unit) = place(&table, mapping, "t")?;
    let columns = |sensor: Sensor, keys: &[&str]| -> Result<SensorColumns> {
        let places = keys
            .iter()
            .map(|key| place(&table, mapping, key))
            .collect::<Result<Vec<_>>>()?;
        let (axes, factors) = places
            .into_iter()
            .map(|(column, unit)| (column, unit.factor))
            .unzip();
        Ok(SensorColumns {
            sensor,
            time,
            time_factor: time_unit.factor,
            axes,
            factors,
        })
    };
    let has = |key: &&str| mapping.columns.contains_key(*key);
    let data = if has(&"y") {
        ImportedData::Track(track(
            name,
            columns(Sensor::Displacement, &["y"])?.read(&table)?,
        )?)
    } else {
        let wanted = TRIADS.iter().filter(|triad| triad.1.iter().any(&has));
        let series = wanted
            .map(|(sensor, keys)| Ok((0, columns(*sensor, keys)?.read(&table)?)))
            .collect::<Result<Vec<(usize, RawSeries)>>>()?;
        let recording = assemble(name, series)?;
        if let Some(doubt) = gravity_doubt(&recording) {
            return Err(table.malformed(None, "accelerations in the stated unit", &doubt));
        }
        ImportedData::Recording(recording)
    };
    Ok(ImportedRecording {
        name: stem(name).to_owned(),
        format: Format::Mapped,
        data,
        notes: Vec::new(),
        not_used: Vec::new(),
    })
}

fn place(table: &Table, mapping: &ColumnMapping, key: &str) -> Result<(usize, Unit)> {
    let column = mapping
        .columns
        .get(key)
        .ok_or_else(|| Error::argument("mapping", format!("an entry for `{key}`"), "none"))?;
    if dimension(key) != Some(column.unit.quantity) {
        return Err(Error::argument(
            "mapping",
            format!("a unit that fits `{key}`"),
            &column.name,
        ));
    }
    let found = table.find(|name| name == column.name).ok_or_else(|| {
        table.malformed(
            Some(0),
            &format!("a column `{}`", column.name),
            &format!("`{}`", table.header_text()),
        )
    })?;
    Ok((found, column.unit))
}
