//! Linear prediction of a record in blocks, from both sides, and where both fail.
//!
//! Only where to look is decided here: the analysis itself uses the samples with their own time
//! stamps.

use nalgebra::{DMatrix, DVector};
use rustfft::{FftPlanner, num_complex::Complex};

use super::types::ChannelGroup;

/// Blocks per cycle of the strongest oscillation.
const BLOCKS_PER_CYCLE: f64 = 16.0;
/// Lags of the prediction: one and a half cycles, enough for several modes and their harmonics.
const LAGS: usize = 24;
/// A disturbance stands this many times above the usual prediction error …
const ABOVE_NOISE: f64 = 7.0;
/// … and above this share of the swing's own size.
const ABOVE_SWING: f64 = 0.05;
/// Motion below this share of that on the other side is rest. From one window of a cycle and a half
/// to the next, the full beat of two periods 15 % apart falls to no less than 0.3.
const AT_REST: f64 = 0.15;
/// Share of the threshold that a surprise must reach where motion meets rest: such a place is
/// suspect already.
const SUSPECT: f64 = 0.3;

/// A block with less than this share of the usual number of samples lies at the edge of a gap. Its
/// samples are on one side of its middle, and their line would have to be extended to it.
const WHOLE_BLOCK: f64 = 0.5;

/// Who tells of a disturbance knows its time to about so many blocks: it was seen in blocks, and
/// lasts.
const KNOWN_BLOCKS: f64 = 2.0;

/// All channels averaged over blocks of one common grid; `None` where a block has no sample.
pub(super) struct BlockSeries {
    start_s: f64,
    step_s: f64,
    period_s: f64,
    /// Channel, block.
    values: Vec<Vec<Option<f64>>>,
    /// Which group (unit) each channel belongs to.
    group: Vec<usize>,
    /// Factor that brings each channel's noise to one.
    weight: Vec<f64>,
}

impl BlockSeries {
    /// Blocks of a sixteenth of the strongest oscillation's period; `None` where there is nothing
    /// to average.
    pub(super) fn new(groups: &[ChannelGroup]) -> Option<Self> {
        let start_s = groups
            .iter()
            .filter_map(|g| g.t_s.first())
            .copied()
            .reduce(f64::min)?;
        let end_s = groups
            .iter()
            .filter_map(|g| g.t_s.last())
            .copied()
            .reduce(f64::max)?;
        let fine_s = ((end_s - start_s) / 4096.0).max(0.05);
        let fine = Self::averaged(groups, start_s, end_s, fine_s)?;
        let period_s = fine.strongest_period()?;
        let step_s = (period_s / BLOCKS_PER_CYCLE).max(longest_interval(groups));
        let mut series = Self::averaged(groups, start_s, end_s, step_s)?;
        series.period_s = period_s;
        (series.len() > 3 * LAGS).then_some(series)
    }

    fn averaged(groups: &[ChannelGroup], start_s: f64, end_s: f64, step_s: f64) -> Option<Self> {
        let count = ((end_s - start_s) / step_s) as usize;
        if count < 16 || !step_s.is_finite() {
            return None;
        }
        let mut values = Vec::new();
        let mut group = Vec::new();
        let mut weight = Vec::new();
        for (index, g) in groups.iter().enumerate() {
            for channel in &g.channels {
                let sigma = noise(channel);
                values.push(block_values(
                    &g.t_s,
                    &without_spikes(channel, sigma),
                    start_s,
                    step_s,
                    count,
                ));
                weight.push(1.0 / sigma);
                group.push(index);
            }
        }
        values.iter_mut().for_each(|v| remove_median(v));
        (!values.is_empty()).then_some(Self {
            start_s,
            step_s,
            period_s: step_s,
            values,
            group,
            weight,
        })
    }

    /// Number of blocks.
    pub(super) fn len(&self) -> usize {
        self.values[0].len()
    }

    /// Start of block `n`, s.
    pub(super) fn time_s(&self, n: usize) -> f64 {
        self.start_s + n as f64 * self.step_s
    }

    /// Whether block `n` lies within [`KNOWN_BLOCKS`] of a time.
    fn is_about(&self, n: usize, at_s: f64) -> bool {
        (self.time_s(n) - at_s).abs() <= KNOWN_BLOCKS * self.step_s
    }

    /// Period of the strongest oscillation, s.
    pub(super) fn period_s(&self) -> f64 {
        self.period_s
    }

    /// Length of a block, s.
    pub(super) fn step_s(&self) -> f64 {
        self.step_s
    }

