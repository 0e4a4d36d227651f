//! The swing that would tell causes apart which the recordings cannot.
//!
//! Each cause, fitted, predicts a swing that was not made. What of the difference no start, damping, bias, phone pose, body
//! or dimension could take up is what would decide.

use nalgebra::{DMatrix, DVector};

use crate::error::Result;
use crate::inertia::by_samples::in_parallel;

use super::fitting::Places;
use super::linear::Reader;
use super::point::{Model, Point};
use super::result::NextSwing;
use super::search::{Found, Tried};

/// Changes of line length and spacing that are thought of, and angles of release, degrees.
const LENGTHS: [f64; 4] = [0.5, 0.75, 1.0, 1.5];
const SPACINGS: [f64; 3] = [0.7, 1.0, 1.4];
const ANGLES_DEG: [f64; 2] = [5.0, 15.0];
const EXCITED: [&[&str]; 4] = [&["yaw"], &["sway"], &["pitch"], &["yaw", "sway", "pitch"]];
/// Durations, s; what differs in phase grows as the time to the power 3/2.
const DURATIONS_S: [f64; 3] = [120.0, 300.0, 600.0];
const DECISIVE: f64 = 5.0;

/// The best of the swings thought of, for the cause taken and its strongest rival.
pub fn next_swing(found: &Found, rival: &Tried) -> Option<NextSwing> {
    let mut other = found.model.clone();
    *other.causes.last_mut()? = rival.cause.clone();
    let design =
        Design { one: &found.model, other: &other, at: &found.fitted.point, rival: &rival.fitted.point };
    let designs: Vec<_> = LENGTHS
        .iter()
        .flat_map(|length| SPACINGS.iter().map(move |spacing| (*length, *spacing)))
        .flat_map(|(length, spacing)| ANGLES_DEG.iter().map(move |angle| (length, spacing, *angle)))
        .flat_map(|(length, spacing, angle)| {
            EXCITED.iter().map(move |excited| (length, spacing, angle, *excited))
        })
        .collect();
    let swings = in_parallel(designs.len(), |k| {
        let (length, spacing, angle_deg, excited) = designs[k];
        design.swing(length, spacing, angle_deg, excited).ok()
    });
    let best = swings.into_iter().flatten().max_by(|a, b| a.sigma.total_cmp(&b.sigma));
    best.map(|swing| in_words(longer(swing), found.model.causes.last().map_or("", |c| c.id), rival.cause.id))
}

/// As long as it takes to decide.
pub fn longer(mut swing: NextSwing) -> NextSwing {
    let recorded_s = swing.duration_s;
    let sigma_at = |t_s: f64| swing.sigma * (t_s / recorded_s).powf(1.5);
    let enough = DURATIONS_S.into_iter().find(|t_s| sigma_at(*t_s) > DECISIVE);
    let duration_s = enough.unwrap_or(DURATIONS_S[DURATIONS_S.len() - 1]);
    swing.sigma = sigma_at(duration_s);
    swing.duration_s = duration_s;
    swing
}

fn in_words(mut swing: NextSwing, one: &str, other: &str) -> NextSwing {
    swing.text = format!(
        "swing {} at {:.0}° on lines of {:.2} m, {:.2} m apart, for {:.0} s: {one} and {other} then differ by {:.0} standard deviations",
        swing.excited.join(" and "),
        swing.amplitude_deg,
        swing.line_length_m,
        swing.spacing_m,
        swing.duration_s,
        swing.sigma
    );
    swing
}

struct Design<'a> {
    one: &'a Model<'a>,
    other: &'a Model<'a>,
    at: &'a Point,
    rival: &'a Point,
}

impl Design<'_> {
    /// How well a swing would tell the two apart: a swing like the first of the session with other lines and another start.
    fn swing(&self, length: f64, spacing: f64, angle_deg: f64, excited: &[&str]) -> Result<NextSwing> {
        const S: usize = 0;
        let index = self.one.swing(S).setup.index;
        let changed = |point: &Point| {
            let mut there = point.clone();
            let mut scale = |i: Option<usize>, by: f64| i.into_iter().for_each(|i| there.x[i] *= by);
            scale(index.line_length, length);
            scale(index.spacing, spacing);
            if index.top_spacing != index.spacing {
                scale(index.top_spacing, spacing);
            }
            let angle = angle_deg.to_radians();
            let line_m = index.line_length.map_or(1.0, |i| there.x[i]);
            let own = &mut there.owns[S];
            own[..8].fill(0.0);
            for name in excited {
                match *name {
                    "yaw" => own[3] = angle,
                    "sway" => own[0] = angle * line_m,
                    _ => own[2] = angle,
                }
            }
            there
        };
        let (mine, theirs) = (changed(self.at), changed(self.rival));
        let blocks = self.one.blocks(S);
        let (a, b) =
            (Reader::new(self.one, &mine, S, &blocks)?, Reader::new(self.other, &theirs, S, &blocks)?);
        let difference = DVector::from_vec(b.reread(&theirs)?) - DVector::from_vec(a.reread(&mine)?);
        let jacobian = self.one.jacobian(&mine, S)?;
        let sigma = self.left(&jacobian, &difference, &mine);
        Ok(NextSwing {
            line_length_m: index.line_length.map_or(f64::NAN, |i| mine.x[i]),
            spacing_m: index.spacing.map_or(f64::NAN, |i| mine.x[i]),
            excited: excited.iter().map(|e| (*e).into()).collect(),
            amplitude_deg: angle_deg,
            duration_s: self.one.swing(S).samples.duration_s,
            hull_pitch_deg: mine.x[index.pitch_deg],
            sigma,
            text: String::new(),
        })
    }

    /// What of a difference of readings nothing that is fitted can take up, in standard deviations.
    fn left(&self, jacobian: &DMatrix<f64>, difference: &DVector<f64>, at: &Point) -> f64 {
        let places = Places::of(self.one).of_swing(self.one, 0);
        let priors = self.one.priors(at);
        let mut matrix = jacobian.transpose() * jacobian;
        for (k, place) in places.iter().enumerate() {
            matrix[(k, k)] += priors[*place].1.powi(-2);
        }
        let pull = jacobian.tr_mul(difference);
        let taken = matrix.cholesky().map_or(0.0, |factor| pull.dot(&factor.solve(&pull)));
        (difference.norm_squared() - taken).max(0.0).sqrt()
    }
}
