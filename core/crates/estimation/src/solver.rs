//! The one descent: a trust region around the best point so far.

use nalgebra::DVector;

use crate::fit::{Edge, Ending, Error, Fit};
use crate::normal::Normal;
use crate::parameter::Parameter;
use crate::problem::{Problem, Slopes};
use crate::quadratic::{Least, Quadratic};
use crate::region::{scaled_slope, step_within};

/// A step counts that gains this share of what was promised (Moré 1978, sec. 3).
const LEAST_KEPT: f64 = 1e-4;
/// Below this share the region shrinks, above the other it grows (Moré 1978, sec. 4).
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// Least and greatest factor by which it shrinks at once (Moré 1978, sec. 4).
const SHRINK: (f64, f64) = (0.1, 0.5);
/// Factor by which it may grow.
const GROW: f64 = 2.0;

/// When a fit is done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Most steps that are tried, those that lead nowhere among them.
    pub most_steps: usize,
    /// A fit has converged where the best step promises less of χ² than this: the square of the
    /// distance to the minimum in standard deviations.
    pub gain: f64,
    /// Or less than this share of χ².
    pub gain_share: f64,
    /// When derivatives are kept for the next step; none: they are new at every point.
    pub keep: Option<Keep>,
}

/// When derivatives are kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Keep {
    /// Where a step gains at least this share of its promise.
    pub share: f64,
    /// Whether a fit may end on kept ones, for a fit that others go on from: where χ² has not fallen
    /// below the same share of what it was at theirs, for those of far away cannot tell what is left
    /// to gain.
    pub to_the_end: bool,
}

impl Default for Options {
    /// A hundred steps to a hundredth of a standard deviation.
    fn default() -> Self {
        Self {
            most_steps: 100,
            gain: 1e-4,
            gain_share: 0.0,
            keep: None,
        }
    }
}

/// How far a fit has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Steps tried.
    pub steps: usize,
    /// χ² of data and priors.
    pub cost: f64,
    /// What the last step gained of it; 0 where it led nowhere.
    pub gained: f64,
    /// What it had promised.
    pub promised: f64,
}

/// Asked after each step whether to stop.
pub type Stop<'a> = dyn Fn(Progress) -> bool + 'a;

/// A fit that nobody stops.
pub const UNSTOPPED: &Stop<'static> = &|_| false;

/// Minimises χ² of data and priors within bounds from a start; a start outside the bounds is put
/// onto them.
///
/// `parameters` and `start` have the order of [`Problem::shape`].
///
/// # Errors
/// [`Error::Count`] and [`Error::Parameter`] for lists that do not fit,
/// [`Error::NoFiniteStart`] where χ² and its derivatives cannot be computed at the start.
pub fn minimise(
    problem: &mut dyn Problem,
    parameters: &[Parameter],
    start: &[f64],
    options: &Options,
    stop: &Stop,
) -> Result<Fit, Error> {
    let total = problem.shape().total();
    for found in [parameters.len(), start.len()] {
        if found != total {
            return Err(Error::Count {
                expected: total,
                found,
            });
        }
    }
    if let Some(place) = parameters.iter().position(|p| !p.is_valid()) {
        return Err(Error::Parameter { place });
    }
    Descent::begin(problem, parameters, start, options)?.run(stop)
}

/// A point and χ² there.
struct Point {
    x: DVector<f64>,
    chi2: f64,
    prior_chi2: f64,
}

impl Point {
    fn cost(&self) -> f64 {
        self.chi2 + self.prior_chi2
    }
}

struct Descent<'a> {
    problem: &'a mut dyn Problem,
    parameters: &'a [Parameter],
    options: &'a Options,
    at: Point,
    normal: Normal,
    /// Squares of the greatest lengths of the Jacobian's columns so far (Moré 1978, sec. 6).
    scale2: DVector<f64>,
    radius: Option<f64>,
    is_new: bool,
    /// χ² where the derivatives were new.
    cost_of_slopes: f64,
    steps: usize,
    evaluations: (usize, usize),
}

/// What became of a step.
enum Outcome {
    Taken { gained: f64, promised: f64 },
    Refused { promised: f64 },
    Ended(Ending),
}

