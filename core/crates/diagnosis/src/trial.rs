//! A cause tried: fitted in full beside those that were taken before.

use gyradius_base::error::Result;

use super::evidence::gain;
use super::fitted_swing::HORIZONS_S;
use super::fitting::{CONVERGED_SHARE, Derivatives, FAR, Fitted, Pace};
use super::found::{Found, STILL_GAINS, Tried};
use super::look::Look;
use super::point::{Cause, Model, Point};
use super::verdict::NOT_TOLD;
use super::white::Left;

/// Shares of the way to where the first look points, from which a full fit may begin.
const SHARES: [f64; 5] = [1.0, 0.5, 0.2, 0.05, 0.01];
/// Shares of a cause's strengths, and of what each swing has of it by itself, that a fit begins
/// with where the whole led astray.
const GENTLE: [f64; 3] = [0.3, 0.1, 0.03];
/// A fit that used up its steps short of what a look promised goes on so often: what the base has bent
/// itself to is given up in small steps.
const MORE: usize = 4;
/// So many forms of a cause are fitted near the data.
const FORMS: usize = 3;
/// A form that leaves more than so many times what the best does (χ²) over a part of the recordings
/// has lost.
const LOST: f64 = 4.0;
/// Over a part of the recordings no longer than this others are still on their ways: the one that
/// was worst after it was best after the next.
const TOO_SHORT_S: f64 = HORIZONS_S[0];
/// A fit that after some steps is still so far (share of what the best gains) behind the best is
/// given up.
const HOPELESS: f64 = 0.5;
/// … after so many.
const HOPELESS_AFTER: usize = 3;
/// One that at its pace would end further behind (χ²) than this is given up as well …
const BEHIND: f64 = 20.0;
/// … after so many steps, two of which tell the pace.
const PACED_AFTER: usize = 1;

