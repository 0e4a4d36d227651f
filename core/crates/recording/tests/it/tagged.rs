//! Rows tagged by sensor, and columns that number the rows: no mapping that is proposed, or taken,
//! mixes sensors or takes a number of frames for a time.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_recording::import::{
    ColumnMapping, ImportOptions, Imported, ImportedData, import_files,
};

fn imported(text: &str, entries: &[&str]) -> gyradius_base::Result<Imported> {
    let mapping = (!entries.is_empty()).then(|| ColumnMapping::from_entries(entries).unwrap());
    let options = ImportOptions {
        mapping,
        ..ImportOptions::default()
    };
    import_files(
        &[("log.csv".to_owned(), text.as_bytes().to_vec())],
        &options,
    )
}

/// What the first recording of a file holds.
fn first(text: &str, entries: &[&str]) -> ImportedData {
    imported(text, entries).unwrap().recordings.remove(0).data
}

fn refusal(text: &str, entries: &[&str]) -> String {
    imported(text, entries).unwrap_err().to_string()
}

fn table(header: &str, row: impl Fn(usize) -> String) -> String {
    let rows: Vec<String> = (0..40).map(row).collect();
    format!("{header}\n{}\n", rows.join("\n"))
}

/// The entries of the mapping that a refusal proposes.
fn proposed(text: &str) -> Vec<String> {
    let text = refusal(text, &[]);
    let entries = text.split("--map \"").skip(1);
    entries
        .map(|entry| entry.split('"').next().unwrap().to_owned())
        .collect()
}

#[test]
fn a_proposal_takes_the_rows_of_one_sensor_whatever_the_columns_are_called() {
    let both = |i: usize| format!("{0},GYR,1,2,{i}\n{0},ACC,0,0,9.81", 10 * i);
    let expected = [
        "t=ms:ms",
        "gx=v1@GYR:rad/s",
        "gy=v2@GYR:rad/s",
        "gz=v3@GYR:rad/s",
    ];
    let entries = proposed(&table("ms,kind,v1,v2,v3", both));
    assert_eq!(entries[..4], expected);
    assert_eq!(entries[4], "ax=v1@ACC:m/s2");
    let text = table("ms,kind,v1,v2,v3", both);
    let entries: Vec<&str> = entries.iter().map(String::as_str).collect();
    let ImportedData::Recording(recording) = first(&text, &entries) else {
        panic!()
    };
    assert_eq!(recording.gyroscope.unwrap().axes[2][7], 7.0);
    assert_eq!(recording.accelerometer.unwrap().axes[2][7], 9.81);

    // Numbers do not tell which sensor is which.
    let coded = |i: usize| format!("{0},1,1,2,{i}\n{0},4,0,0,9.81", 10 * i);
    let entries = proposed(&table("ms,sensor,x1,x2,x3", coded));
    assert_eq!(entries[1], "gx=x1@TAG:rad/s");
}

#[test]
fn a_value_in_each_row_is_one_axis_and_two_are_not_read_as_one() {
    let long = table("s,channel,value", |i| {
        format!("{0},gz,{i}\n{0},gx,0.5", 0.01 * i as f64)
    });
    assert_eq!(proposed(&long), ["t=s:s", "gz=value@gz:rad/s"]);
    let both = ["t=s:s", "gx=value@gx:rad/s", "gz=value@gz:rad/s"];
    let text = refusal(&long, &both);
    assert!(
        text.contains("one tag for all axes of the gyroscope"),
        "{text}"
    );
}

/// A sample may look like the tag: the tags are where it stands most often.
#[test]
fn a_number_that_is_a_tag_is_not_looked_for_among_the_samples() {
    let text = table("s,z,code", |i| {
        let z = if i == 0 { 4 } else { 100 + i };
        format!("{0},{z},1\n{0},7,4", 0.01 * i as f64)
    });
    let ImportedData::Recording(recording) = first(&text, &["t=s:s", "gz=z@4:rad/s"]) else {
        panic!()
    };
    let sensors = recording.sensors();
    assert_eq!(sensors[0].channels[0].1, [7.0; 40]);
}

#[test]
fn frames_are_no_time_without_their_rate() {
    let video = table("frame,theta_deg", |i| format!("{i},{}", 5 + i));
    assert_eq!(proposed(&video), ["t=frame:RATEfps", "angle=theta_deg:deg"]);
    let ImportedData::Channel(channel) = first(&video, &["t=frame:25fps", "angle=theta_deg:deg"])
    else {
        panic!()
    };
    assert_eq!(channel.t_s[10], 0.4);
    assert_eq!(channel.values[0], 5f64.to_radians());
    // 00:00:01:12 is twelve frames after the second, not 120 ms.
    let coded = table("timecode,theta", |i| {
        format!("00:00:{:02}:{:02},{i}", i / 25, i % 25)
    });
    let text = refusal(&coded, &["t=timecode:clock", "angle=theta:deg"]);
    assert!(
        text.contains("t=row:25fps") && text.contains("00:00:00:00"),
        "{text}"
    );
    assert!(imported(&coded, &["t=row:25fps", "angle=theta:deg"]).is_ok());
}
