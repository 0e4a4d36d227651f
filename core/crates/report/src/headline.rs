//! Which figures head the report: where the base simulation was found wanting, those of the
//! extended one.

use std::collections::BTreeMap;

use super::source::ReportSource;
use gyradius_diagnosis::{Critique, Status};
use gyradius_identification::routes::guard::{Limit, verdict};
use gyradius_identification::{Decision, QuantityName, QuantityResult, Verdict};
use gyradius_recording::Quantity;

/// The figures that head the report.
pub(super) struct Headline {
    /// The result.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
    /// The base figures that others of these took the place of.
    pub replaced: BTreeMap<QuantityName, QuantityResult>,
    /// Verdicts on the figures that head the report.
    pub verdicts: Vec<Verdict>,
}

impl Headline {
    /// The measurement's figures, and over them those of the extended simulation where something
    /// was missing.
    pub fn of(source: &ReportSource) -> Self {
        let mut quantities = source.measurement.quantities.clone();
        let mut replaced = BTreeMap::new();
        for (key, extended) in extended(source) {
            if let Some(base) = quantities.insert(key.clone(), extended) {
                replaced.insert(key, base);
            }
        }
        let judged = |old: &Verdict| match replaced.contains_key(&old.quantity) {
            true => judged_again(old, &quantities[&old.quantity]).unwrap_or_else(|| old.clone()),
            false => old.clone(),
        };
        // Where the criticism names no one cause, the extended figures are one guess among several.
        let is_guess = criticised(source)
            .is_some_and(|c| matches!(c.verdict.status, Status::Ambiguous | Status::Unexplained));
        let verdicts = source.measurement.verdicts.iter().map(|old| {
            let new = judged(old);
            if is_guess { agreed(old, new) } else { new }
        });
        let verdicts = verdicts.collect();
        Self {
            quantities,
            replaced,
            verdicts,
        }
    }
}

fn criticised(source: &ReportSource) -> Option<&Critique> {
    source.criticised().map(|criticism| &criticism.critique)
}

/// What two models that may both be right say together: undecided where they do not decide alike.
/// Neither is known to be likelier, so their probabilities are averaged.
fn agreed(base: &Verdict, extended: Verdict) -> Verdict {
    let decision = match base.verdict == extended.verdict {
        true => base.verdict,
        false => Decision::Undecided,
    };
    let probability = 0.5 * (base.conformance_probability + extended.conformance_probability);
    Verdict {
        verdict: decision,
        conformance_probability: probability,
        ..extended
    }
}

fn extended(source: &ReportSource) -> BTreeMap<QuantityName, QuantityResult> {
    criticised(source)
        .filter(|critique| critique.verdict.status != Status::Adequate)
        .map_or_else(BTreeMap::new, |critique| {
            critique.extended.quantities.clone()
        })
}

fn judged_again(old: &Verdict, quantity: &QuantityResult) -> Option<Verdict> {
    let limit = Limit {
        quantity: old.quantity.to_string(),
        relation: old.relation,
        limit: old.limit,
    };
    verdict(
        Quantity::new(quantity.value.scalar()?, quantity.u.scalar()?),
        &limit,
    )
    .ok()
}
