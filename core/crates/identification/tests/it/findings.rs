//! Sessions with something in them that is not plausible: it is named, and no wrong figure is stated.
//!
//! The recordings are pure yaw on two parallel lines, written here in closed form: the period by (5),
//! T = 2π (k/d) √(l/g), small angles, a phone 0.2 m off the axis.
// Clippy's leave for tests does not reach the functions that tests share.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};

use gyradius_identification::{
    Finding, FindingKind, MeasureOptions, Measurement, QuantityName, Severity, measure,
};
use gyradius_recording::{
    LoadedData, LoadedSession, LoadedSwing, RepairKind, SwingData, read_period_list,
    read_recording, read_session,
};
use gyradius_test_support::fresh;
use rand_distr::{Distribution, StandardNormal};

const GRAVITY: f64 = 9.80665;
const LINES_M: f64 = 1.2;
const HALF_SPACING_M: f64 = 0.2;
const GYRADIUS_M: f64 = 0.129;
const LEVER_M: f64 = 0.2;

/// One recorded swing in yaw.
pub struct Yaw {
    gyradius_m: f64,
    rate_hz: f64,
    duration_s: f64,
    amplitude_rad: f64,
    decay_s: f64,
    /// The gyroscope's readings are multiplied by this, …
    gyro_factor: f64,
    /// … the accelerometer's by this.
    acc_factor: f64,
    /// The gyroscope's limit, rad/s.
    limit: f64,
}

pub const SWING: Yaw = Yaw {
    gyradius_m: GYRADIUS_M,
    rate_hz: 100.0,
    duration_s: 60.0,
    amplitude_rad: 0.08,
    decay_s: 200.0,
    gyro_factor: 1.0,
    acc_factor: 1.0,
    limit: f64::INFINITY,
};

impl Yaw {
    pub fn csv(&self, name: &str) -> String {
        let mut draws = fresh(name);
        let omega = HALF_SPACING_M / self.gyradius_m * (GRAVITY / LINES_M).sqrt();
        let mut noise = |size: f64| -> f64 {
            let draw: f64 = StandardNormal.sample(&mut draws);
            size * draw
        };
        let mut text = String::from("t,gx,gy,gz,ax,ay,az\n");
        for i in 0..(self.rate_hz * self.duration_s) as usize {
            let t = i as f64 / self.rate_hz;
            let size = self.amplitude_rad * (-t / self.decay_s).exp();
            let (sin, cos) = (omega * t).sin_cos();
            let rate = -size * omega * sin;
            let rate = (self.gyro_factor * rate + noise(1e-3)).clamp(-self.limit, self.limit);
            let along = -LEVER_M * size * omega * omega * cos;
            let inwards = -LEVER_M * (size * omega * sin).powi(2);
            let acc = [inwards, along, GRAVITY].map(|a| self.acc_factor * (a + noise(0.01)));
            let gyro = [noise(1e-3), noise(1e-3), rate];
            text += &format!(
                "{t:.5},{},{},{},{},{},{}\n",
                gyro[0], gyro[1], gyro[2], acc[0], acc[1], acc[2]
            );
        }
        text
    }
}

fn suspension(spacing_m: f64) -> String {
    format!(
        "[swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
         line_length = {{ value = {LINES_M}, u = 0.001 }}\n\
         spacing = {{ value = {spacing_m}, u = 0.0005 }}\n"
    )
}

const HEAD: &str = "format = \"gyradius-session/1\"\n[body]\nlength_overall = 1.0\n\
    [site]\ngravity = { value = 9.80665, u = 0.0005 }\n";

/// A session of recordings, by their texts.
fn recorded(swings: &[&str], spacing_m: f64) -> LoadedSession {
    let mut text = HEAD.to_owned();
    for i in 0..swings.len() {
        text += &format!("[[swing]]\nid = \"s{i}\"\nrecording = \"s{i}.csv\"\n");
        text += &suspension(spacing_m);
    }
    loaded(&text, swings)
}

