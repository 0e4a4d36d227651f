//! Rig files: what they become, that they are reproducible, blind, and never a panic.
#![allow(clippy::unwrap_used)]

use gyradius_base::frames::Vec3;
use gyradius_mechanics::Draws;
use gyradius_recording::{Overwrite, load_session, read_session, write_session};
use gyradius_simulator::{RigFile, practise, read_rig, save_practised};
use gyradius_test_support::cases;
use gyradius_test_support::seed;
use proptest::prelude::*;

const SHIPPED: &str = include_str!("../../../../../python/gyradius/rigs/keelboat.toml");

fn rig(text: &str) -> RigFile {
    read_rig(text, "rig.toml").unwrap()
}

/// The shipped rig, short.
fn short() -> RigFile {
    rig(&SHIPPED.replace("[truth]\n", "[truth]\nduration_s = 8.0\nrate_hz = 50.0\n"))
}

#[test]
fn the_session_is_what_is_stated_and_gives_nothing_away() {
    let practised = practise(&short(), 7).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (session, truth) = (
        folder.path().join("session"),
        folder.path().join("truth.json"),
    );
    save_practised(&practised, &session, &truth, Overwrite::Refuse).unwrap();
    let loaded = load_session(&session).unwrap();
    assert_eq!(loaded.session, practised.session);
    let mut names: Vec<_> = std::fs::read_dir(&session)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["session.toml", "surge-pitch.csv", "yaw-sway.csv"]);
    let text = std::fs::read_to_string(session.join("session.toml")).unwrap();
    for told in [
        "truth",
        "effect",
        "k_yaw",
        "1.0566",
        "3.4785",
        "seed",
        "clock_scale",
    ] {
        assert!(!text.contains(told), "{told} in {text}");
        assert!(
            std::fs::read_to_string(&truth).unwrap().contains(told) || told == "effect",
            "{told}"
        );
    }
    // Neither file is written over, and the truth never goes into the session.
    let again = save_practised(
        &practised,
        folder.path().join("other"),
        &truth,
        Overwrite::Refuse,
    );
    assert!(again.unwrap_err().to_string().contains("exists already"));
    let inside = save_practised(
        &practised,
        &session,
        session.join("truth.json"),
        Overwrite::Replace,
    );
    assert!(
        inside
            .unwrap_err()
            .to_string()
            .contains("give the truth away")
    );
}

#[test]
fn a_truth_that_cannot_be_written_leaves_the_session_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let (session, truth) = (folder.path().join("session"), folder.path().join("truth"));
    let saved = |seed, truth: &std::path::Path| {
        save_practised(
            &practise(&short(), seed).unwrap(),
            &session,
            truth,
            Overwrite::Replace,
        )
    };
    saved(1, &truth).unwrap();
    let before = std::fs::read(session.join("yaw-sway.csv")).unwrap();
    // A file stands where the truth's folder would have to be.
    let refused = saved(2, &truth.join("truth.json")).unwrap_err();
    assert!(refused.to_string().contains("truth.json"), "{refused}");
    assert_eq!(std::fs::read(session.join("yaw-sway.csv")).unwrap(), before);
    assert_eq!(std::fs::read_dir(&session).unwrap().count(), 3);
}

#[test]
fn the_seed_decides_all_chance_and_nothing_else() {
    let (one, again, other) = (
        practise(&short(), 1).unwrap(),
        practise(&short(), 1).unwrap(),
        practise(&short(), 2).unwrap(),
    );
    assert_eq!(one, again);
    assert_eq!(one.session, other.session);
    assert!(
        one.recordings
            .iter()
            .zip(&other.recordings)
            .all(|(a, b)| a.0 == b.0 && a.1 != b.1)
    );
    // Draws of one swing are not those of another, nor those of one effect those of the next.
    let rig = short();
    let (first, second) = (
        rig.swings[0].draws(Some(1), 50).unwrap(),
        rig.swings[1].draws(Some(1), 50).unwrap(),
    );
    assert_ne!(first[2], second[2]);
    assert_ne!(first[1], first[2][..first[1].len()]);
    assert!(rig.swings[0].draws(None, 50).unwrap().is_empty());
}

#[test]
fn the_draws_are_standard_normal() {
    let draws = rig(SHIPPED).swings[0]
        .draws(Some(seed("noise")), 20_000)
        .unwrap();
    let noise = &draws[2];
    let n = noise.len() as f64;
    assert_eq!(noise.len(), 120_000);
    let mean = noise.iter().sum::<f64>() / n;
    let variance = noise.iter().map(|z| z * z).sum::<f64>() / n;
    // Each bound at four standard deviations of its figure: 6e-5 of correct programs miss one.
    assert!(mean.abs() < 4.0 / n.sqrt(), "{mean}");
    assert!(
        (variance - 1.0).abs() < 4.0 * (2.0 / n).sqrt(),
        "{variance}"
    );
}

