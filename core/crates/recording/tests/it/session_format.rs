//! The session format: the contract's own example in full, and each bad input as a clear error.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use gyradius_base::Error;
use gyradius_recording::{
    Excitation, InclineAngle, ModeName, Orientation, Quantity, Session, SuspensionKind, SwingData,
    read_session,
};

/// The example of the format's specification, word for word.
const EXAMPLE: &str = include_str!("../fixtures/session-example.toml");

/// The smallest session, to be spoilt.
const SMALL: &str = r#"format = "gyradius-session/1"
[body]
mass = 10
[[swing]]
id = "a"
recording = "a.csv"
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = 3.0
spacing = 1.5
"#;

fn read(text: &str) -> Result<Session, Error> {
    read_session(text, "session.toml")
}

/// The message of the error that a text must give.
fn refused(text: &str) -> String {
    match read(text) {
        Err(error) => error.to_string(),
        Ok(session) => panic!("read without an error: {session:?}\n{text}"),
    }
}

fn assert_refused(text: &str, line: usize, parts: &[&str]) {
    let message = refused(text);
    let place = format!("session.toml, line {line}: ");
    assert!(
        message.starts_with(&place),
        "{message:?} does not start with {place:?}"
    );
    for part in parts {
        assert!(message.contains(part), "{message:?} lacks {part:?}");
    }
}

#[test]
fn the_example_of_the_specification_is_read_in_full() {
    let session = read(EXAMPLE).unwrap();
    assert_eq!(session.title, "Yngling 0042, boatyard");
    assert_eq!(session.body.name, "Yngling 0042");
    assert_eq!(session.body.mass_kg, Some(Quantity::new(622.7, 0.5)));
    assert_eq!(session.body.length_overall_m, Some(6.35));
    assert_eq!(session.body.density_kg_m3, Some(750.0));
    assert_eq!(
        session.site.gravity_m_s2,
        Some(Quantity::new(9.80665, 5e-4))
    );
    assert_eq!(session.site.air_density_kg_m3, Some(1.20));
    assert_eq!(
        (session.site.latitude_deg, session.site.altitude_m),
        (None, None)
    );
    let [beam] = &session.attachments[..] else {
        panic!("one attachment")
    };
    assert_eq!(
        (beam.name.as_str(), beam.mass_kg),
        // Without u: 0.2 %.
        ("cross beam", Quantity::new(12.0, 2e-3 * 12.0))
    );
    assert_eq!(
        (beam.position_m, beam.gyradii_m),
        ([0.05, 0.0, 0.02], [0.60, 0.05, 0.60])
    );
}

#[test]
fn the_swings_and_inclines_of_the_example_are_read_in_full() {
    let session = read(EXAMPLE).unwrap();
    let [first, second] = &session.swings[..] else {
        panic!("two swings")
    };
    assert_eq!(
        (first.id.as_str(), &first.data),
        ("yaw-1", &SwingData::Recording("yaw-1.csv".into()))
    );
    assert_eq!(first.excited, [Excitation::Yaw, Excitation::Sway]);
    assert_eq!(
        first.added_masses[0].mass_kg,
        Quantity::new(1.2, 2e-3 * 1.2)
    );
    assert_eq!(first.added_masses[1].position_m, [-2.717, 0.0, 0.0]);
    let hung = &first.suspension;
    assert_eq!(
        (hung.kind, hung.orientation),
        (SuspensionKind::Bifilar, Orientation::Athwartships)
    );
    assert_eq!(hung.line_length_m, Some(Quantity::new(3.477, 0.006)));
    assert_eq!(hung.spacing_m, Some(Quantity::new(1.8, 0.001)));
    assert_eq!(hung.top_spacing_m, Some(Quantity::new(1.8, 0.002)));
    assert_eq!(hung.hull_pitch_deg, Some(Quantity::new(0.0, 0.2)));
    let periods = [
        (ModeName::Yaw, Quantity::new(4.391, 0.004)),
        (ModeName::Sway, Quantity::new(3.802, 0.004)),
    ];
    assert_eq!(second.data, SwingData::PeriodsS(periods.into()));
    assert_eq!(second.amplitude_deg, [(ModeName::Yaw, 5.0)].into());
    let [incline] = &session.inclines[..] else {
        panic!("one incline")
    };
    assert_eq!(incline.depth_m, Quantity::new(0.03, 0.002));
    assert_eq!(
        incline.angle,
        InclineAngle::Stated(Quantity::new(8.2, 0.05))
    );
}

