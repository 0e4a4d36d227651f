//! Numbers as a measurer writes them: as many digits as the uncertainty allows.

use super::words::say;
use gyradius_base::language::{Language, minus};
use gyradius_recording::Quantity;

/// Digits of an uncertainty (GUM 7.2.6: at most two).
const DIGITS_OF_U: i32 = 2;
/// What stands where there is no number.
pub(super) const NOTHING: &str = "–";

/// Decimal places that show two digits of `u` after rounding.
pub(super) fn decimals_for(u: f64) -> usize {
    if !u.is_finite() || u <= 0.0 {
        return 0;
    }
    let places = DIGITS_OF_U - 1 - u.log10().floor() as i32;
    // 0.0996 rounds up to 0.100: one place fewer.
    let rounded = (u * 10f64.powi(places)).round();
    let places = if rounded >= 10f64.powi(DIGITS_OF_U) {
        places - 1
    } else {
        places
    };
    places.clamp(0, 12) as usize
}

/// `1.05660 ± 0.00090`.
pub(super) fn with_u(value: f64, u: f64) -> String {
    match (value.is_finite(), u.is_finite() && u > 0.0) {
        (false, _) => NOTHING.into(),
        (true, false) => significant(value, 6),
        (true, true) => {
            let places = decimals_for(u);
            format!("{} ± {u:.places$}", minus(&format!("{value:.places$}")))
        }
    }
}

/// A quantity with its unit: `3.4770 ± 0.0060 m`.
pub(super) fn with_unit(quantity: Quantity, unit: &str) -> String {
    joined(&with_u(quantity.value, quantity.u), unit)
}

/// A number and its unit; the sign of degrees stands close.
pub(super) fn joined(number: &str, unit: &str) -> String {
    match unit {
        "" => number.into(),
        "°" => format!("{number}°"),
        unit => format!("{number} {unit}"),
    }
}

/// A value alone, with the digits that its uncertainty allows.
pub(super) fn rounded(value: f64, u: f64) -> String {
    if !(u.is_finite() && u > 0.0) {
        return significant(value, 6);
    }
    let places = decimals_for(u);
    if value.is_finite() {
        minus(&format!("{value:.places$}"))
    } else {
        NOTHING.into()
    }
}

/// A difference's text with its sign; a zero has none.
pub(super) fn signed(difference: f64, text: &str) -> String {
    let is_zero = text.chars().all(|c| matches!(c, '0' | '.'));
    if difference > 0.0 && !is_zero {
        format!("+{text}")
    } else {
        text.into()
    }
}

/// An interval with the digits of the uncertainty: `1.0548 … 1.0584`.
pub(super) fn interval(bounds: [f64; 2], u: f64) -> String {
    format!("{} … {}", rounded(bounds[0], u), rounded(bounds[1], u))
}

/// So many significant digits, without an exponent where the size allows it.
pub(super) fn significant(value: f64, digits: i32) -> String {
    if !value.is_finite() {
        return NOTHING.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-6..9).contains(&exponent) {
        return minus(&format!("{value:.*e}", (digits - 1).max(0) as usize));
    }
    let places = (digits - 1 - exponent).max(0) as usize;
    let text = format!("{value:.places$}");
    let trimmed = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    minus(trimmed)
}

/// Unit prefix in which a small length of time or space reads best: factor and prefix.
pub(super) fn prefix(size: f64) -> (f64, &'static str) {
    match size.abs() {
        s if !s.is_finite() || s == 0.0 || s >= 0.5 => (1.0, ""),
        s if s >= 0.5e-3 => (1e3, "m"),
        _ => (1e6, "µ"),
    }
}

/// A number of standard uncertainties: two digits, and nothing finer than a hundredth.
pub(super) fn sigmas(value: f64) -> String {
    if value.abs() < 0.005 {
        "0".into()
    } else {
        significant((value * 100.0).round() / 100.0, 2)
    }
}

/// A probability in percent that does not round to certainty.
pub(super) fn percent(probability: f64, language: Language) -> String {
    match 100.0 * probability {
        p if !p.is_finite() => NOTHING.into(),
        p if p > 99.9 => say(language, "over_99_9", []),
        p if p < 0.1 => say(language, "under_0_1", []),
        p => language.number(&format!("{p:.1}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_uncertainty_has_two_digits() {
        assert_eq!(with_u(1.05661, 0.000899), "1.05661 ± 0.00090");
        assert_eq!(with_u(1.05661, 0.000996), "1.0566 ± 0.0010");
        assert_eq!(with_u(696.4, 12.3), "696 ± 12");
        assert_eq!(with_u(-5.52, 0.65), "−5.52 ± 0.65");
        assert_eq!(with_u(-0.004, 0.65), "0.00 ± 0.65");
    }

    #[test]
    fn what_is_no_number_is_a_dash() {
        assert_eq!(with_u(f64::NAN, 0.1), NOTHING);
        assert_eq!(with_u(2.5, f64::NAN), "2.5");
        assert_eq!(significant(f64::INFINITY, 3), NOTHING);
    }

    #[test]
    fn significant_digits() {
        assert_eq!(significant(0.0123456, 3), "0.0123");
        assert_eq!(significant(622.7, 6), "622.7");
        assert_eq!(significant(1200.0, 2), "1200");
    }

    #[test]
    fn sigmas_need_no_millionths() {
        assert_eq!([5.8e-6, 0.114, 19.04].map(sigmas), ["0", "0.11", "19"]);
    }
}
