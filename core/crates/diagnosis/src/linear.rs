//! How far a simulated swing is from its samples, and how the readings change with everything that
//! is fitted.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_identification::samples::{Sensor, Stream};
use gyradius_mechanics::{Fineness, LANES, Path, Reading};

use super::fitting::Places;
use super::point::{Model, OWN, Part, Point};

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
        let fitted_swing = self.swing(s);
        let readings = self.readings(point, s)?;
        let of = |(stream, readings): (&Stream, Vec<Vec3>)| {
            let each = stream.values.iter().zip(readings);
            each.map(|(value, reading)| (value - reading).component_div(&stream.noise))
                .collect()
        };
        Ok(fitted_swing
            .samples
            .streams
            .iter()
            .zip(readings)
            .map(of)
            .collect())
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
        let fitted_swing = self.swing(s);
        let experiment = self.experiment(point, s)?;
        let until_s = self.until_s(s);
        let path = experiment.motion(self.fineness(), until_s)?;
        let seen = |stream: &Stream| stream.t_s.partition_point(|t| *t <= until_s);
        let times: Vec<&[f64]> = fitted_swing
            .samples
            .streams
            .iter()
            .map(|stream| &stream.t_s[..seen(stream)])
            .collect();
        let sensors = fitted_swing
            .samples
            .streams
            .iter()
            .map(|stream| stream.sensor);
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

    /// What the phone reads at the mean time of each block, as rows.
    pub fn read_rows(&self, point: &Point, s: usize) -> Result<Vec<f64>> {
        self.rows_along(&self.path(point, s)?, point, s)
    }

    fn rows_along(&self, path: &Path<f64>, point: &Point, s: usize) -> Result<Vec<f64>> {
        let blocks = self.blocks(s);
        let times = Times::of(&blocks);
        let readings = self.experiment(point, s)?.readings_on(path, &times.t_s)?;
        let each = blocks.iter().zip(&times.places);
        let row = |(block, place): (&Block, &usize)| {
            let scale = self.scale(s, block);
            let reading = picked(self.sensor(s, block), &readings[*place]).component_mul(&scale);
            [reading.x, reading.y, reading.z]
        };
        Ok(each.flat_map(row).collect())
    }

    fn sensor(&self, s: usize, block: &Block) -> Sensor {
        self.swing(s).samples.streams[block.stream].sensor
    }

    /// What makes the mean of a block a row: one over its standard deviation.
    fn scale(&self, s: usize, block: &Block) -> Vec3 {
        let noise = &self.swing(s).samples.streams[block.stream].noise;
        noise.map(|noise| (block.range.len() as f64).sqrt() / noise)
    }

    /// Derivatives of the readings, as rows: by the session's free parameters, the phone's place
    /// and turn (of the swing's mount), the causes' parameters, the swing's own.
    pub fn jacobian(&self, point: &Point, s: usize) -> Result<DMatrix<f64>> {
        let places = Places::of(self);
        let (first, own) = (places.free + 6, places.free + 6 + places.causes);
        let blocks = self.blocks(s);
        let mut out = DMatrix::zeros(3 * blocks.len(), own + OWN);
        let of_causes = (first..own).map(Wanted::same);
        let is_kinked = self.fineness() == Fineness::OF_KINKED_FITS;
        if self.is_apart() || is_kinked {
            let (reduced, there) = self.reduced(point, self.causes.len());
            let gone = places.causes - Places::of(&reduced).causes;
            let of_own = (own..own + OWN).map(|k| Wanted {
                column: k - gone,
                to: k,
            });
            let others: Vec<Wanted> = (0..first).map(Wanted::same).chain(of_own).collect();
            let of_causes: Vec<Wanted> = of_causes.collect();
            reduced.fill((&there, s), &blocks, &others, None, &mut out)?;
            self.fill_causes((point, s), &blocks, &of_causes, &mut out)?;
        } else {
            let rest = (0..first).chain(own..own + OWN).map(Wanted::same);
            let all: Vec<Wanted> = rest.chain(of_causes).collect();
            self.fill((point, s), &blocks, &all, None, &mut out)?;
        }
        Ok(out)
    }

    /// Derivatives of this model, the last of whose causes was just added, from those without it.
    pub fn widened(&self, without: &DMatrix<f64>, point: &Point, s: usize) -> Result<DMatrix<f64>> {
        let Some(size) = point.causes.last().map(Vec::len) else {
            return Ok(without.clone());
        };
        let first = without.ncols() - OWN;
        let mut out = without.clone().insert_columns(first, size, 0.0);
        let wanted: Vec<Wanted> = (first..first + size).map(Wanted::same).collect();
        self.fill_causes((point, s), &self.blocks(s), &wanted, &mut out)?;
        Ok(out)
    }

    /// Derivatives by causes' numbers: across kinks with halved steps, near the best fit.
    fn fill_causes(
        &self,
        at: (&Point, usize),
        blocks: &[Block],
        wanted: &[Wanted],
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        self.filled(
            at,
            blocks,
            wanted,
            (None, &|slopes| slopes(self.fineness_of_slopes())),
            out,
        )
    }

    /// Derivatives by some of what is fitted, along the motion at the point where that is known.
    /// Across kinks they need no halved steps to lead the way; where a motion cannot be followed
    /// without, a fit ends, and is led on with them if it is worth it.
    pub fn fill(
        &self,
        at: (&Point, usize),
        blocks: &[Block],
        wanted: &[Wanted],
        path: Option<&Path<f64>>,
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        let fineness = self.fineness_of_slopes();
        let straight = Fineness {
            most_halvings: 0,
            ..fineness
        };
        let run = |slopes: &Slopes| {
            let whole = |error| {
                if self.fine {
                    slopes(fineness)
                } else {
                    Err(error)
                }
            };
            slopes(straight).or_else(whole)
        };
        self.filled(at, blocks, wanted, (path, &run), out)
    }

    fn filled(
        &self,
        (point, s): (&Point, usize),
        blocks: &[Block],
        wanted: &[Wanted],
        (path, run): (Option<&Path<f64>>, &Run),
        out: &mut DMatrix<f64>,
    ) -> Result<()> {
        let (mut moving, mut read) = (vec![], vec![]);
        for group in wanted.chunks(LANES) {
            let experiment = self.differentiated(point, s, group)?;
            for (lane, one) in group.iter().enumerate() {
                if let Some((ends, by)) = self.across(point, one.column) {
                    let [none, some] = ends.map(|end| {
                        let path = self.path_of_slopes(&end, s)?;
                        self.rows_along(&path, &end, s).map(DVector::from_vec)
                    });
                    out.set_column(one.to, &((some? - none?) / by));
                } else if experiment.is_moved_by(lane) {
                    moving.push(*one);
                } else if experiment.is_read_by(lane) {
                    read.push(*one);
                }
            }
        }
        let times = Times::of(blocks);
        let mut write = |group: &[Wanted], slopes: &[f64]| {
            for (k, (block, place)) in blocks.iter().zip(&times.places).enumerate() {
                let scale = self.scale(s, block);
                let first = match self.sensor(s, block) {
                    Sensor::Gyroscope => 0,
                    Sensor::Accelerometer => 3,
                };
                for axis in 0..3 {
                    let row = &slopes[(6 * place + first + axis) * group.len()..][..group.len()];
                    let cells = group.iter().zip(row);
                    cells
                        .for_each(|(one, slope)| out[(3 * k + axis, one.to)] = scale[axis] * slope);
                }
            }
        };
        for group in moving.chunks(LANES) {
            let experiment = self.differentiated(point, s, group)?;
            let slopes = |fineness| experiment.slopes(group.len(), fineness, &times.t_s);
            write(group, &run(&slopes)?);
        }
        if read.is_empty() {
            return Ok(());
        }
        let own;
        let path = match path {
            Some(path) => path,
            None => {
                own = self.path_of_slopes(point, s)?;
                &own
            }
        };
        for group in read.chunks(LANES) {
            let experiment = self.differentiated(point, s, group)?;
            write(
                group,
                &experiment.slopes_along(path, group.len(), &times.t_s)?,
            );
        }
        Ok(())
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
}