#[test]
fn an_empty_file_a_missing_and_a_wrong_version_are_refused() {
    assert_eq!(
        refused(" \n"),
        "session.toml: expected a text that starts with `format = \"gyradius-session/1\"`, found an empty file"
    );
    let without = SMALL.split_once('\n').unwrap().1;
    assert!(
        refused(without).contains("`format` (the format's name and version"),
        "{}",
        refused(without)
    );
    for version in [
        "gyradius-session/2",
        "gyradius-session/10",
        "gyradius-session/1.",
        "phyphox/1",
        "",
    ] {
        let text = format!("# a comment\nformat = \"{version}\"\nnew_key = 1\n");
        assert_refused(&text, 2, &["gyradius-session/1", version]);
    }
    assert!(read(&SMALL.replace("session/1", "session/1.3")).is_ok());
}

#[test]
fn a_broken_toml_says_where() {
    assert_refused(&SMALL.replace("mass = 10", "mass = = 10"), 3, &["TOML"]);
    assert_refused(&SMALL.replace("[[swing]]", "[[swing]"), 4, &["TOML"]);
    assert_refused(
        &format!("{SMALL}spacing = 2\n"),
        12,
        &["TOML", "duplicate key"],
    );
}

#[test]
fn unknown_keys_name_the_key_and_the_nearest_known_one() {
    let data = "recording = \"a.csv\"";
    let cases = [
        (
            "mass = 10",
            "maas = 10",
            3,
            "`body.maas`; the nearest known key is `mass`",
        ),
        (
            "[[swing]]",
            "[[swings]]",
            4,
            "`swings`; the nearest known key is `swing`",
        ),
        (
            "line_length",
            "line_lenght",
            10,
            "`swing[1].suspension.line_lenght`; the nearest known key is `line_length`",
        ),
        (
            "3.0",
            "{ value = 3, v = 1 }",
            10,
            "`swing[1].suspension.line_length.v`; the nearest known key is `u`",
        ),
        (
            data,
            "periods_s = { yav = 4.0 }",
            6,
            "`swing[1].periods_s.yav`; the nearest known key is `yaw`",
        ),
        (
            data,
            "periods_s = { \"x.yaw\" = 4.0 }",
            6,
            "`swing[1].periods_s.x.yaw`",
        ),
    ];
    for (old, new, line, part) in cases {
        let text = SMALL.replace(old, new).replace("[swings.", "[swing.");
        assert!(
            matches!(read(&text), Err(Error::UnknownKey { .. })),
            "{new}: {:?}",
            read(&text)
        );
        assert_refused(&text, line, &[part]);
    }
}

#[test]
fn numbers_outside_their_domain_are_refused() {
    let data = "recording = \"a.csv\"";
    let cases = [
        (
            "line_length = 3.0",
            "line_length = -3.0",
            10,
            "`swing[1].suspension.line_length`",
            "-3.0",
        ),
        (
            "line_length = 3.0",
            "line_length = nan",
            10,
            "`swing[1].suspension.line_length`",
            "nan",
        ),
        (
            "line_length = 3.0",
            "line_length = \"3.0\"",
            10,
            "`swing[1].suspension.line_length`",
            "\"3.0\" (string)",
        ),
        (
            "line_length = 3.0",
            "line_length = { value = 3, u = -1 }",
            10,
            "line_length.u`",
            "-1",
        ),
        (
            "line_length = 3.0",
            "line_length = { u = 1 }",
            10,
            "line_length.value`",
            "no key `value`",
        ),
        (
            "line_length = 3.0",
            "line_length = [3.0]",
            10,
            "line_length`",
            "array",
        ),
        (
            "spacing = 1.5",
            "spacing = 0",
            11,
            "spacing`",
            "0 (integer)",
        ),
        ("spacing = 1.5", "spacing = inf", 11, "spacing`", "inf"),
        (
            "spacing = 1.5",
            "spacing = 1.5\ntop_spacing = 7.5",
            12,
            "top_spacing`",
            "7.5",
        ),
        (
            "spacing = 1.5",
            "spacing = 1.5\nhull_pitch_deg = 91",
            12,
            "hull_pitch_deg`",
            "91",
        ),
        ("mass = 10", "mass = 0.0", 3, "`body.mass`", "0.0"),
        ("mass = 10", "density = -1", 3, "`body.density`", "-1"),
        ("mass = 10", "density = 0.75", 3, "`body.density`", "0.75"),
        (
            "mass = 10",
            "length_overall = true",
            3,
            "`body.length_overall`",
            "true (boolean)",
        ),
        (
            "mass = 10",
            "[site]\nlatitude_deg = 90.5",
            4,
            "`site.latitude_deg`",
            "90.5",
        ),
        (
            "mass = 10",
            "[site]\ngravity = 980.0",
            4,
            "`site.gravity`",
            "980.0",
        ),
        (
            "mass = 10",
            "[site]\naltitude = 10",
            4,
            "`site.altitude`",
            "latitude_deg",
        ),
        (
            "mass = 10",
            "[site]\ngravity = 9.8\nlatitude_deg = 50",
            5,
            "`site.latitude_deg`",
            "gravity",
        ),
        (
            "mass = 10",
            "mass = 10\n[[attachment]]\nmass = 12\nposition = [0, 0, 0]",
            3,
            "`body.mass`",
            "12",
        ),
        (
            "mass = 10",
            "[[attachment]]\nmass = 12\nposition = [0, 0]",
            5,
            "`attachment[1].position`",
            "[0, 0]",
        ),
        (
            "mass = 10",
            "[[attachment]]\nmass = 12\nposition = [0, 0, inf]",
            5,
            "`attachment[1].position`",
            "inf",
        ),
        (
            data,
            "periods_s = { yaw = 0 }",
            6,
            "`swing[1].periods_s.yaw`",
            "0",
        ),
        (data, "periods_s = {}", 6, "`swing[1].periods_s`", "none"),
    ];
    for (old, new, line, key, found) in cases {
        assert_refused(&SMALL.replace(old, new), line, &[key, found]);
    }
}

