//! The whole procedure against the simulation: a hull that never was, a phone on it, and an
//! operator who plays by the book.
//!
//! A rig file says what is true. What the operator measures, the hull's hanging and the phone's
//! noise are drawn from the seed that is given: the same rig, seed and events give the same
//! session.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::event::{Batch, Channel, Event, Measured, PhoneInfo, Placement};
use super::judgement::Recommend;
use super::machine::Procedure;
use super::state::{Action, Phase, State};
use super::task::Task;
use gyradius_base::error::{Error, Result};
use gyradius_planning::{PlannedIncline, PlannedSwing, Step};
use gyradius_recording::{
    AddedMass, End, Excitation, Orientation, Quantity, Sensor, Suspension, SuspensionKind, Swing,
    SwingData,
};
use gyradius_simulator::{Feed, Mistakes, Release, RigFile, Silence};

/// Samples come in batches of this length, s.
const BATCH_S: f64 = 0.2;
/// The hull is held so long before it is let go, s.
const HELD_S: f64 = 3.0;
/// A hull that is left alone is simulated in pieces of this length, s.
const ALONE_S: f64 = 30.0;
/// Recordings go on for this long after their time, s: they end by themselves.
const AFTER_S: f64 = 5.0;
/// Length of the recordings, s, amplitude, degrees, and certainty of the period that a practice
/// plan asks for.
const DURATION_S: f64 = 120.0;
const AMPLITUDE_DEG: f64 = 6.0;
const PERIOD_U: f64 = 1e-4;
/// The phone's clock when it is first heard, ns.
const BOOT_NS: i64 = 7_000_000_000_000;
/// An app that was killed is back after this time, ns.
const AWAY_NS: i64 = 2_000_000_000;
/// A rest that has not been found after this time, s, is done without: wind moves some hulls all
/// the time.
const LONGEST_REST_S: f64 = 120.0;
/// An operator who plays by the book makes a swing so often before a bad one is taken all the same.
const MOST_TAKES: usize = 3;
/// The phone of practice.
const PHONE: &str = "simulated phone";

/// Something that goes wrong with one recording.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mishap {
    /// With the hull or the phone.
    pub mistakes: Mistakes,
    /// A sensor that falls silent.
    pub silence: Option<Silence>,
}

/// A procedure with a simulated hull and phone.
pub struct Rehearsal {
    procedure: Procedure,
    rig: RigFile,
    seed: u64,
    /// Numbers the feeds, so that each has its own chance.
    feeds: usize,
    feed: Option<(Scene, Feed)>,
    /// What the phone recorded while time last went by.
    heard: Vec<Batch>,
    now_ns: i64,
    /// When the rest began, ns.
    rest_ns: Option<i64>,
    mishaps: BTreeMap<(String, usize), Mishap>,
}

/// What is being simulated.
#[derive(Debug, Clone, PartialEq)]
enum Scene {
    Alone,
    Step { index: usize, take: usize },
}

/// What a practice plan asks for: the rig's swings, in its order. A plan knows no instruments: their
/// errors are in its figures' own.
pub fn practice_task(rig: &RigFile) -> Task {
    let session = rig.session.without_instruments();
    let step = |swing: &Swing| {
        let excited = if swing.excited.is_empty() {
            vec![Excitation::Yaw]
        } else {
            swing.excited.clone()
        };
        Step::Swing(PlannedSwing {
            id: swing.id.clone(),
            suspension: swing.suspension.clone(),
            added_masses: swing.added_masses.clone(),
            excited,
            amplitude_deg: AMPLITUDE_DEG,
            duration_s: DURATION_S,
            periods_s: BTreeMap::new(),
            period_u_wanted: PERIOD_U,
        })
    };
    Task {
        title: session.title.clone(),
        body: session.body.clone(),
        site: session.site.clone(),
        attachments: session.attachments.clone(),
        steps: session.swings.iter().map(step).collect(),
    }
}

impl Rehearsal {
    /// Begins a procedure in a folder on the hull of a rig. Fails as [`Procedure::create`] does.
    pub fn create(folder: impl AsRef<Path>, rig: RigFile, task: Task, seed: u64) -> Result<Self> {
        Ok(Self::of(
            Procedure::create(folder, task)?,
            rig,
            seed,
            BOOT_NS,
        ))
    }

