//! The effects by name.

use gyradius_core::dynamics::effects::{EffectValues, catalogue};

use crate::scenes::*;

#[test]
fn every_cause_of_the_body_that_criticism_names_is_an_effect() {
    // spec/commands.md, "Names of causes", without the sensor's; pitch_coupling is in the equations of every body.
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
    ];
    let kinds = catalogue();
    for id in named {
        assert!(kinds.iter().any(|kind| kind.id == id), "{id}");
    }
    for (i, kind) in kinds.iter().enumerate() {
        assert!(kinds[..i].iter().all(|other| other.id != kind.id), "{} twice", kind.id);
        assert!(!kind.sentence.is_empty() && !kind.numbers.is_empty(), "{}", kind.id);
        for name in kind.positive {
            assert!(kind.numbers.iter().any(|number| number.name == *name), "{} {name}", kind.id);
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
        let moment = with(keelboat(yawed(0.1)), kind.id, &numbers).motion(10.0).unwrap().at(10.0);
        assert!((moment.position - bare.position).norm() < 1e-12, "{}", kind.id);
        assert!((moment.rate - bare.rate).norm() < 1e-12, "{}", kind.id);
    }
}
