//! A point in the space of everything that is fitted, and the experiment that it describes.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, Matrix6};

use gyradius_base::error::Result;
use gyradius_base::frames::{Rotation, Vec3};
use gyradius_identification::samples::{place, turn_slopes};
use gyradius_identification::theory::{world_from_hull, world_from_hull_matrix};
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::sensors;
use gyradius_mechanics::{Experiment, Fineness, Jet, M3, Phone, Real, V3};

use super::cause_id::CauseId;
use super::fitted_swing::{Base, FittedSwing};
use super::fitting::Places;
use super::linear::Wanted;
use super::parameter_id::ParameterName;
use super::result::ParameterResult;
use super::unit::UnitName;

/// What belongs to one swing alone: its start (8), damping rates (6), biases of gyroscope and
/// accelerometer (6).
pub const OWN: usize = BIAS + place::BIAS.end - place::BIAS.start;
/// Where the damping rates begin.
pub const DAMPING: usize = place::DAMPING.start;
/// Damping rate of heave: what yaws wide on two lines rises and falls.
pub const HEAVE_DAMPING: usize = place::DAMPING.end;
/// Where the biases begin.
pub const BIAS: usize = HEAVE_DAMPING + 1;

/// Where a phone sits, hull axes.
#[derive(Debug, Clone)]
pub struct Mount {
    /// From the hull's centre of mass, m: the suspension points move along the deck where a hull
    /// hangs tilted.
    pub place: Vec3,
    pub hull_from_phone: Rotation,
}

impl Mount {
    /// Shifted, and turned in its own axes. Its place turns with it: swings in yaw do not tell
    /// where a phone's top points, and do tell how far it lies from the centre of mass, and along
    /// which of its axes.
    pub fn moved(&self, shift: Vec3, turn: Vec3) -> Self {
        let turned = self.hull_from_phone * Rotation::from_scaled_axis(turn);
        Self {
            place: turned * self.hull_from_phone.inverse() * self.place + shift,
            hull_from_phone: Rotation::new_normalize(turned.into_inner()),
        }
    }

    /// Moves on top of such a move by changes of its shift and its turn, to first order: the shift,
    /// then the turn, in the order of [`Self::moved`].
    pub fn moves(&self, shift: Vec3, turn: Vec3) -> Matrix6<f64> {
        let turned = self.moved(shift, turn).hull_from_phone.to_rotation_matrix();
        let by_turn = turn_slopes(turn);
        let mut moves = Matrix6::identity();
        moves
            .fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&(shift.cross_matrix() * turned.matrix() * by_turn));
        moves.fixed_view_mut::<3, 3>(3, 3).copy_from(&by_turn);
        moves
    }
}

/// Values of everything that is fitted.
#[derive(Debug, Clone)]
pub struct Point {
    /// The session's parameters, as in its layout.
    pub x: Vec<f64>,
    pub mounts: Vec<Mount>,
    /// Parameters of each cause: those of the session, then those of each swing.
    pub causes: Vec<Vec<f64>>,
    pub owns: Vec<[f64; OWN]>,
}

/// One parameter of a cause, in a unit in which everyday strengths are alike.
#[derive(Debug, Clone)]
pub struct CauseParameter {
    pub name: ParameterName,
    /// Unit of the rig, and how much of it is one of the parameter; logarithms are reported as what
    /// they are of.
    pub unit: UnitName,
    pub factor: f64,
    /// Where its zero is, in that unit: a time in the samples begins when they do.
    pub zero: f64,
    pub is_log: bool,
    /// Mean and standard deviation of its prior; the first look begins at the mean.
    pub prior: (f64, f64),
    /// Below this the motion is stiff: what the number does is told by the difference of this much
    /// from none. (What is fast there follows at once what is slow: no fit needs its phase.)
    pub stiff_below: f64,
    /// The effect is in proportion to it: the first look fits it. Others are held at the mean
    /// there.
    pub is_strength: bool,
    /// Each swing has its own.
    pub of_swing: bool,
    /// There is none below or above these.
    pub limits: (f64, f64),
}

impl CauseParameter {
    /// A value as it is told, in its unit.
    pub fn told(&self, value: f64) -> f64 {
        if self.is_log {
            value.exp()
        } else {
            value * self.factor + self.zero
        }
    }

    /// The same with its standard uncertainty.
    pub fn result(&self, value: f64, u: f64) -> ParameterResult {
        let told = self.told(value);
        let scale = if self.is_log { told } else { self.factor };
        ParameterResult {
            value: told,
            u: u * scale,
            unit: self.unit.into(),
        }
    }
}

