//! The causes in one angle as data: what each does, its numbers with what is known of them before,
//! and where that comes from.
//!
//! Inertia and lever are not known here: strengths are shares at the widest angle of the swing
//! ([`gyradius_mechanics::one_angle::effects`]).

use std::sync::Arc;

use gyradius_estimation::Parameter;
use gyradius_identification::one_motion::{DAMPING_U, Fitting};
use gyradius_mechanics::one_angle::effects::{
    AmplitudeAddedMass, AnyEffect, At, BearingFriction, Effect, Polynomial, PowerLawDamping,
    PreslidingBearing, QuadraticDrag, RestoringForce, ScaleError, Scales, ZeroDrift,
};

use gyradius_mechanics::one_angle::{Law, Now};

use super::super::cause_id::CauseId;
use super::super::causes::TERMS;
use super::super::parameter_id::ParameterName;
use super::super::point::{CauseParameter, NO_LIMITS};
use super::super::term::{Factor, Term};
use super::super::unit::UnitName;

/// A restoring force that departs from its law by more than a third at the widest angle is another
/// law: standard deviation of the share.
const BENT_U: f64 = 0.3;
/// Air that comes along is as heavy as the air that a body takes the place of, more or less: of a light
/// hull (100 kg/m³ over all) a hundredth.
const ADDED_U: f64 = 0.01;
/// Scales of phones' gyroscopes are right to this (sensitivity tolerances of their data sheets: 1 %
/// typical of BMI and LSM parts).
const SCALE_U: f64 = 0.01;
/// A bias of phones' gyroscopes wanders by so much in a recording, rad/s (data sheets: 0.05 °/s over
/// a few kelvin); an angle by as much in the length of a swing.
const DRIFT_U_RAD_S: f64 = 1e-3;
/// Angles over which bearings give, rad, from which a fit begins, and the uncertainty of their
/// logarithms: contacts give by 5 to 50 µm before they slide (Armstrong-Hélouvry, Dupont, Canudas de
/// Wit, *Automatica* 30 (1994) 1083), at a radius of 2 to 10 mm.
const GIVE_RAD: [f64; 2] = [0.002, 0.01];
const GIVE_U: f64 = 0.8;
/// Exponent between linear and quadratic damping: 0.5 is that of a laminar boundary layer (Blasius).
const EXPONENT: (f64, f64) = (0.5, 0.3);
/// Below −1 a brake would grow without bound where the body turns round; beyond 3 nothing is known.
const EXPONENTS: (f64, f64) = (-0.9, 3.0);
/// Standard deviations of the terms of a force of unknown form, as shares of the restoring force: a
/// decade apart, from what hardly shows to what is a tenth of all that acts.
const UNKNOWN_U: [f64; 3] = [1e-3, 1e-2, 1e-1];

/// A form of a cause in a swing.
#[derive(Debug, Clone)]
pub struct Cause {
    /// Name in the contract.
    pub id: CauseId,
    pub effect: Arc<AnyEffect>,
    pub parameters: Vec<CauseParameter>,
    /// Priors and bounds of its numbers.
    pub known: Vec<Parameter>,
    /// Whether it can show in this swing.
    pub shows: bool,
}

impl Cause {
    pub fn fitting(&self) -> Fitting<'_> {
        Fitting {
            effect: &*self.effect,
            parameters: &self.known,
        }
    }

    /// Where it does nothing: strengths at zero, all else as it is thought to be.
    pub fn absent(&self) -> Vec<f64> {
        let value = |p: &CauseParameter| if p.is_strength { 0.0 } else { p.prior.0 };
        self.parameters.iter().map(value).collect()
    }

    /// How much of the restoring force at the widest angle it is where the body turns round, and where
    /// it is fastest.
    pub fn shares(&self, numbers: &[f64], scales: &Scales) -> [f64; 2] {
        let places = [(scales.reach_rad, 0.0), (0.0, scales.rate_rad_s())];
        places.map(|(angle_rad, rate_rad_s)| {
            let now = Now {
                t_s: 0.0,
                angle_rad,
                rate_rad_s,
                sense: if rate_rad_s > 0.0 { 1.0 } else { 0.0 },
                given: 1.0,
            };
            let at = At {
                now: &now,
                scales,
                omega_rad_s: scales.omega_rad_s,
            };
            let torque = self.effect.torque(numbers, &at).abs() / scales.restoring_rad_s2();
            torque + self.effect.added_inertia(numbers, &at).abs()
        })
    }

    /// Whether numbers are further than three standard deviations from what was known of them, or
    /// at a limit that is none of a strength: a prior's edge is no result.
    pub fn is_at_edge(&self, numbers: &[f64]) -> bool {
        let is_beyond = |(x, known): (&f64, &Parameter)| {
            let far = known
                .prior
                .is_some_and(|(mean, u)| (x - mean).abs() > 3.0 * u);
            far || *x >= known.high || (*x <= known.low && known.low != 0.0)
        };
        self.id != CauseId::Unknown && numbers.iter().zip(&self.known).any(is_beyond)
    }
}

