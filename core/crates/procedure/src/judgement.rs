//! What is to be thought of a recording that has ended, and whether it should be repeated.

use serde::{Deserialize, Serialize};

use super::rest::RestReader;
use super::words::{self, number, words};
use gyradius_base::frames::Vec3;
use gyradius_base::message::Message;
use gyradius_identification::measure::PHONE_TILT_U_DEG;
use gyradius_planning::{PlannedIncline, PlannedSwing};
use gyradius_recording::{Excitation, Sensor};
use gyradius_signal::online::{Advice, Estimate, GapList, Line, LineKind, SwingState, TimeLeft};

/// A motion that nobody asked for is worth another release from this share of the main one on: as
/// the live advice has it.
const UNWANTED_SHARE: f64 = 0.05;
/// A release below this part of the planned amplitude, or above this multiple of it, is a bad one.
pub(super) const TOO_SMALL: f64 = 0.6;
pub(super) const TOO_LARGE: f64 = 1.6;
/// A gap of more than this is worth another recording, s.
const LONG_GAP_S: f64 = 1.0;
/// A sensor that was silent at the end for longer than this did not record the swing, s.
const SILENT_S: f64 = 1.0;
/// An incline is another one than planned where it differs by more than this part of it and this
/// angle, degrees.
const FAR_PART: f64 = 0.3;
const FAR_DEG: f64 = 1.0;

/// What is to be thought of a recording.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Judgement {
    /// What the operator is advised to do; it is theirs to decide.
    pub recommend: Recommend,
    /// Why it should be repeated, the gravest first; empty where it is good.
    pub reasons: Vec<Message>,
    /// What else to know.
    pub notes: Vec<Message>,
    /// So much was recorded, s.
    pub recorded_s: f64,
    /// The free swing that says most of the period.
    pub swing: Option<SwingState>,
    /// Amplitude after the release, degrees.
    pub released_deg: Option<f64>,
    /// The tilt of an incline.
    pub incline: Option<InclineReading>,
    /// Every gap of a swing's recording.
    #[serde(default)]
    pub gaps: GapList,
}

/// Advice for the end of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Recommend {
    /// It is good.
    Accept,
    /// It should be made again.
    Repeat,
}

/// The tilt that a weight makes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct InclineReading {
    /// Angle between gravity at rest and with the weight, degrees.
    pub angle_deg: f64,
    /// Its standard uncertainty, degrees.
    pub u_deg: f64,
}

/// What is known of a swing's recording when it ends.
pub(super) struct Heard<'a> {
    pub estimate: &'a Estimate,
    pub recorded_s: f64,
    pub released_deg: Option<f64>,
    pub slip_seen: bool,
    pub stopped: &'a [Sensor],
    pub resumed: bool,
}

impl Judgement {
    pub(super) fn of_swing(planned: &PlannedSwing, heard: &Heard) -> Self {
        let swing = heard.estimate.swing.as_ref();
        let mut notes: Vec<Message> = Vec::new();
        let mut reasons: Vec<Message> = Vec::new();
        if heard.slip_seen {
            reasons.push(Message::new("reason_slip_seen", []));
        }
        for advice in &heard.estimate.advice {
            of_advice(advice, swing, &mut reasons, &mut notes);
        }
        let silent =
            |sensor: &Sensor| Message::new("reason_silent", [("sensor", words::sensor(*sensor))]);
        reasons.extend(heard.stopped.iter().map(silent));
        match swing {
            None => reasons.push(Message::new("reason_no_swing", [])),
            Some(swing) => {
                reasons.extend(
                    swing
                        .lines
                        .iter()
                        .filter(|line| is_unwanted(line, planned))
                        .map(unwanted),
                );
                of_period(swing, planned.period_u_wanted, &mut reasons, &mut notes);
                of_amplitude(
                    swing,
                    planned.amplitude_deg,
                    heard.released_deg,
                    &mut reasons,
                    &mut notes,
                );
            }
        }
        if heard.resumed {
            notes.push(Message::new("note_interrupted", []));
        }
        let gaps = heard.estimate.gaps.clone();
        Self {
            gaps,
            ..Self::from(
                reasons,
                notes,
                heard.recorded_s,
                swing.cloned(),
                heard.released_deg,
            )
        }
    }

    pub(super) fn of_incline(
        planned: &PlannedIncline,
        still: &RestReader,
        level: Option<Vec3>,
        recorded_s: f64,
    ) -> Self {
        let mut reasons = Vec::new();
        if still.still_s() < still.wanted_s() {
            reasons.push(Message::new(
                "reason_moving",
                [("wanted_s", number(still.wanted_s(), 0))],
            ));
        }
        let angle_deg = level
            .zip(still.up())
            .map(|(level, up)| level.angle(&up).to_degrees());
        match angle_deg {
            None => reasons.push(Message::new("reason_no_tilt", [])),
            Some(angle_deg) => {
                let expected_deg = planned.pitch_deg.abs();
                if (angle_deg - expected_deg).abs() > (FAR_PART * expected_deg).max(FAR_DEG) {
                    let arguments = [
                        ("angle_deg", number(angle_deg, 2)),
                        ("expected_deg", number(expected_deg, 2)),
                    ];
                    reasons.push(Message::new("reason_far", arguments));
                }
            }
        }
        let note = |angle_deg| Message::new("note_tilt", [("angle_deg", number(angle_deg, 2))]);
        let notes = angle_deg.map(note).into_iter().collect();
        let incline = angle_deg.map(|angle_deg| InclineReading {
            angle_deg,
            u_deg: PHONE_TILT_U_DEG,
        });
        Self {
            incline,
            ..Self::from(reasons, notes, recorded_s, None, None)
        }
    }

