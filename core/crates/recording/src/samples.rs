//! What the sensors wrote, on their own clocks, with every repair listed.

use serde::{Deserialize, Serialize};

/// Which sensor.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Sensor {
    /// Rotation rate, rad/s.
    Gyroscope,
    /// Specific force, m/s² (at rest, screen up: z = +g).
    Accelerometer,
    /// Acceleration with gravity already taken out by the phone, m/s².
    LinearAccelerometer,
    /// A rangefinder's displacement, m.
    Displacement,
    /// A stopwatch or photogate: times and periods, s.
    Timer,
}

impl Sensor {
    /// What files call one of its axes; nothing where it has none.
    pub(crate) fn axis_name(self, axis: usize) -> &'static str {
        let triad = TRIADS.iter().find(|(sensor, _)| *sensor == self);
        triad
            .and_then(|(_, axes)| axes.get(axis))
            .copied()
            .unwrap_or_default()
    }

    /// What a report calls it.
    pub const fn name(self) -> &'static str {
        match self {
            Sensor::Gyroscope => "gyroscope",
            Sensor::Accelerometer => "accelerometer",
            Sensor::LinearAccelerometer => "gravity-free accelerometer",
            Sensor::Displacement => "rangefinder",
            Sensor::Timer => "timer",
        }
    }
}

/// Three axes of one sensor on its own clock, phone axes. All vectors have the same length; `t_s`
/// increases strictly.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Triad {
    /// Time stamps, s.
    pub t_s: Vec<f64>,
    /// Samples by axis: `axes[0]` is x.
    pub axes: [Vec<f64>; 3],
}

/// The three-axis sensors with the names of their axes in files.
pub(crate) const TRIADS: [(Sensor, [&str; 3]); 3] = [
    (Sensor::Gyroscope, ["gx", "gy", "gz"]),
    (Sensor::Accelerometer, ["ax", "ay", "az"]),
    (Sensor::LinearAccelerometer, ["lx", "ly", "lz"]),
];

/// A sensor of which one or two axes were recorded: what is missing is not zero, and nothing that
/// takes a vector can take it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PartialTriad {
    /// Which sensor.
    pub sensor: Sensor,
    /// Time stamps, s, strictly increasing.
    pub t_s: Vec<f64>,
    /// Samples by axis, x first; none of an axis that was not recorded.
    pub axes: [Option<Vec<f64>>; 3],
}

/// The channels that one sensor recorded, whether they are all of it or not.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorChannels<'a> {
    /// Which sensor.
    pub sensor: Sensor,
    /// Time stamps, s, strictly increasing.
    pub t_s: &'a [f64],
    /// Samples by the name of the channel in files: `gx`, `rate`.
    pub channels: Vec<(&'static str, &'a [f64])>,
}

/// A phone's recording after its repairs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Recording {
    /// File name as the user knows it.
    pub name: String,
    /// Gyroscope, rad/s.
    pub gyroscope: Option<Triad>,
    /// Accelerometer, specific force, m/s².
    pub accelerometer: Option<Triad>,
    /// Gravity-free acceleration, m/s², where the phone gave that instead.
    pub linear_accelerometer: Option<Triad>,
    /// Sensors of which one or two axes were recorded, at most one of a kind, in place of the whole
    /// one of that kind.
    #[serde(default)]
    pub incomplete: Vec<PartialTriad>,
    /// One channel of a motion of one degree of freedom, in place of all of these.
    #[serde(default)]
    pub single: Option<Channel>,
    /// What was found wrong and how it was treated.
    pub repairs: Vec<Repair>,
    /// When the swing was disturbed, s, by the marks of who recorded it: no free swing goes across.
    #[serde(default)]
    pub disturbed_s: Vec<f64>,
    /// When samples were left out because a sensor was at its limit, s, in time order.
    #[serde(default)]
    pub at_limit_s: Vec<f64>,
}

/// A rangefinder's track.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Track {
    /// File name as the user knows it.
    pub name: String,
    /// Time, s, strictly increasing.
    pub t_s: Vec<f64>,
    /// Displacement, m.
    pub y_m: Vec<f64>,
    /// Repairs.
    pub repairs: Vec<Repair>,
}

/// What a single channel holds.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum ChannelQuantity {
    /// Angle about the axis of the motion, rad.
    Angle,
    /// Rotation rate about the axis of the motion, rad/s.
    Rate,
}

impl ChannelQuantity {
    /// What a report, and the column of a file, call it.
    pub const fn name(self) -> &'static str {
        match self {
            ChannelQuantity::Angle => "angle",
            ChannelQuantity::Rate => "rate",
        }
    }

    /// What reads it.
    pub const fn sensor(self) -> Sensor {
        match self {
            ChannelQuantity::Angle => Sensor::Displacement,
            ChannelQuantity::Rate => Sensor::Gyroscope,
        }
    }
}

/// The samples of a single channel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Channel {
    /// What it measured.
    pub quantity: ChannelQuantity,
    /// Time, s, strictly increasing.
    pub t_s: Vec<f64>,
    /// Values, rad or rad/s.
    pub values: Vec<f64>,
}

