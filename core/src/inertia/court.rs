//! The consistency court: every stated dimension against what the swings imply, every route against every other.
//!
//! Sittings are unasked; what differs by more than [`FLAG_SIGMA`] standard uncertainties is flagged.

use crate::recording::{ModeName, Quantity};

use super::alternatives::RouteCalculation;
use super::estimate::{Observed, Solution, System};
use super::measurement::Claim;
use super::parameters::Role;
use super::routes::ratio::line_length_m;

/// A difference this large speaks up: chance does that once in 370 for a normal error.
pub const FLAG_SIGMA: f64 = 3.0;
/// Stated figures that can be tested, with the relative width to which they are opened.
const TESTABLE: [&str; 4] = ["line_length", "spacing", "top_spacing", "gravity"];
const OPENED_RELATIVE_U: f64 = 0.3;
/// An implied figure less certain than this says nothing about a tape.
const MOST_IMPLIED_RELATIVE_U: f64 = 0.05;

/// Every sitting of the court.
pub fn sit(system: &System, solution: &Solution, routes: &[RouteCalculation]) -> Vec<Claim> {
    let mut claims = sway_against_tape(system);
    claims.extend(stated_against_the_rest(system, solution));
    claims.extend(route_against_route(routes));
    claims.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    claims
}

/// Each sway period against the length of the lines, eq. (7) turned round: l = g T² / 4π².
fn sway_against_tape(system: &System) -> Vec<Claim> {
    let gravity = system.layout.parameters[system.layout.gravity].prior;
    system
        .observations
        .iter()
        .filter_map(|o| {
            let Observed::Period(i, ModeName::Sway) = o.what else { return None };
            let index = &system.layout.swings[i];
            if index.top_spacing != index.spacing {
                return None;
            }
            let stated = system.layout.parameters[index.line_length?].prior;
            let implied = line_length_m(o.value.value, gravity.value).ok()?;
            let relative = (2.0 * o.value.u / o.value.value).hypot(gravity.u / gravity.value);
            let implied = Quantity::new(implied, implied * relative);
            Some(claim(
                "line_length",
                stated,
                implied,
                &format!("sway period of {}", system.session.swings[i].id),
            ))
        })
        .collect()
}

/// Each stated dimension freed, and the session solved without it.
fn stated_against_the_rest(system: &System, solution: &Solution) -> Vec<Claim> {
    (0..system.layout.parameters.len()).filter_map(|i| one_stated(system, solution, i)).collect()
}

fn one_stated(system: &System, solution: &Solution, i: usize) -> Option<Claim> {
    let stated = &system.layout.parameters[i];
    if stated.role != Role::Stated || !TESTABLE.contains(&stated.name.as_str()) {
        return None;
    }
    let mut layout = system.layout.clone();
    layout.parameters[i].prior.u = OPENED_RELATIVE_U * stated.prior.value;
    layout.parameters[i].role = Role::Unknown;
    let opened = System { session: system.session, layout, observations: system.observations.clone() };
    let freed = opened.solve(&solution.x).ok()?;
    let derived = freed.derive(&opened.layout, |x| Some(x[i]))?;
    if derived.u > MOST_IMPLIED_RELATIVE_U * stated.prior.value {
        return None;
    }
    let from = super::outputs::budget(&opened, &freed, &derived)
        .into_iter()
        .take(2)
        .map(|line| line.input)
        .collect::<Vec<_>>()
        .join(", ");
    let implied = Quantity::new(derived.value, derived.u);
    Some(claim(&stated.name, stated.prior, implied, &format!("all swings together ({from})")))
}

fn claim(name: &str, stated: Quantity, implied: Quantity, from: &str) -> Claim {
    let difference = implied.value - stated.value;
    let sigma = difference.abs() / stated.u.hypot(implied.u).max(f64::MIN_POSITIVE);
    let flagged = sigma > FLAG_SIGMA;
    let text = format!(
        "{} is stated as {:.4} ± {:.4}; the {from} implies {:.4} ± {:.4}: {} ({sigma:.1} standard uncertainties).",
        name.replace('_', " "),
        stated.value,
        stated.u,
        implied.value,
        implied.u,
        if flagged { "they contradict each other" } else { "they agree" },
    );
    Claim {
        claim: name.into(),
        stated: stated.value,
        stated_u: stated.u,
        implied: implied.value,
        implied_u: implied.u,
        sigma,
        from: from.into(),
        flagged,
        text,
    }
}

/// Single routes to the same quantity, two by two; inputs they share cancel in the difference as they should.
fn route_against_route(routes: &[RouteCalculation]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (i, a) in routes.iter().enumerate() {
        for b in routes[i + 1..].iter().filter(|b| b.quantity == a.quantity) {
            claims.extend(pair(a, b));
        }
    }
    claims
}

fn pair(a: &RouteCalculation, b: &RouteCalculation) -> Option<Claim> {
    let quantity = |r: &RouteCalculation| Quantity::new(r.figure.value, r.figure.u());
    let (first, second) = (quantity(a), quantity(b));
    let u = a.figure.u_of_difference(&b.figure);
    // Two routes through the very same figures are one route.
    if u <= 1e-9 * first.value.abs() {
        return None;
    }
    let sigma = (first.value - second.value).abs() / u;
    let flagged = sigma > FLAG_SIGMA;
    let named =
        |r: &RouteCalculation| format!("{} from {}", r.method.replace('_', " "), r.from.join(" and "));
    let text = format!(
        "{}: {} gives {:.4} ± {:.4}, {} gives {:.4} ± {:.4}: {} ({sigma:.1} standard uncertainties of the difference).",
        a.quantity,
        named(a),
        first.value,
        first.u,
        named(b),
        second.value,
        second.u,
        if flagged { "they contradict each other" } else { "they agree" },
    );
    Some(Claim {
        claim: a.quantity.into(),
        stated: first.value,
        stated_u: first.u,
        implied: second.value,
        implied_u: second.u,
        sigma,
        from: format!("{} against {}", b.method, a.method),
        flagged,
        text,
    })
}
