//! The joint estimate from periods with causes in it.
//!
//! A cause's numbers are parameters of the system beside the others, with what is believed of them
//! as their priors, counted in their own widths. The evidence is Laplace's: exact where the system
//! is linear.

use std::collections::BTreeMap;
use std::sync::Arc;

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

use super::causes::{Amplitudes, Cause, Hung, Scales};
use gyradius_base::error::{Error, Result};
use gyradius_identification::estimate::{self, Observed, Solution, System};
use gyradius_identification::parameters::{Layout, Parameter, Role, SwingIndex};
use gyradius_identification::theory::{axis, compound_period_s, mode_names, swing_body, swing_rig};
use gyradius_identification::{AmplitudeUnit, Analysis, Input, InputKind, ModeResult};
use gyradius_mechanics::{Rig, SmallEffects, small_modes};
use gyradius_recording::{ModeName, Quantity, Swing};

/// Step of numerical derivatives by a cause's number, in its width.
const STEP: f64 = 1e-3;
/// Where the solution starts, in the width: causes of the second order have no slope at zero.
const STARTS: [f64; 2] = [0.5, 0.01];
/// A cause that is not needed costs no more evidence than this when it is fitted well.
const CAUGHT: f64 = 3.0;
/// How far all stated uncertainties together may be off, as a logarithm: a factor of two.
const UNCERTAINTIES_LOG_U: f64 = 0.7;
/// Logarithms of factors that are tried: up to 3000.
const LOG_STEP: f64 = 0.02;
const LOG_STEPS: u32 = 400;
/// A cause whose numbers at one width move no observation by more standard uncertainties is not
/// seen in this session.
const LEAST_SEEN: f64 = 0.1;
/// How far the depth of a centre of mass may lie off 0.4 gyradii, as a logarithm (the paper's
/// hulls: 0.4 and 0.8).
const DEPTH_LOG_U: f64 = 0.7;
/// An observation that the others predict no better than this, relative, tests nothing.
const MOST_PREDICTED_U: f64 = 0.05;

/// What all models of a session share.
pub struct Setting<'a> {
    /// The system without causes.
    pub system: System<'a>,
    /// Its solution.
    pub solution: Solution,
    /// Sizes of the session.
    pub scales: Arc<Scales>,
    amplitudes: Arc<BTreeMap<String, Amplitudes>>,
    bare_log_evidence: f64,
}

/// A model that was fitted.
pub struct Fitted<'a> {
    /// Its causes.
    pub causes: Vec<&'static Cause>,
    /// The system with them.
    pub system: System<'a>,
    /// Its solution.
    pub solution: Solution,
    /// Logarithm of the evidence; what all models of a session share is left out.
    pub log_evidence: f64,
}

/// An observation, or a stated figure, against what everything else says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldOut {
    /// As the rest has it.
    pub predicted: f64,
    /// Standard uncertainty of the difference.
    pub u: f64,
    /// The difference in these.
    pub z: f64,
}

