//! How far a simulated swing is from its samples, and what moves it nearer: the normal equations.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::nodes::nodes;
use super::record::{Samples, Sensor, Stream};
use super::scene::{BIAS, DRIFT, LANES, OWN, Own, PLACE, SHARED_LANES, SwingSetup, TURN};
use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_mechanics::{Dual, Fineness, Mounted, Path, Reading, Real};

/// Columns before they are combined: lanes, place, turn, the clock.
const RAW: usize = LANES.len() + 7;
const RAW_PLACE: usize = LANES.len();
const RAW_TURN: usize = RAW_PLACE + 3;
const RAW_CLOCK: usize = RAW_TURN + 3;
/// All raw columns with the biases and drifts of both sensors.
const COLUMNS: usize = RAW + 12;
/// Half the interval of the numerical derivative by time, s.
const TIME_STEP_S: f64 = 1e-4;

/// How the readings change with every number in play, about one point; good near it.
#[derive(Debug, Clone)]
pub struct Linearised {
    rows: Vec<BlockRows>,
    /// Raw columns by the session's free parameters, then the swing's own.
    combine: DMatrix<f64>,
    /// Of the normal equations: a step δ changes χ² by −2 gᵀδ + δᵀNδ.
    pub matrix: DMatrix<f64>,
}

/// One block's derivatives by axis.
#[derive(Debug, Clone)]
struct BlockRows {
    rows: [SVector<f64, COLUMNS>; 3],
    weight: Vec3,
}

/// A simulated swing read by its phone.
pub struct Simulated {
    path: Path<f64>,
    mounted: Mounted<f64>,
    own: Own,
    clock: f64,
    middle_s: f64,
}

impl Simulated {
    pub fn new(
        setup: &SwingSetup,
        x: &[f64],
        own: &Own,
        horizon_s: f64,
        whole_s: f64,
    ) -> Result<Self> {
        let own = own.clone().folded();
        let clock = setup.layout.clock_error(x, setup.index);
        let path = setup
            .scene(x, &own)?
            .motion_as(Fineness::OF_FITS, horizon_s / (1.0 + clock))?;
        let mounted = own
            .phone()
            .mounted(&own.nominal, &path.cm_m, path.gravity_m_s2);
        Ok(Self {
            path,
            mounted,
            own,
            clock,
            middle_s: 0.5 * whole_s,
        })
    }

    /// The reading at a time of the phone's clock.
    pub fn at(&self, sensor: Sensor, t_s: f64) -> Vec3 {
        self.moving(sensor, t_s) + self.level(sensor, t_s)
    }

    fn level(&self, sensor: Sensor, t_s: f64) -> Vec3 {
        let v = &self.own.values;
        let three = |i: usize| Vec3::new(v[i], v[i + 1], v[i + 2]);
        let offset = sensor_offset(sensor);
        three(BIAS + offset) + three(DRIFT + offset) * (t_s - self.middle_s)
    }

    fn moving(&self, sensor: Sensor, t_s: f64) -> Vec3 {
        let reading = self.felt(t_s);
        pick(sensor, reading.gyro, reading.force)
    }

    fn felt(&self, t_s: f64) -> Reading<f64> {
        self.mounted.read(&self.path.at(t_s / (1.0 + self.clock)))
    }

    /// Mean difference of samples and readings over each block up to `horizon_s`, stream by stream.
    pub fn misfits(&self, samples: &Samples, horizon_s: f64) -> Vec<Vec3> {
        let horizon_s = horizon_s.min(samples.duration_s);
        // Sensors that are read at once feel one motion.
        let mut felt: Vec<(f64, Reading<f64>)> = Vec::new();
        let mut all = Vec::new();
        for stream in &samples.streams {
            let mut places = 0..;
            for block in within(stream, horizon_s) {
                let values = &stream.values[block.clone()];
                let mut misfit = values.iter().sum::<Vec3>() / block.len() as f64;
                for ((t_s, share), place) in
                    (nodes(&stream.t_s[block.clone()]).into_iter()).zip(places.by_ref())
                {
                    let reading = match felt.get(place) {
                        Some((before_s, reading)) if *before_s == t_s => *reading,
                        _ => self.felt(t_s),
                    };
                    if place == felt.len() {
                        felt.push((t_s, reading));
                    }
                    let moving = pick(stream.sensor, reading.gyro, reading.force);
                    misfit -= (moving + self.level(stream.sensor, t_s)) * share;
                }
                all.push(misfit);
            }
        }
        all
    }
}