    /// Root mean square over a stretch of blocks, all channels in units of their noise, each about
    /// its own mean.
    pub(super) fn rms(&self, first: usize, end: usize) -> f64 {
        let of_channel = |(v, w): (&Vec<Option<f64>>, &f64)| {
            let present: Vec<f64> = v[first..end].iter().flatten().copied().collect();
            w * w * variance(&present)
        };
        self.values
            .iter()
            .zip(&self.weight)
            .map(of_channel)
            .sum::<f64>()
            .sqrt()
    }

    /// Whether at least half of a stretch of blocks holds samples: a gap is not rest.
    fn is_recorded(&self, first: usize, end: usize) -> bool {
        self.values.iter().any(|v| {
            let present = v[first..end].iter().flatten().count();
            2 * present >= end - first
        })
    }

    fn strongest_period(&self) -> Option<f64> {
        let n = self.len();
        let fft = FftPlanner::new().plan_fft_forward(n);
        let mut power = vec![0.0; n / 2];
        for (channel, weight) in self.values.iter().zip(&self.weight) {
            let mut buffer: Vec<Complex<f64>> = channel
                .iter()
                .enumerate()
                .map(|(i, v)| {
                    let hann = 0.5 - 0.5 * (std::f64::consts::TAU * i as f64 / n as f64).cos();
                    Complex::new(v.unwrap_or(0.0) * weight * hann, 0.0)
                })
                .collect();
            fft.process(&mut buffer);
            power
                .iter_mut()
                .zip(&buffer)
                .for_each(|(p, b)| *p += b.norm_sqr());
        }
        // Fewer than four cycles in the record is drift, not a swing.
        let strongest = (4..n / 2).max_by(|&a, &b| power[a].total_cmp(&power[b]))?;
        (power[strongest] > 0.0).then(|| n as f64 * self.step_s / strongest as f64)
    }
}

/// Value at the middle of each block, by a straight line through its samples: the mean alone would
/// move with the samples that happen to fall into the block.
fn block_values(
    t_s: &[f64],
    x: &[f64],
    start_s: f64,
    step_s: f64,
    count: usize,
) -> Vec<Option<f64>> {
    let mut sums = vec![[0.0; 5]; count];
    for (t, x) in t_s.iter().zip(x) {
        let n = ((t - start_s) / step_s) as usize;
        let u = (t - start_s) / step_s - n as f64 - 0.5;
        if let Some(s) = sums.get_mut(n) {
            [1.0, u, u * u, *x, u * x]
                .iter()
                .zip(s)
                .for_each(|(term, sum)| *sum += term);
        }
    }
    let filled: Vec<f64> = sums.iter().map(|s| s[0]).filter(|n| *n > 0.0).collect();
    let fewest = WHOLE_BLOCK * quantile(&filled, 0.5).unwrap_or(0.0);
    let is_whole = |s: &[f64; 5]| s[0] >= fewest;
    sums.iter()
        .map(|s| line_at_middle(s).filter(|_| is_whole(s)))
        .collect()
}

fn line_at_middle([n, u, uu, x, ux]: &[f64; 5]) -> Option<f64> {
    if *n == 0.0 {
        return None;
    }
    let spread = uu - u * u / n;
    let slope = if *n >= 3.0 && spread > 0.02 * n {
        (ux - u * x / n) / spread
    } else {
        0.0
    };
    Some((x - slope * u) / n)
}

/// Single samples far from both neighbours, which agree, give way to the neighbours' mean: a spike
/// is no touch.
fn without_spikes(x: &[f64], sigma: f64) -> Vec<f64> {
    let mut smooth = x.to_vec();
    for i in 1..x.len().saturating_sub(1) {
        let (before, after) = (x[i - 1], x[i + 1]);
        let off = (x[i] - 0.5 * (before + after)).abs();
        if off > 12.0 * sigma && (after - before).abs() < 0.25 * off {
            smooth[i] = 0.5 * (before + after);
        }
    }
    smooth
}

/// The usual (95th percentile) interval of the slowest group, so that blocks are not empty by
/// design.
fn longest_interval(groups: &[ChannelGroup]) -> f64 {
    let usual = |g: &ChannelGroup| {
        let steps: Vec<f64> = g.t_s.windows(2).map(|w| w[1] - w[0]).collect();
        quantile(&steps, 0.95).unwrap_or(0.0)
    };
    groups.iter().map(usual).fold(0.0, f64::max) * 1.01
}

