//! The samples of a swing, ready to be compared with a motion.

use std::ops::Range;

use crate::observe::Evidence;
use gyradius_base::frames::Vec3;

/// Samples are averaged over blocks this long, as a share of the fastest period found, before they
/// enter the normal equations; the motion is averaged over the same instants (`nodes`), so nothing is
/// shifted, and no more than (2π/16)²/24 = 0.6 % of the information of the fastest motion is lost.
pub(crate) const BLOCK_OF_PERIOD: f64 = 1.0 / 16.0;

/// The free span is known to a fraction of a second; so much is left out at its ends, s.
const MARGIN_S: f64 = 0.3;

/// A sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensor {
    /// Turn rates.
    Gyroscope,
    /// Specific force.
    Accelerometer,
}

/// One sensor's samples.
#[derive(Debug, Clone)]
pub struct Stream {
    /// Which sensor.
    pub sensor: Sensor,
    /// From the start of the span, s.
    pub t_s: Vec<f64>,
    /// Readings in phone axes, rad/s or m/s².
    pub values: Vec<Vec3>,
    /// Standard deviation of the white noise by axis.
    pub noise: Vec3,
    /// Samples without a gap between them.
    pub blocks: Vec<Range<usize>>,
}

/// The channels of a whole sensor.
fn whole(first: usize) -> Range<usize> {
    first..first + 3
}

/// Start of the part that is used, s by the phone's clock, and its duration, s.
pub(crate) fn inside(evidence: &Evidence) -> (f64, f64) {
    let start_s = evidence.span.start_s + MARGIN_S;
    (start_s, evidence.span.end_s - MARGIN_S - start_s)
}

impl Stream {
    /// The channels of one sensor, averaged over blocks no longer than `block_s`; `None` without
    /// any. Those of a sensor that lacks axes come first: what they read along does not matter where
    /// all is about one axis.
    fn of(
        evidence: &Evidence,
        sensor: Sensor,
        channels: Range<usize>,
        block_s: f64,
    ) -> Option<Self> {
        let (start_s, duration_s) = inside(evidence);
        if channels.is_empty() {
            return None;
        }
        let first = channels.start;
        let mut passed = 0;
        let group = evidence.groups.iter().find(|group| {
            let starts = passed == first;
            passed += group.channels.len();
            starts
        })?;
        let axis = |c: usize, i: usize| group.channels.get(c).map_or(0.0, |axis| axis[i]);
        // An axis that is missing or never changes measured nothing: it has no weight.
        let noise = Vec3::from_fn(|c, _| {
            let found = group
                .channels
                .get(c)
                .and(evidence.found.noise.get(first + c))
                .copied();
            found.filter(|noise| *noise > 0.0).unwrap_or(f64::INFINITY)
        });
        let inside = group.t_s.partition_point(|t| *t < start_s)
            ..group.t_s.partition_point(|t| *t <= start_s + duration_s);
        let t_s: Vec<f64> = group
            .t_s
            .get(inside.clone())?
            .iter()
            .map(|t| t - start_s)
            .collect();
        let values = inside.map(|i| Vec3::from_fn(|c, _| axis(c, i))).collect();
        let blocks = blocks(&t_s, block_s);
        noise.min().is_finite().then_some(Self {
            sensor,
            t_s,
            values,
            noise,
            blocks,
        })
    }

    /// How many of its axes measured something.
    pub fn axes(&self) -> usize {
        self.noise.iter().filter(|noise| noise.is_finite()).count()
    }

    /// Noise of the reading along an axis.
    pub fn noise_along(&self, axis: &Vec3) -> f64 {
        let parts = self
            .noise
            .iter()
            .zip(axis.iter())
            .filter(|(_, a)| **a != 0.0);
        parts
            .map(|(noise, a)| (noise * a).powi(2))
            .sum::<f64>()
            .sqrt()
    }

