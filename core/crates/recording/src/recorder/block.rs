//! Blocks: what is appended at once, each with its own checksums.
//!
//! # Conventions
//! Little-endian. `sync (4) kind (1) sequence (4) length (4) crc (4)`, `length` bytes of payload,
//! `crc (4)`. The first checksum covers kind, sequence and length, so that a length is believed
//! only where it is whole; the second covers everything before it. Both are CRC-32 (ISO-HDLC),
//! which finds every single flipped bit.

/// Begins every block; the last byte is the format's major version.
pub const SYNC: [u8; 4] = [0x89, b'G', b'R', b'1'];
/// Bytes before the payload.
const HEAD: usize = 17;
/// Bytes after it.
const TAIL: usize = 4;
/// Longest payload; a longer one is not written, and not believed.
pub(super) const LONGEST_PAYLOAD: usize = 1 << 18;

/// What stands at the start of some bytes.
#[derive(Debug, PartialEq)]
pub(super) enum Look {
    /// A whole block of so many bytes.
    Block(Block),
    /// What may be a block, of which so many bytes are needed.
    Needs(usize),
    /// No block.
    Nothing,
}

/// A block that its checksums vouch for.
#[derive(Debug, PartialEq, Clone, Copy)]
pub(super) struct Block {
    pub kind: u8,
    pub sequence: u32,
    /// Bytes of the whole block.
    pub bytes: usize,
}

impl Block {
    /// Its payload in the bytes that it stands at the start of.
    pub fn payload<'a>(&self, bytes: &'a [u8]) -> &'a [u8] {
        &bytes[HEAD..self.bytes - TAIL]
    }
}

/// Appends a block to `out`. The payload is at most [`LONGEST_PAYLOAD`] long.
pub(super) fn append(out: &mut Vec<u8>, kind: u8, sequence: u32, payload: &[u8]) {
    let start = out.len();
    out.extend(SYNC);
    out.push(kind);
    out.extend(sequence.to_le_bytes());
    out.extend((payload.len() as u32).to_le_bytes());
    out.extend(crc32fast::hash(&out[start + 4..]).to_le_bytes());
    out.extend(payload);
    out.extend(crc32fast::hash(&out[start..]).to_le_bytes());
}

/// Looks at the start of some bytes.
pub(super) fn look(bytes: &[u8]) -> Look {
    let common = bytes.len().min(SYNC.len());
    if bytes[..common] != SYNC[..common] {
        return Look::Nothing;
    }
    if bytes.len() < HEAD {
        return Look::Needs(HEAD);
    }
    let length = word(bytes, 9) as usize;
    if crc32fast::hash(&bytes[4..13]) != word(bytes, 13) || length > LONGEST_PAYLOAD {
        return Look::Nothing;
    }
    let end = HEAD + length;
    if bytes.len() < end + TAIL {
        return Look::Needs(end + TAIL);
    }
    if crc32fast::hash(&bytes[..end]) != word(bytes, end) {
        return Look::Nothing;
    }
    Look::Block(Block {
        kind: bytes[4],
        sequence: word(bytes, 5),
        bytes: end + TAIL,
    })
}

/// Where the next block may begin, after the first byte.
pub(super) fn next_sync(bytes: &[u8]) -> Option<usize> {
    let may_begin = |at: &usize| {
        let rest = &bytes[*at..];
        let common = rest.len().min(SYNC.len());
        rest[..common] == SYNC[..common]
    };
    (1..bytes.len()).find(may_begin)
}

fn word(bytes: &[u8], at: usize) -> u32 {
    let mut four = [0; 4];
    four.copy_from_slice(&bytes[at..at + 4]);
    u32::from_le_bytes(four)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block() -> Vec<u8> {
        let mut bytes = Vec::new();
        append(&mut bytes, 2, 7, b"payload");
        bytes
    }

    #[test]
    fn a_block_is_recognised_whole_and_asks_for_what_is_missing() {
        let bytes = block();
        let Look::Block(found) = look(&bytes) else {
            panic!("{:?}", look(&bytes))
        };
        assert_eq!(
            (found.kind, found.sequence, found.bytes),
            (2, 7, bytes.len())
        );
        assert_eq!(found.payload(&bytes), b"payload");
        for cut in 0..bytes.len() {
            assert!(
                matches!(look(&bytes[..cut]), Look::Needs(n) if n > cut),
                "{cut}"
            );
        }
    }

    #[test]
    fn no_block_survives_a_flipped_bit() {
        for bit in 0..8 * block().len() {
            let mut bytes = block();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(look(&bytes), Look::Nothing, "bit {bit}");
        }
    }

    // The check value of CRC-32/ISO-HDLC: reveng.sourceforge.io/crc-catalogue, check=0xcbf43926.
    #[test]
    fn the_checksum_is_the_one_that_the_format_names() {
        assert_eq!(crc32fast::hash(b"123456789"), 0xcbf4_3926);
    }

    #[test]
    fn the_next_block_is_looked_for_after_the_first_byte_and_at_the_cut() {
        let mut bytes = block();
        let length = bytes.len();
        bytes.extend(block());
        assert_eq!(next_sync(&bytes), Some(length));
        assert_eq!(next_sync(&bytes[..length + 2]), Some(length));
        assert_eq!(next_sync(&bytes[..length]), None);
    }
}
