//! Which numbers a key may hold.

use std::fmt;

/// A range of finite numbers, with its meaning for messages.
#[derive(Debug, Clone, Copy)]
pub struct Domain {
    what: &'static str,
    low: f64,
    high: f64,
    /// Whether `low` itself is allowed.
    closed: bool,
}

impl Domain {
    /// Values above one that is itself left out.
    pub const fn above(what: &'static str, low: f64) -> Self {
        Self {
            what,
            low,
            high: f64::MAX,
            closed: false,
        }
    }

    /// Values from one on.
    pub const fn at_least(what: &'static str, low: f64) -> Self {
        Self {
            what,
            low,
            high: f64::MAX,
            closed: true,
        }
    }

    /// Values between two, both included.
    pub const fn between(what: &'static str, low: f64, high: f64) -> Self {
        Self {
            what,
            low,
            high,
            closed: true,
        }
    }

    pub(crate) const LENGTH: Self = Self::above("a length in m above 0", 0.0);
    pub(crate) const MASS: Self = Self::above("a mass in kg above 0", 0.0);
    pub(crate) const DENSITY: Self = Self::above("a density in kg/m³ above 0", 0.0);
    pub(crate) const AIR_DENSITY: Self =
        Self::at_least("a density in kg/m³, 0 (no air) or above", 0.0);
    pub(crate) const PERIOD: Self = Self::above("a period in s above 0", 0.0);
    pub(crate) const UNCERTAINTY: Self = Self::at_least("a standard uncertainty, 0 or above", 0.0);
    pub(crate) const GYRADIUS: Self = Self::at_least("a length in m, 0 or above", 0.0);
    pub(crate) const TIME: Self = Self::between("a finite time in s", f64::MIN, f64::MAX);
    pub(crate) const FULL_SCALE: Self = Self::above("a sensor's full scale above 0", 0.0);
    pub(crate) const COORDINATE: Self = Self::between("a finite length in m", f64::MIN, f64::MAX);
    /// From the Moon (1.6) to Jupiter (25): what lies outside is in another unit.
    pub(crate) const GRAVITY: Self =
        Self::between("an acceleration in m/s² from 1 to 30", 1.0, 30.0);
    pub(crate) const LATITUDE: Self =
        Self::between("a latitude in degrees from -90 to 90", -90.0, 90.0);
    pub(crate) const ALTITUDE: Self =
        Self::between("an altitude in m from -1000 to 20000", -1e3, 2e4);
    /// A pitch angle of the hull.
    pub const PITCH: Self = Self::between("an angle in degrees from -90 to 90", -90.0, 90.0);
    pub(crate) const INCLINE: Self = Self {
        what: "an angle in degrees above 0, at most 89",
        low: 0.0,
        high: 89.0,
        closed: false,
    };
    pub(crate) const AMPLITUDE: Self =
        Self::between("an angle in degrees from 0 to 180", 0.0, 180.0);

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
