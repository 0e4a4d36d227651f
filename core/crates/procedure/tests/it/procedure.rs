//! The procedure, played from end to end by an operator on hulls that never were, and killed
//! wherever it can be.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use gyradius_base::Error;
use gyradius_base::language::Language;
use gyradius_diagnosis::{CauseVerdict, Criticism, Critique, SwingTrace};
use gyradius_planning::{PlannedIncline, Step};
use gyradius_procedure::{
    Action, Batch, Channel, Event, Judgement, Measured, Outcome, Phase, PhoneInfo, Placement,
    Procedure, Recommend, Rehearsal, State, Task, keep_criticism, kept_criticism, practice_task,
};
use gyradius_recording::recorder::{Piece, Reader};
use gyradius_recording::{
    DISTURBED, End, Excitation, Quantity, RecordedEvent, Sensor, load_session,
};
use gyradius_simulator::{RigFile, read_rig};
use gyradius_test_support::cases;
use gyradius_test_support::{fresh, seed};
use proptest::prelude::*;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const SHIPPED: &str = include_str!("../../../../../python/gyradius/rigs/keelboat.toml");
const UTC: &str = "2026-05-04T09:30:00Z";

/// A fresh seed, and a generator from it.
fn drawn_from(what: &str) -> (u64, ChaCha8Rng) {
    let seed = seed(what);
    (seed, ChaCha8Rng::seed_from_u64(seed))
}

/// The shipped keelboat with another body and other noise.
fn drawn(rng: &mut impl Rng) -> RigFile {
    let mut text = SHIPPED.to_owned();
    for (key, shipped, low, high) in [
        ("k_yaw_m", "1.0566", 0.9, 1.2),
        ("k_pitch_m", "1.156", 1.0, 1.3),
        ("cm_depth_m", "0.402", 0.3, 0.5),
        ("gyro_rad_s", "0.002", 0.0005, 0.003),
        ("turn_z_rad", "0.4", -3.0, 3.0),
    ] {
        let line = format!("{key} = {shipped}");
        assert!(text.contains(&line), "{line}");
        text = text.replace(&line, &format!("{key} = {}", rng.random_range(low..high)));
    }
    read_rig(&text, "rig.toml").unwrap()
}

/// Yaw alone, yaw with sway, surge with pitch, and a weight on the stern.
fn whole_task(rig: &RigFile) -> Task {
    let mut task = practice_task(rig);
    let Step::Swing(mut yaw) = task.steps[0].clone() else {
        panic!()
    };
    yaw.id = "yaw".into();
    yaw.excited = vec![Excitation::Yaw];
    task.steps.insert(0, Step::Swing(yaw));
    let (mass_kg, depth_m) = (
        rig.session.body.mass_kg.unwrap().value,
        rig.truth.all()["cm_depth_m"],
    );
    // A weight m at arm L and depth b tilts a hull of mass M, whose centre is h below the points,
    // by tan θ = mL/(Mh + mb).
    let (weight, arm, depth) = (20.0_f64, 2.5, 0.05);
    let tilt = (weight * arm / (mass_kg * depth_m + weight * depth))
        .atan()
        .to_degrees();
    let incline = PlannedIncline {
        end: End::Stern,
        mass_kg: weight,
        arm_m: arm,
        depth_m: depth,
        pitch_deg: tilt,
    };
    task.steps.push(Step::Incline(incline));
    task
}

/// What was judged, by step and take.
type Judged = BTreeMap<(String, usize), Judgement>;

fn english(state: &State) -> Vec<String> {
    let mut texts = vec![state.instruction.clone()];
    texts.extend(state.warnings.clone());
    texts.extend(
        state
            .recording
            .iter()
            .flat_map(|recording| recording.advice.clone()),
    );
    texts.extend(
        state
            .judgement
            .iter()
            .flat_map(|one| one.reasons.iter().chain(&one.notes).cloned()),
    );
    for text in &texts {
        assert!(
            !text.english.is_empty() && !text.english.contains('{'),
            "{text:?}"
        );
    }
    texts.into_iter().map(|text| text.english).collect()
}

/// Plays by the book until the steps are done.
fn play(rehearsal: &mut Rehearsal, judged: &mut Judged, until: impl Fn(&State) -> bool) {
    for _ in 0..20_000 {
        let state = rehearsal.state();
        english(&state);
        if until(&state) || matches!(state.phase, Phase::Measure | Phase::Critique | Phase::Done) {
            return;
        }
        if let (Some(judgement), Some(step)) = (&state.judgement, &state.step) {
            judged.insert((step.id.clone(), step.take), judgement.clone());
        }
        match rehearsal.by_the_book(UTC).unwrap() {
            Some(event) => rehearsal.handle(event).unwrap(),
            None => assert!(rehearsal.advance(1.0).unwrap() > 0.0, "{:?}", state.phase),
        }
    }
    panic!(
        "the procedure does not end: {:?}",
        rehearsal.state().instruction
    );
}

