//! Swings about one axis as one motion, at any amplitude and with any damping. The motions are those
//! of a second integrator, with steps of 1/2000 of a period.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::{PI, TAU};

use gyradius_identification::{
    FindingKind, MeasureOptions, Measurement, ModeResult, QuantityName, Severity, measure,
    measure_recording,
};
use gyradius_recording::{LoadedData, LoadedSession, LoadedSwing, read_recording, read_session};
use gyradius_test_support::fresh;
use rand_distr::{Distribution, StandardNormal};

/// A motion: θ'' = −ω² f(θ) − 2αθ' − b|θ'|θ' − c sgn θ', from rest at an angle.
#[derive(Clone, Copy)]
struct Motion {
    period_s: f64,
    angle_rad: f64,
    damping_per_s: f64,
    drag_per_rad: f64,
    friction_rad_s2: f64,
    /// f less the sine of the angle.
    beside_sine: fn(f64) -> f64,
    cycles: f64,
    rate_hz: f64,
    noise: f64,
}

const FREE: Motion = Motion {
    period_s: 1.6,
    angle_rad: 0.3,
    damping_per_s: 0.0,
    drag_per_rad: 0.0,
    friction_rad_s2: 0.0,
    beside_sine: |_| 0.0,
    cycles: 30.0,
    rate_hz: 50.0,
    noise: 1e-3,
};

/// Angle and rate one step later, by Runge and Kutta's rule of order 4.
fn stepped([angle, rate]: [f64; 2], step_s: f64, pull: impl Fn(f64, f64) -> f64) -> [f64; 2] {
    let slope = |da: f64, dr: f64| (rate + dr, pull(angle + da, rate + dr));
    let half = 0.5 * step_s;
    let a = slope(0.0, 0.0);
    let b = slope(half * a.0, half * a.1);
    let c = slope(half * b.0, half * b.1);
    let d = slope(step_s * c.0, step_s * c.1);
    [
        angle + step_s * (a.0 + 2.0 * (b.0 + c.0) + d.0) / 6.0,
        rate + step_s * (a.1 + 2.0 * (b.1 + c.1) + d.1) / 6.0,
    ]
}

impl Motion {
    /// A table of the angle or the rate, with white noise.
    fn table(&self, column: &str, seed: &str) -> String {
        let omega = TAU / self.period_s;
        let step_s = self.period_s / 2000.0;
        let pull = |angle: f64, rate: f64| {
            -omega * omega * (angle.sin() + (self.beside_sine)(angle))
                - 2.0 * self.damping_per_s * rate
                - self.drag_per_rad * rate.abs() * rate
                - self.friction_rad_s2 * if rate == 0.0 { 0.0 } else { rate.signum() }
        };
        let mut draws = fresh(seed);
        let mut text = format!("t,{column}\n");
        let (mut angle, mut rate, mut t) = (self.angle_rad, 0.0, 0.0);
        let mut next = 0.0;
        while t < self.cycles * self.period_s {
            if t >= next {
                let noise: f64 = StandardNormal.sample(&mut draws);
                let value = if column == "angle" { angle } else { rate };
                text += &format!("{t:.6},{}\n", value + self.noise * noise);
                next += 1.0 / self.rate_hz;
            }
            // A turn that friction holds is not reached in these.
            [angle, rate] = stepped([angle, rate], step_s, pull);
            t += step_s;
        }
        text
    }

    fn bare(&self, column: &str, seed: &str) -> Measurement {
        let text = self.table(column, seed);
        let recording = read_recording(text.as_bytes(), "s.csv").unwrap();
        let analysis = measure_recording(&recording, &MeasureOptions::default()).unwrap();
        analysis.measurement
    }

