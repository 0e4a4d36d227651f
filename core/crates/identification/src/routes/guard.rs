//! Pass, fail or undecided against a class limit, with a guard band (JCGM 106:2012, sections 7 and
//! 8).
//!
//! # Conventions
//! The value is taken as normally distributed with the stated u. The guard band keeps the risk of a
//! wrong pass *and* of a wrong fail at or below 5 %: between the two bands nothing is decided.

use super::domain::{finite, not_negative};
use crate::Verdict;
pub use crate::names::Relation;
use crate::names::{Decision, QuantityName};
use gyradius_base::{Error, Result};
use gyradius_recording::Quantity;

/// One-sided 95 % point of the normal distribution.
pub const GUARD_95: f64 = 1.644_853_626_951_472_2;

/// A class limit: `k_pitch_m>=1.100`, or by its short name `k_pitch>=1.100`.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// The quantity's name in files.
    pub quantity: String,
    /// Which side conforms.
    pub relation: Relation,
    /// The limit, unit of the quantity.
    pub limit: f64,
}

impl std::str::FromStr for Limit {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let bad = || {
            Error::argument(
                "limit",
                "a quantity, >= or <=, and a number, as in k_pitch_m>=1.100",
                text,
            )
        };
        let (relation, parts) = match (text.split_once(">="), text.split_once("<=")) {
            (Some(parts), None) => (Relation::AtLeast, parts),
            (None, Some(parts)) => (Relation::AtMost, parts),
            _ => return Err(bad()),
        };
        let limit: f64 = parts.1.trim().parse().map_err(|_| bad())?;
        let asked = parts.0.trim();
        if asked.is_empty() || !limit.is_finite() {
            return Err(bad());
        }
        let quantity = QuantityName::called(asked)
            .ok()
            .filter(QuantityName::is_one_number)
            .ok_or_else(|| unknown(asked))?;
        Ok(Self {
            quantity: quantity.to_string(),
            relation,
            limit,
        })
    }
}

/// A limit on a quantity that is none, with the nearest one that is.
fn unknown(asked: &str) -> Error {
    let names = QuantityName::SHORT.map(|(short, _)| short);
    let nearest = names
        .into_iter()
        .min_by_key(|name| strsim::damerau_levenshtein(name, asked))
        .unwrap_or_default();
    let expected = format!(
        "one of {} or small_period_…_s before the relation",
        names.join(", ")
    );
    Error::argument(
        "limit",
        expected,
        format!("`{asked}`; the nearest is `{nearest}`"),
    )
}

impl Limit {
    /// The quantity that is judged.
    ///
    /// # Errors
    /// Where no quantity has the name that was asked for.
    pub fn known_quantity(&self) -> Result<QuantityName> {
        self.quantity.parse()
    }
}

/// The verdict with the default guard band, 1.645 u.
pub fn verdict(value: Quantity, limit: &Limit) -> Result<Verdict> {
    verdict_with_guard(value, limit, GUARD_95)
}

/// The verdict with a guard band of `guard_factor` standard uncertainties.
pub fn verdict_with_guard(value: Quantity, limit: &Limit, guard_factor: f64) -> Result<Verdict> {
    let judged = judge(value, (limit.relation, limit.limit), guard_factor)?;
    Ok(Verdict {
        quantity: limit.known_quantity()?,
        relation: limit.relation,
        limit: limit.limit,
        guard_band: judged.guard_band,
        conformance_probability: judged.conformance_probability,
        verdict: judged.decision,
    })
}

/// A value judged at a bound.
pub(super) struct Judged {
    /// Guard band, unit of the value.
    pub guard_band: f64,
    /// Probability that the true value conforms.
    pub conformance_probability: f64,
    /// What is decided.
    pub decision: Decision,
}

/// Judges a value with a guard band of `guard_factor` standard uncertainties.
pub(super) fn judge(
    value: Quantity,
    (relation, bound): (Relation, f64),
    guard_factor: f64,
) -> Result<Judged> {
    let u = not_negative("u", value.u)?;
    let guard_band = u * not_negative("guard_factor", guard_factor)?;
    let bound = finite("limit", bound)?;
    let margin = match relation {
        Relation::AtLeast => finite("value", value.value)? - bound,
        Relation::AtMost => bound - finite("value", value.value)?,
    };
    let decision = match () {
        () if margin >= guard_band => Decision::Pass,
        () if margin <= -guard_band => Decision::Fail,
        () => Decision::Undecided,
    };
    Ok(Judged {
        guard_band,
        conformance_probability: conformance(margin, u),
        decision,
    })
}

/// Φ(margin / u) (JCGM 106, 7.3); a value stated as exact conforms or does not.
///
/// `libm` is right to the last digit or two; the erfc of `statrs` only to some 2e-11.
fn conformance(margin: f64, u: f64) -> f64 {
    if u == 0.0 {
        return if margin >= 0.0 { 1.0 } else { 0.0 };
    }
    0.5 * libm::erfc(-margin / (u * std::f64::consts::SQRT_2))
}