/// Where any value has a meaning.
pub const NO_LIMITS: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Puts a cause of given parameters (the session's, then the swing's own) into the experiment of a
/// swing. The numbers carry their derivatives with them.
pub type Put = Arc<dyn Fn(&[Jet], usize, &mut Experiment<Jet>) -> Result<()> + Send + Sync>;

/// Something that the base simulation leaves out.
#[derive(Clone)]
pub struct Cause {
    /// Name in the contract.
    pub id: CauseId,
    pub parameters: Vec<CauseParameter>,
    pub put: Put,
    /// Whether its law has a kink.
    pub kinked: bool,
    /// Whether no other is looked at in the same simulation: it changes the motion even where a
    /// first look takes its derivatives, or makes it much longer to simulate.
    pub alone: bool,
    /// Whether derivatives by everything else are taken without it, since with it they take long
    /// and differ little.
    pub apart: bool,
    /// Strengths below zero have no physical meaning.
    pub one_sided: bool,
    /// Which of the shapes without a name it is, if one.
    pub form: Form,
    /// What a first look sees in its place, where its own parameters are no strengths.
    pub look: Option<Arc<LookAlike>>,
}

/// What a cause is beside its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A law with a name.
    Law,
    /// A learned force over a coordinate (see the effect `learned_force`).
    Force(usize),
    /// A knock in a swing.
    Knock(usize),
    /// A line that gives way in a swing.
    LineSlip(usize),
    /// A phone that slips in a swing.
    PhoneSlip(usize),
    /// Another thing that moves inside the hull, beside one that was taken before.
    Second,
    /// What a wind that was taken before does beside blowing steadily: part of that cause.
    Gust,
}

impl Form {
    /// The swing in which it happens, where it happens at a moment.
    pub fn swing(self) -> Option<usize> {
        match self {
            Form::Knock(swing) | Form::LineSlip(swing) | Form::PhoneSlip(swing) => Some(swing),
            _ => None,
        }
    }
}

/// A linear form of a cause: strengths without regard to how they hang together, and what comes
/// nearest to them of all that the cause can be; none where nothing does.
pub struct LookAlike {
    pub cause: Cause,
    pub nearest: FindNearest,
}

pub type FindNearest = Box<dyn Fn(&Seen) -> Option<Nearest> + Send + Sync>;

/// Strengths that a first look saw, with what the data say of them beside everything that is
/// fitted: information and score.
pub struct Seen {
    pub strengths: DVector<f64>,
    pub information: DMatrix<f64>,
    pub score: DVector<f64>,
}

impl Seen {
    /// How far to go along strengths, not backwards, and what that gains of the logarithm of the
    /// likelihood.
    pub fn along(&self, way: &DVector<f64>) -> (f64, f64) {
        let pull = self.score.dot(way).max(0.0);
        let amount = pull / way.dot(&(&self.information * way));
        (amount, 0.5 * pull * amount)
    }
}

/// What a cause can be that is nearest to strengths that were seen: its own strengths, and its
/// parameters (not a number: where they begin).
pub struct Nearest {
    pub strengths: DVector<f64>,
    pub parameters: Vec<f64>,
}

impl Cause {
    /// How many values its parameters have in a session of so many swings.
    pub fn size(&self, swings: usize) -> usize {
        self.parameters
            .iter()
            .map(|p| if p.of_swing { swings } else { 1 })
            .sum()
    }

    /// Its parameters value by value, each with the swing that it belongs to.
    pub fn expanded(&self, swings: usize) -> Vec<(&CauseParameter, Option<usize>)> {
        let of_session = self
            .parameters
            .iter()
            .filter(|p| !p.of_swing)
            .map(|p| (p, None));
        let of_swing = (0..swings).flat_map(|s| {
            self.parameters
                .iter()
                .filter(|p| p.of_swing)
                .map(move |p| (p, Some(s)))
        });
        of_session.chain(of_swing).collect()
    }

    /// Places of its strengths among its values in a session of so many swings.
    pub fn strengths(&self, swings: usize) -> Vec<usize> {
        let all = self.expanded(swings).into_iter().enumerate();
        all.filter(|(_, (p, _))| p.is_strength)
            .map(|(k, _)| k)
            .collect()
    }

