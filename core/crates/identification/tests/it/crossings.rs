//! Around the global fit: the free span, windows against amplitude, crossings, gates, beats, lists
//! of periods.
//!
//! Expected values are closed forms or the paper's; the records are drawn here, with nothing of the
//! crate.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use gyradius_identification::routes::beat::period_ratio;
use gyradius_recording::{GateEvents, PeriodList};
use gyradius_signal::{
    ChannelGroup, PeriodLaw, Pole, SpanNoteKind, WindowPoint, WindowedMode, against_amplitude,
    beat_count, crossing_periods, fit_period_trend, free_swing_span, gate_periods,
    period_from_crossings, period_from_list, small_amplitude_limit, undisturbed_span,
    zero_crossings,
};
use gyradius_test_support::rng;
use num_complex::Complex64;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{PI, TAU};

fn normal(rng: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(rng)
}

/// A damped oscillation seen by six channels, three of a gyroscope and three of an accelerometer.
#[derive(Clone, Debug)]
struct Swing {
    period_s: f64,
    tau_s: f64,
    gain: [f64; 6],
    phase: f64,
}

impl Swing {
    fn at(&self, channel: usize, t: f64) -> f64 {
        if t < 0.0 {
            return 0.0;
        }
        self.gain[channel] * (-t / self.tau_s).exp() * (TAU * t / self.period_s + self.phase).sin()
    }
}

/// What a phone writes of `motion(channel, t)`: gravity on channel 5, noise, uneven stamps, two
/// clocks.
fn phone(
    rng: &mut ChaCha8Rng,
    duration_s: f64,
    motion: &dyn Fn(usize, f64) -> f64,
) -> Vec<ChannelGroup> {
    let sigma = [0.002, 0.02];
    (0..2)
        .map(|sensor| {
            let (mut t, mut t_s, mut channels) =
                (0.003 * sensor as f64, Vec::new(), vec![Vec::new(); 3]);
            while t < duration_s {
                t_s.push(t);
                for (axis, x) in channels.iter_mut().enumerate() {
                    let level = if sensor == 1 && axis == 2 { 9.81 } else { 0.01 };
                    x.push(level + motion(3 * sensor + axis, t) + sigma[sensor] * normal(rng));
                }
                t += 0.01 * (1.0 + 0.05 * (rng.random::<f64>() - 0.5));
            }
            ChannelGroup { t_s, channels }
        })
        .collect()
}

fn random_swing(rng: &mut ChaCha8Rng, period_s: f64, size: f64) -> Swing {
    let mut gain = [0.0; 6];
    for (c, g) in gain.iter_mut().enumerate() {
        *g = size * normal(rng) * if c < 3 { 1.0 } else { 2.0 };
    }
    Swing {
        period_s,
        tau_s: 40.0 + 600.0 * rng.random::<f64>(),
        gain,
        phase: TAU * rng.random::<f64>(),
    }
}

fn span_is_whole(groups: &[ChannelGroup], what: &str) {
    let span = free_swing_span(groups);
    let last = groups
        .iter()
        .map(|g| *g.t_s.last().unwrap())
        .fold(0.0, f64::max);
    assert!(
        span.notes.is_empty() && span.start_s == 0.0 && span.end_s == last,
        "{what}: {span:?}"
    );
}

#[test]
fn full_beats_of_thirty_seconds_are_not_cut() {
    let mut rng = rng();
    for _ in 0..20 {
        let first = random_swing(&mut rng, 4.39, 0.2);
        // The paper's Fig. 3 pair, equal in every channel: 100 % modulation, 30 s.
        let second = Swing {
            period_s: 3.83,
            phase: TAU * rng.random::<f64>(),
            ..first.clone()
        };
        let groups = phone(&mut rng, 120.0, &|c, t| first.at(c, t) + second.at(c, t));
        span_is_whole(&groups, "beats");
    }
}

