//! Depth of the centre of mass by weights hung from the ends.

use crate::inertia::estimate::{Observation, Observed, Solution, System};
use crate::inertia::routes::incline::{Weight, cm_depth_m};
use crate::inertia::theory::hull_alone;
use crate::inertia::traced::Traced;

use super::{RouteCalculation, stated};

/// Each incline by itself.
pub fn routes(system: &System, solution: &Solution) -> Vec<RouteCalculation> {
    let Some(depth_shift_m) = hull_above_hanging_m(system, solution) else { return vec![] };
    system.observations.iter().filter_map(|o| one_end(system, o, depth_shift_m)).collect()
}

/// How much deeper the hull's own centre lies than that of everything that hangs, m.
fn hull_above_hanging_m(system: &System, solution: &Solution) -> Option<f64> {
    let depth = system.layout.swings.first()?.log_depth;
    let hull = hull_alone(system.session, &system.layout, &solution.x, depth).ok()?;
    Some(-hull.cm_m.z - solution.x[depth].exp())
}

fn one_end(system: &System, observed: &Observation, depth_shift_m: f64) -> Option<RouteCalculation> {
    let Observed::Incline(i) = observed.what else { return None };
    let incline = &system.session.inclines[i];
    let angle = Traced::input(observed.label.clone(), observed.value);
    let figure = Traced::combine(&[&angle, &stated(system, system.layout.mass)], |v| {
        let weight = Weight {
            mass_ratio: incline.mass_kg.value / v[1],
            arm_m: incline.arm_m.value,
            depth_m: incline.depth_m.value,
            angle_rad: v[0].to_radians(),
        };
        Ok(cm_depth_m(&weight)? + depth_shift_m)
    });
    Some(RouteCalculation {
        quantity: "cm_depth_m",
        method: "incline",
        equation: "(20)",
        from: vec![observed.label.clone()],
        figure: figure.ok()?,
    })
}
