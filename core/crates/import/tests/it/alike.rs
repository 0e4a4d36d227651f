//! A swing that hung like another has its figures as they stand there.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;

use gyradius_import::{Growth, Hanging, ImportRequest, import_into};
use gyradius_recording::{Quantity, load_session};

use crate::told::{phyphox, request};

const KEPT: &str = r#"format = "gyradius-session/1"
[body]
[[instrument]]
id = "tape-1"
kind = "tape"
scale_u = 5e-4

[[swing]]
id = "old"
periods_s = { yaw = 4.4 }
[swing.suspension]
kind = "trifilar"
line_length = { value = 3.0, u = 0.002, instrument = "tape-1" }
radius = { value = 0.25, instrument = "tape-1" }
top_radius = { value = 0.26, u = 0.001, instrument = "tape-1" }
hull_pitch_deg = 1.0
"#;

#[test]
fn a_swing_hung_like_another_has_its_readings_but_for_what_is_stated() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("session");
    fs::create_dir(&folder).unwrap();
    fs::write(folder.join("session.toml"), KEPT).unwrap();
    let files: Vec<_> = ["up.csv", "down.csv"]
        .into_iter()
        .enumerate()
        .map(|(k, name)| {
            let file = dir.path().join(name);
            let rate = |i: usize| (k + 1) as f64 * i as f64;
            fs::write(&file, phyphox(60, |i| 0.01 * i as f64, rate)).unwrap();
            file
        })
        .collect();
    let untitled = ImportRequest {
        title: String::new(),
        ..request(&[])
    };
    let anew = ("top_radius".to_owned(), Quantity::new(0.27, 0.001));
    let growth = Growth {
        like: Some("old".to_owned()),
        hung: Hanging {
            figures: [anew].into_iter().collect(),
            ..Hanging::default()
        },
        ..Growth::default()
    };
    import_into(&files, &folder, &untitled, &growth).unwrap();
    let text = fs::read_to_string(folder.join("session.toml")).unwrap();
    let added = text.strip_prefix(KEPT).unwrap();
    // What one command states of both swings is one reading.
    for line in [
        "same_as = \"old\"\n",
        "top_radius = { value = 0.27, u = 0.001 }\n",
        "same_as = \"up\"\n",
    ] {
        let lines = added.matches(&format!("\n{line}")).count();
        assert_eq!(lines, 1, "{line}{added}");
    }
    let session = load_session(&folder).unwrap().session;
    for (key, home) in [("line_length", 0), ("radius", 0), ("top_radius", 1)] {
        assert_eq!(session.measured_at(2, key), home, "{key}");
    }
    let [old, new] = [0, 2].map(|i| session.swings[i].suspension.clone());
    assert_eq!(old.figure("radius"), new.figure("radius"));
    assert_eq!(new.figure("top_radius"), Some(Quantity::new(0.27, 0.001)));
}
