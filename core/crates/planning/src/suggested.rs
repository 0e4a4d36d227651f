//! A swing that the criticism suggests, as one that can be followed.

use std::collections::BTreeMap;

use super::means::Means;
use super::step::PlannedSwing;
use gyradius_diagnosis::NextSwing;
use gyradius_recording::{Quantity, Session, Suspension};

/// Period that is certain enough, as a part of it: what tells causes apart is the length of the
/// whole recording.
const PERIOD_U_WANTED: f64 = 1e-4;
/// A tilt that is off that of the swing hung alike by less is the same, degrees.
const SAME_TILT_DEG: f64 = 1.0;

/// The suggested swing: the one of the session that it names, with its masses and its tape, changed
/// as suggested. A tilt asks for points moved along the deck, which the depth of the centre of mass
/// below the level ones tells. It knows no instruments: their errors are in its figures' own.
///
/// `None` where the session does not have the swing that it is to hang like.
pub fn suggested(
    next: &NextSwing,
    session: &Session,
    cm_depth_m: Option<f64>,
) -> Option<PlannedSwing> {
    let free = free_id(session);
    let session = session.without_instruments();
    let like = session.swings.iter().find(|swing| swing.id == next.like)?;
    Some(PlannedSwing {
        id: free,
        suspension: hung(next, &like.suspension, cm_depth_m),
        added_masses: like.added_masses.clone(),
        excited: next.excited.clone(),
        amplitude_deg: next.amplitude_deg,
        duration_s: next.duration_s,
        periods_s: BTreeMap::new(),
        period_u_wanted: PERIOD_U_WANTED,
    })
}

fn hung(next: &NextSwing, like: &Suspension, cm_depth_m: Option<f64>) -> Suspension {
    let at =
        |stated: Option<Quantity>, value: f64| stated.map(|known| Quantity::new(value, known.u));
    let wider = like
        .spacing_m
        .map_or(1.0, |spacing| next.spacing_m / spacing.value);
    let level = Suspension {
        line_length_m: at(like.line_length_m, next.line_length_m),
        spacing_m: at(like.spacing_m, next.spacing_m),
        top_spacing_m: like
            .top_spacing_m
            .map(|top| Quantity::new(top.value * wider, top.u)),
        ..like.clone()
    };
    let pitch_deg = next.hull_pitch_deg;
    let tilt = like
        .hull_pitch_deg
        .unwrap_or(Quantity::new(0.0, Means::default().u_hull_pitch_deg));
    if (pitch_deg - tilt.value).abs() < SAME_TILT_DEG {
        return level;
    }
    // l2 = Δ / tan φ: forward of the level ones, bow up.
    let moved = |depth_m: f64| depth_m * pitch_deg.to_radians().tan();
    let tape = like
        .points_moved_m
        .or(like.spacing_m)
        .map_or(Means::default().u_spacing_m, |read| read.u);
    Suspension {
        hull_pitch_deg: Some(Quantity::new(pitch_deg, tilt.u)),
        points_moved_m: cm_depth_m.map(|depth_m| Quantity::new(moved(depth_m), tape)),
        ..level
    }
}

fn free_id(session: &Session) -> String {
    let taken = |id: &String| session.swings.iter().any(|swing| swing.id == *id);
    let mut ids = (1..).map(|number| format!("extra-{number}"));
    ids.find(|id| !taken(id)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use gyradius_recording::{Excitation, read_session};

    const SESSION: &str = r#"
format = "gyradius-session/1"
title = "t"
[body]
name = "b"
[[swing]]
id = "extra-1"
periods_s = { yaw = 4.0 }
[[swing.added_mass]]
mass = { value = 2.0, u = 0.001 }
position = [0.4, 0.0, 0.0]
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 3.0, u = 0.004 }
spacing = { value = 1.8, u = 0.001 }
top_spacing = { value = 2.0, u = 0.002 }
[[swing]]
id = "axle"
periods_s = { compound = 4.0 }
[swing.suspension]
kind = "compound"
orientation = "fore_and_aft"
axis_height = { value = 0.3, u = 0.001 }
"#;

    fn next(like: &str, hull_pitch_deg: f64) -> NextSwing {
        NextSwing {
            like: like.into(),
            line_length_m: 2.5,
            spacing_m: 0.9,
            excited: vec![Excitation::Yaw, Excitation::Sway],
            amplitude_deg: 12.0,
            duration_s: 300.0,
            hull_pitch_deg,
            sigma: 9.0,
            message: Default::default(),
        }
    }

    fn hung_for(next: &NextSwing) -> PlannedSwing {
        suggested(
            next,
            &read_session(SESSION, "session.toml").unwrap(),
            Some(0.5),
        )
        .unwrap()
    }

    #[test]
    fn it_hangs_like_the_swing_it_names_with_an_id_of_its_own() {
        // A fit finds a level hull a little off level: that is no tilt to hang it with.
        let swing = hung_for(&next("extra-1", 0.3));
        assert_eq!(swing.id, "extra-2");
        assert_eq!(
            swing.suspension.line_length_m,
            Some(Quantity::new(2.5, 0.004))
        );
        assert_eq!(swing.suspension.spacing_m, Some(Quantity::new(0.9, 0.001)));
        // Half the spacing, half that above: the lines keep their lean.
        assert_eq!(
            swing.suspension.top_spacing_m,
            Some(Quantity::new(1.0, 0.002))
        );
        assert_eq!(
            (
                swing.suspension.hull_pitch_deg,
                swing.suspension.points_moved_m
            ),
            (None, None)
        );
        assert_eq!(swing.added_masses.len(), 1);
        assert_eq!(swing.excited, [Excitation::Yaw, Excitation::Sway]);
        assert_eq!((swing.amplitude_deg, swing.duration_s), (12.0, 300.0));
    }

    #[test]
    fn a_tilt_is_hung_by_points_that_are_moved() {
        let hung = hung_for(&next("extra-1", -20.0)).suspension;
        assert_eq!(hung.hull_pitch_deg, Some(Quantity::new(-20.0, 0.2)));
        let moved = hung.points_moved_m.unwrap();
        // Half a metre deep, bow down: aft by 0.5 tan 20° = 0.18199 m.
        assert!(
            (moved.value + 0.181985).abs() < 1e-6 && moved.u == 0.001,
            "{moved:?}"
        );
    }

    /// A plan names no instruments: 3 mm of the reading and 4 mm of the tape are 5 mm.
    #[test]
    fn the_errors_of_an_instrument_go_with_the_figure() {
        let tape = "[[instrument]]\nid = \"t\"\nkind = \"tape\"\nzero_u = 0.004\n";
        let read = SESSION.replace(
            "line_length = { value = 3.0, u = 0.004 }",
            "line_length = { value = 3.0, u = 0.003, instrument = \"t\" }",
        ) + tape;
        let session = read_session(&read, "session.toml").unwrap();
        let hung = suggested(&next("extra-1", 0.0), &session, None).unwrap();
        let length = hung.suspension.line_length_m.unwrap();
        assert!((length.u - 0.005).abs() < 1e-12, "{length:?}");
    }

    #[test]
    fn an_axle_stays_where_it_is_and_a_swing_that_is_not_there_is_none() {
        let hung = hung_for(&next("axle", 0.0)).suspension;
        assert_eq!((hung.line_length_m, hung.spacing_m), (None, None));
        assert_eq!(hung.axis_height_m, Some(Quantity::new(0.3, 0.001)));
        assert_eq!(
            suggested(&next("other", 0.0), &Session::default(), None),
            None
        );
    }
}