impl Found<'_> {
    /// Fits a cause in full; `None` where no start leads anywhere.
    pub fn fit(&self, look: &Look, best: f64, of_many: bool) -> Option<Tried> {
        let forms: Vec<&Look> = [look].into_iter().chain(&look.others).collect();
        let is_far = self.fitted.rms() > FAR;
        let from_afar = is_far
            .then(|| self.fit_from_afar(&forms, best, of_many))
            .flatten();
        let to_beat = from_afar
            .as_ref()
            .map_or(best, |tried| tried.fitted.cost.min(best));
        // Beside one that leaves next to nothing, starts that lead elsewhere are given up in any
        // case.
        let takes_all = from_afar
            .as_ref()
            .is_some_and(|tried| tried.left.is_next_to_nothing(&self.left));
        let nearby = if takes_all {
            None
        } else {
            self.fit_nearby(&forms, to_beat, of_many)
        };
        from_afar
            .into_iter()
            .chain(nearby)
            .max_by(|a, b| a.gain.total_cmp(&b.gain))
    }

    /// The same for a cause without rivals: a fit that used up its steps on the way goes on.
    pub fn fit_to_its_end(&self, look: &Look) -> Option<Tried> {
        let tried = self.fit(look, f64::INFINITY, false)?;
        let end = tried
            .is_on_its_way()
            .then(|| self.led_on(&tried, tried.gain, false));
        end.flatten().or(Some(tried))
    }

    /// The model with what was looked at beside those taken before.
    fn with(&self, look: &Look, of_many: bool) -> Model<'_> {
        Model {
            of_many,
            ..self.model.with(&look.cause)
        }
    }

    /// Near the data: from the leading forms of a cause, which end in valleys of their own. The
    /// best, with the others' ends.
    fn fit_nearby(&self, forms: &[&Look], best: f64, of_many: bool) -> Option<Tried> {
        let forms = &forms[..forms.len().min(FORMS)];
        let mut ends: Vec<Tried> = Vec::new();
        for form in forms {
            let to_beat = least_cost(&ends, best);
            let model = self.with(form, of_many);
            let Some(start) = self.near(form, &model) else {
                continue;
            };
            let known = self.fitted.jacobians.iter().enumerate();
            let known = known.map(|(s, known)| model.widened(known, &start, s));
            let known = known.collect::<Result<Vec<_>>>();
            let known = known.map_or(Derivatives::Taken, Derivatives::Known);
            let hopeless = |pace: Pace| self.is_hopeless(pace, to_beat);
            let mut fitted = model.fit_with(&start, known, CONVERGED_SHARE, &hopeless);
            for _ in 0..MORE {
                let Some(short) = fitted.as_ref().ok().filter(|end| self.is_short(end, form))
                else {
                    break;
                };
                fitted = model.fit(&short.point, &hopeless);
            }
            ends.extend(
                fitted
                    .ok()
                    .and_then(|fitted| self.weighed_up(&form.cause, model, fitted)),
            );
        }
        // All that end worse than without the cause began too strong.
        if ends.iter().all(|end| end.fitted.cost > self.fitted.cost) {
            ends.extend(self.fit_gently(forms, best, of_many));
        }
        ends.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        // Nothing begins at the others.
        let mut ends = ends.into_iter();
        let first = ends.next()?;
        let others = ends.map(|end| Tried {
            fitted: Fitted {
                jacobians: vec![],
                ..end.fitted
            },
            ..end
        });
        Some(Tried {
            ends: others.collect(),
            ..first
        })
    }

    /// Whether a fit used up its steps on the way to what a look promised.
    fn is_short(&self, end: &Fitted, look: &Look) -> bool {
        let gained = 0.5 * (self.fitted.cost - end.cost);
        end.last_gained >= STILL_GAINS && gained + NOT_TOLD < look.gain
    }

    /// From a cause alone as looks at its forms have it, but weaker: from the best of several such
    /// starts.
    fn fit_gently(&self, forms: &[&Look], best: f64, of_many: bool) -> Option<Tried> {
        let starts = forms.iter().filter_map(|form| {
            let model = self.with(form, of_many);
            let (cost, start) = nearest(&model, self.gentle_starts(form)?)?;
            Some((cost, start, model, &form.cause))
        });
        let (_, start, model, cause) = starts.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let fitted = model
            .fit(&start, &|pace| self.is_hopeless(pace, best))
            .ok()?;
        self.weighed_up(cause, model, fitted)
    }

    /// A cause alone with shares of what a look sees of it.
    fn gentle_starts(&self, look: &Look) -> Option<[Point; 3]> {
        let swings = self.model.base.swings.len();
        let (begin, seen) = (
            look.cause.start(swings),
            look.start(&self.model, &self.fitted, 1.0),
        );
        let seen = seen.causes.last()?;
        let grows = look
            .cause
            .expanded(swings)
            .into_iter()
            .map(|(p, own)| p.is_strength || own.is_some());
        let grows: Vec<bool> = grows.collect();
        Some(GENTLE.map(|share| {
            let weaker =
                |k: usize| begin[k] + if grows[k] { share } else { 1.0 } * (seen[k] - begin[k]);
            let mut point = self.fitted.point.clone();
            point.causes.push((0..seen.len()).map(weaker).collect());
            point
        }))
    }

    /// So far from linear that the way there leads over short parts of the recordings, where the
    /// forms of a cause part: what has not lost goes on, and of that after all but the first the
    /// better half.
    fn fit_from_afar(&self, forms: &[&Look], best: f64, of_many: bool) -> Option<Tried> {
        let mut led: Vec<Led> = forms
            .iter()
            .map(|form| Led::begun(self, form, of_many))
            .collect();
        for horizon_s in HORIZONS_S {
            led.iter_mut().for_each(|form| form.go_on(horizon_s));
            led.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let least = led.first().map_or(f64::INFINITY, |best| best.cost);
            led.retain(|form| form.cost <= LOST * least);
            if horizon_s > TOO_SHORT_S {
                led.truncate(led.len().div_ceil(2));
            }
        }
        let Led {
            cause,
            model,
            point,
            ..
        } = led.into_iter().next()?;
        let fitted = model
            .fit(&point, &|pace| self.is_hopeless(pace, best))
            .ok()?;
        self.weighed_up(cause, model, fitted)
    }

    /// Whether a fit with one more cause is left far behind a cost, or on its way to be.
    fn is_hopeless(&self, pace: Pace, best: f64) -> bool {
        let behind = HOPELESS * (self.fitted.cost - best).max(0.0) + BEHIND;
        pace.steps > HOPELESS_AFTER && (pace.cost > best + behind || cannot_reach(best, pace))
    }

    /// The start of a fit on the way to where a look leads. Where that is nowhere better than
    /// without the cause, the look saw something alike, and what it says of all the rest does not
    /// hold: the cause alone is then as it has it.
    fn near(&self, look: &Look, model: &Model) -> Option<Point> {
        let starts = SHARES.map(|share| look.start(&self.model, &self.fitted, share));
        let whole = starts[0].causes.last()?.clone();
        let (cost, start) = nearest(model, starts)?;
        if cost <= self.fitted.cost {
            return Some(start);
        }
        let mut start = self.fitted.point.clone();
        start.causes.push(whole);
        Some(start)
    }

    /// Where a fit over longer and longer parts begins: where the look leads. Far from the data the
    /// base has bent itself to whatever helped, and the way begins where the swings alone lead,
    /// without the cause; one whose law has no strength to begin at nothing with (what moves inside
    /// starts in proportion to its mass) as the look has it.
    fn afar(&self, look: &Look, model: &Model) -> Point {
        let seen = look.start(&self.model, &self.fitted, 1.0);
        let mut start = self.begin.clone();
        start.causes = if look.cause.look.is_some() {
            seen.causes
        } else {
            self.fitted.point.causes.clone()
        };
        start.causes.resize_with(model.causes.len(), || {
            look.cause.start(model.base.swings.len())
        });
        start
    }

    /// A fitted model with one more cause, weighed against that without it.
    pub fn weighed_up(&self, cause: &Cause, model: Model, fitted: Fitted) -> Option<Tried> {
        let gain = gain(&self.fitted, &fitted)?;
        let left = Left::of(&model, &fitted.point).ok()?;
        let from = self.fitted.point.clone();
        Some(Tried {
            cause: cause.clone(),
            causes: model.causes,
            fitted,
            gain,
            left,
            from,
            ends: vec![],
        })
    }

    /// The model of what was tried, with derivatives over short steps.
    pub fn fine(&self, tried: &Tried) -> Model<'_> {
        Model {
            causes: tried.causes.clone(),
            ..self.model.precise()
        }
    }

    /// What was tried, with its fit led to its end with all derivatives. It is left where it stands
    /// once it cannot gain as much as the best of the others.
    pub fn led_on(&self, tried: &Tried, best_gain: f64, of_many: bool) -> Option<Tried> {
        let model = Model {
            of_many,
            ..self.fine(tried).whole()
        };
        // What the evidence lacks is half of what χ² must come down by.
        let wanted = tried.fitted.cost - 2.0 * (best_gain - tried.gain).max(0.0);
        let hopeless = |pace: Pace| pace.steps >= PACED_AFTER && cannot_reach(wanted, pace);
        let fitted = model.fit(&tried.fitted.point, &hopeless).ok()?;
        // Where a further cause is looked for beside it, derivatives are taken apart again.
        let model = Model {
            causes: tried.causes.clone(),
            ..model
        };
        let ends = tried.ends.clone();
        self.weighed_up(&tried.cause, model, fitted)
            .map(|led| Tried { ends, ..led })
    }
}

