//! Writes a recorder's file: blocks appended as samples arrive, synced at least twice in a second
//! of them.
//!
//! Memory does not grow: at most half a second of samples waits. Where a block cannot be written,
//! everything before it stays readable and the writer takes nothing more, so that no gap can pass
//! unseen; [`Writer::resume`] goes on.

use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

use super::block::{self, LONGEST_PAYLOAD};
use super::payload;
use super::reader::Reader;
use super::types::{END, Event, Header, Samples, Stream};
use gyradius_base::error::{Error, Result};

/// Samples of one stream wait no longer than this, ns of their own stamps: half of the second that
/// may be lost.
const LONGEST_WAIT_NS: u64 = 500_000_000;
/// … and never are more than this.
const MOST_WAITING: usize = 4096;

/// Where blocks go: a file, or what stands for one in a test.
pub(super) trait Sink {
    /// Appends bytes.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Returns once everything appended is on the disk.
    fn sync(&mut self) -> io::Result<()>;
}

impl Sink for File {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.write_all(bytes)
    }

    fn sync(&mut self) -> io::Result<()> {
        self.sync_data()
    }
}

/// What a call did to the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Written {
    /// Bytes appended and synced by this call; 0 where everything still waits.
    pub appended: u64,
    /// Length of the file after it, bytes.
    pub length: u64,
    /// Samples that wait, of all streams.
    pub waiting: usize,
}

/// A recorder's file being written.
pub struct Writer {
    blocks: Blocks<File>,
}

impl Writer {
    /// Makes a new file with its header, synced. Fails with [`Error::Unwritable`] where it cannot
    /// be made or is there already, with [`Error::Argument`] where the header is longer than a
    /// block may be.
    pub fn create(path: impl AsRef<Path>, header: &Header) -> Result<Self> {
        let file = path.as_ref().display().to_string();
        let opened = OpenOptions::new().write(true).create_new(true).open(path);
        let sink = opened.map_err(|error| Error::unwritable(&file, "making the file", &error))?;
        let mut blocks = Blocks::new(sink, file, 0, 0);
        blocks.write(&[(payload::HEADER, payload::header(header))])?;
        Ok(Self { blocks })
    }

    /// Goes on with a file after its writer died: cuts off the incomplete block at its end and says
    /// so in the file.
    ///
    /// Fails with [`Error::Unreadable`], [`Error::Malformed`] where it is no recorder's file, and
    /// [`Error::Unwritable`]; a file that is refused is not touched.
    pub fn resume(path: impl AsRef<Path>) -> Result<Self> {
        let file = path.as_ref().display().to_string();
        let mut reader = Reader::open(&path)?;
        while reader.next_piece()?.is_some() {}
        let (whole, sequence) = (reader.whole_bytes(), reader.expected());
        let fail = |doing: &str, error: &io::Error| Error::unwritable(&file, doing, error);
        let opened = OpenOptions::new().write(true).open(&path);
        let mut sink = opened.map_err(|error| fail("opening it again", &error))?;
        let length = sink
            .seek(SeekFrom::End(0))
            .map_err(|error| fail("finding its end", &error))?;
        sink.set_len(whole)
            .map_err(|error| fail("cutting off an incomplete block", &error))?;
        sink.seek(SeekFrom::Start(whole))
            .map_err(|error| fail("finding its end", &error))?;
        let mut blocks = Blocks::new(sink, file, sequence, whole);
        blocks.write(&[(payload::RESUMED, payload::resumed(length - whole))])?;
        Ok(Self { blocks })
    }

    /// Takes samples of one stream in the order they came: stamps as the phone gave them, and (x,
    /// y, z) each.
    ///
    /// Fails with [`Error::Argument`] where there are not as many values as stamps, and with
    /// [`Error::Unwritable`] where a block cannot be written; what was written before stays
    /// readable.
    pub fn push(
        &mut self,
        stream: Stream,
        stamps_ns: &[i64],
        values: &[[f64; 3]],
    ) -> Result<Written> {
        self.blocks.push(stream, stamps_ns, values)
    }

    /// Writes a mark, with everything that waits before it. Fails as [`Writer::push`] does.
    pub fn mark(&mut self, event: &Event) -> Result<Written> {
        self.blocks.mark(event)
    }

    /// Writes everything that waits. Fails with [`Error::Unwritable`].
    pub fn flush(&mut self) -> Result<Written> {
        self.blocks.flush(Vec::new())
    }

    /// Ends the recording with its end mark. Fails as [`Writer::push`] does.
    pub fn end(mut self, stamp_ns: i64) -> Result<Written> {
        self.mark(&Event {
            stamp_ns,
            key: END.to_owned(),
        })
    }
}

/// The blocks of a file and what waits to become one.
struct Blocks<S> {
    sink: S,
    file: String,
    sequence: u32,
    length: u64,
    waiting: [Samples; 3],
    /// Why an earlier block could not be written.
    failed: Option<Error>,
}

impl<S: Sink> Blocks<S> {
    fn new(sink: S, file: String, sequence: u32, length: u64) -> Self {
        Self {
            sink,
            file,
            sequence,
            length,
            waiting: Stream::ALL.map(Samples::none),
            failed: None,
        }
    }

