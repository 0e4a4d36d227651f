//! `cargo run --example measure -- SESSION`: the measurement of a session or a bare recording as JSON.

use gyradius_core::inertia::{MeasureOptions, measure, measure_recording};
use gyradius_core::recording::{load_session, read_recording};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("name a session or a recording")?;
    let options = MeasureOptions::default();
    let measurement = if path.ends_with(".csv") {
        measure_recording(&read_recording(&std::fs::read(&path)?, &path)?, &options)?.measurement
    } else {
        measure(&load_session(&path)?, &options)?
    };
    println!("{}", serde_json::to_string_pretty(&measurement)?);
    Ok(())
}
