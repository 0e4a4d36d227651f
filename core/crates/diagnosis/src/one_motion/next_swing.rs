//! The swing that would tell causes apart: the same hanging, released wider or narrower.

use super::super::cause_id::CauseId;
use super::super::next_swing::longer;
use super::super::point::Part;
use super::super::result::NextSwing;
use super::super::words;
use super::search::{Found, Tried};
use super::swing::Swing;
use gyradius_base::message::Message;
use gyradius_recording::{Excitation, Quantity};

/// Amplitudes that are thought of, over that of the swing that was made.
const WIDER: [f64; 4] = [0.25, 0.5, 1.5, 2.0];
/// No release is wider than this, rad.
const WIDEST_RAD: f64 = 1.0;

/// The best of the swings thought of, for the cause taken and a rival; one like the first of the
/// session.
pub fn next_swing(found: &Found, rival: &Tried) -> Option<NextSwing> {
    let swing = &found.swings[0];
    let suspension = &swing.suspension;
    let stated = |q: Option<Quantity>| q.map_or(0.0, |q| q.value);
    let options = WIDER
        .iter()
        .filter(|w| **w * swing.scales.reach_rad < WIDEST_RAD)
        .filter_map(|wider| {
            Some(NextSwing {
                like: swing.id.into(),
                line_length_m: stated(suspension.line_length_m),
                spacing_m: stated(suspension.spacing_m),
                excited: vec![Excitation::of(swing.mode, suspension.orientation)],
                amplitude_deg: (wider * swing.scales.reach_rad).to_degrees(),
                duration_s: swing.duration_s,
                hull_pitch_deg: stated(suspension.hull_pitch_deg),
                sigma: apart(found, swing, rival, *wider)?,
                message: Message::default(),
            })
        });
    let best = options.max_by(|a, b| a.sigma.total_cmp(&b.sigma))?;
    let last = *found.best.causes.last()?;
    Some(in_words(longer(best), found.id(last), rival.id))
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

/// How far two causes are apart in a swing so much wider, standard deviations, once everything that
/// is fitted has taken up what it can.
fn apart(found: &Found, swing: &Swing, rival: &Tried, wider: f64) -> Option<f64> {
    let (mine, theirs) = (
        swing.wider(&found.best.fits[0].point, wider),
        swing.wider(&rival.with.fits[0].point, wider),
    );
    let causes = found.best.causes_of(swing);
    let difference = swing.residual(&mine, &causes, Part::All)?
        - swing.residual(&theirs, &rival.with.causes_of(swing), Part::All)?;
    let jacobian = swing.jacobian(&mine, &causes, Part::All)?;
    let mut matrix = jacobian.tr_mul(&jacobian);
    for (k, (_, u)) in swing.priors(&causes).iter().enumerate() {
        matrix[(k, k)] += u.powi(-2);
    }
    let pull = jacobian.tr_mul(&difference);
    let taken = pull.dot(&matrix.cholesky()?.solve(&pull));
    Some((difference.norm_squared() - taken).max(0.0).sqrt())
}
