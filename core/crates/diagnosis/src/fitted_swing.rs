//! What is fitted: a session's parameters and its swings.

use gyradius_identification::Evidence;
use gyradius_identification::estimate::System;
use gyradius_identification::parameters::Layout;
use gyradius_identification::samples::{Samples, SwingSetup};
use gyradius_recording::Session;

/// Parts of the recordings that a fit from far away is led over, s.
pub const HORIZONS_S: [f64; 3] = [8.0, 20.0, 50.0];

/// A swing that is fitted.
pub struct FittedSwing<'a> {
    pub setup: SwingSetup<'a>,
    pub samples: Samples,
    /// Which of the session's phone mounts it has.
    pub mount: usize,
    /// Place in the session.
    pub number: usize,
    pub evidence: &'a Evidence,
}

/// What is fitted: the session's parameters and its swings.
pub struct Base<'a> {
    pub session: &'a Session,
    pub system: &'a System<'a>,
    pub swings: Vec<FittedSwing<'a>>,
    pub mounts: usize,
    /// The session's parameters in play.
    pub free: Vec<usize>,
}

impl<'a> Base<'a> {
    pub fn layout(&self) -> &'a Layout {
        &self.system.layout
    }
}
