//! What the simple theory leaves out, each effect a named part that is switched on by listing it.
//!
//! An effect is a structure of named numbers ([`Numbers`]) with a law ([`Effect`]), in a file of its own, and a line in
//! the registry below.
//!
//! # Conventions
//! Hull axes: x forward, y to port, z up. Forces act at the centre of mass, torques about it. Surge, sway and heave are
//! motions along x, y, z; roll, pitch and yaw turn about them.

use std::fmt::Debug;

use super::numbers::{Number, Numbers};
use super::real::{M3, Real, V3};
use super::suspended::{ATTITUDE, Cord, PLACE, RATE, Suspended, TIME, VELOCITY};
use crate::error::{Error, Result};

mod linear_damping;

pub use linear_damping::LinearDamping;

/// The body at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Now<S: Real> {
    /// Time, s.
    pub t_s: S,
    /// Centre of mass, world axes, m.
    pub position: V3<S>,
    /// `world_from_hull`.
    pub turn: M3<S>,
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity: V3<S>,
    /// Angular rate, hull axes, rad/s.
    pub rate: V3<S>,
}

impl<S: Real> Now<S> {
    pub(super) fn at(y: &[S]) -> Self {
        let part = |i: usize| V3::new(y[i], y[i + 1], y[i + 2]);
        Self {
            t_s: y[TIME],
            position: part(PLACE),
            turn: matrix(&y[ATTITUDE..VELOCITY]),
            velocity: part(VELOCITY),
            rate: part(RATE),
        }
    }

    /// Velocity of the centre of mass, hull axes, m/s.
    pub fn velocity_hull(&self) -> V3<S> {
        self.turn.tr_mul(&self.velocity)
    }

    /// Heading: the angle of the hull's x axis about the vertical, rad.
    pub fn heading(&self) -> S {
        self.turn[(1, 0)].atan2(self.turn[(0, 0)])
    }
}

/// Rotation matrix of a quaternion w, x, y, z; its size is divided out.
pub(super) fn matrix<S: Real>(q: &[S]) -> M3<S> {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    let two = S::constant(2.0) / (w * w + x * x + y * y + z * z);
    let (xs, ys, zs) = (x * two, y * two, z * two);
    let (wx, wy, wz) = (w * xs, w * ys, w * zs);
    let (xx, xy, xz) = (x * xs, x * ys, x * zs);
    let (yy, yz, zz) = (y * ys, y * zs, z * zs);
    let one = S::one();
    M3::new(
        one - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        one - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        one - (xx + yy),
    )
}

/// Force and torque on the body beside the lines' pull.
#[derive(Debug, Clone, Copy)]
pub struct Loads<S: Real> {
    /// At the centre of mass, world axes, N.
    pub force: V3<S>,
    /// About the centre of mass, hull axes, N m.
    pub torque: V3<S>,
}

/// Masses that move with the body, and the forces that come with them; hull axes throughout.
#[derive(Debug, Clone, Copy)]
pub struct AddedMass<S: Real> {
    /// Of `[acceleration of the centre of mass; angular acceleration]`.
    pub matrix: [[S; 6]; 6],
    /// N.
    pub force: V3<S>,
    /// N m.
    pub torque: V3<S>,
}

impl<S: Real> AddedMass<S> {
    pub(super) fn rigid(mass_kg: S, inertia: &M3<S>) -> Self {
        let mut matrix = [[S::zero(); 6]; 6];
        for i in 0..3 {
            matrix[i][i] = mass_kg;
            for j in 0..3 {
                matrix[3 + i][3 + j] = inertia[(i, j)];
            }
        }
        Self { matrix, force: V3::zeros(), torque: V3::zeros() }
    }
}

