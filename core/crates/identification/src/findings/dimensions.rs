//! Lengths against each other, against the hull, and what nothing tests.

use std::collections::BTreeMap;

use gyradius_base::message::Argument;
use gyradius_recording::{Attachment, ModeName, Quantity, Session, Swing, SwingData};

use super::{Finding, FindingKind as Kind, Severity};
use crate::consistency::Hidden;
use crate::estimate::{Solution, System};
use crate::measurement::{Measurement, SwingResult};
use crate::names::{InputKind, QuantityName};
use crate::outputs::hull_scalar;
use crate::suspects::read_for;

/// A spacing of so many line lengths, or lines of so many spacings, are no suspension that anybody
/// hangs up: one of the two is in another unit.
const MOST_RATIO: f64 = 20.0;
const MOST_RATIO_OF_LINES: f64 = 300.0;
/// Points of suspension may lie a little beyond the hull's ends, on a frame.
const BEYOND_ENDS: f64 = 1.2;
/// A stated figure that is tested as well as it was read hides an error of some four uncertainties of
/// the result; one that hides more than this is not tested.
const MOVES_MUCH: f64 = 10.0;

/// Gravity at sea level is 9.780 at the equator and 9.832 at the poles; 10 km up it is 0.031 less.
const GRAVITY_ON_EARTH_M_S2: [f64; 2] = [9.74, 9.84];
/// One of two spacings is rarely more than this many times the other.
const MOST_TAPER: f64 = 5.0;
/// What rides along with more than this share of everything is worth a note: a beam or a platform
/// may, a phone in grams does.
const WORTH_A_NOTE: f64 = 0.3;
/// A uniform rod has k = 0.29 of its length; a third of that is a body with all its mass amidships.
const LEAST_SHARE_OF_LENGTH: f64 = 0.1;
/// Mass that grows from none amidships in proportion to the distance, to the ends: k = L/√8. A hull
/// has less there.
const MOST_SHARE_OF_LENGTH: f64 = 0.354;
/// A uniform rod that just reaches from one suspension point to the other has k = d/√3 = 0.58 d; a
/// body on a light beam of its own may have half of that.
const LEAST_GYRADIUS_OF_HALF_SPACING: f64 = 0.25;

/// The key of a typed period's amplitude.
const AMPLITUDE: &str = "amplitude_deg";

/// Of the stated figures.
pub fn of_dimensions(session: &Session) -> Vec<Finding> {
    let of_swing = |swing: &Swing| {
        let mut found = lengths(session, swing);
        found.extend(taper(swing));
        found.extend(same_period_twice(swing));
        let told = found.into_iter().map(|one| one.of_swing(&swing.id));
        told.collect::<Vec<_>>()
    };
    let mut found: Vec<Finding> = session.swings.iter().flat_map(of_swing).collect();
    found.extend(amplitude_unstated(session));
    found.extend(gravity_stated(session));
    found.extend(
        session
            .attachments
            .iter()
            .flat_map(|one| riding(session, one)),
    );
    found
}

/// What is suspect and only told of.
fn warned(key: &str, kind: Kind, arguments: Vec<(&str, Argument)>) -> Finding {
    Finding::new((kind, Severity::Warned), key, arguments)
}

fn metres(value: f64) -> Argument {
    Argument::Figure(format!("{} m", (value * 1e4).round() / 1e4))
}

fn gravity_stated(session: &Session) -> Option<Finding> {
    let stated = session.site.gravity_m_s2?;
    let [low, high] = GRAVITY_ON_EARTH_M_S2;
    let is_on_earth = (low - 3.0 * stated.u..=high + 3.0 * stated.u).contains(&stated.value);
    (!is_on_earth).then(|| {
        let value = ("value", Argument::Number(stated.value, 3));
        let found = warned("gravity_stated", Kind::ImplausibleSize, vec![value]);
        found
            .of_channel("gravity")
            .with("gravity_m_s2", stated.value)
    })
}

