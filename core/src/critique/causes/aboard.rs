//! What moves inside the hull.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
use std::sync::Arc;

use crate::dynamics::Experiment;
use crate::error::Result;

use super::super::point::{Cause, CauseParameter, Form, LookAlike};
use super::{Scales, UNKNOWN, add, cause, logarithm, number, put, strength};

/// Name in the contract.
pub const INTERNAL_MOTION: &str = "internal_motion";
/// Frequencies tried, as shares of the way (by logarithm) from the slowest motion of the hull to four times the fastest.
const TRIED: [f64; 7] = [0.02, 0.16, 0.32, 0.48, 0.64, 0.8, 0.95];

/// A level slide at several frequencies.
pub fn causes(scales: &Scales) -> Vec<Cause> {
    let span = (4.0 * scales.fastest_rad_s / scales.slowest_rad_s).ln();
    let hz = |share: f64| scales.slowest_rad_s * (share * span).exp() / TAU;
    TRIED.map(|share| internal_motion(scales, hz(share))).to_vec()
}

/// The same at frequencies where something is left: what rings from its own start shows sharply there, whatever drives it.
pub fn ringing(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    frequencies_hz.iter().map(|hz| ringing_at(scales, *hz)).collect()
}

/// Both.
pub fn moving(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    [causes(scales), ringing(scales, frequencies_hz)].concat()
}

/// The same beside one that was taken: not a cause with a name of its own, since one that moves in more ways than one is not known.
pub fn seconds(scales: &Scales, frequencies_hz: &[f64]) -> Vec<Cause> {
    moving(scales, frequencies_hz)
        .into_iter()
        .map(|cause| Cause { id: UNKNOWN, form: Form::Second, ..cause })
        .collect()
}

/// Damping ratio from which a fit begins.
const DAMPING_RATIO: f64 = 0.06;
/// The same of one that rings.
const RINGING_DAMPING_RATIO: f64 = 0.02;
/// Share of the hull that a first look sees ring, and from which a fit begins.
const RINGING_SHARE: f64 = 1e-3;
/// Where a thing is when a recording begins, times its share of the hull, m, and its speed so, m/s: what shows of it is in proportion to
/// both together, whatever it weighs.
const START_M: f64 = 3e-3;
/// What is aboard is no further from where it is looked for than so many widths of its priors: one and a half times half the hull's length
/// fore and aft. Far outside a light thing does by its lever what a heavy one does aboard, and fits stay there.
const ABOARD: f64 = 3.0;
/// Places of the look's slides, shares of half the hull's length.
const FORE: f64 = 0.5;

fn internal_motion(scales: &Scales, frequency_hz: f64) -> Cause {
    let half_m = scales.half_length_m;
    let look =
        LookAlike { cause: slides(scales, frequency_hz), nearest: Box::new(move |w| one_slide(w, half_m)) };
    seen_by(scales, (frequency_hz, DAMPING_RATIO), look)
}

fn ringing_at(scales: &Scales, frequency_hz: f64) -> Cause {
    let look = LookAlike { cause: rings(scales, frequency_hz), nearest: Box::new(one_ring) };
    seen_by(scales, (frequency_hz, RINGING_DAMPING_RATIO), look)
}

/// A mass on a spring, its frequency and damping ratio where its fit begins, and what a first look sees of it.
fn seen_by(scales: &Scales, (frequency_hz, damping_ratio): (f64, f64), look: LookAlike) -> Cause {
    let (half_m, depth_m) = (scales.half_length_m, scales.depth_m);
    let of_start = |name, unit| CauseParameter {
        of_swing: true,
        factor: scales.mass_kg,
        ..number(name, unit, 0.0, START_M)
    };
    let aboard = |name, mean: f64, u: f64| CauseParameter {
        limits: (mean - ABOARD * u, mean + ABOARD * u),
        ..number(name, "m", mean, u)
    };
    let parameters = vec![
        strength("mass_kg", "kg", scales.mass_kg, 0.01),
        logarithm("frequency_hz", "Hz", frequency_hz, 0.4),
        logarithm("damping_ratio", "1", damping_ratio, 1.0),
        number("direction_rad", "rad", 0.0, 1.6),
        aboard("place_x_m", 0.0, 0.5 * half_m),
        aboard("place_y_m", 0.0, 0.2 * half_m),
        aboard("place_z_m", -depth_m, depth_m.max(0.3 * half_m)),
        of_start("start_kg_m", "kg m"),
        of_start("start_kg_m_s", "kg m/s"),
    ];
    let law = put(move |q, _, e| {
        let omega_rad_s = TAU * q[1].clamp(-4.0, 3.0).exp();
        let share = q[0].clamp(1e-9, 0.3);
        let slide = Slide {
            share,
            omega_rad_s,
            damping_ratio: q[2].clamp(-7.0, 0.5).exp(),
            direction_rad: q[3],
            place_m: [q[4], q[5], q[6]],
            start: start([q[7], q[8]], share, omega_rad_s, half_m),
        };
        slide.put(e)
    });
    Cause { one_sided: true, look: Some(Arc::new(look)), ..cause(INTERNAL_MOTION, parameters, law) }
}

