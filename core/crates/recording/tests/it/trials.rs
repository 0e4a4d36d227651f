//! One channel told by its header, and several trials in one file, as programs of physics labs write
//! them. Every table is written here, so that each expected value is read off the row it comes from.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_recording::ChannelQuantity;
use gyradius_recording::import::{ImportOptions, ImportedData, ImportedRecording};

use crate::tables::{files, only};

const ROWS: usize = 30;

/// Time and values of one channel or track.
fn samples(imported: &ImportedRecording) -> (Option<ChannelQuantity>, Vec<f64>, Vec<f64>) {
    match &imported.data {
        ImportedData::Channel(one) => (Some(one.quantity), one.t_s.clone(), one.values.clone()),
        ImportedData::Track(one) => (None, one.t_s.clone(), one.y_m.clone()),
        other => panic!("{other:?}"),
    }
}

fn trial(text: &str, trial: &str) -> ImportedRecording {
    let options = ImportOptions {
        trial: Some(trial.to_owned()),
        ..ImportOptions::default()
    };
    only(files(&[("a.csv", text)], &options).unwrap())
}

fn refused(text: &str) -> String {
    let found = files(&[("a.csv", text)], &ImportOptions::default());
    found.unwrap_err().to_string()
}

/// Rows of a table, `\n` after each.
fn rows(row: impl Fn(usize) -> String) -> String {
    (0..ROWS).map(|i| row(i) + "\n").collect()
}

/// The value of row `i` is `size · i`, its time 20 ms · i.
fn assert_rises(imported: &ImportedRecording, quantity: Option<ChannelQuantity>, size: f64) {
    let (found, t_s, values) = samples(imported);
    assert_eq!((found, t_s.len()), (quantity, ROWS));
    for i in 0..ROWS {
        let (at, value) = (0.02 * i as f64, size * i as f64);
        assert!((t_s[i] - at).abs() < 1e-9, "{i}: {}", t_s[i]);
        assert!((values[i] - value).abs() < 1e-12, "{i}: {}", values[i]);
    }
}

#[test]
fn a_unit_in_the_header_is_read_without_a_mapping() {
    let (angle, rate) = (Some(ChannelQuantity::Angle), Some(ChannelQuantity::Rate));
    let degree = 1f64.to_radians();
    let cases = [
        ("t,x (mm)", 1.0, None, 1e-3),
        ("t (s),theta (deg)", 1.0, angle, degree),
        ("Time [ms],angle [rad]", 1000.0, angle, 1.0),
        ("t (s),Position (cm)", 1.0, None, 1e-2),
        ("Time (s),Angular Velocity (rad/s)", 1.0, rate, 1.0),
        (
            "\"Latest: Time (s)\",\"Latest: Angle (°)\"",
            1.0,
            angle,
            degree,
        ),
        ("Data Set 1:Time(s),Data Set 1:Angle(rad)", 1.0, angle, 1.0),
        ("Time (s) Run #1,Angle (rad) Run #1", 1.0, angle, 1.0),
    ];
    for (header, second, quantity, size) in cases {
        let text = format!(
            "{header}\n{}",
            rows(|i| format!("{},{i}", 0.02 * second * i as f64))
        );
        let one = only(files(&[("a.csv", &text)], &ImportOptions::default()).unwrap());
        assert_rises(&one, quantity, size);
        assert!(
            one.notes.iter().any(|note| note.contains("is read as")),
            "{header}: {:?}",
            one.notes
        );
    }
    // A row of units below the header, decimal commas.
    let text = rows(|i| format!("{};{}", 0.02 * i as f64, i)).replace('.', ",");
    let text = format!("Time;Angle\ns;deg\n{text}");
    let one = only(files(&[("a.csv", &text)], &ImportOptions::default()).unwrap());
    assert_rises(&one, angle, degree);
}

/// A rotary sensor's program computes the rate and more from the angle, which is what was measured.
#[test]
fn of_what_a_sensor_of_angle_exports_the_angle_is_taken() {
    let header = "Time (s) Run #1,Angle (rad) Run #1,Angular Velocity (rad/s) Run #1,\
                  Angular Acceleration (rad/s²) Run #1,Velocity (m/s) Run #1";
    let text = format!(
        "{header}\n{}",
        rows(|i| format!("{},{i},7,8,9", 0.02 * i as f64))
    );
    let one = only(files(&[("a.csv", &text)], &ImportOptions::default()).unwrap());
    assert_rises(&one, Some(ChannelQuantity::Angle), 1.0);
    let left = one.not_used.join(" ");
    assert!(left.contains("Angular Velocity (rad/s) Run #1"), "{left}");
}

#[test]
fn what_a_header_leaves_open_is_left_to_a_mapping() {
    for header in [
        "t (s),x (m),y (m)",
        "t (s),latitude (deg)",
        "time,angle (deg)",
        "t (s),angle",
    ] {
        let row = |i: usize| match header.matches(',').count() {
            1 => format!("{},{i}", 0.02 * i as f64),
            _ => format!("{},{i},{i}", 0.02 * i as f64),
        };
        let text = refused(&format!("{header}\n{}", rows(row)));
        assert!(text.contains("mapping"), "{header}: {text}");
    }
}

