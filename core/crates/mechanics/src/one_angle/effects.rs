//! What else moves a body in one angle, and what a sensor makes of it: each effect a few numbers,
//! written once over numbers with and without derivatives.
//!
//! # Conventions
//! Strengths are shares: of the torque of critical damping at the fastest rate, 2 ω (ω A), of the
//! restoring force ω² A, or of the inertia, at the widest angle A of the swing ([`Scales`]). All
//! torques are over the moment of inertia, rad/s².

use std::fmt::Debug;

use super::law::Law;
use super::motion::{Now, Torque, follow_each};
use crate::real::{Dual, Real};

/// A number with derivatives by so many parameters at a time.
pub const LANES: usize = 8;
/// A number with its derivatives.
pub type Jet = Dual<LANES>;

/// What scales the strengths in a swing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Angular frequency of small swings, rad/s.
    pub omega_rad_s: f64,
    /// Widest angle, rad.
    pub reach_rad: f64,
}

impl Scales {
    /// Fastest rate, rad/s.
    pub fn rate_rad_s(&self) -> f64 {
        self.omega_rad_s * self.reach_rad
    }

    /// Torque over inertia of critical damping at the fastest rate, rad/s².
    pub fn critical_rad_s2(&self) -> f64 {
        2.0 * self.omega_rad_s * self.rate_rad_s()
    }

    /// The restoring force at the widest angle, over inertia, rad/s².
    pub fn restoring_rad_s2(&self) -> f64 {
        self.omega_rad_s * self.rate_rad_s()
    }
}

/// The body at a moment, and what it is held against.
#[derive(Debug, Clone, Copy)]
pub struct At<'a, R> {
    /// The body.
    pub now: &'a Now<R>,
    /// What strengths are shares of.
    pub scales: &'a Scales,
    /// Angular frequency of small swings as it is fitted, rad/s.
    pub omega_rad_s: R,
}

impl<R: Real> At<'_, R> {
    /// Angle over the widest.
    fn x(&self) -> R {
        self.now.angle_rad.scale(1.0 / self.scales.reach_rad)
    }

    /// Rate over the fastest.
    fn v(&self) -> R {
        self.now.rate_rad_s.scale(1.0 / self.scales.rate_rad_s())
    }
}

/// What an effect of the numbers `q` does.
pub trait Acts<R: Real> {
    /// Torque over inertia, rad/s².
    fn torque(&self, _q: &[R], _at: &At<R>) -> R {
        R::zero()
    }

    /// Share of the inertia that comes along.
    fn added_inertia(&self, _q: &[R], _at: &At<R>) -> R {
        R::zero()
    }

    /// Angle over which a bearing gives, rad, where it does.
    fn give_rad(&self, _q: &[R]) -> Option<R> {
        None
    }

    /// What the sensor reads at a time, s, of a turn (rad or rad/s).
    fn reading(&self, _q: &[R], _t_s: f64, turn: R) -> R {
        turn
    }
}

/// An effect on plain numbers and on such with derivatives.
pub trait Effect: Acts<f64> + Acts<Jet> + Debug + Send + Sync {}
impl<E: Acts<f64> + Acts<Jet> + Debug + Send + Sync> Effect for E {}

/// Any effect.
pub type AnyEffect = dyn Effect;

/// A drag with the square of the rate: −q v |v|; one number.
#[derive(Debug)]
pub struct QuadraticDrag;

impl<R: Real> Acts<R> for QuadraticDrag {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        let v = at.v();
        (q[0] * v * v).scale(-at.now.sense * at.scales.critical_rad_s2())
    }
}

/// A damping with a power of the rate: −q |v|^(1 + β) sgn v; its numbers are q and β > −1.
#[derive(Debug)]
pub struct PowerLawDamping;

impl<R: Real> Acts<R> for PowerLawDamping {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        let v = at.v().abs();
        if v.value() <= 0.0 {
            return R::zero();
        }
        let power = ((R::one() + q[1]) * v.ln()).exp();
        (q[0] * power).scale(-at.now.sense * at.scales.critical_rad_s2())
    }
}

/// Dry friction: −q sgn v; one number.
#[derive(Debug)]
pub struct BearingFriction;

impl<R: Real> Acts<R> for BearingFriction {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        q[0].scale(-at.now.sense * at.scales.critical_rad_s2())
    }
}

/// A bearing that springs before it slides: −q z, z' = (θ' − |θ'| z)/θ_s (Dahl); its numbers are q
/// and ln θ_s.
#[derive(Debug)]
pub struct PreslidingBearing;

impl<R: Real> Acts<R> for PreslidingBearing {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        (q[0] * at.now.given).scale(-at.scales.critical_rad_s2())
    }

    fn give_rad(&self, q: &[R]) -> Option<R> {
        Some(q[1].exp())
    }
}

/// Inertia that grows with the amplitude A: (1 + q A) θ'' = …, A² = x² + v²; one number.
#[derive(Debug)]
pub struct AmplitudeAddedMass;

impl<R: Real> Acts<R> for AmplitudeAddedMass {
    fn added_inertia(&self, q: &[R], at: &At<R>) -> R {
        let (x, v) = (at.x(), at.v());
        q[0] * (x * x + v * v).sqrt()
    }
}

/// A restoring torque that is softer at wide angles (κ > 0) or harder: −ω² κ (sin θ − θ). κ = 1 makes
/// a spring a pendulum. One number.
#[derive(Debug)]
pub struct RestoringForce;

