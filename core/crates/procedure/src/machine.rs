//! The procedure: what happens goes in, the journal and the recordings are written, and where it
//! stands comes out.

use std::fs;
use std::path::{Path, PathBuf};

use super::actions::{action_of, name_of};
use super::check;
use super::entry::{Entry, FORMAT};
use super::event::{Batch, Channel, Event};
use super::job::{Job, Outcome};
use super::journal::{Journal, Opened};
use super::judgement::Judgement;
use super::memory::{Memory, StepMemory, Take};
use super::rest::RestReader;
use super::state::{Action, Phase, Work};
use super::take::{Before, Extent, Follow, Running, TAKES, extent, file_of};
use super::task::Task;
use super::tilt::TiltReader;
use super::words::{self, number};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_base::message::Message;

/// Stillness that a rest is taken over, s: the mean of white noise of 0.005 rad/s at 100 Hz is then
/// known to 0.13 mrad/s.
const REST_S: f64 = 15.0;

/// One hull being measured, from hanging it level to the result.
///
/// Everything is decided by the events that it is given: it reads no clock and draws no chance.
/// What is decided is on the disk before [`Procedure::handle`] returns, samples at the latest half
/// a second of their own stamps afterwards.
pub struct Procedure {
    pub(super) folder: PathBuf,
    journal: Journal,
    pub(super) memory: Memory,
    pub(super) tilt: TiltReader,
    pub(super) reference: Option<Vec3>,
    pub(super) rest: RestReader,
    pub(super) running: Option<Running>,
    /// How far the recording goes that was cut off.
    pub(super) cut_off: Extent,
    /// Newest stamps of a sample and of anything, ns.
    pub(super) heard_ns: Option<i64>,
    pub(super) now_ns: Option<i64>,
    pub(super) told: Vec<Message>,
}

impl Procedure {
    /// Begins a procedure in a folder, which is made if it is not there.
    ///
    /// Fails with [`Error::Unwritable`] where one has begun there already, with [`Error::Argument`]
    /// where the task has no step, two steps of one id, or figures that are not numbers.
    pub fn create(folder: impl AsRef<Path>, task: Task) -> Result<Self> {
        check::task(&task)?;
        let folder = folder.as_ref().to_owned();
        let first = Entry::Created {
            format: FORMAT.to_owned(),
            task,
        };
        let journal = Journal::create(&folder, &first)?;
        let takes = folder.join(TAKES);
        fs::create_dir_all(&takes)
            .map_err(|error| Error::unwritable(takes.display(), "", &error))?;
        Self::from(folder, journal, vec![first], Vec::new())
    }

    /// Goes on with a procedure wherever it was left, by itself or by a killed app.
    ///
    /// Fails with [`Error::Unreadable`] where there is no journal, and with [`Error::Malformed`]
    /// where it is none, is of another major version, or not even its first line is whole: then
    /// nothing was begun, and [`Procedure::create`] begins anew there.
    pub fn open(folder: impl AsRef<Path>) -> Result<Self> {
        let folder = folder.as_ref().to_owned();
        let Opened {
            journal,
            entries,
            cut_bytes,
        } = Journal::open(&folder)?;
        check::format(&folder, entries.first())?;
        let mut told = Vec::new();
        if cut_bytes > 0 {
            told.push(Message::new(
                "warn_journal_cut",
                [("bytes", number(cut_bytes as f64, 0))],
            ));
        }
        Self::from(folder, journal, entries, told)
    }

    fn from(
        folder: PathBuf,
        journal: Journal,
        entries: Vec<Entry>,
        told: Vec<Message>,
    ) -> Result<Self> {
        let mut procedure = Self {
            folder,
            journal,
            memory: Memory::of(entries),
            tilt: TiltReader::default(),
            reference: None,
            rest: RestReader::new(REST_S),
            running: None,
            cut_off: Extent::default(),
            heard_ns: None,
            now_ns: None,
            told,
        };
        procedure.adopt()?;
        procedure.look_at_cut_off();
        Ok(procedure)
    }

