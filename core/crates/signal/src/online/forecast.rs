//! How long the recording must go on.

use super::spread::Spread;
use super::state::TimeLeft;

/// Longest recording that is thought of, s: two hours.
const LONGEST_S: f64 = 7200.0;
/// The span is found to this part of itself.
const PRECISION: f64 = 1e-3;

/// Time until noise leaves the frequency no more uncertain than this part of it, from a span of so
/// many seconds. What the frequency does with the amplitude is no uncertainty of a record that has
/// its own mean amplitude.
pub(super) fn time_left(spread: &Spread, omega_rad_s: f64, span_s: f64, wanted: f64) -> TimeLeft {
    let enough = |span_s: f64| spread.noise_rad_s(span_s) <= wanted * omega_rad_s;
    if enough(span_s) {
        return TimeLeft::Reached;
    }
    if span_s >= LONGEST_S || !enough(LONGEST_S) {
        return TimeLeft::OutOfReach;
    }
    let (mut low_s, mut high_s) = (span_s, LONGEST_S);
    while high_s - low_s > PRECISION * high_s {
        let middle_s = 0.5 * (low_s + high_s);
        if enough(middle_s) {
            high_s = middle_s
        } else {
            low_s = middle_s
        }
    }
    TimeLeft::Seconds(high_s - span_s)
}
