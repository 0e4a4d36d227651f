//! The planner: its figures against the paper and closed forms, its predictions against sessions
//! that are then swung.
#![allow(clippy::unwrap_used)]

mod achieved;
mod asked;
mod closed_forms;
