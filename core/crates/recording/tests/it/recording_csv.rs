//! Reading and writing the project's own recordings. Expected values are written out by hand in
//! each case.
// Clippy's leave for tests does not reach the functions that tests share.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_base::Error;
use gyradius_recording::{
    Recording, Repair, RepairKind, Sensor, Triad, read_period_list, read_recording, read_track,
    write_recording,
};
use gyradius_test_support::cases;
use proptest::prelude::*;

fn read(text: &str) -> Recording {
    read_recording(text.as_bytes(), "swing.csv").unwrap()
}

fn refusal(text: &str) -> String {
    read_recording(text.as_bytes(), "swing.csv")
        .unwrap_err()
        .to_string()
}

/// `n` rows whose gx is the row's number and a half, at the given stamps.
fn rows(n: usize, stamp: impl Fn(usize) -> f64) -> String {
    let mut text = String::from("t,gx,gy,gz\n");
    for i in 0..n {
        text += &format!("{:.4},{}.5,-{},1\n", stamp(i), i, i);
    }
    text
}

fn only(recording: &Recording, kind: RepairKind) -> &Repair {
    let found: Vec<&Repair> = recording
        .repairs
        .iter()
        .filter(|repair| repair.kind == kind)
        .collect();
    assert_eq!(found.len(), 1, "{:?}", recording.repairs);
    found[0]
}

#[test]
fn sensors_keep_their_own_clocks_and_columns_their_names() {
    let recording = read(
        "\u{feff}\"az\",\"t\",gx,gy,gz,ax,ay\r\n9.81,0.5,1,2,3,0.1,0.2\r\n,0.51,4,5,6,,\r\n9.79,0.52,,,,0.3,0.4\r\n",
    );
    let gyroscope = recording.gyroscope.unwrap();
    assert_eq!(gyroscope.t_s, [0.5, 0.51]);
    assert_eq!(
        gyroscope.axes,
        [vec![1.0, 4.0], vec![2.0, 5.0], vec![3.0, 6.0]]
    );
    let accelerometer = recording.accelerometer.unwrap();
    assert_eq!(accelerometer.t_s, [0.5, 0.52]);
    assert_eq!(
        accelerometer.axes,
        [vec![0.1, 0.3], vec![0.2, 0.4], vec![9.81, 9.79]]
    );
    assert!(recording.linear_accelerometer.is_none());
    assert_eq!(recording.repairs, []);
}

#[test]
fn one_sensor_is_enough_and_gravity_free_columns_are_kept_apart() {
    let recording = read("t,lx,ly,lz\n0,1,2,3\n0.01,4,5,6\n");
    assert!(recording.gyroscope.is_none() && recording.accelerometer.is_none());
    assert_eq!(recording.linear_accelerometer.unwrap().axes[2], [3.0, 6.0]);
}

