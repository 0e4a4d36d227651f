//! The procedure: what the operator does, step by step, and what to tell them while they do it.
//!
//! A state machine with plain data on both sides. What happens goes in as [`Event`]s and samples;
//! where it stands comes out as a [`State`], which a screen shows and nothing else. It reads no
//! clock and draws no chance. Every decision is in an append-only journal before it counts, every
//! sample in the recorder's file, so that [`Procedure::open`] goes on wherever the app was killed.
//! `core/docs/procedure.md` tells of the phases, the events and the files.
//!
//! May know `recording`, `recorder`, `live`, `plan`, `practice`, `inertia`, `critique`.
//!
//! # Conventions
//! Stamps are nanoseconds of the phone's own clock, samples are rad/s and m/s² of specific force in
//! phone axes, as in `recorder`. Angles are degrees where the name says so. A standard uncertainty
//! is `u`.

mod actions;
mod check;
mod entry;
mod event;
mod job;
mod journal;
mod judgement;
mod kept;
mod machine;
mod memory;
mod rehearsal;
mod release;
mod rest;
mod show;
mod state;
mod take;
mod task;
mod tilt;
mod words;

pub use event::{Batch, Channel, Event, Measured, PhoneInfo, PhoneSensor, Placement};
pub use job::{Job, Outcome};
pub use judgement::{InclineReading, Judgement, Recommend};
pub use kept::{keep_criticism, kept_criticism};
pub use machine::Procedure;
pub use rehearsal::{Mishap, Rehearsal, practice_task};
pub use rest::{Moving, Rest, SensorRest};
pub use state::{
    Action, CritiqueView, Phase, Progress, RecordingView, RestView, ResultView, State, StepView,
    Work,
};
pub use task::Task;
pub use tilt::{Against, Tilt};

pub use gyradius_base::message::{Argument, Message};
