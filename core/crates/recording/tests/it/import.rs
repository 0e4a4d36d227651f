//! Exports of other programs. The fixtures and the motion they all hold are written by
//! `fixtures/make_import_fixtures.py`, from which the expected values here are taken by hand.
// Clippy's leave for tests does not reach the functions that tests share.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G0;
use gyradius_recording::import::{
    ColumnMapping, Format, ImportOptions, Imported, ImportedData, Platform, from_core_motion,
    import_files,
};
use gyradius_recording::{GateEvents, Recording, Repair, RepairKind, Sensor, Triad};
use gyradius_test_support::cases;
use proptest::prelude::*;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/import/");
const SHARED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../../shared/data/");
pub const ROWS: usize = 40;

pub fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(format!("{FOLDER}{name}")).unwrap()
}

pub fn import(names: &[&str]) -> Imported {
    let inputs: Vec<_> = names
        .iter()
        .map(|name| ((*name).to_owned(), bytes(name)))
        .collect();
    import_files(&inputs, &ImportOptions::default()).unwrap()
}

pub fn one(imported: &Imported) -> &Recording {
    assert_eq!(imported.recordings.len(), 1, "{imported:?}");
    recording(&imported.recordings[0].data)
}

fn recording(data: &ImportedData) -> &Recording {
    match data {
        ImportedData::Recording(recording) => recording,
        other => panic!("{other:?}"),
    }
}

fn mapping(entries: &[&str]) -> ImportOptions {
    ImportOptions {
        mapping: Some(ColumnMapping::from_entries(entries).unwrap()),
        ..ImportOptions::default()
    }
}

fn repairs(recording: &Recording, kind: RepairKind) -> Vec<&Repair> {
    recording
        .repairs
        .iter()
        .filter(|repair| repair.kind == kind)
        .collect()
}

fn time(row: usize) -> f64 {
    0.5 + 0.01 * row as f64
}

/// Compares with the fixtures' motion: `value` gives a row's three axes; stamps to rounding, values
/// to 1e-12 relative.
pub fn assert_triad(
    triad: Option<&Triad>,
    rows: impl Iterator<Item = usize>,
    value: impl Fn(f64) -> [f64; 3],
) {
    let triad = triad.unwrap();
    let rows: Vec<usize> = rows.collect();
    assert_eq!(triad.t_s.len(), rows.len());
    for (k, &row) in rows.iter().enumerate() {
        assert!(
            (triad.t_s[k] - time(row)).abs() < 1e-9,
            "row {row}: {}",
            triad.t_s[k]
        );
        for (axis, expected) in value(row as f64).into_iter().enumerate() {
            let found = triad.axes[axis][k];
            assert!(
                (found - expected).abs() <= 1e-12 * expected.abs(),
                "row {row}, axis {axis}: {found}"
            );
        }
    }
}

pub fn gyro(i: f64) -> [f64; 3] {
    [i / 8.0, -i / 4.0, 1.5]
}

pub fn acc(_: f64) -> [f64; 3] {
    [0.25, -0.5, 9.75]
}

fn free(i: f64) -> [f64; 3] {
    [i / 16.0, 0.0, -1.0]
}

#[test]
fn phyphox_dialects_give_the_same_recording() {
    for dialect in [
        "comma-point",
        "tab-point",
        "semicolon-point",
        "tab-comma",
        "semicolon-comma",
        "pendulum",
    ] {
        let imported = import(&[&format!("phyphox-{dialect}.csv")]);
        assert_eq!(imported.source, Format::Phyphox);
        assert_eq!(imported.recordings[0].name, format!("phyphox-{dialect}"));
        let recording = one(&imported);
        assert_triad(recording.gyroscope.as_ref(), 0..ROWS, gyro);
        assert!(recording.accelerometer.is_none());
        assert_eq!(recording.repairs, []);
    }
}

#[test]
fn phyphox_degrees_are_turned_into_radians() {
    let imported = import(&["phyphox-degrees.csv"]);
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, |i| {
        gyro(i).map(|w| w * std::f64::consts::PI / 180.0)
    });
}