/// Where a thing is and how fast at the start, from both times its share of the hull's mass. Nothing moves further than half the hull's
/// length: a share of next to nothing would start from beyond all bounds.
fn start(by_share: [f64; 2], share: f64, omega_rad_s: f64, half_m: f64) -> [f64; 2] {
    let start = by_share.map(|v| v / share);
    let reach_m = start[0].hypot(start[1] / omega_rad_s);
    start.map(|v| v * (half_m / reach_m).min(1.0))
}

/// A mass on a spring along a level way in the hull.
struct Slide {
    /// Of the hull's mass.
    share: f64,
    omega_rad_s: f64,
    damping_ratio: f64,
    direction_rad: f64,
    place_m: [f64; 3],
    start: [f64; 2],
}

impl Slide {
    fn put(&self, e: &mut Experiment) -> Result<()> {
        let numbers = [
            ("mass_kg", self.share),
            ("place_x_m", self.place_m[0]),
            ("place_y_m", self.place_m[1]),
            ("place_z_m", self.place_m[2]),
            ("along_x", self.direction_rad.cos()),
            ("along_y", self.direction_rad.sin()),
            ("stiffness_n_m", self.share * self.omega_rad_s * self.omega_rad_s),
            ("damping_n_s_m", 2.0 * self.damping_ratio * self.share * self.omega_rad_s),
            ("start_m", self.start[0]),
            ("start_m_s", self.start[1]),
        ];
        add(e, "internal_motion", &numbers)
    }
}

/// What a first look sees: slides fore and aft, athwartships and half-way between, each in the fore and in the after part.
/// Any slide along a level way at any place along the hull is a sum of them.
fn slides(scales: &Scales, frequency_hz: f64) -> Cause {
    let (half_m, depth_m) = (scales.half_length_m, scales.depth_m);
    let parameters = (0..6).map(|_| strength("mass_kg", "kg", scales.mass_kg, 0.01)).collect();
    let law = put(move |q, _, e| {
        for (k, share) in q.iter().enumerate().filter(|(_, share)| **share > 0.0) {
            let side = if k % 2 == 0 { FORE } else { -FORE };
            Slide {
                share: *share,
                omega_rad_s: TAU * frequency_hz,
                damping_ratio: DAMPING_RATIO,
                direction_rad: [0.0, FRAC_PI_2, FRAC_PI_4][k / 2],
                place_m: [side * half_m, 0.0, -depth_m],
                start: [0.0; 2],
            }
            .put(e)?;
        }
        Ok(())
    });
    cause(INTERNAL_MOTION, parameters, law)
}

/// What a first look sees of one that rings: in each swing, along the hull and across, from a place and from a speed.
fn rings(scales: &Scales, frequency_hz: f64) -> Cause {
    let depth_m = scales.depth_m;
    let starts = ["along_m", "along_m_s", "across_m", "across_m_s"];
    let parameters =
        starts.map(|name| CauseParameter { of_swing: true, ..strength(name, "m", 1.0, START_M) });
    let law = put(move |q, _, e| {
        for (start, direction_rad) in q.chunks(2).zip([0.0, FRAC_PI_2]) {
            Slide {
                share: RINGING_SHARE,
                omega_rad_s: TAU * frequency_hz,
                damping_ratio: RINGING_DAMPING_RATIO,
                direction_rad,
                place_m: [0.0, 0.0, -depth_m],
                start: [start[0] / RINGING_SHARE, start[1] / RINGING_SHARE],
            }
            .put(e)?;
        }
        Ok(())
    });
    cause(INTERNAL_MOTION, parameters.to_vec(), law)
}

