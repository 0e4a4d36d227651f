//! What moves inside the hull.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
use std::sync::Arc;

use nalgebra::DVector;

use gyradius_base::error::Result;
use gyradius_mechanics::{Experiment, Jet, Real, is_still};

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterName;
use super::super::point::{Cause, CauseParameter, Form, LookAlike, Nearest, Seen};
use super::super::unit::UnitName;
use super::{Scales, add, cause, clamped, fixed, logarithm, number, put, strength, within};

/// Frequencies tried, as shares of the way (by logarithm) from the slowest motion of the hull to
/// four times the fastest.
const TRIED: [f64; 7] = [0.02, 0.16, 0.32, 0.48, 0.64, 0.8, 0.95];

/// A level slide at several frequencies.
pub fn causes(scales: &Scales) -> Vec<Cause> {
    let span = (4.0 * scales.fastest_rad_s / scales.slowest_rad_s).ln();
    let hz = |share: f64| scales.slowest_rad_s * (share * span).exp() / TAU;
    TRIED
        .map(|share| internal_motion(scales, hz(share)))
        .to_vec()
}

/// The same at frequencies where something is left: what rings from its own start shows sharply
/// there, whatever drives it.
pub fn ringing(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    frequencies_hz
        .iter()
        .map(|hz| ringing_at(scales, *hz))
        .collect()
}

/// Both.
fn moving(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    [causes(scales), ringing(scales, frequencies_hz)].concat()
}

/// The same beside one that was taken: not a cause with a name of its own, since one that moves in
/// more ways than one is not known.
pub fn seconds(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    moving(scales, frequencies_hz)
        .into_iter()
        .map(|cause| Cause {
            id: CauseId::Unknown,
            form: Form::Second,
            ..cause
        })
        .collect()
}

/// Damping ratio from which a fit begins.
const DAMPING_RATIO: f64 = 0.06;
/// The same of one that rings.
const RINGING_DAMPING_RATIO: f64 = 0.02;
/// Share of the hull that a first look sees ring, and from which a fit begins.
const RINGING_SHARE: f64 = 1e-3;
/// Where a thing is when a recording begins, times its share of the hull, m, and its speed so, m/s:
/// what shows of it is in proportion to both together, whatever it weighs.
const START_M: f64 = 3e-3;
/// What moves inside is no further from where it is looked for than so many widths of its priors: one
/// and a half times half the hull's length fore and aft. Far outside a light thing does by its
/// lever what a heavy one does inside, and fits stay there.
const INSIDE: f64 = 3.0;
/// Places of the look's slides, shares of half the hull's length.
const FORE: f64 = 0.5;
/// So many ways round half a turn, and places on either side of the middle, are tried for the slide
/// nearest to them.
const WAYS: i32 = 24;
const PLACES: i32 = 8;

/// The mass of what moves, a share of the hull's.
fn share(scales: &Scales) -> CauseParameter {
    strength(
        ParameterName::MassKg,
        UnitName::Kilogram,
        scales.mass_kg,
        0.01,
    )
}

/// Nothing moves without mass: so little is there always, and does nothing.
const LEAST_SHARE: f64 = 1e-9;

fn internal_motion(scales: &Scales, frequency_hz: f64) -> Cause {
    let half_m = scales.half_length_m;
    let look = LookAlike {
        cause: slides(scales, frequency_hz),
        nearest: Box::new(move |seen| one_slide(seen, half_m)),
    };
    seen_by(scales, (frequency_hz, DAMPING_RATIO), look)
}

fn ringing_at(scales: &Scales, frequency_hz: f64) -> Cause {
    let look = LookAlike {
        cause: rings(scales, frequency_hz),
        nearest: Box::new(one_ring),
    };
    seen_by(scales, (frequency_hz, RINGING_DAMPING_RATIO), look)
}

