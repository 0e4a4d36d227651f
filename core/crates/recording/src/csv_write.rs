//! Writing a recording in the project's own form.
//!
//! # Conventions
//! Rows are merged by time: sensors that share a stamp share a row, the others' cells stay empty.
//! Numbers are the shortest that read back to the same bits.

use std::fmt::Write;

use super::samples::{Recording, SensorChannels};

/// A recording as CSV bytes that [`super::read_recording`] reads back to the same samples.
pub fn write_recording(recording: &Recording) -> Vec<u8> {
    let sensors = recording.sensors();
    let mut out = String::from("t");
    for (name, _) in sensors.iter().flat_map(|sensor| &sensor.channels) {
        out.push(',');
        out.push_str(name);
    }
    out.push('\n');
    let mut next = vec![0; sensors.len()];
    while let Some(t_s) = earliest(&sensors, &next) {
        // Writing to a String does not fail.
        let _ = write!(out, "{t_s}");
        for (sensor, next) in sensors.iter().zip(&mut next) {
            write_cells(&mut out, sensor, next, t_s);
        }
        out.push('\n');
    }
    out.into_bytes()
}

fn earliest(sensors: &[SensorChannels], next: &[usize]) -> Option<f64> {
    let stamps = sensors
        .iter()
        .zip(next)
        .filter_map(|(sensor, &i)| sensor.t_s.get(i).copied());
    stamps.min_by(f64::total_cmp)
}

fn write_cells(out: &mut String, sensor: &SensorChannels, next: &mut usize, t_s: f64) {
    let here = sensor.t_s.get(*next) == Some(&t_s);
    for (_, samples) in &sensor.channels {
        out.push(',');
        if let Some(value) = samples.get(*next).filter(|_| here) {
            let _ = write!(out, "{value}");
        }
    }
    *next += usize::from(here);
}
