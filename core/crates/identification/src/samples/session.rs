//! The fits of a session's swings.

use super::equations::Moves;
use super::fit::{Begun, Fit, Headings, begun, fit, fit_together};
use super::model::{Statement, SwingModel};
use super::modes::fitted_modes;
use super::record::Samples;
use super::scene::{Own, SwingSetup};
use crate::measurement::ModeResult;
use crate::observe::Evidence;
use crate::parameters::Layout;
use gyradius_base::error::Result;
use gyradius_recording::Session;

/// A fit explains a record where what it leaves is white to this factor of variance …
pub const WHITE: f64 = 1.5;
/// … and the hull hangs as it was said to: a fit that tilts it by more of its stated uncertainties
/// has lost its way …
const MOST_PITCH_PULL: f64 = 5.0;
/// … instead of white, it may leave so much less than lines in the spectrum do.
const FAR_BETTER: f64 = 1.5;

/// How a fit is begun, and what may move over the short horizons.
#[derive(Debug, Clone, Copy)]
pub struct Ways {
    headings: Headings,
    moves: &'static [Moves],
}

impl Ways {
    /// With the suspension as motions show it and as it was stated.
    pub const FIRST: Self = Self {
        headings: Headings::Shown,
        moves: &[Moves::Body, Moves::All],
    };
    /// From any heading, at last with lines of another length than was stated.
    pub const ALL: Self = Self {
        headings: Headings::All,
        moves: &[Moves::Body, Moves::All, Moves::Opened],
    };
}

/// A swing whose samples the simulation explains.
pub struct FittedSwing<'a> {
    model: SwingModel<'a>,
    fit: Fit,
    /// What lines in the spectrum leave over noise.
    lines_rms_over_noise: f64,
}

/// What a swing's fit begins with: the same whatever moves afterwards.
struct Beginning<'a, 'k> {
    model: SwingModel<'a>,
    begun: Vec<Begun>,
    known: &'k [Statement],
    lines_rms_over_noise: f64,
}

impl<'a, 'k> Beginning<'a, 'k> {
    fn of(
        (session, layout, i): (&'a Session, &'a Layout, usize),
        starts: &[Vec<f64>],
        known: &'k [Statement],
        evidence: &Evidence,
        headings: Headings,
    ) -> Option<Self> {
        let setup = SwingSetup {
            layout,
            swing: &session.swings[i],
            index: &layout.swings[i],
        };
        let fastest_s = evidence
            .found
            .modes
            .iter()
            .map(|m| m.period_s())
            .fold(f64::INFINITY, f64::min);
        let model = SwingModel {
            setup,
            samples: Samples::of(evidence, fastest_s)?,
        };
        let begun = begun(&model, starts, known, headings);
        Some(Self {
            model,
            begun,
            known,
            lines_rms_over_noise: evidence.found.rms_over_noise,
        })
    }

    /// Held dimensions keep a short record from wandering; a dimension that is stated wrong must
    /// not hold: `early` says what moves over the short horizons.
    fn fitted(&self, early: Moves) -> Option<FittedSwing<'a>> {
        let fit = fit(&self.model, &self.begun, self.known, early).ok()?;
        let (model, lines_rms_over_noise) = (self.model.clone(), self.lines_rms_over_noise);
        Some(FittedSwing {
            model,
            fit,
            lines_rms_over_noise,
        })
    }
}

impl<'a> FittedSwing<'a> {
    /// Fits swing `i` from the best of several sets of the session's parameters, beside what is
    /// `known` of them; `None` where it is no bifilar swing with a phone on it, and where the
    /// simulation does not explain the record: then the lines in its spectrum stand. `ways` are tried
    /// until one of them explains it.
    pub fn of(
        swing: (&'a Session, &'a Layout, usize),
        starts: &[Vec<f64>],
        known: &[Statement],
        evidence: &Evidence,
        ways: Ways,
    ) -> Option<Self> {
        let begun = Beginning::of(swing, starts, known, evidence, ways.headings)?;
        let mut fits = ways.moves.iter().filter_map(|early| begun.fitted(*early));
        fits.find(Self::explains)
    }

