//! A swing with the phone that records it: what is simulated, as one list of named numbers.

use super::effects::EffectValues;
use super::numbers::{Number, Numbers};
use super::path::{Fineness, Moment, Path};
use super::phone::{Mounted, Phone, Reading};
use super::real::{Dual, Real, V3};
use super::scene::{LANES, Scene, effect_names, seeded};
use super::sensors::{OwnMotion, Ride, Sensor, SensorEffect, build};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Rotation;

/// A scene and the phone on its hull.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment<S = f64> {
    /// Body, rig, start and effects.
    pub scene: Scene<S>,
    /// Nominal `hull_from_phone`, on top of which the phone's turn comes.
    pub hull_from_phone: Rotation,
    /// The phone.
    pub phone: Phone<S>,
    /// What its sensors do to what they feel.
    pub sensors: Vec<EffectValues<S>>,
    /// So long the hull is held at its start before it is let go, s.
    pub held_s: f64,
}

/// Standard normal numbers for each effect of the sensors, so many for each sample as it takes,
/// sample after sample. Without any, the sensors are what they are on average.
pub type Draws = Vec<Vec<f64>>;

/// The motion and what the phone says of it. Lost samples are left out.
#[derive(Debug, Clone)]
pub struct Record {
    /// The motion from the release on.
    pub path: Path<f64>,
    /// Time stamps, s.
    pub t_s: Vec<f64>,
    /// Where the hull was at each reading.
    pub moments: Vec<Moment<f64>>,
    /// What the phone said.
    pub readings: Vec<Reading<f64>>,
}

/// What the phone makes of a motion.
struct Sampled<S: Real> {
    stamps_s: Vec<f64>,
    /// When it felt what it says, s.
    true_s: Vec<S>,
    readings: Vec<Reading<S>>,
}

type Laws<S> = Vec<Box<dyn SensorEffect<S>>>;

/// The hull's motion for a phone whose numbers are of a kind.
#[derive(Clone, Copy)]
enum Course<'a, S: Real> {
    /// Of the same kind.
    Alike(&'a Path<S>),
    /// Without derivatives.
    Plain(&'a Path<f64>),
}

impl<S: Real> Course<'_, S> {
    fn at(&self, t_s: S) -> Moment<S> {
        match self {
            Self::Alike(path) => path.at_time(t_s),
            Self::Plain(path) => path.as_seen_at(t_s),
        }
    }

    fn first_piece_s(&self) -> f64 {
        match self {
            Self::Alike(path) => path.first_piece_s(),
            Self::Plain(path) => path.first_piece_s(),
        }
    }

    fn duration_s(&self) -> f64 {
        match self {
            Self::Alike(path) => path.duration_s(),
            Self::Plain(path) => path.duration_s(),
        }
    }
}

/// A number with its derivatives by up to [`LANES`] parameters.
pub type Jet = Dual<LANES>;
/// Derivatives by no more parameters than these are computed over narrower numbers.
const NARROW: usize = 2;
const MIDDLE: usize = 6;

impl<S: Real> Experiment<S> {
    /// The same experiment over other numbers.
    fn map<T: Real>(&self, f: impl Fn(S) -> T + Copy) -> Experiment<T> {
        Experiment {
            scene: self.scene.map(f),
            hull_from_phone: self.hull_from_phone,
            phone: self.phone.map(f),
            sensors: self.sensors.iter().map(|e| e.map(f)).collect(),
            held_s: self.held_s,
        }
    }

    /// The same without derivatives.
    pub fn plain(&self) -> Experiment {
        self.map(S::value)
    }

    fn sensor_values(&self) -> impl Iterator<Item = S> {
        self.sensors.iter().flat_map(|e| e.values.iter().copied())
    }
}

/// An experiment whose numbers depend on parameters.
impl Experiment<Jet> {
    /// Whether the hull's motion depends on a parameter.
    pub fn is_moved_by(&self, parameter: usize) -> bool {
        let depends = |number: &Jet| number.slope[parameter] != 0.0;
        self.scene.values().iter().any(depends)
    }

    /// Whether what the phone reads of a motion depends on a parameter.
    pub fn is_read_by(&self, parameter: usize) -> bool {
        let depends = |number: &Jet| number.slope[parameter] != 0.0;
        self.phone.to_numbers().iter().any(depends)
            || self.sensors.iter().flat_map(|e| &e.values).any(depends)
    }

