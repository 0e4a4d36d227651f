//! Where a procedure stands, as plain data: everything that a screen shows.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::judgement::Judgement;
use super::rest::{Moving, Rest};
use super::tilt::Tilt;
use gyradius_base::message::Message;
use gyradius_base::message::text_and_said;
use gyradius_base::message::warnings_and_said;
use gyradius_diagnosis::Status;
use gyradius_identification::{QuantityName, QuantityResult};
use gyradius_planning::Step;
use gyradius_recording::Suspension;
use gyradius_signal::online::Estimate;

/// Everything that a screen shows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct State {
    /// Where the procedure stands.
    pub phase: Phase,
    /// What the operator should do now.
    pub instruction: Message,
    /// What the operator may do now; any other event is refused.
    pub actions: Vec<Action>,
    /// The present step.
    pub step: Option<StepView>,
    /// How far the whole is.
    pub progress: Progress,
    /// The hull's tilt, while it is of use.
    pub tilt: Option<Tilt>,
    /// The rest, while it is taken.
    pub rest: Option<RestView>,
    /// The recording, while it runs or lies interrupted.
    pub recording: Option<RecordingView>,
    /// What is to be thought of the recording that has ended.
    pub judgement: Option<Judgement>,
    /// Work that wants to be done on another thread.
    pub work: Option<Work>,
    /// The result, once there is one.
    pub result: Option<ResultView>,
    /// The criticism, once there is one.
    pub critique: Option<CritiqueView>,
    /// A further swing that is suggested.
    pub suggestion: Option<Step>,
    /// What the operator must know.
    pub warnings: Vec<Message>,
}

/// Where the procedure stands.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Nothing has been done.
    Start,
    /// The hull is being hung level.
    Level,
    /// The hull is left alone while the sensors are read.
    Rest,
    /// The hull is being hung as the step asks, and measured.
    Hang,
    /// It hangs so; the recording may begin.
    Ready,
    /// The recording runs.
    Record,
    /// The recording was cut off.
    Interrupted,
    /// The recording has ended and is to be accepted or repeated.
    Judge,
    /// All steps are done: the session wants to be measured.
    Measure,
    /// The measurement did not come to a result.
    Failed,
    /// The result is there and wants to be criticised.
    Critique,
    /// A further swing is suggested.
    Suggest,
    /// Nothing is left to do.
    Done,
}

/// What an operator can do.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum Action {
    Begin,
    SetReference,
    Accept,
    Repeat,
    Skip,
    Measured,
    StartRecording,
    StopRecording,
    Continue,
    Keep,
    Reopen,
    Retry,
    /// Not an event: call `job`, run it on a thread of its own, and hand back what it gives.
    Work,
}

/// The present step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct StepView {
    /// Its place among the steps, from 0.
    pub index: usize,
    /// How many steps there are.
    pub count: usize,
    /// Its id; an incline's is `incline-bow` or `incline-stern`.
    pub id: String,
    /// Number of the recording, from 1; 0 before the first.
    pub take: usize,
    /// As planned.
    pub planned: Step,
    /// How a swing hangs as far as it was measured, and as planned otherwise.
    pub hanging: Option<Suspension>,
}

/// How far the whole is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Progress {
    /// Steps that are done or left out.
    pub steps_done: usize,
    /// All steps.
    pub steps: usize,
    /// Share of the whole, level, rest and work included, 0 to 1.
    pub share: f64,
    /// Recording time that is still to come, s.
    pub recording_left_s: f64,
}

/// The rest while it is taken.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct RestView {
    /// So long everything has been still, s.
    pub still_s: f64,
    /// So long it must be, s.
    pub wanted_s: f64,
    /// How the hull moved when it last did.
    pub moving: Option<Moving>,
    /// What was found, once it was still for long enough.
    pub found: Option<Rest>,
}

/// The recording while it runs, or as far as it goes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Default, schemars::JsonSchema)]
pub struct RecordingView {
    /// File inside the procedure's folder.
    pub file: String,
    /// So much was recorded, s.
    pub recorded_s: f64,
    /// So long the hull has been swinging freely, s; absent before the release.
    pub swinging_s: Option<f64>,
    /// The recording ends by itself after so much more, s; absent before the release.
    pub left_s: Option<f64>,
    /// Amplitude of the latest half swing, degrees.
    pub amplitude_deg: Option<f64>,
    /// Amplitude after the release, degrees.
    pub released_deg: Option<f64>,
    /// What the planned amplitude is, degrees.
    pub wanted_deg: Option<f64>,
    /// Stillness of an incline, s.
    pub still_s: Option<f64>,
    /// The live estimate; absent for inclines and interrupted recordings.
    pub live: Option<Estimate>,
    /// What to know or do, most urgent first.
    pub advice: Vec<Message>,
}

/// Work for another thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Work {
    /// The session is written and measured: seconds.
    Measure,
    /// Its result is criticised: minutes.
    Critique,
}

/// The result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ResultView {
    /// Folder of the session, inside the procedure's.
    pub session: String,
    /// The joint estimate by quantity.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
    /// What a reader must know.
    #[serde(flatten, with = "warnings_and_said")]
    #[schemars(with = "warnings_and_said::WarningsAndSaid")]
    pub warnings: Vec<Message>,
}

/// What the criticism says in short.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CritiqueView {
    /// Which of the four verdicts.
    pub status: Status,
    /// In words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
    /// How many causes these swings cannot tell apart; 0 where none is in doubt.
    pub causes: usize,
    /// The figures by the simulation with the causes that were found in it.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
}
