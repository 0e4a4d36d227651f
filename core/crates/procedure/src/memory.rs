//! What the journal's entries come to.

use super::entry::Entry;
use super::event::{Measured, PhoneInfo, Placement};
use super::judgement::Judgement;
use super::rest::Rest;
use super::state::{CritiqueView, ResultView, Work};
use super::task::Task;
use gyradius_base::frames::Vec3;
use gyradius_planning::{PlannedSwing, Step};
use gyradius_recording::{End, Quantity, Suspension};

/// Everything that has been decided.
#[derive(Debug, Clone, Default)]
pub(super) struct Memory {
    pub task: Task,
    pub begun: Option<Begun>,
    pub level: Option<Vec3>,
    /// Taken, or done without.
    pub rest: Option<Option<Rest>>,
    pub steps: Vec<StepMemory>,
    pub result: Option<ResultView>,
    pub failed: Option<(Work, String)>,
    /// Made, or done without.
    pub critique: Option<Option<CritiqueView>>,
    pub critique_failed: Option<String>,
    pub suggestion: Option<Step>,
}

/// What was told at the beginning.
#[derive(Debug, Clone)]
pub(super) struct Begun {
    pub measured_on: String,
    pub phone: PhoneInfo,
    pub placement: Placement,
}

/// One step and what came of it.
#[derive(Debug, Clone)]
pub(super) struct StepMemory {
    pub planned: Step,
    pub measured: Option<Measured>,
    pub takes: Vec<Take>,
    pub skipped: bool,
}

/// One recording of a step.
#[derive(Debug, Clone, Default)]
pub(super) struct Take {
    /// From 1.
    pub number: usize,
    pub judgement: Option<Judgement>,
    pub accepted: Option<bool>,
}

impl StepMemory {
    pub fn new(planned: Step) -> Self {
        Self {
            planned,
            measured: None,
            takes: Vec::new(),
            skipped: false,
        }
    }

    pub fn accepted(&self) -> Option<&Take> {
        self.takes.iter().find(|take| take.accepted == Some(true))
    }

    /// Left out, or recorded and measured: a recording whose dimensions were lost with the
    /// journal's end is not enough.
    pub fn is_done(&self) -> bool {
        self.skipped || (self.accepted().is_some() && self.measured.is_some())
    }

    /// The recording that waits for a decision.
    pub fn open_take(&self) -> Option<&Take> {
        let is_settled = self.skipped || self.accepted().is_some();
        self.takes
            .iter()
            .rev()
            .find(|take| take.accepted.is_none() && !is_settled)
    }

    pub fn id(&self) -> String {
        match &self.planned {
            Step::Swing(swing) => swing.id.clone(),
            Step::Incline(incline) => match incline.end {
                End::Bow => "incline-bow".to_owned(),
                End::Stern => "incline-stern".to_owned(),
            },
        }
    }

    /// How a swing hangs, as far as it was measured and as planned otherwise. Points count as moved
    /// only where that was measured: how far they were planned to go follows from a depth that is
    /// itself sought.
    pub fn hanging(&self) -> Option<Suspension> {
        let Step::Swing(PlannedSwing {
            suspension: planned,
            ..
        }) = &self.planned
        else {
            return None;
        };
        let measured = self.measured.unwrap_or_default();
        let or = |measured: Option<Quantity>, planned: Option<Quantity>| measured.or(planned);
        Some(Suspension {
            kind: planned.kind,
            orientation: planned.orientation,
            line_length_m: or(measured.line_length_m, planned.line_length_m),
            spacing_m: or(measured.spacing_m, planned.spacing_m),
            top_spacing_m: or(measured.top_spacing_m, planned.top_spacing_m),
            hull_pitch_deg: or(measured.hull_pitch_deg, planned.hull_pitch_deg),
            hull_roll_deg: planned.hull_roll_deg,
            points_m: planned.points_m.clone(),
            points_moved_m: measured.points_moved_m,
            axis_height_m: or(measured.axis_height_m, planned.axis_height_m),
        })
    }
}

impl Memory {
    pub fn of(entries: Vec<Entry>) -> Self {
        let mut memory = Self::default();
        entries.into_iter().for_each(|entry| memory.take(entry));
        memory
    }

    /// The step that is to be done next.
    pub fn present(&self) -> Option<usize> {
        self.steps.iter().position(|step| !step.is_done())
    }

    pub fn step(&self, index: usize) -> Option<&StepMemory> {
        self.steps.get(index)
    }

