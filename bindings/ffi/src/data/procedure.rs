//! Plain data of the room `procedure`: what happens, and everything that a screen shows.

use std::collections::{BTreeMap, HashMap};

use gyradius_core::procedure::{
    Action, Against, Argument, Batch, Channel, CritiqueView, Event, InclineReading, Judgement, Measured,
    Moving, Phase, PhoneInfo, PhoneSensor, Placement, Progress, Recommend, RecordingView, Rest, RestView,
    ResultView, SensorRest, State, StepView, Task, Text, Tilt, Work,
};
use gyradius_core::recording::{Attachment, Quantity, Sensor, Site, Suspension};

use super::live::LiveEstimate;
use super::plan::PlanStep;
use super::recording::HullBody;
use super::{Count, QuantitiesByName, Vector3};
use gyradius_core::live::SwingState;

/// What is known of the hull, and what is to be done with it.
pub type ProcedureTask = Task;

/// What is known of the hull, and what is to be done with it, in order.
#[uniffi::remote(Record)]
pub struct ProcedureTask {
    /// Title of the session to come.
    pub title: String,
    /// The body that swings.
    pub body: HullBody,
    /// Where it swings.
    pub site: Site,
    /// What rides on the hull and is taken off the result.
    pub attachments: Vec<Attachment>,
    /// What to do, in this order.
    pub steps: Vec<PlanStep>,
}

/// Something that happened.
pub type ProcedureEvent = Event;

/// Something that happened.
#[uniffi::remote(Enum)]
pub enum ProcedureEvent {
    /// The operator begins.
    Begin {
        /// Wall clock, UTC, as text (`2026-05-04T09:30:00Z`); kept, never computed with.
        at_utc: String,
        /// The phone.
        phone: PhoneInfo,
        /// How it is fixed to the hull.
        placement: Placement,
    },
    /// The hull is level now: tilts count from here.
    SetReference,
    /// What was found is good: the level, the rest, the recording, the suggested swing.
    Accept,
    /// The rest or the recording is made again.
    Repeat,
    /// Done without: the rest, this step, the criticism, the suggested swing.
    Skip,
    /// The hull hangs as this step asks, and this was measured.
    Measured(MeasuredDimensions),
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
        step: Count,
    },
    /// Work that failed is tried again.
    Retry,
    /// Samples of one stream in the order they came; `push` takes the same as a block.
    Samples(SampleBatch),
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
pub type SampleBatch = Batch;

/// Samples of one stream.
#[uniffi::remote(Record)]
pub struct SampleBatch {
    /// Their stream.
    pub channel: Channel,
    /// Stamps, ns of the phone's clock.
    pub stamps_ns: Vec<i64>,
    /// Values, phone axes, rad/s or m/s² of specific force.
    pub values: Vec<Vector3>,
}

/// The phone as it describes itself.
#[uniffi::remote(Record)]
pub struct PhoneInfo {
    /// Model.
    pub model: String,
    /// Its sensors.
    pub sensors: Vec<PhoneSensor>,
}

/// One sensor of the phone.
#[uniffi::remote(Record)]
pub struct PhoneSensor {
    /// The stream that it fills.
    pub channel: Channel,
    /// The phone's name for it.
    pub name: String,
    /// Full scale, rad/s or m/s², where the phone tells.
    pub full_scale: Option<f64>,
}

/// How the phone is fixed to the hull.
#[uniffi::remote(Enum)]
pub enum Placement {
    /// Flat, screen up, top edge to the bow: tilts are absolute.
    FlatTopToBow,
    /// Anyhow: a tilt has a size and no direction, against the reading at which the operator said "level".
    AnyWay,
}

/// What the operator measured; what is absent stays as planned.
pub type MeasuredDimensions = Measured;