/// A period that was typed in is one at some amplitude: what it is taken as where none is stated,
/// and what that would cost.
fn amplitude_unstated(session: &Session) -> Option<Finding> {
    let is_bare = |swing: &&Swing| match &swing.data {
        SwingData::PeriodsS(typed) => typed.keys().any(|m| !swing.amplitude_deg.contains_key(m)),
        SwingData::Periods(_) => swing.amplitude_deg.is_empty(),
        _ => false,
    };
    let swings: Vec<String> = session
        .swings
        .iter()
        .filter(is_bare)
        .map(|swing| swing.id.clone())
        .collect();
    (!swings.is_empty()).then(|| {
        let arguments = vec![("swings", Argument::Id(swings.join(", ")))];
        warned("amplitude_unstated", Kind::UncheckedDimension, arguments)
            .of_channel(AMPLITUDE)
            .with("swings", swings.len() as f64)
    })
}

fn taper(swing: &Swing) -> Option<Finding> {
    let (below, above) = (swing.suspension.spacing_m?, swing.suspension.top_spacing_m?);
    let ratio = above.value / below.value;
    (ratio.max(ratio.recip()) > MOST_TAPER).then(|| {
        let figures = vec![
            ("above", metres(above.value)),
            ("below", metres(below.value)),
        ];
        let found = warned("taper", Kind::ImplausibleSize, figures);
        found.of_channel(InputKind::TopSpacing.name())
    })
}

/// Two motions of one body have two periods; to the last digit alike, one was typed twice.
fn same_period_twice(swing: &Swing) -> Option<Finding> {
    let SwingData::PeriodsS(typed) = &swing.data else {
        return None;
    };
    let all: Vec<_> = typed.iter().collect();
    let same = |(i, (_, period)): (usize, &(&ModeName, &Quantity))| {
        let (other, _) = all[..i].iter().find(|(_, p)| p.value == period.value)?;
        Some((**other, *all[i].0, period.value))
    };
    let (one, other, period_s) = all.iter().enumerate().find_map(same)?;
    let arguments = vec![
        (
            "one",
            crate::sentences::motion(crate::words::mode_text(one)),
        ),
        (
            "other",
            crate::sentences::motion(crate::words::mode_text(other)),
        ),
        ("period_s", Argument::Figure(period_s.to_string())),
    ];
    Some(warned("same_period", Kind::UnitSuspect, arguments).with("period_s", period_s))
}

/// What rides on a hull is a part of it: lighter, and within its ends.
fn riding(session: &Session, one: &Attachment) -> Vec<Finding> {
    let name = ("name", Argument::Id(one.name.clone()));
    let mut found = Vec::new();
    if let Some(body) = session
        .body
        .mass_kg
        .filter(|m| one.mass_kg.value > WORTH_A_NOTE * m.value)
    {
        let arguments = vec![
            name.clone(),
            ("mass_kg", Argument::Figure(one.mass_kg.value.to_string())),
            ("body_kg", Argument::Figure(body.value.to_string())),
        ];
        let heavy = Finding::new(
            (Kind::ImplausibleSize, Severity::Noted),
            "riding_heavy",
            arguments,
        );
        found.push(heavy.of_channel("mass").with("mass_kg", one.mass_kg.value));
    }
    let spacings = session.swings.iter().filter_map(|s| s.suspension.spacing_m);
    let widest = spacings.map(|q| q.value).fold(0.0, f64::max);
    let (reach, beside) = match session.body.length_overall_m {
        // A beam that the lines are tied to reaches across the spacing.
        Some(hull) => (BEYOND_ENDS * hull.max(widest), hull.max(widest)),
        None => (MOST_RATIO * widest, widest),
    };
    let sizes = [("position", one.position_m), ("gyradii", one.gyradii_m)];
    for (key, size) in sizes {
        let far = size.iter().fold(0.0, |far: f64, x| far.max(x.abs()));
        // From the middle to the ends is half of the hull.
        let most = if key == "position" && session.body.length_overall_m.is_some() {
            0.5 * reach
        } else {
            reach
        };
        if reach > 0.0 && far > most {
            let arguments = vec![
                name.clone(),
                ("key", Argument::Plain(key.into())),
                ("value", metres(far)),
                ("beside", metres(beside)),
            ];
            let outside = warned("riding_far", Kind::ImplausibleSize, arguments);
            found.push(outside.of_channel(key).with("value_m", far));
        }
    }
    found
}

