//! What the swings of a session cannot tell, or tell with something else in it.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::message::Argument;
use gyradius_recording::{
    Attachment, LoadedData, LoadedSwing, ModeName, Orientation, Quantity, Session, SuspensionKind,
    Swing, SwingData,
};
use num_complex::Complex64;

use super::{Finding, FindingKind as Kind, Severity};
use crate::estimate::{Observed, Solution, System};
use crate::measurement::Measurement;
use crate::modes::in_phase;
use crate::names::QuantityName;
use crate::observe::Evidence;
use crate::one_motion::OneMotion;
use crate::swing_work::SwingWork;

/// Yaw and the in-phase mode this near to each other act on each other (the paper saw it at 2 %,
/// Fig. 15).
pub const NEAR_IN_PHASE: f64 = 0.03;
/// A hanging tilted by less says nothing of roll by its yaw, degrees, nor one heeled by less of pitch.
const LEAST_TILT_DEG: f64 = 5.0;
/// What a phone weighs, kg: most of 2015 to 2025 lie between 0.14 and 0.24.
const PHONE_KG: f64 = 0.2;
/// Heavier than a phone with its case and tape, kg.
const HEAVIER_THAN_PHONE_KG: f64 = 0.6;
/// A phone's accelerometer lies anywhere in it: half its length, m.
const PHONE_REACH_M: f64 = 0.08;
/// Scales of phones' accelerometers by their data sheets: ±3 %.
const SENSOR_SCALE: f64 = 0.03;
/// So many samples tell whether the noise is the same.
const MOST_COMPARED: usize = 2000;
/// So many rows in a row are not alike by chance, where a sensor moves.
const RUN_OF_ROWS: usize = 8;
/// Fewer runs in common are chance.
const LEAST_COMMON: usize = 64;
/// Damped oscillations explain a record that they leave no more than this of, over its noise.
const EXPLAINED: f64 = 1.5;
/// More of the specific force along the axis of a turn than scale errors and misaligned axes of
/// phones make (some 2 %).
const ALONG_THE_AXIS: f64 = 0.1;
const MOSTLY_ALONG: f64 = 0.5;
/// Of the force that gravity would make of the turn's angle.
const LEAST_FORCE: f64 = 0.05;
/// Third differences of two records of one sensor: of white noise that is the same they correlate
/// fully, of another they do not; rounding takes some.
const SAME_NOISE: f64 = 0.7;
/// The same of the samples themselves: one motion.
const SAME_MOTION: f64 = 0.99;
/// A shift of less than this share of u is not worth a word.
const WORTH_A_WORD: f64 = 0.3;

/// Whether a swing, an incline or another hanging shows a quantity.
pub fn is_supported(system: &System, name: &QuantityName) -> bool {
    use ModeName::*;
    let swing = |i: usize| &system.session.swings[i].suspension;
    let shown = |is_it: &dyn Fn(usize, ModeName) -> bool| {
        system.periods.iter().any(|o| match o.what {
            Observed::Period(i, mode) => is_it(i, mode),
            _ => false,
        })
    };
    let about = |i: usize, way: Orientation| {
        swing(i).kind == SuspensionKind::Compound && swing(i).orientation == way
    };
    let is_large = |k: usize| system.layout.parameters[k].prior.value.abs() > LEAST_TILT_DEG;
    let tilted = |i: usize| is_large(system.layout.swings[i].pitch_deg);
    let heeled = |i: usize| system.layout.swings[i].roll_deg.is_some_and(is_large);
    let beside = system
        .observations
        .iter()
        .any(|o| matches!(o.what, Observed::Incline(_) | Observed::Moved(_)));
    match name {
        QuantityName::KYaw => shown(&|_, mode| mode == Yaw),
        QuantityName::KPitch => shown(&|i, mode| {
            matches!(mode, PitchInPhase | PitchOutOfPhase)
                || (mode == Compound && about(i, Orientation::Athwartships))
                || (mode == Yaw && heeled(i))
        }),
        QuantityName::KRoll => shown(&|i, mode| {
            matches!(mode, RollInPhase | RollOutOfPhase)
                || (mode == Compound && about(i, Orientation::ForeAndAft))
                || (mode == Yaw && tilted(i))
        }),
        QuantityName::CmDepth => beside || shown(&|_, mode| !matches!(mode, Yaw | Sway | Other)),
        _ => true,
    }
}