/// χ² of the mean differences over blocks up to `horizon_s`.
pub fn chi2(misfits: &[Vec3], samples: &Samples, horizon_s: f64) -> f64 {
    let horizon_s = horizon_s.min(samples.duration_s);
    let blocks = samples.streams.iter().flat_map(|stream| {
        let noise = stream.noise;
        within(stream, horizon_s).map(move |block| (block.len(), noise))
    });
    let each = misfits.iter().zip(blocks);
    each.map(|(misfit, (count, noise))| count as f64 * misfit.component_div(&noise).norm_squared())
        .sum()
}

/// How many readings blocks up to `horizon_s` hold.
pub fn readings(samples: &Samples, horizon_s: f64) -> usize {
    let of = |stream: &Stream| stream.axes() * within(stream, horizon_s).count();
    samples.streams.iter().map(of).sum()
}

/// The blocks that end before the horizon.
fn within(stream: &Stream, horizon_s: f64) -> impl Iterator<Item = &std::ops::Range<usize>> {
    stream
        .blocks
        .iter()
        .take_while(move |b| stream.t_s[b.end - 1] <= horizon_s)
}

fn sensor_offset(sensor: Sensor) -> usize {
    match sensor {
        Sensor::Gyroscope => 0,
        Sensor::Accelerometer => 3,
    }
}

fn pick<T>(sensor: Sensor, gyro: T, force: T) -> T {
    match sensor {
        Sensor::Gyroscope => gyro,
        Sensor::Accelerometer => force,
    }
}

impl Linearised {
    /// About `x` and `own`, whose turn is folded, up to `horizon_s`; `free` are the session's
    /// parameters in play.
    pub fn at(
        setup: &SwingSetup,
        (x, own): (&[f64], &Own),
        free: &[usize],
        samples: &Samples,
        horizon_s: f64,
    ) -> Result<Self> {
        let horizon_s = horizon_s.min(samples.duration_s);
        let scene = setup.scene(x, own)?;
        let simulated = Simulated::new(setup, x, own, horizon_s, samples.duration_s)?;
        let until_s = horizon_s / (1.0 + simulated.clock);
        let paths = scene.motion_and_derivatives(&LANES, Fineness::OF_FITS, until_s)?;
        let phone = own.phone().map(Dual::constant);
        let mounted: Vec<Mounted<Dual<{ gyradius_mechanics::LANES }>>> = paths
            .iter()
            .map(|p| phone.mounted(&own.nominal, &p.cm_m, p.gravity_m_s2))
            .collect();
        let mut all = Vec::new();
        let mut matrix = Box::new(SMatrix::<f64, COLUMNS, COLUMNS>::zeros());
        for stream in &samples.streams {
            for block in within(stream, horizon_s) {
                let count = block.len() as f64;
                let t_s = block.clone().map(|i| stream.t_s[i]).sum::<f64>() / count;
                let rows = rows(&simulated, &paths, &mounted, stream.sensor, t_s);
                let weight = stream.noise.map(|n| count / (n * n));
                for axis in 0..3 {
                    matrix.syger(weight[axis], &rows[axis], &rows[axis], 1.0);
                }
                all.push(BlockRows { rows, weight });
            }
        }
        matrix.fill_upper_triangle_with_lower_triangle();
        let combine = combination(setup, x, own, free, &scene)?;
        let matrix = DMatrix::from_column_slice(COLUMNS, COLUMNS, matrix.as_slice());
        let matrix = combine.transpose() * matrix * &combine;
        Ok(Self {
            rows: all,
            combine,
            matrix,
        })
    }

