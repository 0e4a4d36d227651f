//! The procedure: what the operator does and is told, step by step.

use std::sync::{Arc, Mutex};

use gyradius_core::procedure::{Batch, Channel, Event, Job, Outcome, State, Task};
use gyradius_core::{Error, procedure};

use crate::error::Result;
use crate::work::{Listener, watched};
use crate::{as_json, block, locked};

/// One hull being measured, from hanging it level to the result. What is decided is on the disk
/// before a call returns.
#[derive(uniffi::Object)]
pub struct Procedure {
    inner: Mutex<procedure::Procedure>,
}

impl Procedure {
    fn of(procedure: procedure::Procedure) -> Arc<Self> {
        Arc::new(Self {
            inner: Mutex::new(procedure),
        })
    }
}

#[uniffi::export]
impl Procedure {
    /// Begins a procedure in a folder, which is made if it is not there.
    #[uniffi::constructor]
    pub fn create(folder: &str, task: Task) -> Result<Arc<Self>> {
        Ok(Self::of(procedure::Procedure::create(folder, task)?))
    }

    /// Goes on with a procedure wherever it was left, by itself or by a killed app.
    #[uniffi::constructor]
    pub fn open(folder: &str) -> Result<Arc<Self>> {
        Ok(Self::of(procedure::Procedure::open(folder)?))
    }

    /// The folder that it is kept in.
    pub fn folder(&self) -> String {
        locked(&self.inner).folder().display().to_string()
    }

    /// Where it stands: cheap enough for every frame.
    pub fn state(&self) -> State {
        locked(&self.inner).state()
    }

    /// Where it stands, as JSON.
    pub fn state_json(&self) -> Result<String> {
        as_json(&self.state())
    }

    /// Takes what happened. What is not offered in the present phase fails with `BadArgument`, and
    /// nothing has changed.
    pub fn handle(&self, event: Event) -> Result<()> {
        Ok(locked(&self.inner).handle(event)?)
    }

    /// Takes a block of stamps (ns) and one of values (x, y, z) of one stream, in the order they
    /// came.
    pub fn push(&self, channel: Channel, stamps_ns: &[u8], values: &[u8]) -> Result<()> {
        self.handle(Event::Samples(batch(channel, stamps_ns, values)?))
    }

    /// Does the work that is wanted, if there is any: seconds or minutes. Other calls go on
    /// meanwhile.
    pub fn work_blocking(&self, listener: Listener) -> Result<()> {
        // Two statements: the lock must be free while the work is done.
        let job = locked(&self.inner).job();
        let Some(outcome) = done(job, &listener)? else {
            return Ok(());
        };
        Ok(locked(&self.inner).finish(outcome)?)
    }
}

/// Runs a job, if there is one.
pub fn done(job: Option<Job>, listener: &Listener) -> Result<Option<Outcome>> {
    job.map(|job| watched(listener, |progress| job.run(progress)))
        .transpose()
}

/// An event from its JSON, e.g. `{"event": "tick", "stamp_ns": 5}`.
#[uniffi::export]
pub fn procedure_event_from_json(text: &str) -> Result<Event> {
    let event = serde_json::from_str(text);
    Ok(event.map_err(|error| Error::argument("event", "an event as JSON", error))?)
}

fn batch(channel: Channel, stamps_ns: &[u8], values: &[u8]) -> Result<Batch> {
    Ok(Batch {
        channel,
        stamps_ns: block::stamps(stamps_ns)?,
        values: block::triples("values", values)?,
    })
}
