//! The start of a motion on the lines: the free coordinates are given, the others follow.

use super::equations::Equations;
use super::numbers::numbers;
use super::real::{M3, Real, V3, constant, solve};
use super::rig::Hanging;
use super::state::{ATTITUDE, MEMORY, Now, PLACE, RATE, VELOCITY, matrix};
use super::suspended::MOST_LINES;
use gyradius_base::error::{Error, Result};

/// Newton's method needs about five; a start that needs more than these has no place near it.
const ITERATIONS: usize = 30;
/// Once the numbers stand, so many more iterations bring the derivatives: Newton's method gives
/// them exactly.
const FOR_DERIVATIVES: usize = 2;

/// Rounds that bring a support that gives way to rest: each gains at least a digit or two.
const SETTLING: usize = 12;

numbers! {
    /// Where the motion begins: the coordinates that the lines leave free.
    pub struct Start {
        /// Mid-point of the suspension points, along the axis.
        along_m: "m",
        /// The same, across (bifilar).
        across_m: "m",
        /// Turn about the axis.
        turn_rad: "rad",
        /// Turn about the vertical (bifilar).
        yaw_rad: "rad",
        /// Rate of `along_m`.
        along_m_s: "m/s",
        /// Rate of `across_m`.
        across_m_s: "m/s",
        /// Rate of `turn_rad`.
        turn_rad_s: "rad/s",
        /// Rate of `yaw_rad`.
        yaw_rad_s: "rad/s",
    }
}

/// A coordinate: a translation or a turn, world axes, at the mid-point of the suspension points.
#[derive(Clone, Copy)]
enum Coordinate {
    Along,
    Across,
    Heave,
    Turn,
    Roll,
    Yaw,
}
use Coordinate::{Across, Along, Heave, Roll, Turn, Yaw};

const ALL: [Coordinate; 6] = [Along, Across, Heave, Turn, Roll, Yaw];

/// The coordinates that the lines decide, one for each line.
fn bound(hanging: Hanging) -> &'static [Coordinate] {
    match hanging {
        Hanging::Bifilar(_) => &[Heave, Roll],
        Hanging::Compound(_) => &[Heave, Roll, Across, Yaw],
    }
}

struct Chart<S: Real> {
    axis: V3<S>,
    across: V3<S>,
    /// Values in the order of [`ALL`].
    at: [S; 6],
    /// Of the upper ends, world axes.
    shift: V3<S>,
}

impl<S: Real> Chart<S> {
    fn quaternion(&self) -> [S; 4] {
        let about = |axis: &V3<S>, angle: S| {
            let half = angle.scale(0.5);
            let v = axis * half.sin();
            [half.cos(), v.x, v.y, v.z]
        };
        let yaw = about(&V3::z(), self.at[Yaw as usize]);
        let roll = about(&self.across, self.at[Roll as usize]);
        product(
            &yaw,
            &product(&roll, &about(&self.axis, self.at[Turn as usize])),
        )
    }

    fn middle(&self) -> V3<S> {
        self.axis * self.at[Along as usize]
            + self.across * self.at[Across as usize]
            + V3::z() * self.at[Heave as usize]
    }

    /// Unit translation and unit turn of a coordinate, world axes.
    fn direction(&self, coordinate: Coordinate) -> (V3<S>, V3<S>) {
        let none = V3::zeros();
        let yawed = |v: &V3<S>| {
            let (sin, cos) = (self.at[Yaw as usize].sin(), self.at[Yaw as usize].cos());
            V3::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos, v.z)
        };
        match coordinate {
            Along => (self.axis, none),
            Across => (self.across, none),
            Heave => (V3::z(), none),
            Yaw => (none, V3::z()),
            Roll => (none, yawed(&self.across)),
            Turn => {
                let roll = self.at[Roll as usize];
                let rolled = self.axis * roll.cos() + self.across.cross(&self.axis) * roll.sin();
                (none, yawed(&rolled))
            }
        }
    }
}

