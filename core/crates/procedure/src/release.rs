//! The release: when the hull began to move, and how far it swings, read half swing by half swing.
//!
//! Between two moments at which the rate is nought a turn goes from one end to the other: half the
//! integral of the rate is its amplitude, whatever its period. A swing without turning is read off
//! the accelerometer: the force across gravity over gravity is the lines' angle.

use super::event::Channel;
use super::rest::Rest;
use gyradius_base::frames::Vec3;

/// Samples are averaged over this time, ns: short against half a swing, long against noise.
const CELL_NS: i64 = 100_000_000;
/// Motion is what exceeds noise by so many standard deviations …
const SIGMAS: f64 = 8.0;
/// … and at least this: rad/s of the gyroscope (at a period of 4 s a swing of 0.4°), m/s² of the
/// accelerometer (0.3°).
const LEAST: [f64; 2] = [0.01, 0.05];
/// Half swings below this are noise or the hand, degrees.
const LEAST_DEG: f64 = 0.2;
/// The release is the largest half swing within this time after the free swing begins, s.
const RELEASE_S: f64 = 10.0;
/// Half swings that are kept.
const MOST: usize = 4096;

/// What is being followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Follows {
    /// A turn, by the gyroscope.
    Turn,
    /// The lines, by the accelerometer.
    Lines,
}

/// Follows a swing from the first sample of its recording on.
#[derive(Debug, Clone)]
pub(super) struct Release {
    follows: Follows,
    /// What the sensor says at rest; that of the first cell where no rest was taken.
    rest: Option<Vec3>,
    threshold: f64,
    cell: (i64, Vec3, usize),
    /// When motion began, ns.
    moving_ns: Option<i64>,
    axis: Vec3,
    last: Option<(i64, f64)>,
    /// Integral, or largest size, since the last change of sign.
    half: f64,
    halves: Vec<(i64, f64)>,
}

impl Release {
    pub fn new(follows: Follows, rest: Option<&Rest>) -> Self {
        let (sensor, least) = match follows {
            Follows::Turn => (rest.map(|rest| rest.gyroscope), LEAST[0]),
            Follows::Lines => (rest.and_then(|rest| rest.accelerometer), LEAST[1]),
        };
        let noise = sensor.map_or(0.0, |sensor| {
            let in_cell = (sensor.rate_hz * CELL_NS as f64 / 1e9).max(1.0);
            Vec3::from(sensor.noise).norm() / in_cell.sqrt()
        });
        Self {
            follows,
            rest: sensor.map(|sensor| Vec3::from(sensor.mean)),
            threshold: least.max(SIGMAS * noise),
            cell: (0, Vec3::zeros(), 0),
            moving_ns: None,
            axis: Vec3::zeros(),
            last: None,
            half: 0.0,
            halves: Vec::new(),
        }
    }

    pub fn push(&mut self, channel: Channel, stamps_ns: &[i64], values: &[[f64; 3]]) {
        let mine = match self.follows {
            Follows::Turn => Channel::Gyroscope,
            Follows::Lines => Channel::Accelerometer,
        };
        if channel != mine {
            return;
        }
        for (&stamp, value) in stamps_ns.iter().zip(values) {
            let value = Vec3::from(*value);
            if !value.iter().all(|v| v.is_finite()) {
                continue;
            }
            if self.cell.2 > 0 && stamp.saturating_sub(self.cell.0) >= CELL_NS {
                let (at_ns, sum, count) = std::mem::take(&mut self.cell);
                self.take(at_ns, sum / count as f64);
            }
            if self.cell.2 == 0 {
                self.cell.0 = stamp;
            }
            self.cell.1 += value;
            self.cell.2 += 1;
        }
    }

    /// When the hull began to move, ns; it may still have been in the hand.
    pub fn moving_ns(&self) -> Option<i64> {
        self.moving_ns
    }

    /// Amplitude of the latest half swing, degrees.
    pub fn amplitude_deg(&self) -> Option<f64> {
        self.halves.last().map(|half| half.1)
    }