    /// What a first look sees of it.
    pub fn as_seen(&self) -> &Self {
        self.look.as_ref().map_or(self, |alike| &alike.cause)
    }

    /// Limits of its parameters, value by value; those of strengths that cannot be below zero among
    /// them.
    pub fn limits(&self, swings: usize) -> Vec<(f64, f64)> {
        let above_zero = |p: &CauseParameter| self.one_sided && p.is_strength;
        let of = |p: &CauseParameter| {
            if above_zero(p) {
                (0.0, p.limits.1)
            } else {
                p.limits
            }
        };
        self.expanded(swings)
            .into_iter()
            .map(|(p, _)| of(p))
            .collect()
    }

    /// Where its priors have their mean.
    pub fn start(&self, swings: usize) -> Vec<f64> {
        self.expanded(swings)
            .iter()
            .map(|(p, _)| p.prior.0)
            .collect()
    }

    /// What concerns a swing.
    fn of_swing<T: Copy>(&self, values: &[T], swings: usize, swing: usize) -> Vec<T> {
        let expanded = self.expanded(swings);
        let concerns = |own: &Option<usize>| own.is_none_or(|s| s == swing);
        expanded
            .iter()
            .zip(values)
            .filter(|((_, own), _)| concerns(own))
            .map(|(_, v)| *v)
            .collect()
    }
}

/// The base simulation with causes in it.
#[derive(Clone)]
pub struct Model<'a> {
    pub base: &'a Base<'a>,
    pub causes: Vec<Cause>,
    /// Which stretches of the recordings count.
    pub part: Part,
    /// One of many that are fitted side by side.
    pub of_many: bool,
    /// Near the best fit: derivatives by causes are taken over short steps, and of motions as fine
    /// as those that are compared.
    pub fine: bool,
}

/// Which samples count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Part {
    All,
    Fitted,
    HeldOut,
    /// The first so many seconds.
    First(f64),
}

/// A recording is cut into so many stretches …
const STRETCHES: f64 = 12.0;
/// … of which the second of every three is held out.
const OUT_OF: usize = 3;
/// What fast parts of an effect were doing before the recording began is not known: so much is not
/// compared, s.
pub const SETTLING_S: f64 = 0.5;

/// Place of the first time that is compared.
pub fn first_settled(t_s: &[f64]) -> usize {
    t_s.partition_point(|t| *t < SETTLING_S)
}

impl Part {
    /// Whether a time of a record so long counts.
    pub fn has(self, t_s: f64, duration_s: f64) -> bool {
        let stretch = (STRETCHES * t_s / duration_s) as usize;
        let held_out = stretch % OUT_OF == 1;
        t_s >= SETTLING_S
            && match self {
                Part::All => true,
                Part::Fitted => !held_out,
                Part::HeldOut => held_out,
                Part::First(horizon_s) => t_s < horizon_s,
            }
    }
}

impl<'a> Model<'a> {
    /// The base simulation, for all of the recordings.
    pub fn of(base: &'a Base<'a>) -> Self {
        Self {
            base,
            causes: vec![],
            part: Part::All,
            of_many: false,
            fine: false,
        }
    }
}