/// What the operator measured; what is absent stays as planned.
#[uniffi::remote(Record)]
pub struct MeasuredDimensions {
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

/// Everything that a screen shows.
pub type ProcedureState = State;

/// Everything that a screen shows.
#[uniffi::remote(Record)]
pub struct ProcedureState {
    /// Where the procedure stands.
    pub phase: ProcedurePhase,
    /// What the operator should do now.
    pub instruction: Sentence,
    /// What the operator may do now; any other event is refused.
    pub actions: Vec<ProcedureAction>,
    /// The present step.
    pub step: Option<StepView>,
    /// How far the whole is.
    pub progress: ProcedureProgress,
    /// The hull's tilt, while it is of use.
    pub tilt: Option<Tilt>,
    /// The rest, while it is taken.
    pub rest: Option<RestView>,
    /// The recording, while it runs or lies interrupted.
    pub recording: Option<RecordingView>,
    /// What is to be thought of the recording that has ended.
    pub judgement: Option<Judgement>,
    /// Work that wants to be done.
    pub work: Option<ProcedureWork>,
    /// The result, once there is one.
    pub result: Option<ResultView>,
    /// The criticism, once there is one.
    pub critique: Option<CritiqueView>,
    /// A further swing that is suggested.
    pub suggestion: Option<PlanStep>,
    /// What the operator must know.
    pub warnings: Vec<Sentence>,
}

/// Where the procedure stands.
pub type ProcedurePhase = Phase;

/// Where the procedure stands.
#[uniffi::remote(Enum)]
pub enum ProcedurePhase {
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
pub type ProcedureAction = Action;

/// What an operator can do.
#[uniffi::remote(Enum)]
pub enum ProcedureAction {
    /// `Begin`.
    Begin,
    /// `SetReference`.
    SetReference,
    /// `Accept`.
    Accept,
    /// `Repeat`.
    Repeat,
    /// `Skip`.
    Skip,
    /// `Measured`.
    Measured,
    /// `StartRecording`.
    StartRecording,
    /// `StopRecording`.
    StopRecording,
    /// `Continue`.
    Continue,
    /// `Keep`.
    Keep,
    /// `Reopen`.
    Reopen,
    /// `Retry`.
    Retry,
    /// Not an event: call `work_blocking`.
    Work,
}

/// The present step.
#[uniffi::remote(Record)]
pub struct StepView {
    /// Its place among the steps, from 0.
    pub index: Count,
    /// How many steps there are.
    pub count: Count,
    /// Its id; an incline's is `incline-bow` or `incline-stern`.
    pub id: String,
    /// Number of the recording, from 1; 0 before the first.
    pub take: Count,
    /// As planned.
    pub planned: PlanStep,
    /// How a swing hangs as far as it was measured, and as planned otherwise.
    pub hanging: Option<Suspension>,
}

/// How far the whole is.
pub type ProcedureProgress = Progress;

/// How far the whole is.
#[uniffi::remote(Record)]
pub struct ProcedureProgress {
    /// Steps that are done or left out.
    pub steps_done: Count,
    /// All steps.
    pub steps: Count,
    /// Share of the whole, level, rest and work included, 0 to 1.
    pub share: f64,
    /// Recording time that is still to come, s.
    pub recording_left_s: f64,
}

/// A tilt, and what it is against.
#[uniffi::remote(Record)]
pub struct Tilt {
    /// What the angles are against.
    pub against: TiltAgainst,
    /// Angle between gravity now and gravity there, degrees; absent where there is nothing to be against.
    pub angle_deg: Option<f64>,
    /// Bow up, degrees; known only where the phone lies flat with its top edge to the bow.
    pub bow_up_deg: Option<f64>,
    /// Starboard side down, degrees; known only where the phone lies so.
    pub starboard_down_deg: Option<f64>,
}

/// What a tilt is against.
pub type TiltAgainst = Against;

/// What a tilt is against.
#[uniffi::remote(Enum)]
pub enum TiltAgainst {
    /// The phone's own plane, which lies flat on the hull.
    PhonePlane,
    /// The reading at which the operator said that the hull was level.
    Reference,
    /// Nothing yet.
    Nothing,
}

/// The rest while it is taken.
#[uniffi::remote(Record)]
pub struct RestView {
    /// So long everything has been still, s.
    pub still_s: f64,
    /// So long it must be, s.
    pub wanted_s: f64,
    /// How the hull moved when it last did.
    pub moving: Option<Moving>,
    /// What was found, once it was still for long enough.
    pub found: Option<RestReading>,
}

/// How a hull moved.
#[uniffi::remote(Record)]
pub struct Moving {
    /// Largest rate against the mean over the last seconds, degrees per s.
    pub rate_deg_s: f64,
    /// Largest turn of gravity against the mean over the last seconds, degrees.
    pub tilt_deg: f64,
}

/// The sensors at rest.
pub type RestReading = Rest;

/// The sensors at rest.
#[uniffi::remote(Record)]
pub struct RestReading {
    /// Length of the still part, s.
    pub still_s: f64,
    /// Gyroscope, rad/s; its mean is the bias.
    pub gyroscope: SensorRest,
    /// Accelerometer, m/s².
    pub accelerometer: Option<SensorRest>,
    /// Size of the accelerometer's mean, m/s².
    pub gravity_m_s2: Option<f64>,
}

/// One sensor at rest.
#[uniffi::remote(Record)]
pub struct SensorRest {
    /// Samples.
    pub samples: Count,
    /// Real rate by its own stamps, gaps left out, Hz.
    pub rate_hz: f64,
    /// Intervals of more than one and a half usual ones.
    pub gaps: Count,
    /// Mean by axis, unit of the sensor, phone axes.
    pub mean: Vector3,
    /// Standard deviation of a sample by axis.
    pub noise: Vector3,
}

/// The recording while it runs, or as far as it goes.
#[uniffi::remote(Record)]
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
    pub live: Option<LiveEstimate>,
    /// What to know or do, most urgent first.
    pub advice: Vec<Sentence>,
}

/// What is to be thought of a recording.
#[uniffi::remote(Record)]
pub struct Judgement {
    /// What the operator is advised to do; it is theirs to decide.
    pub recommend: Recommend,
    /// Why it should be repeated, the gravest first; empty where it is good.
    pub reasons: Vec<Sentence>,
    /// What else to know.
    pub notes: Vec<Sentence>,
    /// So much was recorded, s.
    pub recorded_s: f64,
    /// The free swing that says most of the period.
    pub swing: Option<SwingState>,
    /// Amplitude after the release, degrees.
    pub released_deg: Option<f64>,
    /// The tilt of an incline.
    pub incline: Option<InclineReading>,
}

/// Advice for the end of a recording.
#[uniffi::remote(Enum)]
pub enum Recommend {
    /// It is good.
    Accept,
    /// It should be made again.
    Repeat,
}

/// The tilt that a weight makes.
#[uniffi::remote(Record)]
pub struct InclineReading {
    /// Angle between gravity at rest and with the weight, degrees.
    pub angle_deg: f64,
    /// Its standard uncertainty, degrees.
    pub u_deg: f64,
}

/// Work that a procedure wants done.
pub type ProcedureWork = Work;

/// Work that a procedure wants done.
#[uniffi::remote(Enum)]
pub enum ProcedureWork {
    /// The session is written and measured: seconds.
    Measure,
    /// Its result is criticised: minutes.
    Critique,
}

/// The result.
#[uniffi::remote(Record)]
pub struct ResultView {
    /// Folder of the session, inside the procedure's.
    pub session: String,
    /// The joint estimate by quantity.
    pub quantities: QuantitiesByName,
    /// What a reader must know.
    pub warnings: Vec<String>,
}

/// What the criticism says in short.
#[uniffi::remote(Record)]
pub struct CritiqueView {
    /// `adequate`, `explained`, `ambiguous` or `unexplained`.
    pub status: String,
    /// In words.
    pub text: String,
    /// How many causes these swings cannot tell apart; 0 where none is in doubt.
    pub causes: Count,
    /// The figures by the simulation with the causes that were found in it.
    pub quantities: QuantitiesByName,
}

/// A sentence: its key, what it names, and the English of both. SwiftUI has a `Text` of its own.
pub type Sentence = Text;

/// A sentence: its key, what it names, and the English of both.
#[uniffi::remote(Record)]
pub struct Sentence {
    /// Key for translation.
    pub key: String,
    /// What it names, by the name that stands in it.
    pub arguments: ArgumentsByName,
    /// The sentence in English.
    pub english: String,
}

/// Something that a sentence names.
#[derive(Debug, Clone, PartialEq, uniffi::Enum)]
pub enum SentenceArgument {
    /// A number with the decimals that it is shown with.
    Number {
        /// The number.
        value: f64,
        /// How many decimals.
        decimals: u8,
    },
    /// Words with keys of their own, spaces between them, e.g. `yaw`.
    Words {
        /// The keys.
        keys: String,
    },
    /// Text as it stands: an id, a file, a reason.
    Plain {
        /// The text.
        text: String,
    },
    /// Sentences of their own, in a row.
    Sentences {
        /// The sentences.
        sentences: Vec<Sentence>,
    },
}

/// Arguments as the core holds them.
pub type ArgumentsByName = BTreeMap<String, Argument>;
uniffi::custom_type!(ArgumentsByName, HashMap<String, SentenceArgument>, {
    remote,
    lower: |map| map.into_iter().map(|(name, argument)| (name, argument.into())).collect(),
    try_lift: |map| Ok(map.into_iter().map(|(name, argument)| (name, argument.into())).collect()),
});

impl From<Argument> for SentenceArgument {
    fn from(argument: Argument) -> Self {
        match argument {
            Argument::Number(value, decimals) => Self::Number { value, decimals },
            Argument::Word(keys) => Self::Words { keys },
            Argument::Plain(text) => Self::Plain { text },
            Argument::Texts(sentences) => Self::Sentences { sentences },
        }
    }
}

impl From<SentenceArgument> for Argument {
    fn from(argument: SentenceArgument) -> Self {
        match argument {
            SentenceArgument::Number { value, decimals } => Self::Number(value, decimals),
            SentenceArgument::Words { keys } => Self::Word(keys),
            SentenceArgument::Plain { text } => Self::Plain(text),
            SentenceArgument::Sentences { sentences } => Self::Texts(sentences),
        }
    }
}
