//! The recorder's file: written while a hull swings, read past whatever is damaged.

use std::sync::{Arc, Mutex};

use gyradius_core::procedure::Channel;
use gyradius_core::recorder::{Event, Header, Writer, Written, convert, read_whole};
use gyradius_core::{Error, recorder};

use crate::data::recorder::RecorderDamage;
use crate::error::Result;
use crate::{block, locked};

/// A recorder's file being written: never more than half a second of samples behind.
#[derive(uniffi::Object)]
pub struct RecorderWriter {
    /// None once the recording has ended.
    inner: Mutex<Option<Writer>>,
}

impl RecorderWriter {
    fn of(writer: Writer) -> Arc<Self> {
        Arc::new(Self {
            inner: Mutex::new(Some(writer)),
        })
    }

    fn with<T>(&self, act: impl FnOnce(&mut Writer) -> gyradius_core::Result<T>) -> Result<T> {
        let ended =
            || Error::argument("recorder", "a recording that goes on", "one that has ended");
        Ok(act(locked(&self.inner).as_mut().ok_or_else(ended)?)?)
    }
}

#[uniffi::export]
impl RecorderWriter {
    /// Makes a new file with its header, synced. Fails with `Unwritable` where it is there already.
    #[uniffi::constructor]
    pub fn create(path: &str, header: &Header) -> Result<Arc<Self>> {
        Ok(Self::of(Writer::create(path, header)?))
    }

    /// Goes on with a file after its writer died: cuts off the incomplete block at its end and says
    /// so in the file.
    #[uniffi::constructor]
    pub fn resume(path: &str) -> Result<Arc<Self>> {
        Ok(Self::of(Writer::resume(path)?))
    }

    /// Takes a block of stamps (ns) and one of values (x, y, z) of one stream, in the order they
    /// came.
    pub fn push(&self, channel: Channel, stamps_ns: &[u8], values: &[u8]) -> Result<Written> {
        let (stamps_ns, values) = (block::stamps(stamps_ns)?, block::triples("values", values)?);
        self.with(|writer| writer.push(channel.into(), &stamps_ns, &values))
    }

    /// Writes a mark, with everything that waits before it.
    pub fn mark(&self, mark: &Event) -> Result<Written> {
        self.with(|writer| writer.mark(mark))
    }

    /// Writes everything that waits.
    pub fn flush(&self) -> Result<Written> {
        self.with(Writer::flush)
    }

    /// Ends the recording with its end mark; nothing more is taken.
    pub fn end(&self, stamp_ns: i64) -> Result<Written> {
        let ended =
            || Error::argument("recorder", "a recording that goes on", "one that has ended");
        Ok(locked(&self.inner)
            .take()
            .ok_or_else(ended)?
            .end(stamp_ns)?)
    }
}

/// A recorder's file as it was read.
#[derive(Debug, uniffi::Object)]
pub struct RecorderFile {
    inner: recorder::Whole,
}

/// Samples of one stream as blocks.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct RecordedTrack {
    /// The stream.
    pub channel: recorder::Stream,
    /// Stamps, ns: 64-bit integers.
    pub stamps_ns: Vec<u8>,
    /// x, y, z of each sample: 64-bit floats.
    pub values: Vec<u8>,
}

#[uniffi::export]
impl RecorderFile {
    /// Reads a file, however it was cut or damaged.
    #[uniffi::constructor]
    pub fn read(path: &str) -> Result<Arc<Self>> {
        Ok(Arc::new(Self {
            inner: read_whole(path)?,
        }))
    }

    /// What was known before the first sample.
    pub fn header(&self) -> Header {
        self.inner.header.clone()
    }

    /// Marks, in the order of the file.
    pub fn marks(&self) -> Vec<Event> {
        self.inner.events.clone()
    }

    /// What is missing; empty where the file is whole.
    pub fn damage(&self) -> Vec<RecorderDamage> {
        self.inner.damage.iter().map(RecorderDamage::from).collect()
    }

    /// Samples of every stream that has any, bit for bit as the phone gave them.
    pub fn tracks(&self) -> Vec<RecordedTrack> {
        let filled = self
            .inner
            .tracks
            .iter()
            .filter(|track| !track.stamps_ns.is_empty());
        let track = |samples: &recorder::Samples| RecordedTrack {
            channel: samples.stream,
            stamps_ns: block::of_stamps(&samples.stamps_ns),
            values: block::of_floats(samples.values.as_flattened()),
        };
        filled.map(track).collect()
    }
}

/// Writes a recorder's file as `<name>.csv` (and `<name>-bias.csv`) into a folder; returns what was
/// damaged, a sentence each.
#[uniffi::export]
pub fn convert_recorder_file(file: &str, folder: &str, name: &str) -> Result<Vec<String>> {
    Ok(convert(file, folder, name)?
        .repairs
        .into_iter()
        .map(|repair| repair.text)
        .collect())
}
