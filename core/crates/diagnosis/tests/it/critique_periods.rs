//! The criticism of sessions that hold periods alone.
//!
//! Synthetic sessions are drawn afresh; their periods are closed forms that are written here.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::told::told_in_every_language;
use gyradius_diagnosis::{
    CauseId, Critique, DiscrepancyKind, ParameterName, Status, criticise_periods,
};
use gyradius_identification::{MeasureOptions, analyse};
use gyradius_recording::import::{ImportOptions, ImportedData, import_files};
use gyradius_recording::{
    Body, LoadedData, LoadedSession, LoadedSwing, ModeName, Orientation, Quantity, Session, Site,
    Suspension, SuspensionKind, Swing, SwingData, load_session,
};
use gyradius_signal::gate_periods;
use gyradius_test_support::rng;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

fn criticised(loaded: &LoadedSession) -> Critique {
    let analysis = analyse(loaded, &MeasureOptions::default()).unwrap();
    let critique = criticise_periods(loaded, &analysis).unwrap().critique;
    told_in_every_language(&critique);
    critique
}

fn show(critique: &Critique) {
    println!(
        "{}: {:?} — {}",
        critique.title, critique.verdict.status, critique.verdict.message.english
    );
    let rms = |m: &gyradius_diagnosis::ModelResult| (m.rms_over_noise, m.heldout_rms_over_noise);
    println!(
        "  rms, held out: {:?} -> {:?}",
        rms(&critique.baseline),
        rms(&critique.extended)
    );
    for model in [&critique.baseline, &critique.extended] {
        println!(
            "  {:?}",
            model.quantities.get("k_yaw_m").map(|k| (&k.value, &k.u))
        );
    }
    for cause in &critique.causes {
        println!(
            "  {} p {:.3} gain {:.1}: {}",
            cause.id, cause.probability, cause.log_evidence_gain, cause.message.english
        );
        println!("    {:?}", cause.parameters);
    }
    for discrepancy in &critique.discrepancies {
        println!("  {}", discrepancy.message.english);
    }
    println!("  {:?}", critique.verdict.next_swing);
}

// ---- drawn sessions ----

/// A hull as it is.
#[derive(Debug, Clone, Copy)]
struct Hull {
    mass_kg: f64,
    k_yaw_m: f64,
    k_pitch_m: f64,
    depth_m: f64,
    gravity_m_s2: f64,
}

/// What the session does not say.
#[derive(Debug, Clone, Copy, Default)]
struct Hidden {
    /// Lines longer than the tape says, m.
    excess_m: f64,
    /// Σ G J of the lines, N m².
    rigidity_n_m2: f64,
    /// Give of the gantry, m/N.
    gives_m_n: f64,
    /// Air that moves along in sway, kg.
    sway_kg: f64,
}