    /// The fit nearest to the samples, whether it explains them or not; `None` where there is none.
    pub fn nearest(
        swing: (&'a Session, &'a Layout, usize),
        starts: &[Vec<f64>],
        evidence: &Evidence,
    ) -> Option<Self> {
        let begun = Beginning::of(swing, starts, &[], evidence, Headings::All)?;
        let held = begun.fitted(Moves::Body);
        if held.as_ref().is_some_and(Self::explains) {
            return held;
        }
        [held, begun.fitted(Moves::All)]
            .into_iter()
            .flatten()
            .min_by(|a, b| a.cost().total_cmp(&b.cost()))
    }

    /// What is fitted, and the fit.
    pub fn into_parts(self) -> (SwingModel<'a>, Fit) {
        (self.model, self.fit)
    }

    /// Whether what it leaves is white, or far less than lines in the spectrum leave, and the hull
    /// hangs as it was said to.
    pub fn explains(&self) -> bool {
        let is_far_better = self.fit.rms_over_noise * FAR_BETTER < self.lines_rms_over_noise;
        let is_tilted = self.model.pitch_pull(&self.fit) > MOST_PITCH_PULL;
        !is_tilted && (self.fit.inflation <= WHITE || is_far_better)
    }

    /// Fits swings together from parameters of the session. Where that leaves one of them
    /// unexplained, none is changed: the swings contradict each other, and the answer is no.
    pub fn fit_together(swings: &mut [&mut Self], x: &[f64]) -> Result<bool> {
        let models: Vec<&SwingModel> = swings.iter().map(|s| &s.model).collect();
        let owns: Vec<Own> = swings.iter().map(|s| s.fit.own.clone()).collect();
        let fits = fit_together(&models, x, &owns)?;
        let before: Vec<Fit> = swings.iter().map(|s| s.fit.clone()).collect();
        swings
            .iter_mut()
            .zip(fits)
            .for_each(|(swing, fit)| swing.fit = fit);
        let agree = swings.iter().all(|s| s.explains());
        if !agree {
            swings
                .iter_mut()
                .zip(before)
                .for_each(|(swing, fit)| swing.fit = fit);
        }
        Ok(agree)
    }

    /// Whether it hangs so far from level that bow and stern differ.
    pub fn tells_bow_from_stern(&self) -> bool {
        self.model.tells_bow_from_stern()
    }

    /// χ² of the fit, what was known beside it included.
    pub fn cost(&self) -> f64 {
        self.fit.cost
    }

    /// The session's parameters as this swing has them.
    pub fn x(&self) -> &[f64] {
        &self.fit.x
    }

    /// The product of inertia by this swing alone, and the information it has on it.
    pub fn product(&self) -> (f64, f64) {
        let place = self.model.setup.layout.product_xz;
        let u = self.model.u(&self.fit, place).unwrap_or(f64::INFINITY);
        (self.fit.x[place], u.powi(-2))
    }

    /// What the swing says of the session's parameters. A level hull looks the same from both ends,
    /// so the sign of its product of inertia hangs on a heading that nobody knows: unless the
    /// swings were fitted together, the product is left open.
    pub fn statements(&self, together: bool) -> Vec<Statement> {
        let product_is_open = !together && !self.tells_bow_from_stern();
        self.model
            .statements(&self.fit, product_is_open)
            .unwrap_or_default()
    }

    /// Its modes.
    pub fn modes(&self) -> Result<Vec<ModeResult>> {
        fitted_modes(&self.model, &self.fit)
    }

    /// Residual over noise.
    pub fn rms_over_noise(&self) -> f64 {
        self.fit.rms_over_noise
    }
}
