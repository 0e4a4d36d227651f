//! The swings of a session that a simulation can be fitted to, and where the fit begins.

use gyradius_base::error::Result;
use gyradius_base::frames::Rotation;
use gyradius_identification::Evidence;
use gyradius_identification::by_samples::nearest_fits;
use gyradius_identification::estimate::System;
use gyradius_identification::measure::{Prepared, SwingWork, estimate};
use gyradius_identification::parameters::Layout;
use gyradius_identification::samples::{Own, Samples, Sensor, SwingSetup, place};
use gyradius_identification::theory::{swing_periods, world_from_hull};
use gyradius_recording::Quantity;

use super::fitted_swing::{Base, FittedSwing, HORIZONS_S};
use super::fitting::Fitted;
use super::point::{BIAS, DAMPING, HEAVE_DAMPING, Model, Mount, OWN, Part, Point};
use super::white::levels;

/// Phones turned against each other by less than this may be one phone that slipped, rad; beyond,
/// it was taped anew.
const SAME_MOUNT_RAD: f64 = 0.25;
/// Standard uncertainties of the turn between two swings that may lie between them as well.
const SAME_MOUNT_U: f64 = 4.0;
/// Rate at which a motion dies away within some twenty seconds, 1/s: where a fit begins, none is
/// faster.
const MOST_DAMPING_PER_S: f64 = 0.1;
/// The roll gyradius stays within so many standard deviations of hulls' …
const ROLL_U: f64 = 3.0;
/// … and the product of inertia below this share of what no body can exceed.
const MOST_PRODUCT: f64 = 0.7;
/// Samples are averaged over a sixteenth of this or of the fastest period, s: what moves inside a
/// hull is followed up to some 2.5 Hz.
const FASTEST_PERIOD_S: f64 = 0.4;

impl<'a> Base<'a> {
    /// Limits, by place, of the roll gyradius and of the product of inertia, of which level swings
    /// say nearly nothing: a simulation that lacks something would bend them out of all shape.
    pub fn body_limits(&self, x: &[f64]) -> [(usize, (f64, f64)); 2] {
        let layout = self.layout();
        let [roll, _, yaw] = layout.log_gyradii;
        let prior = layout.parameters[roll].prior;
        let (low, high) = (
            prior.value - ROLL_U * prior.u,
            prior.value + ROLL_U * prior.u,
        );
        // I_xx/M and I_zz/M; their product is the square of the largest I_xz/M.
        let roll_share = x[roll].clamp(low, high);
        let (xx, zz) = ((2.0 * (roll_share + x[yaw])).exp(), (2.0 * x[yaw]).exp());
        let most = MOST_PRODUCT * (xx * zz).sqrt();
        [(roll, (low, high)), (layout.product_xz, (-most, most))]
    }

    /// Keeps a body within these.
    pub fn keep_a_body(&self, x: &mut [f64]) {
        for (place, (low, high)) in self.body_limits(x) {
            x[place] = x[place].clamp(low, high);
        }
    }

