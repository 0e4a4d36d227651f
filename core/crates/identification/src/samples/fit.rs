//! The fit of one swing over growing horizons, from rest; and of all swings of a session together.

use std::f64::consts::FRAC_PI_4;

use nalgebra::{DMatrix, DVector};

use super::equations::{Enough, Fitting, Moves, Point, free};
use super::linearise::{Linearised, Simulated};
use super::model::{Statement, SwingModel};
use super::record::{Samples, Stream};
use super::scene::{OWN, Own, SwingSetup, TURN};
use crate::theory::{axis, swing_body, swing_rig};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Mat3, Rotation, Vec3};
use gyradius_mechanics::{SuspensionAxis, small_modes};

/// Horizons in periods of the slowest mode. A phase known over one horizon stays within a quarter
/// of a cycle over the next; the session's parameters move from the second on.
const HORIZONS: [f64; 5] = [1.5, 3.0, 7.0, 16.0, 40.0];
/// Information below this share of a prior's own is left out of the joint estimate's rows.
const LEAST_INFORMATION: f64 = 0.1;
/// A body whose slowest motion takes so many periods of its fastest is none that anybody swings, and
/// its simulation takes as many more steps.
const MOST_STIFF: f64 = 30.0;
/// A hull pitched by more tells bow from stern, degrees.
const TELLING_PITCH_DEG: f64 = 3.0;

/// A fitted swing.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The session's parameters as this swing has them, priors included.
    pub x: Vec<f64>,
    pub own: Own,
    /// The session's free parameters.
    pub free: Vec<usize>,
    /// Of the normal equations without priors: session's free parameters first, then the swing's
    /// own.
    pub matrix: DMatrix<f64>,
    pub gradient: DVector<f64>,
    /// χ² of samples, priors and what was known.
    pub cost: f64,
    /// Residual over noise, sample by sample.
    pub rms_over_noise: f64,
    /// Factor on the variance of everything: what is left is not white.
    pub inflation: f64,
}

/// Headings of the phone that a fit begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Headings {
    /// The two by which the suspension lies where motions show it; any two where none does.
    Shown,
    /// All round.
    All,
}

/// A swing over its first horizon, from one set of the session's parameters.
pub struct Begun {
    point: Point,
    slowest_s: f64,
}

/// Begins with a swing, from rest and from several sets of the session's parameters, which are
/// held; the best first. A set that is no body that can be simulated is left out.
pub fn begun(
    model: &SwingModel,
    starts: &[Vec<f64>],
    known: &[Statement],
    headings: Headings,
) -> Vec<Begun> {
    let fitting = Fitting {
        models: vec![model],
        known,
    };
    let whole_s = model.samples.duration_s;
    let one = |x: &Vec<f64>| -> Result<Begun> {
        let slowest_s = model.slowest_s(x)?;
        let horizon_s = (HORIZONS[0] * slowest_s).min(whole_s);
        let point = model.first(&fitting, x, horizon_s, headings)?;
        Ok(Begun { point, slowest_s })
    };
    let mut begun: Vec<Begun> = starts.iter().flat_map(one).collect();
    // Horizons differ: what counts is the cost of each second.
    let per_s = |begun: &Begun| begun.point.cost / begun.slowest_s;
    begun.sort_by(|a, b| per_s(a).total_cmp(&per_s(b)));
    begun
}

/// Fits a swing to its end from what was begun, beside what is `known` of the session's parameters;
/// over the short horizons only what `early` says moves.
pub fn fit(model: &SwingModel, begun: &[Begun], known: &[Statement], early: Moves) -> Result<Fit> {
    let fitting = Fitting {
        models: vec![model],
        known,
    };
    let grown = |Begun { point, slowest_s }: &Begun| {
        let grown = |point: Point| model.grown(&fitting, point, *slowest_s, early);
        if !model.tells_bow_from_stern() {
            return grown(point.clone());
        }
        // Over a short horizon a tilted hull looks much the same from its other end.
        let turned = Point::new(&point.x, point.owns.iter().map(Own::turned_round).collect());
        let ends = [point.clone(), turned].map(grown).into_iter().flatten();
        ends.min_by(|a, b| a.cost.total_cmp(&b.cost))
            .ok_or_else(no_start)
    };
    // One that leads to a body that cannot be simulated leads nowhere; the next may.
    begun
        .iter()
        .find_map(|start| grown(start).ok())
        .ok_or_else(no_start)
}