    fn push(&mut self, stream: Stream, stamps_ns: &[i64], values: &[[f64; 3]]) -> Result<Written> {
        if stamps_ns.len() != values.len() {
            let found = format!("{} stamps and {} values", stamps_ns.len(), values.len());
            return Err(Error::argument("values", "as many values as stamps", found));
        }
        self.refuse_failed()?;
        let mut appended = 0;
        for (&stamp, &value) in stamps_ns.iter().zip(values) {
            if is_due(&self.waiting[stream.index()].stamps_ns, stamp) {
                appended += self.flush(Vec::new())?.appended;
            }
            let waiting = &mut self.waiting[stream.index()];
            waiting.stamps_ns.push(stamp);
            waiting.values.push(value);
        }
        Ok(Written {
            appended,
            length: self.length,
            waiting: self.waiting(),
        })
    }

    fn mark(&mut self, event: &Event) -> Result<Written> {
        let payload = payload::event(event);
        if payload.len() > LONGEST_PAYLOAD {
            return Err(Error::argument(
                "key",
                "a few words",
                format!("{} bytes", event.key.len()),
            ));
        }
        self.flush(vec![(payload::EVENT, payload)])
    }

    /// Writes what waits, and then other blocks.
    fn flush(&mut self, others: Vec<(u8, Vec<u8>)>) -> Result<Written> {
        let filled = self
            .waiting
            .iter()
            .filter(|samples| !samples.stamps_ns.is_empty());
        let mut payloads: Vec<_> = filled
            .map(|one| (payload::SAMPLES, payload::samples(one)))
            .collect();
        payloads.extend(others);
        let written = self.write(&payloads)?;
        for samples in &mut self.waiting {
            samples.stamps_ns.clear();
            samples.values.clear();
        }
        Ok(Written {
            waiting: 0,
            ..written
        })
    }

    fn write(&mut self, payloads: &[(u8, Vec<u8>)]) -> Result<Written> {
        self.refuse_failed()?;
        let mut bytes = Vec::new();
        for (kind, payload) in payloads {
            if payload.len() > LONGEST_PAYLOAD {
                let found = format!("{} bytes", payload.len());
                return Err(Error::argument(
                    "header",
                    format!("at most {LONGEST_PAYLOAD} bytes"),
                    found,
                ));
            }
            block::append(&mut bytes, *kind, self.sequence, payload);
            self.sequence = self.sequence.wrapping_add(1);
        }
        let appended = self
            .sink
            .append(&bytes)
            .map_err(|error| ("appending a block", error));
        let synced = appended.and_then(|()| {
            self.sink
                .sync()
                .map_err(|error| ("syncing it to the disk", error))
        });
        if let Err((doing, error)) = synced {
            self.failed = Some(Error::unwritable(&self.file, doing, &error));
        }
        self.refuse_failed()?;
        self.length += bytes.len() as u64;
        Ok(Written {
            appended: bytes.len() as u64,
            length: self.length,
            waiting: self.waiting(),
        })
    }

    fn refuse_failed(&self) -> Result<()> {
        self.failed.clone().map_or(Ok(()), Err)
    }

    fn waiting(&self) -> usize {
        self.waiting
            .iter()
            .map(|samples| samples.stamps_ns.len())
            .sum()
    }
}

/// Whether samples must be written before one more; stamps that step far back count as time that
/// went by.
fn is_due(stamps_ns: &[i64], next_ns: i64) -> bool {
    let Some(first) = stamps_ns.first() else {
        return false;
    };
    next_ns.abs_diff(*first) >= LONGEST_WAIT_NS || stamps_ns.len() >= MOST_WAITING
}

#[cfg(test)]
mod tests {
    use super::super::types::Piece;
    use super::*;

    /// A disk of so many bytes; what does not fit is written as far as it does, as a real one does
    /// it.
    struct SmallDisk {
        bytes: Vec<u8>,
        room: usize,
    }

    impl Sink for SmallDisk {
        fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
            let fits = bytes.len().min(self.room - self.bytes.len());
            self.bytes.extend(&bytes[..fits]);
            if fits < bytes.len() {
                Err(io::ErrorKind::StorageFull.into())
            } else {
                Ok(())
            }
        }

        fn sync(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_is_said_and_all_that_was_flushed_stays_readable() {
        let mut blocks = Blocks::new(
            SmallDisk {
                bytes: Vec::new(),
                room: 20_000,
            },
            "swing.gyr".into(),
            0,
            0,
        );
        let mut flushed = 0;
        let error = (0..).find_map(|i: i64| {
            match blocks.push(Stream::Gyroscope, &[5_000_000 * i], &[[i as f64; 3]]) {
                Ok(written) if written.appended > 0 => flushed = i as usize + 1 - written.waiting,
                Ok(_) => {}
                Err(error) => return Some(error),
            }
            None
        });
        let full = Some(Error::DiskFull {
            file: "swing.gyr".into(),
        });
        assert_eq!(error, full);
        assert_eq!(
            blocks
                .mark(&Event {
                    stamp_ns: 0,
                    key: "end".into()
                })
                .err(),
            full
        );
        assert_eq!(blocks.sink.bytes.len(), 20_000);
        let mut reader = Reader::new(&blocks.sink.bytes[..], "swing.gyr");
        let mut read = 0;
        while let Some(piece) = reader.next_piece().unwrap() {
            let Piece::Samples(samples) = piece else {
                panic!("{piece:?}")
            };
            read += samples.stamps_ns.len();
        }
        assert!(flushed > 0);
        assert_eq!(read, flushed);
    }
}
