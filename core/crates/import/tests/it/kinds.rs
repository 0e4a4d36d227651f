//! Every kind of suspension comes in: new, as a draft, into a session and over a plan.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use gyradius_import::{
    Growth, Hanging, ImportRequest, describe_exports, import_into, import_session,
};
use gyradius_recording::{
    Orientation, Overwrite, Quantity, Suspension, SuspensionKind, load_session, read_session,
};

use crate::told::{phyphox, request};

fn export(dir: &Path, name: &str, rate: f64) -> PathBuf {
    let file = dir.join(name);
    fs::write(&file, phyphox(60, |i| 0.01 * i as f64, |i| rate * i as f64)).unwrap();
    file
}

fn hanging(kind: SuspensionKind, figures: &[(&str, Quantity)]) -> Hanging {
    let figures = figures.iter().map(|(key, q)| ((*key).to_owned(), *q));
    Hanging {
        kind: Some(kind),
        orientation: None,
        figures: figures.collect(),
    }
}

fn round() -> Hanging {
    let figures = [
        ("line_length", Quantity::new(2.0, 0.002)),
        ("radius", Quantity::new(0.25, 0.001)),
    ];
    hanging(SuspensionKind::Trifilar, &figures)
}

fn asked(hung: &Hanging) -> ImportRequest {
    ImportRequest {
        suspension: hung.alone().unwrap(),
        ..request(&[])
    }
}

/// A new session of one swing that hung so: its folder.
fn imported(dir: &Path, hung: &Hanging) -> PathBuf {
    let folder = dir.join("session");
    let file = [export(dir, "yaw.csv", 1.0)];
    import_session(&file, &folder, &asked(hung), Overwrite::Refuse).unwrap();
    folder
}

fn text_of(folder: &Path) -> String {
    fs::read_to_string(folder.join("session.toml")).unwrap()
}

/// Adds a swing to a session.
fn grown(dir: &Path, folder: &Path, name: &str, growth: &Growth) -> Result<Vec<String>, String> {
    let untitled = ImportRequest {
        title: String::new(),
        ..request(&[])
    };
    let file = [export(dir, name, 2.0)];
    import_into(&file, folder, &untitled, growth).map_err(|error| error.to_string())
}

fn last(folder: &Path) -> Suspension {
    let mut swings = load_session(folder).unwrap().session.swings;
    swings.pop().unwrap().suspension
}

#[test]
fn three_lines_are_kept_by_the_radius_of_their_circle() {
    let dir = tempfile::tempdir().unwrap();
    let folder = imported(dir.path(), &round());
    let text = text_of(&folder);
    for line in [
        "kind = \"trifilar\"\n",
        "radius = { value = 0.25, u = 0.001 }\n",
        "line_length = { value = 2.0, u = 0.002 }\n",
        "# top_radius = ",
        "# name = \"platform\"",
    ] {
        assert!(text.contains(line), "{text}");
    }
    assert!(
        !text.contains("spacing") && !text.contains("orientation"),
        "{text}"
    );
    // The circle's diameter.
    assert_eq!(last(&folder).spacing_m, Some(Quantity::new(0.5, 0.002)));
}

#[test]
fn of_a_free_suspension_nothing_is_asked() {
    let dir = tempfile::tempdir().unwrap();
    let hung = hanging(SuspensionKind::Free, &[]);
    let folder = imported(dir.path(), &hung);
    let free = Suspension::unmeasured(SuspensionKind::Free, Orientation::Athwartships);
    assert_eq!(last(&folder), free);
    let text = text_of(&folder);
    assert!(
        !text.contains("line_length") && !text.contains("To be filled in"),
        "{text}"
    );
    let growth = Growth {
        hung,
        ..Growth::default()
    };
    grown(dir.path(), &folder, "up.csv", &growth).unwrap();
    assert_eq!(last(&folder), free);
}

/// Every line to fill in becomes a key once its mark is taken off, whatever the kind.
#[test]
fn the_draft_of_every_kind_becomes_a_session_once_it_is_filled_in() {
    for kind in ["bifilar", "compound", "trifilar", "free"] {
        let kind = SuspensionKind::named(kind).unwrap();
        let dir = tempfile::tempdir().unwrap();
        let hung = hanging(kind, &[]);
        let folder = imported(dir.path(), &hung);
        let growth = Growth {
            hung,
            ..Growth::default()
        };
        let notes = grown(dir.path(), &folder, "up.csv", &growth).unwrap();
        let lacks = kind.needs().join(" and ");
        assert_eq!(notes.len(), usize::from(!lacks.is_empty()), "{notes:?}");
        assert!(notes.iter().all(|note| note.contains(&lacks)), "{notes:?}");
        let filled: String = text_of(&folder)
            .lines()
            .filter(|line| !line.starts_with("# To be filled in"))
            .map(|line| format!("{}\n", line.trim_start_matches("# ")))
            .collect();
        let session = read_session(&filled, "session.toml").unwrap();
        for swing in &session.swings {
            assert_eq!(swing.suspension.kind, kind);
            for key in kind.needs() {
                assert!(swing.suspension.figure(key).is_some(), "{key}: {filled}");
            }
        }
    }
}

