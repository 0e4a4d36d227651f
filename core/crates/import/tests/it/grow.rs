//! Sessions that grow: what is there stays, byte for byte, and what comes in finds its place.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use gyradius_import::{Growth, Hanging, ImportRequest, import_into, import_session};
use gyradius_recording::{
    LoadedData, Orientation, Overwrite, Quantity, Suspension, load_session, read_session,
};

use crate::told::{phyphox, request};

/// A session as a person keeps it: comments, an attachment, an incline, a typed table.
const KEPT: &str = r#"# my boat
format = "gyradius-session/1"
title = "Boat"   # of the club

[body]
name = "Boat"
mass = { value = 300.0, u = 0.5 }

[[attachment]]
name = "beam"    # weighed twice
mass = 12.0
position = [0.05, 0.0, 0.02]

[[swing]]
id = "table"
periods_s = { yaw = { value = 4.391, u = 0.004 } }
[swing.suspension]
kind = "bifilar"
orientation = "fore_and_aft"
line_length = { value = 3.477, u = 0.006 } # by tape
spacing = { value = 1.8, u = 0.001 }

[[incline]]
end = "stern"
mass = 1.0
arm = 0.85
depth = 0.03
angle_deg = 8.2
# the end"#;

/// A swing that a plan wants.
const PLANNED: &str = r#"
[[swing]]
id = "yaw"
recording = "takes/yaw.csv"
excited = ["yaw"]
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 2.0, u = 0.003 }   # planned
spacing = { value = 1.0, u = 0.001 }
"#;

fn session(dir: &Path, text: &str) -> PathBuf {
    let folder = dir.join("session");
    fs::create_dir(&folder).unwrap();
    fs::write(folder.join("session.toml"), text).unwrap();
    folder
}

/// An export with a rate of its own about z.
fn export(dir: &Path, name: &str, rate: f64) -> PathBuf {
    let file = dir.join(name);
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, phyphox(60, |i| 0.01 * i as f64, |i| rate * i as f64)).unwrap();
    file
}

/// Without a title, which is the session's.
fn untitled() -> ImportRequest {
    ImportRequest {
        title: String::new(),
        ..request(&[])
    }
}

/// A hanging of which these figures are stated.
fn stated(figures: &[(&str, Quantity)]) -> Growth {
    let figures = figures.iter().map(|(key, q)| ((*key).to_owned(), *q));
    Growth {
        hung: Hanging {
            figures: figures.collect(),
            ..Hanging::default()
        },
        ..Growth::default()
    }
}

/// Lines of 2 m, 1 m apart.
fn lines() -> Growth {
    stated(&[
        ("line_length", Quantity::exact(2.0)),
        ("spacing", Quantity::exact(1.0)),
    ])
}

