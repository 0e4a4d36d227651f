//! What is said of a record, in English. Other languages have the same keys.

use super::german::GERMAN;
use crate::language::{Argument, Language, Text, entry};

/// What all keys of this room begin with.
const OF_SIGNAL: &str = "signal.";

/// Sentences by key; `{name}` stands for an argument.
const ENGLISH: [(&str, &str); 6] = [
    (
        "misfit",
        "the residual is {times} times the white noise: coloured noise or motion that the model does not hold; the standard errors are widened for it",
    ),
    (
        "growing",
        "{count} of the modes would grow, which a free swing does not: their decay is held at zero",
    ),
    (
        "many",
        "as many modes as allowed were found; there may be more",
    ),
    (
        "lead_in",
        "the first {length_s} s (waiting, handling, release) are left out",
    ),
    (
        "lead_out",
        "the last {length_s} s, from {from_s} s on, are left out: the swing was disturbed",
    ),
    (
        "second_swing",
        "another swing between {from_s} s and {to_s} s (the hull was touched or released again) is left out",
    ),
];

/// A sentence with the numbers in it and their decimals.
pub(super) fn said<'a>(key: &str, numbers: impl IntoIterator<Item = (&'a str, f64, u8)>) -> Text {
    let argument =
        |(name, value, decimals): (&str, f64, u8)| (name.into(), Argument::Number(value, decimals));
    let arguments = numbers.into_iter().map(argument).collect();
    Text::of(format!("{OF_SIGNAL}{key}"), arguments, sentence)
}

/// The sentence of a key in a language; absent where the key is another room's, or unknown.
pub(crate) fn sentence(key: &str, language: Language) -> Option<String> {
    entry(table(language), key.strip_prefix(OF_SIGNAL)?)
}

/// Every sentence by its key in a language.
pub fn sentences(language: Language) -> Vec<(String, String)> {
    let named = |(key, text): &(&str, &str)| (format!("{OF_SIGNAL}{key}"), (*text).to_owned());
    table(language).iter().map(named).collect()
}

fn table(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}
