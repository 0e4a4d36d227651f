//! The live estimator on swings in closed form and on a simulated hull: honest at every moment, and
//! quick to tell.
#![allow(clippy::unwrap_used, clippy::panic)]

use crate::swings::{GRAVITY_M_S2, Oscillation, Scene};
use gyradius_base::Error;
use gyradius_base::language::Language;
use gyradius_base::message::{Argument, texts};
use gyradius_recording::{Sensor, read_recording};
use gyradius_signal::online::{
    Advice, Estimate, LineKind, Live, LiveOptions, SwingState, TimeLeft,
};
use gyradius_signal::{ChannelGroup, DecomposeOptions, Decomposition, decompose, free_swing_span};
use gyradius_simulator::{practise, read_rig};
use gyradius_test_support::{fresh, seed};
use std::collections::BTreeMap;

use rand::{Rng, RngExt};

/// A batch as a phone gives it, s.
const BATCH_S: f64 = 0.2;
/// Stamps count from some time after the phone was switched on, ns.
const BOOT_NS: i64 = 7_000_000_000_000;

fn live(wanted: f64) -> Live {
    Live::new(LiveOptions {
        wanted,
        ..LiveOptions::default()
    })
    .unwrap()
}

/// Both sensors' samples of a span.
fn samples(
    scene: &Scene,
    from_s: f64,
    to_s: f64,
    rng: &mut impl Rng,
) -> [(Vec<i64>, Vec<[f64; 3]>); 2] {
    let gyroscope = Scene::stamps(scene.gyroscope_hz, from_s, to_s, rng);
    let turned = gyroscope
        .iter()
        .map(|&ns| scene.gyroscope(ns as f64 / 1e9, rng))
        .collect();
    let accelerometer = Scene::stamps(scene.accelerometer_hz, from_s, to_s, rng);
    let felt = accelerometer
        .iter()
        .map(|&ns| scene.accelerometer(ns as f64 / 1e9, rng))
        .collect();
    let boot = |stamps: Vec<i64>| stamps.into_iter().map(|ns| ns + BOOT_NS).collect();
    [(boot(gyroscope), turned), (boot(accelerometer), felt)]
}

/// Feeds a span, telling every new estimate.
fn feed(
    live: &mut Live,
    scene: &Scene,
    (from_s, to_s): (f64, f64),
    rng: &mut impl Rng,
    mut told: impl FnMut(&Estimate, &[(Vec<i64>, Vec<[f64; 3]>); 2]),
) {
    for i in 0..((to_s - from_s) / BATCH_S).round() as i32 {
        let at_s = from_s + BATCH_S * f64::from(i);
        let batch = samples(scene, at_s, at_s + BATCH_S, rng);
        for (sensor, (stamps, values)) in [Sensor::Gyroscope, Sensor::Accelerometer]
            .into_iter()
            .zip(&batch)
        {
            live.push(sensor, stamps, values).unwrap();
        }
        told(&live.estimate(), &batch);
    }
}

fn fed(scene: &Scene, to_s: f64, rng: &mut impl Rng) -> Live {
    let mut live = live(1e-4);
    feed(&mut live, scene, (0.0, to_s), rng, |_, _| {});
    live
}

/// A quiet swing with a period of 4 s, 6 degrees, dying with a time constant of 200 s.
fn plain(rng: &mut impl Rng) -> Scene {
    let scene = Scene::draw(rng);
    let turn = Oscillation {
        omega_rad_s: std::f64::consts::TAU / 4.0,
        alpha_per_s: 1.0 / 200.0,
        angle_rad: 6_f64.to_radians(),
        phase: 1.0,
        softening: 0.0,
    };
    Scene {
        turn,
        gyroscope_hz: 100.0,
        accelerometer_hz: 50.0,
        ..scene
    }
}

/// One draw: everything told, and the whole record's own analysis.
struct Run {
    told: Vec<SwingState>,
    /// Absent where the whole record's analysis finds no swing.
    period_s: Option<f64>,
    span_s: f64,
    false_alarms: usize,
}

