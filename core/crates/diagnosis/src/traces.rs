//! What pictures of the criticism are drawn from.

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_identification::samples::Sensor;

use super::found::Found;
use super::point::{Model, first_settled};
use super::result::SwingTrace;
use super::unit::UnitName;
use super::words;

const AXES: [&str; 3] = ["x", "y", "z"];

/// For each swing the channel that moves most against its noise, by both simulations, from where
/// they are compared.
pub fn traces(base: &Model, found: &Found) -> Result<Vec<SwingTrace>> {
    let one = |s: usize| -> Result<SwingTrace> {
        let fitted_swing = base.swing(s);
        let before = base.readings(&found.base.point, s)?;
        let after = found.model.readings(&found.fitted.point, s)?;
        let (stream, axis) = strongest(base, s);
        let samples = &fitted_swing.samples.streams[stream];
        let first = first_settled(&samples.t_s);
        let part = |readings: &[Vec3]| readings[first..].iter().map(|r| r[axis]).collect();
        let (key, unit) = match samples.sensor {
            Sensor::Gyroscope => ("channel_turn", UnitName::RadianPerSecond),
            Sensor::Accelerometer => ("channel_force", UnitName::MetrePerSecondSquaredRaised),
        };
        let channel = words::message(key, [("axis", words::written(AXES[axis]))]);
        Ok(SwingTrace {
            swing: fitted_swing.setup.swing.id.clone(),
            channel,
            unit: unit.into(),
            noise: samples.noise[axis],
            t_s: samples.t_s[first..].to_vec(),
            measured: part(&samples.values),
            base: part(&before[stream]),
            extended: part(&after[stream]),
        })
    };
    (0..base.base.swings.len()).map(one).collect()
}

/// Stream and axis with the largest motion over noise.
fn strongest(base: &Model, s: usize) -> (usize, usize) {
    let mut best = (0, 0, 0.0);
    for (stream, samples) in base.swing(s).samples.streams.iter().enumerate() {
        let count = samples.values.len().max(1) as f64;
        let mean = samples.values.iter().sum::<Vec3>() / count;
        for axis in 0..3 {
            let square: f64 = samples
                .values
                .iter()
                .map(|v| (v[axis] - mean[axis]).powi(2))
                .sum();
            let size = (square / count).sqrt() / samples.noise[axis];
            if size > best.2 {
                best = (stream, axis, size);
            }
        }
    }
    (best.0, best.1)
}
