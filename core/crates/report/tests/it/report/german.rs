//! The report in German: no sentence of it is left in English.

#![allow(clippy::expect_used)]

use std::collections::BTreeSet;
use std::path::Path;

use gyradius_base::error::Result;
use gyradius_base::language::Language;
use gyradius_base::progress::UNWATCHED;
use gyradius_diagnosis::{Criticism, criticise};
use gyradius_identification::{Analysis, MeasureOptions, analyse};
use gyradius_recording::{LoadedSession, load_session};
use gyradius_report::{ReportSource, figures, html};

use crate::report::samples::{ambiguous, unexplained};
use crate::report::well_formed::assert_well_formed;

/// What is the same in both languages beside numbers: units, symbols, and words that are alike.
const ALIKE: [&str; 38] = [
    "kg", "mm", "µm", "Hz", "rad", "dB", "ppm", "tan", "Wind", "Exponent", "P", "F", "a", "b", "c",
    "d", "e", "g", "h", "k", "l", "m", "n", "s", "t", "u", "x", "y", "z", "N", "T", "M", "I", "W",
    "J", "L", "in", "Lamboley",
];
/// A title, which is not told in another language.
const PAPER: &str =
    "Bifilar suspension measurement of boat inertia parameters, Journal of Sailboat Technology";
/// Words that every English sentence has one of and no German one.
const ENGLISH: [&str; 22] = [
    "the", "of", "and", "with", "is", "are", "by", "from", "to", "for", "than", "which", "that",
    "not", "each", "less", "against", "what", "swing", "period", "noise", "residual",
];

/// The texts between the tags, and those that a table repeats on a narrow screen; symbols such as
/// `k` with its index `yaw` are left out.
fn texts(page: &str) -> BTreeSet<String> {
    let body = page.split("<body>").nth(1).unwrap_or_default();
    let body = body.split("<script").next().unwrap_or_default();
    let mut found = BTreeSet::new();
    let mut pieces = body.split('<').skip(1);
    while let Some(piece) = pieces.next() {
        let (tag, text) = piece.split_once('>').unwrap_or_default();
        if tag == "var" {
            pieces.find(|piece| piece.starts_with("/var"));
            continue;
        }
        let head = tag
            .split_once("data-head=\"")
            .map(|(_, rest)| rest.split('"').next().unwrap_or_default());
        let unescaped = |text: &str| text.replace("&#39;", "'").replace("&quot;", "\"");
        found.extend(head.into_iter().chain([text]).map(unescaped));
    }
    found
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphabetic())
        .filter(|word| word.chars().any(|c| c.is_ascii_alphabetic()))
}

/// A text without what the operator wrote in it: a title, a name, an id.
fn without(written: &[String], text: &str) -> String {
    let taken = |text: String, one: &String| text.replace(one.as_str(), "");
    written.iter().fold(text.replace(PAPER, ""), taken)
}

/// Texts of the German page that the English one has too, but for numbers and symbols; and those
/// with an English word.
fn left_in_english(english: &str, german: &str, written: &[String]) -> Vec<String> {
    let [english, german] = [english, german].map(texts);
    assert!(german.len() > 60, "{german:?}");
    let is_left = |text: &&String| {
        let own = without(written, text);
        let is_common = english.contains(*text) && words(&own).any(|word| !ALIKE.contains(&word));
        is_common || words(&own).any(|word| ENGLISH.contains(&word))
    };
    german.iter().filter(is_left).cloned().collect()
}

/// A shipped session, and all that the operator wrote in it, the longest first.
fn shipped(name: &str) -> Result<(LoadedSession, Analysis, Vec<String>)> {
    let sessions = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../python/gyradius/sessions");
    let loaded = load_session(sessions.join(name))?;
    let analysis = analyse(&loaded, &MeasureOptions::default())?;
    let session = &loaded.session;
    let names = session.attachments.iter().map(|mass| &mass.name);
    let ids = session.swings.iter().map(|swing| &swing.id);
    let titles = [&session.title, &session.body.name];
    let mut written: Vec<String> = titles
        .into_iter()
        .chain(names)
        .chain(ids)
        .cloned()
        .collect();
    written.retain(|one| !one.is_empty());
    written.sort_by_key(|one| std::cmp::Reverse(one.len()));
    Ok((loaded, analysis, written))
}

