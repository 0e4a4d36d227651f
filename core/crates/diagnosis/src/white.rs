//! Whether anything is left in residuals: their spectrum against that of white noise.
//!
//! Each channel's residual over its noise is transformed; bands of neighbouring frequencies are
//! judged together, at low frequencies one by one, so that a line and a hump show alike. White
//! noise gives each frequency a power that follows χ² of two degrees of freedom.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex64;
use statrs::distribution::{ChiSquared, ContinuousCDF};

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;

use super::point::{Model, Point, first_settled};

/// Chance that a session of white noise shows anything.
const FALSE_ALARM: f64 = 1e-4;
/// Width of a band as a share of its frequency.
const BAND: f64 = 0.06;
/// Bands within this of a strongest one (difference of logarithms) are one line with it.
const LINE: f64 = 0.15;
/// The white level of a channel is known to this, relative: broad bands must exceed it to count.
const LEVEL_U: f64 = 0.01;
/// What a model leaves is next to nothing up to this share of what another left: laws differ a
/// little from nature's. (A law that bends to much leaves a hundredth of a great effect, and an
/// inertia that is off by many standard deviations.)
const NEXT_TO_NOTHING: f64 = 1e-3;

/// A band of a channel in which more is left than noise.
#[derive(Debug, Clone)]
pub struct Band {
    pub swing: usize,
    /// 0 to 2: gyroscope, 3 to 5: accelerometer.
    pub channel: usize,
    pub from_hz: f64,
    pub to_hz: f64,
    /// What is left beyond noise, χ².
    pub excess: f64,
    /// What noise gives it, χ².
    pub expected: f64,
    /// In standard deviations of a normal variable of the same significance.
    pub sigma: f64,
}

/// What residuals hold beside white noise.
#[derive(Debug, Clone, Default)]
pub struct Left {
    pub bands: Vec<Band>,
}

impl Left {
    /// χ² beyond noise in all bands that show anything.
    pub fn excess(&self) -> f64 {
        self.bands.iter().map(|b| b.excess).sum()
    }

    /// Factor on the variance of what samples say: what is left moves the estimates as noise would
    /// that were as strong where it is.
    pub fn inflation(&self) -> f64 {
        let strongest = |band: &Band| 1.0 + band.excess / band.expected;
        self.bands.iter().map(strongest).fold(1.0, f64::max)
    }

    pub fn is_white(&self) -> bool {
        self.bands.is_empty()
    }

    /// Whether it is so little that it does not count beside what another model left.
    pub fn is_next_to_nothing(&self, beside: &Left) -> bool {
        self.excess() <= NEXT_TO_NOTHING * beside.excess()
    }

    /// Frequencies where most is left, Hz, so many of them and no nearer to each other than what is
    /// one line.
    pub fn peaks_hz(&self, most: usize) -> Vec<f64> {
        let mut bands: Vec<&Band> = self.bands.iter().collect();
        bands.sort_by(|a, b| b.excess.total_cmp(&a.excess));
        let centre_hz = |band: &Band| 0.5 * (band.from_hz + band.to_hz);
        let mut peaks_hz = Vec::new();
        while let (Some(strongest), true) = (bands.first(), peaks_hz.len() < most) {
            let middle_hz = centre_hz(strongest);
            let of_line = |band: &&Band| (centre_hz(band) / middle_hz).ln().abs() < LINE;
            let (line, others): (Vec<&Band>, Vec<&Band>) = bands.into_iter().partition(of_line);
            let excess: f64 = line.iter().map(|band| band.excess).sum();
            peaks_hz.push(
                line.iter()
                    .map(|band| band.excess * centre_hz(band))
                    .sum::<f64>()
                    / excess,
            );
            bands = others;
        }
        peaks_hz
    }

    /// Of a fitted model.
    pub fn of(model: &Model, point: &Point) -> Result<Self> {
        let channels = 6 * model.base.swings.len();
        let found = model.each(|s| -> Result<Vec<Band>> {
            let residuals = model.residuals(point, s)?;
            let mut bands = Vec::new();
            for (stream, residuals) in residuals.iter().enumerate() {
                let t_s = &model.swing(s).samples.streams[stream].t_s;
                for axis in 0..3 {
                    let values: Vec<f64> = residuals.iter().map(|r| r[axis]).collect();
                    bands.extend(in_record((s, 3 * stream + axis), t_s, &values, channels));
                }
            }
            Ok(bands)
        });
        let bands = found.into_iter().collect::<Result<Vec<_>>>()?.concat();
        Ok(Self { bands })
    }
}

/// Noise by what a fitted model leaves, as a share of what it was thought to be: by swing, by stream, by
/// axis. Samples alone tell noise from motion as far as the motion is slow against their rate.
pub fn levels(model: &Model, point: &Point) -> Result<Vec<Vec<Vec3>>> {
    let of_swing = |s: usize| -> Result<Vec<Vec3>> {
        let residuals = model.residuals(point, s)?;
        let of_stream = |(stream, residuals): (usize, &Vec<Vec3>)| {
            let first = first_settled(&model.swing(s).samples.streams[stream].t_s);
            Vec3::from_fn(|axis, _| {
                let values: Vec<f64> = residuals[first..].iter().map(|r| r[axis]).collect();
                level(&values).unwrap_or(1.0)
            })
        };
        Ok(residuals.iter().enumerate().map(of_stream).collect())
    };
    model.each(of_swing).into_iter().collect()
}

