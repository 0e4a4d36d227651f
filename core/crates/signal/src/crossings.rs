//! Zero crossings of one channel between samples, and periods from them: a check that shares
//! nothing with the fit.

use super::curve_fit::linear;

/// A passage through the channel's rest level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// When, s.
    pub t_s: f64,
    /// True where the channel rises.
    pub rising: bool,
    /// Rate of change there, channel unit per second.
    pub slope: f64,
}

/// Periods in time order, each between two crossings in the same direction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PeriodSeries {
    /// Middle of each period, s.
    pub t_s: Vec<f64>,
    /// Period, s.
    pub period_s: Vec<f64>,
}

/// One period from all crossings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingPeriod {
    /// Mean period, s.
    pub period_s: f64,
    /// Its standard error from the scatter of the crossings about their line, s.
    pub period_se_s: f64,
    /// How far rising and falling crossings are displaced against each other by a wrong level, s.
    pub asymmetry_s: f64,
    /// How many crossings.
    pub crossings: usize,
}

/// Half width of the local straight line, as a part of a period: sin x departs from x by 1 % at its
/// ends.
const LINE_HALF_WIDTH: f64 = 0.04;

/// Crossings of the channel's middle level, each from a straight line through the samples about it.
///
/// Noise makes no crossings: the channel must swing beyond a quarter of its present size on both
/// sides.
pub fn zero_crossings(t_s: &[f64], x: &[f64]) -> Vec<Crossing> {
    let level = middle(x);
    let y: Vec<f64> = x.iter().map(|v| v - level).collect();
    let size = 2f64.sqrt() * (y.iter().map(|v| v * v).sum::<f64>() / y.len().max(1) as f64).sqrt();
    let coarse = sign_changes(t_s, &y, 0.25 * size);
    let Some(half_period_s) = median(
        &coarse
            .windows(2)
            .map(|w| w[1].t_s - w[0].t_s)
            .collect::<Vec<f64>>(),
    ) else {
        return Vec::new();
    };
    // The threshold follows the decay once the period is known.
    let local = local_size(t_s, &y, 2.0 * half_period_s);
    let found = sign_changes_above(
        t_s,
        &y,
        &local.iter().map(|s| 0.25 * s).collect::<Vec<f64>>(),
    );
    found
        .iter()
        .filter_map(|c| refined(t_s, &y, c, 2.0 * LINE_HALF_WIDTH * half_period_s))
        .collect()
}

/// Periods between crossings of the same direction: each crossing starts one.
pub fn crossing_periods(crossings: &[Crossing]) -> PeriodSeries {
    let spans = crossings
        .windows(3)
        .filter(|w| w[0].rising == w[2].rising && w[0].rising != w[1].rising);
    let (t_s, period_s) = spans
        .map(|w| (0.5 * (w[0].t_s + w[2].t_s), w[2].t_s - w[0].t_s))
        .unzip();
    PeriodSeries { t_s, period_s }
}

/// Slope of crossing time against crossing count; `None` below four crossings.
pub fn period_from_crossings(crossings: &[Crossing]) -> Option<CrossingPeriod> {
    let t: Vec<f64> = crossings.iter().map(|c| c.t_s).collect();
    let half_s = median(&t.windows(2).map(|w| w[1] - w[0]).collect::<Vec<f64>>())?;
    // Counted by time, so that a crossing missed in a beat's node does not shift the ones after it.
    let mut count = vec![0.0];
    for w in t.windows(2) {
        count.push(count.last().copied().unwrap_or(0.0) + ((w[1] - w[0]) / half_s).round());
    }
    let side: Vec<f64> = crossings
        .iter()
        .map(|c| if c.rising { 0.5 } else { -0.5 })
        .collect();
    let fit = linear(&[vec![1.0; t.len()], count, side], &t, &vec![1.0; t.len()])?;
    Some(CrossingPeriod {
        period_s: 2.0 * fit.parameters[1],
        period_se_s: 2.0 * fit.se(1),
        asymmetry_s: fit.parameters[2],
        crossings: t.len(),
    })
}

/// The middle between the mean of the peaks and the mean of the troughs is disturbed by decay; the
/// mean is not.
fn middle(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len().max(1) as f64
}

/// Median of finite numbers.
pub(super) fn median(x: &[f64]) -> Option<f64> {
    let mut sorted: Vec<f64> = x.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    (n > 0).then(|| 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]))
}

fn sign_changes(t_s: &[f64], y: &[f64], threshold: f64) -> Vec<Crossing> {
    sign_changes_above(t_s, y, &vec![threshold; y.len()])
}

/// Changes of sign between excursions beyond the threshold: the last change of sign before the far
/// side is reached.
fn sign_changes_above(t_s: &[f64], y: &[f64], threshold: &[f64]) -> Vec<Crossing> {
    let mut found = Vec::new();
    let mut side = 0.0;
    let mut candidates: Vec<f64> = Vec::new();
    for i in 0..y.len() {
        if i > 0 && (y[i - 1] < 0.0) != (y[i] < 0.0) {
            let part = y[i - 1] / (y[i - 1] - y[i]);
            candidates.push(t_s[i - 1] + part * (t_s[i] - t_s[i - 1]));
        }
        if y[i].abs() > threshold[i] && threshold[i] > 0.0 {
            let now = y[i].signum();
            if side * now < 0.0
                && let Some(t_s) = median(&candidates)
            {
                found.push(Crossing {
                    t_s,
                    rising: now > 0.0,
                    slope: 0.0,
                });
            }
            (side, candidates) = (now, Vec::new());
        }
    }
    found
}

/// Amplitude in the window of `width_s` about each sample: √2 × rms, by running sums.
fn local_size(t_s: &[f64], y: &[f64], width_s: f64) -> Vec<f64> {
    let (mut first, mut end, mut sum) = (0, 0, 0.0);
    (0..y.len())
        .map(|i| {
            while end < y.len() && t_s[end] <= t_s[i] + 0.5 * width_s {
                sum += y[end] * y[end];
                end += 1;
            }
            while t_s[first] < t_s[i] - 0.5 * width_s {
                sum -= y[first] * y[first];
                first += 1;
            }
            (2.0 * sum.max(0.0) / (end - first).max(1) as f64).sqrt()
        })
        .collect()
}

/// Zero of the straight line through the samples about a coarse crossing, re-centred so that
/// curvature cancels.
fn refined(t_s: &[f64], y: &[f64], coarse: &Crossing, half_width_s: f64) -> Option<Crossing> {
    let mut at = *coarse;
    for _ in 0..3 {
        let first = t_s.partition_point(|t| *t < at.t_s - half_width_s);
        let end = t_s.partition_point(|t| *t <= at.t_s + half_width_s);
        if end < first + 3 {
            // Samples are sparse: the straight line between the two neighbours is all there is.
            return (at.slope != 0.0 || end > 0).then_some(at);
        }
        let from: Vec<f64> = t_s[first..end].iter().map(|t| t - at.t_s).collect();
        let fit = linear(
            &[vec![1.0; from.len()], from.clone()],
            &y[first..end],
            &vec![1.0; from.len()],
        )?;
        let (value, slope) = (fit.parameters[0], fit.parameters[1]);
        if slope == 0.0 || (slope > 0.0) != coarse.rising || (value / slope).abs() > half_width_s {
            return Some(at);
        }
        at = Crossing {
            t_s: at.t_s - value / slope,
            slope,
            ..at
        };
    }
    Some(at)
}
