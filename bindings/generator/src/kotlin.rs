//! `gyradius-kotlin LIBRARY FOLDER`: UniFFI's own Kotlin, of the version that the facade is built
//! with, its blocks held.
//!
//! UniFFI 0.32 passes the address of a direct `ByteBuffer` and lets go of the buffer: collected
//! while the library still reads it, its memory is another's, and what is read is neither refused
//! nor what was recorded. JNA's structure that carries the address lives as long as the call
//! (arguments of a JNI method are roots of the collector), so it holds the buffer here.
//! `SensorsTest` asks for it under a collector that never rests.

use std::error::Error;
use std::fs;
use std::path::Path;

use uniffi::{GenerateOptions, TargetLanguage};

/// Where the Kotlin of the facade stands in the folder.
const WRITTEN: &str = "org/gyradius/gyradius_ffi.kt";

/// What UniFFI writes, and what holds the buffer; each stands there once.
const HELD: [(&str, &str); 2] = [
    (
        "    class ByValue : ForeignBytes(), Structure.ByValue\n",
        "    // Holds the buffer that `data` points into for as long as the call lasts. JNA takes public fields alone for the structure's.
    class ByValue(private val held: java.nio.ByteBuffer? = null) : ForeignBytes(), Structure.ByValue\n",
    ),
    ("        val fb = ForeignBytes.ByValue()\n", "        val fb = ForeignBytes.ByValue(value)\n"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [library, folder] = arguments.as_slice() else {
        return Err("LIBRARY FOLDER".into());
    };
    uniffi::generate(GenerateOptions {
        languages: vec![TargetLanguage::Kotlin],
        source: library.into(),
        out_dir: folder.into(),
        ..GenerateOptions::default()
    })?;
    let path = Path::new(folder).join(WRITTEN);
    let held = HELD
        .iter()
        .try_fold(fs::read_to_string(&path)?, |text, (written, held)| {
            hold(&text, written, held)
        })?;
    Ok(fs::write(path, held)?)
}

fn hold(text: &str, written: &str, held: &str) -> Result<String, String> {
    match text.matches(written).count() {
        1 => Ok(text.replace(written, held)),
        times => Err(format!(
            "{WRITTEN} has {times} times what is to hold a buffer, not once: {}",
            written.trim()
        )),
    }
}
