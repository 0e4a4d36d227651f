//! Measures a session or a bare recording and prints the result as JSON: `measure PATH [LIMIT…]`.

use std::error::Error;
use std::path::Path;

use gyradius_core::identification::{MeasureOptions, analyse, measure_recording};
use gyradius_core::import::{Loaded, load_any};

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let path = words.next().ok_or("measure PATH [LIMIT…]")?;
    let limits = words.map(|limit| limit.parse()).collect::<Result<_, _>>()?;
    let options = MeasureOptions { limits };
    let analysis = match load_any(Path::new(&path), &[])? {
        Loaded::Session(loaded) => analyse(&loaded, &options)?,
        Loaded::Bare(recording) => measure_recording(&recording, &options)?,
    };
    print!("{}", serde_json::to_string_pretty(&analysis.measurement)?);
    Ok(())
}
