//! Causes in one angle, each a few parameters and a torque over the body's inertia.
//!
//! Inertia and lever are not known here: strengths are those over the moment of inertia. Each is
//! fitted as the share of critical damping (or of stiffness, or of inertia) that it has at the
//! widest angle or the fastest rate of the swing.

use super::super::cause_id::CauseId;
use super::super::causes::TERMS;
use super::super::parameter_id::ParameterName;
use super::super::point::{CauseParameter, NO_LIMITS};
use super::super::term::Term;
use super::super::unit::UnitName;

/// Share of critical damping, of stiffness or of inertia that causes ordinarily have: a hundredth.
const ORDINARY: f64 = 0.01;
/// Scales of phones' gyroscopes are right to this, one standard uncertainty, and never wrong by
/// more than the second (sensitivity tolerances of their data sheets).
const SCALE_U: f64 = 0.01;
const MOST_SCALE: f64 = 0.03;
/// A bias of phones' gyroscopes wanders by so much in a recording, rad/s.
const DRIFT_U_RAD_S: f64 = 1e-3;
/// Angles over which bearings give, rad, from which a fit begins, and the uncertainty of their
/// logarithms.
const GIVE_RAD: [f64; 3] = [0.005, 0.015, 0.045];
const GIVE_U: f64 = 0.7;
/// Exponent between linear and quadratic damping, and its limits.
const EXPONENT: (f64, f64) = (0.5, 0.2);
const EXPONENTS: (f64, f64) = (-0.9, 3.0);
/// Time over which terms of a learned force that grow reach their coefficient, s.
pub const GROWTH_S: f64 = 100.0;

/// What scales the strengths in a swing.
#[derive(Debug, Clone, Copy)]
pub struct Scales {
    /// Angular frequency, rad/s.
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
    fn critical_rad_s2(&self) -> f64 {
        2.0 * self.omega_rad_s * self.rate_rad_s()
    }
}

/// What a cause does.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    QuadraticDrag,
    PowerLawDamping,
    BearingFriction,
    PreslidingBearing,
    AmplitudeAddedMass,
    GyroScale,
    BiasDrift,
    /// A polynomial of angle, rate and time, by its terms.
    Learned(Vec<Term>),
}

/// A cause in a swing.
#[derive(Debug, Clone)]
pub struct Cause {
    /// Name in the contract.
    pub id: CauseId,
    pub kind: Kind,
    pub parameters: Vec<CauseParameter>,
    /// Strengths below zero have no physical meaning.
    pub one_sided: bool,
}

/// The body at a moment.
pub type Now = gyradius_mechanics::one_angle::Now<f64>;

/// Every cause, in the order in which all swings have them.
pub fn catalogue(scales: &Scales) -> Vec<Cause> {
    let mut all = vec![
        quadratic_drag(scales),
        power_law_damping(scales),
        bearing_friction(scales),
    ];
    all.extend(GIVE_RAD.map(|give_rad| presliding_bearing(scales, give_rad)));
    all.extend([
        amplitude_added_mass(scales),
        gyro_scale(),
        bias_drift(),
        learned(scales, &TERMS),
    ]);
    all
}

fn parameter(
    name: ParameterName,
    unit: UnitName,
    factor: f64,
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
        is_strength: true,
        of_swing: true,
        limits: NO_LIMITS,
    }
}

fn strength(name: ParameterName, unit: UnitName, factor: f64) -> CauseParameter {
    parameter(name, unit, factor, (0.0, ORDINARY))
}

fn brake(id: CauseId, kind: Kind, parameters: Vec<CauseParameter>) -> Cause {
    Cause {
        id,
        kind,
        parameters,
        one_sided: true,
    }
}

/// θ'' = … − c |θ'| θ'.
fn quadratic_drag(scales: &Scales) -> Cause {
    let factor = scales.critical_rad_s2() / scales.rate_rad_s().powi(2);
    let parameters = vec![strength(
        ParameterName::TorqueCoefficientPerInertia,
        UnitName::One,
        factor,
    )];
    brake(CauseId::QuadraticDrag, Kind::QuadraticDrag, parameters)
}

/// θ'' = … − c |θ'/θ'₁|^β θ', θ'₁ the fastest rate.
fn power_law_damping(scales: &Scales) -> Cause {
    let exponent = CauseParameter {
        is_strength: false,
        ..parameter(ParameterName::Exponent, UnitName::One, 1.0, EXPONENT)
    };
    let rate = strength(
        ParameterName::RateAtFastestPerS,
        UnitName::PerSecond,
        2.0 * scales.omega_rad_s,
    );
    brake(
        CauseId::PowerLawDamping,
        Kind::PowerLawDamping,
        vec![rate, exponent],
    )
}

/// θ'' = … − m sgn θ'.
fn bearing_friction(scales: &Scales) -> Cause {
    let parameters = vec![strength(
        ParameterName::TorquePerInertia,
        UnitName::RadianPerSecondSquared,
        scales.critical_rad_s2(),
    )];
    brake(CauseId::BearingFriction, Kind::BearingFriction, parameters)
}

