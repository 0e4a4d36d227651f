//! Recordings that other programs exported, told apart by their content.
//!
//! What is known of each format, and what is done about it, is in `README.md` beside this file.
//!
//! # Conventions
//! Columns are found by header name, never by position. Results are in s, rad/s and m/s² with
//! Android's sign (at rest, screen up: z = +9.8). Time stamps are the file's own.

mod clock;
mod columns;
mod detect;
mod facts;
mod gcsv;
mod imported;
mod json;
mod labelled;
mod labels;
mod layout;
mod light_gate;
mod mapping;
mod options;
mod phyphox;
mod physics_toolbox;
mod run_label;
mod sensor_logger;
mod sensorlog;
mod source;
mod sqlite;
mod stacked;
pub(crate) mod table;
mod tagged;
mod told;
mod trials;
mod units;
mod workbook;

use std::collections::BTreeMap;

use gyradius_base::{Error, Result};

pub use facts::Facts;
pub use imported::{Format, Imported, ImportedData, ImportedRecording};
pub use mapping::{ColumnMapping, MappedColumn};
pub use options::{ImportOptions, Platform};
pub use source::Input;
pub use units::{Dimension, Unit, from_core_motion, stamp_from_core_motion};

use detect::Content;
use facts::FactsOfSource;
use source::Source;
use table::Table;

/// Imports exports by content. `inputs` are names and bytes; each folder of a `.zip` is one
/// recording, and loose files of one folder that hold different sensors of one phone are one
/// recording too.
pub fn import_files(inputs: &[(String, Vec<u8>)], options: &ImportOptions) -> Result<Imported> {
    let inputs: Vec<Input> = inputs
        .iter()
        .map(|(name, bytes)| Input::File(name.clone(), bytes.clone()))
        .collect();
    import_inputs(&inputs, options)
}

/// The same from files and folders; a folder is read as the archive that it was.
pub fn import_inputs(inputs: &[Input], options: &ImportOptions) -> Result<Imported> {
    let mut device = BTreeMap::new();
    let mut recordings = Vec::new();
    let mut fruitful: Vec<Option<String>> = Vec::new();
    let mut barren = Vec::new();
    let mut sources = source::sources(inputs)?;
    if let Some(trial) = &options.trial
        && !source::keep_trial(&mut sources, trial)?
    {
        return Err(Error::argument(
            "trial",
            "a file with several trials",
            "none",
        ));
    }
    for source in sources {
        if options.trial.is_none() {
            trials::refuse_several(&source, options.mapping.is_some())?;
        }
        let found = match &options.mapping {
            Some(mapping) => mapping::import(&source, mapping),
            None => recognised(&source, options, &mut device),
        };
        let mut found = found?;
        if let (None, Some(first)) = (&options.trial, found.first_mut()) {
            let notes = source
                .members()
                .filter_map(|(name, bytes)| trials::note(bytes, name));
            first.notes.extend(notes);
        }
        if let Some(first) = found.first_mut() {
            let told = |(name, bytes): (&str, &[u8])| told::passed_over(bytes, name);
            first.notes.extend(source.members().flat_map(told));
        }
        let facts = FactsOfSource::new(&source);
        for recording in &mut found {
            recording.facts = facts.of(&recording.name).recorded_by(recording.format);
        }
        if found.is_empty() {
            barren.push(source);
        } else {
            fruitful.push(source.archive);
            recordings.extend(found);
        }
    }
    // A folder of an archive may hold nothing of use; an archive, or loose files, may not.
    if let Some(source) = barren
        .iter()
        .find(|source| source.archive.is_none() || !fruitful.contains(&source.archive))
    {
        return Err(detect::unknown(source)?);
    }
    let source = recordings
        .first()
        .map(|first| first.format)
        .ok_or_else(|| Error::argument("inputs", "at least one exported file", "none"))?;
    Ok(Imported {
        recordings,
        device,
        source,
    })
}

