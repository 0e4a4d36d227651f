//! The joint estimate: one weighted least-squares solution from everything in the session.
//!
//! Observed periods and angles and stated figures are rows of one system; the covariance of the
//! solution is the GUM's law of propagation (JCGM 100, 5.2) for a linearised measurement function,
//! correlations kept.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF};

use gyradius_base::error::{Error, Result};
use gyradius_estimation::{
    Block, ByRows, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted, minimise,
};
use gyradius_recording::{InclineAngle, ModeName, Quantity, Session, Swing};

use super::correlated::Correlated;
use super::names::{Input, InputKind};
use super::parameters::{
    Layout, Reading, Role, SwingIndex, incline_parts, incline_slopes_deg, moved_key,
};
use super::samples::Statement;
use super::theory::{incline_angle_deg, swing_periods};

/// Chance of widening the uncertainties of a consistent session by the Birge ratio.
const BIRGE_FALSE_ALARM: f64 = 1e-3;
const MOST_STEPS: usize = 60;
/// A step that promises less of χ² than this, or less than this share of it, is below a millionth
/// of a standard uncertainty, where periods are computed to no more digits.
const ROUNDING: f64 = 1e-12;
/// A shift stated as exact is good to this, m: the thickness of a line.
const LEAST_MOVED_U_M: f64 = 1e-4;

/// What was observed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Observed {
    /// A small-amplitude period of a mode of a swing (index), s.
    Period(usize, ModeName),
    /// The angle of an incline (index), degrees.
    Incline(usize),
    /// How far the suspension points of a swing (index) were moved along the deck, m.
    Moved(usize),
    /// What the samples of a swing say of the parameters (index into the statements).
    Statement(usize),
}

/// One observation.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    /// What.
    pub what: Observed,
    /// Value, s or degrees, with its uncertainty.
    pub value: Quantity,
    /// Part of that uncertainty that comes from the correction for finite amplitude.
    pub u_amplitude: f64,
    /// For budgets: `yaw period of yaw-1`.
    pub label: Input,
}

impl Observation {
    /// Whether it is a period of one of these swings.
    pub fn is_of(&self, swings: &[usize]) -> bool {
        matches!(self.what, Observed::Period(i, _) if swings.contains(&i))
    }
}

/// The session's system: parameters, observations, and how one predicts the other.
pub struct System<'a> {
    /// The session.
    pub session: &'a Session,
    /// Its parameters.
    pub layout: Layout,
    /// Its observations.
    pub observations: Vec<Observation>,
    /// Rows that are linear in the parameters.
    pub statements: Vec<Statement>,
    /// Every small-amplitude period, those that entered through the samples too: what single routes
    /// start from.
    pub periods: Vec<Observation>,
    /// How a swing's periods follow from the parameters.
    pub theory: Arc<Theory>,
}

/// Small-amplitude undamped periods of one swing by mode, s.
pub type Theory =
    dyn Fn(&Layout, &[f64], &Swing, &SwingIndex) -> Result<Vec<(ModeName, f64)>> + Send + Sync;

/// The solution.
#[derive(Debug, Clone)]
pub struct Solution {
    /// Parameters.
    pub x: Vec<f64>,
    /// Indices of the parameters that were free.
    pub free: Vec<usize>,
    /// Change of each free parameter by one standard uncertainty of each row (rows: observations,
    /// then the free parameters' priors). The covariance is `gain · gainᵀ`.
    pub gain: DMatrix<f64>,
    /// Change of each row of [`System::rows`] by each free parameter.
    pub jacobian: DMatrix<f64>,
    /// Sum of squares and degrees of freedom (those the weak priors take are taken off).
    pub chi2: f64,
    /// Degrees of freedom.
    pub dof: f64,
    /// Factor on all uncertainties: 1 unless the session contradicts itself beyond chance.
    pub birge: f64,
}

impl<'a> System<'a> {
    /// Parameters without observations.
    pub fn new(session: &'a Session, layout: Layout) -> Self {
        System {
            session,
            layout,
            observations: vec![],
            statements: vec![],
            periods: vec![],
            theory: Arc::new(swing_periods),
        }
    }

    /// The same session with other parameters' priors.
    pub fn with(&self, layout: Layout) -> Self {
        System {
            session: self.session,
            layout,
            observations: self.observations.clone(),
            statements: self.statements.clone(),
            periods: self.periods.clone(),
            theory: self.theory.clone(),
        }
    }