    /// As a compound pendulum.
    fn compound(&self, column: &str, seed: &str) -> Measurement {
        let text = "format = \"gyradius-session/1\"\n[body]\n[site]\n\
            gravity = { value = 9.80665, u = 0.0 }\n[[swing]]\nid = \"s\"\nrecording = \"s.csv\"\n\
            excited = [\"pitch\"]\n[swing.suspension]\nkind = \"compound\"\n\
            orientation = \"athwartships\"\naxis_height = { value = 0.5, u = 0.001 }\n";
        of_text(text, &self.table(column, seed))
    }
}

/// A session of one recording.
fn of_text(text: &str, csv: &str) -> Measurement {
    let session = read_session(text, "session.toml").unwrap();
    let loaded = LoadedSession {
        session,
        source: "one motion".into(),
        data: vec![LoadedSwing {
            id: "s".into(),
            data: LoadedData::Recording(read_recording(csv.as_bytes(), "s.csv").unwrap()),
        }],
        inclines: vec![],
        assumed: vec![],
    };
    measure(&loaded, &MeasureOptions::default()).unwrap()
}

fn only_mode(result: &Measurement) -> &ModeResult {
    let [mode] = &result.swings[0].modes[..] else {
        panic!("{:?} {:?}", result.swings[0].modes, result.findings);
    };
    mode
}

/// The period within four standard errors of what it is, and these below a share of it.
fn check(name: &str, result: &Measurement, period_s: f64, most: f64) {
    let mode = only_mode(result);
    let (off, u) = ((mode.period_s - period_s).abs(), mode.period_se_s);
    assert!(off < 4.0 * u, "{name}: {} ± {u}", mode.period_s);
    assert!(u < most * period_s, "{name}: ± {u}");
}

/// What damps a pendulum does not move its period, whatever it is.
#[test]
fn any_damping_leaves_the_period() {
    let omega2 = (TAU / FREE.period_s).powi(2);
    let kinds = [
        ("none", FREE),
        (
            "linear",
            Motion {
                damping_per_s: 0.05,
                ..FREE
            },
        ),
        (
            "drag",
            Motion {
                drag_per_rad: 0.2,
                ..FREE
            },
        ),
        (
            "dry",
            Motion {
                friction_rad_s2: 2e-3 * omega2,
                ..FREE
            },
        ),
        (
            "all",
            Motion {
                damping_per_s: 0.01,
                drag_per_rad: 0.05,
                friction_rad_s2: 5e-4 * omega2,
                ..FREE
            },
        ),
    ];
    for (name, motion) in kinds {
        for column in ["angle", "rate"] {
            let name = format!("{name}, {column}");
            check(&name, &motion.compound(column, &name), 1.6, 1e-4);
            // Where the amplitude stays, only the shape of a cycle tells the law.
            check(&name, &motion.bare(column, &name), 1.6, 2e-3);
        }
    }
}

/// Damping ratios to 0.3: what is there lasts for a cycle or two.
#[test]
fn heavy_damping_is_measured() {
    for (ratio, most) in [(0.1, 3e-4), (0.2, 1e-3), (0.3, 3e-3)] {
        let motion = Motion {
            damping_per_s: ratio * TAU / FREE.period_s,
            cycles: 12.0,
            ..FREE
        };
        for column in ["angle", "rate"] {
            let name = format!("{ratio}, {column}");
            check(&name, &motion.compound(column, &name), 1.6, most);
        }
    }
}

/// Three periods are a measurement, with what it is worth.
#[test]
fn three_periods_are_enough() {
    let motion = Motion {
        damping_per_s: 0.02,
        cycles: 3.5,
        ..FREE
    };
    for column in ["angle", "rate"] {
        check(column, &motion.compound(column, "short"), 1.6, 2e-3);
    }
}

