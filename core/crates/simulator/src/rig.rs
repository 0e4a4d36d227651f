//! The text of a rig file read into the session that it states and the swings that are simulated.

use gyradius_base::error::{Error, Result};
use gyradius_mechanics::Experiment;
use gyradius_mechanics::effects::{self, EffectKind, EffectValues};
use gyradius_mechanics::sensors;
use gyradius_recording::{
    Domain, ROOT, SWING, Session, SwingData, Table, session, utf8, with_root,
};

use super::sampling::Sampling;
use super::truth::{Truth, experiment, keys};

/// Name and major version of the format.
pub const RIG_FORMAT: &str = "gyradius-rig/1";

/// A number without bounds of its own.
const ANY: Domain = Domain::between("a finite number", f64::MIN, f64::MAX);
/// More samples than these in one recording are a slip of the pen.
const MOST_SAMPLES: f64 = 5e6;

/// What a rig file says.
#[derive(Debug, Clone, PartialEq)]
pub struct RigFile {
    /// What is stated: the session that is handed over.
    pub session: Session,
    /// What is told of every swing.
    pub truth: Truth,
    /// What is true of each swing, in the order of the session.
    pub swings: Vec<RiggedSwing>,
    /// Effects that act in every swing.
    pub effects: Vec<EffectValues>,
}

/// A swing as it is simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct RiggedSwing {
    /// The swing's id.
    pub id: String,
    /// Its place among the swings.
    pub place: usize,
    /// Name of the recording in the session.
    pub file: String,
    /// Body, rig, start, effects and phone.
    pub experiment: Experiment,
    /// When the phone reads its sensors.
    pub sampling: Sampling,
    /// What is told of it.
    pub truth: Truth,
}

/// Reads the text of a rig file; `file_name` is what messages call it.
pub fn read_rig(text: &str, file_name: &str) -> Result<RigFile> {
    let known = [ROOT, &["truth", "effect"]].concat();
    with_root(text, file_name, &known, RIG_FORMAT, rig)
}

/// The same from the bytes of a file.
pub(crate) fn read_rig_bytes(bytes: &[u8], file_name: &str) -> Result<RigFile> {
    read_rig(utf8(bytes, file_name)?, file_name)
}

fn rig(root: &Table<'_>) -> Result<RigFile> {
    let of_swing = [SWING, &["truth"]].concat();
    let parsed = session(root, &of_swing)?.session;
    let everywhere = truth(root, &Truth::default())?;
    let ids: Vec<&str> = parsed
        .swings
        .iter()
        .map(|swing| swing.id.as_str())
        .collect();
    let effects = switched(root, &ids)?;
    let mut swings = Vec::new();
    for (table, swing) in root.open_tables("swing")?.iter().zip(&parsed.swings) {
        let truth = truth(table, &everywhere)?;
        let mine = effects
            .iter()
            .filter(|e| e.swing.as_ref().is_none_or(|id| *id == swing.id));
        let (of_sensors, of_hull) = mine.map(|e| e.values.clone()).partition(is_of_sensors);
        swings.push(rigged(
            table,
            &parsed,
            swings.len(),
            &truth,
            [of_hull, of_sensors],
        )?);
    }
    if swings.is_empty() {
        return Err(root.error("at least one [[swing]]", "none"));
    }
    let everywhere_too = effects.into_iter().filter(|effect| effect.swing.is_none());
    let effects = everywhere_too.map(|effect| effect.values).collect();
    Ok(RigFile {
        session: parsed,
        truth: everywhere,
        swings,
        effects,
    })
}

fn rigged(
    table: &Table<'_>,
    session: &Session,
    place: usize,
    truth: &Truth,
    effects: [Vec<EffectValues>; 2],
) -> Result<RiggedSwing> {
    let swing = &session.swings[place];
    let SwingData::Recording(file) = &swing.data else {
        return Err(table.error(
            format!("`{}`: only these are simulated", table.path_of("recording")),
            "another kind of data",
        ));
    };
    let at_table = |error: Error| match error {
        Error::Argument {
            expected,
            found,
            name,
        } => table.error(format!("`{name}`: {expected}"), found),
        other => other,
    };
    let experiment = experiment(session, swing, truth, effects).map_err(at_table)?;
    experiment.draws_per_sample().map_err(at_table)?;
    let sampling = truth.sampling();
    if sampling.duration_s * sampling.rate_hz > MOST_SAMPLES {
        return Err(table.error(
            format!("at most {MOST_SAMPLES} samples"),
            format!("{} s at {} Hz", sampling.duration_s, sampling.rate_hz),
        ));
    }
    Ok(RiggedSwing {
        id: swing.id.clone(),
        place,
        file: file.clone(),
        experiment,
        sampling,
        truth: truth.clone(),
    })
}

/// `[truth]` of a table, on top of what is true everywhere.
fn truth(table: &Table<'_>, everywhere: &Truth) -> Result<Truth> {
    let mut truth = everywhere.clone();
    let Some(field) = table.get("truth") else {
        return Ok(truth);
    };
    let keys = keys();
    for (key, value) in field.by_name(&keys)? {
        truth.set(key.name, value.number(key.domain)?);
    }
    Ok(truth)
}

/// An `[[effect]]`, for one swing or for all.
struct Switched {
    swing: Option<String>,
    values: EffectValues,
}

fn switched(root: &Table<'_>, swings: &[&str]) -> Result<Vec<Switched>> {
    let all = effects::catalogue().into_iter().chain(sensors::catalogue());
    let kinds: Vec<(&str, EffectKind)> = all.map(|kind| (kind.id, kind)).collect();
    root.open_tables("effect")?
        .iter()
        .map(|table| effect(table, &kinds, swings))
        .collect()
}

pub(super) fn is_of_sensors(effect: &EffectValues) -> bool {
    sensors::catalogue()
        .iter()
        .any(|kind| kind.id == effect.kind.id)
}

fn effect(table: &Table<'_>, kinds: &[(&str, EffectKind)], swings: &[&str]) -> Result<Switched> {
    let kind = table.require("id", "which effect")?.choice(kinds)?;
    let names: Vec<&str> = kind.numbers.iter().map(|n| n.name).collect();
    table.refuse_beside(&[&["id", "swing"], &*names].concat())?;
    let ids: Vec<(&str, usize)> = swings.iter().enumerate().map(|(i, id)| (*id, i)).collect();
    let swing = table
        .get("swing")
        .map(|field| field.choice(&ids))
        .transpose()?;
    let number = |name: &&str| Ok(table.number(name, ANY)?.unwrap_or(0.0));
    let values = EffectValues {
        kind,
        values: names.iter().map(number).collect::<Result<_>>()?,
    };
    Ok(Switched {
        swing: swing.map(|i| swings[i].to_owned()),
        values,
    })
}