/// Derivatives of the readings, computed so finely.
type Slopes<'a> = dyn Fn(Fineness) -> Result<Vec<f64>> + 'a;
/// How finely they are.
type Run<'a> = dyn Fn(&Slopes) -> Result<Vec<f64>> + 'a;

/// One of the numbers that are fitted.
#[derive(Clone, Copy)]
pub struct Wanted {
    /// Its column in the derivatives of the model.
    pub column: usize,
    /// The column that its derivatives go to.
    pub to: usize,
}

impl Wanted {
    fn same(column: usize) -> Self {
        Self { column, to: column }
    }
}

/// Mean times of blocks; those of sensors that are read at once stand there once.
struct Times {
    t_s: Vec<f64>,
    /// Of each block.
    places: Vec<usize>,
}

impl Times {
    fn of(blocks: &[Block]) -> Self {
        let streams = blocks.iter().map(|b| b.stream + 1).max().unwrap_or(0);
        let of_stream = |stream: usize| {
            let its = blocks.iter().filter(move |b| b.stream == stream);
            its.map(|b| b.t_s).collect::<Vec<f64>>()
        };
        let lists: Vec<Vec<f64>> = (0..streams).map(of_stream).collect();
        let mut t_s: Vec<f64> = vec![];
        let mut places = vec![];
        let mut firsts: Vec<usize> = vec![];
        for (n, list) in lists.iter().enumerate() {
            let known = lists[..n].iter().position(|other| other == list);
            firsts.push(known.map_or(t_s.len(), |k| firsts[k]));
            if known.is_none() {
                t_s.extend(list);
            }
            places.extend((0..list.len()).map(|k| firsts[n] + k));
        }
        Self { t_s, places }
    }
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

#[cfg(test)]
mod tests {
    use std::path::Path as FilePath;