/// The one slide nearest to what rings in all swings: the way along which most of it goes.
fn one_ring(w: &[f64]) -> Option<Vec<f64>> {
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for swing in w.chunks(4) {
        xx += swing[0] * swing[0] + swing[1] * swing[1];
        yy += swing[2] * swing[2] + swing[3] * swing[3];
        xy += swing[0] * swing[2] + swing[1] * swing[3];
    }
    let direction_rad = 0.5 * (2.0 * xy).atan2(xx - yy);
    let (sin, cos) = direction_rad.sin_cos();
    let along = w.chunks(4).flat_map(|s| [cos * s[0] + sin * s[2], cos * s[1] + sin * s[3]]);
    let of_session = [RINGING_SHARE, f64::NAN, f64::NAN, direction_rad, f64::NAN, f64::NAN, f64::NAN];
    Some(of_session.into_iter().chain(along).collect())
}

/// The slide nearest to such a sum.
///
/// The response to a slide along (cos φ, sin φ) is that of cos² φ along x, sin² φ along y and sin φ cos φ across; half-way
/// between, all three are a half.
fn one_slide(w: &[f64], half_m: f64) -> Option<Vec<f64>> {
    let both = |k: usize| (w[2 * k] + w[2 * k + 1], FORE * half_m * (w[2 * k] - w[2 * k + 1]));
    let ((x, moment_x), (y, moment_y), (d, moment_d)) = (both(0), both(1), both(2));
    let (xx, yy, xy) = (x + 0.5 * d, y + 0.5 * d, 0.5 * d);
    let share = xx + yy;
    if share <= 0.0 {
        return None;
    }
    let direction_rad = 0.5 * (2.0 * xy).atan2(xx - yy);
    let place_m = ((moment_x + moment_y + moment_d) / share).clamp(-half_m, half_m);
    // Frequency and damping stay where the look has them.
    let frequency_and_damping = [f64::NAN; 2];
    Some([&[share][..], &frequency_and_damping, &[direction_rad, place_m]].concat())
}

#[cfg(test)]
mod tests {
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

    #[test]
    fn a_light_thing_starts_aboard() {
        // As far as given: 2 mm of the hull are 0.2 m of a hundredth of it.
        let near = start([2e-3, 4e-3], 0.01, 2.0, 1.4);
        assert!((near[0] - 0.2).abs() < 1e-15 && (near[1] - 0.4).abs() < 1e-15, "{near:?}");
        // 2 m and 4 m/s at 2 rad/s reach 2 sqrt 2 m: what is left of them reaches 1.4 m.
        let far = start([2e-3, 4e-3], 1e-3, 2.0, 1.4);
        assert!((far[0].hypot(far[1] / 2.0) - 1.4).abs() < 1e-12 && (far[1] - 2.0 * far[0]).abs() < 1e-12);
        assert_eq!(start([0.0, 0.0], 1e-9, 2.0, 1.4), [0.0, 0.0]);
    }

    #[test]
    fn what_moves_inside_weighs_something_and_is_aboard() {
        for cause in moving(&HULL, &[0.5]) {
            let limits = cause.limits(2);
            let of = |name: &str| {
                let k = cause.expanded(2).iter().position(|(p, _)| p.name == name).unwrap();
                limits[k]
            };
            assert_eq!(of("mass_kg"), (0.0, f64::INFINITY));
            assert_eq!(of("start_kg_m"), (f64::NEG_INFINITY, f64::INFINITY));
            // Three widths, of half of half the length, a fifth of it, and of the depth or 0.3 of it.
            let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() < 1e-9;
            assert!(near(of("place_x_m"), (-2.1, 2.1)) && near(of("place_y_m"), (-0.84, 0.84)));
            assert!(near(of("place_z_m"), (-0.3 - 1.26, -0.3 + 1.26)), "{:?}", of("place_z_m"));
        }
    }
}
