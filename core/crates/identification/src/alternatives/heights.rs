//! Lamboley's test: compound pendulum about two axes (22, 23).

use crate::names::{Origin, QuantityName, RouteMethod};
use crate::routes::compound::{HeightAndPeriod, Lamboley, lamboley};
use crate::traced::Traced;
use gyradius_recording::ModeName;

use super::{Bench, RouteCalculation};

/// Every pair of compound swings on one suspension direction and different heights.
pub fn routes(benches: &[Bench]) -> Vec<RouteCalculation> {
    let mut found = Vec::new();
    for (i, a) in benches.iter().enumerate() {
        let alike = |b: &&Bench| b.orientation() == a.orientation();
        found.extend(
            benches[i + 1..]
                .iter()
                .filter(alike)
                .filter_map(|b| two_heights(a, b))
                .flatten(),
        );
    }
    found
}

fn two_heights(a: &Bench, b: &Bench) -> Option<[RouteCalculation; 2]> {
    let height_and_period = |bench: &Bench| {
        Some((
            bench.stated(bench.index().axis_height)?,
            bench.period(ModeName::Compound)?,
        ))
    };
    let ((height_a, period_a), (height_b, period_b)) =
        (height_and_period(a)?, height_and_period(b)?);
    let parts = [&height_a, &period_a, &height_b, &period_b, &a.gravity()];
    let both = |v: &[f64]| -> gyradius_base::Result<Lamboley> {
        let at = |i: usize| HeightAndPeriod {
            axis_height_m: v[i],
            period_s: v[i + 1],
        };
        lamboley(at(0), at(2), v[4])
    };
    let (k_name, about) = a.compound_quantity();
    let route = |quantity, figure| RouteCalculation {
        quantity,
        method: RouteMethod::Lamboley,
        equation: "(22), (23)",
        from: vec![Origin::Swing(a.id()), Origin::Swing(b.id())],
        figure,
        interval_95: None,
    };
    let gyradius =
        Traced::combine(&parts, |v| Ok(a.share.gyradii[about] * both(v)?.gyradius_m)).ok()?;
    let depth = Traced::combine(&parts, |v| Ok(both(v)?.cm_depth_m + a.share.depth_m)).ok()?;
    Some([route(k_name, gyradius), route(QuantityName::CmDepth, depth)])
}
