//! The swing that would tell the sets still in contention apart: the same hanging, released wider or
//! narrower.

use gyradius_base::message::Message;
use gyradius_estimation::{Rows, Wanted};
use gyradius_identification::one_motion::{ANGLE, RATE};
use gyradius_recording::{Excitation, Quantity};

use super::super::cause_id::CauseId;
use super::super::next_swing::longer;
use super::super::result::NextSwing;
use super::super::words;
use super::competing::Model;
use super::found::Found;
use super::swing::Swing;

/// Amplitudes that are thought of, over that of the swing that was made.
const WIDER: [f64; 4] = [0.25, 0.5, 1.5, 2.0];
/// No release is wider than this, rad.
const WIDEST_RAD: f64 = 1.0;

/// The best of the swings thought of, for what is asked for and the best that may stand in its place;
/// one like the first of the session.
pub fn next_swing(found: &Found) -> Option<NextSwing> {
    let other = *found.instead().first()?;
    let selection = &found.decision.selection;
    let lacks = |set: &Vec<usize>| {
        found
            .decision
            .names
            .iter()
            .any(|id| !selection.has(set, *id))
    };
    let rival = selection.best(|set| selection.has(set, other) && lacks(set))?;
    let one = found
        .decision
        .names
        .iter()
        .find(|id| !selection.has(&rival.set, **id))?;
    let swing = &found.swings[0];
    let suspension = &swing.suspension;
    let stated = |q: Option<Quantity>| q.map_or(0.0, |q| q.value);
    let reach_rad = swing.scales().reach_rad;
    let options = WIDER.iter().filter(|w| **w * reach_rad < WIDEST_RAD);
    let options = options.filter_map(|wider| {
        Some(NextSwing {
            like: swing.id.into(),
            line_length_m: stated(suspension.line_length_m),
            spacing_m: stated(suspension.spacing_m),
            excited: vec![Excitation::of(swing.mode, suspension.orientation)],
            amplitude_deg: (wider * reach_rad).to_degrees(),
            duration_s: swing.readings().duration_s(),
            hull_pitch_deg: stated(suspension.hull_pitch_deg),
            sigma: apart(swing, &found.decision.best, &rival.model, *wider)?,
            message: Message::default(),
        })
    });
    let best = options.max_by(|a, b| a.sigma.total_cmp(&b.sigma))?;
    Some(in_words(longer(best), *one, other))
}

fn in_words(swing: NextSwing, one: CauseId, other: CauseId) -> NextSwing {
    let said = words::message(
        "next_same",
        [
            ("amplitude_deg", words::number(swing.amplitude_deg, 0)),
            ("duration_s", words::number(swing.duration_s, 0)),
            ("one", words::word(&format!("id.{one}"))),
            ("other", words::word(&format!("id.{other}"))),
            ("sigma", words::number(swing.sigma, 0)),
        ],
    );
    swing.told(said)
}

/// How far two models are apart in a swing so much wider, standard deviations, once everything that
/// is fitted has taken up what it can.
fn apart(swing: &Swing, one: &Model, other: &Model, wider: f64) -> Option<f64> {
    let released = |model: &Model| {
        let mut x = model.swings[0].x.clone();
        x[ANGLE] *= wider;
        x[RATE] *= wider;
        x
    };
    let (mine, theirs) = (released(one), released(other));
    let (effects, others) = (swing.fittings(&one.set), swing.fittings(&other.set));
    let problem = swing.problem(&effects);
    let of_one = problem.rows(0, &mine, &[], Wanted::Jacobian)?;
    let of_other = swing
        .problem(&others)
        .rows(0, &theirs, &[], Wanted::Residuals)?;
    let (difference, jacobian) = (of_one.residuals - of_other.residuals, of_one.jacobian?);
    let mut matrix = jacobian.tr_mul(&jacobian);
    for (k, parameter) in problem.parameters().iter().enumerate() {
        matrix[(k, k)] += parameter.prior.map_or(0.0, |(_, u)| u.powi(-2));
    }
    let pull = jacobian.tr_mul(&difference);
    let taken = pull.dot(&matrix.cholesky()?.solve(&pull));
    Some((difference.norm_squared() - taken).max(0.0).sqrt())
}