#[test]
fn swings_that_contradict_themselves_are_refused() {
    let data = "recording = \"a.csv\"";
    let cases = [
        ("id = \"a\"", "id = \"\"", 5, "`swing[1].id`"),
        ("id = \"a\"", "id = 7", 5, "`swing[1].id`"),
        ("id = \"a\"\n", "", 4, "`swing[1].id`"),
        (
            data,
            "excited = []",
            4,
            "exactly one of `recording`, `displacement`, `periods`, `periods_s`",
        ),
        (
            data,
            "recording = \"a.csv\"\nperiods = \"b.csv\"",
            7,
            "both `recording` and `periods`",
        ),
        (
            data,
            "recording = \"a.csv\"\nat = [1, 0, 0]",
            7,
            "`swing[1].at`",
        ),
        (
            data,
            "recording = \"a.csv\"\namplitude_deg = { yaw = 5 }",
            7,
            "`swing[1].amplitude_deg`",
        ),
        (
            data,
            "periods_s = { yaw = 4 }\namplitude_deg = { sway = 5 }",
            7,
            "a period of `sway`",
        ),
        (
            data,
            "recording = \"a.csv\"\nexcited = [\"yow\"]",
            7,
            "the nearest is `yaw`",
        ),
        (
            data,
            "recording = \"a.csv\"\nexcited = \"yaw\"",
            7,
            "`swing[1].excited`",
        ),
        (
            data,
            "recording = \"a.csv\"\nadded_mass = [3]",
            7,
            "`swing[1].added_mass`",
        ),
        ("\"bifilar\"", "\"bifiler\"", 8, "the nearest is `bifilar`"),
        (
            "\"bifilar\"",
            "\"compound\"",
            10,
            "a bifilar or trifilar suspension; a compound one is described by axis_height",
        ),
        (
            "\"bifilar\"",
            "\"bifilar\"\naxis_height = 1",
            9,
            "a compound suspension; a bifilar one",
        ),
        ("spacing = 1.5\n", "", 7, "`swing[1].suspension.spacing`"),
        (
            "orientation = \"athwartships\"\n",
            "",
            7,
            "`swing[1].suspension.orientation`",
        ),
        ("[swing.suspension]", "[suspension]", 7, "`suspension`"),
    ];
    for (old, new, line, part) in cases {
        assert_refused(&SMALL.replace(old, new), line, &[part]);
    }
    let twice = format!("{SMALL}{}", SMALL.split_once("10\n").unwrap().1);
    assert_refused(&twice, 13, &["`swing[2].id`", "\"a\" again"]);
}

