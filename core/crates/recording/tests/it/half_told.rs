//! Tables that say less, or more, than one recording: read right, told or refused, never guessed in
//! silence.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_base::Result;
use gyradius_recording::import::{
    ColumnMapping, ImportOptions, Imported, ImportedData, ImportedRecording, import_files,
};
use gyradius_recording::{Recording, Sensor};

const ROWS: usize = 60;
const GYROSCOPE: &str = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n";

fn rows(row: impl Fn(usize) -> String) -> String {
    (0..ROWS).map(row).collect()
}

fn t(i: usize) -> f64 {
    0.01 * i as f64
}

/// The rate about an axis: no two axes alike.
fn rate(axis: usize, i: usize) -> f64 {
    (axis + 1) as f64 * 0.1 * (0.3 * i as f64).sin()
}

/// Time and three rates.
fn rates(i: usize) -> String {
    format!("{},{},{},{}", t(i), rate(0, i), rate(1, i), rate(2, i))
}

fn import(files: &[(&str, &str)], entries: &[&str]) -> Result<Imported> {
    let inputs: Vec<(String, Vec<u8>)> = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()))
        .collect();
    let mapping = match entries {
        [] => None,
        _ => Some(ColumnMapping::from_entries(entries)?),
    };
    let options = ImportOptions {
        mapping,
        ..ImportOptions::default()
    };
    import_files(&inputs, &options)
}

fn one(name: &str, text: &str, entries: &[&str]) -> ImportedRecording {
    import(&[(name, text)], entries)
        .unwrap()
        .recordings
        .remove(0)
}

fn refused(name: &str, text: &str, entries: &[&str]) -> String {
    import(&[(name, text)], entries).unwrap_err().to_string()
}

fn recording(imported: &ImportedRecording) -> &Recording {
    match &imported.data {
        ImportedData::Recording(recording) => recording,
        other => panic!("{other:?}"),
    }
}

/// The whole gyroscope as [`rates`] has it.
fn assert_rates(imported: &ImportedRecording) {
    let gyroscope = recording(imported).gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s.len(), ROWS);
    for axis in 0..3 {
        for (i, value) in gyroscope.axes[axis].iter().enumerate() {
            assert!((value - rate(axis, i)).abs() < 1e-9, "{axis} {i} {value}");
        }
    }
}

fn assert_told(imported: &ImportedRecording, parts: &[&str]) {
    let told = imported.told();
    for part in parts {
        assert!(
            told.iter().any(|text| text.contains(part)),
            "{part}: {told:?}"
        );
    }
}

#[test]
fn a_quote_left_open_is_refused_with_its_line() {
    let header = GYROSCOPE.replace('\n', ",note\n");
    let note = |i: usize| if i == 30 { "\"bump" } else { "" };
    let text = header.clone() + &rows(|i| format!("{},{}\n", rates(i), note(i)));
    let error = refused("q.csv", &text, &[]);
    assert!(
        error.contains("line 32") && error.contains("quote"),
        "{error}"
    );
    // Closed again below, it would take the rows between.
    let text = text.replace(
        &format!("{},\n", rates(40)),
        &format!("{},end\"\n", rates(40)),
    );
    assert!(refused("q.csv", &text, &[]).contains("line 32"));
    // A note of two lines is a note.
    let note = |i: usize| if i == 30 { "\"bump\nat the bow\"" } else { "" };
    assert_rates(&one(
        "q.csv",
        &(header + &rows(|i| format!("{},{}\n", rates(i), note(i)))),
        &[],
    ));
}

#[test]
fn a_tag_of_rows_goes_before_the_name_of_the_file() {
    let text = String::from("s,kind,x,y,z\n")
        + &rows(|i| {
            let cells = rates(i);
            let (time, xyz) = cells.split_once(',').unwrap();
            format!("{time},gyro,{xyz}\n{time},acc,0.1,0.2,9.7\n")
        });
    let entries = [
        "t=s:s",
        "gx=x@gyro:rad/s",
        "gy=y@gyro:rad/s",
        "gz=z@gyro:rad/s",
    ];
    for name in ["log.csv", "gyro acc log.csv"] {
        assert_rates(&one(name, &text, &entries));
    }
    // Without a column of tags the name of the file is meant.
    let text = String::from("s,x,y,z\n") + &rows(|i| rates(i) + "\n");
    assert_rates(&one("gyro.csv", &text, &entries));
}

