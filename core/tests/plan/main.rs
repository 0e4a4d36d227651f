//! The planner: its figures against the paper and closed forms, its predictions against sessions
//! that are then swung.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod achieved;
mod asked;
mod closed_forms;