#[test]
fn inclines_are_checked_and_suffice_without_a_swing() {
    let good = "format = \"gyradius-session/1\"\n[body]\n[[incline]]\nend = \"bow\"\nmass = 1\narm = 0.8\n\
                depth = -0.01\nangle_deg = 8\n";
    assert_eq!(read(good).unwrap().inclines.len(), 1);
    let cases = [
        (
            "angle_deg = 8",
            "angle_deg = 0",
            8,
            "`incline[1].angle_deg`",
        ),
        (
            "angle_deg = 8",
            "angle_deg = 90",
            8,
            "`incline[1].angle_deg`",
        ),
        (
            "angle_deg = 8",
            "",
            3,
            "exactly one of `angle_deg`, `recording`",
        ),
        (
            "angle_deg = 8",
            "angle_deg = 8\nrecording = \"i.csv\"",
            9,
            "both `angle_deg` and `recording`",
        ),
        ("\"bow\"", "\"port\"", 4, "`bow`, `stern`"),
        ("arm = 0.8", "arm = -0.8", 6, "`incline[1].arm`"),
    ];
    for (old, new, line, part) in cases {
        assert_refused(&good.replace(old, new), line, &[part]);
    }
    let neither = "format = \"gyradius-session/1\"\n[body]\n";
    assert!(refused(neither).contains("at least one [[swing]] or [[incline]]"));
    assert!(refused("format = \"gyradius-session/1\"\n").contains("`body`"));
}

#[test]
fn file_names_that_leave_the_session_are_refused() {
    for name in [
        "../a.csv",
        "/etc/passwd",
        "sub/../../a.csv",
        "C:/a.csv",
        "",
        "sub/",
    ] {
        assert_refused(
            &SMALL.replace("a.csv", name),
            6,
            &["`swing[1].recording`", "plain relative name"],
        );
    }
    assert_refused(
        &SMALL.replace("\"a.csv\"", "'sub\\a.csv'"),
        6,
        &["backslash"],
    );
}

#[test]
fn other_spellings_of_toml_read_the_same() {
    let plain = read(SMALL).unwrap();
    let dotted = r#"format = "gyradius-session/1"
body.mass.value = 10
swing = [ { id = "a", recording = "./a.csv", suspension = { kind = "bifilar", orientation = "athwartships", line_length.value = 3, spacing = 1.5 } } ]
"#;
    assert_eq!(read(dotted).unwrap(), plain);
    assert_eq!(read(&SMALL.replace('\n', "\r\n")).unwrap(), plain);
    assert_eq!(read(&format!("\u{feff}{SMALL}")).unwrap(), plain);
}

#[test]
fn what_an_import_found_is_read_under_both_names_of_its_list() {
    let told = "text = \"lost\", kind = \"not_imported\"";
    let inline = format!("repairs = [{{ {told} }}]");
    let tables = format!("[[recorded.repair]]\n{}", told.replace(", ", "\n"));
    for list in [inline, tables] {
        let recorded = format!(
            "\n[[recorded]]\nfile = \"a.csv\"\nmeasured_on = \"2024-05-06\"\nphone = \"P\"\nlogger = \"L\"\n{list}\n"
        );
        let session = read(&format!("{SMALL}{recorded}")).unwrap();
        let one = &session.recorded[0];
        assert_eq!(
            (&*one.measured_on, &*one.phone, &*one.logger),
            ("2024-05-06", "P", "L")
        );
        assert_eq!(one.repairs.len(), 1);
        assert_eq!(one.repairs[0].text, "lost");
    }
    let top = SMALL.replacen("[body]", "phone = \"P\"\nlogger = \"L\"\n[body]", 1);
    let session = read(&top).unwrap();
    assert_eq!((&*session.phone, &*session.logger), ("P", "L"));
    assert!(refused(&top.replace("phone", "phon")).contains("`phon`"));
}

/// Figures with an instrument: its errors are shared, the usual u is that of the reading alone.
#[test]
fn figures_name_the_instrument_that_they_were_read_with() {
    let tape = "[[instrument]]\nid = \"tape-1\"\nkind = \"tape\"\nscale_u = 5e-4\nzero_u = 1e-3\n";
    let text = SMALL.replace(
        "spacing = 1.5",
        "spacing = { value = 1.5, instrument = \"tape-1\" }",
    ) + tape;
    let session = read(&text).unwrap();
    let key = "swing[1].suspension.spacing";
    let tape = session.instrument(key).unwrap();
    assert_eq!((tape.scale_u, tape.zero_u), (5e-4, 1e-3));
    let own = session.swings[0].suspension.spacing_m.unwrap();
    assert_eq!(own, Quantity::new(1.5, 2e-3));
    // √(0.002² + (0.0005 · 1.5)² + 0.001²)
    let whole = session.reading(key, own);
    assert!((whole.u - 2.358_495_3e-3).abs() < 1e-9, "{whole:?}");
    assert!(
        session
            .instrument("swing[1].suspension.line_length")
            .is_none()
    );
}

