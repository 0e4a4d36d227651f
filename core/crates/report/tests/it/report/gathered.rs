//! A report straight from an analysis: every curve finite, thinned, and the page well formed.

use std::f64::consts::TAU;

use gyradius_base::language::Language;
use gyradius_identification::{MeasureOptions, measure_recording};
use gyradius_recording::{Recording, Triad};
use gyradius_report::{MOST_POINTS, ReportSource, html};

use crate::report::well_formed::assert_well_formed;

/// A phone lying flat that yaws with a period of 2.7 s: turn about z, gravity on z.
fn yawing() -> Recording {
    let t_s: Vec<f64> = (0..6000).map(|i| 0.01 * f64::from(i)).collect();
    let noise = |i: usize, channel: u64| {
        // Scrambled so that neighbours have nothing in common (splitmix64).
        let mut z = (i as u64 * 6 + channel + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64 - 0.5
    };
    let channel = |k: u64, size: f64, level: f64, amplitude: f64| -> Vec<f64> {
        let swing = |t: f64| amplitude * (-t / 200.0).exp() * (TAU * t / 2.7).cos();
        t_s.iter()
            .enumerate()
            .map(|(i, t)| level + swing(*t) + size * noise(i, k))
            .collect()
    };
    let gyroscope = [
        channel(0, 0.004, 0.0, 0.0),
        channel(1, 0.004, 0.0, 0.0),
        channel(2, 0.004, 0.0, 0.3),
    ];
    let accelerometer = [
        channel(3, 0.04, 0.0, 0.1),
        channel(4, 0.04, 0.0, 0.0),
        channel(5, 0.04, 9.81, 0.0),
    ];
    Recording {
        name: "yawing.csv".into(),
        gyroscope: Some(Triad {
            t_s: t_s.clone(),
            axes: gyroscope,
        }),
        accelerometer: Some(Triad {
            t_s,
            axes: accelerometer,
        }),
        ..Default::default()
    }
}

#[test]
fn a_bare_recording_becomes_a_page() {
    let analysis = measure_recording(&yawing(), &MeasureOptions::default()).expect("an analysis");
    let source = ReportSource::from_analysis(&analysis, None, Language::English);
    let [recording] = source.recordings.as_slice() else {
        panic!("one recording")
    };
    assert_eq!(recording.id, source.measurement.swings[0].id);
    let [turn, acceleration] = recording.traces.as_slice() else {
        panic!("two sensors")
    };
    assert_eq!(turn.label, "turn rate about the phone's z");
    assert_eq!(acceleration.label, "acceleration along the phone's x");
    for trace in &recording.traces {
        assert!(trace.measured.x.len() <= MOST_POINTS + 2);
        assert_eq!(trace.measured.x.len(), trace.measured.y.len());
        assert!(trace.close_up.is_some());
    }
    let spectrum = recording.spectrum.as_ref().expect("a spectrum");
    assert!(
        (spectrum.peaks[0].freq_hz - 1.0 / 2.7).abs() < 1e-3,
        "{:?}",
        spectrum.peaks
    );
    let page = html(&source);
    assert_well_formed(&page);
    assert!(page.contains("2.70"), "the period");
    std::fs::write(
        std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("report-gathered.html"),
        page,
    )
    .expect("written");
}
