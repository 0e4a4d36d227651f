//! What a fitted motion says.

use std::f64::consts::{PI, TAU};

use gyradius_estimation::{Block, Rows, Wanted};
use gyradius_recording::Quantity;
use nalgebra::{DMatrix, DVector};

use super::OneMotion;
use super::fit::Fitted;
use super::problem::{DAMPING, DRAG, FREQUENCY, FRICTION, HARDNESS_PLACE, Problem};

/// Points in a period at which the motion is looked at: a crossing between two is then right to
/// 1e-4 of a period.
const POINTS: f64 = 64.0;
/// A misfit is asked whether it hangs together over runs of so many periods at least …
const FIRST_RUN: f64 = 1.0;
/// … and in so many runs at least: fewer do not tell their own variance.
const FEWEST_RUNS: usize = 20;

/// Period, amplitude and damping with their uncertainties.
pub fn of(fitted: Fitted) -> Option<OneMotion> {
    let problem = fitted.problem();
    let x = &fitted.fit.x;
    let left = fitted.left()?;
    let left_square = left.iter().map(|r| r * r).sum::<f64>();
    let held = fitted.fit.held();
    let free = held.iter().filter(|held| !**held).count();
    let dof = left.len().checked_sub(free).filter(|dof| *dof > 0)?;
    let covariance = fitted.fit.covariance().ok()?;
    let wider = wider(&fitted, free, &covariance)?.max(1.0).sqrt();
    let u = |place: usize| wider * covariance[(place, place)].max(0.0).sqrt();
    let quantity = |place: usize| Quantity::new(x[place], u(place));
    let scales = &problem.scales;
    let first = problem.first_effect();
    let braked =
        |place: usize, unit: f64| (unit * x[place], (!held[place]).then(|| unit * u(place)));
    let is_bent = (first + HARDNESS_PLACE) < x.len();
    // Shares of critical damping at the fastest rate of the start as coefficients.
    let friction = scales.critical_rad_s2();
    let drag = friction / scales.rate_rad_s().powi(2);
    let omega = fitted.start.omega_rad_s * x[FREQUENCY].exp();
    let period_s = TAU / omega;
    let path = Path::of(&problem, x, omega)?;
    let decay_per_s = path.decay_per_s().unwrap_or(x[DAMPING]);
    let mut by = DVector::zeros(x.len());
    let middle_rad = path.middle_rad();
    by[DAMPING] = 1.0;
    by[first + DRAG] = drag * 4.0 * omega * middle_rad / (3.0 * PI);
    by[first + FRICTION] = friction * 2.0 / (PI * omega * middle_rad.max(f64::MIN_POSITIVE));
    // Of the rate of decay at an amplitude, 1/s: α + 4 b ω A/(3π) + 2 c/(π ω A), by the work of a
    // cycle.
    let decay_u = wider * by.dot(&(&covariance * &by)).max(0.0).sqrt();
    Some(OneMotion {
        period_s: Quantity::new(period_s, period_s * u(FREQUENCY)),
        observed_s: path.period_s().unwrap_or(period_s),
        amplitude_rad: path.first_rad(),
        decay_per_s: Quantity::new(decay_per_s, decay_u),
        own_rad_s: path.own_rad_s(omega),
        hardness: match is_bent {
            true => quantity(first + HARDNESS_PLACE),
            false => Quantity::new(0.0, 0.0),
        },
        damping_per_s: braked(DAMPING, 1.0),
        drag_per_rad: braked(first + DRAG, drag),
        friction_rad_s2: braked(first + FRICTION, friction),
        rms_over_noise: (left_square / dof as f64).sqrt() / fitted.readings.noise,
        left_rms: (left_square / left.len() as f64).sqrt(),
        is_described: false,
        fitted,
    })
}

/// From that of the record as a whole to that of small swings, rad/s.
pub fn own_rad_s(fitted: &Fitted) -> Option<[f64; 2]> {
    let x = &fitted.fit.x;
    let omega = fitted.start.omega_rad_s * x[FREQUENCY].exp();
    Some(Path::of(&fitted.problem(), x, omega)?.own_rad_s(omega))
}

/// By what factor the variance of the frequency is larger than for white noise.
fn wider(fitted: &Fitted, free: usize, covariance: &DMatrix<f64>) -> Option<f64> {
    let direction: DVector<f64> = covariance.column(FREQUENCY).into_owned();
    let of_frequency = DMatrix::from_columns(&[direction]);
    let problem = fitted.problem();
    let rows = problem.rows(0, &fitted.fit.x, &[], Wanted::Jacobian)?;
    dispersion(&problem, &rows, free, &of_frequency)
}

