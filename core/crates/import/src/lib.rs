//! What a user hands over: a session, a bare recording, or the exports and recorder's files that
//! become a session.
//!
//! May know `recording`, `recorder`, `signal` (a light gate's edges become periods).

mod draft;
mod gather;
mod grow;
mod import;
mod input;
mod loaded;
mod places;

pub use grow::{Growth, import_into};
pub use import::{ImportRequest, describe_exports, import_session};
pub use loaded::{Loaded, load_any};