/// A mass on a spring, its frequency and damping ratio where its fit begins, and what a first look
/// sees of it.
fn seen_by(scales: &Scales, (frequency_hz, damping_ratio): (f64, f64), look: LookAlike) -> Cause {
    let (half_m, depth_m) = (scales.half_length_m, scales.depth_m);
    let of_start = |name, unit| CauseParameter {
        of_swing: true,
        factor: scales.mass_kg,
        ..number(name, unit, 0.0, START_M)
    };
    let inside = |name, mean: f64, u: f64| within(INSIDE, number(name, UnitName::Metre, mean, u));
    let parameters = vec![
        share(scales),
        logarithm(
            ParameterName::FrequencyHz,
            UnitName::Hertz,
            frequency_hz,
            0.4,
        ),
        logarithm(
            ParameterName::DampingRatio,
            UnitName::One,
            damping_ratio,
            1.0,
        ),
        number(ParameterName::DirectionRad, UnitName::Radian, 0.0, 1.6),
        inside(ParameterName::PlaceXM, 0.0, 0.5 * half_m),
        inside(ParameterName::PlaceYM, 0.0, 0.2 * half_m),
        inside(ParameterName::PlaceZM, -depth_m, depth_m.max(0.3 * half_m)),
        of_start(ParameterName::StartKgM, UnitName::KilogramMetre),
        of_start(ParameterName::StartKgMS, UnitName::KilogramMetrePerSecond),
    ];
    let law = put(move |q, _, e| {
        let omega_rad_s = clamped(q[1], -4.0, 3.0).exp() * TAU;
        let share = clamped(q[0], 0.0, 0.3) + LEAST_SHARE;
        let slide = Slide {
            share,
            omega_rad_s,
            damping_ratio: clamped(q[2], -7.0, 0.5).exp(),
            direction_rad: q[3],
            place_m: [q[4], q[5], q[6]],
            start: start([q[7], q[8]], share, omega_rad_s, half_m),
        };
        slide.put(e)
    });
    Cause {
        one_sided: true,
        look: Some(Arc::new(look)),
        ..cause(CauseId::InternalMotion, parameters, law)
    }
}

/// Where a thing is and how fast at the start, from both times its share of the hull's mass.
/// Nothing moves further than half the hull's length: a share of next to nothing would start from
/// beyond all bounds.
fn start(by_share: [Jet; 2], share: Jet, omega_rad_s: Jet, half_m: f64) -> [Jet; 2] {
    let start = by_share.map(|v| v / share);
    let quarter_on = start[1] / omega_rad_s;
    let reach_m = (start[0] * start[0] + quarter_on * quarter_on).sqrt();
    if reach_m.value > half_m {
        start.map(|v| v * half_m / reach_m)
    } else {
        start
    }
}

/// A mass on a spring along a level way in the hull.
struct Slide {
    /// Of the hull's mass.
    share: Jet,
    omega_rad_s: Jet,
    damping_ratio: Jet,
    direction_rad: Jet,
    place_m: [Jet; 3],
    start: [Jet; 2],
}

impl Slide {
    fn put(&self, e: &mut Experiment<Jet>) -> Result<()> {
        let numbers = [
            ("mass_kg", self.share),
            ("place_x_m", self.place_m[0]),
            ("place_y_m", self.place_m[1]),
            ("place_z_m", self.place_m[2]),
            ("along_x", self.direction_rad.cos()),
            ("along_y", self.direction_rad.sin()),
            (
                "stiffness_n_m",
                self.share * self.omega_rad_s * self.omega_rad_s,
            ),
            (
                "damping_n_s_m",
                self.damping_ratio * 2.0 * self.share * self.omega_rad_s,
            ),
            ("start_m", self.start[0]),
            ("start_m_s", self.start[1]),
        ];
        add(e, "internal_motion", &numbers)
    }
}

/// What a first look sees: slides fore and aft, athwartships and half-way between, each in the fore
/// and in the after part. A slide along any level way at their places is a sum of them, and nearly
/// so at any place along the hull.
fn slides(scales: &Scales, frequency_hz: f64) -> Cause {
    let (half_m, depth_m) = (scales.half_length_m, scales.depth_m);
    let parameters = (0..6).map(|_| share(scales)).collect();
    let law = put(move |q, _, e| {
        let is_there = |share: &Jet| share.value > 0.0 || !is_still(*share);
        for (k, share) in q.iter().enumerate().filter(|(_, share)| is_there(share)) {
            let side = if k % 2 == 0 { FORE } else { -FORE };
            Slide {
                share: *share + LEAST_SHARE,
                omega_rad_s: fixed(TAU * frequency_hz),
                damping_ratio: fixed(DAMPING_RATIO),
                direction_rad: fixed([0.0, FRAC_PI_2, FRAC_PI_4][k / 2]),
                place_m: [side * half_m, 0.0, -depth_m].map(fixed),
                start: [fixed(0.0); 2],
            }
            .put(e)?;
        }
        Ok(())
    });
    Cause {
        alone: true,
        ..cause(CauseId::InternalMotion, parameters, law)
    }
}

