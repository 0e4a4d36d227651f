//! The sensors and the swing at a moment, as plain data.

use serde::{Deserialize, Serialize};

use gyradius_recording::Sensor;

/// What a sensor does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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

/// The free swing as it stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct SwingState {
    /// Where the free swing begins, s: what comes before it is waiting, handling or another swing.
    pub from_s: f64,
    /// The moment that these figures are for, s.
    pub at_s: f64,
    /// Period of the main motion, s, at its mean amplitude since `from_s`.
    pub period_s: f64,
    /// Its standard uncertainty, s: noise, and how far the period of a longer record may still move
    /// away.
    pub period_u_s: f64,
    /// The part of it that noise makes, s: what the period of this record, at its own mean
    /// amplitude, is uncertain by. The wanted uncertainty is about this part.
    pub period_noise_u_s: f64,
    /// Amplitude of the main turn now, degrees; absent without a gyroscope.
    pub amplitude_deg: Option<f64>,
    /// Decay rate of the main motion now, 1/s.
    pub decay_per_s: f64,
    /// Time in which its amplitude halves at that rate, s; absent where it does not decay.
    pub half_s: Option<f64>,
    /// Motions beside the main one, largest first.
    pub lines: Vec<Line>,
    /// Until the wanted uncertainty of the period.
    pub time_left: TimeLeft,
}

/// A motion beside the main one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Line {
    /// Its period, s.
    pub period_s: f64,
    /// Its size over that of the main motion at the start of the free swing, both as angles: the
    /// turn that the gyroscope sees, or the angle of the lines that the accelerometer sees,
    /// whichever is larger.
    pub share: f64,
    /// What it looks like.
    pub kind: LineKind,
}

/// What a motion beside the main one looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LineKind {
    /// The lines swing and the hull hardly turns.
    Sway,
    /// A turn about another axis than the main one.
    OtherTurn,
    /// A turn about the main axis.
    SameTurn,
}

/// How long until the period is as certain as wanted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TimeLeft {
    /// It is.
    Reached,
    /// So many seconds more.
    Seconds(f64),
    /// The swing dies down before.
    OutOfReach,
}

impl SwingState {
    /// The same once it has been disturbed: it says no more than it does.
    pub(super) fn ended(&self) -> Self {
        let time_left = match self.time_left {
            TimeLeft::Reached => TimeLeft::Reached,
            TimeLeft::Seconds(_) | TimeLeft::OutOfReach => TimeLeft::OutOfReach,
        };
        Self {
            time_left,
            ..self.clone()
        }
    }

    /// The longest period of its motions, s.
    pub(super) fn slowest_s(&self) -> f64 {
        self.lines
            .iter()
            .map(|line| line.period_s)
            .fold(self.period_s, f64::max)
    }

    /// What it says of the period, for comparison.
    pub(super) fn worth(&self) -> f64 {
        self.period_s / self.period_u_s
    }
}
