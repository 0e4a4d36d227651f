//! The swing that would tell causes apart which the recordings cannot.
//!
//! Each cause, fitted, predicts a swing that was not made. What of the difference no start,
//! damping, bias, phone pose, body or dimension could take up is what would decide.

use nalgebra::{DMatrix, DVector};

use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_recording::{Excitation, Orientation, Swing};

use super::cause_id::CauseId;
use super::fitting::Places;
use super::point::{Model, Point};
use super::result::NextSwing;
use super::words;
use gyradius_base::message::{Argument, Message};
use gyradius_identification::samples::place;

/// Changes of line length and spacing that are thought of, and angles of release, degrees.
const LENGTHS: [f64; 4] = [0.5, 0.75, 1.0, 1.5];
const SPACINGS: [f64; 3] = [0.7, 1.0, 1.4];
const ANGLES_DEG: [f64; 2] = [5.0, 15.0];
/// Tilts that are thought of beside the hanging of the session, degrees.
const TILTS_DEG: [f64; 2] = [-20.0, 20.0];
const EXCITED: [&[Motion]; 4] = [
    &[Motion::Yaw],
    &[Motion::Along],
    &[Motion::Turn],
    &[Motion::Yaw, Motion::Along, Motion::Turn],
];
/// Durations, s; what differs in phase grows as the time to the power 3/2.
const DURATIONS_S: [f64; 3] = [120.0, 300.0, 600.0];
const DECISIVE: f64 = 5.0;

/// A motion that a swing may be let go in.
#[derive(Clone, Copy)]
enum Motion {
    Yaw,
    /// Along the line that joins the suspension points.
    Along,
    /// About that line.
    Turn,
}

impl Motion {
    fn excitation(self, orientation: Orientation) -> Excitation {
        match self {
            Self::Yaw => Excitation::Yaw,
            Self::Along => Excitation::along(orientation),
            Self::Turn => Excitation::about(orientation),
        }
    }
}

/// One of two ways to explain a session: the simulation with a cause in it, fitted.
pub struct Explained<'a> {
    pub model: &'a Model<'a>,
    pub point: &'a Point,
    /// The cause's name.
    pub id: CauseId,
}

/// The best of the swings thought of, for two ways to explain a session that differ in their last
/// cause.
pub fn next_swing(one: &Explained, other: &Explained) -> Option<NextSwing> {
    let design = Design {
        one: one.model,
        other: other.model,
        at: one.point,
        rival: other.point,
    };
    let best_of = |releases: Vec<Release>| {
        let swings = in_parallel(releases.len(), |k| {
            Some((design.swing(&releases[k]).ok()?, releases[k]))
        });
        swings
            .into_iter()
            .flatten()
            .max_by(|a, b| a.0.sigma.total_cmp(&b.0.sigma))
    };
    let (level, release) = best_of(level())?;
    // A tilt is worth the trouble only where no level swing decides. No points that are moved tilt
    // a hull that hangs by one behind the other.
    let is_athwartships = design.like().suspension.orientation == Orientation::Athwartships;
    let is_decided = longer(level.clone()).sigma > DECISIVE;
    let tilts = TILTS_DEG
        .iter()
        .filter(|_| is_athwartships && !is_decided)
        .flat_map(|tilt| EXCITED.iter().map(move |excited| (*tilt, *excited)));
    let tilted = best_of(
        tilts
            .map(|(tilt_deg, excited)| Release {
                excited,
                tilt_deg,
                ..release
            })
            .collect(),
    );
    let best = tilted
        .map(|(swing, _)| swing)
        .filter(|swing| swing.sigma > level.sigma)
        .unwrap_or(level);
    Some(in_words(longer(best), one.id, other.id))
}

/// The swings thought of that leave the hull level.
fn level() -> Vec<Release> {
    let mut all = Vec::new();
    for length in LENGTHS {
        for spacing in SPACINGS {
            for angle_deg in ANGLES_DEG {
                all.extend(EXCITED.map(|excited| Release {
                    length,
                    spacing,
                    angle_deg,
                    excited,
                    tilt_deg: 0.0,
                }));
            }
        }
    }
    all
}

/// A swing that is thought of: length and spacing over those of the session, and how it is let go.
#[derive(Clone, Copy)]
struct Release {
    length: f64,
    spacing: f64,
    angle_deg: f64,
    excited: &'static [Motion],
    /// Added to the pitch of the session's first swing, degrees.
    tilt_deg: f64,
}

/// As long as it takes to decide.
pub fn longer(mut swing: NextSwing) -> NextSwing {
    let recorded_s = swing.duration_s;
    let sigma_at = |t_s: f64| swing.sigma * (t_s / recorded_s).powf(1.5);
    let enough = DURATIONS_S
        .into_iter()
        .find(|t_s| sigma_at(*t_s) > DECISIVE);
    let duration_s = enough.unwrap_or(DURATIONS_S[DURATIONS_S.len() - 1]);
    swing.sigma = sigma_at(duration_s);
    swing.duration_s = duration_s;
    swing
}

