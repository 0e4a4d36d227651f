//! Tables as people have them: preambles, comments, separators, times as text, several files. Every
//! table is written here, so that each expected value is read off the row that it comes from.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::PI;
use std::io::{Cursor, Write};

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G0;
use gyradius_recording::import::{
    ColumnMapping, Format, ImportOptions, Imported, ImportedData, ImportedRecording, Input,
    import_files, import_inputs,
};
use gyradius_recording::{ChannelQuantity, Recording, Store};
use gyradius_test_support::cases;
use proptest::prelude::*;

const ROWS: usize = 20;

fn mapping(entries: &[&str]) -> ImportOptions {
    ImportOptions {
        mapping: Some(ColumnMapping::from_entries(entries).unwrap()),
        ..ImportOptions::default()
    }
}

pub fn files(files: &[(&str, &str)], options: &ImportOptions) -> gyradius_base::Result<Imported> {
    let inputs: Vec<_> = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()))
        .collect();
    import_files(&inputs, options)
}

pub fn only(imported: Imported) -> ImportedRecording {
    assert_eq!(imported.recordings.len(), 1, "{imported:?}");
    imported.recordings.into_iter().next().unwrap()
}

fn recording(imported: &ImportedRecording) -> &Recording {
    match &imported.data {
        ImportedData::Recording(recording) => recording,
        other => panic!("{other:?}"),
    }
}

/// Rows made by a function of their number.
fn rows(row: impl Fn(usize) -> String) -> String {
    (0..ROWS).map(|i| row(i) + "\n").collect()
}

/// The gyroscope has the rate `i` deg/s about x in row `i`, at 100 Hz from `start_s`.
fn assert_degrees(recording: &Recording, start_s: f64) {
    let gyroscope = recording.gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s.len(), ROWS);
    for i in 0..ROWS {
        let expected_s = start_s + 0.01 * i as f64;
        assert!(
            (gyroscope.t_s[i] - expected_s).abs() < 2e-6,
            "{}",
            gyroscope.t_s[i]
        );
        assert!((gyroscope.axes[0][i] - i as f64 * PI / 180.0).abs() < 1e-12);
        assert!((gyroscope.axes[1][i] - PI / 90.0).abs() < 1e-12);
        assert!((gyroscope.axes[2][i] + PI / 60.0).abs() < 1e-12);
    }
}

fn map_degrees(text: &str, time: &str, xyz: [&str; 3]) -> ImportedRecording {
    let [x, y, z] = xyz.map(|name| format!("={name}:deg/s"));
    let entries = [
        time.to_owned(),
        format!("gx{x}"),
        format!("gy{y}"),
        format!("gz{z}"),
    ];
    let entries: Vec<&str> = entries.iter().map(String::as_str).collect();
    only(files(&[("log.txt", text)], &mapping(&entries)).unwrap())
}

#[test]
fn headers_below_a_preamble_are_found() {
    let row = |i: usize| format!("{}, {}, {i}, 2, -3", i, 22_000_000 + 10_000 * i);
    let header = "\"loopIteration\",\"time\",\"gyroADC[0]\",\"gyroADC[1]\",\"gyroADC[2]\"\n";
    let product = "\"Product\",\"Flight recorder\"\n\"firmware\",\"1.2\"\n";
    let text = format!("{product}{header}{}", rows(row));
    let xyz = ["gyroADC[0]", "gyroADC[1]", "gyroADC[2]"];
    let imported = map_degrees(&text, "t=time:us", xyz);
    assert_degrees(recording(&imported), 22.0);
    assert_eq!(
        imported.not_used,
        ["log.txt: column `loopIteration` is not used"]
    );
    // Comments, a stated separator, and a preamble with the cells of a table.
    let row = |i: usize| format!("{},{i},2,-3", 10 * i);
    for preamble in [
        "# logged by ESP32, 100 Hz\n",
        "sep=,\n",
        "sep=,\nDeviceTag:,DOT-1\nOutputRate:,60Hz\n\n",
        "% rate, 100, 1, 1\n// more\n",
        "Created at 10:00\n\n",
        "version,1.3\ntscale,0.001\n",
    ] {
        let text = format!("{preamble}ms,gx,gy,gz\n{}", rows(row));
        assert_degrees(
            recording(&map_degrees(&text, "t=ms:ms", ["gx", "gy", "gz"])),
            0.0,
        );
    }
    // A wrong cell is told with its line, the preamble counted.
    let text = "# one\nsep=,\nms,gx,gy,gz\n0,1,2,3\n10,1,2,3\n20,x,2,3\n";
    let error = files(
        &[("log.txt", text)],
        &mapping(&["t=ms:ms", "gx=gx:deg/s", "gy=gy:deg/s", "gz=gz:deg/s"]),
    );
    let text = error.unwrap_err().to_string();
    assert!(
        text.contains("line 6") && text.contains("column `gx`"),
        "{text}"
    );
}

