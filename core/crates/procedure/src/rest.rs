//! The sensors at rest: bias, noise, gravity and real rates, taken only from a hull that hangs
//! still.
//!
//! Samples are kept in blocks of half a second. A block whose mean is off that of the still blocks
//! before it, by more than noise allows and by more than matters, says that the hull moves, and
//! stillness begins anew.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use super::event::Channel;
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::frames::Vec3;
use gyradius_recording::MISSING_INTERVALS;

/// Length of a block, ns.
const BLOCK_NS: i64 = 500_000_000;
/// Blocks that an account of motion looks back over.
const LOOK_BACK: usize = 8;
/// A rate below this is no motion that matters, rad/s: at a period of 4 s it is a swing of 0.1°.
const LEAST_RATE_RAD_S: f64 = 0.003;
/// A turn of gravity below this is none, rad (0.1°).
const LEAST_TILT_RAD: f64 = 0.0017;
/// Means of noise stay within so many standard deviations.
const SIGMAS: f64 = 6.0;

/// The sensors at rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Rest {
    /// Length of the still part, s.
    pub still_s: f64,
    /// Gyroscope, rad/s; its mean is the bias.
    pub gyroscope: SensorRest,
    /// Accelerometer, m/s²; its mean is the reaction to gravity and the sensor's own error.
    pub accelerometer: Option<SensorRest>,
    /// Size of the accelerometer's mean, m/s²: gravity to within the sensor's own error, which may
    /// be 0.5 %.
    pub gravity_m_s2: Option<f64>,
}

/// One sensor at rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct SensorRest {
    /// Samples.
    pub samples: usize,
    /// Real rate by its own stamps, gaps left out, Hz.
    pub rate_hz: f64,
    /// Intervals of more than one and a half usual ones.
    pub gaps: usize,
    /// Mean by axis, unit of the sensor, phone axes.
    pub mean: [f64; 3],
    /// Standard deviation of a sample by axis, from the differences of neighbours: slow motion is
    /// not in it.
    pub noise: [f64; 3],
}

/// How a hull moved.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Moving {
    /// Largest rate against the mean over the last seconds, degrees per s.
    pub rate_deg_s: f64,
    /// Largest turn of gravity against the mean over the last seconds, degrees.
    pub tilt_deg: f64,
}

/// Half a second of one sensor.
#[derive(Debug, Clone, Default)]
struct Block {
    stamps_ns: Vec<i64>,
    values: Vec<Vec3>,
}

impl Block {
    fn mean(&self) -> Vec3 {
        self.values.iter().sum::<Vec3>() / self.values.len().max(1) as f64
    }

    /// Variance of a sample, all axes together, from the differences of neighbours.
    fn variance(&self) -> f64 {
        let squares: f64 = self
            .values
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).norm_squared())
            .sum();
        0.5 * squares / self.values.len().saturating_sub(1).max(1) as f64
    }
}

/// One sensor's still blocks.
#[derive(Debug, Clone)]
struct Sensed {
    open: Block,
    still: VecDeque<Block>,
    /// Means of the latest blocks, still or not.
    latest: VecDeque<Vec3>,
}

/// Samples at rest until they are still for long enough.
#[derive(Debug, Clone)]
pub(super) struct RestReader {
    wanted_s: f64,
    gyroscope: Sensed,
    accelerometer: Sensed,
    /// End of the last block that was not still, ns.
    moved_ns: Option<i64>,
}

impl RestReader {
    pub fn new(wanted_s: f64) -> Self {
        let sensed = || Sensed {
            open: Block::default(),
            still: VecDeque::new(),
            latest: VecDeque::new(),
        };
        Self {
            wanted_s,
            gyroscope: sensed(),
            accelerometer: sensed(),
            moved_ns: None,
        }
    }

    pub fn wanted_s(&self) -> f64 {
        self.wanted_s
    }

    pub fn push(&mut self, channel: Channel, stamps_ns: &[i64], values: &[[f64; 3]]) {
        // A little more than is wanted is kept, so that both sensors have it.
        let most = (self.wanted_s * 1e9 / BLOCK_NS as f64).ceil() as usize + 2;
        let (sensed, other, least) = match channel {
            Channel::Gyroscope => (
                &mut self.gyroscope,
                &mut self.accelerometer,
                LEAST_RATE_RAD_S,
            ),
            Channel::Accelerometer => (
                &mut self.accelerometer,
                &mut self.gyroscope,
                LEAST_TILT_RAD * STANDARD_GRAVITY_M_S2,
            ),
            Channel::GyroscopeBias => return,
        };
        for (&stamp, value) in stamps_ns.iter().zip(values) {
            let moved_ns = sensed.push(stamp, Vec3::from(*value), least, most, self.moved_ns);
            self.moved_ns = self.moved_ns.max(moved_ns);
        }
        // What moves one sensor moves the hull: the other has been still only since.
        if let Some(moved_ns) = self.moved_ns {
            other.forget_before(moved_ns);
        }
    }

    /// So long it has been still, s: by the gyroscope, and by the accelerometer where there is one.
    pub fn still_s(&self) -> f64 {
        let gyroscope_s = self.gyroscope.still_s();
        let has_other =
            !self.accelerometer.latest.is_empty() || !self.accelerometer.open.values.is_empty();
        if has_other {
            gyroscope_s.min(self.accelerometer.still_s())
        } else {
            gyroscope_s
        }
    }

