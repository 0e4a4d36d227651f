//! Messages about a measurement.
//!
//! Beside sentences there are names: `input.…` of an input of a budget, `motion.…` of a motion,
//! `quantity.…` of a quantity, `route.…` of a closed-form estimator; `id.…` is a quantity as the
//! format spells it.

use gyradius_base::error::Error;
use gyradius_base::message::{Argument, Message, spaced};

/// Key of the warning that gravity is not stated.
pub const NO_GRAVITY: &str = "inertia.no_gravity";
/// Key of the name of gravity.
pub const GRAVITY: &str = "inertia.input.gravity";
/// Key of the warning that there is no joint estimate.
pub const NO_JOINT_ESTIMATE: &str = "inertia.no_joint_estimate";

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

/// A message with what it names.
pub fn message<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Message {
    Message::new(format!("inertia.{key}"), arguments)
}

/// A name with a key, as an argument.
pub fn name(key: &str) -> Argument {
    Argument::Texts(vec![message(key, [])])
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
pub fn input(label: &str) -> Message {
    if INPUTS.contains(&spaced(label).as_str()) {
        return message(&format!("input.{label}"), []);
    }
    // A name may hold an "of" of its own: "pitch out of phase period of bow-up".
    let of_one = INPUTS
        .iter()
        .find_map(|what| Some((what, label.strip_prefix(what)?.strip_prefix(" of ")?)));
    match of_one {
        Some((what, which)) => message(
            "of",
            [
                ("what", name(&format!("input.{what}"))),
                ("which", Argument::Id(which.to_owned())),
            ],
        ),
        None => message("an_id", [("id", Argument::Id(label.to_owned()))]),
    }
}

/// Inputs in a row.
pub fn inputs<'a>(labels: impl IntoIterator<Item = &'a String>) -> Argument {
    Argument::Texts(labels.into_iter().map(|label| input(label)).collect())
}