/// Noise from second differences, robust; a thousandth of the channel's spread where quantisation
/// hides it.
fn noise(x: &[f64]) -> f64 {
    let differences: Vec<f64> = x
        .windows(3)
        .map(|w| (w[2] - 2.0 * w[1] + w[0]).abs())
        .collect();
    let spread = variance(x).sqrt();
    // 0.6745: quartile of the normal distribution; √6: gain of the second difference on white
    // noise.
    let white = quantile(&differences, 0.5).unwrap_or(0.0) / (0.6745 * 6f64.sqrt());
    white.max(1e-3 * spread).max(f64::MIN_POSITIVE.sqrt())
}

fn remove_median(values: &mut [Option<f64>]) {
    let present: Vec<f64> = values.iter().flatten().copied().collect();
    let middle = quantile(&present, 0.5).unwrap_or(0.0);
    values.iter_mut().flatten().for_each(|v| *v -= middle);
}

fn variance(x: &[f64]) -> f64 {
    let n = x.len().max(1) as f64;
    let mean = x.iter().sum::<f64>() / n;
    x.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n
}

fn quantile(x: &[f64], q: f64) -> Option<f64> {
    let mut sorted: Vec<f64> = x.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    sorted
        .get((q * sorted.len().saturating_sub(1) as f64).round() as usize)
        .copied()
}

/// How far every block is from what its neighbours foretell, relative to the threshold of a
/// disturbance.
pub(super) struct Surprise {
    coefficients: Vec<f64>,
    /// Channel, block: the threshold.
    threshold: Vec<Vec<f64>>,
    /// Block: prediction from the blocks before.
    forward: Vec<f64>,
    /// Block: prediction from the blocks after.
    backward: Vec<f64>,
}

impl Surprise {
    /// Fits the common rule, leaving out what does not follow it, and judges every block by it.
    pub(super) fn new(series: &BlockSeries) -> Option<Self> {
        let mut weights = vec![1.0; series.len()];
        let mut coefficients = fit(series, &weights)?;
        for _ in 0..6 {
            weights = trusted(series, &coefficients);
            coefficients = fit(series, &weights)?;
        }
        let errors: Vec<[Vec<f64>; 2]> = (0..series.values.len())
            .map(|c| {
                [
                    predict(&series.values[c], &coefficients, true),
                    predict(&series.values[c], &coefficients, false),
                ]
            })
            .collect();
        let threshold = thresholds(series, &errors);
        let ratio = |side: usize| {
            let worst = |n: usize| {
                (0..errors.len())
                    .map(|c| errors[c][side][n].abs() / threshold[c][n])
                    .fold(0.0, nan_aside)
            };
            (0..series.len()).map(worst).collect::<Vec<f64>>()
        };
        Some(Self {
            forward: ratio(0),
            backward: ratio(1),
            coefficients,
            threshold,
        })
    }

    /// Blocks at which the motion before and the motion after do not belong together, and those
    /// about a time at which the swing is known to have been disturbed.
    pub(super) fn breaks(&self, series: &BlockSeries, known_s: &[f64]) -> Vec<bool> {
        let n = series.len();
        let at = |v: &[f64], i: usize| v.get(i).copied().unwrap_or(0.0);
        let broken = |i: usize| {
            let ahead = at(&self.forward, i).max(at(&self.forward, i + 1));
            let behind = at(&self.backward, i).max(if i > 0 {
                at(&self.backward, i - 1)
            } else {
                0.0
            });
            // Near the ends only one side can foretell.
            let early = i < LAGS && at(&self.backward, i) > 1.0;
            let late = i + LAGS >= n && at(&self.forward, i) > 1.0;
            ahead.min(behind) > 1.0
                || early
                || late
                || (ahead.max(behind) > SUSPECT && meets_rest(series, i))
        };
        let mut disturbed: Vec<bool> = (0..n).map(broken).collect();
        let known: Vec<bool> = (0..n)
            .map(|i| known_s.iter().any(|at_s| series.is_about(i, *at_s)))
            .collect();
        self.forgive_glitches(series, &mut disturbed, &known);
        disturbed
            .iter()
            .zip(known)
            .map(|(disturbed, known)| *disturbed || known)
            .collect()
    }