/// Quantities that were left out because no swing shows them.
pub fn unsupported(session: &Session, left_out: &[QuantityName]) -> Vec<Finding> {
    let shows = |name: &&QuantityName| !(is_unweighed(session) && **name == QuantityName::CmDepth);
    let told = left_out.iter().filter(shows).map(|name| {
        let key = match name {
            QuantityName::KYaw => "not_shown_yaw",
            QuantityName::KRoll => "not_shown_roll",
            _ => "not_shown_pitch",
        };
        not_shown(name, key)
    });
    told.collect()
}

/// An incline shows mass times depth.
fn is_unweighed(session: &Session) -> bool {
    !session.inclines.is_empty() && session.body.mass_kg.is_none()
}

/// Inclines of a hull whose mass nobody stated are not used.
pub fn incline_without_mass(session: &Session) -> Option<Finding> {
    let name = QuantityName::CmDepth;
    is_unweighed(session).then(|| not_shown(&name, "incline_without_mass"))
}

fn not_shown(name: &QuantityName, key: &str) -> Finding {
    let quantity = crate::sentences::name(&format!("quantity.{name}"));
    let what = (Kind::NotIdentifiable, Severity::Refused);
    Finding::new(what, key, [("quantity", quantity)]).of_channel(name.as_str())
}

/// A quantity that a swing shows and that is not stated all the same: how uncertain it would be; none
/// where what rides along leaves no body. Beyond all numbers the session says nothing of it.
pub fn undetermined(name: &QuantityName, figure: Option<Quantity>) -> Finding {
    let quantity = (
        "quantity",
        crate::sentences::name(&format!("quantity.{name}")),
    );
    let what = (Kind::NotIdentifiable, Severity::Refused);
    let found = match figure {
        None => Finding::new(what, "no_hull_left", [quantity]),
        Some(figure) if !figure.u.is_finite() => Finding::new(what, "says_nothing", [quantity]),
        Some(figure) => {
            let places = if *name == QuantityName::Psi { 1 } else { 3 };
            let arguments = [
                quantity,
                ("value", Argument::Number(figure.value, places)),
                ("u", Argument::Number(figure.u, places)),
            ];
            let what = (Kind::NotIdentifiable, Severity::Noted);
            let found = Finding::new(what, "undetermined", arguments);
            found.with("value", figure.value).with("u", figure.u)
        }
    };
    found.of_channel(name.as_str())
}

/// Swings on two lines in which damped oscillations explain what both sensors read, but no motion of
/// a body does: then the sensors do not belong together, or the hull does not hang as stated.
pub fn not_one_motion(session: &Session, works: &[SwingWork]) -> Vec<Finding> {
    let told = |(work, swing): (&SwingWork, &Swing)| {
        let evidence = work.evidence.as_ref()?;
        let is_explained = evidence.found.rms_over_noise < EXPLAINED;
        let is_bifilar = swing.suspension.kind == SuspensionKind::Bifilar;
        // The simulation has linear damping alone; where another law is known, that is why.
        let is_damped_otherwise = evidence
            .one_motion()
            .is_some_and(OneMotion::is_damped_otherwise);
        if work.result.simulated
            || is_damped_otherwise
            || work.periods.is_empty()
            || !(is_explained && is_bifilar && evidence.has_shapes())
        {
            return None;
        }
        let most = most_along_the_axis(evidence);
        let found = match most > ALONG_THE_AXIS {
            true => axes_disagree(Severity::Warned, most),
            false => {
                let what = (Kind::SensorsDisagree, Severity::Warned);
                Finding::new(what, "sensors_disagree", [])
            }
        };
        Some(found.of_swing(&swing.id))
    };
    works.iter().zip(&session.swings).filter_map(told).collect()
}

fn axes_disagree(severity: Severity, share: f64) -> Finding {
    let arguments = [("percent", Argument::Number(100.0 * share, 0))];
    let found = Finding::new(
        (Kind::SensorsDisagree, severity),
        "axes_disagree",
        arguments,
    );
    found.with("along_the_axis", share)
}

