//! Clocks that step, amplitudes that cannot be, heeled hulls: figures by closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};

use gyradius_identification::{FindingKind, MeasureOptions, Measurement, Severity, measure};
use gyradius_recording::{
    LoadedData, LoadedSession, LoadedSwing, SwingData, read_recording, read_session, write_session,
};
use gyradius_test_support::fresh;
use rand_distr::{Distribution, StandardNormal};

const GRAVITY: f64 = 9.80665;
const HEAD: &str = "format = \"gyradius-session/1\"\n[body]\n[site]\n\
    gravity = { value = 9.80665, u = 0.0 }\n";

/// A session whose recordings, if any, are all this text.
fn measured(text: &str, csv: &str) -> Measurement {
    let session = read_session(text, "session.toml").unwrap();
    let data = session.swings.iter().map(|swing| LoadedSwing {
        id: swing.id.clone(),
        data: match &swing.data {
            SwingData::Recording(name) => {
                LoadedData::Recording(read_recording(csv.as_bytes(), name).unwrap())
            }
            _ => LoadedData::Typed,
        },
    });
    let loaded = LoadedSession {
        data: data.collect(),
        session,
        source: "written".into(),
        inclines: vec![],
        assumed: vec![],
    };
    measure(&loaded, &MeasureOptions::default()).unwrap()
}

fn scalar(result: &Measurement, name: &str) -> (f64, f64) {
    let found = &result.quantities[name];
    (found.value.scalar().unwrap(), found.u.scalar().unwrap())
}

fn severities(result: &Measurement, kind: FindingKind) -> Vec<Severity> {
    let found = result.findings.iter().filter(|one| one.kind == kind);
    found.map(|one| one.severity).collect()
}

/// Yaw of a body of k = 0.9 m on lines of 1 m, 1.2 m apart, by (5): T = 2π k/d √(l/g).
const LINES: &str = "[[swing]]\nid = \"s\"\nrecording = \"s.csv\"\nexcited = [\"yaw\"]\n\
    [swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
    line_length = { value = 1.0, u = 0.0005 }\nspacing = { value = 1.2, u = 0.0005 }\n";

/// Its rate over a minute at 50 Hz; after half of it the stamps are `ahead_s` more, and `lost_s` of
/// the motion passed unseen.
fn yaw(ahead_s: f64, lost_s: f64) -> String {
    let omega = 0.6 / 0.9 * GRAVITY.sqrt();
    let mut draws = fresh("clock");
    let mut text = String::from("t,gx,gy,gz\n");
    for i in 0..3000 {
        let late = if i < 1500 { 0.0 } else { 1.0 };
        let t = 0.02 * f64::from(i) + late * lost_s;
        let rate = -0.05 * omega * (-t / 150.0).exp() * (omega * t).sin();
        let mut noise = || -> f64 {
            let draw: f64 = StandardNormal.sample(&mut draws);
            1e-3 * draw
        };
        let stamp = t + late * ahead_s;
        text += &format!("{stamp:.5},{},{},{}\n", noise(), noise(), rate + noise());
    }
    text
}

#[test]
fn a_clock_that_steps_in_a_swing_is_cut_there() {
    let text = format!("{HEAD}{LINES}");
    for ahead_s in [0.2, 0.4, 1.8] {
        let result = measured(&text, &yaw(ahead_s, 0.0));
        let told = severities(&result, FindingKind::StampStep);
        assert_eq!(
            told,
            [Severity::Warned],
            "{ahead_s} s: {:?}",
            result.findings
        );
        let (value, u) = scalar(&result, "k_yaw_m");
        assert!((value - 0.9).abs() < 3.0 * u, "{ahead_s} s: {value} ± {u}");
    }
}

#[test]
fn a_pause_of_the_logger_is_bridged() {
    let text = format!("{HEAD}{LINES}");
    for lost_s in [0.2, 0.4, 1.8] {
        let result = measured(&text, &yaw(0.0, lost_s));
        let told = severities(&result, FindingKind::StampStep);
        assert_eq!(told, [], "{lost_s} s: {:?}", result.findings);
        let [_, end_s] = result.swings[0].span_s.unwrap();
        assert!(end_s > 59.0, "{lost_s} s: to {end_s} s");
        let (value, u) = scalar(&result, "k_yaw_m");
        assert!((value - 0.9).abs() < 3.0 * u, "{lost_s} s: {value} ± {u}");
    }
}

