//! Samples of one sensor as means over cells of time, bounded in number.
//!
//! A cell is short against every period of a hull, so its mean keeps what the samples say of the
//! swing; it stands at the centroid of its stamps. When there are too many, neighbours are joined
//! as long as the period allows it, and after that the oldest are given up.

use crate::ChannelGroup;

/// First width, s: up to 10 Hz can be seen, beyond what a hull does.
const FIRST_WIDTH_S: f64 = 0.05;
/// Widest cells before the period is known, s.
const WIDEST_UNSEEN_S: f64 = 0.2;
/// Cells per period at least: 3.3 % of the information is lost.
const CELLS_PER_PERIOD: f64 = 10.0;
/// Most cells that are kept: 27 minutes at 0.2 s.
const MOST_CELLS: usize = 8192;
/// Fewest cells that anything is looked for in.
const FEWEST_CELLS: usize = 64;

/// The cells of a sensor.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    width_s: f64,
    widest_s: f64,
    open: Cell,
    done: Vec<Cell>,
}

/// A cell: number of samples, sums of stamps and values.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    slot: i64,
    count: f64,
    t_s: f64,
    values: [f64; 3],
}

impl Cell {
    fn join(&mut self, other: &Self) {
        self.count += other.count;
        self.t_s += other.t_s;
        self.values
            .iter_mut()
            .zip(other.values)
            .for_each(|(sum, value)| *sum += value);
    }
}

impl Cells {
    pub fn new() -> Self {
        Self {
            width_s: FIRST_WIDTH_S,
            widest_s: WIDEST_UNSEEN_S,
            open: Cell::default(),
            done: Vec::with_capacity(MOST_CELLS),
        }
    }

    pub fn push(&mut self, t_s: f64, values: [f64; 3]) {
        let sample = Cell {
            slot: (t_s / self.width_s).floor() as i64,
            count: 1.0,
            t_s,
            values,
        };
        if self.open.count > 0.0 && sample.slot == self.open.slot {
            self.open.join(&sample);
            return;
        }
        let full = std::mem::replace(&mut self.open, sample);
        if full.count > 0.0 {
            self.done.push(full);
        }
        if self.done.len() >= MOST_CELLS {
            self.make_room();
        }
    }

    /// Cells may be joined as far as this period allows.
    pub fn allow_for(&mut self, period_s: f64) {
        self.widest_s = period_s / CELLS_PER_PERIOD;
    }

    fn make_room(&mut self) {
        if 2.0 * self.width_s > self.widest_s {
            self.done.drain(..MOST_CELLS / 2);
            return;
        }
        self.width_s *= 2.0;
        self.open.slot = self.open.slot.div_euclid(2);
        let mut joined: Vec<Cell> = Vec::with_capacity(MOST_CELLS);
        for mut cell in self.done.drain(..) {
            cell.slot = cell.slot.div_euclid(2);
            match joined.last_mut() {
                Some(last) if last.slot == cell.slot => last.join(&cell),
                _ => joined.push(cell),
            }
        }
        self.done = joined;
    }

    /// The complete cells from a time on, as channels at their centroids; none where they are too
    /// few to say anything.
    pub fn group(&self, from_s: f64) -> Option<ChannelGroup> {
        let first = self
            .done
            .partition_point(|cell| cell.t_s < from_s * cell.count);
        let cells = &self.done[first..];
        let of = |value: &dyn Fn(&Cell) -> f64| {
            cells.iter().map(|cell| value(cell) / cell.count).collect()
        };
        (cells.len() >= FEWEST_CELLS).then(|| ChannelGroup {
            t_s: of(&|cell| cell.t_s),
            channels: (0..3).map(|axis| of(&|cell| cell.values[axis])).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn however_long_the_record_the_cells_are_bounded_and_keep_their_means() {
        let mut cells = Cells::new();
        cells.allow_for(1.0);
        for i in 0..400_000 {
            cells.push(0.005 * f64::from(i), [f64::from(i), 1.0, -1.0]);
            assert!(cells.done.len() < MOST_CELLS);
        }
        let group = cells.group(0.0).unwrap();
        assert!(group.t_s.windows(2).all(|pair| pair[0] < pair[1]));
        for (t, x) in group.t_s.iter().zip(&group.channels[0]) {
            // x = t/0.005 holds for means as for samples.
            assert!((x * 0.005 - t).abs() < 1e-9 * t.max(1.0));
        }
        assert!(group.channels[1].iter().all(|y| (y - 1.0).abs() < 1e-12));
        // 2000 s at the widest cells that a period of 1 s allows would be more than are kept: the
        // oldest are gone.
        assert!(group.t_s[0] > 0.0 && group.t_s[group.t_s.len() - 1] > 1999.0);
    }
}