impl Run {
    fn of(scene: &Scene, span_s: f64, wanted: f64, rng: &mut impl Rng) -> Self {
        let mut live = live(wanted);
        let mut groups = [empty(), empty()];
        let mut told: Vec<SwingState> = Vec::new();
        let mut false_alarms = 0;
        feed(&mut live, scene, (0.0, span_s), rng, |estimate, batch| {
            for (group, (stamps, values)) in groups.iter_mut().zip(batch) {
                group
                    .t_s
                    .extend(stamps.iter().map(|ns| (ns - BOOT_NS) as f64 / 1e9));
                for (axis, channel) in group.channels.iter_mut().enumerate() {
                    channel.extend(values.iter().map(|value| value[axis]));
                }
            }
            if let Some(swing) = estimate
                .swing
                .iter()
                .find(|new| told.last().is_none_or(|l| l.at_s != new.at_s))
            {
                told.push(swing.clone());
            }
            let alarm = |advice: &Advice| {
                matches!(advice, Advice::Touched { .. } | Advice::PhoneMoved { .. })
            };
            false_alarms = estimate
                .advice
                .iter()
                .filter(|advice| alarm(advice))
                .count();
        });
        let period_s = whole(&groups).map(|found| nearest(&found, scene.turn.period_s()));
        Self {
            told,
            period_s,
            span_s,
            false_alarms,
        }
    }

    /// Deviation from the final period in stated uncertainties, at the first estimate from a part
    /// of the record on.
    fn deviation(&self, part: f64) -> Option<f64> {
        let at = self
            .told
            .iter()
            .find(|swing| swing.at_s >= part * self.span_s)?;
        Some((at.period_s - self.period_s?) / at.period_u_s)
    }

    /// Errors of the forecasts of the moment when the wanted uncertainty was reached, over the time
    /// that was left.
    fn forecast_errors(&self) -> Vec<f64> {
        let reached = self
            .told
            .iter()
            .find(|swing| swing.time_left == TimeLeft::Reached);
        let Some(reached_s) = reached.map(|swing| swing.at_s) else {
            return Vec::new();
        };
        let left = |swing: &SwingState| match swing.time_left {
            TimeLeft::Seconds(left_s) => Some(left_s / (reached_s - swing.at_s) - 1.0),
            TimeLeft::Reached | TimeLeft::OutOfReach => None,
        };
        self.told
            .iter()
            .take_while(|swing| swing.at_s < reached_s)
            .filter_map(left)
            .collect()
    }
}

/// The whole record's own analysis: the free swing, and what is in it.
fn whole(groups: &[ChannelGroup]) -> Option<Decomposition> {
    let span = free_swing_span(groups);
    let inside = |group: &ChannelGroup| {
        let first = group.t_s.partition_point(|t| *t < span.start_s);
        let end = group.t_s.partition_point(|t| *t <= span.end_s);
        let channels = group
            .channels
            .iter()
            .map(|channel| channel[first..end].to_vec());
        ChannelGroup {
            t_s: group.t_s[first..end].to_vec(),
            channels: channels.collect(),
        }
    };
    let groups: Vec<ChannelGroup> = groups.iter().map(inside).collect();
    decompose(&groups, &DecomposeOptions::default()).ok()
}

fn empty() -> ChannelGroup {
    ChannelGroup {
        t_s: Vec::new(),
        channels: vec![Vec::new(); 3],
    }
}

fn nearest(found: &Decomposition, period_s: f64) -> f64 {
    let periods = found.modes.iter().map(|mode| mode.period_s());
    periods
        .min_by(|a, b| (a - period_s).abs().total_cmp(&(b - period_s).abs()))
        .unwrap()
}

