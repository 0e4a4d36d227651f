//! Every language says the same: the same keys, and in each sentence the same names.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use gyradius_core::identification::{MeasureOptions, Measurement, measure};
use gyradius_core::language::Language;
use gyradius_core::message::{Message, id_in, texts};
use gyradius_core::planning::{Warning, WarningKind};
use gyradius_core::recording::load_session;
use gyradius_core::{diagnosis, identification};

#[test]
fn no_sentence_is_left_in_english() {
    let said = |language| {
        // What is nothing but places has no language, and a single word may be the same.
        let has_words = |text: &String| {
            let mut inside = false;
            let outside = text.chars().filter(|c| {
                inside = (inside || *c == '{') && *c != '}';
                !inside
            });
            text.contains(' ') && outside.filter(|c| c.is_alphabetic()).count() > 0
        };
        texts(language)
            .into_iter()
            .map(|(_, text)| text)
            .filter(has_words)
            .collect::<BTreeSet<_>>()
    };
    let common: Vec<String> = said(Language::English)
        .intersection(&said(Language::German))
        .cloned()
        .collect();
    assert!(common.is_empty(), "{common:?}");
}

/// Text of every Rust source under a folder.
fn sources(folder: &Path, all: &mut String) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, all);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            all.push_str(&fs::read_to_string(&path).unwrap());
        }
    }
}

/// Keys that the sources do not write out: the last part of a key is an enum's name in the format,
/// or a word of an id that a user may choose.
#[test]
fn every_message_is_used() {
    let mut all = String::new();
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates")).unwrap() {
        sources(&entry.unwrap().path().join("src"), &mut all);
    }
    let all = all.replace(' ', "_");
    let unused: Vec<String> = texts(Language::English)
        .into_iter()
        .map(|(id, _)| id)
        .filter(|id| {
            // A name may go on with its unit, and a key end in what is put there (`{…}`).
            let is_written = |part: &str| {
                let before = part.rsplit_once('_').map_or(part, |(before, _)| before);
                let starts = ["\"", "."].map(|start| format!("{start}{part}"));
                let put_there = format!("\"{before}{{");
                starts.iter().any(|start| all.contains(start)) || all.contains(&put_there)
            };
            let whole = id.splitn(3, '-').last().unwrap_or_default();
            let in_family = id.split_once('-').map_or("", |(_, rest)| rest);
            ![whole, in_family, id.as_str()]
                .iter()
                .any(|part| is_written(part))
        })
        .collect();
    assert!(unused.is_empty(), "{unused:?}");
}

#[test]
fn a_language_is_known_by_its_tag() {
    for language in Language::ALL {
        assert_eq!(language.tag().parse::<Language>().unwrap(), language);
    }
    assert!("fr".parse::<Language>().is_err());
}

#[test]
fn every_text_of_the_report_is_there() {
    let report = |language| -> BTreeSet<String> {
        let ids = texts(language).into_iter().map(|(id, _)| id);
        ids.filter(|id| id.starts_with("report-")).collect()
    };
    let english = report(Language::English);
    assert!(english.len() > 200 && english == report(Language::German));
}

#[test]
fn an_id_is_told_by_its_words() {
    let told = |id: &str| [Language::English, Language::German].map(|language| id_in(id, language));
    assert_eq!(told("yaw-sway-2"), ["yaw-sway-2", "Gieren-Querschwingen-2"]);
    assert_eq!(told("incline-bow"), ["incline-bow", "Neigungsversuch-Bug"]);
    assert_eq!(told("Tuesday"), ["Tuesday", "Tuesday"]);
}

#[test]
fn quantities_routes_and_causes_have_names_and_units() {
    let german = Language::German;
    assert_eq!(
        identification::quantity_in("k_yaw_m", german),
        "Trägheitsradius Gieren"
    );
    assert_eq!(
        identification::quantity_in("small_period_yaw_s", Language::English),
        "small period yaw"
    );
    assert_eq!(
        ["small_period_yaw_s", "i_kg_m2", "g_m_s2", "mass"].map(identification::unit_of),
        ["s", "kg m²", "m/s²", ""]
    );
    assert_eq!(
        identification::route_in("lamboley", german),
        "physikalisches Pendel in zwei Höhen (Lamboley)"
    );
    assert_eq!(identification::route_in("a_new_one", german), "a new one");
    assert_eq!(
        diagnosis::cause_name(diagnosis::CauseId::QuadraticDrag, german),
        "quadratischer Luftwiderstand"
    );
    assert_eq!(
        diagnosis::cause_name(diagnosis::CauseId::QuadraticDrag, Language::English),
        "quadratic drag"
    );
}

