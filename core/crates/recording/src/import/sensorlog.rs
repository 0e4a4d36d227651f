//! SensorLog for iOS: one wide table, accelerations in g with the sign of iOS.
//!
//! # Conventions
//! Raw columns (`gyroRotationX`, `accelerometerAccelerationX`) are preferred to the fused ones
//! (`motion…`), whose bias is changed by the phone in mid-record. Each row repeats the last sample
//! of slower sensors with its own stamp, so that a sensor's own stamp column is used where there is
//! one. Without raw accelerations, gravity is put back: `motionUserAcceleration` plus
//! `motionGravity`.

use super::columns::{Clock, SensorColumns, assemble, columns_not_used, gravity_doubt, sum, xyz};
use super::imported::{Format, ImportedRecording};
use super::table::Table;
use super::units::from_core_motion;
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
    let mut used = Vec::new();
    for (sensor, stem, unit, stamp) in COLUMNS {
        if series.iter().any(|(_, raw)| raw.sensor == sensor) {
            continue;
        }
        let Some(axes) = axes_of(&table, stem, unit) else {
            continue;
        };
        let factor = if unit == "(G)" {
            from_core_motion([1.0; 3])[0]
        } else {
            1.0
        };
        let mut columns = SensorColumns::new(sensor, axes[0], axes, factor);
        columns.clock = clock(&table, stamp)?;
        let raw = columns.read(&table)?;
        if !raw.has_samples() {
            let sensor = sensor.name();
            notes.push(format!("{sensor}: columns `{stem}X…` hold no sample"));
            continue;
        }
        notes.push(format!("{}: columns `{stem}X…`", sensor.name()));
        series.push((0, raw));
        used.extend(columns.used());
    }
    let gravity = axes_of(&table, "motionGravity", "(G)");
    let place = |sensor: Sensor| series.iter().position(|(_, raw)| raw.sensor == sensor);
    if let (Some(free), None, Some(axes)) = (
        place(Sensor::LinearAccelerometer),
        place(Sensor::Accelerometer),
        gravity,
    ) {
        let factor = from_core_motion([1.0; 3])[0];
        let mut columns = SensorColumns::new(Sensor::Accelerometer, axes[0], axes, factor);
        columns.clock = clock(&table, "motionTimestamp")?;
        let gravity = columns.read(&table)?;
        if gravity.has_samples() {
            series[free].1 = sum(&series[free].1, &gravity);
            notes.pop();
            let parts = "columns `motionUserAccelerationX…` plus `motionGravityX…`";
            notes.push(format!("accelerometer: {parts}"));
            used.extend(columns.used());
        }
    }
    let recording = assemble(name, series)?;
    notes.extend(gravity_doubt(&recording));
    let imported = ImportedRecording::new(name, Format::SensorLog, recording, notes);
    Ok(imported.without(columns_not_used(&table, used)))
}

/// Columns with their unit, or without it as in JSON.
fn axes_of(table: &Table, stem: &str, unit: &str) -> Option<[usize; 3]> {
    xyz(table, |axis| format!("{stem}{axis}{unit}"))
        .or_else(|| xyz(table, |axis| format!("{stem}{axis}")))
}

/// The clock of a sensor: its own stamps, or else that of the rows, `loggingTime`.
fn clock(table: &Table, stamp: &str) -> Result<Clock> {
    let is_seconds = |column: &str| column.ends_with("(s)") || column.ends_with("_sinceReboot");
    let own = table.find(|column| column.starts_with(stamp) && is_seconds(column));
    if let Some(column) = own {
        return Ok(Clock::Number {
            column,
            factor: 1.0,
        });
    }
    let time = table.find(|column| column.to_lowercase().starts_with("loggingtime"));
    let time = time.ok_or_else(|| {
        table.malformed(
            Some(0),
            "a column `loggingTime(txt)`",
            &format!("`{}`", table.header_text()),
        )
    })?;
    Clock::of_column(table, time)
}