fn at(judged: &Judged, step: &str, take: usize) -> (Recommend, Vec<String>) {
    let judgement = &judged[&(step.to_owned(), take)];
    (
        judgement.recommend,
        judgement
            .reasons
            .iter()
            .map(|reason| reason.key.clone())
            .collect(),
    )
}

/// To be repeated, and for this reason.
fn assert_repeat(judged: &Judged, step: &str, take: usize, why: &str) {
    let (recommend, reasons) = at(judged, step, take);
    assert!(
        recommend == Recommend::Repeat && reasons.iter().any(|key| key == why),
        "{step} {take}: {reasons:?}"
    );
}

/// Hulls drawn anew, and everything that can go wrong: parasitic sway, a bad release, a touch, a
/// slip, a silent gyroscope, and an app that is killed in the middle of a recording. A correct
/// program misses a bound of four of its own standard uncertainties less than once in 10 000.
#[test]
fn an_operator_is_led_to_the_right_inertia_whatever_goes_wrong() {
    for round in 0..2 {
        let (seed, mut rng) = drawn_from(&format!("operator {round}"));
        let rig = drawn(&mut rng);
        let folder = tempfile::tempdir().unwrap();
        let task = whole_task(&rig);
        let mut rehearsal = Rehearsal::create(folder.path(), rig.clone(), task, seed).unwrap();
        let mishaps = [
            ("yaw", 1, "sway"),
            ("yaw-sway", 1, "bad_release"),
            ("yaw-sway", 2, "touch"),
            ("surge-pitch", 1, "slip"),
            ("surge-pitch", 2, "silence"),
        ];
        mishaps
            .iter()
            .for_each(|(step, take, what)| rehearsal.mishap(step, *take, what.parse().unwrap()));
        let mut judged = Judged::new();
        // Killed somewhere in the second recording, and started again two seconds later.
        let killed_s = rng.random_range(10.0..100.0);
        play(&mut rehearsal, &mut judged, |state| {
            let here = state
                .step
                .as_ref()
                .is_some_and(|step| (step.id.as_str(), step.take) == ("yaw", 2));
            here && state
                .recording
                .as_ref()
                .is_some_and(|recording| recording.recorded_s > killed_s)
        });
        assert_eq!(rehearsal.state().phase, Phase::Record);
        drop(rehearsal);
        let mut rehearsal = Rehearsal::open(folder.path(), rig.clone(), seed).unwrap();
        let state = rehearsal.state();
        assert_eq!(state.phase, Phase::Interrupted);
        assert!(state.recording.unwrap().recorded_s > killed_s - 1.0);
        mishaps
            .iter()
            .for_each(|(step, take, what)| rehearsal.mishap(step, *take, what.parse().unwrap()));
        play(&mut rehearsal, &mut judged, |_| false);
        println!("killed after {killed_s:.0} s");
        for (step, take) in judged.keys() {
            println!("{step} {take}: {:?}", at(&judged, step, *take));
        }

        assert_repeat(&judged, "yaw", 1, "reason_sway");
        assert_repeat(&judged, "yaw-sway", 1, "reason_small");
        // Touched 80 s after the first sample: to be repeated, or judged by what stands on one side
        // of the touch.
        let touched = &judged[&("yaw-sway".to_owned(), 2)];
        let one_side = touched
            .swing
            .as_ref()
            .is_some_and(|swing| swing.at_s < 85.0 || swing.from_s > 75.0);
        assert!(
            touched.recommend == Recommend::Repeat || one_side,
            "{touched:?}"
        );
        assert_repeat(&judged, "surge-pitch", 1, "reason_slip");
        assert_repeat(&judged, "surge-pitch", 2, "reason_gaps");
        assert_eq!(at(&judged, "surge-pitch", 3), (Recommend::Accept, vec![]));
        assert_eq!(at(&judged, "incline-stern", 1), (Recommend::Accept, vec![]));

        // Nothing recorded is lost: a file for every recording that was begun.
        let files = fs::read_dir(folder.path().join("takes")).unwrap().count();
        assert_eq!(files, judged.len());
        rehearsal.procedure().work(&|_, _| true).unwrap();
        let state = rehearsal.state();
        assert_eq!(state.phase, Phase::Critique, "{:?}", state.instruction);
        let loaded = load_session(folder.path().join("session")).unwrap();
        assert_eq!(loaded.session.swings.len(), 3);
        assert_eq!(loaded.session.recorded.len(), 3);
        assert_eq!(loaded.session.inclines.len(), 1);
        // Whatever is judged by one side of the touch is measured by it.
        let marks = &loaded.session.recorded[1].events;
        let is_marked =
            |mark: &RecordedEvent| mark.key == DISTURBED && (mark.t_s - 80.0).abs() < 5.0;
        assert!(
            touched.recommend == Recommend::Repeat || marks.iter().any(is_marked),
            "{marks:?}"
        );
        assert_eq!(loaded.session.measured_on, UTC[..10]);
        let result = state.result.unwrap();
        for name in ["k_yaw_m", "k_pitch_m", "cm_depth_m"] {
            let quantity = &result.quantities[name];
            let (value, u) = (
                quantity.value.scalar().unwrap(),
                quantity.u.scalar().unwrap(),
            );
            let z = (value - rig.truth.all()[name]) / u;
            println!(
                "{name} {value:.5} ± {u:.5}, true {:.5}, z {z:.2}",
                rig.truth.all()[name]
            );
            assert!(z.abs() < 4.0 && u < 0.02 * value);
        }
        assert_eq!(a_further_swing(rehearsal.procedure()), Phase::Measure);
    }
}

