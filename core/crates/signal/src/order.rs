//! How many modes there are, decided from the data.
//!
//! The strongest line of the residual's spectrum, each channel measured against its own coloured
//! floor, is tried as what it may be: a combination tone of known modes, an amplitude law of the
//! mode it stands beside, the other half of a close pair, or a mode of its own. A trial stays if
//! what it takes off the sum of squares, measured against the floor *after* the trial, is beyond
//! what the largest of all noise bins would take off.

use super::basis::Model;
use super::compress::Cells;
use super::fit::{Fit, polish, project, project_with_curvature, refine};
use super::proposals::{Kind, nearest, proposals};
use super::record::{FINAL_CELLS, SEARCH_CELLS};
use super::search::{Peak, Search, Whitened};

/// χ² (2 degrees of freedom) that an amplitude law must gain: false alarm 4e-6 for white noise.
const LAW_GAIN: f64 = 25.0;
/// Peaks tried in vain before the search ends.
const MOST_REJECTIONS: usize = 6;
/// Most iterations of the last fit.
const LAST_ITERATIONS: usize = 12;
/// Standard errors of a negative decay that count as noise.
const BEYOND_NOISE: f64 = 3.0;
/// Polynomials that follow drift and leave an oscillation of one cycle in the span alone.
const BASELINE_PER_CYCLE: f64 = 1.6;
/// Polynomials added where a drift may hide all modes.
const DRIFT_STEP: usize = 5;
/// Gain, over the bound, that a drift or a line with wide skirts shows and red noise does not.
const DRIFT_GAIN: f64 = 100.0;
/// Most baseline polynomials.
const MOST_BASELINE: usize = 12;