#[test]
fn a_warning_is_told_with_its_numbers_and_names() {
    let numbers = [("u_percent", 20.0)];
    let warning = Warning::new(
        WarningKind::RoughHull,
        None,
        &numbers,
        &[("quantity", "k_yaw_m")],
    );
    let german = warning.message().in_language(Language::German);
    assert!(
        german.starts_with("k_yaw_m des Rumpfs ist nur auf 20 % bekannt"),
        "{german}"
    );
    assert_eq!(
        warning.text,
        warning.message().in_language(Language::English)
    );
    let numbers = [
        ("reached_u", 0.02),
        ("wanted_u", 0.01),
        ("contribution_u", 0.015),
        ("times_better", 3.0),
    ];
    let names = [("quantity", "depth"), ("input", "line_length")];
    let warning = Warning::new(WarningKind::NotReached, None, &numbers, &names);
    let german = warning.message().in_language(Language::German);
    let begins = "Schwerpunkttiefe erreicht u = 0,020, nicht 0,010: das meiste kommt von: Leinenlänge (0,015).";
    assert!(german.starts_with(begins), "{german}");
    assert!(
        warning
            .text
            .contains("most of it comes from line_length (0.015)"),
        "{}",
        warning.text
    );
}

#[test]
fn a_number_below_zero_has_a_minus_sign_and_no_hyphen() {
    let numbers = [
        ("tilt_deg", -25.0),
        ("points_moved_m", 0.4),
        ("corner_tilt_deg", -0.01),
    ];
    let warning = Warning::new(WarningKind::TiltNeeded, Some("w1"), &numbers, &[]);
    let german = warning.message().in_language(Language::German);
    assert!(
        german.starts_with("Schwingung w1 hängt geneigt, −25,0°"),
        "{german}"
    );
    assert!(
        warning.text.starts_with("Swing w1 hangs tilted, −25.0°"),
        "{}",
        warning.text
    );
    // Of what rounds to zero none.
    assert!(german.contains("gäben 0,0°"), "{german}");
    let figures =
        Language::ALL.map(|language| language.number("-5.52 ± 0.65 m, 3 of -1, yaw-sway"));
    assert_eq!(
        figures,
        [
            "−5.52 ± 0.65 m, 3 of −1, yaw-sway",
            "−5,52 ± 0,65 m, 3 of −1, yaw-sway"
        ]
    );
}

/// Everything that the measurement of a session says, with its sentence; inputs of budgets by their
/// labels.
fn told(measured: &Measurement) -> Vec<(String, Message)> {
    let of_swings = measured.swings.iter().flat_map(|swing| &swing.warnings);
    let claims = measured.consistency.iter().map(|claim| &claim.message);
    let all = of_swings.chain(&measured.warnings).chain(claims);
    let mut all: Vec<(String, Message)> =
        all.map(|one| (one.english.clone(), one.clone())).collect();
    let lines = measured.budget.values().flatten();
    all.extend(lines.map(|line| (line.input.to_string(), line.input.message())));
    all
}

#[test]
fn a_measurement_is_told_in_every_language() {
    let sessions = Path::new(env!("CARGO_MANIFEST_DIR")).join("../python/gyradius/sessions");
    for name in ["boat-park", "keelboat", "model-hull"] {
        let loaded = load_session(sessions.join(name)).unwrap();
        // A limit of what is not measured is warned of.
        let limits = vec!["small_period_ballast_s >= 1".parse().unwrap()];
        let measured = measure(&loaded, &MeasureOptions { limits }).unwrap();
        let all = told(&measured);
        assert!(
            all.len() > 10 && !measured.warnings.is_empty(),
            "{name}: {all:?}"
        );
        for (english, said) in all {
            assert_eq!(english, said.in_language(Language::English));
            let german = said.in_language(Language::German);
            println!("  {german}");
            assert!(
                !german.is_empty() && german != english && !german.contains(['{', '_']),
                "{english}: {german}"
            );
        }
    }
}

#[test]
fn an_input_of_a_budget_has_a_name() {
    let told = |label: &str| {
        Language::ALL.map(|language| identification::input(label).in_language(language))
    };
    assert_eq!(told("line_length"), ["line_length", "Leinenlänge"]);
    assert_eq!(
        told("yaw period of yaw-sway"),
        [
            "yaw period of yaw-sway",
            "Gierperiode von Gieren-Querschwingen"
        ]
    );
    assert_eq!(
        told("roll out of phase period of roll")[1],
        "Rollperiode im Gegentakt von Rollen"
    );
    assert_eq!(told("mass of keel"), ["mass of keel", "Masse von keel"]);
    assert_eq!(
        told("unknown tilt of the principal axes"),
        [
            "unknown tilt of the principal axes",
            "unbekannte Neigung der Hauptachsen"
        ]
    );
    // What is none is the id of a swing.
    assert_eq!(told("bow-up"), ["bow-up", "Bug-hoch"]);
    assert_eq!(told("Day of rest"), ["Day of rest", "Day of rest"]);
}
