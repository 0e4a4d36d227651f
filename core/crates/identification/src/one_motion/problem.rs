//! The least-squares problem: readings less motion, resting reading and lines beside it.

use nalgebra::{DMatrix, DVector};

use gyradius_estimation::{Block, Parameter, Rows, Shape, Wanted};
use gyradius_mechanics::Dual;

use super::lines::{LINE, Line};
use super::readings::Readings;
use super::torque::{Base, DAMPING, DRAG, FREQUENCY, FRICTION, HARDNESS, OF_MOTION, Restoring};

/// Place of the reading at rest; lines come after it.
pub const REST: usize = OF_MOTION;
pub const FIRST_LINE: usize = REST + 1;

/// Widths of the weak priors of α, b and c: each alone would be so large a share of critical damping
/// at the start. They decide where a few cycles cannot tell the three apart.
const DAMPING_U: f64 = 0.3;
/// Of the logarithm of the frequency about that of the start.
const FREQUENCY_U: f64 = 0.5;
const MOST_FREQUENCY: f64 = 1.0;
/// κ where nobody says how the body hangs: that of a pendulum, and within one standard deviation
/// that of a spring and of two lines.
const HARDNESS_PRIOR: (f64, f64) = (1.0, 1.0);

/// What is fitted to a part of the readings.
pub struct Problem<'a> {
    pub readings: &'a Readings,
    pub restoring: Restoring,
    /// Frequency of the start, rad/s.
    pub omega_rad_s: f64,
    /// Angle of the start, rad, for the priors' widths.
    pub reach_rad: f64,
    pub lines: &'a [Line],
    pub horizon_s: f64,
}

impl Problem<'_> {
    fn count(&self) -> usize {
        FIRST_LINE + LINE * self.lines.len()
    }

    /// Priors and bounds.
    pub fn parameters(&self) -> Vec<Parameter> {
        let (omega, reach) = (self.omega_rad_s, self.reach_rad);
        let mut all = vec![Parameter::FREE; self.count()];
        // What a motion costs goes with its frequency.
        let frequency = Parameter::FREE.with_prior(0.0, FREQUENCY_U);
        all[FREQUENCY] = frequency.within(-MOST_FREQUENCY, MOST_FREQUENCY);
        // Each has the damping torque 2 · share · ω² · reach at the fastest rate ω · reach.
        let torque = 2.0 * DAMPING_U * omega * omega * reach;
        let rate = omega * reach;
        let widths = [
            (DAMPING, 0.5 * torque / rate),
            (DRAG, torque / (rate * rate)),
            (FRICTION, torque),
        ];
        for (place, u) in widths {
            // Nothing drives the body.
            all[place] = Parameter::FREE.with_prior(0.0, u);
            all[place].low = 0.0;
        }
        let (mean, u) = HARDNESS_PRIOR;
        all[HARDNESS] = match self.restoring {
            Restoring::Unknown => Parameter::FREE.with_prior(mean, u),
            Restoring::Known(_) => Parameter::FREE.within(0.0, 0.0),
        };
        for (l, line) in self.lines.iter().enumerate() {
            let first = FIRST_LINE + LINE * l;
            all[first..first + LINE].copy_from_slice(&line.parameters());
        }
        all
    }

    fn numbers(x: &[f64]) -> [f64; OF_MOTION] {
        std::array::from_fn(|k| x[k])
    }

    /// Samples of the part.
    fn times_s(&self) -> &[f64] {
        let end = self
            .readings
            .blocks_to(self.horizon_s)
            .last()
            .map_or(0, |b| b.end);
        &self.readings.t_s[..end]
    }

    fn kind(&self) -> usize {
        usize::from(!self.readings.is_angle)
    }

    /// What the sensor reads at every sample of the part.
    pub fn simulated(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.at_times(x, self.times_s())
    }

    /// What is left of every sample of the part.
    pub fn left(&self, x: &[f64]) -> Option<Vec<f64>> {
        let simulated = self.simulated(x)?;
        let pairs = self.readings.values.iter().zip(simulated);
        Some(pairs.map(|(value, by)| value - by).collect())
    }

    /// What it reads at times by its clock, s; before the first sample what it reads there.
    pub fn at(&self, x: &[f64], t_s: &[f64]) -> Option<Vec<f64>> {
        let start_s = self.readings.start_s;
        let from_start: Vec<f64> = t_s.iter().map(|t| (t - start_s).max(0.0)).collect();
        self.at_times(x, &from_start)
    }

    fn at_times(&self, x: &[f64], times_s: &[f64]) -> Option<Vec<f64>> {
        let base = Base::new(self.restoring, self.omega_rad_s, Self::numbers(x));
        let motion = base.motion(times_s)?;
        let beside = |t: f64| Line::sum(self.lines, &x[FIRST_LINE..], t);
        let readings =
            (times_s.iter().zip(motion)).map(|(t, now)| now[self.kind()] + x[REST] + beside(*t));
        Some(readings.collect())
    }

    /// Standard deviation of the mean of a block.
    pub fn noise(&self, samples: usize) -> f64 {
        self.readings.noise / (samples as f64).sqrt()
    }

    fn slopes(&self, x: &[f64]) -> Option<DMatrix<f64>> {
        let numbers = Self::numbers(x);
        let dual = std::array::from_fn(|k| Dual::<OF_MOTION>::parameter(numbers[k], k));
        let base = Base::new(self.restoring, self.omega_rad_s, dual);
        let blocks = self.readings.blocks_to(self.horizon_s);
        let mut matrix = DMatrix::zeros(blocks.len(), self.count());
        let (mut i, mut row) = (0, 0);
        base.each(self.times_s().iter().copied(), |now| {
            while row + 1 < blocks.len() && i >= blocks[row].end {
                row += 1;
            }
            for (k, slope) in now[self.kind()].slope.iter().enumerate() {
                matrix[(row, k)] += slope;
            }
            matrix[(row, REST)] += 1.0;
            self.add_lines(x, self.readings.t_s[i], (&mut matrix, row));
            i += 1;
        })?;
        for (row, block) in blocks.iter().enumerate() {
            // Of the mean, over its noise, and of measured less simulated.
            let count = block.len() as f64;
            matrix
                .row_mut(row)
                .scale_mut(-1.0 / (count * self.noise(block.len())));
        }
        Some(matrix)
    }

    fn add_lines(&self, x: &[f64], t_s: f64, (matrix, row): (&mut DMatrix<f64>, usize)) {
        for (l, line) in self.lines.iter().enumerate() {
            let first = FIRST_LINE + LINE * l;
            let slopes = line.slopes(&x[first..first + LINE], t_s);
            for (k, slope) in slopes.into_iter().enumerate() {
                matrix[(row, first + k)] += slope;
            }
        }
    }
}

impl Rows for Problem<'_> {
    fn shape(&self) -> Shape {
        Shape::single(self.count())
    }

    fn rows(&self, _: usize, x: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
        let simulated = self.simulated(x)?;
        let blocks = self.readings.blocks_to(self.horizon_s).iter();
        let left = |i: usize| self.readings.values[i] - simulated[i];
        let rows = blocks.map(|block| Readings::mean(block, left) / self.noise(block.len()));
        let residuals = DVector::from_vec(rows.collect());
        let jacobian = match wanted {
            Wanted::Residuals => None,
            Wanted::Jacobian => Some(self.slopes(x)?),
        };
        residuals.iter().all(|r| r.is_finite()).then_some(Block {
            residuals,
            jacobian,
        })
    }
}
