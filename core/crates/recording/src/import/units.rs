//! Units and signs of other programs, turned into the core's.

use std::str::FromStr;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::{Error, Result};

/// Accelerations of iOS (in g, at rest, screen up: z = −1) as specific force, m/s² (z = +9.80665).
pub fn from_core_motion(acceleration_g: [f64; 3]) -> [f64; 3] {
    acceleration_g.map(|a| -STANDARD_GRAVITY_M_S2 * a)
}

/// A time stamp of iOS, seconds since the phone was switched on, as ns.
pub fn stamp_from_core_motion(timestamp_s: f64) -> Result<i64> {
    let stamp_ns = (1e9 * timestamp_s).round();
    // A NaN is not below it either.
    if stamp_ns.abs() < MOST_STAMP_NS {
        return Ok(stamp_ns as i64);
    }
    Err(Error::argument(
        "timestamp_s",
        "seconds since the phone was switched on",
        timestamp_s,
    ))
}

/// 2⁵³, 104 days: up to there a float tells whole ns apart.
const MOST_STAMP_NS: f64 = 9_007_199_254_740_992.0;

/// A unit of a mapped column: `s`, `ms`, `us`, `ns`, `rad/s`, `deg/s`, `m/s2`, `g`, `m`, `mm`,
/// `cm`. A leading minus turns the sign (`-g` for raw iOS accelerations).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// What the unit measures.
    pub quantity: Dimension,
    /// Factor to s, rad/s, m/s² or m.
    pub factor: f64,
}

/// What a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Dimension {
    Time,
    AngularRate,
    Acceleration,
    Length,
}

impl FromStr for Unit {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let bare = text.strip_prefix(['-', '−']);
        let sign = if bare.is_some() { -1.0 } else { 1.0 };
        let (quantity, factor) = match bare.unwrap_or(text) {
            "s" => (Dimension::Time, 1.0),
            "ms" => (Dimension::Time, 1e-3),
            "us" | "µs" | "μs" => (Dimension::Time, 1e-6),
            "ns" => (Dimension::Time, 1e-9),
            "rad/s" => (Dimension::AngularRate, 1.0),
            "deg/s" | "°/s" => (Dimension::AngularRate, 1f64.to_radians()),
            "m/s2" | "m/s^2" | "m/s²" => (Dimension::Acceleration, 1.0),
            "g" => (Dimension::Acceleration, STANDARD_GRAVITY_M_S2),
            "m" => (Dimension::Length, 1.0),
            "cm" => (Dimension::Length, 1e-2),
            "mm" => (Dimension::Length, 1e-3),
            _ => {
                return Err(Error::argument(
                    "unit",
                    "s, ms, us, ns, rad/s, deg/s, m/s2, g, m, mm or cm",
                    text,
                ));
            }
        };
        Ok(Self {
            quantity,
            factor: sign * factor,
        })
    }
}

/// A unit as a header writes it in brackets; programs differ in `°`, `^2` and spaces.
pub(super) fn unit_of_header(unit: &str) -> Option<Unit> {
    let unit = unit.trim().to_lowercase();
    // A degree sign in another encoding than UTF-8 reads as a replacement character.
    let plain = unit.replace('\u{fffd}', "°").replace("seconds", "s");
    plain.parse().ok()
}