#[test]
fn phyphox_archive_has_its_pause_put_back_and_its_range_used() {
    let imported = import(&["phyphox-android.zip"]);
    assert_eq!(imported.device["deviceModel"], "Pixel 0");
    let recording = one(&imported);
    let gyroscope = recording.gyroscope.as_ref().unwrap();
    // |y| reaches the stated range of 9.5 rad/s at row 38.
    assert_eq!(gyroscope.t_s.len(), 38);
    assert_eq!(repairs(recording, RepairKind::Saturation)[0].count, 2);
    // Paused at 0.695 s of experiment time, from 0.7 to 4.7 s of system time: row 20 on comes 4 s
    // later.
    for (row, t_s) in gyroscope.t_s.iter().enumerate() {
        let expected = time(row) + if row >= 20 { 4.0 } else { 0.0 };
        assert!((t_s - expected).abs() < 1e-6, "row {row}: {t_s}");
    }
    let pauses = repairs(recording, RepairKind::Pause);
    assert_eq!(pauses.len(), 3);
    assert_eq!((pauses[0].count, pauses[0].first_s), (1, 0.695));
    assert_eq!(
        pauses[0].text,
        "gyroscope: paused once, 4.000 s in all; put back from the system clock"
    );
    assert_eq!(
        recording.accelerometer.as_ref().unwrap().axes[2],
        [9.75; 20]
    );
    assert_eq!(
        recording.linear_accelerometer.as_ref().unwrap().axes[2],
        [-1.0; 20]
    );
}

#[test]
fn phyphox_composed_sets_are_told_by_their_names() {
    let imported = import(&["phyphox-ios-composed.zip"]);
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
    assert_triad(
        one(&imported).accelerometer.as_ref(),
        (0..ROWS).step_by(2),
        acc,
    );
}

#[test]
fn padding_of_the_shorter_column_is_no_sample() {
    for system in ["android", "ios"] {
        let imported = import(&[&format!("phyphox-padded-{system}.csv")]);
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        assert_triad(
            one(&imported).accelerometer.as_ref(),
            (0..ROWS).step_by(2),
            acc,
        );
        assert_eq!(one(&imported).repairs, []);
    }
}

#[test]
fn sensor_logger_columns_are_found_by_name_and_the_raw_gyroscope_is_preferred() {
    let imported = import(&["sensor-logger-android.zip"]);
    assert_eq!(imported.source, Format::SensorLogger);
    assert_eq!(imported.device["device name"], "Phone 0");
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, |i| {
        gyro(i).map(|w| w + 0.125)
    });
    assert_triad(
        one(&imported).accelerometer.as_ref(),
        (0..ROWS).step_by(2),
        acc,
    );
    assert!(one(&imported).linear_accelerometer.is_none());
}

#[test]
fn sensor_logger_on_ios_is_turned_unless_standardised_and_gravity_is_added_back() {
    for file in ["sensor-logger-ios-false.zip", "sensor-logger-ios-true.zip"] {
        let imported = import(&[file]);
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        assert_triad(
            one(&imported).accelerometer.as_ref(),
            (0..ROWS).step_by(2),
            acc,
        );
    }
}

#[test]
fn loose_files_of_one_folder_are_one_recording() {
    let names = [
        "sensor-logger-loose/Gyroscope.csv",
        "sensor-logger-loose/Accelerometer.csv",
    ];
    let imported = import(&names);
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
    assert_triad(
        one(&imported).linear_accelerometer.as_ref(),
        (0..ROWS).step_by(2),
        free,
    );
    assert!(
        imported.recordings[0]
            .notes
            .iter()
            .any(|note| note.contains("Android's sign"))
    );
    let inputs: Vec<_> = names
        .iter()
        .map(|name| ((*name).to_owned(), bytes(name)))
        .collect();
    let options = ImportOptions {
        platform: Some(Platform::Ios),
        ..ImportOptions::default()
    };
    let turned = import_files(&inputs, &options).unwrap();
    assert_eq!(
        one(&turned).linear_accelerometer.as_ref().unwrap().axes[2],
        [1.0; 20]
    );
    assert_triad(one(&turned).gyroscope.as_ref(), 0..ROWS, gyro);
}

#[test]
fn loose_files_with_the_same_sensor_are_recordings_of_their_own() {
    let imported = import(&[
        "phyphox-comma-point.csv",
        "phyphox-pendulum.csv",
        "native.csv",
        "light-gate.csv",
    ]);
    let names: Vec<&str> = imported
        .recordings
        .iter()
        .map(|recorded| recorded.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "phyphox-comma-point",
            "phyphox-pendulum",
            "native",
            "light-gate"
        ]
    );
    for recorded in &imported.recordings {
        if let ImportedData::Recording(recording) = &recorded.data {
            assert_triad(recording.gyroscope.as_ref(), 0..ROWS, gyro);
        }
    }
}

