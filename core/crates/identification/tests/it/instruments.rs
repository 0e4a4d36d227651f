//! Readings of one instrument, a whole body, one channel, three lines: figures by closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use gyradius_identification::{FindingKind, MeasureOptions, Measurement, QuantityName, measure};
use gyradius_recording::{
    LoadedData, LoadedSession, LoadedSwing, ModeName, SwingData, read_period_list, read_recording,
    read_session,
};
use gyradius_test_support::{fresh, rng};
use rand_distr::{Distribution, StandardNormal};

const GRAVITY: f64 = 9.80665;
const GYRADIUS_M: f64 = 1.05;

/// A session of typed periods.
pub fn typed(text: &str) -> Measurement {
    let session = read_session(text, "session.toml").unwrap();
    let swing = |id: &str| LoadedSwing {
        id: id.into(),
        data: LoadedData::Typed,
    };
    let loaded = LoadedSession {
        data: session.swings.iter().map(|one| swing(&one.id)).collect(),
        session,
        source: "typed".into(),
        inclines: vec![],
        assumed: vec![],
    };
    measure(&loaded, &MeasureOptions::default()).unwrap()
}

pub fn k_yaw(result: &Measurement) -> (f64, f64) {
    scalar(result, "k_yaw_m")
}

fn scalar(result: &Measurement, name: &str) -> (f64, f64) {
    let found = &result.quantities[name];
    (found.value.scalar().unwrap(), found.u.scalar().unwrap())
}

/// A hanging: what the tape reads of length and spacing, and the true ones.
struct Hanging {
    read: [f64; 2],
    is: [f64; 2],
}

impl Hanging {
    /// Yaw and sway by (5) and (7).
    fn periods(&self) -> [f64; 2] {
        let [length, spacing] = self.is;
        let sway = TAU * (length / GRAVITY).sqrt();
        [sway * GYRADIUS_M / (0.5 * spacing), sway]
    }

    fn swing(&self, id: &str, figure: &str, with_sway: bool) -> String {
        let [yaw, sway] = self.periods();
        let [length, spacing] = self.read;
        let sway = match with_sway {
            true => format!(", sway = {{ value = {sway:?}, u = 1e-4 }}"),
            false => String::new(),
        };
        format!(
            "[[swing]]\nid = \"{id}\"\nperiods_s = {{ yaw = {{ value = {yaw:?}, u = 1e-4 }}{sway} }}\n\
             [swing.suspension]\nkind = \"bifilar\"\norientation = \"athwartships\"\n\
             line_length = {{ value = {length:?}, {figure} }}\nspacing = {{ value = {spacing:?}, {figure} }}\n"
        )
    }
}

fn session(swings: &[String], instruments: &str) -> String {
    format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = {{ value = 100.0, u = 0.1 }}\n[site]\n\
         gravity = {{ value = {GRAVITY}, u = 1e-5 }}\n{}{instruments}",
        swings.concat()
    )
}

const TAPE: &str = "[[instrument]]\nid = \"tape-1\"\nkind = \"tape\"\nscale_u = 1e-3\n";

/// k is the spacing times what periods and lengths give, √(g/l): with everything read by one tape of
/// relative error s it goes as √s where no sway tells s, and u(k)/k = u(s)/2 however many hangings
/// there are.
#[test]
fn a_tape_errs_alike_in_all_of_its_readings() {
    let hangings = [[3.0, 1.8], [3.5, 1.9], [4.1, 2.0]].map(|is| Hanging { read: is, is });
    for count in 1..=3 {
        let swings: Vec<String> = hangings[..count]
            .iter()
            .enumerate()
            .map(|(i, one)| one.swing(&format!("s{i}"), "u = 0, instrument = \"tape-1\"", false))
            .collect();
        let (value, u) = k_yaw(&typed(&session(&swings, TAPE)));
        assert!((value - GYRADIUS_M).abs() < 1e-6, "{value}");
        let expected = 0.5e-3 * GYRADIUS_M;
        assert!((u / expected - 1.0).abs() < 0.01, "{count}: {u} {expected}");
    }
}

