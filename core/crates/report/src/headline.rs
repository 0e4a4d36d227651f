//! Which figures head the report: where the base simulation was found wanting, those of the
//! extended one.

use std::collections::BTreeMap;

use super::source::ReportSource;
use gyradius_diagnosis::Status;
use gyradius_identification::routes::guard::{Limit, verdict};
use gyradius_identification::{QuantityName, QuantityResult, Verdict};
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
        let verdicts = source.measurement.verdicts.iter().map(judged).collect();
        Self {
            quantities,
            replaced,
            verdicts,
        }
    }
}

fn extended(source: &ReportSource) -> BTreeMap<QuantityName, QuantityResult> {
    let critique = source.criticised().map(|criticism| &criticism.critique);
    critique
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