/// A session by its text; files in the order of its swings.
fn loaded(text: &str, files: &[&str]) -> LoadedSession {
    let session = read_session(text, "session.toml").unwrap();
    let mut files = files.iter();
    let data = session.swings.iter().map(|swing| {
        let data = match &swing.data {
            SwingData::Recording(name) => {
                let text = files.next().unwrap();
                LoadedData::Recording(read_recording(text.as_bytes(), name).unwrap())
            }
            SwingData::Periods(name) => {
                let text = files.next().unwrap();
                LoadedData::Periods(read_period_list(text.as_bytes(), name).unwrap())
            }
            _ => LoadedData::Typed,
        };
        let id = swing.id.clone();
        LoadedSwing { id, data }
    });
    let data = data.collect();
    LoadedSession {
        session,
        source: "written".into(),
        data,
        inclines: vec![],
        assumed: vec![],
    }
}

fn measured(session: &LoadedSession) -> Measurement {
    measure(session, &MeasureOptions::default()).unwrap()
}

fn of_kind(result: &Measurement, kind: FindingKind) -> Vec<Severity> {
    let found = result.findings.iter().filter(|one| one.kind == kind);
    found.map(|one| one.severity).collect()
}

/// A figure with its standard uncertainty.
fn figure(result: &Measurement, name: &QuantityName) -> Option<(f64, f64)> {
    let quantity = result.quantities.get(name)?;
    Some((quantity.value.scalar()?, quantity.u.scalar()?))
}

#[track_caller]
fn assert_near(result: &Measurement, name: &QuantityName, expected: f64, most: f64) {
    let (value, u) = figure(result, name).unwrap();
    assert!(
        (value - expected).abs() < most * u,
        "{name}: {value} ± {u}, expected {expected}"
    );
}

#[track_caller]
fn assert_refused(result: &Measurement, kind: FindingKind) {
    assert_eq!(
        of_kind(result, kind),
        [Severity::Refused],
        "{:?}",
        result.findings
    );
    assert!(result.quantities.is_empty(), "{:?}", result.quantities);
}

#[test]
fn a_plausible_session_is_measured_and_nothing_is_refused() {
    let csv = SWING.csv("plausible");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 3.0);
    let refused = result.findings.iter().find(|one| one.refuses());
    assert!(refused.is_none(), "{refused:?}");
    // Yaw alone says nothing of pitch, and nothing tests the spacing.
    assert!(figure(&result, &QuantityName::KPitch).is_none());
    assert!(figure(&result, &QuantityName::CmDepth).is_none());
    let unchecked = of_kind(&result, FindingKind::UncheckedDimension);
    assert!(unchecked.iter().all(|s| *s == Severity::Noted) && !unchecked.is_empty());
}

#[test]
fn degrees_per_second_are_named() {
    let gyro_factor = 180.0 / PI;
    let amplitude_rad = 0.3;
    let csv = Yaw {
        gyro_factor,
        amplitude_rad,
        ..SWING
    }
    .csv("degrees");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    assert_refused(&result, FindingKind::UnitSuspect);
    let finding = &result.findings[0];
    assert_eq!(finding.channel.as_deref(), Some("gyroscope"));
    assert!((finding.numbers["factor"] - PI / 180.0).abs() < 1e-12);
    assert!(finding.advice.english.contains("degrees per second"));
}

#[test]
fn an_accelerometer_in_another_unit_is_named() {
    for (unit, per_m_s2) in [("g", 1.0 / GRAVITY), ("mg", 1e3 / GRAVITY), ("mm/s²", 1e3)] {
        let csv = Yaw {
            acc_factor: per_m_s2,
            ..SWING
        }
        .csv("acceleration");
        let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
        assert_refused(&result, FindingKind::UnitSuspect);
        let advice = &result.findings[0].advice.english;
        assert!(advice.contains(&format!("look like {unit}:")), "{advice}");
    }
    // A fifth too much is no unit: it is said, and the period stands.
    let csv = Yaw {
        acc_factor: 1.2,
        ..SWING
    }
    .csv("acceleration");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    assert_eq!(
        of_kind(&result, FindingKind::UnitSuspect),
        [Severity::Warned]
    );
    assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 3.0);
}

/// 5 Hz: the period of 0.2837 s shows as one of 0.66 s.
#[test]
fn a_motion_faster_than_half_the_rate_is_not_stated() {
    let gyradius_m = HALF_SPACING_M * 0.2837 / TAU * (GRAVITY / LINES_M).sqrt();
    let csv = Yaw {
        gyradius_m,
        rate_hz: 5.0,
        ..SWING
    }
    .csv("alias");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    assert_refused(&result, FindingKind::Undersampled);
    let other_s = result.findings[0].numbers["other_period_s"];
    assert!((other_s - 0.2837).abs() < 0.01, "{other_s}");
}

