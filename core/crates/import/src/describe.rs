//! What exports hold, and the command that makes them a session.

use std::path::PathBuf;

use super::gather::split;
use super::import::ImportRequest;
use super::input::options;
use gyradius_base::error::Result;
use gyradius_recording::import::{ImportedData, Platform, import_inputs};
use gyradius_recording::{Orientation, Quantity, SuspensionKind};

/// What exports hold, line by line: every recording with its format, sensors and samples, what an
/// import would tell, and the command that would write a session. Nothing is written. Fails as
/// reading does; a table that is not known is an error that proposes a mapping.
pub fn describe_exports(files: &[PathBuf], request: &ImportRequest) -> Result<Vec<String>> {
    let (recorded, exported) = split(files)?;
    let mut lines: Vec<String> = recorded
        .iter()
        .map(|file| format!("{}: a recorder's file", file.display()))
        .collect();
    let mut of_gate = false;
    if !exported.is_empty() {
        let mut options = options(&request.mapping, request.platform)?;
        options.trial.clone_from(&request.trial);
        for recording in import_inputs(&exported, &options)?.recordings {
            lines.push(format!("{}: {}", recording.name, recording.summary()));
            lines.extend(recording.told().into_iter().map(|text| format!("  {text}")));
            of_gate |= matches!(recording.data, ImportedData::GateEvents(_));
        }
    }
    lines.push(
        "To write a session, with your figures for what stands in capitals (U: one standard uncertainty):"
            .to_owned(),
    );
    lines.push(format!("  {}", command(files, request, of_gate)));
    Ok(lines)
}

/// The command with all that is stated, and in capitals what is still to be stated.
fn command(files: &[PathBuf], request: &ImportRequest, of_gate: bool) -> String {
    let mut words = vec!["gyradius import".to_owned()];
    words.extend(files.iter().map(|file| quoted(&file.to_string_lossy())));
    let mut option = |name: &str, value: String| words.push(format!("--{name} {value}"));
    for entry in &request.mapping {
        option("map", quoted(entry));
    }
    if let Some(trial) = &request.trial {
        option("trial", quoted(trial));
    }
    if let Some(platform) = request.platform {
        let name = match platform {
            Platform::Android => "android",
            Platform::Ios => "ios",
        };
        option("platform", name.to_owned());
    }
    match request.flag_width_m {
        Some(width_m) => option("flag-width", width_m.to_string()),
        None if of_gate => option("flag-width", "M".to_owned()),
        None => {}
    }
    if !request.title.is_empty() {
        option("title", quoted(&request.title));
    }
    option("output", "SESSION".to_owned());
    let hung = &request.suspension;
    if hung.kind != SuspensionKind::Bifilar {
        option("suspension", hung.kind.name().to_owned());
    }
    if hung.orientation != Orientation::Athwartships {
        option("orientation", hung.orientation.name().to_owned());
    }
    let of_hanging = hung.kind.figures().iter().map(|key| {
        let wanted = hung.kind.needs().contains(key).then_some("M:U");
        (option_of(key), hung.figure(key), wanted)
    });
    let of_session = [
        ("mass".to_owned(), request.mass_kg, Some("KG:U")),
        ("gravity".to_owned(), request.gravity_m_s2, None),
    ];
    for (name, stated, wanted) in of_session.into_iter().chain(of_hanging) {
        match (stated, wanted) {
            (Some(stated), _) => words.push(format!("--{name}={}", reading(stated))),
            (None, Some(wanted)) => words.push(format!("--{name} {wanted}")),
            (None, None) => {}
        }
    }
    words.join(" ")
}

/// The option that states a figure of a suspension.
fn option_of(key: &str) -> String {
    key.trim_end_matches("_deg").replace('_', "-")
}

fn reading(stated: Quantity) -> String {
    match stated.u.is_nan() {
        true => stated.value.to_string(),
        false => format!("{}:{}", stated.value, stated.u),
    }
}

/// A word of a command, in quotes where a shell would take it apart.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_./:=@,+-".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    let escaped = word.chars().flat_map(|c| {
        let mark = matches!(c, '"' | '\\' | '$' | '`').then_some('\\');
        mark.into_iter().chain(std::iter::once(c))
    });
    format!("\"{}\"", escaped.collect::<String>())
}