/// What stands beside a missing figure does not spoil a draft.
#[test]
fn a_draft_may_state_any_of_the_figures() {
    let wide = Quantity::new(4.0, 0.001);
    for (kind, key) in [
        (SuspensionKind::Bifilar, "top_spacing"),
        (SuspensionKind::Trifilar, "top_radius"),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let hung = hanging(kind, &[(key, wide)]);
        let folder = imported(dir.path(), &hung);
        let growth = Growth {
            hung,
            ..Growth::default()
        };
        grown(dir.path(), &folder, "up.csv", &growth).unwrap();
        assert_eq!(text_of(&folder).matches(&format!("\n{key} = ")).count(), 2);
    }
}

#[test]
fn a_figure_of_another_kind_is_refused_by_its_name() {
    let figure = [("radius", Quantity::exact(0.25))];
    let two_lines = hanging(SuspensionKind::Bifilar, &figure);
    let text = two_lines.alone().unwrap_err().to_string();
    assert!(
        text.contains("`radius`") && text.contains("a trifilar suspension; a bifilar one"),
        "{text}"
    );
    // The kind is that of the swing that hung alike.
    let dir = tempfile::tempdir().unwrap();
    let folder = imported(dir.path(), &round());
    let before = text_of(&folder);
    let like = |figures: &[(&str, Quantity)]| Growth {
        like: Some("yaw".to_owned()),
        hung: Hanging {
            kind: None,
            ..hanging(SuspensionKind::Free, figures)
        },
        ..Growth::default()
    };
    let spaced = like(&[("spacing", Quantity::exact(1.0))]);
    let text = grown(dir.path(), &folder, "up.csv", &spaced).unwrap_err();
    assert!(
        text.contains("`spacing`") && text.contains("trifilar"),
        "{text}"
    );
    assert_eq!(text_of(&folder), before);
    let other = like(&[("radius", Quantity::new(0.3, 0.002))]);
    grown(dir.path(), &folder, "up.csv", &other).unwrap();
    let hung = last(&folder);
    assert_eq!(hung.figure("radius"), Some(Quantity::new(0.3, 0.002)));
    assert_eq!(hung.line_length_m, Some(Quantity::new(2.0, 0.002)));
}

#[test]
fn another_kind_drops_what_only_the_old_one_has() {
    const PLANNED: &str = "format = \"gyradius-session/1\"\n[body]\n[[swing]]\nid = \"yaw\"\n\
        recording = \"yaw.csv\"\n[swing.suspension]\nkind = \"bifilar\"  # planned\n\
        orientation = \"athwartships\"\nline_length = 2.0\nspacing = 1.0\n";
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("session");
    fs::create_dir(&folder).unwrap();
    fs::write(folder.join("session.toml"), PLANNED).unwrap();
    let radius = [("radius", Quantity::new(0.25, 0.001))];
    let growth = Growth {
        hung: hanging(SuspensionKind::Trifilar, &radius),
        ..Growth::default()
    };
    grown(dir.path(), &folder, "yaw.csv", &growth).unwrap();
    let expected = PLANNED
        .replace("\"bifilar\"", "\"trifilar\"")
        .replace("spacing = 1.0", "radius = { value = 0.25, u = 0.001 }");
    assert_eq!(text_of(&folder), expected);
}

#[test]
fn the_next_command_names_what_the_kind_needs() {
    let dir = tempfile::tempdir().unwrap();
    let file = [export(dir.path(), "yaw.csv", 1.0)];
    for (hung, end) in [
        (
            hanging(
                SuspensionKind::Trifilar,
                &[("radius", Quantity::new(0.25, 0.001))],
            ),
            "--suspension trifilar --mass KG:U --line-length M:U --radius=0.25:0.001",
        ),
        (
            hanging(SuspensionKind::Free, &[]),
            "--suspension free --mass KG:U",
        ),
    ] {
        let lines = describe_exports(&file, &asked(&hung)).unwrap();
        assert!(lines.last().unwrap().ends_with(end), "{lines:?}");
    }
}