/// A yaw gyradius far below half the spacing that the body reaches across.
fn of_spacing(session: &Session, result: &Measurement) -> Option<Finding> {
    // The lines may be tied to a beam that is taken off.
    if !session.attachments.is_empty() {
        return None;
    }
    let yaw = result.quantities.get(&QuantityName::KYaw)?.value.scalar()?;
    let spacings = session.swings.iter().filter(|swing| {
        let is_yaw = |r: &&SwingResult| r.id == swing.id;
        let shown = result.swings.iter().find(is_yaw);
        shown.is_none_or(|r| r.modes.iter().any(|m| m.mode == ModeName::Yaw))
    });
    let spacings = spacings.filter_map(|swing| swing.suspension.spacing_m);
    let narrow = spacings.map(|q| q.value).fold(f64::INFINITY, f64::min);
    (yaw < LEAST_GYRADIUS_OF_HALF_SPACING * 0.5 * narrow && narrow.is_finite()).then(|| {
        let arguments = vec![("value", metres(yaw)), ("spacing", metres(narrow))];
        let found = warned("small_gyradius", Kind::ImplausibleSize, arguments);
        found
            .of_channel("k_yaw_m")
            .with("value_m", yaw)
            .with("spacing_m", narrow)
    })
}

/// Of a body that is long one of yaw and pitch may be little less than the other, of a flat one by
/// √2; one far below the other leaves a rod across the hull.
fn a_rod(result: &Measurement) -> Option<Finding> {
    let k = |name| result.quantities.get(&name)?.value.scalar();
    let (yaw, pitch) = (k(QuantityName::KYaw)?, k(QuantityName::KPitch)?);
    (yaw.min(pitch) < LEAST_SHARE_OF_LENGTH * yaw.max(pitch)).then(|| {
        let arguments = vec![("yaw", metres(yaw)), ("pitch", metres(pitch))];
        let found = warned("a_rod", Kind::ImplausibleSize, arguments);
        found.with("k_yaw_m", yaw).with("k_pitch_m", pitch)
    })
}

/// Much smaller or larger than the hull is long, or much deeper than a hull is.
fn of_length(name: &QuantityName, value: f64, length: f64) -> Option<Finding> {
    let (key, is_odd) = match name {
        QuantityName::KYaw | QuantityName::KPitch if value > MOST_SHARE_OF_LENGTH * length => {
            ("large_for_length", true)
        }
        QuantityName::KYaw | QuantityName::KPitch => {
            ("small_for_length", value < LEAST_SHARE_OF_LENGTH * length)
        }
        QuantityName::CmDepth => ("deep_for_length", value > 0.5 * length),
        _ => return None,
    };
    is_odd.then(|| {
        let arguments = vec![
            (
                "quantity",
                crate::sentences::name(&format!("quantity.{name}")),
            ),
            ("value", metres(value)),
            ("length", metres(length)),
        ];
        warned(key, Kind::ImplausibleSize, arguments)
            .of_channel(name.as_str())
            .with("value_m", value)
            .with("length_overall_m", length)
    })
}

/// No moment of inertia exceeds the sum of the other two: Σ m(y²+z²) and so on.
fn of_triangle(result: &Measurement) -> Option<Finding> {
    let names = [
        QuantityName::KRoll,
        QuantityName::KPitch,
        QuantityName::KYaw,
    ];
    let k = |name: &QuantityName| {
        let found = result.quantities.get(name)?;
        Some((found.value.scalar()?, found.u.scalar()?))
    };
    let [x, y, z] = [k(&names[0])?, k(&names[1])?, k(&names[2])?];
    let most = [(x, y, z, 0), (y, x, z, 1), (z, x, y, 2)]
        .into_iter()
        .find(|(a, b, c, _)| {
            let square = |(value, _): &(f64, f64)| value * value;
            let u = |(value, u): &(f64, f64)| 2.0 * value * u;
            let beyond = square(a) - square(b) - square(c);
            beyond > 3.0 * u(a).hypot(u(b)).hypot(u(c))
        })?;
    let quantity = crate::sentences::name(&format!("quantity.{}", names[most.3]));
    let found = warned(
        "no_body",
        Kind::ImplausibleSize,
        vec![("quantity", quantity)],
    );
    Some(found.of_channel(names[most.3].as_str()))
}

