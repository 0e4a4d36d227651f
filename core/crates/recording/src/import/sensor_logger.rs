//! Sensor Logger: one file per sensor, columns in the order z, y, x.
//!
//! # Conventions
//! `GyroscopeUncalibrated` is preferred to `Gyroscope`, whose bias the phone re-calibrates in
//! mid-record in steps; the analysis fits a bias itself. The accelerometer is `TotalAcceleration`,
//! or else `Accelerometer` (gravity-free) plus `Gravity`. On iOS accelerations carry the opposite
//! sign unless the metadata say `standardisation=true`.

use std::collections::{BTreeMap, HashMap};

use super::columns::{SensorColumns, assemble, gravity_doubt, xyz};
use super::imported::{Format, ImportedRecording};
use super::options::{ImportOptions, Platform};
use super::source::{Source, stem};
use super::table::Table;
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::Result;

type File<'a> = (&'a str, &'a [u8]);

/// Stamps above this are Unix time: no recording lasts three years.
const UNIX_TIME_S: f64 = 1e8;

/// One recording from the sensor files of a source.
pub(super) fn import(
    source: &Source,
    files: &[File],
    metadata: &[File],
    options: &ImportOptions,
    device: &mut BTreeMap<String, String>,
) -> Result<Option<ImportedRecording>> {
    let mut stated = BTreeMap::new();
    for (name, bytes) in metadata {
        stated.extend(read_metadata(bytes, name)?);
    }
    let (sign, mut notes) = acceleration_sign(&stated, options);
    let by_name: BTreeMap<String, File> = files
        .iter()
        .map(|file| (stem(file.0).to_lowercase(), *file))
        .collect();
    let mut series: Vec<RawSeries> = Vec::new();
    series.extend(gyroscope(&by_name, &mut notes)?);
    series.extend(acceleration(&by_name, sign, &mut notes)?);
    if series.is_empty() {
        return Ok(None);
    }
    from_first_stamp(&mut series);
    let name = if source.archive.is_some() {
        source.name.as_str()
    } else {
        files[0].0
    };
    let recording = assemble(name, series.into_iter().enumerate().collect())?;
    notes.extend(gravity_doubt(&recording));
    device.extend(stated);
    Ok(Some(ImportedRecording::new(
        name,
        Format::SensorLogger,
        recording,
        notes,
    )))
}

fn read_metadata(bytes: &[u8], name: &str) -> Result<BTreeMap<String, String>> {
    let table = Table::open(bytes, name)?;
    let values = table.texts()?.into_iter().next().unwrap_or_default();
    Ok(table.header().iter().cloned().zip(values).collect())
}

/// +1 for Android's sign, −1 for that of iOS, with a note where it had to be assumed.
fn acceleration_sign(
    stated: &BTreeMap<String, String>,
    options: &ImportOptions,
) -> (f64, Vec<String>) {
    let says = |key: &str, value: &str| {
        stated
            .iter()
            .any(|(k, v)| k.eq_ignore_ascii_case(key) && v.to_lowercase().contains(value))
    };
    let stated = match (says("platform", "ios"), says("platform", "android")) {
        (true, _) => Some(Platform::Ios),
        (_, true) => Some(Platform::Android),
        _ => None,
    };
    match stated.or(options.platform) {
        Some(Platform::Ios) if says("standardisation", "true") => (1.0, Vec::new()),
        Some(Platform::Ios) => (
            -1.0,
            vec!["accelerations have the sign of iOS and are turned".to_owned()],
        ),
        Some(Platform::Android) => (1.0, Vec::new()),
        None => {
            let note = "the files do not name the phone's system: accelerations are taken to have Android's sign";
            (1.0, vec![note.to_owned()])
        }
    }
}

fn gyroscope(files: &BTreeMap<String, File>, notes: &mut Vec<String>) -> Result<Option<RawSeries>> {
    for name in ["gyroscopeuncalibrated", "gyroscope"] {
        if let Some(file) = files.get(name) {
            let raw = read(file, Sensor::Gyroscope, 1.0)?;
            if raw.t_s.len() >= 2 {
                notes.push(format!("gyroscope: `{}`", file.0));
                return Ok(Some(raw));
            }
        }
    }
    Ok(None)
}

fn acceleration(
    files: &BTreeMap<String, File>,
    sign: f64,
    notes: &mut Vec<String>,
) -> Result<Option<RawSeries>> {
    if let Some(file) = files.get("totalacceleration") {
        notes.push(format!("accelerometer: `{}`", file.0));
        return read(file, Sensor::Accelerometer, sign).map(Some);
    }
    let Some(file) = files.get("accelerometer") else {
        return Ok(None);
    };
    let free = read(file, Sensor::LinearAccelerometer, sign)?;
    let Some(gravity) = files.get("gravity") else {
        return Ok(Some(free));
    };
    let total = sum(&free, &read(gravity, Sensor::Accelerometer, sign)?);
    // Where the two are not sampled together there is nothing to add without resampling.
    if 2 * total.t_s.len() < free.t_s.len() {
        notes.push(format!(
            "`{}` has stamps of its own and is not used",
            gravity.0
        ));
        return Ok(Some(free));
    }
    notes.push(format!(
        "accelerometer: `{}` plus `{}` where their stamps agree",
        file.0, gravity.0
    ));
    Ok(Some(total))
}

/// Gravity-free acceleration plus gravity at the stamps that both have.
fn sum(free: &RawSeries, gravity: &RawSeries) -> RawSeries {
    let rows: HashMap<u64, usize> = gravity.t_s.iter().map(|t| t.to_bits()).zip(0..).collect();
    let mut total = RawSeries::new(Sensor::Accelerometer, 3);
    for (i, &t_s) in free.t_s.iter().enumerate() {
        if let Some(&j) = rows.get(&t_s.to_bits()) {
            total.push(
                i,
                t_s,
                (0..3).map(|axis| free.channels[axis][i] + gravity.channels[axis][j]),
            );
        }
    }
    total
}

fn read(file: &File, sensor: Sensor, factor: f64) -> Result<RawSeries> {
    let table = Table::open(file.1, file.0)?;
    let missing = |what: &str| {
        table.malformed(
            Some(0),
            &format!("columns {what}"),
            &format!("`{}`", table.header_text()),
        )
    };
    let axes = xyz(&table, str::to_owned).ok_or_else(|| missing("x, y and z"))?;
    let find = |wanted: &str| table.find(|column| column == wanted);
    let elapsed = find("seconds_elapsed");
    let time = elapsed
        .or_else(|| find("time"))
        .ok_or_else(|| missing("`seconds_elapsed` or `time`"))?;
    let mut columns = SensorColumns::new(sensor, time, axes, factor);
    if elapsed.is_none() {
        // `time` is in nanoseconds since 1970.
        columns.time_factor = 1e-9;
    }
    columns.read(&table)
}

/// Unix time is counted from the first stamp of all sensors, which keeps their clocks together.
fn from_first_stamp(series: &mut [RawSeries]) {
    let first = series
        .iter()
        .flat_map(|raw| raw.t_s.first().copied())
        .fold(f64::INFINITY, f64::min);
    if first > UNIX_TIME_S && first.is_finite() {
        series
            .iter_mut()
            .flat_map(|raw| &mut raw.t_s)
            .for_each(|t| *t -= first);
    }
}
