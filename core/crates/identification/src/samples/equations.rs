//! The least-squares problem of the samples of one swing or of several at once: one body and one
//! set of dimensions for all, and for each swing what is its own.
//!
//! # Conventions
//! The session's free parameters are shared, a swing's own numbers are those of its block. While a
//! fit runs, the phone's turn and place count from where the fit began (`turn`).

use nalgebra::{DMatrix, Matrix6};

use super::linearise::{Linearised, chi2, readings};
use super::model::{Statement, SwingModel};
use super::scene::{OWN, Own, PLACE};
use crate::names::InputKind;
use crate::parameters::{Layout, Role};
use crate::suspects::slip;
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_estimation::{
    Ending, Keep, Normal, Options, Parameter, Problem, Shape, Slopes, UNSTOPPED, minimise,
};

/// Most steps of a fit.
const MOST_STEPS: usize = 60;
/// Derivatives cost some thirty times what a motion does: they are kept while a step gains this
/// share of what they promised.
const KEEP: Keep = Keep {
    share: 0.5,
    to_the_end: true,
};

/// What is fitted.
pub struct Fitting<'a> {
    pub models: Vec<&'a SwingModel<'a>>,
    /// What is known of the session's parameters beside their priors.
    pub known: &'a [Statement],
}

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub enum Enough {
    /// A fit that another goes on from.
    Nearly,
    Converged,
}

impl Enough {
    /// Of a fit to so many readings.
    fn options(self, readings: usize) -> Options {
        let gain_share = match self {
            Enough::Nearly => 1e-2,
            // A tenth of a standard deviation, by the noise that the fit leaves: what a swing says of
            // the session's parameters is led on from there by one more step.
            Enough::Converged => 1e-2 / readings.max(1) as f64,
        };
        Options {
            most_steps: MOST_STEPS,
            gain: 0.0,
            gain_share,
            keep: Some(KEEP),
        }
    }
}

/// What a fit may move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moves {
    /// The swings' own numbers, the session's held.
    Own,
    /// And the body's, the stated dimensions held: a short record says little of them.
    Body,
    /// All that may move.
    All,
    /// The same, the length of the lines within what a slip of the tape may be.
    Opened,
}

/// The session's parameters, and what belongs to each swing.
#[derive(Debug, Clone)]
pub struct Point {
    pub x: Vec<f64>,
    pub owns: Vec<Own>,
    /// χ² of samples, priors and what is known.
    pub cost: f64,
}

impl Point {
    pub fn new(x: &[f64], owns: Vec<Own>) -> Self {
        Self {
            x: x.to_vec(),
            owns,
            cost: f64::INFINITY,
        }
    }
}

/// The session's parameters in play.
pub fn free(layout: &Layout) -> Vec<usize> {
    (0..layout.parameters.len())
        .filter(|i| layout.parameters[*i].is_free_in_motion())
        .collect()
}

impl Fitting<'_> {
    fn layout(&self) -> &Layout {
        self.models[0].setup.layout
    }

    /// The best point near a start, and derivatives from near it.
    pub fn optimised(
        &self,
        at: Point,
        moves: Moves,
        horizon_s: f64,
        enough: Enough,
    ) -> Result<(Point, Vec<Linearised>)> {
        let each = self.models.iter();
        let count = each.map(|model| readings(&model.samples, horizon_s)).sum();
        let mut equations = Equations::about(self, at, horizon_s);
        let (parameters, start) = equations.parameters(moves);
        let options = enough.options(count);
        let found = minimise(&mut equations, &parameters, &start, &options, UNSTOPPED)
            .ok()
            .filter(|fit| fit.ending != Ending::NoDerivatives)
            .ok_or_else(|| Error::no_result("fit of the motion", "it cannot be computed"))?;
        let point = Point {
            cost: found.cost(),
            ..equations.point(&found.x)
        };
        Ok((point, equations.slopes))
    }
}

struct Equations<'a> {
    fitting: &'a Fitting<'a>,
    free: Vec<usize>,
    /// Where the fit began, turns folded.
    start: Point,
    horizon_s: f64,
    /// The last derivatives, by turns about where they were taken.
    slopes: Vec<Linearised>,
    /// The phone's place and those turns by the numbers of the fit.
    turns: Vec<Matrix6<f64>>,
    /// Where the last motions are, and what they leave of each swing's blocks.
    left: (Vec<f64>, Vec<Vec<Vec3>>),
}

impl<'a> Equations<'a> {
    fn about(fitting: &'a Fitting<'a>, mut start: Point, horizon_s: f64) -> Self {
        start.owns = start.owns.into_iter().map(Own::folded).collect();
        Self {
            free: free(fitting.layout()),
            fitting,
            start,
            horizon_s,
            slopes: vec![],
            turns: vec![],
            left: (vec![], vec![]),
        }
    }

