//! Whether the phone still sits on the hull as it did.

use nalgebra::Vector3;

use crate::ChannelGroup;

/// Periods that a direction of gravity is the mean over: a swing averages out over whole periods,
/// and quicker motions beside it nearly.
const PERIODS: f64 = 3.0;
/// A change of that direction from which on the phone has moved, degrees, …
const MOVED_DEG: f64 = 2.0;
/// … and this share of how far the direction swings beside it: a mean over a little more than three
/// periods leaves up to 1/(3π) of a motion, and a wide swing presses the phone down along with
/// gravity, by half the square of its angle.
const SHARE: f64 = 0.15;

/// The largest lasting change of gravity's direction in the phone, if there is one: when, s, and by
/// how much, degrees. `period_s` is that of the slowest motion.
pub(super) fn moved(accelerometer: &ChannelGroup, period_s: f64) -> Option<(f64, f64)> {
    let window_s = PERIODS * period_s;
    let sums = Sums::of(accelerometer);
    let t_s = &accelerometer.t_s;
    let angle = |&i: &usize| -> Option<(f64, f64)> {
        let from = t_s.partition_point(|t| *t < t_s[i] - window_s);
        let to = t_s.partition_point(|t| *t < t_s[i] + window_s);
        let (before, after) = (sums.mean(from, i)?, sums.mean(i, to)?);
        Some((before.angle(&after).to_degrees(), t_s[i]))
    };
    let inside =
        |i: &usize| t_s[*i] - t_s[0] >= window_s && t_s[t_s.len() - 1] - t_s[*i] >= window_s;
    let changes = (0..t_s.len()).filter(inside).filter_map(|i| angle(&i));
    let (tilt_deg, at_s) = changes.max_by(|a, b| a.0.total_cmp(&b.0))?;
    // How far it swings is asked for only where it counts.
    let is_moved =
        tilt_deg > MOVED_DEG && tilt_deg > MOVED_DEG + SHARE * swing_deg(accelerometer, &sums)?;
    is_moved.then_some((at_s, tilt_deg))
}

/// How far the direction of the force swings about its mean: √2 of its standard deviation, degrees.
fn swing_deg(accelerometer: &ChannelGroup, sums: &Sums) -> Option<f64> {
    let count = accelerometer.t_s.len();
    let mean = sums.mean(0, count)?;
    let force = |i: usize| Vector3::from_fn(|c, _| accelerometer.channels[c][i]);
    let square: f64 = (0..count).map(|i| force(i).angle(&mean).powi(2)).sum();
    Some((2.0 * square / count as f64).sqrt().to_degrees())
}

/// Running sums, so that every mean costs the same.
struct Sums(Vec<Vector3<f64>>);

impl Sums {
    fn of(group: &ChannelGroup) -> Self {
        let mut sum = Vector3::zeros();
        let mut sums = vec![sum];
        for i in 0..group.t_s.len() {
            sum += Vector3::new(
                group.channels[0][i],
                group.channels[1][i],
                group.channels[2][i],
            );
            sums.push(sum);
        }
        Self(sums)
    }

    fn mean(&self, from: usize, to: usize) -> Option<Vector3<f64>> {
        (to > from).then(|| (self.0[to] - self.0[from]) / (to - from) as f64)
    }
}
