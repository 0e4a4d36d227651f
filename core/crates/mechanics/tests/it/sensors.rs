//! What the sensors' effects do to a phone's readings, against closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{LN_10, TAU};

use gyradius_base::frames::{Rotation, Vec3};
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::sensors::catalogue;
use gyradius_mechanics::{
    Body, Dimensions, Draws, Experiment, Fineness, Hanging, Phone, Record, RigidBody, Scene, Start,
    SuspensionAxis,
};

const G: f64 = 9.80665;
const LINE_M: f64 = 1.006;

/// The model hull of the paper's Fig. 15 with a phone off its centre.
fn swing(start: Start, sensors: &[(&str, &[(&str, f64)])]) -> Experiment {
    let body = RigidBody::from_gyradii(13.18, [0.204, 0.352, 0.303], Vec3::new(0.0, 0.0, -0.253));
    let dimensions = Dimensions {
        line_length_m: LINE_M,
        spacing_m: 0.56,
        top_spacing_m: 0.56,
        gravity_m_s2: G,
        ..Dimensions::default()
    };
    let scene = Scene {
        hanging: Hanging::Bifilar(SuspensionAxis::Athwartships),
        body: Body::new(body.mass_kg, &body.inertia_kg_m2, &body.cm_m),
        dimensions,
        start,
        effects: Vec::new(),
    };
    let phone = Phone {
        position_x_m: 0.2,
        turn_y_rad: 0.3,
        gyro_bias_z_rad_s: 0.01,
        ..Phone::default()
    };
    let sensors = sensors
        .iter()
        .map(|(id, numbers)| effect(id, numbers))
        .collect();
    Experiment {
        scene,
        hull_from_phone: Rotation::identity(),
        phone,
        sensors,
        held_s: 0.0,
    }
}

fn effect(id: &str, given: &[(&str, f64)]) -> EffectValues {
    let kind = catalogue().into_iter().find(|kind| kind.id == id).unwrap();
    let known = |name: &str| kind.numbers.iter().any(|n| n.name == name);
    assert!(given.iter().all(|(name, _)| known(name)), "{id}: {given:?}");
    let value = |name: &str| {
        given
            .iter()
            .find(|(n, _)| *n == name)
            .map_or(0.0, |(_, value)| *value)
    };
    EffectValues {
        values: kind.numbers.iter().map(|n| value(n.name)).collect(),
        kind,
    }
}

/// Yaw, sway and pitch at once.
fn lively() -> Start {
    Start {
        along_m: 0.08,
        turn_rad: 0.05,
        yaw_rad: 0.1,
        ..Start::default()
    }
}

fn times(count: usize, rate_hz: f64) -> Vec<f64> {
    (0..count).map(|i| i as f64 / rate_hz).collect()
}

fn six(record: &Record) -> Vec<[f64; 6]> {
    record
        .readings
        .iter()
        .map(|reading| reading.six())
        .collect()
}

fn read(sensors: &[(&str, &[(&str, f64)])], t_s: &[f64]) -> Vec<[f64; 6]> {
    six(&swing(lively(), sensors).record(t_s, &Draws::new()).unwrap())
}

fn assert_alike(found: &[[f64; 6]], expected: &[[f64; 6]], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (n, (found, expected)) in found.iter().zip(expected).enumerate() {
        for k in 0..6 {
            let miss = (found[k] - expected[k]).abs();
            assert!(
                miss <= tolerance,
                "sample {n}, reading {k}: {} against {}",
                found[k],
                expected[k]
            );
        }
    }
}

/// The readings without any effect, each changed.
fn changed(t_s: &[f64], change: impl Fn(f64, [f64; 6]) -> [f64; 6]) -> Vec<[f64; 6]> {
    t_s.iter()
        .zip(read(&[], t_s))
        .map(|(t, six)| change(*t, six))
        .collect()
}

