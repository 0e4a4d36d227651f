//! The least-squares problem: readings less motion, resting reading and lines beside it.
//!
//! # Conventions
//! What is fitted, in order: angle and rate at the start (rad, rad/s), the logarithm of the frequency
//! over that of the start, α (1/s), the reading at rest, the numbers of each line, those of each
//! effect.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use gyradius_base::parallel::in_parallel;
use gyradius_estimation::{Block, Parameter, Rows, Shape, Wanted};
use gyradius_mechanics::Real;
use gyradius_mechanics::one_angle::effects::{
    Acts, AnyEffect, BearingFriction, Jet, LANES, QuadraticDrag, RestoringForce, Scales, Swinging,
};
use gyradius_mechanics::one_angle::{Law, Now, follow};

use super::lines::{LINE, Line};
use super::readings::Readings;

/// Places of the numbers of the motion among all that is fitted.
pub const ANGLE: usize = 0;
/// Rate at the start.
pub const RATE: usize = 1;
/// Logarithm of the frequency over that of the start.
pub const FREQUENCY: usize = 2;
/// α.
pub const DAMPING: usize = 3;
/// The reading at rest; lines come after it.
pub const REST: usize = 4;
const FIRST_LINE: usize = REST + 1;
/// Places of the numbers that move the body.
const OF_MOTION: [usize; 4] = [ANGLE, RATE, FREQUENCY, DAMPING];

/// Width of the priors of what brakes a swing: its torque at the fastest rate of the start, as a share
/// of critical damping. A body loses most of its energy in one period at a twelfth of it; the
/// width decides where a few cycles cannot tell linear damping, drag and friction apart.
pub const DAMPING_U: f64 = 0.3;
/// Of the logarithm of the frequency about that of the start.
const FREQUENCY_U: f64 = 0.5;
const MOST_FREQUENCY: f64 = 1.0;
/// κ where nobody says how the body hangs: that of a pendulum, and within one standard deviation
/// that of a spring and of two lines.
const HARDNESS_PRIOR: (f64, f64) = (1.0, 1.0);

/// An effect with what is known of its numbers.
#[derive(Debug, Clone, Copy)]
pub struct Fitting<'a> {
    /// What it does.
    pub effect: &'a AnyEffect,
    /// Its numbers.
    pub parameters: &'a [Parameter],
}

const BRAKE: Parameter = Parameter {
    prior: Some((0.0, DAMPING_U)),
    // Nothing drives the body.
    low: 0.0,
    high: f64::INFINITY,
};
const HARDNESS: Parameter = Parameter {
    prior: Some(HARDNESS_PRIOR),
    ..Parameter::FREE
};
/// Places of b, c and κ among the numbers of [`measured`].
pub const DRAG: usize = 0;
/// c.
pub const FRICTION: usize = 1;
/// κ.
pub const HARDNESS_PLACE: usize = 2;

/// What is fitted to every swing that is measured: drag, dry friction, and where nobody says how it
/// hangs, how its restoring force bends.
pub fn measured(knows_law: bool) -> &'static [Fitting<'static>] {
    static ALL: [Fitting<'static>; 3] = [
        Fitting {
            effect: &QuadraticDrag,
            parameters: &[BRAKE],
        },
        Fitting {
            effect: &BearingFriction,
            parameters: &[BRAKE],
        },
        Fitting {
            effect: &RestoringForce,
            parameters: &[HARDNESS],
        },
    ];
    &ALL[..if knows_law { HARDNESS_PLACE } else { ALL.len() }]
}

/// What is fitted to blocks of the readings.
pub struct Problem<'a> {
    /// The readings.
    pub readings: &'a Readings,
    /// What brings the body back.
    pub law: Law,
    /// Frequency and width of the start.
    pub scales: Scales,
    /// Weak oscillations beside it.
    pub lines: &'a [Line],
    /// What else acts.
    pub effects: &'a [Fitting<'a>],
    /// The blocks that count, rising.
    pub blocks: &'a [Range<usize>],
    /// Noise of a sample, unit of the readings.
    pub noise: f64,
}

