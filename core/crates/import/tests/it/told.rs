//! What an import tells, and what the session that it writes still tells later.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::{Path, PathBuf};

use gyradius_import::{ImportRequest, import_session};
use gyradius_recording::{
    LoadedData, Orientation, Overwrite, Quantity, Repair, RepairKind, Sensor, Suspension,
    SuspensionKind, load_session,
};

pub fn request(mapping: &[&str]) -> ImportRequest {
    ImportRequest {
        mapping: mapping.iter().map(|entry| (*entry).to_owned()).collect(),
        trial: None,
        platform: None,
        flag_width_m: None,
        title: "boat".to_owned(),
        mass_kg: None,
        gravity_m_s2: None,
        suspension: Suspension {
            line_length_m: Some(Quantity::exact(2.0)),
            spacing_m: Some(Quantity::exact(1.0)),
            ..Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships)
        },
    }
}

/// Writes a file, imports it into a session and gives the notes and the folder of the session.
fn import(dir: &Path, name: &str, text: &str) -> (Vec<String>, PathBuf) {
    let file = dir.join(name);
    std::fs::write(&file, text).unwrap();
    let folder = dir.join("session");
    let notes = import_session(&[file], &folder, &request(&[]), Overwrite::Refuse).unwrap();
    (notes, folder)
}

fn repairs(folder: &Path) -> Vec<Repair> {
    match load_session(folder).unwrap().data.remove(0).data {
        LoadedData::Recording(recording) => recording.repairs,
        other => panic!("{other:?}"),
    }
}

/// phyphox rows of a gyroscope: `stamp` gives the time of a row, `z` its rate about z.
pub fn phyphox(rows: usize, stamp: impl Fn(usize) -> f64, z: impl Fn(usize) -> f64) -> String {
    let header = r#""Time (s)","Gyroscope x (rad/s)","Gyroscope y (rad/s)","Gyroscope z (rad/s)""#;
    let row = |i: usize| format!("{},{},0.5,{}\n", stamp(i), i as f64 / 8.0, z(i));
    format!("{header}\n{}", (0..rows).map(row).collect::<String>())
}

#[test]
fn stamps_of_whole_seconds_are_told_and_kept() {
    let dir = tempfile::tempdir().unwrap();
    // Three samples share each stamp: 40 of 60 have none of their own.
    let text = phyphox(60, |i| (i / 3) as f64, |i| i as f64);
    let (notes, folder) = import(dir.path(), "sec.csv", &text);
    let shared = "gyroscope: 60 samples share 20 stamps, 3 to a stamp; spread evenly from one stamp to the next";
    assert!(notes.iter().any(|note| note == shared), "{notes:?}");
    let kept = repairs(&folder);
    let told = kept.iter().find(|repair| repair.text == shared).unwrap();
    let (kind, sensor, count) = (RepairKind::SharedStamps, Sensor::Gyroscope, 40);
    assert_eq!((told.kind, told.sensor, told.count), (kind, sensor, count));
}

#[test]
fn a_clock_that_starts_again_and_a_limit_are_told_and_kept() {
    let dir = tempfile::tempdir().unwrap();
    // 40 rows, then the clock starts again for 20 rows.
    let text = phyphox(60, |i| 0.01 * (i % 40) as f64, |i| i as f64);
    let (notes, folder) = import(dir.path(), "wrap.csv", &text);
    let second = "gyroscope: 20 samples belong to a second recording in the same file; left out";
    assert!(notes.iter().any(|note| note == second), "{notes:?}");
    let kept = repairs(&folder);
    let told: Vec<_> = kept.iter().filter(|repair| repair.text == second).collect();
    assert_eq!((told.len(), told[0].kind), (1, RepairKind::SecondSwing));
}

