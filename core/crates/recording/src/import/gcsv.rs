//! Gyroflow's IMU log (gcsv): a preamble of `key,value` lines with the scale of every column, then
//! whole numbers.

use super::columns::{Clock, SensorColumns, assemble, columns_not_used, gravity_doubt, xyz};
use super::imported::{Format, ImportedRecording};
use super::table::Table;
use crate::samples::Sensor;
use gyradius_base::Result;
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;

/// True where the first line says so.
pub(super) fn recognises(table: &Table) -> bool {
    let first = table.preamble().first();
    first.is_some_and(|line| line.to_uppercase().ends_with("IMU LOG"))
}

/// Reads `t`, `gx,gy,gz` and, where it is there, `ax,ay,az`, each with its scale.
pub(super) fn import(bytes: &[u8], name: &str) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let stated = |key: &str| {
        let pairs = table
            .preamble()
            .iter()
            .filter_map(|line| line.split_once(','));
        pairs
            .filter(|(found, _)| found.trim() == key)
            .map(|(_, value)| value.trim())
            .next()
    };
    let scale = |key: &str| -> Result<f64> {
        let value = stated(key).and_then(|value| value.parse::<f64>().ok());
        value
            .filter(|scale| scale.is_finite() && *scale > 0.0)
            .ok_or_else(|| {
                let found = stated(key).unwrap_or("none");
                table.malformed(None, &format!("a line `{key},…` with a factor"), found)
            })
    };
    let time = table.find(|column| column == "t").ok_or_else(|| {
        let found = format!("`{}`", table.header_text());
        table.malformed(Some(0), "a column `t`", &found)
    })?;
    let sensors = [
        (Sensor::Gyroscope, "g", "gscale", 1.0),
        (Sensor::Accelerometer, "a", "ascale", STANDARD_GRAVITY_M_S2),
    ];
    let mut series = Vec::new();
    let mut used = Vec::new();
    for (sensor, prefix, key, unit) in sensors {
        if let Some(axes) = xyz(&table, |axis| format!("{prefix}{axis}")) {
            let mut columns = SensorColumns::new(sensor, time, axes, unit * scale(key)?);
            columns.clock = Clock::Number {
                column: time,
                factor: scale("tscale")?,
            };
            series.push((0, columns.read(&table)?));
            used.extend(columns.used());
        }
    }
    let recording = assemble(name, series)?;
    let mut notes: Vec<String> = gravity_doubt(&recording).into_iter().collect();
    let turned = stated("orientation").filter(|axes| *axes != "XYZ");
    notes.extend(turned.map(|axes| {
        format!("the orientation `{axes}` is not applied: the axes are the sensor's own")
    }));
    let imported = ImportedRecording::new(name, Format::Gcsv, recording, notes);
    Ok(imported.without(columns_not_used(&table, used)))
}