#[test]
fn errors_in_proportion_and_drift_are_what_their_formulas_say() {
    let t_s = times(200, 20.0);
    let drift: &[(&str, f64)] = &[
        ("gyro_rate_x_rad_s2", 1e-4),
        ("acc_rate_z_m_s3", -2e-3),
        ("gyro_warm_y_rad_s", 0.02),
        ("acc_warm_x_m_s2", 0.3),
        ("warm_up_s", 4.0),
    ];
    let drifted = changed(&t_s, |t, mut r| {
        let warm = 1.0 - (-t / 4.0f64).exp();
        r[0] += 1e-4 * t;
        r[1] += 0.02 * warm;
        r[3] += 0.3 * warm;
        r[5] -= 2e-3 * t;
        r
    });
    assert_alike(&read(&[("bias_drift", drift)], &t_s), &drifted, 1e-13);
    let scaled = changed(&t_s, |_, r| {
        [r[0], r[1], 1.01 * r[2], 0.98 * r[3], r[4], r[5]]
    });
    let both: &[(&str, &[(&str, f64)])] = &[
        ("gyro_scale", &[("z", 0.01)]),
        ("acc_scale", &[("x", -0.02)]),
    ];
    assert_alike(&read(both, &t_s), &scaled, 1e-13);
    let crossed = changed(&t_s, |_, r| {
        [
            r[0] + 0.02 * r[1],
            r[1],
            r[2],
            r[3],
            r[4] - 0.01 * r[5],
            r[5] + 0.03 * r[3],
        ]
    });
    let cross: &[(&str, f64)] = &[("gyro_xy", 0.02), ("acc_yz", -0.01), ("acc_zx", 0.03)];
    assert_alike(&read(&[("cross_axis", cross)], &t_s), &crossed, 1e-13);
}

#[test]
fn a_wrong_clock_and_a_delay_read_the_motion_at_another_time() {
    let t_s = times(200, 20.0);
    let slower: Vec<f64> = t_s.iter().map(|t| t / 1.001).collect();
    assert_alike(
        &read(&[("clock_scale", &[("error", 1e-3)])], &t_s),
        &read(&[], &slower),
        1e-11,
    );
    // A slow clock's last samples are taken when a right one has stopped.
    let t_s = times(1200, 20.0);
    let faster: Vec<f64> = t_s.iter().map(|t| t / 0.98).collect();
    let slow: &[(&str, &[(&str, f64)])] = &[("clock_scale", &[("error", -0.02)])];
    assert_alike(&read(slow, &t_s), &read(&[], &faster), 1e-11);
    let experiment = swing(lively(), slow);
    let path = experiment.motion(Fineness::FULL, t_s[1199]).unwrap();
    let on_path: Vec<[f64; 6]> = experiment
        .readings_on(&path, &t_s)
        .unwrap()
        .iter()
        .map(|reading| reading.six())
        .collect();
    assert_alike(&on_path, &read(&[], &faster), 1e-11);
    let late = &t_s[1..];
    let ago = |d: f64| late.iter().map(|t| t - d).collect::<Vec<_>>();
    let (gyro, acc) = (read(&[], &ago(0.013)), read(&[], &ago(0.027)));
    let expected: Vec<[f64; 6]> = gyro
        .iter()
        .zip(&acc)
        .map(|(w, f)| [w[0], w[1], w[2], f[3], f[4], f[5]])
        .collect();
    assert_alike(
        &read(&[("delay", &[("gyro_s", 0.013), ("acc_s", 0.027)])], late),
        &expected,
        1e-11,
    );
}

/// A yaw so small that it is harmonic: its angular frequency, eq. (5), and a start.
fn small_yaw() -> (f64, Start) {
    (
        0.28 / 0.303 * (G / LINE_M).sqrt(),
        Start {
            yaw_rad: 1e-4,
            ..Start::default()
        },
    )
}

/// Readings about the vertical of a phone that is not turned, after transients have died.
fn settled_yaw(sensors: &[(&str, &[(&str, f64)])]) -> Vec<(f64, f64)> {
    let t_s: Vec<f64> = (1500..2000).map(|i| f64::from(i) / 100.0).collect();
    let mut experiment = swing(small_yaw().1, sensors);
    experiment.phone = Phone::default();
    let record = experiment.record(&t_s, &Draws::new()).unwrap();
    t_s.iter()
        .zip(six(&record))
        .map(|(t, r)| (*t, r[2]))
        .collect()
}