/// Fits several swings together from parameters of the session and what each swing had for its own.
/// Bow and stern look alike to most of a level swing: both headings are tried.
pub fn fit_together(models: &[&SwingModel], x: &[f64], owns: &[Own]) -> Result<Vec<Fit>> {
    let near = models
        .iter()
        .zip(owns)
        .map(|(model, own)| model.headed(x, own))
        .collect::<Result<Vec<Own>>>()?;
    let fitting = Fitting {
        models: models.to_vec(),
        known: &[],
    };
    let starts = [
        vec![Point::new(x, near.clone())],
        other_ends(models, x, &near),
    ]
    .concat();
    let ends = starts
        .into_iter()
        .map(|p| fitting.optimised(p, Moves::All, f64::INFINITY, Enough::Converged));
    let best = ends
        .flatten()
        .min_by(|(a, _), (b, _)| a.cost.total_cmp(&b.cost));
    fitting.all_finished(best.ok_or_else(no_start)?)
}

/// Other starts where masses were added at unlike distances: seen from its other end such a hull is
/// another hull, and which way the product of inertia points is no longer a matter of heading
/// alone.
fn other_ends(models: &[&SwingModel], x: &[f64], owns: &[Own]) -> Vec<Point> {
    let is_lopsided = |i: &usize| !models[*i].setup.swing.added_masses.is_empty();
    let Some(lopsided) = (0..models.len()).find(is_lopsided) else {
        return vec![];
    };
    let turned = |which: &dyn Fn(usize) -> bool| -> Vec<Own> {
        let each = owns.iter().enumerate();
        each.map(|(i, own)| {
            if which(i) {
                own.turned_round()
            } else {
                own.clone()
            }
        })
        .collect()
    };
    let mut mirrored = x.to_vec();
    mirrored[models[0].setup.layout.product_xz] *= -1.0;
    vec![
        Point::new(x, turned(&|i| i == lopsided)),
        Point::new(&mirrored, turned(&|i| i != lopsided)),
        Point::new(&mirrored, turned(&|_| true)),
    ]
}

fn no_start() -> Error {
    Error::no_result("fit of the motion", "it cannot be begun")
}

impl Fitting<'_> {
    fn all_finished(&self, (point, slopes): (Point, Vec<Linearised>)) -> Result<Vec<Fit>> {
        let each = self.models.iter().zip(&point.owns).zip(slopes);
        each.map(|((model, own), slopes)| model.finished(&point, own, slopes))
            .collect()
    }
}