    /// A glitch leaves the motion as it was: with its blocks unknown, both sides follow one rule.
    /// What is known to be none is not forgiven.
    fn forgive_glitches(&self, series: &BlockSeries, disturbed: &mut [bool], known: &[bool]) {
        for (first, end) in runs(disturbed) {
            let (a, b) = (first.saturating_sub(1), (end + 1).min(series.len()));
            let short = b - a <= LAGS / 2 && a >= LAGS && b + LAGS <= series.len();
            let unknown = !known[a..b.min(known.len())].contains(&true);
            if unknown && short && goes_on(series, a, b) && self.bridges(series, a, b) {
                disturbed[first..end].fill(false);
            }
        }
    }

    fn bridges(&self, series: &BlockSeries, a: usize, b: usize) -> bool {
        (0..series.values.len()).all(|c| {
            let worst = bridge_error(&series.values[c], &self.coefficients, a, b);
            worst.is_none_or(|errors| {
                errors
                    .iter()
                    .enumerate()
                    .all(|(i, e)| e.abs() <= self.threshold[c][(a + i).min(series.len() - 1)])
            })
        })
    }
}

/// Whether block `i` divides motion from rest.
fn meets_rest(series: &BlockSeries, i: usize) -> bool {
    i >= LAGS && i + LAGS < series.len() && !goes_on(series, i, i + 1)
}

/// Whether there is as much motion after block `b` as before block `a`. Rest follows the rule of
/// any swing: a constant foretells itself, and a few unknown blocks lead from the one to the other.
/// A side that was hardly recorded says nothing of rest.
fn goes_on(series: &BlockSeries, a: usize, b: usize) -> bool {
    if !series.is_recorded(a - LAGS, a) || !series.is_recorded(b, b + LAGS) {
        return true;
    }
    let (before, after) = (series.rms(a - LAGS, a), series.rms(b, b + LAGS));
    before.min(after) > AT_REST * before.max(after)
}

fn nan_aside(a: f64, b: f64) -> f64 {
    if b.is_nan() { a } else { a.max(b) }
}

/// Runs of true as (first, end excluded), runs nearer than two blocks joined.
fn runs(flags: &[bool]) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for n in (0..flags.len()).filter(|&n| flags[n]) {
        match found.last_mut() {
            Some((_, end)) if n <= *end + 2 => *end = n + 1,
            _ => found.push((n, n + 1)),
        }
    }
    found
}

/// Lags of block `n`, nearest first, looking back (`forward`) or ahead; `None` where one is
/// missing.
fn lags(x: &[Option<f64>], n: usize, forward: bool) -> Option<[f64; LAGS]> {
    let mut row = [0.0; LAGS];
    for (k, slot) in row.iter_mut().enumerate() {
        let index = if forward {
            n.checked_sub(k + 1)?
        } else {
            n + k + 1
        };
        *slot = (*x.get(index)?)?;
    }
    Some(row)
}

/// Common coefficients of all channels, both directions (weak damping makes the rule nearly the
/// same both ways).
fn fit(series: &BlockSeries, trust: &[f64]) -> Option<Vec<f64>> {
    let mut normal = DMatrix::zeros(LAGS, LAGS);
    let mut right = DVector::zeros(LAGS);
    for (x, w) in series.values.iter().zip(&series.weight) {
        for n in 0..x.len() {
            let (Some(value), true) = (x[n], trust[n] > 0.0) else {
                continue;
            };
            for forward in [true, false] {
                let Some(row) = lags(x, n, forward) else {
                    continue;
                };
                add_row(&mut normal, &mut right, &row, value, w * w);
            }
        }
    }
    let ridge = 1e-10 * normal.trace() / LAGS as f64 + f64::MIN_POSITIVE;
    (0..LAGS).for_each(|k| normal[(k, k)] += ridge);
    normal
        .cholesky()
        .map(|c| c.solve(&right).iter().copied().collect())
}

fn add_row(
    normal: &mut DMatrix<f64>,
    right: &mut DVector<f64>,
    row: &[f64; LAGS],
    value: f64,
    weight: f64,
) {
    for i in 0..LAGS {
        right[i] += weight * row[i] * value;
        for j in 0..LAGS {
            normal[(i, j)] += weight * row[i] * row[j];
        }
    }
}

/// Prediction error of each block; NaN where it cannot be foretold.
fn predict(x: &[Option<f64>], coefficients: &[f64], forward: bool) -> Vec<f64> {
    let error = |n: usize| {
        let foretold = lags(x, n, forward)?
            .iter()
            .zip(coefficients)
            .map(|(l, a)| l * a)
            .sum::<f64>();
        Some(x[n]? - foretold)
    };
    (0..x.len()).map(|n| error(n).unwrap_or(f64::NAN)).collect()
}

