//! Every sentence that a screen shows, in each language.

use gyradius_core::language::Language;
use gyradius_core::plan::Warning;
use gyradius_core::procedure::Text;
use gyradius_core::{critique, inertia, live, plan, procedure, signal};

use crate::data::NamedText;

/// A language of the sentences that an operator reads or hears.
#[uniffi::remote(Enum)]
pub enum Language {
    /// As everywhere else.
    English,
    /// With decimal commas.
    German,
}

/// Every sentence and word by its key; `{name}` stands for an argument, `{^name}` for one with a
/// capital. Keys of the live estimator begin with `live.`, those of the plan with `plan.`, of a
/// measurement with `inertia.` and `signal.`, of the criticism with `critique.`.
#[uniffi::export]
pub fn texts(language: Language) -> Vec<NamedText> {
    let of_live = live::sentences(language)
        .iter()
        .map(|(key, text)| (format!("live.{key}"), *text));
    let of_procedure = procedure::sentences(language)
        .iter()
        .map(|(key, text)| ((*key).to_owned(), *text));
    let all = of_procedure
        .chain(of_live)
        .map(|(name, text)| (name, text.to_owned()));
    let rooms = [
        plan::sentences,
        signal::sentences,
        inertia::sentences,
        critique::sentences,
    ];
    let of_rooms = rooms.iter().flat_map(|sentences| sentences(language));
    all.chain(of_rooms)
        .map(|(name, text)| NamedText { name, text })
        .collect()
}

/// A sentence in a language, with what it names.
#[uniffi::export]
pub fn sentence_in(sentence: &Text, language: Language) -> String {
    sentence.in_language(language)
}

/// The sentence of a plan's warning in a language.
#[uniffi::export]
pub fn warning_in(warning: &Warning, language: Language) -> String {
    warning.said().in_language(language)
}

/// The id of a step or a swing in a language; in English it stands as it is.
#[uniffi::export]
pub fn id_in(id: &str, language: Language) -> String {
    procedure::id_in(id, language)
}

/// A quantity by its key, without its unit, in a language.
#[uniffi::export]
pub fn quantity_in(name: &str, language: Language) -> String {
    inertia::quantity_in(name, language)
}

/// An input of a budget by its label, in a language; in English it stands as it is.
#[uniffi::export]
pub fn input_in(label: &str, language: Language) -> String {
    inertia::input(label).in_language(language)
}

/// A single route to a quantity by its method, in a language.
#[uniffi::export]
pub fn route_in(method: &str, language: Language) -> String {
    inertia::route_in(method, language)
}

/// The short name of a cause that the criticism tries, in a language.
#[uniffi::export]
pub fn cause_in(id: &str, language: Language) -> String {
    critique::cause_name(id, language)
}

/// The unit that a quantity's key ends in, as it is printed.
#[uniffi::export]
pub fn unit_of(name: &str) -> String {
    inertia::unit_of(name).into()
}
