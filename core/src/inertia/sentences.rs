//! What is said of a measurement, in English. Other languages have the same keys.
//!
//! Beside sentences there are names: `input.…` of an input of a budget, `motion.…` of a motion,
//! `quantity.…` of a quantity, `route.…` of a route; `id.…` is a quantity as the format spells it.

use super::german::{INPUTS as GERMAN_INPUTS, MOTIONS as GERMAN_MOTIONS, SENTENCES as GERMAN};
use super::words::{quantity_in, route_in, spaced};
use crate::error::Error;
use crate::language::{Argument, Language, Text, entry};
use crate::signal;

/// What all keys of this room begin with.
const OF_INERTIA: &str = "inertia.";

/// Sentences by key; `{name}` stands for an argument.
const ENGLISH: [(&str, &str); 22] = [
    (
        "stated",
        "{name} is stated as {stated}; by {by} it is {implied}: {verdict} ({sigma} standard uncertainties).",
    ),
    ("by_sway", "the sway period of {swing}"),
    ("by_all", "all swings together ({inputs})"),
    (
        "against",
        "{quantity}: the {one} ({one_from}) gives {first}, the {other} ({other_from}) gives {second}: {verdict} ({sigma} standard uncertainties of the difference).{pairs}",
    ),
    (
        "pairs",
        " The same two ways differ by {least} to {most} over {count} pairs of swings.",
    ),
    ("agree", "they agree"),
    ("contradict", "they contradict each other"),
    (
        "no_gravity",
        "neither gravity nor latitude is stated: standard gravity with u = 0.015 m/s² is used",
    ),
    ("no_joint_estimate", "no joint estimate: {reason}"),
    (
        "widened",
        "the session contradicts itself (χ² = {chi2} with {dof} degrees of freedom): all uncertainties are widened by {factor}",
    ),
    ("no_verdict", "no verdict on {quantity}: {reason}"),
    (
        "no_verdict_undetermined",
        "no verdict on {quantity}: the swings do not determine it",
    ),
    (
        "no_single_period",
        "the entry at {at_s} s ({period_s} s) is no single period of this motion: left out",
    ),
    (
        "bare_recording",
        "a bare recording gives modes alone; a session with dimensions gives inertia",
    ),
    (
        "yaw_by_word",
        "no accelerometer that sees gravity: the vertical is unknown, so the strongest mode is called yaw on the operator's word alone",
    ),
    (
        "no_shapes",
        "no accelerometer that sees gravity: the vertical is unknown, so the modes cannot be named by shape",
    ),
    (
        "track_alone",
        "a displacement alone does not show shapes: modes are named by their periods",
    ),
    (
        "not_seen",
        "{motion} was meant to be excited but does not show in the data",
    ),
    (
        "not_meant",
        "the strongest motion is {motion}, which was not meant to be excited",
    ),
    (
        "parasitic",
        "parasitic {motion} at {percent} % of the strongest motion",
    ),
    ("of", "{what} of {which}"),
    ("an_id", "{id}"),
];

/// Motions that are meant or found.
const MOTIONS: [&str; 11] = [
    "yaw",
    "sway",
    "surge",
    "pitch",
    "roll",
    "pitch in phase",
    "pitch out of phase",
    "roll in phase",
    "roll out of phase",
    "compound pendulum",
    "unnamed motion",
];

/// Inputs of budgets, without the swing or the mass that they are of.
const INPUTS: [&str; 25] = [
    "gravity",
    "phone clock",
    "mass",
    "gyradius",
    "product xz",
    "depth",
    "line length",
    "spacing",
    "top spacing",
    "axis height",
    "hull pitch",
    "suspension points",
    "incline bow",
    "incline stern",
    "samples",
    "finite-amplitude correction",
    "unknown tilt of the principal axes",
    "yaw period",
    "sway period",
    "pitch in phase period",
    "pitch out of phase period",
    "roll in phase period",
    "roll out of phase period",
    "compound pendulum period",
    "unnamed motion period",
];

/// A sentence with what it names.
pub fn said<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Text {
    let arguments = arguments
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    Text::of(format!("{OF_INERTIA}{key}"), arguments, sentence)
}

/// A name with a key, as an argument.
pub fn name(key: &str) -> Argument {
    Argument::Texts(vec![said(key, [])])
}

/// An error, as it stands.
pub fn plain(error: Error) -> Argument {
    Argument::Plain(error.to_string())
}

/// A motion by its name in English.
pub fn motion(english: &str) -> Argument {
    name(&format!("motion.{english}"))
}

/// An input of a budget by its label: `spacing`, `yaw period of bow-up`. What is no input is an id.
/// In English it stands as it is.
pub fn input(label: &str) -> Text {
    if INPUTS.contains(&spaced(label).as_str()) {
        return said(&format!("input.{label}"), []);
    }
    // A name may hold an "of" of its own: "pitch out of phase period of bow-up".
    let of_one = INPUTS
        .iter()
        .find_map(|what| Some((what, label.strip_prefix(what)?.strip_prefix(" of ")?)));
    match of_one {
        Some((what, which)) => said(
            "of",
            [
                ("what", name(&format!("input.{what}"))),
                ("which", Argument::Id(which.to_owned())),
            ],
        ),
        None => said("an_id", [("id", Argument::Id(label.to_owned()))]),
    }
}

/// Inputs in a row.
pub fn inputs<'a>(labels: impl IntoIterator<Item = &'a String>) -> Argument {
    Argument::Texts(labels.into_iter().map(|label| input(label)).collect())
}

/// The sentence or name of a key in a language, those of `signal` among them; absent where the key
/// is another room's, or unknown.
pub(crate) fn sentence(key: &str, language: Language) -> Option<String> {
    let Some(key) = key.strip_prefix(OF_INERTIA) else {
        return signal::sentence(key, language);
    };
    match key.split_once('.') {
        None => entry(table(language), key),
        Some(("quantity", quantity)) => Some(quantity_in(quantity, language)),
        Some(("route", method)) => Some(route_in(method, language)),
        Some((_, english)) if language == Language::English => Some(english.to_owned()),
        Some(("id", quantity)) => Some(quantity_in(quantity, language)),
        Some(("input", label)) => entry(&GERMAN_INPUTS, &spaced(label)),
        Some((_, motion)) => entry(&GERMAN_MOTIONS, motion),
    }
}

/// Every sentence and name by its key in a language.
pub fn sentences(language: Language) -> Vec<(String, String)> {
    let sentences = ENGLISH.iter().map(|(key, _)| (*key).to_owned());
    let inputs = INPUTS.iter().map(|label| format!("input.{label}"));
    let motions = MOTIONS.iter().map(|motion| format!("motion.{motion}"));
    let keys = sentences
        .chain(inputs)
        .chain(motions)
        .map(|key| format!("{OF_INERTIA}{key}"));
    keys.filter_map(|key| sentence(&key, language).map(|text| (key, text)))
        .collect()
}

fn table(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}
