//! What the operator should know or do, as plain data with keys for translation.

use serde::{Deserialize, Serialize};

use super::estimate::{Estimate, LineKind, SensorState, SwingState, TimeLeft};
use gyradius_base::message::{Argument, Message};
use gyradius_recording::Sensor;

/// A motion beside the main one from this share on is worth another release.
const UNWANTED_SHARE: f64 = 0.05;
/// Below this amplitude friction and currents of air show more than inertia, degrees.
const LOW_AMPLITUDE_DEG: f64 = 2.0;
/// A sensor whose newest stamp is this far behind the other's has fallen silent, s.
const SILENT_AFTER_S: f64 = 1.0;

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

/// What follows from an estimate whose other fields stand; `known` is what was found beside it.
pub(super) fn advise(estimate: &Estimate, known: Vec<Advice>) -> Vec<Advice> {
    let mut advice: Vec<Advice> = estimate
        .sensors
        .iter()
        .filter_map(|s| silent(s, estimate.now_s))
        .collect();
    advice.extend(known);
    advice.extend(
        estimate
            .sensors
            .iter()
            .flat_map(|sensor| limits(sensor).into_iter().flatten()),
    );
    if let Some(swing) = &estimate.swing {
        advice.extend(of_swing(swing));
    }
    advice
}

fn silent(sensor: &SensorState, now_s: f64) -> Option<Advice> {
    let is_silent = now_s - sensor.last_s.unwrap_or(0.0) > SILENT_AFTER_S;
    is_silent.then_some(Advice::SensorSilent {
        sensor: sensor.sensor,
        since_s: sensor.last_s,
    })
}

fn limits(state: &SensorState) -> [Option<Advice>; 2] {
    let SensorState {
        sensor,
        saturated,
        gaps,
        longest_gap_s,
        ..
    } = *state;
    [
        (saturated > 0).then_some(Advice::Saturated {
            sensor,
            samples: saturated,
        }),
        (gaps > 0).then_some(Advice::Gaps {
            sensor,
            gaps,
            longest_s: longest_gap_s,
        }),
    ]
}

fn of_swing(swing: &SwingState) -> Vec<Advice> {
    let low = swing
        .amplitude_deg
        .filter(|amplitude_deg| *amplitude_deg < LOW_AMPLITUDE_DEG);
    let mut advice: Vec<Advice> = low
        .map(|amplitude_deg| Advice::AmplitudeLow { amplitude_deg })
        .into_iter()
        .collect();
    let unwanted = swing
        .lines
        .iter()
        .filter(|line| line.share >= UNWANTED_SHARE);
    advice.extend(unwanted.map(|line| Advice::Unwanted {
        kind: line.kind,
        share: line.share,
        period_s: line.period_s,
    }));
    match swing.time_left {
        TimeLeft::Reached => advice.push(Advice::LongEnough),
        TimeLeft::OutOfReach => advice.push(Advice::OutOfReach),
        TimeLeft::Seconds(_) => {}
    }
    advice
}
