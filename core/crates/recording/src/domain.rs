//! Which numbers a key may hold, and how well they are known where nobody says.

use std::fmt;

use super::session::InstrumentKind;
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;

/// Gravity between the equator (9.780) and the poles (9.832) against the standard value.
const STANDARD_GRAVITY_U_M_S2: f64 = 0.015;

/// No figure of a body that swings is larger, in SI units: a slip of the keyboard or a damaged file.
pub(crate) const MOST: f64 = 1e12;

/// The unit of the last digit of a number as it is written: 0.001 of `4.391`, 10 of `12e1`.
fn last_digit(written: &str) -> f64 {
    let written = written.trim().replace('_', "").to_lowercase();
    let (digits, exponent) = written.split_once('e').unwrap_or((&written, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let exponent = exponent.parse::<i32>().unwrap_or(0);
    10f64.powi(exponent - decimals as i32)
}

/// A range of finite numbers, with its meaning for messages.
#[derive(Debug, Clone, Copy)]
pub struct Domain {
    what: &'static str,
    low: f64,
    high: f64,
    /// Whether `low` itself is allowed.
    closed: bool,
    /// The standard uncertainty of a figure that is stated without one.
    usual: Usual,
}

/// The usual standard uncertainty of a reading, by what it is read with (`core/docs`, session
/// format: "a dimension without u").
#[derive(Debug, Clone, Copy, PartialEq)]
enum Usual {
    /// It is taken as exact.
    Exact,
    /// A tape or a scale or a protractor: so much, and so large a part of the reading.
    Reading { fixed: f64, part: f64 },
    /// A figure that was rounded to its last digit: a unit of it over √12.
    LastDigit,
    /// The same of gravity, but for the standard value, which is nobody's reading: it is taken
    /// where the local one is not known, which lies within 0.026 m/s² of it (rectangular).
    Gravity,
}

impl Domain {
    /// Values above one that is itself left out.
    pub const fn above(what: &'static str, low: f64) -> Self {
        Self {
            what,
            low,
            high: MOST,
            closed: false,
            usual: Usual::Exact,
        }
    }

    /// Values from one on.
    pub const fn at_least(what: &'static str, low: f64) -> Self {
        Self {
            what,
            low,
            high: MOST,
            closed: true,
            usual: Usual::Exact,
        }
    }

    /// Values between two, both included.
    pub const fn between(what: &'static str, low: f64, high: f64) -> Self {
        Self {
            what,
            low,
            high,
            closed: true,
            usual: Usual::Exact,
        }
    }

    const fn usually(self, usual: Usual) -> Self {
        Self { usual, ..self }
    }

    /// What reads such figures; none of what is only stated.
    pub(crate) fn instrument(&self) -> Option<InstrumentKind> {
        let readers = [
            (Self::TAPE, InstrumentKind::Tape),
            (Self::SCALE, InstrumentKind::Scale),
            (Self::PROTRACTOR, InstrumentKind::Protractor),
            (Usual::LastDigit, InstrumentKind::Clock),
        ];
        let mut known = readers.iter().filter(|(usual, _)| *usual == self.usual);
        known.next().map(|(_, kind)| *kind)
    }

    /// The standard uncertainty of a value that is stated without one; `written` is its text. The
    /// part that grows with the reading is the instrument's, where one is named.
    pub(crate) fn usual_u(&self, value: f64, written: &str, has_instrument: bool) -> f64 {
        match self.usual {
            Usual::Reading { fixed, .. } if has_instrument && fixed > 0.0 => fixed,
            Usual::Exact => 0.0,
            Usual::Reading { fixed, part } => fixed + part * value.abs(),
            Usual::Gravity if value == STANDARD_GRAVITY_M_S2 => STANDARD_GRAVITY_U_M_S2,
            Usual::LastDigit | Usual::Gravity => last_digit(written) / 12f64.sqrt(),
        }
    }

    /// A tape of class II and an eye: 2 mm and 0.05 %.
    const TAPE: Usual = Usual::Reading {
        fixed: 2e-3,
        part: 5e-4,
    };
    const SCALE: Usual = Usual::Reading {
        fixed: 0.0,
        part: 2e-3,
    };
    const PROTRACTOR: Usual = Usual::Reading {
        fixed: 0.3,
        part: 0.0,
    };

    pub(crate) const LENGTH: Self = Self::above("a length in m above 0", 0.0).usually(Self::TAPE);
    pub(crate) const MASS: Self = Self::above("a mass in kg above 0", 0.0).usually(Self::SCALE);
    pub(crate) const DENSITY: Self = Self::above("a density in kg/m³ above 0", 0.0);
    pub(crate) const AIR_DENSITY: Self =
        Self::at_least("a density in kg/m³, 0 (no air) or above", 0.0);
    pub(crate) const PERIOD: Self =
        Self::above("a period in s above 0", 0.0).usually(Usual::LastDigit);
    pub(crate) const UNCERTAINTY: Self = Self::at_least("a standard uncertainty, 0 or above", 0.0);
    pub(crate) const GYRADIUS: Self = Self::at_least("a length in m, 0 or above", 0.0);
    pub(crate) const TIME: Self = Self::between("a finite time in s", f64::MIN, f64::MAX);
    pub(crate) const FULL_SCALE: Self = Self::above("a sensor's full scale above 0", 0.0);
    pub(crate) const COORDINATE: Self =
        Self::between("a finite length in m", -MOST, MOST).usually(Self::TAPE);
    /// From the Moon (1.6) to Jupiter (25): what lies outside is in another unit.
    pub(crate) const GRAVITY: Self =
        Self::between("an acceleration in m/s² from 1 to 30", 1.0, 30.0).usually(Usual::Gravity);
    pub(crate) const LATITUDE: Self =
        Self::between("a latitude in degrees from -90 to 90", -90.0, 90.0);
    pub(crate) const ALTITUDE: Self =
        Self::between("an altitude in m from -1000 to 20000", -1e3, 2e4);
    /// A pitch angle of the hull.
    pub const PITCH: Self =
        Self::between("an angle in degrees from -90 to 90", -90.0, 90.0).usually(Self::PROTRACTOR);
    pub(crate) const INCLINE: Self = Self {
        what: "an angle in degrees above 0, at most 89",
        low: 0.0,
        high: 89.0,
        closed: false,
        usual: Self::PROTRACTOR,
    };
    pub(crate) const AMPLITUDE: Self =
        Self::between("an angle in degrees from 0 to 180", 0.0, 180.0);

    /// Whether a value is its upper end.
    pub(crate) fn reaches(&self, value: f64) -> bool {
        self.high == value
    }

    pub(crate) fn holds(&self, value: f64) -> bool {
        value.is_finite()
            && value <= self.high
            && (value > self.low || (self.closed && value == self.low))
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.what)
    }
}

#[cfg(test)]
mod tests {
    use super::Domain;

    #[test]
    fn what_is_stated_without_u_has_the_usual_one() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * b.max(1e-9), "{a} {b}");
        close(Domain::LENGTH.usual_u(3.477, "3.477", false), 0.0037385);
        close(Domain::MASS.usual_u(622.7, "622.7", false), 1.2454);
        close(Domain::PITCH.usual_u(25.0, "25", false), 0.3);
        close(
            Domain::PERIOD.usual_u(4.391, "4.391", false),
            1e-3 / 12f64.sqrt(),
        );
        close(
            Domain::PERIOD.usual_u(4.0, " 4 ", false),
            1.0 / 12f64.sqrt(),
        );
        close(
            Domain::PERIOD.usual_u(4391.0, "4.391e3", false),
            1.0 / 12f64.sqrt(),
        );
        close(
            Domain::GRAVITY.usual_u(9.81, "9.81", false),
            1e-2 / 12f64.sqrt(),
        );
        close(Domain::GRAVITY.usual_u(9.80665, "9.80665", false), 0.015);
        close(Domain::LENGTH.usual_u(3.477, "3.477", true), 0.002);
        close(Domain::MASS.usual_u(622.7, "622.7", true), 1.2454);
        assert_eq!(Domain::DENSITY.usual_u(750.0, "750", false), 0.0);
    }

    #[test]
    fn ends_are_open_or_closed_as_said_and_nothing_infinite_holds() {
        assert!(
            !Domain::LENGTH.holds(0.0) && Domain::LENGTH.holds(1e-9) && !Domain::LENGTH.holds(-1.0)
        );
        assert!(
            Domain::UNCERTAINTY.holds(0.0)
                && Domain::LATITUDE.holds(-90.0)
                && !Domain::LATITUDE.holds(90.1)
        );
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!Domain::COORDINATE.holds(value) && !Domain::LENGTH.holds(value));
        }
    }
}
