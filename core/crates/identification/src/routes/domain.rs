//! Domains of the routes' arguments: what is outside is an error that names the argument, never a
//! NaN.

use gyradius_base::{Error, Result};

/// A finite number greater than zero.
pub(super) fn positive(name: &str, value: f64) -> Result<f64> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::argument(name, "a number greater than 0", value))
    }
}

/// A finite number of zero or more.
pub(super) fn not_negative(name: &str, value: f64) -> Result<f64> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(Error::argument(name, "a number of 0 or more", value))
    }
}

/// Any finite number.
pub(super) fn finite(name: &str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::argument(name, "a finite number", value))
    }
}

/// A number strictly between two bounds.
pub(super) fn between(name: &str, value: f64, low: f64, high: f64) -> Result<f64> {
    if value > low && value < high {
        Ok(value)
    } else {
        Err(Error::argument(
            name,
            format!("a number between {low} and {high}"),
            value,
        ))
    }
}

/// Square root of a figure that is positive for every physical input.
pub(super) fn root(what: &str, square: f64) -> Result<f64> {
    if square.is_finite() && square > 0.0 {
        Ok(square.sqrt())
    } else {
        Err(Error::no_result(
            what,
            format!("its square comes out as {square}: the inputs contradict each other"),
        ))
    }
}

/// A computed figure that must be finite.
pub(super) fn result(what: &str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::no_result(
            what,
            "the formula has no finite value for these inputs",
        ))
    }
}