/// θ'' = … − m z, z' = (θ' − |θ'| z)/θ_s (Dahl, see the effect `presliding_bearing`).
fn presliding_bearing(scales: &Scales, give_rad: f64) -> Cause {
    let give = CauseParameter {
        is_log: true,
        is_strength: false,
        ..parameter(
            ParameterName::GiveRad,
            UnitName::Radian,
            1.0,
            (give_rad.ln(), GIVE_U),
        )
    };
    let torque = strength(
        ParameterName::TorquePerInertia,
        UnitName::RadianPerSecondSquared,
        scales.critical_rad_s2(),
    );
    brake(
        CauseId::PreslidingBearing,
        Kind::PreslidingBearing,
        vec![torque, give],
    )
}

/// (1 + a A) θ'' = …, A² = θ² + (θ'/ω)².
fn amplitude_added_mass(scales: &Scales) -> Cause {
    let parameters = vec![strength(
        ParameterName::InertiaSharePerRad,
        UnitName::PerRadian,
        1.0 / scales.reach_rad,
    )];
    brake(
        CauseId::AmplitudeAddedMass,
        Kind::AmplitudeAddedMass,
        parameters,
    )
}

fn gyro_scale() -> Cause {
    let parameters = vec![parameter(
        ParameterName::AboutTheAxis,
        UnitName::One,
        1.0,
        (0.0, SCALE_U),
    )];
    Cause {
        id: CauseId::GyroScale,
        kind: Kind::GyroScale,
        parameters,
        one_sided: false,
    }
}

/// A bias that grows evenly; the change over the recording.
fn bias_drift() -> Cause {
    let parameters = vec![parameter(
        ParameterName::AboutTheAxis,
        UnitName::RadianPerSecond,
        1.0,
        (0.0, DRIFT_U_RAD_S),
    )];
    Cause {
        id: CauseId::BiasDrift,
        kind: Kind::BiasDrift,
        parameters,
        one_sided: false,
    }
}

/// θ'' = … − Σ c (θ/A)^i (θ'/ωA)^j t^k, by the terms asked for.
pub fn learned(scales: &Scales, terms: &[Term]) -> Cause {
    let factor = scales.omega_rad_s * scales.rate_rad_s();
    let parameters = terms
        .iter()
        .map(|term| strength(term.parameter(), UnitName::RadianPerSecondSquared, factor))
        .collect();
    Cause {
        id: CauseId::Unknown,
        kind: Kind::Learned(terms.to_vec()),
        parameters,
        one_sided: false,
    }
}

/// A trace of a strength, as a share of the width of its prior.
const TRACE: f64 = 0.01;

impl Cause {
    /// Where a fit with it begins: strengths a trace above nothing, so that what else it has shows.
    pub fn start(&self) -> Vec<f64> {
        self.parameters
            .iter()
            .map(|p| {
                let trace = if p.is_strength { TRACE } else { 0.0 };
                p.prior.0 + trace * p.prior.1
            })
            .collect()
    }

    /// Torque over inertia, rad/s².
    pub fn torque(&self, q: &[f64], scales: &Scales, now: &Now) -> f64 {
        let critical = scales.critical_rad_s2();
        let v = now.rate_rad_s / scales.rate_rad_s();
        match &self.kind {
            Kind::QuadraticDrag => -q[0] * critical * now.sense * v * v,
            Kind::PowerLawDamping => {
                -q[0]
                    * critical
                    * now.sense
                    * v.abs().powf(1.0 + q[1].clamp(EXPONENTS.0, EXPONENTS.1))
            }
            Kind::BearingFriction => -q[0] * critical * now.sense,
            Kind::PreslidingBearing => -q[0] * critical * now.given,
            Kind::Learned(terms) => {
                let (x, t) = (now.angle_rad / scales.reach_rad, now.t_s / GROWTH_S);
                let force: f64 = terms
                    .iter()
                    .zip(q)
                    .map(|(term, q)| q * term.times(1.0, x, v, t))
                    .sum();
                -force * scales.omega_rad_s * scales.rate_rad_s()
            }
            Kind::AmplitudeAddedMass | Kind::GyroScale | Kind::BiasDrift => 0.0,
        }
    }

    /// Share of the inertia that comes along.
    pub fn added_inertia(&self, q: &[f64], scales: &Scales, now: &Now) -> f64 {
        if self.kind != Kind::AmplitudeAddedMass {
            return 0.0;
        }
        let (x, v) = (
            now.angle_rad / scales.reach_rad,
            now.rate_rad_s / scales.rate_rad_s(),
        );
        q[0] * x.hypot(v)
    }

    /// Error of the gyroscope's scale.
    pub fn scale_error(&self, q: &[f64]) -> f64 {
        if self.kind == Kind::GyroScale {
            q[0].clamp(-MOST_SCALE, MOST_SCALE)
        } else {
            0.0
        }
    }

    /// Drift of the gyroscope's bias over the recording, rad/s.
    pub fn drift_rad_s(&self, q: &[f64]) -> f64 {
        if self.kind == Kind::BiasDrift {
            q[0]
        } else {
            0.0
        }
    }

    /// Angle over which a bearing gives, rad.
    pub fn give_rad(&self, q: &[f64]) -> Option<f64> {
        (self.kind == Kind::PreslidingBearing).then(|| q[1].exp())
    }
}