fn text_of(folder: &Path) -> String {
    fs::read_to_string(folder.join("session.toml")).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn refused(files: &[PathBuf], folder: &Path, request: &ImportRequest, growth: &Growth) -> String {
    let before = fs::read(folder.join("session.toml")).ok();
    let files_before = folder.is_dir().then(|| names(folder));
    let error = import_into(files, folder, request, growth).unwrap_err();
    assert_eq!(fs::read(folder.join("session.toml")).ok(), before);
    assert_eq!(folder.is_dir().then(|| names(folder)), files_before);
    error.to_string()
}

#[test]
fn a_session_keeps_its_text_and_gains_swings() {
    for end in ["\n", "\r\n"] {
        let dir = tempfile::tempdir().unwrap();
        let kept = KEPT.replace('\n', end);
        let folder = session(dir.path(), &kept);
        let files = [
            export(dir.path(), "yaw.csv", 1.0),
            export(dir.path(), "Up 2.csv", 2.0),
        ];
        let into = folder.join("session.toml");
        let notes = import_into(&files, &into, &untitled(), &lines()).unwrap();
        assert_eq!(notes, Vec::<String>::new());
        let text = text_of(&folder);
        assert!(text.starts_with(&kept), "{text}");
        assert_eq!(text.matches('\n').count(), text.matches(end).count());
        let loaded = load_session(&folder).unwrap();
        let ids: Vec<&str> = loaded
            .session
            .swings
            .iter()
            .map(|swing| &*swing.id)
            .collect();
        assert_eq!(ids, ["table", "yaw", "Up-2"]);
        let hung = &loaded.session.swings[1].suspension;
        assert_eq!(hung.line_length_m, Some(Quantity::exact(2.0)));
        assert_eq!(hung.orientation, Orientation::Athwartships);
        assert_eq!(loaded.session.attachments[0].name, "beam");
        assert_eq!(loaded.session.inclines.len(), 1);
        let LoadedData::Recording(recording) = &loaded.data[2].data else {
            panic!("{:?}", loaded.data[2])
        };
        let gyroscope = recording.gyroscope.as_ref().unwrap();
        assert_eq!(gyroscope.axes[2][30], 60.0);
    }
}

#[test]
fn a_name_that_is_taken_gets_a_number_and_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let folder = session(dir.path(), KEPT);
    // One is taken by a swing, one by a file that no swing names, in other letters.
    fs::write(folder.join("YAW.csv"), "t,y\n0,1\n").unwrap();
    let files = [
        export(dir.path(), "table.csv", 1.0),
        export(dir.path(), "yaw.csv", 2.0),
    ];
    let notes = import_into(&files, &folder, &untitled(), &lines()).unwrap();
    let ids: Vec<String> = load_session(&folder)
        .unwrap()
        .session
        .swings
        .into_iter()
        .map(|swing| swing.id)
        .collect();
    assert_eq!(ids, ["table", "table-2", "yaw-2"]);
    assert_eq!(fs::read(folder.join("YAW.csv")).unwrap(), b"t,y\n0,1\n");
    for (old, new) in [("table", "table-2"), ("yaw", "yaw-2")] {
        let told = |note: &String| note.contains(&format!("`{old}`")) && note.contains(new);
        assert!(notes.iter().any(told), "{notes:?}");
    }
}

#[test]
fn the_same_samples_again_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let folder = session(dir.path(), KEPT);
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    import_into(&file, &folder, &untitled(), &lines()).unwrap();
    let again = [export(dir.path(), "other.csv", 1.0)];
    let text = refused(&again, &folder, &untitled(), &lines());
    assert!(text.contains("`yaw.csv` again, as `other.csv`"), "{text}");
}

#[test]
fn a_planned_swing_gets_its_recording_by_its_name_or_by_its_id() {
    for (name, swing) in [
        ("yaw.csv", None),
        ("first yaw.csv", None),
        ("phyphox 17.csv", Some("yaw".to_owned())),
    ] {
        let dir = tempfile::tempdir().unwrap();
        // The id, and the name of the file.
        let planned = format!("{KEPT}\n{PLANNED}").replace("takes/yaw", "takes/first yaw");
        let folder = session(dir.path(), &planned);
        let file = [export(dir.path(), name, 1.0)];
        let growth = Growth {
            swing,
            ..Growth::default()
        };
        let notes = import_into(&file, &folder, &untitled(), &growth).unwrap();
        assert!(notes[0].contains("`yaw`"), "{notes:?}");
        assert_eq!(text_of(&folder), planned);
        let loaded = load_session(&folder).unwrap();
        assert_eq!(loaded.session.swings.len(), 2);
        assert!(matches!(loaded.data[1].data, LoadedData::Recording(_)));
        assert!(folder.join("takes/first yaw.csv").is_file());
    }
}

#[test]
fn what_is_read_off_takes_the_place_of_what_was_planned() {
    let dir = tempfile::tempdir().unwrap();
    let planned = format!("\u{feff}{KEPT}\n{PLANNED}");
    let folder = session(dir.path(), &planned);
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let mut growth = stated(&[
        ("line_length", Quantity::new(1.987, 0.002)),
        ("top_spacing", Quantity::new(1.01, f64::NAN)),
    ]);
    growth.hung.orientation = Some(Orientation::ForeAndAft);
    import_into(&file, &folder, &untitled(), &growth).unwrap();
    let expected = planned
        .replace(
            "orientation = \"athwartships\"",
            "orientation = \"fore_and_aft\"",
        )
        .replace("{ value = 2.0, u = 0.003 }", "{ value = 1.987, u = 0.002 }");
    assert_eq!(text_of(&folder), format!("{expected}top_spacing = 1.01\n"));
}