#[test]
fn folders_of_an_archive_are_recordings_of_their_own() {
    let imported = import(&["two-recordings.zip"]);
    let names: Vec<&str> = imported
        .recordings
        .iter()
        .map(|recorded| recorded.name.as_str())
        .collect();
    assert_eq!(names, ["pitch", "yaw"]);
    for recorded in &imported.recordings {
        assert_triad(recording(&recorded.data).gyroscope.as_ref(), 0..ROWS, gyro);
    }
}

#[test]
fn one_name_twice_is_refused_instead_of_one_being_lost() {
    let input = ("native.csv".to_owned(), bytes("native.csv"));
    let text = import_files(&[input.clone(), input], &ImportOptions::default())
        .unwrap_err()
        .to_string();
    assert!(text.contains("`native.csv` twice"), "{text}");
}

#[test]
fn physics_toolbox_accelerations_are_in_g() {
    for dialect in ["comma", "semicolon", "decimal-comma"] {
        let imported = import(&[&format!("physics-toolbox-{dialect}.csv")]);
        assert_eq!(imported.source, Format::PhysicsToolbox);
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        assert_triad(one(&imported).accelerometer.as_ref(), 0..ROWS, |_| {
            [0.25 * G0, -0.5 * G0, G0]
        });
    }
    let ios = import(&["physics-toolbox-ios.csv"]);
    // Rows come in pairs with one stamp. The gyroscope's differ: they are spread. The accelerometer's
    // are the same: they are one.
    let gyroscope = one(&ios).gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s.len(), ROWS);
    let is_even = |pair: &[f64]| (pair[1] - pair[0] - 0.01).abs() < 1e-9;
    assert!(gyroscope.t_s.windows(2).all(is_even));
    for (kind, sensor) in [
        (RepairKind::SharedStamps, Sensor::Gyroscope),
        (RepairKind::RepeatedStamp, Sensor::Accelerometer),
    ] {
        let found = repairs(one(&ios), kind);
        let told: Vec<_> = found.iter().map(|one| (one.sensor, one.count)).collect();
        assert_eq!(told, [(sensor, 20)], "{kind:?}");
    }
}

#[test]
fn sensorlog_turns_the_sign_of_ios_and_keeps_each_sensors_clock() {
    for dialect in ["comma", "semicolon", "bar"] {
        let imported = import(&[&format!("sensorlog-{dialect}.csv")]);
        assert_eq!(imported.source, Format::SensorLog);
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        let even = (0..ROWS).step_by(2);
        assert_triad(one(&imported).accelerometer.as_ref(), even, |_| {
            [0.25 * G0, -0.5 * G0, G0]
        });
        assert_eq!(
            repairs(one(&imported), RepairKind::RepeatedStamp)[0].count,
            20
        );
    }
}

#[test]
fn sensorlog_dates_are_a_clock_across_midnight() {
    let imported = import(&["sensorlog-dates.csv"]);
    let gyroscope = one(&imported).gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s.len(), ROWS);
    for (row, t_s) in gyroscope.t_s.iter().enumerate() {
        // Seconds since 1970 resolve 0.24 µs.
        assert!((t_s - 0.01 * row as f64).abs() < 1e-6, "row {row}: {t_s}");
        assert_eq!(gyroscope.axes[0][row], row as f64 / 8.0);
    }
}

#[test]
fn core_motion_has_the_opposite_sign_and_counts_in_g() {
    assert_eq!(
        from_core_motion([0.0, 0.5, -1.0]),
        [-0.0, -4.903325, 9.80665]
    );
}

#[test]
fn a_light_gate_log_gives_edges() {
    let imported = import(&["light-gate.csv"]);
    assert_eq!(imported.source, Format::LightGate);
    let expected = GateEvents {
        t_s: vec![0.0, 0.041376, 0.1425519, 1.25],
        a: vec![true, true, true, false],
        b: vec![false, true, false, false],
    };
    assert_eq!(
        imported.recordings[0].data,
        ImportedData::GateEvents(expected)
    );
}

const MAPPED: [&str; 4] = [
    "t=Millis:ms",
    "gx=p rate:deg/s",
    "gy=q rate:deg/s",
    "gz=r rate:deg/s",
];

fn import_mapped(more: &[&str]) -> gyradius_base::Result<Imported> {
    let inputs = [("mapped.csv".to_owned(), bytes("mapped.csv"))];
    import_files(&inputs, &mapping(&[&MAPPED[..], more].concat()))
}