    /// Recordings whose line in the journal was lost are taken up again; none is passed over.
    fn adopt(&mut self) -> Result<()> {
        let mut known = 0;
        for step in 0..self.memory.steps.len() {
            let id = self.memory.steps[step].id();
            let takes = self.memory.steps[step].takes.len();
            let lost = (takes + 1..)
                .take_while(|take| self.folder.join(file_of(step, &id, *take)).exists());
            let lost: Vec<usize> = lost.collect();
            known += takes + lost.len();
            for take in lost {
                self.write(Entry::Started {
                    step,
                    take,
                    at_utc: String::new(),
                })?;
            }
        }
        let files =
            fs::read_dir(self.folder.join(TAKES)).map_or(0, |files| files.flatten().count());
        if files > known {
            let files = number((files - known) as f64, 0);
            self.told
                .push(Message::new("warn_unused", [("files", files)]));
        }
        Ok(())
    }

    fn look_at_cut_off(&mut self) {
        let open = self
            .open_take()
            .filter(|(_, _, take)| take.judgement.is_none());
        self.cut_off = open.map_or(Extent::default(), |(_, file, _)| extent(&file));
    }

    /// Takes what happened. What is not offered in the present phase is an [`Error::Argument`] that
    /// says what is; nothing has changed then. Samples, ticks and the phone's reports are taken in
    /// every phase.
    ///
    /// A recording that cannot be written is interrupted, and
    /// [`State::warnings`](super::State::warnings) says why; what was written before stays. Fails
    /// with [`Error::Unwritable`] or [`Error::DiskFull`] where a decision cannot be: then it was
    /// not taken.
    pub fn handle(&mut self, event: Event) -> Result<()> {
        if let Some(action) = action_of(&event) {
            let offered = self.actions();
            if !offered.contains(&action) {
                let offered: Vec<String> = offered.iter().map(|action| name_of(*action)).collect();
                return Err(Error::argument(
                    "event",
                    format!("one of: {}", offered.join(", ")),
                    name_of(action),
                ));
            }
        }
        match event {
            Event::Samples(batch) => self.samples(&batch),
            Event::Tick { stamp_ns } => {
                self.now_ns = Some(self.now_ns.map_or(stamp_ns, |now| now.max(stamp_ns)));
                Ok(())
            }
            Event::SensorStopped { sensor, stamp_ns } => {
                self.tell(Message::new(
                    "warn_sensor_stopped",
                    [("sensor", words::sensor(sensor))],
                ));
                self.of_running(|running| running.sensor_stopped(stamp_ns, sensor))
            }
            Event::SlipSeen { stamp_ns } => self.of_running(|running| running.slip_seen(stamp_ns)),
            Event::DiskFull => {
                self.interrupt(Message::new("warn_disk", []));
                Ok(())
            }
            decision => self.decide(decision),
        }
    }

    fn decide(&mut self, event: Event) -> Result<()> {
        let phase = self.phase();
        match event {
            Event::Begin {
                at_utc,
                measured_on,
                phone,
                placement,
            } => {
                check::phone(&phone)?;
                let measured_on = measured_on.or_else(|| day_of(&at_utc)).unwrap_or_default();
                self.write(Entry::Begun {
                    at_utc,
                    measured_on,
                    phone,
                    placement,
                })
            }
            Event::SetReference => {
                self.reference = Some(self.up()?);
                Ok(())
            }
            Event::Measured(measured) => self.measured(measured),
            Event::StartRecording { at_utc } => self.start(at_utc),
            Event::StopRecording => self.stop(),
            Event::Continue => self.go_on(),
            Event::Keep => self.keep(),
            Event::Retry => self.write(Entry::Retried),
            Event::Reopen { step } => self.reopen(step),
            Event::Accept => self.accept(phase),
            Event::Repeat => self.repeat(phase),
            Event::Skip => self.skip(phase),
            Event::Samples(_)
            | Event::Tick { .. }
            | Event::SensorStopped { .. }
            | Event::SlipSeen { .. }
            | Event::DiskFull => Ok(()),
        }
    }

    fn accept(&mut self, phase: Phase) -> Result<()> {
        match phase {
            Phase::Level => {
                let up = self.up()?.into();
                self.write(Entry::Levelled { up })?;
                self.rest = RestReader::new(REST_S);
                Ok(())
            }
            Phase::Rest => {
                let missing =
                    || Error::argument("event", format!("{REST_S} s of stillness"), "less");
                let rest = self.rest.found().ok_or_else(missing)?;
                self.write(Entry::Rested { rest })
            }
            Phase::Judge => self.decided(true),
            _ => match self.memory.suggestion.clone() {
                Some(step) => self.write(Entry::SuggestionTaken { step }),
                None => Ok(()),
            },
        }
    }

