//! What uncertainty is wanted of what.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::hull::Hull;
use gyradius_base::error::{Error, Result};
use gyradius_identification::QuantityName;

/// Quantities that can be asked for: short name, the name that measurements have, whether it is an
/// angle.
const NAMES: [(&str, QuantityName, bool); 5] = [
    ("k_yaw", QuantityName::KYaw, false),
    ("k_pitch", QuantityName::KPitch, false),
    ("k_roll", QuantityName::KRoll, false),
    ("depth", QuantityName::CmDepth, false),
    ("psi", QuantityName::Psi, true),
];

/// A standard uncertainty that is wanted: `k_yaw=0.1%`, `k_pitch=2mm`, `depth=0.005m`, `psi=1deg`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Wanted {
    /// The quantity, by the name that measurements have.
    pub quantity: QuantityName,
    /// Standard uncertainty, in the quantity's unit or as a part of it.
    pub u: f64,
    /// Whether `u` is a part of the quantity.
    pub is_relative: bool,
}

impl Wanted {
    /// The uncertainty in the quantity's own unit, for a hull.
    pub fn u_of(&self, hull: &Hull) -> f64 {
        let value = hull.quantity(&self.quantity).map_or(1.0, |q| q.value);
        if self.is_relative {
            self.u * value
        } else {
            self.u
        }
    }

    /// What is sought where nothing is said: what a class measurer needs.
    pub fn usual() -> Vec<Self> {
        let relative = |quantity: QuantityName, u: f64| Self {
            quantity,
            u,
            is_relative: true,
        };
        vec![
            relative(QuantityName::KYaw, 2e-3),
            relative(QuantityName::KPitch, 5e-3),
        ]
    }
}

impl FromStr for Wanted {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let refuse = |expected: &str| Error::argument("wanted", expected, format!("`{text}`"));
        let (name, size) = text
            .split_once('=')
            .ok_or_else(|| refuse("QUANTITY=UNCERTAINTY, such as k_yaw=0.1%"))?;
        let known = NAMES
            .iter()
            .find(|(short, long, _)| [*short, long.as_str()].contains(&name.trim()));
        let names = NAMES.map(|(short, _, _)| short).join(", ");
        let (_, quantity, is_angle) =
            known.ok_or_else(|| refuse(&format!("one of {names} before the =")))?;
        let size = size.trim();
        let digits = size
            .find(|c: char| c.is_alphabetic() || c == '%' || c == '°')
            .unwrap_or(size.len());
        let (number, unit) = size.split_at(digits);
        let number: f64 = number
            .trim()
            .parse()
            .map_err(|_| refuse("a number behind the ="))?;
        let (factor, is_relative) = match (unit.trim(), is_angle) {
            ("%", false) => (0.01, true),
            ("ppm", false) => (1e-6, true),
            ("m", false) | ("" | "deg" | "°", true) => (1.0, false),
            ("cm", false) => (0.01, false),
            ("mm", false) => (1e-3, false),
            (_, false) => return Err(refuse("a unit of %, ppm, m, cm or mm")),
            (_, true) => return Err(refuse("an angle in deg")),
        };
        if !(number.is_finite() && number > 0.0) {
            return Err(refuse("an uncertainty above 0"));
        }
        Ok(Self {
            quantity: quantity.clone(),
            u: number * factor,
            is_relative,
        })
    }
}