#[test]
fn what_cannot_be_read_is_said_with_its_place() {
    let few = "swing.csv: expected at least two rows of usable samples, found fewer than two";
    let empty = "swing.csv: expected a header and rows, found an empty file";
    let cases = [
        ("", empty),
        ("\r\n\n", empty),
        ("t,gx,gy,gz\n", few),
        ("t,gx,gy,gz\n0,1,2,3\n", few),
        (
            "gx,gy,gz\n1,2,3\n",
            "swing.csv, line 1: expected a column `t`, found `gx,gy,gz`",
        ),
        (
            "t,gx,gx\n1,2,3\n",
            "swing.csv, line 1: expected column `gx` once, found `t,gx,gx`",
        ),
        (
            "t,gx,gy,Gz\n1,2,3,4\n",
            "swing.csv, line 1: unknown key `Gz`; the nearest known key is `gz`",
        ),
        (
            "t\n1\n2\n",
            "swing.csv, line 1: expected columns of gx,gy,gz (gyroscope) or ax,ay,az (accelerometer), found `t`",
        ),
        (
            "t,gx,gy,gz\n0,1,2,3\n\n1,2,x1,4\n",
            "swing.csv, line 4: expected a number in column `gy`, found `x1`",
        ),
        (
            "t,gx,gy,gz\r\n0,1,2,3\r\n1,2,x1,4\r\n",
            "swing.csv, line 3: expected a number in column `gy`, found `x1`",
        ),
        (
            "t,gx,gy,gz\n0,1,2\n1,2,3,4\n",
            "swing.csv, line 2: expected 4 cells, as in the header, found 3",
        ),
        (
            "t,gx,gy,gz\n0,1,2,3,9\n1,2,3,4\n",
            "swing.csv, line 2: expected 4 cells, as in the header, found 5",
        ),
        (
            "t,gx,gy,gz\n0,1,2,3\n,2,3,4\n",
            "swing.csv, line 3: expected a time stamp, found an empty cell",
        ),
        (
            "\u{d0}",
            "swing.csv, line 1: unknown key `\u{d0}`; the nearest known key is `t`",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(refusal(text), expected, "{text:?}");
    }
    let workbook = read_recording(&[0xD0, 0xCF, 0x11, 0xE0, 0xA1], "a.xls")
        .unwrap_err()
        .to_string();
    assert_eq!(
        workbook,
        "a.xls: expected comma-separated text (export as CSV), found an Excel workbook (xls)"
    );
}

#[test]
fn a_last_row_cut_off_by_a_killed_app_costs_that_row_only() {
    let recording = read("t,gx,gy,gz\n0,1,2,3\n0.01,2,3,4\n0.02,5,");
    assert_eq!(recording.gyroscope.as_ref().unwrap().t_s, [0.0, 0.01]);
    assert_eq!(only(&recording, RepairKind::NotANumber).count, 1);
}

#[test]
fn stamps_in_another_unit_are_refused() {
    for (scale, unit) in [
        (1e3, "milliseconds"),
        (1e6, "microseconds"),
        (1e9, "nanoseconds"),
    ] {
        let text = refusal(&rows(1200, |i| 0.01 * i as f64 * scale));
        assert!(text.contains(unit), "{text}");
    }
}

#[test]
fn values_that_are_not_numbers_leave_the_row_out_for_that_sensor() {
    let recording = read(
        "t,gx,gy,gz,ax,ay,az\n0,1,1,1,0,0,9\n0.1,NaN,1,1,0,0,9\n0.2,1,inf,1,0,0,9\n0.3,1,,1,0,0,9\n0.4,1,1,1,0,0,9\n",
    );
    assert_eq!(recording.gyroscope.as_ref().unwrap().t_s, [0.0, 0.4]);
    assert_eq!(recording.accelerometer.as_ref().unwrap().t_s.len(), 5);
    let repair = only(&recording, RepairKind::NotANumber);
    assert_eq!(
        (repair.sensor, repair.count, repair.first_s, repair.last_s),
        (Sensor::Gyroscope, 3, 0.1, 0.3)
    );
    assert_eq!(
        repair.text,
        "gyroscope: 3 samples have a value that is not a number; left out"
    );
}

#[test]
fn a_sensor_without_a_usable_sample_is_absent_but_listed() {
    let recording = read("t,gx,gy,gz,ax,ay,az\n0,NaN,1,1,0,0,9\n0.1,NaN,1,1,0,0,9\n");
    assert!(recording.gyroscope.is_none());
    assert_eq!(only(&recording, RepairKind::NotANumber).count, 2);
}

#[test]
fn repeated_and_backward_stamps_are_left_out() {
    // Row 2 is repeated twice, row 7 steps back.
    let stamps = [0.0, 0.01, 0.02, 0.02, 0.02, 0.03, 0.04, 0.03, 0.05, 0.06];
    let recording = read(&rows(stamps.len(), |i| stamps[i]));
    let gyroscope = recording.gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s, [0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06]);
    assert_eq!(gyroscope.axes[0], [0.5, 1.5, 2.5, 5.5, 6.5, 8.5, 9.5]);
    let repeated = only(&recording, RepairKind::RepeatedStamp);
    assert_eq!(
        (repeated.count, repeated.first_s, repeated.last_s),
        (2, 0.02, 0.02)
    );
    let backward = only(&recording, RepairKind::BackwardStamp);
    assert_eq!(
        (backward.count, backward.first_s, backward.last_s),
        (1, 0.03, 0.03)
    );
    assert_eq!(recording.repairs.len(), 2);
}

