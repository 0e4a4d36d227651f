//! The motion in one angle against closed forms.

use std::f64::consts::{PI, TAU};

use gyradius_mechanics::one_angle::effects::{
    Acts, AmplitudeAddedMass, AnyEffect, BearingFriction, Jet, Polynomial, PowerLawDamping,
    PreslidingBearing, QuadraticDrag, RestoringForce, ScaleError, Scales, Swinging, ZeroDrift,
};
use gyradius_mechanics::one_angle::{Law, Now, Torque, TwoLines, follow};
use gyradius_mechanics::{Dual, Real};

/// A law with linear damping (1/s) and dry friction (rad/s²).
struct Braked<R> {
    law: Law,
    omega_rad_s: R,
    damping_per_s: R,
    friction_rad_s2: R,
}

impl<R: Real> Torque<R> for Braked<R> {
    fn acceleration(&self, now: &Now<R>) -> R {
        let (torque, inertia) = self.law.at(self.omega_rad_s, now.angle_rad, now.rate_rad_s);
        let damping = (self.damping_per_s * now.rate_rad_s).scale(2.0);
        (torque - damping - self.friction_rad_s2.scale(now.sense)) / inertia
    }
}

fn free(law: Law, omega_rad_s: f64) -> Braked<f64> {
    Braked {
        law,
        omega_rad_s,
        damping_per_s: 0.0,
        friction_rad_s2: 0.0,
    }
}

/// From rest at an angle over `cycles` periods: the angle then.
fn after(law: Law, angle_rad: f64, period_s: f64, cycles: f64) -> f64 {
    let times = [cycles * period_s];
    let motion = follow(&free(law, TAU), Now::start(angle_rad, 0.0), TAU, &times);
    motion.map_or(f64::NAN, |motion| motion[0][0])
}

/// A pendulum of 1 s comes back to where it was after 2 K(sin A/2)/π seconds (scipy,
/// `2*ellipk(sin(A/2)**2)/pi`).
#[test]
fn a_pendulum_has_the_period_of_its_amplitude() {
    for (angle_rad, period_s) in [
        (0.1, 1.0006253583077365),
        (1.0, 1.0663342455799631),
        (1.66, 1.205612467373184),
        (2.8, 2.0208040775981706),
    ] {
        for cycles in [1.0, 20.0] {
            let off = after(Law::Pendulum, angle_rad, period_s, cycles) - angle_rad;
            assert!(off.abs() < 1e-6 * angle_rad, "{angle_rad}: {off}");
        }
    }
}

/// Small yaw on two lines is that of a spring; the bound is the third power of the angle.
#[test]
fn two_lines_hold_small_turns_as_a_spring() {
    let lines = Law::TwoLines(TwoLines::new([0.6, 0.6], 1.0, 9.81));
    let off = after(lines, 1e-4, 1.0, 5.25);
    assert!(off.abs() < 5e-10, "{off}");
    assert!((after(lines, 1e-4, 1.0, 5.0) - 1e-4).abs() < 5e-10);
}

/// Dry friction on a spring: half cycles are cosines about ±d, d = c/ω², so that in the half cycle n
/// θ = (A − (2n + 1) d) cos ωt + (−1)ⁿ d; the derivatives follow, those across the turns among them.
#[test]
fn dry_friction_takes_as_much_of_each_half_cycle() {
    let (omega, angle, d) = (TAU, 0.2, 0.004);
    let c = d * omega * omega;
    let times: Vec<f64> = (1..400).map(|i| 0.0257 * f64::from(i)).collect();
    let braked = Braked {
        law: Law::Linear,
        omega_rad_s: Dual::<3>::parameter(omega, 0),
        damping_per_s: Dual::constant(0.0),
        friction_rad_s2: Dual::parameter(c, 1),
    };
    let start = Now::start(Dual::parameter(angle, 2), Dual::constant(0.0));
    // Turns fall between two steps, where the jump of 2 c in the acceleration is interpolated; by ω
    // they move by t/ω, and what is interpolated with them.
    let step_s = 1.0 / (1.03 * 128.0);
    let jump = 2.0 * c * step_s * step_s / 16.0;
    let moved = 2.0 * c * step_s / (4.0 * omega);
    let motion = follow(&braked, start, 1.03 * omega, &times).unwrap_or_default();
    assert_eq!(motion.len(), times.len());
    for (t, [now, _]) in times.iter().zip(&motion) {
        let half = (t * omega / PI).floor();
        let (sin, cos) = (omega * t).sin_cos();
        let (odd, sense) = (2.0 * half + 1.0, if half % 2.0 == 0.0 { 1.0 } else { -1.0 });
        if angle - odd * d < d {
            // Friction holds it there for good.
            let rest = angle - (2.0 * half) * d;
            assert!(now.value().abs() <= rest.abs().max(2.0 * d), "{t}: {now:?}");
            continue;
        }
        let size = angle - odd * d;
        let error = (now.value() - size * cos - sense * d).abs();
        assert!(error < jump + 2e-7, "{t}: {error}");
        // By c at fixed ω; by ω, where d = c/ω² moves too; by A.
        let by_d = sense - odd * cos;
        let slopes = [
            -size * t * sin - 2.0 * d / omega * by_d,
            by_d / (omega * omega),
            cos,
        ];
        for (slope, expected) in now.slopes().iter().zip(slopes) {
            let off = (slope - expected).abs();
            assert!(
                off < moved * t + 2e-5 * (1.0 + expected.abs()),
                "{t}: {slope} {expected}"
            );
        }
    }
}