#[test]
fn a_field_that_is_mapped_twice_is_refused() {
    let text = String::from("s,x,y\n0,1,2\n1,2,3\n");
    let error = refused("a.csv", &text, &["t=s:s", "gx=x:rad/s", "gx=y:rad/s"]);
    assert!(error.contains("one column for `gx`"), "{error}");
}

#[test]
fn the_name_of_a_file_does_not_take_gravity_out() {
    let text = String::from(
        "Time (s),Acceleration x (m/s^2),Acceleration y (m/s^2),Acceleration z (m/s^2)\n",
    ) + &rows(|i| format!("{},0.1,0.2,9.8\n", t(i)));
    for name in ["nonlinear yaw.csv", "linear rig.csv"] {
        assert!(
            recording(&one(name, &text, &[])).accelerometer.is_some(),
            "{name}"
        );
    }
    let free = one("Linear Accelerometer.csv", &text, &[]);
    assert!(recording(&free).linear_accelerometer.is_some());
    assert_told(&free, &["it is probably not taken out"]);
}

#[test]
fn a_phone_and_a_watch_are_not_mixed() {
    let header = "time,seconds_elapsed,z,y,x\n";
    let row = |i: usize| {
        format!(
            "{},{},{},{},{}\n",
            i,
            t(i),
            rate(2, i),
            rate(1, i),
            rate(0, i)
        )
    };
    let phone = header.to_owned() + &rows(row);
    let watch = String::from(
        "time,seconds_elapsed,rotationRateX,rotationRateY,rotationRateZ,gravityX,gravityY,gravityZ,accelerationX,accelerationY,accelerationZ\n",
    ) + &rows(|i| format!("{},{},9,9,9,0,0,-1,0,0,0\n", i, t(i)));
    let files = [
        ("Gyroscope.csv", phone.as_str()),
        ("WristMotion.csv", &watch),
    ];
    let imported = import(&files, &[]).unwrap().recordings.remove(0);
    assert_rates(&imported);
    assert!(recording(&imported).accelerometer.is_none());
    assert_told(
        &imported,
        &["of a phone and of a watch", "`WristMotion.csv` is not used"],
    );
}

#[test]
fn sensors_without_samples_give_way_and_are_told() {
    let header = "time,seconds_elapsed,z,y,x\n";
    let gravity = header.to_owned() + &rows(|i| format!("{i},{},9.8,0,0\n", t(i)));
    let free = header.to_owned() + &rows(|i| format!("{i},{},0.1,0.2,0.3\n", t(i)));
    let files = [
        ("TotalAcceleration.csv", header),
        ("Accelerometer.csv", &free),
        ("Gravity.csv", &gravity),
    ];
    let imported = import(&files, &[]).unwrap().recordings.remove(0);
    assert!(recording(&imported).accelerometer.is_some());
    assert_told(&imported, &["`TotalAcceleration.csv` holds no sample"]);

    let header = "loggingTime(txt),gyroRotationX(rad/s),gyroRotationY(rad/s),gyroRotationZ(rad/s),motionRotationRateX(rad/s),motionRotationRateY(rad/s),motionRotationRateZ(rad/s)\n";
    for none in ["", "NaN", "null"] {
        let row = |i: usize| {
            let cells = rates(i);
            let (_, xyz) = cells.split_once(',').unwrap();
            format!(
                "2026-05-04 10:00:{:06.3},{none},{none},{none},{xyz}\n",
                t(i)
            )
        };
        let imported = one("log.csv", &(header.to_owned() + &rows(row)), &[]);
        assert_rates(&imported);
        assert_told(&imported, &["columns `gyroRotationX…` hold no sample"]);
    }
}

#[test]
fn an_axis_without_samples_is_told_or_where_it_is_mapped_refused() {
    let text = |z: &str| GYROSCOPE.to_owned() + &rows(|i| format!("{},1,2,{z}\n", t(i)));
    for z in ["", "NaN", "NA"] {
        let imported = one("g.csv", &text(z), &[]);
        assert_eq!(recording(&imported).incomplete[0].sensor, Sensor::Gyroscope);
        assert_told(&imported, &["gyroscope: gz without a sample"]);
        let entries = ["t=#1:s", "gx=#2:rad/s", "gz=#4:rad/s"];
        let error = refused("g.csv", &text(z), &entries);
        assert!(
            error.contains("samples in `Gyroscope z (rad/s)`"),
            "{error}"
        );
    }
    let header = GYROSCOPE.replace('\n', ",Acceleration x (m/s^2)\n");
    let imported = one("g.csv", &(header + &rows(|i| rates(i) + ",\n")), &[]);
    assert_rates(&imported);
    assert_told(&imported, &["accelerometer: no sample in any row"]);
}