#[test]
fn gaps_and_stalls_are_told_apart_by_ten_intervals() {
    let shift = |i: usize| match i {
        0..50 => 0.0,
        50..80 => 0.02,
        80..90 => 0.07,
        _ => 0.5,
    };
    let recording = read(&rows(120, |i| 0.01 * i as f64 + shift(i)));
    let missing = only(&recording, RepairKind::MissingRows);
    assert_eq!(
        (missing.count, missing.first_s, missing.last_s),
        (2, 0.49, 0.81)
    );
    assert_eq!(
        missing.text,
        "gyroscope: rows are missing in 2 gaps, up to 0.060 s long; left as gaps"
    );
    let stall = only(&recording, RepairKind::Stall);
    assert_eq!((stall.count, stall.first_s), (1, 0.96));
    assert_eq!(recording.gyroscope.unwrap().t_s.len(), 120);
}

#[test]
fn jitter_is_reported_above_a_twentieth_of_the_interval_and_used_as_it_stands() {
    // Every other stamp late by d: intervals 10 ms ± d, so their sd is d and the bound is at d =
    // 0.5 ms.
    let late = |ms: f64| move |i: usize| 0.01 * i as f64 + if i % 2 == 1 { 1e-3 * ms } else { 0.0 };
    let recording = read(&rows(101, late(1.0)));
    let jitter = only(&recording, RepairKind::Jitter);
    assert!(jitter.text.contains("by 1.00 ms"), "{}", jitter.text);
    assert_eq!(recording.gyroscope.as_ref().unwrap().t_s[1], 0.011);
    assert_eq!(read(&rows(101, late(0.4))).repairs, []);
    assert_eq!(read(&rows(101, late(0.0))).repairs, []);
}

#[test]
fn of_two_recordings_in_one_file_the_longer_is_kept() {
    for (first, second) in [(300, 500), (500, 300)] {
        let stamp = |i: usize| 0.01 * if i < first { i } else { i - first } as f64;
        let recording = read(&rows(first + second, stamp));
        let gyroscope = recording.gyroscope.as_ref().unwrap();
        assert_eq!(gyroscope.t_s.len(), 500);
        assert_eq!(
            gyroscope.axes[0][0],
            if first > second { 0.5 } else { 300.5 }
        );
        assert_eq!(only(&recording, RepairKind::SecondSwing).count, 300);
    }
}

#[test]
fn a_stray_stamp_far_ahead_or_behind_costs_its_own_row_only() {
    for stray in [1e6, -5.0] {
        let recording = read(&rows(
            400,
            |i| if i == 200 { stray } else { 0.01 * i as f64 },
        ));
        assert_eq!(recording.gyroscope.as_ref().unwrap().t_s.len(), 399);
        assert_eq!(only(&recording, RepairKind::BackwardStamp).count, 1);
    }
}

#[test]
fn a_file_that_runs_backwards_is_refused() {
    let text = refusal(&rows(50, |i| 10.0 - 0.01 * i as f64));
    assert_eq!(
        text,
        "swing.csv: expected time that runs forwards, found 49 of 49 steps of the gyroscope backwards"
    );
}

#[test]
fn a_clipped_channel_is_saturated_and_a_coarse_one_is_not() {
    let swing = |limit: f64, step: f64| {
        let mut text = String::from("t,gx,gy,gz\n");
        for i in 0..1200 {
            let t = 0.01 * i as f64;
            let x = 5.0 * (-0.05 * t).exp() * (4.7 * t).cos();
            let x = ((x / step).round() * step).clamp(-limit, limit);
            text += &format!("{t:.2},{x},0,0\n");
        }
        read(&text)
    };
    let clipped = swing(4.363, 0.001);
    let count = only(&clipped, RepairKind::Saturation).count;
    let gyroscope = clipped.gyroscope.unwrap();
    assert!(gyroscope.axes[0].iter().all(|x| x.abs() < 4.363));
    assert_eq!(gyroscope.t_s.len() + count, 1200);
    assert_eq!(swing(100.0, 0.001).repairs, []);
    assert_eq!(swing(100.0, 0.5).repairs, []);
    let level = |i: usize| 9.8 + 0.01 * (i / 7 % 2) as f64;
    let resting: String = (0..500)
        .map(|i| format!("{:.2},0,0,{}\n", 0.01 * i as f64, level(i)))
        .collect();
    assert_eq!(read(&("t,ax,ay,az\n".to_owned() + &resting)).repairs, []);
}