impl Recording {
    /// Every sensor with the axes that it recorded, in the order of a written recording.
    pub fn sensors(&self) -> Vec<SensorChannels<'_>> {
        let mut all = Vec::new();
        for (sensor, names) in TRIADS {
            let whole = match sensor {
                Sensor::Gyroscope => &self.gyroscope,
                Sensor::Accelerometer => &self.accelerometer,
                _ => &self.linear_accelerometer,
            };
            let partial = self.incomplete.iter().find(|one| one.sensor == sensor);
            let (t_s, axes): (&[f64], [Option<&[f64]>; 3]) = match (whole, partial) {
                (Some(whole), _) => (&whole.t_s, whole.axes.each_ref().map(|x| Some(&**x))),
                (None, Some(partial)) => {
                    (&partial.t_s, partial.axes.each_ref().map(Option::as_deref))
                }
                (None, None) => continue,
            };
            let channels = names.into_iter().zip(axes);
            all.push(SensorChannels {
                sensor,
                t_s,
                channels: channels
                    .filter_map(|(name, samples)| Some((name, samples?)))
                    .collect(),
            });
        }
        all.extend(self.single.iter().map(|channel| SensorChannels {
            sensor: channel.quantity.sensor(),
            t_s: &channel.t_s,
            channels: vec![(channel.quantity.name(), &channel.values)],
        }));
        all
    }

    /// What the only channel measured, where it tells a motion of one degree of freedom: an angle, a
    /// rate, or one axis of a gyroscope with nothing beside it.
    pub fn lone_quantity(&self) -> Option<ChannelQuantity> {
        match (&self.single, &self.sensors()[..]) {
            (Some(channel), _) => Some(channel.quantity),
            (None, [one]) if one.sensor == Sensor::Gyroscope && one.channels.len() == 1 => {
                Some(ChannelQuantity::Rate)
            }
            _ => None,
        }
    }
}

impl From<SingleChannel> for Recording {
    fn from(channel: SingleChannel) -> Self {
        Recording {
            name: channel.name,
            single: Some(Channel {
                quantity: channel.quantity,
                t_s: channel.t_s,
                values: channel.values,
            }),
            repairs: channel.repairs,
            at_limit_s: channel.at_limit_s,
            ..Recording::default()
        }
    }
}

/// One channel of a motion of one degree of freedom: an encoder, a video tracker.
#[derive(Debug, Clone, PartialEq)]
pub struct SingleChannel {
    /// File name as the user knows it.
    pub name: String,
    /// What it measured.
    pub quantity: ChannelQuantity,
    /// Time, s, strictly increasing.
    pub t_s: Vec<f64>,
    /// Values, rad or rad/s.
    pub values: Vec<f64>,
    /// Repairs.
    pub repairs: Vec<Repair>,
    /// When samples were left out because the sensor was at its limit, s, in time order.
    pub at_limit_s: Vec<f64>,
}

/// A list of periods in time order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PeriodList {
    /// File name as the user knows it.
    pub name: String,
    /// Time of each period (its middle), s.
    pub t_s: Vec<f64>,
    /// Period, s.
    pub period_s: Vec<f64>,
    /// Repairs.
    pub repairs: Vec<Repair>,
}

/// A two-gate timer's log: one entry per beam edge, with the state of both gates after it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct GateEvents {
    /// Time of each edge, s, increasing.
    pub t_s: Vec<f64>,
    /// Gate A is blocked from this edge on.
    pub a: Vec<bool>,
    /// Gate B is blocked from this edge on.
    pub b: Vec<bool>,
}

/// The kinds of damage a recording can have.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum RepairKind {
    /// Time stamps scatter about their rate by more than a twentieth of the interval: used as they
    /// stand.
    Jitter,
    /// A time stamp repeats the one before: the repeated row is dropped for that sensor.
    RepeatedStamp,
    /// A time stamp steps back: the row is dropped for that sensor.
    BackwardStamp,
    /// Rows are missing (gap of 1.5 to 10 intervals): left as a gap.
    MissingRows,
    /// The record stood still (gap over 10 intervals): left as a gap.
    Stall,
    /// Cells that are not numbers (NaN, inf): the row is dropped for that sensor.
    NotANumber,
    /// Samples at the sensor's limit: dropped for that sensor.
    Saturation,
    /// A pause, put back from the system clock.
    Pause,
    /// Parts that the recorder's file had lost before it became this recording.
    LostByRecorder,
    /// A second swing (hull touched or released again): only the longest is used.
    SecondSwing,
    /// Different samples share a stamp (packets, stamps in whole seconds): spread evenly from one
    /// stamp to the next.
    SharedStamps,
    /// The clock steps ahead by more than the record can hold, or a few rows stand alone beyond a
    /// gap: what lies beyond is dropped.
    StampStep,
    /// A sensor's stamps lie outside those of the others, as with a clock of its own: the sensor is
    /// dropped.
    OtherClock,
    /// Columns, files or sensors of an export that the import did not use.
    NotImported,
    /// What a recorder writes where it has no reading (−999): a value that comes time and again, far
    /// from all others. The row is dropped for that sensor.
    NoReading,
}

/// One kind of damage of one sensor: how often, where first and last, what was done.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Repair {
    /// Kind.
    pub kind: RepairKind,
    /// Sensor.
    pub sensor: Sensor,
    /// How many samples or gaps.
    pub count: usize,
    /// Time of the first, s.
    pub first_s: f64,
    /// Time of the last, s.
    pub last_s: f64,
    /// A sentence for the report: what was found and what was done.
    pub text: String,
}
