//! Which room of the core may know which (ARCHITECTURE.md). Collects every `crate::…` path of every
//! source file.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// `room: what it may know`. `error`, `constants`, `frames`, `language`, `progress` and `parallel`
/// are known to all.
const MAY_KNOW: [(&str, &[&str]); 19] = [
    ("error", &[]),
    ("constants", &[]),
    ("frames", &[]),
    ("language", &[]),
    ("progress", &[]),
    ("parallel", &[]),
    ("recording", &[]),
    ("recorder", &["recording"]),
    ("signal", &["recording"]),
    ("intake", &["recording", "recorder", "signal"]),
    ("live", &["recording", "signal"]),
    ("modes", &["recording", "signal"]),
    ("dynamics", &[]),
    ("practice", &["recording", "dynamics"]),
    ("inertia", &["recording", "signal", "modes", "dynamics"]),
    (
        "critique",
        &["recording", "signal", "modes", "dynamics", "inertia"],
    ),
    (
        "plan",
        &[
            "recording",
            "signal",
            "modes",
            "dynamics",
            "practice",
            "inertia",
            "critique",
        ],
    ),
    (
        "procedure",
        &[
            "recording",
            "recorder",
            "live",
            "plan",
            "practice",
            "inertia",
            "critique",
        ],
    ),
    (
        "report",
        &[
            "recording",
            "signal",
            "modes",
            "dynamics",
            "inertia",
            "critique",
        ],
    ),
];
const KNOWN_TO_ALL: [&str; 6] = [
    "error",
    "constants",
    "frames",
    "language",
    "progress",
    "parallel",
];

fn sources(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Names that follow `crate::`, braces included: `crate::{error::Error, signal::x}` knows `error`
/// and `signal`.
fn known_rooms(text: &str) -> BTreeSet<String> {
    let mut rooms = BTreeSet::new();
    for (at, _) in text.match_indices("crate::") {
        let rest = &text[at + 7..];
        let names: Vec<&str> = if let Some(inside) = rest.strip_prefix('{') {
            top_level_names(inside)
        } else {
            vec![rest]
        };
        for name in names {
            let name: String = name
                .trim()
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            rooms.insert(name);
        }
    }
    rooms
}

fn top_level_names(inside: &str) -> Vec<&str> {
    let (mut depth, mut start, mut names) = (0, 0, Vec::new());
    for (i, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => {
                names.push(&inside[start..i]);
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                names.push(&inside[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    names
}

#[test]
fn every_room_knows_only_what_it_may() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let allowed: BTreeMap<&str, &[&str]> = MAY_KNOW.into_iter().collect();
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut wrong = Vec::new();
    let mut seen = BTreeSet::new();
    for file in files {
        let inside = file.strip_prefix(&root).unwrap();
        let room = inside
            .iter()
            .next()
            .unwrap()
            .to_str()
            .unwrap()
            .trim_end_matches(".rs")
            .to_string();
        if room == "lib" {
            continue;
        }
        let may = allowed
            .get(room.as_str())
            .unwrap_or_else(|| panic!("{room} is no room of ARCHITECTURE.md"));
        seen.insert(room.clone());
        let text = fs::read_to_string(&file).unwrap();
        for known in known_rooms(&text) {
            let is_room = allowed.contains_key(known.as_str());
            let fine = known == room
                || KNOWN_TO_ALL.contains(&known.as_str())
                || may.contains(&known.as_str());
            if is_room && !fine {
                wrong.push(format!("{} knows {known}", inside.display()));
            }
        }
        for foreign in ["pyo3", "uniffi"] {
            if text.contains(&format!("{foreign}::")) {
                wrong.push(format!("{} knows {foreign}", inside.display()));
            }
        }
    }
    assert_eq!(seen.len(), MAY_KNOW.len(), "rooms seen: {seen:?}");
    assert!(wrong.is_empty(), "forbidden arrows:\n{}", wrong.join("\n"));
}

#[test]
fn braces_are_read() {
    let text = "use crate::{error::{Error, Result}, signal::Fit}; use crate::modes;";
    let expected: BTreeSet<String> = ["error", "signal", "modes"]
        .into_iter()
        .map(String::from)
        .collect();
    assert_eq!(known_rooms(text), expected);
}