/// What a first look sees of one that rings: in each swing, along the hull and across, from a place
/// and from a speed.
fn rings(scales: &Scales, frequency_hz: f64) -> Cause {
    let depth_m = scales.depth_m;
    let starts = [
        ParameterName::AlongM,
        ParameterName::AlongMS,
        ParameterName::AcrossM,
        ParameterName::AcrossMS,
    ];
    let parameters = starts.map(|name| CauseParameter {
        of_swing: true,
        ..strength(name, UnitName::Metre, 1.0, START_M)
    });
    let law = put(move |q, _, e| {
        for (start, direction_rad) in q.chunks(2).zip([0.0, FRAC_PI_2]) {
            Slide {
                share: fixed(RINGING_SHARE),
                omega_rad_s: fixed(TAU * frequency_hz),
                damping_ratio: fixed(RINGING_DAMPING_RATIO),
                direction_rad: fixed(direction_rad),
                place_m: [0.0, 0.0, -depth_m].map(fixed),
                start: [start[0], start[1]].map(|start| start * RINGING_SHARE.recip()),
            }
            .put(e)?;
        }
        Ok(())
    });
    Cause {
        alone: true,
        ..cause(CauseId::InternalMotion, parameters.to_vec(), law)
    }
}

/// The one slide nearest to what rings in all swings: the way along which most of it goes.
fn one_ring(seen: &Seen) -> Option<Nearest> {
    let w = seen.strengths.as_slice();
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for swing in w.chunks(4) {
        xx += swing[0] * swing[0] + swing[1] * swing[1];
        yy += swing[2] * swing[2] + swing[3] * swing[3];
        xy += swing[0] * swing[2] + swing[1] * swing[3];
    }
    let direction_rad = 0.5 * (2.0 * xy).atan2(xx - yy);
    let (sin, cos) = direction_rad.sin_cos();
    let along: Vec<f64> = w
        .chunks(4)
        .flat_map(|s| [cos * s[0] + sin * s[2], cos * s[1] + sin * s[3]])
        .collect();
    let ways = along
        .chunks(2)
        .flat_map(|s| [cos * s[0], cos * s[1], sin * s[0], sin * s[1]]);
    let strengths = DVector::from_iterator(w.len(), ways);
    let of_session = [
        RINGING_SHARE,
        f64::NAN,
        f64::NAN,
        direction_rad,
        f64::NAN,
        f64::NAN,
        f64::NAN,
    ];
    Some(Nearest {
        strengths,
        parameters: of_session.into_iter().chain(along).collect(),
    })
}

/// The slide that gains most of what such a sum does; none where a mass gains nothing anywhere.
/// (The sum itself may well have masses below nothing: above what drives it a slide goes along as
/// if it belonged to the hull, and little of it is left to be seen.)
fn one_slide(seen: &Seen, half_m: f64) -> Option<Nearest> {
    let ways = (0..WAYS).map(|k| PI * k as f64 / WAYS as f64);
    let tried = ways.flat_map(|direction_rad| {
        (-PLACES..=PLACES).map(move |k| (direction_rad, half_m * k as f64 / PLACES as f64))
    });
    let all = tried.map(|(direction_rad, place_m)| {
        let way = as_slides(direction_rad, place_m / (FORE * half_m));
        let (share, gain) = seen.along(&way);
        (
            gain,
            way * share,
            vec![share, f64::NAN, f64::NAN, direction_rad, place_m],
        )
    });
    let (gain, strengths, parameters) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (gain > 0.0).then_some(Nearest {
        strengths,
        parameters,
    })
}