fn lengths(session: &Session, swing: &Swing) -> Vec<Finding> {
    let hung = &swing.suspension;
    let length = |q: Option<Quantity>| q.map(|q| q.value);
    let spacings = [
        (InputKind::Spacing, length(hung.spacing_m)),
        (InputKind::TopSpacing, length(hung.top_spacing_m)),
    ];
    let lines = length(hung.line_length_m);
    let mut found = Vec::new();
    for (kind, spacing) in spacings {
        let Some(spacing) = spacing else { continue };
        let is_tied_to_beam = !session.attachments.is_empty();
        let hull = session.body.length_overall_m.filter(|_| !is_tied_to_beam);
        if let Some(hull) = hull.filter(|hull| spacing > BEYOND_ENDS * hull) {
            found.push(implausible(kind, spacing, ("length_overall", hull)));
        } else if let Some(lines) = lines.filter(|lines| spacing > MOST_RATIO * lines) {
            found.push(implausible(kind, spacing, ("line_length", lines)));
        } else if let Some(lines) = lines.filter(|lines| *lines > MOST_RATIO_OF_LINES * spacing) {
            found.push(implausible(
                InputKind::LineLength,
                lines,
                (kind.name(), spacing),
            ));
        }
    }
    found
}

fn implausible(kind: InputKind, value: f64, (beside, other): (&str, f64)) -> Finding {
    let figure = |value: f64| Argument::Figure(format!("{value} m"));
    Finding::new(
        (Kind::ImplausibleSize, Severity::Refused),
        "implausible_length",
        [
            ("name", Argument::Texts(vec![kind.in_words()])),
            ("value", figure(value)),
            ("beside", Argument::Plain(beside.to_owned())),
            ("other", figure(other)),
        ],
    )
    .of_channel(kind.name())
    .with(kind.name(), value)
    .with(beside, other)
}

/// Of the gyradii: no point of a body of length L is further than L/2 from the middle along each of
/// two axes, so no gyradius exceeds L/√2, and that of a slender one not L/2. Refused figures are
/// taken out.
pub fn of_size(session: &Session, result: &mut Measurement) -> Vec<Finding> {
    let mut found: Vec<Finding> = of_spacing(session, result).into_iter().collect();
    found.extend(of_triangle(result));
    found.extend(a_rod(result));
    let Some(length) = session.body.length_overall_m else {
        return found;
    };
    let names = [
        QuantityName::KYaw,
        QuantityName::KPitch,
        QuantityName::KRoll,
        QuantityName::CmDepth,
    ];
    for name in names {
        let value = result.quantities.get(&name).and_then(|q| q.value.scalar());
        let most = match name {
            QuantityName::CmDepth => length,
            _ => length * std::f64::consts::FRAC_1_SQRT_2,
        };
        let Some(value) = value else { continue };
        if value <= most {
            found.extend(of_length(&name, value, length));
            continue;
        }
        result.take_out(&name);
        let quantity = crate::sentences::name(&format!("quantity.{name}"));
        let finding = Finding::new(
            (Kind::ImplausibleSize, Severity::Refused),
            "implausible_gyradius",
            [
                ("quantity", quantity),
                ("value", Argument::Number(value, 3)),
                ("most", Argument::Number(most, 3)),
                ("length", Argument::Number(length, 3)),
            ],
        );
        found.push(
            finding
                .of_channel(name.as_str())
                .with("value_m", value)
                .with("length_overall_m", length),
        );
    }
    found
}

/// Stated figures of which the session would not show an error that moves a quantity by more than
/// [`MOVES_MUCH`] of its uncertainties, however small a share of them the figure has.
pub fn unchecked(
    (system, solution): (&System, &Solution),
    hidden: &[Hidden],
    result: &Measurement,
) -> Vec<Finding> {
    let names = QuantityName::SCALARS.into_iter();
    let stated = names.filter(|name| result.quantities.contains_key(name));
    let slopes: Vec<Slopes> = stated
        .filter_map(|name| Slopes::of(system, solution, name))
        .collect();
    let mut by_kind: Vec<Moved> = Vec::new();
    for Hidden { readings, error } in hidden {
        let moved = slopes.iter().map(|slopes| {
            let slope: f64 = readings.iter().map(|i| slopes.by(*i)).sum();
            (&slopes.name, (slope * error).abs())
        });
        let most = moved
            .filter(|(_, in_u)| *in_u >= MOVES_MUCH)
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((quantity, in_u)) = most else {
            continue;
        };
        let one = Moved {
            kind: system.layout.parameters[readings[0]].name.kind,
            readings: readings.clone(),
            error: *error,
            in_u,
            quantity,
        };
        match by_kind.iter_mut().find(|known| known.kind == one.kind) {
            Some(known) => known.join(one),
            None => by_kind.push(one),
        }
    }
    by_kind.iter().map(|one| one.told(system)).collect()
}