/// Every form of every cause, in the order in which all swings have them.
pub fn catalogue(scales: &Scales, law: Law, is_angle: bool, duration_s: f64) -> Vec<Cause> {
    let (critical, restoring) = (scales.critical_rad_s2(), scales.restoring_rad_s2());
    let rate_rad_s = scales.rate_rad_s();
    let torque = || {
        strength(
            ParameterName::TorquePerInertia,
            (UnitName::RadianPerSecondSquared, critical),
            DAMPING_U,
        )
    };
    let drag = strength(
        ParameterName::TorqueCoefficientPerInertia,
        (UnitName::One, critical / rate_rad_s.powi(2)),
        DAMPING_U,
    );
    let power = strength(
        ParameterName::RateAtFastestPerS,
        (UnitName::PerSecond, 2.0 * scales.omega_rad_s),
        DAMPING_U,
    );
    let exponent = other(ParameterName::Exponent, (UnitName::One, 1.0), EXPONENT);
    let exponent = CauseParameter {
        limits: EXPONENTS,
        ..exponent
    };
    let added = strength(
        ParameterName::InertiaSharePerRad,
        (UnitName::PerRadian, scales.reach_rad.recip()),
        ADDED_U,
    );
    // κ (sin θ − θ) is κ A²/6 of the restoring force at small widest angles A.
    let bent = both_ways(
        ParameterName::Hardness,
        (UnitName::One, 1.0),
        6.0 * BENT_U / scales.reach_rad.powi(2),
    );
    let mut all = vec![
        cause(CauseId::QuadraticDrag, QuadraticDrag, vec![drag]),
        cause(
            CauseId::PowerLawDamping,
            PowerLawDamping,
            vec![power, exponent],
        ),
        cause(CauseId::BearingFriction, BearingFriction, vec![torque()]),
        cause(CauseId::AmplitudeAddedMass, AmplitudeAddedMass, vec![added]),
        cause(CauseId::RestoringForce, RestoringForce, vec![bent]),
    ];
    for give_rad in GIVE_RAD {
        let give = other(
            ParameterName::GiveRad,
            (UnitName::Radian, 1.0),
            (give_rad.ln(), GIVE_U),
        );
        let give = CauseParameter {
            is_log: true,
            ..give
        };
        let parameters = vec![torque(), give];
        all.push(cause(
            CauseId::PreslidingBearing,
            PreslidingBearing,
            parameters,
        ));
    }
    let scale = both_ways(ParameterName::AboutTheAxis, (UnitName::One, 1.0), SCALE_U);
    all.push(Cause {
        // Only a law that bends tells how wide a swing is by itself.
        shows: law.knows_the_angle() && !is_angle,
        ..cause(CauseId::GyroScale, ScaleError, vec![scale])
    });
    let unit = if is_angle {
        UnitName::Radian
    } else {
        UnitName::RadianPerSecond
    };
    let drift = both_ways(ParameterName::AboutTheAxis, (unit, 1.0), DRIFT_U_RAD_S);
    all.push(cause(
        CauseId::BiasDrift,
        ZeroDrift { duration_s },
        vec![drift],
    ));
    all.extend(UNKNOWN_U.map(|u| unknown(&TERMS, restoring, u)));
    all
}

/// A force of unknown form by some terms, as shares of the restoring force.
pub fn unknown(terms: &[Term], restoring_rad_s2: f64, u: f64) -> Cause {
    let power = |term: &Term, of: Factor| {
        let found = term.factors().iter().filter(|factor| **factor == of);
        found.count()
    };
    let powers =
        |term: &Term| [Factor::Position, Factor::Rate, Factor::Time].map(|f| power(term, f));
    let unit = (UnitName::RadianPerSecondSquared, restoring_rad_s2);
    let parameters = terms
        .iter()
        .map(|term| both_ways(term.parameter(), unit, u));
    let terms = terms.iter().map(powers).collect();
    cause(CauseId::Unknown, Polynomial { terms }, parameters.collect())
}

/// What laws that are the same both ways do otherwise: terms to the fifth power that are odd in the
/// angle and even in the rate, and the other way round, with the shares of the restoring force that
/// each may have.
pub fn nearly([at_turn, at_speed]: [f64; 2]) -> (Polynomial, Vec<Parameter>) {
    let all = [
        ([3, 0, 0], at_turn),
        ([1, 2, 0], at_turn),
        ([5, 0, 0], at_turn),
        ([0, 3, 0], at_speed),
        ([2, 1, 0], at_speed),
        ([0, 5, 0], at_speed),
    ];
    let some = all.into_iter().filter(|(_, u)| *u > 0.0);
    let (terms, widths): (Vec<[usize; 3]>, Vec<f64>) = some.unzip();
    let known = widths
        .into_iter()
        .map(|u| Parameter::FREE.with_prior(0.0, u));
    (Polynomial { terms }, known.collect())
}

fn cause(id: CauseId, effect: impl Effect + 'static, parameters: Vec<CauseParameter>) -> Cause {
    let known = |p: &CauseParameter| {
        let prior = Parameter::FREE.with_prior(p.prior.0, p.prior.1);
        prior.within(p.limits.0, p.limits.1)
    };
    Cause {
        id,
        effect: Arc::new(effect),
        known: parameters.iter().map(known).collect(),
        parameters,
        shows: true,
    }
}

fn other(
    name: ParameterName,
    (unit, factor): (UnitName, f64),
    prior: (f64, f64),
) -> CauseParameter {
    CauseParameter {
        name,
        unit,
        factor,
        zero: 0.0,
        is_log: false,
        prior,
        stiff_below: 0.0,
        is_strength: false,
        of_swing: true,
        limits: NO_LIMITS,
    }
}

/// A strength of either sign.
fn both_ways(name: ParameterName, unit: (UnitName, f64), u: f64) -> CauseParameter {
    CauseParameter {
        is_strength: true,
        ..other(name, unit, (0.0, u))
    }
}

/// A strength that is not below zero.
fn strength(name: ParameterName, unit: (UnitName, f64), u: f64) -> CauseParameter {
    CauseParameter {
        limits: (0.0, f64::INFINITY),
        ..both_ways(name, unit, u)
    }
}