#[test]
fn a_low_pass_weakens_and_delays_a_harmonic_motion() {
    let (omega, _) = small_yaw();
    // ωτ = 0.29: the edge of what the documentation promises.
    let tau = 0.1;
    for (t, found) in settled_yaw(&[("low_pass", &[("gyro_time_constant_s", tau)])]) {
        let lag = (omega * tau).atan();
        let expected = -1e-4 * omega * lag.cos() * (omega * t - lag).sin();
        assert!(
            (found - expected).abs() < 1e-7 * 1e-4 * omega,
            "{t}: {found} against {expected}"
        );
    }
}

#[test]
fn a_springy_mount_passes_on_what_base_excitation_says() {
    let (omega, _) = small_yaw();
    let (own, zeta) = (TAU * 1.0, 0.5);
    // Transmissibility (ω₀² + 2iζω₀Ω) / (ω₀² − Ω² + 2iζω₀Ω).
    let t = |w: f64| {
        let (re, im) = (own * own, 2.0 * zeta * own * w);
        num_complex::Complex::new(re, im) / num_complex::Complex::new(re - w * w, im)
    };
    let turned = [("turn_hz", 1.0), ("damping_ratio", zeta)];
    for (time, found) in settled_yaw(&[("phone_mount_resonance", &turned)]) {
        let phase = num_complex::Complex::from_polar(1.0, omega * time);
        let expected = (t(omega) * num_complex::Complex::new(0.0, 1e-4 * omega) * phase).re;
        assert!(
            (found - expected).abs() < 1e-6 * 1e-4 * omega,
            "{time}: {found} against {expected}"
        );
    }
    // Sway: Ω² = g/l, eq. (7); the hull stays level, so that the phone feels its acceleration
    // alone.
    let sway = (G / LINE_M).sqrt();
    let t_s: Vec<f64> = (1500..2000).map(|i| f64::from(i) / 100.0).collect();
    let shifted = [("shift_hz", 1.0), ("damping_ratio", zeta)];
    let mut experiment = swing(
        Start {
            along_m: 1e-5,
            ..Start::default()
        },
        &[("phone_mount_resonance", &shifted)],
    );
    experiment.phone = Phone::default();
    for (time, found) in t_s
        .iter()
        .zip(six(&experiment.record(&t_s, &Draws::new()).unwrap()))
    {
        let phase = num_complex::Complex::from_polar(1.0, sway * time);
        let expected = -1e-5 * sway * sway * (t(sway) * phase).re;
        assert!(
            (found[4] - expected).abs() < 1e-6 * 1e-5 * sway * sway,
            "{time}: {} {expected}",
            found[4]
        );
        assert!((found[5] - G).abs() < 1e-6);
    }
}

#[test]
fn a_springy_mount_rings_when_the_hull_is_let_go() {
    // θ̈ + 2 ζ ω₀ θ̇ + ω₀² θ = ψ₀ Ω² cos Ωt from rest: what the drive keeps up, and what rings
    // away.
    let (omega, start) = small_yaw();
    let (held, own, zeta) = (2.0, TAU * 4.0, 0.05);
    let (decay, ringing) = (zeta * own, own * (1.0 - zeta * zeta).sqrt());
    let kept = 1e-4 * omega * omega
        / num_complex::Complex::new(own * own - omega * omega, 2.0 * zeta * own * omega);
    let t_s: Vec<f64> = (1..200).map(|i| f64::from(i) / 100.0).collect();
    let mount = [("turn_hz", 4.0), ("damping_ratio", zeta)];
    let mut experiment = swing(start, &[("phone_mount_resonance", &mount)]);
    (experiment.phone, experiment.held_s) = (Phone::default(), held);
    let stamps: Vec<f64> = t_s.iter().map(|t| held + t).collect();
    let turn_rate = |t: f64| {
        let driven = (kept
            * num_complex::Complex::new(0.0, omega)
            * (num_complex::Complex::i() * omega * t).exp())
        .re;
        // x = e^{−δt} (a cos + b sin), x(0) = −Re A, ẋ(0) = Ω Im A.
        let (a, rate) = (-kept.re, omega * kept.im);
        let b = (rate + decay * a) / ringing;
        let (sin, cos) = (ringing * t).sin_cos();
        driven
            + (-decay * t).exp()
                * ((b * ringing - a * decay) * cos - (a * ringing + b * decay) * sin)
    };
    for (t, found) in t_s
        .iter()
        .zip(six(&experiment.record(&stamps, &Draws::new()).unwrap()))
    {
        let expected = -1e-4 * omega * (omega * t).sin() + turn_rate(*t);
        assert!(
            (found[2] - expected).abs() < 1e-6 * 1e-4 * omega,
            "{t}: {} against {expected}",
            found[2]
        );
    }
}

