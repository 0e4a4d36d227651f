//! Samples of several streams put into rows by time, in constant memory.
//!
//! # Conventions
//! The order within a stream is that of the file, whatever its stamps say. A row is written once
//! every stream has a sample that may be earlier, or once one stream is so far ahead that another
//! must have stopped.

use std::collections::VecDeque;
use std::fmt::Write;

use super::types::Samples;

/// Samples of a stream that may wait for another one: 20 s at 400 Hz.
const MOST_AHEAD: usize = 8192;

/// Samples that wait for their row, by column group.
pub(super) struct Merge {
    origin_ns: i64,
    queues: Vec<VecDeque<(i64, [f64; 3])>>,
}

impl Merge {
    /// Rows of so many column groups; `t` counts from `origin_ns`.
    pub fn new(origin_ns: i64, groups: usize) -> Self {
        Self {
            origin_ns,
            queues: vec![VecDeque::new(); groups],
        }
    }

    /// Takes samples of one group and appends the rows that are complete.
    pub fn push(&mut self, group: usize, samples: &Samples, out: &mut String) {
        for sample in samples.stamps_ns.iter().zip(&samples.values) {
            self.queues[group].push_back((*sample.0, *sample.1));
            while self.queues.iter().all(|queue| !queue.is_empty())
                || self.queues[group].len() > MOST_AHEAD
            {
                self.row(out);
            }
        }
    }

    /// Appends the rows that are left.
    pub fn finish(mut self, out: &mut String) {
        while self.queues.iter().any(|queue| !queue.is_empty()) {
            self.row(out);
        }
    }

    /// Writes the earliest sample and those of its stamp.
    fn row(&mut self, out: &mut String) {
        let heads = self.queues.iter().filter_map(|queue| queue.front());
        let Some(stamp_ns) = heads.map(|head| head.0).min() else {
            return;
        };
        // Writing to a String does not fail.
        let _ = write!(out, "{}", seconds(stamp_ns, self.origin_ns));
        for queue in &mut self.queues {
            match queue.front() {
                Some(&(stamp, [x, y, z])) if stamp == stamp_ns => {
                    let _ = write!(out, ",{x},{y},{z}");
                    queue.pop_front();
                }
                _ => out.push_str(",,,"),
            }
        }
        out.push('\n');
    }
}

/// Seconds from the origin. Rounded back to nanoseconds it is the stamp again, up to 26 days (2^51
/// ns) from it.
pub(super) fn seconds(stamp_ns: i64, origin_ns: i64) -> f64 {
    (i128::from(stamp_ns) - i128::from(origin_ns)) as f64 / 1e9
}
