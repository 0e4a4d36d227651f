//! Integration tests of `gyradius-recording`, in one program.

#![allow(missing_docs)]

mod axes;
mod containers;
mod half_told;
mod import;
mod recorder;
mod recording_csv;
mod session_format;
mod session_properties;
mod session_store;
mod tables;
mod tagged;
mod trials;