fn assert_german(
    name: &str,
    criticism: impl Fn(&LoadedSession) -> Option<std::result::Result<Criticism, String>>,
) -> Result<()> {
    let (loaded, analysis, written) = shipped(name)?;
    let criticism = criticism(&loaded);
    let pages = Language::ALL.map(|language| {
        let mut source = ReportSource::from_analysis(&analysis, Some(&loaded), language);
        source.criticism = criticism.clone();
        let page = html(&source);
        let tag = language.tag();
        let file = format!("shipped-{name}-{tag}.html");
        // To be looked at; the test does not need it.
        let _ = std::fs::write(Path::new(env!("CARGO_TARGET_TMPDIR")).join(file), &page);
        assert!(page.contains(&format!("<html lang=\"{tag}\">")), "{tag}");
        assert_well_formed(&page);
        for figure in figures(&source) {
            assert!(page.contains(&figure.svg), "{}", figure.title);
        }
        page
    });
    let [english, german] = &pages;
    let left = left_in_english(english, german, &written);
    assert!(left.is_empty(), "{name}: {left:#?}");
    Ok(())
}

#[test]
fn a_shipped_session_is_told_in_german() {
    assert_german("keelboat", |_| None).expect("measured");
    assert_german("model-hull", |loaded| {
        Some(criticise(loaded, UNWATCHED).map_err(|error| error.to_string()))
    })
    .expect("measured");
}

/// All of them with their criticisms, minutes.
#[test]
#[ignore = "minutes"]
fn every_shipped_session_is_told_in_german() {
    for name in ["keelboat", "boat-park", "model-hull"] {
        assert_german(name, |loaded| {
            Some(criticise(loaded, UNWATCHED).map_err(|error| error.to_string()))
        })
        .expect("measured");
    }
}

#[test]
fn ids_and_json_are_those_of_every_language() {
    let (loaded, analysis, _) = shipped("keelboat").expect("measured");
    let [english, german] = Language::ALL.map(|language| {
        let source = ReportSource::from_analysis(&analysis, Some(&loaded), language);
        let ids: Vec<String> = figures(&source)
            .into_iter()
            .map(|figure| figure.id)
            .collect();
        let json = html(&source).split("<script").nth(1).map(String::from);
        (ids, json)
    });
    assert_eq!(english, german);
}

#[test]
fn numbers_have_decimal_commas() {
    let (loaded, analysis, written) = shipped("keelboat").expect("measured");
    let source = ReportSource::from_analysis(&analysis, Some(&loaded), Language::German);
    let page = html(&source);
    let with_point = |text: &String| {
        let letters: Vec<char> = without(&written, text).chars().collect();
        letters
            .windows(3)
            .any(|w| w[0].is_ascii_digit() && w[1] == '.' && w[2].is_ascii_digit())
    };
    let made_by = source.generated_by.as_str();
    let left: Vec<String> = texts(&page)
        .into_iter()
        .filter(|text| with_point(text) && !text.contains(made_by))
        .collect();
    assert!(left.is_empty(), "{left:#?}");
}

#[test]
fn a_criticism_without_its_keys_is_shown_in_german_as_far_as_it_goes() {
    let (loaded, analysis, _) = shipped("keelboat").expect("measured");
    for criticism in [ambiguous(), unexplained()] {
        let mut source = ReportSource::from_analysis(&analysis, Some(&loaded), Language::German);
        source.criticism = Some(Ok(criticism));
        let page = html(&source);
        assert_well_formed(&page);
        for text in [
            "Log-Evidenz",
            "Wahrscheinlichkeit jeder Ursache",
            "Gemessen gegen simuliert",
        ] {
            assert!(page.contains(text), "{text}");
        }
    }
}