impl SwingModel<'_> {
    fn slowest_s(&self, x: &[f64]) -> Result<f64> {
        let SwingSetup {
            layout,
            swing,
            index,
        } = self.setup;
        let body = swing_body(layout, x, swing, index)?;
        let modes = small_modes(&swing_rig(layout, x, swing, index)?, &body)?;
        if modes.period_s(0) > MOST_STIFF * modes.period_s(3) {
            return Err(no_start());
        }
        Ok(modes.period_s(0))
    }

    /// A start followed over longer and longer horizons.
    fn grown(
        &self,
        fitting: &Fitting,
        mut point: Point,
        slowest_s: f64,
        early: Moves,
    ) -> Result<Fit> {
        let whole_s = self.samples.duration_s;
        for horizon in HORIZONS[1..]
            .iter()
            .map(|h| h * slowest_s)
            .take_while(|h| *h < whole_s)
        {
            point = fitting.optimised(point, early, horizon, Enough::Nearly)?.0;
        }
        let last = match early {
            Moves::Opened => Moves::Opened,
            _ => Moves::All,
        };
        let there = fitting.optimised(point, last, whole_s, Enough::Converged)?;
        fitting.all_finished(there)?.pop().ok_or_else(no_start)
    }

    /// The best start over the headings that the phone may have.
    fn first(
        &self,
        fitting: &Fitting,
        x: &[f64],
        horizon_s: f64,
        headings: Headings,
    ) -> Result<Point> {
        let headings = self.headings(headings).into_iter();
        let tried = headings.map(|nominal| -> Result<Point> {
            let start = Point::new(x, vec![Own::at_rest(nominal)]);
            Ok(fitting
                .optimised(start, Moves::Own, horizon_s, Enough::Nearly)?
                .0)
        });
        tried
            .flatten()
            .min_by(|a: &Point, b| a.cost.total_cmp(&b.cost))
            .ok_or_else(no_start)
    }

    /// The swing's own numbers at other parameters of the session, with the better of both
    /// headings.
    fn headed(&self, x: &[f64], own: &Own) -> Result<Own> {
        let fitting = Fitting {
            models: vec![self],
            known: &[],
        };
        let whole_s = self.samples.duration_s;
        let tried = [own.clone(), own.turned_round()].map(|own| {
            fitting.optimised(
                Point::new(x, vec![own]),
                Moves::Own,
                whole_s,
                Enough::Nearly,
            )
        });
        let best = tried.into_iter().flatten().map(|(point, _)| point);
        let best = best
            .min_by(|a, b| a.cost.total_cmp(&b.cost))
            .ok_or_else(no_start)?;
        best.owns.into_iter().next().ok_or_else(no_start)
    }

    /// `hanging_from_phone` for the vertical seen, with headings by the suspension that motions show or
    /// all round.
    fn headings(&self, headings: Headings) -> Vec<Rotation> {
        let up = self.samples.up;
        let shown = self.samples.along_suspension;
        let ahead = match (headings, shown) {
            (Headings::Shown, Some(along)) => {
                let ahead = match axis(self.setup.swing.suspension.orientation) {
                    SuspensionAxis::ForeAndAft => along,
                    SuspensionAxis::Athwartships => along.cross(&up),
                };
                vec![ahead, -ahead]
            }
            _ => {
                let level = |v: Vec3| (v - up * up.dot(&v)).try_normalize(0.5);
                let Some(start) = level(Vec3::x()).or_else(|| level(Vec3::y())) else {
                    return vec![];
                };
                let turn = |eighth: i32| up * (FRAC_PI_4 * f64::from(eighth));
                let turned = |eighth| Rotation::from_scaled_axis(turn(eighth)) * start;
                // Yaw alone looks the same from everywhere: the phone's place goes with its heading.
                let eighths = match headings {
                    Headings::Shown => [0, 2].as_slice(),
                    Headings::All => &[0, 1, 2, 3, 4, 5, 6, 7],
                };
                eighths.iter().copied().map(turned).collect()
            }
        };
        // Columns: x, y and z of the hanging axes in phone axes.
        let with = |ahead: Vec3| {
            let phone_from_hanging = Mat3::from_columns(&[ahead, up.cross(&ahead), up]);
            let matrix = nalgebra::Rotation3::from_matrix_unchecked(phone_from_hanging.transpose());
            Rotation::from_rotation_matrix(&matrix)
        };
        ahead.into_iter().map(with).collect()
    }

    /// Information and gradient of the priors, session's free parameters first.
    fn priors(&self, x: &[f64], own: &Own, free: &[usize]) -> (DVector<f64>, DVector<f64>) {
        let of_session = free.iter().map(|i| {
            let prior = self.setup.layout.parameters[*i].prior;
            (prior.u.powi(-2), (prior.value - x[*i]) / prior.u.powi(2))
        });
        let of_own = own
            .values
            .iter()
            .zip(Own::prior_u())
            .map(|(v, u)| (u.powi(-2), -v / (u * u)));
        let both: Vec<(f64, f64)> = of_session.chain(of_own).collect();
        let column =
            |f: fn(&(f64, f64)) -> f64| DVector::from_iterator(both.len(), both.iter().map(f));
        (column(|p| p.0), column(|p| p.1))
    }

    fn finished(&self, point: &Point, own: &Own, slopes: Linearised) -> Result<Fit> {
        let whole_s = self.samples.duration_s;
        let simulated = Simulated::new(&self.setup, &point.x, own, whole_s, whole_s)?;
        Ok(Fit {
            cost: point.cost,
            x: point.x.clone(),
            own: own.clone().folded(),
            free: free(self.setup.layout),
            gradient: slopes.gradient(&simulated.misfits(&self.samples, whole_s)),
            rms_over_noise: rms(&simulated, &self.samples),
            inflation: inflation(&simulated, &self.samples),
            matrix: slopes.matrix,
        })
    }

    /// How far the fit pitches the hull from what was stated, in standard uncertainties.
    pub fn pitch_pull(&self, fit: &Fit) -> f64 {
        let prior = self.setup.layout.parameters[self.setup.index.pitch_deg].prior;
        let pull = (fit.x[self.setup.index.pitch_deg] - prior.value).abs();
        if prior.u > 0.0 { pull / prior.u } else { 0.0 }
    }

    pub fn tells_bow_from_stern(&self) -> bool {
        self.setup.layout.parameters[self.setup.index.pitch_deg]
            .prior
            .value
            .abs()
            > TELLING_PITCH_DEG
    }

    /// What the swing says of the session's parameters, its own numbers left open, and the product
    /// of inertia where that is asked.
    pub fn statements(&self, fit: &Fit, product_is_open: bool) -> Option<Vec<Statement>> {
        let (information, pull) = self.priors(&fit.x, &fit.own, &fit.free);
        let is_open = |k: usize| {
            k >= fit.free.len() || (fit.free[k] == self.setup.layout.product_xz && product_is_open)
        };
        let all = fit.free.len() + OWN;
        let (open, kept): (Vec<usize>, Vec<usize>) = (0..all).partition(|k| is_open(*k));
        let part = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
                fit.matrix[(rows[i], columns[j])]
            })
        };
        let mut inner = part(&open, &open);
        open.iter()
            .enumerate()
            .for_each(|(i, k)| inner[(i, i)] += information[*k]);
        let outer = part(&kept, &open);
        let solved = inner.cholesky()?;
        let open_gradient =
            DVector::from_fn(open.len(), |i, _| fit.gradient[open[i]] + pull[open[i]]);
        let matrix = part(&kept, &kept) - &outer * solved.solve(&outer.transpose());
        let gradient = DVector::from_fn(kept.len(), |i, _| fit.gradient[kept[i]])
            - &outer * solved.solve(&open_gradient);
        let u = DVector::from_fn(kept.len(), |i, _| information[kept[i]].powf(-0.5));
        let scaled = DMatrix::from_fn(kept.len(), kept.len(), |i, j| matrix[(i, j)] * u[i] * u[j]);
        let eigen = scaled.symmetric_eigen();
        let statement = |k: usize| {
            let (vector, root) = (eigen.eigenvectors.column(k), eigen.eigenvalues[k].sqrt());
            let scale = 1.0 / fit.inflation.sqrt();
            let row: Vec<(usize, f64)> = (0..kept.len())
                .map(|i| (fit.free[kept[i]], scale * root * vector[i] / u[i]))
                .collect();
            let here: f64 = row.iter().map(|(i, r)| r * fit.x[*i]).sum();
            let pulled: f64 = (0..kept.len())
                .map(|i| vector[i] * u[i] * gradient[i])
                .sum();
            Statement {
                row,
                value: here + scale * pulled / root,
            }
        };
        let telling = (0..kept.len()).filter(|k| eigen.eigenvalues[*k] > LEAST_INFORMATION);
        Some(telling.map(statement).collect())
    }

    /// Standard uncertainty of a parameter of the session by this swing alone.
    pub fn u(&self, fit: &Fit, parameter: usize) -> Option<f64> {
        let place = fit.free.iter().position(|i| *i == parameter)?;
        Some(self.covariance(fit)?[(place, place)].sqrt())
    }

    /// Standard uncertainty of the phone's turn against the hull, about its least certain axis,
    /// rad.
    pub fn turn_u_rad(&self, fit: &Fit) -> f64 {
        let first = fit.free.len() + TURN;
        let Some(covariance) = self.covariance(fit) else {
            return f64::INFINITY;
        };
        let part = covariance.view((first, first), (3, 3)).into_owned();
        part.symmetric_eigenvalues().max().max(0.0).sqrt()
    }

    /// Covariance of the session's free parameters and the swing's own, priors included.
    pub fn covariance(&self, fit: &Fit) -> Option<DMatrix<f64>> {
        let (information, _) = self.priors(&fit.x, &fit.own, &fit.free);
        let matrix = &fit.matrix / fit.inflation + DMatrix::from_diagonal(&information);
        Some(matrix.cholesky()?.inverse())
    }
}

