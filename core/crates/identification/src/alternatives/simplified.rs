//! What a single route leaves out: run on the figures that the joint estimate predicts, it should
//! give back the joint estimate's quantity. What it misses by is part of its uncertainty.

use crate::estimate::{Solution, System};
use crate::names::{Origin, QuantityName, RouteMethod};
use crate::outputs::{hull_scalar, with_principal_axes_turned};

use super::{RouteCalculation, of_figures};

/// A simplification smaller than this share of a route's other uncertainty is not worth a line.
const LEAST_SHARE: f64 = 0.01;

/// Gives every route its simplification as an input of its own, judged at the solution and, the
/// principal axes being hard to know, where they are turned by their standard uncertainty.
pub fn widen(system: &System, solution: &Solution, routes: &mut [RouteCalculation]) {
    let turned = with_principal_axes_turned(system, solution);
    let judged: Vec<Vec<Missed>> = [Some(solution), turned.as_ref()]
        .into_iter()
        .flatten()
        .map(|s| missed(system, s))
        .collect();
    for route in routes {
        let misses = judged
            .iter()
            .flatten()
            .filter(|m| m.is_of(route))
            .map(|m| m.by.abs());
        let most = misses.fold(0.0, f64::max);
        if most > LEAST_SHARE * route.figure.u() {
            let from: Vec<String> = route.from.iter().map(Origin::to_string).collect();
            let input = format!("what {} leaves out, {}", route.method, from.join(", "));
            route.figure.by_input.insert(input, most);
        }
    }
}

/// How far a route misses the quantity it is for.
struct Missed {
    quantity: QuantityName,
    method: RouteMethod,
    from: Vec<Origin>,
    by: f64,
}

impl Missed {
    fn is_of(&self, route: &RouteCalculation) -> bool {
        self.quantity == route.quantity && self.method == route.method && self.from == route.from
    }
}

fn missed(system: &System, solution: &Solution) -> Vec<Missed> {
    let Some(ideal) = system.as_solved(solution) else {
        return vec![];
    };
    let miss = |route: RouteCalculation| {
        let meant = hull_scalar(&ideal, &route.quantity, &solution.x)?;
        let RouteCalculation {
            quantity,
            method,
            from,
            figure,
            ..
        } = route;
        Some(Missed {
            quantity,
            method,
            from,
            by: figure.value - meant,
        })
    };
    of_figures(&ideal, solution, &[])
        .into_iter()
        .filter_map(miss)
        .collect()
}