/// The sway tells the length, and with it what the tape's scale is: T_s² = 4π² l/g, relative u of l
/// 2 u(T_s)/T_s. Then k = d T_y/T_s has that share of the tape's error.
#[test]
fn a_sway_tells_the_scale_of_the_tape() {
    let scale = 1.0013;
    let is = [3.0, 1.8];
    let hanging = Hanging {
        read: is.map(|x| x / scale),
        is,
    };
    let figure = "u = 0, instrument = \"tape-1\"";
    let (value, u) = k_yaw(&typed(&session(&[hanging.swing("a", figure, true)], TAPE)));
    let by_sway = 2.0 * 1e-4 / hanging.periods()[1];
    let posterior = (by_sway.powi(-2) + 1e6_f64).powf(-0.5);
    // The prior holds the scale back by the share of its information.
    let pulled = 0.0013 * (posterior / 1e-3).powi(2);
    assert!(
        (value - GYRADIUS_M * (1.0 - pulled)).abs() < 3e-5,
        "{value}"
    );
    assert!(
        u < 1.5 * posterior * GYRADIUS_M && u > 0.3 * posterior * GYRADIUS_M,
        "{u}"
    );
}

/// Two readings are two, whatever their digits: equal ones, some two micrometres apart and some far
/// apart have the same uncertainty.
#[test]
fn digits_change_no_uncertainty() {
    let at = |apart: f64, is_apart: f64| {
        let is = [3.0, 1.8];
        let second = Hanging {
            read: [3.0, 1.8 + apart],
            is: [3.0, 1.8 + is_apart],
        };
        let first = Hanging { read: is, is };
        let swings = [
            first.swing("a", "u = 0.0018", true),
            second.swing("b", "u = 0.0018", true),
        ];
        k_yaw(&typed(&session(&swings, ""))).1
    };
    let (same, near, far) = (at(0.0, 0.0), at(2e-6, 0.0), at(0.02, 0.02));
    assert!((near / same - 1.0).abs() < 0.01, "{near} {same}");
    assert!((far / same - 1.0).abs() < 0.02, "{far} {same}");
}

/// Drawn sessions, one tape for all or one for each hanging: the errors are as large as stated. With
/// 120 draws the standard deviation of z is within 0.25 of 1 in all but 1 of 10,000 runs.
#[test]
fn uncertainties_hold_with_shared_and_with_separate_tapes() {
    const DRAWS: usize = 120;
    let mut draws = rng();
    let mut normal = |size: f64| -> f64 {
        let draw: f64 = StandardNormal.sample(&mut draws);
        size * draw
    };
    for shared in [true, false] {
        let mut square = 0.0;
        for _ in 0..DRAWS {
            let scales = [normal(1e-3), normal(1e-3)];
            let hangings = [[3.0, 1.8], [3.5, 1.9]];
            let swings: Vec<String> = hangings
                .into_iter()
                .enumerate()
                .map(|(i, is)| {
                    let scale = if shared { scales[0] } else { scales[i] };
                    let read = is.map(|x| x * (1.0 + scale) + normal(5e-4));
                    let tape = if shared { 1 } else { i + 1 };
                    let figure = format!("u = 5e-4, instrument = \"tape-{tape}\"");
                    Hanging { read, is }.swing(&format!("s{i}"), &figure, false)
                })
                .collect();
            let tapes = format!("{TAPE}{}", TAPE.replace("tape-1", "tape-2"));
            let (value, u) = k_yaw(&typed(&session(&swings, &tapes)));
            square += ((value - GYRADIUS_M) / u).powi(2);
        }
        let sd = (square / DRAWS as f64).sqrt();
        assert!((sd - 1.0).abs() < 0.25, "shared {shared}: {sd}");
    }
}

/// Contributions of what rides along against differences through the whole program.
#[test]
fn masses_and_places_of_what_rides_along_count() {
    let hanging = Hanging {
        read: [3.0, 1.8],
        is: [3.0, 1.8],
    };
    let at = |added: f64, riding: f64, place: f64| {
        let swing = hanging.swing("a", "u = 1e-4", true).replace(
            "[swing.suspension]",
            &format!(
                "added_mass = [ {{ mass = {{ value = {added:?}, u = 0.01 }}, position = [1.5, 0.0, 0.0] }}, \
                 {{ mass = {{ value = 1.0, u = 0.0 }}, position = [-1.5, 0.0, 0.0] }} ]\n[swing.suspension]"
            ),
        );
        let attachment = format!(
            "[[attachment]]\nname = \"beam\"\nmass = {{ value = {riding:?}, u = 0.05 }}\n\
             position = {{ value = [{place:?}, 0.0, 0.0], u = 0.01 }}\n"
        );
        typed(&session(&[attachment, swing], ""))
    };
    let centre = at(1.0, 2.0, 1.2);
    let value = |result: &Measurement| k_yaw(result).0;
    let contribution = |of: &str| {
        let lines = &centre.budget["k_yaw_m"];
        let line = lines.iter().find(|line| line.input.to_string() == of);
        line.map_or(0.0, |line| line.u_contribution)
    };
    let cases = [
        ("mass of added mass 1", at(1.01, 2.0, 1.2)),
        ("mass of beam", at(1.0, 2.05, 1.2)),
        ("position of beam", at(1.0, 2.0, 1.21)),
    ];
    for (input, moved) in &cases {
        let difference = (value(moved) - value(&centre)).abs();
        let found = contribution(input);
        assert!(
            (found / difference - 1.0).abs() < 0.03 && difference > 1e-6,
            "{input}: {found} {difference}"
        );
    }
}

