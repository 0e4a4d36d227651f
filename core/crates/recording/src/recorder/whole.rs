//! A recorder's file read whole.

use std::path::Path;

use super::damage::Damage;
use super::reader::Reader;
use super::types::{Event, Header, Piece, Samples, Stream};
use gyradius_base::error::Result;

/// All of a recorder's file.
#[derive(Debug, Clone, PartialEq)]
pub struct Whole {
    /// What was known before the first sample; empty where it was lost.
    pub header: Header,
    /// Marks, in the order of the file.
    pub events: Vec<Event>,
    /// What is missing, in the order of the file.
    pub damage: Vec<Damage>,
    /// Samples of every stream, in the order of [`Stream::ALL`]; empty where there are none.
    pub tracks: [Samples; 3],
}

/// Reads a file past whatever is damaged. Fails as [`Reader`] does.
pub fn read_whole(path: impl AsRef<Path>) -> Result<Whole> {
    let mut reader = Reader::open(path)?;
    let mut whole = Whole {
        header: Header::default(),
        events: Vec::new(),
        damage: Vec::new(),
        tracks: Stream::ALL.map(Samples::none),
    };
    while let Some(piece) = reader.next_piece()? {
        match piece {
            Piece::Header(header) => whole.header = header,
            Piece::Event(event) => whole.events.push(event),
            Piece::Samples(samples) => {
                let track = &mut whole.tracks[samples.stream.index()];
                track.stamps_ns.extend(samples.stamps_ns);
                track.values.extend(samples.values);
            }
            Piece::Resumed { .. } => {}
        }
    }
    whole.damage = reader.damage().to_vec();
    Ok(whole)
}
