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

/// A unit of a mapped column: `s`, `ms`, `us`, `ns`, `100Hz` (numbers of samples or frames),
/// `clock` (a time of day, with or without a date); `rad/s`, `deg/s`; `m/s2`, `g`, `mg`; `m`, `cm`,
/// `mm`; `rad`, `deg`, `rev`.
///
/// # Conventions
/// A leading minus turns the sign (`-g` for raw iOS accelerations). A factor stands before a `*`:
/// `0.061*deg/s` for raw counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// What the unit measures.
    pub quantity: Dimension,
    /// Factor to s, rad/s, m/s², m or rad; 1 for a clock.
    pub factor: f64,
}

/// What a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Dimension {
    Time,
    /// A time of day as text.
    Clock,
    AngularRate,
    Acceleration,
    Length,
    Angle,
}

impl FromStr for Unit {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let bare = text.strip_prefix(['-', '−']);
        let sign = if bare.is_some() { -1.0 } else { 1.0 };
        let bare = bare.unwrap_or(text).trim();
        let (scale, name) = match bare.split_once('*') {
            Some((scale, name)) => (scale.trim().parse().unwrap_or(f64::NAN), name.trim()),
            None => (1.0, bare),
        };
        let known = plain_unit(name).filter(|_| scale.is_finite() && scale != 0.0);
        let (quantity, factor) = known.ok_or_else(|| {
            Error::argument(
                "unit",
                "s, ms, us, ns, a rate such as 100Hz, clock, rad/s, deg/s, m/s2, g, mg, m, mm, cm, \
                 rad, deg or rev, with a factor as in 0.061*deg/s if need be",
                text,
            )
        })?;
        Ok(Self {
            quantity,
            factor: sign * scale * factor,
        })
    }
}

/// Units that a header alone has: `mrad/s`, `rpm`, and a number before a unit of time (`0.1 ms`).
fn scaled(name: &str) -> Option<(Dimension, f64)> {
    match name {
        "mrad/s" => return Some((Dimension::AngularRate, 1e-3)),
        "mdps" | "mdeg/s" => return Some((Dimension::AngularRate, 1e-3_f64.to_radians())),
        "rpm" | "rev/min" | "u/min" => {
            return Some((Dimension::AngularRate, std::f64::consts::TAU / 60.0));
        }
        "rev/s" | "rps" => return Some((Dimension::AngularRate, std::f64::consts::TAU)),
        _ => {}
    }
    let end = name.find(|c: char| !c.is_ascii_digit() && c != '.')?;
    let count: f64 = name.get(..end)?.parse().ok()?;
    let unit = name.get(end..)?;
    let (quantity, factor) =
        plain_unit(unit).filter(|_| matches!(unit, "s" | "ms" | "us" | "ns"))?;
    (count > 0.0).then_some((quantity, count * factor))
}

fn plain_unit(name: &str) -> Option<(Dimension, f64)> {
    Some(match name {
        "s" => (Dimension::Time, 1.0),
        "ms" => (Dimension::Time, 1e-3),
        "us" | "µs" | "μs" => (Dimension::Time, 1e-6),
        "ns" => (Dimension::Time, 1e-9),
        "clock" | "date" => (Dimension::Clock, 1.0),
        "rad/s" => (Dimension::AngularRate, 1.0),
        "deg/s" | "°/s" | "dps" => (Dimension::AngularRate, 1f64.to_radians()),
        "m/s2" | "m/s^2" | "m/s²" => (Dimension::Acceleration, 1.0),
        "g" => (Dimension::Acceleration, STANDARD_GRAVITY_M_S2),
        "mg" => (Dimension::Acceleration, 1e-3 * STANDARD_GRAVITY_M_S2),
        "m" => (Dimension::Length, 1.0),
        "cm" => (Dimension::Length, 1e-2),
        "mm" => (Dimension::Length, 1e-3),
        "rad" => (Dimension::Angle, 1.0),
        "deg" | "°" => (Dimension::Angle, 1f64.to_radians()),
        "rev" => (Dimension::Angle, std::f64::consts::TAU),
        _ => {
            let rate = name
                .strip_suffix("Hz")
                .or_else(|| name.strip_suffix("fps"))
                .or_else(|| name.strip_suffix("/s"))?;
            let rate_hz: f64 = rate.trim().parse().ok()?;
            let usable = rate_hz.is_finite() && rate_hz > 0.0;
            return usable.then_some((Dimension::Time, 1.0 / rate_hz));
        }
    })
}

/// A unit as a header writes it in brackets; programs differ in `°`, `^2`, spaces and words.
pub(super) fn unit_of_header(unit: &str) -> Option<Unit> {
    // A degree sign or a square in another encoding than UTF-8 reads as a replacement character.
    let unit = unit.trim().to_lowercase();
    let known = |sign: &str| written(&unit.replace('\u{fffd}', sign));
    known("°").or_else(|| known("²"))
}

/// The same in characters that can all be read.
fn written(unit: &str) -> Option<Unit> {
    let plain: String = unit
        .chars()
        .filter(|c| !matches!(c, ' ' | '(' | ')'))
        .collect();
    let (above, below) = match plain.split_once('/') {
        Some((above, below)) => (above, Some(below)),
        None => (plain.as_str(), None),
    };
    let above = match above {
        "second" | "seconds" | "sec" | "secs" => "s",
        "millis" | "milliseconds" | "msec" => "ms",
        "micros" | "microseconds" | "usec" | "µsec" => "us",
        "nanos" | "nanoseconds" | "nsec" => "ns",
        "radian" | "radians" => "rad",
        "degree" | "degrees" | "º" => "deg",
        other => other,
    };
    let below = match below {
        Some("sec" | "second") => Some("s"),
        Some("s/s" | "sec^2" | "s**2") => Some("s2"),
        other => other,
    };
    let whole = below.map_or_else(|| above.to_owned(), |below| format!("{above}/{below}"));
    plain_unit(&whole)
        .or_else(|| scaled(&whole))
        .filter(|(quantity, _)| *quantity != Dimension::Clock)
        .map(|(quantity, factor)| Unit { quantity, factor })
}