#[test]
fn a_swing_at_the_sensors_limit_is_refused_or_used_from_where_it_is_clear() {
    let omega = HALF_SPACING_M / GYRADIUS_M * (GRAVITY / LINES_M).sqrt();
    for share in [0.4, 0.65, 0.9] {
        let limit = share * SWING.amplitude_rad * omega;
        let csv = Yaw {
            limit,
            decay_s: 1e4,
            ..SWING
        }
        .csv("limit");
        let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
        assert_refused(&result, FindingKind::Saturated);
        // It decays below the limit soon: up to there it is left out if much was lost.
        let csv = Yaw {
            limit,
            decay_s: 25.0,
            duration_s: 90.0,
            ..SWING
        }
        .csv("clear");
        let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
        let told = of_kind(&result, FindingKind::Saturated);
        assert!(
            share > 0.8 || told == [Severity::Warned],
            "{share}: {told:?}"
        );
        assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 4.0);
    }
}

#[test]
fn lengths_in_another_unit_are_refused() {
    let csv = SWING.csv("plausible");
    let result = measured(&recorded(&[&csv], 2e3 * HALF_SPACING_M));
    assert_refused(&result, FindingKind::ImplausibleSize);
    assert_eq!(result.findings[0].channel.as_deref(), Some("spacing"));
}

/// One fifth more spacing than the hull is long, twice the gyradius: only the hull's length tells.
#[test]
fn a_gyradius_that_no_hull_of_this_length_has_is_refused() {
    let csv = Yaw {
        gyradius_m: 0.8,
        ..SWING
    }
    .csv("size");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    assert_eq!(
        of_kind(&result, FindingKind::ImplausibleSize),
        [Severity::Refused]
    );
    assert!(figure(&result, &QuantityName::KYaw).is_none());
}

#[test]
fn half_periods_are_told_by_their_alternation() {
    let period_s = TAU * GYRADIUS_M / HALF_SPACING_M * (LINES_M / GRAVITY).sqrt();
    let session = |entry: &dyn Fn(usize) -> f64| {
        let mut draws = fresh("half periods");
        let mut list = String::from("t,period\n");
        let mut t = 0.0;
        for i in 0..60 {
            let noise: f64 = StandardNormal.sample(&mut draws);
            let length = entry(i) + 1e-4 * noise;
            list += &format!("{},{length}\n", t + 0.5 * length);
            t += length;
        }
        let text = format!(
            "{HEAD}[[swing]]\nid = \"gate\"\nexcited = [\"yaw\"]\nperiods = \"p.csv\"\n{}",
            suspension(2.0 * HALF_SPACING_M)
        );
        measured(&loaded(&text, &[&list]))
    };
    let by_turns = |i: usize| 0.5 * period_s + if i.is_multiple_of(2) { 0.03 } else { -0.03 };
    assert_refused(&session(&by_turns), FindingKind::HalfPeriods);
    let whole = session(&|_| period_s);
    assert!(of_kind(&whole, FindingKind::HalfPeriods).is_empty());
    assert_near(&whole, &QuantityName::KYaw, GYRADIUS_M, 3.0);
}

#[test]
fn constant_channels_are_named() {
    let csv = SWING.csv("plausible");
    let with_zeros: Vec<String> = csv
        .lines()
        .map(|line| {
            let mut cells: Vec<&str> = line.split(',').collect();
            if cells[0] != "t" {
                cells[2] = "0";
            }
            cells.join(",")
        })
        .collect();
    let result = measured(&recorded(&[&with_zeros.join("\n")], 2.0 * HALF_SPACING_M));
    let channels: Vec<_> = result
        .findings
        .iter()
        .filter(|one| one.kind == FindingKind::ConstantChannel)
        .map(|one| one.channel.as_deref())
        .collect();
    assert_eq!(channels, [Some("gy")]);
}

#[test]
fn the_same_recording_twice_counts_once() {
    let (one, other) = (SWING.csv("first"), SWING.csv("second"));
    let alone = measured(&recorded(&[&one], 2.0 * HALF_SPACING_M));
    let twice = measured(&recorded(&[&one, &one], 2.0 * HALF_SPACING_M));
    assert_eq!(
        of_kind(&twice, FindingKind::DuplicateRecording),
        [Severity::Refused]
    );
    let (single, double) = (
        figure(&alone, &QuantityName::KYaw).unwrap(),
        figure(&twice, &QuantityName::KYaw).unwrap(),
    );
    assert!((single.0 - double.0).abs() < 1e-6 && (single.1 / double.1 - 1.0).abs() < 1e-3);
    let both = measured(&recorded(&[&one, &other], 2.0 * HALF_SPACING_M));
    assert!(of_kind(&both, FindingKind::DuplicateRecording).is_empty());
}