#[test]
fn units_rows_name_the_units() {
    let row = |i: usize| format!("{}\t{i}\t2\t-3\t", 1_600_000_000_000_i64 + 10 * i as i64);
    let header = "S1_Timestamp_Unix_CAL\tS1_Gyro_X_CAL\tS1_Gyro_Y_CAL\tS1_Gyro_Z_CAL\t\n";
    let units = "ms\tdeg/s\tdeg/s\tdeg/s\t\n";
    for preamble in ["", "\"sep=\t\"\n"] {
        let text = format!("{preamble}{header}{units}{}", rows(row));
        let imported = only(files(&[("sh.csv", &text)], &ImportOptions::default()).unwrap());
        assert_degrees(recording(&imported), 0.0);
        let xyz = ["S1_Gyro_X_CAL", "S1_Gyro_Y_CAL", "S1_Gyro_Z_CAL"];
        let mapped = map_degrees(&text, "t=S1_Timestamp_Unix_CAL:ms", xyz);
        assert_degrees(recording(&mapped), 0.0);
    }
}

#[test]
fn columns_without_names_have_numbers() {
    let row = |i: usize| {
        format!(
            "{i},2,-3,{}",
            8_925_125_000_000_000_i64 + 10_000_000 * i as i64
        )
    };
    let imported = map_degrees(&rows(row), "t=4:ns", ["1", "2", "3"]);
    assert_degrees(recording(&imported), 8_925_125.0);
    // Blanks between the cells, below a comment; several of them count once.
    let row = |i: usize| format!("{}  {i} \t2 -3", 10 * i);
    let text = format!("# Created at Fri Apr 23 03:53:31 GMT 2021\n{}", rows(row));
    assert_degrees(
        recording(&map_degrees(&text, "t=1:ms", ["2", "3", "4"])),
        0.0,
    );
    // A named column has a number too.
    let row = |i: usize| format!("{},{i},2,-3", 10 * i);
    let text = format!("a,b,b,b\n{}", rows(row));
    assert_degrees(
        recording(&map_degrees(&text, "t=#1:ms", ["#2", "#3", "#4"])),
        0.0,
    );
}

#[test]
fn decimal_commas_are_read_whatever_separates_the_cells() {
    for separator in [';', '\t', '|', ' '] {
        let s = separator;
        let row = |i: usize| {
            format!(
                "{}{s}{i},0{s}2,0{s}-3,0",
                format!("{:.2}", 0.01 * i as f64).replace('.', ",")
            )
        };
        let text = format!("t{s}x{s}y{s}z\n{}", rows(row));
        assert_degrees(
            recording(&map_degrees(&text, "t=t:s", ["x", "y", "z"])),
            0.0,
        );
    }
    let row = |i: usize| format!("{:.2};{i};2;-3", 0.01 * i as f64).replace('.', ",");
    let text = format!("t;gx;gy;gz\n{}", rows(row));
    let imported = only(files(&[("native.csv", &text)], &ImportOptions::default()).unwrap());
    assert_eq!(
        recording(&imported).gyroscope.as_ref().unwrap().axes[2],
        [-3.0; ROWS]
    );
}

