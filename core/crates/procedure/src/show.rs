//! What a screen shows of the procedure.

use super::judgement::{Recommend, TOO_LARGE, TOO_SMALL, is_unwanted};
use super::machine::Procedure;
use super::memory::StepMemory;
use super::state::{Action, Phase, Progress, RecordingView, RestView, State, StepView, Work};
use super::take::{Follow, INCLINE_STILL_S, file_of};
use super::tilt::{Against, Tilt};
use super::words::{id, number, plain, words};
use gyradius_base::frames::Vec3;
use gyradius_base::message::{Argument, Message};
use gyradius_planning::{PlannedIncline, PlannedSwing, Step};
use gyradius_recording::{End, Orientation, Quantity, SuspensionKind};
use gyradius_signal::online::Advice;

/// No sample for so long is worth a word, s.
const SILENT_S: f64 = 1.5;

impl Procedure {
    /// Where it stands. Cheap enough to be asked at every frame.
    pub fn state(&self) -> State {
        let phase = self.phase();
        let tilt = self.tilt_now(phase);
        let recording = self.recording_view(phase);
        let rest = (phase == Phase::Rest).then(|| self.rest_view());
        let work = match phase {
            Phase::Measure => Some(Work::Measure),
            Phase::Critique => Some(Work::Critique),
            _ => None,
        };
        State {
            phase,
            instruction: self.instruction(phase, tilt.as_ref(), rest.as_ref(), recording.as_ref()),
            actions: self.actions(),
            step: self.step_view(),
            progress: self.progress(),
            tilt,
            rest,
            recording,
            judgement: self
                .open_take()
                .and_then(|(_, _, take)| take.judgement.clone()),
            work,
            result: self.memory.result.clone(),
            critique: self.memory.critique.clone().flatten(),
            suggestion: self.memory.suggestion.clone(),
            warnings: self.warnings(phase),
        }
    }

    fn tilt_now(&self, phase: Phase) -> Option<Tilt> {
        let of_use = matches!(
            phase,
            Phase::Level | Phase::Rest | Phase::Hang | Phase::Ready
        );
        let placement = self
            .memory
            .begun
            .as_ref()
            .map(|begun| begun.placement)
            .unwrap_or_default();
        let reference: Option<Vec3> = if phase == Phase::Level {
            self.reference
        } else {
            self.level()
        };
        self.tilt.tilt(placement, reference).filter(|_| of_use)
    }

    fn rest_view(&self) -> RestView {
        RestView {
            still_s: self.rest.still_s(),
            wanted_s: self.rest.wanted_s(),
            moving: self.rest.moving(),
            found: self.rest.found(),
        }
    }

    /// The step whose recording is open, or the next one.
    fn shown_step(&self) -> Option<(usize, &StepMemory)> {
        match self.open_take() {
            Some((index, _, _)) => self.memory.step(index).map(|step| (index, step)),
            None => self.present(),
        }
    }

    fn step_view(&self) -> Option<StepView> {
        let (index, step) = self.shown_step()?;
        Some(StepView {
            index,
            count: self.memory.steps.len(),
            id: step.id(),
            take: step.takes.iter().map(|take| take.number).max().unwrap_or(0),
            planned: step.planned.clone(),
            hanging: step.hanging(),
        })
    }

    fn progress(&self) -> Progress {
        let steps = self.memory.steps.len();
        let steps_done = self
            .memory
            .steps
            .iter()
            .filter(|step| step.is_done())
            .count();
        let memory = &self.memory;
        let others = [
            memory.level.is_some(),
            memory.rest.is_some(),
            memory.result.is_some(),
            memory.critique.is_some(),
        ];
        let done = steps_done + others.iter().filter(|done| **done).count();
        let left = memory
            .steps
            .iter()
            .filter(|step| !step.is_done())
            .map(|step| match &step.planned {
                Step::Swing(swing) => swing.duration_s,
                Step::Incline(_) => INCLINE_STILL_S,
            });
        Progress {
            steps_done,
            steps,
            share: done as f64 / (steps + others.len()) as f64,
            recording_left_s: left.sum(),
        }
    }

