//! The job: a rig and a seed become a session folder, and beside it a file that says what is true.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::Serialize;

use gyradius_base::error::{Error, Result};
use gyradius_mechanics::Record;
use gyradius_recording::{
    Overwrite, Recording, Session, Triad, save_session_with, write_recording,
};

use super::rig::{RigFile, RiggedSwing};

/// Name and version of the truth file.
const TRUTH_FORMAT: &str = "gyradius-truth/1";
/// Figures are written to so many parts of s, rad/s and m/s²: finer than any phone's.
const WRITTEN: f64 = 1e9;

/// A session that was never swung.
#[derive(Debug, Clone, PartialEq)]
pub struct Practised {
    /// What is stated.
    pub session: Session,
    /// Recordings, by name and bytes.
    pub recordings: Vec<(String, Vec<u8>)>,
    /// What is true, as JSON.
    pub truth: String,
}

#[derive(Serialize, schemars::JsonSchema)]
struct TruthFile<'a> {
    format: &'static str,
    title: &'a str,
    seed: u64,
    truth: &'a BTreeMap<&'static str, f64>,
    swings: Vec<SwingTruth<'a>>,
}

#[derive(Serialize, schemars::JsonSchema)]
struct SwingTruth<'a> {
    id: &'a str,
    truth: &'a BTreeMap<&'static str, f64>,
    /// Every number of the simulation.
    numbers: BTreeMap<String, f64>,
    /// When a line went slack, s, if one did.
    slack_s: Option<f64>,
}

/// Simulates every swing of a rig. The same seed gives the same bytes.
pub fn practise(rig: &RigFile, seed: u64) -> Result<Practised> {
    let records = rig
        .swings
        .iter()
        .map(|swing| record(swing, seed))
        .collect::<Result<Vec<_>>>()?;
    let pairs = || rig.swings.iter().zip(&records);
    let truth = TruthFile {
        format: TRUTH_FORMAT,
        title: &rig.session.title,
        seed,
        truth: rig.truth.all(),
        swings: pairs()
            .map(|(swing, record)| swing_truth(swing, record))
            .collect(),
    };
    let truth = serde_json::to_string_pretty(&truth)
        .map_err(|e| Error::no_result("truth", e.to_string()))?;
    let file = |(swing, record): (&RiggedSwing, &Record)| {
        (
            swing.file.clone(),
            write_recording(&recording(&swing.file, record)),
        )
    };
    Ok(Practised {
        session: rig.session.clone(),
        recordings: pairs().map(file).collect(),
        truth: truth + "\n",
    })
}

fn record(swing: &RiggedSwing, seed: u64) -> Result<Record> {
    let t_s = swing.sampling.times_s();
    swing
        .experiment
        .record(&t_s, &swing.draws(Some(seed), t_s.len())?)
}

fn swing_truth<'a>(swing: &'a RiggedSwing, record: &Record) -> SwingTruth<'a> {
    let names = swing.experiment.names().into_iter().map(|(name, _)| name);
    SwingTruth {
        id: &swing.id,
        truth: swing.truth.all(),
        numbers: names.zip(swing.experiment.values()).collect(),
        slack_s: record.path.slack.map(|slack| slack.t_s),
    }
}

fn recording(name: &str, record: &Record) -> Recording {
    let short = |x: f64| (x * WRITTEN).round() / WRITTEN;
    let t_s: Vec<f64> = record.t_s.iter().map(|t| short(*t)).collect();
    let triad = |first: usize| Triad {
        t_s: t_s.clone(),
        axes: [0, 1, 2].map(|axis| {
            record
                .readings
                .iter()
                .map(|r| short(r.six()[first + axis]))
                .collect()
        }),
    };
    Recording {
        name: name.into(),
        gyroscope: Some(triad(0)),
        accelerometer: Some(triad(3)),
        ..Recording::default()
    }
}

/// Writes the session into a folder and the truth into a file outside of it: both or, where the
/// disk is full, neither.
pub fn save_practised(
    practised: &Practised,
    folder: impl AsRef<Path>,
    truth_file: impl AsRef<Path>,
    overwrite: Overwrite,
) -> Result<()> {
    let (folder, truth_file) = (folder.as_ref(), truth_file.as_ref());
    let refuse = |reason: &str| {
        Err(Error::Unwritable {
            file: truth_file.display().to_string(),
            reason: reason.into(),
        })
    };
    fs::create_dir_all(folder).map_err(|e| Error::unwritable(folder.display(), "", &e))?;
    if lies_inside(truth_file, folder) {
        return refuse("the session would give the truth away");
    }
    if overwrite == Overwrite::Refuse && truth_file.exists() {
        return refuse("it exists already and is not overwritten");
    }
    // A device, a pipe or a link is written to, not replaced.
    let is_replaced = !fs::symlink_metadata(truth_file).is_ok_and(|found| !found.is_file());
    let truth = (truth_file.to_owned(), practised.truth.as_bytes());
    save_session_with(
        folder,
        &practised.session,
        &practised.recordings,
        if is_replaced {
            std::slice::from_ref(&truth)
        } else {
            &[]
        },
        overwrite,
    )?;
    if is_replaced {
        return Ok(());
    }
    fs::write(truth_file, &practised.truth)
        .map_err(|e| Error::unwritable(truth_file.display(), "", &e))
}

fn lies_inside(file: &Path, folder: &Path) -> bool {
    let parent = match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    match (parent.canonicalize(), folder.canonicalize()) {
        (Ok(parent), Ok(folder)) => parent.starts_with(folder),
        _ => false,
    }
}
