//! The beat of yaw against sway, and the gyradius from counting oscillations per beat (eqs. 9–13).
//!
//! # Conventions
//! n counts oscillations of the average motion from one amplitude minimum to the next. The count
//! alone does not say which of the two is the slower: the caller does (`yaw_is_slower`: k > d, the
//! case for lines at the sheer).

use super::domain::{positive, result};
use gyradius_base::{Error, Result};

/// Period of the average oscillation, s.
pub fn average_period_s(yaw_period_s: f64, sway_period_s: f64) -> Result<f64> {
    let yaw = positive("yaw_period_s", yaw_period_s)?;
    let sway = positive("sway_period_s", sway_period_s)?;
    result("average period", 2.0 * yaw * sway / (yaw + sway)) // (10)
}

/// Time from one amplitude minimum to the next, s. Equal periods do not beat.
pub fn beat_period_s(yaw_period_s: f64, sway_period_s: f64) -> Result<f64> {
    let yaw = positive("yaw_period_s", yaw_period_s)?;
    let sway = positive("sway_period_s", sway_period_s)?;
    result("beat period", yaw * sway / (yaw - sway).abs()) // (11)
}

/// Oscillations per beat, n.
pub fn oscillations_per_beat(yaw_period_s: f64, sway_period_s: f64) -> Result<f64> {
    let beat = beat_period_s(yaw_period_s, sway_period_s)?;
    result(
        "oscillations per beat",
        beat / average_period_s(yaw_period_s, sway_period_s)?,
    ) // (12)
}

/// T_y / T_s from the count.
pub fn period_ratio(oscillations_per_beat: f64, yaw_is_slower: bool) -> Result<f64> {
    if !oscillations_per_beat.is_finite() || oscillations_per_beat <= 0.5 {
        let expected = "a count greater than 1/2";
        return Err(Error::argument(
            "oscillations_per_beat",
            expected,
            oscillations_per_beat,
        ));
    }
    let slower = (2.0 * oscillations_per_beat + 1.0) / (2.0 * oscillations_per_beat - 1.0); // (13)
    Ok(if yaw_is_slower { slower } else { 1.0 / slower })
}

/// Yaw gyradius from the count and the half spacing, m.
pub fn yaw_gyradius_m(
    oscillations_per_beat: f64,
    half_spacing_m: f64,
    yaw_is_slower: bool,
) -> Result<f64> {
    let ratio = period_ratio(oscillations_per_beat, yaw_is_slower)?;
    result(
        "yaw gyradius",
        ratio * positive("half_spacing_m", half_spacing_m)?,
    ) // (13)
}
