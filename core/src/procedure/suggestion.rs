//! The criticism's next swing as a step that can be followed.

use crate::critique::NextSwing;
use crate::plan::{PlannedSwing, Step};
use crate::recording::{Excitation, Quantity, Session};

/// Period that is certain enough, as a part of it: as the live estimator has it.
const PERIOD_U: f64 = 1e-4;

/// The step; nothing where the session has no swing on lines to hang it like.
pub(super) fn step(next: &NextSwing, session: &Session) -> Option<Step> {
    let like = session.swings.iter().find(|swing| swing.suspension.line_length_m.is_some())?;
    let u = |quantity: Option<Quantity>| quantity.map_or(0.0, |quantity| quantity.u);
    let mut suspension = like.suspension.clone();
    suspension.line_length_m = Some(Quantity::new(next.line_length_m, u(suspension.line_length_m)));
    suspension.spacing_m = Some(Quantity::new(next.spacing_m, u(suspension.spacing_m)));
    // Lines hung vertically again: the points above follow those on the hull.
    suspension.top_spacing_m = None;
    suspension.hull_pitch_deg = match next.hull_pitch_deg {
        0.0 => None,
        pitch => Some(Quantity::new(pitch, 0.5)),
    };
    Some(Step::Swing(PlannedSwing {
        id: free_id(session),
        suspension,
        added_masses: Vec::new(),
        excited: next.excited.iter().filter_map(|name| excitation(name)).collect(),
        amplitude_deg: next.amplitude_deg,
        duration_s: next.duration_s,
        periods_s: Default::default(),
        period_u_wanted: PERIOD_U,
    }))
}

fn excitation(name: &str) -> Option<Excitation> {
    match name {
        "yaw" => Some(Excitation::Yaw),
        "sway" => Some(Excitation::Sway),
        "surge" => Some(Excitation::Surge),
        "pitch" => Some(Excitation::Pitch),
        "roll" => Some(Excitation::Roll),
        _ => None,
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
    use crate::recording::read_session;

    const SESSION: &str = r#"
format = "gyradius-session/1"
title = "t"
[body]
name = "b"
[[swing]]
id = "extra-1"
periods_s = { yaw = 4.0 }
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 3.0, u = 0.004 }
spacing = { value = 1.8, u = 0.001 }
"#;

    #[test]
    fn the_next_swing_hangs_like_the_others_with_an_id_of_its_own() {
        let session = read_session(SESSION, "session.toml").unwrap();
        let next = NextSwing {
            line_length_m: 2.5,
            spacing_m: 1.2,
            excited: vec!["yaw".into(), "sway".into(), "dance".into()],
            amplitude_deg: 12.0,
            duration_s: 300.0,
            hull_pitch_deg: 0.0,
            sigma: 9.0,
            text: String::new(),
        };
        let Some(Step::Swing(swing)) = step(&next, &session) else { panic!() };
        assert_eq!(swing.id, "extra-2");
        assert_eq!(swing.suspension.line_length_m, Some(Quantity::new(2.5, 0.004)));
        assert_eq!(swing.suspension.spacing_m, Some(Quantity::new(1.2, 0.001)));
        assert_eq!(swing.excited, [Excitation::Yaw, Excitation::Sway]);
        assert_eq!((swing.amplitude_deg, swing.duration_s), (12.0, 300.0));
        assert_eq!(step(&next, &Session::default()), None);
    }
}