/// Small-amplitude periods on parallel lines of length l, 2d apart.
fn periods(hull: &Hull, hidden: &Hidden, l: f64, d: f64) -> Vec<(ModeName, f64)> {
    let g = hull.gravity_m_s2;
    // Eq. (5), the stiffness g d²/l of each kilogram raised by κ/M, κ = Σ G J/l.
    let stiffness = (g * d * d + hidden.rigidity_n_m2 / hull.mass_kg) / l;
    let yaw = TAU * hull.k_yaw_m / stiffness.sqrt();
    // Eq. (7): a spring in series adds M/k to l/g, air adds mass without weight.
    let heavier = 1.0 + hidden.sway_kg / hull.mass_kg;
    let sway = TAU * (heavier * (l / g + hull.mass_kg * hidden.gives_m_n)).sqrt();
    // The double pendulum's equation of motion: ω⁴ l k² − ω² g (k² + l₂² + l l₂) + g² l₂ = 0.
    let (a, b, c) = (
        l * hull.k_pitch_m.powi(2),
        g * (hull.k_pitch_m.powi(2) + hull.depth_m.powi(2) + l * hull.depth_m),
        g * g * hull.depth_m,
    );
    let root = |sign: f64| TAU / ((b + sign * (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt();
    let pitch = [
        (ModeName::PitchInPhase, root(-1.0)),
        (ModeName::PitchOutOfPhase, root(1.0)),
    ];
    [(ModeName::Yaw, yaw), (ModeName::Sway, sway)]
        .into_iter()
        .chain(pitch)
        .collect()
}

fn between(rng: &mut ChaCha8Rng, least: f64, most: f64) -> f64 {
    least + (most - least) * rng.random::<f64>()
}

fn normal(rng: &mut ChaCha8Rng) -> f64 {
    rng.sample(StandardNormal)
}

fn hull(rng: &mut ChaCha8Rng) -> Hull {
    let k_yaw_m = between(rng, 0.3, 1.5);
    Hull {
        mass_kg: 300.0 * k_yaw_m.powi(3) * between(rng, 0.7, 1.4),
        k_yaw_m,
        k_pitch_m: k_yaw_m * between(rng, 1.02, 1.2),
        depth_m: k_yaw_m * between(rng, 0.3, 0.8),
        gravity_m_s2: 9.81 + 0.0005 * normal(rng),
    }
}

/// A tape's reading, and what was true.
fn taped(rng: &mut ChaCha8Rng, truth_m: f64, u_m: f64) -> (Quantity, f64) {
    (Quantity::new(truth_m + u_m * normal(rng), u_m), truth_m)
}

/// A session of the hull on lines of these lengths, at each of these spacings (all in yaw gyradii),
/// with those modes.
fn drawn(
    rng: &mut ChaCha8Rng,
    hull: &Hull,
    hidden: &Hidden,
    (lengths, spacings): (&[f64], &[f64]),
    wanted: &[ModeName],
) -> LoadedSession {
    let u_m = 5e-4 * hull.k_yaw_m;
    let lengths: Vec<_> = lengths
        .iter()
        .map(|l| taped(rng, l * hull.k_yaw_m, u_m))
        .collect();
    let spacings: Vec<_> = spacings
        .iter()
        .map(|s| taped(rng, s * hull.k_yaw_m, u_m))
        .collect();
    let mut swings = Vec::new();
    for (length, true_length) in &lengths {
        for (spacing, true_spacing) in &spacings {
            let id = format!("swing-{}", swings.len() + 1);
            let all = periods(
                hull,
                hidden,
                true_length + hidden.excess_m,
                0.5 * true_spacing,
            );
            let typed = all
                .into_iter()
                .filter(|(mode, _)| wanted.contains(mode))
                .map(|(mode, period_s)| {
                    let u = 3e-5 * period_s;
                    (mode, Quantity::new(period_s + u * normal(rng), u))
                });
            swings.push(swing(
                &id,
                SwingData::PeriodsS(typed.collect()),
                *length,
                *spacing,
            ));
        }
    }
    typed(session(
        "drawn",
        Some(Quantity::exact(hull.mass_kg)),
        9.81,
        swings,
    ))
}

fn typed(session: Session) -> LoadedSession {
    let data = session.swings.iter().map(|s| LoadedSwing {
        id: s.id.clone(),
        data: LoadedData::Typed,
    });
    LoadedSession {
        data: data.collect(),
        session,
        source: "drawn".into(),
        inclines: vec![],
        assumed: vec![],
    }
}

fn session(title: &str, mass_kg: Option<Quantity>, gravity: f64, swings: Vec<Swing>) -> Session {
    Session {
        title: title.into(),
        body: Body {
            mass_kg,
            ..Body::default()
        },
        site: Site {
            gravity_m_s2: Some(Quantity::new(gravity, 0.0005)),
            ..Site::default()
        },
        swings,
        ..Session::default()
    }
}

fn swing(id: &str, data: SwingData, length: Quantity, spacing: Quantity) -> Swing {
    Swing {
        id: id.into(),
        data,
        excited: vec![],
        added_masses: vec![],
        amplitude_deg: BTreeMap::new(),
        suspension: Suspension {
            line_length_m: Some(length),
            spacing_m: Some(spacing),
            hull_pitch_deg: Some(Quantity::new(0.0, 0.1)),
            ..Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships)
        },
    }
}

const YAW_AND_SWAY: &[ModeName] = &[ModeName::Yaw, ModeName::Sway];
const ALL: &[ModeName] = &[
    ModeName::Yaw,
    ModeName::Sway,
    ModeName::PitchInPhase,
    ModeName::PitchOutOfPhase,
];

/// How often `truth` was named, of those runs in which it was named or left open; it must always be
/// one of the two.
fn named(
    count: usize,
    truth: CauseId,
    draw: impl Fn(&mut ChaCha8Rng) -> LoadedSession,
) -> (usize, Vec<Critique>) {
    let mut rng = rng();
    let all: Vec<Critique> = (0..count).map(|_| criticised(&draw(&mut rng))).collect();
    let mut hits = 0;
    for critique in &all {
        let is_named = critique.verdict.causes.contains(&truth);
        let is_open = critique.verdict.indistinguishable_from.contains(&truth);
        if !is_named {
            show(critique);
        }
        assert!(is_named || is_open, "{:?}", critique.verdict);
        assert!(
            [Status::Explained, Status::Ambiguous].contains(&critique.verdict.status),
            "{:?}",
            critique.verdict
        );
        hits += usize::from(is_named);
    }
    println!("{truth}: named in {hits} of {count}");
    (hits, all)
}

fn parameter(critique: &Critique, cause: CauseId, name: ParameterName) -> Option<(f64, f64)> {
    let found = critique
        .causes
        .iter()
        .find(|c| c.id == cause)?
        .parameters
        .get(&name.into())?;
    Some((found.value, found.u))
}

#[test]
fn complete_sessions_are_adequate() {
    let mut rng = rng();
    let (mut wrong, count) = (0, 30);
    for i in 0..count {
        let hull = hull(&mut rng);
        let rig: (&[f64], &[f64]) = match i % 3 {
            0 => (&[2.0], &[1.8]),
            1 => (&[1.2, 3.0], &[1.8]),
            _ => (&[1.2, 3.0], &[1.4, 2.1]),
        };
        let wanted = if i % 2 == 0 { ALL } else { YAW_AND_SWAY };
        let critique = criticised(&drawn(&mut rng, &hull, &Hidden::default(), rig, wanted));
        if critique.verdict.status != Status::Adequate {
            wrong += 1;
            show(&critique);
        }
    }
    // Evidence of 7 nats by chance comes less than once in e⁷ sessions and cause, and many causes
    // are the same to a session: at 1 % for each session, more than 3 of 30 come once in 4000 runs.
    assert!(wrong <= 3, "{wrong} of {count}");
}

#[test]
fn a_wrong_tape_on_the_lines_is_named() {
    let (hits, all) = named(15, CauseId::StatedLength, |rng| {
        let hull = hull(rng);
        let size = between(rng, 0.02, 0.04) * hull.k_yaw_m;
        let excess_m = if rng.random::<bool>() { size } else { -size };
        let hidden = Hidden {
            excess_m,
            ..Hidden::default()
        };
        drawn(rng, &hull, &hidden, (&[1.2, 3.0], &[1.8]), YAW_AND_SWAY)
    });
    // 40 tapes' uncertainties at the least, and a stretch would have to be 2.5 times as much on the
    // longer lines.
    assert!(hits >= 13, "{hits}");
    let far = all
        .iter()
        .filter_map(|c| c.gain.heldout_rms_ratio)
        .fold(f64::INFINITY, f64::min);
    assert!(far > 3.0, "{far}");
}

#[test]
fn at_one_length_a_wrong_tape_is_ambiguous_and_a_swing_is_proposed() {
    let (_, all) = named(8, CauseId::StatedLength, |rng| {
        let hull = hull(rng);
        let excess_m = 0.04 * hull.k_yaw_m;
        let hidden = Hidden {
            excess_m,
            ..Hidden::default()
        };
        drawn(rng, &hull, &hidden, (&[2.0], &[1.8]), YAW_AND_SWAY)
    });
    for critique in &all {
        assert_eq!(
            critique.verdict.status,
            Status::Ambiguous,
            "{:?}",
            critique.verdict
        );
        let next = critique.verdict.next_swing.as_ref().unwrap();
        assert!(next.sigma > 3.0 && next.line_length_m > 0.0, "{next:?}");
    }
}

#[test]
fn a_gantry_that_gives_is_told_from_long_lines_by_the_yaw() {
    let (hits, all) = named(10, CauseId::SupportCompliance, |rng| {
        let hull = hull(rng);
        let gives_m_n =
            between(rng, 0.02, 0.04) * hull.k_yaw_m / (hull.mass_kg * hull.gravity_m_s2);
        let hidden = Hidden {
            gives_m_n,
            ..Hidden::default()
        };
        drawn(rng, &hull, &hidden, (&[1.2, 3.0], &[1.8]), YAW_AND_SWAY)
    });
    assert!(hits >= 8, "{hits}");
    for critique in &all {
        println!(
            "{:?}",
            parameter(
                critique,
                CauseId::SupportCompliance,
                ParameterName::StiffnessAlongNM
            )
        );
    }
}

#[test]
fn air_that_moves_along_is_told_from_a_gantry_by_the_length() {
    let (hits, _) = named(10, CauseId::AddedMass, |rng| {
        let hull = hull(rng);
        let hidden = Hidden {
            sway_kg: between(rng, 0.02, 0.04) * hull.mass_kg,
            ..Hidden::default()
        };
        drawn(rng, &hull, &hidden, (&[1.2, 3.0], &[1.8]), YAW_AND_SWAY)
    });
    assert!(hits >= 8, "{hits}");
}

#[test]
fn torsion_shows_at_two_spacings_and_is_named_at_three() {
    let draw = |spacings: &'static [f64]| {
        move |rng: &mut ChaCha8Rng| {
            let hull = hull(rng);
            // In those of the yaw's own stiffness at a spacing of one gyradius.
            let own = hull.mass_kg * hull.gravity_m_s2 * (0.5 * hull.k_yaw_m).powi(2);
            let hidden = Hidden {
                rigidity_n_m2: between(rng, 0.05, 0.1) * own,
                ..Hidden::default()
            };
            drawn(rng, &hull, &hidden, (&[1.2, 3.0], spacings), YAW_AND_SWAY)
        }
    };
    named(8, CauseId::LineTorsion, draw(&[1.0, 2.0]));
    let (hits, _) = named(8, CauseId::LineTorsion, draw(&[0.8, 1.3, 2.4]));
    assert!(hits >= 6, "{hits}");
}

#[test]
fn air_that_grows_with_the_amplitude_shows_in_swings_of_several_amplitudes() {
    let (hits, all) = named(6, CauseId::AmplitudeAddedMass, |rng| {
        let hull = hull(rng);
        let share_by_radian = between(rng, 0.2, 0.4);
        let (length, l) = taped(rng, 2.0 * hull.k_yaw_m, 5e-4 * hull.k_yaw_m);
        let (spacing, _) = taped(rng, 1.8 * hull.k_yaw_m, 5e-4 * hull.k_yaw_m);
        let swings: Vec<Swing> = [1.0, 3.0, 6.0]
            .into_iter()
            .map(|degrees: f64| {
                let angle = degrees.to_radians();
                // The pendulum's law, and (7) with the mass that the air adds at this amplitude.
                let finite = 1.0 + angle.powi(2) / 16.0 + 11.0 * angle.powi(4) / 3072.0;
                let heavier = 1.0 + share_by_radian * angle;
                let period_s = TAU * (heavier * l / hull.gravity_m_s2).sqrt() * finite;
                let read = Quantity::new(period_s * (1.0 + 3e-5 * normal(rng)), 3e-5 * period_s);
                let data = SwingData::PeriodsS(BTreeMap::from([(ModeName::Sway, read)]));
                let mut swing = swing(&format!("sway-{degrees}"), data, length, spacing);
                swing.amplitude_deg.insert(ModeName::Sway, degrees);
                swing
            })
            .collect();
        typed(session(
            "drawn",
            Some(Quantity::exact(hull.mass_kg)),
            9.81,
            swings,
        ))
    });
    assert_eq!(hits, 6);
    let sizes: Vec<_> = all
        .iter()
        .filter_map(|c| parameter(c, CauseId::AmplitudeAddedMass, ParameterName::SwayKgM))
        .collect();
    println!("{sizes:?}");
    assert!(
        sizes.len() == 6 && sizes.iter().all(|(value, u)| value / u > 10.0),
        "{sizes:?}"
    );
}

// ---- measured sessions ----

fn shipped(name: &str) -> LoadedSession {
    load_session(format!(
        "{}/../../../python/gyradius/sessions/{name}",
        env!("CARGO_MANIFEST_DIR")
    ))
    .unwrap()
}

#[test]
fn the_papers_keelboat_is_flagged_with_a_ranking() {
    let critique = criticised(&shipped("keelboat"));
    show(&critique);
    // Errata: the sway periods imply 3.591 and 3.625 m, the tape said 3.477 ± 0.006 m.
    assert!([Status::Ambiguous, Status::Unexplained].contains(&critique.verdict.status));
    let tape = critique.discrepancies.iter().find(|d| {
        d.what == DiscrepancyKind::Dimension && d.message.english.contains("line length")
    });
    assert!(
        tape.unwrap().sigma > 10.0 && (tape.unwrap().size + 0.131).abs() < 0.02,
        "{tape:?}"
    );
    // Long lines, a gantry that gives and air that moves along lengthen the sway alike; nothing
    // else does.
    let open: Vec<&CauseId> = critique
        .verdict
        .causes
        .iter()
        .chain(&critique.verdict.indistinguishable_from)
        .collect();
    for cause in [
        CauseId::StatedLength,
        CauseId::LineStretch,
        CauseId::SupportCompliance,
        CauseId::AddedMass,
    ] {
        assert!(open.contains(&&cause), "{open:?}");
    }
    for cause in [
        CauseId::StatedSpacing,
        CauseId::LineTorsion,
        CauseId::ClockScale,
        CauseId::StatedGravity,
        CauseId::OffCentreCm,
    ] {
        assert!(!open.contains(&&cause), "{open:?}");
    }
    // Table 2: 1040 and 1038 mm by the ratio, 1057 and 1060 mm by the yaw period.
    assert!(
        critique
            .verdict
            .message
            .english
            .contains("gyradius hangs on it"),
        "{}",
        critique.verdict.message.english
    );
    assert!(critique.verdict.next_swing.unwrap().sigma > 3.0);
}

#[test]
fn the_papers_model_hull_contradicts_itself_at_one_spacing() {
    let critique = criticised(&shipped("model-hull"));
    show(&critique);
    // Its README: the rows differ by a per cent or so.
    assert_eq!(critique.verdict.status, Status::Unexplained);
    assert_eq!(critique.discrepancies[0].swing, "level-1084mm");
}

/// Nine geometries of one bar, gate events as they were logged; `None` (said aloud) where the
/// folder is absent.
fn bar() -> Option<LoadedSession> {
    let folder =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../../shared/data/light-gate-bar");
    let Ok(files) = std::fs::read_dir(&folder) else {
        println!("skipped: ../shared/data/light-gate-bar is not here");
        return None;
    };
    let mut paths: Vec<PathBuf> = files.map(|f| f.unwrap().path()).collect();
    paths.sort();
    let (mut swings, mut data) = (Vec::new(), Vec::new());
    for path in paths {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let file = (format!("{name}.csv"), std::fs::read(&path).unwrap());
        let imported = import_files(&[file], &ImportOptions::default()).unwrap();
        let ImportedData::GateEvents(events) = &imported.recordings[0].data else {
            unreachable!()
        };
        let list = gate_periods(events, 0.006).unwrap().list(&name);
        let size = |key: &str| -> f64 {
            let from = name.split(&format!("{key}-")).nth(1).unwrap();
            from.split('m').next().unwrap().parse().unwrap()
        };
        let sizes = (
            Quantity::new(size("length"), 5e-4),
            Quantity::new(size("spacing"), 5e-4),
        );
        swings.push(swing(
            &name,
            SwingData::Periods(name.clone()),
            sizes.0,
            sizes.1,
        ));
        data.push(LoadedSwing {
            id: name,
            data: LoadedData::Periods(list),
        });
    }
    let session = session("bar", None, 9.81256, swings);
    Some(LoadedSession {
        session,
        source: "bar".into(),
        data,
        inclines: vec![],
        assumed: vec![],
    })
}

#[test]
fn no_common_cause_accounts_for_the_spread_of_the_bar() {
    let Some(bar) = bar() else { return };
    let critique = criticised(&bar);
    show(&critique);
    assert_eq!(critique.verdict.status, Status::Unexplained);
    assert!(critique.verdict.causes.contains(&CauseId::Unknown));
    assert!(critique.discrepancies.len() >= 6);
}