    use gyradius_identification::measure::prepare;
    use gyradius_recording::load_session;

    use super::super::base::by_periods;
    use super::super::cause_id::CauseId;
    use super::super::causes::{
        Scales, TERMS, catalogue, knock_at, learned_force, line_slip_at, mounts, ringing, slip_at,
    };
    use super::super::fitted_swing::Base;
    use super::super::point::{BIAS, Cause, DAMPING};
    use super::*;

    const UNTIL_S: f64 = 10.0;

    /// Steps of differences by each column, small against what shows of it.
    fn steps(model: &Model, point: &Point) -> Vec<f64> {
        let layout = model.base.layout();
        let of_session = model.base.free.iter().map(|i| layout.parameters[*i].step);
        let of_phone = [1e-4, 1e-4, 1e-4, 1e-5, 1e-5, 1e-5];
        let swings = model.base.swings.len();
        let of_causes = model.causes.iter().flat_map(|cause| {
            let all = cause.expanded(swings).into_iter();
            all.map(|(p, _)| 1e-3 * p.prior.1).collect::<Vec<_>>()
        });
        let of_own = (0..OWN).map(|k| {
            if (DAMPING..BIAS).contains(&k) {
                1e-4
            } else if k < BIAS {
                1e-5
            } else {
                1e-3
            }
        });
        let all: Vec<f64> = (of_session.chain(of_phone).chain(of_causes).chain(of_own)).collect();
        assert_eq!(
            all.len(),
            Places::of(model).free + 6 + Places::of(model).causes + OWN
        );
        assert_eq!(point.causes.len(), model.causes.len());
        all
    }

    fn stepped(model: &Model, point: &Point, s: usize, column: usize, by: f64) -> Point {
        let places = Places::of(model);
        let (first, own) = (places.free + 6, places.free + 6 + places.causes);
        let mut there = point.clone();
        if column < places.free {
            there.x[model.base.free[column]] += by;
        } else if column < first {
            let k = column - places.free;
            let along = |from: usize| Vec3::from_fn(|i, _| if from + i == k { by } else { 0.0 });
            let mount = &mut there.mounts[model.swing(s).mount];
            *mount = mount.moved(along(0), along(3));
        } else if column < own {
            let all = there.causes.iter_mut().flatten();
            *all.into_iter().nth(column - first).unwrap() += by;
        } else {
            there.owns[s][column - own] += by;
        }
        there
    }