/// The criticism suggests a swing: it is offered, becomes a step, survives the app's end, and the
/// result is made anew.
fn a_further_swing(procedure: &mut Procedure) -> Phase {
    let Some(Step::Swing(mut swing)) = practice_task(&read_rig(SHIPPED, "rig.toml").unwrap())
        .steps
        .pop()
    else {
        panic!()
    };
    swing.id = "extra-1".into();
    let suggested = Step::Swing(swing);
    assert_eq!(
        kept_criticism(procedure.folder())
            .unwrap()
            .map(|kept| kept.critique.title),
        None
    );
    let outcome = Outcome::Criticised(Box::default(), Some(Box::new(suggested.clone())));
    procedure.finish(outcome.clone()).unwrap();
    assert!(
        procedure
            .finish(outcome)
            .unwrap_err()
            .to_string()
            .contains("work that is wanted")
    );
    let state = procedure.state();
    assert_eq!(
        (state.phase, state.suggestion.as_ref()),
        (Phase::Suggest, Some(&suggested))
    );
    english(&state);
    let folder = procedure.folder().to_owned();
    let mut declined = Procedure::open(&folder).unwrap();
    declined.handle(Event::Accept).unwrap();
    let state = Procedure::open(&folder).unwrap().state();
    assert_eq!(
        (
            state.phase,
            state.step.unwrap().id.as_str(),
            state.progress.steps
        ),
        (Phase::Hang, "extra-1", 5)
    );
    assert!(state.result.is_none());
    declined.handle(Event::Skip).unwrap();
    declined.state().phase
}

/// What is kept of a criticism is read again whole, curves included; what cannot be drawn is left
/// out.
#[test]
fn a_criticism_is_kept_with_what_its_pictures_are_drawn_from() {
    let folder = tempfile::tempdir().unwrap();
    assert!(kept_criticism(folder.path()).unwrap().is_none());
    let curve = |values: [f64; 2]| SwingTrace {
        swing: "yaw".into(),
        t_s: vec![0.0, 0.1],
        measured: values.to_vec(),
        base: vec![1.0 / 3.0, 2.0],
        extended: vec![0.1, 0.2],
        ..SwingTrace::default()
    };
    let critique = Critique {
        title: "boat".into(),
        ..Critique::default()
    };
    let traces = vec![curve([0.25, -1e-17]), curve([f64::NAN, 0.0])];
    keep_criticism(
        folder.path(),
        &Criticism {
            critique: critique.clone(),
            traces,
        },
    )
    .unwrap();
    let kept = kept_criticism(folder.path()).unwrap().unwrap();
    assert_eq!(
        (kept.critique, kept.traces),
        (critique.clone(), vec![curve([0.25, -1e-17])])
    );
    // One whose sentences are in English alone tells them in every language.
    let verdict = CauseVerdict {
        message: "It sways.".into(),
        ..CauseVerdict::default()
    };
    let english = Criticism {
        critique: Critique {
            verdict,
            ..critique
        },
        traces: vec![],
    };
    keep_criticism(folder.path(), &english).unwrap();
    let kept = kept_criticism(folder.path()).unwrap().unwrap();
    assert_eq!(
        kept.critique.verdict.message.in_language(Language::German),
        "It sways."
    );
    // One from before curves were kept.
    fs::remove_file(folder.path().join("critique-traces.json")).unwrap();
    assert!(
        kept_criticism(folder.path())
            .unwrap()
            .unwrap()
            .traces
            .is_empty()
    );
    fs::write(folder.path().join("critique.json"), "{").unwrap();
    assert!(matches!(
        kept_criticism(folder.path()),
        Err(Error::Malformed { line: Some(1), .. })
    ));
}