/// A form of a cause on its way over longer and longer parts of the recordings.
struct Led<'a> {
    cause: &'a Cause,
    model: Model<'a>,
    start: Point,
    point: Point,
    cost: f64,
}

impl<'a> Led<'a> {
    fn begun(found: &'a Found, form: &'a Look, of_many: bool) -> Self {
        let model = found.with(form, of_many);
        let start = found.afar(form, &model);
        Self {
            cause: &form.cause,
            model,
            point: start.clone(),
            start,
            cost: f64::INFINITY,
        }
    }

    fn go_on(&mut self, horizon_s: f64) {
        (self.point, self.cost) = self.model.over_first(horizon_s, &self.point, &self.start);
    }
}

/// The least χ² of those tried, if it is below a limit.
pub fn least_cost(tried: &[Tried], limit: f64) -> f64 {
    tried.iter().map(|t| t.fitted.cost).fold(limit, f64::min)
}

/// The start that is nearest to the data, and its cost; one that cannot be simulated is the
/// furthest.
fn nearest(model: &Model, starts: impl IntoIterator<Item = Point>) -> Option<(f64, Point)> {
    let costs = starts
        .into_iter()
        .map(|start| (model.cost(&start).unwrap_or(f64::INFINITY), start));
    costs.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Whether a fit would end above a cost, were all steps that are left as good as the better of its
/// last two.
fn cannot_reach(cost: f64, pace: Pace) -> bool {
    pace.cost - pace.steps_left as f64 * pace.gained > cost + BEHIND
}
