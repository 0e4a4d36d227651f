//! A recorder's file from any bytes: an error or pieces that keep their promises, and damage that stays inside the file.
#![no_main]

use gyradius_core::recorder::{Piece, Reader};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut reader = Reader::new(bytes, "fuzz.gyr");
    while let Ok(Some(piece)) = reader.next_piece() {
        if let Piece::Samples(samples) = piece {
            assert_eq!(samples.stamps_ns.len(), samples.values.len());
        }
    }
    assert!(reader.damage().iter().all(|damage| damage.at_byte <= bytes.len() as u64));
});
