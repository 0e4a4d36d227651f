//! The recorder's file: samples and marks, appended as they arrive, readable after whatever
//! happens.
//!
//! May know `error` and `recording`. The format is described in `core/docs/recorder-file.md`:
//! blocks with a checksum each, at most half a second of samples in one, synced as they are
//! written. A file cut at any byte is read up to the cut; a block that is damaged is lost alone;
//! whatever is missing is told as [`Damage`], never passed over.
//!
//! # Conventions
//! Stamps are nanoseconds of the phone's own clock, exactly as the phone gave them; values are
//! rad/s and m/s² of specific force in phone axes (at rest, screen up: z = +g), bit for bit as they
//! came.

mod block;
mod convert;
mod damage;
mod merge;
mod payload;
mod reader;
mod types;
mod whole;
mod writer;

pub use block::SYNC;
pub use convert::{NamedTables, convert, converted};
pub use damage::{Damage, DamageKind};
pub use reader::Reader;
pub use types::{END, Event, Header, Piece, Samples, SensorInfo, Stream};
pub use whole::{Whole, read_whole};
pub use writer::{Writer, Written};
