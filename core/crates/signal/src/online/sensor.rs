//! One sensor's stamps and limits, sample by sample.

use super::gaps::{Gap, GapList};
use super::state::SensorState;
use gyradius_recording::{CUT_STEPS, MISSING_INTERVALS, RUN_SAMPLES, RUNS, STATED_RANGE, Sensor};

/// Intervals that the usual one is the median of.
const INTERVALS: usize = 64;
/// The median is taken anew after so many.
const RENEWED_AFTER: usize = 16;
/// A sensor being watched.
#[derive(Debug, Clone)]
pub(super) struct Watch {
    sensor: Sensor,
    full_scale: Option<f64>,
    last_s: Option<f64>,
    samples: u64,
    left_out: u64,
    /// The latest intervals, s, the next one replacing the oldest.
    intervals_s: Vec<f64>,
    next: usize,
    usual_s: Option<f64>,
    /// Intervals that are no gaps: how many, and their sum.
    regular: u64,
    regular_s: f64,
    gaps: GapList,
    at_full_scale: u64,
    axes: [Extreme; 3],
}

impl Watch {
    pub fn new(sensor: Sensor, full_scale: Option<f64>) -> Self {
        Self {
            sensor,
            full_scale,
            last_s: None,
            samples: 0,
            left_out: 0,
            intervals_s: Vec::with_capacity(INTERVALS),
            next: 0,
            usual_s: None,
            regular: 0,
            regular_s: 0.0,
            gaps: GapList::default(),
            at_full_scale: 0,
            axes: [Extreme::default(); 3],
        }
    }

    /// Takes a sample in; false where it must not be used.
    pub fn admit(&mut self, t_s: f64, value: [f64; 3]) -> bool {
        let steps_back = self.last_s.is_some_and(|last_s| t_s <= last_s);
        if steps_back || !value.iter().all(|v| v.is_finite()) {
            self.left_out += 1;
            return false;
        }
        if let Some(last_s) = self.last_s.replace(t_s) {
            self.take_interval(last_s, t_s - last_s);
        }
        self.samples += 1;
        if let Some(limit) = self.full_scale.map(|scale| STATED_RANGE * scale.abs()) {
            let at_limit = value.iter().any(|v| v.abs() >= limit);
            self.at_full_scale += u64::from(at_limit);
            return !at_limit;
        }
        self.axes
            .iter_mut()
            .zip(value)
            .for_each(|(axis, v)| axis.take(v));
        true
    }

    fn take_interval(&mut self, from_s: f64, interval_s: f64) {
        if self.intervals_s.len() < INTERVALS {
            self.intervals_s.push(interval_s);
        } else {
            self.intervals_s[self.next] = interval_s;
        }
        self.next = (self.next + 1) % INTERVALS;
        if self.usual_s.is_none() || self.next.is_multiple_of(RENEWED_AFTER) {
            self.usual_s = median(&self.intervals_s);
        }
        if self
            .usual_s
            .is_some_and(|usual_s| interval_s > MISSING_INTERVALS * usual_s)
        {
            self.gaps.take(Gap {
                sensor: self.sensor,
                from_s,
                length_s: interval_s,
            });
        } else {
            self.regular += 1;
            self.regular_s += interval_s;
        }
    }

    pub fn last_s(&self) -> Option<f64> {
        self.last_s
    }

    pub fn gaps(&self) -> &GapList {
        &self.gaps
    }

    pub fn state(&self) -> SensorState {
        SensorState {
            sensor: self.sensor,
            rate_hz: (self.regular > 0).then(|| self.regular as f64 / self.regular_s),
            samples: self.samples,
            left_out: self.left_out,
            gaps: self.gaps.count(),
            longest_gap_s: self.gaps.longest_s(),
            saturated: self.at_full_scale + self.axes.iter().map(Extreme::saturated).sum::<u64>(),
            last_s: self.last_s,
        }
    }
}

fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    let middle = sorted.len() / 2;
    (!sorted.is_empty()).then(|| *sorted.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// A step smaller than this part of the extreme is rounding: a converter of 16 bits makes larger
/// ones.
const ROUNDING: f64 = 1e-5;

/// The largest value of one axis, and how the samples stay at it. Without a stated range an axis is
/// taken as cut off where it stays at exactly its extreme, time and again, and comes and goes in
/// steps that are large against its resolution (the rule of a recording's repairs, kept up sample
/// by sample).
#[derive(Debug, Clone, Copy)]
struct Extreme {
    peak: f64,
    last: f64,
    /// Samples at the extreme in the present run.
    run: u64,
    /// Step into the present run.
    step_in: f64,
    runs: u64,
    in_runs: u64,
    steps: f64,
    resolution: f64,
}

impl Default for Extreme {
    fn default() -> Self {
        Self {
            peak: 0.0,
            last: 0.0,
            run: 0,
            step_in: 0.0,
            runs: 0,
            in_runs: 0,
            steps: 0.0,
            resolution: f64::INFINITY,
        }
    }
}

impl Extreme {
    fn take(&mut self, value: f64) {
        let step = (value - self.last).abs();
        if step > ROUNDING * self.peak.abs() {
            self.resolution = self.resolution.min(step);
        }
        if value.abs() > self.peak.abs() {
            *self = Self {
                peak: value,
                run: 1,
                step_in: step,
                resolution: self.resolution,
                ..Self::default()
            };
        } else if value == self.peak {
            self.step_in = if self.run == 0 { step } else { self.step_in };
            self.run += 1;
        } else if self.run > 0 {
            self.end_run(step);
        }
        self.last = value;
    }

    fn end_run(&mut self, step_out: f64) {
        if self.run >= RUN_SAMPLES as u64 {
            self.runs += 1;
            self.in_runs += self.run;
            self.steps += 0.5 * (self.step_in + step_out);
        }
        self.run = 0;
    }

    /// Samples at the limit, 0 where there is none.
    fn saturated(&self) -> u64 {
        let cut = self.steps > CUT_STEPS * self.resolution * self.runs as f64;
        if self.runs >= RUNS as u64 && self.peak != 0.0 && cut {
            self.in_runs
        } else {
            0
        }
    }
}
