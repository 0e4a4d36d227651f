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
        let Some(axes) = xyz(&table, |axis| format!("{stem}{axis}{unit}")) else {
            continue;
        };
        let factor = if unit == "(G)" {
            from_core_motion([1.0; 3])[0]
        } else {
            1.0
        };
        let mut columns = SensorColumns::new(sensor, axes[0], axes, factor);
        columns.clock = clock(&table, stamp)?;
        notes.push(format!("{}: columns `{stem}X…`", sensor.name()));
        series.push((0, columns.read(&table)?));
        used.extend(columns.used());
    }
    let gravity = xyz(&table, |axis| format!("motionGravity{axis}(G)"));
    let place = |sensor: Sensor| series.iter().position(|(_, raw)| raw.sensor == sensor);
    if let (Some(free), None, Some(axes)) = (
        place(Sensor::LinearAccelerometer),
        place(Sensor::Accelerometer),
        gravity,
    ) {
        let factor = from_core_motion([1.0; 3])[0];
        let mut columns = SensorColumns::new(Sensor::Accelerometer, axes[0], axes, factor);
        columns.clock = clock(&table, "motionTimestamp")?;
        series[free].1 = sum(&series[free].1, &columns.read(&table)?);
        notes.pop();
        notes.push(
            "accelerometer: columns `motionUserAccelerationX…` plus `motionGravityX…`".to_owned(),
        );
        used.extend(columns.used());
    }
    let recording = assemble(name, series)?;
    notes.extend(gravity_doubt(&recording));
    let imported = ImportedRecording::new(name, Format::SensorLog, recording, notes);
    Ok(imported.without(columns_not_used(&table, used)))
}

/// The clock of a sensor: its own stamps, or else that of the rows, `loggingTime`.
fn clock(table: &Table, stamp: &str) -> Result<Clock> {
    let own = table.find(|column| column.starts_with(stamp) && column.ends_with("(s)"));
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
