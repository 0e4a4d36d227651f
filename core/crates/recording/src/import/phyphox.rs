//! phyphox: one table per set of sensors, and `meta/` with the phone and the pauses.

mod header;
mod pauses;

use std::collections::BTreeMap;

use super::columns::{SensorColumns, add_repair, assemble, gravity_doubt};
use super::imported::{Format, ImportedRecording};
use super::source::{Source, stem};
use super::table::Table;
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::Result;
use header::sensors;
use pauses::Pauses;

type File<'a> = (&'a str, &'a [u8]);

/// True for a header with a phyphox time column and a sensor with three axes.
pub(super) fn recognises(table: &Table, name: &str) -> bool {
    !sensors(table, stem(name)).is_empty()
}

/// One recording from the sets of a source. Loose sets that hold the same sensor twice are
/// recordings of their own.
pub(super) fn import(
    source: &Source,
    sets: &[File],
    times: &[File],
    devices: &[File],
    device: &mut BTreeMap<String, String>,
) -> Result<Vec<ImportedRecording>> {
    let mut stated = BTreeMap::new();
    for (name, bytes) in devices {
        stated.extend(properties(bytes, name)?);
    }
    let pauses = match times.first() {
        Some((name, bytes)) => Pauses::read(bytes, name)?,
        None => Pauses::default(),
    };
    let mut all = Vec::new();
    for (place, (name, bytes)) in sets.iter().enumerate() {
        all.extend(
            read_set(bytes, name, &stated)?
                .into_iter()
                .map(|raw| (place, raw)),
        );
    }
    device.extend(stated);
    if repeats_a_sensor(&all) && source.archive.is_none() {
        let of = |place: usize| {
            all.iter()
                .filter(|set| set.0 == place)
                .cloned()
                .collect::<Vec<_>>()
        };
        return sets
            .iter()
            .enumerate()
            .map(|(place, set)| finish(set.0, of(place), &pauses))
            .collect();
    }
    if all.is_empty() {
        return Ok(Vec::new());
    }
    let name = if source.archive.is_some() {
        source.name.as_str()
    } else {
        sets[0].0
    };
    finish(name, all, &pauses).map(|recording| vec![recording])
}

fn finish(
    name: &str,
    mut series: Vec<(usize, RawSeries)>,
    pauses: &Pauses,
) -> Result<ImportedRecording> {
    let mut notes = keep_first_of_each(&mut series);
    for (_, raw) in &mut series {
        raw.t_s.iter_mut().for_each(|t| *t = pauses.wall_s(*t));
    }
    let mut recording = assemble(name, series)?;
    if let Some(repair) = pauses.repair() {
        add_repair(&mut recording, &repair);
    }
    notes.extend(gravity_doubt(&recording));
    Ok(ImportedRecording::new(
        name,
        Format::Phyphox,
        recording,
        notes,
    ))
}

fn read_set(bytes: &[u8], name: &str, device: &BTreeMap<String, String>) -> Result<Vec<RawSeries>> {
    let table = Table::open(bytes, name)?;
    let columns: Vec<SensorColumns> = sensors(&table, stem(name));
    let read = |columns: SensorColumns| {
        let mut raw = columns.read(&table)?;
        raw.limit = range(device, columns.sensor);
        Ok(raw)
    };
    columns.into_iter().map(read).collect()
}

fn repeats_a_sensor(series: &[(usize, RawSeries)]) -> bool {
    series.iter().enumerate().any(|(i, (_, raw))| {
        series[..i]
            .iter()
            .any(|(_, other)| other.sensor == raw.sensor)
    })
}

/// A second set of the same sensor (filtered, say) cannot be told from the first, which is kept.
fn keep_first_of_each(series: &mut Vec<(usize, RawSeries)>) -> Vec<String> {
    let mut seen: Vec<Sensor> = Vec::new();
    let mut notes = Vec::new();
    series.retain(|(_, raw)| {
        let new = !seen.contains(&raw.sensor);
        if new {
            seen.push(raw.sensor);
        } else {
            notes.push(format!(
                "{}: a second set of the same sensor is not used",
                raw.sensor.name()
            ));
        }
        new
    });
    notes
}

/// `meta/device.csv`.
fn properties(bytes: &[u8], name: &str) -> Result<BTreeMap<String, String>> {
    let rows = Table::open(bytes, name)?.texts()?;
    let pair = |row: Vec<String>| {
        let mut cells = row.into_iter();
        Some((cells.next()?, cells.next()?))
    };
    Ok(rows.into_iter().filter_map(pair).collect())
}

/// The range that the phone states for a sensor: `gyroscope Range`, `accelerometer Range`,
/// `linear_acceleration Range`.
fn range(device: &BTreeMap<String, String>, sensor: Sensor) -> Option<f64> {
    let prefix = match sensor {
        Sensor::Gyroscope => "gyroscope",
        Sensor::Accelerometer => "accelerometer",
        Sensor::LinearAccelerometer => "linear",
        Sensor::Displacement | Sensor::Timer => return None,
    };
    let is_range = |key: &str| {
        let key = key.to_lowercase();
        key.starts_with(prefix) && key.ends_with("range")
    };
    let stated = device.iter().find(|(key, _)| is_range(key))?.1;
    stated
        .trim()
        .replace(',', ".")
        .parse()
        .ok()
        .filter(|range: &f64| range.is_finite() && *range > 0.0)
}
