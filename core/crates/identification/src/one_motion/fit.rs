//! The fit over longer and longer parts of a record.

use std::ops::Range;

use gyradius_estimation::{ByRows, Fit, Options, Rows, UNSTOPPED, Wanted, minimise};

use super::lines::Line;
use super::problem::Problem;
use super::readings::Readings;
use super::start::{Start, starts};
use super::summary;
use super::torque::Restoring;
use crate::chance::beyond_chance;

/// Periods that a fit begins with: fewer do not tell damping from frequency, over more a start that
/// is a few percent off loses count.
const FIRST_CYCLES: f64 = 2.5;
/// Each part is so many times as long as the one before: a phase that is known over one stays within
/// a quarter of a cycle over the next.
const LONGER: f64 = 2.0;
const OPTIONS: Options = Options {
    most_steps: 60,
    // A hundredth of a standard deviation.
    gain: 1e-4,
    gain_share: 1e-12,
    keep: None,
};
/// A swing fitted.
#[derive(Debug, Clone)]
pub struct Fitted {
    pub readings: Readings,
    pub fit: Fit,
    pub lines: Vec<Line>,
    pub start: Start,
    pub restoring: Restoring,
}

impl Fitted {
    /// The problem that it solves, over the whole record.
    pub fn problem(&self) -> Problem<'_> {
        problem(
            &self.readings,
            self.restoring,
            &self.start,
            &self.lines,
            f64::INFINITY,
        )
    }

    /// What it leaves of every sample.
    pub fn left(&self) -> Option<Vec<f64>> {
        self.problem().left(&self.fit.x)
    }

    /// Once more from where it is, with the noise that it leaves where that is less: where a cycle has
    /// few samples, a motion that does not describe the swing leaves it as noise.
    fn again(self) -> Option<Self> {
        let left = self.left()?;
        let readings = self.readings.quieter(&left)?;
        let mut again = Self { readings, ..self };
        let fit = solve(&again.problem(), &again.fit.x)?;
        again.fit = Some(fit).filter(|fit| fit.ending.is_converged())?;
        Some(again)
    }

    /// Whether more is left than noise.
    fn is_left(&self) -> Option<bool> {
        let rows = self
            .problem()
            .rows(0, &self.fit.x, &[], Wanted::Residuals)?;
        let count = rows.residuals.len() as f64;
        let mean = rows.residuals.norm_squared() / count;
        Some(beyond_chance(mean, count) > 0.0)
    }

    /// With the lines that are left beside it, where it can be fitted with them.
    fn with_lines(self) -> Option<Self> {
        let own = summary::own_rad_s(&self)?;
        let left = self.left()?;
        let mut more = self.clone();
        more.lines = Line::beside(&self.readings.t_s[..left.len()], left, own);
        let mut x = self.fit.x.clone();
        more.lines.iter().for_each(|line| x.extend(line.start()));
        match solve(&more.problem(), &x) {
            Some(fit) if !more.lines.is_empty() => Some(Self { fit, ..more }),
            _ => Some(self),
        }
    }
}

fn problem<'a>(
    readings: &'a Readings,
    restoring: Restoring,
    start: &Start,
    lines: &'a [Line],
    horizon_s: f64,
) -> Problem<'a> {
    let [angle, rate, ..] = start.numbers;
    Problem {
        readings,
        restoring,
        omega_rad_s: start.omega_rad_s,
        reach_rad: angle.hypot(rate / start.omega_rad_s),
        lines,
        horizon_s,
    }
}

fn solve(problem: &Problem, x: &[f64]) -> Option<Fit> {
    minimise(
        &mut ByRows::new(problem),
        &problem.parameters(),
        x,
        &OPTIONS,
        UNSTOPPED,
    )
    .ok()
}

/// From the best start over the whole record, then with the lines that it leaves.
pub fn fit_from_afar(readings: Readings, restoring: Restoring) -> Option<Fitted> {
    let duration_s = readings.duration_s();
    let cycles = duration_s * readings.pole.im / std::f64::consts::TAU;
    if cycles > readings.blocks.len() as f64 {
        // Most of it is a gap: the motion in it would cost more than the samples are worth.
        return None;
    }
    let (start, first) = begin(&readings, restoring)?;
    let mut horizon_s = first_horizon_s(&start);
    let left = problem(&readings, restoring, &start, &[], horizon_s).left(&first.x)?;
    let readings = readings.quieter(&left)?;
    let to = |horizon_s| problem(&readings, restoring, &start, &[], horizon_s);
    let mut fit = solve(&to(horizon_s), &first.x)?;
    while horizon_s < duration_s {
        let known = readings.blocks_to(horizon_s).len();
        horizon_s *= LONGER;
        if readings.blocks_to(horizon_s).len() > known {
            let longer = to(horizon_s);
            if !foresees(&longer, &fit, known)? {
                return None;
            }
            fit = solve(&longer, &fit.x)?;
        }
    }
    let fitted = Fitted {
        readings,
        fit,
        lines: vec![],
        start,
        restoring,
    };
    let fitted = fitted.again()?;
    match fitted.is_left()? {
        true => fitted.with_lines()?.again(),
        false => Some(fitted),
    }
}

/// Whether a fit of the first rows tells the phase in the next ones to a quarter of a cycle: then its
/// readings there are uncertain by less than sin 45° of the largest.
fn foresees(longer: &Problem, fit: &Fit, known: usize) -> Option<bool> {
    let readings = longer.readings;
    let jacobian = longer.rows(0, &fit.x, &[], Wanted::Jacobian)?.jacobian?;
    let covariance = fit.covariance().ok()?;
    let size = |block: &Range<usize>| Readings::mean(block, |i| readings.values[i]).abs();
    let most = readings.blocks[..known]
        .iter()
        .map(size)
        .fold(0.0, f64::max);
    let new = readings
        .blocks_to(longer.horizon_s)
        .iter()
        .enumerate()
        .skip(known);
    let u = |(row, block): (usize, &Range<usize>)| {
        let slopes = jacobian.row(row);
        let variance = (slopes * &covariance * slopes.transpose())[(0, 0)];
        longer.noise(block.len()) * variance.max(0.0).sqrt()
    };
    Some(new.map(u).fold(0.0, f64::max) < std::f64::consts::FRAC_1_SQRT_2 * most)
}

fn first_horizon_s(start: &Start) -> f64 {
    FIRST_CYCLES * std::f64::consts::TAU / start.omega_rad_s
}

/// The start from which the first cycles are described best.
fn begin(readings: &Readings, restoring: Restoring) -> Option<(Start, Fit)> {
    let fits = starts(readings, restoring).into_iter().filter_map(|start| {
        let mut x = start.numbers.to_vec();
        x.push(start.rest);
        let problem = problem(readings, restoring, &start, &[], first_horizon_s(&start));
        let fit = solve(&problem, &x)?;
        let rows = readings.blocks_to(problem.horizon_s).len();
        Some((start, fit.chi2 / rows.max(1) as f64, fit))
    });
    let best = fits.min_by(|a, b| a.1.total_cmp(&b.1));
    best.map(|(start, _, fit)| (start, fit))
}
