//! The one door to every route by name: inputs and outputs as named numbers, for test vectors that
//! every language runs and for users who look a formula up.

use std::collections::BTreeMap;

use super::domain::{finite, result};
pub use super::entry::{CatalogueEntry, Numbers, Slot};
use super::entry::{Inputs, matches};
use super::propagate::{Propagated, propagate};
use super::table::ROUTES;
use gyradius_base::{Error, Result};
use gyradius_recording::Quantity;

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