/// Least relative uncertainty of a period after a time: the Cramér–Rao bound of a sinusoid's
/// frequency with unknown phase, 24 σ²/(A² f T³) (Kay 1993, Estimation Theory, example 3.14), by
/// the gyroscope alone.
fn bound(scene: &Scene, span_s: f64) -> f64 {
    let rate_rad_s = scene.turn.angle_rad * scene.turn.omega_rad_s;
    let variance = 24.0 * (scene.gyroscope_noise_rad_s / rate_rad_s).powi(2)
        / (scene.gyroscope_hz * span_s.powi(3));
    variance.sqrt() / scene.turn.omega_rad_s
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// 200 fresh swings, half of them with sway of 1 to 15 %: within twice the stated uncertainty of
/// the final period at six moments each. A program whose figure holds 95.4 % of the time misses
/// more than 22 of 200 less than once in 15 000 (binomial), six moments together less than once in
/// 2000.
#[test]
fn the_live_period_agrees_with_the_final_one_and_the_forecast_is_right() {
    let mut rng = fresh("coverage");
    let mut misses = [0; 6];
    let (mut errors, mut alarms, mut unknown) = (Vec::new(), 0, 0);
    for i in 0..200 {
        let mut scene = Scene::draw(&mut rng);
        if i % 2 == 1 {
            let share = rng.random_range(0.01..0.15);
            scene = scene.with_sway(&mut rng, share);
        }
        let span_s = rng.random_range(60.0..120.0);
        let wanted = bound(&scene, span_s * rng.random_range(0.4..0.7));
        let run = Run::of(&scene, span_s, wanted, &mut rng);
        for (part, misses) in misses.iter_mut().enumerate() {
            let deviation = run.deviation(part as f64 / 6.0);
            *misses += usize::from(deviation.is_some_and(|z| z.abs() > 2.0));
        }
        alarms += usize::from(run.false_alarms > 0);
        unknown += usize::from(run.period_s.is_none());
        let wrong: Vec<f64> = run.forecast_errors().into_iter().map(f64::abs).collect();
        if !wrong.is_empty() {
            errors.push(median(wrong));
        }
    }
    let forecasts = errors.len();
    let error = median(errors);
    println!(
        "misses {misses:?} of 200; forecasts of {forecasts} swings off by {error:.3} in the median; {alarms} alarms"
    );
    assert!(misses.iter().all(|&misses| misses <= 22), "{misses:?}");
    assert!(forecasts >= 50 && unknown <= 20);
    assert!(error <= 0.2);
    // Nobody touched anything. A program that cries wolf in 2 swings of 100 does so in more than 12
    // of 200 less than once in 1000 runs.
    assert!(alarms <= 12, "{alarms} false alarms");
}

/// A simulated hull with yaw and sway, its own phone and noise: the live period against the whole
/// record's. The moments of a record share most of their samples: a tenth of them is a few looks
/// that know nothing of one another, and one beyond twice its uncertainty takes many with it.
/// Beyond four times it is one look in 16 000.
#[test]
fn a_simulated_hull_is_followed() {
    let rig = include_str!("../../../../../python/gyradius/rigs/keelboat.toml");
    let rig = read_rig(
        &rig.replace("[truth]\n", "[truth]\nduration_s = 120.0\n"),
        "rig.toml",
    )
    .unwrap();
    let practised = practise(&rig, seed("keelboat")).unwrap();
    for (name, bytes) in &practised.recordings {
        let recording = read_recording(bytes, name).unwrap();
        let sensors = [
            (Sensor::Gyroscope, recording.gyroscope),
            (Sensor::Accelerometer, recording.accelerometer),
        ];
        let sensors = sensors.map(|(sensor, triad)| (sensor, triad.unwrap()));
        let groups = sensors.clone().map(|(_, triad)| ChannelGroup {
            t_s: triad.t_s,
            channels: triad.axes.to_vec(),
        });
        let found = whole(&groups).unwrap();
        let mut live = live(1e-4);
        let (mut moments, mut within) = (0, 0);
        for i in 0..600 {
            for (sensor, triad) in &sensors {
                let place = |k: i32| triad.t_s.partition_point(|t| *t < f64::from(k) * BATCH_S);
                let rows = place(i)..place(i + 1);
                let stamps: Vec<i64> = rows
                    .clone()
                    .map(|k| (triad.t_s[k] * 1e9).round() as i64)
                    .collect();
                let values: Vec<[f64; 3]> = rows
                    .map(|k| [0, 1, 2].map(|axis| triad.axes[axis][k]))
                    .collect();
                live.push(*sensor, &stamps, &values).unwrap();
            }
            if let Some(swing) = live.estimate().swing {
                let off = swing.period_s - nearest(&found, swing.period_s);
                moments += 1;
                within += usize::from(off.abs() <= 4.0 * swing.period_u_s);
            }
        }
        println!("{name}: {within} of {moments} moments within four times the uncertainty");
        assert!(
            moments > 300 && within as f64 >= 0.9 * f64::from(moments),
            "{name}"
        );
    }
}

#[test]
fn amplitude_and_decay_are_those_of_the_closed_form() {
    let mut rng = fresh("amplitude");
    let scene = plain(&mut rng);
    let swing = fed(&scene, 120.0, &mut rng).estimate().swing.unwrap();
    let expected = 6.0 * (-swing.at_s / 200.0).exp();
    assert!(
        (swing.amplitude_deg.unwrap() / expected - 1.0).abs() < 0.02,
        "{swing:?}"
    );
    assert!((swing.decay_per_s * 200.0 - 1.0).abs() < 0.05, "{swing:?}");
    assert!(
        (swing.half_s.unwrap() / (200.0 * std::f64::consts::LN_2) - 1.0).abs() < 0.05,
        "{swing:?}"
    );
    assert!(swing.period_noise_u_s <= swing.period_u_s && swing.lines.is_empty());
}

#[test]
fn sway_is_told_by_its_share_of_the_turn() {
    let mut rng = fresh("sway");
    let mut scene = plain(&mut rng);
    let omega_rad_s = std::f64::consts::TAU / 3.4;
    scene.sway = Some(Oscillation {
        omega_rad_s,
        angle_rad: 0.06 * scene.turn.angle_rad,
        ..scene.turn
    });
    let estimate = fed(&scene, 60.0, &mut rng).estimate();
    let [line] = estimate.swing.unwrap().lines[..] else {
        panic!("not one line")
    };
    assert_eq!(line.kind, LineKind::Sway);
    assert!(
        (line.share / 0.06 - 1.0).abs() < 0.08 && (line.period_s - 3.4).abs() < 0.02,
        "{line:?}"
    );
    let told: Vec<String> = estimate
        .advice
        .iter()
        .map(|advice| advice.message().english)
        .collect();
    let sentence = format!(
        "Sway (period {:.2} s) is 6 % of the main motion: steady the hull and release it again.",
        line.period_s
    );
    assert!(told.contains(&sentence), "{told:?}");
}

#[test]
fn a_touch_is_told_with_its_moment_and_the_swing_before_it_is_kept() {
    let mut rng = fresh("touch");
    let scene = plain(&mut rng);
    let mut live = live(1e-5);
    feed(&mut live, &scene, (0.0, 41.0), &mut rng, |estimate, _| {
        assert!(
            !estimate
                .advice
                .iter()
                .any(|advice| matches!(advice, Advice::Touched { .. }))
        );
    });
    let mut after = scene.clone();
    after.turn.phase += 1.2;
    after.turn.angle_rad *= 0.8;
    feed(&mut live, &after, (41.0, 75.0), &mut rng, |_, _| {});
    let estimate = live.estimate();
    let touched = estimate.advice.iter().find_map(|advice| match advice {
        Advice::Touched { at_s } => Some(*at_s),
        _ => None,
    });
    // Within a period: the rule of the whole record judges blocks of a cycle and a half.
    assert!(
        (touched.unwrap() - 41.0).abs() < 4.0,
        "{:?}",
        estimate.advice
    );
    let period_s = estimate.swing.unwrap().period_s;
    assert!((period_s - 4.0).abs() < 0.01, "{period_s}");
}

#[test]
fn a_phone_that_slips_is_told_with_its_tilt() {
    let mut rng = fresh("slip");
    let scene = plain(&mut rng);
    let mut live = live(1e-5);
    feed(&mut live, &scene, (0.0, 50.0), &mut rng, |_, _| {});
    let tilt = 6_f64.to_radians();
    let mut after = scene.clone();
    for i in 0..3 {
        after.up[i] = scene.up[i] * tilt.cos() + scene.across[i] * tilt.sin();
        after.axis[i] = after.up[i];
    }
    feed(&mut live, &after, (50.0, 90.0), &mut rng, |_, _| {});
    let advice = live.estimate().advice;
    let moved = advice.iter().find_map(|advice| match advice {
        Advice::PhoneMoved { at_s, tilt_deg } => Some((*at_s, *tilt_deg)),
        _ => None,
    });
    let (at_s, tilt_deg) = moved.unwrap();
    assert!(
        (at_s - 50.0).abs() < 4.0 && (tilt_deg - 6.0).abs() < 1.0,
        "{advice:?}"
    );
    assert!(
        !advice
            .iter()
            .any(|advice| matches!(advice, Advice::Touched { .. })),
        "{advice:?}"
    );
}

/// A mean over three periods of the turn holds one and a half of a sway that is twice as slow:
/// gravity seems to come and go.
#[test]
fn a_sway_twice_as_slow_as_the_turn_is_no_phone_that_slips() {
    let mut rng = fresh("slow sway");
    let scene = plain(&mut rng);
    let turn = Oscillation {
        omega_rad_s: std::f64::consts::TAU / 2.0,
        ..scene.turn
    };
    let sway = Oscillation {
        omega_rad_s: std::f64::consts::TAU / 4.1,
        angle_rad: 9_f64.to_radians(),
        phase: rng.random_range(0.0..std::f64::consts::TAU),
        ..scene.turn
    };
    let scene = Scene {
        turn,
        sway: Some(sway),
        ..scene
    };
    let live = fed(&scene, 120.0, &mut rng);
    let advice = live.estimate().advice;
    assert!(
        !advice
            .iter()
            .any(|advice| matches!(advice, Advice::PhoneMoved { .. })),
        "{advice:?}"
    );
}

#[test]
fn rates_gaps_and_silence_are_told() {
    let mut live = live(1e-4);
    let stamps: Vec<i64> = (0..2000)
        .filter(|i| !(500..550).contains(i))
        .map(|i| i * 5_000_000)
        .collect();
    let values: Vec<[f64; 3]> = (0..stamps.len()).map(|i| [i as f64; 3]).collect();
    live.push(Sensor::Gyroscope, &stamps, &values).unwrap();
    live.push(
        Sensor::Gyroscope,
        &[stamps[1949], stamps[0]],
        &[[0.0; 3]; 2],
    )
    .unwrap();
    live.push(
        Sensor::Gyroscope,
        &[stamps[1949] + 5_000_000],
        &[[f64::NAN, 0.0, 0.0]],
    )
    .unwrap();
    let few: Vec<i64> = (0..100).map(|i| i * 10_000_000).collect();
    live.push(
        Sensor::Accelerometer,
        &few,
        &vec![[0.0, 0.0, GRAVITY_M_S2]; 100],
    )
    .unwrap();
    let estimate = live.estimate();
    let [gyroscope, accelerometer] = estimate.sensors[..] else {
        panic!("two sensors")
    };
    assert!((gyroscope.rate_hz.unwrap() - 200.0).abs() < 1e-9);
    assert_eq!(
        (gyroscope.samples, gyroscope.left_out, gyroscope.gaps),
        (1950, 3, 1)
    );
    // 50 samples are missing between 499 and 550: 51 intervals of 5 ms.
    assert!((gyroscope.longest_gap_s - 0.255).abs() < 1e-9);
    assert!((accelerometer.rate_hz.unwrap() - 100.0).abs() < 1e-9);
    assert_eq!(
        estimate.advice[0],
        Advice::SensorSilent {
            sensor: Sensor::Accelerometer,
            since_s: Some(0.99)
        }
    );
    let gaps = Advice::Gaps {
        sensor: Sensor::Gyroscope,
        gaps: 1,
        longest_s: gyroscope.longest_gap_s,
    };
    assert!(estimate.advice.contains(&gaps));
    let [gap] = estimate.gaps.listed[..] else {
        panic!("one gap: {:?}", estimate.gaps)
    };
    assert_eq!(
        (gap.sensor, gap.length_s),
        (Sensor::Gyroscope, gyroscope.longest_gap_s)
    );
    assert!((gap.from_s - 2.495).abs() < 1e-9);
}

/// One sample in ten is missing for a hundred seconds, three in a row at the two moments told.
#[test]
fn gaps_are_listed_by_time_and_where_they_are_too_many_the_longest() {
    let mut live = live(1e-4);
    let is_long = |i: i64, at: i64| (at..at + 3).contains(&i);
    for (sensor, at) in [(Sensor::Gyroscope, 5_003), (Sensor::Accelerometer, 3_003)] {
        let stamps: Vec<i64> = (0..10_000)
            .filter(|&i| i % 10 != 9 && !is_long(i, at))
            .map(|i| i * 10_000_000)
            .collect();
        live.push(
            sensor,
            &stamps,
            &vec![[0.0, 0.0, GRAVITY_M_S2]; stamps.len()],
        )
        .unwrap();
    }
    let estimate = live.estimate();
    let gaps = &estimate.gaps;
    assert_eq!(gaps.listed.len(), 200);
    assert_eq!(
        gaps.listed.len() as u64 + gaps.more,
        estimate.sensors.iter().map(|one| one.gaps).sum::<u64>()
    );
    assert!(gaps.listed.is_sorted_by(|a, b| a.from_s <= b.from_s));
    let long: Vec<(Sensor, f64)> = gaps
        .listed
        .iter()
        .filter(|gap| gap.length_s > 0.03)
        .map(|gap| (gap.sensor, gap.from_s))
        .collect();
    assert_eq!(
        long,
        [(Sensor::Accelerometer, 30.02), (Sensor::Gyroscope, 50.02)]
    );
}

/// A sinusoid cut off at its limit, with the limit stated and without; and one that rests at its
/// peaks by resolution.
#[test]
fn saturation_is_seen_by_the_stated_range_or_by_the_samples_alone() {
    let sine = |i: i64| 3.0 * (0.02 * i as f64).sin();
    let cut = |i: i64| sine(i).clamp(-2.0, 2.0);
    let coarse = |i: i64| (sine(i) * 8.0).round() / 8.0;
    let at_limit = (0..3000).filter(|&i| sine(i).abs() >= 1.998).count() as u64;
    let saturated = |full_scale: Option<f64>, signal: &dyn Fn(i64) -> f64| {
        let options = LiveOptions {
            gyroscope_full_scale_rad_s: full_scale,
            ..LiveOptions::default()
        };
        let mut live = Live::new(options).unwrap();
        let stamps: Vec<i64> = (0..3000).map(|i| i * 10_000_000).collect();
        let values: Vec<[f64; 3]> = (0..3000).map(|i| [signal(i), 0.1, 0.2]).collect();
        live.push(Sensor::Gyroscope, &stamps, &values).unwrap();
        live.estimate().sensors[0].saturated
    };
    assert_eq!(saturated(Some(2.0), &cut), at_limit);
    assert!(saturated(None, &cut) > at_limit / 3);
    assert_eq!(saturated(None, &sine), 0);
    assert_eq!(saturated(None, &coarse), 0);
}

#[test]
fn what_does_not_fit_is_refused() {
    let refused = Live::new(LiveOptions {
        wanted: 0.0,
        ..LiveOptions::default()
    })
    .unwrap_err();
    assert!(matches!(refused, Error::Argument { .. }), "{refused}");
    let mut live = live(1e-4);
    assert!(matches!(
        live.push(Sensor::Gyroscope, &[1], &[]),
        Err(Error::Argument { .. })
    ));
    assert!(matches!(
        live.push(Sensor::Timer, &[1], &[[0.0; 3]]),
        Err(Error::Argument { .. })
    ));
    assert_eq!(live.estimate().swing, None);
}

/// Every kind of advice has its sentence, and every name in a sentence its value.
#[test]
fn all_advice_is_said() {
    let sensor = Sensor::Gyroscope;
    let line = |kind| Advice::Unwanted {
        kind,
        share: 0.06,
        period_s: 3.8,
    };
    let all = [
        Advice::SensorSilent {
            sensor,
            since_s: Some(12.0),
        },
        Advice::SensorSilent {
            sensor,
            since_s: None,
        },
        Advice::PhoneMoved {
            at_s: 41.0,
            tilt_deg: 5.0,
        },
        Advice::Touched { at_s: 41.0 },
        Advice::Saturated { sensor, samples: 7 },
        Advice::Gaps {
            sensor,
            gaps: 2,
            longest_s: 0.25,
        },
        Advice::AmplitudeLow { amplitude_deg: 1.9 },
        line(LineKind::Sway),
        line(LineKind::OtherTurn),
        line(LineKind::SameTurn),
        Advice::OutOfReach,
        Advice::LongEnough,
    ];
    let mut keys: Vec<String> = all.iter().map(|one| one.message().key).collect();
    keys.sort_unstable();
    for language in Language::ALL {
        let known: BTreeMap<String, String> = texts(language)
            .into_iter()
            .filter_map(|(id, text)| Some((id.strip_prefix("live-")?.to_owned(), text)))
            .collect();
        let named = known.keys().map(|id| format!("live.{id}"));
        assert_eq!(keys, named.collect::<Vec<_>>());
        for advice in &all {
            let message = advice.message();
            let text = message.in_language(language);
            assert!(!text.contains(['{', '}']), "{text}");
            let sentence = &known[message.key.trim_start_matches("live.")];
            assert!(
                message
                    .arguments
                    .keys()
                    .all(|name| sentence.contains(&format!("{{{name}}}"))),
                "{text}"
            );
        }
    }
    assert_eq!(
        all[3].message().english,
        "Something touched the hull at 41 s: let it swing freely, or release it again."
    );
    assert_eq!(
        all[5].message().in_language(Language::German),
        "Der Drehratensensor hat 2 Lücken, die längste von 0,25 s: andere Apps schließen und den Bildschirm anlassen."
    );
    assert_eq!(
        all[3].message().arguments["at_s"],
        Argument::Number(41.0, 0)
    );
}
