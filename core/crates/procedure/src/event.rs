//! What can happen to a procedure, as plain data: what the operator does, and what the phone
//! reports.

use serde::{Deserialize, Serialize};

use gyradius_recording::recorder::{Header, SensorInfo, Stream};
use gyradius_recording::{Quantity, Sensor};

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case", deny_unknown_fields)]
pub enum Event {
    /// The operator begins.
    Begin {
        /// Wall clock, UTC, as text (`2026-05-04T09:30:00Z`); kept, never computed with.
        at_utc: String,
        /// The date where the hull hangs, as the session and its report tell it (`2026-05-04`); the
        /// day of `at_utc` where absent.
        #[serde(default)]
        measured_on: Option<String>,
        /// The phone.
        phone: PhoneInfo,
        /// How it is fixed to the hull.
        placement: Placement,
    },
    /// The hull is level now, by a spirit level or by eye: tilts count from here.
    SetReference,
    /// What was found is good: the level, the rest, the recording, the suggested swing.
    Accept,
    /// The rest or the recording is made again.
    Repeat,
    /// Done without: the rest, this step, the criticism, the suggested swing.
    Skip,
    /// The hull hangs as this step asks, and this was measured.
    Measured(Measured),
    /// The recording begins; the hull is let go afterwards.
    StartRecording {
        /// Wall clock, UTC, as text.
        at_utc: String,
    },
    /// The recording ends before its time.
    StopRecording,
    /// A recording that was cut off goes on.
    Continue,
    /// A recording that was cut off is judged as far as it goes.
    Keep,
    /// A step that is done is opened again; its recordings stay on the disk.
    Reopen {
        /// Its place among the steps, from 0.
        step: usize,
    },
    /// Work that failed is tried again.
    Retry,
    /// Samples of one stream in the order they came.
    Samples(Batch),
    /// The system took a sensor away.
    SensorStopped {
        /// Which.
        sensor: Sensor,
        /// When, ns of the phone's clock.
        stamp_ns: i64,
    },
    /// The operator saw the phone slip.
    SlipSeen {
        /// When, ns of the phone's clock.
        stamp_ns: i64,
    },
    /// The phone says that its disk is full.
    DiskFull,
    /// Time went by.
    Tick {
        /// Now, ns of the phone's clock.
        stamp_ns: i64,
    },
}

/// Samples of one stream.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Batch {
    /// Their stream.
    pub channel: Channel,
    /// Stamps, ns of the phone's clock.
    pub stamps_ns: Vec<i64>,
    /// (x, y, z) each, phone axes, rad/s or m/s² of specific force (at rest, screen up: z = +g).
    pub values: Vec<[f64; 3]>,
}

/// A stream of samples, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Rotation rate, rad/s.
    Gyroscope,
    /// Specific force, m/s².
    Accelerometer,
    /// The phone's own estimate of an uncalibrated gyroscope's bias, rad/s.
    GyroscopeBias,
}

impl From<Channel> for Stream {
    fn from(channel: Channel) -> Self {
        match channel {
            Channel::Gyroscope => Stream::Gyroscope,
            Channel::Accelerometer => Stream::Accelerometer,
            Channel::GyroscopeBias => Stream::GyroscopeBias,
        }
    }
}

/// The phone as it describes itself.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PhoneInfo {
    /// Model.
    pub model: String,
    /// Its sensors.
    pub sensors: Vec<PhoneSensor>,
}

/// One sensor of the phone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PhoneSensor {
    /// The stream that it fills.
    pub channel: Channel,
    /// The phone's name for it.
    pub name: String,
    /// Full scale, rad/s or m/s², where the phone tells.
    pub full_scale: Option<f64>,
}

impl PhoneInfo {
    pub(super) fn full_scale(&self, channel: Channel) -> Option<f64> {
        let of = self.sensors.iter().find(|sensor| sensor.channel == channel);
        of.and_then(|sensor| sensor.full_scale)
            .filter(|scale| *scale > 0.0 && scale.is_finite())
    }

    pub(super) fn header(&self) -> Header {
        let sensor = |one: &PhoneSensor| SensorInfo {
            stream: one.channel.into(),
            name: one.name.clone(),
            full_scale: one.full_scale,
        };
        Header {
            phone: self.model.clone(),
            sensors: self.sensors.iter().map(sensor).collect(),
            ..Header::default()
        }
    }
}

/// How the phone is fixed to the hull.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Placement {
    /// Flat on a surface that is level when the hull is, screen up, top edge to the bow: tilts are
    /// absolute.
    FlatTopToBow,
    /// Anyhow: a tilt has a size, and no direction, against the reading at which the operator said
    /// "level".
    #[default]
    AnyWay,
}

/// What the operator measured; what is absent stays as planned, or as measured for an earlier step
/// that hung alike, of the lines also for one on the same lines at another tilt.
///
/// An incline must be given its `mass_kg`, `arm_m` and `depth_m`: nothing else says how well they
/// are known.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Measured {
    /// Length of the lines, m.
    pub line_length_m: Option<Quantity>,
    /// Distance between the points on the hull, m.
    pub spacing_m: Option<Quantity>,
    /// Distance between the points above, m.
    pub top_spacing_m: Option<Quantity>,
    /// Bow-up angle, degrees.
    pub hull_pitch_deg: Option<Quantity>,
    /// How far forward the suspension points were moved, m.
    pub points_moved_m: Option<Quantity>,
    /// Height of the swing axis (compound), m.
    pub axis_height_m: Option<Quantity>,
    /// Weight of an incline, kg.
    pub mass_kg: Option<Quantity>,
    /// Its horizontal distance from the suspension points, m.
    pub arm_m: Option<Quantity>,
    /// Depth of its suspension point below the hull's, m.
    pub depth_m: Option<Quantity>,
}
