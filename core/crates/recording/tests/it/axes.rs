//! Any of the axes of a phone may be recorded: what is missing is missing, never zero.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;

use gyradius_recording::import::{ColumnMapping, ImportOptions, ImportedData, import_files};
use gyradius_recording::{
    ChannelQuantity, Recording, Sensor, Store, load_store, read_channel, read_recording,
    write_recording,
};

const ALL: [&str; 9] = ["gx", "gy", "gz", "ax", "ay", "az", "lx", "ly", "lz"];
const ROWS: usize = 30;

/// What a column holds: no two alike.
fn value(column: usize, row: usize) -> f64 {
    0.5 * (column + 1) as f64 + 0.25 * ((row * (column + 3)) % 7) as f64
}

/// A table of the columns of which the bit is set.
fn table(mask: usize, separator: char) -> String {
    let columns: Vec<usize> = (0..ALL.len()).filter(|c| mask >> c & 1 == 1).collect();
    let mut text = String::from("t");
    columns
        .iter()
        .for_each(|c| text += &format!("{separator}{}", ALL[*c]));
    for row in 0..ROWS {
        text += &format!("\n{}", 0.01 * row as f64);
        let cells = columns
            .iter()
            .map(|c| format!("{separator}{}", value(*c, row)));
        cells.for_each(|cell| text += &cell);
    }
    text + "\n"
}

fn held(recording: &Recording) -> BTreeMap<&'static str, Vec<f64>> {
    let sensors = recording.sensors().into_iter();
    let channels = sensors.flat_map(|sensor| sensor.channels);
    channels
        .map(|(name, samples)| (name, samples.to_vec()))
        .collect()
}

#[test]
fn every_subset_of_the_axes_is_read_kept_and_written() {
    for mask in 1..1 << ALL.len() {
        let recording = read_recording(table(mask, ',').as_bytes(), "a.csv").unwrap();
        let held = held(&recording);
        let expected: BTreeMap<&str, Vec<f64>> = (0..ALL.len())
            .filter(|c| mask >> c & 1 == 1)
            .map(|c| (ALL[c], (0..ROWS).map(|row| value(c, row)).collect()))
            .collect();
        assert_eq!(held, expected);
        // A vector is there only where all of its axes are.
        for (first, sensor) in [(0, &recording.gyroscope), (3, &recording.accelerometer)] {
            assert_eq!(sensor.is_some(), mask >> first & 7 == 7, "{mask:b}");
        }
        let mut back = read_recording(&write_recording(&recording), "a.csv").unwrap();
        back.repairs.clone_from(&recording.repairs);
        assert_eq!(back, recording);
    }
}

#[test]
fn one_axis_of_a_gyroscope_alone_is_a_rate_and_one_of_an_accelerometer_is_not() {
    let lone = |mask| {
        read_recording(table(mask, ',').as_bytes(), "a")
            .unwrap()
            .lone_quantity()
    };
    assert_eq!(lone(0b100), Some(ChannelQuantity::Rate));
    assert_eq!((lone(0b11), lone(0b1000), lone(0b1001)), (None, None, None));
    let rate = table(0b100, ',').replace("gz", "rate");
    let read = read_recording(rate.as_bytes(), "a").unwrap();
    assert_eq!(read.lone_quantity(), Some(ChannelQuantity::Rate));
    assert_eq!(
        read_channel(rate.as_bytes(), "a").unwrap().values.len(),
        ROWS
    );
}

/// A column that the logger wrote but never filled.
#[test]
fn an_axis_without_a_cell_is_missing_and_does_not_take_the_others_along() {
    let mut text = String::from("t,gx,gy,gz,ax\n");
    (0..ROWS).for_each(|row| text += &format!("{},,,{},\n", 0.01 * row as f64, value(2, row)));
    let recording = read_recording(text.as_bytes(), "a.csv").unwrap();
    assert_eq!(held(&recording).keys().copied().collect::<Vec<_>>(), ["gz"]);
    assert_eq!(recording.repairs, []);
    // A cell that is no number is damage: of its row, not of the axis.
    let damaged = text.replacen(",,,", ",nan,,", 1);
    let recording = read_recording(damaged.as_bytes(), "a.csv");
    assert!(recording.is_err(), "{recording:?}");
}