    fn repeat(&mut self, phase: Phase) -> Result<()> {
        match phase {
            Phase::Rest => {
                self.rest = RestReader::new(REST_S);
                Ok(())
            }
            _ => self.decided(false),
        }
    }

    fn skip(&mut self, phase: Phase) -> Result<()> {
        match phase {
            Phase::Rest => self.write(Entry::RestSkipped),
            Phase::Critique => self.write(Entry::CritiqueSkipped),
            Phase::Suggest => self.write(Entry::SuggestionDeclined),
            _ => match self.memory.present() {
                Some(step) => self.write(Entry::Skipped { step }),
                None => Ok(()),
            },
        }
    }

    fn reopen(&mut self, step: usize) -> Result<()> {
        if !self.memory.step(step).is_some_and(StepMemory::is_done) {
            return Err(Error::argument(
                "step",
                "the place of a step that is done",
                step,
            ));
        }
        self.write(Entry::Reopened { step })
    }

    fn measured(&mut self, measured: super::event::Measured) -> Result<()> {
        let Some(step) = self.memory.present() else {
            return Ok(());
        };
        let measured = measured.over(self.memory.measured_alike(step));
        if let Some(memory) = self.memory.step(step) {
            check::measured(memory, measured)?;
        }
        self.write(Entry::Hung { step, measured })
    }

    fn start(&mut self, at_utc: String) -> Result<()> {
        let Some((step, memory)) = self.present() else {
            return Ok(());
        };
        let take = memory
            .takes
            .iter()
            .map(|take| take.number)
            .max()
            .unwrap_or(0)
            + 1;
        let (planned, id) = (memory.planned.clone(), memory.id());
        self.write(Entry::Started { step, take, at_utc })?;
        let file = self.folder.join(file_of(step, &id, take));
        self.cut_off = Extent::default();
        self.told.clear();
        self.running = Some(Running::begin(&file, &planned, &id, &self.before())?);
        Ok(())
    }

    fn stop(&mut self) -> Result<()> {
        let Some(running) = self.running.take() else {
            return Ok(());
        };
        let (follow, ended) = running.end();
        self.cut_off = Extent {
            recorded_s: follow.recorded_s(),
            ended: true,
            newest_ns: Some(follow.last_ns()),
        };
        self.judge(&follow)?;
        // A missing end mark is told by whoever reads the file; what was recorded is judged all the
        // same.
        if let Err(error) = ended {
            self.tell(words::not_written(&error));
        }
        Ok(())
    }

    fn judge(&mut self, follow: &Follow) -> Result<()> {
        let Some((step, _, take)) = self.open_take() else {
            return Ok(());
        };
        let judgement = sound(follow.judgement(self.level()));
        let take = take.number;
        self.write(Entry::Ended {
            step,
            take,
            judgement,
        })
    }

    fn go_on(&mut self) -> Result<()> {
        let Some((step, file, _)) = self.open_take() else {
            return Ok(());
        };
        let planned = self.memory.steps[step].planned.clone();
        self.told.clear();
        self.running = Some(Running::resume(&file, &planned, &self.before())?);
        Ok(())
    }

    fn keep(&mut self) -> Result<()> {
        let Some((step, file, _)) = self.open_take() else {
            return Ok(());
        };
        let planned = self.memory.steps[step].planned.clone();
        let follow = Follow::replayed(&file, &planned, &self.before())?;
        self.judge(&follow)
    }

    fn decided(&mut self, accepted: bool) -> Result<()> {
        let Some((step, _, take)) = self.open_take() else {
            return Ok(());
        };
        let take = take.number;
        self.write(Entry::Decided {
            step,
            take,
            accepted,
        })?;
        // Recordings whose lines were lost come up one after the other.
        self.look_at_cut_off();
        Ok(())
    }