/// From 100° and from 150° it is one motion too, of the amplitude that it was released at.
#[test]
fn a_swing_of_any_width_is_one_motion() {
    for degrees in [30.0_f64, 100.0, 150.0] {
        let motion = Motion {
            angle_rad: degrees.to_radians(),
            damping_per_s: 0.003,
            cycles: 60.0,
            ..FREE
        };
        for column in ["angle", "rate"] {
            let name = format!("{degrees}°, {column}");
            let bare = motion.bare(column, &name);
            check(&name, &bare, 1.6, 1e-4);
            check(&name, &motion.compound(column, &name), 1.6, 3e-5);
            let amplitude = only_mode(&bare).amplitude.unwrap();
            let released = degrees.to_radians();
            // A few seconds at the start may not be used, in which it loses 1 %.
            assert!(
                (amplitude / released - 1.0).abs() < 0.05,
                "{name}: {amplitude}"
            );
        }
    }
}

/// What brings a body back need not be gravity: a spring, and a ship whose righting moment hardens.
#[test]
fn the_law_is_seen_in_the_motion() {
    type Law = fn(f64) -> f64;
    let laws: [(&str, Law); 2] = [
        ("spring", |angle| angle - angle.sin()),
        ("hardening", |angle| {
            angle + 0.75 * angle.powi(3) - angle.sin()
        }),
    ];
    for (name, beside_sine) in laws {
        let motion = Motion {
            beside_sine,
            angle_rad: 0.17,
            damping_per_s: 0.01,
            ..FREE
        };
        for column in ["angle", "rate"] {
            let name = format!("{name}, {column}");
            check(&name, &motion.bare(column, &name), 1.6, 1e-3);
        }
    }
}

/// Over many records the error is as large as it is said to be: the mean square of twenty deviations
/// in standard errors lies between 0.27 and 2.37 all but once in a thousand times (χ² of 20).
#[test]
fn uncertainties_are_those_of_the_errors() {
    let motion = Motion {
        friction_rad_s2: 0.01,
        damping_per_s: 0.01,
        cycles: 15.0,
        ..FREE
    };
    let squares = (0..20).map(|seed| {
        let result = motion.compound("rate", &format!("coverage {seed}"));
        let mode = only_mode(&result);
        ((mode.period_s - 1.6) / mode.period_se_s).powi(2)
    });
    let mean = squares.sum::<f64>() / 20.0;
    assert!((0.27..2.37).contains(&mean), "{mean}");
}

/// A phone that turns about an axis that none of its own is, by all three axes of its gyroscope.
#[test]
fn an_axis_across_the_phone_is_found() {
    let table = Motion {
        angle_rad: 80.0 * PI / 180.0,
        damping_per_s: 0.02,
        ..FREE
    }
    .table("rate", "axis");
    let mut draws = fresh("across");
    let mut text = String::from("t,gx,gy,gz\n");
    for line in table.lines().skip(1) {
        let (t, rate) = line.split_once(',').unwrap();
        let rate: f64 = rate.parse().unwrap();
        let mut read = |share: f64| {
            let noise: f64 = StandardNormal.sample(&mut draws);
            share * rate + 1e-3 * noise
        };
        let row = [read(0.48), read(-0.6), read(0.64)];
        text += &format!("{t},{},{},{}\n", row[0], row[1], row[2]);
    }
    let recording = read_recording(text.as_bytes(), "s.csv").unwrap();
    let analysis = measure_recording(&recording, &MeasureOptions::default()).unwrap();
    check("across", &analysis.measurement, 1.6, 1e-4);
}

const LINES_M: f64 = 1.2;
const HALF_SPACING_M: f64 = 0.2;
const GYRADIUS_M: f64 = 0.29;
const GRAVITY: f64 = 9.80665;

