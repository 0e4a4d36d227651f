//! SensorLog for iOS: one wide table, accelerations in g with the sign of iOS.
//!
//! # Conventions
//! Raw columns (`gyroRotationX`, `accelerometerAccelerationX`) are preferred to the fused ones
//! (`motion…`), whose bias is changed by the phone in mid-record. Each row repeats the last sample
//! of slower sensors with its own stamp, so that a sensor's own stamp column is used where there is
//! one.

use super::columns::{SensorColumns, assemble, gravity_doubt, xyz};
use super::imported::{Format, ImportedRecording};
use super::table::Table;
use super::units::{from_core_motion, unit_of_header};
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::Result;

/// Sensor, stem of its columns, unit in their brackets, prefix of its own stamp column; preferred
/// ones first.
const COLUMNS: [(Sensor, &str, &str, &str); 4] = [
    (
        Sensor::Gyroscope,
        "gyroRotation",
        "(rad/s)",
        "gyroTimestamp",
    ),
    (
        Sensor::Gyroscope,
        "motionRotationRate",
        "(rad/s)",
        "motionTimestamp",
    ),
    (
        Sensor::Accelerometer,
        "accelerometerAcceleration",
        "(G)",
        "accelerometerTimestamp",
    ),
    (
        Sensor::LinearAccelerometer,
        "motionUserAcceleration",
        "(G)",
        "motionTimestamp",
    ),
];

/// Reads a SensorLog table with `,`, `;` or `|`.
pub(super) fn import(bytes: &[u8], name: &str) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let mut series: Vec<(usize, RawSeries)> = Vec::new();
    let mut notes = Vec::new();
    for (sensor, stem, unit, stamp) in COLUMNS {
        if series.iter().any(|(_, raw)| raw.sensor == sensor) {
            continue;
        }
        let Some(axes) = xyz(&table, |axis| format!("{stem}{axis}{unit}")) else {
            continue;
        };
        let own = table.find(|column| column.starts_with(stamp) && column.ends_with("(s)"));
        let factor = if unit == "(G)" {
            from_core_motion([1.0; 3])[0]
        } else {
            1.0
        };
        let raw = match own {
            Some(time) => SensorColumns::new(sensor, time, axes, factor).read(&table)?,
            None => on_row_clock(&table, sensor, axes, factor)?,
        };
        notes.push(format!("{}: columns `{stem}X…`", sensor.name()));
        series.push((0, raw));
    }
    let recording = assemble(name, series)?;
    notes.extend(gravity_doubt(&recording));
    Ok(ImportedRecording::new(
        name,
        Format::SensorLog,
        recording,
        notes,
    ))
}

/// Samples on the clock of the rows, `loggingTime`, as seconds from the first row.
fn on_row_clock(table: &Table, sensor: Sensor, axes: [usize; 3], factor: f64) -> Result<RawSeries> {
    let time = table.find(|column| column.to_lowercase().starts_with("loggingtime"));
    let time = time.ok_or_else(|| {
        table.malformed(
            Some(0),
            "a column `loggingTime(txt)`",
            &format!("`{}`", table.header_text()),
        )
    })?;
    if table.header()[time]
        .split_once('(')
        .and_then(|(_, unit)| unit_of_header(unit.trim_end_matches(')')))
        .is_some()
    {
        return SensorColumns::new(sensor, time, axes, factor).read(table);
    }
    // The date column is text: read the axes on the first of them as a stand-in clock, then set the
    // true one.
    let mut raw = SensorColumns::new(sensor, axes[0], axes, factor).read(table)?;
    let stamps = table.texts_of(time)?;
    let seconds: Vec<f64> = stamps
        .iter()
        .map(|text| seconds_of_date(text).unwrap_or(f64::NAN))
        .collect();
    let start = seconds
        .iter()
        .copied()
        .find(|t| t.is_finite())
        .unwrap_or(0.0);
    for (row, t_s) in raw.row.iter().zip(&mut raw.t_s) {
        *t_s = seconds.get(*row).map_or(f64::NAN, |t| t - start);
    }
    Ok(raw)
}

/// `2024-05-06 10:27:38.103 +0200` as seconds since 1970 on the file's own clock; the zone does not
/// change in a record.
fn seconds_of_date(text: &str) -> Option<f64> {
    let (date, rest) = text.split_once([' ', 'T'])?;
    let time = rest.split([' ', '+', 'Z']).next()?;
    let mut day = date.split('-').map(|part| part.parse::<i64>().ok());
    let (year, month, day) = (day.next()??, day.next()??, day.next()??);
    let mut clock = time
        .split(':')
        .map(|part| part.replace(',', ".").parse::<f64>().ok());
    let (hour, minute, second) = (clock.next()??, clock.next()??, clock.next()??);
    let in_range =
        (0..=9999).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    in_range.then(|| {
        days_since_1970(year, month, day) as f64 * 86_400.0 + hour * 3600.0 + minute * 60.0 + second
    })
}

/// Days of the Gregorian calendar, years counted from March so that the leap day is the last.
fn days_since_1970(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let month = (month + 9) % 12;
    let day_of_year = (153 * month + 2) / 5 + day - 1;
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + day_of_year
        - 719_468
}