    /// Derivatives of the readings at these times by the first `count` parameters: for each time
    /// six rows (gyroscope x, y, z, specific force x, y, z), for each of them one figure by
    /// parameter.
    pub fn slopes(&self, count: usize, fineness: Fineness, t_s: &[f64]) -> Result<Vec<f64>> {
        self.by_width(count, Hull::Moves(fineness), t_s)
    }

    /// The same by parameters on which the hull's motion does not depend, along that motion.
    pub fn slopes_along(&self, path: &Path<f64>, count: usize, t_s: &[f64]) -> Result<Vec<f64>> {
        self.by_width(count, Hull::Known(path), t_s)
    }

    fn by_width(&self, count: usize, hull: Hull, t_s: &[f64]) -> Result<Vec<f64>> {
        if count <= NARROW {
            let narrow = self.map(Dual::narrowed::<NARROW>);
            narrow.all_slopes(count, hull, t_s)
        } else if count <= MIDDLE {
            let middle = self.map(Dual::narrowed::<MIDDLE>);
            middle.all_slopes(count, hull, t_s)
        } else {
            self.all_slopes(count, hull, t_s)
        }
    }
}

/// Where the motion of the hull comes from.
#[derive(Clone, Copy)]
enum Hull<'a> {
    /// It is computed, with its derivatives.
    Moves(Fineness),
    /// It is known, and has none.
    Known(&'a Path<f64>),
}

impl<const N: usize> Experiment<Dual<N>> {
    fn all_slopes(&self, count: usize, hull: Hull, t_s: &[f64]) -> Result<Vec<f64>> {
        let fineness = match hull {
            Hull::Known(path) => return self.slopes_on(Course::Plain(path), count, t_s),
            Hull::Moves(fineness) => fineness,
        };
        let plain = self.plain();
        let step_s = plain.scene.step_s(fineness.steps_per_period)?;
        let laws: Laws<f64> = plain.laws(&mut plain.sensor_values())?;
        let duration_s = plain.duration_s(&laws, t_s, &Draws::new(), step_s);
        let path = (plain.scene).run(self.scene.values(), duration_s, step_s, fineness)?;
        self.slopes_on(Course::Alike(&path), count, t_s)
    }

    fn slopes_on(&self, hull: Course<Dual<N>>, count: usize, t_s: &[f64]) -> Result<Vec<f64>> {
        let (cm_m, gravity_m_s2) = match hull {
            Course::Alike(path) => (path.cm_m, path.gravity_m_s2),
            Course::Plain(path) => {
                let cm_m = path.cm_m.map(Dual::constant);
                (cm_m, Dual::constant(path.gravity_m_s2))
            }
        };
        let laws = self.plain().laws(&mut self.sensor_values())?;
        let mounted = (self.phone).mounted(&self.hull_from_phone, &cm_m, gravity_m_s2);
        let readings = read(&laws, hull, self.held_s, &mounted, t_s)?;
        let rows = readings.iter().flat_map(Reading::six);
        Ok(rows
            .flat_map(|row| row.slope.into_iter().take(count))
            .collect())
    }
}

impl Experiment {
    /// Names and units of all its numbers: those of the scene, those of the phone as
    /// `phone.position_x_m`, those of the sensors' effects as the scene's.
    pub fn names(&self) -> Vec<(String, &'static str)> {
        let of_phone = <Phone as Numbers<f64>>::NUMBERS.iter();
        let mut names = self.scene.names();
        names.extend(of_phone.map(|n: &Number| (format!("phone.{}", n.name), n.unit)));
        names.extend(effect_names(&self.sensors));
        names
    }

    /// All its numbers, in the order of [`Experiment::names`].
    pub fn values(&self) -> Vec<f64> {
        let of_sensors = self.sensors.iter().flat_map(|e| e.values.clone()).collect();
        [self.scene.values(), self.phone.to_numbers(), of_sensors].concat()
    }

    /// The experiment with other numbers, in the order of [`Experiment::names`].
    pub fn with_values(&self, values: &[f64]) -> Result<Self> {
        let few = || too_few(values.len());
        let (of_scene, rest) = values
            .split_at_checked(self.scene.values().len())
            .ok_or_else(few)?;
        let mut rest = rest.iter().copied();
        let mut other = Self {
            scene: self.scene.with_values(of_scene)?,
            ..self.clone()
        };
        other.phone = Phone::from_numbers(&mut rest).ok_or_else(few)?;
        for value in other.sensors.iter_mut().flat_map(|e| &mut e.values) {
            *value = rest.next().ok_or_else(few)?;
        }
        Ok(other)
    }