/// Where most of the force lies along the axis of a turn the axes are not those of one phone, and a
/// mode's shape says nothing of what it is.
pub fn of_axes(evidence: &Evidence) -> Option<Finding> {
    let most = most_along_the_axis(evidence);
    (most > MOSTLY_ALONG && !evidence.map.gravity_free)
        .then(|| axes_disagree(Severity::Refused, most))
}

fn most_along_the_axis(evidence: &Evidence) -> f64 {
    let named = evidence.named.iter().enumerate();
    let named = named.filter(|(_, named)| named.name != ModeName::Other);
    let shares = named.filter_map(|(mode, _)| along_the_axis(evidence, mode));
    shares.fold(0.0, f64::max)
}

/// Share of a mode's specific force that lies along the axis it turns about. A point of a body that
/// turns about an axis, and shifts across it, is accelerated across it, and so does gravity tilt.
fn along_the_axis(evidence: &Evidence, mode: usize) -> Option<f64> {
    let (first, second) = (evidence.map.gyroscope?, evidence.map.accelerometer?);
    let mode = &evidence.found.modes[mode];
    let part = |first: usize| {
        let each = [0, 1, 2].map(|k| mode.shape.get(first + k).copied().unwrap_or_default());
        let noise = (0..3)
            .filter_map(|k| evidence.found.noise.get(first + k))
            .sum::<f64>();
        (each, noise)
    };
    let ((turn, turn_noise), (force, force_noise)) = (part(first), part(second));
    let size = |v: &[Complex64; 3]| v.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt();
    // Out of the noise of single samples, which the fit of thousands lies far below; and more turn
    // than sway, which tilts the phone as it likes.
    let is_seen = size(&turn) > turn_noise && size(&force) > force_noise;
    let turns = size(&turn) * STANDARD_GRAVITY_M_S2 / mode.omega_rad_s > 0.3 * size(&force);
    if !(is_seen && turns) {
        return None;
    }
    // By the phase of the turn both are real but for the damping.
    let axis = in_phase(&turn.into());
    let length = axis.norm();
    let along: Complex64 = axis.iter().zip(&force).map(|(a, f)| f * *a).sum();
    // At the centre of oscillation there is no force of its own: any other would have a large share.
    let least = LEAST_FORCE * STANDARD_GRAVITY_M_S2 * size(&turn) / mode.omega_rad_s;
    let share = along.norm() / (length * size(&force).max(least));
    share.is_finite().then_some(share)
}

/// Yaw near the in-phase mode of the same hanging: as observed, or as the result predicts it where
/// it knows the pitch gyradius and the depth.
pub fn near_resonance(
    system: &System,
    solution: &Solution,
    works: &[SwingWork],
    result: &Measurement,
) -> Vec<Finding> {
    let known = [QuantityName::KPitch, QuantityName::CmDepth];
    let is_known = known
        .iter()
        .all(|name| result.quantities.contains_key(name));
    let near = |(i, work): (usize, &SwingWork)| {
        let modes = work.result.modes.iter();
        let seen: Vec<(ModeName, f64)> = modes.map(|m| (m.mode, m.period_s)).collect();
        let (swing, index) = (&system.session.swings[i], &system.layout.swings[i]);
        let predicted = || (system.theory)(&system.layout, &solution.x, swing, index).ok();
        let predicted = if is_known { predicted() } else { None };
        let period = |is_it: &dyn Fn(ModeName) -> bool, of: &[(ModeName, f64)]| {
            of.iter()
                .find(|(mode, _)| is_it(*mode))
                .map(|(_, period)| *period)
        };
        let yaw = period(&|m| m == ModeName::Yaw, &seen)?;
        let in_phase = |m| matches!(m, ModeName::PitchInPhase | ModeName::RollInPhase);
        let slow = period(&in_phase, &seen)
            .or_else(|| period(&in_phase, predicted.as_deref().unwrap_or_default()))?;
        let apart = yaw / slow - 1.0;
        (apart.abs() < NEAR_IN_PHASE).then(|| {
            Finding::new(
                (Kind::NearResonance, Severity::Warned),
                "near_resonance",
                [
                    ("yaw_s", Argument::Number(yaw, 3)),
                    ("slow_s", Argument::Number(slow, 3)),
                    ("percent", Argument::Number(100.0 * apart.abs(), 1)),
                ],
            )
            .of_swing(&work.result.id)
            .with("yaw_period_s", yaw)
            .with("in_phase_period_s", slow)
        })
    };
    works.iter().enumerate().filter_map(near).collect()
}

