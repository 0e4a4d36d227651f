//! Things that happen at a moment: the phone slips, the hull is knocked, a line gives way. What a
//! session shows of the first two is the response to a change of pose or of motion from that moment
//! on, so no simulation is needed to look for the moment. A line that gives way turns the hull for
//! good as a phone slips: it is simulated about the moments at which a slip is seen.

use nalgebra::{DMatrix, DVector};

use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;

use super::causes::{GIVES_S, SLIP_S, Scales, knock_at, line_slip_at, slip_at};
use super::look::{Equations, Look, Part, Solved, Standing, laid_out, part};
use super::parameter_id::ParameterName;
use super::point::{Cause, OWN};

/// Moments tried in each swing, first coarse, then about the best.
const COARSE: usize = 24;
const FINE: usize = 9;
/// What a slip itself turns and jolts shows best when it was: so far to both sides of where the
/// lasting change puts it, and of where most is left, it is looked for in steps of [`STEP_S`], s,
/// then with other lengths, s.
const REACH_S: f64 = 0.4;
const STEP_S: f64 = 0.05;
const OTHER_LENGTHS_S: [f64; 2] = [0.05, 0.5];
/// From this gain of the logarithm of the evidence on a slip is looked at so closely.
const WORTH_IT: f64 = 5.0;

/// What happens.
#[derive(Clone, Copy, PartialEq)]
enum Event {
    Slip,
    Knock,
    LineSlip,
}

/// First looks at what may have happened, each at its best moment.
pub fn moments(standing: &Standing) -> Result<Vec<Look>> {
    let model = &standing.model;
    let times: Vec<Vec<f64>> = (0..standing.residuals.len())
        .map(|s| model.blocks(s).iter().map(|b| b.t_s).collect())
        .collect();
    let scales = Scales::of(model.base, &standing.fitted.point)?;
    let slipped = in_parallel(times.len(), |s| {
        let columns = responses(standing, Event::Slip, s);
        let (jacobian, residual) = (&standing.fitted.jacobians[s], &standing.residuals[s]);
        Part::of(jacobian, &columns, residual)
    });
    let scan = Scan {
        standing,
        times,
        scales,
        slipped,
    };
    let slips = scan.best_of_each(Event::Slip);
    let closer = |event, slip: &Seen| {
        (slip.gain > WORTH_IT)
            .then(|| scan.closer(event, slip))
            .flatten()
    };
    // Where a line gave way early, the base has taken most swings as they were after it, and a
    // phone seems to slip in one of these.
    let gives = best(
        slips
            .iter()
            .filter_map(|slip| closer(Event::LineSlip, slip)),
    );
    let gives = gives.map(|seen| scan.look(Event::LineSlip, seen));
    let slip = best(slips.into_iter());
    let slips = slip.map(|slip| closer(Event::Slip, &slip).unwrap_or(slip));
    let slips = slips.map(|seen| scan.look(Event::Slip, seen));
    let knock =
        best(scan.best_of_each(Event::Knock).into_iter()).map(|seen| scan.look(Event::Knock, seen));
    Ok(slips.into_iter().chain(knock).chain(gives).collect())
}

/// What a swing adds to the equations from each of its blocks on.
struct Tails {
    /// Of the blocks, in order.
    times_s: Vec<f64>,
    /// One more: from behind the last.
    parts: Vec<Part>,
}

impl Tails {
    fn from(&self, t_s: f64) -> &Part {
        &self.parts[self.times_s.partition_point(|t| *t < t_s)]
    }
}

/// Derivatives of a swing by the phone's pose or by the start of the motion.
fn responses(standing: &Standing, event: Event, swing: usize) -> DMatrix<f64> {
    let jacobian = &standing.fitted.jacobians[swing];
    let free = standing.model.base.free.len();
    let own = jacobian.ncols() - OWN;
    let places: Vec<usize> = match event {
        // Turn first, then place.
        Event::Slip => (free + 3..free + 6).chain(free..free + 3).collect(),
        Event::Knock | Event::LineSlip => (own..own + 8).collect(),
    };
    jacobian.select_columns(&places)
}

struct Scan<'a> {
    standing: &'a Standing<'a>,
    times: Vec<Vec<f64>>,
    scales: Scales,
    /// What each swing adds where the phone slipped before it.
    slipped: Vec<Part>,
}

