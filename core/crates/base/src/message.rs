//! Messages: a key, what it names, and the sentence in every language.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::catalogue::{self, format};
use crate::language::Language;

/// A sentence: its key, what it names, and the English of both.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Message {
    /// Key in the Fluent files; empty where there is no more of it than English.
    pub key: String,
    /// What it names, by the name that stands in it.
    pub arguments: BTreeMap<String, Argument>,
    /// The sentence in English.
    pub english: String,
}

/// Something that a sentence names.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Argument {
    /// A number with the decimals that it is shown with.
    Number(f64, u8),
    /// A figure as it is written with a decimal point: `1.20 ± 0.03 m`.
    Figure(String),
    /// A word with a key of its own, e.g. `gyroscope` or `yaw`. Several have spaces between them.
    Word(String),
    /// The id of a step or a swing, such as `yaw-sway`: its words with keys of their own, hyphens
    /// between them.
    Id(String),
    /// Text as it stands: a file, a reason.
    Plain(String),
    /// Messages of their own, in a list.
    Texts(Vec<Message>),
}

/// Families of keys that are their own English: names as the result's format spells them.
const SPELLED_AS_IN_THE_FORMAT: [&str; 4] = [
    "inertia.input.",
    "inertia.motion.",
    "inertia.id.",
    "critique.id.",
];
/// Families whose other languages are those of another family.
const NAMED_AS: [(&str, &str); 2] = [
    ("inertia.id.", "inertia.quantity."),
    ("critique.id.", "critique.name."),
];

/// A message of a key without arguments in a language. A name without an entry (`….name.of_it`) is
/// its own key's last part in words.
pub fn name(key: &str, language: Language) -> Option<String> {
    named(key, &[], language)
}

fn named(key: &str, arguments: &[(&str, String)], language: Language) -> Option<String> {
    if language == Language::English {
        let own = |family: &&str| key.strip_prefix(*family);
        if let Some(own) = SPELLED_AS_IN_THE_FORMAT.iter().find_map(own) {
            return Some(own.to_owned());
        }
    }
    let other = |(family, other): &(&str, &str)| {
        key.strip_prefix(*family)
            .map(|name| format!("{other}{name}"))
    };
    let other = NAMED_AS.iter().find_map(other);
    let key = other.as_deref().unwrap_or(key);
    format(key, arguments, language).or_else(|| in_words(key))
}

/// The last part of a key of a family in words: `critique.parameter.top_spacing`.
fn in_words(key: &str) -> Option<String> {
    let mut parts = key.splitn(3, '.');
    parts.nth(2).map(spaced)
}

/// A key's words, with spaces between them.
pub fn spaced(key: &str) -> String {
    key.replace('_', " ")
}

impl Message {
    /// The message of a key with what it names.
    pub fn new<'a>(
        key: impl Into<String>,
        arguments: impl IntoIterator<Item = (&'a str, Argument)>,
    ) -> Self {
        let arguments = arguments
            .into_iter()
            .map(|(name, value)| (name.to_owned(), value))
            .collect();
        let message = Self {
            key: key.into(),
            arguments,
            english: String::new(),
        };
        let english = message.in_language(Language::English);
        debug_assert!(!english.is_empty(), "no message of the key {}", message.key);
        Self { english, ..message }
    }

    /// A message of which there is no more than English.
    pub fn in_english(english: impl Into<String>) -> Self {
        Self {
            english: english.into(),
            ..Self::default()
        }
    }

    /// Whether there is no more of it than English.
    pub fn has_no_key(&self) -> bool {
        self.key.is_empty()
    }

    /// Whether it is the message of a key, or names one of that key.
    pub fn is_about(&self, key: &str) -> bool {
        let named = |argument: &Argument| match argument {
            Argument::Texts(texts) => texts.iter().any(|text| text.is_about(key)),
            _ => false,
        };
        self.key == key || self.arguments.values().any(named)
    }

    /// The sentence in a language, with what it names.
    pub fn in_language(&self, language: Language) -> String {
        if self.has_no_key() {
            return self.english.clone();
        }
        let shown: Vec<(&str, String)> = self
            .arguments
            .iter()
            .map(|(name, argument)| (name.as_str(), argument.shown(language)))
            .collect();
        named(&self.key, &shown, language).unwrap_or_else(|| self.english.clone())
    }
}

