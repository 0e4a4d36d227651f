//! The missing force where no known cause accounts for it: learned inside the simulation, and the
//! simplest closed form that does as well.

use nalgebra::{DMatrix, DVector};

use super::cause_id::CauseId;
use super::causes::{Scales, TERMS, reach};
use super::closed_form::Whole;
use super::coordinate::ForceCoordinate;
use super::found::Found;
use super::point::Form;
use super::result::LearnedForce;
use super::term::{Factor, Term};
use super::unit::UnitName;
use super::words;
use gyradius_base::message::{Argument, Message};

/// Positions and rates at which the force is told, shares of the scale.
const GRID: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];

/// The force that the last cause is, where it is one without a name.
pub fn learned(found: &Found, heldout_rms: f64) -> Option<LearnedForce> {
    let cause = found
        .model
        .causes
        .last()
        .filter(|cause| cause.id == CauseId::Unknown)?;
    match cause.form {
        Form::Force(coordinate) => force(found, coordinate, heldout_rms),
        Form::Knock(swing) => knock(found, swing, heldout_rms),
        Form::LineSlip(swing) => line_slip(found, swing, heldout_rms),
        Form::Second => second(found, heldout_rms),
        Form::Law | Form::PhoneSlip(_) | Form::Gust => None,
    }
}

/// A shape that is its own closed form, and acts on more than one coordinate.
fn of_all(equation: String, message: Message, heldout_rms: f64) -> LearnedForce {
    LearnedForce {
        coordinate: ForceCoordinate::All,
        unit: UnitName::Newton.into(),
        points: vec![],
        equation,
        message,
        heldout_rms_over_noise: Some(heldout_rms),
        closed_heldout_rms_over_noise: Some(heldout_rms),
    }
}

/// Something more that moves inside: a mass m on a spring along a level way in the hull.
fn second(found: &Found, heldout_rms: f64) -> Option<LearnedForce> {
    let (cause, values) = (
        found.model.causes.last()?,
        found.fitted.point.causes.last()?,
    );
    let [mass, log_frequency, log_damping, ..] = values[..] else {
        return None;
    };
    let (mass_kg, frequency_hz) = (mass * cause.parameters.first()?.factor, log_frequency.exp());
    let equation = format!(
        "F(t) = −m s̈, s̈ + 2 ζ ω ṡ + ω² s = −a; m = {mass_kg:.3} kg, ω = 2π · {frequency_hz:.3} Hz, ζ = {:.3}",
        log_damping.exp()
    );
    let frequency = [("frequency_hz", words::number(frequency_hz, 2))];
    let message = words::message("learned_second", frequency);
    Some(of_all(equation, message, heldout_rms))
}

fn knock(found: &Found, swing: usize, heldout_rms: f64) -> Option<LearnedForce> {
    let values = found.fitted.point.causes.last()?;
    let cause = found.model.causes.last()?;
    let id = &found.model.swing(swing).setup.swing.id;
    let parts: Vec<String> = cause.parameters[..4]
        .iter()
        .zip(values)
        .map(|(p, v)| format!("{:.3} {} ({})", p.told(*v), p.unit, p.name.without(p.unit)))
        .collect();
    let at_s = cause.parameters[4].told(values[4]);
    let equation = format!("F(t) = J δ(t − {at_s:.2} s), J = {}", parts.join(", "));
    let named = [("swing", words::id(id)), ("at_s", words::number(at_s, 2))];
    let message = words::message("learned_knock", named);
    Some(of_all(equation, message, heldout_rms))
}

/// Lines that are longer from a moment on: no force of its own, but the lines'.
fn line_slip(found: &Found, swing: usize, heldout_rms: f64) -> Option<LearnedForce> {
    let (cause, values) = (
        found.model.causes.last()?,
        found.fitted.point.causes.last()?,
    );
    let [positive, negative, at_s, ..] = values[..] else {
        return None;
    };
    let at_s = cause.parameters.get(2)?.told(at_s);
    let line_mm = 1e3 * cause.parameters.first()?.factor;
    let id = &found.model.swing(swing).setup.swing.id;
    let more = [positive, negative].map(|share| format!("{:+.2}", share * line_mm));
    let [positive_mm, negative_mm] = &more;
    let equation = format!(
        "l(t > {at_s:.2} s) = l + {positive_mm} mm and {negative_mm} mm (line on the positive side of the axis, on the negative)"
    );
    let [positive_mm, negative_mm] = more.map(words::written);
    let named = [
        ("swing", words::id(id)),
        ("at_s", words::number(at_s, 2)),
        ("positive_mm", positive_mm),
        ("negative_mm", negative_mm),
    ];
    let message = words::message("learned_line_slip", named);
    Some(of_all(equation, message, heldout_rms))
}

