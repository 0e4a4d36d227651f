//! Pass, fail or undecided against a class limit, with a guard band (JCGM 106:2012, sections 7 and
//! 8).
//!
//! # Conventions
//! The value is taken as normally distributed with the stated u. The guard band keeps the risk of a
//! wrong pass *and* of a wrong fail at or below 5 %: between the two bands nothing is decided.

use super::domain::{finite, not_negative};
use crate::Verdict;
use gyradius_base::{Error, Result};
use gyradius_recording::Quantity;

/// One-sided 95 % point of the normal distribution.
pub const GUARD_95: f64 = 1.644_853_626_951_472_2;

/// Which side of the limit conforms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The value must reach the limit.
    AtLeast,
    /// The value must not exceed the limit.
    AtMost,
}

impl Relation {
    /// `>=` or `<=`.
    pub fn sign(self) -> &'static str {
        match self {
            Relation::AtLeast => ">=",
            Relation::AtMost => "<=",
        }
    }
}

/// A class limit: `k_pitch_m>=1.100`.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// The quantity's name.
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
        let quantity = parts.0.trim().to_string();
        if quantity.is_empty() || !limit.is_finite() {
            return Err(bad());
        }
        Ok(Self {
            quantity,
            relation,
            limit,
        })
    }
}

/// The verdict with the default guard band, 1.645 u.
pub fn verdict(value: Quantity, limit: &Limit) -> Result<Verdict> {
    verdict_with_guard(value, limit, GUARD_95)
}

/// The verdict with a guard band of `guard_factor` standard uncertainties.
pub fn verdict_with_guard(value: Quantity, limit: &Limit, guard_factor: f64) -> Result<Verdict> {
    let u = not_negative("u", value.u)?;
    let guard_band = u * not_negative("guard_factor", guard_factor)?;
    let bound = finite("limit", limit.limit)?;
    let margin = match limit.relation {
        Relation::AtLeast => finite("value", value.value)? - bound,
        Relation::AtMost => bound - finite("value", value.value)?,
    };
    let verdict = match () {
        () if margin >= guard_band => "pass",
        () if margin <= -guard_band => "fail",
        () => "undecided",
    };
    Ok(Verdict {
        quantity: limit.quantity.clone(),
        relation: limit.relation.sign().into(),
        limit: bound,
        guard_band,
        conformance_probability: conformance(margin, u),
        verdict: verdict.into(),
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