#[test]
fn a_swing_that_waits_for_something_else_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let track = PLANNED.replace("recording =", "displacement =");
    let folder = session(dir.path(), &format!("{KEPT}\n{track}"));
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let text = refused(&file, &folder, &untitled(), &Growth::default());
    assert!(text.contains("`yaw` waits for, a track"), "{text}");
    let growth = Growth {
        swing: Some("table".to_owned()),
        ..Growth::default()
    };
    let text = refused(&file, &folder, &untitled(), &growth);
    assert!(
        text.contains("no recording yet: yaw") && text.contains("`table`"),
        "{text}"
    );
}

#[test]
fn a_new_swing_says_how_it_hung_or_which_swing_hung_alike() {
    let dir = tempfile::tempdir().unwrap();
    let folder = session(dir.path(), KEPT);
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let text = refused(&file, &folder, &untitled(), &Growth::default());
    assert!(
        text.contains("line_length and spacing") && text.contains("--like"),
        "{text}"
    );
    let mut growth = Growth {
        like: Some("tabel".to_owned()),
        ..stated(&[("spacing", Quantity::new(1.2, 0.001))])
    };
    let text = refused(&file, &folder, &untitled(), &growth);
    assert!(text.contains("a swing of the session: table"), "{text}");
    growth.like = Some("table".to_owned());
    import_into(&file, &folder, &untitled(), &growth).unwrap();
    let session = load_session(&folder).unwrap().session;
    let expected = Suspension {
        spacing_m: Some(Quantity::new(1.2, 0.001)),
        ..session.swings[0].suspension.clone()
    };
    assert_eq!(session.swings[1].suspension, expected);
}

#[test]
fn a_draft_grows_as_a_draft_and_is_filled_in_once() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("session");
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let mut first = request(&[]);
    first.suspension = Hanging::default().alone().unwrap();
    import_session(&file, &folder, &first, Overwrite::Refuse).unwrap();
    let before = text_of(&folder);
    let file = [export(dir.path(), "up.csv", 2.0)];
    let notes = import_into(&file, &folder, &untitled(), &Growth::default()).unwrap();
    assert!(
        notes[0].contains("still lacks line_length and spacing"),
        "{notes:?}"
    );
    let text = text_of(&folder);
    assert!(text.starts_with(&before));
    assert!(load_session(&folder).is_err());
    let filled = text
        .replace("# line_length", "line_length")
        .replace("# spacing", "spacing");
    fs::write(folder.join("session.toml"), filled).unwrap();
    let session = load_session(&folder).unwrap().session;
    let lengths: Vec<_> = session
        .swings
        .iter()
        .map(|s| s.suspension.line_length_m)
        .collect();
    assert_eq!(lengths, [Some(Quantity::new(3.0, 0.003)); 2]);
}

#[test]
fn what_is_no_session_or_a_spoilt_one_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let growth = lines();
    let nowhere = dir.path().join("nowhere");
    let text = refused(&file, &nowhere, &untitled(), &growth);
    assert!(
        text.contains("-o instead of --into") && !nowhere.exists(),
        "{text}"
    );
    let empty = dir.path().join("empty");
    fs::create_dir(&empty).unwrap();
    assert!(refused(&file, &empty, &untitled(), &growth).contains("session.toml"));
    let zip = dir.path().join("boat.zip");
    fs::write(&zip, "PK").unwrap();
    assert!(refused(&file, &zip, &untitled(), &growth).contains("unpack"));

    let folder = session(dir.path(), &KEPT.replace("title =", "titel ="));
    let text = refused(&file, &folder, &untitled(), &growth);
    assert!(
        text.contains("line 3") && text.contains("`titel`"),
        "{text}"
    );
    let in_line = r#"format = "gyradius-session/1"
swing = [{ id = "a", periods_s = { yaw = 4.0 }, suspension = { kind = "compound", orientation = "athwartships", axis_height = 1.0 } }]
[body]
"#;
    fs::write(folder.join("session.toml"), in_line).unwrap();
    let text = refused(&file, &folder, &untitled(), &growth);
    assert!(text.contains("[[swing]]"), "{text}");
    fs::write(folder.join("session.toml"), KEPT).unwrap();
    let titled = ImportRequest {
        title: "new".to_owned(),
        ..untitled()
    };
    assert!(refused(&file, &folder, &titled, &growth).contains("title"));
}