    fn recording_view(&self, phase: Phase) -> Option<RecordingView> {
        let (index, _, take) = self.open_take()?;
        let step = self.memory.step(index)?;
        let file = file_of(index, &step.id(), take.number)
            .display()
            .to_string();
        match &self.running {
            Some(running) if phase == Phase::Record => {
                Some(running_view(file, &step.planned, &running.follow))
            }
            _ => {
                let recorded_s = self.cut_off.recorded_s;
                (phase == Phase::Interrupted).then(|| RecordingView {
                    file,
                    recorded_s,
                    ..Default::default()
                })
            }
        }
    }

    fn warnings(&self, phase: Phase) -> Vec<Message> {
        let mut warnings = self.told.clone();
        if self.memory.rest == Some(None) {
            warnings.push(Message::new("warn_no_rest", []));
        }
        if let Some(reason) = &self.memory.critique_failed {
            warnings.push(Message::new("warn_critique", [("reason", plain(reason))]));
        }
        let listening = matches!(phase, Phase::Level | Phase::Rest | Phase::Record);
        if let (true, Some(heard), Some(now)) = (listening, self.heard_ns, self.now_ns) {
            let silent_s = now.saturating_sub(heard) as f64 / 1e9;
            if silent_s > SILENT_S {
                warnings.push(Message::new(
                    "warn_silent",
                    [("silent_s", number(silent_s, 0))],
                ));
            }
        }
        warnings
    }

    fn instruction(
        &self,
        phase: Phase,
        tilt: Option<&Tilt>,
        rest: Option<&RestView>,
        recording: Option<&RecordingView>,
    ) -> Message {
        let id = || {
            id(self
                .shown_step()
                .map(|step| step.1.id())
                .unwrap_or_default())
        };
        match phase {
            Phase::Start => self.start_text(),
            Phase::Level => level_text(tilt),
            Phase::Rest => rest.map_or_else(|| Message::new("rest", []), rest_text),
            Phase::Hang => self
                .shown_step()
                .map_or_else(|| Message::new("measure", []), |step| hang_text(step.1)),
            Phase::Ready => self
                .shown_step()
                .map_or_else(|| Message::new("measure", []), |step| ready_text(step.1)),
            Phase::Record => recording.map_or_else(|| Message::new("waiting", []), record_text),
            Phase::Interrupted => {
                let recorded_s = self.cut_off.recorded_s;
                let goes_on = self.actions().contains(&Action::Continue);
                let key = match (recorded_s > 0.0, self.cut_off.ended) {
                    (false, _) => "interrupted_empty",
                    (true, true) => "interrupted_ended",
                    (true, false) if goes_on => "interrupted",
                    (true, false) => "interrupted_restarted",
                };
                Message::new(key, [("id", id()), ("recorded_s", number(recorded_s, 0))])
            }
            Phase::Judge => {
                let judgement = self
                    .open_take()
                    .and_then(|(_, _, take)| take.judgement.as_ref());
                let good =
                    judgement.is_some_and(|judgement| judgement.recommend == Recommend::Accept);
                Message::new(
                    if good { "judge_accept" } else { "judge_repeat" },
                    [("id", id())],
                )
            }
            Phase::Measure => Message::new("measure", []),
            Phase::Failed => {
                let reason = self
                    .memory
                    .failed
                    .as_ref()
                    .map(|failed| failed.1.clone())
                    .unwrap_or_default();
                Message::new("failed", [("reason", plain(reason))])
            }
            Phase::Critique => Message::new("critique", []),
            Phase::Suggest => self.suggest_text(),
            Phase::Done => {
                let result = self
                    .memory
                    .result
                    .as_ref()
                    .map(|result| result.session.clone());
                let session = self.folder.join(result.unwrap_or_default());
                Message::new("done", [("session", plain(session.display().to_string()))])
            }
        }
    }

    fn start_text(&self) -> Message {
        let minutes = (self.progress().recording_left_s / 60.0).ceil();
        let arguments = [
            ("title", plain(&self.memory.task.title)),
            ("steps", number(self.memory.steps.len() as f64, 0)),
            ("minutes", number(minutes, 0)),
        ];
        Message::new("start", arguments)
    }

