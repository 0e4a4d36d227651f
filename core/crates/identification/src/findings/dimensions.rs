//! Lengths against each other, against the hull, and what nothing tests.

use gyradius_base::message::Argument;
use gyradius_recording::{Attachment, ModeName, Quantity, Session, Swing, SwingData};

use super::{Finding, FindingKind as Kind, Severity};
use crate::measurement::{Measurement, SwingResult};
use crate::names::{InputKind, QuantityName, Subject};

/// A spacing of so many line lengths, or lines of so many spacings, are no suspension that anybody
/// hangs up: one of the two is in another unit.
const MOST_RATIO: f64 = 20.0;
const MOST_RATIO_OF_LINES: f64 = 300.0;
/// Points of suspension may lie a little beyond the hull's ends, on a frame.
const BEYOND_ENDS: f64 = 1.2;
/// Less than this share of a quantity's variance is rounding.
const ROUNDING: f64 = 1e-9;

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

/// Dimensions that a quantity depends on and that no consistency test reached: a slip in one of them
/// moves it, however small a share of its uncertainty that dimension has.
pub fn unchecked(result: &Measurement) -> Vec<Finding> {
    let lengths = [
        InputKind::Spacing,
        InputKind::TopSpacing,
        InputKind::LineLength,
        InputKind::AxisHeight,
    ];
    let is_tested = |kind: InputKind| {
        let tested = |c: &crate::measurement::Claim| c.claim == Subject::Stated(kind);
        result.consistency.iter().any(tested)
    };
    lengths
        .into_iter()
        .filter(|kind| !is_tested(*kind))
        .filter_map(|kind| {
            let concerned = QuantityName::SCALARS
                .into_iter()
                .find(|name| share_of(result, name, kind) > ROUNDING)?;
            let quantity = crate::sentences::name(&format!("quantity.{concerned}"));
            let finding = Finding::new(
                (Kind::UncheckedDimension, Severity::Noted),
                "unchecked",
                [
                    ("name", Argument::Texts(vec![kind.in_words()])),
                    ("quantity", quantity),
                ],
            );
            Some(finding.of_channel(kind.name()))
        })
        .collect()
}

fn share_of(result: &Measurement, name: &QuantityName, kind: InputKind) -> f64 {
    let Some(lines) = result.budget.get(name) else {
        return 0.0;
    };
    let square = |line: &crate::measurement::BudgetLine| line.u_contribution.powi(2);
    let all: f64 = lines.iter().map(square).sum();
    let own: f64 = lines
        .iter()
        .filter(|line| line.input.kind == kind)
        .map(square)
        .sum();
    own / all.max(f64::MIN_POSITIVE)
}
