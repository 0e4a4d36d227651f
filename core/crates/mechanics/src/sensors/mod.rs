//! What a phone's sensors do to what they feel, each effect a named part that is switched on by
//! listing it.
//!
//! An effect is a structure of named numbers ([`Numbers`]) with a law (`SensorEffect`), in a file
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

use super::effects::EffectKind;
use super::numbers::Numbers;
use super::real::Real;

mod bias_drift;
mod clock_scale;
mod coloured_noise;
mod cross_axis;
mod delay;
mod drop_outs;
mod effect;
mod jitter;
mod low_pass;
mod oscillator;
mod phone_mount_resonance;
mod phone_slip;
mod quantisation;
mod saturation;
mod scale;
mod white_noise;

use bias_drift::BiasDrift;
use clock_scale::ClockScale;
use coloured_noise::ColouredNoise;
use cross_axis::CrossAxis;
use delay::Delay;
use drop_outs::DropOuts;
pub use effect::SensorDescribed;
pub(crate) use effect::{OwnMotion, Ride, Sensor, SensorEffect};
use jitter::Jitter;
use low_pass::LowPass;
use phone_mount_resonance::PhoneMountResonance;
pub use phone_slip::PhoneSlip;
use quantisation::Quantisation;
use saturation::Saturation;
use scale::{AccScale, GyroScale};
use white_noise::WhiteNoise;

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
