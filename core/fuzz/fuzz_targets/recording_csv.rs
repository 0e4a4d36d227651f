//! A recording from any bytes: an error or a recording that keeps its promises, and that survives
//! writing.
#![no_main]

use gyradius_core::recording::{read_recording, write_recording};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(recording) = read_recording(bytes, "fuzz.csv") else {
        return;
    };
    let triads = [
        &recording.gyroscope,
        &recording.accelerometer,
        &recording.linear_accelerometer,
    ];
    for triad in triads.into_iter().flatten() {
        assert!(triad.t_s.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(triad.axes.iter().all(|axis| axis.len() == triad.t_s.len()));
        assert!(triad.axes.iter().flatten().all(|value| value.is_finite()));
    }
    let _ = read_recording(&write_recording(&recording), "again.csv");
});
