//! A swing on its way from its record to the estimate.

use gyradius_recording::Quantity;

use super::measurement::{ModeResult, SwingResult};
use super::observe::Evidence;

/// Modes weaker than this beside the strongest of their swing are reported but not used: a stronger
/// motion drives them off their own period.
pub(super) const WEAKEST_DB: f64 = -16.0;

/// One swing on its way to the estimate.
pub struct SwingWork {
    pub(crate) result: SwingResult,
    /// What the record says, where there is one.
    pub evidence: Option<Evidence>,
    /// Undamped observed periods by mode with what they weigh; index into `result.modes`.
    pub(super) periods: Vec<(usize, Quantity)>,
    /// Its modes as the record has them, before corrections.
    uncorrected: Option<Vec<ModeResult>>,
}

impl SwingWork {
    /// What was found in a swing, nothing corrected yet.
    pub(super) fn of(
        result: SwingResult,
        evidence: Option<Evidence>,
        periods: Vec<(usize, Quantity)>,
    ) -> Self {
        Self {
            result,
            evidence,
            periods,
            uncorrected: None,
        }
    }

    /// Corrections begin from the modes as the record has them, however often they are made.
    pub(super) fn uncorrect(&mut self) {
        match &self.uncorrected {
            Some(modes) => self.result.modes.clone_from(modes),
            None => self.uncorrected = Some(self.result.modes.clone()),
        }
    }

    /// Takes its figures out of the estimate and out of the result; the pictures keep what was
    /// found.
    pub(super) fn refuse(&mut self) {
        self.periods.clear();
        self.result.modes.clear();
        self.uncorrected = None;
        self.result.motion = None;
        self.evidence = None;
    }
}