#[test]
fn free_swings_of_any_periods_are_kept_whole() {
    let mut rng = rng();
    for _ in 0..60 {
        let period_s = 1.0 + 4.0 * rng.random::<f64>();
        let size = 0.3 * 10f64.powf(-1.5 * rng.random::<f64>());
        let mut swings = vec![random_swing(&mut rng, period_s, size)];
        for _ in 0..(rng.random::<u32>() % 4) {
            let near = if rng.random::<bool>() {
                1.0 + 0.06 * normal(&mut rng)
            } else {
                0.4 + 1.2 * rng.random::<f64>()
            };
            let share = 10f64.powf(-2.0 * rng.random::<f64>());
            swings.push(random_swing(
                &mut rng,
                period_s * near.max(0.2),
                size * share,
            ));
        }
        let duration = 60.0 + 100.0 * rng.random::<f64>();
        let groups = phone(&mut rng, duration, &|c, t| {
            swings.iter().map(|s| s.at(c, t)).sum()
        });
        span_is_whole(&groups, &format!("{swings:?}"));
    }
}

/// A hull held and slowly pulled aside, with a trembling hand, then let go at `release_s`.
fn held_then_released(
    rng: &mut ChaCha8Rng,
    release_s: f64,
    swing: Swing,
) -> impl Fn(usize, f64) -> f64 + use<> {
    let wobble: Vec<[f64; 3]> = (0..18)
        .map(|_| {
            [
                0.3 + 3.0 * rng.random::<f64>(),
                TAU * rng.random::<f64>(),
                0.1 * normal(rng),
            ]
        })
        .collect();
    let hand_s = (0.3 + 8.0 * rng.random::<f64>()).min(release_s);
    move |c, t| {
        if t >= release_s {
            return swing.at(c, t - release_s);
        }
        let s = (t - (release_s - hand_s)) / hand_s;
        if s < 0.0 {
            return 0.0;
        }
        let size =
            swing.gain.iter().map(|g| g.abs()).fold(0.0, f64::max) * if c < 3 { 0.5 } else { 1.0 };
        let shake: f64 = wobble[3 * c..3 * c + 3]
            .iter()
            .map(|[f, p, a]| a * (TAU * f * t + p).sin())
            .sum();
        size * ((PI * s).sin() * 0.2 + shake)
    }
}

#[test]
fn waiting_and_handling_before_the_release_are_left_out() {
    let mut rng = rng();
    for _ in 0..40 {
        let release_s = 0.5 + 19.5 * rng.random::<f64>();
        let period_s = 1.2 + 3.5 * rng.random::<f64>();
        let swing = random_swing(&mut rng, period_s, 0.15);
        let motion = held_then_released(&mut rng, release_s, swing);
        let groups = phone(&mut rng, release_s + 110.0, &motion);
        let span = free_swing_span(&groups);
        let late = span.start_s - release_s;
        assert!(
            late > -0.3 * period_s && late < 1.5 * period_s,
            "release {release_s}, T {period_s}: {span:?}"
        );
        assert!(span.end_s > release_s + 109.9, "{span:?}");
    }
}

#[test]
fn a_stop_and_a_phone_picked_up_end_the_span() {
    let mut rng = rng();
    for _ in 0..40 {
        let stop_s = 60.0 + 40.0 * rng.random::<f64>();
        let period_s = 1.2 + 3.5 * rng.random::<f64>();
        let swing = random_swing(&mut rng, period_s, 0.15);
        let turn: Vec<f64> = (0..6).map(|_| normal(&mut rng)).collect();
        let motion = |c: usize, t: f64| {
            let picked = (t - stop_s - 3.0).clamp(0.0, 4.0);
            if t < stop_s {
                swing.at(c, t)
            } else {
                turn[c] * (3.0 * picked).sin() * if c < 3 { 1.0 } else { 5.0 }
            }
        };
        let groups = phone(&mut rng, stop_s + 8.0, &motion);
        let span = free_swing_span(&groups);
        assert!(
            span.start_s == 0.0
                && span.end_s > stop_s - 1.5 * period_s
                && span.end_s < stop_s + 1.5 * period_s,
            "{stop_s} {period_s}: {span:?}"
        );
        assert!(
            span.notes.len() == 1 && span.notes[0].kind == SpanNoteKind::LeadOut,
            "{span:?}"
        );
    }
}