    /// The gradient g at a point nearby, from the misfits of all blocks there.
    pub fn gradient(&self, misfits: &[Vec3]) -> DVector<f64> {
        let mut gradient = DVector::zeros(COLUMNS);
        for (part, misfit) in self.rows.iter().zip(misfits) {
            for axis in 0..3 {
                gradient.axpy(part.weight[axis] * misfit[axis], &part.rows[axis], 1.0);
            }
        }
        self.combine.transpose() * gradient
    }
}

/// Derivatives of the three readings of a sensor by all raw columns.
fn rows(
    simulated: &Simulated,
    paths: &[Path<Dual<{ gyradius_mechanics::LANES }>>],
    mounted: &[Mounted<Dual<{ gyradius_mechanics::LANES }>>],
    sensor: Sensor,
    t_s: f64,
) -> [SVector<f64, COLUMNS>; 3] {
    let mut rows = [SVector::<f64, COLUMNS>::zeros(); 3];
    let true_s = t_s / (1.0 + simulated.clock);
    for (chunk, (path, phone)) in paths.iter().zip(mounted).enumerate() {
        let reading = phone.read(&path.at(true_s));
        let reading = pick(sensor, reading.gyro, reading.force);
        for axis in 0..3 {
            for (lane, slope) in reading[axis].slope.iter().enumerate() {
                rows[axis][chunk * gyradius_mechanics::LANES + lane] = *slope;
            }
        }
    }
    let here = simulated.moving(sensor, t_s);
    let moment = simulated.path.at(true_s);
    let phone_from_hull = simulated.own.nominal.inverse();
    let rate = (simulated.moving(sensor, t_s + TIME_STEP_S)
        - simulated.moving(sensor, t_s - TIME_STEP_S))
        / (2.0 * TIME_STEP_S);
    let offset = sensor_offset(sensor);
    for k in 0..3 {
        let unit = Vec3::ith(k, 1.0);
        // exp(turn)ᵀ u ≈ u − turn × u
        let by_turn = -unit.cross(&here);
        let by_place = match sensor {
            Sensor::Gyroscope => Vec3::zeros(),
            Sensor::Accelerometer => {
                let spin = moment.rate.cross(&moment.rate.cross(&unit));
                phone_from_hull * (moment.angular_acceleration.cross(&unit) + spin)
            }
        };
        for axis in 0..3 {
            rows[axis][RAW_PLACE + k] = by_place[axis];
            rows[axis][RAW_TURN + k] = by_turn[axis];
        }
        rows[k][RAW_CLOCK] = -rate[k] * true_s;
        rows[k][RAW + offset + k] = 1.0;
        rows[k][RAW + 6 + offset + k] = t_s - simulated.middle_s;
    }
    rows
}

/// Raw columns by the session's free parameters and the swing's own.
fn combination(
    setup: &SwingSetup,
    x: &[f64],
    own: &Own,
    free: &[usize],
    scene: &gyradius_mechanics::Scene,
) -> Result<DMatrix<f64>> {
    let mut combine = DMatrix::zeros(COLUMNS, free.len() + OWN);
    combine
        .view_mut((0, 0), (LANES.len(), free.len()))
        .copy_from(&setup.lane_slopes(x, own, free)?);
    let is_clock = |i: &usize| *i == setup.layout.clock || Some(*i) == setup.index.clock;
    for (column, _) in free.iter().enumerate().filter(|(_, i)| is_clock(i)) {
        combine[(RAW_CLOCK, column)] = 1.0;
    }
    let first = free.len();
    for k in 0..8 {
        combine[(SHARED_LANES + k, first + k)] = 1.0;
    }
    for (k, scale) in setup.damping_slopes(scene).into_iter().enumerate() {
        combine[(SHARED_LANES + 8 + k, first + 8 + k)] = scale;
    }
    for k in 0..6 {
        combine[(RAW_PLACE + k, first + PLACE + k)] = 1.0;
    }
    for k in 0..12 {
        combine[(RAW + k, first + BIAS + k)] = 1.0;
    }
    debug_assert_eq!((RAW_TURN - RAW_PLACE, TURN - PLACE), (3, 3));
    Ok(combine)
}