    /// Place of a number in [`Experiment::names`].
    pub fn index(&self, name: &str) -> Result<usize> {
        let found = self.names().iter().position(|(n, _)| n == name);
        found.ok_or_else(|| Error::argument("number", "a number of the simulation", name))
    }

    /// How many standard normal numbers each effect of the sensors takes for a sample.
    pub fn draws_per_sample(&self) -> Result<Vec<usize>> {
        Ok(self
            .laws::<f64>(&mut self.sensor_values())?
            .iter()
            .map(|law| law.draws())
            .collect())
    }

    /// The record of samples taken at these times on the phone's clock, s.
    pub fn record(&self, t_s: &[f64], draws: &Draws) -> Result<Record> {
        let (path, sampled) = self.run(self.values(), Fineness::FULL, t_s, draws)?;
        let moments = sampled
            .true_s
            .iter()
            .map(|t_s| hull_at(Course::Alike(&path), self.held_s, *t_s))
            .collect();
        Ok(Record {
            path,
            t_s: sampled.stamps_s,
            moments,
            readings: sampled.readings,
        })
    }

    /// Derivatives of gyroscope x, y, z and specific force x, y, z by the numbers at `wanted`:
    /// those of each sample of [`Experiment::record`] after the other, in it those of each reading,
    /// in it one by each number.
    pub fn derivatives(&self, wanted: &[usize], t_s: &[f64], draws: &Draws) -> Result<Vec<f64>> {
        let count = self
            .kept(&self.laws(&mut self.sensor_values())?, t_s, draws)
            .len();
        let mut out = vec![0.0; count * 6 * wanted.len()];
        for (chunk, lanes) in wanted.chunks(LANES).enumerate() {
            let values: Vec<Dual<LANES>> = seeded(&self.values(), lanes)?;
            let (_, sampled) = self.run(values, self.fineness_of_derivatives(), t_s, draws)?;
            let readings = sampled.readings.iter().flat_map(Reading::six);
            for (cell, found) in out.chunks_exact_mut(wanted.len()).zip(readings) {
                cell[chunk * LANES..][..lanes.len()].copy_from_slice(&found.slope[..lanes.len()]);
            }
        }
        Ok(out)
    }

    /// The motion over the times asked for and a step beyond, for [`Experiment::readings_on`].
    pub fn motion(&self, fineness: Fineness, last_s: f64) -> Result<Path<f64>> {
        let step_s = self.scene.step_s(fineness.steps_per_period)?;
        let laws: Laws<f64> = self.laws(&mut self.sensor_values())?;
        let duration_s = self.duration_s(&laws, &[last_s], &Draws::new(), step_s);
        self.scene
            .run(self.scene.values(), duration_s, step_s, fineness)
    }

    /// So long the hull moves until the last of these times on the phone's clock, and a step
    /// beyond.
    fn duration_s<S: Real>(&self, laws: &Laws<S>, t_s: &[f64], draws: &Draws, step_s: f64) -> f64 {
        let drawn = Drawn::new(laws, draws);
        let true_s = t_s
            .iter()
            .enumerate()
            .map(|(n, t_s)| drawn.true_s(laws, n, *t_s).value());
        (true_s.fold(0.0, f64::max) + step_s - self.held_s).max(step_s)
    }

    /// What phone and sensors, without chance, make of a motion at these times: a reading for each,
    /// none is lost.
    pub fn readings_on(&self, path: &Path<f64>, t_s: &[f64]) -> Result<Vec<Reading<f64>>> {
        let laws = self.laws(&mut self.sensor_values())?;
        let mounted = self
            .phone
            .mounted(&self.hull_from_phone, &path.cm_m, path.gravity_m_s2);
        read(&laws, Course::Alike(path), self.held_s, &mounted, t_s)
    }

    /// The effects of the sensors differentiate the motion by time, or drive something with it:
    /// they need more than the derivatives themselves.
    fn fineness_of_derivatives(&self) -> Fineness {
        if self.scene.effects.iter().any(|effect| effect.kind.kinked) {
            Fineness::OF_KINKED_DERIVATIVES
        } else if self.sensors.is_empty() {
            Fineness::OF_DERIVATIVES
        } else {
            Fineness::FULL
        }
    }

    fn laws<S: Real>(&self, values: &mut dyn Iterator<Item = S>) -> Result<Laws<S>> {
        let law = |e: &EffectValues| {
            let law = build(e.kind.id, values).ok_or_else(|| too_few(0))?;
            law.check().map(|()| law)
        };
        self.sensors.iter().map(law).collect()
    }

