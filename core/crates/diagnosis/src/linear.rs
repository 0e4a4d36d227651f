//! How far a simulated swing is from its samples, and how the readings change with everything that
//! is fitted.

use std::borrow::Cow;
use std::ops::Range;

use nalgebra::DMatrix;

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_identification::samples::{LANES, SHARED_LANES, Sensor, Stream};
use gyradius_mechanics::{Experiment, Fineness, Path, Reading};

use super::point::{BIAS, Cause, Model, OWN, Part, Point};

/// Steps of numerical derivatives by the phone's place, m, and turn, rad; by a clock's error.
const PLACE_STEP_M: f64 = 1e-4;
const TURN_STEP_RAD: f64 = 1e-5;
const CLOCK_STEP: f64 = 1e-6;

/// Derivatives by a cause of no more parameters than this are taken to both sides.
const TWO_SIDED: usize = 2;
/// Near the best fit steps to one side are so much shorter. What rings through a recording turns by
/// radians along a long one: far from the best fit that leads past what is best only nearby, near
/// it it leads astray.
const FINE: f64 = 1e-3;

/// A block of samples that counts.
pub struct Block<'a> {
    pub stream: usize,
    pub range: &'a Range<usize>,
    /// Mean time of its samples, s.
    pub t_s: f64,
}

