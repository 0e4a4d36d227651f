//! The Fluent files: one folder a language, one file a crate.
//!
//! A key such as `critique.name.wind` is the message `critique-name-wind`. Places in a message are
//! variables (`{ $name }`); `{ CAPITAL($name) }` begins a sentence with one.

use std::sync::LazyLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::types::FluentValue;
use fluent_bundle::{FluentArgs, FluentResource};
use unic_langid::{LanguageIdentifier, langid};

use crate::language::Language;

macro_rules! files {
    ($language:literal: $($name:literal),*) => {
        [$(include_str!(concat!("../messages/", $language, "/", $name, ".ftl"))),*]
    };
}

const ENGLISH: [&str; 7] = files!(
    "en": "signal", "online", "identification", "diagnosis", "planning", "procedure", "report"
);
const GERMAN: [&str; 7] = files!(
    "de": "signal", "online", "identification", "diagnosis", "planning", "procedure", "report"
);

type Bundle = FluentBundle<FluentResource>;

static BUNDLES: LazyLock<[Bundle; 2]> = LazyLock::new(|| Language::ALL.map(bundle));

/// The source of every Fluent file of a language.
pub fn sources(language: Language) -> &'static [&'static str] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}

fn bundle(language: Language) -> Bundle {
    let mut bundle = Bundle::new_concurrent(vec![tag(language)]);
    // Isolation marks would stand in every sentence, for the sake of right-to-left text.
    bundle.set_use_isolating(false);
    // A name that is added twice is an error here; the tests of this crate look for those.
    let _ = bundle.add_function("CAPITAL", |arguments, _| match arguments.first() {
        Some(FluentValue::String(text)) => capital(text).into(),
        _ => FluentValue::Error,
    });
    for source in sources(language) {
        let resource = FluentResource::try_new((*source).to_owned());
        // A message with a wrong syntax is left out; the tests of this crate look for those.
        let (Ok(resource) | Err((resource, _))) = resource;
        let _ = bundle.add_resource(resource);
    }
    bundle
}

fn tag(language: Language) -> LanguageIdentifier {
    match language {
        Language::English => langid!("en"),
        Language::German => langid!("de"),
    }
}

/// The Fluent identifier of a key.
pub(crate) fn identifier(key: &str) -> String {
    key.replace('.', "-").replace(' ', "_")
}

/// A message with its arguments in their places; absent where there is none of this key.
pub(crate) fn format(
    key: &str,
    arguments: &[(&str, String)],
    language: Language,
) -> Option<String> {
    let bundle = &BUNDLES[language as usize];
    let message = bundle.get_message(&identifier(key))?;
    let mut given = FluentArgs::with_capacity(arguments.len());
    for (name, shown) in arguments {
        given.set(*name, shown.as_str());
    }
    // An argument that is missing stands in the text by its name.
    let mut missing = Vec::new();
    let text = bundle.format_pattern(message.value()?, Some(&given), &mut missing);
    Some(text.into_owned())
}

/// Every message by its Fluent identifier in a language, with `{name}` in its places.
pub fn texts(language: Language) -> Vec<(String, String)> {
    let ids = sources(language).iter().flat_map(|source| ids(source));
    ids.map(|(id, names)| {
        let places: Vec<(&str, String)> = names
            .into_iter()
            .map(|name| (name, format!("{{{name}}}")))
            .collect();
        let text = format(id, &places, language).unwrap_or_default();
        (id.to_owned(), text)
    })
    .collect()
}

/// Identifiers of a file's messages, each with the names of its variables.
pub fn ids(source: &str) -> impl Iterator<Item = (&str, Vec<&str>)> {
    let messages = source.lines().filter_map(|line| line.split_once(" = "));
    messages.map(|(id, pattern)| {
        let end = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        let names = pattern.split('$').skip(1);
        (
            id,
            names
                .map(|rest| rest.split(end).next().unwrap_or(rest))
                .collect(),
        )
    })
}

/// With a capital letter at its beginning.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn every_file_is_fluent_without_errors_and_no_key_stands_twice() {
        for language in Language::ALL {
            let mut bundle = Bundle::new_concurrent(vec![tag(language)]);
            for source in sources(language) {
                let resource = FluentResource::try_new((*source).to_owned()).unwrap();
                let found = resource.entries().count();
                let ours = ids(source).count();
                bundle.add_resource(resource).unwrap();
                assert_eq!(found, ours, "a message that spans lines is not seen");
            }
        }
    }

    #[test]
    fn every_language_has_the_same_keys_with_the_same_names() {
        let of = |language| -> BTreeMap<&str, Vec<&str>> {
            let all = sources(language).iter().flat_map(|source| ids(source));
            all.map(|(id, mut names)| {
                names.sort_unstable();
                names.dedup();
                (id, names)
            })
            .collect()
        };
        let english = of(Language::English);
        assert!(english.len() > 300 && english.values().any(|names| names.len() > 4));
        assert_eq!(english, of(Language::German));
    }

    #[test]
    fn places_are_filled() {
        let named = [("sensor", "gyroscope".to_owned()), ("since_s", "3".into())];
        let text = format("live.sensor_silent", &named, Language::English).unwrap();
        assert!(
            text.starts_with("The gyroscope has given no samples since 3 s"),
            "{text}"
        );
        assert_eq!(format("no.such", &[], Language::English), None);
    }
}