#[test]
fn tracks_and_period_lists_are_read_likewise() {
    let track = read_track(b"y,t\n0.5,0\n0.6,0.05\n0.7,0.1\nnan,0.15\n", "track.csv").unwrap();
    assert_eq!(
        (track.t_s, track.y_m),
        (vec![0.0, 0.05, 0.1], vec![0.5, 0.6, 0.7])
    );
    assert_eq!(track.repairs[0].sensor, Sensor::Displacement);
    let list = read_period_list(b"t,period\n1,4.39\n5.4,4.38\n5.4,4.38\n", "p.csv").unwrap();
    assert_eq!(
        (list.t_s, list.period_s),
        (vec![1.0, 5.4], vec![4.39, 4.38])
    );
    assert_eq!(list.repairs[0].kind, RepairKind::RepeatedStamp);
    let text = read_period_list(b"t,period\n1,4.39\n5.4,-1\n", "p.csv")
        .unwrap_err()
        .to_string();
    assert_eq!(
        text,
        "p.csv, line 3: expected a period above 0 s in column `period`, found -1"
    );
    let error = read_period_list(b"t,perod\n1,4.39\n", "p.csv").unwrap_err();
    assert!(matches!(error, Error::UnknownKey { nearest: Some(key), .. } if key == "period"));
}

/// Counted over the file's own stamps, outside this program: 1 steps back, 11 repeat, 12 gaps of
/// 20–30 ms remain.
#[test]
fn the_phone_pendulum_has_the_damage_that_was_counted_outside() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../../../shared/data/phone-pendulum/Gyroscope.csv"
    );
    let Ok(bytes) = std::fs::read(path) else {
        println!("skipped: ../shared/data is absent");
        return;
    };
    let text = String::from_utf8(bytes).unwrap().replace('\t', ",");
    let (_, body) = text.split_once('\n').unwrap();
    let recording = read(&format!("t,gx,gy,gz\n{body}"));
    assert_eq!(only(&recording, RepairKind::BackwardStamp).count, 1);
    assert_eq!(only(&recording, RepairKind::RepeatedStamp).count, 11);
    assert_eq!(only(&recording, RepairKind::MissingRows).count, 12);
    assert_eq!(recording.repairs.len(), 3, "{:?}", recording.repairs);
    assert_eq!(recording.gyroscope.unwrap().t_s.len(), 17_987);
}

fn triad(stamps: impl Strategy<Value = Vec<u32>>) -> impl Strategy<Value = Option<Triad>> {
    let samples = stamps.prop_flat_map(|stamps| {
        let mut t_s: Vec<f64> = stamps.iter().map(|&k| f64::from(k) * 1.3e-3).collect();
        t_s.sort_by(f64::total_cmp);
        t_s.dedup();
        let n = t_s.len();
        let axis = || prop::collection::vec(readings(), n);
        (Just(t_s), [axis(), axis(), axis()]).prop_map(|(t_s, axes)| Triad { t_s, axes })
    });
    prop::option::of(samples)
}

/// What a sensor may read: more than 1e12 in SI units is a damaged cell.
fn readings() -> impl Strategy<Value = f64> {
    prop_oneof![-1e3..1e3, -1e12..1e12, Just(0.0), 1e-300..1e-290]
}