/// Lengths of the append-only files of a folder.
fn lengths(folder: &Path) -> BTreeMap<String, u64> {
    let mut found = BTreeMap::new();
    let journal = folder.join("procedure.journal");
    found.insert(
        "procedure.journal".to_owned(),
        fs::metadata(journal).unwrap().len(),
    );
    for entry in fs::read_dir(folder.join("takes")).unwrap() {
        let entry = entry.unwrap();
        let name = format!("takes/{}", entry.file_name().into_string().unwrap());
        found.insert(name, entry.metadata().unwrap().len());
    }
    found
}

/// A moment of a procedure: what was on the disk, and where it stood.
struct Snapshot {
    lengths: BTreeMap<String, u64>,
    phase: Phase,
    recorded_s: f64,
    takes: usize,
}

fn snapshot(rehearsal: &Rehearsal) -> Snapshot {
    let state = rehearsal.state();
    let lengths = lengths(&rehearsal.folder());
    Snapshot {
        takes: lengths.len() - 1,
        lengths,
        phase: state.phase,
        recorded_s: state
            .recording
            .map_or(0.0, |recording| recording.recorded_s),
    }
}

/// A rehearsal of two short swings, the first of which is repeated, with a snapshot after
/// everything that happens.
fn logged(folder: &Path, seed: u64, rig: &RigFile) -> Vec<Snapshot> {
    let mut task = practice_task(rig);
    for step in &mut task.steps {
        if let Step::Swing(swing) = step {
            swing.duration_s = 25.0;
        }
    }
    let mut rehearsal = Rehearsal::create(folder, rig.clone(), task, seed).unwrap();
    let mut snapshots = vec![snapshot(&rehearsal)];
    let mut repeated = false;
    while rehearsal.state().phase != Phase::Measure {
        match rehearsal.state().phase {
            Phase::Judge if !repeated => {
                repeated = true;
                rehearsal.handle(Event::Repeat).unwrap();
            }
            Phase::Judge => rehearsal.handle(Event::Accept).unwrap(),
            _ => match rehearsal.by_the_book(UTC).unwrap() {
                Some(event) => rehearsal.handle(event).unwrap(),
                None => assert!(rehearsal.advance(0.2).unwrap() > 0.0),
            },
        }
        snapshots.push(snapshot(&rehearsal));
    }
    snapshots
}

/// The files as a kill at so many bytes after a snapshot leaves them.
fn cut(from: &Path, to: &Path, now: &Snapshot, next: &Snapshot, mut bytes: u64) {
    fs::create_dir_all(to.join("takes")).unwrap();
    let mut names: Vec<&String> = next.lengths.keys().collect();
    // A new recording has its line in the journal first; an end is written before its line.
    let is_new = |name: &String| !now.lengths.contains_key(name);
    let journal_first = names.iter().any(|name| is_new(name));
    names.sort_by_key(|name| (name.as_str() == "procedure.journal") != journal_first);
    for name in names {
        let old = now.lengths.get(name).copied().unwrap_or(0);
        let grown = (next.lengths[name] - old).min(bytes);
        bytes -= grown;
        if is_new(name) && grown == 0 {
            continue;
        }
        let whole = fs::read(from.join(name)).unwrap();
        fs::write(to.join(name), &whole[..(old + grown) as usize]).unwrap();
    }
}