    /// Fits each swing by itself; what they agree on is where the fit of all begins. None where
    /// there is no swing on two lines, with gyroscope and accelerometer, that a simulation can be
    /// fitted to.
    pub fn begin(
        system: &'a System<'a>,
        works: &'a [SwingWork],
        inclines: &[Option<Quantity>],
        x: &[f64],
    ) -> Result<Option<(Self, Point)>> {
        let (session, layout) = (system.session, &system.layout);
        let mut begun: Vec<Begun> = Vec::new();
        let fits = nearest_fits(system, works, x, inclines);
        let said: Vec<_> = fits
            .iter()
            .map(|f| f.as_ref().map_or(vec![], |f| f.statements(false)))
            .collect();
        let agreed = system.agreed(&said, inclines);
        for (number, fit) in fits.into_iter().enumerate() {
            let (Some(fit), Some(evidence)) = (fit, works[number].evidence.as_ref()) else {
                continue;
            };
            let (model, fit) = fit.into_parts();
            let fastest_s = swing_periods(layout, &fit.x, model.setup.swing, model.setup.index)?
                .iter()
                .map(|(_, period_s)| *period_s)
                .fold(FASTEST_PERIOD_S, f64::min);
            let turn_u_rad = model.turn_u_rad(&fit);
            let tells_bow_from_stern = model.tells_bow_from_stern();
            let mut samples = Samples::of(evidence, fastest_s).unwrap_or(model.samples);
            keep_off_limits(&mut samples, evidence);
            let (x, own) = (fit.x, fit.own);
            begun.push(Begun {
                setup: model.setup,
                samples,
                number,
                evidence,
                x,
                own,
                turn_u_rad,
                tells_bow_from_stern,
            });
        }
        if begun.is_empty() {
            return Ok(None);
        }
        let median = median(layout, &begun);
        let mut sets: Vec<Vec<f64>> = agreed
            .into_iter()
            .chain([median.clone(), x.to_vec()])
            .collect();
        sets.extend(begun.iter().map(|b| b.x.clone()));
        let (mounts, which) = mounts(&mut begun, &median);
        let owns = begun.iter().map(|b| own_of(&b.own)).collect();
        let swings = begun
            .into_iter()
            .zip(which)
            .map(|(b, mount)| FittedSwing {
                setup: b.setup,
                samples: b.samples,
                mount,
                number: b.number,
                evidence: b.evidence,
            })
            .collect();
        let free = (0..layout.parameters.len())
            .filter(|i| layout.parameters[*i].is_free_in_motion())
            .collect();
        let base = Self {
            session,
            system,
            swings,
            mounts: mounts.len(),
            free,
        };
        let start = base.nearest(
            sets,
            Point {
                x: median,
                mounts,
                causes: vec![],
                owns,
            },
        );
        Ok(Some((base, start)))
    }

    /// Fits all swings together from a start, with the noise that they show.
    pub fn fit(&mut self, start: &Point) -> Result<Fitted> {
        let model = Model::of(self).precise();
        let fitted = model.fit_from_afar(start)?;
        let levels = levels(&model, &fitted.point)?;
        for (swing, levels) in self.swings.iter_mut().zip(levels) {
            for (stream, level) in swing.samples.streams.iter_mut().zip(levels) {
                stream.noise.component_mul_assign(&level);
            }
        }
        Model::of(self).precise().fit(&fitted.point, &|_| false)
    }

    /// A start with that set of the session's parameters which is nearest to the first seconds of
    /// the recordings. Swings that contradict each other agree on no body that there can be, or on
    /// one that cannot hang; from rest every body can.
    fn nearest(&self, sets: Vec<Vec<f64>>, start: Point) -> Point {
        let early = Model {
            part: Part::First(HORIZONS_S[0]),
            ..Model::of(self)
        };
        let cost = |point: &Point| early.chi2(point).unwrap_or(f64::INFINITY);
        let mut at_rest = start.clone();
        at_rest
            .owns
            .iter_mut()
            .for_each(|own| own[..BIAS].fill(0.0));
        let points = sets.into_iter().flat_map(|mut x| {
            self.keep_a_body(&mut x);
            [
                Point {
                    x: x.clone(),
                    ..start.clone()
                },
                Point {
                    x,
                    ..at_rest.clone()
                },
            ]
        });
        let costs = points.map(|point| (cost(&point), point));
        costs
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(start.clone(), |(_, point)| point)
    }
}

/// Samples at a sensor's limit were lost; those beside the gaps would be chosen by their noise. So
/// much is left out, s.
const BESIDE_LIMIT_S: f64 = 0.15;

/// Leaves out what lies beside gaps that a sensor's limit has torn.
fn keep_off_limits(samples: &mut Samples, evidence: &Evidence) {
    for stream in &mut samples.streams {
        let sensor = match stream.sensor {
            Sensor::Gyroscope => gyradius_recording::Sensor::Gyroscope,
            Sensor::Accelerometer => gyradius_recording::Sensor::Accelerometer,
        };
        if evidence.saturated.contains(&sensor) {
            stream.leave_out_beside_gaps(BESIDE_LIMIT_S);
        }
    }
}