#[test]
fn of_two_swings_in_one_file_the_longer_is_used_and_the_other_noted() {
    let mut rng = rng();
    for _ in 0..40 {
        let touch_s = 25.0 + 70.0 * rng.random::<f64>();
        if (touch_s - 60.0).abs() < 10.0 {
            continue;
        }
        let period_s = 1.2 + 1.5 * rng.random::<f64>();
        let first = Swing {
            tau_s: 600.0,
            ..random_swing(&mut rng, period_s, 0.15)
        };
        // Turned round at the touch: whatever the phase, the motion jumps.
        let phase = first.phase + TAU * touch_s / period_s + PI;
        let second = Swing {
            phase,
            ..first.clone()
        };
        let motion = |c: usize, t: f64| {
            if t < touch_s {
                first.at(c, t)
            } else {
                second.at(c, t - touch_s)
            }
        };
        let groups = phone(&mut rng, 120.0, &motion);
        let span = free_swing_span(&groups);
        let edge = if touch_s > 60.0 {
            span.end_s
        } else {
            span.start_s
        };
        assert!(
            (edge - touch_s).abs() < 1.5 * period_s,
            "{touch_s} {period_s}: {span:?}"
        );
        assert!(
            span.notes
                .iter()
                .any(|n| n.kind == SpanNoteKind::SecondSwing),
            "{touch_s}: {span:?}"
        );
    }
}

/// Of a touch that leaves the motion nearly as it was the record tells nothing: who saw it does.
#[test]
fn a_swing_does_not_go_across_a_disturbance_that_is_known() {
    let mut rng = rng();
    for _ in 0..20 {
        // Nine cycles or more on either side: a swing of fewer than eight is not worth a note of
        // its own.
        let side_s = if rng.random() { 10.0 } else { -35.0 };
        let touch_s = 60.0 + side_s + 25.0 * rng.random::<f64>();
        let period_s = 1.2 + 1.5 * rng.random::<f64>();
        let swing = Swing {
            tau_s: 600.0,
            ..random_swing(&mut rng, period_s, 0.15)
        };
        let groups = phone(&mut rng, 120.0, &|c, t| swing.at(c, t));
        span_is_whole(&groups, "nothing told");
        let span = undisturbed_span(&groups, &[touch_s]);
        let (edge, other) = if touch_s > 60.0 {
            (span.end_s, span.start_s)
        } else {
            (span.start_s, span.end_s - 120.0)
        };
        assert!(
            (edge - touch_s).abs() < 0.5 * period_s && other.abs() < 0.1,
            "{touch_s}: {span:?}"
        );
        assert!(edge < touch_s || touch_s < 60.0, "{touch_s}: {span:?}");
        assert!(
            span.notes
                .iter()
                .any(|n| n.kind == SpanNoteKind::SecondSwing),
            "{touch_s}: {span:?}"
        );
    }
}

#[test]
fn single_wrong_samples_do_not_cut_a_record() {
    let mut rng = rng();
    for _ in 0..20 {
        let swing = random_swing(&mut rng, 2.5, 0.2);
        let mut groups = phone(&mut rng, 100.0, &|c, t| swing.at(c, t));
        for _ in 0..3 {
            let at = 2000 + rng.random::<u32>() as usize % 6000;
            groups[0].channels[0][at] += 3.0;
        }
        span_is_whole(&groups, "glitches");
    }
}

// ---- crossings, eq. (14), lists ----

#[test]
fn crossings_give_the_period_of_a_noisy_decaying_sine() {
    let mut rng = rng();
    let mut pulls = Vec::new();
    for _ in 0..40 {
        let period_s = 1.0 + 4.0 * rng.random::<f64>();
        let swing = Swing {
            tau_s: 100.0,
            ..random_swing(&mut rng, period_s, 0.2)
        };
        let t: Vec<f64> = (0..12000)
            .map(|i| 0.01 * (i as f64 + 0.2 * rng.random::<f64>()))
            .collect();
        let x: Vec<f64> = t
            .iter()
            .map(|t| {
                (-t / 100.0).exp() * (TAU * t / period_s + swing.phase).sin()
                    + 0.005 * normal(&mut rng)
            })
            .collect();
        let fit = period_from_crossings(&zero_crossings(&t, &x)).unwrap();
        // Damped: zeros of exp(−αt) sin ωt are spaced by π/ω exactly.
        pulls.push((fit.period_s - period_s) / fit.period_se_s);
        assert!(
            (fit.period_s / period_s - 1.0).abs() < 2e-4,
            "{period_s}: {fit:?}"
        );
        let list = crossing_periods(&zero_crossings(&t, &x));
        assert!(
            list.period_s
                .iter()
                .all(|p| (p / period_s - 1.0).abs() < 0.05),
            "{period_s}"
        );
    }
    let rms = (pulls.iter().map(|p| p * p).sum::<f64>() / pulls.len() as f64).sqrt();
    println!("crossings: rms pull {rms:.2}");
    // χ² with 40 degrees of freedom: 1.40 × is passed once in 10 000; decay makes late crossings
    // worse than early ones.
    assert!(rms < 2.0, "{rms}");
}

