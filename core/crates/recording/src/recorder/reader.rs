//! Reads a recorder's file block by block, in constant memory, past whatever is damaged.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use super::block::{Block, Look, SYNC, look, next_sync};
use super::damage::{Damage, DamageKind};
use super::payload;
use super::types::{END, FORMAT, Piece};
use gyradius_base::error::{Error, Result};

/// Bytes that are read at once while looking for the next block.
const STRIDE: usize = 1 << 12;

/// A recorder's file being read.
pub struct Reader<R> {
    source: R,
    file: String,
    /// Bytes read and not yet used.
    window: Vec<u8>,
    /// Place of the window in the file.
    at_byte: u64,
    /// Bytes given up since the last block.
    given_up: u64,
    /// Number that the next block should have.
    expected: u32,
    /// End of the last whole block.
    whole_bytes: u64,
    /// Whether the bytes begin as such a file does.
    begins_well: bool,
    /// Whether the last piece was the end mark.
    ended: bool,
    last_ns: Option<i64>,
    damage: Vec<Damage>,
    done: bool,
}

impl Reader<BufReader<File>> {
    /// Opens a file. Fails with [`Error::Unreadable`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let file = path.as_ref().display().to_string();
        match File::open(path) {
            Ok(source) => Ok(Reader::new(BufReader::new(source), &file)),
            Err(error) => Err(unreadable(&file, "opening", &error)),
        }
    }
}

impl<R: Read> Reader<R> {
    /// Reads from any source; `file` is what messages call it.
    pub fn new(source: R, file: &str) -> Self {
        Self {
            source,
            file: file.to_owned(),
            window: Vec::new(),
            at_byte: 0,
            given_up: 0,
            expected: 0,
            whole_bytes: 0,
            begins_well: true,
            ended: false,
            last_ns: None,
            damage: Vec::new(),
            done: false,
        }
    }

    /// The next piece; `None` at the end of the file.
    ///
    /// Fails with [`Error::Unreadable`] where the file cannot be read, and at the end with
    /// [`Error::Malformed`] where it is no recorder's file at all.
    pub fn next_piece(&mut self) -> Result<Option<Piece>> {
        while !self.done {
            match look(&self.window) {
                Look::Block(block) => {
                    if let Some(piece) = self.take(block) {
                        return Ok(Some(piece));
                    }
                }
                Look::Needs(bytes) => {
                    if !self.fill(bytes)? {
                        self.give_up()?;
                    }
                }
                Look::Nothing => {
                    self.fill(STRIDE)?;
                    self.give_up()?;
                }
            }
        }
        Ok(None)
    }

    /// What was found damaged so far, in file order; complete once [`Reader::next_piece`] has given
    /// `None`.
    pub fn damage(&self) -> &[Damage] {
        &self.damage
    }

    /// End of the last whole block so far, bytes from the start.
    pub(super) fn whole_bytes(&self) -> u64 {
        self.whole_bytes
    }

    /// Number that the next block should have.
    pub(super) fn expected(&self) -> u32 {
        self.expected
    }

    /// Uses a block: its piece, or none where it is not known.
    fn take(&mut self, block: Block) -> Option<Piece> {
        self.judge_place(block);
        let piece = payload::read(block.kind, block.payload(&self.window));
        match &piece {
            None => self.tell(
                DamageKind::UnknownBlock,
                self.at_byte,
                block.bytes as u64,
                0,
            ),
            Some(Piece::Resumed { cut_bytes }) => {
                self.tell(DamageKind::Resumed, self.at_byte, *cut_bytes, 0)
            }
            Some(Piece::Samples(samples)) => self.note_stamps(&samples.stamps_ns),
            Some(Piece::Header(_) | Piece::Event(_)) => {}
        }
        self.ended = matches!(&piece, Some(Piece::Event(event)) if event.key == END);
        self.expected = block.sequence.wrapping_add(1);
        self.advance(block.bytes);
        self.whole_bytes = self.at_byte;
        piece
    }

    /// Tells of what is missing between the last block and this one.
    fn judge_place(&mut self, block: Block) {
        let missing = block.sequence.wrapping_sub(self.expected);
        // A number from before the expected one wraps round to more blocks than any file has.
        let blocks = if missing > u32::MAX / 2 { 0 } else { missing };
        let lost = std::mem::take(&mut self.given_up);
        if lost > 0 {
            self.tell(DamageKind::LostBlock, self.at_byte - lost, lost, blocks);
        } else if missing > 0 {
            self.tell(DamageKind::OutOfSequence, self.at_byte, 0, blocks);
        }
    }

    fn tell(&mut self, kind: DamageKind, at_byte: u64, bytes: u64, blocks: u32) {
        let after_ns = self.last_ns;
        self.damage.push(Damage {
            kind,
            at_byte,
            bytes,
            blocks,
            after_ns,
            before_ns: None,
        });
    }

    fn note_stamps(&mut self, stamps_ns: &[i64]) {
        let (Some(first), Some(last)) = (stamps_ns.first(), stamps_ns.last()) else {
            return;
        };
        for open in self
            .damage
            .iter_mut()
            .rev()
            .take_while(|damage| damage.before_ns.is_none())
        {
            open.before_ns = Some(*first);
        }
        self.last_ns = Some(*last);
    }

    /// Gives up bytes as far as the next place where a block may begin; at the end of the file,
    /// all.
    fn give_up(&mut self) -> Result<()> {
        if self.at_byte == 0 {
            let common = self.window.len().min(SYNC.len());
            self.begins_well = self.window[..common] == SYNC[..common];
        }
        if self.window.is_empty() {
            return self.finish();
        }
        let bytes = next_sync(&self.window).unwrap_or(self.window.len());
        self.given_up += bytes as u64;
        self.advance(bytes);
        Ok(())
    }

    fn finish(&mut self) -> Result<()> {
        self.done = true;
        if self.whole_bytes == 0 && !self.begins_well {
            return Err(Error::Malformed {
                file: self.file.clone(),
                line: None,
                expected: format!("a recorder's file ({FORMAT})"),
                found: "no block of one".to_owned(),
            });
        }
        if self.given_up > 0 {
            self.tell(DamageKind::CutTail, self.whole_bytes, self.given_up, 0);
        } else if !self.ended {
            self.tell(DamageKind::NoEnd, self.at_byte, 0, 0);
        }
        Ok(())
    }

    fn advance(&mut self, bytes: usize) {
        self.window.drain(..bytes);
        self.at_byte += bytes as u64;
    }

    /// Reads on until the window holds so many bytes; false where the file ends before.
    fn fill(&mut self, bytes: usize) -> Result<bool> {
        let missing = bytes.saturating_sub(self.window.len()) as u64;
        let read = self
            .source
            .by_ref()
            .take(missing)
            .read_to_end(&mut self.window);
        match read {
            Ok(_) => Ok(self.window.len() >= bytes),
            Err(error) => Err(unreadable(&self.file, "reading a block", &error)),
        }
    }
}

fn unreadable(file: &str, doing: &str, error: &std::io::Error) -> Error {
    Error::Unreadable {
        file: file.to_owned(),
        reason: format!("{doing}: {error}"),
    }
}