impl Problem<'_> {
    /// Where the numbers of the effects begin.
    pub fn first_effect(&self) -> usize {
        FIRST_LINE + LINE * self.lines.len()
    }

    /// How many numbers are fitted.
    pub fn count(&self) -> usize {
        let numbers = self.effects.iter().map(|one| one.parameters.len());
        self.first_effect() + numbers.sum::<usize>()
    }

    /// Priors and bounds.
    pub fn parameters(&self) -> Vec<Parameter> {
        let mut all = vec![Parameter::FREE; self.count()];
        // What a motion costs goes with its frequency.
        let frequency = Parameter::FREE.with_prior(0.0, FREQUENCY_U);
        all[FREQUENCY] = frequency.within(-MOST_FREQUENCY, MOST_FREQUENCY);
        all[DAMPING] = Parameter::FREE.with_prior(0.0, DAMPING_U * self.scales.omega_rad_s);
        all[DAMPING].low = 0.0;
        for (l, line) in self.lines.iter().enumerate() {
            let first = FIRST_LINE + LINE * l;
            all[first..first + LINE].copy_from_slice(&line.parameters());
        }
        let effects = self.effects.iter().flat_map(|one| one.parameters);
        all[self.first_effect()..]
            .iter_mut()
            .zip(effects)
            .for_each(|(place, parameter)| *place = *parameter);
        all
    }

    fn swinging<'q, R: Real>(&'q self, x: &'q [R]) -> Swinging<'q, R> {
        let mut from = self.first_effect();
        let effects = self.effects.iter().map(|one| {
            let to = from + one.parameters.len();
            (one.effect, &x[std::mem::replace(&mut from, to)..to])
        });
        Swinging {
            law: self.law,
            scales: self.scales,
            omega_rad_s: x[FREQUENCY].exp().scale(self.scales.omega_rad_s),
            damping_per_s: x[DAMPING],
            effects: effects.collect(),
        }
    }

    fn each<R: Real>(&self, x: &[R], times_s: &[f64], take: impl FnMut(usize, R)) -> Option<()>
    where
        AnyEffect: Acts<R>,
    {
        let start = [x[ANGLE], x[RATE]];
        (self.swinging(x)).readings(start, self.readings.is_angle, times_s, take)
    }

    /// Angles of the motion alone, rad, at rising times from the start, s.
    pub fn angles_rad(&self, x: &[f64], times_s: &[f64]) -> Option<Vec<f64>> {
        let swinging = self.swinging(x);
        let start = Now::start(x[ANGLE], x[RATE]);
        let motion = follow(&swinging, start, swinging.omega_rad_s, times_s)?;
        Some(motion.into_iter().map(|[angle, _]| angle).collect())
    }

    /// Samples up to the last block.
    fn times_s(&self) -> &[f64] {
        let end = self.blocks.last().map_or(0, |b| b.end);
        &self.readings.t_s[..end]
    }

    /// What the sensor reads at every sample up to the last block.
    pub fn simulated(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.at_times(x, self.times_s())
    }

    /// What is left of every one of them.
    pub fn left(&self, x: &[f64]) -> Option<Vec<f64>> {
        let simulated = self.simulated(x)?;
        let pairs = self.readings.values.iter().zip(simulated);
        Some(pairs.map(|(value, by)| value - by).collect())
    }

    /// What the sensor reads at every sample of the record.
    pub fn at_samples(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.at_times(x, &self.readings.t_s)
    }

    /// What it reads at times by its clock, s; before the first sample what it reads there.
    pub fn at(&self, x: &[f64], t_s: &[f64]) -> Option<Vec<f64>> {
        let start_s = self.readings.start_s;
        let from_start: Vec<f64> = t_s.iter().map(|t| (t - start_s).max(0.0)).collect();
        self.at_times(x, &from_start)
    }

    fn at_times(&self, x: &[f64], times_s: &[f64]) -> Option<Vec<f64>> {
        let lines = &x[FIRST_LINE..self.first_effect()];
        let mut readings = Vec::with_capacity(times_s.len());
        self.each(x, times_s, |sample, turn| {
            readings.push(turn + x[REST] + Line::sum(self.lines, lines, times_s[sample]));
        })?;
        Some(readings)
    }

    /// Standard deviation of the mean of a block.
    pub fn block_noise(&self, samples: usize) -> f64 {
        self.noise / (samples as f64).sqrt()
    }

    /// Derivatives of what is left of the blocks, over their noise.
    fn slopes(&self, x: &[f64]) -> Option<DMatrix<f64>> {
        self.slopes_by(x, 0..self.count())
    }

    /// Those by some of the numbers; zero by the others that move the body.
    pub fn slopes_by(&self, x: &[f64], wanted: Range<usize>) -> Option<DMatrix<f64>> {
        let mut matrix = DMatrix::zeros(self.blocks.len(), self.count());
        let moving: Vec<usize> = OF_MOTION
            .into_iter()
            .chain(self.first_effect()..x.len())
            .filter(|place| wanted.contains(place))
            .collect();
        let chunks: Vec<&[usize]> = moving.chunks(LANES).collect();
        for (lanes, sums) in chunks
            .iter()
            .zip(in_parallel(chunks.len(), |k| self.sums(x, chunks[k])))
        {
            for (place, column) in lanes.iter().zip(sums?.column_iter()) {
                matrix.set_column(*place, &column);
            }
        }
        for (row, block) in self.blocks.iter().enumerate() {
            for i in block.clone() {
                matrix[(row, REST)] += 1.0;
                self.add_lines(x, self.readings.t_s[i], (&mut matrix, row));
            }
            // Of the mean, over its noise, and of measured less simulated.
            let scale = block.len() as f64 * self.block_noise(block.len());
            matrix.row_mut(row).scale_mut(-1.0 / scale);
        }
        Some(matrix)
    }

    /// Derivatives by so many numbers as a jet carries, sums over blocks.
    fn sums(&self, x: &[f64], lanes: &[usize]) -> Option<DMatrix<f64>> {
        let mut jets: Vec<Jet> = x.iter().map(|x| Jet::constant(*x)).collect();
        for (lane, place) in lanes.iter().enumerate() {
            jets[*place] = Jet::parameter(x[*place], lane);
        }
        let mut sums = DMatrix::zeros(self.blocks.len(), lanes.len());
        let mut row = 0;
        self.each(&jets, self.times_s(), |sample, reading| {
            while sample >= self.blocks[row].end {
                row += 1;
            }
            if sample >= self.blocks[row].start {
                for (lane, slope) in (0..lanes.len()).zip(reading.slope) {
                    sums[(row, lane)] += slope;
                }
            }
        })?;
        Some(sums)
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
        let left = self.left(x)?;
        let rows = self
            .blocks
            .iter()
            .map(|block| Readings::mean(block, |i| left[i]) / self.block_noise(block.len()));
        let residuals = DVector::from_iterator(self.blocks.len(), rows);
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
