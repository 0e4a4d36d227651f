//! The motion in time, as a curve that can be read at any time.

use super::dop853::{COEFFICIENTS, Stepper, between};
use super::effects::matrix;
use super::real::{M3, Real, V3};
use super::suspended::{ATTITUDE, Equations, MEMORY, PLACE, RATE, VELOCITY};
use crate::error::{Error, Result};

/// A line that went slack: lines of given length then go on as rods, and what follows is not to be used; elastic lines
/// go on as they should.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// When its tension first vanished, s.
    pub t_s: f64,
    /// Which line.
    pub line: usize,
}

/// A motion from time 0 on.
#[derive(Debug, Clone)]
pub struct Path<S: Real> {
    step_s: f64,
    steps: usize,
    coefficients: Vec<[S; COEFFICIENTS]>,
    /// First slack line, if any.
    pub slack: Option<Slack>,
    /// Centre of mass, hull axes, from the mid-point of the suspension points, m.
    pub cm_m: V3<S>,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: S,
}

/// The body at one instant of its path.
#[derive(Debug, Clone, Copy)]
pub struct Moment<S: Real> {
    /// Centre of mass, world axes, m.
    pub position: V3<S>,
    /// Quaternion w, x, y, z, `world_from_hull`, of unit size to rounding at the ends of steps.
    pub attitude: [S; 4],
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity: V3<S>,
    /// Angular rate, hull axes, rad/s.
    pub rate: V3<S>,
    /// Acceleration of the centre of mass, world axes, m/s².
    pub acceleration: V3<S>,
    /// Angular acceleration, hull axes, rad/s².
    pub angular_acceleration: V3<S>,
}

impl<S: Real> Moment<S> {
    /// `world_from_hull`.
    pub fn turn(&self) -> M3<S> {
        matrix(&self.attitude)
    }

    /// The same place, held still.
    pub fn stopped(&self) -> Self {
        let still = V3::zeros();
        let (velocity, rate, acceleration, angular_acceleration) = (still, still, still, still);
        Self { velocity, rate, acceleration, angular_acceleration, ..*self }
    }
}

/// Newton steps onto the constraints after each step of the integration: it leaves them by rounding or a little more.
const PROJECTIONS: usize = 1;

/// A path of more steps would take a gigabyte.
const MOST_STEPS: f64 = 1e6;

impl<S: Real> Path<S> {
    /// Integrates from `start`, which keeps the constraints already, over `duration_s` in steps of `step_s`.
    pub(super) fn integrate(
        equations: &Equations<S>,
        start: Vec<S>,
        duration_s: f64,
        step_s: f64,
    ) -> Result<Self> {
        for (name, value) in [("duration_s", duration_s), ("step_s", step_s)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::argument(name, "a positive number", value));
            }
        }
        let steps = (duration_s / step_s).ceil();
        if steps > MOST_STEPS {
            return Err(Error::no_result(
                "motion",
                format!("{duration_s} s in steps of {step_s} s is too long"),
            ));
        }
        let steps = steps as usize;
        let size = equations.size();
        let mut path = Self {
            step_s,
            steps,
            coefficients: Vec::with_capacity(steps * MEMORY),
            slack: None,
            cm_m: equations.system.cm_m,
            gravity_m_s2: equations.system.gravity_m_s2,
        };
        let mut f = |y: &[S], out: &mut [S]| {
            equations.slope(y, out);
        };
        let mut stepper = Stepper::new(size);
        let (mut y, mut end, mut end_slope) = (start, vec![S::zero(); size], vec![S::zero(); size]);
        let mut before = equations.slope(&y, stepper.first_slope()).tension_n.map(Real::value);
        for n in 0..steps {
            stepper.advance(&mut f, &y, step_s, &mut end);
            equations.project(&mut end, PROJECTIONS);
            let after = equations.slope(&end, &mut end_slope).tension_n.map(Real::value);
            let from_s = n as f64 * step_s;
            if !end.iter().all(|x| x.value().is_finite()) {
                return Err(Error::no_result("motion", format!("it cannot be continued after {from_s} s")));
            }
            stepper.between(&mut f, (&y, &end), &end_slope, step_s, MEMORY, &mut path.coefficients);
            path.note_slack(from_s, &before, &after, equations.system.cords.len());
            std::mem::swap(&mut y, &mut end);
            before = after;
        }
        Ok(path)
    }

    /// Keeps the first zero of a tension, by a straight line between the ends of the step.
    fn note_slack(&mut self, from_s: f64, before: &[f64], after: &[f64], count: usize) {
        if self.slack.is_some() {
            return;
        }
        let zero = |line: usize| {
            let (b, a) = (before[line], after[line]);
            let part = if b > a { (b / (b - a)).clamp(0.0, 1.0) } else { 0.0 };
            (a <= 0.0).then_some(Slack { t_s: from_s + part * self.step_s, line })
        };
        self.slack = (0..count).filter_map(zero).min_by(|a, b| a.t_s.total_cmp(&b.t_s));
    }

    /// Length, s.
    pub fn duration_s(&self) -> f64 {
        self.steps as f64 * self.step_s
    }

    /// The body at `t_s`; outside of the path its first or last step is continued.
    pub fn at(&self, t_s: f64) -> Moment<S> {
        let step = ((t_s / self.step_s) as usize).min(self.steps - 1);
        let x = t_s / self.step_s - step as f64;
        let parts = &self.coefficients[step * MEMORY..(step + 1) * MEMORY];
        let value = |i: usize| between(&parts[i], x).0;
        let slope = |i: usize| between(&parts[i], x).1.scale(1.0 / self.step_s);
        let vector = |i: usize, of: &dyn Fn(usize) -> S| V3::new(of(i), of(i + 1), of(i + 2));
        Moment {
            position: vector(PLACE, &value),
            attitude: [0, 1, 2, 3].map(|i| value(ATTITUDE + i)),
            velocity: vector(VELOCITY, &value),
            rate: vector(RATE, &value),
            acceleration: vector(VELOCITY, &slope),
            angular_acceleration: vector(RATE, &slope),
        }
    }

    /// The state at the end of step `n`, without the effects' memories.
    pub fn knot(&self, n: usize) -> Moment<S> {
        self.at(n as f64 * self.step_s)
    }
}