impl<'a> Descent<'a> {
    fn begin(
        problem: &'a mut dyn Problem,
        parameters: &'a [Parameter],
        start: &[f64],
        options: &'a Options,
    ) -> Result<Self, Error> {
        let inside = |(x, p): (&f64, &Parameter)| x.clamp(p.low, p.high);
        let x = DVector::from_iterator(start.len(), start.iter().zip(parameters).map(inside));
        let at = point(problem, parameters, x).ok_or(Error::NoFiniteStart)?;
        let normal = normal(problem, parameters, &at, Slopes::New).ok_or(Error::NoFiniteStart)?;
        Ok(Self {
            scale2: normal.diagonal().map(|d| if d > 0.0 { d } else { 1.0 }),
            problem,
            parameters,
            options,
            cost_of_slopes: at.cost(),
            at,
            normal,
            radius: None,
            is_new: true,
            steps: 0,
            evaluations: (1, 1),
        })
    }

    fn run(mut self, stop: &Stop) -> Result<Fit, Error> {
        loop {
            let (gained, promised) = match self.step() {
                Outcome::Taken { gained, promised } => (gained, promised),
                Outcome::Refused { promised } => (0.0, promised),
                Outcome::Ended(ending) => return Ok(self.ended(ending)),
            };
            let progress = Progress {
                steps: self.steps,
                cost: self.at.cost(),
                gained,
                promised,
            };
            if stop(progress) {
                return Ok(self.ended(Ending::Stopped));
            }
        }
    }

    /// What is too little to count: what the caller says, and the rounding of χ² itself.
    fn enough(&self) -> f64 {
        let rounding = f64::EPSILON.max(self.options.gain_share);
        self.options.gain.max(rounding * self.at.cost().abs())
    }

    fn step(&mut self) -> Outcome {
        let gradient = self.normal.whole_gradient();
        let model = Quadratic {
            normal: &self.normal,
            gradient: &gradient,
            parameters: self.parameters,
            x: &self.at.x,
            scale2: &self.scale2,
        };
        if self.is_level(&model) {
            return self.converged(Ending::Gradient);
        }
        let undamped = model.least(0.0);
        let best = undamped.as_ref().map(|least| model.promise(&least.step));
        if best.is_some_and(|best| best <= self.enough()) {
            return self.converged(Ending::Gain);
        }
        let radius = self
            .radius
            .unwrap_or_else(|| first_radius(&model, undamped.as_ref()));
        let Some(Least { step, .. }) = step_within(&model, undamped, radius) else {
            return Outcome::Ended(Ending::Step);
        };
        let (promised, reach) = (model.promise(&step), model.reach(&step));
        let slope = gradient.dot(&step);
        if promised <= self.enough() {
            return self.converged(if best.is_some() {
                Ending::Step
            } else {
                Ending::Gain
            });
        }
        if self.steps == self.options.most_steps {
            return Outcome::Ended(Ending::Iterations);
        }
        self.steps += 1;
        let to = self.moved(&step);
        let there = self.point(to);
        let gained = there.as_ref().map(|there| self.at.cost() - there.cost());
        self.radius = Some(next_radius(radius, reach, gained, promised, slope));
        match there.zip(gained) {
            Some((there, gained)) if gained >= LEAST_KEPT * promised => {
                self.at = there;
                self.take(gained, promised)
            }
            _ if self.is_new => Outcome::Refused { promised },
            // A kept derivative may be what led astray.
            _ => {
                self.radius = Some(radius);
                match self.renew(Slopes::New) {
                    Some(()) => Outcome::Refused { promised },
                    None => Outcome::Ended(Ending::NoDerivatives),
                }
            }
        }
    }

    fn point(&mut self, x: DVector<f64>) -> Option<Point> {
        self.evaluations.0 += 1;
        point(self.problem, self.parameters, x)
    }

    /// Normal equations where a step has led.
    fn take(&mut self, gained: f64, promised: f64) -> Outcome {
        let slopes = match self.options.keep {
            Some(keep) if gained >= keep.share * promised => Slopes::Kept,
            _ => Slopes::New,
        };
        match self.renew(slopes) {
            Some(()) => Outcome::Taken { gained, promised },
            None => Outcome::Ended(Ending::NoDerivatives),
        }
    }

    /// The end, if the derivatives may be those of the end; otherwise new ones.
    fn converged(&mut self, ending: Ending) -> Outcome {
        let near =
            |keep: Keep| keep.to_the_end && self.at.cost() >= keep.share * self.cost_of_slopes;
        if self.is_new || self.options.keep.is_some_and(near) {
            return Outcome::Ended(ending);
        }
        match self.renew(Slopes::New) {
            Some(()) => Outcome::Taken {
                gained: 0.0,
                promised: 0.0,
            },
            None => Outcome::Ended(Ending::NoDerivatives),
        }
    }

