//! What the operator should know or do, as plain data with keys for translation.

use serde::{Deserialize, Serialize};

use super::state::LineKind;
use gyradius_base::message::{Argument, Message};
use gyradius_recording::Sensor;

/// One piece of advice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Advice {
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
        kind: LineKind,
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

impl Advice {
    /// The key of its sentence.
    const fn key(&self) -> &'static str {
        match self {
            Advice::SensorSilent {
                since_s: Some(_), ..
            } => "sensor_silent",
            Advice::SensorSilent { since_s: None, .. } => "sensor_absent",
            Advice::PhoneMoved { .. } => "phone_moved",
            Advice::Touched { .. } => "touched",
            Advice::Saturated { .. } => "saturated",
            Advice::Gaps { .. } => "gaps",
            Advice::AmplitudeLow { .. } => "amplitude_low",
            Advice::Unwanted {
                kind: LineKind::Sway,
                ..
            } => "sway",
            Advice::Unwanted {
                kind: LineKind::OtherTurn,
                ..
            } => "other_turn",
            Advice::Unwanted {
                kind: LineKind::SameTurn,
                ..
            } => "same_turn",
            Advice::OutOfReach => "out_of_reach",
            Advice::LongEnough => "long_enough",
        }
    }

    /// The advice as a message.
    pub fn message(&self) -> Message {
        Message::new(format!("live.{}", self.key()), self.arguments())
    }

    /// What its sentence names, by the name that stands in it.
    fn arguments(&self) -> Vec<(&'static str, Argument)> {
        use Argument::Number;
        match *self {
            Advice::SensorSilent { sensor, since_s } => {
                let since = since_s.map(|since_s| ("since_s", Number(since_s, 0)));
                [("sensor", word(sensor))]
                    .into_iter()
                    .chain(since)
                    .collect()
            }
            Advice::PhoneMoved { at_s, tilt_deg } => {
                vec![("at_s", Number(at_s, 0)), ("tilt_deg", Number(tilt_deg, 0))]
            }
            Advice::Touched { at_s } => vec![("at_s", Number(at_s, 0))],
            Advice::Saturated { sensor, samples } => {
                vec![
                    ("sensor", word(sensor)),
                    ("samples", Number(samples as f64, 0)),
                ]
            }
            Advice::Gaps {
                sensor,
                gaps,
                longest_s,
            } => vec![
                ("sensor", word(sensor)),
                ("gaps", Number(gaps as f64, 0)),
                ("longest_s", Number(longest_s, 2)),
            ],
            Advice::AmplitudeLow { amplitude_deg } => {
                vec![("amplitude_deg", Number(amplitude_deg, 1))]
            }
            Advice::Unwanted {
                share, period_s, ..
            } => {
                vec![
                    ("percent", Number(100.0 * share, 0)),
                    ("period_s", Number(period_s, 2)),
                ]
            }
            Advice::OutOfReach | Advice::LongEnough => Vec::new(),
        }
    }
}

/// A sensor's name, a word with a key.
fn word(sensor: Sensor) -> Argument {
    Argument::Word(sensor.name().replace(' ', "_"))
}