/// A drone on a platform that hangs on three lines: ω² = g R²/(l k²) of both together, the
/// platform's moment taken off.
#[test]
fn three_lines_give_the_gyradius_of_what_stands_on_the_platform() {
    let (radius, length, drone, platform) = (0.25, 1.2, 0.2058_f64, 0.14_f64);
    let both = ((2.0 * drone * drone + platform * platform) / 3.0).sqrt();
    let period = TAU * both / radius * (length / GRAVITY).sqrt();
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = {{ value = 3.0, u = 0.0 }}\n[site]\n\
         gravity = {{ value = {GRAVITY}, u = 0.0 }}\n[[attachment]]\nname = \"platform\"\nmass = {{ value = 1.0, u = 0.0 }}\n\
         position = {{ value = [0.0, 0.0, 0.0], u = 0.0 }}\ngyradii = [0.1, 0.1, {platform}]\n\
         [[swing]]\nid = \"t\"\nperiods_s = {{ yaw = {{ value = {period:?}, u = 1e-5 }} }}\n\
         [swing.suspension]\nkind = \"trifilar\"\nline_length = {{ value = {length}, u = 0.0 }}\n\
         radius = {{ value = {radius}, u = 0.0005 }}\n"
    );
    let result = typed(&text);
    let (value, u) = k_yaw(&result);
    assert!((value - drone).abs() < 1e-6, "{value}");
    // k of both goes as R; 3 k_both dk_both = 2 k dk.
    let expected = 3.0 * both / (2.0 * drone) * both * 0.0005 / radius;
    assert!((u / expected - 1.0).abs() < 0.01, "{u} {expected}");
    let (moment, _) = scalar(&result, "inertia_yaw_kg_m2");
    assert!((moment - 2.0 * drone * drone).abs() < 1e-5, "{moment}");
    assert!(!result.quantities.contains_key("inertia_kg_m2"));
}

/// A session whose one swing has one file.
fn of_file(suspension: &str, key: &str, csv: &str) -> Measurement {
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\n[site]\ngravity = {{ value = {GRAVITY}, u = 0.0 }}\n\
         [[swing]]\nid = \"s\"\n{key} = \"s.csv\"\nexcited = [\"yaw\"]\n[swing.suspension]\n{suspension}\n"
    );
    let session = read_session(&text, "session.toml").unwrap();
    let data = match session.swings[0].data {
        SwingData::Periods(_) => {
            LoadedData::Periods(read_period_list(csv.as_bytes(), "s.csv").unwrap())
        }
        _ => LoadedData::Recording(read_recording(csv.as_bytes(), "s.csv").unwrap()),
    };
    let loaded = LoadedSession {
        session,
        source: "one file".into(),
        data: vec![LoadedSwing {
            id: "s".into(),
            data,
        }],
        inclines: vec![],
        assumed: vec![],
    };
    measure(&loaded, &MeasureOptions::default()).unwrap()
}

/// A pendulum's θ = A cos φ and its rate, with white noise: A = A₀ e^(−αt), and as the frequency is
/// lower by A²/16, φ = ω (t − A₀² (1 − e^(−2αt))/(32 α)).
fn channel(header: &str, period_s: f64, amplitude_rad: f64) -> String {
    let mut draws = fresh(header);
    let (omega, alpha) = (TAU / period_s, 1.0 / 150.0);
    let mut text = format!("{header}\n");
    for i in 0..4000 {
        let t = 0.015 * f64::from(i);
        let size = amplitude_rad * (-alpha * t).exp();
        let late = (amplitude_rad * amplitude_rad - size * size) / (32.0 * alpha);
        let (sin, cos) = (omega * (t - late)).sin_cos();
        let frequency = omega * (1.0 - size * size / 16.0);
        let value = match header {
            "t,angle" => size * cos,
            _ => -size * (frequency * sin + alpha * cos),
        };
        let noise: f64 = StandardNormal.sample(&mut draws);
        text += &format!("{t},{}\n", value + 3e-4 * noise);
    }
    text
}

