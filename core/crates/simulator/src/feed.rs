//! A simulated phone: what it says of a swing, batch after batch, in the order of time.

use gyradius_base::error::Result;
use gyradius_recording::Sensor;

use super::rig::RiggedSwing;

/// A sensor that falls silent, s from the first sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Silence {
    /// Which.
    pub sensor: Sensor,
    /// From when on.
    pub from_s: f64,
    /// Until when.
    pub until_s: f64,
}

/// What the phone says of one swing.
#[derive(Debug, Clone, PartialEq)]
pub struct Feed {
    stamps_ns: Vec<i64>,
    /// Angular rate and specific force, phone axes.
    readings: Vec<[[f64; 3]; 2]>,
    from_ns: i64,
    next: usize,
    silence: Option<Silence>,
}

/// Samples of one sensor.
#[derive(Debug, Clone, PartialEq)]
pub struct Heard {
    /// Gyroscope (rad/s) or accelerometer (m/s² of specific force).
    pub sensor: Sensor,
    /// Stamps, ns of the phone's clock.
    pub stamps_ns: Vec<i64>,
    /// (x, y, z) each, phone axes.
    pub values: Vec<[f64; 3]>,
}

impl Feed {
    /// Simulates a swing. `from_ns` is the phone's clock at its first sample, `seed` that of all
    /// chance; the same seed gives the same samples. Fails as the simulation does.
    pub fn of(
        swing: &RiggedSwing,
        seed: u64,
        from_ns: i64,
        silence: Option<Silence>,
    ) -> Result<Self> {
        let t_s = swing.sampling.times_s();
        let record = swing
            .experiment
            .record(&t_s, &swing.draws(Some(seed), t_s.len())?)?;
        let stamp = |t_s: &f64| from_ns.saturating_add((t_s * 1e9).round() as i64);
        let reading = |six: [f64; 6]| [[six[0], six[1], six[2]], [six[3], six[4], six[5]]];
        Ok(Self {
            stamps_ns: record.t_s.iter().map(stamp).collect(),
            readings: record
                .readings
                .iter()
                .map(|one| reading(one.six()))
                .collect(),
            from_ns,
            next: 0,
            silence,
        })
    }

    /// What comes in the next so many seconds: a batch for each sensor; `None` once all has come.
    pub fn next(&mut self, seconds: f64) -> Option<[Heard; 2]> {
        let first = *self.stamps_ns.get(self.next)?;
        let until = first.saturating_add((seconds.max(0.0) * 1e9) as i64);
        let rest = &self.stamps_ns[self.next..];
        let count = rest
            .iter()
            .position(|stamp| *stamp >= until)
            .unwrap_or(rest.len())
            .max(1);
        let rows = self.next..self.next + count;
        self.next += count;
        Some(
            [(Sensor::Gyroscope, 0), (Sensor::Accelerometer, 1)].map(|(sensor, which)| {
                let kept = rows
                    .clone()
                    .filter(|row| !self.is_silent(sensor, self.stamps_ns[*row]));
                let kept: Vec<usize> = kept.collect();
                Heard {
                    sensor,
                    stamps_ns: kept.iter().map(|row| self.stamps_ns[*row]).collect(),
                    values: kept.iter().map(|row| self.readings[*row][which]).collect(),
                }
            }),
        )
    }

    /// The phone's clock after the last sample that has come, ns.
    pub fn now_ns(&self) -> i64 {
        let last = self
            .next
            .checked_sub(1)
            .and_then(|last| self.stamps_ns.get(last));
        last.map_or(self.from_ns, |last| last.saturating_add(1))
    }

    fn is_silent(&self, sensor: Sensor, stamp_ns: i64) -> bool {
        let t_s = stamp_ns.saturating_sub(self.from_ns) as f64 / 1e9;
        self.silence.is_some_and(|silence| {
            silence.sensor == sensor && (silence.from_s..silence.until_s).contains(&t_s)
        })
    }
}
