//! The fits of a session's swings, and their part in the joint estimate.

use super::fit::{Fit, Moves, Statement, SwingModel, fit};
use super::modes::fitted_modes;
use super::record::Samples;
use super::scene::SwingSetup;
use crate::inertia::measurement::ModeResult;
use crate::inertia::observe::Evidence;
use crate::inertia::parameters::Layout;
use crate::recording::Session;

/// A fit explains a record where what it leaves is white to this factor of variance …
const WHITE: f64 = 1.5;
/// … and the hull hangs as it was said to: a fit that tilts it by more of its stated uncertainties has lost its way …
const MOST_PITCH_PULL: f64 = 5.0;
/// … instead of white, it may leave so much less than lines in the spectrum do.
const FAR_BETTER: f64 = 1.5;

/// A swing whose samples the simulation explains.
pub struct FittedSwing<'a> {
    model: SwingModel<'a>,
    fit: Fit,
    /// Its modes.
    pub modes: Vec<ModeResult>,
    /// Residual over noise.
    pub rms_over_noise: f64,
}

impl<'a> FittedSwing<'a> {
    /// Fits swing `i` from the best of several sets of the session's parameters; `None` where it is no bifilar swing with a phone on it, and
    /// where the simulation does not explain the record: then the lines in its spectrum stand.
    pub fn of(
        session: &'a Session,
        layout: &'a Layout,
        i: usize,
        starts: &[Vec<f64>],
        evidence: &Evidence,
    ) -> Option<Self> {
        let (swing, index) = (&session.swings[i], &layout.swings[i]);
        let setup = SwingSetup { layout, swing, index };
        let fastest_s = evidence.found.modes.iter().map(|m| m.period_s()).fold(f64::INFINITY, f64::min);
        // Held dimensions keep a short record from wandering; a dimension that is stated wrong must not hold.
        [Moves::Body, Moves::All].into_iter().find_map(|early| {
            let model = SwingModel { setup, samples: Samples::of(evidence, fastest_s)? };
            let fit = fit(&model, starts, early).ok()?;
            Self::explaining(model, fit, evidence)
        })
    }

    fn explaining(model: SwingModel<'a>, fit: Fit, evidence: &Evidence) -> Option<Self> {
        let rms_over_noise = fit.rms_over_noise;
        let is_far_better = rms_over_noise * FAR_BETTER < evidence.found.rms_over_noise;
        let is_tilted = model.pitch_pull(&fit) > MOST_PITCH_PULL;
        if is_tilted || (fit.inflation > WHITE && !is_far_better) {
            return None;
        }
        let modes = fitted_modes(&model, &fit).ok()?;
        Some(Self { model, fit, modes, rms_over_noise })
    }

    /// Begins the fit anew at other parameters of the session, and keeps what is better.
    pub fn again(self, x: &[f64], evidence: &Evidence) -> Option<Self> {
        let fit = self.model.again(self.fit.clone(), x).unwrap_or(self.fit);
        Self::explaining(self.model, fit, evidence)
    }

    /// What the swing says of the session's parameters.
    pub fn statements(&self) -> Vec<Statement> {
        self.model.statements(&self.fit).unwrap_or_default()
    }

    /// Moves the fit to other parameters of the session, its own numbers fitted anew.
    pub fn move_to(&mut self, x: &[f64]) {
        if let Ok(moved) = self.model.moved(&self.fit, x) {
            self.fit = moved;
        }
    }
}
