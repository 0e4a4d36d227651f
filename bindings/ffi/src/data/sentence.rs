//! Sentences by key.

use std::collections::{BTreeMap, HashMap};

use gyradius_core::message::{Argument, Message};

/// A sentence: its key, what it names, and the English of both. The core calls it a message.
pub type Sentence = Message;

/// A sentence: its key, what it names, and the English of both.
#[uniffi::remote(Record)]
pub struct Sentence {
    /// Key for translation.
    pub key: String,
    /// What it names, by the name that stands in it.
    pub arguments: ArgumentsByName,
    /// The sentence in English.
    pub english: String,
}

/// Something that a sentence names.
#[derive(Debug, Clone, PartialEq, uniffi::Enum)]
pub enum SentenceArgument {
    /// A number with the decimals that it is shown with.
    Number {
        /// The number.
        value: f64,
        /// How many decimals.
        decimals: u8,
    },
    /// Words with keys of their own, spaces between them, e.g. `yaw`.
    Words {
        /// The keys.
        keys: String,
    },
    /// A figure as it is written with a decimal point.
    Figure {
        /// The figure.
        written: String,
    },
    /// The id of a step or a swing: words with keys of their own, hyphens between them.
    Id {
        /// The id.
        id: String,
    },
    /// Message as it stands: a file, a reason.
    Plain {
        /// The text.
        text: String,
    },
    /// Sentences of their own, in a row.
    Sentences {
        /// The sentences.
        sentences: Vec<Sentence>,
    },
}

/// Arguments as the core holds them.
pub type ArgumentsByName = BTreeMap<String, Argument>;
uniffi::custom_type!(ArgumentsByName, HashMap<String, SentenceArgument>, {
    remote,
    lower: |map| map.into_iter().map(|(name, argument)| (name, argument.into())).collect(),
    try_lift: |map| Ok(map.into_iter().map(|(name, argument)| (name, argument.into())).collect()),
});

impl From<Argument> for SentenceArgument {
    fn from(argument: Argument) -> Self {
        match argument {
            Argument::Number(value, decimals) => Self::Number { value, decimals },
            Argument::Word(keys) => Self::Words { keys },
            Argument::Figure(written) => Self::Figure { written },
            Argument::Id(id) => Self::Id { id },
            Argument::Plain(text) => Self::Plain { text },
            Argument::Texts(sentences) => Self::Sentences { sentences },
        }
    }
}

impl From<SentenceArgument> for Argument {
    fn from(argument: SentenceArgument) -> Self {
        match argument {
            SentenceArgument::Number { value, decimals } => Self::Number(value, decimals),
            SentenceArgument::Words { keys } => Self::Word(keys),
            SentenceArgument::Figure { written } => Self::Figure(written),
            SentenceArgument::Id { id } => Self::Id(id),
            SentenceArgument::Plain { text } => Self::Plain(text),
            SentenceArgument::Sentences { sentences } => Self::Texts(sentences),
        }
    }
}
