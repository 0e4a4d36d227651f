//! The one door to every route by name: inputs and outputs as named numbers, for test vectors that
//! every language runs and for users who look a formula up.

use std::collections::BTreeMap;

use serde::Serialize;

use super::domain::{finite, result};
use super::propagate::{Propagated, propagate};
use super::table::ROUTES;
use gyradius_base::{Error, Result};
use gyradius_recording::Quantity;

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
pub(super) struct Inputs<'a>(&'a Numbers);

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

/// Every route, in the paper's order.
pub fn catalogue() -> &'static [CatalogueEntry] {
    ROUTES
}

/// Outputs of the route of this name.
///
/// # Errors
/// [`Error::Argument`] for an unknown route, an unknown or missing input, and whatever is outside
/// the domain; [`Error::NoResult`] where the inputs contradict each other.
pub fn evaluate(name: &str, inputs: &Numbers) -> Result<Numbers> {
    let entry = find(name)?;
    check_names(entry, inputs)?;
    for (key, value) in inputs {
        finite(key, *value)?;
    }
    let values = (entry.function)(&Inputs(inputs))?;
    let named =
        |(slot, value): (&Slot, f64)| Ok((slot.name.to_string(), result(slot.name, value)?));
    entry.outputs.iter().zip(values).map(named).collect()
}

/// One output of a route with its uncertainty; contributions in the order of the inputs' names.
pub fn evaluate_with_u(
    name: &str,
    inputs: &BTreeMap<String, Quantity>,
    output: &str,
) -> Result<Propagated> {
    let quantities: Vec<Quantity> = inputs.values().copied().collect();
    propagate(&quantities, |values| {
        let numbers = inputs.keys().cloned().zip(values.iter().copied()).collect();
        let outputs = evaluate(name, &numbers)?;
        let known = || outputs.keys().cloned().collect::<Vec<_>>().join(", ");
        outputs
            .get(output)
            .copied()
            .ok_or_else(|| Error::argument("output", known(), output))
    })
}

fn find(name: &str) -> Result<&'static CatalogueEntry> {
    ROUTES
        .iter()
        .find(|entry| entry.name == name)
        .ok_or_else(|| {
            let near =
                |entry: &&CatalogueEntry| (1000.0 * strsim::jaro_winkler(entry.name, name)) as i64;
            let nearest = ROUTES
                .iter()
                .max_by_key(near)
                .map_or("", |entry| entry.name);
            Error::argument(
                "route",
                format!("a route of the catalogue (the nearest is `{nearest}`)"),
                name,
            )
        })
}

fn check_names(entry: &CatalogueEntry, inputs: &Numbers) -> Result<()> {
    for slot in entry.inputs.iter().filter(|slot| slot.required) {
        let name = slot.name.replace('#', "1");
        if !inputs.contains_key(&name) {
            return Err(Error::argument(
                &name,
                format!("a number, {}", slot.unit),
                "none",
            ));
        }
    }
    for key in inputs.keys() {
        if !entry.inputs.iter().any(|slot| matches(slot.name, key)) {
            let names: Vec<_> = entry.inputs.iter().map(|slot| slot.name).collect();
            return Err(Error::argument("inputs", names.join(", "), key));
        }
    }
    Ok(())
}

fn matches(pattern: &str, key: &str) -> bool {
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
