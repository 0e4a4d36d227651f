//! What may be asked, what is refused, and that a plan survives being written.

use gyradius_base::Error;
use gyradius_base::language::Language;
use gyradius_base::message::Message;
use gyradius_planning::{
    BOAT_TYPES, BoatType, Plan, Request, Wanted, WarningKind, plan, rig_toml, session_toml,
};
use gyradius_recording::{Orientation, read_session};
use gyradius_simulator::read_rig;

fn keelboat(wanted: &str) -> String {
    format!(
        r#"{{"hull": {{"mass_kg": 622.7, "length_m": 6.35, "beam_m": 1.73, "boat_type": "keelboat"}}, "wanted": [{wanted}]}}"#
    )
}

#[test]
fn wanted_uncertainties_are_read() {
    for (text, quantity, u, is_relative) in [
        ("k_yaw=0.1%", "k_yaw_m", 1e-3, true),
        ("k_pitch_m = 2 mm", "k_pitch_m", 2e-3, false),
        ("depth=0.5cm", "cm_depth_m", 5e-3, false),
        ("k_roll=500ppm", "k_roll_m", 5e-4, true),
        ("psi=1deg", "psi_deg", 1.0, false),
        ("psi=0.5°", "psi_deg", 0.5, false),
    ] {
        let wanted: Wanted = text.parse().unwrap();
        assert_eq!(
            (wanted.quantity.as_str(), wanted.is_relative),
            (quantity, is_relative),
            "{text}"
        );
        assert!((wanted.u - u).abs() < 1e-12, "{text}");
    }
    for text in [
        "",
        "k_yaw",
        "k_yaw=",
        "k_yaw=1",
        "k_yaw=0%",
        "k_yaw=-1%",
        "psi=1%",
        "k_yaw=1deg",
        "sway=1%",
        "k_yaw=nan%",
    ] {
        let refused = text.parse::<Wanted>();
        assert!(
            matches!(refused, Err(Error::Argument { .. })),
            "{text}: {refused:?}"
        );
    }
}

#[test]
fn what_is_wrong_is_named() {
    for (json, words) in [
        ("{", "request"),
        (r#"{"hulk": 1}"#, "hulk"),
        (r#"{"hull": {"mass_kg": 600, "lenght_m": 6}}"#, "lenght_m"),
        (r#"{"hull": {}}"#, "mass"),
        (
            r#"{"hull": {"mass_kg": 600, "length_m": 6, "beam_m": -2}}"#,
            "beam",
        ),
        (
            r#"{"hull": {"mass_kg": 600, "length_m": 6, "beam_m": 2, "boat_type": "raft"}}"#,
            "raft",
        ),
        (
            r#"{"hull": {"mass_kg": 600, "length_m": 6, "beam_m": 2, "boat_type": "dinghy"}, "means": {"rate_hz": 0}}"#,
            "rate_hz",
        ),
        (
            r#"{"hull": {"mass_kg": 600, "length_m": 6, "beam_m": 2, "boat_type": "dinghy"}, "means": {"most_line_length_m": 0.1}}"#,
            "least_line_length_m",
        ),
        (
            r#"{"hull": {"mass_kg": 9, "length_m": 6, "beam_m": 2, "boat_type": "dinghy", "k_yaw_m": {"value": 4, "u": 0}}}"#,
            "gyradii that a body can have",
        ),
    ] {
        let refused = Request::from_json(json)
            .and_then(|request| plan(&request))
            .unwrap_err();
        assert!(refused.to_string().contains(words), "{json}: {refused}");
    }
}

#[test]
fn every_type_has_a_source_and_a_plan() {
    for (name, kind) in BOAT_TYPES {
        assert_eq!(BoatType::named(name).unwrap(), kind);
        assert!(kind.ratios().source.len() > 20);
        let json = format!(
            r#"{{"hull": {{"mass_kg": 90, "length_m": 4, "beam_m": 1.2, "boat_type": "{name}"}}}}"#
        );
        let plan = plan(&Request::from_json(&json).unwrap()).unwrap();
        assert!(plan.quantities["k_yaw_m"].u.is_some(), "{name}");
    }
}

#[test]
fn a_plan_survives_being_written() {
    let request =
        Request::from_json(&keelboat(r#""k_yaw=0.2%", "k_roll=2%", "psi=1.5deg""#)).unwrap();
    let plan = plan(&request).unwrap();
    let again: Plan = serde_json::from_str(&serde_json::to_string(&plan).unwrap()).unwrap();
    assert_eq!(again.steps, plan.steps);
    let session = read_session(&session_toml(&plan), "session.toml").unwrap();
    let rig = read_rig(&rig_toml(&plan).unwrap(), "rig.toml").unwrap();
    assert_eq!(session.swings, rig.session.swings);
    // The lines side by side are measured once, whatever the tilt.
    let side_by_side = |i: &usize| {
        let hung = &session.swings[*i].suspension;
        hung.orientation == Orientation::Athwartships
            && hung.line_length_m == session.swings[0].suspension.line_length_m
    };
    let lines: Vec<usize> = (0..session.swings.len()).filter(side_by_side).collect();
    let tilted = |i: &&usize| session.swings[**i].suspension.points_moved_m.is_some();
    assert!(lines.iter().any(|i| tilted(&i)));
    for key in ["line_length", "spacing"] {
        assert!(
            lines.iter().all(|i| session.measured_at(*i, key) == 0),
            "{key}"
        );
    }
    assert_eq!(session.swings.len(), plan.predicted.len());
    // ψ asks for a tilt, which is told before the first swing with what the frame's corners would
    // give: tan φ = d / l2.
    let tilt = plan
        .warnings
        .iter()
        .find(|w| w.kind == WarningKind::TiltNeeded)
        .unwrap();
    let depth = plan.hull.cm_depth_m.value;
    let swing = session
        .swings
        .iter()
        .find(|s| Some(&s.id) == tilt.swing.as_ref())
        .unwrap();
    let corner = (0.5 * swing.suspension.spacing_m.unwrap().value / depth)
        .atan()
        .to_degrees();
    assert!((tilt.numbers["corner_tilt_deg"] - corner).abs() < 1e-9);
    let moved = depth * tilt.numbers["tilt_deg"].to_radians().tan();
    assert!((tilt.numbers["points_moved_m"] - moved).abs() < 1e-9);
    told_in_german(&plan);
}

/// Nothing of a plan is in English alone; what is spelled as in the format is the symbol of a
/// quantity.
fn told_in_german(plan: &Plan) {
    let mut all: Vec<(String, Message)> = plan
        .warnings
        .iter()
        .map(|w| (w.text.clone(), w.message()))
        .collect();
    all.extend(
        plan.suspensions
            .iter()
            .map(|hung| (hung.message.english.clone(), hung.message.clone())),
    );
    all.extend(
        plan.budget
            .values()
            .flatten()
            .map(|line| line.input.message())
            .map(|message| (message.english.clone(), message)),
    );
    assert!(plan.suspensions.len() > 1 && all.len() > plan.suspensions.len() + 10);
    for (text, said) in all {
        assert_eq!(text, said.in_language(Language::English));
        let german = said.in_language(Language::German);
        let of_english = [" of ", " period", "lines", "swing "]
            .iter()
            .find(|word| german.contains(**word));
        assert!(
            german != *text && !german.contains('{') && of_english.is_none(),
            "{text}: {german}"
        );
    }
}

#[test]
fn the_same_request_gives_the_same_plan() {
    let request = Request::from_json(&keelboat(r#""k_pitch=0.3%""#)).unwrap();
    assert_eq!(plan(&request).unwrap(), plan(&request).unwrap());
}
