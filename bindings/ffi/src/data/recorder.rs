//! Plain data of the module `recorder`: the file that a phone appends to.

use gyradius_core::procedure::Channel;
use gyradius_core::recorder::{Damage, DamageKind, Event, Header, SensorInfo, Stream, Written};

use super::{Count, TextsByName};

/// A stream of samples of three axes, on its own clock.
#[uniffi::remote(Enum)]
pub enum Channel {
    /// Rotation rate, rad/s.
    Gyroscope,
    /// Specific force, m/s² (at rest, screen up: z = +g).
    Accelerometer,
    /// The phone's own estimate of an uncalibrated gyroscope's bias, rad/s; not taken off the
    /// samples.
    GyroscopeBias,
}

/// The core's stream by the name that the procedure has for it too.
pub type RecorderStream = Stream;
uniffi::custom_type!(RecorderStream, Channel, {
    remote,
    lower: |stream| match stream {
        Stream::Gyroscope => Channel::Gyroscope,
        Stream::Accelerometer => Channel::Accelerometer,
        Stream::GyroscopeBias => Channel::GyroscopeBias,
    },
    try_lift: |channel| Ok(channel.into()),
});

/// One sensor as the phone describes it.
pub type RecorderSensor = SensorInfo;

/// One sensor as the phone describes it.
#[uniffi::remote(Record)]
pub struct RecorderSensor {
    /// The stream that it fills.
    pub stream: RecorderStream,
    /// The phone's name for it, e.g. `LSM6DSO`.
    pub name: String,
    /// Its full scale, rad/s or m/s², where the phone tells.
    pub full_scale: Option<f64>,
}

/// What is known before the first sample.
pub type RecorderHeader = Header;

/// What is known before the first sample.
#[uniffi::remote(Record)]
pub struct RecorderHeader {
    /// Model of the phone.
    pub phone: String,
    /// Its sensors.
    pub sensors: Vec<RecorderSensor>,
    /// Anything else, by key.
    pub notes: TextsByName,
}

/// A mark: `release`, `slip seen`, `sensor stopped`, `gap`, `end`.
pub type RecorderMark = Event;

/// A mark: `release`, `slip seen`, `sensor stopped`, `gap`, `end`.
#[uniffi::remote(Record)]
pub struct RecorderMark {
    /// Stamp, ns of the phone's clock.
    pub stamp_ns: i64,
    /// What it marks, one word or a few.
    pub key: String,
}

/// What a call did to the file.
#[uniffi::remote(Record)]
pub struct Written {
    /// Bytes appended and synced by this call; 0 where everything still waits.
    pub appended: u64,
    /// Length of the file after it, bytes.
    pub length: u64,
    /// Samples that wait, of all streams.
    pub waiting: Count,
}

/// The kinds of damage that a file can have.
#[uniffi::remote(Enum)]
pub enum DamageKind {
    /// Bytes in the middle that are no block: what they held is lost.
    LostBlock,
    /// Bytes at the end that are no whole block.
    CutTail,
    /// Nothing says that the recording ended.
    NoEnd,
    /// Blocks are absent, or stand in another order than they were written in.
    OutOfSequence,
    /// A whole block that this version of the format does not know.
    UnknownBlock,
    /// The recorder was stopped and went on later.
    Resumed,
}

/// One place of a recorder's file where something is missing.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct RecorderDamage {
    /// Kind.
    pub kind: DamageKind,
    /// Where in the file it begins, bytes from the start.
    pub at_byte: u64,
    /// How many bytes are not used, or were cut off before.
    pub bytes: u64,
    /// How many blocks are missing by their numbers; 0 where the numbers cannot tell.
    pub blocks: u32,
    /// The last stamp read before it, ns.
    pub after_ns: Option<i64>,
    /// The first stamp read after it, ns.
    pub before_ns: Option<i64>,
    /// A sentence: what was found and what was done.
    pub text: String,
}

impl From<&Damage> for RecorderDamage {
    fn from(damage: &Damage) -> Self {
        let text = damage.text();
        let Damage {
            kind,
            at_byte,
            bytes,
            blocks,
            after_ns,
            before_ns,
        } = damage.clone();
        Self {
            kind,
            at_byte,
            bytes,
            blocks,
            after_ns,
            before_ns,
            text,
        }
    }
}