impl<'a> Setting<'a> {
    /// From the solved periods of a session.
    pub fn new(
        (mut system, solution): (System<'a>, Solution),
        analysis: &Analysis,
    ) -> Result<Self> {
        system.layout = with_sober_depths(&system.layout);
        let solution = system.solve(&solution.x)?;
        let scales = Arc::new(scales(&system, &solution));
        let swings = &analysis.measurement.swings;
        let amplitudes = swings
            .iter()
            .map(|swing| (swing.id.clone(), amplitudes(&swing.modes)))
            .collect();
        let bare_log_evidence =
            log_evidence(&system.layout, &solution, &[]).unwrap_or(f64::NEG_INFINITY);
        Ok(Self {
            system,
            solution,
            scales,
            amplitudes: Arc::new(amplitudes),
            bare_log_evidence,
        })
    }

    /// The model with these causes; `None` where it has no solution.
    pub fn fit(&self, causes: &[&'static Cause]) -> Option<Fitted<'a>> {
        self.fit_without(causes, &|_| false)
    }

    /// The same without some of the observations.
    pub fn fit_without(
        &self,
        causes: &[&'static Cause],
        is_left_out: &dyn Fn(Observed) -> bool,
    ) -> Option<Fitted<'a>> {
        let mut system = self.with(causes);
        system.observations.retain(|o| !is_left_out(o.what));
        let first = self.solve(&system, causes, STARTS[0]);
        let (solution, log_evidence) = match first {
            // The solution got caught where two modes nearly coincide: nearer to zero the same
            // model does better.
            Some((_, evidence)) if evidence < self.bare_log_evidence - CAUGHT => {
                let other = self.solve(&system, causes, STARTS[1]);
                first
                    .into_iter()
                    .chain(other)
                    .max_by(|a, b| a.1.total_cmp(&b.1))?
            }
            first => first?,
        };
        let solution = self.on_the_right_side(&mut system, solution, causes)?;
        Some(Fitted {
            causes: causes.to_vec(),
            system,
            solution,
            log_evidence,
        })
    }

    fn solve(
        &self,
        system: &System,
        causes: &[&'static Cause],
        size: f64,
    ) -> Option<(Solution, f64)> {
        let mut start = self.solution.x.clone();
        start.resize(system.layout.parameters.len(), size);
        let solution = system.solve(&start).ok()?;
        let log_evidence = log_evidence(&system.layout, &solution, causes)?;
        Some((solution, log_evidence))
    }

    /// The solution with those numbers held at zero that cannot be negative and would be.
    fn on_the_right_side(
        &self,
        system: &mut System,
        solution: Solution,
        causes: &[&'static Cause],
    ) -> Option<Solution> {
        let first = self.solution.x.len();
        let numbers = causes.iter().flat_map(|cause| cause.numbers).enumerate();
        let wrong: Vec<usize> = numbers
            .filter(|(i, number)| number.positive && solution.x[first + i] < 0.0)
            .map(|(i, _)| first + i)
            .collect();
        if wrong.is_empty() {
            return Some(solution);
        }
        let mut start = solution.x;
        for place in wrong {
            start[place] = 0.0;
            system.layout.parameters[place].prior.u = 0.0;
        }
        system.solve(&start).ok()
    }

    /// Whether a cause within what is believed of it moves any observation.
    pub fn is_seen(&self, cause: &'static Cause) -> bool {
        let system = self.with(&[cause]);
        let rows = |size: f64| {
            let mut x = self.solution.x.clone();
            x.resize(system.layout.parameters.len(), size);
            system.rows(&x, &[])
        };
        rows(0.0)
            .zip(rows(1.0))
            .is_some_and(|(without, with)| (with - without).amax() > LEAST_SEEN)
    }

    fn with(&self, causes: &[&'static Cause]) -> System<'a> {
        let mut layout = self.system.layout.clone();
        let first = layout.parameters.len();
        for cause in causes {
            layout
                .parameters
                .extend(cause.numbers.iter().map(|number| Parameter {
                    name: Input::of(
                        InputKind::CauseNumber,
                        &format!("{}.{}", cause.id, number.name),
                    ),
                    role: Role::Stated,
                    prior: Quantity::new(0.0, 1.0),
                    step: STEP,
                }));
        }
        let mut system = self.system.with(layout);
        system.theory = self.by(causes, first, self.amplitudes.clone());
        system
    }

    /// Periods by these causes, whose numbers begin at `first`, of a swing that was not made, by
    /// its name and amplitudes.
    pub fn theory(
        &self,
        causes: &[&'static Cause],
        first: usize,
        (id, amplitudes): (&str, Amplitudes),
    ) -> Arc<estimate::Theory> {
        self.by(
            causes,
            first,
            Arc::new(BTreeMap::from([(id.to_owned(), amplitudes)])),
        )
    }

    fn by(
        &self,
        causes: &[&'static Cause],
        first: usize,
        amplitudes: Arc<BTreeMap<String, Amplitudes>>,
    ) -> Arc<estimate::Theory> {
        let theory = Theory {
            causes: causes.to_vec(),
            first,
            scales: self.scales.clone(),
            amplitudes,
        };
        Arc::new(
            move |layout: &Layout, x: &[f64], swing: &Swing, index: &SwingIndex| {
                theory.periods(layout, x, swing, index)
            },
        )
    }
}

/// The small oscillations with causes in them.
struct Theory {
    causes: Vec<&'static Cause>,
    /// Place of their numbers among the parameters.
    first: usize,
    scales: Arc<Scales>,
    amplitudes: Arc<BTreeMap<String, Amplitudes>>,
}

impl Theory {
    fn periods(
        &self,
        layout: &Layout,
        x: &[f64],
        swing: &Swing,
        index: &SwingIndex,
    ) -> Result<Vec<(ModeName, f64)>> {
        let along = axis(swing.suspension.orientation);
        let body = swing_body(layout, x, swing, index)?;
        let rig = match index.axis_height {
            Some(_) => Rig::bifilar(along, 1.0, 1.0, 1.0, x[layout.gravity])?,
            None => swing_rig(layout, x, swing, index)?,
        };
        let amplitudes = self.amplitudes.get(&swing.id).copied().unwrap_or_default();
        let effects = SmallEffects::default();
        let mut hung = Hung {
            rig,
            body,
            effects,
            clock_error: 0.0,
            axis: along.unit(),
            amplitudes,
            scales: &self.scales,
        };
        self.put(x, &mut hung)?;
        let clock = 1.0 + hung.clock_error;
        if let Some(height) = index.axis_height {
            let period_s = compound_period_s(&hung.body, swing, x[height], hung.rig.gravity_m_s2);
            return Ok(vec![(ModeName::Compound, clock * period_s)]);
        }
        let modes = small_modes(&hung.rig, &hung.body)?.with(&hung.body, &hung.effects)?;
        let names = mode_names(&hung.body, &modes, swing.suspension.orientation);
        Ok((0..4)
            .map(|i| (names[i], clock * modes.period_s(i)))
            .collect())
    }

    fn put(&self, x: &[f64], hung: &mut Hung) -> Result<()> {
        let mut rest = x.get(self.first..).unwrap_or_default();
        for cause in &self.causes {
            let few = || Error::argument("x", "numbers for every cause", rest.len());
            let (own, after) = rest.split_at_checked(cause.numbers.len()).ok_or_else(few)?;
            let numbers: Vec<f64> = cause
                .numbers
                .iter()
                .zip(own)
                .map(|(n, v)| v * (n.width)(&self.scales))
                .collect();
            (cause.put)(&numbers, hung);
            rest = after;
        }
        Ok(())
    }
}

impl Fitted<'_> {
    /// Value and standard uncertainty of every number of the causes, in its width, in order.
    pub fn numbers(&self) -> Vec<Quantity> {
        let count = self.causes.iter().map(|c| c.numbers.len()).sum::<usize>();
        let end = self.system.layout.parameters.len();
        (end - count..end)
            .map(|i| Quantity::new(self.solution.x[i], self.solution.u(i)))
            .collect()
    }

    /// Chance of a χ² as large as this.
    pub fn p_value(&self) -> f64 {
        let Solution { chi2, dof, .. } = self.solution;
        if dof < 0.5 {
            return 1.0;
        }
        ChiSquared::new(dof).map_or(1.0, |d| d.sf(chi2))
    }

    /// χ² beyond the median of what chance leaves.
    pub fn beyond_chance(&self) -> f64 {
        let Solution { chi2, dof, .. } = self.solution;
        let median = ChiSquared::new(dof.max(0.5)).map_or(dof, |d| d.inverse_cdf(0.5));
        (chi2 - median).max(0.0)
    }

    /// Residual over noise; none where nothing is left over to judge by.
    pub fn rms_over_noise(&self) -> Option<f64> {
        let Solution { chi2, dof, .. } = self.solution;
        (dof >= 0.5).then(|| (chi2 / dof).sqrt())
    }

    /// Each row (observations, then the free parameters' priors) against the prediction of all
    /// others, to first order; `None` where these do not predict it.
    pub fn held_out(&self) -> Vec<Option<HeldOut>> {
        let solution = &self.solution;
        let Some(rows) = self.system.rows(&solution.x, &solution.free) else {
            return vec![];
        };
        let figure = |i: usize| match self.system.observations.get(i) {
            Some(observation) => observation.value,
            None => {
                self.system.layout.parameters[solution.free[i - self.system.observations.len()]]
                    .prior
            }
        };
        (0..rows.len())
            .map(|i| {
                // gain = −N⁻¹ Jᵀ: what the row says of itself is its leverage.
                let leverage = -(solution.jacobian.row(i) * solution.gain.column(i))[(0, 0)];
                let of_rest = 1.0 - leverage;
                let stated = figure(i);
                let u = stated.u / of_rest.max(f64::MIN_POSITIVE).sqrt();
                let predicted = stated.value - rows[i] * stated.u / of_rest;
                let z = (stated.value - predicted) / u;
                let is_predicted = of_rest > 1e-9 && u < MOST_PREDICTED_U * stated.value.abs();
                is_predicted.then_some(HeldOut { predicted, u, z })
            })
            .collect()
    }
}

/// −χ²/2 − ½ ln det JᵀJ: what the Gaussian integral over all parameters leaves, their priors
/// counted among the rows; and for each number that cannot be negative, ln 2 for the half of its
/// prior and the share of the integral on that side.
///
/// Where a model leaves contradictions, all uncertainties may have been stated too small: at the
/// price of [`scatter`]. Otherwise whatever takes a little off a large contradiction would be
/// called certain.
fn log_evidence(layout: &Layout, solution: &Solution, causes: &[&'static Cause]) -> Option<f64> {
    let sizes: Vec<f64> = solution.jacobian.column_iter().map(|c| c.norm()).collect();
    let mut scaled = solution.jacobian.clone();
    scaled
        .column_iter_mut()
        .zip(&sizes)
        .for_each(|(mut column, size)| column /= *size);
    let lower = (scaled.transpose() * scaled).cholesky()?.unpack();
    let half_log_det: f64 = lower
        .diagonal()
        .iter()
        .zip(&sizes)
        .map(|(pivot, size)| (pivot * size).ln())
        .sum();
    let normal = Normal::standard();
    let numbers = causes.iter().flat_map(|cause| cause.numbers);
    let first = solution.x.len() - numbers.clone().count();
    let us: Vec<f64> = (first..solution.x.len()).map(|i| solution.u(i)).collect();
    let sides: f64 = numbers
        .zip(solution.x[first..].iter().zip(&us))
        .filter(|(number, _)| number.positive)
        .map(|(_, (x, u))| (2.0 * normal.cdf(x / u)).max(f64::MIN_POSITIVE).ln())
        .sum();
    let believed = believed(layout, solution, first);
    let logs = (0..=LOG_STEPS).map(|i| LOG_STEP * f64::from(i));
    let fits = logs
        .map(|log| scatter(solution, believed, &us, log))
        .fold(f64::NEG_INFINITY, f64::max);
    Some(sides + fits - half_log_det)
}

/// The part of χ² by which body and causes depart from what is believed of them beforehand; nobody
/// stated that.
fn believed(layout: &Layout, solution: &Solution, first_cause: usize) -> f64 {
    let is_believed = |i: usize| i >= first_cause || layout.parameters[i].role == Role::Unknown;
    let pull = |i: usize| {
        let prior = layout.parameters[i].prior;
        (solution.x[i] - prior.value) / prior.u
    };
    solution
        .free
        .iter()
        .filter(|i| is_believed(**i))
        .map(|i| pull(*i).powi(2))
        .sum()
}

/// −χ²/2 with all stated uncertainties larger by a factor s (its logarithm is given): χ² but for
/// what is `believed` falls by s², the density of every degree of freedom by s, and the causes'
/// numbers are known less well by up to s.
fn scatter(solution: &Solution, believed: f64, us: &[f64], log: f64) -> f64 {
    let shrunk = (-2.0 * log).exp();
    let wider = |u: &f64| {
        let information = (1.0 / (u * u) - 1.0).max(0.0);
        0.5 * ((1.0 + information) / (1.0 + information * shrunk)).ln()
    };
    let numbers: f64 = us.iter().map(wider).sum();
    let chi2 = believed + (solution.chi2 - believed) * shrunk;
    numbers - 0.5 * chi2 - solution.dof * log - 0.5 * (log / UNCERTAINTIES_LOG_U).powi(2)
}

/// An estimate may leave the depth of a centre of mass open; a comparison of causes must not: lines
/// a hair off parallel under a hull many metres deep would account for any sway.
fn with_sober_depths(layout: &Layout) -> Layout {
    let mut layout = layout.clone();
    for place in layout.swings.iter().map(|s| s.log_depth) {
        let prior = &mut layout.parameters[place].prior;
        prior.u = prior.u.min(DEPTH_LOG_U);
    }
    layout
}

fn scales(system: &System, solution: &Solution) -> Scales {
    let layout = &system.layout;
    let mean = |places: Vec<usize>| {
        let count = places.len().max(1) as f64;
        places
            .iter()
            .map(|i| layout.parameters[*i].prior.value)
            .sum::<f64>()
            / count
    };
    let mean_or_one = |places: Vec<usize>| if places.is_empty() { 1.0 } else { mean(places) };
    Scales {
        mass_kg: solution.x[layout.mass],
        mass_is_known: system.session.body.mass_kg.is_some(),
        gravity_m_s2: solution.x[layout.gravity],
        length_m: mean_or_one(layout.swings.iter().filter_map(|s| s.line_length).collect()),
        spacing_m: mean_or_one(layout.swings.iter().filter_map(|s| s.spacing).collect()),
        k_yaw_m: solution.x[layout.log_gyradii[2]].exp(),
    }
}

fn amplitudes(modes: &[ModeResult]) -> Amplitudes {
    let of = |name: ModeName| {
        let mode = modes
            .iter()
            .find(|m| m.mode == name && m.amplitude_unit == AmplitudeUnit::Radian);
        mode.map_or(0.0, mean_amplitude)
    };
    Amplitudes {
        yaw_rad: of(ModeName::Yaw),
        sway_rad: of(ModeName::Sway),
    }
}

/// That at which the period was observed: the mean over the record where there is one.
fn mean_amplitude(mode: &ModeResult) -> f64 {
    let points = &mode.against_amplitude;
    match points.len() {
        0 => mode.amplitude.unwrap_or(0.0),
        count => points.iter().map(|p| p.amplitude).sum::<f64>() / count as f64,
    }
}