fn kept_and_left_out(recording: &Recording, sensor: Sensor, triad: &Option<Triad>) -> usize {
    let gaps = [
        RepairKind::Jitter,
        RepairKind::MissingRows,
        RepairKind::Stall,
    ];
    let left_out = recording
        .repairs
        .iter()
        .filter(|r| r.sensor == sensor && !gaps.contains(&r.kind));
    left_out.map(|r| r.count).sum::<usize>() + triad.as_ref().map_or(0, |triad| triad.t_s.len())
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn what_is_written_reads_back_to_the_same_bits(
        gyroscope in triad(prop::collection::vec(0..100_000u32, 20..60)),
        accelerometer in triad(prop::collection::vec(0..100_000u32, 20..60)),
        linear_accelerometer in triad(prop::collection::vec(0..100_000u32, 20..60)),
    ) {
        let name = "r.csv".to_owned();
        let recording = Recording { name, gyroscope, accelerometer, linear_accelerometer, repairs: Vec::new(), ..Recording::default() };
        let any = recording.gyroscope.is_some()
            || recording.accelerometer.is_some()
            || recording.linear_accelerometer.is_some();
        prop_assume!(any);
        let mut back = read_recording(&write_recording(&recording), "r.csv").unwrap();
        back.repairs.clear();
        prop_assert_eq!(back, recording);
    }

    #[test]
    fn arbitrary_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = read_recording(&bytes, "a");
        let _ = read_track(&bytes, "a");
        let _ = read_period_list(&bytes, "a");
        let mut headed = b"t,gx,gy,gz\n".to_vec();
        headed.extend(&bytes);
        let _ = read_recording(&headed, "a");
    }

    #[test]
    fn every_row_is_kept_or_accounted_for(
        stamps in prop::collection::vec(prop_oneof![
            20 => (-3i32..4).prop_map(f64::from),
            1 => (-300i32..300).prop_map(f64::from),
            1 => Just(f64::NAN),
        ], 2..200),
        holes in prop::collection::vec(0..8u8, 200),
    ) {
        let mut text = String::from("t,gx,gy,gz,ax,ay,az\n");
        let (mut gyroscope, mut accelerometer) = (0, 0);
        for (i, (wobble, hole)) in stamps.iter().zip(&holes).enumerate() {
            let t = (2.0 * i as f64 + wobble) * 0.01;
            let cells = match hole {
                0 => ",,,1,2,9",
                1 => "1,2,3,,,",
                2 => ",,,,,",
                3 => "inf,2,3,1,,2",
                _ => "1,2,3,1,2,9",
            };
            gyroscope += usize::from(!matches!(hole, 0 | 2));
            accelerometer += usize::from(!matches!(hole, 1 | 2));
            text += &format!("{t},{cells}\n");
        }
        if let Ok(recording) = read_recording(text.as_bytes(), "a") {
            for triad in [&recording.gyroscope, &recording.accelerometer].into_iter().flatten() {
                prop_assert!(triad.t_s.windows(2).all(|pair| pair[0] < pair[1]));
                prop_assert!(triad.axes.iter().all(|axis| axis.len() == triad.t_s.len()));
                prop_assert!(triad.axes.iter().flatten().all(|v| v.is_finite()));
            }
            let both = [
                (Sensor::Gyroscope, &recording.gyroscope, gyroscope),
                (Sensor::Accelerometer, &recording.accelerometer, accelerometer),
            ];
            for (sensor, triad, rows) in both {
                // A sensor with a single usable sample is absent; that sample is then the one not
                // accounted for.
                let counted = kept_and_left_out(&recording, sensor, triad);
                prop_assert!(counted == rows || (triad.is_none() && counted + 1 == rows), "{counted} of {rows}");
            }
        }
    }
}

/// A minute at 100 Hz, and rows whose stamps have another origin.
#[test]
fn rows_beyond_a_step_of_the_clock_are_left_out() {
    let far = [10.0, 300.0, 1e4, 1.7e9, 9.223372036854776e18, 1e308];
    for ahead in far {
        let last = read(&rows(6000, |i| {
            0.01 * i as f64 + if i == 5999 { ahead } else { 0.0 }
        }));
        assert_eq!(last.gyroscope.as_ref().unwrap().t_s.len(), 5999, "{ahead}");
        assert_eq!(only(&last, RepairKind::StampStep).count, 1);
    }
    for ahead in [200.0, 1e5, 1e9] {
        for (from, kept) in [(2000, 4000), (4000, 4000), (3000, 3000)] {
            let step = |i: usize| 0.01 * i as f64 + if i >= from { ahead } else { 0.0 };
            let recording = read(&rows(6000, step));
            let t_s = &recording.gyroscope.as_ref().unwrap().t_s;
            assert_eq!(t_s.len(), kept, "{ahead} from {from}");
            assert!(t_s[t_s.len() - 1] - t_s[0] < 41.0);
            assert_eq!(only(&recording, RepairKind::StampStep).count, 6000 - kept);
        }
    }
}

/// The recorder stopped for less than it recorded, or sent bursts: nothing is left out.
#[test]
fn pauses_and_bursts_are_no_steps_of_the_clock() {
    let paused = |i: usize| 0.01 * i as f64 + if i >= 3000 { 20.0 } else { 0.0 };
    let bursts = |i: usize| 0.01 * i as f64 + 0.15 * (i / 10) as f64;
    for recording in [read(&rows(6000, paused)), read(&rows(6000, bursts))] {
        assert_eq!(recording.gyroscope.as_ref().unwrap().t_s.len(), 6000);
    }
}

