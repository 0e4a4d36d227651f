//! Cost of the live estimator per sample of both sensors at 200 Hz, looks at the whole swing
//! included, and the recorder's throughput with every block synced to the disk.
#![allow(missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use gyradius_core::online::{Live, LiveOptions};
use gyradius_core::recorder::{Header, Reader, Stream, Writer};
use gyradius_core::recording::Sensor;

/// A batch of a tenth of a second at 200 Hz.
const BATCH: i64 = 20;
const BATCHES: i64 = 1200;

/// Noise without a generator: the fractional parts of a quadratic phase, close to white.
fn noise(i: i64) -> f64 {
    let x = i as f64;
    (0.618_033_988_749_894_9 * x * x + 0.414_213_562_373_095 * x).fract() - 0.5
}

/// Stamps and both sensors' values of a batch: a turn of 5 degrees in 4.39 s, and sway in 3.80 s.
fn batch(number: i64) -> (Vec<i64>, Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let rows = number * BATCH..(number + 1) * BATCH;
    let turn = |t: f64| 0.125 * (-t / 600.0).exp() * (1.431 * t).sin();
    let sway = |t: f64| 0.05 * (-t / 300.0).exp() * (1.653 * t).sin();
    let t = |i: i64| 0.005 * i as f64;
    (
        rows.clone().map(|i| 5_000_000 * i).collect(),
        rows.clone()
            .map(|i| {
                [
                    2e-3 * noise(i),
                    2e-3 * noise(i + 7),
                    turn(t(i)) + 2e-3 * noise(i + 9),
                ]
            })
            .collect(),
        rows.map(|i| {
            [
                0.03 * noise(i + 1),
                sway(t(i)) + 0.03 * noise(i + 3),
                9.81 + 0.03 * noise(i + 5),
            ]
        })
        .collect(),
    )
}

fn live(criterion: &mut Criterion) {
    let batches: Vec<_> = (0..BATCHES).map(batch).collect();
    let mut group = criterion.benchmark_group("live, 120 s of both sensors at 200 Hz");
    group
        .throughput(Throughput::Elements((BATCH * BATCHES) as u64))
        .sample_size(10);
    group.bench_function("samples of both sensors", |b| {
        b.iter(|| {
            let mut live = Live::new(LiveOptions::default()).unwrap();
            for (stamps, gyroscope, accelerometer) in &batches {
                live.push(Sensor::Gyroscope, stamps, gyroscope).unwrap();
                live.push(Sensor::Accelerometer, stamps, accelerometer)
                    .unwrap();
            }
            live.estimate()
        });
    });
    group.finish();
}

fn recorder(criterion: &mut Criterion) {
    let batches: Vec<_> = (0..BATCHES).map(batch).collect();
    let path = std::env::temp_dir().join(format!("gyradius-bench-{}.gyr", std::process::id()));
    let write = || {
        let _ = std::fs::remove_file(&path);
        let mut writer = Writer::create(&path, &Header::default()).unwrap();
        for (stamps, gyroscope, accelerometer) in &batches {
            writer.push(Stream::Gyroscope, stamps, gyroscope).unwrap();
            writer
                .push(Stream::Accelerometer, stamps, accelerometer)
                .unwrap();
        }
        writer.end(0).unwrap().length
    };
    let mut group = criterion.benchmark_group("recorder, 120 s of both sensors at 200 Hz");
    group.throughput(Throughput::Bytes(write())).sample_size(10);
    group.bench_function("write, synced twice a second", |b| b.iter(write));
    group.bench_function("read", |b| {
        b.iter(|| {
            let mut reader = Reader::open(&path).unwrap();
            while let Some(piece) = reader.next_piece().unwrap() {
                std::hint::black_box(piece);
            }
        });
    });
    group.finish();
    let _ = std::fs::remove_file(&path);
}

criterion_group!(benches, live, recorder);
criterion_main!(benches);