#[test]
fn a_springy_mount_on_a_hull_that_swings_already_does_not_ring() {
    // What the drive keeps up, from the first sample on; the series in Ω/ω₀ at the start leaves its
    // third power.
    let (omega, start) = small_yaw();
    let (own, zeta) = (TAU * 3.0, 0.02);
    let kept = 1e-4 * omega * omega
        / num_complex::Complex::new(own * own - omega * omega, 2.0 * zeta * own * omega);
    let mount = [("turn_hz", 3.0), ("damping_ratio", zeta)];
    let mut experiment = swing(start, &[("phone_mount_resonance", &mount)]);
    experiment.phone = Phone::default();
    let t_s: Vec<f64> = (0..300).map(|i| f64::from(i) / 100.0).collect();
    let turns = kept.norm() * omega;
    for (t, found) in t_s
        .iter()
        .zip(six(&experiment.record(&t_s, &Draws::new()).unwrap()))
    {
        let turn_rate = (kept
            * num_complex::Complex::new(0.0, omega)
            * (num_complex::Complex::i() * omega * t).exp())
        .re;
        let expected = -1e-4 * omega * (omega * t).sin() + turn_rate;
        let most = 2.0 * (omega / own).powi(2) * turns;
        assert!(
            (found[2] - expected).abs() < most,
            "{t}: {} against {expected} within {most}",
            found[2]
        );
    }
}

#[test]
fn a_slip_turns_shifts_and_is_felt() {
    let slip: &[(&str, f64)] = &[
        ("at_s", 2.0),
        ("over_s", 0.5),
        ("turn_x_rad", 0.3),
        ("turn_z_rad", -0.2),
        ("shift_x_m", 0.05),
        ("shift_y_m", -0.02),
    ];
    let t_s = times(500, 100.0);
    let found = read(&[("phone_slip", slip)], &t_s);
    let ideal = read(&[], &t_s);
    assert_alike(&found[..200], &ideal[..200], 1e-13);
    // Afterwards it is a phone that was mounted so from the start.
    let mut moved = swing(lively(), &[]);
    let turn = Rotation::from_scaled_axis(Vec3::new(0.0, moved.phone.turn_y_rad, 0.0));
    moved.hull_from_phone = turn * Rotation::from_scaled_axis(Vec3::new(0.3, 0.0, -0.2));
    moved.phone.turn_y_rad = 0.0;
    moved.phone.position_x_m += 0.05;
    moved.phone.position_y_m -= 0.02;
    let after = six(&moved.record(&t_s, &Draws::new()).unwrap());
    assert_alike(&found[251..], &after[251..], 1e-12);
    // On a hull that is held, the gyroscope's integral is the turn and the accelerometer's double
    // integral the shift.
    let shift_only = [("at_s", 2.0), ("over_s", 0.5), ("shift_x_m", 0.05)];
    let turn_only = [("at_s", 2.0), ("over_s", 0.5), ("turn_z_rad", 0.3)];
    // Finely, because the acceleration begins and ends with a bend.
    let fine: Vec<f64> = (0..6000).map(|i| 1.95 + f64::from(i) / 1e4).collect();
    let held = |numbers: &[(&str, f64)]| {
        let mut experiment = swing(Start::default(), &[("phone_slip", numbers)]);
        (experiment.phone, experiment.held_s) = (Phone::default(), 10.0);
        six(&experiment.record(&fine, &Draws::new()).unwrap())
    };
    let turned: f64 = held(&turn_only).iter().map(|r| r[2] * 1e-4).sum();
    assert!((turned - 0.3).abs() < 1e-6, "{turned}");
    // Without rate at the end, ∬ a = −∫ t a.
    let shifted: f64 = held(&shift_only)
        .iter()
        .zip(&fine)
        .map(|(r, t)| -t * r[3] * 1e-4)
        .sum();
    assert!((shifted - 0.05).abs() < 1e-6, "{shifted}");
}