/// The paper's photogate list: T0 (1 + bt) + C exp(−t/τ) sin(2πt/T_m + φ), eq. (14) in the errata's
/// form.
fn photogate(rng: &mut ChaCha8Rng, c_s: f64, b: f64, sigma_s: f64) -> (Vec<f64>, Vec<f64>) {
    let phase = TAU * rng.random::<f64>();
    let t: Vec<f64> = (0..160).map(|i| 2.2 * i as f64).collect();
    let p = t
        .iter()
        .map(|t| {
            4.391 * (1.0 + b * t)
                + c_s * (-t / 350.0).exp() * (TAU * t / 28.3 + phase).sin()
                + sigma_s * normal(rng)
        })
        .collect();
    (t, p)
}

#[test]
fn equation_14_is_recovered_with_true_errors() {
    let mut rng = rng();
    let mut pulls = [0.0; 4];
    for _ in 0..60 {
        let (t, p) = photogate(&mut rng, 0.04, -5e-6, 0.002);
        let fit = fit_period_trend(&t, &p).unwrap();
        let m = fit.modulation.expect("a modulation of 20 sigma is seen");
        pulls[0] += ((fit.t0_s - 4.391) / fit.t0_se_s).powi(2);
        pulls[1] += ((m.t_m_s - 28.3) / m.t_m_se_s).powi(2);
        pulls[2] += ((m.c_s - 0.04) / m.c_se_s).powi(2);
        pulls[3] += ((m.decay_per_s - 1.0 / 350.0) / m.decay_se_per_s).powi(2);
    }
    println!(
        "mean squared pulls of T0, T_m, C, 1/tau: {:?}",
        pulls.map(|p| p / 60.0)
    );
    // χ²(60)/60: 0.52 and 1.66 are each passed less than once in 2000; four figures.
    assert!(
        pulls.iter().all(|p| (0.45..1.75).contains(&(p / 60.0))),
        "{pulls:?}"
    );
}

#[test]
fn equation_14_falls_back_where_there_is_no_modulation() {
    let mut rng = rng();
    let mut invented = 0;
    for _ in 0..60 {
        let (t, p) = photogate(&mut rng, 0.0, 0.0, 0.002);
        let fit = fit_period_trend(&t, &p).unwrap();
        invented += usize::from(fit.modulation.is_some());
        assert!((fit.mean_s - 4.391).abs() < 6.0 * fit.mean_se_s, "{fit:?}");
    }
    println!("modulations invented in noise: {invented} of 60");
    assert!(invented <= 3);
}

#[test]
fn doubled_and_halved_periods_are_flagged() {
    let mut rng = rng();
    let (t_s, mut period_s) = photogate(&mut rng, 0.03, -5e-6, 0.002);
    period_s[20] *= 2.0;
    period_s[77] *= 0.5;
    let list = PeriodList {
        name: "gate".into(),
        t_s,
        period_s,
        repairs: Vec::new(),
    };
    let found = period_from_list(&list).unwrap();
    let flags: Vec<(usize, Option<f64>)> =
        found.flagged.iter().map(|f| (f.index, f.factor)).collect();
    assert_eq!(flags, [(20, Some(2.0)), (77, Some(0.5))]);
    let middle = 4.391 * (1.0 - 5e-6 * 0.5 * 2.2 * 159.0);
    assert!(
        (found.period_s - middle).abs() < 5.0 * found.u_s,
        "{found:?}"
    );
    assert!(period_from_list(&PeriodList::default()).is_err());
}

// ---- beats ----