fn product<S: Real>(p: &[S; 4], q: &[S; 4]) -> [S; 4] {
    let (a, b) = (V3::new(p[1], p[2], p[3]), V3::new(q[1], q[2], q[3]));
    let v = b * p[0] + a * q[0] + a.cross(&b);
    [p[0] * q[0] - a.dot(&b), v.x, v.y, v.z]
}

/// The state at the start; a support that gives way stands where the lines' pull holds it.
pub(super) fn started<S: Real>(
    equations: &Equations<S>,
    hanging: Hanging,
    start: &Start<S>,
) -> Result<Vec<S>> {
    let mut y = placed(equations, hanging, start, &V3::zeros())?;
    for (effect, memory) in equations.effects() {
        effect.memory_given(&mut y[memory.clone()]);
    }
    if equations.support(&Now::at(&y), &y).is_none() {
        return Ok(y);
    }
    let mut slope = vec![S::zero(); equations.size()];
    for _ in 0..SETTLING {
        let solved = equations.slope(&y, &mut slope);
        let memories = &mut slope[MEMORY..];
        memories.fill(S::zero());
        for (effect, memory) in equations.effects() {
            let own = &mut memories[memory.start - MEMORY..memory.end - MEMORY];
            effect.memory_given(own);
            effect.memory_start(&solved, own);
        }
        let settled = memories.to_vec();
        y[MEMORY..].copy_from_slice(&settled);
        let shift = equations
            .support(&Now::at(&y), &y)
            .map_or(V3::zeros(), |support| support.offset);
        y = placed(equations, hanging, start, &shift)?;
        y[MEMORY..].copy_from_slice(&settled);
    }
    Ok(y)
}

/// The state at the start under upper ends that are shifted, without memories.
fn placed<S: Real>(
    equations: &Equations<S>,
    hanging: Hanging,
    start: &Start<S>,
    shift: &V3<S>,
) -> Result<Vec<S>> {
    let system = &equations.system;
    let axis: V3<S> = constant(&hanging.axis().unit());
    let zero = S::zero();
    let drop = system
        .cords
        .iter()
        .map(|c| (c.length_m * c.length_m - squared(&(c.top_m - c.point_m))).sqrt());
    let heave = -drop
        .fold(zero, |sum, x| sum + x)
        .scale(1.0 / system.cords.len() as f64);
    let mut chart = Chart {
        across: axis.cross(&V3::z()),
        axis,
        at: [
            start.along_m,
            start.across_m,
            heave,
            start.turn_rad,
            zero,
            start.yaw_rad,
        ],
        shift: *shift,
    };
    let bound = bound(hanging);
    let lengths = hung_lengths(equations);
    let mut left = ITERATIONS;
    while left > 0 {
        let worst = newton(equations, &mut chart, bound, &lengths);
        left -= 1;
        if !worst.is_finite() {
            break;
        }
        if worst < 1e-13 && left > FOR_DERIVATIVES {
            left = FOR_DERIVATIVES;
        } else if left == 0 && worst < 1e-12 {
            return Ok(state(equations, &chart, bound, start));
        }
    }
    Err(Error::no_result(
        "start of the motion",
        "the lines cannot reach the body there",
    ))
}

/// Lengths of the lines under the body's weight.
fn hung_lengths<S: Real>(equations: &Equations<S>) -> Vec<S> {
    let system = &equations.system;
    let share = (system.mass_kg * system.gravity_m_s2).scale(1.0 / system.cords.len() as f64);
    let stretch = system
        .spring
        .as_ref()
        .map_or(S::zero(), |spring| share / spring.stiffness_n_m);
    (0..system.cords.len())
        .map(|i| equations.length(S::zero(), i)[0] + stretch)
        .collect()
}

fn squared<S: Real>(v: &V3<S>) -> S {
    v.dot(v)
}