/// What hangs as an earlier swing did has its figures; an id that is not there is refused.
#[test]
fn a_swing_hangs_as_an_earlier_one() {
    let again = "[[swing]]\nid = \"again\"\nperiods_s = { yaw = 5.0 }\n[swing.suspension]\n";
    let text = format!("{SMALL}{again}same_as = \"a\"\n");
    let session = read(&text).unwrap();
    assert_eq!(session.swings[1].suspension, session.swings[0].suspension);
    assert_eq!(session.same_hanging(1), Some(0));
    let written = gyradius_recording::write_session(&session);
    assert!(written.contains("same_as = \"a\""), "{written}");
    assert_eq!(read(&written).unwrap(), session);
    let message = refused(&format!("{SMALL}{again}same_as = \"jaw\"\n"));
    assert!(
        message.contains("same_as") && message.contains("(a)"),
        "{message}"
    );
    let both = refused(&format!("{SMALL}{again}same_as = \"a\"\nkind = \"free\"\n"));
    assert!(both.contains("kind"), "{both}");
}

/// Beside `same_as` stands what differs: those are readings of their own, the others the same ones.
#[test]
fn a_swing_hangs_as_an_earlier_one_but_for_what_is_stated() {
    let again = "[[swing]]\nid = \"again\"\nperiods_s = { yaw = 5.0 }\n[swing.suspension]\n";
    let tilted = "hull_pitch_deg = { value = 20.0, u = 0.2 }\npoints_moved = 0.1\n";
    let text = format!("{SMALL}{again}same_as = \"a\"\n{tilted}");
    let session = read(&text).unwrap();
    let [level, hung] = [0, 1].map(|i| session.swings[i].suspension.clone());
    assert_eq!(hung.line_length_m, level.line_length_m);
    assert_eq!(hung.spacing_m, level.spacing_m);
    assert_eq!(hung.hull_pitch_deg, Some(Quantity::new(20.0, 0.2)));
    for (key, home) in [("line_length", 0), ("spacing", 0), ("hull_pitch_deg", 1)] {
        assert_eq!(session.measured_at(1, key), home, "{key}");
    }
    // A third as the second: its lines are those of the first, its tilt that of the second; at
    // another tilt the points are elsewhere.
    let third = again.replace("again", "third") + "same_as = \"again\"\n";
    let three = read(&format!("{text}{third}")).unwrap();
    assert_eq!(three.swings[2].suspension, hung);
    assert_eq!(
        [0, 1].map(|k| three.measured_at(2, ["spacing", "points_moved"][k])),
        [0, 1]
    );
    let flat = read(&format!("{text}{third}hull_pitch_deg = 0.5\n")).unwrap();
    assert_eq!(flat.swings[2].suspension.points_moved_m, None);
    // Another direction has other points.
    let turned = format!("{SMALL}{again}same_as = \"a\"\norientation = \"fore_and_aft\"\n");
    assert!(refused(&turned).contains("spacing"));
    let turned = read(&format!("{turned}spacing = 2.5\n")).unwrap();
    assert_eq!(turned.swings[1].suspension.spacing_m.unwrap().value, 2.5);
    assert_eq!(
        turned.swings[1].suspension.line_length_m,
        level.line_length_m
    );
    for session in [session, three, flat, turned] {
        let written = gyradius_recording::write_session(&session);
        assert_eq!(read(&written).unwrap(), session, "{written}");
    }
}