/// The rate of a pendulum from `angle_rad`, by Størmer's steps of 1 ms, times a factor.
fn pendulum(angle_rad: f64, factor: f64) -> String {
    const STEP_S: f64 = 1e-3;
    let (omega, loss_per_s) = (TAU / 1.4, 2.0 / 60.0);
    let mut draws = fresh("pendulum");
    let (mut before, mut angle) = (angle_rad, angle_rad);
    let mut text = String::from("t,gx,gy,gz\n");
    for i in 0..60_000 {
        let rate = (angle - before) / STEP_S;
        let pull = -omega * omega * angle.sin() - loss_per_s * rate;
        let next = 2.0 * angle - before + STEP_S * STEP_S * pull;
        if i % 20 == 0 {
            let mut noise = || -> f64 {
                let draw: f64 = StandardNormal.sample(&mut draws);
                3e-4 * draw
            };
            let rate = (next - before) / (2.0 * STEP_S);
            let row = [noise(), noise(), rate + noise()].map(|read| factor * read);
            let t = STEP_S * f64::from(i);
            text += &format!("{t:.3},{},{},{}\n", row[0], row[1], row[2]);
        }
        (before, angle) = (angle, next);
    }
    text
}

const AXIS: &str = "[[swing]]\nid = \"s\"\nrecording = \"s.csv\"\nexcited = [\"pitch\"]\n\
    [swing.suspension]\nkind = \"compound\"\norientation = \"athwartships\"\n\
    axis_height = { value = 0.2, u = 0.001 }\n";

/// One degree written in deg/s reads as 57°: the motion itself says that it is not.
#[test]
fn a_rate_in_degrees_is_seen_in_the_motion_itself() {
    let text = format!("{HEAD}{AXIS}");
    let result = measured(&text, &pendulum(PI / 180.0, 180.0 / PI));
    let suspect = FindingKind::UnitSuspect;
    assert_eq!(
        severities(&result, suspect),
        [Severity::Refused],
        "{:?}",
        result.findings
    );
    assert!(result.quantities.is_empty());
    // What does swing by 57°, and by 1°, is believed.
    for degrees in [57.0_f64, 1.0] {
        let result = measured(&text, &pendulum(degrees.to_radians(), 1.0));
        assert_eq!(
            severities(&result, suspect),
            [],
            "{degrees}°: {:?}",
            result.findings
        );
    }
}

/// Samples that are lost in a large swing, of which damped oscillations leave something, are no step of
/// the clock.
#[test]
fn samples_lost_in_a_large_swing_are_bridged() {
    let all = pendulum(1.0, 1.0);
    let is_kept = |line: &&str| {
        let stamp = line.split(',').next().and_then(|t| t.parse::<f64>().ok());
        !stamp.is_some_and(|t| (30.0..30.3).contains(&t))
    };
    let kept: Vec<&str> = all.lines().filter(is_kept).collect();
    assert!(kept.len() < all.lines().count());
    let result = measured(&format!("{HEAD}{AXIS}"), &kept.join("\n"));
    assert_eq!(severities(&result, FindingKind::StampStep), []);
    let [_, end_s] = result.swings[0].span_s.unwrap();
    assert!(end_s > 59.0, "to {end_s} s");
}

/// A period that was typed without its amplitude is told; with it, the pendulum's 2K(sin A/2)/π =
/// 1.073182 at 60° (mpmath) is taken off.
#[test]
fn a_typed_period_has_an_amplitude() {
    let (gyradius, depth) = (0.35_f64, 0.25_f64);
    let swing = |id: &str, height: f64, amplitude: &str| {
        let arm = height + depth;
        let small = TAU * ((gyradius * gyradius + arm * arm) / (GRAVITY * arm)).sqrt();
        let period = 1.073_182_007_149_36 * small;
        format!(
            "[[swing]]\nid = \"{id}\"\nperiods_s = {{ compound = {{ value = {period:?}, u = 1e-5 }} }}\n{amplitude}\
             [swing.suspension]\nkind = \"compound\"\norientation = \"athwartships\"\n\
             axis_height = {{ value = {height}, u = 0.0 }}\n"
        )
    };
    let session = |amplitude: &str| {
        format!(
            "{HEAD}{}{}",
            swing("a", 0.1, amplitude),
            swing("b", 0.5, amplitude)
        )
    };
    let bare = measured(&session(""), "");
    let told = |result: &Measurement| {
        let is_it = |channel: &Option<String>| channel.as_deref() == Some("amplitude_deg");
        let found = result.findings.iter().filter(|one| is_it(&one.channel));
        found.map(|one| one.severity).collect::<Vec<_>>()
    };
    assert_eq!(told(&bare), [Severity::Warned], "{:?}", bare.findings);
    let stated = measured(&session("amplitude_deg = { compound = 60 }\n"), "");
    assert_eq!(told(&stated), [], "{:?}", stated.findings);
    let (value, u) = scalar(&stated, "k_pitch_m");
    assert!((value - gyradius).abs() < 3.0 * u, "{value} ± {u}");
}

