//! What the columns of a phyphox set are.

use crate::import::columns::SensorColumns;
use crate::import::table::Table;
use crate::import::units::{Dimension, Unit, unit_of_header};
use crate::samples::Sensor;

/// A header cell taken apart: `Linear Acceleration x (m/s^2)`.
struct Label {
    what: String,
    axis: Option<usize>,
    unit: Option<Unit>,
}

impl Label {
    fn of(cell: &str) -> Self {
        let (words, unit) = cell.rsplit_once('(').unwrap_or((cell, ""));
        let lower = words.trim().to_lowercase();
        let last = lower.rsplit(' ').next().unwrap_or_default();
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == last);
        let what = if axis.is_some() {
            lower[..lower.len() - 1].trim_end()
        } else {
            &lower
        };
        Self {
            what: what.to_owned(),
            axis,
            unit: unit_of_header(unit.trim().trim_end_matches(')')),
        }
    }

    fn time_factor(&self) -> Option<f64> {
        let unit = self.unit.filter(|unit| unit.quantity == Dimension::Time)?;
        (self.what == "time").then_some(unit.factor)
    }

    /// The sensor this is an axis of; composed experiments name the axis alone, and the set names
    /// the sensor.
    fn sensor(&self, set: &str) -> Option<Sensor> {
        let set = set.to_lowercase();
        let free = |text: &str| text.contains("linear") || text.contains("without g");
        match (self.what.as_str(), self.unit?.quantity) {
            ("gyroscope" | "rotation" | "rotation rate" | "", Dimension::AngularRate) => {
                Some(Sensor::Gyroscope)
            }
            ("linear acceleration", Dimension::Acceleration) => Some(Sensor::LinearAccelerometer),
            ("acceleration" | "accelerometer" | "", Dimension::Acceleration) if free(&set) => {
                Some(Sensor::LinearAccelerometer)
            }
            ("acceleration" | "accelerometer", Dimension::Acceleration) => {
                Some(Sensor::Accelerometer)
            }
            ("", Dimension::Acceleration) if set.contains("accel") => Some(Sensor::Accelerometer),
            _ => None,
        }
    }
}

/// A sensor of which some axes have been met: column and factor of each.
struct Met {
    sensor: Sensor,
    time: usize,
    time_factor: f64,
    axes: [Option<(usize, f64)>; 3],
}

impl Met {
    fn complete(self) -> Option<SensorColumns> {
        let axes: Vec<(usize, f64)> = self.axes.into_iter().collect::<Option<_>>()?;
        let (axes, factors) = axes.into_iter().unzip();
        let Met {
            sensor,
            time,
            time_factor,
            ..
        } = self;
        Some(SensorColumns {
            sensor,
            time,
            time_factor,
            axes,
            factors,
        })
    }
}

/// The complete sensors of a set, each with the nearest time column before it.
pub(super) fn sensors(table: &Table, set: &str) -> Vec<SensorColumns> {
    let labels: Vec<Label> = table.header().iter().map(|cell| Label::of(cell)).collect();
    let mut time = None;
    let mut found: Vec<Met> = Vec::new();
    for (column, label) in labels.iter().enumerate() {
        if let Some(factor) = label.time_factor() {
            time = Some((column, factor));
            continue;
        }
        let (Some(sensor), Some(axis), Some(unit), Some((time, time_factor))) =
            (label.sensor(set), label.axis, label.unit, time)
        else {
            continue;
        };
        let place = found
            .iter()
            .position(|met| met.sensor == sensor)
            .unwrap_or_else(|| {
                found.push(Met {
                    sensor,
                    time,
                    time_factor,
                    axes: [None; 3],
                });
                found.len() - 1
            });
        found[place].axes[axis].get_or_insert((column, unit.factor));
    }
    found.into_iter().filter_map(Met::complete).collect()
}
