//! Equations of motion of a rigid body on its lines.
//!
//! Six coordinates (centre of mass, attitude) and a force in each line. On lines of given length
//! the forces follow from the demand that the lengths are kept (index 1), and what numerical drift
//! is left is projected away; on elastic lines they are springs. Effects add forces, masses, and
//! states of their own (`memory`).
//!
//! # Conventions
//! The constraint of a line is (|q|² − l²)/2 = 0 with q from its upper to its lower end; its pull
//! on the body is −λ q, so that its tension is λ |q|.

use std::cell::Cell;
use std::ops::Range;

use super::effects::{AddedMass, Effect, Loads, Solved, Support};
use super::real::{Decomposed, M3, Real, V3, inverse, solve, times};
use super::state::{ATTITUDE, MEMORY, Now, PLACE, RATE, TIME, VELOCITY};
use super::suspended::{MOST_LINES, Spring, Suspended};

/// So far inside are the ends of an interval, shares of its length.
const ROOM: f64 = 1e-9;

/// The equations, ready to be evaluated.
pub(super) struct Equations<S: Real> {
    pub system: Suspended<S>,
    effects: Vec<(Box<dyn Effect<S>>, Range<usize>)>,
    /// Lower ends from the centre of mass, hull axes.
    points: Vec<V3<S>>,
    /// Where the lines take hold along the axis, −1 or 1.
    sides: Vec<f64>,
    inverse_mass: S,
    inverse_inertia: M3<S>,
    size: usize,
    has_added_mass: bool,
    /// Times that are meant by those at its ends and beyond, s.
    inside_s: Cell<[f64; 2]>,
}

/// How the lines take hold of the body.
struct Grip<S: Real> {
    count: usize,
    q: [V3<S>; MOST_LINES],
    /// Gradient with respect to a turn, hull axes.
    moment: [V3<S>; MOST_LINES],
    /// Accelerations by a unit pull: of the centre of mass (world), angular (hull axes).
    yields: [(V3<S>, V3<S>); MOST_LINES],
    /// G M⁻¹ Gᵀ.
    stiffness: [[S; MOST_LINES]; MOST_LINES],
}

/// Mass in its general form: rigid, or with masses that effects add.
#[allow(
    clippy::large_enum_variant,
    reason = "it lives for one evaluation, on the stack: a box would be an allocation for each"
)]
enum Mass<'a, S: Real> {
    Rigid {
        inverse_mass: S,
        inverse_inertia: &'a M3<S>,
    },
    Full {
        matrix: Decomposed<'a, S, 6>,
        turn: &'a M3<S>,
    },
}

impl<S: Real> Mass<'_, S> {
    /// Acceleration of the centre of mass (world) and angular acceleration (hull axes).
    fn accelerated(&self, force: &V3<S>, torque: &V3<S>) -> (V3<S>, V3<S>) {
        match self {
            Mass::Rigid {
                inverse_mass,
                inverse_inertia,
            } => (force * *inverse_mass, times(inverse_inertia, torque)),
            Mass::Full { matrix, turn } => {
                let f = turn.tr_mul(force);
                let x = matrix.solve(&[f.x, f.y, f.z, torque.x, torque.y, torque.z]);
                (
                    times(turn, &V3::new(x[0], x[1], x[2])),
                    V3::new(x[3], x[4], x[5]),
                )
            }
        }
    }
}

impl<S: Real> Equations<S> {
    pub fn new(mut system: Suspended<S>, effects: Vec<Box<dyn Effect<S>>>) -> Self {
        for effect in &effects {
            effect.set_up(&mut system);
        }
        let axis = system.axis();
        let mut size = MEMORY;
        let has_added_mass = effects.iter().any(|effect| effect.adds_mass());
        let placed = |effect: Box<dyn Effect<S>>| {
            let memory = size..size + effect.memory();
            size = memory.end;
            (effect, memory)
        };
        Self {
            effects: effects.into_iter().map(placed).collect(),
            points: system
                .cords
                .iter()
                .map(|cord| cord.point_m - system.cm_m)
                .collect(),
            sides: system.cords.iter().map(|cord| cord.side(&axis)).collect(),
            inverse_mass: S::one() / system.mass_kg,
            inverse_inertia: inverse(&system.inertia_kg_m2),
            system,
            size,
            has_added_mass,
            inside_s: Cell::new([f64::NEG_INFINITY, f64::INFINITY]),
        }
    }

