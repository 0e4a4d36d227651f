//! Shapes of what no cause of the catalogue accounts for: they find no name, but show what is
//! missing.

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterName;
use super::super::point::{Cause, Form};
use super::super::term::Term;
use super::super::unit::UnitName;
use gyradius_mechanics::Real;

use super::{Scales, add, cause, clamped, fixed, logarithm, number, put, strength};

/// Length of a knock, s, and standard deviation of its logarithm.
const KNOCK_S: f64 = 0.1;
const KNOCK_LOG_U: f64 = 0.7;

/// A knock at a moment of a swing. Impulses are changes of speed and rate.
pub fn knock_at(scales: &Scales, swing: usize, at_s: f64) -> Cause {
    let (i, mass, pitches) = (scales.gyradii2_m2, scales.mass_kg, scales.pitches);
    let (turn, about) = if pitches {
        (ParameterName::TurnYNMS, i[1])
    } else {
        (ParameterName::TurnXNMS, i[0])
    };
    let parameters = vec![
        strength(
            ParameterName::ImpulseXNS,
            UnitName::NewtonSecond,
            mass,
            0.02,
        ),
        strength(
            ParameterName::ImpulseYNS,
            UnitName::NewtonSecond,
            mass,
            0.02,
        ),
        strength(turn, UnitName::NewtonMetreSecond, about * mass, 0.02),
        strength(
            ParameterName::TurnZNMS,
            UnitName::NewtonMetreSecond,
            i[2] * mass,
            0.02,
        ),
        number(ParameterName::AtS, UnitName::Second, at_s, 2.0),
        logarithm(ParameterName::OverS, UnitName::Second, KNOCK_S, KNOCK_LOG_U),
    ];
    let law = put(move |q, s, e| {
        if s != swing {
            return Ok(());
        }
        let over_s = q[5].exp();
        let numbers = [
            ("at_s", q[4] - over_s * 0.5),
            ("over_s", over_s),
            ("impulse_x_n_s", q[0]),
            ("impulse_y_n_s", q[1]),
            (turn.name(), q[2] * about),
            ("turn_z_n_m_s", q[3] * i[2]),
        ];
        add(e, "knock", &numbers)
    });
    Cause {
        apart: true,
        form: Form::Knock(swing),
        ..cause(CauseId::Unknown, parameters, law)
    }
}

/// Length of a line's slip, s, and standard deviation of its logarithm.
pub const GIVES_S: f64 = 0.2;
const GIVES_LOG_U: f64 = 0.7;
/// Shortest and longest that are told from none and from creep, s.
const GIVES_WITHIN_S: [f64; 2] = [0.05, 3.0];

/// Lines that give way at a moment of a swing, and stay so in all that follow. The moment is the
/// middle.
pub fn line_slip_at(scales: &Scales, swing: usize, at_s: f64) -> Cause {
    let line_m = scales.line_m;
    let parameters = vec![
        strength(ParameterName::PositiveM, UnitName::Metre, line_m, 2e-3),
        strength(ParameterName::NegativeM, UnitName::Metre, line_m, 2e-3),
        number(ParameterName::AtS, UnitName::Second, at_s, 2.0),
        logarithm(ParameterName::OverS, UnitName::Second, GIVES_S, GIVES_LOG_U),
    ];
    let law = put(move |q, s, e| {
        if s < swing {
            return Ok(());
        }
        let over_s = clamped(q[3].exp(), GIVES_WITHIN_S[0], GIVES_WITHIN_S[1]);
        let at_s = if s == swing {
            q[2] - over_s * 0.5
        } else {
            fixed(-10.0)
        };
        let numbers = [
            ("at_s", at_s),
            ("over_s", over_s),
            ("positive_m", q[0] * line_m),
            ("negative_m", q[1] * line_m),
        ];
        add(e, "line_slip", &numbers)
    });
    Cause {
        apart: true,
        form: Form::LineSlip(swing),
        ..cause(CauseId::Unknown, parameters, law)
    }
}

/// Terms of a learned force, in the order in which they are tried.
pub const TERMS: [Term; 9] = [
    Term::Xx,
    Term::Xv,
    Term::Vv,
    Term::Xxx,
    Term::Xxv,
    Term::Xvv,
    Term::Vvv,
    Term::Xt,
    Term::Vt,
];

/// Scales of position and rate of a learned force over a coordinate.
pub fn reach(scales: &Scales, coordinate: usize) -> (f64, f64) {
    let position = if coordinate < 2 {
        0.1 * scales.line_m
    } else {
        0.1
    };
    let rate_rad_s = if coordinate == 3 {
        scales.yaw_rad_s
    } else {
        scales.slowest_rad_s
    };
    (position, position * rate_rad_s)
}

/// A smooth force over one coordinate (0: along x, 1: along y, 2: about the suspension, 3: about
/// the vertical), by the terms asked for.
pub fn learned_force(scales: &Scales, coordinate: usize, terms: &[Term]) -> Cause {
    let inertia = [1.0, 1.0, scales.turn2_m2(), scales.gyradii2_m2[2]][coordinate];
    let (position, rate) = reach(scales, coordinate);
    // The force that the rest of the motion has at the scale.
    let force = inertia * rate * rate / position;
    let unit = if coordinate < 2 {
        UnitName::Newton
    } else {
        UnitName::NewtonMetre
    };
    let parameters = terms
        .iter()
        .map(|term| strength(term.parameter(), unit, force * scales.mass_kg, 0.01))
        .collect();
    let terms = terms.to_vec();
    let law = put(move |q, _, e| {
        let mut numbers = vec![
            ("coordinate", fixed(coordinate as f64)),
            ("scale_of_position", fixed(position)),
            ("scale_of_rate", fixed(rate)),
        ];
        numbers.extend(
            terms
                .iter()
                .zip(q)
                .map(|(term, q)| (term.name(), *q * force)),
        );
        add(e, "learned_force", &numbers)
    });
    Cause {
        form: Form::Force(coordinate),
        ..cause(CauseId::Unknown, parameters, law)
    }
}
