//! What is known of a parameter before a fit.

use std::f64::consts::SQRT_2;

use statrs::function::erf::erfc;

/// Prior and bounds of one parameter.
///
/// # Conventions
/// In the parameter's own unit. A prior `(mean, u)` is Gaussian and counts as one residual
/// `(x − mean)/u`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Mean and standard deviation of a Gaussian prior.
    pub prior: Option<(f64, f64)>,
    /// Least value; `-∞` where there is none.
    pub low: f64,
    /// Greatest value; `∞` where there is none. Equal to `low`: the parameter is fixed.
    pub high: f64,
}

impl Parameter {
    /// Without prior or bounds.
    pub const FREE: Self = Self {
        prior: None,
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// With a Gaussian prior.
    pub fn with_prior(self, mean: f64, u: f64) -> Self {
        Self {
            prior: Some((mean, u)),
            ..self
        }
    }

    /// Within bounds.
    pub fn within(self, low: f64, high: f64) -> Self {
        Self { low, high, ..self }
    }

    /// Fixed at a value.
    pub fn fixed(self, at: f64) -> Self {
        self.within(at, at)
    }

    /// Whether it cannot move.
    pub fn is_fixed(&self) -> bool {
        self.low >= self.high
    }

    /// The share within the bounds of a normal distribution about a value.
    pub(crate) fn mass(&self, mean: f64, sigma: f64) -> f64 {
        let below = |bound: f64| 0.5 * erfc((mean - bound) / (sigma * SQRT_2));
        below(self.high) - below(self.low)
    }

    pub(crate) fn is_valid(&self) -> bool {
        let prior = self
            .prior
            .is_none_or(|(mean, u)| mean.is_finite() && u.is_finite() && u > 0.0);
        prior && self.low <= self.high && self.low < f64::INFINITY && self.high > f64::NEG_INFINITY
    }

    /// The side that a value stands at.
    pub(crate) fn side(&self, x: f64) -> Option<Side> {
        if x <= self.low {
            Some(Side::Low)
        } else if x >= self.high {
            Some(Side::High)
        } else {
            None
        }
    }
}

/// A side of the box that bounds make.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The least value.
    Low,
    /// The greatest value.
    High,
}

impl Side {
    /// Whether a slope of χ² presses a parameter against this side.
    pub(crate) fn is_pressed(self, slope: f64) -> bool {
        match self {
            Side::Low => slope >= 0.0,
            Side::High => slope <= 0.0,
        }
    }
}
