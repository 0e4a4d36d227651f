//! Languages in which sentences are told.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A language of the sentences that an operator reads or hears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Language {
    /// As everywhere else.
    English,
    /// With decimal commas.
    German,
}

impl Language {
    /// Every one of them.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Numbers that are written with decimal points and hyphens, as the language writes them.
    pub fn number(self, written: &str) -> String {
        let signed = written.split(' ').map(minus).collect::<Vec<_>>().join(" ");
        match self {
            Self::English => signed,
            Self::German => signed.replace('.', ","),
        }
    }

    /// The word between the last two of a row.
    pub fn and(self) -> &'static str {
        match self {
            Self::English => " and ",
            Self::German => " und ",
        }
    }
}

/// A sentence: its key, what it names, and the English of both.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Text {
    /// Key for translation.
    pub key: String,
    /// What it names, by the name that stands in it.
    pub arguments: BTreeMap<String, Argument>,
    /// The sentence in English.
    pub english: String,
}

/// A minus sign as long as a plus, not a hyphen; none before a zero.
pub(crate) fn minus(number: &str) -> String {
    match number
        .strip_prefix('-')
        .filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.into(),
        Some(rest) => format!("−{rest}"),
        None => number.into(),
    }
}

/// Something that a sentence names.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Argument {
    /// A number with the decimals that it is shown with.
    Number(f64, u8),
    /// A figure as it is written with a decimal point: `1.20 ± 0.03 m`.
    Figure(String),
    /// A word with a key of its own, e.g. `gyroscope` or `yaw`.
    Word(String),
    /// The id of a step or a swing, such as `yaw-sway`: its words with keys of their own, hyphens
    /// between them.
    Id(String),
    /// Text as it stands: a file, a reason.
    Plain(String),
    /// Sentences of their own, in a row.
    Texts(Vec<Text>),
}

/// The sentence or word of a key in a language, where there is one.
pub(crate) type Lookup = fn(&str, Language) -> Option<String>;

/// The sentence or word of a key in a table.
pub(crate) fn entry(table: &[(&str, &str)], key: &str) -> Option<String> {
    table
        .iter()
        .find(|(known, _)| *known == key)
        .map(|(_, text)| (*text).to_owned())
}

/// The English of sentences.
pub(crate) fn english(said: &[Text]) -> Vec<String> {
    said.iter().map(|text| text.english.clone()).collect()
}

/// Whether there is no more of them than English, which stands beside them.
pub(crate) fn english_alone(said: &[Text]) -> bool {
    said.iter().all(Text::has_no_key)
}

/// Without sentences, what was said in English.
pub(crate) fn or_english(said: &mut Vec<Text>, english: &[String]) {
    if said.is_empty() {
        *said = english.iter().map(Text::in_english).collect();
    }
}

impl Text {
    /// The sentence of a key with what it names. `{name}` stands for an argument, `{^name}` for one
    /// that begins a sentence.
    pub(crate) fn of(key: String, arguments: BTreeMap<String, Argument>, lookup: Lookup) -> Self {
        let text = Self {
            key,
            arguments,
            english: String::new(),
        };
        Self {
            english: text.told(Language::English, lookup),
            ..text
        }
    }

    /// A sentence of which there is no more than English.
    pub(crate) fn in_english(english: impl Into<String>) -> Self {
        Self {
            english: english.into(),
            ..Self::default()
        }
    }

    /// Whether there is no more of it than English.
    pub(crate) fn has_no_key(&self) -> bool {
        self.key.is_empty()
    }

    /// Without a key, what was said in English.
    pub(crate) fn or_english(&mut self, english: &str) {
        if self.has_no_key() {
            self.english = english.to_owned();
        }
    }

    /// The sentence in a language, with what it names.
    pub(crate) fn told(&self, language: Language, lookup: Lookup) -> String {
        if self.has_no_key() {
            return self.english.clone();
        }
        let mut text = lookup(&self.key, language).unwrap_or_default();
        for (name, argument) in &self.arguments {
            let shown = argument.shown(language, lookup);
            text = text.replace(&format!("{{^{name}}}"), &capital(&shown));
            text = text.replace(&format!("{{{name}}}"), &shown);
        }
        text
    }
}

impl Argument {
    fn shown(&self, language: Language, lookup: Lookup) -> String {
        let word = |key: &str| lookup(key, language).unwrap_or_else(|| key.to_owned());
        match self {
            Argument::Number(value, decimals) => {
                language.number(&format!("{value:.*}", usize::from(*decimals)))
            }
            Argument::Figure(written) => language.number(written),
            // Several words stand with spaces between their keys.
            Argument::Word(keys) => keys
                .split(' ')
                .map(word)
                .collect::<Vec<_>>()
                .join(language.and()),
            Argument::Id(id) => id_in(id, language, lookup),
            Argument::Plain(text) => text.clone(),
            Argument::Texts(texts) => texts
                .iter()
                .map(|text| text.told(language, lookup))
                .collect::<Vec<_>>()
                .join(", "),
        }
    }
}

/// An id in a language: what of it is a word with a key is that word, anything else stays. In
/// English it stays whole.
pub(crate) fn id_in(id: &str, language: Language, lookup: Lookup) -> String {
    if language == Language::English {
        return id.to_owned();
    }
    let word = |part: &str| lookup(part, language).unwrap_or_else(|| part.to_owned());
    id.split('-').map(word).collect::<Vec<_>>().join("-")
}

/// With a capital letter at its beginning.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}