#[test]
fn axes_of_one_sensor_keep_their_common_clock_and_sensors_their_own() {
    let text = "t,gx,gz,ax\n0,1,2,\n0.01,,,9\n0.02,3,4,\n0.03,,,8\n0.04,5,6,\n0.05,,,7\n";
    let recording = read_recording(text.as_bytes(), "a.csv").unwrap();
    let sensors = recording.sensors();
    assert_eq!(sensors.len(), 2);
    assert_eq!(sensors[0].t_s, [0.0, 0.02, 0.04]);
    assert_eq!(
        (sensors[1].sensor, sensors[1].t_s),
        (Sensor::Accelerometer, &[0.01, 0.03, 0.05][..])
    );
}

fn imported(name: &str, text: &str, entries: &[&str]) -> (Recording, String) {
    let mapping = (!entries.is_empty()).then(|| ColumnMapping::from_entries(entries).unwrap());
    let options = ImportOptions {
        mapping,
        ..ImportOptions::default()
    };
    let inputs = [(name.to_owned(), text.as_bytes().to_vec())];
    let mut all = import_files(&inputs, &options).unwrap().recordings;
    assert_eq!(all.len(), 1);
    let summary = all[0].summary();
    match all.remove(0).data {
        ImportedData::Recording(recording) => (recording, summary),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_mapping_takes_any_axes_each_with_its_own_unit() {
    let text = table(0b1_0101, ',').replace("gx,gz,ay", "wx,wz,f");
    let entries = ["t=t:s", "gz=wz:deg/s", "ay=f:-g"];
    let (recording, summary) = imported("log.csv", &text, &entries);
    let held = held(&recording);
    assert_eq!(held.keys().copied().collect::<Vec<_>>(), ["ay", "gz"]);
    assert_eq!(held["gz"][3], value(2, 3).to_radians());
    assert_eq!(held["ay"][3], -9.80665 * value(4, 3));
    assert!(
        summary.contains("gyroscope (gz alone)") && summary.contains("accelerometer (ay alone)"),
        "{summary}"
    );
    let (axis, _) = imported("log.csv", &text, &["t=t:s", "ax=f:m/s2"]);
    assert_eq!(axis.incomplete[0].axes[0].as_ref().unwrap()[3], value(4, 3));
}

#[test]
fn headers_that_name_sensor_axis_and_unit_need_no_mapping() {
    let text = table(0b100, ';').replace("t;gz", "Time (s);Gyroscope z (deg/s)");
    let (recording, _) = imported("phone.csv", &text.replace('.', ","), &[]);
    assert_eq!(held(&recording)["gz"][3], value(2, 3).to_radians());
    // A whole set is worth more than a single column before it.
    let mut text = String::from("Time (s),Gyroscope z (rad/s)\n");
    (0..ROWS).for_each(|row| text += &format!("{},7\n", 0.01 * row as f64));
    let inputs = [
        ("z.csv".to_owned(), text.into_bytes()),
        (
            "all.csv".to_owned(),
            table(0b111, ',')
                .replace(
                    "t,gx,gy,gz",
                    "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)",
                )
                .into_bytes(),
        ),
    ];
    let all = import_files(&inputs, &ImportOptions::default()).unwrap();
    assert_eq!(all.recordings.len(), 2);
}

#[test]
fn an_incline_needs_all_of_gravity() {
    let session = "format = \"gyradius-session/1\"\n[body]\n[[incline]]\nend = \"bow\"\nmass = 1.0\n\
        arm = 1.0\ndepth = 0.0\nrecording = \"a.csv\"\n";
    let loaded = |mask| {
        let files = [
            ("session.toml", session.to_owned()),
            ("a.csv", table(mask, ',')),
        ];
        let files = files.map(|(name, text)| (name.to_owned(), text.into_bytes()));
        load_store(&Store::from_files("s", files.to_vec()).unwrap())
    };
    assert!(loaded(0b11_1000).is_ok());
    let text = loaded(0b1_1100).unwrap_err().to_string();
    assert!(
        text.contains("a.csv")
            && text.contains("ax, ay and az")
            && text.contains("gz, ax, ay alone"),
        "{text}"
    );
}