#[test]
fn the_beat_count_gives_the_ratio_of_the_periods() {
    let mut rng = rng();
    for _ in 0..40 {
        // Fig. 3 of the paper: T_a = 4.09 s, T_b = 30.0 s, n = 7.33.
        let balance = 0.5 + 0.5 * rng.random::<f64>();
        let (strong, weak) = if rng.random::<bool>() {
            (4.39, 3.83)
        } else {
            (3.83, 4.39)
        };
        let (p, q) = (TAU * rng.random::<f64>(), TAU * rng.random::<f64>());
        let t: Vec<f64> = (0..9000).map(|i| 0.02 * i as f64).collect();
        let x: Vec<f64> = t
            .iter()
            .map(|t| {
                0.1 * (TAU * t / strong + p).sin()
                    + 0.1 * balance * (TAU * t / weak + q).sin()
                    + 1e-3 * normal(&mut rng)
            })
            .collect();
        let count = beat_count(&t, &x).unwrap();
        let ratio = period_ratio(count.n, true).unwrap();
        assert!(
            (count.beat_s - 30.0).abs() < 0.6,
            "{balance:.2} {strong}: {count:?}"
        );
        assert!(
            (count.n - 7.339).abs() < 4.0 * count.n_u && count.n_u < 0.5,
            "{balance:.2} {strong}: {count:?}"
        );
        assert!(
            (ratio - 4.39 / 3.83).abs() < 0.006,
            "{balance:.2} {strong}: {ratio} {count:?}"
        );
    }
}

#[test]
fn a_single_sine_has_no_beat() {
    let t: Vec<f64> = (0..9000).map(|i| 0.02 * i as f64).collect();
    let x: Vec<f64> = t
        .iter()
        .map(|t| (-t / 200.0).exp() * (TAU * t / 4.0).sin())
        .collect();
    assert!(beat_count(&t, &x).is_err());
}

// ---- windows against amplitude ----