#[test]
fn any_table_is_read_by_its_mapping() {
    let imported = import_mapped(&["lx=fwd:m/s2", "ly=port:m/s2", "lz=up:-g"]).unwrap();
    assert_eq!(imported.source, Format::Mapped);
    let recording = one(&imported);
    let gyroscope = recording.gyroscope.as_ref().unwrap();
    for row in 0..ROWS {
        assert!((gyroscope.t_s[row] - (1.0 + 0.01 * row as f64)).abs() < 1e-12);
        let half_turns = row as f64 / 2.0;
        assert!((gyroscope.axes[0][row] - half_turns * std::f64::consts::PI).abs() < 1e-12);
        assert!((gyroscope.axes[1][row] + half_turns * std::f64::consts::FRAC_PI_2).abs() < 1e-12);
        assert!((gyroscope.axes[2][row] - std::f64::consts::PI).abs() < 1e-12);
    }
    assert_eq!(
        recording.linear_accelerometer.as_ref().unwrap().axes[2],
        [0.5 * G0; ROWS]
    );
}

#[test]
fn a_mapping_is_held_against_gravity_and_against_the_file() {
    let cases: [(&[&str], &str); 2] = [
        (
            &["ax=port:m/s2", "ay=port:m/s2", "az=fwd:g"],
            "neither m/s2 nor g fits gravity",
        ),
        (
            &["ax=port:m/s2", "ay=port:m/s2", "az=aft:m/s2"],
            "expected a column `aft`",
        ),
    ];
    for (more, expected) in cases {
        let text = import_mapped(more).unwrap_err().to_string();
        assert!(text.contains(expected), "{text}");
    }
    let table = "t;x;y;z\n0,0;0,1;0,0;1,0\n0,1;0,0;0,1;0,9\n0,2;0,0;0,1;1,0\n";
    let inputs = [("a.csv".to_owned(), table.as_bytes().to_vec())];
    let text = import_files(
        &inputs,
        &mapping(&["t=t:s", "ax=x:m/s2", "ay=y:m/s2", "az=z:m/s2"]),
    )
    .unwrap_err();
    assert!(
        text.to_string().contains("the unit is probably g"),
        "{text}"
    );
    let right = import_files(&inputs, &mapping(&["t=t:s", "ax=x:g", "ay=y:g", "az=z:g"])).unwrap();
    assert_eq!(
        one(&right).accelerometer.as_ref().unwrap().axes[2][1],
        0.9 * G0
    );
    let track = import_files(&inputs, &mapping(&["t=t:s", "y=z:mm"])).unwrap();
    let ImportedData::Track(track) = &track.recordings[0].data else {
        panic!()
    };
    assert_eq!((track.y_m.len(), track.y_m[0]), (3, 1e-3));
    for bad in ["gx=p:m", "gw=p:rad/s", "gx=p", "gx", "gx=p:rpm"] {
        assert!(ColumnMapping::from_entries([bad]).is_err(), "{bad}");
    }
}

#[test]
fn what_is_no_export_is_refused_with_a_way_out() {
    let cases: [(&str, Vec<u8>, &str); 5] = [
        ("a.xlsx", bytes("workbook.xlsx"), "export as CSV"),
        (
            "a.xls",
            vec![0xD0, 0xCF, 0x11, 0xE0, 0xA1, 0xB1],
            "export as CSV",
        ),
        (
            "a.csv",
            b"time,pressure\n0,1\n1,2\n".to_vec(),
            "a column mapping",
        ),
        ("a.csv", Vec::new(), "an empty file"),
        ("a.zip", b"PK\x03\x04 and no more".to_vec(), "a.zip"),
    ];
    for (name, bytes, expected) in cases {
        let text = import_files(&[(name.to_owned(), bytes)], &ImportOptions::default())
            .unwrap_err()
            .to_string();
        assert!(text.contains(expected), "{text}");
    }
    assert!(import_files(&[], &ImportOptions::default()).is_err());
}

fn shared(name: &str) -> Option<(String, Vec<u8>)> {
    let bytes = std::fs::read(format!("{SHARED}{name}")).ok();
    if bytes.is_none() {
        println!("skipped: ../shared/data is absent");
    }
    Some((name.to_owned(), bytes?))
}

/// Counts taken over the files' stamps outside this program.
#[test]
fn the_phone_pendulum_comes_through_with_its_damage() {
    let Some(input) = shared("phone-pendulum/Gyroscope.csv") else {
        return;
    };
    let imported = import_files(&[input], &ImportOptions::default()).unwrap();
    let recording = one(&imported);
    let counts: Vec<_> = recording
        .repairs
        .iter()
        .map(|r| (r.kind, r.count))
        .collect();
    let expected = [
        (RepairKind::RepeatedStamp, 11),
        (RepairKind::BackwardStamp, 1),
        (RepairKind::MissingRows, 12),
    ];
    assert_eq!(counts, expected);
    assert_eq!(recording.gyroscope.as_ref().unwrap().t_s.len(), 17_987);
}