/// A file by the name that it has in the session's folder or the archive: paths of this machine
/// stay out of sessions.
pub(crate) fn file_not_used(name: &str) -> String {
    format!("`{}` is not used", source::base(name))
}

/// The project's own columns, with others beside them. An acceleration in g is refused: what is written
/// of it could not be measured.
fn native(table: &Table) -> Result<ImportedRecording> {
    let (recording, used) = super::csv::read_axes(table)?;
    let doubt = columns::gravity_doubt(&recording);
    if let (Some(doubt), true) = (&doubt, columns::is_in_g(&recording)) {
        let mapping = labels::proposal(table).unwrap_or_default();
        let expected = format!(
            "accelerations in m/s2, or a column mapping that tells the units (what is in capitals is yours to fill in): {}",
            mapping.replace(":rad/s\"", ":UNIT\"")
        );
        return Err(table.malformed(None, &expected, doubt));
    }
    let notes = doubt.into_iter().collect();
    let imported = ImportedRecording::new(table.file(), Format::Native, recording, notes);
    Ok(imported.without(columns::columns_not_used(table, used)))
}

fn recognised(
    source: &Source,
    options: &ImportOptions,
    device: &mut BTreeMap<String, String>,
) -> Result<Vec<ImportedRecording>> {
    let contents = detect::contents(source)?;
    let of = |wanted: Content| -> Vec<(&str, &[u8])> {
        contents
            .iter()
            .filter(|content| content.2 == wanted)
            .map(|content| (content.0, content.1))
            .collect()
    };
    let mut out = Vec::new();
    for (name, bytes) in of(Content::Native) {
        // With a preamble, another separator or a decimal comma it is read all the same.
        let table = Table::open(bytes, name)?;
        out.push(native(&table)?);
    }
    for (name, bytes) in of(Content::Track) {
        let data = ImportedData::Track(super::csv::track_of(&Table::open(bytes, name)?)?);
        out.push(ImportedRecording::of(
            name,
            Format::Native,
            data,
            Vec::new(),
        ));
    }
    for (name, bytes) in of(Content::Periods) {
        let data = ImportedData::Periods(super::csv::periods_of(&Table::open(bytes, name)?)?);
        let notes = Vec::new();
        out.push(ImportedRecording::of(name, Format::Native, data, notes));
    }
    for (name, bytes) in of(Content::Channel) {
        let table = Table::open(bytes, name)?;
        let data = ImportedData::Channel(super::csv::channel_of(&table)?);
        out.push(ImportedRecording::of(
            name,
            Format::Native,
            data,
            Vec::new(),
        ));
    }
    for (name, bytes) in of(Content::Labelled) {
        out.push(labelled::import(bytes, name)?);
    }
    for (name, bytes) in of(Content::Gcsv) {
        out.push(gcsv::import(bytes, name)?);
    }
    for (name, bytes) in of(Content::LightGate) {
        out.push(light_gate::import(bytes, name)?);
    }
    for (name, bytes) in of(Content::PhysicsToolbox) {
        out.push(physics_toolbox::import(bytes, name)?);
    }
    for (name, bytes) in of(Content::SensorLog) {
        out.push(sensorlog::import(bytes, name)?);
    }
    out.extend(sensor_logger::import(
        source,
        &of(Content::SensorLogger),
        &of(Content::SensorLoggerMetadata),
        options,
        device,
    )?);
    out.extend(phyphox::import(
        source,
        &of(Content::Phyphox),
        &of(Content::PhyphoxTime),
        &of(Content::PhyphoxDevice),
        device,
    )?);
    let place = |recorded: &ImportedRecording| {
        source
            .members()
            .position(|(name, _)| source::stem(name) == recorded.name)
    };
    out.sort_by_key(place);
    let unused: Vec<String> = of(Content::Unknown)
        .iter()
        .map(|(name, _)| *name)
        .chain(source.ignored.iter().map(String::as_str))
        .map(file_not_used)
        .collect();
    if let Some(last) = out.last_mut() {
        last.not_used.extend(unused);
    }
    Ok(out)
}