impl Scan<'_> {
    /// An event's best moment in each swing, by what is known of the response.
    fn best_of_each(&self, event: Event) -> Vec<Seen> {
        let tried = in_parallel(self.times.len(), |s| {
            let tails = self.tails(event, s);
            let seen = |t_s: f64| self.seen(event, (s, t_s), &tails);
            let duration_s = self.standing.model.swing(s).samples.duration_s;
            let step_s = duration_s / COARSE as f64;
            let coarse = (1..COARSE).map(|k| k as f64 * step_s);
            let roughly = best(coarse.filter_map(seen))?;
            // Twice finer about the best.
            [step_s / 5.0, step_s / 40.0]
                .into_iter()
                .try_fold(roughly, |roughly, step_s| {
                    let half = (FINE / 2) as f64;
                    let from_s = roughly.t_s - half * step_s;
                    let near = (0..FINE).map(|k| from_s + k as f64 * step_s);
                    best(near.filter_map(seen).chain([roughly]))
                })
        });
        tried.into_iter().flatten().collect()
    }

    /// A slip with what is felt of it while it lasts, at its best moment and length.
    fn closer(&self, event: Event, roughly: &Seen) -> Option<Seen> {
        let s = roughly.s;
        let later = self.later(event, roughly)?;
        let steps = (REACH_S / STEP_S) as i32;
        let near = |t_s: f64| (-steps..=steps).map(move |k| t_s + STEP_S * f64::from(k));
        let moments: Vec<f64> = near(roughly.t_s)
            .chain(self.loudest_s(s).into_iter().flat_map(near))
            .collect();
        let at = |t_s: f64, over_s: f64| self.slip(event, &later, (s, t_s), over_s);
        let over_s = if event == Event::Slip {
            SLIP_S
        } else {
            GIVES_S
        };
        let usual = best(
            in_parallel(moments.len(), |k| at(moments[k], over_s))
                .into_iter()
                .flatten(),
        )?;
        let others = OTHER_LENGTHS_S.map(|over_s| at(usual.t_s, over_s));
        best(others.into_iter().flatten().chain([usual]))
    }

    /// What the swings after a slip add.
    fn later(&self, event: Event, slip: &Seen) -> Option<Vec<(usize, Part)>> {
        let part = |later: usize| match event {
            Event::LineSlip => self.simulated(event, (slip.s, slip.t_s), GIVES_S, later),
            _ => Some(self.slipped[later].clone()),
        };
        self.after(event, slip.s)
            .map(|later| Some((later, part(later)?)))
            .collect()
    }

    /// What a swing adds for a slip of a length in that or an earlier one, by simulations.
    fn simulated(
        &self,
        event: Event,
        (s, t_s): (usize, f64),
        over_s: f64,
        swing: usize,
    ) -> Option<Part> {
        let cause = self.cause(event, (s, t_s));
        let mut at = self.standing.fitted.point.clone();
        at.causes.push(cause.start(self.times.len()));
        *at.causes.last_mut()?.last_mut()? = over_s.ln();
        let extended = self.standing.model.with(&cause);
        let strengths: Vec<usize> = (0..self.strength_u(event).len()).collect();
        part(self.standing, &extended, &at, swing, &strengths).ok()
    }

    /// The evidence for a slip of a length, with what is known of the swings after it.
    fn slip(
        &self,
        event: Event,
        later: &[(usize, Part)],
        (s, t_s): (usize, f64),
        over_s: f64,
    ) -> Option<Seen> {
        let mut equations = Equations::new(self.standing, self.strength_u(event));
        equations.add(s, &self.simulated(event, (s, t_s), over_s, s)?);
        later
            .iter()
            .for_each(|(later, part)| equations.add(*later, part));
        let Solved {
            strength,
            rest,
            gain,
        } = equations.solved(false)?;
        Some(Seen {
            s,
            t_s,
            over_s,
            gain,
            strength,
            rest,
        })
    }

    /// When most is left of a swing, s.
    fn loudest_s(&self, s: usize) -> Option<f64> {
        let left = &self.standing.residuals[s];
        let loudness = |block: &usize| left.rows(3 * block, 3).norm_squared();
        let loudest =
            (0..self.times[s].len()).max_by(|a, b| loudness(a).total_cmp(&loudness(b)))?;
        Some(self.times[s][loudest])
    }

    /// The swings after one in which an event is still seen.
    fn after(&self, event: Event, s: usize) -> impl Iterator<Item = usize> {
        let model = &self.standing.model;
        let is_seen = move |later: &usize| match event {
            Event::Slip => model.swing(*later).mount == model.swing(s).mount,
            Event::LineSlip => true,
            Event::Knock => false,
        };
        (s + 1..self.times.len()).filter(is_seen)
    }

    /// What a swing adds from each moment on.
    fn tails(&self, event: Event, s: usize) -> Tails {
        let columns = responses(self.standing, event, s);
        let jacobian = &self.standing.fitted.jacobians[s];
        let residual = &self.standing.residuals[s];
        let mut from: Vec<(f64, usize)> = self.times[s].iter().copied().zip(0..).collect();
        from.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut part = Part::nothing(jacobian.ncols(), columns.ncols());
        let mut parts = vec![part.clone()];
        for (_, block) in from.iter().rev() {
            (3 * block..3 * block + 3)
                .for_each(|row| part.add_row((jacobian, &columns), residual, row));
            parts.push(part.clone());
        }
        parts.reverse();
        Tails {
            times_s: from.into_iter().map(|(t_s, _)| t_s).collect(),
            parts,
        }
    }

    /// The evidence for an event at a moment of a swing, with what the swings after it add.
    fn seen(&self, event: Event, (s, t_s): (usize, f64), tails: &Tails) -> Option<Seen> {
        let mut equations = Equations::new(self.standing, self.strength_u(event));
        equations.add(s, tails.from(t_s));
        self.after(event, s)
            .for_each(|later| equations.add(later, &self.slipped[later]));
        let Solved {
            strength,
            rest,
            gain,
        } = equations.solved(false)?;
        Some(Seen {
            s,
            t_s,
            over_s: SLIP_S,
            gain,
            strength,
            rest,
        })
    }

    /// Standard deviations of what is sought before anything is seen. Of a knock the change of
    /// motion is, not its impulses.
    fn strength_u(&self, event: Event) -> DVector<f64> {
        if event == Event::Knock {
            return DVector::repeat(8, 0.03);
        }
        let cause = self.cause(event, (0, 0.0));
        let strengths = cause.parameters.iter().filter(|p| p.is_strength);
        DVector::from_vec(strengths.map(|p| p.prior.1).collect())
    }

    fn cause(&self, event: Event, (s, t_s): (usize, f64)) -> Cause {
        let mut cause = match event {
            Event::Slip => slip_at(s, t_s),
            Event::Knock => knock_at(&self.scales, s, t_s),
            Event::LineSlip => line_slip_at(&self.scales, s, t_s),
        };
        let start_s = self.standing.model.swing(s).samples.start_s;
        cause
            .parameters
            .iter_mut()
            .filter(|p| p.name == ParameterName::AtS)
            .for_each(|p| p.zero = start_s);
        cause
    }

    fn look(&self, event: Event, seen: Seen) -> Look {
        let cause = self.cause(event, (seen.s, seen.t_s));
        let mut values = vec![0.0; cause.size(self.standing.residuals.len())];
        // Strengths first, then the moment and the logarithm of the length. A knock's are not those
        // that were seen.
        if event != Event::Knock {
            let count = seen.strength.len();
            values[..count].copy_from_slice(seen.strength.as_slice());
            values[count + 1] = seen.over_s.ln() - cause.start(self.times.len())[count + 1];
        }
        let delta = laid_out(&self.standing.model, &seen.rest, &values);
        Look {
            cause,
            gain: seen.gain,
            delta,
            others: vec![],
            score_test: None,
        }
    }
}

/// What gains most.
fn best(seen: impl Iterator<Item = Seen>) -> Option<Seen> {
    seen.max_by(|a, b| a.gain.total_cmp(&b.gain))
}

struct Seen {
    s: usize,
    t_s: f64,
    /// Length of a slip, s.
    over_s: f64,
    gain: f64,
    strength: DVector<f64>,
    rest: DVector<f64>,
}