    /// Goes on with one that was left: two seconds have gone by on the phone's clock, and a
    /// recording that goes on finds the hull held aside once more. Fails as [`Procedure::open`]
    /// does.
    pub fn open(folder: impl AsRef<Path>, rig: RigFile, seed: u64) -> Result<Self> {
        let procedure = Procedure::open(folder)?;
        let now_ns = procedure
            .newest_ns()
            .map_or(BOOT_NS, |newest| newest.saturating_add(AWAY_NS));
        Ok(Self::of(procedure, rig, seed, now_ns))
    }

    fn of(procedure: Procedure, rig: RigFile, seed: u64, now_ns: i64) -> Self {
        Self {
            procedure,
            rig,
            seed,
            feeds: 0,
            feed: None,
            heard: Vec::new(),
            now_ns,
            rest_ns: None,
            mishaps: BTreeMap::new(),
        }
    }

    /// Lets something go wrong with one recording of a step, counted from 1.
    pub fn mishap(&mut self, step: &str, take: usize, mishap: Mishap) {
        self.mishaps.insert((step.to_owned(), take), mishap);
    }

    /// The procedure.
    pub fn procedure(&mut self) -> &mut Procedure {
        &mut self.procedure
    }

    /// Where it stands.
    pub fn state(&self) -> State {
        self.procedure.state()
    }

    /// The folder of the procedure.
    pub fn folder(&self) -> PathBuf {
        self.procedure.folder().to_owned()
    }

    /// Takes what the operator did. Fails as [`Procedure::handle`] does.
    pub fn handle(&mut self, event: Event) -> Result<()> {
        self.procedure.handle(event)?;
        let rests = self.procedure.phase() == Phase::Rest;
        self.rest_ns = rests.then(|| self.rest_ns.unwrap_or(self.now_ns));
        Ok(())
    }

    /// Lets so much time go by on the simulated hull, s; less where the recording ends meanwhile,
    /// and none where the phone is not listened to. Returns what went by.
    pub fn advance(&mut self, seconds: f64) -> Result<f64> {
        self.heard.clear();
        let from_ns = self.now_ns;
        let gone_s = |now_ns: i64| now_ns.saturating_sub(from_ns) as f64 / 1e9;
        while gone_s(self.now_ns) < seconds {
            let Some(scene) = self.scene() else { break };
            if self.feed.as_ref().is_none_or(|(of, _)| *of != scene) {
                self.feed = Some((scene.clone(), self.simulate(&scene)?));
            }
            let Some((_, feed)) = &mut self.feed else {
                break;
            };
            let left_s = seconds - gone_s(self.now_ns);
            let Some(heard) = feed.next(left_s.min(BATCH_S)) else {
                self.feed = None;
                continue;
            };
            self.now_ns = feed.now_ns();
            for one in heard {
                let channel = match one.sensor {
                    Sensor::Gyroscope => Channel::Gyroscope,
                    _ => Channel::Accelerometer,
                };
                let batch = Batch {
                    channel,
                    stamps_ns: one.stamps_ns,
                    values: one.values,
                };
                self.procedure.handle(Event::Samples(batch.clone()))?;
                self.heard.push(batch);
            }
        }
        Ok(gone_s(self.now_ns))
    }

    /// What the phone recorded while time last went by.
    pub fn heard(&self) -> &[Batch] {
        &self.heard
    }

    /// What an operator who plays by the book does now; nothing while there is to be waited or
    /// worked.
    pub fn by_the_book(&self, at_utc: &str) -> Result<Option<Event>> {
        let state = self.state();
        let offered = |action| state.actions.contains(&action);
        Ok(match state.phase {
            Phase::Start => {
                let phone = PhoneInfo {
                    model: PHONE.to_owned(),
                    sensors: Vec::new(),
                };
                Some(Event::Begin {
                    at_utc: at_utc.to_owned(),
                    measured_on: None,
                    phone,
                    placement: Placement::AnyWay,
                })
            }
            Phase::Level => offered(Action::Accept).then_some(Event::Accept),
            Phase::Rest if offered(Action::Accept) => Some(Event::Accept),
            Phase::Rest => {
                let rested_s = self
                    .rest_ns
                    .map_or(0.0, |from| self.now_ns.saturating_sub(from) as f64 / 1e9);
                (rested_s > LONGEST_REST_S).then_some(Event::Skip)
            }
            Phase::Hang => Some(Event::Measured(self.tape()?)),
            Phase::Ready => Some(Event::StartRecording {
                at_utc: at_utc.to_owned(),
            }),
            Phase::Interrupted => [
                (Action::Continue, Event::Continue),
                (Action::Keep, Event::Keep),
                (Action::Repeat, Event::Repeat),
            ]
            .into_iter()
            .find_map(|(action, event)| offered(action).then_some(event)),
            Phase::Judge => {
                let take = state.step.map_or(0, |step| step.take);
                let good = state
                    .judgement
                    .is_some_and(|judgement| judgement.recommend == Recommend::Accept);
                Some(if good || take >= MOST_TAKES {
                    Event::Accept
                } else {
                    Event::Repeat
                })
            }
            Phase::Suggest => Some(Event::Skip),
            Phase::Record | Phase::Measure | Phase::Failed | Phase::Critique | Phase::Done => None,
        })
    }

