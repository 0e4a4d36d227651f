//! What a recorder's file holds.

use std::collections::BTreeMap;

/// Name and major version of the format.
pub(super) const FORMAT: &str = "gyradius-recorder/1";

/// Key of the mark that ends a recording that was not cut short.
pub const END: &str = "end";

/// A stream of samples of three axes, on its own clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stream {
    /// Rotation rate, rad/s.
    Gyroscope,
    /// Specific force, m/s².
    Accelerometer,
    /// The phone's own estimate of the bias of an uncalibrated gyroscope, rad/s; not taken off the
    /// samples.
    GyroscopeBias,
}

impl Stream {
    /// All streams, in the order of their numbers in the file.
    pub const ALL: [Stream; 3] = [
        Stream::Gyroscope,
        Stream::Accelerometer,
        Stream::GyroscopeBias,
    ];

    /// Its name in the session and in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Stream::Gyroscope => "gyroscope",
            Stream::Accelerometer => "accelerometer",
            Stream::GyroscopeBias => "gyroscope_bias",
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Stream::Gyroscope | Stream::GyroscopeBias => "rad/s",
            Stream::Accelerometer => "m/s2",
        }
    }

    pub(super) const fn index(self) -> usize {
        match self {
            Stream::Gyroscope => 0,
            Stream::Accelerometer => 1,
            Stream::GyroscopeBias => 2,
        }
    }
}

/// One sensor as the phone describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorInfo {
    /// The stream that it fills.
    pub stream: Stream,
    /// The phone's name for it, e.g. `LSM6DSO`.
    pub name: String,
    /// Its full scale, in the stream's unit, where the phone tells.
    pub full_scale: Option<f64>,
}

/// What is known before the first sample.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Header {
    /// Model of the phone.
    pub phone: String,
    /// Its sensors.
    pub sensors: Vec<SensorInfo>,
    /// Anything else, by key.
    pub notes: BTreeMap<String, String>,
}

/// A mark: release, slip seen, sensor stopped, gap, end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Event {
    /// Stamp, ns of the phone's clock.
    pub stamp_ns: i64,
    /// What it marks, one word or a few.
    pub key: String,
}

/// Samples of one stream in the order they came.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// Their stream.
    pub stream: Stream,
    /// Stamps, ns of the phone's clock.
    pub stamps_ns: Vec<i64>,
    /// Values by sample (x, y, z), as many as stamps.
    pub values: Vec<[f64; 3]>,
}

impl Samples {
    /// A stream without samples.
    pub(super) fn none(stream: Stream) -> Self {
        Self {
            stream,
            stamps_ns: Vec::new(),
            values: Vec::new(),
        }
    }
}

/// What a block holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// What is known before the first sample.
    Header(Header),
    /// Samples of one stream, at most half a second of them.
    Samples(Samples),
    /// A mark.
    Event(Event),
    /// The recorder went on here after it had been stopped.
    Resumed {
        /// Bytes of the incomplete block that was cut off.
        cut_bytes: u64,
    },
}
