//! The criticism of swings that a gyroscope alone saw.
//!
//! Synthetic swings are drawn afresh and integrated here, by the rule of Runge and Kutta, not by
//! the code under test.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::told::told_in_every_language;
use gyradius_diagnosis::{
    CauseId, Critique, DiscrepancyKind, ModelResult, ParameterName, Status, criticise,
};
use gyradius_recording::import::{ColumnMapping, ImportOptions, ImportedData, import_files};
use gyradius_recording::{
    Excitation, LoadedData, LoadedSession, LoadedSwing, Orientation, Quantity, Recording, Session,
    Suspension, SuspensionKind, Swing, SwingData, Triad,
};
use gyradius_test_support::rng;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// What brakes a drawn pendulum, as shares of critical damping at its fastest rate, and what bends its
/// law.
#[derive(Debug, Clone, Copy)]
struct Brakes {
    linear: f64,
    quadratic: f64,
    dry: f64,
    /// Shares of the restoring force that grow with the third power of the angle, and with its
    /// square, at one radian.
    cubic: f64,
    one_sided: f64,
}

/// θ'' = −ω² (sin θ + c θ³ + s θ²) − 2 ω (l + q |v|/V + d V/|v|) v at even times; the rate at each,
/// rad/s.
fn rates(omega: f64, reach_rad: f64, brakes: Brakes, step_s: f64, count: usize) -> Vec<f64> {
    let fastest = omega * reach_rad;
    let slope = |[x, v]: [f64; 2]| {
        // Coulomb's jump spread over a ten-thousandth of the fastest rate.
        let brake = brakes.linear * v
            + brakes.quadratic * v.abs() * v / fastest
            + brakes.dry * fastest * (v / (1e-4 * fastest)).tanh();
        let back = x.sin() + brakes.cubic * x.powi(3) + brakes.one_sided * x * x;
        [v, -omega * omega * back - 2.0 * omega * brake]
    };
    let inner = 20;
    let h = step_s / f64::from(inner);
    let moved = |y: [f64; 2], k: [f64; 2], by: f64| [y[0] + by * k[0], y[1] + by * k[1]];
    let mut y = [reach_rad, 0.0];
    let mut found = Vec::with_capacity(count);
    for _ in 0..count {
        found.push(y[1]);
        for _ in 0..inner {
            let a = slope(y);
            let b = slope(moved(y, a, 0.5 * h));
            let c = slope(moved(y, b, 0.5 * h));
            let d = slope(moved(y, c, h));
            y = [0, 1].map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
    }
    found
}

fn between(rng: &mut ChaCha8Rng, least: f64, most: f64) -> f64 {
    least + (most - least) * rng.random::<f64>()
}

/// A phone's gyroscope on a compound pendulum, the phone taped on in any way.
fn drawn(rng: &mut ChaCha8Rng, quadratic: f64, dry: f64) -> LoadedSession {
    let period_s = between(rng, 1.0, 3.0);
    let brakes = Brakes {
        linear: between(rng, 0.0005, 0.0015),
        quadratic,
        dry,
        cubic: 0.0,
        one_sided: 0.0,
    };
    swinging(rng, period_s, brakes)
}

/// The same of a period of small swings.
fn swinging(rng: &mut ChaCha8Rng, period_s: f64, brakes: Brakes) -> LoadedSession {
    let omega = TAU / period_s;
    let count = 12_000;
    let motion = rates(omega, between(rng, 0.2, 0.5), brakes, 0.01, count);
    let mut normal = || -> f64 { rng.sample(StandardNormal) };
    let axis = [normal(), normal(), normal()];
    let size = axis.iter().map(|a| a * a).sum::<f64>().sqrt();
    let axes = axis.map(|a| {
        let bias = 0.005 * normal();
        motion
            .iter()
            .map(|rate| a / size * rate + bias + 0.001 * normal())
            .collect::<Vec<f64>>()
    });
    let t_s = (0..count).map(|i| 0.01 * i as f64).collect();
    let gyroscope = Some(Triad { t_s, axes });
    session(
        Recording {
            name: "drawn".into(),
            gyroscope,
            ..Default::default()
        },
        compound(),
        vec![],
    )
}

fn compound() -> Suspension {
    Suspension {
        axis_height_m: Some(Quantity::new(0.4, 0.01)),
        ..Suspension::unmeasured(SuspensionKind::Compound, Orientation::Athwartships)
    }
}

fn session(
    recording: Recording,
    suspension: Suspension,
    excited: Vec<Excitation>,
) -> LoadedSession {
    let swing = Swing {
        id: "swing".into(),
        data: SwingData::Recording("swing.csv".into()),
        excited,
        added_masses: vec![],
        amplitude_deg: BTreeMap::new(),
        suspension,
    };
    let session = Session {
        title: "one motion".into(),
        swings: vec![swing],
        ..Session::default()
    };
    let data = vec![LoadedSwing {
        id: "swing".into(),
        data: LoadedData::Recording(recording),
    }];
    LoadedSession {
        data,
        session,
        source: "one motion".into(),
        inclines: vec![],
        assumed: vec![],
    }
}

fn criticised(loaded: &LoadedSession) -> Critique {
    let critique = criticise(loaded, &|_, _| true).unwrap().critique;
    println!(
        "{:?}: {}",
        critique.verdict.causes, critique.verdict.message.english
    );
    println!(
        "  {:?} -> {:?}",
        critique.baseline.rms_over_noise, critique.extended.rms_over_noise
    );
    for cause in &critique.causes {
        println!(
            "  {} {:.1} {:?}",
            cause.id, cause.log_evidence_gain, cause.parameters
        );
    }
    critique
        .discrepancies
        .iter()
        .for_each(|d| println!("  {:.1} {}", d.sigma, d.message.english));
    told_in_every_language(&critique);
    critique
}

/// How often of eight drawn sessions exactly these causes are named.
fn named(quadratic: f64, dry: f64, causes: &[CauseId]) -> usize {
    let mut rng = rng();
    let right = |critique: &Critique| {
        let status = if causes.is_empty() {
            Status::Adequate
        } else {
            Status::Explained
        };
        critique.verdict.causes == causes && critique.verdict.status == status
    };
    (0..8)
        .filter(|_| right(&criticised(&drawn(&mut rng, quadratic, dry))))
        .count()
}

// A false alarm is rarer than one in fifty; so is a cause that is missed at strengths that change
// the decay by a tenth and more. What errs so often errs in three of eight less than once in 2000
// runs (binomial).

#[test]
fn a_pendulum_that_swings_as_it_should_is_left_alone() {
    assert!(named(0.0, 0.0, &[]) >= 6);
}

#[test]
fn quadratic_drag_is_named() {
    assert!(named(0.001, 0.0, &[CauseId::QuadraticDrag]) >= 6);
}

#[test]
fn dry_friction_is_named() {
    assert!(named(0.0, 0.0003, &[CauseId::BearingFriction]) >= 6);
}

/// Value and standard uncertainty of the period of small swings, s.
fn small_period_s(model: &ModelResult) -> (f64, f64) {
    let small = &model.quantities["small_period_swing_s"];
    (small.value.scalar().unwrap(), small.u.scalar().unwrap())
}

/// A ship's restoring force that stiffens: T is that of small swings, however wide they are.
#[test]
fn a_restoring_force_that_hardens_is_named() {
    let mut rng = rng();
    let brakes = Brakes {
        linear: 0.001,
        quadratic: 0.0,
        dry: 0.0,
        cubic: 0.5,
        one_sided: 0.0,
    };
    let critique = criticised(&swinging(&mut rng, 2.0, brakes));
    assert_eq!(critique.verdict.causes, [CauseId::RestoringForce]);
    assert_eq!(critique.verdict.status, Status::Explained);
    let (period_s, u_s) = small_period_s(&critique.extended);
    assert!(
        (period_s - 2.0).abs() < 4.0 * u_s && u_s < 1e-4,
        "{period_s} ± {u_s}"
    );
    // By the law that is stated it is far off.
    let (by_base_s, _) = small_period_s(&critique.baseline);
    assert!((by_base_s - 2.0).abs() > 10.0 * u_s, "{by_base_s}");
}

/// A spring that is stiffer on one side is in no catalogue: it is called unexplained and told as a
/// closed form, and the interval of the period allows for it.
#[test]
fn a_force_that_is_in_no_catalogue_is_learned() {
    let mut rng = rng();
    let brakes = Brakes {
        linear: 0.001,
        quadratic: 0.0,
        dry: 0.0,
        cubic: 0.0,
        one_sided: 0.1,
    };
    let critique = criticised(&swinging(&mut rng, 2.0, brakes));
    assert_eq!(critique.verdict.status, Status::Unexplained);
    assert_eq!(critique.verdict.causes, [CauseId::Unknown]);
    let equation = critique.learned.as_ref().unwrap().equation.as_str();
    let mut words = equation.split_whitespace().skip(2);
    let coefficient: f64 = words.next().unwrap().parse().unwrap();
    assert_eq!(words.next(), Some("θθ"), "{equation}");
    // s ω² with ω = π rad/s; the sign is that of the axis.
    let expected = 0.1 * (TAU / 2.0).powi(2);
    assert!(
        (coefficient.abs() / expected - 1.0).abs() < 0.05,
        "{equation}"
    );
    let (period_s, u_s) = small_period_s(&critique.extended);
    assert!((period_s - 2.0).abs() < 3.0 * u_s, "{period_s} ± {u_s}");
}

fn third(all: &[f64]) -> Vec<f64> {
    all.iter().copied().step_by(3).collect()
}

/// Every third sample alone tells the same.
#[test]
fn thinning_changes_no_verdict() {
    let mut rng = rng();
    let full = drawn(&mut rng, 0.001, 0.0);
    let mut thin = full.clone();
    if let LoadedData::Recording(recording) = &mut thin.data[0].data {
        let gyroscope = recording.gyroscope.as_mut().unwrap();
        gyroscope.t_s = third(&gyroscope.t_s);
        gyroscope.axes = gyroscope.axes.each_ref().map(|axis| third(axis));
    }
    let [full, thin] = [full, thin].map(|session| criticised(&session).verdict);
    assert_eq!(full.causes, [CauseId::QuadraticDrag]);
    assert_eq!((full.status, full.causes), (thin.status, thin.causes));
}

/// Strength over the true one of what was drawn: θ'' = … − (2 ω q/V) |θ'| θ'.
#[test]
fn the_strength_of_a_drag_is_found_within_its_uncertainty() {
    let mut rng = rng();
    let critique = criticised(&drawn(&mut rng, 0.001, 0.0));
    let period = critique.extended.quantities["small_period_swing_s"]
        .value
        .scalar()
        .unwrap();
    let found = &critique.causes[0].parameters[&ParameterName::TorqueCoefficientPerInertia.into()];
    // 2 ω q/(ω A) = 2 q/A: between those of the widest and the narrowest release.
    assert!((1.0..3.0).contains(&period));
    assert!(found.value > 0.002 / 0.5 - 5.0 * found.u && found.value < 0.002 / 0.2 + 5.0 * found.u);
}

// ---- real recordings ----

/// A recording from the folder of real data, imported; `None` (said aloud) where that is absent.
fn shared(path: &str, mapping: &[&str]) -> Option<Recording> {
    let full = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../../../shared/data")
        .join(path);
    let Ok(bytes) = std::fs::read(full) else {
        println!("skipped: ../shared/data/{path} is not here");
        return None;
    };
    let mapping = (!mapping.is_empty()).then(|| ColumnMapping::from_entries(mapping).unwrap());
    let options = ImportOptions {
        mapping,
        ..Default::default()
    };
    let mut imported = import_files(&[(path.into(), bytes)], &options).unwrap();
    match imported.recordings.remove(0).data {
        ImportedData::Recording(recording) => Some(recording),
        _ => panic!("{path} is no phone's recording"),
    }
}

/// What its notes say, measured without this program: the small period is near 1.338 s, the period
/// exceeds a pendulum's law above 0.25 rad. No cause that is known accounts for that, and the
/// program must not claim one.
#[test]
fn the_phone_pendulum_is_not_explained_away() {
    let Some(recording) = shared("phone-pendulum/Gyroscope.csv", &[]) else {
        return;
    };
    let critique = criticised(&session(recording, compound(), vec![]));
    assert_eq!(critique.verdict.status, Status::Unexplained);
    let period = critique.baseline.quantities["small_period_swing_s"]
        .value
        .scalar()
        .unwrap();
    assert!((period - 1.338).abs() < 0.005, "{period}");
    assert!(
        critique
            .discrepancies
            .iter()
            .any(|d| d.what == DiscrepancyKind::PeriodVsAmplitude)
    );
    assert!(critique.extended.rms_over_noise < critique.baseline.rms_over_noise);
}

/// Its notes: 2.83 s at 0.75 rad falls to 2.64 s at 0.11 rad, and nobody has said why.
#[test]
fn the_ducted_fan_is_not_explained_away() {
    let mapping = [
        "t=Time:ms",
        "gx=xGyro:deg/s",
        "gy=yGyro:deg/s",
        "gz=ZGyro:deg/s",
    ];
    let Some(recording) = shared("ducted-fan/YawInertiaPendel01.csv", &mapping) else {
        return;
    };
    let lines = Suspension {
        kind: SuspensionKind::Bifilar,
        line_length_m: Some(Quantity::new(0.74, 0.01)),
        spacing_m: Some(Quantity::new(0.16, 0.005)),
        axis_height_m: None,
        ..compound()
    };
    let critique = criticised(&session(recording, lines, vec![Excitation::Yaw]));
    assert_eq!(critique.verdict.status, Status::Unexplained);
    let period = critique.baseline.quantities["small_period_swing_s"]
        .value
        .scalar()
        .unwrap();
    assert!((2.5..2.8).contains(&period), "{period}");
}