impl Model<'_> {
    /// The blocks of a swing that count, stream after stream. Their rows are x, y, z of each.
    pub fn blocks(&self, s: usize) -> Vec<Block<'_>> {
        let samples = &self.swing(s).samples;
        let mut blocks = Vec::new();
        for (stream, all) in samples.streams.iter().enumerate() {
            for range in &all.blocks {
                let t_s = all.t_s[range.clone()].iter().sum::<f64>() / range.len() as f64;
                let is_seen = all.t_s[range.end - 1] <= self.until_s(s);
                if is_seen && self.part.has(t_s, samples.duration_s) {
                    blocks.push(Block { stream, range, t_s });
                }
            }
        }
        blocks
    }

    /// Differences of every sample and its reading over the noise, stream by stream.
    pub fn residuals(&self, point: &Point, s: usize) -> Result<Vec<Vec<Vec3>>> {
        let swung = self.swing(s);
        let readings = self.readings(point, s)?;
        let of = |(stream, readings): (&Stream, Vec<Vec3>)| {
            let each = stream.values.iter().zip(readings);
            each.map(|(value, reading)| (value - reading).component_div(&stream.noise))
                .collect()
        };
        Ok(swung.samples.streams.iter().zip(readings).map(of).collect())
    }

    /// So far a swing is looked at, s.
    fn until_s(&self, s: usize) -> f64 {
        let duration_s = self.swing(s).samples.duration_s;
        if let Part::First(horizon_s) = self.part {
            duration_s.min(horizon_s)
        } else {
            duration_s
        }
    }

    /// Readings at the time of every sample that is looked at, stream by stream.
    pub fn readings(&self, point: &Point, s: usize) -> Result<Vec<Vec<Vec3>>> {
        let swung = self.swing(s);
        let experiment = self.experiment(point, s)?;
        let until_s = self.until_s(s);
        let path = experiment.motion(self.fineness(), until_s)?;
        let seen = |stream: &Stream| stream.t_s.partition_point(|t| *t <= until_s);
        let times: Vec<&[f64]> = swung
            .samples
            .streams
            .iter()
            .map(|stream| &stream.t_s[..seen(stream)])
            .collect();
        let sensors = swung.samples.streams.iter().map(|stream| stream.sensor);
        let all = once_each(&times, |t_s| experiment.readings_on(&path, t_s))?;
        let part = |(readings, sensor): (Vec<Reading<f64>>, Sensor)| {
            readings.iter().map(|r| picked(sensor, r)).collect()
        };
        Ok(all.into_iter().zip(sensors).map(part).collect())
    }

    /// The motion of a swing as far as it is looked at.
    pub fn path(&self, point: &Point, s: usize) -> Result<Path<f64>> {
        self.experiment(point, s)?
            .motion(self.fineness(), self.until_s(s))
    }

    /// The same for derivatives.
    pub fn path_of_slopes(&self, point: &Point, s: usize) -> Result<Path<f64>> {
        self.experiment(point, s)?
            .motion(self.fineness_of_slopes(), self.until_s(s))
    }

    /// Mean residual of each block over its standard deviation, block after block.
    pub fn rows(&self, point: &Point, s: usize) -> Result<Vec<f64>> {
        let residuals = self.residuals(point, s)?;
        let row = |block: &Block| {
            let sum: Vec3 = residuals[block.stream][block.range.clone()].iter().sum();
            let mean = sum / (block.range.len() as f64).sqrt();
            [mean.x, mean.y, mean.z]
        };
        Ok(self.blocks(s).iter().flat_map(row).collect())
    }

    /// What readings, by time of each block, become as rows.
    fn as_rows(&self, s: usize, blocks: &[Block], readings: &[Vec3]) -> Vec<f64> {
        let streams = &self.swing(s).samples.streams;
        let row = |(block, reading): (&Block, &Vec3)| {
            let weight = (block.range.len() as f64).sqrt();
            let v = reading.component_div(&streams[block.stream].noise) * weight;
            [v.x, v.y, v.z]
        };
        blocks.iter().zip(readings).flat_map(row).collect()
    }

    /// Derivatives of the readings, as rows: by the session's free parameters, the phone's place
    /// and turn (of the swing's mount), the causes' parameters, the swing's own.
    pub fn jacobian(&self, point: &Point, s: usize) -> Result<DMatrix<f64>> {
        let blocks = self.blocks(s);
        let free = &self.base.free;
        let causes: usize = point.causes.iter().map(Vec::len).sum();
        let mut out = DMatrix::zeros(3 * blocks.len(), free.len() + 6 + causes + OWN);
        self.fill_motion(point, s, &blocks, &mut out)?;
        let reader = Reader::new(self, point, s, &blocks)?;
        let here = reader.reread(point)?;
        self.fill_clock_and_pose(point, &reader, &mut out)?;
        let mut column = free.len();
        for k in 0..6 {
            let step = if k < 3 { PLACE_STEP_M } else { TURN_STEP_RAD };
            let moved =
                |sign: f64| reader.reread(&moved_phone(point, self.swing(s).mount, k, sign * step));
            set(&mut out, column, &moved(1.0)?, &moved(-1.0)?, 2.0 * step);
            column += 1;
        }
        for (c, cause) in self.causes.iter().enumerate() {
            for (k, (parameter, own)) in cause.expanded(self.base.swings.len()).iter().enumerate() {
                if own.is_none_or(|own| own == s) {
                    reader.fill_cause(
                        (c, k, parameter.step),
                        (cause.on_phone, &here),
                        column,
                        &mut out,
                    )?;
                }
                column += 1;
            }
        }
        for k in 0..6 {
            let (sensor, axis) = (k / 3, k % 3);
            let unit = blocks.iter().map(|b| {
                if b.stream == sensor {
                    Vec3::ith(axis, 1.0)
                } else {
                    Vec3::zeros()
                }
            });
            let rows = self.as_rows(s, &blocks, &unit.collect::<Vec<_>>());
            out.column_mut(column + BIAS + k).copy_from_slice(&rows);
        }
        Ok(out)
    }

    /// Of derivatives of the whole recordings, those of the part that this model looks at.
    pub fn of_part(&self, whole: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
        let all = Model {
            part: Part::All,
            ..self.clone()
        };
        let rows = |s: usize| {
            let duration_s = self.swing(s).samples.duration_s;
            let blocks = all.blocks(s).into_iter().enumerate();
            let seen = blocks.filter(|(_, block)| self.part.has(block.t_s, duration_s));
            seen.flat_map(|(k, _)| 3 * k..3 * k + 3)
                .collect::<Vec<usize>>()
        };
        whole
            .iter()
            .enumerate()
            .map(|(s, jacobian)| jacobian.select_rows(&rows(s)))
            .collect()
    }

    /// Whether derivatives by a cause are taken to one side alone, over steps that are long near
    /// the best fit. (Where a phone's readings are in proportion to all of a cause, no step is
    /// long.)
    pub fn is_coarse(&self) -> bool {
        let in_proportion =
            |cause: &Cause| cause.on_phone && cause.parameters.iter().all(|p| p.is_strength);
        self.causes
            .iter()
            .any(|cause| !is_few(cause.size(self.base.swings.len())) && !in_proportion(cause))
    }

    /// Derivatives of this model, the last of whose causes was just added, from those without it.
    pub fn widened(&self, without: &DMatrix<f64>, point: &Point, s: usize) -> Result<DMatrix<f64>> {
        let blocks = self.blocks(s);
        let Some((cause, last)) = self.causes.last().zip(self.causes.len().checked_sub(1)) else {
            return Ok(without.clone());
        };
        let expanded = cause.expanded(self.base.swings.len());
        let first = without.ncols() - OWN;
        let mut out = without.clone().insert_columns(first, expanded.len(), 0.0);
        let reader = Reader::new(self, point, s, &blocks)?;
        let here = reader.reread(point)?;
        for (k, (parameter, own)) in expanded.iter().enumerate() {
            if own.is_none_or(|own| own == s) {
                reader.fill_cause(
                    (last, k, parameter.step),
                    (cause.on_phone, &here),
                    first + k,
                    &mut out,
                )?;
            }
        }
        Ok(out)
    }

    /// By start, damping and the session's parameters as far as they move the hull.
    fn fill_motion(
        &self,
        point: &Point,
        s: usize,
        blocks: &[Block],
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        let swung = self.swing(s);
        let own = self.own(point, s);
        let free = &self.base.free;
        let (pliant, there) = self.pliant(point, self.causes.len());
        let experiment = pliant.experiment(&there, s)?;
        let by_lane = swung.setup.lane_slopes(&point.x, &own, free)?;
        let damping = swung.setup.damping_slopes(&experiment.scene);
        let first_own = out.ncols() - OWN;
        let of_streams: Vec<(Vec<usize>, Vec<&Block>)> = (0..swung.samples.streams.len())
            .map(|stream| {
                blocks
                    .iter()
                    .enumerate()
                    .filter(|(_, b)| b.stream == stream)
                    .unzip()
            })
            .collect();
        let times: Vec<Vec<f64>> = of_streams
            .iter()
            .map(|(_, of_stream)| of_stream.iter().map(|b| b.t_s).collect())
            .collect();
        // Across kinks derivatives need no halved steps to lead the way; where a motion cannot be
        // followed without, a fit ends, and is led on with them if it is worth it.
        let fineness = self.fineness_of_slopes();
        let straight = Fineness {
            most_halvings: 0,
            ..fineness
        };
        let slopes = |fineness| {
            once_each(&times, |t_s| {
                experiment.slopes_of_motion(&LANES, fineness, t_s)
            })
        };
        let all = slopes(straight).or_else(|error| {
            if self.fine {
                slopes(fineness)
            } else {
                Err(error)
            }
        })?;
        for (stream, ((places, of_stream), slopes)) in of_streams.iter().zip(all).enumerate() {
            let sensor = &swung.samples.streams[stream];
            let first = if sensor.sensor == Sensor::Gyroscope {
                0
            } else {
                3
            };
            for (n, (place, block)) in places.iter().zip(of_stream).enumerate() {
                let weight = (block.range.len() as f64).sqrt();
                for axis in 0..3 {
                    let row = 3 * place + axis;
                    let scale = weight / sensor.noise[axis];
                    let lanes = &slopes[(6 * n + first + axis) * LANES.len()..][..LANES.len()];
                    for column in 0..free.len() {
                        let sum: f64 = (0..LANES.len())
                            .map(|l| lanes[l] * by_lane[(l, column)])
                            .sum();
                        out[(row, column)] = scale * sum;
                    }
                    for k in 0..BIAS {
                        let factor = if k < 8 { 1.0 } else { damping[k - 8] };
                        out[(row, first_own + k)] = scale * factor * lanes[SHARED_LANES + k];
                    }
                }
            }
        }
        Ok(())
    }

    /// What the phone reads of the same motion with another clock, or lying otherwise: by the
    /// clocks, the pitch and the depth.
    fn fill_clock_and_pose(
        &self,
        point: &Point,
        reader: &Reader,
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        let swung = self.swing(reader.s);
        let (layout, index) = (self.base.layout(), swung.setup.index);
        for (column, i) in self.base.free.iter().enumerate() {
            let step = if *i == layout.clock || Some(*i) == index.clock {
                CLOCK_STEP
            } else if [index.pitch_deg, index.log_depth].contains(i) {
                layout.parameters[*i].step
            } else {
                continue;
            };
            let moved = |sign: f64| {
                let mut moved = point.clone();
                moved.x[*i] += sign * step;
                reader.reread(&moved)
            };
            let change = difference(&moved(1.0)?, &moved(-1.0)?, 2.0 * step);
            out.column_mut(column)
                .iter_mut()
                .zip(change)
                .for_each(|(cell, more)| *cell += more);
        }
        Ok(())
    }
}