    /// Leaves out samples so near to a gap of lost ones, s.
    pub fn leave_out_beside_gaps(&mut self, beside_s: f64) {
        let mut steps: Vec<f64> = self.t_s.windows(2).map(|t| t[1] - t[0]).collect();
        steps.sort_by(f64::total_cmp);
        let Some(usual_s) = steps.get(steps.len() / 2).copied() else {
            return;
        };
        let gaps: Vec<[f64; 2]> = self
            .t_s
            .windows(2)
            .filter(|t| t[1] - t[0] > 1.5 * usual_s)
            .map(|t| [t[0], t[1]])
            .collect();
        let is_near = |t: f64| {
            gaps.iter()
                .any(|[from, to]| t > from - beside_s && t < to + beside_s)
        };
        let kept: Vec<bool> = self.t_s.iter().map(|t| !is_near(*t)).collect();
        // Blocks that lose a sample go: their others are few.
        self.blocks.retain(|block| block.clone().all(|i| kept[i]));
        let places: Vec<usize> = kept
            .iter()
            .scan(0, |next, kept| {
                let place = *next;
                *next += usize::from(*kept);
                Some(place)
            })
            .collect();
        for block in &mut self.blocks {
            *block = places[block.start]..places[block.start] + block.len();
        }
        let mut keep = kept.iter();
        self.t_s.retain(|_| keep.next().copied().unwrap_or(false));
        let mut keep = kept.iter();
        self.values
            .retain(|_| keep.next().copied().unwrap_or(false));
    }
}

/// A recording to come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recorded {
    /// Length of the recording, s.
    pub duration_s: f64,
    /// Samples per second of either sensor.
    pub rate_hz: f64,
    /// White noise of each axis of the gyroscope, rad/s.
    pub gyro_rad_s: f64,
    /// White noise of each axis of the accelerometer, m/s².
    pub acc_m_s2: f64,
}

/// All samples of a swing.
#[derive(Debug, Clone)]
pub struct Samples {
    /// One a sensor.
    pub streams: Vec<Stream>,
    /// When their time begins, s, by the phone's clock.
    pub start_s: f64,
    /// How long they last, s.
    pub duration_s: f64,
    /// The vertical in phone axes.
    pub up: Vec3,
    /// The line that joins the suspension points in phone axes, either way, where motions show it.
    pub along_suspension: Option<Vec3>,
}

impl Samples {
    /// From what was found in a phone's record; `None` without both sensors or without gravity in
    /// the record.
    pub fn of(evidence: &Evidence, fastest_period_s: f64) -> Option<Self> {
        let map = evidence.map;
        if map.gravity_free {
            return None;
        }
        let (up, block_s) = (evidence.up?, fastest_period_s * BLOCK_OF_PERIOD);
        let streams = vec![
            Stream::of(evidence, Sensor::Gyroscope, whole(map.gyroscope?), block_s)?,
            Stream::of(
                evidence,
                Sensor::Accelerometer,
                whole(map.accelerometer?),
                block_s,
            )?,
        ];
        let (start_s, duration_s) = inside(evidence);
        (duration_s > 0.0).then_some(Self {
            streams,
            start_s,
            duration_s,
            up,
            along_suspension: evidence.along_suspension(),
        })
    }

    /// Of a recording to come: one reading for each block that its samples would be averaged over,
    /// with the noise of that average. `None` where it is shorter than two periods.
    pub fn expected(recorded: &Recorded, fastest_period_s: f64) -> Option<Self> {
        let duration_s = recorded.duration_s - 2.0 * MARGIN_S;
        // Not more readings than there are samples.
        let block_s = (fastest_period_s * BLOCK_OF_PERIOD).max(1.0 / recorded.rate_hz);
        let in_block = recorded.rate_hz * block_s;
        let t_s: Vec<f64> = (0..(duration_s / block_s) as usize)
            .map(|i| (i as f64 + 0.5) * block_s)
            .collect();
        let stream = |sensor: Sensor, noise: f64| Stream {
            sensor,
            values: vec![Vec3::zeros(); t_s.len()],
            noise: Vec3::repeat(noise / in_block.sqrt()),
            blocks: (0..t_s.len()).map(|i| i..i + 1).collect(),
            t_s: t_s.clone(),
        };
        let streams = vec![
            stream(Sensor::Gyroscope, recorded.gyro_rad_s),
            stream(Sensor::Accelerometer, recorded.acc_m_s2),
        ];
        (duration_s > 2.0 * fastest_period_s).then_some(Self {
            streams,
            start_s: 0.0,
            duration_s,
            up: Vec3::z(),
            along_suspension: None,
        })
    }
}

/// Runs of samples no longer than `block_s`.
pub(crate) fn blocks(t_s: &[f64], block_s: f64) -> Vec<Range<usize>> {
    let mut blocks = Vec::new();
    let mut first = 0;
    for i in 1..=t_s.len() {
        if i == t_s.len() || t_s[i] - t_s[first] > block_s {
            blocks.push(first..i);
            first = i;
        }
    }
    blocks
}
