//! What the simple theory leaves out, each effect a named part that is switched on by listing it.
//!
//! An effect is a structure of named numbers ([`Numbers`]) with a law ([`Effect`]), in a file of
//! its own, and a line in the registry below.
//!
//! `pitch_coupling` is not among them: the exchange of a combined yaw and sway with the pitch (T.
//! R. Kane and G.-T. Tseng, Int. J. Mech. Sci. 9 (1967) 83) is in the equations of motion of every
//! body on two lines, without a switch.
//!
//! # Conventions
//! Hull axes: x forward, y to port, z up. Forces act at the centre of mass, torques about it.
//! Surge, sway and heave are motions along x, y, z; roll, pitch and yaw turn about them.

use std::fmt::Debug;

use super::numbers::{Number, Numbers};
use super::real::{M3, Real, V3};
use super::suspended::{ATTITUDE, Cord, PLACE, RATE, Suspended, TIME, VELOCITY};
use gyradius_base::error::{Error, Result};

mod added_mass;
mod amplitude_added_mass;
mod bearing_friction;
mod buoyancy;
mod internal_motion;
mod knock;
mod learned_force;
mod line_creep;
mod line_mass;
mod line_slip;
mod line_stretch;
mod line_torsion;
mod linear_damping;
mod nonparallel_lines;
mod off_centre_cm;
mod power_law_damping;
mod presliding_bearing;
mod quadratic_drag;
mod stated_length;
mod stated_spacing;
mod support_compliance;
mod unequal_lines;
mod wind;

pub use added_mass::EntrainedAir;
pub use amplitude_added_mass::AmplitudeAddedMass;
pub use bearing_friction::BearingFriction;
pub use buoyancy::Buoyancy;
pub use internal_motion::InternalMotion;
pub use knock::Knock;
pub use learned_force::LearnedForce;
pub use line_creep::LineCreep;
pub use line_mass::LineMass;
pub use line_slip::LineSlip;
pub use line_stretch::LineStretch;
pub use line_torsion::LineTorsion;
pub use linear_damping::LinearDamping;
pub use nonparallel_lines::NonparallelLines;
pub use off_centre_cm::OffCentreCm;
pub use power_law_damping::PowerLawDamping;
pub use presliding_bearing::PreslidingBearing;
pub use quadratic_drag::QuadraticDrag;
pub use stated_length::StatedLength;
pub use stated_spacing::StatedSpacing;
pub use support_compliance::SupportCompliance;
pub use unequal_lines::UnequalLines;
pub use wind::Wind;

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

    /// Downwards, hull axes.
    pub fn down(&self) -> V3<S> {
        -self.turn.row(2).transpose()
    }

    /// Horizontal part of the position, world axes, m.
    pub fn level_position(&self) -> V3<S> {
        V3::new(self.position.x, self.position.y, S::zero())
    }

    /// The turn about the vertical, rad, and its change by a turn about each hull axis: what is
    /// left of the attitude when the least tilt that explains the hull's z axis is taken away
    /// (swing and twist). A tilted hull's axes do not bias it, and a torque along its change
    /// conserves energy.
    pub fn twist(&self) -> (S, V3<S>) {
        let r = &self.turn;
        let angle = (r[(1, 0)] - r[(0, 1)]).atan2(r[(0, 0)] + r[(1, 1)]);
        let upright = S::one() / (S::one() + r[(2, 2)]);
        (
            angle,
            V3::new(r[(2, 0)] * upright, r[(2, 1)] * upright, S::one()),
        )
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
        Self::of(&catalogue(), id, given)
    }

    /// The same from another catalogue, that of the sensors.
    pub fn of(kinds: &[EffectKind], id: &str, given: &[(&str, f64)]) -> Result<Self> {
        let known = || kinds.iter().map(|k| k.id).collect::<Vec<_>>().join(", ");
        let kind = *kinds
            .iter()
            .find(|k| k.id == id)
            .ok_or_else(|| Error::argument("effect", known(), id))?;
        let mut effect = Self {
            kind,
            values: vec![0.0; kind.numbers.len()],
        };
        given
            .iter()
            .try_for_each(|(name, value)| effect.set(name, *value))?;
        Ok(effect)
    }

    /// Gives a number by its name.
    pub fn set(&mut self, name: &str, value: f64) -> Result<()> {
        let numbers = self.kind.numbers;
        let names = || {
            numbers
                .iter()
                .map(|n| n.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let place = numbers.iter().position(|n| n.name == name);
        self.values[place.ok_or_else(|| Error::argument(self.kind.id, names(), name))?] = value;
        Ok(())
    }

    /// Fails where a number that must be larger than zero is not.
    pub(super) fn check(&self) -> Result<()> {
        for (number, value) in self.kind.numbers.iter().zip(&self.values) {
            if self.kind.positive.contains(&number.name) && !(value.is_finite() && *value > 0.0) {
                let name = format!("{}.{}", self.kind.id, number.name);
                return Err(Error::argument(&name, "a positive number", value));
            }
        }
        Ok(())
    }
}

macro_rules! registry {
    ($($effect:ident),* $(,)?) => {
        /// Every effect that there is.
        pub fn catalogue() -> Vec<EffectKind> {
            vec![$(EffectKind {
                id: $effect::<f64>::ID,
                numbers: <$effect<f64> as Numbers<f64>>::NUMBERS,
                positive: $effect::<f64>::POSITIVE,
                kinked: $effect::<f64>::KINKED,
            }),*]
        }

        /// The law of the effect `id` with its numbers; `None` for an unknown one or too few
        /// numbers.
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
    QuadraticDrag,
    PowerLawDamping,
    BearingFriction,
    PreslidingBearing,
    EntrainedAir,
    AmplitudeAddedMass,
    LineCreep,
    LineStretch,
    LineTorsion,
    LineMass,
    NonparallelLines,
    UnequalLines,
    OffCentreCm,
    StatedLength,
    StatedSpacing,
    SupportCompliance,
    InternalMotion,
    Wind,
    Buoyancy,
    Knock,
    LineSlip,
    LearnedForce,
}
