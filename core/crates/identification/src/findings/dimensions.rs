//! Lengths against each other, against the hull, and what nothing tests.

use gyradius_base::message::Argument;
use gyradius_recording::{Quantity, Session, Swing};

use super::{Finding, FindingKind as Kind, Severity};
use crate::measurement::Measurement;
use crate::names::{InputKind, QuantityName, Subject};

/// A spacing of so many line lengths, or lines of so many spacings, are no suspension that anybody
/// hangs up: one of the two is in another unit.
const MOST_RATIO: f64 = 20.0;
const MOST_RATIO_OF_LINES: f64 = 300.0;
/// Points of suspension may lie a little beyond the hull's ends, on a frame.
const BEYOND_ENDS: f64 = 1.2;
/// A dimension with less than this share of a quantity's variance does not matter to it.
const MATTERS: f64 = 0.1;

/// Of the stated lengths.
pub fn of_dimensions(session: &Session) -> Vec<Finding> {
    session
        .swings
        .iter()
        .flat_map(|swing| {
            let found = lengths(session, swing);
            found.into_iter().map(|one| one.of_swing(&swing.id))
        })
        .collect()
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
        let hull = session.body.length_overall_m;
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
    let Some(length) = session.body.length_overall_m else {
        return vec![];
    };
    let names = [
        QuantityName::KYaw,
        QuantityName::KPitch,
        QuantityName::KRoll,
        QuantityName::CmDepth,
    ];
    let mut found = Vec::new();
    for name in names {
        let value = result.quantities.get(&name).and_then(|q| q.value.scalar());
        let most = match name {
            QuantityName::CmDepth => length,
            _ => length * std::f64::consts::FRAC_1_SQRT_2,
        };
        let Some(value) = value.filter(|value| *value > most) else {
            continue;
        };
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

/// Dimensions that matter to a quantity and that no consistency test reached.
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
                .find(|name| share_of(result, name, kind) > MATTERS)?;
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