    fn run<S: Real>(
        &self,
        mut values: Vec<S>,
        fineness: Fineness,
        t_s: &[f64],
        draws: &Draws,
    ) -> Result<(Path<S>, Sampled<S>)> {
        let mut rest = values.split_off(self.scene.values().len()).into_iter();
        let phone = Phone::from_numbers(&mut rest).ok_or_else(|| too_few(values.len()))?;
        let laws = self.laws(&mut rest)?;
        let step_s = self.scene.step_s(fineness.steps_per_period)?;
        let duration_s = self.duration_s(&laws, t_s, draws, step_s);
        let path = self.scene.run(values, duration_s, step_s, fineness)?;
        let mounted = phone.mounted(&self.hull_from_phone, &path.cm_m, path.gravity_m_s2);
        let sampled = {
            let hull = |t_s: S| hull_at(Course::Alike(&path), self.held_s, t_s);
            let ride = Ride {
                hull: &hull,
                mounted: &mounted,
                from_s: self.held_s,
                to_s: self.held_s + duration_s,
            };
            Sampler::new(&laws, &ride, draws)?.sample(&self.kept(&laws, t_s, draws))
        };
        Ok((path, sampled))
    }

    /// The samples that are not lost, with their places among all.
    fn kept<S: Real>(&self, laws: &Laws<S>, t_s: &[f64], draws: &Draws) -> Vec<(usize, f64)> {
        let drawn = Drawn::new(laws, draws);
        let lost = |&(n, t_s): &(usize, f64)| {
            laws.iter()
                .enumerate()
                .any(|(i, law)| law.loses(t_s, drawn.of(i, n)))
        };
        t_s.iter()
            .copied()
            .enumerate()
            .filter(|sample| !lost(sample))
            .collect()
    }
}

/// What phone and sensors, without chance, make of a motion at these times.
fn read<S: Real>(
    laws: &Laws<S>,
    course: Course<S>,
    held_s: f64,
    mounted: &Mounted<S>,
    t_s: &[f64],
) -> Result<Vec<Reading<S>>> {
    let hull = |t_s: S| hull_at(course, held_s, t_s);
    let ride = Ride {
        hull: &hull,
        mounted,
        from_s: held_s,
        to_s: held_s + course.duration_s(),
    };
    let all: Vec<(usize, f64)> = t_s.iter().copied().enumerate().collect();
    let none = Draws::new();
    Ok(Sampler::new(laws, &ride, &none)?.sample(&all).readings)
}

/// The hull at a time of the recording. Held, it stays where it starts; not held, it was moving
/// already: one piece of the path is continued backwards, and there it stays.
fn hull_at<S: Real>(course: Course<S>, held_s: f64, t_s: S) -> Moment<S> {
    let since_s = t_s - S::constant(held_s);
    if since_s.value() < 0.0 && held_s > 0.0 {
        course.at(S::zero()).stopped()
    } else if since_s.value() < -course.first_piece_s() {
        course.at(S::constant(-course.first_piece_s()))
    } else {
        course.at(since_s)
    }
}

fn too_few(count: usize) -> Error {
    Error::argument("values", "as many as the simulation has numbers", count)
}

/// The numbers drawn for each law and sample; zeros where none were handed in.
struct Drawn<'a> {
    draws: &'a Draws,
    per_sample: Vec<usize>,
    none: Vec<f64>,
}

impl<'a> Drawn<'a> {
    fn new<S: Real>(laws: &Laws<S>, draws: &'a Draws) -> Self {
        let per_sample: Vec<usize> = laws.iter().map(|law| law.draws()).collect();
        let none = vec![0.0; per_sample.iter().copied().max().unwrap_or(0)];
        Self {
            draws,
            per_sample,
            none,
        }
    }

    fn of(&self, law: usize, sample: usize) -> &[f64] {
        let count = self.per_sample[law];
        let drawn = self
            .draws
            .get(law)
            .and_then(|all| all.get(sample * count..(sample + 1) * count));
        drawn.unwrap_or(&self.none[..count])
    }

    /// When a sample was really taken.
    fn true_s<S: Real>(&self, laws: &Laws<S>, sample: usize, clock_s: f64) -> S {
        let mut true_s = S::constant(clock_s);
        laws.iter()
            .enumerate()
            .for_each(|(i, law)| law.bend(&mut true_s, self.of(i, sample)));
        true_s
    }
}