/// Yaw on two parallel lines, which lift the body as it turns, with friction in it: the rate by Runge
/// and Kutta's rule, steps of 2 ms. θ'' (k² + z'²) = −z' z'' θ'² − g z' − k² (2αθ' + c sgn θ').
fn yaw_table(angle_rad: f64, friction_rad_s2: f64, factor: f64, seed: &str) -> String {
    const STEP_S: f64 = 2e-3;
    let square = HALF_SPACING_M * HALF_SPACING_M;
    let acceleration = |angle: f64, rate: f64| {
        let height = (LINES_M.powi(2) - 2.0 * square * (1.0 - angle.cos())).sqrt();
        let lift = square * angle.sin() / height;
        let bend = square * angle.cos() / height + lift * lift / height;
        // sgn by a steep slope, as the body comes to rest.
        let friction = friction_rad_s2 * (rate / 1e-3).tanh();
        let lost = GYRADIUS_M.powi(2) * (0.01 * rate + friction);
        (-lost - lift * bend * rate * rate - GRAVITY * lift) / (GYRADIUS_M.powi(2) + lift * lift)
    };
    let mut draws = fresh(seed);
    let mut noise = || -> f64 {
        let draw: f64 = StandardNormal.sample(&mut draws);
        1e-3 * draw
    };
    let mut text = String::from("t,gx,gy,gz\n");
    let (mut angle, mut rate) = (angle_rad, 0.0);
    for i in 0..30_000 {
        if i % 5 == 0 {
            let t = STEP_S * f64::from(i);
            let row = [noise(), noise(), rate + noise()].map(|read| factor * read);
            text += &format!("{t:.3},{},{},{}\n", row[0], row[1], row[2]);
        }
        [angle, rate] = stepped([angle, rate], STEP_S, acceleration);
    }
    text
}

fn on_lines(csv: &str) -> Measurement {
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\n[site]\n\
         gravity = {{ value = {GRAVITY}, u = 0.0 }}\n[[swing]]\nid = \"s\"\nrecording = \"s.csv\"\n\
         excited = [\"yaw\"]\n[swing.suspension]\nkind = \"bifilar\"\n\
         orientation = \"athwartships\"\nline_length = {{ value = {LINES_M}, u = 0.001 }}\n\
         spacing = {{ value = {:?}, u = 0.0005 }}\n",
        2.0 * HALF_SPACING_M
    );
    of_text(&text, csv)
}

/// Dry friction bends the decay, and the hull comes to rest in the record: damped oscillations make
/// two lines of it that no suspension has.
#[test]
fn yaw_with_dry_friction_is_one_motion() {
    for (angle_rad, friction) in [(0.3, 0.0), (0.3, 0.006), (0.12, 0.006), (0.9, 0.01)] {
        let csv = yaw_table(
            angle_rad,
            friction,
            1.0,
            &format!("yaw {angle_rad} {friction}"),
        );
        let result = on_lines(&csv);
        let k_yaw = result.quantities.get(&QuantityName::KYaw).unwrap();
        let (k, u) = (k_yaw.value.scalar().unwrap(), k_yaw.u.scalar().unwrap());
        let off = (k - GYRADIUS_M).abs();
        let name = format!("{angle_rad} rad, {friction} rad/s²: {k} ± {u}");
        assert!(off < 3.0 * u && u < 0.004 * GYRADIUS_M, "{name}");
    }
}

/// One degree written in deg/s reads as 57°, and its period does not grow as that of two lines does.
#[test]
fn yaw_in_degrees_per_second_is_seen_in_the_motion_itself() {
    let units = |result: &Measurement| -> Vec<Severity> {
        let found = result.findings.iter();
        let found = found.filter(|one| one.kind == FindingKind::UnitSuspect);
        found.map(|one| one.severity).collect()
    };
    let degrees = 180.0 / PI;
    let wrong = on_lines(&yaw_table(1.0 / degrees, 0.0, degrees, "yaw in degrees"));
    assert_eq!(units(&wrong), [Severity::Refused], "{:?}", wrong.findings);
    assert!(wrong.quantities.is_empty());
    let right = on_lines(&yaw_table(57.0 / degrees, 0.0, 1.0, "yaw by much"));
    assert_eq!(units(&right), []);
}
