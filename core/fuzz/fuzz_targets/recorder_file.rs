//! A recorder's file from any bytes: an error or pieces that keep their promises, and damage that
//! stays inside the file.
//!
//! Chance does not find a checksum: the bytes are read as they are, and as the payload of a whole
//! block of each kind behind them.
#![no_main]

use gyradius_core::recorder::{Piece, Reader};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    read(bytes);
    let mut file = bytes.to_vec();
    for kind in 0..6 {
        file.extend(block(kind, u32::from(kind), bytes));
    }
    read(&file);
});

fn read(file: &[u8]) {
    let mut reader = Reader::new(file, "fuzz.gyr");
    while let Ok(Some(piece)) = reader.next_piece() {
        if let Piece::Samples(samples) = piece {
            assert_eq!(samples.stamps_ns.len(), samples.values.len());
        }
    }
    assert!(
        reader
            .damage()
            .iter()
            .all(|damage| damage.at_byte <= file.len() as u64)
    );
}

/// A block as `core/docs/recorder-file.md` has it.
fn block(kind: u8, number: u32, payload: &[u8]) -> Vec<u8> {
    let mut head = vec![kind];
    head.extend(number.to_le_bytes());
    head.extend((payload.len() as u32).to_le_bytes());
    let mut block = b"\x89GR1".to_vec();
    block.extend(&head);
    block.extend(crc32fast::hash(&head).to_le_bytes());
    block.extend(payload);
    block.extend(crc32fast::hash(&block).to_le_bytes());
    block
}
