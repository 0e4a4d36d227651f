//! A report straight from an analysis: every curve finite, thinned, and the page well formed.

use std::f64::consts::TAU;

use gyradius_base::language::Language;
use gyradius_identification::{MeasureOptions, analyse, measure_recording};
use gyradius_recording::{
    LoadedData, LoadedSession, LoadedSwing, Recording, Triad, read_period_list, read_session,
};
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

/// Fig. 6 of the paper: periods of a yaw that sway modulates, by eq. (14) with T_0 = 4.39 s, b =
/// −4e-6 1/s, C = 60 ms, T_m = 30 s and τ_m = 400 s.
#[test]
fn a_list_of_periods_is_drawn_with_its_beat() {
    let [t0, b, c, t_m, tau] = [4.39, -4e-6, 0.06, 30.0, 400.0];
    let law = |t: f64| t0 * (1.0 + b * t) + c * (-t / tau).exp() * (TAU * t / t_m + 0.4).sin();
    // Rounded to a millisecond, as a gate's clock is.
    let rows = (0..160).map(|i| {
        let t = t0 * f64::from(i);
        format!("{t:.3},{:.3}\n", law(t))
    });
    let csv = format!("t,period\n{}", rows.collect::<String>());
    let text = "format = \"gyradius-session/1\"\n[body]\nname = \"hull\"\n[site]\ngravity = 9.81\n\
        [[swing]]\nid = \"gate\"\nperiods = \"gate.csv\"\nexcited = [\"yaw\"]\n[swing.suspension]\n\
        kind = \"bifilar\"\norientation = \"athwartships\"\nline_length = 3.477\nspacing = 1.8\n";
    let session = read_session(text, "session.toml").expect("a session");
    let list = read_period_list(csv.as_bytes(), "gate.csv").expect("a list");
    let loaded = LoadedSession {
        data: vec![LoadedSwing {
            id: "gate".into(),
            data: LoadedData::Periods(list),
        }],
        session,
        source: "gate".into(),
        inclines: vec![],
        assumed: vec![],
    };
    let analysis = analyse(&loaded, &MeasureOptions::default()).expect("an analysis");
    for language in [Language::English, Language::German] {
        let source = ReportSource::from_analysis(&analysis, Some(&loaded), language);
        let [list] = source.periods.as_slice() else {
            panic!("one list")
        };
        assert_eq!(list.listed.x.len(), 160);
        for (t, period) in list.curve.points() {
            assert!((period - law(t)).abs() < 1e-3, "{period} at {t} s");
        }
        assert!(list.residual.y.iter().all(|left| left.abs() < 2e-3));
        let page = html(&source);
        assert_well_formed(&page);
        let picture = gyradius_report::figures(&source)
            .into_iter()
            .find(|figure| figure.id == "gate-periods")
            .expect("the picture");
        let caption = picture.caption.replace(',', ".").replace('\u{2212}', "-");
        let told = |name: &str| -> f64 {
            let figure = caption.split(&format!("{name} = ")).nth(1).expect(name);
            let digits = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
            let end = figure.find(|c| !digits(c)).expect(name);
            figure[..end].parse().expect(name)
        };
        let expected = [
            ("T₀", t0, 2e-4),
            ("b", 1e6 * b, 0.1),
            ("Tₘ", t_m, 5e-3),
            ("C", 1e3 * c, 0.5),
            ("τₘ", tau, 10.0),
        ];
        for (name, value, within) in expected {
            assert!((told(name) - value).abs() < within, "{name}: {caption}");
        }
        assert!(!picture.caption.contains('_'), "{}", picture.caption);
    }
    let page = html(&ReportSource::from_analysis(
        &analysis,
        Some(&loaded),
        Language::English,
    ));
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("gate.html"), page).expect("the page is written");
}
