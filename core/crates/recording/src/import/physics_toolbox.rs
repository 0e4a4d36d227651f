//! Physics Toolbox: one table of all sensors, accelerations in g.

use super::columns::{Clock, SensorColumns, assemble, columns_not_used, gravity_doubt, xyz};
use super::imported::{Format, ImportedRecording};
use super::table::Table;
use crate::samples::Sensor;
use gyradius_base::Result;
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;

/// Reads `time` (s, or a time of day) with `gFx…` (g), `wx…` (rad/s) and `ax…` (gravity-free, m/s²). Repeated stamps are
/// left to the repairs.
pub(super) fn import(bytes: &[u8], name: &str) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let sensors = [
        (Sensor::Gyroscope, "w", 1.0),
        (Sensor::Accelerometer, "gF", STANDARD_GRAVITY_M_S2),
        (Sensor::LinearAccelerometer, "a", 1.0),
    ];
    let time = table
        .find(|column| column.eq_ignore_ascii_case("time"))
        .ok_or_else(|| {
            table.malformed(
                Some(0),
                "a column `time`",
                &format!("`{}`", table.header_text()),
            )
        })?;
    let clock = Clock::of_column(&table, time)?;
    let mut series = Vec::new();
    let mut used = Vec::new();
    for (sensor, prefix, factor) in sensors {
        if let Some(axes) = xyz(&table, |axis| format!("{prefix}{axis}")) {
            let mut columns = SensorColumns::new(sensor, time, axes, factor);
            columns.clock = clock;
            series.push((0, columns.read(&table)?));
            used.extend(columns.used());
        }
    }
    let recording = assemble(name, series)?;
    let notes = gravity_doubt(&recording).into_iter().collect();
    let imported = ImportedRecording::new(name, Format::PhysicsToolbox, recording, notes);
    Ok(imported.without(columns_not_used(&table, used)))
}