/// One where a block follows the present rule about as well as most blocks do, else zero.
fn trusted(series: &BlockSeries, coefficients: &[f64]) -> Vec<f64> {
    let mut total = vec![0.0; series.len()];
    for (x, w) in series.values.iter().zip(&series.weight) {
        let ahead = predict(x, coefficients, true);
        let behind = predict(x, coefficients, false);
        for (sum, (f, b)) in total.iter_mut().zip(ahead.iter().zip(&behind)) {
            *sum += w * w * (nan_aside(0.0, f * f) + nan_aside(0.0, b * b));
        }
    }
    let usual = quantile(&total, 0.5).unwrap_or(0.0);
    total
        .iter()
        .map(|t| if *t <= 9.0 * usual { 1.0 } else { 0.0 })
        .collect()
}

fn thresholds(series: &BlockSeries, errors: &[[Vec<f64>; 2]]) -> Vec<Vec<f64>> {
    let size = swing_size(series);
    let reach = (5.0 * BLOCKS_PER_CYCLE) as usize;
    let of_channel = |(c, [ahead, behind]): (usize, &[Vec<f64>; 2])| {
        let both: Vec<f64> = ahead.iter().chain(behind).map(|e| e.abs()).collect();
        let usual = quantile(&both, 0.5).unwrap_or(0.0) / 0.6745;
        (0..series.len())
            .map(|n| {
                let here = quieter_side(ahead, behind, n, reach).clamp(usual, 3.0 * usual);
                (ABOVE_NOISE * here)
                    .max(ABOVE_SWING * size[series.group[c]][n])
                    .max(f64::MIN_POSITIVE)
            })
            .collect()
    };
    errors.iter().enumerate().map(of_channel).collect()
}

/// Usual prediction error in the quieter of the stretches before and after: strong swings predict
/// less well.
fn quieter_side(ahead: &[f64], behind: &[f64], n: usize, reach: usize) -> f64 {
    let usual = |first: usize, end: usize| {
        let errors: Vec<f64> = ahead[first..end]
            .iter()
            .chain(&behind[first..end])
            .map(|e| e.abs())
            .collect();
        if errors.len() < reach {
            f64::INFINITY
        } else {
            quantile(&errors, 0.5).unwrap_or(0.0) / 0.6745
        }
    };
    usual(n.saturating_sub(reach), n).min(usual(
        (n + 1).min(ahead.len()),
        (n + reach).min(ahead.len()),
    ))
}

/// Root mean square of each group's channels over a few cycles about each block, in the group's
/// unit.
fn swing_size(series: &BlockSeries) -> Vec<Vec<f64>> {
    let reach = (2.0 * BLOCKS_PER_CYCLE) as usize;
    let count = series.group.iter().max().map_or(0, |g| g + 1);
    let mut sizes = vec![vec![0.0; series.len()]; count];
    for (x, g) in series.values.iter().zip(&series.group) {
        for (n, size) in sizes[*g].iter_mut().enumerate() {
            let near: Vec<f64> = x[n.saturating_sub(reach)..(n + reach).min(x.len())]
                .iter()
                .flatten()
                .copied()
                .collect();
            *size += variance(&near);
        }
    }
    sizes.iter_mut().for_each(|size| rooted_and_capped(size));
    sizes
}

/// Roots of mean squares; the shaking of a phone picked up must not hide the stop before it.
fn rooted_and_capped(size: &mut [f64]) {
    size.iter_mut().for_each(|v| *v = v.sqrt());
    let cap = 3.0 * quantile(size, 0.5).unwrap_or(f64::INFINITY);
    size.iter_mut().for_each(|v| *v = v.min(cap));
}

/// Least prediction errors over blocks a .. b + lags when blocks a .. b are unknown; `None` where
/// others are missing.
fn bridge_error(x: &[Option<f64>], coefficients: &[f64], a: usize, b: usize) -> Option<Vec<f64>> {
    let rows = b - a + LAGS;
    let mut matrix = DMatrix::zeros(rows, b - a);
    let mut right = DVector::zeros(rows);
    for r in 0..rows {
        let n = a + r;
        for k in 0..=LAGS {
            let factor = if k == 0 { 1.0 } else { -coefficients[k - 1] };
            let m = n - k;
            if (a..b).contains(&m) {
                matrix[(r, m - a)] = factor
            } else {
                right[r] -= factor * (*x.get(m)?)?
            }
        }
    }
    let solution = matrix.clone().svd(true, true).solve(&right, 1e-12).ok()?;
    Some((matrix * solution - right).iter().copied().collect())
}
