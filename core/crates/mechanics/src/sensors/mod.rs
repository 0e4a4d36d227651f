//! What a phone's sensors do to what they feel, each effect a named part that is switched on by
//! listing it.
//!
//! An effect is a structure of named numbers ([`Numbers`]) with a law ([`SensorEffect`]), in a file
//! of its own, and a line in the registry below. Laws act in the order of the signal, whatever the
//! order of the list: the phone's own motion against the hull, the clock, the filter, errors of the
//! sensor, noise, conversion to figures.
//!
//! There is no randomness here. An effect that needs chance says how many standard normal numbers
//! it takes for each sample, and whoever simulates hands them in; without any the sensor is what it
//! is on average.
//!
//! # Conventions
//! Readings are in phone axes. Times count on the phone's clock from the start of the recording.

use std::fmt::Debug;

use super::effects::EffectKind;
use super::numbers::Numbers;
use super::path::Moment;
use super::phone::{Mounted, Reading};
use super::real::{Real, V3};
use gyradius_base::error::Result;

mod bias_drift;
mod clock_scale;
mod coloured_noise;
mod cross_axis;
mod delay;
mod drop_outs;
mod jitter;
mod low_pass;
mod oscillator;
mod phone_mount_resonance;
mod phone_slip;
mod quantisation;
mod saturation;
mod scale;
mod white_noise;

pub use bias_drift::BiasDrift;
pub use clock_scale::ClockScale;
pub use coloured_noise::ColouredNoise;
pub use cross_axis::CrossAxis;
pub use delay::Delay;
pub use drop_outs::DropOuts;
pub use jitter::Jitter;
pub use low_pass::LowPass;
pub use phone_mount_resonance::PhoneMountResonance;
pub use phone_slip::PhoneSlip;
pub use quantisation::Quantisation;
pub use saturation::Saturation;
pub use scale::{AccScale, GyroScale};
pub use white_noise::WhiteNoise;

/// One of the two sensors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensor {
    /// Angular rate.
    Gyroscope,
    /// Specific force.
    Accelerometer,
}

/// Where the phone is against its place on the hull.
///
/// # Conventions
/// The shift is in hull axes. The turn is a rotation vector in phone axes, about an axis that
/// stays, or small.
#[derive(Debug, Clone, Copy)]
pub struct Offset<S: Real> {
    /// m.
    pub shift: V3<S>,
    /// m/s.
    pub shift_rate: V3<S>,
    /// m/s².
    pub shift_acceleration: V3<S>,
    /// rad.
    pub turn: V3<S>,
    /// rad/s.
    pub turn_rate: V3<S>,
}

impl<S: Real> Default for Offset<S> {
    fn default() -> Self {
        let none = V3::zeros();
        Self {
            shift: none,
            shift_rate: none,
            shift_acceleration: none,
            turn: none,
            turn_rate: none,
        }
    }
}

/// The hull's motion as a phone meets it.
pub struct Ride<'a, S: Real> {
    /// The hull at a time, s.
    pub hull: &'a dyn Fn(S) -> Moment<S>,
    /// Where the phone sits.
    pub mounted: &'a Mounted<S>,
    /// When the hull is let go, s.
    pub from_s: f64,
    /// The last time that will be asked for, s.
    pub to_s: f64,
}

/// The phone's own motion against the hull, by time.
pub type OwnMotion<'a, S> = Box<dyn Fn(S) -> Offset<S> + 'a>;

/// The law of a sensor's effect. Every part is optional.
pub trait SensorEffect<S: Real>: Debug {
    /// Refuses numbers that the law has no meaning for.
    fn check(&self) -> Result<()> {
        Ok(())
    }
    /// Standard normal numbers that it takes for each sample.
    fn draws(&self) -> usize {
        0
    }
    /// Whether the sample is lost that was to be taken at this time.
    fn loses(&self, _clock_s: f64, _draws: &[f64]) -> bool {
        false
    }
    /// What is added to the time stamp that is written, s.
    fn stamp_error_s(&self, _draws: &[f64]) -> f64 {
        0.0
    }
    /// Whether readings are taken at a time that depends on the effect's numbers.
    fn bends_time(&self) -> bool {
        false
    }
    /// Makes true time of the phone's.
    fn bend(&self, _t_s: &mut S, _draws: &[f64]) {}
    /// The phone's motion against the hull, where the effect is one.
    fn own_motion<'a>(&'a self, _ride: &'a Ride<'a, S>) -> Result<Option<OwnMotion<'a, S>>> {
        Ok(None)
    }
    /// The sensor says the sum of what it felt so long ago, s, times these weights.
    fn memory_of(&self, _sensor: Sensor) -> Vec<(S, f64)> {
        vec![(S::zero(), 1.0)]
    }
    /// Changes a reading.
    fn distort(&self, _clock_s: S, _reading: &mut Reading<S>) {}
    /// How many states of its own the noise has.
    fn noise_states(&self) -> usize {
        0
    }
    /// Adds noise; `since_s` is the time from the sample before, none at the first.
    fn add_noise(
        &self,
        _since_s: Option<f64>,
        _draws: &[f64],
        _states: &mut [S],
        _reading: &mut Reading<S>,
    ) {
    }
    /// Turns a reading into figures.
    fn convert(&self, _reading: &mut Reading<S>) {}
}

/// What is told of a sensor's effect, as a type.
pub trait SensorDescribed {
    /// Name in files.
    const ID: &'static str;
}

macro_rules! registry {
    ($($effect:ident),* $(,)?) => {
        /// Every effect of the sensors that there is.
        pub fn catalogue() -> Vec<EffectKind> {
            vec![$(EffectKind {
                id: $effect::<f64>::ID,
                numbers: <$effect<f64> as Numbers<f64>>::NUMBERS,
                // Each law checks its own numbers.
                positive: &[],
                kinked: false,
            }),*]
        }

        /// The law of the effect `id` with its numbers; `None` for an unknown one or too few
        /// numbers.
        pub(super) fn build<S: Real>(
            id: &str,
            numbers: &mut dyn Iterator<Item = S>,
        ) -> Option<Box<dyn SensorEffect<S>>> {
            $(if id == $effect::<f64>::ID {
                return Some(Box::new($effect::<S>::from_numbers(numbers)?));
            })*
            None
        }
    };
}

registry! {
    AccScale,
    BiasDrift,
    ClockScale,
    ColouredNoise,
    CrossAxis,
    Delay,
    DropOuts,
    GyroScale,
    Jitter,
    LowPass,
    PhoneMountResonance,
    PhoneSlip,
    Quantisation,
    Saturation,
    WhiteNoise,
}