    /// What the operator's tape says of the present step: what is true, and an error as large as
    /// the plan's uncertainty of it makes one.
    pub fn tape(&self) -> Result<Measured> {
        let Some(step) = self.state().step else {
            return Ok(Measured::default());
        };
        match &step.planned {
            Step::Swing(swing) => Ok(self.tape_of(&swing.suspension)),
            Step::Incline(incline) => Ok(Measured {
                mass_kg: Some(Quantity::new(incline.mass_kg, 0.001)),
                arm_m: Some(Quantity::new(incline.arm_m, 0.002)),
                depth_m: Some(Quantity::new(incline.depth_m, 0.002)),
                ..Measured::default()
            }),
        }
    }

    fn tape_of(&self, planned: &Suspension) -> Measured {
        let mut measured = Measured::default();
        let lengths = [
            (
                "line_length",
                planned.line_length_m,
                &mut measured.line_length_m,
            ),
            ("spacing", planned.spacing_m, &mut measured.spacing_m),
            (
                "top_spacing",
                planned.top_spacing_m,
                &mut measured.top_spacing_m,
            ),
            (
                "hull_pitch",
                planned.hull_pitch_deg,
                &mut measured.hull_pitch_deg,
            ),
            (
                "axis_height",
                planned.axis_height_m,
                &mut measured.axis_height_m,
            ),
        ];
        for (name, planned, stated) in lengths {
            *stated =
                planned.map(|p| Quantity::new(p.value + p.u * self.chance(name, p.value), p.u));
        }
        measured.points_moved_m = planned
            .points_moved_m
            .map(|points| self.moved(planned, points.u));
        measured
    }

    /// Points are moved until the hull hangs at the planned tilt, (26): how far that is, only the
    /// tape tells.
    fn moved(&self, planned: &Suspension, u_m: f64) -> Quantity {
        let pitch_deg = planned.hull_pitch_deg.map_or(0.0, |pitch| pitch.value);
        let depth_m = self.truth().get("cm_depth_m").copied().unwrap_or_default();
        let moved_m = depth_m * pitch_deg.to_radians().tan();
        Quantity::new(moved_m + u_m * self.chance("points_moved", moved_m), u_m)
    }

    /// A standard normal number for a dimension: the same wherever that dimension is hung again.
    fn chance(&self, name: &str, value: f64) -> f64 {
        let mut generator = ChaCha8Rng::seed_from_u64(self.seed);
        // Streams of their own beside those of the sensors: from a hash of name and value.
        let text = format!("{name} {value}");
        generator.set_stream(u64::MAX - u64::from(crc32fast::hash(text.as_bytes())));
        StandardNormal.sample(&mut generator)
    }

    fn scene(&self) -> Option<Scene> {
        let state = self.state();
        match state.phase {
            Phase::Level | Phase::Rest | Phase::Hang | Phase::Ready => Some(Scene::Alone),
            Phase::Record => state.step.map(|step| Scene::Step {
                index: step.index,
                take: step.take,
            }),
            _ => None,
        }
    }

