//! Work that takes longer than a screen may wait: the session written and measured, its result
//! criticised.

use std::path::{Path, PathBuf};

use super::entry::Entry;
use super::event::Measured;
use super::kept::{forget_criticism, keep_criticism, write_json};
use super::memory::{Memory, StepMemory};
use super::state::{CritiqueView, ResultView, Work};
use super::take::file_of;
use gyradius_base::error::{Error, ErrorKind, Result};
use gyradius_base::progress::{Progress, tell};
use gyradius_diagnosis::{Criticism, Critique, criticise};
use gyradius_identification::{MeasureOptions, Measurement, QuantityName, analyse_watched};
use gyradius_planning::{PlannedIncline, PlannedSwing, Step, suggested};
use gyradius_recording::recorder::convert;
use gyradius_recording::{
    Incline, InclineAngle, Overwrite, Quantity, Session, Swing, SwingData, load_session,
    save_session,
};

/// Folder of the session inside the procedure's.
pub(super) const SESSION: &str = "session";
/// Files of the results beside it.
const MEASUREMENT: &str = "measurement.json";

/// Work that knows all it needs: it may be moved to another thread.
#[derive(Debug, Clone)]
pub struct Job {
    work: Work,
    folder: PathBuf,
    session: Session,
    /// Recordings to be converted: file, and name in the session.
    takes: Vec<(PathBuf, String)>,
}

/// What a job came to.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// The session has a result.
    Measured(Box<Measurement>),
    /// The result has been criticised; with the swing that would say more, if there is one.
    Criticised(Box<Criticism>, Option<Box<Step>>),
    /// The data do not allow it, for this reason.
    Failed(Work, String),
}

impl Job {
    pub(super) fn of(work: Work, folder: &Path, memory: &Memory) -> Self {
        let measured_on = memory
            .begun
            .as_ref()
            .map(|begun| begun.measured_on.clone())
            .unwrap_or_default();
        let session = Session {
            measured_on,
            ..memory.task.head()
        };
        let mut job = Self {
            work,
            folder: folder.to_owned(),
            session,
            takes: Vec::new(),
        };
        for (index, step) in memory
            .steps
            .iter()
            .enumerate()
            .filter(|(_, step)| !step.skipped)
        {
            job.add(index, step);
        }
        // What is not measured anew is taken over from the hanging before.
        job.session = job.session.with_same_hangings();
        job
    }

    fn add(&mut self, index: usize, step: &StepMemory) {
        let Some(take) = step.accepted() else { return };
        match &step.planned {
            Step::Swing(planned) => {
                let name = name_of(index, &planned.id);
                self.takes.push((
                    self.folder.join(file_of(index, &step.id(), take.number)),
                    name.clone(),
                ));
                self.session
                    .swings
                    .extend(swing(step, planned, format!("{name}.csv")));
            }
            Step::Incline(planned) => {
                let reading = take
                    .judgement
                    .as_ref()
                    .and_then(|judgement| judgement.incline);
                let angle = reading.map(|reading| Quantity::new(reading.angle_deg, reading.u_deg));
                self.session
                    .inclines
                    .extend(angle.and_then(|angle| incline(step, planned, angle)));
            }
        }
    }

    /// Which work it is.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Does it; the callback is told a share and a text, and stops the criticism by answering
    /// false.
    ///
    /// What the data do not allow is an [`Outcome::Failed`]. Fails with [`Error::Cancelled`] where
    /// it was stopped, and as reading and writing do.
    pub fn run(&self, progress: &Progress) -> Result<Outcome> {
        let done = match self.work {
            Work::Measure => self.measured(progress),
            Work::Critique => self.criticised(progress),
        };
        match done {
            Err(error) if error != Error::Cancelled && error.kind() == ErrorKind::NoResult => {
                Ok(Outcome::Failed(self.work, error.to_string()))
            }
            other => other,
        }
    }

    fn measured(&self, progress: &Progress) -> Result<Outcome> {
        if self.session.swings.is_empty() {
            return Err(Error::no_result(
                "the session",
                "no recording of a swing was accepted",
            ));
        }
        let folder = self.folder.join(SESSION);
        let mut session = self.session.clone();
        for (place, (file, name)) in self.takes.iter().enumerate() {
            tell(
                progress,
                0.5 * place as f64 / self.takes.len() as f64,
                "writing the session",
            )?;
            session.recorded.push(convert(file, &folder, name)?);
        }
        save_session(&folder, &session, &[], Overwrite::Replace)?;
        let measuring = |share: f64, text: &str| progress(0.5 + 0.5 * share, text);
        let options = MeasureOptions::default();
        let measurement =
            analyse_watched(&load_session(&folder)?, &options, &measuring)?.measurement;
        write_json(&self.folder.join(MEASUREMENT), &measurement)?;
        // Of a session that is no more.
        forget_criticism(&self.folder)?;
        Ok(Outcome::Measured(Box::new(measurement)))
    }

    fn criticised(&self, progress: &Progress) -> Result<Outcome> {
        let loaded = load_session(self.folder.join(SESSION))?;
        let criticism = criticise(&loaded, progress)?;
        keep_criticism(&self.folder, &criticism)?;
        let step = next_step(&criticism.critique, &self.session).map(Box::new);
        Ok(Outcome::Criticised(Box::new(criticism), step))
    }
}