#[test]
fn a_session_that_is_there_is_not_written_anew() {
    let dir = tempfile::tempdir().unwrap();
    let folder = session(dir.path(), KEPT);
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    let error = import_session(&file, &folder, &request(&[]), Overwrite::Refuse);
    let text = error.unwrap_err().to_string();
    assert!(
        text.contains("exists already") && text.contains("--into"),
        "{text}"
    );
    assert_eq!(
        (text_of(&folder), names(&folder).len()),
        (KEPT.to_owned(), 1)
    );
}

/// Every commented line becomes a key once its mark is taken off.
#[test]
fn a_written_session_has_lines_to_fill_in_that_are_right() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("session");
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    import_session(&file, &folder, &request(&[]), Overwrite::Refuse).unwrap();
    let text = text_of(&folder);
    let session = load_session(&folder).unwrap().session;
    assert_eq!((session.attachments.len(), session.body.mass_kg), (0, None));
    let filled: String = text
        .lines()
        .map(|line| format!("{}\n", line.trim_start_matches("# ")))
        .collect();
    let filled = read_session(&filled, "session.toml").unwrap();
    assert_eq!(filled.body.mass_kg, Some(Quantity::new(100.0, 0.2)));
    assert_eq!(filled.attachments[0].name, "phone");
    assert_eq!(filled.swings[0].excited.len(), 2);
    assert_eq!(
        filled.swings[0].suspension.top_spacing_m,
        Some(Quantity::new(1.5, 0.002))
    );
    assert_eq!(
        filled.swings[0].suspension.hull_pitch_deg,
        Some(Quantity::new(0.0, 0.3))
    );
    assert_eq!(filled.site.gravity_m_s2, Some(Quantity::new(9.81, 0.005)));
}

/// A planned swing that hangs as another one, or whose points are stated, keeps what nobody states
/// anew.
#[test]
fn a_planned_swing_keeps_how_it_is_described() {
    let points = "points_m = [[0.0, -0.5, 0.1], [0.0, 0.5, 0.1]]";
    let described = PLANNED.replace("spacing = { value = 1.0, u = 0.001 }", points);
    let again = "\n[[swing]]\nid = \"again\"\nrecording = \"again.csv\"\n[swing.suspension]\nsame_as = \"yaw\"\n";
    let filled = |name: &str, growth: &Growth| {
        let dir = tempfile::tempdir().unwrap();
        let text = format!("{KEPT}\n{described}{again}");
        let folder = session(dir.path(), &text);
        let file = [export(dir.path(), &format!("{name}.csv"), 1.0)];
        import_into(&file, &folder, &untitled(), growth).unwrap();
        let grown = text_of(&folder);
        (
            text,
            grown.clone(),
            read_session(&grown, "session.toml").unwrap(),
        )
    };
    let longer = stated(&[("line_length", Quantity::new(1.987, 0.002))]);
    let (text, grown, _) = filled("yaw", &longer);
    let expected = text.replace("{ value = 2.0, u = 0.003 }", "{ value = 1.987, u = 0.002 }");
    assert_eq!(grown, expected);
    // A spacing says otherwise how far apart the points are.
    let (text, grown, _) = filled("yaw", &stated(&[("spacing", Quantity::new(1.1, 0.002))]));
    let expected = text.replace(points, "spacing = { value = 1.1, u = 0.002 }");
    assert_eq!(grown, expected);
    let (text, grown, session) = filled("again", &longer);
    assert_eq!(
        grown,
        format!("{text}line_length = {{ value = 1.987, u = 0.002 }}\n")
    );
    assert_eq!(
        session.swings[2].suspension.points_m,
        session.swings[1].suspension.points_m
    );
    assert_eq!(session.measured_at(2, "spacing"), 1);
    // Hung the other way, it hangs no more as that one did.
    let mut turned = stated(&[("spacing", Quantity::new(2.2, 0.002))]);
    turned.hung.orientation = Some(Orientation::ForeAndAft);
    let (_, grown, session) = filled("again", &turned);
    assert!(!grown.contains("same_as"), "{grown}");
    let expected = Suspension {
        line_length_m: Some(Quantity::new(2.0, 0.003)),
        spacing_m: Some(Quantity::new(2.2, 0.002)),
        ..Suspension::unmeasured(session.swings[1].suspension.kind, Orientation::ForeAndAft)
    };
    assert_eq!(session.swings[2].suspension, expected);
}