    /// The system as it would be were the solution the truth: every stated figure, every period and
    /// every angle with the value that the solution has for it.
    pub fn as_solved(&self, solution: &Solution) -> Option<Self> {
        let mut layout = self.layout.clone();
        layout
            .parameters
            .iter_mut()
            .zip(&solution.x)
            .for_each(|(p, x)| p.prior.value = *x);
        let mut ideal = self.with(layout);
        let mut seen = vec![None; self.session.swings.len()];
        for observation in ideal.periods.iter_mut().chain(&mut ideal.observations) {
            observation.value.value = self.predict_one(observation, &solution.x, &mut seen)?;
        }
        Some(ideal)
    }

    /// What stands beside the swings: inclines, and how far suspension points were moved to tilt
    /// the hull.
    pub fn beside_swings(&self, inclines: &[Option<Quantity>]) -> Vec<Observation> {
        let mut observations = incline_observations(self.session, inclines);
        if self.layout.level_depth().is_some() {
            let swings = 0..self.session.swings.len();
            observations.extend(swings.filter_map(|i| moved_points(self.session, i)));
        }
        observations
    }

    /// Predicted observations; `None` where the parameters allow no motion.
    fn predict(&self, x: &[f64]) -> Option<Vec<f64>> {
        let mut periods: Vec<Option<Vec<(ModeName, f64)>>> = vec![None; self.session.swings.len()];
        self.observations
            .iter()
            .map(|o| self.predict_one(o, x, &mut periods))
            .collect()
    }

    fn predict_one(
        &self,
        observation: &Observation,
        x: &[f64],
        periods: &mut [Option<Vec<(ModeName, f64)>>],
    ) -> Option<f64> {
        match observation.what {
            Observed::Statement(i) => Some(
                self.statements[i]
                    .row
                    .iter()
                    .map(|(k, slope)| slope * x[*k])
                    .sum(),
            ),
            Observed::Incline(i) => {
                let depth = self.layout.level_or_first_depth()?;
                Some(incline_angle_deg(
                    &self.layout,
                    x,
                    &self.session.inclines[i],
                    depth,
                ))
            }
            Observed::Moved(i) => {
                let depth_m = x[self.layout.level_depth()?].exp();
                // l2 = Δ / tan φ
                Some(depth_m * x[self.layout.swings[i].pitch_deg].to_radians().tan())
            }
            Observed::Period(i, mode) => {
                let index = &self.layout.swings[i];
                if periods[i].is_none() {
                    periods[i] =
                        (self.theory)(&self.layout, x, &self.session.swings[i], index).ok();
                }
                let (_, period_s) = periods[i]
                    .as_ref()?
                    .iter()
                    .find(|(name, _)| *name == mode)?;
                Some(period_s * (1.0 + self.layout.clock_error(x, index)))
            }
        }
    }

    /// What every observation, then every free parameter's prior, exceeds the prediction by, in
    /// standard uncertainties.
    pub fn rows(&self, x: &[f64], free: &[usize]) -> Option<DVector<f64>> {
        let mut rows = self.plain_rows(x, free)?;
        for group in self.correlated(free) {
            group.whiten(&mut rows);
        }
        rows.iter()
            .all(|r| r.is_finite())
            .then(|| DVector::from_vec(rows))
    }

    /// The same before what instruments share is taken out.
    pub(super) fn plain_rows(&self, x: &[f64], free: &[usize]) -> Option<Vec<f64>> {
        let predicted = self.predict(x)?;
        let observed = self
            .observations
            .iter()
            .zip(predicted)
            .map(|(o, p)| (o.value.value - p) / o.value.u);
        let priors = free.iter().map(|i| {
            let prior = self.layout.parameters[*i].prior;
            (prior.value - x[*i]) / prior.u
        });
        Some(observed.chain(priors).collect())
    }

    /// The rows that share errors of instruments.
    pub(super) fn correlated(&self, free: &[usize]) -> Vec<Correlated> {
        let first_prior = self.observations.len();
        let row = |reading: &Reading| match reading {
            Reading::Parameter(i) => {
                let k = free.iter().position(|free| free == i)?;
                Some((first_prior + k, self.layout.parameters[*i].prior.u))
            }
            Reading::Observed(what) => {
                let k = self.observations.iter().position(|o| o.what == *what)?;
                Some((k, self.observations[k].value.u))
            }
        };
        Correlated::of(&self.layout.shared, row)
    }

