//! Messages of the criticism.
//!
//! A cause has a sentence (`cause.…`; where periods alone were judged, `periods.…`) and a short
//! name (`name.…`); `id.…` is its name as the format spells it.

use gyradius_base::language::Language;
use gyradius_base::message::{Argument, Message, name, spaced};
use gyradius_identification::words::mode_text;
use gyradius_recording::ModeName;

use super::cause_id::CauseId;

/// What all keys of the criticism begin with.
const OF_CRITIQUE: &str = "critique.";

/// A message of the criticism with what it names.
pub fn message<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Message {
    Message::new(format!("critique.{key}"), arguments)
}

/// A word or sentence without arguments, as an argument.
pub fn word(key: &str) -> Argument {
    Argument::Word(format!("{OF_CRITIQUE}{key}"))
}

/// One sentence as an argument, or nothing.
pub fn part(text: Option<Message>) -> Argument {
    Argument::Texts(text.into_iter().collect())
}

/// A number with its decimals.
pub fn number(value: f64, decimals: u8) -> Argument {
    Argument::Number(value, decimals)
}

/// The id of a swing.
pub fn id(id: &str) -> Argument {
    Argument::Id(id.to_owned())
}

/// A figure as it is written.
pub fn written(figure: impl Into<String>) -> Argument {
    Argument::Figure(figure.into())
}

/// A mode of motion.
pub fn motion(mode: ModeName) -> Argument {
    word(&format!("mode.{}", mode_text(mode).replace(' ', "_")))
}

/// A row of arguments, two joined by `last` in the end and all before by `between`: keys of
/// sentences of `one` and `other`.
pub fn row(mut all: Vec<Argument>, between: &str, last: &str) -> Argument {
    let Some(end) = all.pop() else {
        return Argument::Texts(vec![]);
    };
    let joined = |key: &str, one: Argument, other: Argument| {
        Argument::Texts(vec![message(key, [("one", one), ("other", other)])])
    };
    match all
        .into_iter()
        .reduce(|row, next| joined(between, row, next))
    {
        None => end,
        Some(row) => joined(last, row, end),
    }
}

/// Short names of causes, in a row.
pub fn names(ids: impl IntoIterator<Item = CauseId>, last: &str) -> Argument {
    row(
        ids.into_iter()
            .map(|id| word(&format!("name.{id}")))
            .collect(),
        "row",
        last,
    )
}

/// The short name of a cause.
pub fn cause_name(id: CauseId, language: Language) -> String {
    cause_called(id.name(), language)
}

/// The same by a text from outside; what has no name is told by its words.
pub fn cause_called(id: &str, language: Language) -> String {
    name(&format!("{OF_CRITIQUE}name.{id}"), language).unwrap_or_else(|| spaced(id))
}
