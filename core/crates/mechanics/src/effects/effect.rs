//! The law of an effect: what it does to a body on its lines.

use std::fmt::Debug;

use crate::numbers::Number;
use crate::real::{M3, Real, V3};
use crate::state::Now;
use crate::suspended::{Cord, MOST_LINES, Suspended};

/// Force and torque on the body beside the lines' pull.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Loads<S: Real> {
    /// At the centre of mass, world axes, N.
    pub force: V3<S>,
    /// About the centre of mass, hull axes, N m.
    pub torque: V3<S>,
}

/// Masses that move with the body, and the forces that come with them; hull axes throughout.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AddedMass<S: Real> {
    /// Of `[acceleration of the centre of mass; angular acceleration]`.
    pub matrix: [[S; 6]; 6],
    /// N.
    pub force: V3<S>,
    /// N m.
    pub torque: V3<S>,
}

impl<S: Real> AddedMass<S> {
    pub(crate) fn rigid(mass_kg: S, inertia: &M3<S>) -> Self {
        let mut matrix = [[S::zero(); 6]; 6];
        for i in 0..3 {
            matrix[i][i] = mass_kg;
            for j in 0..3 {
                matrix[3 + i][3 + j] = inertia[(i, j)];
            }
        }
        Self {
            matrix,
            force: V3::zeros(),
            torque: V3::zeros(),
        }
    }

    /// A mass for each axis of the centre of mass and an inertia about each.
    pub fn add_diagonal(&mut self, mass_kg: &V3<S>, inertia_kg_m2: &V3<S>) {
        for i in 0..3 {
            self.matrix[i][i] += mass_kg[i];
            self.matrix[3 + i][3 + i] += inertia_kg_m2[i];
        }
    }

    /// A mass at `arm` from the centre of mass that moves with the body, and a force on it.
    ///
    /// Its acceleration is a + ω̇ × r + ω × (ω × r).
    pub fn add_point(&mut self, mass_kg: S, arm: &V3<S>, force: &V3<S>, now: &Now<S>) {
        let m = arm * mass_kg;
        let zero = S::zero();
        let turned = [[zero, -m.z, m.y], [m.z, zero, -m.x], [-m.y, m.x, zero]];
        let square = m.dot(arm);
        for i in 0..3 {
            self.matrix[i][i] += mass_kg;
            self.matrix[3 + i][3 + i] += square;
            for j in 0..3 {
                self.matrix[i][3 + j] -= turned[i][j];
                self.matrix[3 + i][j] += turned[i][j];
                self.matrix[3 + i][3 + j] -= m[i] * arm[j];
            }
        }
        let force = force - now.rate.cross(&now.rate.cross(&m));
        self.force += force;
        self.torque += arm.cross(&force);
    }

    /// Lets a mass that was added move freely along a unit vector through where it is; `about` is
    /// its arm × that vector. What holds it there instead pulls at the body along that line.
    pub fn free_along(&mut self, mass_kg: S, along: &V3<S>, about: &V3<S>, pull: S) {
        let way = [along.x, along.y, along.z, about.x, about.y, about.z];
        for i in 0..6 {
            let m = way[i] * mass_kg;
            for j in 0..6 {
                self.matrix[i][j] -= m * way[j];
            }
        }
        self.force += along * pull;
        self.torque += about * pull;
    }
}

/// A support that moves: the upper ends of all lines together.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Support<S: Real> {
    /// World axes, m.
    pub offset: V3<S>,
    /// m/s.
    pub velocity: V3<S>,
    /// What it would have without the lines' pull, m/s².
    pub free_acceleration: V3<S>,
    /// Acceleration per force along each world axis, 1/kg.
    pub inverse_mass: V3<S>,
}

/// What the equations of motion were solved for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Solved<S: Real> {
    /// Of the centre of mass, world axes, m/s².
    pub acceleration: V3<S>,
    /// Hull axes, rad/s².
    pub angular_acceleration: V3<S>,
    /// Force of all lines on what they hang from, world axes, N.
    pub pull_on_support: V3<S>,
    /// Tension of each line, N.
    pub tension_n: [S; MOST_LINES],
}

impl<S: Real> Default for Solved<S> {
    fn default() -> Self {
        let none = V3::zeros();
        Self {
            acceleration: none,
            angular_acceleration: none,
            pull_on_support: none,
            tension_n: [S::zero(); 4],
        }
    }
}

/// The law of an effect. Every part is optional.
pub(crate) trait Effect<S: Real>: Debug {
    /// Changes the rig or the body before the motion begins.
    fn set_up(&self, _system: &mut Suspended<S>) {}
    /// Force and torque.
    fn load(&self, _now: &Now<S>, _memory: &[S], _system: &Suspended<S>, _loads: &mut Loads<S>) {}
    /// Whether [`Effect::add_mass`] does anything.
    fn adds_mass(&self) -> bool {
        false
    }
    /// Mass, and the forces that belong to it.
    fn add_mass(
        &self,
        _now: &Now<S>,
        _memory: &[S],
        _system: &Suspended<S>,
        _mass: &mut AddedMass<S>,
    ) {
    }
    /// Adds to a line's length and its first two derivatives in time; `side` is where it takes hold
    /// of the body, −1 or 1.
    fn lengthen(&self, _t_s: S, _cord: &Cord<S>, _side: f64, _law: &mut [S; 3]) {}
    /// The moving support, where the effect is one.
    fn support(&self, _now: &Now<S>, _memory: &[S]) -> Option<Support<S>> {
        None
    }
    /// How many states of its own it has; they begin at zero unless [`Effect::memory_given`] says
    /// otherwise.
    fn memory(&self) -> usize {
        0
    }
    /// Its states at the start.
    fn memory_given(&self, _memory: &mut [S]) {}
    /// Where a support stands at the start, given what pulls at it.
    fn memory_start(&self, _solved: &Solved<S>, _memory: &mut [S]) {}
    /// Derivatives of its states in time.
    fn memory_slope(
        &self,
        _now: &Now<S>,
        _memory: &[S],
        _system: &Suspended<S>,
        _solved: &Solved<S>,
        _out: &mut [S],
    ) {
    }
    /// Fastest angular frequency that it brings in, rad/s: the step of the integration follows it.
    fn fastest_rad_s(&self, _system: &Suspended<S>) -> f64 {
        0.0
    }
    /// Where it is something that happens once: when it begins, s, and how long it lasts, s. Steps
    /// end there, and are short against it.
    fn event_s(&self) -> Option<[f64; 2]> {
        None
    }
}

/// What is told of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectKind {
    /// Name in files.
    pub id: &'static str,
    /// Its numbers.
    pub numbers: &'static [Number],
    /// Names of those that must be larger than zero.
    pub positive: &'static [&'static str],
    /// Whether its law has a kink, or nearly one, where a velocity changes its sign: derivatives
    /// then need smaller steps.
    pub kinked: bool,
}

/// What is told of an effect, as a type.
pub trait Described {
    /// Name in files: the cause's name in the criticism.
    const ID: &'static str;
    /// Names of the numbers that must be larger than zero: those divided by.
    const POSITIVE: &'static [&'static str] = &[];
    /// Whether the law has a kink, or nearly one, where a velocity changes its sign.
    const KINKED: bool = false;
}