/// A pendulum by its equation θ″ = −ω² sin θ − 2αθ′, classical Runge–Kutta at 1 ms: rate against
/// time.
fn pendulum(omega: f64, alpha: f64, start_rad: f64, duration_s: f64) -> (Vec<f64>, Vec<f64>) {
    let slope = |y: [f64; 2]| [y[1], -omega * omega * y[0].sin() - 2.0 * alpha * y[1]];
    let add = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
    let (mut y, h) = ([start_rad, 0.0], 1e-3);
    let (mut t_s, mut rate) = (Vec::new(), Vec::new());
    for i in 0..(duration_s / h) as usize {
        if i % 10 == 0 {
            t_s.push(i as f64 * h);
            rate.push(y[1]);
        }
        let k1 = slope(y);
        let k2 = slope(add(y, k1, h / 2.0));
        let k3 = slope(add(y, k2, h / 2.0));
        let k4 = slope(add(y, k3, h));
        for j in 0..2 {
            y[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
        }
    }
    (t_s, rate)
}

fn followed(
    groups: &[ChannelGroup],
    span_s: (f64, f64),
    period_s: f64,
    channel: usize,
) -> Vec<WindowPoint> {
    let channels: usize = groups.iter().map(|g| g.channels.len()).sum();
    let project: Vec<Complex64> = (0..channels)
        .map(|c| Complex64::new(f64::from(c == channel), 0.0))
        .collect();
    let wanted = WindowedMode {
        span_s,
        mode: Pole {
            omega_rad_s: TAU / period_s,
            alpha_per_s: 0.01,
        },
        others: &[],
        project: &project,
    };
    against_amplitude(groups, &wanted)
}

/// Every window's period and decrement within its own error: two modes, six channels with noise of
/// different size.
#[test]
fn windows_state_true_errors() {
    let mut rng = rng();
    let (mut squares, mut count) = ([0.0; 2], 0.0);
    for _ in 0..40 {
        let swing = Swing {
            tau_s: 300.0,
            ..random_swing(&mut rng, 1.9, 0.15)
        };
        let other = Swing {
            tau_s: 200.0,
            ..random_swing(&mut rng, 3.1, 0.15)
        };
        let groups = phone(&mut rng, 130.0, &|c, t| swing.at(c, t) + other.at(c, t));
        let pole = |s: &Swing| Pole {
            omega_rad_s: TAU / s.period_s,
            alpha_per_s: 1.0 / s.tau_s,
        };
        let wanted = WindowedMode {
            span_s: (0.0, 130.0),
            mode: pole(&swing),
            others: &[pole(&other)],
            project: &[Complex64::ONE; 6],
        };
        for p in against_amplitude(&groups, &wanted) {
            squares[0] += ((p.period_s - 1.9) / p.period_se_s).powi(2);
            squares[1] += ((p.decrement - 1.9 / 300.0) / p.decrement_se).powi(2);
            count += 1.0;
        }
    }
    let mean = squares.map(|s| s / count);
    println!("mean squared pulls of {count} windows: {mean:?}");
    // χ²(n)/n scatters by √(2/n); 3.5 of these either way is missed once in 2000. 2 % more for what
    // the cells lose.
    let wide = 3.5 * (2.0 / count).sqrt() + 0.02;
    assert!(
        count > 300.0 && mean.iter().all(|m| (m - 1.0).abs() < wide),
        "{mean:?}"
    );
}

#[test]
fn a_pendulum_shows_its_law() {
    let mut rng = rng();
    let (omega, alpha) = (TAU / 1.338, 0.012);
    let (t_s, mut rate) = pendulum(omega, alpha, 0.4, 180.0);
    rate.iter_mut().for_each(|r| *r += 0.005 * normal(&mut rng));
    let group = ChannelGroup {
        t_s,
        channels: vec![rate],
    };
    let points = followed(&[group], (0.0, 180.0), 1.338, 0);
    assert!(points.len() > 15);
    for p in &points {
        // T = T0 (1 + θ²/16 + 11 θ⁴/3072), the pendulum's series; decay shifts ω² by −α² (4e-6 of
        // it).
        let theta = p.amplitude_over_omega();
        let law = 1.338 * (1.0 + theta.powi(2) / 16.0 + 11.0 * theta.powi(4) / 3072.0);
        assert!(
            (p.period_s - law).abs() < 5.0 * p.period_se_s + 1.5e-4,
            "{p:?} {law}"
        );
        assert!(
            (p.decrement - alpha * 1.338).abs() < 5.0 * p.decrement_se + 5e-4,
            "{p:?}"
        );
    }
    let limit = small_amplitude_limit(&points).unwrap();
    println!("pendulum: {limit:?}");
    assert!(
        (limit.period_s - 1.338).abs() < 1e-4 + 4.0 * limit.period_se_s,
        "{limit:?}"
    );
}

#[test]
fn the_law_is_chosen_by_the_evidence() {
    let mut rng = rng();
    for (law, c1, c2) in [
        (PeriodLaw::Constant, 0.0, 0.0),
        (PeriodLaw::Linear, 0.25, 0.0),
        (PeriodLaw::Quadratic, 0.0, 0.3),
    ] {
        let (mut chosen, mut inside) = (0, 0);
        for _ in 0..100 {
            let points: Vec<WindowPoint> = (0..20)
                .map(|k| {
                    let amplitude = 0.75 * (-0.12 * k as f64).exp();
                    let period_s = 2.6
                        + c1 * amplitude
                        + c2 * amplitude * amplitude
                        + 0.001 * normal(&mut rng);
                    let t_s = 5.0 * k as f64;
                    WindowPoint {
                        t_s,
                        amplitude,
                        period_s,
                        period_se_s: 0.001,
                        decrement: 0.0,
                        decrement_se: 0.0,
                    }
                })
                .collect();
            let limit = small_amplitude_limit(&points).unwrap();
            chosen += usize::from(limit.law == law);
            inside += usize::from((limit.period_s - 2.6).abs() < 1.96 * limit.period_se_s);
        }
        println!("{law:?}: chosen {chosen}, inside 95 %: {inside} of 100");
        // Binomial(100, 0.95): below 86 once in 3000.
        assert!(chosen >= 70 && inside >= 86, "{law:?}: {chosen} {inside}");
    }
}

// ---- gates ----

/// Edges of a flag 6 mm wide on an oscillating bar with sway, at two gates beside the rest
/// position, by stepping.
fn two_gates(period_s: f64, sway_s: f64, sway_m: f64, duration_s: f64) -> GateEvents {
    let place = |gate: usize, t: f64| {
        let end = if gate == 0 { 1.0 } else { -1.0 };
        let yaw = 0.03 * (-t / 400.0).exp() * (TAU * t / period_s).sin();
        yaw + end * sway_m * (TAU * t / sway_s + 0.4).sin() - [0.002, -0.0015][gate]
    };
    let mut log = GateEvents::default();
    let blocked = |t: f64| [place(0, t).abs() < 0.003, place(1, t).abs() < 0.003];
    let mut last = blocked(0.0);
    let step = 2e-5;
    for i in 1..(duration_s / step) as usize {
        let t = i as f64 * step;
        let now = blocked(t);
        if now != last {
            log.t_s.push(t);
            log.a.push(now[0]);
            log.b.push(now[1]);
            last = now;
        }
    }
    log
}

#[test]
fn gates_at_both_ends_give_yaw_without_sway() {
    let events = two_gates(1.1, 1.7, 0.001, 120.0);
    let gates = gate_periods(&events, 0.006).unwrap();
    let windows = gates.against_amplitude(30);
    for w in &windows {
        assert!((w.period_s / 1.1 - 1.0).abs() < 5e-4, "{w:?}");
        let amplitude = 0.03 * (-w.t_s / 400.0).exp();
        assert!(
            (w.amplitude / amplitude - 1.0).abs() < 0.03,
            "{w:?} {amplitude}"
        );
        assert!(
            (w.decrement - 1.1 / 400.0).abs() < 5.0 * w.decrement_se + 1e-3,
            "{w:?}"
        );
    }
    let list = period_from_list(&gates.list("gates")).unwrap();
    assert!(
        (list.period_s / 1.1 - 1.0).abs() < 2e-4,
        "{:?}",
        list.period_s
    );
    assert!(gates.notes.is_empty(), "{:?}", gates.notes);
}

#[test]
fn a_missed_passage_is_noted_not_counted() {
    let mut events = two_gates(1.1, 1.7, 0.001, 60.0);
    for column in [40, 40, 40, 40] {
        events.t_s.remove(column);
        events.a.remove(column);
        events.b.remove(column);
    }
    let gates = gate_periods(&events, 0.006).unwrap();
    assert!(!gates.notes.is_empty());
    assert!(
        gates.period_s.iter().all(|p| (p / 1.1 - 1.0).abs() < 0.05),
        "{:?}",
        gates.notes
    );
    assert!(
        gate_periods(&events, -1.0).is_err()
            && gate_periods(&GateEvents::default(), 0.006).is_err()
    );
}

// ---- real recordings ----

/// Columns of a file of numbers, `None` (said aloud) where the folder is absent.
fn shared(path: &str, separator: char) -> Option<Vec<Vec<f64>>> {
    let full = std::path::PathBuf::from(std::env::var("CARGO_MANIFEST_DIR").unwrap())
        .join("../../../../shared/data")
        .join(path);
    let Ok(text) = std::fs::read_to_string(&full) else {
        println!("skipped: ../shared/data/{path} is not here");
        return None;
    };
    let rows: Vec<Vec<f64>> = text
        .lines()
        .map(|line| {
            line.split(separator)
                .map_while(|cell| cell.trim().parse().ok())
                .collect::<Vec<f64>>()
        })
        .filter(|row| row.len() > 2)
        .collect();
    let width = rows[0].len();
    Some(
        (0..width)
            .map(|c| rows.iter().map(|row| row[c]).collect())
            .collect(),
    )
}

/// One group of the columns `from..to`, each times `factor`, rows with a stamp not after the last
/// dropped.
fn group(columns: &[Vec<f64>], time: f64, from: usize, to: usize, factor: f64) -> ChannelGroup {
    let mut group = ChannelGroup {
        t_s: Vec::new(),
        channels: vec![Vec::new(); to - from],
    };
    for i in 0..columns[0].len() {
        let t = columns[0][i] * time;
        if group.t_s.last().is_none_or(|last| t > *last) {
            group.t_s.push(t);
            (from..to).for_each(|c| group.channels[c - from].push(columns[c][i] * factor));
        }
    }
    group
}

fn phone_pendulum() -> Option<Vec<ChannelGroup>> {
    shared("phone-pendulum/Gyroscope.csv", '\t').map(|c| vec![group(&c, 1.0, 1, 4, 1.0)])
}

fn ducted_fan(file: &str) -> Option<Vec<ChannelGroup>> {
    let columns = shared(&format!("ducted-fan/{file}"), ',')?;
    Some(vec![
        group(&columns, 1e-3, 4, 7, PI / 180.0),
        group(&columns, 1e-3, 7, 10, 1.0),
    ])
}

#[test]
fn real_records_are_trimmed_where_a_hand_was() {
    if let Some(groups) = phone_pendulum() {
        let span = free_swing_span(&groups);
        println!("phone pendulum {span:?}");
        assert!(span.end_s - span.start_s > 165.0, "{span:?}");
    }
    for file in [
        "YawInertiaPendel01.csv",
        "PitchInertiaPendel01.csv",
        "RollInertiapendel01.csv",
    ] {
        let Some(groups) = ducted_fan(file) else {
            return;
        };
        let span = free_swing_span(&groups);
        println!(
            "{file} {} .. {}: {span:?}",
            groups[0].t_s[0],
            groups[0].t_s.last().unwrap()
        );
    }
}

#[test]
fn the_phone_pendulum_at_small_amplitude() {
    let Some(groups) = phone_pendulum() else {
        return;
    };
    let span = free_swing_span(&groups);
    let points = followed(&groups, (span.start_s, span.end_s), 1.343, 0);
    for p in &points {
        println!(
            "{:.1} s: {:.3} rad, {:.5} +- {:.5} s, {:.4}",
            p.t_s,
            p.amplitude_over_omega(),
            p.period_s,
            p.period_se_s,
            p.decrement
        );
    }
    let limit = small_amplitude_limit(&points).unwrap();
    println!("{limit:?}");
    // NOTES.md of the data: near 1.338 s; the issue asks for ± 0.002.
    assert!((limit.period_s - 1.338).abs() < 0.002, "{limit:?}");
}

#[test]
fn the_ducted_fan_yaw_falls_with_amplitude() {
    let Some(groups) = ducted_fan("YawInertiaPendel01.csv") else {
        return;
    };
    let span = free_swing_span(&groups);
    let points = followed(&groups, (span.start_s, span.end_s), 2.72, 2);
    for p in &points {
        println!(
            "{:.1} s: {:.3} rad, {:.4} +- {:.4} s, {:.4}",
            p.t_s,
            p.amplitude_over_omega(),
            p.period_s,
            p.period_se_s,
            p.decrement
        );
    }
    let limit = small_amplitude_limit(&points).unwrap();
    println!("{limit:?}");
    // NOTES.md of the data: 2.83 s at 0.75 rad, 2.64 s at 0.11 rad, still falling.
    assert!(
        limit.law != PeriodLaw::Constant && limit.period_s < 2.66,
        "{limit:?}"
    );
}

#[test]
fn nine_geometries_of_one_bar() {
    let geometries = [
        (0.3960, "0.62450"),
        (0.3960, "1.13599"),
        (0.3960, "1.38915"),
        (0.5960, "1.38922"),
        (0.6000, "0.83042"),
        (1.0920, "0.46659"),
        (1.0920, "0.64005"),
        (1.0920, "0.86795"),
        (1.0920, "1.26893"),
    ];
    let mut gyradii = Vec::new();
    for (spacing_m, length) in geometries {
        let Some(c) = shared(
            &format!("light-gate-bar/spacing-{spacing_m:.4}m_length-{length}m.csv"),
            ',',
        ) else {
            return;
        };
        let on = |column: &[f64]| column.iter().map(|v| *v > 0.5).collect();
        let gates = gate_periods(
            &GateEvents {
                t_s: c[0].clone(),
                a: on(&c[2]),
                b: on(&c[3]),
            },
            0.006,
        )
        .unwrap();
        let limit = small_amplitude_limit(&gates.against_amplitude(40)).unwrap();
        let length_m: f64 = length.parse().unwrap();
        let gyradius = |t: f64| t * spacing_m / 2.0 / TAU * (9.81256 / length_m).sqrt(); // eq. (6)
        println!(
            "{spacing_m} {length_m}: T0 {:.5} +- {:.5} {:?}, k {:.5}, notes {:?}",
            limit.period_s,
            limit.period_se_s,
            limit.law,
            gyradius(limit.period_s),
            gates.notes
        );
        gyradii.push(gyradius(limit.period_s));
    }
    let mean = gyradii.iter().sum::<f64>() / 9.0;
    let spread = (gyradii.iter().map(|k| (k - mean).powi(2)).sum::<f64>() / 8.0).sqrt() / mean;
    println!("k = {mean:.5} m, spread {:.2} %", 100.0 * spread);
    // NOTES.md of the data: near 0.342 m, 0.8 % spread by the small-angle formula.
    assert!(
        (mean - 0.342).abs() < 0.001 && spread < 0.009,
        "{mean} {spread}"
    );
}