    fn suggest_text(&self) -> Message {
        let Some(Step::Swing(swing)) = &self.memory.suggestion else {
            return Message::new("suggest", []);
        };
        let causes = self
            .memory
            .critique
            .iter()
            .flatten()
            .next()
            .map_or(2, |critique| critique.causes.max(2));
        let hung = &swing.suspension;
        let (key, lengths) = match hung.kind {
            SuspensionKind::Bifilar | SuspensionKind::Trifilar | SuspensionKind::Free => (
                "suggest",
                vec![
                    ("line_length_m", hung.line_length_m),
                    ("spacing_m", hung.spacing_m),
                ],
            ),
            SuspensionKind::Compound => (
                "suggest_compound",
                vec![("axis_height_m", hung.axis_height_m)],
            ),
        };
        let mut arguments = vec![
            ("count", number(causes as f64, 0)),
            ("extras", extras(swing)),
            ("excited", words(swing.excited.iter().map(|one| one.name()))),
            ("amplitude_deg", number(swing.amplitude_deg, 0)),
            ("duration_s", number(swing.duration_s, 0)),
        ];
        arguments.extend(
            lengths
                .into_iter()
                .map(|(name, value)| (name, length(value))),
        );
        Message::new(key, arguments)
    }
}

fn running_view(file: String, planned: &Step, follow: &Follow) -> RecordingView {
    let mut view = RecordingView {
        file,
        recorded_s: follow.recorded_s(),
        ..Default::default()
    };
    match planned {
        Step::Swing(swing) => {
            let estimate = follow.live.estimate();
            view.swinging_s = follow.swinging_s();
            view.left_s = follow.left_s();
            view.amplitude_deg = follow.release.amplitude_deg();
            view.released_deg = follow.release.released_deg(follow.free_from_ns());
            view.wanted_deg = Some(swing.amplitude_deg);
            view.advice = advice(&estimate.advice, swing, &view);
            view.live = Some(estimate);
        }
        Step::Incline(_) => {
            view.still_s = Some(follow.still.still_s());
            view.left_s = follow.left_s();
            view.advice = follow
                .still
                .moving()
                .map(|_| Message::new("advice_moving", []))
                .into_iter()
                .collect();
        }
    }
    view
}

/// What the estimator says, less what the plan asks for, and what the amplitude says beside it.
fn advice(found: &[Advice], planned: &PlannedSwing, view: &RecordingView) -> Vec<Message> {
    let asked_for = |advice: &&Advice| match **advice {
        Advice::Unwanted {
            kind,
            share,
            period_s,
        } => is_unwanted(
            &gyradius_signal::online::Line {
                kind,
                share,
                period_s,
            },
            planned,
        ),
        _ => true,
    };
    let mut texts: Vec<Message> = found
        .iter()
        .filter(asked_for)
        .map(Advice::message)
        .collect();
    let Some(released_deg) = view.released_deg else {
        return texts;
    };
    let key = match released_deg / planned.amplitude_deg {
        ratio if ratio < TOO_SMALL => "advice_small",
        ratio if ratio > TOO_LARGE => "advice_large",
        _ => return texts,
    };
    let arguments = [
        ("amplitude_deg", number(released_deg, 1)),
        ("wanted_deg", number(planned.amplitude_deg, 1)),
    ];
    texts.push(Message::new(key, arguments));
    texts
}

fn level_text(tilt: Option<&Tilt>) -> Message {
    let Some(tilt) = tilt else {
        return Message::new("level_no_gravity", []);
    };
    let shown = |angle: Option<f64>| number(angle.unwrap_or_default(), 1);
    match tilt.against {
        Against::PhonePlane => Message::new(
            "level_flat",
            [
                ("bow_up_deg", shown(tilt.bow_up_deg)),
                ("starboard_down_deg", shown(tilt.starboard_down_deg)),
            ],
        ),
        Against::Reference => {
            Message::new("level_reference", [("angle_deg", shown(tilt.angle_deg))])
        }
        Against::Nothing => Message::new("level_nothing", []),
    }
}

fn rest_text(rest: &RestView) -> Message {
    if let Some(found) = &rest.found {
        let size = |axes: [f64; 3]| 1e3 * Vec3::from(axes).norm();
        let arguments = [
            ("gyroscope_hz", number(found.gyroscope.rate_hz, 2)),
            (
                "noise_mrad_s",
                number(size(found.gyroscope.noise) / 3_f64.sqrt(), 2),
            ),
            ("bias_mrad_s", number(size(found.gyroscope.mean), 2)),
        ];
        return Message::new("rest_found", arguments);
    }
    match &rest.moving {
        Some(moving) => Message::new(
            "rest_moving",
            [
                ("rate_deg_s", number(moving.rate_deg_s, 2)),
                ("tilt_deg", number(moving.tilt_deg, 2)),
            ],
        ),
        None => Message::new(
            "rest",
            [
                ("still_s", number(rest.still_s, 0)),
                ("wanted_s", number(rest.wanted_s, 0)),
            ],
        ),
    }
}

