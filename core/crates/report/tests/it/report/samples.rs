//! Sources made by hand, with numbers near those of the paper's keelboat (Tables 1 and 2) and model
//! hull (Table 3).

#![allow(clippy::expect_used)]

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::str::FromStr;

use gyradius_base::language::Language;
use gyradius_diagnosis::{Criticism, SwingTrace, UnitName};
use gyradius_identification::{
    AmplitudePoint, AmplitudeUnit, BudgetLine, Claim, Measurement, Method, ModeResult,
    QuantityName, QuantityResult, Relation, Route, SwingResult, Value, Verdict,
};
use gyradius_recording::{ModeName, Quantity, Repair, RepairKind, Sensor};
use gyradius_report::{
    BodyFacts, Curve, Peak, RecordingFigureData, ReportSource, RigFigureData, SpectrumFigureData,
    StatedFigure, Trace, thinned,
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// What a file's name stands for.
pub fn named<T: FromStr<Err: std::fmt::Debug>>(name: &str) -> T {
    name.parse().expect("a name of the core")
}

fn quantity(value: f64, u: f64) -> QuantityResult {
    let interval = [value - 1.96 * u, value + 1.96 * u];
    QuantityResult {
        value: value.into(),
        u: u.into(),
        interval_95: Some(interval),
        method: Method::JointEstimate,
    }
}

fn route(method: &str, value: f64, u: f64, equation: &str, from: &[&str]) -> Route {
    let from = from.iter().map(|id| id.to_string()).collect();
    let interval_95 = [value - 1.96 * u, value + 1.96 * u];
    Route {
        method: named(method),
        value,
        u,
        interval_95,
        equation: equation.into(),
        from,
    }
}

fn mode(mode: ModeName, period_s: f64, tau_s: f64, amplitude_rad: f64) -> ModeResult {
    ModeResult {
        mode,
        period_s,
        period_se_s: 2.1e-5 * period_s,
        period_observed_s: period_s * 1.00031,
        decay_time_s: Some(tau_s),
        decay_time_se_s: Some(0.006 * tau_s),
        amplitude: Some(amplitude_rad),
        amplitude_unit: AmplitudeUnit::Radian,
        relative_db: 0.0,
        parasitic: false,
        doubtful: false,
        against_amplitude: windows(period_s, tau_s, amplitude_rad),
        ..bare_mode()
    }
}

/// A mode of which nothing is known.
pub fn bare_mode() -> ModeResult {
    ModeResult {
        mode: ModeName::Other,
        period_s: 1.0,
        period_se_s: 0.0,
        period_observed_s: 1.0,
        decay_time_s: None,
        decay_time_se_s: None,
        amplitude: None,
        amplitude_unit: AmplitudeUnit::None,
        phase_rad: None,
        relative_db: 0.0,
        parasitic: false,
        doubtful: false,
        against_amplitude: vec![],
    }
}

fn windows(period_s: f64, tau_s: f64, amplitude: f64) -> Vec<AmplitudePoint> {
    (0..9)
        .map(|i| {
            let t_s = 6.0 + 12.0 * f64::from(i);
            let here = amplitude * (-t_s / tau_s).exp();
            let scatter = [0.4, -0.7, 0.2, 0.9, -0.3, -1.1, 0.6, 0.1, -0.5][i as usize];
            let se = 1.5e-5 * period_s * amplitude / here;
            AmplitudePoint {
                t_s,
                amplitude: here,
                period_s: period_s * (1.0 + 0.02 * here * here) + se * scatter,
                period_se_s: se,
                decrement: period_s / tau_s * (1.0 + 1.5 * here) + 2e-4 * scatter,
                decrement_se: 2e-4,
            }
        })
        .collect()
}

/// A deterministic stand-in for noise.
fn noise(i: usize) -> f64 {
    (0..4)
        .map(|k| ((i * (7919 + 104 * k) + 31 * k) % 2003) as f64 / 2003.0 - 0.5)
        .sum()
}

fn trace(
    label: &str,
    unit: &str,
    level: f64,
    lines: &[(f64, f64)],
    tau_s: f64,
    sigma: f64,
) -> Trace {
    let t: Vec<f64> = (0..11_800)
        .map(|i| 2.0 + 0.01 * i as f64)
        .filter(|t| !(71.0..74.5).contains(t))
        .collect();
    let swing = |t: f64| {
        lines
            .iter()
            .map(|(period, a)| a * (-t / tau_s).exp() * (TAU * t / period).cos())
            .sum::<f64>()
    };
    let model: Vec<f64> = t.iter().map(|t| level + swing(*t)).collect();
    let left: Vec<f64> = (0..t.len())
        .map(|i| sigma * noise(i) + if i == 5000 { 9.0 * sigma } else { 0.0 })
        .collect();
    let measured: Vec<f64> = model.iter().zip(&left).map(|(m, r)| m + r).collect();
    let near = t.iter().filter(|t| **t < 26.0).count();
    let close = |y: &[f64]| thinned(&t[..near], &y[..near]);
    Trace {
        label: label.into(),
        unit: unit.into(),
        measured: thinned(&t, &measured),
        model: thinned(&t, &model),
        residual: thinned(&t, &left),
        noise: Some(sigma),
        close_up: Some([close(&measured), close(&model)]),
    }
}

fn spectrum(lines: &[(f64, f64, &str)]) -> SpectrumFigureData {
    let f: Vec<f64> = (1..1600).map(|i| 0.0025 * f64::from(i)).collect();
    let floor = |i: usize| 2e-5 * (1.2 + noise(i).abs());
    let height = |f: f64| {
        lines
            .iter()
            .map(|(p, a, _)| a / (1.0 + ((f - 1.0 / p) / 0.004).powi(2)))
            .sum::<f64>()
    };
    SpectrumFigureData {
        label: "turn rate about the phone's z".into(),
        unit: "rad/s".into(),
        amplitude: Curve::of(
            f.iter()
                .enumerate()
                .map(|(i, f)| (*f, height(*f) + floor(i))),
        ),
        residual: Some(Curve::of(
            f.iter().enumerate().map(|(i, f)| (*f, floor(i + 3))),
        )),
        peaks: lines
            .iter()
            .map(|(p, _, name)| Peak {
                freq_hz: 1.0 / p,
                name: name.to_string(),
            })
            .collect(),
    }
}

fn yaw_recording(id: &str) -> RecordingFigureData {
    let lines = [(4.391, 0.2), (3.802, 0.05)];
    RecordingFigureData {
        id: id.into(),
        traces: vec![
            trace(
                "turn rate about the phone's z",
                "rad/s",
                0.0021,
                &lines,
                380.0,
                0.002,
            ),
            trace(
                "acceleration along the phone's x",
                "m/s²",
                9.79,
                &[(3.802, 0.08)],
                420.0,
                0.02,
            ),
        ],
        spectrum: Some(spectrum(&[(4.391, 0.2, "yaw"), (3.802, 0.05, "sway")])),
    }
}

fn claims() -> Vec<Claim> {
    let claim = |name: &str, stated: (f64, f64), implied: (f64, f64), from: &str| {
        let sigma = (implied.0 - stated.0).abs() / stated.1.hypot(implied.1);
        Claim {
            claim: named(name),
            stated: stated.0,
            stated_u: stated.1,
            implied: implied.0,
            implied_u: implied.1,
            sigma,
            from: from.into(),
            flagged: sigma > 3.0,
            message: format!(
                "{} is stated as {:.3} ± {:.3}; the {from} implies {:.3} ± {:.3}.",
                if name.starts_with("k_") {
                    name.to_string()
                } else {
                    name.replace('_', " ")
                },
                stated.0,
                stated.1,
                implied.0,
                implied.1
            )
            .as_str()
            .into(),
            pairs: 1,
            sigma_range: None,
        }
    };
    vec![
        // Errata: sway periods of 3.802 s and 3.820 s against the tape's 3.477 m.
        claim(
            "line_length",
            (3.477, 0.006),
            (3.591, 0.004),
            "sway period of yaw-1",
        ),
        claim(
            "k_yaw_m",
            (1.0569, 0.0021),
            (1.0398, 0.0014),
            "period_ratio against yaw_period",
        ),
        claim(
            "gravity",
            (9.80665, 0.0005),
            (9.81, 0.004),
            "all swings together (line length, sway period of yaw-1)",
        ),
        claim(
            "spacing",
            (1.8, 0.001),
            (1.7991, 0.0016),
            "all swings together (yaw period of yaw-1, line length)",
        ),
    ]
}

/// The keelboat, with a contradiction and all three gyradii.
pub fn keelboat() -> ReportSource {
    let mut swings = vec![SwingResult {
        id: "yaw-1".into(),
        span_s: Some([2.0, 120.0]),
        modes: vec![
            mode(ModeName::Yaw, 4.391, 380.0, 0.14),
            mode(ModeName::Sway, 3.802, 420.0, 0.012),
        ],
        repairs: vec![Repair {
            kind: RepairKind::Stall,
            sensor: Sensor::Gyroscope,
            count: 1,
            first_s: 71.0,
            last_s: 74.5,
            text: "the gyroscope stood still from 71.0 s to 74.5 s: left as a gap".into(),
        }],
        warnings: vec!["yaw depends on amplitude: the small-amplitude limit is used".into()],
        rms_over_noise: Some(1.03),
        ..Default::default()
    }];
    swings[0].modes[1].relative_db = -21.3;
    swings[0].modes[1].parasitic = true;
    swings.push(SwingResult {
        id: "pitch-1".into(),
        modes: vec![
            mode(ModeName::PitchInPhase, 4.118, 300.0, 0.03),
            mode(ModeName::PitchOutOfPhase, 1.902, 90.0, 0.02),
        ],
        rms_over_noise: Some(2.4),
        ..Default::default()
    });
    swings.push(SwingResult {
        id: "table-1".into(),
        modes: vec![ModeResult {
            mode: ModeName::Yaw,
            period_s: 4.395,
            period_se_s: 0.004,
            period_observed_s: 4.397,
            ..bare_mode()
        }],
        ..Default::default()
    });
    let stated = |what: &str, value: Quantity, unit: &str, applies_to: &[&str]| StatedFigure {
        what: what.into(),
        value,
        unit: unit.into(),
        applies_to: applies_to.iter().map(|id| id.to_string()).collect(),
    };
    ReportSource {
        language: Language::English,
        criticism: None,
        measurement: Measurement {
            format: "gyradius-measurement/1".into(),
            title: "Keelboat of the paper".into(),
            swings,
            quantities: quantities(),
            alternatives: BTreeMap::from([(
                QuantityName::KYaw,
                vec![
                    route("yaw_period", 1.0566, 0.0021, "(5), (6)", &["yaw-1"]),
                    route("period_ratio", 1.0398, 0.0014, "(8)", &["yaw-1"]),
                ],
            )]),
            budget: budget(),
            correlations: vec![(QuantityName::KYaw, QuantityName::KPitch, 0.31)],
            consistency: claims(),
            verdicts: verdicts(),
            findings: vec![],
            warnings: vec![
                "line length is stated as 3.477 ± 0.006 m; the sway period of yaw-1 implies 3.591 ± 0.004 m"
                    .into(),
                "the session contradicts itself: all uncertainties are widened by 3.2".into(),
            ],
        },
        body: BodyFacts {
            name: "Yngling".into(),
            mass_kg: Some(Quantity::new(622.7, 0.5)),
            length_overall_m: Some(6.35),
        },
        rig: Some(RigFigureData {
            swing: "yaw-1".into(),
            line_length_m: Quantity::new(3.477, 0.006),
            spacing_m: Quantity::new(1.8, 0.001),
            top_spacing_m: Some(Quantity::new(1.9, 0.001)),
        }),
        recorded_by: vec!["Pixel 9".into(), "phyphox".into()],
        stated: vec![
            stated("line length", Quantity::new(3.477, 0.006), "m", &["yaw-1", "pitch-1"]),
            stated("spacing of the lines", Quantity::new(1.8, 0.001), "m", &[]),
            stated("gravity", Quantity::exact(9.80665), "m/s²", &[]),
        ],
        periods: vec![],
        recordings: vec![yaw_recording("yaw-1")],
        measured_on: None,
        generated_by: "gyradius 0.1.0".into(),
    }
}

fn quantities() -> BTreeMap<QuantityName, QuantityResult> {
    let whole = |value, u| QuantityResult {
        value,
        u,
        interval_95: None,
        method: Method::JointEstimate,
    };
    BTreeMap::from([
        (QuantityName::KYaw, quantity(1.0566, 0.00093)),
        (QuantityName::KPitch, quantity(1.156, 0.0031)),
        (QuantityName::KRoll, quantity(0.625, 0.0042)),
        (QuantityName::CmDepth, quantity(0.923, 0.012)),
        (QuantityName::Psi, quantity(5.55, 1.4)),
        (
            QuantityName::PrincipalGyradii,
            whole(
                Value::Vector([0.618, 1.156, 1.061]),
                Value::Vector([0.0043, 0.0031, 0.0012]),
            ),
        ),
        (
            QuantityName::Inertia,
            whole(
                Value::Matrix([[243.2, 0.0, -42.1], [0.0, 832.1, 0.0], [-42.1, 0.0, 695.2]]),
                Value::Matrix([[3.1, 0.0, 9.4], [0.0, 4.5, 0.0], [9.4, 0.0, 1.3]]),
            ),
        ),
    ])
}

fn budget() -> BTreeMap<QuantityName, Vec<BudgetLine>> {
    let lines = |lines: &[(&str, f64)]| {
        lines
            .iter()
            .map(|(input, u)| BudgetLine {
                input: named(input),
                u_contribution: *u,
            })
            .collect()
    };
    BTreeMap::from([
        (
            QuantityName::KYaw,
            lines(&[
                ("line_length", 0.00074),
                ("spacing", 0.00051),
                ("yaw period of yaw-1", 0.00021),
                ("finite-amplitude correction", 0.00008),
                ("gravity", 0.00003),
            ]),
        ),
        (
            QuantityName::KPitch,
            lines(&[
                (
                    "pitch out of phase period of pitch-1 with a rather long name",
                    0.0024,
                ),
                ("line_length", 0.0018),
                ("spacing", 0.0006),
                ("sway period of yaw-1", 0.0003),
                ("mass of cross beam", 0.0002),
                ("pitch in phase period of pitch-1", 0.00018),
                ("gravity", 0.0001),
                ("hull_pitch", 0.00006),
                ("mass", 0.00003),
                ("finite-amplitude correction", 0.00002),
            ]),
        ),
    ])
}

fn verdicts() -> Vec<Verdict> {
    let verdict = |quantity: &str, limit: f64, probability: f64, verdict: &str| Verdict {
        quantity: named(quantity),
        relation: Relation::AtLeast,
        limit,
        guard_band: 0.0051,
        conformance_probability: probability,
        verdict: named(verdict),
    };
    vec![
        verdict("k_pitch_m", 1.1, 0.99999, "pass"),
        verdict("k_yaw_m", 1.055, 0.957, "undecided"),
        verdict("k_roll_m", 0.65, 0.0, "fail"),
    ]
}

/// A drag that the data cannot tell from another damping, after `critiques/ambiguous.json`; its
/// traces are made here.
pub fn ambiguous() -> Criticism {
    criticism(include_str!("critiques/ambiguous.json"))
}

/// A torque that no known cause gives, after `critiques/unexplained.json`.
pub fn unexplained() -> Criticism {
    criticism(include_str!("critiques/unexplained.json"))
}

fn criticism(json: &str) -> Criticism {
    let critique = serde_json::from_str(json).expect("a critique");
    let traces = vec![
        swing_trace("yaw-1", 4.391, 0.2, 0.002),
        swing_trace("pitch-1", 1.902, 0.05, 0.002),
    ];
    Criticism { critique, traces }
}

/// A swing that dies faster while it is wide; the base simulation lets it die evenly.
fn swing_trace(swing: &str, period_s: f64, amplitude: f64, noise_size: f64) -> SwingTrace {
    let t_s: Vec<f64> = (0..6000).map(|i| 0.02 * f64::from(i)).collect();
    let wave = |t: f64| amplitude * (TAU * t / period_s).cos();
    let extended: Vec<f64> = t_s
        .iter()
        .map(|t| wave(*t) * (-t / 380.0).exp() / (1.0 + t / 200.0))
        .collect();
    let base = t_s.iter().map(|t| wave(*t) * (-t / 140.0).exp()).collect();
    // Seed 1: the same page every time.
    let draws = Normal::new(0.0, noise_size)
        .expect("a size")
        .sample_iter(ChaCha8Rng::seed_from_u64(1));
    let measured = extended
        .iter()
        .zip(draws)
        .map(|(y, noise)| y + noise)
        .collect();
    SwingTrace {
        swing: swing.into(),
        channel: "turn rate about the phone's z".into(),
        unit: UnitName::RadianPerSecond.into(),
        noise: noise_size,
        t_s,
        measured,
        base,
        extended,
    }
}

/// A session that determines the yaw gyradius alone, in full agreement.
pub fn yaw_only() -> ReportSource {
    let mut source = keelboat();
    source.measurement.title = "Dinghy 17".into();
    source
        .measurement
        .quantities
        .retain(|key, _| *key == QuantityName::KYaw);
    source.measurement.budget.remove("k_pitch_m");
    source.measurement.swings.truncate(1);
    source.measurement.consistency = claims().split_off(2);
    source.measurement.verdicts.clear();
    source.measurement.warnings.clear();
    source.measurement.correlations.clear();
    source.measured_on = Some("4 May 2026, boatyard".into());
    source
}

/// A bare recording with six modes, some of them close together.
pub fn bare_recording() -> ReportSource {
    let near = [
        (2.766, 0.1, "pitch in phase"),
        (2.712, 0.2, "yaw"),
        (2.506, 0.05, "sway"),
        (1.272, 0.02, "pitch out of phase"),
    ];
    let modes = near
        .iter()
        .map(|(period, _, _)| mode(ModeName::Other, *period, 200.0, 0.05))
        .collect();
    let recording = RecordingFigureData {
        spectrum: Some(spectrum(&near)),
        ..yaw_recording("model-hull.csv")
    };
    ReportSource {
        measurement: Measurement {
            title: "model-hull.csv".into(),
            swings: vec![SwingResult {
                id: "model-hull.csv".into(),
                modes,
                ..Default::default()
            }],
            warnings: vec![
                "a bare recording gives modes alone; a session with dimensions gives inertia"
                    .into(),
            ],
            ..Default::default()
        },
        recordings: vec![recording],
        ..Default::default()
    }
}