/// A program that hangs a hull on the same lines in several ways read them once.
#[test]
fn a_program_tells_which_readings_it_copied() {
    let again = "[[swing]]\nid = \"again\"\nperiods_s = { yaw = 5.0 }\n[swing.suspension]\n";
    let first = read(&format!("{SMALL}{again}same_as = \"a\"\n")).unwrap();
    let copies = |change: &dyn Fn(&mut gyradius_recording::Suspension)| {
        let mut session = first.clone();
        session.hung_as.clear();
        change(&mut session.swings[1].suspension);
        let told = session.with_same_hangings();
        let written = gyradius_recording::write_session(&told);
        assert_eq!(read(&written).unwrap(), told, "{written}");
        let hung = told.hung_as.get("again")?;
        Some(hung.but_for.iter().cloned().collect::<Vec<_>>().join(" "))
    };
    let read = |value: f64| Some(Quantity::new(value, 0.002));
    assert_eq!(copies(&|_| ()).as_deref(), Some(""));
    let tilted = copies(&|hung| hung.hull_pitch_deg = read(20.0));
    assert_eq!(tilted.as_deref(), Some("hull_pitch_deg"));
    let longer = copies(&|hung| hung.line_length_m = read(9.0));
    assert_eq!(longer.as_deref(), Some("line_length"));
    let other = copies(&|hung| {
        (hung.line_length_m, hung.spacing_m) = (read(9.0), read(0.7));
    });
    assert_eq!(other, None);
}

#[test]
fn points_lie_along_the_suspension() {
    let points = |text: &str| SMALL.replace("spacing = 1.5", &format!("points_m = {text}"));
    let session = read(&points("[[0.0, -0.75, 0.1], [0.0, 0.75, 0.1]]")).unwrap();
    let hung = &session.swings[0].suspension;
    assert_eq!(hung.spacing_m.unwrap().value, 1.5);
    for wrong in [
        "[[-0.75, 0.0, 0.1], [0.75, 0.0, 0.1]]",
        "[[0.0, -0.75, 0.1]]",
        "[[0.0, -0.75], [0.0, 0.75]]",
        "[[0.0, 0.0, 0.1], [0.0, 0.0, 0.1]]",
    ] {
        assert!(refused(&points(wrong)).contains("points_m"), "{wrong}");
    }
}

#[test]
fn an_instrument_that_is_not_there_or_reads_something_else_is_refused() {
    let named = SMALL.replace(
        "spacing = 1.5",
        "spacing = { value = 1.5, instrument = \"t\" }",
    );
    assert_refused(
        &named,
        11,
        &["[[instrument]]", "swing[1].suspension.spacing"],
    );
    let clock = format!("{named}[[instrument]]\nid = \"t\"\nkind = \"clock\"\n");
    assert_refused(&clock, 11, &["a tape", "a clock"]);
    let twice = format!("{clock}[[instrument]]\nid = \"t\"\nkind = \"tape\"\n");
    assert_refused(&twice, 16, &["unlike all before it"]);
}

#[test]
fn three_lines_have_a_radius_and_a_free_body_has_nothing() {
    let bifilar =
        "kind = \"bifilar\"\norientation = \"athwartships\"\nline_length = 3.0\nspacing = 1.5\n";
    let with = |text: &str| SMALL.replace(bifilar, text);
    let trifilar = "kind = \"trifilar\"\nline_length = 3.0\nradius = { value = 0.25, u = 0.001 }\n";
    let session = read(&with(trifilar)).unwrap();
    let hung = &session.swings[0].suspension;
    assert_eq!(hung.kind, SuspensionKind::Trifilar);
    assert_eq!(hung.spacing_m, Some(Quantity::new(0.5, 0.002)));
    assert_eq!(
        read(&gyradius_recording::write_session(&session)).unwrap(),
        session
    );
    let free = read(&with("kind = \"free\"\n")).unwrap();
    assert_eq!(free.swings[0].suspension.kind, SuspensionKind::Free);
    assert_eq!(
        read(&gyradius_recording::write_session(&free)).unwrap(),
        free
    );
    let both = format!("{trifilar}spacing = 0.5\n");
    assert_refused(&with(&both), 11, &["radius"]);
    assert_refused(
        &with("kind = \"free\"\nline_length = 3.0\n"),
        9,
        &["nothing is stated"],
    );
    let round = format!("{bifilar}radius = 0.5\n");
    assert_refused(&with(&round), 12, &["trifilar"]);
}

/// A place has one u for each coordinate: stated, or what a tape has at the largest of them.
#[test]
fn a_position_has_an_uncertainty() {
    let beam = |position: &str| {
        let text = format!("[[attachment]]\nmass = 1.0\nposition = {position}\n");
        read(&(SMALL.to_owned() + &text)).unwrap().attachments[0].clone()
    };
    let stated = beam("{ value = [0.4, -2.0, 0.1], u = 0.005 }");
    assert_eq!(
        (stated.position_m, stated.position_u_m),
        ([0.4, -2.0, 0.1], 0.005)
    );
    assert!((beam("[0.4, -2.0, 0.1]").position_u_m - 0.003).abs() < 1e-12);
}