    /// From now on the times at the ends of an interval count as inside of it: what begins or ends
    /// there has, or has not, begun or ended.
    pub fn keep_inside(&self, from_s: f64, to_s: f64) {
        let room_s = ROOM * (to_s - from_s);
        self.inside_s.set([from_s + room_s, to_s - room_s]);
    }

    fn now(&self, y: &[S]) -> Now<S> {
        let mut now = Now::at(y);
        let [from_s, to_s] = self.inside_s.get();
        let (t_s, inside_s) = (now.t_s.value(), now.t_s.value().clamp(from_s, to_s));
        if t_s != inside_s {
            now.t_s += S::constant(inside_s - t_s);
        }
        now
    }

    /// Length of the state.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The effects with their memories in the state.
    pub fn effects(&self) -> impl Iterator<Item = (&dyn Effect<S>, &Range<usize>)> {
        self.effects
            .iter()
            .map(|(effect, memory)| (effect.as_ref(), memory))
    }

    /// When things that happen once begin, s, and how long they last, s.
    pub fn events_s(&self) -> Vec<[f64; 2]> {
        let events = self
            .effects
            .iter()
            .filter_map(|(effect, _)| effect.event_s());
        events.filter(|[_, over_s]| *over_s > 0.0).collect()
    }

    /// Derivative of the state, and what was solved for on the way.
    pub fn slope(&self, y: &[S], out: &mut [S]) -> Solved<S> {
        let now = self.now(y);
        let rate = now.rate;
        let mut loads = Loads {
            force: V3::new(
                S::zero(),
                S::zero(),
                -(self.system.gravity_m_s2 * self.system.mass_kg),
            ),
            torque: -rate.cross(&times(&self.system.inertia_kg_m2, &rate)),
        };
        for (effect, memory) in &self.effects {
            effect.load(&now, &y[memory.clone()], &self.system, &mut loads);
        }
        let added = self.has_added_mass.then(|| self.added_mass(&now, y));
        let mass = match &added {
            None => self.rigid(),
            Some(added) => {
                loads.force += times(&now.turn, &added.force);
                loads.torque += added.torque;
                Mass::Full {
                    matrix: Decomposed::new(&added.matrix),
                    turn: &now.turn,
                }
            }
        };
        let support = self.support(&now, y);
        let grip = self.grip(&now, &mass, support.as_ref());
        let (acceleration, angular_acceleration) = mass.accelerated(&loads.force, &loads.torque);
        let mut solved = Solved {
            acceleration,
            angular_acceleration,
            ..Solved::default()
        };
        let pull = match &self.system.spring {
            Some(spring) => self.spring_pulls(spring, &now, &grip, support.as_ref()),
            None => self.constraint_pulls(&now, &grip, support.as_ref(), &solved),
        };
        for i in 0..grip.count {
            let (along, about) = &grip.yields[i];
            solved.acceleration -= along * pull[i];
            solved.angular_acceleration -= about * pull[i];
            solved.pull_on_support += grip.q[i] * pull[i];
            solved.tension_n[i] = pull[i] * grip.q[i].dot(&grip.q[i]).sqrt();
        }
        self.fill(&now, y, &solved, out);
        solved
    }

    fn fill(&self, now: &Now<S>, y: &[S], solved: &Solved<S>, out: &mut [S]) {
        out[TIME] = S::one();
        out[PLACE..PLACE + 3].copy_from_slice(now.velocity.as_slice());
        let (w, v) = (
            y[ATTITUDE],
            V3::new(y[ATTITUDE + 1], y[ATTITUDE + 2], y[ATTITUDE + 3]),
        );
        let turning = (now.rate * w + v.cross(&now.rate)).map(|x| x.scale(0.5));
        out[ATTITUDE] = v.dot(&now.rate).scale(-0.5);
        out[ATTITUDE + 1..VELOCITY].copy_from_slice(turning.as_slice());
        out[VELOCITY..RATE].copy_from_slice(solved.acceleration.as_slice());
        out[RATE..MEMORY].copy_from_slice(solved.angular_acceleration.as_slice());
        for (effect, memory) in &self.effects {
            effect.memory_slope(
                now,
                &y[memory.clone()],
                &self.system,
                solved,
                &mut out[memory.clone()],
            );
        }
    }