#[test]
fn the_axes_of_one_sensor_are_called_alike_but_for_the_axis() {
    let bow = "Time (s),Bow gyroscope x (rad/s),Bow gyroscope y (rad/s),";
    let plain = "Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n";
    let row = |i: usize| {
        let cells = rates(i);
        let (time, xyz) = cells.split_once(',').unwrap();
        format!("{time},7,8,{xyz}\n")
    };
    assert_rates(&one("a.csv", &(format!("{bow}{plain}") + &rows(row)), &[]));
    let stern = plain.replace("Gyro", "Stern gyro");
    let imported = one("a.csv", &(format!("{bow}{stern}") + &rows(row)), &[]);
    assert_rates(&imported);
    assert_told(&imported, &["columns `Bow gyroscope x (rad/s)`"]);
    // Of two that are whole, the one without another word.
    let filtered = bow.replace("Bow", "Filtered") + "Filtered gyroscope z (rad/s),";
    let row = |i: usize| {
        let cells = rates(i);
        let (time, xyz) = cells.split_once(',').unwrap();
        format!("{time},7,8,9,{xyz}\n")
    };
    assert_rates(&one("a.csv", &(filtered + plain + &rows(row)), &[]));
}

#[test]
fn another_time_beside_the_clock_is_no_clock() {
    for other in ["Lap time (s)", "Exposure time (ms)"] {
        let header = GYROSCOPE.replacen(',', &format!(",{other},"), 1);
        let row = |i: usize| format!("{}\n", rates(i).replacen(',', &format!(",{},", i % 9), 1));
        let imported = one("a.csv", &(header + &rows(row)), &[]);
        assert_rates(&imported);
        assert_told(&imported, &[&format!("column `{other}` is not used")]);
    }
}

#[test]
fn loose_files_that_are_read_as_one_recording_are_told() {
    let gyroscope = GYROSCOPE.to_owned() + &rows(|i| rates(i) + "\n");
    let acceleration =
        "Time (s),Acceleration z (m/s^2)\n".to_owned() + &rows(|i| format!("{},9.8\n", t(i)));
    let files = [
        ("yaw.csv", gyroscope.as_str()),
        ("pitch.csv", &acceleration),
    ];
    let imported = import(&files, &[]).unwrap().recordings.remove(0);
    assert_told(
        &imported,
        &["`yaw.csv` and `pitch.csv` are read as one recording"],
    );
}

#[test]
fn comments_that_look_like_rows_are_told() {
    let row = |i: usize| format!("{}{i},{}\n", if i % 2 == 1 { "#" } else { "" }, rates(i));
    let imported = one("a.csv", &(format!("id,{GYROSCOPE}") + &rows(row)), &[]);
    assert_told(
        &imported,
        &[
            "30 lines that begin with # are comments and no rows",
            "line 3 is",
        ],
    );
}

#[test]
fn frames_in_which_a_point_was_lost_keep_their_time() {
    let lost = |i: usize| (20..25).contains(&i);
    let text = rows(|i| {
        if lost(i) {
            "\n".to_owned()
        } else {
            format!("{}\n", (i as f64).sin())
        }
    });
    let entries = ["t=row:100Hz", "y=#1:mm"];
    let ImportedData::Track(track) = one("track.txt", &text, &entries).data else {
        panic!("no track");
    };
    let kept: Vec<f64> = (0..ROWS)
        .filter(|i| !lost(*i))
        .map(|i| i as f64 / 100.0)
        .collect();
    assert_eq!(track.t_s, kept);
    // Blank lines between all rows are space.
    let text = rows(|i| format!("{}\n\n", (i as f64).sin()));
    let ImportedData::Track(track) = one("track.txt", &text, &entries).data else {
        panic!("no track");
    };
    assert_eq!(track.t_s[ROWS - 1], (ROWS - 1) as f64 / 100.0);
}

#[test]
fn own_columns_in_g_are_refused_with_a_mapping() {
    let text =
        "t,gx,gy,gz,ax,ay,az\n".to_owned() + &rows(|i| format!("{},0.01,0.02,0.99\n", rates(i)));
    let error = refused("a.csv", &text, &[]);
    assert!(
        error.contains("gx=gx:UNIT") && error.contains("az=az:g"),
        "{error}"
    );
}

