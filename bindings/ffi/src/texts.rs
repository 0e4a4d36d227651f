//! Every sentence that a screen shows, in each language.

use gyradius_core::language::Language;
use gyradius_core::message::Message;
use gyradius_core::planning::Warning;
use gyradius_core::{diagnosis, identification, message};

use crate::data::NamedText;

/// A language of the sentences that an operator reads or hears.
#[uniffi::remote(Enum)]
pub enum Language {
    /// As everywhere else.
    English,
    /// With decimal commas.
    German,
}

/// Every message by its Fluent identifier; `{name}` stands for an argument.
#[uniffi::export]
pub fn texts(language: Language) -> Vec<NamedText> {
    let named = |(name, text)| NamedText { name, text };
    message::texts(language).into_iter().map(named).collect()
}

/// A sentence in a language, with what it names.
#[uniffi::export]
pub fn sentence_in(sentence: &Message, language: Language) -> String {
    sentence.in_language(language)
}

/// The sentence of a plan's warning in a language.
#[uniffi::export]
pub fn warning_in(warning: &Warning, language: Language) -> String {
    warning.message().in_language(language)
}

/// The id of a step or a swing in a language; in English it stands as it is.
#[uniffi::export]
pub fn id_in(id: &str, language: Language) -> String {
    message::id_in(id, language)
}

/// A quantity by its key, without its unit, in a language.
#[uniffi::export]
pub fn quantity_in(name: &str, language: Language) -> String {
    identification::quantity_in(name, language)
}

/// An input of a budget by its label, in a language; in English it stands as it is.
#[uniffi::export]
pub fn input_in(label: &str, language: Language) -> String {
    identification::input(label).in_language(language)
}

/// A single route to a quantity by its method, in a language.
#[uniffi::export]
pub fn route_in(method: &str, language: Language) -> String {
    identification::route_in(method, language)
}

/// The short name of a cause that the criticism tries, in a language.
#[uniffi::export]
pub fn cause_in(id: &str, language: Language) -> String {
    diagnosis::cause_called(id, language)
}

/// The unit that a quantity's key ends in, as it is printed.
#[uniffi::export]
pub fn unit_of(name: &str) -> String {
    identification::unit_of(name).into()
}
