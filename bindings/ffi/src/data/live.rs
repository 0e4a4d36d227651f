//! Plain data of the module `live`: what the operator is told while the hull swings.

use gyradius_core::online::{
    Advice, Estimate, Gap, GapList, Line, LineKind, SensorState, SwingState, TimeLeft,
};
use gyradius_core::recording::Sensor;

/// Everything that is known at a moment.
pub type LiveEstimate = Estimate;

/// Everything that is known at a moment.
#[uniffi::remote(Record)]
pub struct LiveEstimate {
    /// The newest stamp of all sensors, s from the first; 0 before the first sample.
    pub now_s: f64,
    /// What each sensor does: gyroscope, accelerometer.
    pub sensors: Vec<SensorState>,
    /// Every gap of theirs.
    pub gaps: GapList,
    /// The swing, once there is one to speak of.
    pub swing: Option<SwingState>,
    /// What the operator should know or do, most urgent first.
    pub advice: Vec<LiveAdvice>,
}

/// What a sensor does.
#[uniffi::remote(Record)]
pub struct SensorState {
    /// Which one.
    pub sensor: Sensor,
    /// Its real rate, Hz, gaps not counted.
    pub rate_hz: Option<f64>,
    /// Samples taken in.
    pub samples: u64,
    /// Samples left out: stamps that repeat or step back, values that are not numbers.
    pub left_out: u64,
    /// Intervals of more than one and a half times the usual one.
    pub gaps: u64,
    /// The longest of them, s.
    pub longest_gap_s: f64,
    /// Samples at the sensor's limit.
    pub saturated: u64,
    /// The newest stamp, s.
    pub last_s: Option<f64>,
}

/// Every gap of a recording, as far as a list of them is of use.
#[uniffi::remote(Record)]
pub struct GapList {
    /// The gaps, first to last: the hundred longest of each sensor.
    pub listed: Vec<SensorGap>,
    /// How many more there are; each is shorter than what is listed of its sensor.
    pub more: u64,
}

/// A time without samples.
pub type SensorGap = Gap;

/// A time without samples.
#[uniffi::remote(Record)]
pub struct SensorGap {
    /// Whose.
    pub sensor: Sensor,
    /// The last stamp before it, s from the recording's first.
    pub from_s: f64,
    /// How long it lasted, s.
    pub length_s: f64,
}

/// The free swing as it stands.
#[uniffi::remote(Record)]
pub struct SwingState {
    /// Where the free swing begins, s.
    pub from_s: f64,
    /// The moment that these figures are for, s.
    pub at_s: f64,
    /// Period of the main motion, s, at its mean amplitude since `from_s`.
    pub period_s: f64,
    /// Its standard uncertainty, s: noise, and how far the period of a longer record may still move
    /// away.
    pub period_u_s: f64,
    /// The part of it that noise makes, s. The wanted uncertainty is about this part.
    pub period_noise_u_s: f64,
    /// Amplitude of the main turn now, degrees; absent without a gyroscope.
    pub amplitude_deg: Option<f64>,
    /// Decay rate of the main motion now, 1/s.
    pub decay_per_s: f64,
    /// Time in which its amplitude halves at that rate, s; absent where it does not decay.
    pub half_s: Option<f64>,
    /// Motions beside the main one, largest first.
    pub lines: Vec<SideMotion>,
    /// Until the wanted uncertainty of the period.
    pub time_left: TimeLeft,
}

/// A motion beside the main one.
pub type SideMotion = Line;

/// A motion beside the main one.
#[uniffi::remote(Record)]
pub struct SideMotion {
    /// Its period, s.
    pub period_s: f64,
    /// Its size over that of the main motion at the start of the free swing, both as angles.
    pub share: f64,
    /// What it looks like.
    pub kind: SideMotionKind,
}

/// What a motion beside the main one looks like.
pub type SideMotionKind = LineKind;

/// What a motion beside the main one looks like.
#[uniffi::remote(Enum)]
pub enum SideMotionKind {
    /// The lines swing and the hull hardly turns.
    Sway,
    /// A turn about another axis than the main one.
    OtherTurn,
    /// A turn about the main axis.
    SameTurn,
}

/// How long until the period is as certain as wanted.
#[uniffi::remote(Enum)]
pub enum TimeLeft {
    /// It is.
    Reached,
    /// So many seconds more.
    Seconds(f64),
    /// The swing dies down before.
    OutOfReach,
}

/// One piece of advice.
pub type LiveAdvice = Advice;

/// One piece of advice; `live_sentence` gives its sentence.
#[uniffi::remote(Enum)]
pub enum LiveAdvice {
    /// A sensor gives no more samples.
    SensorSilent {
        /// Which.
        sensor: Sensor,
        /// Its last stamp, s; absent where it never gave one.
        since_s: Option<f64>,
    },
    /// The phone sits another way on the hull than before.
    PhoneMoved {
        /// When, s.
        at_s: f64,
        /// By how much it tilted, degrees.
        tilt_deg: f64,
    },
    /// The swing was disturbed.
    Touched {
        /// When, s.
        at_s: f64,
    },
    /// Samples stood at a sensor's limit.
    Saturated {
        /// Which sensor.
        sensor: Sensor,
        /// How many samples.
        samples: u64,
    },
    /// Samples are missing.
    Gaps {
        /// Of which sensor.
        sensor: Sensor,
        /// How many gaps.
        gaps: u64,
        /// The longest, s.
        longest_s: f64,
    },
    /// The main turn is too small.
    AmplitudeLow {
        /// Its amplitude, degrees.
        amplitude_deg: f64,
    },
    /// A motion beside the main one is too large.
    Unwanted {
        /// What it looks like.
        kind: SideMotionKind,
        /// Its size over that of the main motion.
        share: f64,
        /// Its period, s.
        period_s: f64,
    },
    /// The swing will die down before the period is as certain as wanted.
    OutOfReach,
    /// The period is as certain as wanted.
    LongEnough,
}