    /// The largest difference of a swing's derivatives from central differences of its readings, as
    /// a part of the largest derivative by the same number.
    fn worst(model: &Model, point: &Point, s: usize) -> (f64, usize) {
        let jacobian = model.jacobian(point, s).unwrap();
        let off = |(column, step): (usize, f64)| {
            let read = |by: f64| {
                let there = stepped(model, point, s, column, by);
                model.read_rows(&there, s).unwrap()
            };
            let (up, down) = (read(step), read(-step));
            let largest = jacobian.column(column).amax();
            let differences = up
                .iter()
                .zip(&down)
                .map(|(up, down)| (up - down) / (2.0 * step));
            let found = jacobian.column(column);
            let away = differences.zip(found.iter()).map(|(a, b)| (a - b).abs());
            let away = away.fold(0.0, f64::max);
            // What does not show at all differs by rounding.
            (away / largest.max(1e-6 / step), column)
        };
        let all = steps(model, point).into_iter().enumerate().map(off);
        all.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
    }

    /// Where a cause shows: its strengths a third of what is expected of it, everything else off
    /// its middle.
    fn shown(cause: &Cause, swings: usize) -> Vec<f64> {
        let all = cause.expanded(swings).into_iter().zip(cause.limits(swings));
        all.enumerate()
            .map(|(k, ((p, _), (low, high)))| {
                let share = 0.3 - 0.02 * k as f64;
                let value = (p.prior.0 + share * p.prior.1).clamp(low, high);
                value.max(if p.stiff_below > 0.0 {
                    1.5 * p.stiff_below
                } else {
                    value
                })
            })
            .collect()
    }

    /// Derivatives by everything that is fitted, with each cause in turn, against central
    /// differences of the readings.
    #[test]
    fn derivatives_are_those_of_the_readings() {
        let folder = FilePath::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../../python/gyradius/sessions/boat-park");
        let mut loaded = load_session(folder.as_path()).unwrap();
        loaded.session.swings.truncate(2);
        loaded.data.truncate(2);
        let mut prepared = prepare(&loaded).unwrap();
        let x = by_periods(&mut prepared);
        let (system, works) = (&prepared.system, &prepared.works);
        let (base, start) = Base::begin(system, works, &prepared.inclines, &x)
            .unwrap()
            .unwrap();
        let model = Model {
            part: Part::First(UNTIL_S),
            ..Model::of(&base).precise()
        };
        let scales = Scales::of(&base, &start).unwrap();
        let mut causes = [catalogue(&scales), mounts(), ringing(&scales, &[0.9])].concat();
        causes.extend((0..4).map(|coordinate| learned_force(&scales, coordinate, &TERMS)));
        causes.extend([
            knock_at(&scales, 0, 4.0),
            line_slip_at(&scales, 0, 4.0),
            slip_at(0, 4.0),
        ]);
        for s in 0..2 {
            let (off, column) = worst(&model, &start, s);
            assert!(off < 1e-3, "base, swing {s}, column {column}: {off}");
        }
        // Dry friction turns its sign within less than a step of a fit: neither derivatives nor
        // differences of such motions are exact (those in short steps are: `gyradius-mechanics`).
        let all = causes.iter();
        for cause in all.filter(|cause| cause.id != CauseId::BearingFriction) {
            let with = model.with(cause).whole();
            let mut point = start.clone();
            point.causes.push(shown(cause, 2));
            let most = match cause.id {
                // Where the bearing gives way its force has a kink.
                CauseId::PreslidingBearing => 0.05,
                // What heaves by itself runs out of phase between the differences.
                CauseId::LineStretch => 0.02,
                // Where a rate changes its sign the law has no third derivative.
                CauseId::PowerLawDamping | CauseId::QuadraticDrag => 0.03,
                // The grid on which the mount is followed goes with its frequency.
                CauseId::PhoneMountResonance => 0.1,
                _ => 1e-3,
            };
            for s in 0..2 {
                let (off, column) = worst(&with, &point, s);
                let (id, form) = (cause.id, cause.form);
                assert!(
                    off < most,
                    "{id} {form:?}, swing {s}, column {column}: {off}"
                );
            }
        }
    }
}
