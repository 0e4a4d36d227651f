//! Writing a recording in the project's own form.
//!
//! # Conventions
//! Rows are merged by time: sensors that share a stamp share a row, the others' cells stay empty.
//! Numbers are the shortest that read back to the same bits.

use std::fmt::Write;

use super::csv::TRIADS;
use super::samples::{Recording, Sensor, Triad};

/// A recording as CSV bytes that [`super::read_recording`] reads back to the same samples.
pub fn write_recording(recording: &Recording) -> Vec<u8> {
    if let Some(channel) = &recording.single {
        let mut out = format!("t,{}\n", channel.quantity.name());
        for (t_s, value) in channel.t_s.iter().zip(&channel.values) {
            let _ = writeln!(out, "{t_s},{value}");
        }
        return out.into_bytes();
    }
    let sensors: Vec<(&Triad, [&str; 3])> = TRIADS
        .iter()
        .filter_map(|(sensor, names)| Some((triad_of(recording, *sensor)?, *names)))
        .collect();
    let mut out = String::from("t");
    for name in sensors.iter().flat_map(|(_, names)| names) {
        out.push(',');
        out.push_str(name);
    }
    out.push('\n');
    let mut next = vec![0; sensors.len()];
    while let Some(t_s) = earliest(&sensors, &next) {
        // Writing to a String does not fail.
        let _ = write!(out, "{t_s}");
        for ((triad, _), next) in sensors.iter().zip(&mut next) {
            write_cells(&mut out, triad, next, t_s);
        }
        out.push('\n');
    }
    out.into_bytes()
}

fn triad_of(recording: &Recording, sensor: Sensor) -> Option<&Triad> {
    match sensor {
        Sensor::Gyroscope => recording.gyroscope.as_ref(),
        Sensor::Accelerometer => recording.accelerometer.as_ref(),
        Sensor::LinearAccelerometer => recording.linear_accelerometer.as_ref(),
        Sensor::Displacement | Sensor::Timer => None,
    }
}

fn earliest(sensors: &[(&Triad, [&str; 3])], next: &[usize]) -> Option<f64> {
    let stamps = sensors
        .iter()
        .zip(next)
        .filter_map(|((triad, _), &i)| triad.t_s.get(i).copied());
    stamps.min_by(f64::total_cmp)
}

fn write_cells(out: &mut String, triad: &Triad, next: &mut usize, t_s: f64) {
    let here = triad.t_s.get(*next) == Some(&t_s);
    for axis in &triad.axes {
        out.push(',');
        if let Some(value) = axis.get(*next).filter(|_| here) {
            let _ = write!(out, "{value}");
        }
    }
    *next += usize::from(here);
}