/// Standard deviation of white noise in a record that has lines, too: by the median of its spectrum,
/// which is ln 2 of the mean of what noise gives. Hann's window keeps the lines from all the rest.
fn level(values: &[f64]) -> Option<f64> {
    let count = values.len() as f64;
    let windowed = values.iter().enumerate().map(|(k, value)| {
        let window = 1.0 - (std::f64::consts::TAU * k as f64 / count).cos();
        value * window / 1.5f64.sqrt()
    });
    let mut power = spectrum(&windowed.collect::<Vec<f64>>());
    power.sort_by(f64::total_cmp);
    let median = power.get(power.len() / 2)?;
    (*median > 0.0).then(|| (median / std::f64::consts::LN_2).sqrt())
}

/// Bands of one channel's residuals, over their noise, in a session of so many channels.
pub fn in_record(
    place: (usize, usize),
    t_s: &[f64],
    residuals: &[f64],
    channels: usize,
) -> Vec<Band> {
    let first = first_settled(t_s);
    let span_s = t_s.last().unwrap_or(&0.0) - t_s.get(first).unwrap_or(&0.0);
    in_channel(
        place,
        &residuals[first..],
        span_s,
        FALSE_ALARM / channels as f64,
    )
}

/// Bands of one channel's residual, over its noise, that hold more than chance gives them.
fn in_channel(
    (swing, channel): (usize, usize),
    values: &[f64],
    span_s: f64,
    chance: f64,
) -> Vec<Band> {
    let power = spectrum(values);
    let edges = edges(power.len());
    let each = chance / edges.len().max(1) as f64;
    let mut found = Vec::new();
    for pair in edges.windows(2) {
        let count = (pair[1] - pair[0]) as f64;
        let sum = 2.0 * power[pair[0]..pair[1]].iter().sum::<f64>();
        let expected = 2.0 * count * (1.0 + LEVEL_U * (count / power.len() as f64).sqrt().min(1.0));
        let Ok(law) = ChiSquared::new(2.0 * count) else {
            continue;
        };
        // A broad band is known no better than the level of the noise.
        let level = 1.0 + 4.0 * LEVEL_U;
        let tail = law.sf(if count > 30.0 { sum / level } else { sum });
        if tail < each {
            let excess = sum - expected;
            let sigma = if tail > 0.0 {
                normal_sigma(tail)
            } else {
                excess / (4.0 * count).sqrt()
            };
            let (from_hz, to_hz) = (pair[0] as f64 / span_s, pair[1] as f64 / span_s);
            found.push(Band {
                swing,
                channel,
                from_hz,
                to_hz,
                excess,
                expected,
                sigma,
            });
        }
    }
    found
}

/// Standard deviations that a normal variable exceeds with this chance: √(−2 ln p) less its slow
/// terms.
fn normal_sigma(tail: f64) -> f64 {
    let x = (-2.0 * tail.ln()).max(0.0);
    (x - (x.max(1.0)).ln() - (2.0 * std::f64::consts::PI).ln())
        .max(0.0)
        .sqrt()
}

/// Power of each frequency up to the highest, 1 on average for white noise of unit variance; the
/// mean is left out.
pub fn spectrum(values: &[f64]) -> Vec<f64> {
    let mut buffer: Vec<Complex64> = values.iter().map(|v| Complex64::new(*v, 0.0)).collect();
    let n = buffer.len();
    if n < 16 {
        return vec![];
    }
    FftPlanner::new().plan_fft_forward(n).process(&mut buffer);
    buffer[..n / 2]
        .iter()
        .map(|c| c.norm_sqr() / n as f64)
        .collect()
}

/// Where bands begin: from the first frequency on, each as wide as a share of its frequency, at
/// least one.
fn edges(count: usize) -> Vec<usize> {
    let mut edges = vec![1];
    let mut at = 1;
    while at < count {
        at = (at + ((at as f64 * BAND) as usize).max(1)).min(count);
        edges.push(at);
    }
    edges
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    use super::*;

    /// Noise of 1.7 beside a line of a hundred times that.
    #[test]
    fn a_line_does_not_raise_the_level_of_noise() {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let values: Vec<f64> = (0..6000)
            .map(|k| {
                let noise: f64 = StandardNormal.sample(&mut rng);
                1.7 * noise + 170.0 * (0.0531 * f64::from(k)).sin()
            })
            .collect();
        // The median of so many is known to 1/√3000 of the power, 1 % of the level.
        let found = level(&values).unwrap();
        assert!((found / 1.7 - 1.0).abs() < 0.03, "{found}");
    }
}