/// The app killed at 1000 random bytes of all that it ever wrote: it goes on where it was, and no
/// recording lacks more than its last second.
#[test]
fn a_killed_app_goes_on_and_loses_at_most_a_second() {
    let (seed, mut rng) = drawn_from("killed");
    let rig = drawn(&mut rng);
    let folder = tempfile::tempdir().unwrap();
    let snapshots = logged(folder.path(), seed, &rig);
    let grown = |pair: &[Snapshot]| {
        pair[1].lengths.values().sum::<u64>() - pair[0].lengths.values().sum::<u64>()
    };
    let total: u64 = snapshots.windows(2).map(grown).sum();
    let work = tempfile::tempdir().unwrap();
    for round in 0..1000 {
        // Every fifth cut is into the journal's lines, which are few bytes beside the samples.
        let pairs: Vec<&[Snapshot]> = snapshots
            .windows(2)
            .filter(|pair| grown(pair) > 0)
            .collect();
        let (pair, bytes) = if round % 5 == 0 {
            let of_journal: Vec<&&[Snapshot]> = pairs
                .iter()
                .filter(|pair| {
                    pair[0].lengths["procedure.journal"] < pair[1].lengths["procedure.journal"]
                })
                .collect();
            let pair = *of_journal[rng.random_range(0..of_journal.len())];
            (pair, rng.random_range(0..grown(pair)))
        } else {
            let mut place = rng.random_range(0..total);
            let at = pairs.iter().position(|pair| {
                let inside = place < grown(pair);
                place -= if inside { 0 } else { grown(pair) };
                inside
            });
            (pairs[at.unwrap()], place)
        };
        let here = work.path().join("procedure");
        let _ = fs::remove_dir_all(&here);
        cut(folder.path(), &here, &pair[0], &pair[1], bytes);
        let mut procedure =
            Procedure::open(&here).unwrap_or_else(|error| panic!("round {round}: {error}"));
        let state = procedure.state();
        let goes_on = |snapshot: &Snapshot| match snapshot.phase {
            Phase::Record => Phase::Interrupted,
            other => other,
        };
        // A judgement whose line was cut off is asked for again; a rest or a level is taken again.
        let possible = [goes_on(&pair[0]), goes_on(&pair[1])];
        assert!(
            possible.contains(&state.phase),
            "round {round}: {:?} of {possible:?}",
            state.phase
        );
        if state.phase == Phase::Interrupted && pair[0].phase == Phase::Record {
            let recorded_s = state.recording.as_ref().unwrap().recorded_s;
            assert!(
                recorded_s > pair[0].recorded_s - 1.0,
                "{recorded_s} of {}",
                pair[0].recorded_s
            );
        }
        assert!(lengths(&here).len() > pair[0].takes);
        if round % 40 == 0 && state.actions.contains(&Action::Keep) {
            procedure.handle(Event::Keep).unwrap();
            assert_eq!(procedure.state().phase, Phase::Judge);
        } else if round % 40 == 1 && state.actions.contains(&Action::Continue) {
            procedure.handle(Event::Continue).unwrap();
            assert_eq!(procedure.state().phase, Phase::Record);
            drop(procedure);
            let again = Procedure::open(&here).unwrap().state();
            assert_eq!(again.phase, Phase::Interrupted);
            assert!(again.recording.unwrap().recorded_s > pair[0].recorded_s - 1.0);
        }
    }
}

/// The journal alone cut short, as a damaged disk would: every recording is still found and
/// offered.
#[test]
fn recordings_whose_lines_are_lost_are_found_again() {
    let (seed, mut rng) = drawn_from("lost lines");
    let rig = drawn(&mut rng);
    let folder = tempfile::tempdir().unwrap();
    logged(folder.path(), seed, &rig);
    let journal = fs::read(folder.path().join("procedure.journal")).unwrap();
    let takes = fs::read_dir(folder.path().join("takes")).unwrap().count();
    let first = journal.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    for _ in 0..12 {
        let at = rng.random_range(first..journal.len());
        fs::write(folder.path().join("procedure.journal"), &journal[..at]).unwrap();
        let mut rehearsal = Rehearsal::open(folder.path(), rig.clone(), seed).unwrap();
        let mut seen = 0;
        while !matches!(rehearsal.state().phase, Phase::Measure) {
            let state = rehearsal.state();
            seen += usize::from(state.phase == Phase::Interrupted);
            match state.phase {
                Phase::Interrupted => rehearsal.handle(Event::Keep).unwrap(),
                Phase::Judge => rehearsal.handle(Event::Accept).unwrap(),
                Phase::Start | Phase::Hang => {
                    rehearsal
                        .handle(rehearsal.by_the_book(UTC).unwrap().unwrap())
                        .unwrap();
                }
                Phase::Rest => rehearsal.handle(Event::Skip).unwrap(),
                Phase::Level => match rehearsal.by_the_book(UTC).unwrap() {
                    Some(event) => rehearsal.handle(event).unwrap(),
                    None => assert!(rehearsal.advance(1.0).unwrap() > 0.0),
                },
                Phase::Ready => rehearsal.handle(Event::Skip).unwrap(),
                other => panic!("{other:?}"),
            }
        }
        assert!(seen <= takes);
        assert_eq!(
            fs::read_dir(folder.path().join("takes")).unwrap().count(),
            takes
        );
    }
    for at in [0, 1, first / 2, first - 1] {
        fs::write(folder.path().join("procedure.journal"), &journal[..at]).unwrap();
        let Err(Error::Malformed { line: Some(1), .. }) = Procedure::open(folder.path()) else {
            panic!("{at}")
        };
    }
    // Nothing was begun: it may be begun anew, and again nothing is written over.
    let begun = Procedure::create(folder.path(), practice_task(&rig)).unwrap();
    assert_eq!(begun.state().phase, Phase::Start);
    let again = Procedure::create(folder.path(), practice_task(&rig));
    assert!(matches!(again, Err(Error::Unwritable { .. })));
}