impl Model<'_> {
    /// The same model, as it is fitted near its best.
    pub fn precise(&self) -> Self {
        Self {
            fine: true,
            ..self.clone()
        }
    }

    pub fn swing(&self, s: usize) -> &FittedSwing<'_> {
        &self.base.swings[s]
    }

    /// What the phone's clock shows of a true second in a swing.
    pub fn clock(&self, point: &Point, s: usize) -> Result<f64> {
        Ok(1.0 + self.experiment(point, s)?.sensors[0].values[0])
    }

    /// The causes that have a name of their own: gusts belong to their wind.
    pub fn named(&self) -> impl Iterator<Item = &Cause> {
        self.causes.iter().filter(|cause| cause.form != Form::Gust)
    }

    /// The same model with another cause.
    pub fn with(&self, cause: &Cause) -> Self {
        let mut model = self.clone();
        model.causes.push(cause.clone());
        model
    }

    /// The model and its point without those of the first so many causes that derivatives are taken
    /// apart from.
    pub fn reduced(&self, point: &Point, count: usize) -> (Self, Point) {
        self.only(point, |k, cause| k >= count || !cause.apart)
    }

    /// The model and its point with some of its causes, by their places and what they are.
    pub fn only(&self, point: &Point, stays: impl Fn(usize, &Cause) -> bool) -> (Self, Point) {
        let all = self.causes.iter().zip(&point.causes).enumerate();
        let some = all.filter(|(k, (cause, _))| stays(*k, cause));
        let (causes, values) = some
            .map(|(_, (cause, values))| (cause.clone(), values.clone()))
            .unzip();
        (
            Self {
                causes,
                ..self.clone()
            },
            Point {
                causes: values,
                ..point.clone()
            },
        )
    }

    /// The same model, its derivatives taken of all at once.
    pub fn whole(&self) -> Self {
        let mut model = self.clone();
        model
            .causes
            .iter_mut()
            .for_each(|cause| cause.apart = false);
        model
    }

    pub fn fineness(&self) -> Fineness {
        let kinked = self.causes.iter().any(|c| c.kinked);
        if kinked {
            Fineness::OF_KINKED_FITS
        } else {
            Fineness::OF_FITS
        }
    }

    /// The same for derivatives that lead on the way: those of smooth motions over longer steps. (A
    /// step over a kink differs more from its neighbours than a motion does from that of shorter
    /// steps.)
    pub fn fineness_of_slopes(&self) -> Fineness {
        let fineness = self.fineness();
        let is_smooth = fineness == Fineness::OF_FITS;
        if is_smooth && !self.fine {
            Fineness::OF_SLOPES_OF_FITS
        } else {
            fineness
        }
    }

    /// The experiment of a swing.
    pub fn experiment(&self, point: &Point, s: usize) -> Result<Experiment> {
        Ok(self.differentiated(point, s, &[])?.plain())
    }

    /// Where the motion is too stiff for the derivative by a cause's number: the points between
    /// which a difference tells what it does, and how far they are apart.
    pub fn across(&self, point: &Point, column: usize) -> Option<([Point; 2], f64)> {
        let mut first = Places::of(self).free + 6;
        for (c, cause) in self.causes.iter().enumerate() {
            let all = cause.expanded(self.base.swings.len());
            if let Some((parameter, _)) = column.checked_sub(first).and_then(|k| all.get(k)) {
                let at = |value: f64| {
                    let mut there = point.clone();
                    there.causes[c][column - first] = value;
                    there
                };
                let by = parameter.stiff_below;
                let is_stiff = by > 0.0 && point.causes[c][column - first] < by;
                return is_stiff.then(|| ([at(0.0), at(by)], by));
            }
            first += all.len();
        }
        None
    }

    /// The experiment of a swing with derivatives by some of what is fitted, at most as many as a
    /// [`Jet`] has.
    pub fn differentiated(
        &self,
        point: &Point,
        s: usize,
        wanted: &[Wanted],
    ) -> Result<Experiment<Jet>> {
        let with_lane = |value: f64, column: usize| {
            let lane = wanted.iter().position(|one| one.column == column);
            lane.map_or(Jet::constant(value), |lane| Jet::parameter(value, lane))
        };
        let places = Places::of(self);
        let (mut of_cause, first_own) = (places.free + 6, places.free + 6 + places.causes);
        let fitted_swing = self.swing(s);
        let mut x: Vec<Jet> = point.x.iter().map(|x| Jet::constant(*x)).collect();
        for (column, i) in self.base.free.iter().enumerate() {
            x[*i] = with_lane(point.x[*i], column);
        }
        let own = std::array::from_fn(|k| with_lane(point.owns[s][k], first_own + k));
        let moves = std::array::from_fn(|k| with_lane(0.0, places.free + k));
        let phone = self.phone(
            &point.mounts[fitted_swing.mount],
            &moves,
            (&x, &own),
            fitted_swing,
        );
        let hull_from_phone = self.hull_from_phone(point, s);
        let clock = self.base.layout().clock_error(&x, fitted_swing.setup.index);
        let mut experiment = Experiment {
            scene: fitted_swing.setup.scene_of(&x, &own[..BIAS])?,
            hull_from_phone,
            phone,
            // The clock comes first: `clock` and a cause of the catalogue rely on it.
            sensors: vec![sensor("clock_scale", &[("error", clock)])?],
            held_s: 0.0,
        };
        for (cause, values) in self.causes.iter().zip(&point.causes) {
            let values: Vec<Jet> = (values.iter().enumerate())
                .map(|(k, value)| with_lane(*value, of_cause + k))
                .collect();
            of_cause += values.len();
            let values = cause.of_swing(&values, self.base.swings.len(), s);
            (cause.put)(&values, s, &mut experiment)?;
        }
        Ok(experiment)
    }

    /// How the phone lies on the hanging hull.
    fn hull_from_phone(&self, point: &Point, s: usize) -> Rotation {
        let fitted_swing = self.swing(s);
        let hanging = world_from_hull(&point.x, fitted_swing.setup.index);
        let turn = hanging * point.mounts[fitted_swing.mount].hull_from_phone;
        Rotation::new_normalize(turn.into_inner())
    }

    /// The phone on the hanging hull, a small move of its mount on top of that.
    fn phone(
        &self,
        mount: &Mount,
        moves: &[Jet; 6],
        (x, own): (&[Jet], &[Jet; OWN]),
        fitted_swing: &FittedSwing,
    ) -> Phone<Jet> {
        let index = fitted_swing.setup.index;
        let hanging: M3<Jet> = world_from_hull_matrix(x, index);
        let level: M3<Jet> = hanging.map(|cell| Jet::constant(cell.value));
        let on_hull: M3<Jet> = matrix(&mount.hull_from_phone);
        let [shift, turn] = [0, 3].map(|k| V3::new(moves[k], moves[k + 1], moves[k + 2]));
        let place = mount.place.map(Jet::constant);
        // A turn in the phone's axes takes the place with it.
        let place = hanging * (place + shift + (on_hull * turn).cross(&place));
        // How the hull hangs turns the phone, too: in its axes.
        let hung = level.transpose() * hanging;
        let away = |i: usize, j: usize| (hung[(i, j)] - hung[(j, i)]) * 0.5;
        let hung = on_hull.transpose() * V3::new(away(2, 1), away(0, 2), away(1, 0));
        let turn = turn
            + hung.map(|angle| Jet {
                value: 0.0,
                ..angle
            });
        Phone {
            position_x_m: place.x,
            position_y_m: place.y,
            position_z_m: place.z - x[index.log_depth].exp(),
            turn_x_rad: turn.x,
            turn_y_rad: turn.y,
            turn_z_rad: turn.z,
            gyro_bias_x_rad_s: own[BIAS],
            gyro_bias_y_rad_s: own[BIAS + 1],
            gyro_bias_z_rad_s: own[BIAS + 2],
            acc_bias_x_m_s2: own[BIAS + 3],
            acc_bias_y_m_s2: own[BIAS + 4],
            acc_bias_z_m_s2: own[BIAS + 5],
        }
    }
}