#[test]
fn jitter_takes_the_draws_as_they_are() {
    let t_s = times(50, 10.0);
    let numbers = [("sampling_s", 2e-3), ("stamp_s", 5e-3)];
    let draws: Draws = vec![(0..100).map(|i| f64::from(i % 7) - 3.0).collect()];
    let record = swing(lively(), &[("jitter", &numbers)])
        .record(&t_s, &draws)
        .unwrap();
    let taken: Vec<f64> = t_s
        .iter()
        .enumerate()
        .map(|(n, t)| t + 2e-3 * draws[0][2 * n])
        .collect();
    assert_alike(&six(&record)[1..], &read(&[], &taken[1..]), 1e-11);
    for (n, stamp) in record.t_s.iter().enumerate() {
        assert!((stamp - taken[n] - 5e-3 * draws[0][2 * n + 1]).abs() < 1e-15);
    }
}

#[test]
fn lost_samples_are_those_of_the_lowest_draws_and_of_the_stall() {
    let t_s = times(50, 10.0);
    let numbers = [("share", 0.1), ("stall_at_s", 2.0), ("stall_s", 0.95)];
    // Φ(−1.28155) = 0.1 (tables of the normal distribution).
    let draws: Draws = vec![
        (0..50)
            .map(|i| if i % 5 == 0 { -1.2816 } else { -1.2815 })
            .collect(),
    ];
    let record = swing(lively(), &[("drop_outs", &numbers)])
        .record(&t_s, &draws)
        .unwrap();
    let kept: Vec<f64> = (0..50)
        .filter(|i| i % 5 != 0 && !(20..30).contains(i))
        .map(|i| f64::from(i) / 10.0)
        .collect();
    assert_eq!(record.t_s, kept);
    assert_alike(&six(&record), &read(&[], &kept), 1e-12);
}

#[test]
fn conversion_clips_and_steps() {
    let t_s = times(300, 30.0);
    let numbers: &[(&str, &[(&str, f64)])] = &[
        ("quantisation", &[("gyro_rad_s", 1e-3), ("acc_m_s2", 0.01)]),
        ("saturation", &[("gyro_rad_s", 0.1), ("acc_m_s2", 9.3)]),
    ];
    let ideal = read(&[], &t_s);
    let clipped = |x: f64, limit: f64| x.clamp(-limit, limit);
    for (found, ideal) in read(numbers, &t_s).iter().zip(&ideal) {
        for k in 0..6 {
            let (limit, step) = if k < 3 { (0.1, 1e-3) } else { (9.3, 0.01) };
            assert!((found[k] / step - (found[k] / step).round()).abs() < 1e-9);
            assert!(
                (found[k] - clipped(ideal[k], limit)).abs() <= 0.5 * step * (1.0 + 1e-9),
                "{k}"
            );
        }
    }
    assert!(ideal.iter().any(|r| r[5] > 9.3) && ideal.iter().any(|r| r[2].abs() > 0.1));
    // Derivatives: the limit's own where it is reached, as without steps elsewhere.
    let (plain, converted) = (swing(lively(), &[]), swing(lively(), numbers));
    let by = |e: &Experiment, name: &str| {
        e.derivatives(&[e.index(name).unwrap()], &t_s, &Draws::new())
            .unwrap()
    };
    let (free, stopped) = (by(&plain, "yaw_rad"), by(&converted, "yaw_rad"));
    let limit = by(&converted, "saturation.gyro_rad_s");
    for (n, ideal) in ideal.iter().enumerate() {
        // A reading within a step of the limit may fall on either side.
        if (ideal[2].abs() - 0.1).abs() < 2e-3 {
            continue;
        }
        let beyond = ideal[2].abs() > 0.1;
        assert!((stopped[6 * n + 2] - if beyond { 0.0 } else { free[6 * n + 2] }).abs() < 1e-6);
        assert_eq!(
            limit[6 * n + 2],
            if beyond { ideal[2].signum() } else { 0.0 }
        );
    }
}