    /// Priors of all that is fitted, what may not move fixed; and where it begins.
    fn parameters(&self, moves: Moves) -> (Vec<Parameter>, Vec<f64>) {
        let of_session = self.free.iter().map(|i| {
            let (known, at) = (&self.fitting.layout().parameters[*i], self.start.x[*i]);
            let u = match moves {
                Moves::Opened if known.name.kind == InputKind::LineLength => {
                    slip(known).unwrap_or(known.prior.u)
                }
                _ => known.prior.u,
            };
            let prior = Parameter::FREE.with_prior(known.prior.value, u);
            let may_move = match moves {
                Moves::All | Moves::Opened => true,
                Moves::Body => known.role == Role::Unknown,
                Moves::Own => false,
            };
            (if may_move { prior } else { prior.fixed(at) }, at)
        });
        let of_swing = |own: &Own| {
            let priors = Own::prior_u().map(|u| Parameter::FREE.with_prior(0.0, u));
            priors.into_iter().zip(own.values)
        };
        of_session
            .chain(self.start.owns.iter().flat_map(of_swing))
            .unzip()
    }

    fn point(&self, x: &[f64]) -> Point {
        let mut point = self.start.clone();
        let (shared, owns) = x.split_at(self.free.len());
        for (i, value) in self.free.iter().zip(shared) {
            point.x[*i] = *value;
        }
        for (own, values) in point.owns.iter_mut().zip(owns.chunks(OWN)) {
            own.values.copy_from_slice(values);
        }
        point
    }

    /// What the motions at a point leave; none where one cannot be simulated.
    fn left(&mut self, x: &[f64]) -> Option<&[Vec<Vec3>]> {
        if self.left.0 != x {
            let (point, horizon_s) = (self.point(x), self.horizon_s);
            let each = self.fitting.models.iter().zip(&point.owns);
            let left = each.map(|(model, own)| {
                let motion = model.simulated(&point.x, own, horizon_s)?;
                Ok(motion.misfits(&model.samples, horizon_s))
            });
            self.left = (x.to_vec(), left.collect::<Result<_>>().ok()?);
        }
        Some(&self.left.1)
    }

    /// Derivatives at a point.
    fn linearise(&mut self, x: &[f64]) -> Result<()> {
        let point = self.point(x);
        self.turns = point.owns.iter().map(Own::folding_slopes).collect();
        let owns = point.owns.into_iter().map(Own::folded);
        let each = self.fitting.models.iter().zip(owns);
        self.slopes = each
            .map(|(model, own)| {
                let at = (&point.x[..], &own);
                Linearised::at(&model.setup, at, &self.free, &model.samples, self.horizon_s)
            })
            .collect::<Result<_>>()?;
        Ok(())
    }
}

impl Problem for Equations<'_> {
    fn shape(&self) -> Shape {
        Shape::new(self.free.len(), &vec![OWN; self.fitting.models.len()])
    }

    fn chi2(&mut self, x: &[f64]) -> Option<f64> {
        let (fitting, horizon_s) = (self.fitting, self.horizon_s);
        let left = self.left(x)?.iter().zip(&fitting.models);
        let of_samples: f64 = left
            .map(|(left, model)| chi2(left, &model.samples, horizon_s))
            .sum();
        let session = self.point(x).x;
        let known = fitting.known.iter();
        Some(of_samples + known.map(|s| s.misfit(&session).powi(2)).sum::<f64>())
    }

    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal> {
        if slopes == Slopes::New {
            self.linearise(x).ok()?;
        }
        self.left(x)?;
        let mut normal = Normal::zero(&self.shape());
        for (s, left) in self.left.1.iter().enumerate() {
            let (slopes, place) = (&self.slopes[s], self.free.len() + PLACE);
            let mut by_turn = DMatrix::identity(slopes.matrix.nrows(), slopes.matrix.ncols());
            by_turn
                .view_mut((place, place), (6, 6))
                .copy_from(&self.turns[s]);
            let gradient = by_turn.tr_mul(&slopes.gradient(left));
            normal.add(
                s,
                &(by_turn.transpose() * &slopes.matrix * &by_turn),
                &-gradient,
            );
        }
        let session = self.point(x).x;
        for statement in self.fitting.known {
            let row = statement.by_place(&self.free);
            for (k, a) in &row {
                normal.gradient[*k] -= a * statement.misfit(&session);
                row.iter()
                    .for_each(|(l, b)| normal.information[(*k, *l)] += a * b);
            }
        }
        Some(normal)
    }
}
