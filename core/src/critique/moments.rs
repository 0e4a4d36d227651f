//! Things that happen at a moment: the phone slips, the hull is knocked. What a session shows of them is the response to a
//! change of pose or of motion from that moment on, so no simulation is needed to look for the moment.

use nalgebra::{DMatrix, DVector};

use crate::error::Result;
use crate::inertia::by_samples::in_parallel;

use super::causes::{Scales, knock_at, slip_at};
use super::look::{Equations, Look, Part, Solved, Standing, laid_out};
use super::point::{Cause, OWN};

/// Moments tried in each swing, first coarse, then about the best.
const COARSE: usize = 24;
const FINE: usize = 9;

/// What happens.
#[derive(Clone, Copy, PartialEq)]
enum Event {
    Slip,
    Knock,
}

/// First looks at what may have happened, each at its best moment.
pub fn moments(standing: &Standing) -> Result<Vec<Look>> {
    let model = &standing.model;
    let times: Vec<Vec<f64>> =
        (0..standing.residuals.len()).map(|s| model.blocks(s).iter().map(|b| b.t_s).collect()).collect();
    let scales = Scales::of(model.base, &standing.fitted.point)?;
    let scan = Scan { standing, times, scales };
    Ok([Event::Slip, Event::Knock].into_iter().filter_map(|event| scan.best(event)).collect())
}

struct Scan<'a> {
    standing: &'a Standing<'a>,
    times: Vec<Vec<f64>>,
    scales: Scales,
}

impl Scan<'_> {
    fn best(&self, event: Event) -> Option<Look> {
        let tried = in_parallel(self.times.len(), |s| {
            let duration_s = self.standing.model.swing(s).samples.duration_s;
            let step_s = duration_s / COARSE as f64;
            let coarse = (1..COARSE).map(|k| k as f64 * step_s);
            let best =
                coarse.filter_map(|t| self.seen(event, s, t)).max_by(|a, b| a.gain.total_cmp(&b.gain))?;
            // Twice finer about the best.
            [step_s / 5.0, step_s / 40.0].into_iter().try_fold(best, |best, step_s| {
                let half = (FINE / 2) as f64;
                let from_s = best.t_s - half * step_s;
                let near = (0..FINE).map(|k| from_s + k as f64 * step_s);
                let seen = near.filter_map(|t| self.seen(event, s, t)).chain([best]);
                seen.max_by(|a, b| a.gain.total_cmp(&b.gain))
            })
        });
        let best = tried.into_iter().flatten().max_by(|a, b| a.gain.total_cmp(&b.gain))?;
        Some(self.look(event, best))
    }

    /// The evidence for an event at a moment of a swing.
    fn seen(&self, event: Event, s: usize, t_s: f64) -> Option<Seen> {
        let count = match event {
            Event::Slip => 6,
            Event::Knock => 8,
        };
        let u = DVector::from_fn(count, |k, _| match event {
            Event::Slip => {
                if k < 3 {
                    0.01
                } else {
                    0.02
                }
            }
            Event::Knock => 0.03,
        });
        let mut equations = Equations::new(self.standing, u);
        let last = if event == Event::Slip { self.standing.residuals.len() } else { s + 1 };
        for swing in s..last {
            let from_s = if swing == s { t_s } else { f64::NEG_INFINITY };
            if swing != s && self.standing.model.swing(swing).mount != self.standing.model.swing(s).mount {
                continue;
            }
            let columns = self.columns(event, swing, from_s);
            equations.add(
                swing,
                Part::of(&self.standing.fitted.jacobians[swing], &columns, &self.standing.residuals[swing]),
            );
        }
        let Solved { strength, rest, gain, chi2 } = equations.solved(false)?;
        Some(Seen { s, t_s, gain, chi2, strength, rest })
    }

    /// Derivatives by the phone's pose or by the start of the motion, from a moment on.
    fn columns(&self, event: Event, swing: usize, from_s: f64) -> DMatrix<f64> {
        let jacobian = &self.standing.fitted.jacobians[swing];
        let free = self.standing.model.base.free.len();
        let (first, count) = match event {
            Event::Slip => (free, 6),
            Event::Knock => (jacobian.ncols() - OWN, 8),
        };
        let mut columns = jacobian.columns(first, count).into_owned();
        for (block, t_s) in self.times[swing].iter().enumerate() {
            if *t_s < from_s {
                columns.rows_mut(3 * block, 3).fill(0.0);
            }
        }
        columns
    }

    fn look(&self, event: Event, seen: Seen) -> Look {
        let cause: Cause = match event {
            Event::Slip => slip_at(seen.s, seen.t_s),
            Event::Knock => knock_at(&self.scales, seen.s, seen.t_s),
        };
        let mut values = vec![0.0; cause.size(self.standing.residuals.len())];
        if event == Event::Slip {
            // Place first there, turn first here.
            (0..6).for_each(|k| values[k] = seen.strength[(k + 3) % 6]);
        }
        let delta = laid_out(&self.standing.model, &seen.rest, &values);
        Look { cause, gain: seen.gain, chi2: seen.chi2, delta }
    }
}

struct Seen {
    s: usize,
    t_s: f64,
    gain: f64,
    chi2: f64,
    strength: DVector<f64>,
    rest: DVector<f64>,
}