    fn jacobian(&self, x: &[f64], free: &[usize], rows: usize) -> Option<DMatrix<f64>> {
        let mut jacobian = DMatrix::zeros(rows, free.len());
        for (column, i) in free.iter().enumerate() {
            let step = self.layout.parameters[*i].step;
            let shifted = |sign: f64| {
                let mut moved = x.to_vec();
                moved[*i] += sign * step;
                self.rows(&moved, free)
            };
            jacobian.set_column(column, &((shifted(1.0)? - shifted(-1.0)?) / (2.0 * step)));
        }
        Some(jacobian)
    }

    /// Solves the system from `start`.
    ///
    /// # Errors
    /// [`Error::NoResult`] where a motion cannot be computed at the start, or where observations
    /// and priors do not determine every free parameter.
    pub fn solve(&self, start: &[f64]) -> Result<Solution> {
        let free: Vec<usize> = (0..self.layout.parameters.len())
            .filter(|i| self.layout.parameters[*i].prior.u > 0.0)
            .collect();
        let x = self.minimise(start, &free)?;
        let rows = self.rows(&x, &free).ok_or_else(failed)?;
        let jacobian = self.jacobian(&x, &free, rows.len()).ok_or_else(failed)?;
        let normal = jacobian.transpose() * &jacobian;
        let covariance = normal.cholesky().ok_or_else(failed)?.inverse();
        let gain = -&covariance * jacobian.transpose();
        let taken: f64 = free
            .iter()
            .enumerate()
            .filter(|(_, i)| self.layout.parameters[**i].role == Role::Unknown)
            .map(|(k, i)| 1.0 - covariance[(k, k)] / self.layout.parameters[*i].prior.u.powi(2))
            .sum();
        let chi2 = rows.norm_squared();
        let dof = (self.observations.len() as f64 - taken).max(0.0);
        Ok(Solution {
            x,
            free,
            gain,
            jacobian,
            chi2,
            dof,
            birge: birge(chi2, dof),
        })
    }

    fn minimise(&self, start: &[f64], free: &[usize]) -> Result<Vec<f64>> {
        let equations = Equations {
            system: self,
            start,
            free,
        };
        let at: Vec<f64> = free.iter().map(|i| start[*i]).collect();
        let options = Options {
            most_steps: MOST_STEPS,
            gain: ROUNDING,
            gain_share: ROUNDING,
            keep: None,
        };
        let parameters = vec![Parameter::FREE; free.len()];
        let solved = |from: &[f64]| {
            let rows = &mut ByRows::new(&equations);
            minimise(rows, &parameters, from, &options, UNSTOPPED).map_err(|_| failed())
        };
        let mut fit = solved(&at)?;
        // A start far off may take more steps than that: it goes on from there.
        if !fit.ending.is_converged() {
            fit = solved(&fit.x)?;
        }
        Ok(equations.whole(&fit.x))
    }
}

/// A system's rows by its free parameters; priors are among the rows, for instruments share errors
/// between them and the observations.
struct Equations<'a> {
    system: &'a System<'a>,
    /// What the parameters that are not free are held at.
    start: &'a [f64],
    free: &'a [usize],
}

impl Equations<'_> {
    fn whole(&self, free: &[f64]) -> Vec<f64> {
        let mut x = self.start.to_vec();
        self.free.iter().zip(free).for_each(|(i, v)| x[*i] = *v);
        x
    }
}

impl Rows for Equations<'_> {
    fn shape(&self) -> Shape {
        Shape::single(self.free.len())
    }

    fn rows(&self, _: usize, free: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
        let x = self.whole(free);
        let residuals = self.system.rows(&x, self.free)?;
        let jacobian = match wanted {
            Wanted::Residuals => None,
            Wanted::Jacobian => Some(self.system.jacobian(&x, self.free, residuals.len())?),
        };
        Some(Block {
            residuals,
            jacobian,
        })
    }
}

fn failed() -> Error {
    Error::no_result(
        "joint estimate",
        "the stated dimensions and the observed periods admit no common solution",
    )
}

fn birge(chi2: f64, dof: f64) -> f64 {
    if dof < 0.5 {
        return 1.0;
    }
    let beyond_chance = ChiSquared::new(dof)
        .map(|d| chi2 > d.inverse_cdf(1.0 - BIRGE_FALSE_ALARM))
        .unwrap_or(false);
    if beyond_chance {
        (chi2 / dof).sqrt()
    } else {
        1.0
    }
}