/// What an error that would not show moves.
struct Moved<'a> {
    kind: InputKind,
    /// Of which parameters.
    readings: Vec<usize>,
    error: f64,
    /// What it moves most, in its standard uncertainties.
    in_u: f64,
    quantity: &'a QuantityName,
}

impl Moved<'_> {
    /// Readings of one kind are told at once, with the error that does most.
    fn join(&mut self, other: Self) {
        let mut readings = std::mem::take(&mut self.readings);
        readings.extend(&other.readings);
        readings.sort_unstable();
        readings.dedup();
        if other.in_u > self.in_u {
            *self = other;
        }
        self.readings = readings;
    }

    fn told(&self, system: &System) -> Finding {
        let swings = read_for(system, &self.readings).join(", ");
        let of = match swings.is_empty() {
            true => swings,
            false => format!(" ({swings})"),
        };
        let error = match self.kind {
            InputKind::PhoneClock => format!("{:.1} %", 100.0 * self.error),
            _ => format!("{:.1} mm", 1e3 * self.error),
        };
        let quantity = crate::sentences::name(&format!("quantity.{}", self.quantity));
        let finding = Finding::new(
            (Kind::UncheckedDimension, Severity::Noted),
            "unchecked",
            [
                ("name", Argument::Texts(vec![self.kind.in_words()])),
                ("of", Argument::Plain(of)),
                ("error", Argument::Figure(error)),
                ("quantity", quantity),
                ("in_u", Argument::Number(self.in_u, 0)),
            ],
        );
        finding
            .of_channel(self.kind.name())
            .with("hidden_error", self.error)
            .with("in_u", self.in_u)
    }
}

/// Changes of a quantity, in its standard uncertainties, by one unit of each stated figure.
struct Slopes<'a> {
    system: &'a System<'a>,
    solution: &'a Solution,
    name: QuantityName,
    u: f64,
    of_free: BTreeMap<usize, f64>,
}

impl<'a> Slopes<'a> {
    fn of(system: &'a System, solution: &'a Solution, name: QuantityName) -> Option<Self> {
        let of_hull = |x: &[f64]| hull_scalar(system, &name, x);
        let derived = solution.derive(&system.layout, of_hull)?;
        let mut changes = derived.by_row;
        for group in system.correlated(&solution.free) {
            group.by_reading(&mut changes)?;
        }
        let u = derived.u.max(f64::MIN_POSITIVE);
        let of_priors = solution
            .free
            .iter()
            .zip(&changes[system.observations.len()..]);
        let by_unit = of_priors.map(|(i, change)| {
            let stated = system.layout.parameters[*i].prior;
            (*i, change / (stated.u * u))
        });
        Some(Self {
            system,
            solution,
            name,
            u,
            of_free: by_unit.collect(),
        })
    }

    fn by(&self, parameter: usize) -> f64 {
        let of_free = self.of_free.get(&parameter).copied();
        of_free.or_else(|| self.by_exact(parameter)).unwrap_or(0.0)
    }

    /// The same of a figure that is stated as exact: the session solved with another.
    fn by_exact(&self, parameter: usize) -> Option<f64> {
        let step = self.system.layout.parameters[parameter].step;
        let other = |sign: f64| {
            let mut start = self.solution.x.clone();
            start[parameter] += sign * step;
            let solution = self.system.solve(&start).ok()?;
            hull_scalar(self.system, &self.name, &solution.x)
        };
        Some((other(1.0)? - other(-1.0)?) / (2.0 * step * self.u))
    }
}
