//! The English of every key that a screen may have to translate.

use gyradius_core::{live, plan, procedure};

use crate::data::NamedText;

/// Every sentence and word by its key; `{name}` stands for an argument. Keys of the live estimator begin with `live.`, those
/// of the plan's warnings with `plan.`.
#[uniffi::export]
pub fn english_texts() -> Vec<NamedText> {
    let of_live = live::ENGLISH.iter().map(|(key, text)| (format!("live.{key}"), *text));
    let of_procedure = procedure::ENGLISH.iter().map(|(key, text)| ((*key).to_owned(), *text));
    let of_plan = plan::ENGLISH.iter().map(|(kind, text)| (format!("plan.{}", key_of(kind)), *text));
    let all = of_procedure.chain(of_live).chain(of_plan);
    all.map(|(name, text)| NamedText { name, text: text.into() }).collect()
}

/// The name that a kind of warning has in JSON.
fn key_of(kind: &plan::WarningKind) -> String {
    let name = serde_json::to_value(kind).ok();
    name.as_ref().and_then(|name| name.as_str()).unwrap_or_default().to_owned()
}