fn begun(folder: &Path) -> Procedure {
    let rig = read_rig(SHIPPED, "rig.toml").unwrap();
    let mut procedure = Procedure::create(folder, practice_task(&rig)).unwrap();
    let phone = PhoneInfo {
        model: "test".into(),
        sensors: vec![],
    };
    let (at_utc, placement) = (UTC.into(), Placement::FlatTopToBow);
    let begin = Event::Begin {
        at_utc,
        measured_on: None,
        phone,
        placement,
    };
    procedure.handle(begin).unwrap();
    procedure
}

/// Both sensors from a time on: a gyroscope of bias 0.01, -0.02, 0.005 rad/s about whose z the hull
/// turns with an amplitude, rad.
fn listen(
    procedure: &mut Procedure,
    (from_s, to_s): (f64, f64),
    amplitude_rad: f64,
    rng: &mut impl Rng,
) {
    let omega = TAU / 4.0;
    let mut noise = |sigma: f64| -> f64 {
        sigma * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng)
    };
    for (channel, rate_hz) in [(Channel::Gyroscope, 101.3), (Channel::Accelerometer, 52.7)] {
        let (mut stamps_ns, mut values) = (Vec::new(), Vec::new());
        for i in 0..((to_s - from_s) * rate_hz) as i64 {
            let t = from_s + i as f64 / rate_hz;
            stamps_ns.push((t * 1e9) as i64);
            values.push(match channel {
                Channel::Gyroscope => {
                    let turn = amplitude_rad * omega * (omega * t).cos();
                    [
                        0.01 + noise(1e-3),
                        -0.02 + noise(1e-3),
                        0.005 + turn + noise(1e-3),
                    ]
                }
                _ => [noise(0.02), noise(0.02), 9.81 + noise(0.02)],
            });
        }
        procedure
            .handle(Event::Samples(Batch {
                channel,
                stamps_ns,
                values,
            }))
            .unwrap();
    }
}

#[test]
fn a_rest_is_refused_while_the_hull_moves_and_tells_the_sensors_when_it_does_not() {
    let mut rng = fresh("rest");
    let folder = tempfile::tempdir().unwrap();
    let mut procedure = begun(folder.path());
    listen(&mut procedure, (0.0, 3.0), 0.0, &mut rng);
    let tilt = procedure.state().tilt.unwrap();
    // Means of 100 samples of 0.02 m/s² lie within 0.1 degrees.
    assert!(
        tilt.bow_up_deg.unwrap().abs() < 0.1 && tilt.starboard_down_deg.unwrap().abs() < 0.1,
        "{tilt:?}"
    );
    procedure.handle(Event::Accept).unwrap();
    // A turn of half a degree in 4 s: its rate goes to 0.79 degrees per second; a mean over half a
    // second takes 3 % off.
    listen(&mut procedure, (3.0, 30.0), 0.5_f64.to_radians(), &mut rng);
    let rest = procedure.state().rest.unwrap();
    let moving = rest.moving.unwrap();
    assert!((0.6..0.9).contains(&moving.rate_deg_s), "{moving:?}");
    assert!(rest.found.is_none() && !procedure.state().actions.contains(&Action::Accept));
    let refused = procedure.handle(Event::Accept).unwrap_err().to_string();
    assert!(refused.contains("one of: repeat, skip"), "{refused}");
    listen(&mut procedure, (30.0, 47.0), 0.0, &mut rng);
    let found = procedure.state().rest.unwrap().found.unwrap();
    assert!(found.still_s >= 15.0);
    let accelerometer = found.accelerometer.unwrap();
    for (rate_hz, true_hz) in [
        (found.gyroscope.rate_hz, 101.3),
        (accelerometer.rate_hz, 52.7),
    ] {
        assert!((rate_hz / true_hz - 1.0).abs() < 1e-6, "{rate_hz}");
    }
    // Means of 1500 samples of 1e-3 rad/s: five standard deviations are 1.3e-4.
    for (mean, bias) in found.gyroscope.mean.iter().zip([0.01, -0.02, 0.005]) {
        assert!((mean - bias).abs() < 1.3e-4, "{mean}");
    }
    // A standard deviation of as many is known to 2.3 % (neighbours' differences): five of those.
    assert!(
        found
            .gyroscope
            .noise
            .iter()
            .all(|noise| (noise / 1e-3 - 1.0).abs() < 0.12),
        "{found:?}"
    );
    assert!((found.gravity_m_s2.unwrap() - 9.81).abs() < 0.005);
    procedure.handle(Event::Accept).unwrap();
    assert_eq!(
        Procedure::open(folder.path()).unwrap().state().phase,
        Phase::Hang
    );
}

