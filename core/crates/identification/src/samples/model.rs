//! A swing to be fitted, and what another may state of the session's parameters.

use super::linearise::Simulated;
use super::record::Samples;
use super::scene::{Own, SwingSetup};
use gyradius_base::error::Result;

/// One swing and its samples.
#[derive(Clone)]
pub struct SwingModel<'a> {
    pub setup: SwingSetup<'a>,
    pub samples: Samples,
}

impl SwingModel<'_> {
    /// The swing up to a horizon.
    pub fn simulated(&self, x: &[f64], own: &Own, horizon_s: f64) -> Result<Simulated> {
        let whole_s = self.samples.duration_s;
        Simulated::new(&self.setup, x, own, horizon_s.min(whole_s), whole_s)
    }
}

/// A linear statement about the session's parameters: `row · x = value`, of unit standard
/// uncertainty.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// Parameters by their index, each with its factor.
    pub row: Vec<(usize, f64)>,
    /// What they add up to.
    pub value: f64,
}

impl Statement {
    /// How far parameters are from what is stated, in standard uncertainties.
    pub fn misfit(&self, x: &[f64]) -> f64 {
        self.value - self.row.iter().map(|(i, slope)| slope * x[*i]).sum::<f64>()
    }

    /// The row by places among the free parameters.
    pub fn by_place(&self, free: &[usize]) -> Vec<(usize, f64)> {
        let place = |i: &usize| free.iter().position(|f| f == i);
        self.row
            .iter()
            .filter_map(|(i, slope)| Some((place(i)?, *slope)))
            .collect()
    }
}
