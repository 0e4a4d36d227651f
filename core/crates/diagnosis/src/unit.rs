//! Units of the criticism's figures.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use gyradius_base::error::{Error, Result};

use gyradius_base::{named, written_as_text};
use gyradius_identification::InputKind;

named! {
    /// A unit of a figure.
    UnitName: "unit" {
        /// Not told.
        Untold = "",
        /// Hundredths.
        Percent = "%",
        /// A pure number.
        One = "1",
        /// Each metre.
        PerMetre = "1/m",
        /// Each radian.
        PerRadian = "1/rad",
        /// Each second.
        PerSecond = "1/s",
        /// Hertz.
        Hertz = "Hz",
        /// Newton.
        Newton = "N",
        /// Newton metre.
        NewtonMetre = "N m",
        /// Newton metre second.
        NewtonMetreSecond = "N m s",
        /// Newton metre second squared.
        NewtonMetreSecondSquared = "N m s^2",
        /// Newton metre per radian.
        NewtonMetrePerRadian = "N m/rad",
        /// Newton metre squared.
        NewtonMetreSquared = "N m^2",
        /// Newton second.
        NewtonSecond = "N s",
        /// Newton second per metre.
        NewtonSecondPerMetre = "N s/m",
        /// Newton second squared per metre squared.
        NewtonSecondSquaredPerMetreSquared = "N s^2/m^2",
        /// Newton per metre.
        NewtonPerMetre = "N/m",
        /// Kilogram.
        Kilogram = "kg",
        /// Kilogram metre.
        KilogramMetre = "kg m",
        /// Kilogram metre per second.
        KilogramMetrePerSecond = "kg m/s",
        /// Kilogram metre squared per radian.
        KilogramMetreSquaredPerRadian = "kg m^2/rad",
        /// Kilogram per metre.
        KilogramPerMetre = "kg/m",
        /// Metre.
        Metre = "m",
        /// Metre per newton.
        MetrePerNewton = "m/N",
        /// Metre per second.
        MetrePerSecond = "m/s",
        /// As parameters have it.
        MetrePerSecondSquared = "m/s^2",
        /// The same as readings and stated figures have it.
        MetrePerSecondSquaredRaised = "m/s²",
        /// Radian.
        Radian = "rad",
        /// Radian per second.
        RadianPerSecond = "rad/s",
        /// Radian per second squared.
        RadianPerSecondSquared = "rad/s^2",
        /// Second.
        Second = "s",
        /// Degree.
        Degree = "°",
    }
}

/// That of a stated figure.
impl From<InputKind> for UnitName {
    fn from(stated: InputKind) -> Self {
        match stated {
            InputKind::LineLength
            | InputKind::Spacing
            | InputKind::TopSpacing
            | InputKind::AxisHeight => Self::Metre,
            InputKind::Gravity => Self::MetrePerSecondSquaredRaised,
            InputKind::HullPitch | InputKind::HullRoll => Self::Degree,
            _ => Self::Untold,
        }
    }
}

impl UnitName {
    /// As names of parameters end in it: `N/m` is `n_m`.
    pub(super) fn in_names(self) -> String {
        let plain = self.name().to_lowercase().replace('^', "");
        plain.replace(['/', ' '], "_")
    }
}

/// Unit of a figure of the criticism.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unit {
    /// One with a name.
    Of(UnitName),
    /// So much for each kilogram of a mass that was not stated: `N/m for each kg`.
    ForEachKilogram(UnitName),
}

/// What follows the name of a unit for each kilogram.
const FOR_EACH_KILOGRAM: &str = " for each kg";

/// That of what has none.
impl Default for Unit {
    fn default() -> Self {
        Self::Of(UnitName::Untold)
    }
}

impl From<UnitName> for Unit {
    fn from(name: UnitName) -> Self {
        Self::Of(name)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Of(name) => write!(f, "{name}"),
            Self::ForEachKilogram(name) => write!(f, "{name}{FOR_EACH_KILOGRAM}"),
        }
    }
}

impl FromStr for Unit {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text.strip_suffix(FOR_EACH_KILOGRAM) {
            Some(name) => name.parse().map(Self::ForEachKilogram),
            None => text.parse().map(Self::Of),
        }
    }
}

written_as_text!(Unit);

impl schemars::JsonSchema for Unit {
    fn schema_name() -> Cow<'static, str> {
        "Unit".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let named = UnitName::ALL.iter().map(|name| Self::Of(*name));
        let by_mass = UnitName::ALL
            .iter()
            .map(|name| Self::ForEachKilogram(*name));
        let all: Vec<String> = named.chain(by_mass).map(|unit| unit.to_string()).collect();
        schemars::json_schema!({
            "description": "Unit of a figure of the criticism.",
            "type": "string",
            "enum": all,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_read_as_it_is_written() {
        for name in UnitName::ALL {
            for unit in [Unit::Of(*name), Unit::ForEachKilogram(*name)] {
                let json = serde_json::to_string(&unit).unwrap();
                assert_eq!(json, format!("\"{unit}\""));
                assert_eq!(serde_json::from_str::<Unit>(&json).unwrap(), unit);
            }
        }
        let error = serde_json::from_str::<Unit>("\"furlong\"").unwrap_err();
        assert!(error.to_string().contains("furlong"), "{error}");
    }
}