/// Reads a swing at the times of its blocks.
pub struct Reader<'a> {
    model: &'a Model<'a>,
    point: &'a Point,
    pub s: usize,
    blocks: &'a [Block<'a>],
    path: Cow<'a, Path<f64>>,
}

impl<'a> Reader<'a> {
    pub fn new(
        model: &'a Model<'a>,
        point: &'a Point,
        s: usize,
        blocks: &'a [Block<'a>],
    ) -> Result<Self> {
        Ok(Self {
            model,
            point,
            s,
            blocks,
            path: Cow::Owned(model.path_of_slopes(point, s)?),
        })
    }

    /// Where the motion at the point is known already.
    pub fn along(
        path: &'a Path<f64>,
        model: &'a Model<'a>,
        (point, s): (&'a Point, usize),
        blocks: &'a [Block<'a>],
    ) -> Self {
        Self {
            model,
            point,
            s,
            blocks,
            path: Cow::Borrowed(path),
        }
    }

    /// Rows of the same motion with another phone.
    pub fn reread(&self, point: &Point) -> Result<Vec<f64>> {
        self.read(&self.model.experiment(point, self.s)?, &self.path)
    }

    /// Rows of another motion.
    pub fn moved(&self, point: &Point) -> Result<Vec<f64>> {
        self.read(
            &self.model.experiment(point, self.s)?,
            &self.model.path_of_slopes(point, self.s)?,
        )
    }

    fn read(&self, experiment: &Experiment, path: &Path<f64>) -> Result<Vec<f64>> {
        let streams = &self.model.swing(self.s).samples.streams;
        // Block after block, stream after stream.
        let times: Vec<Vec<f64>> = (0..streams.len())
            .map(|stream| {
                self.blocks
                    .iter()
                    .filter(|b| b.stream == stream)
                    .map(|b| b.t_s)
                    .collect()
            })
            .collect();
        let all = once_each(&times, |t_s| experiment.readings_on(path, t_s))?;
        let readings = all
            .iter()
            .zip(streams)
            .flat_map(|(all, stream)| all.iter().map(|r| (stream.sensor, r)));
        let values: Vec<Vec3> = readings
            .map(|(sensor, reading)| picked(sensor, reading))
            .collect();
        Ok(self.model.as_rows(self.s, self.blocks, &values))
    }

    fn fill_cause(
        &self,
        (cause, k, step): (usize, usize, f64),
        (on_phone, here): (bool, &[f64]),
        column: usize,
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        let moved = |by: f64| {
            let mut moved = self.point.clone();
            moved.causes[cause][k] += by;
            if on_phone {
                self.reread(&moved)
            } else {
                self.moved(&moved)
            }
        };
        // What shifts a period must be known better than a step forwards tells; below zero some
        // laws have no meaning.
        let few = is_few(self.point.causes[cause].len());
        if let Some(Ok(down)) = few.then(|| moved(-step)) {
            set(out, column, &moved(step)?, &down, 2.0 * step);
        } else {
            let step = if self.model.fine { FINE * step } else { step };
            set(out, column, &moved(step)?, here, step);
        }
        Ok(())
    }
}