fn matrix(turn: &Rotation) -> M3<Jet> {
    turn.to_rotation_matrix().matrix().map(Jet::constant)
}

/// A sensor's effect with the numbers given, the others zero.
pub fn sensor(id: &str, given: &[(&str, Jet)]) -> Result<EffectValues<Jet>> {
    EffectValues::of(&sensors::catalogue(), id, given)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of [`Mount::moved`].
    #[test]
    fn a_change_of_a_move_is_a_move_on_top_of_it() {
        let step = 1e-6;
        let mount = Mount {
            place: Vec3::new(0.6, -0.2, 0.1),
            hull_from_phone: Rotation::new(Vec3::new(1.2, -0.4, 2.0)),
        };
        let (shift, turn) = (Vec3::new(0.05, 0.2, -0.1), Vec3::new(0.4, -0.3, 0.7));
        let moves = mount.moves(shift, turn);
        let at = mount.moved(shift, turn);
        for k in 0..6 {
            let unit = |first: usize| Vec3::from_fn(|i, _| f64::from(first + i == k));
            let there = |by: f64| mount.moved(shift + unit(0) * by, turn + unit(3) * by);
            let (before, after) = (there(-step), there(step));
            let (moved, turned) = (
                moves.fixed_view::<3, 1>(0, k),
                moves.fixed_view::<3, 1>(3, k),
            );
            let on_top = |by: f64| at.moved(moved * by, turned * by);
            let (expected_before, expected_after) = (on_top(-step), on_top(step));
            let slope = |a: &Mount, b: &Mount| {
                let on_top = a.hull_from_phone.inverse() * b.hull_from_phone;
                (
                    (b.place - a.place) / (2.0 * step),
                    on_top.scaled_axis() / (2.0 * step),
                )
            };
            let (found, expected) = (
                slope(&expected_before, &expected_after),
                slope(&before, &after),
            );
            assert!((found.0 - expected.0).norm() < 1e-8, "{k}");
            assert!((found.1 - expected.1).norm() < 1e-8, "{k}");
        }
    }
}
