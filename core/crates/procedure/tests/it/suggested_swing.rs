//! A criticism's own suggestion, played through the procedure: an operator who always forgets the
//! shackles in the length of the lines, on one rig, where long lines, a gantry that gives and lines
//! that stretch look alike.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;

use gyradius_diagnosis::{CauseId, CauseVerdict, Critique, NextSwing, Status};
use gyradius_planning::{PlannedSwing, Step};
use gyradius_procedure::{Event, Phase, Recommend, Rehearsal, Task, practice_task};
use gyradius_recording::{Excitation, Quantity, load_session};
use gyradius_simulator::{RigFile, read_rig};
use gyradius_test_support::seed;
use rand::{Rng, RngExt};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const SHIPPED: &str = include_str!("../../../../../python/gyradius/rigs/keelboat.toml");
const UTC: &str = "2026-05-04T09:30:00Z";
/// What the operator leaves out of every line's length, m.
const SHACKLES_M: f64 = 0.05;
const TRUTH: CauseId = CauseId::StatedLength;

/// The shipped keelboat with another body, by a phone that is content with 50 samples a second.
fn drawn(rng: &mut impl Rng) -> RigFile {
    let mut text = SHIPPED.replacen("\n[truth]\n", "\n[truth]\nrate_hz = 50.0\n", 1);
    for (key, shipped, low, high) in [
        ("k_yaw_m", "1.0566", 1.0, 1.1),
        ("k_pitch_m", "1.156", 1.1, 1.2),
        ("cm_depth_m", "0.402", 0.35, 0.45),
        ("turn_z_rad", "0.4", -3.0, 3.0),
    ] {
        let line = format!("{key} = {shipped}");
        assert!(text.contains(&line), "{line}");
        text = text.replace(&line, &format!("{key} = {}", rng.random_range(low..high)));
    }
    read_rig(&text, "rig.toml").unwrap()
}

/// One swing of 40 s in yaw and sway.
fn one_swing(rig: &RigFile) -> Task {
    let mut task = practice_task(rig);
    task.steps.truncate(1);
    let Step::Swing(swing) = &mut task.steps[0] else {
        panic!()
    };
    swing.excited = vec![Excitation::Yaw, Excitation::Sway];
    swing.duration_s = 40.0;
    task
}

/// Plays by the book, but for the tape, until one of these phases is reached.
fn play(rehearsal: &mut Rehearsal, until: &[Phase]) {
    for _ in 0..20_000 {
        let state = rehearsal.state();
        if until.contains(&state.phase) {
            return;
        }
        if state.work.is_some() {
            rehearsal.procedure().work(&|_, _| true).unwrap();
            continue;
        }
        match rehearsal.by_the_book(UTC).unwrap() {
            Some(Event::Measured(mut measured)) => {
                let shorter = |read: Quantity| Quantity::new(read.value - SHACKLES_M, read.u);
                measured.line_length_m = measured.line_length_m.map(shorter);
                rehearsal.handle(Event::Measured(measured)).unwrap();
            }
            Some(event) => rehearsal.handle(event).unwrap(),
            None => assert!(rehearsal.advance(1.0).unwrap() > 0.0, "{:?}", state.phase),
        }
    }
    panic!(
        "the procedure does not end: {:?}",
        rehearsal.state().instruction
    );
}

fn verdict(rehearsal: &Rehearsal) -> CauseVerdict {
    let text = std::fs::read_to_string(rehearsal.folder().join("critique.json")).unwrap();
    let critique: Critique = serde_json::from_str(&text).unwrap();
    println!("{}", critique.verdict.message.english);
    critique.verdict
}

/// What may be the cause.
fn candidates(verdict: &CauseVerdict) -> BTreeSet<CauseId> {
    verdict
        .causes
        .iter()
        .chain(&verdict.indistinguishable_from)
        .copied()
        .collect()
}

/// The step is the criticism's swing, figure by figure as its file has them: reading JSON may turn
/// the last bit.
fn assert_as_suggested(step: &PlannedSwing, next: &NextSwing) {
    println!("{}", next.message.english);
    let is = |stated: Option<Quantity>, value: f64| {
        stated.is_some_and(|stated| (stated.value - value).abs() < 1e-12 * value.abs())
    };
    assert!(
        is(step.suspension.line_length_m, next.line_length_m),
        "{step:?}"
    );
    assert!(is(step.suspension.spacing_m, next.spacing_m), "{step:?}");
    assert_eq!(
        (step.amplitude_deg, step.duration_s),
        (next.amplitude_deg, next.duration_s)
    );
    assert_eq!(step.excited, next.excited);
    let is_tilted = next.hull_pitch_deg.abs() > 1.0;
    assert_eq!(
        is(step.suspension.hull_pitch_deg, next.hull_pitch_deg),
        is_tilted,
        "{step:?}"
    );
    // Forward for bow up, aft for bow down.
    let moved = step
        .suspension
        .points_moved_m
        .map(|moved| moved.value.signum());
    assert_eq!(moved, is_tilted.then_some(next.hull_pitch_deg.signum()));
}

/// Plays a hull: what the criticism suggests is made as it says. Whether the criticism was right
/// before and after, and the procedure called the recording good.
fn tells_more(seed: u64) -> bool {
    let rig = drawn(&mut ChaCha8Rng::seed_from_u64(seed));
    let folder = tempfile::tempdir().unwrap();
    let task = one_swing(&rig);
    let mut rehearsal = Rehearsal::create(folder.path().join("p"), rig, task, seed).unwrap();
    play(&mut rehearsal, &[Phase::Suggest, Phase::Done]);
    let before = verdict(&rehearsal);
    if before.status != Status::Ambiguous || !candidates(&before).contains(&TRUTH) {
        println!("{before:?}");
        return false;
    }
    let Some(Step::Swing(step)) = rehearsal.state().suggestion else {
        panic!("{before:?}")
    };
    assert_as_suggested(&step, before.next_swing.as_ref().unwrap());

    rehearsal.handle(Event::Accept).unwrap();
    play(&mut rehearsal, &[Phase::Judge]);
    let judgement = rehearsal.state().judgement.unwrap();
    // The procedure may take a free swing for a touched one, if seldom.
    if judgement.recommend != Recommend::Accept {
        println!("{:?}", judgement.reasons);
        return false;
    }
    play(&mut rehearsal, &[Phase::Critique]);
    let session = load_session(rehearsal.folder().join("session"))
        .unwrap()
        .session;
    let ids: Vec<&str> = session
        .swings
        .iter()
        .map(|swing| swing.id.as_str())
        .collect();
    assert_eq!(ids, ["yaw-sway", step.id.as_str()]);
    let hung = &session.swings[1].suspension;
    assert_eq!(
        hung.points_moved_m.is_some(),
        step.suspension.points_moved_m.is_some()
    );

    rehearsal.procedure().work(&|_, _| true).unwrap();
    let after = verdict(&rehearsal);
    println!("{before:?}\n{after:?}");
    let found = candidates(&after);
    found.contains(&TRUTH)
        && after.status != Status::Unexplained
        && found.len() <= candidates(&before).len()
}

/// What is right of nine hulls in ten is wrong of three in a row less than once in a thousand runs;
/// how often the criticism is right is judged by `make hidden`, how often a swing that nobody
/// touched is called touched in `live.rs`.
#[test]
fn the_swing_that_the_criticism_suggests_is_made_and_tells_more() {
    assert!((0..3).any(|hull| tells_more(seed(&format!("hull {hull}")))));
}