    fn rigid(&self) -> Mass<'_, S> {
        Mass::Rigid {
            inverse_mass: self.inverse_mass,
            inverse_inertia: &self.inverse_inertia,
        }
    }

    fn added_mass(&self, now: &Now<S>, y: &[S]) -> AddedMass<S> {
        let mut added = AddedMass::rigid(self.system.mass_kg, &self.system.inertia_kg_m2);
        for (effect, memory) in &self.effects {
            effect.add_mass(now, &y[memory.clone()], &self.system, &mut added);
        }
        added
    }

    pub fn support(&self, now: &Now<S>, y: &[S]) -> Option<Support<S>> {
        self.effects
            .iter()
            .find_map(|(effect, memory)| effect.support(now, &y[memory.clone()]))
    }

    fn grip(&self, now: &Now<S>, mass: &Mass<'_, S>, support: Option<&Support<S>>) -> Grip<S> {
        let count = self.points.len();
        let none = V3::zeros();
        let mut grip = Grip {
            count,
            q: [none; MOST_LINES],
            moment: [none; MOST_LINES],
            yields: [(none, none); MOST_LINES],
            stiffness: [[S::zero(); MOST_LINES]; MOST_LINES],
        };
        let shift = support.map_or(none, |s| s.offset);
        for i in 0..count {
            grip.q[i] = now.position + times(&now.turn, &self.points[i])
                - self.system.cords[i].top_m
                - shift;
            grip.moment[i] = self.points[i].cross(&now.turn.tr_mul(&grip.q[i]));
            grip.yields[i] = mass.accelerated(&grip.q[i], &grip.moment[i]);
        }
        for i in 0..count {
            for j in 0..=i {
                let (along, about) = &grip.yields[j];
                let mut w = grip.q[i].dot(along) + grip.moment[i].dot(about);
                if let Some(support) = support {
                    w += grip.q[i]
                        .component_mul(&support.inverse_mass)
                        .dot(&grip.q[j]);
                }
                grip.stiffness[i][j] = w;
                grip.stiffness[j][i] = w;
            }
        }
        grip
    }

    /// Velocity of the lower end of line `i` against its upper end, world axes.
    fn end_velocity(&self, now: &Now<S>, i: usize, support: Option<&Support<S>>) -> V3<S> {
        let top = support.map_or(V3::zeros(), |s| s.velocity);
        now.velocity + times(&now.turn, &now.rate.cross(&self.points[i])) - top
    }

    /// Multipliers that keep the lengths of the lines.
    fn constraint_pulls(
        &self,
        now: &Now<S>,
        grip: &Grip<S>,
        support: Option<&Support<S>>,
        free: &Solved<S>,
    ) -> [S; MOST_LINES] {
        let mut due = [S::zero(); MOST_LINES];
        for i in 0..grip.count {
            let speed = now.rate.cross(&self.points[i]);
            let centripetal = grip.q[i].dot(&times(&now.turn, &now.rate.cross(&speed)));
            let velocity = self.end_velocity(now, i, support);
            let [length, lengthening, growth] = self.length(now.t_s, i);
            due[i] = grip.q[i].dot(&free.acceleration)
                + grip.moment[i].dot(&free.angular_acceleration)
                + velocity.dot(&velocity)
                + centripetal
                - lengthening * lengthening
                - length * growth;
            if let Some(support) = support {
                due[i] -= grip.q[i].dot(&support.free_acceleration);
            }
        }
        solve_lines(&grip.stiffness, due, grip.count)
    }

    fn spring_pulls(
        &self,
        spring: &Spring<S>,
        now: &Now<S>,
        grip: &Grip<S>,
        support: Option<&Support<S>>,
    ) -> [S; MOST_LINES] {
        let mut pull = [S::zero(); MOST_LINES];
        for (i, pull) in pull.iter_mut().enumerate().take(grip.count) {
            let length = grip.q[i].dot(&grip.q[i]).sqrt();
            let [rest, ..] = self.length(now.t_s, i);
            let rate = grip.q[i].dot(&self.end_velocity(now, i, support)) / length;
            let tension = spring.stiffness_n_m * (length - rest) + spring.damping_n_s_m * rate;
            // A slack line pushes nothing.
            if tension.value() > 0.0 {
                *pull = tension / length;
            }
        }
        pull
    }

    /// Length of line `i` at a time, with its first and second derivative in time.
    pub fn length(&self, t_s: S, i: usize) -> [S; 3] {
        let mut law = [self.system.cords[i].length_m, S::zero(), S::zero()];
        for (effect, _) in &self.effects {
            effect.lengthen(t_s, &self.system.cords[i], self.sides[i], &mut law);
        }
        law
    }

    /// The state moved onto the constraints, positions first, then velocities: by the least change,
    /// as kinetic energy measures it. Elastic lines have no constraint.
    pub fn project(&self, y: &mut [S], iterations: usize) {
        let norm = (ATTITUDE..VELOCITY)
            .map(|i| y[i] * y[i])
            .fold(S::zero(), |sum, x| sum + x)
            .sqrt();
        y[ATTITUDE..VELOCITY].iter_mut().for_each(|x| *x /= norm);
        if self.system.spring.is_some() {
            return;
        }
        for _ in 0..iterations {
            self.project_lengths(y);
        }
        self.project_rates(y);
    }

    fn projecting(&self, y: &[S]) -> (Now<S>, Grip<S>, Option<Support<S>>) {
        let now = self.now(y);
        let mass = self.rigid();
        let support = self.support(&now, y);
        let still = support.as_ref().map(|s| Support {
            inverse_mass: V3::zeros(),
            ..*s
        });
        let grip = self.grip(&now, &mass, still.as_ref());
        (now, grip, support)
    }

    fn project_lengths(&self, y: &mut [S]) {
        let (now, grip, _) = self.projecting(y);
        let mut excess = [S::zero(); MOST_LINES];
        for i in 0..grip.count {
            let length = grip.q[i].dot(&grip.q[i]).sqrt();
            let [wanted, ..] = self.length(now.t_s, i);
            excess[i] = ((length - wanted) * (length + wanted)).scale(0.5);
        }
        let (shift, turn) = push(&grip, excess);
        for k in 0..3 {
            y[PLACE + k] -= shift[k];
        }
        // q ← q ⊗ (1, −θ/2), normalised: right to second order, which Newton's method mends.
        let (w, v) = (
            y[ATTITUDE],
            V3::new(y[ATTITUDE + 1], y[ATTITUDE + 2], y[ATTITUDE + 3]),
        );
        let half = turn.map(|x| x.scale(-0.5));
        let (w, v) = (w - v.dot(&half), v + half * w + v.cross(&half));
        let norm = S::one() / (w * w + v.dot(&v)).sqrt();
        y[ATTITUDE] = w * norm;
        y[ATTITUDE + 1..VELOCITY].copy_from_slice((v * norm).as_slice());
    }

    fn project_rates(&self, y: &mut [S]) {
        let (now, grip, support) = self.projecting(y);
        let mut stretching = [S::zero(); MOST_LINES];
        for i in 0..grip.count {
            let [length, lengthening, _] = self.length(now.t_s, i);
            stretching[i] =
                grip.q[i].dot(&self.end_velocity(&now, i, support.as_ref())) - length * lengthening;
        }
        let (shift, turn) = push(&grip, stretching);
        for k in 0..3 {
            y[VELOCITY + k] -= shift[k];
            y[RATE + k] -= turn[k];
        }
    }
}

fn solve_lines<S: Real>(
    stiffness: &[[S; MOST_LINES]; MOST_LINES],
    mut due: [S; MOST_LINES],
    count: usize,
) -> [S; MOST_LINES] {
    if count == 2 {
        let [[a, b, ..], [_, d, ..], ..] = *stiffness;
        let inverse = S::one() / (a * d - b * b);
        let [x, y, ..] = due;
        due[0] = (d * x - b * y) * inverse;
        due[1] = (a * y - b * x) * inverse;
        return due;
    }
    solve(&mut stiffness.clone(), &mut due, count);
    due
}

/// The least change that moves the constraints by `amount`.
fn push<S: Real>(grip: &Grip<S>, amount: [S; MOST_LINES]) -> (V3<S>, V3<S>) {
    let mu = solve_lines(&grip.stiffness, amount, grip.count);
    let mut change = (V3::zeros(), V3::zeros());
    for i in 0..grip.count {
        change.0 += grip.yields[i].0 * mu[i];
        change.1 += grip.yields[i].1 * mu[i];
    }
    change
}