#[test]
fn times_of_day_and_dates_are_clocks() {
    // 23:59:59.9 on; the day changes in row 10.
    let clock = |i: usize| match i {
        0..10 => format!("23:59:59.{:02}0", 90 + i),
        _ => format!("00:00:00.{:02}0", i - 10),
    };
    let day = |i: usize| if i < 10 { "2024-02-29" } else { "2024-03-01" };
    let start = 24.0 * 3600.0 - 0.1;
    let of_day = rows(|i| format!("{},{i},2,-3", clock(i)));
    let imported = map_degrees(
        &format!("Clock,x,y,z\n{of_day}"),
        "t=Clock:clock",
        ["x", "y", "z"],
    );
    assert_degrees(recording(&imported), start);
    let dated = rows(|i| format!("{} {},{i},2,-3", day(i), clock(i)));
    let imported = map_degrees(
        &format!("Date,x,y,z\n{dated}"),
        "t=Date:clock",
        ["x", "y", "z"],
    );
    assert_degrees(recording(&imported), 0.0);
    let serial = rows(|i| format!("{} -> {i},2,-3", clock(i)));
    let imported = map_degrees(&serial, "t=1:clock", ["2", "3", "4"]);
    assert_degrees(recording(&imported), start);
    let no_time = files(
        &[("a.csv", "a,x,y,z\n1,2,3,4\n2,2,3,4\n")],
        &mapping(&["t=a:clock", "gx=x:deg/s", "gy=y:deg/s", "gz=z:deg/s"]),
    );
    let text = no_time.unwrap_err().to_string();
    assert!(text.contains("a time of day in column `a`"), "{text}");
}

#[test]
fn cells_that_name_themselves_are_columns() {
    let plotter = rows(|i| format!("ms:{},rx:{i},ry: 2,rz:-3", 10 * i));
    assert_degrees(
        recording(&map_degrees(&plotter, "t=ms:ms", ["rx", "ry", "rz"])),
        0.0,
    );
    let monitor = rows(|i| format!("10:00:00.{:02}0 -> rx={i} ry=2 rz=-3", i));
    assert_degrees(
        recording(&map_degrees(&monitor, "t=1:clock", ["rx", "ry", "rz"])),
        36_000.0,
    );
}

#[test]
fn a_frame_rate_stands_in_for_a_time_column() {
    let text = format!("frame,x,y,z\n{}", rows(|i| format!("{},{i},2,-3", 100 + i)));
    let xyz = ["x", "y", "z"];
    assert_degrees(recording(&map_degrees(&text, "t=frame:100Hz", xyz)), 1.0);
    assert_degrees(recording(&map_degrees(&text, "t=row:100Hz", xyz)), 0.0);
    assert_degrees(recording(&map_degrees(&text, "t=:100fps", xyz)), 0.0);
}

const TAGGED: [&str; 7] = [
    "t=Stamp:ms",
    "gx=x@Gyro:deg/s",
    "gy=y@Gyro:deg/s",
    "gz=z@Gyro:deg/s",
    "ax=x@Accel:m/s2",
    "ay=y@Accel:m/s2",
    "az=z@Accel:m/s2",
];

#[test]
fn rows_tagged_by_sensor_are_told_apart() {
    let row = |i: usize| {
        format!(
            "Gyro,{},{i},2,-3\nAccel,{},0.25,-0.5,9.75",
            10 * i,
            10 * i + 3
        )
    };
    let text = format!("Type,Stamp,x,y,z\n{}", rows(row));
    let imported = only(files(&[("tagged.csv", &text)], &mapping(&TAGGED)).unwrap());
    assert_degrees(recording(&imported), 0.0);
    let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
    assert_eq!(accelerometer.axes[2], [9.75; ROWS]);
    assert!((accelerometer.t_s[1] - 0.013).abs() < 1e-12);
    assert_eq!(imported.not_used, Vec::<String>::new());
}

