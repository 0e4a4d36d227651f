//! A cause tried: fitted in full beside those that were taken before.

use crate::error::Result;

use super::evidence::gain;
use super::fitting::{CONVERGED_SHARE, Derivatives, FAR, Fitted, Pace};
use super::look::Look;
use super::point::{Cause, Model, Point};
use super::search::Found;
use super::white::Left;

/// Shares of the way to where the first look points, from which a full fit may begin.
const SHARES: [f64; 5] = [1.0, 0.5, 0.2, 0.05, 0.01];
/// A fit that after some steps is still so far (share of what the best gains) behind the best is given up.
const HOPELESS: f64 = 0.5;
/// … after so many.
const HOPELESS_AFTER: usize = 3;
/// One that at its pace would end further behind (χ²) than this is given up as well …
const BEHIND: f64 = 20.0;
/// … after so many steps, two of which tell the pace.
const PACED_AFTER: usize = 1;
/// A fit whose last step gained more of χ² than this has not come to its end.
const STILL_GAINS: f64 = 1.0;

/// A cause fitted in full beside those taken before.
#[derive(Clone)]
pub struct Tried {
    pub cause: Cause,
    /// Those taken before, and this one.
    pub causes: Vec<Cause>,
    pub fitted: Fitted,
    /// Of the logarithm of the evidence, over the model without it.
    pub gain: f64,
    /// What is left, χ² beyond noise.
    pub left: Left,
    /// Where it was looked for.
    pub from: Point,
}

impl Tried {
    /// Whether its fit used up its steps on the way.
    pub fn is_on_its_way(&self) -> bool {
        self.fitted.last_gained >= STILL_GAINS
    }
}

impl Found<'_> {
    /// Fits a cause in full; `None` where no start leads anywhere.
    pub fn fit(&self, look: &Look, best: f64, of_many: bool) -> Option<Tried> {
        let behind = HOPELESS * (self.fitted.cost - best).max(0.0) + BEHIND;
        let hopeless = |pace: Pace| {
            pace.steps > HOPELESS_AFTER && (pace.cost > best + behind || cannot_reach(best, pace))
        };
        let model = Model { of_many, ..self.model.with(&look.cause) };
        if let Some(start) = self.near(look, &model) {
            let known = model.each(|s| model.widened(&self.fitted.jacobians[s], &start, s));
            let known = known.into_iter().collect::<Result<Vec<_>>>();
            let known = known.map_or(Derivatives::Taken, Derivatives::Known);
            let fitted = model.fit_with(&start, known, CONVERGED_SHARE, &hopeless).ok()?;
            return self.weighed_up(&look.cause, model, fitted);
        }
        // So far from linear that the way there leads over short parts of the recordings, where the forms of a cause part.
        let led = [look].into_iter().chain(&look.others).filter_map(|form| {
            let model = Model { of_many, ..self.model.with(&form.cause) };
            let (point, cost) = model.grown(&self.afar(form, &model)).ok()?;
            Some((cost, &form.cause, model, point))
        });
        let (_, cause, model, point) = led.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let fitted = model.fit(&point, &hopeless).ok()?;
        self.weighed_up(cause, model, fitted)
    }

    /// The start of a cause's fit from where its look leads, if that is better than without the cause.
    fn near(&self, look: &Look, model: &Model) -> Option<Point> {
        if self.fitted.rms() > FAR {
            return None;
        }
        let starts = SHARES.map(|share| look.start(&self.model, &self.fitted, share));
        let costs = starts.into_iter().map(|start| (model.cost(&start).unwrap_or(f64::INFINITY), start));
        let (cost, start) = costs.min_by(|a, b| a.0.total_cmp(&b.0))?;
        (cost <= self.fitted.cost).then_some(start)
    }

    /// Where a fit over longer and longer parts begins: where the look leads. Far from the data the base has bent itself to whatever
    /// helped, and the way begins where the swings alone lead, without the cause; one whose law has no strength to begin at nothing with
    /// (what moves inside starts in proportion to its mass) as the look has it.
    fn afar(&self, look: &Look, model: &Model) -> Point {
        let seen = look.start(&self.model, &self.fitted, 1.0);
        if self.fitted.rms() <= FAR {
            return seen;
        }
        let mut start = self.begin.clone();
        start.causes = if look.cause.look.is_some() { seen.causes } else { self.fitted.point.causes.clone() };
        start.causes.resize_with(model.causes.len(), || look.cause.start(model.base.swings.len()));
        start
    }

    /// A fitted model with one more cause, weighed against that without it.
    pub fn weighed_up(&self, cause: &Cause, model: Model, fitted: Fitted) -> Option<Tried> {
        let gain = gain(&self.fitted, &fitted, cause, model.base.swings.len())?;
        let left = Left::of(&model, &fitted.point).ok()?;
        let from = self.fitted.point.clone();
        Some(Tried { cause: cause.clone(), causes: model.causes, fitted, gain, left, from })
    }

    /// What was tried, with its fit led to its end: where that used up its steps on the way, or where derivatives were coarse, or in a close
    /// race taken apart. What ends on the way with derivatives taken apart needs all of them. It is left where it stands once it cannot gain
    /// as much as the best of the others.
    pub fn led_on(&self, tried: &Tried, best_gain: f64, (of_many, is_close): (bool, bool)) -> Option<Tried> {
        let mut model = Model { causes: tried.causes.clone(), fine: true, of_many, ..self.model.clone() };
        let needs_all = tried.is_on_its_way() || model.is_coarse() || (is_close && model.is_apart());
        if !needs_all {
            return None;
        }
        model.causes.iter_mut().for_each(|cause| cause.apart = false);
        // What the evidence lacks is half of what χ² must come down by.
        let wanted = tried.fitted.cost - 2.0 * (best_gain - tried.gain).max(0.0);
        let hopeless = |pace: Pace| pace.steps >= PACED_AFTER && cannot_reach(wanted, pace);
        let fitted = model.fit(&tried.fitted.point, &hopeless).ok()?;
        // Where a further cause is looked for beside it, derivatives are taken apart again.
        let model = Model { causes: tried.causes.clone(), ..model };
        self.weighed_up(&tried.cause, model, fitted)
    }
}

/// Whether a fit would end above a cost, were all steps that are left as good as the better of its last two.
fn cannot_reach(cost: f64, pace: Pace) -> bool {
    pace.cost - pace.steps_left as f64 * pace.gained > cost + BEHIND
}