    fn renew(&mut self, slopes: Slopes) -> Option<()> {
        self.normal = normal(self.problem, self.parameters, &self.at, slopes)?;
        self.is_new = slopes == Slopes::New;
        if self.is_new {
            self.evaluations.1 += 1;
            self.cost_of_slopes = self.at.cost();
        }
        self.scale2 = self.scale2.zip_map(&self.normal.diagonal(), f64::max);
        Some(())
    }

    /// Where a step leads; bounds are met exactly.
    fn moved(&self, step: &DVector<f64>) -> DVector<f64> {
        let inside = |k: usize| {
            let (x, p) = (self.at.x[k], &self.parameters[k]);
            if step[k] == p.low - x {
                p.low
            } else if step[k] == p.high - x {
                p.high
            } else {
                (x + step[k]).clamp(p.low, p.high)
            }
        };
        DVector::from_fn(step.len(), |k, _| inside(k))
    }

    /// Whether the residuals stand at right angles to every column that is free, to rounding.
    fn is_level(&self, model: &Quadratic) -> bool {
        let (pressed, size) = (model.pressed(), self.normal.diagonal());
        let level = |k: usize| {
            let length = (size[k] * self.at.cost().max(0.0)).sqrt();
            model.gradient[k].abs() <= f64::EPSILON * length
        };
        (0..pressed.len()).all(|k| pressed[k] || level(k))
    }

    fn ended(self, ending: Ending) -> Fit {
        let gradient = self.normal.whole_gradient();
        let edge = |k: usize| {
            let parameter = &self.parameters[k];
            let side = parameter.side(self.at.x[k])?;
            (!parameter.is_fixed()).then(|| Edge {
                place: k,
                side,
                is_pressed: side.is_pressed(gradient[k]),
            })
        };
        Fit {
            edges: (0..gradient.len()).filter_map(edge).collect(),
            x: self.at.x.as_slice().to_vec(),
            chi2: self.at.chi2,
            prior_chi2: self.at.prior_chi2,
            normal: self.normal,
            ending,
            steps: self.steps,
            evaluations: self.evaluations,
            parameters: self.parameters.to_vec(),
        }
    }
}

/// As far as the derivatives point; where they point nowhere to rounding, as far as the model falls
/// along its steepest slope (A. R. Conn, N. I. M. Gould, Ph. L. Toint, *Trust-Region Methods*
/// (2000), sec. 17.2).
fn first_radius(model: &Quadratic, undamped: Option<&Least>) -> f64 {
    if let Some(least) = undamped {
        return model.reach(&least.step);
    }
    let down = model.gradient.component_div(model.scale2);
    let bend = down.dot(&model.normal.times(&down));
    let radius = scaled_slope(model).powi(3) / bend;
    // Where it bends down there is no least point: any reach will do.
    if radius.is_finite() && radius > 0.0 {
        radius
    } else {
        scaled_slope(model)
    }
}

/// Moré 1978, sec. 4: a refused region shrinks to where a parabola through both ends has its
/// least point.
fn next_radius(radius: f64, reach: f64, gained: Option<f64>, promised: f64, slope: f64) -> f64 {
    let Some(gained) = gained else {
        return SHRINK.0 * reach.min(radius);
    };
    let kept = gained / promised;
    if kept < POOR {
        // χ² along the step: slope 2·slope at its beginning, lower by `gained` at its end.
        let least = slope / (2.0 * slope + gained);
        let shrink = if gained >= 0.0 { SHRINK.1 } else { least };
        return reach.min(radius) * shrink.clamp(SHRINK.0, SHRINK.1);
    }
    if kept > GOOD {
        radius.max(GROW * reach)
    } else {
        radius
    }
}

fn point(problem: &mut dyn Problem, parameters: &[Parameter], x: DVector<f64>) -> Option<Point> {
    let chi2 = problem.chi2(x.as_slice()).filter(|c| c.is_finite())?;
    let prior = |(x, p): (&f64, &Parameter)| p.prior.map_or(0.0, |(m, u)| ((x - m) / u).powi(2));
    let prior_chi2 = x.iter().zip(parameters).map(prior).sum();
    Some(Point {
        x,
        chi2,
        prior_chi2,
    })
}

fn normal(
    problem: &mut dyn Problem,
    parameters: &[Parameter],
    at: &Point,
    slopes: Slopes,
) -> Option<Normal> {
    let mut normal = problem.normal(at.x.as_slice(), slopes)?;
    for (k, p) in parameters.iter().enumerate() {
        if let Some((mean, u)) = p.prior {
            normal.add_prior(k, at.x[k] - mean, u);
        }
    }
    normal.is_finite().then_some(normal)
}