#[test]
fn other_columns_beside_the_own_ones_are_told() {
    let row = |i: usize| format!("{i},{},21.5\n", rates(i));
    for header in [",t,gx,gy,gz,temp\n", "n,T,GX,GY,GZ,temp\n"] {
        let imported = one("a.csv", &(header.to_owned() + &rows(row)), &[]);
        assert_rates(&imported);
        assert_told(&imported, &["`temp`"]);
    }
}

#[test]
fn cells_without_a_value_and_a_last_line_of_words_are_told() {
    for none in ["NA", "N/A", "#N/A", "null", "None", "-"] {
        let row = |i: usize| {
            format!(
                "{}\n",
                if i.is_multiple_of(20) {
                    format!("{},{none},1,2", t(i))
                } else {
                    rates(i)
                }
            )
        };
        let imported = one("a.csv", &(GYROSCOPE.to_owned() + &rows(row)), &[]);
        let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
        assert_eq!(gyroscope.t_s.len(), ROWS - 3, "{none}");
        assert!(!recording(&imported).repairs.is_empty());
    }
    for last in [
        "Recording stopped",
        "\n60 samples, 0 errors",
        "\u{1a}",
        "\0\0\0",
    ] {
        let text = GYROSCOPE.to_owned() + &rows(|i| rates(i) + "\n") + last;
        let imported = one("a.csv", &text, &[]);
        assert_rates(&imported);
        assert_told(&imported, &["is no row and is left out"]);
    }
    // In the midst of the rows it is damage.
    let row = |i: usize| {
        format!(
            "{}{}\n",
            rates(i),
            if i == 9 { "\nsensor lost" } else { "" }
        )
    };
    assert!(refused("a.csv", &(GYROSCOPE.to_owned() + &rows(row)), &[]).contains("line 12"));
}

#[test]
fn a_list_of_periods_is_known() {
    let text = "t,period\n".to_owned() + &rows(|i| format!("{},4.39\n", 4.39 * i as f64));
    let ImportedData::Periods(list) = one("periods.csv", &text, &[]).data else {
        panic!("no list");
    };
    assert_eq!(list.period_s, [4.39; ROWS]);
}

#[test]
fn units_of_a_header_are_read_or_left_to_fill_in() {
    let text = GYROSCOPE
        .replace("rad/s", "mrad/s")
        .replace("Time (s)", "Time (0.1 ms)")
        + &rows(|i| {
            let mrad = |axis| 1e3 * rate(axis, i);
            format!("{},{},{},{}\n", 1e4 * t(i), mrad(0), mrad(1), mrad(2))
        });
    assert_rates(&one("a.csv", &text, &[]));
    let rpm = |value: f64| value * 60.0 / std::f64::consts::TAU;
    let text = GYROSCOPE.replace("rad/s", "rpm")
        + &rows(|i| {
            let rpm = |axis| rpm(rate(axis, i));
            format!("{},{},{},{}\n", t(i), rpm(0), rpm(1), rpm(2))
        });
    assert_rates(&one("a.csv", &text, &[]));
    let text = GYROSCOPE.replace("rad/s", "furlongs") + &rows(|i| rates(i) + "\n");
    let error = refused("a.csv", &text, &[]);
    assert!(error.contains("gx=Gyroscope x (furlongs):UNIT"), "{error}");
}

#[test]
fn a_mapping_is_not_proposed_against_the_names_of_columns() {
    let row = |i: usize| {
        format!(
            "{i},{},{},{},{}\n",
            t(i),
            rate(2, i),
            rate(1, i),
            rate(0, i)
        )
    };
    let text = "time,seconds_elapsed,z,y,x\n".to_owned() + &rows(row);
    let error = refused("gy.csv", &text, &[]);
    assert!(
        error.contains("gx=x:rad/s") && error.contains("gz=z:rad/s"),
        "{error}"
    );
    assert_rates(&one("Gyroscope (1).csv", &text, &[]));
    let text = "Frame,Time (Seconds),X,Y,Z,X,Y,Z\n".to_owned()
        + &rows(|i| format!("{i},{},1,2,3,4,5,6\n", t(i)));
    assert!(!refused("a.csv", &text, &[]).contains("gx=Frame"));
    let german =
        "Zeit (s),Beschleunigung x (m/s^2),Beschleunigung y (m/s^2),Beschleunigung z (m/s^2)\n";
    let error = refused(
        "a.csv",
        &(german.to_owned() + &rows(|i| rates(i) + "\n")),
        &[],
    );
    assert!(
        error.contains("ax=Beschleunigung x (m/s^2):m/s2"),
        "{error}"
    );
}