fn residual(simulated: &Simulated, stream: &Stream, i: usize) -> Vec3 {
    (stream.values[i] - simulated.at(stream.sensor, stream.t_s[i])).component_div(&stream.noise)
}

fn rms(simulated: &Simulated, samples: &Samples) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for stream in &samples.streams {
        sum += (0..stream.t_s.len())
            .map(|i| residual(simulated, stream, i).norm_squared())
            .sum::<f64>();
        count += stream.axes() * stream.t_s.len();
    }
    (sum / count.max(1) as f64).sqrt()
}

/// Variance of the block means over what white noise gives them, at least 1: what is left at the
/// frequencies of the swing counts, and a block passes them. The worst axis counts where it stands
/// out from chance.
fn inflation(simulated: &Simulated, samples: &Samples) -> f64 {
    let mut worst: f64 = 1.0;
    for stream in &samples.streams {
        let mut sum = Vec3::zeros();
        for block in &stream.blocks {
            let mean = block
                .clone()
                .map(|i| residual(simulated, stream, i))
                .sum::<Vec3>()
                / block.len() as f64;
            sum += mean.component_mul(&mean) * block.len() as f64;
        }
        let ratio = (sum / stream.blocks.len().max(1) as f64).max();
        // Four standard deviations of the mean of so many χ² of one degree of freedom.
        let chance = 4.0 * (2.0 / stream.blocks.len().max(1) as f64).sqrt();
        if ratio > 1.0 + chance {
            worst = worst.max(ratio);
        }
    }
    worst
}