    fn from(
        reasons: Vec<Message>,
        notes: Vec<Message>,
        recorded_s: f64,
        swing: Option<SwingState>,
        released_deg: Option<f64>,
    ) -> Self {
        let recommend = if reasons.is_empty() {
            Recommend::Accept
        } else {
            Recommend::Repeat
        };
        Self {
            recommend,
            reasons,
            notes,
            recorded_s,
            swing,
            released_deg,
            incline: None,
            gaps: GapList::default(),
        }
    }
}

/// What the live estimator found that stays true after the end.
fn of_advice(
    advice: &Advice,
    swing: Option<&SwingState>,
    reasons: &mut Vec<Message>,
    notes: &mut Vec<Message>,
) {
    match *advice {
        Advice::PhoneMoved { at_s, tilt_deg } => reasons.push(Message::new(
            "reason_slip",
            [("at_s", number(at_s, 0)), ("tilt_deg", number(tilt_deg, 1))],
        )),
        Advice::Touched { at_s } => {
            let enough = swing.is_some_and(|swing| swing.time_left == TimeLeft::Reached);
            let (key, to) = if enough {
                ("note_touched", notes)
            } else {
                ("reason_touched", reasons)
            };
            to.push(Message::new(key, [("at_s", number(at_s, 0))]));
        }
        Advice::Saturated { sensor, samples } => reasons.push(Message::new(
            "reason_saturated",
            [
                ("sensor", words::sensor(sensor)),
                ("samples", number(samples as f64, 0)),
            ],
        )),
        Advice::Gaps {
            sensor, longest_s, ..
        } if longest_s > LONG_GAP_S => reasons.push(Message::new(
            "reason_gaps",
            [
                ("sensor", words::sensor(sensor)),
                ("longest_s", number(longest_s, 1)),
            ],
        )),
        Advice::Gaps {
            sensor,
            gaps,
            longest_s,
        } => notes.push(Message::new(
            "note_gaps",
            [
                ("sensor", words::sensor(sensor)),
                ("gaps", number(gaps as f64, 0)),
                ("longest_s", number(longest_s, 2)),
            ],
        )),
        Advice::SensorSilent { sensor, since_s }
            if since_s.is_none_or(|since_s| since_s > SILENT_S) =>
        {
            reasons.push(Message::new(
                "reason_silent",
                [("sensor", words::sensor(sensor))],
            ));
        }
        // Amplitude, unwanted motion and what is reached are judged against what was planned.
        Advice::SensorSilent { .. }
        | Advice::AmplitudeLow { .. }
        | Advice::Unwanted { .. }
        | Advice::OutOfReach
        | Advice::LongEnough => {}
    }
}

/// Whether a motion beside the main one was not asked for.
pub(super) fn is_unwanted(line: &Line, planned: &PlannedSwing) -> bool {
    let asked = |wanted: &[Excitation]| planned.excited.iter().any(|one| wanted.contains(one));
    let turns = planned.excited.iter().filter(|one| one.turns());
    let fine = match line.kind {
        // A hull that pitches or surges on two lines has two modes that turn about the same axis,
        // and one of them mostly swings along.
        LineKind::Sway => asked(&[
            Excitation::Sway,
            Excitation::Surge,
            Excitation::Pitch,
            Excitation::Roll,
        ]),
        LineKind::SameTurn => asked(&[
            Excitation::Pitch,
            Excitation::Roll,
            Excitation::Surge,
            Excitation::Sway,
        ]),
        LineKind::OtherTurn => turns.count() > 1,
    };
    line.share >= UNWANTED_SHARE && !fine
}

fn unwanted(line: &Line) -> Message {
    let kind = if line.kind == LineKind::Sway {
        "sway"
    } else {
        "turn"
    };
    let arguments = [
        ("kind", words(std::iter::once(kind))),
        ("percent", number(100.0 * line.share, 0)),
        ("period_s", number(line.period_s, 2)),
    ];
    Message::new("reason_sway", arguments)
}

fn of_period(
    swing: &SwingState,
    wanted: f64,
    reasons: &mut Vec<Message>,
    notes: &mut Vec<Message>,
) {
    let u = swing.period_noise_u_s / swing.period_s;
    let (key, to) = if u <= wanted {
        ("note_period", notes)
    } else {
        ("reason_period", reasons)
    };
    to.push(Message::new(
        key,
        [
            ("u_ppm", number(1e6 * u, 0)),
            ("wanted_ppm", number(1e6 * wanted, 0)),
        ],
    ));
}

fn of_amplitude(
    swing: &SwingState,
    wanted_deg: f64,
    released_deg: Option<f64>,
    reasons: &mut Vec<Message>,
    notes: &mut Vec<Message>,
) {
    let Some(released_deg) = released_deg else {
        return;
    };
    let arguments = [
        ("released_deg", number(released_deg, 1)),
        ("wanted_deg", number(wanted_deg, 1)),
    ];
    if released_deg < TOO_SMALL * wanted_deg {
        reasons.push(Message::new("reason_small", arguments));
    } else if released_deg > TOO_LARGE * wanted_deg {
        reasons.push(Message::new("reason_large", arguments));
    }
    if let Some(left_deg) = swing.amplitude_deg {
        let arguments = [
            ("released_deg", number(released_deg, 1)),
            ("left_deg", number(left_deg, 1)),
        ];
        notes.push(Message::new("note_amplitude", arguments));
    }
}