/// A slide along a level way at a place, in units of that of the fore slides, as a sum of the
/// look's.
///
/// The response to one along (cos φ, sin φ) is that of cos² φ along x, sin² φ along y and sin φ cos
/// φ across; half-way between, all three are a half.
fn as_slides(direction_rad: f64, place: f64) -> DVector<f64> {
    let (sin, cos) = direction_rad.sin_cos();
    let ways = [cos * (cos - sin), sin * (sin - cos), 2.0 * sin * cos];
    DVector::from_iterator(
        6,
        ways.into_iter()
            .flat_map(|w| [0.5 * w * (1.0 + place), 0.5 * w * (1.0 - place)]),
    )
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    const HULL: Scales = Scales {
        mass_kg: 50.0,
        gyradii2_m2: [0.1, 0.5, 0.6],
        depth_m: 0.3,
        line_m: 2.0,
        spacing_m: 1.0,
        gravity_m_s2: 9.81,
        yaw_rad_s: 1.5,
        slowest_rad_s: 1.5,
        fastest_rad_s: 3.0,
        pitches: true,
        half_length_m: 1.4,
    };

    /// A light thing on a spring drives the hull by the product of how each of the hull's motions
    /// (surge, sway, roll, pitch, yaw) moves its place along its way with how its pull drives each
    /// of them.
    fn drives(direction_rad: f64, place: f64, depth: f64) -> DMatrix<f64> {
        let (sin, cos) = direction_rad.sin_cos();
        let moves = DVector::from_vec(vec![cos, sin, -depth * sin, depth * cos, place * sin]);
        &moves * moves.transpose()
    }

    #[test]
    fn a_slide_is_a_sum_of_the_look_s() {
        for (direction_rad, place) in [(0.0, 0.3), (2.1, -1.0), (1.0, 1.0), (0.6, 1.7)] {
            let sum = as_slides(direction_rad, place).iter().enumerate().fold(
                DMatrix::zeros(5, 5),
                |sum: DMatrix<f64>, (k, w)| {
                    let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                    sum + drives([0.0, FRAC_PI_2, FRAC_PI_4][k / 2], side, 0.4) * *w
                },
            );
            let mut expected = drives(direction_rad, place, 0.4);
            // Of turns about the hull's middle driven by themselves the look's slides show what
            // those at their places do.
            expected[(4, 4)] = direction_rad.sin().powi(2);
            assert!((sum - expected).amax() < 1e-14, "{direction_rad} {place}");
        }
    }

    /// Where the data are those of a slide, whatever they say of each strength, no other gains as
    /// much (Cauchy and Schwarz), not even if masses stand out so little that their sum is seen to
    /// be below nothing.
    #[test]
    fn the_slide_that_gains_most_is_the_one_that_is_there() {
        let (direction_rad, place_m, share) = (PI * 17.0 / 24.0, -0.875 * 1.4, 3e-3);
        let way = as_slides(direction_rad, place_m / (FORE * 1.4));
        let rows = DMatrix::from_fn(9, 6, |i, k| ((3 + i * i + 5 * k * i + k) as f64).sin());
        let information = rows.tr_mul(&rows);
        let score = &information * &way * share;
        let strengths = DVector::from_element(6, -1e-3);
        let found = one_slide(
            &Seen {
                strengths,
                information,
                score,
            },
            1.4,
        )
        .unwrap();
        let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * b.abs();
        assert!(close(found.parameters[0], share), "{:?}", found.parameters);
        assert!(close(found.parameters[3], direction_rad) && close(found.parameters[4], place_m));
        assert!((found.strengths - way * share).amax() < 1e-12);
    }

    #[test]
    fn a_light_thing_starts_inside_the_hull() {
        // As far as given: 2 mm of the hull are 0.2 m of a hundredth of it.
        let start = |by_share: [f64; 2], share: f64| {
            let start = start(by_share.map(fixed), fixed(share), fixed(2.0), 1.4);
            start.map(|part| part.value)
        };
        let near = start([2e-3, 4e-3], 0.01);
        assert!(
            (near[0] - 0.2).abs() < 1e-15 && (near[1] - 0.4).abs() < 1e-15,
            "{near:?}"
        );
        // 2 m and 4 m/s at 2 rad/s reach 2 sqrt 2 m: what is left of them reaches 1.4 m.
        let far = start([2e-3, 4e-3], 1e-3);
        assert!(
            (far[0].hypot(far[1] / 2.0) - 1.4).abs() < 1e-12
                && (far[1] - 2.0 * far[0]).abs() < 1e-12
        );
        assert_eq!(start([0.0, 0.0], 1e-9), [0.0, 0.0]);
    }

    #[test]
    fn what_moves_inside_weighs_something_and_is_in_the_hull() {
        for cause in moving(&HULL, &[0.5]) {
            let limits = cause.limits(2);
            let of = |name: ParameterName| {
                let k = cause
                    .expanded(2)
                    .iter()
                    .position(|(p, _)| p.name == name)
                    .unwrap();
                limits[k]
            };
            assert_eq!(of(ParameterName::MassKg), (0.0, f64::INFINITY));
            assert_eq!(
                of(ParameterName::StartKgM),
                (f64::NEG_INFINITY, f64::INFINITY)
            );
            // Three widths, of half of half the length, a fifth of it, and of the depth or 0.3 of
            // it.
            let near =
                |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() < 1e-9;
            assert!(
                near(of(ParameterName::PlaceXM), (-2.1, 2.1))
                    && near(of(ParameterName::PlaceYM), (-0.84, 0.84))
            );
            assert!(
                near(of(ParameterName::PlaceZM), (-0.3 - 1.26, -0.3 + 1.26)),
                "{:?}",
                of(ParameterName::PlaceZM)
            );
        }
    }
}