#[test]
fn a_full_disk_and_a_stopped_sensor_are_told_and_what_was_recorded_can_be_kept() {
    let mut rng = fresh("full disk");
    let folder = tempfile::tempdir().unwrap();
    let mut procedure = begun(folder.path());
    listen(&mut procedure, (0.0, 3.0), 0.0, &mut rng);
    for event in [
        Event::Accept,
        Event::Skip,
        Event::Measured(Measured::default()),
    ] {
        procedure.handle(event).unwrap();
    }
    procedure
        .handle(Event::StartRecording { at_utc: UTC.into() })
        .unwrap();
    listen(&mut procedure, (3.0, 6.0), 0.0, &mut rng);
    listen(&mut procedure, (6.0, 40.0), 0.1, &mut rng);
    let seen = procedure.state().recording.unwrap();
    // No rest was taken: the first tenth of a second stands for it, 0.1 rad are 5.73 degrees.
    assert!((seen.released_deg.unwrap() - 5.73).abs() < 0.2, "{seen:?}");
    assert!(
        (seen.left_s.unwrap() - (120.0 - 34.0)).abs() < 1.0,
        "{seen:?}"
    );
    procedure
        .handle(Event::SensorStopped {
            sensor: Sensor::Gyroscope,
            stamp_ns: 40_000_000_000,
        })
        .unwrap();
    // Told by somebody who never heard a sample.
    procedure
        .handle(Event::SensorStopped {
            sensor: Sensor::Accelerometer,
            stamp_ns: 0,
        })
        .unwrap();
    procedure.handle(Event::DiskFull).unwrap();
    let state = procedure.state();
    assert_eq!(state.phase, Phase::Interrupted);
    let keys: Vec<&str> = state
        .warnings
        .iter()
        .map(|text| text.key.as_str())
        .collect();
    assert!(
        keys.contains(&"warn_disk") && keys.contains(&"warn_sensor_stopped"),
        "{keys:?}"
    );
    procedure.handle(Event::Keep).unwrap();
    let judgement = procedure.state().judgement.unwrap();
    assert_eq!(judgement.recommend, Recommend::Repeat);
    let silent = judgement
        .reasons
        .iter()
        .filter(|reason| reason.key == "reason_silent")
        .count();
    assert_eq!(silent, 2, "{judgement:?}");
    let takes = fs::read_dir(folder.path().join("takes"))
        .unwrap()
        .flatten()
        .next()
        .unwrap()
        .path();
    let mut reader = Reader::open(&takes).unwrap();
    let mut marks = Vec::new();
    while let Some(piece) = reader.next_piece().unwrap() {
        if let Piece::Event(mark) = piece {
            marks.push((mark.key, mark.stamp_ns / 1_000_000_000));
        }
    }
    for sensor in ["gyroscope", "accelerometer"] {
        let at_s = marks
            .iter()
            .find(|mark| mark.0 == format!("sensor stopped {sensor}"))
            .unwrap()
            .1;
        assert!((39..=40).contains(&at_s), "{marks:?}");
    }
    // 36.98 s were given, of which at most half a second of samples waited.
    assert!(judgement.recorded_s > 36.4, "{}", judgement.recorded_s);
    procedure.handle(Event::Repeat).unwrap();
    assert_eq!(procedure.state().phase, Phase::Ready);
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -20.0..20.0,
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(0.0), Just(1e300), Just(-1e-300)],
    ]
}

fn any_stamp() -> impl Strategy<Value = i64> {
    prop_oneof![4 => 0_i64..200_000_000_000, 1 => any::<i64>()]
}

