//! Every language says the same: the same keys, and in each sentence the same names.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};

use gyradius_core::language::Language;
use gyradius_core::plan::{Warning, WarningKind};
use gyradius_core::{critique, inertia, live, plan, procedure};

/// Every sentence and word by key.
fn all(language: Language) -> Vec<(String, String)> {
    let of_live = live::sentences(language).iter().map(|(key, text)| (format!("live.{key}"), *text));
    let of_plan = plan::sentences(language).iter().map(|(kind, text)| (format!("plan.{kind:?}"), *text));
    let routes = inertia::routes_in(language).iter().map(|(key, text)| (format!("route.{key}"), *text));
    let of_procedure = procedure::sentences(language).iter().map(|(key, text)| ((*key).to_owned(), *text));
    let others = of_live.chain(of_plan).chain(routes).chain(of_procedure);
    let others = others.map(|(key, text)| (key, text.to_owned()));
    others.chain(critique::sentences(language)).collect()
}

/// Names in braces by key; a capital that a language gives one is its own affair.
fn names(language: Language) -> BTreeMap<String, BTreeSet<String>> {
    let named = |text: &str| -> BTreeSet<String> {
        let names = text.split('{').skip(1).map(|rest| rest.split_once('}').unwrap().0);
        names.map(|name| name.trim_start_matches('^').to_owned()).collect()
    };
    all(language).into_iter().map(|(key, text)| (key, named(&text))).collect()
}

#[test]
fn every_language_has_the_same_sentences() {
    let english = names(Language::English);
    assert!(english.len() > 250 && english.values().any(|names| names.len() > 4));
    assert_eq!(english, names(Language::German));
}

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
        all(language).into_iter().map(|(_, text)| text).filter(has_words).collect::<BTreeSet<_>>()
    };
    let common: Vec<String> =
        said(Language::English).intersection(&said(Language::German)).cloned().collect();
    assert!(common.is_empty(), "{common:?}");
}

#[test]
fn an_id_is_told_by_its_words() {
    let told =
        |id: &str| [Language::English, Language::German].map(|language| procedure::id_in(id, language));
    assert_eq!(told("yaw-sway-2"), ["yaw-sway-2", "Gieren-Querschwingen-2"]);
    assert_eq!(told("incline-bow"), ["incline-bow", "Neigungsversuch-Bug"]);
    assert_eq!(told("Tuesday"), ["Tuesday", "Tuesday"]);
}

#[test]
fn quantities_routes_and_causes_have_names_and_units() {
    let german = Language::German;
    assert_eq!(inertia::quantity_in("k_yaw_m", german), "Trägheitsradius Gieren");
    assert_eq!(inertia::quantity_in("small_period_yaw_s", Language::English), "small period yaw");
    assert_eq!(
        ["small_period_yaw_s", "i_kg_m2", "g_m_s2", "mass"].map(inertia::unit_of),
        ["s", "kg m²", "m/s²", ""]
    );
    assert_eq!(inertia::route_in("lamboley", german), "physikalisches Pendel in zwei Höhen (Lamboley)");
    assert_eq!(inertia::route_in("a_new_one", german), "a new one");
    assert_eq!(critique::cause_name("quadratic_drag", german), "quadratischer Luftwiderstand");
    assert_eq!(critique::cause_name("quadratic_drag", Language::English), "quadratic drag");
}

#[test]
fn a_warning_is_told_with_its_numbers_and_names() {
    let numbers = [("u_percent", 20.0)];
    let warning = Warning::new(WarningKind::RoughHull, None, &numbers, &[("quantity", "k_yaw_m")]);
    let german = warning.in_language(Language::German);
    assert!(german.starts_with("k_yaw_m des Rumpfs ist nur auf 20 % bekannt"), "{german}");
    assert_eq!(warning.text, warning.in_language(Language::English));
}