    /// Amplitude after the release, degrees; the free swing begins at `from_ns`, or where motion
    /// did.
    pub fn released_deg(&self, from_ns: Option<i64>) -> Option<f64> {
        let from_ns = from_ns.or(self.moving_ns)?;
        let until_ns = from_ns.saturating_add((RELEASE_S * 1e9) as i64);
        let within = self
            .halves
            .iter()
            .filter(|half| (from_ns..until_ns).contains(&half.0));
        within.map(|half| half.1).max_by(f64::total_cmp)
    }

    fn take(&mut self, at_ns: i64, mean: Vec3) {
        let rest = *self.rest.get_or_insert(mean);
        let mut off = mean - rest;
        if self.follows == Follows::Lines {
            let up = rest.try_normalize(1.0).unwrap_or_default();
            off -= up * off.dot(&up);
        }
        if off.norm() > self.threshold {
            self.moving_ns.get_or_insert(at_ns);
        }
        if self.moving_ns.is_none() {
            return;
        }
        if off.norm() > self.axis.norm() {
            self.axis = if off.dot(&self.axis) < 0.0 { -off } else { off };
        }
        let along = off.dot(&self.axis.try_normalize(0.0).unwrap_or_default());
        self.follow(at_ns, along, rest.norm());
    }

    fn follow(&mut self, at_ns: i64, along: f64, gravity_m_s2: f64) {
        let Some((last_ns, last)) = self.last.replace((at_ns, along)) else {
            return;
        };
        if last * along < 0.0 {
            let size = match self.follows {
                Follows::Turn => 0.5 * self.half,
                Follows::Lines => self.half / gravity_m_s2.max(1.0),
            };
            if size.to_degrees() > LEAST_DEG && self.halves.len() < MOST {
                self.halves.push((at_ns, size.to_degrees()));
            }
            self.half = 0.0;
        }
        match self.follows {
            Follows::Turn => {
                self.half += 0.5 * (along + last).abs() * at_ns.saturating_sub(last_ns) as f64 / 1e9
            }
            Follows::Lines => self.half = self.half.max(along.abs()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Still for 3 s, then a turn of 5 degrees with a period of 4 s: rate A ω sin ωt.
    #[test]
    fn a_release_is_seen_and_read_in_degrees() {
        let mut release = Release::new(Follows::Turn, None);
        let omega = TAU / 4.0;
        for i in 0..2000_i64 {
            let t = i as f64 / 100.0 - 3.0;
            let rate = if t < 0.0 {
                0.0
            } else {
                5_f64.to_radians() * omega * (omega * t).sin()
            };
            release.push(
                Channel::Gyroscope,
                &[10_000_000 * i],
                &[[0.02, 0.01 - rate, 0.0]],
            );
        }
        let moving_s = release.moving_ns().unwrap() as f64 / 1e9;
        // The rate passes 0.01 rad/s, of 0.137, after 0.05 s; cells are 0.1 s long.
        assert!((3.0..3.3).contains(&moving_s), "{moving_s}");
        let released = release.released_deg(None).unwrap();
        assert!((released - 5.0).abs() < 0.1, "{released}");
        assert!((release.amplitude_deg().unwrap() - 5.0).abs() < 0.1);
    }

    /// Lines at 2 degrees: the force across gravity is g θ cos ωt.
    #[test]
    fn a_swing_without_turning_is_read_off_the_force() {
        let mut release = Release::new(Follows::Lines, None);
        for i in 0..2000_i64 {
            let t = i as f64 / 100.0 - 3.0;
            let across = if t < 0.0 {
                0.0
            } else {
                9.81 * 2_f64.to_radians() * (1.6 * t).sin()
            };
            release.push(
                Channel::Accelerometer,
                &[10_000_000 * i],
                &[[across, 0.0, 9.81]],
            );
        }
        let released = release.released_deg(None).unwrap();
        assert!((released - 2.0).abs() < 0.1, "{released}");
    }
}