/// Samples every 10 ms in packets of 30, 60 and 90, each with the stamp of its last sample.
#[test]
fn the_samples_of_a_packet_are_spread() {
    let size = |i: usize| [30, 60, 90][i % 3];
    let mut last_of = Vec::new();
    for packet in 0..60 {
        let before = last_of.len();
        last_of.extend(std::iter::repeat_n(before + size(packet) - 1, size(packet)));
    }
    let recording = read(&rows(last_of.len(), |i| 0.01 * last_of[i] as f64));
    let t_s = &recording.gyroscope.as_ref().unwrap().t_s;
    assert_eq!(t_s.len(), 3600);
    for (i, t_s) in t_s.iter().enumerate() {
        assert!((t_s - 0.01 * i as f64).abs() < 1e-9, "{i}: {t_s}");
    }
    let shared = only(&recording, RepairKind::SharedStamps);
    assert_eq!(shared.count, 3540);
    assert!(shared.text.contains("60 to a stamp"), "{}", shared.text);
    // Stamps in whole seconds: a second late, all of them.
    let seconds = read(&rows(6000, |i| (i / 100) as f64));
    let t_s = &seconds.gyroscope.as_ref().unwrap().t_s;
    assert_eq!(t_s.len(), 6000);
    for (i, t_s) in t_s.iter().enumerate() {
        assert!((t_s - (0.01 * i as f64 - 0.99)).abs() < 1e-9, "{i}: {t_s}");
    }
}

/// The gyroscope counts from the start of the phone, the accelerometer from 1970.
#[test]
fn a_sensor_with_a_clock_of_its_own_is_left_out() {
    let mut text = String::from("t,gx,gy,gz,ax,ay,az\n");
    for i in 0..100 {
        let t = 0.01 * f64::from(i);
        text += &format!("{t:.2},1,{i},3,,,\n{:.2},,,,0.1,{i},9.8\n", 1.7e9 + t);
    }
    // One column of time: the stamps of the two alternate.
    let recording = read(&text);
    assert_eq!(recording.gyroscope.unwrap().t_s.len(), 100);
    assert!(recording.accelerometer.is_none());
    let repair = recording
        .repairs
        .iter()
        .find(|r| r.kind == RepairKind::OtherClock);
    assert_eq!(repair.unwrap().count, 100);
}

#[test]
fn the_times_at_the_limit_are_kept() {
    let mut text = String::from("t,gx,gy,gz\n");
    for i in 0..400 {
        let x = (10.0 * (0.05 * f64::from(i)).sin()).clamp(-7.0, 7.0);
        text += &format!(
            "{:.2},{x},{:.3},0.1\n",
            0.01 * f64::from(i),
            0.001 * f64::from(i % 7)
        );
    }
    let recording = read(&text);
    let count = only(&recording, RepairKind::Saturation).count;
    assert!(count > 100);
    assert_eq!(recording.at_limit_s.len(), count);
    assert!(recording.at_limit_s.is_sorted());
}

/// Another program has left out what was at the limit, or whatever came by chance.
#[test]
fn gaps_at_the_extremes_of_a_channel_are_samples_at_its_limit() {
    let rows = |is_kept: &dyn Fn(i32, f64) -> bool| {
        let mut text = String::from("t,gx,gy,gz\n");
        for i in 0..3000 {
            let x = (0.02 * f64::from(i)).sin();
            if is_kept(i, x) {
                text += &format!("{:.2},{x},0.1,0.2\n", 0.01 * f64::from(i));
            }
        }
        read(&text)
    };
    let cut = rows(&|_, x| x.abs() < 0.7);
    let kept = cut.gyroscope.as_ref().unwrap().t_s.len();
    assert_eq!(cut.at_limit_s.len(), 3000 - kept);
    // Twenty gaps anywhere.
    let by_chance = rows(&|i, _| i % 150 > 12);
    assert!(by_chance.at_limit_s.is_empty());
    // The same with one value far off.
    let mut text = String::from("t,gx,gy,gz\n");
    for i in (0..3000).filter(|i| i % 150 > 12) {
        let x = if i == 777 {
            1e4
        } else {
            (0.02 * f64::from(i)).sin()
        };
        text += &format!("{:.2},{x},0.1,0.2\n", 0.01 * f64::from(i));
    }
    assert!(read(&text).at_limit_s.is_empty());
}