/// A scalar of the solution with its uncertainty, by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Derived {
    /// Value.
    pub value: f64,
    /// Standard uncertainty, Birge factor included.
    pub u: f64,
    /// Change by one standard uncertainty of each row (Birge factor included).
    pub by_row: Vec<f64>,
    /// Share of the variance that comes from weak priors: what exceeds a little was not measured.
    pub weak_share: f64,
}

impl Solution {
    /// A function of the parameters, linearised; `None` where it is not defined.
    pub fn derive(&self, layout: &Layout, f: impl Fn(&[f64]) -> Option<f64>) -> Option<Derived> {
        let value = f(&self.x).filter(|v| v.is_finite())?;
        let mut by_row = DVector::zeros(self.gain.ncols());
        for (k, i) in self.free.iter().enumerate() {
            let step = layout.parameters[*i].step;
            let mut moved = self.x.clone();
            moved[*i] += step;
            let up = f(&moved)?;
            moved[*i] -= 2.0 * step;
            let slope = (up - f(&moved)?) / (2.0 * step);
            by_row += self.gain.row(k).transpose() * (slope * self.birge);
        }
        let first_prior = self.gain.ncols() - self.free.len();
        let by_row: Vec<f64> = by_row.iter().copied().collect();
        let variance: f64 = by_row.iter().map(|row| row * row).sum();
        let weak: f64 = self
            .free
            .iter()
            .enumerate()
            .filter(|(_, i)| layout.parameters[**i].role == Role::Unknown)
            .map(|(k, _)| by_row[first_prior + k].powi(2))
            .sum();
        let weak_share = if variance > 0.0 { weak / variance } else { 0.0 };
        Some(Derived {
            value,
            u: variance.sqrt(),
            by_row,
            weak_share,
        })
    }

    /// Standard uncertainty of a parameter.
    pub fn u(&self, parameter: usize) -> f64 {
        self.free
            .iter()
            .position(|i| *i == parameter)
            .map_or(0.0, |k| self.gain.row(k).norm())
    }
}

impl Derived {
    /// Takes in rows more, in which quantities share as in the others.
    pub(super) fn append(&mut self, rows: &[f64]) {
        self.by_row.extend(rows);
        self.u = rows.iter().fold(self.u, |u, row| u.hypot(*row));
    }

    /// Correlation with another scalar of the same solution.
    pub fn correlation(&self, other: &Derived) -> f64 {
        let covariance: f64 = self
            .by_row
            .iter()
            .zip(&other.by_row)
            .map(|(a, b)| a * b)
            .sum();
        if self.u > 0.0 && other.u > 0.0 {
            covariance / (self.u * other.u)
        } else {
            0.0
        }
    }
}

/// The observations that stated incline angles make.
/// An incline shows mass times depth: without the mass it tells nothing of the depth.
fn incline_observations(session: &Session, recorded_deg: &[Option<Quantity>]) -> Vec<Observation> {
    if session.body.mass_kg.is_none() {
        return vec![];
    }
    let angle = |i: usize| match session.inclines[i].angle {
        InclineAngle::Stated(angle) => Some(angle),
        InclineAngle::Recording(_) => recorded_deg.get(i).copied().flatten(),
    };
    (0..session.inclines.len())
        .filter_map(|i| {
            let incline = &session.inclines[i];
            let read = angle(i)?;
            // The weight's own figures widen the angle by (20).
            let slopes = incline_slopes_deg(incline, read.value);
            let parts = incline_parts(incline, i, Some(read));
            let weights = parts.into_iter().skip(1).zip(slopes);
            let whole = session.reading(&format!("incline[{}].angle_deg", i + 1), read);
            let u = weights.fold(whole.u, |u, (part, slope)| {
                u.hypot(slope * session.reading(&part.key, part.figure).u)
            });
            let u = u.max(1e-4);
            Some(Observation {
                what: Observed::Incline(i),
                value: Quantity::new(read.value, u),
                u_amplitude: 0.0,
                label: InputKind::incline(incline.end).into(),
            })
        })
        .collect()
}

fn moved_points(session: &Session, i: usize) -> Option<Observation> {
    if session.measured_at(i, "points_moved") != i {
        return None;
    }
    let swing = &session.swings[i];
    let moved_m = session.reading(&moved_key(i), swing.suspension.points_moved_m?);
    Some(Observation {
        what: Observed::Moved(i),
        value: Quantity::new(moved_m.value, moved_m.u.max(LEAST_MOVED_U_M)),
        u_amplitude: 0.0,
        label: Input::of(InputKind::SuspensionPoints, &swing.id),
    })
}
