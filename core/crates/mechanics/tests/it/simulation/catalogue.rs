//! The effects by name.

use std::path::{Path, PathBuf};

use gyradius_mechanics::effects::{EffectValues, catalogue};
use gyradius_mechanics::sensors;

use crate::simulation::scenes::*;

#[test]
fn every_effect_of_the_body_that_was_asked_for_is_there() {
    // spec/commands.md, "Names of causes", without the sensor's; pitch_coupling is in the equations
    // of every body.
    let named = [
        "quadratic_drag",
        "power_law_damping",
        "bearing_friction",
        "presliding_bearing",
        "amplitude_added_mass",
        "line_creep",
        "line_stretch",
        "line_torsion",
        "nonparallel_lines",
        "unequal_lines",
        "off_centre_cm",
        "support_compliance",
        "internal_motion",
        "wind",
        "stated_length",
        "stated_spacing",
        // Further ones that were asked for.
        "linear_damping",
        "added_mass",
        "line_mass",
        "buoyancy",
        // Those that show what has no name.
        "knock",
        "line_slip",
        "learned_force",
    ];
    let kinds = catalogue();
    for id in named {
        assert!(kinds.iter().any(|kind| kind.id == id), "{id}");
    }
    for (i, kind) in kinds.iter().enumerate() {
        assert!(
            kinds[..i].iter().all(|other| other.id != kind.id),
            "{} twice",
            kind.id
        );
        assert!(!kind.numbers.is_empty(), "{}", kind.id);
        for name in kind.positive {
            assert!(
                kind.numbers.iter().any(|number| number.name == *name),
                "{} {name}",
                kind.id
            );
        }
    }
}

#[test]
fn a_number_that_is_divided_by_must_be_positive() {
    for kind in catalogue().iter().filter(|kind| !kind.positive.is_empty()) {
        let mut scene = keelboat(yawed(0.1));
        scene.effects = vec![EffectValues::new(kind.id, &[]).unwrap()];
        let error = scene.motion(1.0).unwrap_err().to_string();
        assert!(error.contains(kind.positive[0]), "{error}");
    }
}

#[test]
fn effects_of_no_strength_change_nothing() {
    let bare = keelboat(yawed(0.1)).motion(10.0).unwrap().at(10.0);
    for kind in catalogue() {
        // These are absent only when infinitely stiff.
        if ["line_stretch", "support_compliance", "internal_motion"].contains(&kind.id) {
            continue;
        }
        let numbers: Vec<_> = kind.positive.iter().map(|name| (*name, 1.0)).collect();
        let moment = with(keelboat(yawed(0.1)), kind.id, &numbers)
            .motion(10.0)
            .unwrap()
            .at(10.0);
        assert!(
            (moment.position - bare.position).norm() < 1e-12,
            "{}",
            kind.id
        );
        assert!((moment.rate - bare.rate).norm() < 1e-12, "{}", kind.id);
    }
}

/// All Rust files below a folder, with their text.
fn sources(folder: &Path, out: &mut Vec<(PathBuf, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|end| end == "rs") {
            let text = std::fs::read_to_string(&path).unwrap();
            out.push((path, text));
        }
    }
}

#[test]
fn an_effect_is_named_in_its_own_file_alone() {
    // Whoever adds one touches that file and the registry of its crate.
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    ["mechanics", "simulator"]
        .iter()
        .for_each(|name| sources(&crates.join(name).join("src"), &mut files));
    for kind in catalogue().into_iter().chain(sensors::catalogue()) {
        let quoted = format!("\"{}\"", kind.id);
        let telling = |text: &str| {
            text.lines()
                .any(|line| line.contains("const ID") && line.contains(&quoted))
        };
        let naming: Vec<_> = files
            .iter()
            .filter(|(_, text)| text.contains(&quoted))
            .collect();
        assert!(
            naming.iter().all(|(_, text)| telling(text)),
            "{}: {:?}",
            kind.id,
            naming.iter().map(|f| &f.0)
        );
        assert_eq!(naming.len(), 1, "{}", kind.id);
    }
}

#[test]
fn every_effect_of_the_sensors_that_was_asked_for_is_there() {
    // Place, turn and constant bias are the phone's own numbers.
    let named = [
        "bias_drift",
        "gyro_scale",
        "acc_scale",
        "cross_axis",
        "clock_scale",
        "jitter",
        "drop_outs",
        "saturation",
        "quantisation",
        "low_pass",
        "delay",
        "phone_slip",
        "phone_mount_resonance",
    ];
    let kinds = sensors::catalogue();
    for id in named {
        assert!(kinds.iter().any(|kind| kind.id == id), "{id}");
    }
}