    /// How the hull moves, while it has not been still for long enough since it did.
    pub fn moving(&self) -> Option<Moving> {
        let unsettled = self.moved_ns.is_some() && self.still_s() < self.wanted_s;
        unsettled.then(|| Moving {
            rate_deg_s: self
                .gyroscope
                .largest(|mean, value| (value - mean).norm())
                .to_degrees(),
            tilt_deg: self
                .accelerometer
                .largest(|mean, value| mean.angle(value))
                .to_degrees(),
        })
    }

    /// What was found, once everything was still for long enough.
    pub fn found(&self) -> Option<Rest> {
        if self.still_s() < self.wanted_s {
            return None;
        }
        let gyroscope = self.gyroscope.rest()?;
        let accelerometer = self.accelerometer.rest();
        let gravity_m_s2 = accelerometer.map(|rest| Vec3::from(rest.mean).norm());
        Some(Rest {
            still_s: self.still_s(),
            gyroscope,
            accelerometer,
            gravity_m_s2,
        })
    }

    /// Mean of the accelerometer over the still part, m/s².
    pub fn up(&self) -> Option<Vec3> {
        let rest = self.accelerometer.rest()?;
        Vec3::from(rest.mean).try_normalize(1.0)
    }
}

impl Sensed {
    /// Takes a sample; its stamp where the block that it ends says that the hull moved.
    fn push(
        &mut self,
        stamp: i64,
        value: Vec3,
        least: f64,
        most: usize,
        moved_ns: Option<i64>,
    ) -> Option<i64> {
        let steps_back = self
            .open
            .stamps_ns
            .last()
            .is_some_and(|last| stamp <= *last);
        if steps_back || !value.iter().all(|v| v.is_finite()) {
            return None;
        }
        let first = *self.open.stamps_ns.first().unwrap_or(&stamp);
        let ends = stamp.saturating_sub(first) >= BLOCK_NS;
        let moved = ends && self.close(least, most, moved_ns);
        self.open.stamps_ns.push(stamp);
        self.open.values.push(value);
        moved.then_some(stamp)
    }

    /// Drops what was before the hull last moved.
    fn forget_before(&mut self, moved_ns: i64) {
        self.still.retain(|block| {
            block
                .stamps_ns
                .first()
                .is_some_and(|first| *first >= moved_ns)
        });
    }

    fn close(&mut self, least: f64, most: usize, moved_ns: Option<i64>) -> bool {
        let block = std::mem::take(&mut self.open);
        let mean = block.mean();
        self.latest.push_back(mean);
        if self.latest.len() > LOOK_BACK {
            self.latest.pop_front();
        }
        let noise = SIGMAS * (block.variance() / block.values.len() as f64).sqrt();
        let moved = self
            .level()
            .is_some_and(|level| (mean - level).norm() > least.max(noise));
        if moved {
            self.still.clear();
            return true;
        }
        if moved_ns.is_some_and(|moved_ns| {
            block
                .stamps_ns
                .first()
                .is_none_or(|first| *first < moved_ns)
        }) {
            return false;
        }
        self.still.push_back(block);
        if self.still.len() > most {
            self.still.pop_front();
        }
        false
    }

    /// Mean of the still blocks.
    fn level(&self) -> Option<Vec3> {
        let count = self.still.len();
        (count > 0).then(|| self.still.iter().map(Block::mean).sum::<Vec3>() / count as f64)
    }

    fn still_s(&self) -> f64 {
        let first = self.still.front().and_then(|block| block.stamps_ns.first());
        let last = self.still.back().and_then(|block| block.stamps_ns.last());
        first.zip(last).map_or(0.0, |(first, last)| {
            last.saturating_sub(*first) as f64 / 1e9
        })
    }

    fn largest(&self, distance: impl Fn(&Vec3, &Vec3) -> f64) -> f64 {
        let mean = self.latest.iter().sum::<Vec3>() / self.latest.len().max(1) as f64;
        self.latest
            .iter()
            .map(|value| distance(&mean, value))
            .fold(0.0, f64::max)
    }

    fn rest(&self) -> Option<SensorRest> {
        let stamps: Vec<i64> = self
            .still
            .iter()
            .flat_map(|block| block.stamps_ns.iter().copied())
            .collect();
        let values: Vec<Vec3> = self
            .still
            .iter()
            .flat_map(|block| block.values.iter().copied())
            .collect();
        let mut intervals: Vec<f64> = stamps
            .windows(2)
            .map(|pair| pair[1].saturating_sub(pair[0]) as f64 / 1e9)
            .collect();
        intervals.sort_by(f64::total_cmp);
        let usual = *intervals.get(intervals.len() / 2)?;
        let regular = intervals.partition_point(|interval| *interval <= MISSING_INTERVALS * usual);
        let time_s: f64 = intervals[..regular].iter().sum();
        let mean = values.iter().sum::<Vec3>() / values.len() as f64;
        let squares = values
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).map(|d| d * d))
            .sum::<Vec3>();
        Some(SensorRest {
            samples: values.len(),
            rate_hz: regular as f64 / time_s,
            gaps: intervals.len() - regular,
            mean: mean.into(),
            noise: (squares * (0.5 / (values.len() - 1) as f64))
                .map(f64::sqrt)
                .into(),
        })
    }
}
