//! Depth of the centre of mass by weights hung from the ends, and by moving the suspension points.

use crate::estimate::{Observation, Observed, Solution, System};
use crate::names::{Origin, QuantityName, RouteMethod};
use crate::routes::incline::{
    BothEnds, Weight, cm_depth_from_both_ends_m, cm_depth_from_shift_m, cm_depth_m,
};
use crate::theory::hull_alone;
use crate::traced::Traced;
use gyradius_recording::End;

use super::{RouteCalculation, stated};

/// Each incline by itself.
pub fn routes(system: &System, solution: &Solution) -> Vec<RouteCalculation> {
    let Some(depth_shift_m) = hull_above_hanging_m(system, solution) else {
        return vec![];
    };
    let ends = system
        .observations
        .iter()
        .filter_map(|o| one_end(system, o, depth_shift_m));
    let moved = system
        .observations
        .iter()
        .filter_map(|o| moved_points(system, o, depth_shift_m));
    ends.chain(moved)
        .chain(both_ends(system, depth_shift_m))
        .collect()
}

/// How much deeper the hull's own centre lies than that of everything that hangs, m.
fn hull_above_hanging_m(system: &System, solution: &Solution) -> Option<f64> {
    let depth = system.layout.level_or_first_depth()?;
    let hull = hull_alone(system.session, &system.layout, &solution.x, depth).ok()?;
    Some(-hull.cm_m.z - solution.x[depth].exp())
}

fn one_end(
    system: &System,
    observed: &Observation,
    depth_shift_m: f64,
) -> Option<RouteCalculation> {
    let Observed::Incline(i) = observed.what else {
        return None;
    };
    let incline = &system.session.inclines[i];
    let angle = Traced::input(observed.label.to_string(), observed.value);
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
        quantity: QuantityName::CmDepth,
        method: RouteMethod::Incline,
        equation: "(20)",
        from: vec![Origin::Incline(observed.label.kind)],
        figure: figure.ok()?,
        interval_95: None,
    })
}

/// Suspension points moved along the deck, and the tilt that follows.
fn moved_points(
    system: &System,
    observed: &Observation,
    depth_shift_m: f64,
) -> Option<RouteCalculation> {
    let Observed::Moved(i) = observed.what else {
        return None;
    };
    let moved_m = Traced::input(observed.label.to_string(), observed.value);
    let pitch_deg = stated(system, system.layout.swings[i].pitch_deg);
    let figure = Traced::combine(&[&moved_m, &pitch_deg], |v| {
        Ok(cm_depth_from_shift_m(v[0], v[1].to_radians())? + depth_shift_m)
    });
    Some(RouteCalculation {
        quantity: QuantityName::CmDepth,
        method: RouteMethod::PointsMoved,
        equation: "Δ / tan φ",
        from: vec![Origin::Swing(system.session.swings[i].id.clone())],
        figure: figure.ok()?,
        interval_95: None,
    })
}

/// (21): the same weight at both ends; where the suspension points stand between them drops out.
fn both_ends(system: &System, depth_shift_m: f64) -> Option<RouteCalculation> {
    let at = |end: End| {
        system.observations.iter().find_map(|o| match o.what {
            Observed::Incline(i) if system.session.inclines[i].end == end => {
                Some((o, &system.session.inclines[i]))
            }
            _ => None,
        })
    };
    let ((bow_seen, bow), (stern_seen, stern)) = (at(End::Bow)?, at(End::Stern)?);
    if bow.mass_kg != stern.mass_kg {
        return None;
    }
    let angle = |o: &Observation| Traced::input(o.label.to_string(), o.value);
    let parts = [
        &angle(bow_seen),
        &angle(stern_seen),
        &stated(system, system.layout.mass),
    ];
    let figure = Traced::combine(&parts, |v| {
        let test = BothEnds {
            mass_ratio: bow.mass_kg.value / v[2],
            length_m: bow.arm_m.value + stern.arm_m.value,
            bow_depth_m: bow.depth_m.value,
            stern_depth_m: stern.depth_m.value,
            bow_angle_rad: v[0].to_radians(),
            stern_angle_rad: v[1].to_radians(),
        };
        Ok(cm_depth_from_both_ends_m(&test)? + depth_shift_m)
    });
    Some(RouteCalculation {
        quantity: QuantityName::CmDepth,
        method: RouteMethod::InclineBothEnds,
        equation: "(21)",
        from: [bow_seen, stern_seen]
            .map(|o| Origin::Incline(o.label.kind))
            .to_vec(),
        figure: figure.ok()?,
        interval_95: None,
    })
}