    fn samples(&mut self, batch: &Batch) -> Result<()> {
        if batch.stamps_ns.len() != batch.values.len() {
            let found = format!(
                "{} stamps and {} values",
                batch.stamps_ns.len(),
                batch.values.len()
            );
            return Err(Error::argument("values", "as many values as stamps", found));
        }
        if let Some(last) = batch.stamps_ns.iter().max() {
            self.heard_ns = Some(self.heard_ns.map_or(*last, |heard| heard.max(*last)));
            self.now_ns = Some(self.now_ns.map_or(*last, |now| now.max(*last)));
        }
        if batch.channel == Channel::Accelerometer {
            self.tilt.push(&batch.stamps_ns, &batch.values);
        }
        if self.phase() == Phase::Rest {
            self.rest
                .push(batch.channel, &batch.stamps_ns, &batch.values);
        }
        self.of_running(|running| running.push(batch))?;
        if self.running.as_ref().is_some_and(Running::is_over) {
            self.stop()
        } else {
            Ok(())
        }
    }

    /// Does something with the recording that runs. Where that fails, it is interrupted; a file
    /// that cannot be written is told among the warnings, and no error beside them.
    fn of_running(&mut self, act: impl FnOnce(&mut Running) -> Result<()>) -> Result<()> {
        let Some(running) = &mut self.running else {
            return Ok(());
        };
        let Err(error) = act(running) else {
            return Ok(());
        };
        self.interrupt(words::not_written(&error));
        match error {
            Error::Unwritable { .. } | Error::DiskFull { .. } => Ok(()),
            other => Err(other),
        }
    }

    /// Told until the next recording.
    fn tell(&mut self, warning: Message) {
        if !self.told.contains(&warning) {
            self.told.push(warning);
        }
    }

    fn interrupt(&mut self, why: Message) {
        self.tell(why);
        if let Some(running) = self.running.take() {
            drop(running);
            self.look_at_cut_off();
        }
    }

    /// The work that is wanted, to be run on a thread of its own; `None` where there is none.
    pub fn job(&self) -> Option<Job> {
        let work = match self.phase() {
            Phase::Measure => Work::Measure,
            Phase::Critique => Work::Critique,
            _ => return None,
        };
        Some(Job::of(work, &self.folder, &self.memory))
    }

    /// Takes what a job came to. Fails with [`Error::Argument`] where that work is not wanted (any
    /// more).
    pub fn finish(&mut self, outcome: Outcome) -> Result<()> {
        let wanted = self.job().map(|job| job.work());
        if wanted != Some(outcome.work()) {
            return Err(Error::argument(
                "outcome",
                "that of the work that is wanted",
                format!("{:?}", outcome.work()),
            ));
        }
        self.write(outcome.into_entry())
    }

    /// Does the work that is wanted on this thread, if there is any. Fails as [`Job::run`] does.
    pub fn work(&mut self, progress: &gyradius_diagnosis::Progress) -> Result<()> {
        match self.job() {
            Some(job) => self.finish(job.run(progress)?),
            None => Ok(()),
        }
    }

    /// The newest stamp of all recordings, ns.
    pub(super) fn newest_ns(&self) -> Option<i64> {
        let files = fs::read_dir(self.folder.join(TAKES)).ok()?.flatten();
        files
            .filter_map(|file| extent(&file.path()).newest_ns)
            .max()
    }

