//! Languages in which messages are written.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};

/// A language of the messages that an operator reads or hears.
#[derive(
    Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Language {
    /// As everywhere else.
    #[default]
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

    /// Its tag, as documents name it.
    pub fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// The word between the last two of a list.
    pub fn and(self) -> &'static str {
        match self {
            Self::English => " and ",
            Self::German => " und ",
        }
    }
}

impl FromStr for Language {
    type Err = Error;

    /// A language by its tag.
    fn from_str(tag: &str) -> Result<Self> {
        let known = || Self::ALL.map(Self::tag).join(", ");
        let found = Self::ALL.into_iter().find(|language| language.tag() == tag);
        found.ok_or_else(|| Error::argument("language", known(), tag))
    }
}

/// A minus sign as long as a plus, not a hyphen; none before a zero.
pub fn minus(number: &str) -> String {
    match number
        .strip_prefix('-')
        .filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.into(),
        Some(rest) => format!("−{rest}"),
        None => number.into(),
    }
}