impl From<&str> for Message {
    fn from(english: &str) -> Self {
        Self::in_english(english)
    }
}

impl Argument {
    fn shown(&self, language: Language) -> String {
        let word = |key: &str| name(key, language).unwrap_or_else(|| key.to_owned());
        match self {
            Argument::Number(value, decimals) => {
                language.number(&format!("{value:.*}", usize::from(*decimals)))
            }
            Argument::Figure(written) => language.number(written),
            Argument::Word(keys) => keys
                .split(' ')
                .map(word)
                .collect::<Vec<_>>()
                .join(language.and()),
            Argument::Id(id) => id_in(id, language),
            Argument::Plain(text) => text.clone(),
            Argument::Texts(texts) => texts
                .iter()
                .map(|text| text.in_language(language))
                .collect::<Vec<_>>()
                .join(", "),
        }
    }
}

/// The id of a step or a swing in a language: what of it is a word with a key is that word, anything
/// else stays. In English it stays whole.
pub fn id_in(id: &str, language: Language) -> String {
    if language == Language::English {
        return id.to_owned();
    }
    let word = |part: &str| name(part, language).unwrap_or_else(|| part.to_owned());
    id.split('-').map(word).collect::<Vec<_>>().join("-")
}

pub use catalogue::texts;

/// A module for `#[serde(flatten, with = "…")]`: a message in JSON as two keys, its English and
/// the message, where it has more than that.
macro_rules! english_and_said {
    ($(#[$doc:meta])* $module:ident, $English:ident, $key:ident, $said:ident) => {
        $(#[$doc])*
        pub mod $module {
            use serde::{Deserialize, Deserializer, Serialize, Serializer};

            use super::Message;

            /// The two keys.
            #[derive(Serialize, Deserialize, schemars::JsonSchema)]
            pub struct $English {
                /// The message in English.
                #[serde(default)]
                pub $key: String,
                /// The same for every language.
                #[serde(default, skip_serializing_if = "Message::has_no_key")]
                pub $said: Message,
            }

            /// Writes both.
            pub fn serialize<S: Serializer>(message: &Message, to: S) -> Result<S::Ok, S::Error> {
                let ($key, $said) = (message.english.clone(), message.clone());
                $English { $key, $said }.serialize(to)
            }

            /// Reads both; a file from before there were keys has the English alone.
            pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Message, D::Error> {
                let $English { $key, $said } = $English::deserialize(from)?;
                Ok(if $said.has_no_key() { Message::in_english($key) } else { $said })
            }
        }
    };
}

english_and_said!(
    /// A message as `text` and `said`.
    text_and_said, TextAndSaid, text, said
);
english_and_said!(
    /// A message as `channel` and `said`.
    channel_and_said, ChannelAndSaid, channel, said
);
english_and_said!(
    /// A message as `advice` and `advice_said`.
    advice_and_said, AdviceAndSaid, advice, advice_said
);

/// Messages in JSON as two keys: `warnings`, their English, and `warnings_said`, the messages where
/// one has more than that. For `#[serde(flatten, with = "…")]`.
pub mod warnings_and_said {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::Message;

    /// The two keys.
    #[derive(Serialize, Deserialize, schemars::JsonSchema)]
    pub struct WarningsAndSaid {
        /// What a reader must know, in English.
        #[serde(default)]
        pub warnings: Vec<String>,
        /// The same for every language.
        #[serde(default, skip_serializing_if = "in_english_alone")]
        pub warnings_said: Vec<Message>,
    }

    fn in_english_alone(messages: &[Message]) -> bool {
        messages.iter().all(Message::has_no_key)
    }

    /// Writes both.
    pub fn serialize<S: Serializer>(messages: &[Message], to: S) -> Result<S::Ok, S::Error> {
        let warnings = messages.iter().map(|one| one.english.clone()).collect();
        let warnings_said = messages.to_vec();
        WarningsAndSaid {
            warnings,
            warnings_said,
        }
        .serialize(to)
    }

    /// Reads both; a file from before there were keys has the English alone.
    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Message>, D::Error> {
        let read = WarningsAndSaid::deserialize(from)?;
        Ok(if read.warnings_said.is_empty() {
            read.warnings.into_iter().map(Message::in_english).collect()
        } else {
            read.warnings_said
        })
    }
}
