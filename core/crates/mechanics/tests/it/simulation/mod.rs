//! The simulation of a scene and its effects against closed forms, quadratures and equations of one
//! coordinate, integrated apart.
#![allow(clippy::unwrap_used, clippy::panic)]

mod catalogue;
mod closed_forms;
mod damping;
mod derivatives;
mod exchange;
mod lines;
mod masses;
mod scenes;
mod surroundings;