/// A gyroscope and an accelerometer in two files, each with its own clock.
fn two_files() -> [(&'static str, String); 2] {
    let gyroscope = rows(|i| format!("{:.3},{i},2,-3", 0.01 * i as f64));
    let accelerometer = rows(|i| format!("{:.3},0,0,1", 0.003 + 0.01 * i as f64));
    let header = "elapsed,x,y,z\n";
    [
        ("mw_Gyro.csv", format!("{header}{gyroscope}")),
        ("mw_Accel.csv", format!("{header}{accelerometer}")),
    ]
}

#[test]
fn one_mapping_takes_several_files() {
    let [gyroscope, accelerometer] = two_files();
    let pair = [
        (gyroscope.0, gyroscope.1.as_str()),
        (accelerometer.0, accelerometer.1.as_str()),
    ];
    let mut entries = TAGGED.map(|entry| entry.replace(":m/s2", ":g"));
    entries[0] = "t=elapsed:s".to_owned();
    let entries: Vec<&str> = entries.iter().map(String::as_str).collect();
    let imported = only(files(&pair, &mapping(&entries)).unwrap());
    assert_degrees(recording(&imported), 0.0);
    let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
    assert_eq!(accelerometer.axes[2], [G0; ROWS]);
    assert_eq!(accelerometer.t_s[0], 0.003);
    // Without the files' names it is not clear which is meant; each is then complete by itself.
    let bare = ["t=elapsed:s", "gx=x:deg/s", "gy=y:deg/s", "gz=z:deg/s"];
    assert_eq!(files(&pair, &mapping(&bare)).unwrap().recordings.len(), 2);
}

pub fn zip<T: AsRef<[u8]>>(members: &[(&str, T)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        zip.start_file(*name, zip::write::SimpleFileOptions::default())
            .unwrap();
        zip.write_all(content.as_ref()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

#[test]
fn a_mapping_reaches_the_tables_of_an_archive() {
    let text = format!(
        "Uhr (s),p,q,r\n{}",
        rows(|i| format!("{},{i},2,-3", 0.01 * i as f64))
    );
    let device = "\"property\",\"value\"\n\"deviceModel\",\"x\"\n";
    let bytes = zip(&[
        ("Set.csv", text.as_str()),
        ("meta/device.csv", device),
        ("meta/photo.png", "x"),
    ]);
    let options = mapping(&["t=Uhr (s):s", "gx=p:deg/s", "gy=q:deg/s", "gz=r:deg/s"]);
    let imported = only(import_files(&[("puck.zip".to_owned(), bytes.clone())], &options).unwrap());
    assert_degrees(recording(&imported), 0.0);
    let not_used = imported.not_used.join("; ");
    assert!(
        not_used.contains("`device.csv`") && not_used.contains("`photo.png`"),
        "{not_used}"
    );
    let wrong = mapping(&["t=Uhr (s):s", "gx=P:deg/s", "gy=q:deg/s", "gz=r:deg/s"]);
    let error = import_files(&[("puck.zip".to_owned(), bytes)], &wrong)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("Set.csv, line 1") && error.contains("column `P`"),
        "{error}"
    );
}

#[test]
fn phyphox_bluetooth_columns_are_known() {
    let columns = [
        [
            "Angular velocity x (deg/s)",
            "Angular velocity y (deg/s)",
            "Angular velocity z (deg/s)",
        ],
        ["Gyr X (°/s)", "Gyr Y (°/s)", "Gyr Z (°/s)"],
        [
            "Gyroscope x (°/s)",
            "Gyroscope y (°/s)",
            "Gyroscope z (°/s)",
        ],
    ];
    for [x, y, z] in columns {
        for time in ["Time (s)", "t (s)"] {
            let header = format!(
                "\"{time}\",\"{x}\",\"{y}\",\"{z}\",\"Acc X (m/s²)\",\"Acc Y (m/s²)\",\"Acc Z (m/s²)\",\"Battery (V)\"\n"
            );
            let text =
                header + &rows(|i| format!("{},{i},2,-3,0.25,-0.5,9.75,3.7", 0.01 * i as f64));
            let imported = only(files(&[("tag.csv", &text)], &ImportOptions::default()).unwrap());
            assert_degrees(recording(&imported), 0.0);
            let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
            assert_eq!(accelerometer.axes[2], [9.75; ROWS]);
            assert_eq!(
                imported.not_used,
                ["tag.csv: column `Battery (V)` is not used"]
            );
        }
    }
}

#[test]
fn a_folder_is_read_as_the_archive_that_it_was() {
    let set = |i: usize| format!("{},{i},2,-3", 0.01 * i as f64);
    let gyroscope = format!(
        "Time (s),Gyroscope x (°/s),Gyroscope y (°/s),Gyroscope z (°/s)\n{}",
        rows(set)
    );
    let time = "event,experiment time,system time,system time text\nSTART,0,100,x\nPAUSE,0.095,101,x\nSTART,0.095,103,x\n";
    let store = Store::from_files(
        "export",
        [
            ("Gyroscope.csv".to_owned(), gyroscope.into_bytes()),
            ("meta/time.csv".to_owned(), time.as_bytes().to_vec()),
        ],
    );
    let inputs = [Input::Folder(store.unwrap())];
    let imported = only(import_inputs(&inputs, &ImportOptions::default()).unwrap());
    assert_eq!(imported.name, "export");
    // Row 10 is at 0.1 s; 2 s of pause come before it.
    let t_s = &recording(&imported).gyroscope.as_ref().unwrap().t_s;
    assert!((t_s[9] - 0.09).abs() < 1e-12 && (t_s[10] - 2.1).abs() < 1e-12);
    assert!(
        imported
            .told()
            .iter()
            .any(|text| text.contains("paused once, 2.000 s"))
    );
}

#[test]
fn sensor_logger_json_is_its_archive_in_one_list() {
    let sample = |i: usize| {
        format!(
            "{{\"sensor\":\"Gyroscope\",\"time\":\"{}\",\"seconds_elapsed\":\"{}\",\"z\":\"-3\",\"y\":2,\"x\":{i}}},\
         {{\"sensor\":\"TotalAcceleration\",\"seconds_elapsed\":{},\"z\":-9.75,\"y\":0.5,\"x\":-0.25}},\
         {{\"sensor\":\"Magnetometer\",\"seconds_elapsed\":{},\"z\":1,\"y\":1,\"x\":1}}",
            1_698_501_144_000_000_000_i64 + 10_000_000 * i as i64,
            0.01 * i as f64,
            0.003 + 0.01 * i as f64,
            0.01 * i as f64,
        )
    };
    let samples: Vec<String> = (0..ROWS).map(sample).collect();
    let metadata = "{\"sensor\":\"Metadata\",\"platform\":\"ios\",\"device name\":\"Phone 0\",\"standardisation\":\"false\"}";
    let text = format!("[{metadata},{}]", samples.join(","));
    let imported = files(&[("2023-10-28.json", &text)], &ImportOptions::default()).unwrap();
    assert_eq!(
        (imported.source, imported.device["device name"].as_str()),
        (Format::SensorLogger, "Phone 0")
    );
    let imported = only(imported);
    let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
    assert_eq!((gyroscope.axes[0][7], gyroscope.axes[2][7]), (7.0, -3.0));
    assert_eq!(
        recording(&imported).accelerometer.as_ref().unwrap().axes[2],
        [9.75; ROWS]
    );
    assert_eq!(imported.not_used, ["`Magnetometer.csv` is not used"]);
    let broken = files(
        &[("a.json", "[{\"sensor\":\"Gyroscope\",\n \"x\":1,}]")],
        &ImportOptions::default(),
    );
    let text = broken.unwrap_err().to_string();
    assert!(text.contains("a.json, line 2"), "{text}");
}

#[test]
fn sensor_logger_files_without_elapsed_time_and_of_a_watch_are_read() {
    let ns = |i: usize| 1_698_501_144_000_000_000_i64 + 10_000_000 * i as i64;
    let text = format!("time,z,y,x\n{}", rows(|i| format!("{},-3,2,{i}", ns(i))));
    let imported = only(files(&[("Gyroscope.csv", &text)], &ImportOptions::default()).unwrap());
    let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
    // Unix time in ns resolves 0.26 µs.
    assert!((gyroscope.t_s[7] - 0.07).abs() < 1e-6);
    assert_eq!((gyroscope.axes[0][7], gyroscope.axes[2][7]), (7.0, -3.0));

    let axes = |stem: &str| format!("{stem}X,{stem}Y,{stem}Z");
    let header = [axes("rotationRate"), axes("gravity"), axes("acceleration")].join(",");
    let row = |i: usize| format!("{},{},{i},2,-3,0,0,-1,0.5,0,0", ns(i), 0.01 * i as f64);
    let text = format!("time,seconds_elapsed,{header}\n{}", rows(row));
    let imported = only(files(&[("WristMotion.csv", &text)], &ImportOptions::default()).unwrap());
    let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
    // In g with the sign of iOS: gravity −1 becomes +9.80665, 0.5 becomes −4.903325.
    assert_eq!(
        (accelerometer.axes[0][3], accelerometer.axes[2][3]),
        (-0.5 * G0, G0)
    );
    assert_eq!(
        recording(&imported).gyroscope.as_ref().unwrap().axes[0][7],
        7.0
    );
}

#[test]
fn an_uncalibrated_accelerometer_in_g_is_used_where_there_is_no_other() {
    let row = |i: usize, z: f64| format!("{},{},{z},0,0", 10_000_000 * i, 0.01 * i as f64);
    let header = "time,seconds_elapsed,z,y,x\n";
    let gyroscope = header.to_owned() + &rows(|i| row(i, 1.0));
    let accelerometer = header.to_owned() + &rows(|i| row(i, -1.0));
    let metadata = "platform,device name,standardisation\nios,Phone,false\n";
    let bytes = zip(&[
        ("Gyroscope.csv", gyroscope.as_str()),
        ("AccelerometerUncalibrated.csv", accelerometer.as_str()),
        ("Metadata.csv", metadata),
    ]);
    let imported =
        only(import_files(&[("unc.zip".to_owned(), bytes)], &ImportOptions::default()).unwrap());
    let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
    assert_eq!(accelerometer.axes[2], [G0; ROWS]);
    assert!(imported.told().iter().any(|text| text.contains("in g")));
}

#[test]
fn sensorlog_of_a_watch_has_gravity_put_back() {
    let axes = |stem: &str, unit: &str| format!("{stem}X({unit}),{stem}Y({unit}),{stem}Z({unit})");
    let header = [
        "loggingTime(txt),motionTimestamp_sinceReboot(s),motionYaw(rad)".to_owned(),
        axes("motionRotationRate", "rad/s"),
        axes("motionUserAcceleration", "G"),
        axes("motionGravity", "G"),
    ];
    let row = |i: usize| {
        format!(
            "2026-06-07 17:05:00.000 +0200,{},0,{i},2,-3,0.5,0,0,0,0,-1",
            1000.0 + 0.01 * i as f64
        )
    };
    let text = format!("{}\n{}", header.join(","), rows(row));
    let imported = only(files(&[("slog.csv", &text)], &ImportOptions::default()).unwrap());
    let accelerometer = recording(&imported).accelerometer.as_ref().unwrap();
    assert_eq!(
        (accelerometer.axes[0][3], accelerometer.axes[2][3]),
        (-0.5 * G0, G0)
    );
    assert!(recording(&imported).linear_accelerometer.is_none());
    let expected = "slog.csv: columns `loggingTime(txt)`, `motionYaw(rad)` are not used";
    assert_eq!(imported.not_used, [expected]);
}

#[test]
fn gyroflow_logs_have_their_scales() {
    let preamble = "GYROFLOW IMU LOG\nversion,1.3\nid,custom\norientation,XYZ\nvendor,x\ntscale,0.001\ngscale,0.5\nascale,0.25\n";
    let text = format!(
        "{preamble}t,gx,gy,gz,ax,ay,az\n{}",
        rows(|i| format!("{},{i},2,-3,0,0,4", 10 * i))
    );
    let imported = files(&[("log.gcsv", &text)], &ImportOptions::default()).unwrap();
    assert_eq!(imported.source, Format::Gcsv);
    let imported = only(imported);
    let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
    assert!((gyroscope.t_s[7] - 0.07).abs() < 1e-12);
    assert_eq!((gyroscope.axes[0][7], gyroscope.axes[1][7]), (3.5, 1.0));
    assert_eq!(
        recording(&imported).accelerometer.as_ref().unwrap().axes[2],
        [G0; ROWS]
    );
    let without = text.replace("gscale,0.5\n", "");
    let error = files(&[("log.gcsv", &without)], &ImportOptions::default())
        .unwrap_err()
        .to_string();
    assert!(error.contains("gscale"), "{error}");
}

#[test]
fn physics_toolbox_may_write_a_time_of_day() {
    let text = format!(
        "time,wx,wy,wz\n{}",
        rows(|i| format!("10:00:0{}:{:03},{i},2,-3", i / 10, 10 * (i % 10)))
    );
    let imported = only(files(&[("pt.csv", &text)], &ImportOptions::default()).unwrap());
    let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
    assert!(
        (gyroscope.t_s[15] - (36_001.05)).abs() < 1e-9,
        "{}",
        gyroscope.t_s[15]
    );
    assert_eq!(gyroscope.axes[0][15], 15.0);
}

#[test]
fn angles_and_rates_are_channels() {
    let text = format!(
        "clock,swing\n{}",
        rows(|i| format!("{},{}", 0.01 * i as f64, 9 * i))
    );
    let cases = [
        ("angle=swing:deg", ChannelQuantity::Angle, 0.05 * PI),
        ("angle=swing:rad", ChannelQuantity::Angle, 9.0),
        ("angle=swing:rev", ChannelQuantity::Angle, 18.0 * PI),
        ("rate=swing:deg/s", ChannelQuantity::Rate, 0.05 * PI),
        ("rate=swing:rad/s", ChannelQuantity::Rate, 9.0),
    ];
    for (entry, quantity, expected) in cases {
        let imported =
            only(files(&[("wheel.csv", &text)], &mapping(&["t=clock:s", entry])).unwrap());
        let ImportedData::Channel(channel) = &imported.data else {
            panic!("{imported:?}")
        };
        assert_eq!((channel.quantity, channel.t_s.len()), (quantity, ROWS));
        assert!(
            (channel.values[1] - expected).abs() < 1e-12,
            "{entry}: {}",
            channel.values[1]
        );
    }
    let own = text.replace("clock,swing", "t,angle");
    let imported = only(files(&[("own.csv", &own)], &ImportOptions::default()).unwrap());
    assert!(matches!(imported.data, ImportedData::Channel(_)));
    let both = files(
        &[("wheel.csv", &text)],
        &mapping(&["t=clock:s", "angle=swing:rad", "y=swing:m"]),
    );
    assert!(both.unwrap_err().to_string().contains("no other samples"));
}

#[test]
fn unknown_tables_are_described_and_a_mapping_is_proposed() {
    let cases: [(&str, String, &str); 5] = [
        (
            "tagged.csv",
            format!(
                "Type,Stamp,x,y,z\n{}",
                rows(|i| format!("Gyro,{},1,2,3\nAccel,{},1,2,3", 10 * i, 10 * i + 3))
            ),
            "--map \"t=Stamp:ms\" --map \"gx=x@Gyro:rad/s\" --map \"gy=y@Gyro:rad/s\" --map \"gz=z@Gyro:rad/s\" --map \"ax=x@Accel:m/s2\"",
        ),
        (
            "comm.csv",
            format!(
                "# 100 Hz\nms,ax,ay,az,gx,gy,gz\n{}",
                rows(|i| format!("{},0,0,1,{i},2,-3", 10 * i))
            ),
            "--map \"t=ms:ms\" --map \"ax=ax:g\" --map \"ay=ay:g\" --map \"az=az:g\" --map \"gx=gx:rad/s\"",
        ),
        (
            "headerless.csv",
            rows(|i| {
                format!(
                    "{i},2,-3,{}",
                    8_925_125_000_000_000_i64 + 10_000_000 * i as i64
                )
            }),
            "4 columns without a header",
        ),
        (
            "headerless.csv",
            rows(|i| {
                format!(
                    "{},2,-3,{}",
                    5 - i as i64,
                    8_925_125_000_000_000_i64 + 10_000_000 * i as i64
                )
            }),
            "--map \"t=4:ns\" --map \"gx=1:rad/s\"",
        ),
        (
            "angle.csv",
            format!(
                "time,angle\n{}",
                rows(|i| format!("{:.2},{}", 33.0 + 0.05 * i as f64, i % 3))
            ),
            "--map \"t=time:s\" --map \"angle=angle:rad\"",
        ),
    ];
    for (name, text, expected) in cases {
        let error = files(&[(name, &text)], &ImportOptions::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn one_of_several_trials_is_chosen() {
    // Trials 7 and 9 in turn, by a column; and 20 rows each of a clock that starts again.
    let column = rows(|i| format!("{},{},{i},2,-3", if i < 10 { 7 } else { 9 }, 10 * i));
    let column = format!("Trial,ms,x,y,z\n{column}");
    let entries = ["t=ms:ms", "gx=x:deg/s", "gy=y:deg/s", "gz=z:deg/s"];
    let mut options = mapping(&entries);
    let all = only(files(&[("a.csv", &column)], &options).unwrap());
    let note =
        "`a.csv` holds 2 trials, column `Trial`: 7 (10 rows), 9 (10 rows); choose one with --trial";
    assert_eq!(all.notes, [note]);
    options.trial = Some("9".to_owned());
    let one = only(files(&[("a.csv", &column)], &options).unwrap());
    let gyroscope = recording(&one).gyroscope.as_ref().unwrap();
    assert_eq!((gyroscope.t_s.len(), gyroscope.t_s[0]), (10, 0.1));
    options.trial = Some("8".to_owned());
    let text = files(&[("a.csv", &column)], &options)
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("trial `8`") && text.contains("7 (10 rows)"),
        "{text}"
    );

    let header = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n";
    let part = |x: f64| rows(|i| format!("{},{x},{i},1", 0.01 * i as f64));
    let clock = format!("{header}{}{}{}", part(1.0), part(2.0), part(3.0));
    let options = ImportOptions {
        trial: Some("2".to_owned()),
        ..ImportOptions::default()
    };
    let one = only(files(&[("b.csv", &clock)], &options).unwrap());
    assert_eq!(
        recording(&one).gyroscope.as_ref().unwrap().axes[0],
        [2.0; ROWS]
    );
    assert_eq!(recording(&one).repairs, []);
    let none = files(&[("c.csv", &format!("{header}{}", part(1.0)))], &options);
    assert!(none.unwrap_err().to_string().contains("several trials"));
}

#[test]
fn a_mapped_archive_of_phyphox_has_its_pauses_put_back() {
    let text = format!(
        "Uhr (s),p,q,r\n{}",
        rows(|i| format!("{},{i},2,-3", 0.01 * i as f64))
    );
    let time = "event,experiment time,system time,system time text\nSTART,0,100,x\nPAUSE,0.095,101,x\nSTART,0.095,103,x\n";
    let bytes = zip(&[("Set.csv", text.as_str()), ("meta/time.csv", time)]);
    let options = mapping(&["t=Uhr (s):s", "gx=p:deg/s", "gy=q:deg/s", "gz=r:deg/s"]);
    let imported = only(import_files(&[("puck.zip".to_owned(), bytes)], &options).unwrap());
    let t_s = &recording(&imported).gyroscope.as_ref().unwrap().t_s;
    assert!((t_s[9] - 0.09).abs() < 1e-12 && (t_s[10] - 2.1).abs() < 1e-12);
    assert!(
        imported
            .told()
            .iter()
            .any(|text| text.contains("paused once, 2.000 s"))
    );
}

#[test]
fn other_kinds_of_files_are_refused_with_the_way_out() {
    for (name, start) in [
        ("a.mat", &b"MATLAB 5.0 MAT-file"[..]),
        ("b.mat", b"\x89HDF\r\n\x1a\n"),
    ] {
        let error = import_files(
            &[(name.to_owned(), start.to_vec())],
            &ImportOptions::default(),
        );
        let text = error.unwrap_err().to_string();
        assert!(text.contains(name) && text.contains("CSV"), "{text}");
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn no_table_makes_the_reader_panic(
        text in "([0-9.,;|\t \"#%:=>\\-a-zµ\\[{}]{0,12}[\n\r,;\t]){0,40}",
        trial in proptest::option::of("[0-9]"),
    ) {
        for entries in [&["t=1:ms", "angle=2:deg"][..], &["t=#1:clock", "rate=#2@a:deg/s"], &["t=frame:5/s", "y=1:m"]] {
            let options = ImportOptions { trial: trial.clone(), ..mapping(entries) };
            let _ = files(&[("a.csv", &text), ("b.csv", &text)], &options);
        }
        let options = ImportOptions { trial, ..ImportOptions::default() };
        let _ = files(&[("Gyroscope.csv", &text)], &options);
    }
}
