//! What `import` says of files without writing: what they hold, and the next command.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;

use gyradius_import::{ImportRequest, describe_exports};
use gyradius_recording::{Quantity, Suspension, SuspensionKind};

use crate::told::{phyphox, request};

#[test]
fn the_next_command_has_what_is_stated_and_names_what_is_not() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("my yaw.csv");
    fs::write(&file, phyphox(60, |i| 0.01 * i as f64, |i| i as f64)).unwrap();
    let mut asked = ImportRequest {
        title: "My $boat".to_owned(),
        ..request(&[])
    };
    asked.suspension.spacing_m = None;
    asked.suspension.line_length_m = Some(Quantity::new(3.477, 0.006));
    let lines = describe_exports(std::slice::from_ref(&file), &asked).unwrap();
    assert!(
        lines[0].starts_with("my yaw: gyroscope, 60 samples in 0.6 s"),
        "{lines:?}"
    );
    let name = file.display();
    let expected = format!(
        "  gyradius import \"{name}\" --title \"My \\$boat\" --output SESSION --mass KG:U --line-length=3.477:0.006 --spacing M:U"
    );
    assert_eq!(lines.last(), Some(&expected));

    asked.suspension = Suspension {
        kind: SuspensionKind::Compound,
        line_length_m: None,
        ..asked.suspension
    };
    let lines = describe_exports(&[file], &asked).unwrap();
    let last = lines.last().unwrap();
    assert!(
        last.ends_with("--suspension compound --mass KG:U --axis-height M:U"),
        "{last}"
    );
}

#[test]
fn a_light_gate_needs_its_flag_and_a_single_channel_does_not() {
    let dir = tempfile::tempdir().unwrap();
    let gate = dir.path().join("gate.csv");
    fs::write(
        &gate,
        "Time,Event Time,State at A,State at B\ns,s,State,State\n\n0,0,1,0\n0.1,0.1,0,0\n2,2,1,0\n2.1,2.1,0,0\n",
    )
    .unwrap();
    let lines = describe_exports(&[gate], &request(&[])).unwrap();
    assert!(
        lines.last().unwrap().contains("--flag-width M "),
        "{lines:?}"
    );
    let angle = dir.path().join("angle.csv");
    fs::write(&angle, "t,angle\n0,1\n0.1,2\n0.2,1\n").unwrap();
    let lines = describe_exports(&[angle], &request(&[])).unwrap();
    let command = lines.last().unwrap();
    assert!(
        command.contains("gyradius import") && !command.contains("--flag-width"),
        "{lines:?}"
    );
}