/// Reads the phone sample by sample.
struct Sampler<'a, S: Real> {
    laws: &'a Laws<S>,
    ride: &'a Ride<'a, S>,
    own_motions: Vec<OwnMotion<'a, S>>,
    /// What gyroscope and accelerometer remember.
    memories: [Vec<(S, f64)>; 2],
    drawn: Drawn<'a>,
}

impl<'a, S: Real> Sampler<'a, S> {
    fn new(laws: &'a Laws<S>, ride: &'a Ride<'a, S>, draws: &'a Draws) -> Result<Self> {
        let mut own_motions = Vec::new();
        for law in laws {
            own_motions.extend(law.own_motion(ride)?);
        }
        let memories =
            [Sensor::Gyroscope, Sensor::Accelerometer].map(|sensor| memory(laws, sensor));
        Ok(Self {
            laws,
            ride,
            own_motions,
            memories,
            drawn: Drawn::new(laws, draws),
        })
    }

    fn sample(&self, samples: &[(usize, f64)]) -> Sampled<S> {
        let mut states: Vec<Vec<S>> = self
            .laws
            .iter()
            .map(|law| vec![S::zero(); law.noise_states()])
            .collect();
        let mut sampled = Sampled {
            stamps_s: Vec::new(),
            true_s: Vec::new(),
            readings: Vec::new(),
        };
        let mut before_s = None;
        for &(n, clock_s) in samples {
            let mut stamp_s = clock_s;
            for (i, law) in self.laws.iter().enumerate() {
                stamp_s += law.stamp_error_s(self.drawn.of(i, n));
            }
            let true_s = self.drawn.true_s(self.laws, n, clock_s);
            let mut reading = self.remembered(true_s);
            let since_s = before_s.map(|before_s| clock_s - before_s);
            self.spoil((n, clock_s, since_s), &mut states, &mut reading);
            before_s = Some(clock_s);
            sampled.stamps_s.push(stamp_s);
            sampled.true_s.push(true_s);
            sampled.readings.push(reading);
        }
        sampled
    }

    /// Errors, noise and conversion, in this order.
    fn spoil(
        &self,
        (n, clock_s, since_s): (usize, f64, Option<f64>),
        states: &mut [Vec<S>],
        reading: &mut Reading<S>,
    ) {
        self.laws
            .iter()
            .for_each(|law| law.distort(S::constant(clock_s), reading));
        for (i, (law, states)) in self.laws.iter().zip(states).enumerate() {
            law.add_noise(since_s, self.drawn.of(i, n), states, reading);
        }
        self.laws.iter().for_each(|law| law.convert(reading));
    }

    /// What the sensors say of what they felt until now.
    fn remembered(&self, t_s: S) -> Reading<S> {
        let [gyro, acc] = &self.memories;
        let sum = |memory: &[(S, f64)]| {
            let mut sum = Reading {
                gyro: V3::zeros(),
                force: V3::zeros(),
            };
            for (ago_s, weight) in memory {
                let felt = self.felt(t_s - *ago_s);
                sum.gyro += felt.gyro.map(|x| x.scale(*weight));
                sum.force += felt.force.map(|x| x.scale(*weight));
            }
            sum
        };
        let heard = sum(gyro);
        if gyro == acc {
            heard
        } else {
            Reading {
                force: sum(acc).force,
                ..heard
            }
        }
    }

    fn felt(&self, t_s: S) -> Reading<S> {
        let moment = (self.ride.hull)(t_s);
        let mounted: &Mounted<S> = self.ride.mounted;
        if self.own_motions.is_empty() {
            return mounted.read(&moment);
        }
        let offsets: Vec<_> = self.own_motions.iter().map(|motion| motion(t_s)).collect();
        mounted.read_moving(&moment, &offsets)
    }
}

/// What a sensor remembers through one law after the other.
fn memory<S: Real>(laws: &Laws<S>, sensor: Sensor) -> Vec<(S, f64)> {
    let through = |before: Vec<(S, f64)>, more: Vec<(S, f64)>| {
        let later = |(ago_s, weight): (S, f64)| {
            more.iter()
                .map(|(more_s, share)| (ago_s + *more_s, weight * share))
                .collect::<Vec<_>>()
        };
        before.into_iter().flat_map(later).collect()
    };
    laws.iter()
        .map(|law| law.memory_of(sensor))
        .fold(vec![(S::zero(), 1.0)], through)
}