    /// The folder that it is kept in.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    pub(super) fn phase(&self) -> Phase {
        let memory = &self.memory;
        if memory.begun.is_none() {
            return Phase::Start;
        }
        if self.running.is_some() {
            return Phase::Record;
        }
        if let Some((_, _, take)) = self.open_take() {
            return if take.judgement.is_some() {
                Phase::Judge
            } else {
                Phase::Interrupted
            };
        }
        if memory.level.is_none() {
            return Phase::Level;
        }
        if memory.rest.is_none() {
            return Phase::Rest;
        }
        match self.present() {
            Some((_, step)) if step.measured.is_none() => Phase::Hang,
            Some(_) => Phase::Ready,
            None => self.phase_of_result(),
        }
    }

    fn phase_of_result(&self) -> Phase {
        let memory = &self.memory;
        if memory.failed.is_some() {
            Phase::Failed
        } else if memory.result.is_none() {
            Phase::Measure
        } else if memory.critique.is_none() {
            Phase::Critique
        } else if memory.suggestion.is_some() {
            Phase::Suggest
        } else {
            Phase::Done
        }
    }

    /// What the operator may do now.
    pub(super) fn actions(&self) -> Vec<Action> {
        use Action::*;
        let mut actions = match self.phase() {
            Phase::Start => vec![Begin],
            Phase::Level => self
                .tilt
                .up()
                .map_or_else(Vec::new, |_| vec![SetReference, Accept]),
            Phase::Rest => self
                .rest
                .found()
                .map(|_| Accept)
                .into_iter()
                .chain([Repeat, Skip])
                .collect(),
            Phase::Hang => vec![Measured, Skip],
            Phase::Ready => vec![StartRecording, Measured, Skip],
            Phase::Record => vec![StopRecording],
            Phase::Interrupted => self.actions_of_cut_off(),
            Phase::Judge => vec![Accept, Repeat],
            Phase::Measure => vec![Work],
            Phase::Failed => vec![Retry],
            Phase::Critique => vec![Work, Skip],
            Phase::Suggest => vec![Accept, Skip],
            Phase::Done => vec![],
        };
        let after_steps = matches!(
            self.phase(),
            Phase::Failed | Phase::Critique | Phase::Suggest | Phase::Done
        );
        if after_steps || matches!(self.phase(), Phase::Hang | Phase::Ready) {
            let any = self.memory.steps.iter().any(StepMemory::is_done);
            actions.extend(any.then_some(Reopen));
        }
        actions
    }

    fn actions_of_cut_off(&self) -> Vec<Action> {
        let Extent {
            recorded_s,
            ended,
            newest_ns,
        } = self.cut_off;
        // A phone that was switched off counts anew: what it says now cannot follow what it said
        // then.
        let restarted = self
            .now_ns
            .zip(newest_ns)
            .is_some_and(|(now, newest)| now < newest);
        if recorded_s <= 0.0 {
            vec![Action::Repeat]
        } else if ended || restarted {
            vec![Action::Keep, Action::Repeat]
        } else {
            vec![Action::Continue, Action::Keep, Action::Repeat]
        }
    }

    pub(super) fn present(&self) -> Option<(usize, &StepMemory)> {
        let index = self.memory.present()?;
        self.memory.step(index).map(|step| (index, step))
    }

    /// The recording that runs or waits for a decision: its step, its file and itself.
    pub(super) fn open_take(&self) -> Option<(usize, PathBuf, &Take)> {
        let open = |(index, step): (usize, &'_ StepMemory)| {
            let number = step.open_take()?.number;
            Some((
                index,
                number,
                self.folder.join(file_of(index, &step.id(), number)),
            ))
        };
        let (index, number, file) = self.memory.steps.iter().enumerate().find_map(open)?;
        let take = self.memory.steps[index]
            .takes
            .iter()
            .find(|take| take.number == number)?;
        Some((index, file, take))
    }

    /// Direction of gravity's reaction at rest, or when it was level.
    pub(super) fn level(&self) -> Option<Vec3> {
        let rest = self.memory.rest.as_ref().and_then(Option::as_ref);
        let mean = rest
            .and_then(|rest| rest.accelerometer)
            .map(|rest| Vec3::from(rest.mean));
        mean.and_then(|mean| mean.try_normalize(1.0))
            .or(self.memory.level)
    }

    fn up(&self) -> Result<Vec3> {
        let missing = || Error::argument("event", "a reading of gravity before it", "none");
        self.tilt.up().ok_or_else(missing)
    }

    fn before(&self) -> Before {
        let phone = self
            .memory
            .begun
            .clone()
            .map(|begun| begun.phone)
            .unwrap_or_default();
        Before {
            phone,
            rest: self.memory.rest.clone().flatten(),
        }
    }

    /// Writes a decision, and only then holds it for true.
    fn write(&mut self, entry: Entry) -> Result<()> {
        self.journal.append(&entry)?;
        self.memory.take(entry);
        Ok(())
    }
}

/// The day of a wall clock's `2026-05-04T09:30:00Z`.
fn day_of(at_utc: &str) -> Option<String> {
    at_utc.split_once('T').map(|(day, _)| day.to_owned())
}

/// Figures that are no numbers cannot be kept as JSON: a swing that has them tells nothing.
fn sound(judgement: Judgement) -> Judgement {
    let text = serde_json::to_string(&judgement).unwrap_or_default();
    match serde_json::from_str::<Judgement>(&text) {
        Ok(_) => judgement,
        Err(_) => Judgement {
            swing: None,
            released_deg: None,
            incline: None,
            ..judgement
        },
    }
}