/// Linear damping on a spring: θ = A e^(−αt) (cos ω_d t + α/ω_d sin ω_d t).
#[test]
fn a_damped_spring_dies_away() {
    let (omega, alpha) = (TAU, 0.2 * TAU);
    let braked = Braked {
        damping_per_s: alpha,
        ..free(Law::Linear, omega)
    };
    let times: Vec<f64> = (0..300).map(|i| 0.01 * f64::from(i)).collect();
    let motion = follow(&braked, Now::start(1.0, 0.0), omega, &times).unwrap_or_default();
    let damped = (omega * omega - alpha * alpha).sqrt();
    for (t, [now, _]) in times.iter().zip(motion) {
        let (sin, cos) = (damped * t).sin_cos();
        let expected = (-alpha * t).exp() * (cos + alpha / damped * sin);
        assert!((now - expected).abs() < 1e-7, "{t}: {now} {expected}");
    }
}

/// Readings of a pendulum from 0.6 rad with an effect, at every 0.1 s of 10 s.
fn with_effect<R: Real>(effect: &AnyEffect, numbers: &[R]) -> Vec<R>
where
    AnyEffect: Acts<R>,
{
    let swinging = Swinging {
        law: Law::Pendulum,
        scales: Scales {
            omega_rad_s: TAU,
            reach_rad: 0.6,
        },
        omega_rad_s: R::constant(TAU),
        damping_per_s: R::constant(0.05),
        effects: vec![(effect, numbers)],
    };
    let times: Vec<f64> = (1..=100).map(|i| 0.1 * f64::from(i)).collect();
    let start = [R::constant(0.6), R::constant(0.0)];
    let mut all = Vec::new();
    let done = swinging.readings(start, false, &times, |_, reading| all.push(reading));
    assert!(done.is_some());
    all
}

/// Derivatives by every number of every effect against central differences.
#[test]
fn every_effect_carries_the_derivatives_of_its_motion() {
    let terms = vec![[2, 0, 0], [0, 3, 0], [1, 2, 0], [3, 0, 0], [0, 1, 1]];
    let effects: [(&AnyEffect, &[f64]); 9] = [
        (&QuadraticDrag, &[0.01]),
        (&PowerLawDamping, &[0.01, 0.4]),
        (&BearingFriction, &[0.005]),
        (&PreslidingBearing, &[0.01, -4.0]),
        (&AmplitudeAddedMass, &[0.02]),
        (&RestoringForce, &[0.3]),
        (&Polynomial { terms }, &[0.01, 0.02, 0.01, -0.02, 0.1]),
        (&ScaleError, &[0.01]),
        (&ZeroDrift { duration_s: 10.0 }, &[0.01]),
    ];
    for (effect, numbers) in effects {
        let jets: Vec<Jet> = (numbers.iter().enumerate())
            .map(|(lane, number)| Jet::parameter(*number, lane))
            .collect();
        let exact = with_effect(effect, &jets);
        for lane in 0..numbers.len() {
            let step = 1e-5;
            let moved = |by: f64| {
                let mut moved = numbers.to_vec();
                moved[lane] += by;
                with_effect(effect, &moved)
            };
            let (more, less) = (moved(step), moved(-step));
            let sizes = exact.iter().map(|reading| reading.slope[lane].abs());
            let largest = sizes.fold(0.0, f64::max);
            for ((reading, more), less) in exact.iter().zip(&more).zip(&less) {
                let off = reading.slope[lane] - (more - less) / (2.0 * step);
                assert!(
                    off.abs() < 1e-3 * largest,
                    "{effect:?} {lane}: {off} of {largest}"
                );
            }
        }
    }
}

/// A force that hardens has the period that its energy gives.
#[test]
fn a_hardening_force_has_its_period() {
    // mpmath, 30 digits: quad of dθ/√(2 (V(A) − V(θ))), V = θ²/2 + κ (1 − cos θ − θ²/2),
    // κ = −3, A = 0.6, over 2π for ω = 2π/s.
    let period_s = 0.9397437869701682;
    let swinging = Swinging {
        law: Law::Linear,
        scales: Scales {
            omega_rad_s: TAU,
            reach_rad: 0.6,
        },
        omega_rad_s: TAU,
        damping_per_s: 0.0,
        effects: vec![(&RestoringForce, &[-3.0][..])],
    };
    let motion = follow(&swinging, Now::start(0.6, 0.0), TAU, &[10.0 * period_s]);
    let off = motion.map_or(f64::NAN, |motion| motion[0][0] - 0.6);
    assert!(off.abs() < 1e-6, "{off}");
}
