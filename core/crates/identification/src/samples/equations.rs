//! The least-squares problem of the samples of one swing or of several at once: one body and one
//! set of dimensions for all, and for each swing what is its own.
//!
//! # Conventions
//! The session's free parameters are shared, a swing's own numbers are those of its block. While a
//! fit runs, the phone's turn counts from where the fit began.

use nalgebra::DMatrix;

use super::linearise::{Linearised, Simulated};
use super::model::{Statement, SwingModel};
use super::scene::{OWN, Own, TURN};
use super::turn::turn_slopes;
use crate::parameters::{Layout, Role};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Mat3, Vec3};
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
    fn options(self) -> Options {
        let (gain, gain_share) = match self {
            Enough::Nearly => (0.0, 1e-2),
            // A hundredth of a standard deviation.
            Enough::Converged => (1e-4, 0.0),
        };
        Options {
            most_steps: MOST_STEPS,
            gain,
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
    All,
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
        let mut equations = Equations::about(self, at, horizon_s);
        let (parameters, start) = equations.parameters(moves);
        let options = enough.options();
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
    /// Those turns by the turns of the fit.
    turns: Vec<Mat3>,
    /// The last motions, and where they are.
    motions: (Vec<f64>, Vec<Simulated>),
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
            motions: (vec![], vec![]),
        }
    }

    /// Priors of all that is fitted, what may not move fixed; and where it begins.
    fn parameters(&self, moves: Moves) -> (Vec<Parameter>, Vec<f64>) {
        let of_session = self.free.iter().map(|i| {
            let (known, at) = (&self.fitting.layout().parameters[*i], self.start.x[*i]);
            let prior = Parameter::FREE.with_prior(known.prior.value, known.prior.u);
            let may_move = match moves {
                Moves::All => true,
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

    /// The motions at a point; none where one cannot be simulated.
    fn motions(&mut self, x: &[f64]) -> Option<&[Simulated]> {
        if self.motions.0 != x {
            let point = self.point(x);
            let each = self.fitting.models.iter().zip(&point.owns);
            let motions = each.map(|(model, own)| model.simulated(&point.x, own, self.horizon_s));
            self.motions = (x.to_vec(), motions.collect::<Result<_>>().ok()?);
        }
        Some(&self.motions.1)
    }

    /// Derivatives at a point.
    fn linearise(&mut self, x: &[f64]) -> Result<()> {
        let point = self.point(x);
        let turn = |own: &Own| turn_slopes(Vec3::from_column_slice(&own.values[TURN..TURN + 3]));
        self.turns = point.owns.iter().map(turn).collect();
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
        let motions = self.motions(x)?.iter().zip(&fitting.models);
        let of_samples: f64 = motions
            .map(|(motion, model)| motion.chi2(&model.samples, horizon_s))
            .sum();
        let session = self.point(x).x;
        let known = fitting.known.iter();
        Some(of_samples + known.map(|s| s.misfit(&session).powi(2)).sum::<f64>())
    }

    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal> {
        if slopes == Slopes::New {
            self.linearise(x).ok()?;
        }
        self.motions(x)?;
        let mut normal = Normal::zero(&self.shape());
        let each = self.motions.1.iter().zip(&self.fitting.models);
        for (s, (motion, model)) in each.enumerate() {
            let (slopes, turn) = (&self.slopes[s], self.free.len() + TURN);
            let mut by_turn = DMatrix::identity(slopes.matrix.nrows(), slopes.matrix.ncols());
            by_turn
                .view_mut((turn, turn), (3, 3))
                .copy_from(&self.turns[s]);
            let gradient = by_turn.tr_mul(&slopes.gradient(motion, &model.samples));
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
