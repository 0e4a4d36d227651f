//! The face of `gyradius-core` for Kotlin and Swift: conversions only, no science.
//!
//! Every function reads its arguments, calls the core, and hands back what the core gives or its
//! error. Plain data of the core cross as immutable records: [`data`] describes them to UniFFI
//! field by field, and a field that the core gains or loses does not compile until that is said
//! here too. Results with a format of their own also cross as the JSON text that the core writes,
//! byte for byte the same as Rust's and Python's.
//!
//! # Conventions
//! - Samples cross as blocks of bytes ([`block`]): little-endian, stamps as 64-bit integers (ns),
//!   values as 64-bit floats.
//! - Objects may be called from any thread; calls of one object that changes wait for each other.
//! - Long work ends in `_blocking`: it keeps the calling thread until it is done, is told of and
//!   stopped by a [`work::ProgressListener`], and runs on a thread with a stack of its own. The
//!   packages wrap it in `suspend` and `async`.
//! - Names that Foundation, SwiftUI or Kotlin use themselves (`Progress`, `Measurement`, `Text`,
//!   `Task` …) are avoided.

uniffi::setup_scaffolding!();

pub mod analysis;
pub mod block;
pub mod criticism;
pub mod data;
pub mod error;
pub mod imports;
pub mod live;
pub mod oscillations;
pub mod planning;
pub mod procedure;
pub mod recorder;
pub mod rehearsal;
pub mod routes;
pub mod session;
pub mod simulation;
pub mod texts;
pub mod work;

use gyradius_core::Error;
use serde::Serialize;

/// The version of the library.
#[uniffi::export]
pub fn library_version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A value of the core as the JSON text that every language gives.
fn as_json(value: &impl Serialize) -> error::Result<String> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| Error::no_result("JSON", error.to_string()))?)
}

/// What a lock guards. A panic under it would be a mistake of the core, told as an internal error;
/// later calls go on.
fn locked<T>(lock: &std::sync::Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    lock.lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner)
}
