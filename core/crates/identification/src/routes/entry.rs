//! What a route of the catalogue is, and the named numbers that it takes.

use std::collections::BTreeMap;

use serde::Serialize;

use gyradius_base::{Error, Result};

/// Named numbers, SI units.
pub type Numbers = BTreeMap<String, f64>;

/// A named number of a route.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Slot {
    /// Name, unit included. `#` stands for 1, 2, 3 … without gaps.
    pub name: &'static str,
    /// Unit; `1` for a plain number.
    pub unit: &'static str,
    /// False where the route has a default (stated in its summary).
    pub required: bool,
}

/// A route that can be looked up and evaluated.
#[derive(Debug, Clone, Copy, Serialize, schemars::JsonSchema)]
pub struct CatalogueEntry {
    /// Name, permanent.
    pub name: &'static str,
    /// The paper's equations, or the source.
    pub equation: &'static str,
    /// What it does, with its defaults.
    pub summary: &'static str,
    /// Inputs.
    pub inputs: &'static [Slot],
    /// Outputs.
    pub outputs: &'static [Slot],
    #[serde(skip)]
    pub(super) function: fn(&Inputs) -> Result<Vec<f64>>,
}

/// Inputs whose names have been checked.
pub(super) struct Inputs<'a>(pub &'a Numbers);

impl Inputs<'_> {
    pub(super) fn get(&self, name: &str) -> Result<f64> {
        self.optional(name)
            .ok_or_else(|| Error::argument(name, "a number", "none"))
    }

    pub(super) fn optional(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }

    pub(super) fn or(&self, name: &str, default: f64) -> f64 {
        self.optional(name).unwrap_or(default)
    }

    /// No input of a numbered slot may stand beyond a gap, where it would be read by nobody.
    pub(super) fn numbered_up_to(&self, pattern: &str, last: usize) -> Result<()> {
        let beyond = |key: &&String| {
            matches(pattern, key)
                && !(1..=last).any(|n| **key == pattern.replace('#', &n.to_string()))
        };
        match self.0.keys().find(beyond) {
            Some(key) => Err(Error::argument(
                key,
                format!("numbers from 1 to {last}, without gaps"),
                key,
            )),
            None => Ok(()),
        }
    }

    /// Three numbers that share a pattern: `three("position_#_m", ["x", "y", "z"])`.
    pub(super) fn three(&self, pattern: &str, parts: [&str; 3]) -> Result<[f64; 3]> {
        let [a, b, c] = parts.map(|part| self.get(&pattern.replace('#', part)));
        Ok([a?, b?, c?])
    }
}

/// Whether a key is a slot's, numbered or not.
pub(super) fn matches(pattern: &str, key: &str) -> bool {
    let Some((head, tail)) = pattern.split_once('#') else {
        return pattern == key;
    };
    let number = key
        .strip_prefix(head)
        .and_then(|rest| rest.strip_suffix(tail));
    number.is_some_and(|digits| {
        digits
            .parse::<u16>()
            .is_ok_and(|n| n > 0 && n.to_string() == digits)
    })
}