#[test]
fn trials_side_by_side_are_listed_and_chosen() {
    let angle = Some(ChannelQuantity::Angle);
    let cases = [
        // Logger Pro, Graphical Analysis, Capstone; a spreadsheet of one's own.
        (
            "Run 1: Time (s),Run 1: Angle (rad),Run 2: Time (s),Run 2: Angle (rad)",
            "1",
            "2",
        ),
        (
            "Data Set 1:Time(s),Data Set 1:Angle(rad),Data Set 2:Time(s),Data Set 2:Angle(rad)",
            "1",
            "2",
        ),
        (
            "Time (s) Run #3,Angle (rad) Run #3,Time (s) Run #4,Angle (rad) Run #4",
            "3",
            "4",
        ),
        (
            "Latest: Time (s),Latest: Angle (rad),Run 1: Time (s),Run 1: Angle (rad)",
            "Latest",
            "1",
        ),
        (
            "time_1 (s),angle_1 (rad),time_2 (s),angle_2 (rad)",
            "1",
            "2",
        ),
        ("Time (s),Angle (rad),Time (s),Angle (rad)", "1", "2"),
    ];
    // The second is longer: cells of the first stay empty.
    let row = |i: usize| {
        let t = 0.02 * i as f64;
        format!("{t},{i},{t},{}\n", 3 * i)
    };
    let more = "\n,,9.9,1\n";
    for (header, first, second) in cases {
        let body: String = (0..ROWS).map(row).collect();
        let text = format!("{header}\n{body}");
        let listed = refused(&format!("{text}{}", more.trim_start()));
        let counts = format!("{first} ({ROWS} rows), {second} ({} rows)", ROWS + 1);
        assert!(
            listed.contains("2 trials") && listed.contains(&counts),
            "{header}: {listed}"
        );
        assert!(listed.contains("--trial"), "{listed}");
        assert_rises(&trial(&text, first), angle, 1.0);
        assert_rises(&trial(&text, second), angle, 3.0);
    }
    // The line above may name them; lines keep their numbers.
    let body: String = (0..ROWS).map(row).collect();
    let text = format!("Pendulum\nlong,,short,\nt,x (mm),t,x (mm)\n{body}");
    assert_rises(&trial(&text, "short"), None, 3e-3);
    let spoilt = text.replace("\n0.1,5,0.1,15\n", "\n0.1,5,0.1,?\n");
    let options = ImportOptions {
        trial: Some("short".to_owned()),
        ..ImportOptions::default()
    };
    let error = files(&[("a.csv", &spoilt)], &options)
        .unwrap_err()
        .to_string();
    assert!(error.contains("line 9"), "{error}");
    // One time for all runs.
    let text = format!(
        "Time (s),Run 1: Angle (deg),Run 2: Angle (deg)\n{}",
        rows(|i| format!("{},{i},{}", 0.02 * i as f64, 2 * i))
    );
    assert_rises(&trial(&text, "2"), angle, 2f64.to_radians());
    // Units in a row of their own, tabs, decimal commas.
    let body: String = (0..ROWS)
        .map(row)
        .collect::<String>()
        .replace(',', "\t")
        .replace('.', ",");
    let text = format!("t1\tx1\tt2\tx2\ns\tmm\ts\tmm\n{body}");
    assert_rises(&trial(&text, "2"), None, 3e-3);
}

/// Two sensors with a clock each are no trials.
#[test]
fn clocks_of_two_sensors_are_no_trials() {
    let header = "Time 1 (s),Gyroscope x (rad/s),Time 2 (s),Acceleration z (m/s^2)";
    let text = format!(
        "{header}\n{}",
        rows(|i| format!("{0},{i},{0},9.8", 0.02 * i as f64))
    );
    let one = only(files(&[("a.csv", &text)], &ImportOptions::default()).unwrap());
    assert!(matches!(one.data, ImportedData::Recording(_)), "{one:?}");
    assert!(
        !one.notes.iter().any(|note| note.contains("trial")),
        "{:?}",
        one.notes
    );
}

#[test]
fn tables_one_below_the_other_are_listed_and_chosen() {
    let angle = Some(ChannelQuantity::Angle);
    let table = |size: usize| rows(|i| format!("{},{}", 0.02 * i as f64, size * i));
    let header = "Time (s),Angle (deg)\n";
    let between = [
        // A blank line; a line of its own with or without blank ones; nothing but the header again.
        format!("\n{header}"),
        format!("Run 2\n{header}"),
        format!("\n\nTrial 2: 5 degrees\n{header}"),
        header.to_owned(),
        "\nTime (s),theta (deg)\n".to_owned(),
        "\nTime,Angle\ns,deg\n".to_owned(),
    ];
    for between in between {
        let text = format!("Pendulum\n{header}{}{between}{}", table(1), table(2));
        let listed = refused(&text);
        let counts = format!("1 ({ROWS} rows), 2 ({ROWS} rows)");
        assert!(
            listed.contains(&counts) && listed.contains("--trial"),
            "{listed}"
        );
        for (name, size) in [("1", 1.0), ("2", 2.0)] {
            assert_rises(&trial(&text, name), angle, size * 1f64.to_radians());
        }
    }
    // A line of text among the rows is damage, no table.
    let text = format!("{header}{}connection lost, again\n{}", table(1), table(2));
    let error = refused(&text);
    assert!(!error.contains("--trial"), "{error}");
}
