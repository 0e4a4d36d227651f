//! A swing on its way from its record to the estimate.

use gyradius_recording::Quantity;

use super::measurement::SwingResult;
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
}

impl SwingWork {
    /// Takes its figures out of the estimate and out of the result; the pictures keep what was
    /// found.
    pub(super) fn refuse(&mut self) {
        self.periods.clear();
        self.result.modes.clear();
        self.result.motion = None;
        self.evidence = None;
    }
}