    /// What was measured of earlier steps that are planned to hang as this one, or on the same lines
    /// in another way: then of the lines alone.
    pub fn measured_alike(&self, index: usize) -> Option<Measured> {
        let Some(Step::Swing(mine)) = self.steps.get(index).map(|step| &step.planned) else {
            return None;
        };
        let mut alike: Vec<(usize, Measured)> = Vec::new();
        for step in self.steps.iter().rev() {
            let (Step::Swing(other), Some(measured)) = (&step.planned, step.measured) else {
                continue;
            };
            let (other, mine) = (&other.suspension, &mine.suspension);
            if let Some(mut but_for) = other.differences(mine) {
                if other.orientation != mine.orientation {
                    // Other points: of the same are the lines alone.
                    let others = mine
                        .kind
                        .figures()
                        .iter()
                        .filter(|key| **key != "line_length");
                    but_for.extend(others.map(|key| (*key).to_owned()));
                }
                alike.push((but_for.len(), measured.but_for(&but_for)));
            }
        }
        // The last of those that differ least comes first.
        alike.sort_by_key(|(differences, _)| *differences);
        let alike = alike.into_iter().map(|(_, measured)| measured);
        alike.reduce(|nearest, other| nearest.over(Some(other)))
    }

    pub fn take(&mut self, entry: Entry) {
        match entry {
            Entry::Created { task, .. } => {
                self.steps = task.steps.iter().cloned().map(StepMemory::new).collect();
                self.task = task;
            }
            Entry::Begun {
                measured_on,
                phone,
                placement,
                ..
            } => {
                self.begun = Some(Begun {
                    measured_on,
                    phone,
                    placement,
                });
            }
            Entry::Levelled { up } => self.level = Some(Vec3::from(up)),
            Entry::Rested { rest } => self.rest = Some(Some(rest)),
            Entry::RestSkipped => self.rest = Some(None),
            Entry::Measured { result } => (self.result, self.failed) = (Some(result), None),
            Entry::Failed {
                work: Work::Measure,
                reason,
            } => self.failed = Some((Work::Measure, reason)),
            Entry::Failed {
                work: Work::Critique,
                reason,
            } => {
                (self.critique, self.critique_failed) = (Some(None), Some(reason));
            }
            Entry::Retried => self.failed = None,
            Entry::Criticised {
                critique,
                suggestion,
            } => {
                (self.critique, self.suggestion) = (Some(Some(critique)), suggestion);
            }
            Entry::CritiqueSkipped => self.critique = Some(None),
            Entry::SuggestionDeclined => self.suggestion = None,
            Entry::SuggestionTaken { step } => {
                self.steps.push(StepMemory::new(step));
                self.forget_result();
            }
            Entry::Hung { step, .. }
            | Entry::Started { step, .. }
            | Entry::Ended { step, .. }
            | Entry::Decided { step, .. }
            | Entry::Skipped { step }
            | Entry::Reopened { step } => self.take_of_step(step, entry),
        }
    }

    fn take_of_step(&mut self, index: usize, entry: Entry) {
        if matches!(entry, Entry::Reopened { .. }) {
            self.forget_result();
        }
        let Some(step) = self.steps.get_mut(index) else {
            return;
        };
        let numbered = |takes: &mut Vec<Take>, number: usize| {
            takes.iter().position(|take| take.number == number)
        };
        match entry {
            Entry::Hung { measured, .. } => step.measured = Some(measured),
            Entry::Started { take, .. } => step.takes.push(Take {
                number: take,
                ..Take::default()
            }),
            Entry::Ended {
                take, judgement, ..
            } => {
                if let Some(at) = numbered(&mut step.takes, take) {
                    step.takes[at].judgement = Some(judgement);
                }
            }
            Entry::Decided { take, accepted, .. } => {
                if let Some(at) = numbered(&mut step.takes, take) {
                    step.takes[at].accepted = Some(accepted);
                }
            }
            Entry::Skipped { .. } => step.skipped = true,
            Entry::Reopened { .. } => {
                step.skipped = false;
                step.measured = None;
                step.takes
                    .iter_mut()
                    .for_each(|take| take.accepted = Some(false));
            }
            _ => {}
        }
    }

    /// What follows from the recordings no longer holds once there is to be another.
    fn forget_result(&mut self) {
        (self.result, self.failed) = (None, None);
        (self.critique, self.critique_failed, self.suggestion) = (None, None, None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gyradius_base::language::Language;

    #[test]
    fn what_an_older_journal_has_in_english_is_told_in_every_language() {
        let mut memory = Memory::default();
        let result = r#"{"session": "s", "quantities": {}, "warnings": ["It sways."]}"#;
        memory.take(Entry::Measured {
            result: serde_json::from_str(result).unwrap(),
        });
        let critique =
            r#"{"status": "adequate", "text": "It swings.", "causes": 0, "quantities": {}}"#;
        memory.take(Entry::Criticised {
            critique: serde_json::from_str(critique).unwrap(),
            suggestion: None,
        });
        let warnings = memory.result.unwrap().warnings;
        assert_eq!(warnings[0].in_language(Language::German), "It sways.");
        assert_eq!(
            memory
                .critique
                .flatten()
                .unwrap()
                .message
                .in_language(Language::German),
            "It swings."
        );
    }
}
