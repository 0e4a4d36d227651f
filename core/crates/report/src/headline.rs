//! Which figures head the report: where the base simulation was found wanting, those of the
//! extended one.

use std::collections::BTreeMap;

use super::source::ReportSource;
use gyradius_diagnosis::{Critique, Status, judged_with};
use gyradius_identification::{QuantityName, QuantityResult, Verdict};

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
        let measurement = &source.measurement;
        let verdicts = criticised(source).map_or_else(
            || measurement.verdicts.clone(),
            |critique| judged_with(measurement, critique).verdicts,
        );
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

fn extended(source: &ReportSource) -> BTreeMap<QuantityName, QuantityResult> {
    criticised(source)
        .filter(|critique| critique.verdict.status != Status::Adequate)
        .map_or_else(BTreeMap::new, |critique| {
            critique.extended.quantities.clone()
        })
}
