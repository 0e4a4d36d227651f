//! What the simple theory leaves out, each effect a named part that is switched on by listing it.
//!
//! An effect is a structure of named numbers ([`Numbers`]) with a law (`Effect`), in a file of
//! its own, and a line in the registry below.
//!
//! `pitch_coupling` is not among them: the exchange of a combined yaw and sway with the pitch (T.
//! R. Kane and G.-T. Tseng, Int. J. Mech. Sci. 9 (1967) 83) is in the equations of motion of every
//! body on two lines, without a switch.
//!
//! # Conventions
//! Hull axes: x forward, y to port, z up. Forces act at the centre of mass, torques about it.
//! Surge, sway and heave are motions along x, y, z; roll, pitch and yaw turn about them.

use super::numbers::Numbers;
use super::real::Real;
use gyradius_base::error::{Error, Result};

mod added_mass;
mod amplitude_added_mass;
mod bearing_friction;
mod buoyancy;
mod effect;
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

use added_mass::EntrainedAir;
use amplitude_added_mass::AmplitudeAddedMass;
use bearing_friction::BearingFriction;
use buoyancy::Buoyancy;
pub(crate) use effect::{AddedMass, Effect, Loads, Solved, Support};
pub use effect::{Described, EffectKind};
use internal_motion::InternalMotion;
pub use knock::Knock;
use learned_force::LearnedForce;
use line_creep::LineCreep;
use line_mass::LineMass;
use line_slip::LineSlip;
use line_stretch::LineStretch;
use line_torsion::LineTorsion;
pub(crate) use linear_damping::LinearDamping;
use nonparallel_lines::NonparallelLines;
use off_centre_cm::OffCentreCm;
use power_law_damping::PowerLawDamping;
use presliding_bearing::PreslidingBearing;
use quadratic_drag::QuadraticDrag;
use stated_length::StatedLength;
use stated_spacing::StatedSpacing;
use support_compliance::SupportCompliance;
use unequal_lines::UnequalLines;
use wind::Wind;

/// An effect and the values of its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectValues<S = f64> {
    /// What it is.
    pub kind: EffectKind,
    /// Values in the order of `kind.numbers`.
    pub values: Vec<S>,
}

impl<S: Real> EffectValues<S> {
    /// The effect `id` with the values given, the others zero.
    pub fn new(id: &str, given: &[(&str, S)]) -> Result<Self> {
        Self::of(&catalogue(), id, given)
    }

    /// The same from another catalogue, that of the sensors.
    pub fn of(kinds: &[EffectKind], id: &str, given: &[(&str, S)]) -> Result<Self> {
        let known = || kinds.iter().map(|k| k.id).collect::<Vec<_>>().join(", ");
        let kind = *kinds
            .iter()
            .find(|k| k.id == id)
            .ok_or_else(|| Error::argument("effect", known(), id))?;
        let mut effect = Self {
            kind,
            values: vec![S::zero(); kind.numbers.len()],
        };
        given
            .iter()
            .try_for_each(|(name, value)| effect.set(name, *value))?;
        Ok(effect)
    }

    /// Gives a number by its name.
    pub fn set(&mut self, name: &str, value: S) -> Result<()> {
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

    /// The same effect over other numbers.
    pub(super) fn map<T>(&self, f: impl Fn(S) -> T) -> EffectValues<T> {
        EffectValues {
            kind: self.kind,
            values: self.values.iter().map(|value| f(*value)).collect(),
        }
    }

    /// Fails where a number that must be larger than zero is not.
    pub(super) fn check(&self) -> Result<()> {
        for (number, value) in self.kind.numbers.iter().zip(&self.values) {
            let value = value.value();
            if self.kind.positive.contains(&number.name) && !(value.is_finite() && value > 0.0) {
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