/// The phone's tilt against the pitch that is stated, degrees: one of them is wrong, and nothing
/// says which.
pub fn phone_moved(id: &str, stated_deg: f64, phone_deg: f64) -> Finding {
    let arguments = [
        ("stated_deg", Argument::Number(stated_deg, 1)),
        ("phone_deg", Argument::Number(phone_deg, 1)),
    ];
    Finding::new(
        (Kind::PhoneMoved, Severity::Widened),
        "phone_moved",
        arguments,
    )
    .of_swing(id)
    .with("stated_deg", stated_deg)
    .with("phone_deg", phone_deg)
}

/// The phone that recorded, against what is said to ride along: its mass is missing, or it lies
/// elsewhere than its accelerometer feels the yaw.
pub fn phone(session: &Session, works: &[SwingWork], result: &Measurement) -> Option<Finding> {
    let is_phone = |swing: &Swing| matches!(swing.data, SwingData::Recording(_));
    let is_light = |a: &&Attachment| a.mass_kg.value < HEAVIER_THAN_PHONE_KG;
    if !session.swings.iter().any(is_phone) {
        return None;
    }
    let light: Vec<&Attachment> = session.attachments.iter().filter(is_light).collect();
    match light.is_empty() {
        true => phone_mass(session, works, result),
        false => phone_place(session, &light, works, result),
    }
}

/// What the mass of a phone that is not taken off does to the yaw gyradius, the phone being where its
/// accelerometer feels the yaw.
fn phone_mass(session: &Session, works: &[SwingWork], result: &Measurement) -> Option<Finding> {
    let (k, u) = yaw_gyradius(result)?;
    let lever_m = works.iter().find_map(lever_m)?;
    let Some(mass_kg) = session.body.mass_kg else {
        let arguments = [
            ("mass_kg", Argument::Number(PHONE_KG, 1)),
            ("lever_m", Argument::Number(lever_m, 2)),
        ];
        let noted = (Kind::PhoneMassMissing, Severity::Noted);
        return Some(Finding::new(noted, "phone_mass_unknown", arguments).with("lever_m", lever_m));
    };
    let mass_kg = mass_kg.value;
    // Two bodies about their common centre; the phone's own gyradius is nothing beside it.
    let hull_kg = mass_kg - PHONE_KG;
    let moment = mass_kg * k * k - mass_kg / hull_kg * PHONE_KG * lever_m * lever_m;
    let without = (hull_kg > 0.0 && moment > 0.0).then(|| (moment / hull_kg).sqrt());
    let shift = without.map_or(k, |without| without - k);
    if shift.abs() < WORTH_A_WORD * u {
        return None;
    }
    let arguments = [
        ("mass_kg", Argument::Number(PHONE_KG, 1)),
        ("lever_m", Argument::Number(lever_m, 2)),
        ("shift_mm", Argument::Number(1e3 * shift, 1)),
        ("in_u", Argument::Number(shift.abs() / u, 1)),
    ];
    let finding = Finding::new(
        (Kind::PhoneMassMissing, Severity::Warned),
        "phone_mass",
        arguments,
    );
    Some(
        finding
            .with("phone_kg", PHONE_KG)
            .with("lever_m", lever_m)
            .with("k_yaw_shift_m", shift),
    )
}