/// Whether derivatives by so many values of a cause are taken to both sides.
fn is_few(values: usize) -> bool {
    values <= TWO_SIDED
}

fn set(out: &mut DMatrix<f64>, column: usize, up: &[f64], down: &[f64], by: f64) {
    out.column_mut(column)
        .copy_from_slice(&difference(up, down, by));
}

fn difference(up: &[f64], down: &[f64], by: f64) -> Vec<f64> {
    up.iter().zip(down).map(|(u, d)| (u - d) / by).collect()
}

fn moved_phone(point: &Point, mount: usize, k: usize, by: f64) -> Point {
    let mut moved = point.clone();
    let along = |first: usize| {
        if (first..first + 3).contains(&k) {
            Vec3::ith(k - first, by)
        } else {
            Vec3::zeros()
        }
    };
    moved.mounts[mount] = moved.mounts[mount].moved(along(0), along(3));
    moved
}

fn picked(sensor: Sensor, reading: &Reading<f64>) -> Vec3 {
    match sensor {
        Sensor::Gyroscope => reading.gyro,
        Sensor::Accelerometer => reading.force,
    }
}

/// What is found at each of several lists of times; lists that are alike are looked at once.
fn once_each<L: AsRef<[f64]>, T: Clone>(
    times: &[L],
    find: impl Fn(&[f64]) -> Result<T>,
) -> Result<Vec<T>> {
    let mut all: Vec<T> = Vec::new();
    for (n, list) in times.iter().enumerate() {
        let known = times[..n]
            .iter()
            .position(|other| other.as_ref() == list.as_ref());
        all.push(known.map_or_else(|| find(list.as_ref()), |k| Ok(all[k].clone()))?);
    }
    Ok(all)
}