    fn simulate(&mut self, scene: &Scene) -> Result<Feed> {
        self.feeds += 1;
        let step = self.state().step;
        let mut swing = self.hanging(step.as_ref().map(|step| &step.planned));
        let alone = Release {
            held_s: 0.0,
            swings_s: ALONE_S,
            ..Release::default()
        };
        let (mut release, mut mishap) = (alone, Mishap::default());
        if let (Scene::Step { take, .. }, Some(step)) = (scene, &step) {
            mishap = self
                .mishaps
                .get(&(step.id.clone(), *take))
                .copied()
                .unwrap_or_default();
            match &step.planned {
                Step::Swing(planned) => release = let_go(planned),
                Step::Incline(incline) => swing.added_masses.push(weight(incline)),
            }
        }
        let told = truth(&swing.suspension);
        let rigged = self
            .rig
            .rehung(&swing, &release, &mishap.mistakes, &told, self.feeds)?;
        Feed::of(&rigged, self.seed, self.now_ns, mishap.silence)
    }

    /// The hull as a step hangs it; inclines and rests hang as the first swing does.
    fn hanging(&self, step: Option<&Step>) -> Swing {
        let first = self
            .rig
            .session
            .swings
            .first()
            .map(|swing| swing.suspension.clone());
        let (suspension, added_masses) = match step {
            Some(Step::Swing(planned)) => {
                (planned.suspension.clone(), planned.added_masses.clone())
            }
            _ => (first.unwrap_or_else(plain_lines), Vec::new()),
        };
        Swing {
            id: "practice".to_owned(),
            data: SwingData::Recording("practice.csv".to_owned()),
            excited: Vec::new(),
            added_masses,
            amplitude_deg: BTreeMap::new(),
            suspension,
        }
    }

    /// What is true of the hull, by name: the rig's `[truth]`.
    pub fn truth(&self) -> BTreeMap<String, f64> {
        self.rig
            .truth
            .all()
            .iter()
            .map(|(name, value)| ((*name).to_owned(), *value))
            .collect()
    }
}

/// True dimensions of a practice hull are those planned: it is the tape that errs.
fn truth(planned: &Suspension) -> BTreeMap<String, f64> {
    let spacing = planned.spacing_m.map(|spacing| spacing.value);
    let dimensions = [
        (
            "line_length_m",
            planned.line_length_m.map(|length| length.value),
        ),
        ("spacing_m", spacing),
        (
            "top_spacing_m",
            planned.top_spacing_m.map(|top| top.value).or(spacing),
        ),
        (
            "hull_pitch_deg",
            planned.hull_pitch_deg.map(|pitch| pitch.value),
        ),
        (
            "axis_height_m",
            planned.axis_height_m.map(|height| height.value),
        ),
    ];
    dimensions
        .into_iter()
        .filter_map(|(name, value)| Some((name.to_owned(), value?)))
        .collect()
}

fn let_go(planned: &PlannedSwing) -> Release {
    Release {
        excited: planned.excited.clone(),
        amplitude_deg: planned.amplitude_deg,
        held_s: HELD_S,
        swings_s: planned.duration_s + AFTER_S,
    }
}

/// A weight on a line pulls at the point that it hangs from.
fn weight(incline: &PlannedIncline) -> AddedMass {
    let forward = match incline.end {
        End::Bow => 1.0,
        End::Stern => -1.0,
    };
    AddedMass {
        mass_kg: Quantity::exact(incline.mass_kg),
        position_m: [forward * incline.arm_m, 0.0, -incline.depth_m],
    }
}

fn plain_lines() -> Suspension {
    Suspension {
        line_length_m: Some(Quantity::exact(3.0)),
        spacing_m: Some(Quantity::exact(1.5)),
        ..Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships)
    }
}

impl std::str::FromStr for Mishap {
    type Err = Error;

    /// `bad_release`, `sway`, `touch`, `slip` or `silence`, as a trainer would ask for it.
    fn from_str(name: &str) -> Result<Self> {
        let mut mishap = Self::default();
        let mistakes = &mut mishap.mistakes;
        match name {
            "bad_release" => mistakes.amplitude = Some(0.3),
            "sway" => mistakes.sway_m = 0.25,
            "touch" => mistakes.touch_s = Some(80.0),
            "slip" => mistakes.slip_s = Some(50.0),
            "silence" => {
                mishap.silence = Some(Silence {
                    sensor: Sensor::Gyroscope,
                    from_s: 30.0,
                    until_s: 60.0,
                });
            }
            other => {
                return Err(Error::argument(
                    "mishap",
                    "bad_release, sway, touch, slip or silence",
                    other,
                ));
            }
        }
        Ok(mishap)
    }
}