/// Level yaw turns about the vertical through the middle of the suspension points: where none of the
/// light bodies that ride along lies as far from it as the phone feels it, the phone's place is
/// wrong, and the hull's inertia with it.
fn phone_place(
    session: &Session,
    light: &[&Attachment],
    works: &[SwingWork],
    result: &Measurement,
) -> Option<Finding> {
    let mass_kg = session.body.mass_kg?.value;
    let (k, u) = yaw_gyradius(result)?;
    let is_level = |swing: &Swing| {
        let angles = [
            swing.suspension.hull_pitch_deg,
            swing.suspension.hull_roll_deg,
        ];
        let mut stated = angles.into_iter().flatten();
        stated.all(|angle| angle.value.abs() < LEAST_TILT_DEG)
    };
    let level = works.iter().zip(&session.swings);
    let mut level = level.filter(|(_, swing)| is_level(swing));
    let lever_m = level.find_map(|(work, _)| lever_m(work))?;
    let from_axis_m = |one: &Attachment| one.position_m[0].hypot(one.position_m[1]);
    let apart = |one: &Attachment| from_axis_m(one) - lever_m;
    let nearest = light
        .iter()
        .min_by(|a, b| apart(a).abs().total_cmp(&apart(b).abs()))?;
    let stated_m = from_axis_m(nearest);
    // What is taken off at the one distance and lies at the other, about the common centre.
    let riding_kg: f64 = session.attachments.iter().map(|a| a.mass_kg.value).sum();
    let hull_kg = Some(mass_kg - riding_kg).filter(|kg| *kg > 0.0)?;
    let square = (stated_m * stated_m - lever_m * lever_m) * mass_kg / hull_kg;
    let moment = nearest.mass_kg.value * square;
    let is = (k * k + moment / hull_kg).max(0.0).sqrt();
    let shift = is - k;
    let within = PHONE_REACH_M.hypot(SENSOR_SCALE * lever_m);
    if (stated_m - lever_m).abs() < within || shift.abs() < WORTH_A_WORD * u {
        return None;
    }
    let arguments = [
        ("name", Argument::Plain(nearest.name.clone())),
        ("stated_m", Argument::Number(stated_m, 2)),
        ("lever_m", Argument::Number(lever_m, 2)),
        ("shift_mm", Argument::Number(1e3 * shift, 1)),
        ("in_u", Argument::Number(shift.abs() / u, 1)),
    ];
    let warned = (Kind::Contradiction, Severity::Warned);
    let found = Finding::new(warned, "phone_place", arguments).of_channel("attachment");
    let numbers = [
        ("stated_m", stated_m),
        ("lever_m", lever_m),
        ("k_yaw_shift_m", shift),
    ];
    Some(found.with_all(numbers))
}

fn yaw_gyradius(result: &Measurement) -> Option<(f64, f64)> {
    let yaw = result.quantities.get(&QuantityName::KYaw)?;
    Some((yaw.value.scalar()?, yaw.u.scalar()?))
}

/// Distance of the phone from the axis of yaw, m: acceleration over angular acceleration.
fn lever_m(work: &SwingWork) -> Option<f64> {
    let evidence = work.evidence.as_ref()?;
    let is_yaw = |m: &crate::modes::NamedMode| m.name == ModeName::Yaw;
    let mode = evidence.named.iter().position(is_yaw)?;
    let (up, motion) = evidence.phone_motion(mode)?;
    let (turn, _) = motion.rotation_split(&up)?;
    let (_, push) = motion.acceleration_split(&up)?;
    let lever = push / (turn * motion.omega_rad_s.powi(2));
    lever.is_finite().then_some(lever)
}

/// Swings whose samples are those of another: a file that was imported twice, or two loggers that
/// read one sensor, say nothing twice. The place of each that repeats an earlier one, and a finding.
pub fn duplicates(session: &Session, data: &[LoadedSwing]) -> Vec<(usize, Finding)> {
    let rows: Vec<BTreeSet<u64>> = data.iter().map(runs_of).collect();
    let noises: Vec<Option<Noise>> = data.iter().map(Noise::of).collect();
    let repeats = |j: usize| {
        (0..j).find(|&i| {
            let common = rows[i].intersection(&rows[j]).count();
            let is_same =
                common > LEAST_COMMON && 10 * common > 9 * rows[i].len().min(rows[j].len());
            let one_sensor = |(a, b): (&Noise, &Noise)| a.is_that_of(b);
            is_same
                || noises[i]
                    .as_ref()
                    .zip(noises[j].as_ref())
                    .is_some_and(one_sensor)
        })
    };
    let id = |i: usize| session.swings[i].id.clone();
    (0..data.len())
        .filter_map(|j| {
            let first = repeats(j)?;
            let finding = Finding::new(
                (Kind::DuplicateRecording, Severity::Refused),
                "duplicate",
                [("first", Argument::Id(id(first)))],
            );
            Some((j, finding.of_swing(&id(j))))
        })
        .collect()
}