/// One channel of a pendulum: the period of small swings, T(A)/T = 1 + A²/16 taken off.
#[test]
fn a_single_channel_is_measured() {
    let compound = "kind = \"compound\"\norientation = \"athwartships\"\naxis_height = { value = 0.3, u = 0.001 }";
    for header in ["t,angle", "t,rate", "t,gz"] {
        let result = of_file(compound, "recording", &channel(header, 1.43, 0.05));
        let [mode] = &result.swings[0].modes[..] else {
            panic!("{header}: {:?}", result.swings[0].modes);
        };
        assert_eq!(mode.mode, ModeName::Compound, "{header}");
        assert!(
            (mode.amplitude.unwrap() - 0.05).abs() < 1e-3,
            "{header}: {mode:?}"
        );
        let off = (mode.period_s - 1.43).abs();
        assert!(off < 5.0 * mode.period_se_s + 2e-5, "{header}: {mode:?}");
    }
}

/// A pendulum from 95° is one motion, its period at small swings that of the law, 1 s, within what is
/// stated; what else there is is faint.
#[test]
fn a_large_swing_is_one_motion() {
    // The pendulum of 1 s from 95°, by Størmer's steps of 0.5 ms.
    let (step, omega) = (5e-4, TAU);
    let (mut before, mut angle) = (1.66_f64, 1.66_f64);
    let mut draws = fresh("large");
    let mut text = String::from("t,angle\n");
    for i in 0..60_000 {
        let next = 2.0 * angle
            - before
            - (omega * step).powi(2) * angle.sin()
            - 0.02 * step * (angle - before);
        (before, angle) = (angle, next);
        if i % 40 == 0 {
            let noise: f64 = StandardNormal.sample(&mut draws);
            text += &format!("{},{}\n", step * f64::from(i), angle + 1e-3 * noise);
        }
    }
    let compound = "kind = \"compound\"\norientation = \"athwartships\"\naxis_height = { value = 0.3, u = 0.001 }";
    let result = of_file(compound, "recording", &text);
    let [first, rest @ ..] = &result.swings[0].modes[..] else {
        panic!("{:?}", result.swings);
    };
    assert_eq!(first.mode, ModeName::Compound);
    assert!(
        (first.amplitude.unwrap() / 1.66 - 1.0).abs() < 0.05,
        "{first:?}"
    );
    let off = (first.period_s - 1.0).abs();
    assert!(
        off < 3.0 * first.period_se_s && first.period_se_s < 0.03,
        "{first:?}"
    );
    assert!(rest.iter().all(|mode| mode.relative_db < -50.0), "{rest:?}");
}

/// Eq. (14) in a list: the sway that modulates it, 1/T_s = 1/T_y + 1/T_m, gives the ratio of the
/// periods, and with it k = d T_y/T_s without the length of the lines.
#[test]
fn the_sway_in_a_list_of_periods_gives_the_ratio() {
    let (spacing, length) = (1.8, 3.477);
    let sway = TAU * (length / GRAVITY).sqrt();
    let yaw = sway * 1.0566 / (0.5 * spacing);
    let beat = 1.0 / (1.0 / sway - 1.0 / yaw);
    let mut draws = fresh("gate");
    let mut text = String::from("t,period\n");
    for i in 0..160 {
        let t = yaw * (f64::from(i) + 0.5);
        let noise: f64 = StandardNormal.sample(&mut draws);
        let wave = 0.12 * (-t / 900.0).exp() * (TAU * t / beat + 0.4).sin();
        text += &format!("{t},{}\n", yaw + wave + 2e-3 * noise);
    }
    let hung = format!(
        "kind = \"bifilar\"\norientation = \"athwartships\"\nline_length = {{ value = {length}, u = 0.006 }}\n\
         spacing = {{ value = {spacing}, u = 0.001 }}"
    );
    let result = of_file(&hung, "periods", &text);
    let trend = result.swings[0].trend.as_ref().unwrap();
    let modulation = trend.modulation.as_ref().unwrap();
    assert!(
        (modulation.t_m_s - beat).abs() < 4.0 * modulation.t_m_se_s + 0.01,
        "{modulation:?} {beat}"
    );
    assert!(
        (modulation.c_s - 0.12).abs() < 5.0 * modulation.c_se_s,
        "{modulation:?}"
    );
    let (value, u) = scalar(&result, QuantityName::KYaw.as_str());
    assert!((value - 1.0566).abs() < 3.5 * u, "{value} {u}");
    // The tape of the lines gave u = 0.0011; the spacing's own is k · 0.001/1.8 = 0.00059.
    assert!(u < 0.0007, "{u}");
}

