//! The law of a sensor's effect: what it does to what a phone feels.

use std::fmt::Debug;

use crate::path::Moment;
use crate::phone::{Mounted, Offset, Reading};
use crate::real::Real;
use gyradius_base::error::Result;

/// One of the two sensors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sensor {
    /// Angular rate.
    Gyroscope,
    /// Specific force.
    Accelerometer,
}

/// The hull's motion as a phone meets it.
pub(crate) struct Ride<'a, S: Real> {
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
pub(crate) type OwnMotion<'a, S> = Box<dyn Fn(S) -> Offset<S> + 'a>;

/// The law of a sensor's effect. Every part is optional.
pub(crate) trait SensorEffect<S: Real>: Debug {
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