impl Search<'_> {
    /// Adds lines until the residual has none; where there are none, below a drift that stands in
    /// front of them.
    pub fn run(&mut self) {
        self.add_lines();
        while self.fit.model.modes.is_empty() && self.take_more_drift() {
            self.add_lines();
        }
        // No drift stands in front of them: they may hide each other.
        if self.fit.model.modes.is_empty() && self.add_strongest_pair() {
            self.add_lines_above_floor();
        }
        self.simplify();
        self.finish();
    }

    /// A richer baseline before there are modes, as far as some of the band stays above it.
    fn take_more_drift(&mut self) -> bool {
        let baseline = self.fit.model.baseline + DRIFT_STEP;
        let model = Model {
            baseline,
            ..Model::default()
        };
        let fit = (baseline <= MOST_BASELINE)
            .then(|| project(&model, &self.cells))
            .flatten();
        let Some(fit) = fit else { return false };
        let taken =
            self.gain(&fit, &self.whiten(&fit), 0.5 * baseline as f64) > DRIFT_GAIN * self.bound;
        if taken {
            self.fit = fit;
        }
        taken
    }

    /// The band as far as the baseline does not follow it.
    fn band(&self) -> (f64, f64) {
        let (low, high) = self.record.band;
        (
            low.max(self.fit.model.baseline as f64 / BASELINE_PER_CYCLE),
            high,
        )
    }

    fn add_lines(&mut self) {
        self.add_lines_above_floor();
        if self.fit.model.modes.is_empty() && !self.is_complete() && self.add_strongest_line() {
            self.add_lines_above_floor();
        }
    }

    /// The two strongest lines together, where neither was found: each may pass for the floor that
    /// hides the other.
    fn add_strongest_pair(&mut self) -> bool {
        let most = self.options.mode_count.unwrap_or(self.options.max_modes);
        if most < 2 {
            return false;
        }
        let Some(peak) = self.strongest() else {
            return false;
        };
        let before = self.make_cells_for(peak.k * std::f64::consts::TAU);
        let none = self.fit.clone();
        let first = proposals(self, &peak, true, &[]).into_iter().next();
        let pair = first.and_then(|(_, first)| {
            self.fit = first;
            let other = self.strongest()?;
            self.best_trial(&other, &[])
        });
        self.fit = none;
        let least = DRIFT_GAIN * self.bound;
        match pair.filter(|(fit, after)| self.gain(fit, after, peak.k) > least) {
            Some((fit, _)) => {
                self.fit = fit;
                true
            }
            None => {
                if let Some(before) = before {
                    (self.cells, self.width, self.fit) = before;
                }
                false
            }
        }
    }

    /// The strongest line of what the fit leaves, the floor taken as flat.
    fn strongest(&self) -> Option<Peak> {
        let flat = self.whiten(&self.fit).over_mean_power();
        flat.peak(self.band(), &[], &self.fit)
    }

    /// The strongest line of all, where none was found: its own skirts may have passed for the
    /// floor that hides it.
    fn add_strongest_line(&mut self) -> bool {
        let Some(peak) = self.strongest() else {
            return false;
        };
        let Some((fit, Some(after))) = self.improve(&peak, &[]) else {
            return false;
        };
        let stands = self.gain(&fit, &after, peak.k) > DRIFT_GAIN * self.bound;
        if stands {
            self.fit = fit;
        }
        stands
    }

    fn add_lines_above_floor(&mut self) {
        let (mut masked, mut tried): (Vec<f64>, Vec<usize>) = (vec![], vec![]);
        let mut whitened = self.whiten(&self.fit);
        while !self.is_complete() && masked.len() <= MOST_REJECTIONS {
            if tried.is_empty() && self.raise_baseline(&whitened) {
                whitened = self.whiten(&self.fit);
            }
            let Some(peak) = whitened.peak(self.band(), &masked, &self.fit) else {
                break;
            };
            if self.options.mode_count.is_none() && peak.power < 0.6 * self.bound {
                break;
            }
            match self.improve(&peak, &tried) {
                Some((fit, after)) => {
                    self.fit = fit;
                    tried.clear();
                    let Some(after) = after else { break };
                    whitened = after;
                }
                None => {
                    masked.push(peak.k);
                    tried.extend(nearest(&self.fit.model, peak.k));
                }
            }
        }
        self.top_floor = whitened
            .floors
            .iter()
            .map(|floor| floor.at(self.record.band.1))
            .collect();
    }

    /// The last steps, on cells so fine that next to nothing is lost.
    fn finish(&mut self) {
        if self.fit.model.modes.is_empty() {
            return;
        }
        let width = self
            .record
            .fit_width(self.fit.model.highest_omega(), FINAL_CELLS);
        if width < 0.8 * self.width {
            self.width = width;
            self.cells = self.record.gather(width);
        }
        if let Some(fit) = polish(&self.fit.model, &self.cells, LAST_ITERATIONS, &[]) {
            self.fit = fit;
        }
        if self.fit.model.modes.iter().any(|mode| mode.alpha < 0.0) {
            self.hold_growing();
        }
    }

    /// A free swing does not grow: where the fit says so beyond its noise, the decay is held at
    /// zero.
    fn hold_growing(&mut self) {
        let Some((_, curvature)) = project_with_curvature(&self.fit.model, &self.cells) else {
            return;
        };
        let Some(covariance) = curvature.hessian.cholesky().map(|c| c.inverse()) else {
            return;
        };
        let (mut model, mut held) = (self.fit.model.clone(), vec![]);
        for m in 0..model.modes.len() {
            let at = model.parameter_offset(m) + 1;
            if model.modes[m].alpha < -BEYOND_NOISE * covariance[(at, at)].sqrt() {
                model.modes[m].alpha = 0.0;
                held.push(at);
            }
        }
        if held.is_empty() {
            return;
        }
        if let Some(fit) = polish(&model, &self.cells, LAST_ITERATIONS, &held) {
            self.fit = fit;
            self.held_growing = held.len();
        }
    }

    fn is_complete(&self) -> bool {
        let modes = self.fit.model.modes.len();
        match self.options.mode_count {
            Some(count) => modes >= count,
            None => modes >= self.options.max_modes || self.fit.model.tones.len() >= 8,
        }
    }

    /// The best admissible trial for a peak, if one stands.
    ///
    /// No spectrum comes with the last of a given number of modes.
    fn improve(&mut self, peak: &Peak, tried: &[usize]) -> Option<(Fit, Option<Whitened>)> {
        let before = self.make_cells_for(peak.k * std::f64::consts::TAU);
        let found = match self.options.mode_count {
            Some(count) => {
                let (_, fit) = proposals(self, peak, true, tried).into_iter().next()?;
                let after = (fit.model.modes.len() < count).then(|| self.whiten(&fit));
                Some((fit, after))
            }
            None => self
                .best_trial(peak, tried)
                .map(|(fit, after)| (fit, Some(after))),
        };
        if let (None, Some(before)) = (&found, before) {
            (self.cells, self.width, self.fit) = before;
        }
        found
    }

    fn best_trial(&self, peak: &Peak, tried: &[usize]) -> Option<(Fit, Whitened)> {
        let mut best: Option<(f64, Kind, Fit, Whitened)> = None;
        for (kind, fit) in proposals(self, peak, false, tried) {
            let after = self.whiten(&fit);
            let gain = self.gain(&fit, &after, peak.k);
            let needed = if kind == Kind::Law {
                LAW_GAIN
            } else {
                2.0 * self.bound
            };
            if gain < needed {
                continue;
            }
            let better = match &best {
                None => true,
                Some(held) => prefer(kind, gain, &fit, held.1, held.0, &held.2, self.bound),
            };
            if better {
                best = Some((gain, kind, fit, after));
            }
        }
        best.map(|(_, _, fit, after)| (fit, after))
    }

    /// χ² that a fit gains over the present one, by the floor at a frequency.
    fn gain(&self, fit: &Fit, after: &Whitened, k: f64) -> f64 {
        let lost = self
            .fit
            .rss
            .iter()
            .zip(&fit.rss)
            .map(|(before, after)| before - after);
        lost.zip(&after.floors)
            .map(|(lost, floor)| (lost / floor.at(k)).clamp(-1e12, 1e12))
            .sum()
    }

    /// Finer cells where a faster line is tried than the present cells resolve; what was before is
    /// returned.
    fn make_cells_for(&mut self, omega: f64) -> Option<(Vec<Cells>, f64, Fit)> {
        let fastest = self.fit.model.highest_omega().max(omega);
        let width = self.record.fit_width(fastest, SEARCH_CELLS);
        let first = self.fit.model.modes.is_empty();
        if !first && width > 0.8 * self.width {
            return None;
        }
        let cells = std::mem::replace(&mut self.cells, self.record.gather(width));
        let fit = refine(&self.fit.model, &self.cells, 3).unwrap_or_else(|| self.fit.clone());
        Some((
            cells,
            std::mem::replace(&mut self.width, width),
            std::mem::replace(&mut self.fit, fit),
        ))
    }

    /// Two more baseline polynomials where the spectrum stands high below the band.
    fn raise_baseline(&mut self, whitened: &Whitened) -> bool {
        let slowest = self
            .fit
            .model
            .modes
            .iter()
            .map(|m| m.omega)
            .fold(f64::INFINITY, f64::min);
        let room = (BASELINE_PER_CYCLE * slowest / std::f64::consts::TAU).min(MOST_BASELINE as f64)
            as usize;
        let baseline = self.fit.model.baseline + 2;
        let low = whitened.highest(0.3, self.record.band.0.min(1.5));
        if slowest.is_infinite() || baseline > room || low < 0.5 * self.bound {
            return false;
        }
        let model = Model {
            baseline,
            ..self.fit.model.clone()
        };
        let Some(fit) = refine(&model, &self.cells, 6) else {
            return false;
        };
        let after = self.whiten(&fit);
        let raised = self.gain(&fit, &after, 0.5 * baseline as f64) > 2.0 * self.bound;
        if raised {
            self.fit = fit;
        }
        raised
    }

    /// Takes back laws that a later mode made needless.
    fn simplify(&mut self) {
        for m in 0..self.fit.model.modes.len() {
            if self.fit.model.modes[m].law.is_none() || self.fit.model.modes.len() == 1 {
                continue;
            }
            let mut model = self.fit.model.clone();
            model.modes[m].law = None;
            let Some(plain) = refine(&model, &self.cells, 12) else {
                continue;
            };
            let after = self.whiten(&self.fit);
            let k = self.fit.model.modes[m].omega / std::f64::consts::TAU;
            let lost = plain.rss.iter().zip(&self.fit.rss).map(|(a, b)| a - b);
            let gain: f64 = lost
                .zip(&after.floors)
                .map(|(lost, floor)| lost / floor.at(k))
                .sum();
            if gain < LAW_GAIN {
                self.fit = plain;
            }
        }
    }
}

/// Whether a trial beats the one held.
fn prefer(
    kind: Kind,
    gain: f64,
    fit: &Fit,
    held_kind: Kind,
    held: f64,
    held_fit: &Fit,
    bound: f64,
) -> bool {
    match (held_kind, kind) {
        // A line that a combination explains by half is that combination, its parents' law being
        // imperfect.
        (Kind::Tone, Kind::Mode) => held < 0.5 * gain,
        // A law needs two numbers, a mode two for each channel besides; a tie is the law's.
        (Kind::Law, Kind::Mode) => held_fit.merit - fit.merit > 2.0 * bound && held < 0.97 * gain,
        _ => gain > held,
    }
}
