//! Time of a whole decomposition of 120 s at 100 Hz, 12 000 samples × 6 channels: start values and
//! standard errors included, once with the number of modes found in the data, once with it known.
#![allow(missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use gyradius_core::signal::{ChannelGroup, DecomposeOptions, decompose};

/// Noise without a generator: the fractional parts of a quadratic phase, close to white.
fn noise(i: usize) -> f64 {
    let x = i as f64;
    (0.618_033_988_749_894_9 * x * x + 0.414_213_562_373_095 * x).fract() - 0.5
}

fn record(periods_s: &[f64]) -> Vec<ChannelGroup> {
    let t_s: Vec<f64> = (0..12_000)
        .map(|i| 0.01 * i as f64 + 1e-4 * noise(i))
        .collect();
    let channel = |c: usize| {
        let value = |(i, t): (usize, &f64)| {
            let swing = |(m, period): (usize, &f64)| {
                (0.2 / (1 + (c + 2 * m) % 5) as f64)
                    * (std::f64::consts::TAU * t / period + c as f64).cos()
            };
            let modes: f64 = periods_s.iter().enumerate().map(swing).sum();
            (-t / 640.0).exp() * modes + 0.017 * noise(i + 20_011 * (c + 1))
        };
        t_s.iter().enumerate().map(value).collect::<Vec<f64>>()
    };
    let group = |first: usize| ChannelGroup {
        t_s: t_s.clone(),
        channels: (first..first + 3).map(channel).collect(),
    };
    vec![group(0), group(3)]
}

fn periods(criterion: &mut Criterion) {
    for (name, periods_s) in [("one mode", vec![4.39]), ("two modes", vec![4.39, 4.26])] {
        let groups = record(&periods_s);
        let known = DecomposeOptions {
            mode_count: Some(periods_s.len()),
            ..DecomposeOptions::default()
        };
        for (how, options) in [
            ("searched", DecomposeOptions::default()),
            ("number known", known),
        ] {
            criterion.bench_function(&format!("{name}, {how}"), |b| {
                b.iter(|| decompose(&groups, &options))
            });
        }
    }
}

criterion_group!(benches, periods);
criterion_main!(benches);