/// Small-amplitude periods of a hull with k = (0.625, 1.156, 1.057) m, depth 0.470 m and ψ = 0 on
/// lines of 3.477 m, spacing 1.8 m, by the small oscillations of another program: athwartships yaw,
/// sway, pitch out of and in phase; fore and aft roll out of and in phase.
const PERIODS_S: [f64; 6] = [
    4.39394234, 3.74129433, 2.91735013, 4.33872133, 1.69113778, 4.04663005,
];

fn typed(clock: f64, is_rolled: bool) -> LoadedSession {
    let [yaw, sway, out, slow, roll_out, roll_slow] = PERIODS_S.map(|p| clock * p);
    let hung = |way: &str| {
        format!(
            "[swing.suspension]\nkind = \"bifilar\"\norientation = \"{way}\"\n\
             line_length = {{ value = 3.477, u = 0.001 }}\nspacing = {{ value = 1.8, u = 0.0005 }}\n"
        )
    };
    let q = |value: f64| format!("{{ value = {value}, u = 0.0005 }}");
    let mut text = format!(
        "format = \"gyradius-session/1\"\n[body]\n[site]\ngravity = {}\n\
         [[swing]]\nid = \"a\"\nperiods_s = {{ yaw = {}, sway = {}, pitch_out_of_phase = {}, \
         pitch_in_phase = {} }}\n{}",
        q(GRAVITY),
        q(yaw),
        q(sway),
        q(out),
        q(slow),
        hung("athwartships"),
    );
    if is_rolled {
        text += &format!(
            "[[swing]]\nid = \"f\"\nperiods_s = {{ yaw = {}, sway = {}, roll_out_of_phase = {}, \
             roll_in_phase = {} }}\n{}",
            q(yaw),
            q(sway),
            q(roll_out),
            q(roll_slow),
            hung("fore_and_aft"),
        );
    }
    loaded(&text, &[])
}

#[test]
fn another_swing_raises_no_uncertainty() {
    let (less, more) = (measured(&typed(1.0, false)), measured(&typed(1.0, true)));
    for (name, truth) in [
        (QuantityName::KYaw, 1.057),
        (QuantityName::KPitch, 1.156),
        (QuantityName::CmDepth, 0.470),
    ] {
        assert_near(&less, &name, truth, 0.1);
        assert_near(&more, &name, truth, 0.1);
        let (before, after) = (
            figure(&less, &name).unwrap().1,
            figure(&more, &name).unwrap().1,
        );
        assert!(after < 1.02 * before, "{name}: {before} to {after}");
    }
    assert_near(&more, &QuantityName::KRoll, 0.625, 0.1);
}

/// All periods 1 % long: gravity is wrong, or the lines are. The ratio of periods knows the yaw
/// gyradius all the same; what hangs on the two is uncertain by as much.
#[test]
fn a_contradiction_widens_what_it_touches() {
    let (right, wrong) = (measured(&typed(1.0, true)), measured(&typed(1.01, true)));
    assert!(of_kind(&right, FindingKind::Contradiction).is_empty());
    assert_eq!(
        of_kind(&wrong, FindingKind::Contradiction),
        [Severity::Widened]
    );
    for (name, truth) in [
        (QuantityName::KPitch, 1.156),
        (QuantityName::CmDepth, 0.470),
    ] {
        assert_near(&wrong, &name, truth, 2.5);
    }
    assert_near(&wrong, &QuantityName::KYaw, 1.057, 2.5);
    let u = |result: &Measurement| figure(result, &QuantityName::KYaw).unwrap().1;
    assert!(u(&wrong) < 3.0 * u(&right), "{} {}", u(&right), u(&wrong));
}

