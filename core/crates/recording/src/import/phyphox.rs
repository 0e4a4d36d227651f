//! phyphox, and every table whose header tells sensors, axes and units: one table per set of
//! sensors; phyphox adds `meta/` with the phone and the pauses.

mod pauses;

use std::collections::BTreeMap;

use super::columns::{add_repair, assemble, columns_not_used, gravity_doubt};
use super::imported::{Format, ImportedRecording};
use super::labels::sensors;
use super::source::{Source, base, stem};
use super::table::Table;
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::Result;
pub(super) use pauses::Pauses;

type File<'a> = (&'a str, &'a [u8]);

/// True for a header with a time column and an axis of a sensor, units told.
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
    let mut not_used = Vec::new();
    for (place, (name, bytes)) in sets.iter().enumerate() {
        let (series, left) = read_set(bytes, name, &stated)?;
        all.extend(series.into_iter().map(|raw| (place, raw)));
        not_used.push(left);
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
            .zip(not_used)
            .map(|((place, set), left)| finish(set.0, sets, of(place), &pauses, left))
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
    let left = not_used.into_iter().flatten();
    let mut recording = finish(name, sets, all, &pauses, left)?;
    if source.archive.is_none() && sets.len() > 1 {
        recording.notes.push(read_together(sets));
    }
    Ok(vec![recording])
}

/// Loose files may be of two experiments, whose clocks both start at 0.
fn read_together(sets: &[File]) -> String {
    let files: Vec<String> = sets
        .iter()
        .map(|set| format!("`{}`", base(set.0)))
        .collect();
    format!(
        "{} are read as one recording of one swing, as they hold different sensors; files of several swings are imported one by one",
        files.join(" and ")
    )
}

fn finish(
    name: &str,
    sets: &[File],
    mut series: Vec<(usize, RawSeries)>,
    pauses: &Pauses,
    left: impl IntoIterator<Item = String>,
) -> Result<ImportedRecording> {
    let not_used: Vec<String> = left
        .into_iter()
        .chain(keep_first_of_each(&mut series, sets))
        .collect();
    for (_, raw) in &mut series {
        raw.t_s.iter_mut().for_each(|t| *t = pauses.wall_s(*t));
    }
    let mut recording = assemble(name, series)?;
    if let Some(repair) = pauses.repair() {
        add_repair(&mut recording, &repair);
    }
    let notes = gravity_doubt(&recording).into_iter().collect();
    let imported = ImportedRecording::new(name, Format::Phyphox, recording, notes);
    Ok(imported.without(not_used))
}

/// The sensors of a set, and a sentence on the columns that are not used.
fn read_set(
    bytes: &[u8],
    name: &str,
    device: &BTreeMap<String, String>,
) -> Result<(Vec<RawSeries>, Option<String>)> {
    let table = Table::open(bytes, name)?;
    let columns = sensors(&table, stem(name));
    let mut series = Vec::new();
    for one in &columns {
        let mut raw = one.read(&table)?;
        raw.limit = range(device, one.sensor);
        series.push(raw);
    }
    // phyphox computes `Absolute (rad/s)` from the axes: nothing is lost.
    let computed = |column: &usize| table.name_of(*column).starts_with("Absolute");
    let computed = (0..table.header().len()).filter(computed);
    let used = columns.iter().flat_map(|one| one.used()).chain(computed);
    let left = columns_not_used(&table, used);
    Ok((series, left))
}

fn repeats_a_sensor(series: &[(usize, RawSeries)]) -> bool {
    series.iter().enumerate().any(|(i, (_, raw))| {
        series[..i]
            .iter()
            .any(|(_, other)| other.sensor == raw.sensor)
    })
}

/// Axes that hold samples.
fn fullness(raw: &RawSeries) -> usize {
    match raw.has_samples() {
        true => raw.axes.len(),
        false => 0,
    }
}

/// A second set of the same sensor (filtered, say) cannot be told from the first, which is kept; one
/// with more axes is.
fn keep_first_of_each(series: &mut Vec<(usize, RawSeries)>, sets: &[File]) -> Vec<String> {
    let mut seen: Vec<Sensor> = Vec::new();
    let mut notes = Vec::new();
    let axes: Vec<(Sensor, usize)> = series
        .iter()
        .map(|(_, raw)| (raw.sensor, fullness(raw)))
        .collect();
    let is_fullest = |raw: &RawSeries| {
        let same = axes.iter().filter(|(sensor, _)| *sensor == raw.sensor);
        same.map(|(_, count)| *count).max() == Some(fullness(raw))
    };
    series.retain(|(place, raw)| {
        let new = is_fullest(raw) && !seen.contains(&raw.sensor);
        if new {
            seen.push(raw.sensor);
        } else {
            let file = sets.get(*place).map_or("", |set| base(set.0));
            let sensor = raw.sensor.name();
            notes.push(match raw.has_samples() {
                true => format!(
                    "{sensor}: `{file}` is a second set of the same sensor and is not used; if it is a swing of its own, import it as a file by itself"
                ),
                false => format!("{sensor}: `{file}` holds no sample and is not used"),
            });
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