fn force(found: &Found, coordinate: usize, heldout_rms: f64) -> Option<LearnedForce> {
    // Of where the force was looked for: its terms are over these.
    let scales = Scales::of(found.model.base, &found.looked_from).ok()?;
    let closed = Whole::of(found, &scales, coordinate)?.closed_form()?;
    let full = found.model.causes.last()?;
    let unit = full.parameters.first()?.unit;
    let (position, rate) = reach(&scales, coordinate);
    let (chi2, rows) = Found::held_out(&closed.model, &closed.fitted).ok()?;
    let symbol = if coordinate < 2 {
        ("x", "v")
    } else {
        ("θ", "ω")
    };
    let values = closed.fitted.point.causes.last()?;
    let factor = full.parameters.first()?.factor;
    let sum: Vec<String> = closed
        .terms
        .iter()
        .zip(values)
        .map(|(term, q)| {
            let (powers, scale) = written(TERMS[*term], symbol, position, rate);
            format!("{:+.4e} {powers}", -q * factor / scale)
        })
        .collect();
    let name = match coordinate {
        0 => ForceCoordinate::Surge,
        1 => ForceCoordinate::Sway,
        2 if scales.pitches => ForceCoordinate::Pitch,
        2 => ForceCoordinate::Roll,
        _ => ForceCoordinate::Yaw,
    };
    let letter = if coordinate < 2 { "F" } else { "M" };
    Some(LearnedForce {
        coordinate: name,
        unit: unit.into(),
        points: points(found, position, rate)?,
        equation: format!("{letter}_{name} = {} {unit}", sum.join(" ")),
        message: words::message(
            "learned_acts",
            [
                ("motion", Argument::Word(format!("inertia.motion.{name}"))),
                ("shapes", shapes(closed.terms.iter().map(|t| TERMS[*t]))),
            ],
        ),
        heldout_rms_over_noise: Some(heldout_rms),
        closed_heldout_rms_over_noise: Some((chi2 / rows.max(1) as f64).sqrt()),
    })
}

/// A term's factors and what they are over.
pub fn written(term: Term, (x, v): (&str, &str), position: f64, rate: f64) -> (String, f64) {
    let (mut text, mut scale) = (String::new(), 1.0);
    for factor in term.factors() {
        let (symbol, by) = match factor {
            Factor::Position => (x, position),
            Factor::Rate => (v, rate),
            Factor::Time => ("t", 100.0),
        };
        text.push_str(symbol);
        scale *= by;
    }
    (text, scale)
}

fn in_words(term: Term) -> Argument {
    words::word(match term {
        Term::Xx => "shape.spring_on_one_side",
        Term::Xv => "shape.drag_on_one_side",
        Term::Vv => "shape.push_one_way",
        Term::Xxx => "shape.spring_at_wide_angles",
        Term::Xxv => "shape.drag_away_from_middle",
        Term::Xvv => "shape.spring_at_speed",
        Term::Vvv => "shape.drag_of_third_power",
        Term::Xt => "shape.spring_with_time",
        Term::Vt => "shape.drag_with_time",
    })
}

/// What terms look like, in a row.
pub fn shapes(terms: impl Iterator<Item = Term>) -> Argument {
    words::row(terms.map(in_words).collect(), "and", "and")
}

/// The force with its standard uncertainty on a grid of positions and rates at the start and after
/// 100 s.
fn points(found: &Found, position: f64, rate: f64) -> Option<Vec<[f64; 5]>> {
    let cause = found.model.causes.last()?;
    let values = found.fitted.point.causes.last()?;
    let covariance = found.fitted.covariance()?;
    let (first, size) = (found.fitted.place_of_last(values.len()), values.len());
    let terms = cause.parameters.iter().map(|p| Term::of(p.name));
    let terms = terms.collect::<Option<Vec<Term>>>()?;
    let factor = cause.parameters.first()?.factor;
    let own = covariance.view((first, first), (size, size)).into_owned();
    Some(grid(&terms, (values, &own), factor, (position, rate)))
}

/// A force by terms with coefficients and their covariance, times a factor: rows of position, rate,
/// time, force, its standard uncertainty.
pub fn grid(
    terms: &[Term],
    (values, covariance): (&[f64], &DMatrix<f64>),
    factor: f64,
    (position, rate): (f64, f64),
) -> Vec<[f64; 5]> {
    let mut points = Vec::new();
    for t_s in [0.0, 100.0] {
        for x in GRID {
            for v in GRID {
                let of = |term: &Term| term.times(-factor, x, v, t_s / 100.0);
                let row = DVector::from_iterator(terms.len(), terms.iter().map(of));
                let force = row.iter().zip(values).map(|(r, q)| r * q).sum();
                let variance = row.dot(&(covariance * &row));
                points.push([x * position, v * rate, t_s, force, variance.max(0.0).sqrt()]);
            }
        }
    }
    points
}