/// Two loggers read one sensor: other digits and another clock, the same noise.
#[test]
fn two_loggers_of_one_phone_count_once() {
    let csv = SWING.csv("logged");
    let other = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let rounded: Vec<String> = cells[1..].iter().map(|v| format!("{v:.3}")).collect();
        format!("{:.4},{}\n", cells[0] + 1_700_000_000.0, rounded.join(","))
    };
    // The other was started 0.4 s later.
    let rest: String = csv.lines().skip(41).map(other).collect();
    let again = format!("t,gx,gy,gz,ax,ay,az\n{rest}");
    let result = measured(&recorded(&[&csv, &again], 2.0 * HALF_SPACING_M));
    let found = of_kind(&result, FindingKind::DuplicateRecording);
    assert_eq!(found, [Severity::Refused], "{:?}", result.findings);
    // Another swing of the same hull is another measurement.
    let second = SWING.csv("another");
    let result = measured(&recorded(&[&csv, &second], 2.0 * HALF_SPACING_M));
    assert_eq!(of_kind(&result, FindingKind::DuplicateRecording), []);
}

/// A record of little more than one period is mostly baseline: what oscillates beside it is not the
/// motion, and no period is stated.
#[test]
fn oscillations_that_are_not_the_motion_are_refused() {
    let short = Yaw {
        duration_s: 2.0,
        amplitude_rad: 0.5,
        ..SWING
    };
    let whole = SWING.csv("whole");
    let csv = short.csv("short");
    let result = measured(&recorded(&[&whole, &csv], 2.0 * HALF_SPACING_M));
    assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 4.0);
    let true_s = TAU * GYRADIUS_M / HALF_SPACING_M * (LINES_M / GRAVITY).sqrt();
    for mode in &result.swings[1].modes {
        let off = (mode.period_s / true_s - 1.0).abs();
        assert!(off < 0.05, "{mode:?} {true_s}");
    }
}

/// Axes of one sensor that are exchanged show a turn along which the force lies.
#[test]
fn exchanged_axes_are_told() {
    // The gyroscope's y and z: yaw looks like pitch.
    let exchanged = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let [t, gx, gy, gz, ax, ay, az] = cells[..] else {
            panic!("{line}");
        };
        format!("{t},{gx},{gz},{gy},{ax},{ay},{az}\n")
    };
    let csv = SWING.csv("exchanged");
    let rest: String = csv.lines().skip(1).map(exchanged).collect();
    let turned = format!("t,gx,gy,gz,ax,ay,az\n{rest}");
    let result = measured(&recorded(&[&turned], 2.0 * HALF_SPACING_M));
    assert_refused(&result, FindingKind::SensorsDisagree);
}

/// A recorder that writes −999 where it has no reading: those rows are left out, and told.
#[test]
fn what_is_no_reading_is_left_out() {
    let csv = SWING.csv("sentinels");
    let lost = |(i, line): (usize, &str)| match i % 97 {
        13 => {
            let cells: Vec<&str> = line.split(',').collect();
            format!("{},-999,-999,-999\n", cells[..4].join(","))
        }
        _ => format!("{line}\n"),
    };
    let with: String = csv.lines().enumerate().map(lost).collect();
    let result = measured(&recorded(&[&with], 2.0 * HALF_SPACING_M));
    assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 3.0);
    let told = result.swings[0]
        .repairs
        .iter()
        .find(|repair| repair.kind == RepairKind::NoReading);
    assert_eq!(told.map(|repair| repair.count), Some(62));
}

/// Rows of a file in another order than that of time are no two recordings.
#[test]
fn rows_out_of_order_are_refused() {
    let csv = SWING.csv("shuffled");
    let lines: Vec<&str> = csv.lines().collect();
    let (head, rows) = lines.split_first().unwrap();
    let blocks: Vec<&[&str]> = rows.chunks(50).collect();
    // 7 has no factor in common with the 120 blocks.
    let order = (0..blocks.len()).map(|i| blocks[7 * i % blocks.len()].join("\n"));
    let text = format!("{head}\n{}\n", order.collect::<Vec<_>>().join("\n"));
    let error = read_recording(text.as_bytes(), "s.csv").unwrap_err();
    assert!(
        error.to_string().contains("in the order of time"),
        "{error}"
    );
}

