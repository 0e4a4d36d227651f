//! Messages about a measurement.
//!
//! Beside sentences there are names: `input.…` of an input of a budget, `motion.…` of a motion,
//! `quantity.…` of a quantity, `route.…` of a closed-form estimator; `id.…` is a quantity as the
//! format spells it.

use gyradius_base::error::Error;
use gyradius_base::message::{Argument, Message, spaced};

use super::names::{Input, InputKind, Origin};

/// Key of the warning that gravity is not stated.
pub const NO_GRAVITY: &str = "inertia.no_gravity";
/// Key of the name of gravity.
pub const GRAVITY: &str = "inertia.input.gravity";
/// Key of the warning that there is no joint estimate.
pub const NO_JOINT_ESTIMATE: &str = "inertia.no_joint_estimate";

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

impl Input {
    /// Its name, in English as files spell it.
    pub fn message(&self) -> Message {
        self.called(self.kind.name().to_owned())
    }

    /// The same in words.
    pub fn in_words(&self) -> Message {
        self.called(spaced(self.kind.name()))
    }

    fn called(&self, kind: String) -> Message {
        let key = format!("input.{kind}");
        match &self.of {
            None => message(&key, []),
            Some(which) => message(
                "of",
                [("what", name(&key)), ("which", Argument::Id(which.clone()))],
            ),
        }
    }
}

impl InputKind {
    /// Its name in words.
    pub fn in_words(self) -> Message {
        Input::from(self).in_words()
    }
}

impl Origin {
    /// Its name in words.
    pub fn message(&self) -> Message {
        match self {
            Self::Swing(id) => message("an_id", [("id", Argument::Id(id.clone()))]),
            Self::Incline(kind) => kind.in_words(),
        }
    }
}

/// The name of an input by its text in files; what is no input is an id.
pub fn input(label: &str) -> Message {
    let known = label.parse::<Input>().map(|input| input.message());
    known.unwrap_or_else(|_| message("an_id", [("id", Argument::Id(label.to_owned()))]))
}

/// Inputs in a row.
pub fn inputs<'a>(all: impl IntoIterator<Item = &'a Input>) -> Argument {
    Argument::Texts(all.into_iter().map(Input::in_words).collect())
}

/// Swings and inclines in a row.
pub fn origins<'a>(all: impl IntoIterator<Item = &'a Origin>) -> Argument {
    Argument::Texts(all.into_iter().map(Origin::message).collect())
}
