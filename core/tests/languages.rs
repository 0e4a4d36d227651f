//! Every language says the same: the same keys, and in each sentence the same names.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};

use gyradius_core::language::Language;
use gyradius_core::plan::{Warning, WarningKind};
use gyradius_core::{live, plan, procedure};

/// Names in braces by key.
fn names(
    sentences: impl Iterator<Item = (String, &'static str)>,
) -> BTreeMap<String, BTreeSet<&'static str>> {
    let named =
        |text: &'static str| text.split('{').skip(1).map(|rest| rest.split_once('}').unwrap().0).collect();
    sentences.map(|(key, text)| (key, named(text))).collect()
}

fn all(language: Language) -> BTreeMap<String, BTreeSet<&'static str>> {
    let of_live = live::sentences(language).iter().map(|(key, text)| (format!("live.{key}"), *text));
    let of_plan = plan::sentences(language).iter().map(|(kind, text)| (format!("plan.{kind:?}"), *text));
    let of_procedure = procedure::sentences(language).iter().map(|(key, text)| ((*key).to_owned(), *text));
    names(of_live.chain(of_plan).chain(of_procedure))
}

#[test]
fn every_language_has_the_same_sentences() {
    let english = all(Language::English);
    assert!(english.len() > 100 && english.values().any(|names| names.len() > 4));
    assert_eq!(english, all(Language::German));
}

#[test]
fn no_sentence_is_left_in_english() {
    let said = |language| {
        let all = procedure::sentences(language).iter().chain(live::sentences(language));
        all.filter(|(_, text)| text.contains(' ')).map(|(_, text)| *text).collect::<BTreeSet<_>>()
    };
    assert!(said(Language::English).is_disjoint(&said(Language::German)));
}

#[test]
fn a_warning_is_told_with_its_numbers_and_names() {
    let numbers = [("u_percent", 20.0)];
    let warning = Warning::new(WarningKind::RoughHull, None, &numbers, &[("quantity", "k_yaw_m")]);
    let german = warning.in_language(Language::German);
    assert!(german.starts_with("k_yaw_m des Rumpfs ist nur auf 20 % bekannt"), "{german}");
    assert_eq!(warning.text, warning.in_language(Language::English));
}