fn length(quantity: Option<Quantity>) -> Argument {
    number(quantity.map_or(0.0, |quantity| quantity.value), 3)
}

fn hang_text(step: &StepMemory) -> Message {
    match (&step.planned, step.hanging()) {
        (Step::Swing(swing), Some(hanging)) => {
            let orientation = match hanging.orientation {
                Orientation::Athwartships => "athwartships",
                Orientation::ForeAndAft => "fore_and_aft",
            };
            let common = [
                ("id", id(&swing.id)),
                ("orientation", words(std::iter::once(orientation))),
                ("extras", extras(swing)),
            ];
            let [id, orientation, extras] = common;
            match hanging.kind {
                SuspensionKind::Bifilar | SuspensionKind::Trifilar | SuspensionKind::Free => {
                    let lengths = [
                        ("line_length_m", length(hanging.line_length_m)),
                        ("spacing_m", length(hanging.spacing_m)),
                    ];
                    let [line, spacing] = lengths;
                    Message::new("hang", [id, orientation, extras, line, spacing])
                }
                SuspensionKind::Compound => {
                    let height = ("axis_height_m", length(hanging.axis_height_m));
                    Message::new("hang_compound", [id, orientation, extras, height])
                }
            }
        }
        (Step::Incline(incline), _) => hang_incline_text(step, incline),
        (Step::Swing(_), None) => Message::new("reason_lines_unknown", []),
    }
}

fn hang_incline_text(step: &StepMemory, incline: &PlannedIncline) -> Message {
    let end = match incline.end {
        End::Bow => "bow",
        End::Stern => "stern",
    };
    let arguments = [
        ("id", id(step.id())),
        ("end", words(std::iter::once(end))),
        ("mass_kg", number(incline.mass_kg, 3)),
        ("arm_m", number(incline.arm_m, 3)),
        ("depth_m", number(incline.depth_m, 3)),
    ];
    Message::new("hang_incline", arguments)
}

/// What a swing's hanging has beside lines.
fn extras(swing: &PlannedSwing) -> Argument {
    let mut extras = Vec::new();
    if let Some(pitch) = swing
        .suspension
        .hull_pitch_deg
        .filter(|pitch| pitch.value != 0.0)
    {
        let key = if pitch.value > 0.0 {
            "extra_bow_up"
        } else {
            "extra_bow_down"
        };
        extras.push(Message::new(
            key,
            [("pitch_deg", number(pitch.value.abs(), 1))],
        ));
    }
    if let Some(points) = swing
        .suspension
        .points_moved_m
        .filter(|points| points.value != 0.0)
    {
        let key = if points.value > 0.0 {
            "extra_points_forward"
        } else {
            "extra_points_aft"
        };
        extras.push(Message::new(
            key,
            [("points_m", number(points.value.abs(), 3))],
        ));
    }
    if !swing.added_masses.is_empty() {
        extras.push(Message::new(
            "extra_masses",
            [("count", number(swing.added_masses.len() as f64, 0))],
        ));
    }
    if extras.is_empty() {
        extras.push(Message::new("no_extras", []));
    }
    Argument::Texts(extras)
}

fn ready_text(step: &StepMemory) -> Message {
    let Step::Swing(swing) = &step.planned else {
        return Message::new("ready_incline", [("wanted_s", number(INCLINE_STILL_S, 0))]);
    };
    let arguments = [
        ("excited", words(swing.excited.iter().map(|one| one.name()))),
        ("amplitude_deg", number(swing.amplitude_deg, 0)),
        ("duration_s", number(swing.duration_s, 0)),
    ];
    Message::new("ready", arguments)
}

fn record_text(view: &RecordingView) -> Message {
    match (view.still_s, view.swinging_s) {
        (Some(still_s), _) => Message::new(
            "still",
            [
                ("still_s", number(still_s, 0)),
                ("wanted_s", number(INCLINE_STILL_S, 0)),
            ],
        ),
        (None, Some(_)) => Message::new(
            "swinging",
            [("left_s", number(view.left_s.unwrap_or(0.0).ceil(), 0))],
        ),
        (None, None) => Message::new("waiting", []),
    }
}