/// Figures that cannot be: each is named, and what is missing is explained.
#[test]
fn figures_that_cannot_be_are_told() {
    let hanging = Hanging {
        read: [3.0, 1.8],
        is: [3.0, 1.8],
    };
    let swing = hanging.swing("a", "u = 1e-3", true);
    let riding = |text: &str| format!("[[attachment]]\nname = \"beam\"\n{text}\n");
    let kinds = |text: &str| -> Vec<(FindingKind, Option<String>)> {
        let found = typed(text).findings.into_iter();
        found.map(|one| (one.kind, one.channel)).collect()
    };
    let has = |text: &str, kind: FindingKind, channel: &str| {
        let found = kinds(text);
        let is_it = |one: &(FindingKind, Option<String>)| {
            one.0 == kind && one.1.as_deref() == Some(channel)
        };
        assert!(found.iter().any(is_it), "{channel}: {found:?}");
    };
    let with = |attachment: &str| session(&[riding(attachment), swing.clone()], "");
    let implausible = FindingKind::ImplausibleSize;
    has(
        &with("mass = 40.0\nposition = [0.0, 0.0, 0.0]"),
        implausible,
        "mass",
    );
    has(
        &with("mass = 1.0\nposition = [60.0, 0.0, 0.0]"),
        implausible,
        "position",
    );
    // 1 kg at 60 m has more moment of inertia than the 110 kg m² of everything.
    let missing = FindingKind::NotIdentifiable;
    has(
        &with("mass = 1.0\nposition = [60.0, 0.0, 0.0]"),
        missing,
        "k_yaw_m",
    );
    let plain = session(std::slice::from_ref(&swing), "");
    has(&plain.replace("9.80665", "1.62"), implausible, "gravity");
    let frequency = hanging.periods()[0].recip();
    let typed_as = format!("yaw = {{ value = {frequency:?}");
    let period = format!("yaw = {{ value = {:?}", hanging.periods()[0]);
    let swings = [hanging
        .swing("a", "u = 1e-3", false)
        .replace(&period, &typed_as)];
    has(&session(&swings, ""), implausible, "k_yaw_m");
    assert!(
        !kinds(&plain).iter().any(|(kind, _)| *kind == implausible),
        "{:?}",
        kinds(&plain)
    );
}

/// Of a session that contradicts itself the figure that is wrong is among the suspects, a typed
/// period too, and none that would have to be wrong by more than a slip.
#[test]
fn a_misread_sway_is_among_the_suspects() {
    let hanging = Hanging {
        read: [3.0, 1.8],
        is: [3.0, 1.8],
    };
    let sway = format!("sway = {{ value = {:?}", hanging.periods()[1]);
    let misread = format!("sway = {{ value = {:?}", hanging.periods()[1] * 1.025);
    let swing = hanging
        .swing("a", "u = 1e-3", true)
        .replace(&sway, &misread);
    let result = typed(&session(&[swing], ""));
    let (value, u) = k_yaw(&result);
    // By the sway 1.05/1.025, by the tape 1.05.
    assert!(
        (value - GYRADIUS_M).abs() < 3.0 * u && u > 0.005,
        "{value} {u}"
    );
    let told = result
        .findings
        .iter()
        .find(|f| f.kind == FindingKind::Contradiction);
    assert!(
        told.is_some_and(|f| f.message.english.contains("sway period")),
        "{told:?}"
    );
    // The period of yaw for both: no slip of 30 % explains it.
    let both = format!("sway = {{ value = {:?}", hanging.periods()[0]);
    let swing = hanging.swing("a", "u = 1e-3", true).replace(&sway, &both);
    let result = typed(&session(&[swing], ""));
    let stated = result.quantities.get("k_yaw_m").map(|_| k_yaw(&result));
    assert!(
        stated.is_none_or(|(value, u)| (value - GYRADIUS_M).abs() < 3.0 * u),
        "{stated:?}"
    );
}