/// A support that moves: the upper ends of all lines together.
#[derive(Debug, Clone, Copy)]
pub struct Support<S: Real> {
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
pub struct Solved<S: Real> {
    /// Of the centre of mass, world axes, m/s².
    pub acceleration: V3<S>,
    /// Hull axes, rad/s².
    pub angular_acceleration: V3<S>,
    /// Force of all lines on what they hang from, world axes, N.
    pub pull_on_support: V3<S>,
    /// Tension of each line, N.
    pub tension_n: [S; super::suspended::MOST_LINES],
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
pub trait Effect<S: Real>: Debug {
    /// Changes the rig or the body before the motion begins.
    fn set_up(&self, _system: &mut Suspended<S>) {}
    /// Force and torque.
    fn load(&self, _now: &Now<S>, _memory: &[S], _system: &Suspended<S>, _loads: &mut Loads<S>) {}
    /// Whether [`Effect::add_mass`] does anything.
    fn adds_mass(&self) -> bool {
        false
    }
    /// Mass, and the forces that belong to it.
    fn add_mass(&self, _now: &Now<S>, _memory: &[S], _system: &Suspended<S>, _mass: &mut AddedMass<S>) {}
    /// Adds to a line's length and its first two derivatives in time.
    fn lengthen(&self, _t_s: S, _cord: &Cord<S>, _law: &mut [S; 3]) {}
    /// The moving support, where the effect is one.
    fn support(&self, _now: &Now<S>, _memory: &[S]) -> Option<Support<S>> {
        None
    }
    /// How many states of its own it has; they begin at zero.
    fn memory(&self) -> usize {
        0
    }
    /// Their derivatives in time.
    fn memory_slope(&self, _now: &Now<S>, _memory: &[S], _solved: &Solved<S>, _out: &mut [S]) {}
    /// Fastest angular frequency that it brings in, rad/s: the step of the integration follows it.
    fn fastest_rad_s(&self, _system: &Suspended<S>) -> f64 {
        0.0
    }
}

/// What is told of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectKind {
    /// Name in files.
    pub id: &'static str,
    /// What it is, for a report.
    pub sentence: &'static str,
    /// Its numbers.
    pub numbers: &'static [Number],
}

/// What is told of an effect, as a type.
pub trait Described {
    /// Name in files: the cause's name in the criticism.
    const ID: &'static str;
    /// What it is, for a report.
    const SENTENCE: &'static str;
}

/// An effect and the values of its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectValues {
    /// What it is.
    pub kind: EffectKind,
    /// Values in the order of `kind.numbers`.
    pub values: Vec<f64>,
}

impl EffectValues {
    /// The effect `id` with the values given, the others zero.
    pub fn new(id: &str, given: &[(&str, f64)]) -> Result<Self> {
        let kinds = catalogue();
        let known = || kinds.iter().map(|k| k.id).collect::<Vec<_>>().join(", ");
        let kind =
            *kinds.iter().find(|k| k.id == id).ok_or_else(|| Error::argument("effect", known(), id))?;
        let mut values = vec![0.0; kind.numbers.len()];
        for (name, value) in given {
            let names = || kind.numbers.iter().map(|n| n.name).collect::<Vec<_>>().join(", ");
            let place = kind.numbers.iter().position(|n| n.name == *name);
            let place = place.ok_or_else(|| Error::argument(id, names(), name))?;
            values[place] = *value;
        }
        Ok(Self { kind, values })
    }
}

macro_rules! registry {
    ($($effect:ident),* $(,)?) => {
        /// Every effect that there is.
        pub fn catalogue() -> Vec<EffectKind> {
            vec![$(EffectKind {
                id: $effect::<f64>::ID,
                sentence: $effect::<f64>::SENTENCE,
                numbers: <$effect<f64> as Numbers<f64>>::NUMBERS,
            }),*]
        }

        /// The law of the effect `id` with its numbers; `None` for an unknown one or too few numbers.
        pub(super) fn build<S: Real>(id: &str, numbers: &mut dyn Iterator<Item = S>) -> Option<Box<dyn Effect<S>>> {
            $(if id == $effect::<f64>::ID {
                return Some(Box::new($effect::<S>::from_numbers(numbers)?));
            })*
            None
        }
    };
}

registry! {
    LinearDamping,
}