/// From the upper to the lower ends, and from the mid-point to the lower ends, world axes.
fn reaches<S: Real>(equations: &Equations<S>, chart: &Chart<S>) -> Vec<(V3<S>, V3<S>)> {
    let turn: M3<S> = matrix(&chart.quaternion());
    let middle = chart.middle();
    let reach = |arm: V3<S>, top: &V3<S>| (middle + arm - top - chart.shift, arm);
    equations
        .system
        .cords
        .iter()
        .map(|cord| reach(turn * cord.point_m, &cord.top_m))
        .collect()
}

/// How each bound coordinate changes (|q|² − l²)/2 of each line.
fn jacobian<S: Real>(
    chart: &Chart<S>,
    reaches: &[(V3<S>, V3<S>)],
    bound: &[Coordinate],
) -> [[S; MOST_LINES]; MOST_LINES] {
    let mut matrix = [[S::zero(); MOST_LINES]; MOST_LINES];
    for (i, (q, arm)) in reaches.iter().enumerate() {
        for (j, coordinate) in bound.iter().enumerate() {
            let (shift, turn) = chart.direction(*coordinate);
            matrix[i][j] = q.dot(&(shift + turn.cross(arm)));
        }
    }
    matrix
}

/// One step; returns the largest relative misfit of a length before it.
fn newton<S: Real>(
    equations: &Equations<S>,
    chart: &mut Chart<S>,
    bound: &[Coordinate],
    lengths: &[S],
) -> f64 {
    let reaches = reaches(equations, chart);
    let mut excess = [S::zero(); MOST_LINES];
    let mut worst: f64 = 0.0;
    for (i, ((q, _), wanted)) in reaches.iter().zip(lengths).enumerate() {
        let length = squared(q).sqrt();
        excess[i] = ((length - *wanted) * (length + *wanted)).scale(0.5);
        worst = worst.max((length.value() / wanted.value() - 1.0).abs());
        if !length.value().is_finite() {
            return f64::NAN;
        }
    }
    solve(
        &mut jacobian(chart, &reaches, bound),
        &mut excess,
        bound.len(),
    );
    for (coordinate, change) in bound.iter().zip(excess) {
        chart.at[*coordinate as usize] -= change;
    }
    worst
}

fn state<S: Real>(
    equations: &Equations<S>,
    chart: &Chart<S>,
    bound: &[Coordinate],
    start: &Start<S>,
) -> Vec<S> {
    let zero = S::zero();
    let mut rates = [
        start.along_m_s,
        start.across_m_s,
        zero,
        start.turn_rad_s,
        zero,
        start.yaw_rad_s,
    ];
    let reaches = reaches(equations, chart);
    bound.iter().for_each(|c| rates[*c as usize] = zero);
    let motion = |rates: &[S; 6]| {
        ALL.iter().zip(rates).fold(
            (V3::zeros(), V3::zeros()),
            |(v, w): (V3<S>, V3<S>), (c, rate)| {
                let (shift, turn) = chart.direction(*c);
                (v + shift * *rate, w + turn * *rate)
            },
        )
    };
    let (v, w) = motion(&rates);
    let mut stretching = [zero; MOST_LINES];
    for (i, (q, arm)) in reaches.iter().enumerate() {
        let [length, lengthening, _] = equations.length(zero, i);
        stretching[i] = q.dot(&(v + w.cross(arm))) - length * lengthening;
    }
    solve(
        &mut jacobian(chart, &reaches, bound),
        &mut stretching,
        bound.len(),
    );
    bound
        .iter()
        .zip(stretching)
        .for_each(|(c, rate)| rates[*c as usize] = -rate);
    let (v, w) = motion(&rates);
    let attitude = chart.quaternion();
    let turn: M3<S> = matrix(&attitude);
    let arm = turn * equations.system.cm_m;
    let mut y = vec![zero; equations.size()];
    y[PLACE..PLACE + 3].copy_from_slice((chart.middle() + arm).as_slice());
    y[ATTITUDE..VELOCITY].copy_from_slice(&attitude);
    y[VELOCITY..RATE].copy_from_slice((v + w.cross(&arm)).as_slice());
    y[RATE..RATE + 3].copy_from_slice(turn.tr_mul(&w).as_slice());
    y
}
