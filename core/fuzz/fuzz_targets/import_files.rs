//! Exports from any bytes: as one file, as several loose files of one folder (split at form feeds),
//! and by mapping.
#![no_main]

use gyradius_core::recording::import::{ColumnMapping, ImportOptions, import_files};
use libfuzzer_sys::fuzz_target;

const NAMES: [&str; 6] = [
    "Gyroscope.csv",
    "Accelerometer.csv",
    "Gravity.csv",
    "meta/time.csv",
    "meta/device.csv",
    "Metadata.csv",
];

fuzz_target!(|bytes: &[u8]| {
    let options = ImportOptions::default();
    let whole = [("export".to_owned(), bytes.to_vec())];
    let _ = import_files(&whole, &options);
    let parts: Vec<(String, Vec<u8>)> = bytes
        .split(|byte| *byte == 0x0c)
        .zip(NAMES)
        .map(|(part, name)| (name.to_owned(), part.to_vec()))
        .collect();
    let _ = import_files(&parts, &options);
    let mapping =
        ColumnMapping::from_entries(["t=t:ms", "gx=x:deg/s", "gy=y:deg/s", "gz=z:deg/s"]).ok();
    let _ = import_files(&whole, &ImportOptions { mapping, ..options });
});
