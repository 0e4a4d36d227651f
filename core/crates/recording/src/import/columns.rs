//! One sensor's columns of a table, read and brought to the core's units.

use super::table::Table;
use crate::csv::collect;
use crate::repair::RawSeries;
use crate::samples::{Recording, Repair, Sensor};
use gyradius_base::Result;

/// Where a sensor's samples stand, and the factors to s and to the core's unit.
#[derive(Debug, Clone)]
pub(super) struct SensorColumns {
    pub sensor: Sensor,
    pub time: usize,
    pub time_factor: f64,
    pub axes: Vec<usize>,
    pub factors: Vec<f64>,
}

impl SensorColumns {
    /// Columns in s and in one unit on all axes.
    pub fn new(sensor: Sensor, time: usize, axes: [usize; 3], factor: f64) -> Self {
        Self {
            sensor,
            time,
            time_factor: 1.0,
            axes: axes.to_vec(),
            factors: vec![factor; 3],
        }
    }

    /// Reads the samples; `NaN` in every axis at the end of a column is padding to a longer one
    /// beside it.
    pub fn read(&self, table: &Table) -> Result<RawSeries> {
        let columns: Vec<usize> = std::iter::once(self.time)
            .chain(self.axes.iter().copied())
            .collect();
        let numbers = table.numbers(&columns)?;
        let places: Vec<usize> = (1..columns.len()).collect();
        let mut raw = collect(table, &numbers, self.sensor, &places)?;
        let empty = |row: usize| raw.channels.iter().all(|channel| channel[row].is_nan());
        let length = (0..raw.t_s.len())
            .rev()
            .find(|&row| !empty(row))
            .map_or(0, |last| last + 1);
        raw.truncate(length);
        raw.t_s.iter_mut().for_each(|t| *t *= self.time_factor);
        for (channel, factor) in raw.channels.iter_mut().zip(&self.factors) {
            channel.iter_mut().for_each(|value| *value *= factor);
        }
        Ok(raw)
    }
}

/// The columns `prefix` + x, y, z by exact name, in upper or lower case.
pub(super) fn xyz(table: &Table, name: impl Fn(&str) -> String) -> Option<[usize; 3]> {
    let find = |axis: &str| {
        let wanted = name(axis).to_lowercase();
        table.find(|column| column.to_lowercase() == wanted)
    };
    Some([find("x")?, find("y")?, find("z")?])
}

/// Puts series of one or several tables together, each on its own clock.
pub(super) fn assemble(name: &str, mut series: Vec<(usize, RawSeries)>) -> Result<Recording> {
    for (table, raw) in &mut series {
        raw.table = *table;
    }
    crate::csv::recording(name, series.into_iter().map(|(_, raw)| raw).collect())
}

/// A repair that holds for every sensor of a recording.
pub(super) fn add_repair(recording: &mut Recording, repair: &Repair) {
    let sensors = [
        (Sensor::Gyroscope, recording.gyroscope.is_some()),
        (Sensor::Accelerometer, recording.accelerometer.is_some()),
        (
            Sensor::LinearAccelerometer,
            recording.linear_accelerometer.is_some(),
        ),
    ];
    for (sensor, _) in sensors.into_iter().filter(|sensor| sensor.1) {
        let text = format!("{}: {}", sensor.name(), repair.text);
        recording.repairs.push(Repair {
            sensor,
            text,
            ..repair.clone()
        });
    }
}

/// A remark where the size of gravity contradicts the unit or the kind of acceleration.
pub(super) fn gravity_doubt(recording: &Recording) -> Option<String> {
    let mean = mean_size(recording)?;
    let likely = match mean {
        m if (7.0..=13.0).contains(&m) => return None,
        m if (0.7..=1.3).contains(&m) => "the unit is probably g, not m/s2",
        m if (69.0..=128.0).contains(&m) => "the unit is probably m/s2, not g",
        m if m < 0.7 => "gravity is probably already taken out (columns lx, ly, lz)",
        _ => "neither m/s2 nor g fits gravity",
    };
    Some(format!(
        "the mean size of the acceleration is {mean:.3} m/s2 where gravity is 9.8: {likely}"
    ))
}

fn mean_size(recording: &Recording) -> Option<f64> {
    let triad = recording.accelerometer.as_ref()?;
    let [x, y, z] = &triad.axes;
    let sizes = x
        .iter()
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| (x * x + y * y + z * z).sqrt());
    Some(sizes.sum::<f64>() / triad.t_s.len() as f64)
}