/// The noise of a sensor by its third differences, which a swing of many samples a period hardly
/// has: two loggers that read one sensor have the same, whatever their clocks and digits.
struct Noise {
    differences: [Vec<f64>; 3],
    /// The samples about their means.
    samples: [Vec<f64>; 3],
}

impl Noise {
    fn of(swing: &LoadedSwing) -> Option<Self> {
        let LoadedData::Recording(recording) = &swing.data else {
            return None;
        };
        let triad = recording
            .gyroscope
            .as_ref()
            .or(recording.accelerometer.as_ref())?;
        let thirds = |axis: &Vec<f64>| -> Vec<f64> {
            let each = axis
                .windows(4)
                .map(|w| w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]);
            each.collect()
        };
        let about_mean = |axis: &Vec<f64>| -> Vec<f64> {
            let mean = axis.iter().sum::<f64>() / axis.len().max(1) as f64;
            axis.iter().map(|x| x - mean).collect()
        };
        let found = Self {
            differences: triad.axes.each_ref().map(thirds),
            samples: triad.axes.each_ref().map(about_mean),
        };
        (found.differences[0].len() > LEAST_COMMON && found.is_white()).then_some(found)
    }

    /// Third differences of white noise correlate by −3/4 with the next; those of a motion by +1.
    fn is_white(&self) -> bool {
        let (mut next, mut own) = (0.0, 0.0);
        for axis in &self.differences {
            next += axis.windows(2).map(|w| w[0] * w[1]).sum::<f64>();
            own += axis.iter().map(|x| x * x).sum::<f64>();
        }
        // A tone near half the sampling rate has −1.
        (-0.9 * own..-0.5 * own).contains(&next)
    }

    /// Whether noise and motion of both are the same at some lag of up to two hundred samples, in all
    /// axes together: a turned phone is another one.
    fn is_that_of(&self, other: &Self) -> bool {
        let shorter = self.differences[0].len().min(other.differences[0].len());
        let most = 200.min(shorter / 2) as isize;
        (-most..=most).any(|lag| {
            correlation(&self.differences, &other.differences, lag) > SAME_NOISE
                && correlation(&self.samples, &other.samples, lag) > SAME_MOTION
        })
    }
}

/// Correlation of two records in all axes together, the first `lag` samples later.
fn correlation(one: &[Vec<f64>; 3], other: &[Vec<f64>; 3], lag: isize) -> f64 {
    let (skip, from) = (lag.max(0) as usize, (-lag).max(0) as usize);
    let (mut both, mut own, mut others) = (0.0, 0.0, 0.0);
    for (a, b) in one.iter().zip(other) {
        for (x, y) in a[skip..].iter().zip(&b[from..]).take(MOST_COMPARED) {
            both += x * y;
            own += x * x;
            others += y * y;
        }
    }
    both / (own * others).sqrt().max(f64::MIN_POSITIVE)
}

/// Different runs of rows of the gyroscope, or of the accelerometer where there is none. Single rows
/// of a coarse sensor are alike by chance.
fn runs_of(swing: &LoadedSwing) -> BTreeSet<u64> {
    let LoadedData::Recording(recording) = &swing.data else {
        return BTreeSet::new();
    };
    let sensors = recording.sensors();
    let Some(first) = sensors.first() else {
        return BTreeSet::new();
    };
    let run = |from: usize| {
        let mut hasher = DefaultHasher::new();
        for (_, samples) in &first.channels {
            let values = samples[from..from + RUN_OF_ROWS].iter();
            values.for_each(|value| value.to_bits().hash(&mut hasher));
        }
        hasher.finish()
    };
    (0..(first.t_s.len() + 1).saturating_sub(RUN_OF_ROWS))
        .map(run)
        .collect()
}