/// Counts taken over the files' stamps outside this program: late rows and stalls, and no other
/// damage but jitter.
#[test]
fn the_ducted_fan_comes_through_by_mapping() {
    let runs = [
        ("ducted-fan/PitchInertiaPendel01.csv", 754, 2),
        ("ducted-fan/RollInertiapendel01.csv", 799, 1),
        ("ducted-fan/YawInertiaPendel01.csv", 816, 1),
    ];
    let gyroscope = [
        "t=Time:ms",
        "gx=xGyro:deg/s",
        "gy=yGyro:deg/s",
        "gz=ZGyro:deg/s",
    ];
    let acceleration = ["lx=xAcc:m/s2", "ly=yAcc:m/s2", "lz=zAcc:m/s2"];
    for (name, missing, stalls) in runs {
        let Some(input) = shared(name) else { return };
        let options = mapping(&[&gyroscope[..], &acceleration[..]].concat());
        let imported = import_files(&[input], &options).unwrap();
        let of_gyroscope = one(&imported)
            .repairs
            .iter()
            .filter(|r| r.sensor == Sensor::Gyroscope);
        let counts: Vec<_> = of_gyroscope.map(|r| (r.kind, r.count)).collect();
        assert_eq!(
            counts[1..],
            [
                (RepairKind::MissingRows, missing),
                (RepairKind::Stall, stalls)
            ],
            "{name}"
        );
        assert_eq!(counts[0].0, RepairKind::Jitter);
        assert_eq!(
            one(&imported)
                .linear_accelerometer
                .as_ref()
                .unwrap()
                .t_s
                .len(),
            10_000
        );
    }
}

#[test]
fn the_light_gate_logs_give_every_edge() {
    let name = "light-gate-bar/spacing-0.3960m_length-0.62450m.csv";
    let Some(input) = shared(name) else { return };
    let rows = input
        .1
        .split(|b| *b == b'\n')
        .skip(3)
        .filter(|line| line.len() > 4)
        .count();
    let imported = import_files(&[input], &ImportOptions::default()).unwrap();
    let ImportedData::GateEvents(events) = &imported.recordings[0].data else {
        panic!()
    };
    assert_eq!(
        (events.t_s.len(), events.a.len(), events.b.len()),
        (rows, rows, rows)
    );
    assert_eq!(
        (events.t_s[1], events.a[1], events.b[1]),
        (0.041376, true, true)
    );
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn damaged_exports_never_panic(
        which in 0..12usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4u8), 1..12),
    ) {
        let name = [
            "phyphox-tab-comma.csv", "phyphox-android.zip", "sensor-logger-android.zip", "sensorlog-dates.csv",
            "physics-toolbox-semicolon.csv", "light-gate.csv", "native.csv", "phyphox-padded-ios.csv",
            "sensor-logger-utf8.sqlite", "sensor-logger-utf16.sqlite", "phyphox.xlsx", "phyphox-padded.xlsx",
        ][which];
        let mut bytes = bytes(name);
        for (at, byte, kind) in edits {
            let at = at.index(bytes.len().max(1));
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                2 => { bytes.remove(at); }
                _ => { let end = (at + usize::from(byte)).min(bytes.len()); bytes.drain(at..end); }
            }
            if bytes.is_empty() { break; }
        }
        let inputs = [(name.to_owned(), bytes)];
        if let Ok(imported) = import_files(&inputs, &ImportOptions::default()) {
            for recorded in &imported.recordings {
                let ImportedData::Recording(recording) = &recorded.data else { continue };
                let triads = [&recording.gyroscope, &recording.accelerometer, &recording.linear_accelerometer];
                for triad in triads.into_iter().flatten() {
                    prop_assert!(triad.t_s.windows(2).all(|pair| pair[0] < pair[1]));
                    prop_assert!(triad.axes.iter().all(|axis| axis.len() == triad.t_s.len()));
                }
            }
        }
        let _ = import_files(&inputs, &mapping(&MAPPED));
    }

    #[test]
    fn arbitrary_bytes_never_panic(name in ".{0,12}", bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = import_files(&[(name.clone(), bytes.clone())], &ImportOptions::default());
        let _ = import_files(&[(name, bytes)], &mapping(&MAPPED));
    }
}