/// A hull heeled by φ yaws about an axis between its z and y: k² = k_z² cos² φ + k_y² sin² φ.
#[test]
fn a_heeled_hull_shows_its_pitch_gyradius_in_yaw() {
    let (yaw, pitch, heel) = (1.156_f64, 1.054_f64, 40.0_f64);
    let swing = |id: &str, heel_deg: f64| {
        let (sin, cos) = heel_deg.to_radians().sin_cos();
        let k = (yaw * cos).hypot(pitch * sin);
        let period = TAU * k / 0.6 * (2.0 / GRAVITY).sqrt();
        format!(
            "[[swing]]\nid = \"{id}\"\nperiods_s = {{ yaw = {{ value = {period:?}, u = 1e-5 }} }}\n\
             amplitude_deg = {{ yaw = 0 }}\n[swing.suspension]\nkind = \"bifilar\"\n\
             orientation = \"fore_and_aft\"\nline_length = {{ value = 2.0, u = 0.0 }}\n\
             points_m = [[-0.6, 0.3, 0.0], [0.6, 0.3, 0.0]]\n\
             hull_roll_deg = {{ value = {heel_deg}, u = 0.1 }}\n"
        )
    };
    let text = format!("{HEAD}{}{}", swing("level", 0.0), swing("heeled", heel));
    let session = read_session(&text, "session.toml").unwrap();
    assert_eq!(session.swings[0].suspension.spacing_m.unwrap().value, 1.2);
    let again = read_session(&write_session(&session), "session.toml").unwrap();
    assert_eq!(again.swings, session.swings);
    let result = measured(&text, "");
    for (name, expected) in [("k_yaw_m", yaw), ("k_pitch_m", pitch)] {
        let (value, u) = scalar(&result, name);
        assert!((value - expected).abs() < 0.05 * u, "{name}: {value} ± {u}");
    }
}

/// A swing on lines of 2.2 m, 1.8 m apart, by typed periods, s: yaw, sway, and both of pitch.
fn typed_swing(id: &str, [yaw, sway, slow, fast]: [f64; 4], turned: &str) -> String {
    let period = |name: &str, value: f64| format!("{name} = {{ value = {value}, u = 0.002 }}");
    let periods = [
        period("yaw", yaw),
        period("sway", sway),
        period("pitch_in_phase", slow),
        period("pitch_out_of_phase", fast),
    ]
    .join(", ");
    format!(
        "[[swing]]\nid = \"{id}\"\nperiods_s = {{ {periods} }}\n[swing.suspension]\n\
         kind = \"bifilar\"\norientation = \"athwartships\"\n\
         line_length = {{ value = 2.2, u = 0.003 }}\nspacing = {{ value = 1.8, u = 0.001 }}\n\
         hull_pitch_deg = {{ value = 0.0, u = 0.2 }}\n{turned}"
    )
}

/// The depth is that of the level hanging, 0.402 m, whichever comes first. Heeled by 30° the centre
/// lies 0.300 m below its points; periods by (5), the heeled tensor and the double pendulum of
/// surge and pitch.
#[test]
fn a_heeled_hanging_is_not_the_level_one() {
    let heeled = [3.557_042, 2.975_986, 4.426_542, 2.796_359];
    let heeled = typed_swing(
        "heeled",
        heeled,
        "hull_roll_deg = { value = 30.0, u = 0.3 }\n",
    );
    let level = typed_swing("level", [3.493_807, 2.975_986, 4.099_266, 2.655_762], "");
    for both in [format!("{heeled}{level}"), format!("{level}{heeled}")] {
        let result = measured(&format!("{HEAD}{both}"), "");
        let (value, u) = scalar(&result, "cm_depth_m");
        assert!((value - 0.402).abs() < u && u < 0.005, "{value} ± {u}");
    }
}

