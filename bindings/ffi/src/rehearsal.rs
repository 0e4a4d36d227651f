//! The whole procedure against the simulation: practice without a hull.

use std::sync::{Arc, Mutex};

use gyradius_core::procedure::{self, Batch, Event, State};

use crate::data::NumbersByName;
use crate::error::Result;
use crate::procedure::done;
use crate::simulation::Rig;
use crate::work::{Listener, aside};
use crate::{as_json, locked};

/// A procedure with a simulated hull and phone. The same rig, seed and events give the same
/// session.
#[derive(uniffi::Object)]
pub struct Rehearsal {
    inner: Mutex<procedure::Rehearsal>,
}

impl Rehearsal {
    fn of(rehearsal: procedure::Rehearsal) -> Arc<Self> {
        Arc::new(Self {
            inner: Mutex::new(rehearsal),
        })
    }
}

#[uniffi::export]
impl Rehearsal {
    /// Begins in a folder: the rig's swings, in its order.
    #[uniffi::constructor]
    pub fn create(folder: &str, rig: &Rig, seed: u64) -> Result<Arc<Self>> {
        let task = procedure::practice_task(rig.file());
        Ok(Self::of(procedure::Rehearsal::create(
            folder,
            rig.file().clone(),
            task,
            seed,
        )?))
    }

    /// Goes on with one that was left: two seconds have gone by on the phone's clock.
    #[uniffi::constructor]
    pub fn open(folder: &str, rig: &Rig, seed: u64) -> Result<Arc<Self>> {
        Ok(Self::of(procedure::Rehearsal::open(
            folder,
            rig.file().clone(),
            seed,
        )?))
    }

    /// Where it stands.
    pub fn state(&self) -> State {
        locked(&self.inner).state()
    }

    /// Where it stands, as JSON.
    pub fn state_json(&self) -> Result<String> {
        as_json(&self.state())
    }

    /// Takes what the operator did.
    pub fn handle(&self, event: Event) -> Result<()> {
        Ok(locked(&self.inner).handle(event)?)
    }

    /// Lets so much time go by on the simulated hull, s; returns what did: less where the recording
    /// ends meanwhile.
    pub fn advance(&self, seconds: f64) -> Result<f64> {
        aside(|| locked(&self.inner).advance(seconds))
    }

    /// What the phone recorded while time last went by, as a live trace shows it.
    pub fn heard(&self) -> Vec<Batch> {
        locked(&self.inner).heard().to_vec()
    }

    /// What an operator who plays by the book does now; nothing while there is to be waited or
    /// worked. `at_utc` is the wall clock as text.
    pub fn by_the_book(&self, at_utc: &str) -> Result<Option<Event>> {
        Ok(locked(&self.inner).by_the_book(at_utc)?)
    }

    /// Lets something go wrong with a recording of a step, counted from 1: `bad_release`, `sway`,
    /// `touch`, `slip`, `silence`.
    pub fn mishap(&self, step: &str, take: u32, what: &str) -> Result<()> {
        let mishap = what.parse()?;
        locked(&self.inner).mishap(step, take as usize, mishap);
        Ok(())
    }

    /// Does the work that is wanted, if there is any: seconds or minutes.
    pub fn work_blocking(&self, listener: Listener) -> Result<()> {
        let job = locked(&self.inner).procedure().job();
        let Some(outcome) = done(job, &listener)? else {
            return Ok(());
        };
        Ok(locked(&self.inner).procedure().finish(outcome)?)
    }

    /// What is true of the hull, by name.
    pub fn truth(&self) -> NumbersByName {
        locked(&self.inner).truth()
    }
}