struct Begun<'a> {
    setup: SwingSetup<'a>,
    samples: Samples,
    number: usize,
    evidence: &'a Evidence,
    x: Vec<f64>,
    own: Own,
    /// Of the phone's turn against the hull, by this swing alone.
    turn_u_rad: f64,
    tells_bow_from_stern: bool,
}

/// Parameters of the session from the fits of its swings: the median of each, so that one lost
/// swing does no harm.
fn median(layout: &Layout, begun: &[Begun]) -> Vec<f64> {
    let median = |i: usize| {
        let prior = layout.parameters[i].prior;
        // A swing that says nothing of a parameter leaves it at its prior.
        let mut moved: Vec<f64> = begun
            .iter()
            .map(|b| b.x[i])
            .filter(|x| *x != prior.value)
            .collect();
        moved.sort_by(f64::total_cmp);
        moved.get(moved.len() / 2).copied().unwrap_or(prior.value)
    };
    (0..layout.parameters.len()).map(median).collect()
}

fn own_of(own: &Own) -> [f64; OWN] {
    let mut values = [0.0; OWN];
    values[..HEAVE_DAMPING].copy_from_slice(&own.values[..HEAVE_DAMPING]);
    values[BIAS..].copy_from_slice(&own.values[place::BIAS]);
    // A single swing that lost its way may even gain energy: such a start runs away.
    values[place::DAMPING]
        .iter_mut()
        .for_each(|rate| *rate = rate.clamp(0.0, MOST_DAMPING_PER_S));
    // That of heave, which single swings are fitted without, begins as that of sway does.
    values[HEAVE_DAMPING] = values[DAMPING + 1];
    values
}

/// Poses of the phone in hull axes, those alike as one: that of the swing that knows it best. A
/// level hull looks the same from both ends: a swing seen from the other end is turned round.
fn mounts(begun: &mut [Begun], x: &[f64]) -> (Vec<Mount>, Vec<usize>) {
    let mut order: Vec<usize> = (0..begun.len()).collect();
    order.sort_by(|a, b| begun[*a].turn_u_rad.total_cmp(&begun[*b].turn_u_rad));
    let mut mounts: Vec<(Mount, f64)> = Vec::new();
    let mut which = vec![0; begun.len()];
    for i in order {
        let b = &mut begun[i];
        let hanging = world_from_hull(x, b.setup.index);
        let centre_m = b.setup.centre_m(x);
        let pose = |own: &Own| Mount {
            place: hanging.inverse() * (own.phone_m() - centre_m),
            hull_from_phone: renormalised(hanging.inverse() * own.nominal),
        };
        let ways = if b.tells_bow_from_stern {
            vec![b.own.clone()]
        } else {
            vec![b.own.clone(), b.own.turned_round()]
        };
        let nearest = |(mount, u): &(Mount, f64)| {
            let allowed = SAME_MOUNT_RAD.max(SAME_MOUNT_U * u.hypot(b.turn_u_rad));
            let away = ways.iter().map(|own| (mount.turned_from(&pose(own)), own));
            away.min_by(|a, b| a.0.total_cmp(&b.0))
                .filter(|(away, _)| *away < allowed)
                .map(|(_, own)| own.clone())
        };
        match mounts
            .iter()
            .enumerate()
            .find_map(|(k, known)| Some((k, nearest(known)?)))
        {
            Some((k, own)) => (which[i], b.own) = (k, own),
            None => {
                which[i] = mounts.len();
                mounts.push((pose(&b.own), b.turn_u_rad));
            }
        }
    }
    (mounts.into_iter().map(|(mount, _)| mount).collect(), which)
}

impl Mount {
    fn turned_from(&self, other: &Self) -> f64 {
        (self.hull_from_phone.inverse() * other.hull_from_phone).angle()
    }
}

fn renormalised(turn: Rotation) -> Rotation {
    Rotation::new_normalize(turn.into_inner())
}

/// Parameters by the periods alone, or as stated where those admit no solution.
pub fn by_periods(prepared: &mut Prepared) -> Vec<f64> {
    let session = prepared.system.session;
    let solved = estimate(
        &mut prepared.system,
        session,
        &mut prepared.works,
        &prepared.inclines,
    );
    solved.map_or_else(|_| prepared.system.layout.start(), |solution| solution.x)
}