/// An incline shows mass times depth.
#[test]
fn an_incline_without_a_mass_tells_no_depth() {
    let period = TAU * 1.1 / 0.9 * (2.2 / GRAVITY).sqrt();
    let text = |body: &str| {
        format!(
            "{body}[[swing]]\nid = \"y\"\nperiods_s = {{ yaw = {{ value = {period:?}, u = 0.002 }} }}\n\
             [swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
             line_length = {{ value = 2.2, u = 0.003 }}\nspacing = {{ value = 1.8, u = 0.001 }}\n\
             [[incline]]\nend = \"bow\"\nmass = {{ value = 20.0, u = 0.05 }}\n\
             arm = {{ value = 2.5, u = 0.005 }}\ndepth = {{ value = 0.0, u = 0.002 }}\n\
             angle_deg = {{ value = 11.0, u = 0.05 }}\n"
        )
    };
    let weighed = HEAD.replace("[body]\n", "[body]\nmass = { value = 622.7, u = 0.5 }\n");
    // (20): tan φ = m L/(M l2).
    let expected = 20.0 * 2.5 / (622.7 * 11f64.to_radians().tan());
    let (value, u) = scalar(&measured(&text(&weighed), ""), "cm_depth_m");
    assert!((value - expected).abs() < u, "{value} ± {u}, {expected}");
    let unweighed = measured(&text(HEAD), "");
    assert!(!unweighed.quantities.contains_key("cm_depth_m"));
    let told = unweighed
        .findings
        .iter()
        .find(|one| one.message.english.contains("states no mass"));
    assert!(told.is_some(), "{:?}", unweighed.findings);
}

/// Zero is an amplitude, the one at which a period is that of small swings: of a hull that a phone
/// beside its middle plane makes lopsided too. k = (T/2π) d √(g/l), eq. (5); the phone moves it by
/// less than its uncertainty.
#[test]
fn an_amplitude_of_zero_needs_no_correction() {
    let gyradius = 1.056_f64;
    let period = TAU * gyradius / 0.9 * (3.477 / GRAVITY).sqrt();
    let head = HEAD.replace("[body]\n", "[body]\nmass = { value = 622.7, u = 0.5 }\n");
    let k = |amplitude: &str| {
        let text = format!(
            "{head}[[attachment]]\nname = \"phone\"\nmass = {{ value = 0.2, u = 0.002 }}\n\
             position = {{ value = [1.5, 0.1, -0.1], u = 0.01 }}\n\
             [[swing]]\nid = \"y\"\nperiods_s = {{ yaw = {{ value = {period:?}, u = 0.002 }} }}\n\
             {amplitude}[swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
             line_length = {{ value = 3.477, u = 0.003 }}\nspacing = {{ value = 1.8, u = 0.001 }}\n"
        );
        scalar(&measured(&text, ""), "k_yaw_m")
    };
    let (at_zero, u) = k("amplitude_deg = { yaw = 0 }\n");
    let (unstated, _) = k("");
    assert!((at_zero - unstated).abs() < 1e-6, "{at_zero} {unstated}");
    assert!(
        (at_zero - gyradius).abs() < u && u < 0.002,
        "{at_zero} ± {u}"
    );
}

/// Two swings in one hanging have one reading of the spacing, whose error stays; two hangings have
/// two, and the mean of them is better by √2, whatever digits they have.
#[test]
fn one_hanging_is_one_reading() {
    let period = TAU * 1.1 / 0.6 * (2.0 / GRAVITY).sqrt();
    let typed = |id: &str| {
        format!(
            "[[swing]]\nid = \"{id}\"\nperiods_s = {{ yaw = {{ value = {period:?}, u = 0.0 }} }}\n\
             amplitude_deg = {{ yaw = 0 }}\n[swing.suspension]\n"
        )
    };
    let stated = |spacing: f64| {
        format!(
            "kind = \"bifilar\"\norientation = \"athwartships\"\n\
             line_length = {{ value = 2.0, u = 0.0 }}\nspacing = {{ value = {spacing}, u = 0.003 }}\n"
        )
    };
    let u = |second: &str| {
        let text = format!("{HEAD}{}{}{}{second}", typed("a"), stated(1.2), typed("b"));
        scalar(&measured(&text, ""), "k_yaw_m").1
    };
    let once = u("same_as = \"a\"\n");
    // Hung again at another tilt on the same lines, the tape was read once.
    let tilted = u("same_as = \"a\"\nhull_pitch_deg = { value = 0.0, u = 0.1 }\n");
    assert!((tilted / once - 1.0).abs() < 0.01, "{once} {tilted}");
    let twice = u(&stated(1.2));
    let other = u(&stated(1.200_002));
    assert!((once / (1.1 * 0.003 / 1.2) - 1.0).abs() < 0.01, "{once}");
    assert!(
        (twice / once - 0.5_f64.sqrt()).abs() < 0.02,
        "{once} {twice}"
    );
    assert!((other / twice - 1.0).abs() < 0.02, "{twice} {other}");
}
