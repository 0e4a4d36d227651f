//! What keeps an uncertainty from being reached, and what would mend it.

use super::hull::Hull;
use super::means::Means;
use super::search::Way;
use super::wanted::Wanted;
use super::warnings::{Warning, WarningKind};
use gyradius_identification::{BudgetLine, InputKind, QuantityName};

/// A figure of the hull rougher than this is worth a word.
const ROUGH: f64 = 0.15;

/// Of every quantity that is wanted and not reached: which input is to blame, and how well it would
/// have to be known.
pub fn not_reached(hull: &Hull, means: &Means, wanted: &[Wanted], way: &Way) -> Vec<Warning> {
    wanted
        .iter()
        .filter_map(|w| one(hull, means, w, way))
        .collect()
}

fn one(hull: &Hull, means: &Means, wanted: &Wanted, way: &Way) -> Option<Warning> {
    let name = short(&wanted.quantity);
    let Some(found) = way.expected.quantities.get(&wanted.quantity) else {
        return Some(Warning::new(
            WarningKind::NotDetermined,
            None,
            &[],
            &[("quantity", name)],
        ));
    };
    let (value, u, wanted_u) = (found.value.scalar()?, found.u.scalar()?, wanted.u_of(hull));
    if u <= wanted_u {
        return None;
    }
    let worst = way.expected.budget.get(&wanted.quantity)?.first()?;
    let needed = needed(u, wanted_u, worst);
    if worst.input == InputKind::Spacing.into() && value > 0.0 {
        let better = needed.unwrap_or(0.5 * wanted_u) / worst.u_contribution;
        let numbers = [
            ("reached_percent", 100.0 * u / value),
            ("wanted_percent", 100.0 * wanted_u / value),
            ("spacing_m", way.design.spacing_m),
            ("u_input_mm", 1e3 * means.u_spacing_m),
            ("u_input_needed_mm", 1e3 * means.u_spacing_m * better),
            // k = (T_y/T_s) d: the same error of the tape is a smaller part of a wider spacing.
            ("spacing_needed_m", way.design.spacing_m / better),
        ];
        return Some(Warning::new(
            WarningKind::SpacingTooShort,
            None,
            &numbers,
            &[("quantity", name)],
        ));
    }
    let numbers = [
        ("reached_u", u),
        ("wanted_u", wanted_u),
        ("contribution_u", worst.u_contribution),
        (
            "times_better",
            worst.u_contribution / needed.unwrap_or(0.5 * wanted_u),
        ),
    ];
    Some(Warning::new(
        WarningKind::NotReached,
        None,
        &numbers,
        &[("quantity", name), ("input", &worst.input.to_string())],
    ))
}

/// What the largest contribution may be at most; `None` where the others alone are too much.
fn needed(u: f64, wanted_u: f64, worst: &BudgetLine) -> Option<f64> {
    let others = u * u - worst.u_contribution * worst.u_contribution;
    let room = wanted_u * wanted_u - others;
    (room > 0.0).then(|| room.sqrt())
}

/// The depth of the centre of mass, by which the lines' length is chosen, is often little more than
/// a guess.
pub fn rough(hull: &Hull) -> Vec<Warning> {
    let figures = [
        ("depth", hull.cm_depth_m),
        ("k_pitch", hull.k_pitch_m),
        ("k_yaw", hull.k_yaw_m),
    ];
    let share = |q: &gyradius_recording::Quantity| q.u / q.value;
    let rough = figures.iter().filter(|(_, q)| share(q) > ROUGH);
    let warning = |(name, q): &(&str, gyradius_recording::Quantity)| {
        Warning::new(
            WarningKind::RoughHull,
            None,
            &[("u_percent", 100.0 * share(q))],
            &[("quantity", name)],
        )
    };
    rough.map(warning).collect()
}

/// A quantity without its unit.
fn short(quantity: &QuantityName) -> &str {
    match quantity {
        QuantityName::KYaw => "k_yaw",
        QuantityName::KPitch => "k_pitch",
        QuantityName::KRoll => "k_roll",
        QuantityName::CmDepth => "depth",
        QuantityName::Psi => "psi",
        other => other.as_str(),
    }
}
