//! The day, the phone and the program that exports tell stay with the session.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use gyradius_import::{Growth, ImportRequest, import_into, import_session};
use gyradius_recording::recorder::{Header, Stream, Writer};
use gyradius_recording::{Overwrite, Session, load_session};

use crate::told::{phyphox, request};

/// An unpacked export of phyphox, recorded on a day with a phone; each has its own samples.
fn folder(dir: &Path, name: &str, phone: &str, day: &str) -> PathBuf {
    let meta = dir.join(name).join("meta");
    fs::create_dir_all(&meta).unwrap();
    let samples = phyphox(60, |i| 0.01 * i as f64, |i| (name.len() * i) as f64);
    fs::write(dir.join(name).join("Gyroscope.csv"), samples).unwrap();
    let device =
        format!("\"property\",\"value\"\n\"version\",\"1.1.16\"\n\"deviceModel\",\"{phone}\"\n");
    fs::write(meta.join("device.csv"), device).unwrap();
    let time = format!(
        "\"event\",\"experiment time\",\"system time\",\"system time text\"\n\"START\",0,1714992000,\"{day} 10:40:00.000 UTC+02:00\"\n\"PAUSE\",0.6,1714992000.6,\"{day} 10:40:00.600 UTC+02:00\"\n"
    );
    fs::write(meta.join("time.csv"), time).unwrap();
    dir.join(name)
}

fn imported(dir: &Path, files: &[PathBuf]) -> Session {
    let folder = dir.join("session");
    import_session(files, &folder, &request(&[]), Overwrite::Refuse).unwrap();
    load_session(&folder).unwrap().session
}

#[test]
fn what_all_recordings_say_stands_at_the_top() {
    let dir = tempfile::tempdir().unwrap();
    let files = [
        folder(dir.path(), "yaw", "Pixel 7", "2024-05-06"),
        folder(dir.path(), "tilted", "Pixel 7", "2024-05-06"),
    ];
    let session = imported(dir.path(), &files);
    assert_eq!(session.measured_on, "2024-05-06");
    assert_eq!(session.phone, "Pixel 7");
    assert_eq!(session.logger, "phyphox 1.1.16");
    assert!(
        session.recorded.iter().all(|one| one.phone.is_empty()),
        "{session:?}"
    );
}

#[test]
fn what_recordings_say_otherwise_stands_with_each() {
    let dir = tempfile::tempdir().unwrap();
    let files = [
        folder(dir.path(), "yaw", "Pixel 7", "2024-05-06"),
        folder(dir.path(), "tilted", "iPhone10,4", "2024-05-06"),
    ];
    let session = imported(dir.path(), &files);
    assert_eq!((&*session.measured_on, &*session.phone), ("2024-05-06", ""));
    let phones: Vec<&str> = session.recorded.iter().map(|one| &*one.phone).collect();
    assert_eq!(phones, ["Pixel 7", "iPhone10,4"]);

    // Another day's swing is added later.
    let file = folder(dir.path(), "roll", "Pixel 7", "2024-05-07");
    let later = ImportRequest {
        title: String::new(),
        ..request(&[])
    };
    let alike = Growth {
        like: Some("yaw".to_owned()),
        ..Growth::default()
    };
    import_into(&[file], &dir.path().join("session"), &later, &alike).unwrap();
    let session = load_session(dir.path().join("session")).unwrap().session;
    assert_eq!(session.measured_on, "2024-05-06");
    let last = session.recorded.last().unwrap();
    assert_eq!(
        (&*last.file, &*last.measured_on),
        ("roll.csv", "2024-05-07")
    );
    // The program is that of the session, and is not said again.
    assert_eq!((&*last.phone, &*last.logger), ("Pixel 7", ""));
}

#[test]
fn sensor_loggers_metadata_and_sensorlogs_dates_are_kept() {
    let dir = tempfile::tempdir().unwrap();
    let export = dir.path().join("yaw");
    fs::create_dir(&export).unwrap();
    let rows: String = (0..30)
        .map(|i| format!("{},{},1,2,{i}\n", i * 10_000_000, f64::from(i) / 100.0))
        .collect();
    fs::write(
        export.join("Gyroscope.csv"),
        format!("time,seconds_elapsed,z,y,x\n{rows}"),
    )
    .unwrap();
    let metadata = "version,device name,recording epoch time,recording time,recording timezone,platform,appVersion,standardisation\n3,Pixel 7,1698501144401,2023-10-28_13-52-24,Europe/Berlin,android,1.29,false\n";
    fs::write(export.join("Metadata.csv"), metadata).unwrap();
    let session = imported(dir.path(), &[export]);
    let facts = (&*session.measured_on, &*session.phone, &*session.logger);
    assert_eq!(facts, ("2023-10-28", "Pixel 7", "Sensor Logger 1.29"));

    let dir = tempfile::tempdir().unwrap();
    let header = "loggingTime(txt),gyroRotationX(rad/s),gyroRotationY(rad/s),gyroRotationZ(rad/s)";
    let rows: String = (0..30)
        .map(|i| format!("2024-03-01 12:00:00.{:03} +0100,{i},2,3\n", 10 * i))
        .collect();
    fs::write(dir.path().join("log.csv"), format!("{header}\n{rows}")).unwrap();
    let session = imported(dir.path(), &[dir.path().join("log.csv")]);
    assert_eq!(
        (&*session.measured_on, &*session.logger),
        ("2024-03-01", "SensorLog")
    );
}

#[test]
fn loose_files_of_one_folder_keep_each_its_day() {
    let dir = tempfile::tempdir().unwrap();
    let header = "loggingTime(txt),gyroRotationX(rad/s),gyroRotationY(rad/s),gyroRotationZ(rad/s)";
    let files = [1, 2].map(|day| {
        let row = |i: i32| format!("2024-03-0{day} 12:00:00.{:03} +0100,{i},{day},3\n", 10 * i);
        let path = dir.path().join(format!("day{day}.csv"));
        let rows: String = (0..30).map(row).collect();
        fs::write(&path, format!("{header}\n{rows}")).unwrap();
        path
    });
    let session = imported(dir.path(), &files);
    let days: Vec<&str> = session
        .recorded
        .iter()
        .map(|one| &*one.measured_on)
        .collect();
    assert_eq!(days, ["2024-03-01", "2024-03-02"]);
    assert_eq!((&*session.measured_on, &*session.logger), ("", "SensorLog"));
}

#[test]
fn a_recorders_file_says_its_phone() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("yaw.gyr");
    let header = Header {
        phone: "Pixel 7".to_owned(),
        ..Header::default()
    };
    let mut writer = Writer::create(&path, &header).unwrap();
    let stamps: Vec<i64> = (0..120).map(|i| 10_000_000 * i).collect();
    let values: Vec<[f64; 3]> = (0..120).map(|i| [f64::from(i), 1.0, 2.0]).collect();
    writer.push(Stream::Gyroscope, &stamps, &values).unwrap();
    drop(writer);
    let session = imported(dir.path(), &[path]);
    assert_eq!((&*session.phone, &*session.logger), ("Pixel 7", "gyradius"));
    assert_eq!(session.recorded[0].repairs.len(), 1);
}