fn any_batch() -> impl Strategy<Value = Event> {
    let channel = prop_oneof![
        Just(Channel::Gyroscope),
        Just(Channel::Accelerometer),
        Just(Channel::GyroscopeBias)
    ];
    let value = [any_number(), any_number(), any_number()];
    (
        channel,
        prop::collection::vec(any_stamp(), 0..40),
        prop::collection::vec(value, 40),
        0..20,
    )
        .prop_map(|(channel, stamps_ns, values, odd)| {
            let count = stamps_ns.len().saturating_sub(usize::from(odd == 0));
            Event::Samples(Batch {
                channel,
                stamps_ns,
                values: values[..count].to_vec(),
            })
        })
}

fn any_event() -> impl Strategy<Value = Event> {
    let quantity =
        || (any_number(), any_number()).prop_map(|(value, u)| Some(Quantity::new(value, u)));
    let measured =
        (quantity(), quantity(), quantity()).prop_map(|(line_length_m, spacing_m, mass_kg)| {
            Event::Measured(Measured {
                line_length_m,
                spacing_m,
                mass_kg,
                ..Measured::default()
            })
        });
    let sensor = prop_oneof![
        Just(Sensor::Gyroscope),
        Just(Sensor::Accelerometer),
        Just(Sensor::Timer)
    ];
    let phone = |scale| PhoneInfo {
        model: "any".into(),
        sensors: vec![gyradius_procedure::PhoneSensor {
            channel: Channel::Gyroscope,
            name: "any".into(),
            full_scale: Some(scale),
        }],
    };
    let begin = any_number().prop_map(move |scale| Event::Begin {
        at_utc: String::new(),
        measured_on: None,
        phone: phone(scale),
        placement: Placement::AnyWay,
    });
    prop_oneof![
        2 => begin,
        1 => Just(Event::SetReference),
        3 => Just(Event::Accept),
        1 => Just(Event::Repeat),
        1 => Just(Event::Skip),
        1 => measured,
        2 => Just(Event::Measured(Measured::default())),
        3 => Just(Event::StartRecording { at_utc: UTC.into() }),
        1 => Just(Event::StopRecording),
        1 => Just(Event::Continue),
        1 => Just(Event::Keep),
        1 => (0..4_usize).prop_map(|step| Event::Reopen { step }),
        1 => Just(Event::Retry),
        6 => any_batch(),
        1 => (sensor, any_stamp()).prop_map(|(sensor, stamp_ns)| Event::SensorStopped { sensor, stamp_ns }),
        1 => any_stamp().prop_map(|stamp_ns| Event::SlipSeen { stamp_ns }),
        1 => Just(Event::DiskFull),
        1 => any_stamp().prop_map(|stamp_ns| Event::Tick { stamp_ns }),
    ]
}

proptest! {
    #![proptest_config(cases(48))]

    /// Any event at any time is a new state or a clear error that changes nothing, and the journal
    /// says the same.
    #[test]
    fn no_event_breaks_it(events in prop::collection::vec(any_event(), 1..60)) {
        let folder = tempfile::tempdir().unwrap();
        let rig = read_rig(SHIPPED, "rig.toml").unwrap();
        let mut procedure = Procedure::create(folder.path(), practice_task(&rig)).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        for (place, event) in events.into_iter().enumerate() {
            // Now and then gravity is heard, without which nothing begins.
            if place % 8 == 0 && procedure.state().phase == Phase::Level {
                listen(&mut procedure, (0.0, 3.0), 0.0, &mut rng);
            }
            let before = procedure.state();
            let offered = before.actions.clone();
            match procedure.handle(event.clone()) {
                Ok(()) => {}
                Err(error) => {
                    prop_assert!(error.to_string().len() > 10);
                    prop_assert_eq!(procedure.state().phase, before.phase, "{:?} {}", event, error);
                }
            }
            english(&procedure.state());
            if matches!(event, Event::StartRecording { .. }) && !offered.contains(&Action::StartRecording) {
                prop_assert!(procedure.state().phase == before.phase);
            }
        }
        let phase = match procedure.state().phase {
            Phase::Record => Phase::Interrupted,
            other => other,
        };
        drop(procedure);
        prop_assert_eq!(Procedure::open(folder.path()).unwrap().state().phase, phase);
    }
}

/// Events and journals are kept as JSON: a figure must come back as it went in, not next to it.
#[test]
fn figures_read_back_from_json_to_the_same_bits() {
    let event = r#"{"event": "measured", "spacing_m": {"value": 1.8011788166229135, "u": 0.001}}"#;
    let Event::Measured(measured) = serde_json::from_str(event).unwrap() else {
        panic!()
    };
    // Rust rounds the literal correctly (IEEE 754).
    assert_eq!(
        measured.spacing_m.unwrap().value.to_bits(),
        1.8011788166229135_f64.to_bits()
    );
}