/// Rows that were lost, under stamps that count those that came: no clock tells of it, the swing does
/// as it starts anew at every loss. 2 % of the time is missing, and so much longer is the period.
#[test]
fn losses_under_counted_stamps_are_in_the_uncertainty() {
    let swing = Yaw {
        amplitude_rad: 0.12,
        ..SWING
    };
    let csv = swing.csv("lossy");
    let mut lines = csv.lines();
    let head = lines.next().unwrap();
    let kept = lines.enumerate().filter(|(i, _)| i % 400 >= 8);
    let counted = kept.enumerate().map(|(i, (_, line))| {
        let (_, cells) = line.split_once(',').unwrap();
        format!("{:.5},{cells}\n", i as f64 / swing.rate_hz)
    });
    let text: String = counted.collect();
    let result = measured(&recorded(
        &[&format!("{head}\n{text}")],
        2.0 * HALF_SPACING_M,
    ));
    assert_near(&result, &QuantityName::KYaw, GYRADIUS_M, 3.0);
    let mut told = result.findings.iter();
    assert!(told.any(|one| one.severity == Severity::Warned));
}

/// A phone typed at 0.03 m for 0.2 m from the axis: its own accelerometer feels the yaw where it is.
#[test]
fn a_phone_that_is_elsewhere_is_told() {
    let csv = SWING.csv("elsewhere");
    let session = |at_m: f64| {
        let head = HEAD.replace(
            "length_overall",
            "mass = { value = 3.0, u = 0.002 }\nlength_overall",
        );
        let text = format!(
            "{head}[[attachment]]\nname = \"phone\"\nmass = 0.2\nposition = [{at_m:?}, 0.0, 0.0]\n\
             [[swing]]\nid = \"s\"\nrecording = \"s.csv\"\n{}",
            suspension(2.0 * HALF_SPACING_M)
        );
        measured(&loaded(&text, &[&csv]))
    };
    let (right, wrong) = (session(0.2), session(0.03));
    assert!(of_kind(&right, FindingKind::Contradiction).is_empty());
    let told = wrong
        .findings
        .iter()
        .find(|one| one.kind == FindingKind::Contradiction)
        .unwrap();
    assert_eq!(told.severity, Severity::Warned);
    assert!((told.numbers["lever_m"] - LEVER_M).abs() < 0.01, "{told:?}");
    // The gyradii of the two sessions differ by what is told.
    let k = |result: &Measurement| figure(result, &QuantityName::KYaw).unwrap().0;
    let shift = told.numbers["k_yaw_shift_m"];
    let is = k(&right) - k(&wrong);
    assert!((shift / is - 1.0).abs() < 0.15, "{shift} {is}");
}

/// Yaw alone tests neither its dimensions nor the clock: it is said what could be wrong unseen.
#[test]
fn what_yaw_alone_does_not_test_is_told() {
    let csv = SWING.csv("untested");
    let result = measured(&recorded(&[&csv], 2.0 * HALF_SPACING_M));
    let untested = result.findings.iter();
    let untested = untested.filter(|one| one.kind == FindingKind::UncheckedDimension);
    let names: Vec<_> = untested.filter_map(|one| one.channel.as_deref()).collect();
    assert_eq!(names, ["phone_clock", "line_length", "spacing"]);
    // What one tape says of two swings is no test, nor is it one to state it as exact.
    let other = SWING.csv("untested again");
    let twice = recorded(&[&csv, &other], 2.0 * HALF_SPACING_M);
    let text = format!(
        "{HEAD}[[swing]]\nid = \"s\"\nrecording = \"s.csv\"\n{}",
        suspension(2.0 * HALF_SPACING_M).replace("u = 0.0005", "u = 0.0")
    );
    for session in [twice, loaded(&text, &[&csv])] {
        let result = measured(&session);
        let of_spacing = |one: &&Finding| {
            one.kind == FindingKind::UncheckedDimension && one.channel.as_deref() == Some("spacing")
        };
        let told = result.findings.iter().find(of_spacing).unwrap();
        // A slip of 30 % of it moves the gyradius by as much.
        let (k, u) = figure(&result, &QuantityName::KYaw).unwrap();
        let expected = 0.3 * k / u;
        assert!(
            (told.numbers["in_u"] / expected - 1.0).abs() < 0.1,
            "{told:?}"
        );
    }
    // Four modes of two hangings test lines and clock; a slip that both spacings share is as good as
    // another yaw gyradius.
    let result = measured(&typed(1.0, true));
    let told = result.findings.iter();
    let told = told.filter(|one| one.numbers.contains_key("hidden_error"));
    let names: Vec<_> = told.filter_map(|one| one.channel.as_deref()).collect();
    assert_eq!(names, ["spacing"]);
}