#[test]
fn white_noise_adds_the_draws() {
    let t_s = times(20, 10.0);
    let draws: Draws = vec![(0..120).map(|i| (f64::from(i) * 0.37).sin()).collect()];
    let numbers = [("gyro_rad_s", 2e-3), ("acc_m_s2", 0.05)];
    let found = six(&swing(lively(), &[("white_noise", &numbers)])
        .record(&t_s, &draws)
        .unwrap());
    let mut expected = read(&[], &t_s);
    for (n, row) in expected.iter_mut().enumerate() {
        for (k, r) in row.iter_mut().enumerate() {
            *r += if k < 3 { 2e-3 } else { 0.05 } * draws[0][6 * n + k];
        }
    }
    assert_alike(&found, &expected, 1e-13);
}

#[test]
fn coloured_noise_has_the_spectrum_b_squared_over_f() {
    // One draw at the first sample shows a process: its size σ and, by its decay, its time
    // constant.
    let (b, interval_s, per_sample) = (0.03, 0.05, 66);
    let t_s = [0.0, interval_s];
    let ideal = read(&[], &t_s);
    let process = |k: usize| {
        let mut draws = vec![0.0; 2 * per_sample];
        draws[k] = 1.0;
        let noisy = swing(lively(), &[("coloured_noise", &[("gyro_rad_s", b)])]);
        assert_eq!(noisy.draws_per_sample().unwrap(), [per_sample]);
        let found = six(&noisy.record(&t_s, &vec![draws]).unwrap());
        let (first, second) = (found[0][0] - ideal[0][0], found[1][0] - ideal[1][0]);
        (first, -interval_s / (second / first).ln())
    };
    let processes: Vec<(f64, f64)> = (0..11).map(process).collect();
    for exponent in -30..=0 {
        let f = 10f64.powf(f64::from(exponent) / 10.0);
        // One-sided spectral density of a first-order Gauss–Markov process.
        let density: f64 = processes
            .iter()
            .map(|(s, tau)| 4.0 * s * s * tau / (1.0 + (TAU * f * tau).powi(2)))
            .sum();
        assert!(
            (density * f / (b * b) - 1.0).abs() < 0.1,
            "{f} Hz: {density}"
        );
    }
    // What a second draw adds keeps the variance: 1 − e^{−2Δ/τ}.
    let mut draws = vec![0.0; 2 * per_sample];
    draws[per_sample + 2] = 1.0;
    let noisy = swing(lively(), &[("coloured_noise", &[("gyro_rad_s", b)])]);
    let added = six(&noisy.record(&t_s, &vec![draws]).unwrap())[1][0] - ideal[1][0];
    let (size, tau) = processes[2];
    assert!((size * size - b * b * 0.5 * LN_10).abs() < 1e-9);
    assert!((added / size - (1.0 - (-2.0 * interval_s / tau).exp()).sqrt()).abs() < 1e-6);
}