#[test]
fn a_pitched_hull_hangs_with_its_centre_straight_below() {
    let level = rig(SHIPPED);
    let pitched = rig(&SHIPPED.replace(
        "line_length_m = 3.4785\n",
        "line_length_m = 3.4785\nhull_pitch_deg = 20.0\n",
    ));
    let (level, pitched) = (&level.swings[1].experiment, &pitched.swings[1].experiment);
    let body = &pitched.scene.body;
    let phi = 20f64.to_radians();
    assert!((body.cm_z_m + 0.402 / phi.cos()).abs() < 1e-12 && body.cm_x_m.abs() < 1e-12);
    // Inertia about the vertical through a hull pitched by φ, eq. (25): k_z² cos² φ + k_x² sin² φ.
    let k2 = 1.0566f64.powi(2) * phi.cos().powi(2) + 0.625f64.powi(2) * phi.sin().powi(2);
    assert!((body.inertia_zz_kg_m2 / 622.5 - k2).abs() < 1e-12);
    // The phone is as far from the centre of mass as before.
    let arm = |e: &gyradius_mechanics::Experiment| {
        let (p, b) = (&e.phone, &e.scene.body);
        Vec3::new(
            p.position_x_m - b.cm_x_m,
            p.position_y_m - b.cm_y_m,
            p.position_z_m - b.cm_z_m,
        )
        .norm()
    };
    assert!((arm(level) - arm(pitched)).abs() < 1e-12);
    // Held still, bow up by 20°, the phone feels the vertical lean towards the bow.
    let mut still = pitched.clone();
    (still.held_s, still.sensors) = (5.0, Vec::new());
    (
        still.scene.start.turn_rad,
        still.scene.start.across_m,
        still.phone.turn_z_rad,
    ) = (0.0, 0.0, 0.0);
    let reading = still.record(&[1.0], &Draws::new()).unwrap().readings[0].force;
    assert!((reading.x - 9.8065 * phi.sin()).abs() < 1e-9, "{reading}");
    assert!(
        (reading.z - 9.8065 * phi.cos() - 0.03).abs() < 1e-9,
        "{reading}"
    );
}

#[test]
fn attachments_are_part_of_what_swings() {
    let mast = "[[attachment]]\nmass = 20.0\nposition = [1.0, 0.0, 0.5]\ngyradii = [0.1, 0.2, 0.3]\n[[swing]]";
    let with = rig(&SHIPPED.replacen("[[swing]]", mast, 1));
    let body = &with.swings[0].experiment.scene.body;
    assert!((body.mass_kg - 622.5).abs() < 1e-9);
    // The centre of everything hangs below; of the hull it lies at −20 · 1.0 / 602.5.
    assert!(body.cm_x_m.abs() < 1e-12);
    let (hull, x) = (602.5, -20.0 / 602.5f64);
    assert!((body.cm_z_m - (20.0 * 0.5 - hull * 0.402) / 622.5).abs() < 1e-12);
    let zz = hull * (1.0566f64.powi(2) + x * x) + 20.0 * (0.09 + 1.0);
    assert!(
        (body.inertia_zz_kg_m2 - zz).abs() < 1e-9,
        "{}",
        body.inertia_zz_kg_m2
    );
}

#[test]
fn the_shipped_rig_reads_and_its_session_reads_back() {
    let rig = rig(SHIPPED);
    let text = write_session(&rig.session);
    assert_eq!(read_session(&text, "session.toml").unwrap(), rig.session);
    assert_eq!(rig.swings.len(), 2);
    assert_eq!(
        rig.swings[1].experiment.sensors.len(),
        rig.swings[0].experiment.sensors.len() + 1
    );
}

proptest! {
    #![proptest_config(cases(256))]

    /// Any text is refused or read, never a panic: the shipped rig with pieces of it cut out,
    /// doubled or replaced.
    #[test]
    fn any_rig_is_read_or_refused(
        cuts in proptest::collection::vec((0usize..3000, 0usize..60, 0usize..3000, "[ -~\\n]{0,12}"), 1..4),
    ) {
        let mut text = SHIPPED.to_owned();
        for (at, length, from, new) in cuts {
            let place = |i: usize, text: &str| (0..=i.min(text.len())).rev().find(|i| text.is_char_boundary(*i));
            let (at, from) = (place(at, &text).unwrap(), place(from, &text).unwrap());
            let end = place(at + length, &text).unwrap().max(at);
            let copied = text[from..place(from + length, &text).unwrap().max(from)].to_owned();
            let put = if length % 2 == 0 { new } else { copied };
            text.replace_range(at..end, &put);
        }
        if let Ok(rig) = read_rig(&text, "rig.toml") {
            prop_assert_eq!(read_session(&write_session(&rig.session), "session.toml").unwrap(), rig.session);
        }
    }

    /// Any number under any key of the truth is refused or makes a motion or an error.
    #[test]
    fn any_truth_is_simulated_or_refused(key in 0usize..60, value in prop_oneof![-10.0..10.0, Just(0.0), Just(1e-9), Just(1e12)]) {
        let rig = short();
        let mut experiment = rig.swings[0].experiment.clone();
        let mut values = experiment.values();
        let place = key % values.len();
        values[place] = value;
        experiment = experiment.with_values(&values).unwrap();
        if let Ok(record) = experiment.record(&[0.0, 1.0, 5.0], &Draws::new()) {
            prop_assert!(record.readings.len() <= 3);
        }
    }
}