/// By what factor the variance along directions in all that is fitted is larger than for white noise,
/// their mean: what is left hangs together over runs of samples, whose scores are taken as
/// independent (Liang and Zeger 1986). The largest of all lengths of runs, and of what is left of
/// all blocks alike. `rows` are those of the fit, with derivatives; `free` is how many numbers are
/// fitted.
pub fn dispersion(
    problem: &Problem,
    rows: &Block,
    free: usize,
    directions: &DMatrix<f64>,
) -> Option<f64> {
    let readings = problem.readings;
    let mut scores = rows.jacobian.as_ref()? * directions;
    let variances: Vec<f64> = scores.column_iter().map(|c| c.norm_squared()).collect();
    for (row, residual) in rows.residuals.iter().enumerate() {
        scores.row_mut(row).scale_mut(*residual);
    }
    let dof = rows.residuals.len().checked_sub(free).filter(|n| *n > 0)?;
    let mut most = rows.residuals.norm_squared() / dof as f64;
    let mut run_s = FIRST_RUN * TAU / problem.scales.omega_rad_s;
    while readings.duration_s() / run_s >= FEWEST_RUNS as f64 {
        let count = (readings.duration_s() / run_s) as usize + 1;
        let mut sums = DMatrix::<f64>::zeros(count, directions.ncols());
        for (block, score) in problem.blocks.iter().zip(scores.row_iter()) {
            let run = (readings.t_s[block.start] / run_s) as usize;
            let mut sum = sums.row_mut(run);
            sum += score;
        }
        let shares = sums.column_iter().zip(&variances);
        let told = shares.filter(|(_, variance)| **variance > 0.0);
        let factors: Vec<f64> = told.map(|(c, v)| c.norm_squared() / v).collect();
        most = most.max(factors.iter().sum::<f64>() / factors.len().max(1) as f64);
        run_s *= 2.0;
    }
    Some(most)
}

/// The motion alone, finely enough to see it cross rest.
struct Path {
    step_s: f64,
    angles_rad: Vec<f64>,
    in_period: usize,
}

impl Path {
    fn of(problem: &Problem, x: &[f64], omega_rad_s: f64) -> Option<Self> {
        let duration_s = problem.readings.duration_s();
        let step_s = TAU / omega_rad_s / POINTS;
        let count = (duration_s / step_s) as usize;
        let times: Vec<f64> = (0..=count).map(|i| i as f64 * step_s).collect();
        Some(Self {
            step_s,
            angles_rad: problem.angles_rad(x, &times)?,
            in_period: POINTS as usize,
        })
    }

    fn widest(angles_rad: &[f64]) -> f64 {
        angles_rad
            .iter()
            .fold(0.0, |most: f64, a| most.max(a.abs()))
    }

    /// A swing of any width is through with a cycle in two periods of small swings.
    fn first_rad(&self) -> f64 {
        let end = (2 * self.in_period).min(self.angles_rad.len());
        Self::widest(&self.angles_rad[..end])
    }

    /// Between the first amplitude and the last.
    fn middle_rad(&self) -> f64 {
        let from = self.angles_rad.len().saturating_sub(2 * self.in_period);
        (self.first_rad() * Self::widest(&self.angles_rad[from..])).sqrt()
    }

    /// From the frequency of the first cycle to that of small swings, whichever is lower first.
    fn own_rad_s(&self, omega_rad_s: f64) -> [f64; 2] {
        let first = self
            .upward()
            .first_chunk()
            .map(|[a, b]| TAU / ((b - a) * self.step_s));
        let first = first.unwrap_or(omega_rad_s);
        [first.min(omega_rad_s), first.max(omega_rad_s)]
    }

    /// When it passes rest upward, steps.
    fn upward(&self) -> Vec<f64> {
        let pairs = self.angles_rad.windows(2).enumerate();
        let upward = pairs.filter(|(_, pair)| pair[0] < 0.0 && pair[1] >= 0.0);
        let at = upward.map(|(i, pair)| i as f64 + pair[0] / (pair[0] - pair[1]));
        at.collect()
    }

    /// From the first passage upward to the last.
    fn period_s(&self) -> Option<f64> {
        let at = self.upward();
        let cycles = at.len().checked_sub(1).filter(|n| *n > 0)?;
        Some((at.last()? - at.first()?) * self.step_s / cycles as f64)
    }

    /// From the first two periods to the last two.
    fn decay_per_s(&self) -> Option<f64> {
        let count = self.angles_rad.len();
        let from = count.checked_sub(2 * self.in_period).filter(|n| *n > 0)?;
        let ratio = self.first_rad() / Self::widest(&self.angles_rad[from..]);
        let between_s = from as f64 * self.step_s;
        Some(ratio.ln() / between_s).filter(|rate| rate.is_finite() && *rate > 0.0)
    }
}