/// The swing that the criticism suggests, hung by the depth that it found.
fn next_step(critique: &Critique, session: &Session) -> Option<Step> {
    let depth = critique
        .extended
        .quantities
        .get(&QuantityName::CmDepth)
        .and_then(|depth| depth.value.scalar());
    suggested(critique.verdict.next_swing.as_ref()?, session, depth).map(Step::Swing)
}

impl Outcome {
    /// Of which work.
    pub fn work(&self) -> Work {
        match self {
            Outcome::Measured(_) => Work::Measure,
            Outcome::Criticised(..) => Work::Critique,
            Outcome::Failed(work, _) => *work,
        }
    }

    pub(super) fn into_entry(self) -> Entry {
        match self {
            Outcome::Measured(measurement) => Entry::Measured {
                result: ResultView {
                    session: SESSION.to_owned(),
                    quantities: measurement.quantities,
                    warnings: measurement.warnings,
                },
            },
            Outcome::Criticised(criticism, suggestion) => {
                let critique = criticism.critique;
                Entry::Criticised {
                    critique: CritiqueView {
                        causes: doubtful(&critique.verdict),
                        status: critique.verdict.status,
                        message: critique.verdict.message,
                        quantities: critique.extended.quantities,
                    },
                    suggestion: suggestion.map(|step| *step),
                }
            }
            Outcome::Failed(work, reason) => Entry::Failed { work, reason },
        }
    }
}

fn doubtful(verdict: &gyradius_diagnosis::CauseVerdict) -> usize {
    match verdict.indistinguishable_from.len() {
        0 => 0,
        others => others + 1,
    }
}

/// Name of a recording in the session: the id where it can be one of a file.
fn name_of(index: usize, id: &str) -> String {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if id.chars().all(fits) {
        id.to_owned()
    } else {
        format!("swing-{}", index + 1)
    }
}

fn swing(step: &StepMemory, planned: &PlannedSwing, file: String) -> Option<Swing> {
    Some(Swing {
        id: planned.id.clone(),
        data: SwingData::Recording(file),
        excited: planned.excited.clone(),
        added_masses: planned.added_masses.clone(),
        amplitude_deg: Default::default(),
        suspension: step.hanging()?,
    })
}

fn incline(step: &StepMemory, planned: &PlannedIncline, angle_deg: Quantity) -> Option<Incline> {
    let Measured {
        mass_kg,
        arm_m,
        depth_m,
        ..
    } = step.measured?;
    let angle = InclineAngle::Stated(angle_deg);
    Some(Incline {
        end: planned.end,
        mass_kg: mass_kg?,
        arm_m: arm_m?,
        depth_m: depth_m?,
        angle,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::memory::Take;
    use gyradius_recording::{Orientation, Suspension, SuspensionKind};

    /// The tape is read at the level hanging; tilted, the hull hangs on the same lines.
    #[test]
    fn lines_that_were_measured_once_are_one_reading() {
        let level = Suspension {
            line_length_m: Some(Quantity::new(2.0, 0.01)),
            spacing_m: Some(Quantity::new(1.0, 0.01)),
            hull_pitch_deg: Some(Quantity::new(0.0, 0.2)),
            ..Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships)
        };
        let tilted = Suspension {
            hull_pitch_deg: Some(Quantity::new(20.0, 0.2)),
            points_moved_m: Some(Quantity::new(0.1, 0.01)),
            ..level.clone()
        };
        let step = |id: &str, suspension: &Suspension| {
            let mut step = StepMemory::new(Step::Swing(PlannedSwing {
                id: id.into(),
                suspension: suspension.clone(),
                added_masses: Vec::new(),
                excited: Vec::new(),
                amplitude_deg: 5.0,
                duration_s: 60.0,
                periods_s: Default::default(),
                period_u_wanted: 0.0,
            }));
            step.takes.push(Take {
                number: 1,
                accepted: Some(true),
                ..Take::default()
            });
            step
        };
        let mut memory = Memory {
            steps: vec![step("level", &level), step("tilted", &tilted)],
            ..Memory::default()
        };
        let read = |value: f64| Some(Quantity::new(value, 0.002));
        memory.steps[0].measured = Some(Measured {
            line_length_m: read(2.003),
            spacing_m: read(1.001),
            hull_pitch_deg: read(0.1),
            ..Measured::default()
        });
        let anew = Measured {
            points_moved_m: read(0.12),
            ..Measured::default()
        };
        let measured = anew.over(memory.measured_alike(1));
        assert_eq!(measured.line_length_m, read(2.003));
        assert_eq!(measured.hull_pitch_deg, None);
        memory.steps[1].measured = Some(measured);
        let session = Job::of(Work::Measure, Path::new("."), &memory).session;
        assert_eq!(
            session.swings[1].suspension.hull_pitch_deg,
            Some(Quantity::new(20.0, 0.2))
        );
        for (key, home) in [("line_length", 0), ("spacing", 0), ("hull_pitch_deg", 1)] {
            assert_eq!(session.measured_at(1, key), home, "{key}");
        }
        // Read anew there, it is another reading.
        let (longer, same) = (read(2.1), memory.steps[1].measured.unwrap_or_default());
        memory.steps[1].measured = Some(Measured {
            line_length_m: longer,
            ..same
        });
        let session = Job::of(Work::Measure, Path::new("."), &memory).session;
        assert_eq!(session.measured_at(1, "line_length"), 1);
        assert_eq!(session.measured_at(1, "spacing"), 0);
    }
}
