//! The fit over longer and longer parts of a record.

use std::cell::Cell;
use std::ops::Range;

use gyradius_estimation::{ByRows, Fit, Options, Progress, Rows, Wanted, minimise};

use super::lines::Line;
use super::problem::{Fitting, HARDNESS_PLACE, Problem, REST, measured};
use super::readings::Readings;
use super::start::{Start, starts};
use super::summary;
use crate::chance::beyond_chance;
use gyradius_mechanics::one_angle::Law;

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
    /// Its readings, with the noise that the motion leaves.
    pub readings: Readings,
    /// The fit.
    pub fit: Fit,
    /// Oscillations beside it.
    pub lines: Vec<Line>,
    /// Where it began.
    pub start: Start,
    /// What brings the body back; where nobody says it, a spring that an effect bends.
    pub law: Option<Law>,
}

impl Fitted {
    /// The problem that it solves, over the whole record.
    pub fn problem(&self) -> Problem<'_> {
        let effects = measured(self.law.is_some());
        problem(
            &self.readings,
            self.law,
            &self.start,
            (&self.lines, effects),
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
        let beside: Vec<f64> = more.lines.iter().flat_map(Line::start).collect();
        let first = self.problem().first_effect();
        x.splice(first..first, beside);
        match solve(&more.problem(), &x) {
            Some(fit) if !more.lines.is_empty() => Some(Self { fit, ..more }),
            _ => Some(self),
        }
    }
}

fn problem<'a>(
    readings: &'a Readings,
    law: Option<Law>,
    start: &Start,
    (lines, effects): (&'a [Line], &'a [Fitting<'a>]),
) -> Problem<'a> {
    Problem {
        readings,
        law: law.unwrap_or(Law::Linear),
        scales: start.scales(),
        lines,
        effects,
        blocks: &readings.blocks,
        noise: readings.noise,
    }
}

/// Fits; `None` where the problem has no answer at its start.
pub fn solve(problem: &Problem, x: &[f64]) -> Option<Fit> {
    solve_towards(problem, x, f64::INFINITY)
}

/// The same, given up where χ² of data and priors would not come below a limit even if every step
/// that is left were as good as the better of the last two.
pub fn solve_towards(problem: &Problem, x: &[f64], limit: f64) -> Option<Fit> {
    let gains = Cell::new([f64::INFINITY; 2]);
    let is_vain = |progress: Progress| {
        let [_, before] = gains.replace([gains.get()[1], progress.gained]);
        let left = OPTIONS.most_steps.saturating_sub(progress.steps) as f64;
        progress.cost - left * before.max(progress.gained) > limit
    };
    minimise(
        &mut ByRows::new(problem),
        &problem.parameters(),
        x,
        &OPTIONS,
        &is_vain,
    )
    .ok()
}

/// From the best start over the whole record, then with the lines that it leaves; by a law, or where
/// nobody says it, by one that is fitted.
pub fn fit_from_afar(readings: Readings, law: Option<Law>) -> Option<Fitted> {
    let duration_s = readings.duration_s();
    let cycles = duration_s * readings.pole.im / std::f64::consts::TAU;
    if cycles > readings.blocks.len() as f64 {
        // Most of it is a gap: the motion in it would cost more than the samples are worth.
        return None;
    }
    let effects = measured(law.is_some());
    let (start, first) = begin(&readings, law)?;
    let mut horizon_s = first_horizon_s(&start);
    let left = Problem {
        blocks: readings.blocks_to(horizon_s),
        ..problem(&readings, law, &start, (&[], effects))
    }
    .left(&first.x)?;
    let readings = readings.quieter(&left)?;
    let to = |horizon_s| Problem {
        blocks: readings.blocks_to(horizon_s),
        ..problem(&readings, law, &start, (&[], effects))
    };
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
        law,
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
    let new = longer.blocks.iter().enumerate().skip(known);
    let u = |(row, block): (usize, &Range<usize>)| {
        let slopes = jacobian.row(row);
        let variance = (slopes * &covariance * slopes.transpose())[(0, 0)];
        longer.block_noise(block.len()) * variance.max(0.0).sqrt()
    };
    Some(new.map(u).fold(0.0, f64::max) < std::f64::consts::FRAC_1_SQRT_2 * most)
}

fn first_horizon_s(start: &Start) -> f64 {
    FIRST_CYCLES * std::f64::consts::TAU / start.omega_rad_s
}

/// The start from which the first cycles are described best.
fn begin(readings: &Readings, law: Option<Law>) -> Option<(Start, Fit)> {
    let effects = measured(law.is_some());
    let fits = starts(readings, law.is_some())
        .into_iter()
        .filter_map(|start| {
            let problem = Problem {
                blocks: readings.blocks_to(first_horizon_s(&start)),
                ..problem(readings, law, &start, (&[], effects))
            };
            let mut x = vec![
                start.angle_rad,
                start.rate_rad_s,
                0.0,
                start.damping_per_s,
                start.rest,
            ];
            x.resize(problem.count(), 0.0);
            if let Some(hardness) = x.get_mut(REST + 1 + HARDNESS_PLACE) {
                *hardness = start.hardness;
            }
            let fit = solve(&problem, &x)?;
            Some((start, fit.chi2 / problem.blocks.len().max(1) as f64, fit))
        });
    let best = fits.min_by(|a, b| a.1.total_cmp(&b.1));
    best.map(|(start, _, fit)| (start, fit))
}
