//! A number with one standard uncertainty.

use serde::{Deserialize, Serialize};

/// A value and its standard uncertainty in the same unit (GUM: `u`, one sigma; 0 = stated as
/// exact).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Quantity {
    /// The value.
    pub value: f64,
    /// Its standard uncertainty, ≥ 0.
    pub u: f64,
}

impl Quantity {
    /// A value with its standard uncertainty.
    pub const fn new(value: f64, u: f64) -> Self {
        Self { value, u }
    }

    /// A value stated without uncertainty.
    pub const fn exact(value: f64) -> Self {
        Self { value, u: 0.0 }
    }
}

impl From<f64> for Quantity {
    fn from(value: f64) -> Self {
        Self::exact(value)
    }
}