impl<R: Real> Acts<R> for RestoringForce {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        let angle = at.now.angle_rad;
        -(at.omega_rad_s * at.omega_rad_s * q[0] * (angle.sin() - angle))
    }
}

/// Time over which terms of a force that grow reach their coefficient, s.
pub const GROWTH_S: f64 = 100.0;

/// Exponents of a force of unknown form are below this.
pub const MOST_POWER: usize = 6;

/// A force of unknown form: −Σ q x^i v^j (t/[`GROWTH_S`])^k as shares of the restoring force; a
/// number for each term.
#[derive(Debug)]
pub struct Polynomial {
    /// Exponents i, j, k, each below [`MOST_POWER`].
    pub terms: Vec<[usize; 3]>,
}

impl<R: Real> Acts<R> for Polynomial {
    fn torque(&self, q: &[R], at: &At<R>) -> R {
        let (x, v, t) = (at.x(), at.v(), at.now.t_s / GROWTH_S);
        let [xs, vs, ts] = [x.value(), v.value(), t].map(powers);
        let slope = |of: &[f64; MOST_POWER], n: usize| match n {
            0 => 0.0,
            n => n as f64 * of[n - 1],
        };
        let (mut force, mut by_x, mut by_v) = (R::zero(), 0.0, 0.0);
        for (q, [i, j, k]) in q.iter().zip(&self.terms) {
            force.add_scaled(xs[*i] * vs[*j] * ts[*k], *q);
            by_x += q.value() * ts[*k] * slope(&xs, *i) * vs[*j];
            by_v += q.value() * ts[*k] * xs[*i] * slope(&vs, *j);
        }
        // The coefficients came with their derivatives; here come those of place and rate.
        force += x.chain(0.0, by_x) + v.chain(0.0, by_v);
        force.scale(-at.scales.restoring_rad_s2())
    }
}

/// Powers of a number from none.
fn powers(of: f64) -> [f64; MOST_POWER] {
    let mut all = [1.0; MOST_POWER];
    for n in 1..MOST_POWER {
        all[n] = all[n - 1] * of;
    }
    all
}

/// A sensor whose scale is off; one number.
#[derive(Debug)]
pub struct ScaleError;

impl<R: Real> Acts<R> for ScaleError {
    fn reading(&self, q: &[R], _t_s: f64, turn: R) -> R {
        turn + q[0] * turn
    }
}

/// A sensor whose zero drifts evenly, by so much over the record; one number.
#[derive(Debug)]
pub struct ZeroDrift {
    /// Length of the record, s.
    pub duration_s: f64,
}

impl<R: Real> Acts<R> for ZeroDrift {
    fn reading(&self, q: &[R], t_s: f64, turn: R) -> R {
        turn + q[0].scale(t_s / self.duration_s)
    }
}

/// A body with effects.
#[derive(Debug)]
pub struct Swinging<'a, R> {
    /// What brings it back.
    pub law: Law,
    /// What strengths are shares of.
    pub scales: Scales,
    /// Angular frequency of small swings, rad/s.
    pub omega_rad_s: R,
    /// Linear damping α, 1/s.
    pub damping_per_s: R,
    /// Effects with their numbers.
    pub effects: Vec<(&'a AnyEffect, &'a [R])>,
}

impl<R: Real> Torque<R> for Swinging<'_, R>
where
    AnyEffect: Acts<R>,
{
    fn acceleration(&self, now: &Now<R>) -> R {
        let at = At {
            now,
            scales: &self.scales,
            omega_rad_s: self.omega_rad_s,
        };
        let (mut torque, mut inertia) =
            self.law.at(self.omega_rad_s, now.angle_rad, now.rate_rad_s);
        torque -= (self.damping_per_s * now.rate_rad_s).scale(2.0);
        for (effect, q) in &self.effects {
            torque += effect.torque(q, &at);
            inertia += effect.added_inertia(q, &at);
        }
        torque / inertia
    }

    /// Dahl's law along a way in one sense: the bearing gives as 1 − exp(−way/θ_s) of what is left.
    fn given(&self, now: &Now<R>, angle_rad: R) -> R {
        let mut gives = self.effects.iter();
        let Some(give_rad) = gives.find_map(|(effect, q)| effect.give_rad(q)) else {
            return now.given;
        };
        let way = (angle_rad - now.angle_rad).scale(now.sense);
        let way = if way.value() > 0.0 { way } else { R::zero() };
        let sense = R::constant(now.sense);
        sense + (now.given - sense) * (-(way / give_rad)).exp()
    }
}

impl<R: Real> Swinging<'_, R>
where
    AnyEffect: Acts<R>,
{
    /// Angle or rate, as the sensor reads it, at rising times from the start (angle, rad; rate,
    /// rad/s), handed over one by one; `None` where the motion runs out of the numbers.
    pub fn readings(
        &self,
        [angle_rad, rate_rad_s]: [R; 2],
        is_angle: bool,
        times_s: &[f64],
        mut take: impl FnMut(usize, R),
    ) -> Option<()> {
        let start = Now::start(angle_rad, rate_rad_s);
        let mut sample = 0;
        let times = times_s.iter().copied();
        follow_each(self, start, self.omega_rad_s.value(), times, |now| {
            let turn = now[usize::from(!is_angle)];
            let t_s = times_s[sample];
            let effects = self.effects.iter();
            let reading = effects.fold(turn, |turn, (effect, q)| effect.reading(q, t_s, turn));
            take(sample, reading);
            sample += 1;
        })
    }
}
