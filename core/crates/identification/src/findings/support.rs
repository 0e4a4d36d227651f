//! What the swings of a session cannot tell, or tell with something else in it.

use std::collections::BTreeSet;

use gyradius_base::message::Argument;
use gyradius_recording::{
    LoadedData, LoadedSwing, ModeName, Orientation, Session, SuspensionKind, SwingData,
};

use super::{Finding, FindingKind as Kind, Severity};
use crate::estimate::{Observed, Solution, System};
use crate::measurement::Measurement;
use crate::modes::PhoneMotion;
use crate::names::QuantityName;
use crate::swing_work::SwingWork;

/// Yaw and the in-phase mode this near to each other act on each other (the paper saw it at 2 %,
/// Fig. 15).
pub const NEAR_IN_PHASE: f64 = 0.03;
/// A hanging tilted by less says nothing of roll by its yaw, degrees.
const LEAST_TILT_DEG: f64 = 5.0;
/// What a phone weighs, kg: most of 2015 to 2025 lie between 0.14 and 0.24.
const PHONE_KG: f64 = 0.2;
/// Heavier than a phone with its case and tape, kg.
const HEAVIER_THAN_PHONE_KG: f64 = 0.6;
/// Fewer rows in common are chance.
const LEAST_COMMON: usize = 64;
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
    let tilted = |i: usize| {
        let pitch = system.layout.swings[i].pitch_deg;
        system.layout.parameters[pitch].prior.value.abs() > LEAST_TILT_DEG
    };
    let beside = system
        .observations
        .iter()
        .any(|o| matches!(o.what, Observed::Incline(_) | Observed::Moved(_)));
    match name {
        QuantityName::KYaw => shown(&|_, mode| mode == Yaw),
        QuantityName::KPitch => shown(&|i, mode| {
            matches!(mode, PitchInPhase | PitchOutOfPhase)
                || (mode == Compound && about(i, Orientation::Athwartships))
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
pub fn unsupported(left_out: &[QuantityName]) -> Vec<Finding> {
    left_out
        .iter()
        .map(|name| {
            let key = match name {
                QuantityName::KYaw => "not_shown_yaw",
                QuantityName::KRoll => "not_shown_roll",
                _ => "not_shown_pitch",
            };
            let quantity = crate::sentences::name(&format!("quantity.{name}"));
            Finding::new(
                (Kind::NotIdentifiable, Severity::Refused),
                key,
                [("quantity", quantity)],
            )
            .of_channel(name.as_str())
        })
        .collect()
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

/// A phone recorded, and nothing as light as a phone is taken off the hull: what that does to the
/// yaw gyradius, the phone being where its accelerometer feels the yaw.
pub fn phone_mass(session: &Session, works: &[SwingWork], result: &Measurement) -> Option<Finding> {
    let is_phone =
        |swing: &gyradius_recording::Swing| matches!(swing.data, SwingData::Recording(_));
    let is_light = |a: &gyradius_recording::Attachment| a.mass_kg.value < HEAVIER_THAN_PHONE_KG;
    if !session.swings.iter().any(is_phone) || session.attachments.iter().any(is_light) {
        return None;
    }
    let mass_kg = session.body.mass_kg?.value;
    let yaw = result.quantities.get(&QuantityName::KYaw)?;
    let (k, u) = (yaw.value.scalar()?, yaw.u.scalar()?);
    let lever_m = works.iter().find_map(lever_m)?;
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

/// Distance of the phone from the axis of yaw, m: acceleration over angular acceleration.
fn lever_m(work: &SwingWork) -> Option<f64> {
    let evidence = work.evidence.as_ref()?;
    let up = evidence.up?;
    let is_yaw = |m: &crate::modes::NamedMode| m.name == ModeName::Yaw;
    let mode = evidence.named.iter().position(is_yaw)?;
    let gravity = gyradius_base::constants::STANDARD_GRAVITY_M_S2;
    let motion = PhoneMotion::of(&evidence.found.modes[mode], evidence.map, gravity, Some(up));
    let (turn, _) = motion.rotation_split(&up)?;
    let (_, push) = motion.acceleration_split(&up)?;
    let lever = push / (turn * motion.omega_rad_s.powi(2));
    lever.is_finite().then_some(lever)
}

/// Swings whose samples are those of another: a file that was imported twice, or two loggers that
/// read one sensor, say nothing twice. The place of each that repeats an earlier one, and a finding.
pub fn duplicates(session: &Session, data: &[LoadedSwing]) -> Vec<(usize, Finding)> {
    let rows: Vec<BTreeSet<[u64; 3]>> = data.iter().map(rows_of).collect();
    let repeats = |j: usize| {
        (0..j).find(|&i| {
            let common = rows[i].intersection(&rows[j]).count();
            common > LEAST_COMMON && 10 * common > 9 * rows[i].len().min(rows[j].len())
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

/// Different rows of the gyroscope, or of the accelerometer where there is none.
fn rows_of(swing: &LoadedSwing) -> BTreeSet<[u64; 3]> {
    let LoadedData::Recording(recording) = &swing.data else {
        return BTreeSet::new();
    };
    if let Some(channel) = &recording.single {
        let rows = channel.t_s.iter().zip(&channel.values);
        return rows.map(|(t, v)| [t.to_bits(), v.to_bits(), 0]).collect();
    }
    let triad = recording
        .gyroscope
        .as_ref()
        .or(recording.accelerometer.as_ref());
    let [x, y, z] = triad.map_or([&[][..]; 3], |triad| {
        triad.axes.each_ref().map(Vec::as_slice)
    });
    x.iter()
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| [x, y, z].map(|value| value.to_bits()))
        .collect()
}
