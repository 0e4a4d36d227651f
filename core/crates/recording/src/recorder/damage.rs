//! What is missing in a file, where, and why.

/// The kinds of damage that a file can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DamageKind {
    /// Bytes in the middle that are no block: what they held is lost.
    LostBlock,
    /// Bytes at the end that are no whole block: the recording was cut off while they were written.
    CutTail,
    /// Nothing says that the recording ended: it was cut off between two blocks.
    NoEnd,
    /// Blocks are absent, or stand in another order than they were written in, although no byte is
    /// damaged.
    OutOfSequence,
    /// A whole block that this version of the format does not know.
    UnknownBlock,
    /// The recorder was stopped and went on later; the incomplete block it had left was cut off.
    Resumed,
}

/// One place where something is missing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Damage {
    /// Kind.
    pub kind: DamageKind,
    /// Where in the file it begins, bytes from the start.
    pub at_byte: u64,
    /// How many bytes are not used, or were cut off before.
    pub bytes: u64,
    /// How many blocks are missing by their numbers; 0 where the numbers cannot tell.
    pub blocks: u32,
    /// The last stamp read before it, ns of the phone's clock.
    pub after_ns: Option<i64>,
    /// The first stamp read after it, ns.
    pub before_ns: Option<i64>,
}

impl Damage {
    /// A sentence for the report: what was found and what was done.
    pub fn text(&self) -> String {
        let (bytes, at) = (self.bytes, self.at_byte);
        match self.kind {
            DamageKind::LostBlock => {
                format!(
                    "{bytes} damaged bytes at byte {at} of the recorder's file: {} left out",
                    self.lost()
                )
            }
            DamageKind::CutTail => format!(
                "the recording was cut off: the last {bytes} bytes, from byte {at} on, are no whole block and are \
                 left out; up to one second is missing"
            ),
            DamageKind::NoEnd => {
                "the recording was cut off without an end mark; up to one second is missing"
                    .to_owned()
            }
            DamageKind::OutOfSequence => format!(
                "the numbers of the blocks jump at byte {at} of the recorder's file: {} absent or out of order",
                self.lost()
            ),
            DamageKind::UnknownBlock => {
                format!(
                    "a block of {bytes} bytes at byte {at} is of a kind that is not known; left out"
                )
            }
            DamageKind::Resumed => format!(
                "the recorder was stopped and went on at byte {at}; an incomplete block of {bytes} bytes was cut off"
            ),
        }
    }

    fn lost(&self) -> String {
        match self.blocks {
            0 => "an unknown number of blocks is".to_owned(),
            1 => "one block is".to_owned(),
            n => format!("{n} blocks are"),
        }
    }
}