fn in_words(swing: NextSwing, one: CauseId, other: CauseId) -> NextSwing {
    let hull = match swing.hull_pitch_deg {
        pitch if pitch.abs() < 1.0 => None,
        pitch => {
            let key = if pitch > 0.0 {
                "next_bow_up"
            } else {
                "next_bow_down"
            };
            Some(words::message(
                key,
                [("pitch_deg", words::number(pitch.abs(), 0))],
            ))
        }
    };
    let excited = swing
        .excited
        .iter()
        .map(|one| one.name())
        .collect::<Vec<_>>()
        .join(" ");
    let said = words::message(
        "next_lines",
        [
            ("excited", Argument::Word(excited)),
            ("hull", words::part(hull)),
            ("amplitude_deg", words::number(swing.amplitude_deg, 0)),
            ("line_length_m", words::number(swing.line_length_m, 2)),
            ("spacing_m", words::number(swing.spacing_m, 2)),
            ("duration_s", words::number(swing.duration_s, 0)),
            ("one", words::word(&format!("id.{one}"))),
            ("other", words::word(&format!("id.{other}"))),
            ("sigma", words::number(swing.sigma, 0)),
        ],
    );
    swing.told(said)
}

struct Design<'a> {
    one: &'a Model<'a>,
    other: &'a Model<'a>,
    at: &'a Point,
    rival: &'a Point,
}

impl Design<'_> {
    /// The swing that all those thought of hang like: the first of the session.
    fn like(&self) -> &Swing {
        self.one.swing(0).setup.swing
    }

    /// How well a swing would tell the two apart: a swing like the first of the session with other
    /// lines and another start.
    fn swing(&self, release: &Release) -> Result<NextSwing> {
        let Release {
            length,
            spacing,
            angle_deg,
            excited,
            tilt_deg,
        } = *release;
        const S: usize = 0;
        let (like, index) = (self.like(), self.one.swing(S).setup.index);
        let changed = |point: &Point| {
            let mut there = point.clone();
            let mut scale =
                |i: Option<usize>, by: f64| i.into_iter().for_each(|i| there.x[i] *= by);
            scale(index.line_length, length);
            scale(index.spacing, spacing);
            if index.top_spacing != index.spacing {
                scale(index.top_spacing, spacing);
            }
            if tilt_deg != 0.0 {
                let (from, to) = (
                    there.x[index.pitch_deg],
                    there.x[index.pitch_deg] + tilt_deg,
                );
                there.x[index.pitch_deg] = to;
                // Moved along the deck until the centre hangs below them, the points lie 1/cos of
                // the tilt above it.
                there.x[index.log_depth] += (from.to_radians().cos() / to.to_radians().cos()).ln();
            }
            let angle = angle_deg.to_radians();
            let line_m = index.line_length.map_or(1.0, |i| there.x[i]);
            let own = &mut there.owns[S];
            own[place::START].fill(0.0);
            for motion in excited {
                match motion {
                    Motion::Yaw => own[place::YAW] = angle,
                    Motion::Along => own[place::ALONG] = angle * line_m,
                    Motion::Turn => own[place::TURN_ABOUT] = angle,
                }
            }
            there
        };
        let (mine, theirs) = (changed(self.at), changed(self.rival));
        let difference = DVector::from_vec(self.other.read_rows(&theirs, S)?)
            - DVector::from_vec(self.one.read_rows(&mine, S)?);
        let jacobian = self.one.jacobian(&mine, S)?;
        let sigma = self.left(&jacobian, &difference, &mine);
        Ok(NextSwing {
            like: like.id.clone(),
            line_length_m: index.line_length.map_or(f64::NAN, |i| mine.x[i]),
            spacing_m: index.spacing.map_or(f64::NAN, |i| mine.x[i]),
            excited: excited
                .iter()
                .map(|motion| motion.excitation(like.suspension.orientation))
                .collect(),
            amplitude_deg: angle_deg,
            duration_s: self.one.swing(S).samples.duration_s,
            hull_pitch_deg: mine.x[index.pitch_deg],
            sigma,
            message: Message::default(),
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
        let taken = matrix
            .cholesky()
            .map_or(0.0, |factor| pull.dot(&factor.solve(&pull)));
        (difference.norm_squared() - taken).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Lines one behind the other: along them the hull surges, about them it rolls.
    #[test]
    fn an_operator_is_told_the_motion_of_the_hull() {
        let all = [Motion::Yaw, Motion::Along, Motion::Turn];
        let told = |orientation| all.map(|motion| motion.excitation(orientation));
        assert_eq!(
            told(Orientation::Athwartships),
            [Excitation::Yaw, Excitation::Sway, Excitation::Pitch]
        );
        assert_eq!(
            told(Orientation::ForeAndAft),
            [Excitation::Yaw, Excitation::Surge, Excitation::Roll]
        );
    }
}
