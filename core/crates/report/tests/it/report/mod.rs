//! The report: what it says, that it is well formed, and that no data break its pictures.
//!
//! `cargo test --test report` leaves a page of each sample under `target/tmp`, to be looked at in a
//! browser.

mod content;
mod critique;
mod degenerate;
mod gathered;
mod german;
mod samples;
mod well_formed;
