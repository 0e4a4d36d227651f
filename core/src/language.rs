//! Languages in which sentences are told.

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

    /// A number that is written with a decimal point, as the language writes it.
    pub fn number(self, written: &str) -> String {
        match self {
            Self::English => written.to_owned(),
            Self::German => written.replace('.', ","),
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
