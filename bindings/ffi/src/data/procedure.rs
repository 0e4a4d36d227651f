//! Plain data of the module `procedure`: what happens, and everything that a screen shows.

use gyradius_core::procedure::{
    Action, Batch, Channel, CritiqueView, Event, Judgement, Measured, Phase, PhoneInfo,
    PhoneSensor, Placement, Progress, RecordingView, RestView, ResultView, State, StepView, Task,
    Tilt, Work,
};
use gyradius_core::recording::{Attachment, Quantity, Sensor, Site, Suspension};

use super::names::CauseStatus;
use super::plan::PlanStep;
use super::recording::HullBody;
use super::sentence::Sentence;
use super::{Count, QuantitiesByName, Vector3};

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
        /// The date where the hull hangs, as the session and its report tell it (`2026-05-04`); the
        /// day of `at_utc` where absent.
        measured_on: Option<String>,
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
    /// Anyhow: a tilt has a size and no direction, against the reading at which the operator said
    /// "level".
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
    pub warnings: Vec<Sentence>,
}

/// What the criticism says in short.
#[uniffi::remote(Record)]
pub struct CritiqueView {
    /// `adequate`, `explained`, `ambiguous` or `unexplained`.
    pub status: CauseStatus,
    /// In words.
    pub message: Sentence,
    /// How many causes these swings cannot tell apart; 0 where none is in doubt.
    pub causes: Count,
    /// The figures by the simulation with the causes that were found in it.
    pub quantities: QuantitiesByName,
}