#[test]
fn sensorlog_in_json_has_the_sign_of_ios_turned() {
    let row = |i: usize| {
        format!(
            "{{\"loggingTime\": \"2026-06-07 17:05:00.001\", \"accelerometerTimestamp_sinceReboot\": \"{}\", \"accelerometerAccelerationX\": \"0\", \"accelerometerAccelerationY\": \"0\", \"accelerometerAccelerationZ\": \"-1\"}}",
            100.0 + t(i)
        )
    };
    let text = format!("[{}]", (0..ROWS).map(row).collect::<Vec<_>>().join(", "));
    let imported = one("log.json", &text, &[]);
    let z = &recording(&imported).accelerometer.as_ref().unwrap().axes[2];
    assert!((z[0] - 9.80665).abs() < 1e-9 && z.len() == ROWS);
}

#[test]
fn names_over_two_lines_and_in_another_encoding_are_read() {
    let text = GYROSCOPE.trim_end().split(',').collect::<Vec<_>>();
    let names: Vec<String> = text
        .iter()
        .map(|name| format!("\"{}\"", name.replace(" (", "\n(")))
        .collect();
    let text = names.join(",") + "\n" + &rows(|i| rates(i) + "\n");
    assert_rates(&one("a.csv", &text, &[]));
    let text = "Time (s),Acc X (m/s?),Acc Y (m/s?),Acc Z (m/s?)\n".to_owned()
        + &rows(|i| format!("{},0,0,9.8\n", t(i)));
    let latin1: Vec<u8> = text
        .bytes()
        .map(|b| if b == b'?' { 0xB2 } else { b })
        .collect();
    let inputs = [("a.csv".to_owned(), latin1)];
    let imported = import_files(&inputs, &ImportOptions::default()).unwrap();
    assert!(recording(&imported.recordings[0]).accelerometer.is_some());
}

#[test]
fn a_small_table_beside_known_ones_is_passed_over() {
    let gyroscope = GYROSCOPE.to_owned() + &rows(|i| rates(i) + "\n");
    let peaks = "Time 1,Peak 1,Time 2,Peak 2\n0.1,1,0.2,2\n0.3,1,0.4,2\n";
    let files = [
        ("Gyroscope.csv", gyroscope.as_str()),
        ("Results.csv", peaks),
    ];
    let imported = import(&files, &[]).unwrap().recordings.remove(0);
    assert_rates(&imported);
    assert_told(&imported, &["`Results.csv` is not used"]);
}

/// R's `write.table` names its rows, and its header has no name for them.
#[test]
fn names_of_rows_are_no_time() {
    let row = |i: usize| format!("\"{}\" {}\n", i + 1, rates(i).replace(',', " "));
    let text = format!("\"t\" \"gx\" \"gy\" \"gz\"\n{}", rows(row));
    let imported = one(
        "r.txt",
        &text,
        &["t=t:s", "gx=gx:rad/s", "gy=gy:rad/s", "gz=gz:rad/s"],
    );
    let gyroscope = recording(&imported).gyroscope.as_ref().unwrap();
    assert_eq!(gyroscope.t_s[ROWS - 1], t(ROWS - 1));
    assert_eq!(gyroscope.axes[2][7], rate(2, 7));
}

/// A table that was compressed by itself is the table.
#[test]
fn a_compressed_table_is_unpacked() {
    use std::io::Write;
    let text = format!("{GYROSCOPE}{}", rows(|i| rates(i) + "\n"));
    let mut packed = flate2::write::GzEncoder::new(vec![], flate2::Compression::default());
    packed.write_all(text.as_bytes()).unwrap();
    let packed = packed.finish().unwrap();
    let import = |bytes: Vec<u8>| {
        let inputs = [("Gyroscope.csv.gz".to_owned(), bytes)];
        import_files(&inputs, &ImportOptions::default())
    };
    let found = import(packed.clone()).unwrap();
    let plain = one("Gyroscope.csv", &text, &[]);
    assert_eq!(recording(&found.recordings[0]), recording(&plain));
    // Cut short it is an error, not half a swing.
    let error = import(packed[..packed.len() / 2].to_vec()).unwrap_err();
    assert!(error.to_string().contains("Gyroscope.csv.gz"), "{error}");
}