#[test]
fn gaps_that_the_written_file_shows_are_told_once() {
    let dir = tempfile::tempdir().unwrap();
    // Half a second is missing after row 20.
    let text = phyphox(
        60,
        |i| 0.01 * i as f64 + if i > 20 { 0.5 } else { 0.0 },
        |i| i as f64,
    );
    let (notes, folder) = import(dir.path(), "gap.csv", &text);
    let stood_still = |text: &&String| text.contains("the record stood still in 1 gap");
    assert_eq!(notes.iter().filter(stood_still).count(), 1, "{notes:?}");
    let kept = repairs(&folder);
    assert_eq!(
        kept.iter()
            .map(|repair| &repair.text)
            .filter(stood_still)
            .count(),
        1
    );
}

#[test]
fn what_a_later_analysis_would_refuse_is_refused_at_import() {
    let dir = tempfile::tempdir().unwrap();
    // A sample every two seconds: the stamps look like milliseconds.
    let text = phyphox(150, |i| 2.0 * i as f64, |i| i as f64);
    let file = dir.path().join("packets.csv");
    std::fs::write(&file, text).unwrap();
    let folder = dir.path().join("session");
    let error = import_session(&[file], &folder, &request(&[]), Overwrite::Refuse);
    let text = error.unwrap_err().to_string();
    assert!(text.contains("look like milliseconds"), "{text}");
    assert!(!folder.exists());
}

#[test]
fn a_session_without_anything_to_tell_holds_nothing_more() {
    let dir = tempfile::tempdir().unwrap();
    let text = phyphox(60, |i| 0.01 * i as f64, |i| i as f64);
    let (notes, folder) = import(dir.path(), "clean.csv", &text);
    assert_eq!(notes, Vec::<String>::new());
    assert_eq!(load_session(&folder).unwrap().session.recorded, []);
}

/// Exports whose right reading is known from outside (`../shared/cases`, skipped aloud without it):
/// each has a gyroscope, and what is written of it is read back.
#[test]
fn the_shared_exports_become_sessions_with_a_gyroscope() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../../shared/cases");
    if !cases.is_dir() {
        println!("skipped: no ../shared/cases beside this clone");
        return;
    }
    for file in [
        "sensor-logger-json-sqlite/rec.sqlite",
        "sensor-logger-json-sqlite/2023-10-28.json",
        "sensor-logger-json-sqlite/ios_unc.zip",
        "sensor-logger-json-sqlite/wrist.zip",
        "sensor-logger-json-sqlite/Gyroscope.csv",
        "phyphox-bluetooth/puck.zip",
        "phyphox-bluetooth/bmi.csv",
        "phyphox-bluetooth/tag.csv",
        "phyphox-bluetooth/t_s.csv",
    ] {
        let dir = tempfile::tempdir().unwrap();
        let folder = dir.path().join("session");
        let files = [cases.join(file)];
        import_session(&files, &folder, &request(&[]), Overwrite::Refuse)
            .unwrap_or_else(|error| panic!("{file}: {error}"));
        let loaded = load_session(&folder).unwrap();
        let LoadedData::Recording(recording) = &loaded.data[0].data else {
            panic!("{file}: {:?}", loaded.data[0])
        };
        assert!(recording.gyroscope.is_some(), "{file}");
        if file.ends_with("unc.zip") || file.ends_with("wrist.zip") {
            let session = &loaded.session;
            let facts = (&*session.measured_on, &*session.phone, &*session.logger);
            assert_eq!(
                facts,
                ("2023-10-28", "iPhone", "Sensor Logger 1.29"),
                "{file}"
            );
        }
    }
}

#[test]
fn a_database_that_a_program_has_open_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("rec.sqlite");
    std::fs::write(&file, "SQLite format 3\0").unwrap();
    std::fs::write(dir.path().join("rec.sqlite-wal"), "rows").unwrap();
    let folder = dir.path().join("session");
    let error = import_session(&[file], &folder, &request(&[]), Overwrite::Refuse).unwrap_err();
    assert!(error.to_string().contains("rec.sqlite-wal"), "{error}");
}
