//! A step within a trust region: the damping that makes it as long as the region is wide.
//!
//! J. J. Moré, "The Levenberg–Marquardt algorithm: implementation and theory", *Lecture Notes in
//! Mathematics* 630 (1978) 105, sec. 5; the scaling is that of sec. 6.

use crate::quadratic::{Least, Quadratic};

/// A step may be longer or shorter than the region by this share (Moré's σ).
const SLACK: f64 = 0.1;
/// Least share of the upper limit that a damping without a lower one is put at (Moré, step (a)).
const LEAST_SHARE: f64 = 1e-3;
/// Moré reports fewer than two factorisations a step on average; bounds make kinks, and halving a
/// bracket of three decades to [`SLACK`] takes six more.
const MOST_DAMPINGS: usize = 10;

/// The step that lowers the model most within a radius, in units of the scales; none where the
/// model has no finite step at all.
pub(crate) fn step_within(
    model: &Quadratic,
    undamped: Option<Least>,
    radius: f64,
) -> Option<Least> {
    let reach = |least: &Least| model.reach(&least.step);
    let undamped = match undamped {
        Some(least) if reach(&least) <= radius * (1.0 + SLACK) => return Some(least),
        other => other,
    };
    let mut high = scaled_slope(model) / radius;
    let mut low = 0.0;
    // Without bounds a Newton step from zero falls short; bounds make kinks, and it may not.
    let from_zero = undamped.map(|least| newton(model, &least, radius).min(high));
    let mut damping = from_zero.unwrap_or(LEAST_SHARE * high);
    let mut longest = None;
    for _ in 0..MOST_DAMPINGS {
        let Some(least) = model.least(damping) else {
            low = damping;
            damping = between(low, high);
            continue;
        };
        let length = reach(&least);
        let next = damping + newton(model, &least, radius);
        if length > radius * (1.0 + SLACK) {
            low = damping;
        } else if length >= radius * (1.0 - SLACK) {
            return Some(least);
        } else {
            (high, longest) = (damping, Some(least));
        }
        damping = if next > low && next < high {
            next
        } else {
            between(low, high)
        };
    }
    // The upper limit always gives a step that is short enough.
    longest.or_else(|| model.least(high))
}

/// Inside a bracket, in the logarithm.
fn between(low: f64, high: f64) -> f64 {
    (low * high).sqrt().max(LEAST_SHARE * high)
}

/// Length of the slope in units of the scales, without what is pressed against a bound.
pub(crate) fn scaled_slope(model: &Quadratic) -> f64 {
    let pressed = model.pressed();
    let free = (0..pressed.len()).filter(|k| !pressed[*k]);
    free.map(|k| model.gradient[k].powi(2) / model.scale2[k])
        .sum::<f64>()
        .sqrt()
}

/// Change of the damping by Newton's method on the reciprocal of the length (Moré, eq. 5.5).
fn newton(model: &Quadratic, least: &Least, radius: f64) -> f64 {
    let length = model.reach(&least.step);
    let pull = model.scale2.component_mul(&least.step);
    // Half of the slope of the length's square by the damping, sign reversed.
    let fall = pull.dot(&least.factor.solve(&pull));
    if fall <= 0.0 {
        return 0.0;
    }
    (length - radius) / radius * length * length / fall
}
