//! What a user hands over: a session, a bare recording, or the exports and recorder's files that
//! become a session or are added to one.
//!
//! May know `recording`, `recorder`, `signal` (a light gate's edges become periods).

mod describe;
mod draft;
mod gather;
mod grow;
mod hanging;
mod import;
mod input;
mod loaded;
mod places;

pub use describe::describe_exports;
pub use grow::{Growth, import_into};
pub use hanging::Hanging;
pub use import::{ImportRequest, import_session};
pub use loaded::{Loaded, load_any, load_tables};