#[test]
fn smooth_effects_have_their_derivatives() {
    let sensors: &[(&str, &[(&str, f64)])] = &[
        ("clock_scale", &[("error", 1e-3)]),
        ("jitter", &[("sampling_s", 1e-3)]),
        ("delay", &[("gyro_s", 0.01), ("acc_s", 0.02)]),
        (
            "low_pass",
            &[
                ("gyro_time_constant_s", 0.01),
                ("acc_time_constant_s", 0.02),
            ],
        ),
        (
            "phone_slip",
            &[
                ("at_s", 1.0),
                ("over_s", 1.0),
                ("turn_y_rad", 0.2),
                ("shift_z_m", 0.05),
            ],
        ),
        (
            "phone_mount_resonance",
            &[("turn_hz", 3.0), ("shift_hz", 4.0), ("damping_ratio", 0.2)],
        ),
        (
            "bias_drift",
            &[
                ("gyro_rate_x_rad_s2", 1e-3),
                ("acc_warm_y_m_s2", 0.1),
                ("warm_up_s", 2.0),
            ],
        ),
        ("gyro_scale", &[("z", 0.01)]),
        ("acc_scale", &[("x", 0.01)]),
        ("cross_axis", &[("gyro_zx", 0.01), ("acc_xz", 0.02)]),
        ("white_noise", &[("gyro_rad_s", 1e-3), ("acc_m_s2", 1e-2)]),
        (
            "coloured_noise",
            &[("gyro_rad_s", 1e-3), ("acc_m_s2", 1e-2)],
        ),
    ];
    let t_s = times(80, 20.0);
    let mut experiment = swing(lively(), sensors);
    experiment.held_s = 0.3;
    let needed = experiment.draws_per_sample().unwrap();
    let draws: Draws = needed
        .iter()
        .map(|n| {
            (0..n * t_s.len())
                .map(|i| (i as f64 * 0.61).sin())
                .collect()
        })
        .collect();
    let names = experiment.names();
    let wanted: Vec<usize> = (0..names.len())
        .filter(|i| {
            let name = &names[*i].0;
            // A reading at the release belongs to one side of it or the other.
            name.contains('.')
                || ["yaw_rad", "line_length_m", "inertia_zz_kg_m2"].contains(&name.as_str())
        })
        .collect();
    let found = experiment.derivatives(&wanted, &t_s, &draws).unwrap();
    let values = experiment.values();
    for (column, &i) in wanted.iter().enumerate() {
        let h = 1e-3 * values[i].abs().max(1e-2);
        let at = |shift: f64| {
            let mut moved = values.clone();
            moved[i] += shift;
            six(&experiment
                .with_values(&moved)
                .unwrap()
                .record(&t_s, &draws)
                .unwrap())
        };
        let (far, near) = ([at(h), at(-h)], [at(0.5 * h), at(-0.5 * h)]);
        let slope = |pair: &[Vec<[f64; 6]>; 2], n: usize, k: usize, h: f64| {
            (pair[0][n][k] - pair[1][n][k]) / (2.0 * h)
        };
        for k in 0..6 {
            let expected: Vec<f64> = (0..t_s.len())
                .map(|n| (4.0 * slope(&near, n, k, 0.5 * h) - slope(&far, n, k, h)) / 3.0)
                .collect();
            let size = expected.iter().fold(1e-3, |size: f64, x| size.max(x.abs()));
            for n in 0..t_s.len() {
                // What is felt jumps at the release, and lagged nodes cross it.
                if (0.2..1.0).contains(&t_s[n]) {
                    continue;
                }
                let found = found[(6 * n + k) * wanted.len() + column];
                let miss = (found - expected[n]).abs();
                assert!(
                    miss < 1e-6 * size,
                    "{}, reading {k} at {}: {} against {}",
                    names[i].0,
                    t_s[n],
                    found,
                    expected[n]
                );
            }
        }
    }
}

#[test]
fn every_effect_has_a_name_and_units() {
    let kinds = catalogue();
    assert_eq!(kinds.len(), 15);
    for (i, kind) in kinds.iter().enumerate() {
        assert!(!kind.numbers.is_empty(), "{}", kind.id);
        assert!(
            kinds[..i].iter().all(|other| other.id != kind.id),
            "{} twice",
            kind.id
        );
        assert!(
            kind.numbers.iter().all(|n| !n.unit.is_empty()),
            "{}",
            kind.id
        );
    }
}

#[test]
fn numbers_without_meaning_are_refused() {
    for (id, numbers) in [
        ("low_pass", [("gyro_time_constant_s", -0.1)]),
        ("phone_slip", [("over_s", 0.0)]),
        ("phone_mount_resonance", [("damping_ratio", 1.0)]),
    ] {
        let refused = swing(lively(), &[(id, &numbers)]).record(&[0.0, 1.0], &Draws::new());
        assert!(refused.unwrap_err().to_string().contains(id));
    }
}
