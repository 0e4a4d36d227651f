//! What is known of a hull before it swings: as told, by its type, or as measured so far.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_identification::{Measurement, QuantityName};
use gyradius_mechanics::RigidBody;
use gyradius_recording::{Quantity, Session};

/// Types of boats of which rough ratios are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BoatType {
    /// With a ballast keel, full size.
    Keelboat,
    /// An open boat without ballast.
    Dinghy,
    /// A tank or sailing model of a keelboat.
    ModelKeelboat,
    /// A bar or box of even density that hangs by its upper edge: for the classroom.
    UniformBar,
}

/// Rough ratios of a type. Their uncertainties say how far boats of the type scatter about them, as
/// far as is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratios {
    /// Yaw gyradius over length.
    pub k_yaw_over_length: Quantity,
    /// Pitch gyradius over length.
    pub k_pitch_over_length: Quantity,
    /// Roll gyradius over beam.
    pub k_roll_over_beam: Quantity,
    /// Depth of the centre of mass below the suspension points over the pitch gyradius (1/K_P2 of
    /// the paper); over the beam for a bar.
    pub depth_over_k_pitch: Quantity,
    /// ψ, degrees.
    pub psi_deg: Quantity,
    /// Where they come from.
    pub source: &'static str,
}

/// All types with the names that files and commands have for them.
pub const BOAT_TYPES: [(&str, BoatType); 4] = [
    ("keelboat", BoatType::Keelboat),
    ("dinghy", BoatType::Dinghy),
    ("model_keelboat", BoatType::ModelKeelboat),
    ("uniform_bar", BoatType::UniformBar),
];

impl BoatType {
    /// The type of that name.
    ///
    /// # Errors
    /// [`Error::Argument`] that lists the names.
    pub fn named(name: &str) -> Result<Self> {
        let found = BOAT_TYPES
            .iter()
            .find(|(known, _)| *known == name.replace('-', "_"));
        let names = BOAT_TYPES.map(|(known, _)| known).join(", ");
        found
            .map(|(_, of)| *of)
            .ok_or_else(|| Error::argument("type", format!("one of {names}"), name))
    }

    /// Its ratios.
    pub fn ratios(self) -> Ratios {
        let of = |value: f64, relative_u: f64| Quantity::new(value, value * relative_u);
        match self {
            BoatType::Keelboat => Ratios {
                k_yaw_over_length: of(1.057 / 6.35, 0.10),
                k_pitch_over_length: of(1.156 / 6.35, 0.10),
                k_roll_over_beam: of(0.623 / 1.73, 0.20),
                depth_over_k_pitch: of(1.0 / 1.5, 0.25),
                psi_deg: Quantity::new(1.0, 3.0),
                source: "one keelboat of 6.35 m by 1.73 m (Hinrichsen 2014, Table 4; roll modelled there beside eq. 28) and K_P2 = 1.5 of keelboats (eq. 19)",
            },
            BoatType::Dinghy => Ratios {
                // The Finn's class limit of 1.100 m on 4.50 m; the keelboat's shell alone has 1.448
                // m on 6.35 m.
                k_yaw_over_length: of(0.235, 0.08),
                k_pitch_over_length: of(0.235, 0.08),
                k_roll_over_beam: of(0.36, 0.25),
                depth_over_k_pitch: of(1.0 / 3.5, 0.25),
                psi_deg: Quantity::new(0.0, 3.0),
                source: "the Finn's limit over its length and the shell of a keelboat (Hinrichsen 2014, Table 4), yaw as pitch (22 Flying Dutchmen, same place), K_P2 = 2.5 to 4.5 of dinghies (eq. 19); roll is a guess",
            },
            BoatType::ModelKeelboat => Ratios {
                k_yaw_over_length: of(0.303 / 1.87, 0.10),
                k_pitch_over_length: of(0.352 / 1.87, 0.10),
                k_roll_over_beam: of(0.204 / 0.288, 0.20),
                depth_over_k_pitch: of(0.253 / 0.352, 0.25),
                psi_deg: Quantity::new(5.6, 3.0),
                source: "one model of 1.87 m by 0.288 m (Hinrichsen 2014, Fig. 15 and Table 3)",
            },
            BoatType::UniformBar => Ratios {
                k_yaw_over_length: of(12f64.powf(-0.5), 0.01),
                k_pitch_over_length: of(12f64.powf(-0.5), 0.01),
                k_roll_over_beam: of(12f64.powf(-0.5), 0.10),
                depth_over_k_pitch: of(0.5, 0.20),
                psi_deg: Quantity::new(0.0, 0.5),
                source: "a uniform slender bar: L/√12; depth half of the beam",
            },
        }
    }
}

/// What a user tells of a hull. Gyradii and depth that are told go before those of the type.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RoughHull {
    /// Everything that hangs, kg.
    pub mass_kg: Option<f64>,
    /// Length overall, m.
    pub length_m: Option<f64>,
    /// Largest beam, m.
    pub beam_m: Option<f64>,
    /// Name of the type ([`BOAT_TYPES`]).
    pub boat_type: Option<String>,
    /// Yaw gyradius, m.
    pub k_yaw_m: Option<Quantity>,
    /// Pitch gyradius, m.
    pub k_pitch_m: Option<Quantity>,
    /// Roll gyradius, m.
    pub k_roll_m: Option<Quantity>,
    /// Depth of the centre of mass below the suspension points, hung level, m.
    pub cm_depth_m: Option<Quantity>,
    /// ψ, bow up, degrees.
    pub psi_deg: Option<Quantity>,
}

/// A hull as the plan assumes it: each figure with how far it may be off, and where it comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Hull {
    /// Everything that hangs, kg.
    pub mass_kg: f64,
    /// Length overall, m.
    pub length_m: f64,
    /// Largest beam, m.
    pub beam_m: f64,
    /// Yaw gyradius, m.
    pub k_yaw_m: Quantity,
    /// Pitch gyradius, m.
    pub k_pitch_m: Quantity,
    /// Roll gyradius, m.
    pub k_roll_m: Quantity,
    /// Depth of the centre of mass below the suspension points, hung level, m.
    pub cm_depth_m: Quantity,
    /// ψ, bow up, degrees.
    pub psi_deg: Quantity,
    /// Where each figure comes from.
    pub sources: BTreeMap<QuantityName, String>,
}

/// Where a figure that was told comes from.
const TOLD: &str = "told";
const MEASURED: &str = "measured so far";
/// Beam of a hull of which only the spacing of earlier lines is known, over that.
const BEAM_OVER_SPACING: f64 = 1.0;
/// Where nothing else is known of a hull that was measured: what the measurement itself takes for
/// granted of hulls (`inertia::parameters`), relative to the yaw gyradius.
const ROLL_OVER_YAW: Quantity = Quantity::new(0.52, 0.16);
const DEPTH_OVER_YAW: Quantity = Quantity::new(0.4, 0.2);
const LENGTH_OVER_YAW: f64 = 5.5;

impl RoughHull {
    /// The hull that the plan assumes.
    ///
    /// # Errors
    /// [`Error::Argument`] that names what is missing or outside its domain.
    pub fn completed(&self) -> Result<Hull> {
        let mass_kg = required("mass", self.mass_kg)?;
        let (length_m, beam_m) = (
            required("length", self.length_m)?,
            required("beam", self.beam_m)?,
        );
        let ratios = self
            .boat_type
            .as_deref()
            .map(|name| Ok((name, BoatType::named(name)?.ratios())));
        let ratios: Option<(&str, Ratios)> = ratios.transpose()?;
        let mut sources = BTreeMap::new();
        let mut figure =
            |name: QuantityName, told: Option<Quantity>, by_type: &dyn Fn(&Ratios) -> Quantity| {
                let (value, source) = match (told, &ratios) {
                    (Some(told), _) => (told, TOLD.to_owned()),
                    (None, Some((kind, ratios))) => {
                        (by_type(ratios), format!("{kind}: {}", ratios.source))
                    }
                    (None, None) => {
                        let expected = format!("a type of boat, or `{name}`");
                        return Err(Error::argument("type", expected, "neither"));
                    }
                };
                sources.insert(name, source);
                Ok(value)
            };
        let k_yaw_m = figure(QuantityName::KYaw, self.k_yaw_m, &|r| {
            times(r.k_yaw_over_length, length_m)
        })?;
        let k_pitch_m = figure(QuantityName::KPitch, self.k_pitch_m, &|r| {
            times(r.k_pitch_over_length, length_m)
        })?;
        let k_roll_m = figure(QuantityName::KRoll, self.k_roll_m, &|r| {
            times(r.k_roll_over_beam, beam_m)
        })?;
        let is_bar = self.boat_type.as_deref().map(BoatType::named).transpose()?
            == Some(BoatType::UniformBar);
        let depth_scale_m = if is_bar { beam_m } else { k_pitch_m.value };
        let cm_depth_m = figure(QuantityName::CmDepth, self.cm_depth_m, &|r| {
            times(r.depth_over_k_pitch, depth_scale_m)
        })?;
        let psi_deg = match ratios {
            Some((_, ratios)) => self.psi_deg.unwrap_or(ratios.psi_deg),
            None => self.psi_deg.unwrap_or(Quantity::new(0.0, 3.0)),
        };
        Hull {
            mass_kg,
            length_m,
            beam_m,
            k_yaw_m,
            k_pitch_m,
            k_roll_m,
            cm_depth_m,
            psi_deg,
            sources,
        }
        .checked()
    }
}

fn times(q: Quantity, by: f64) -> Quantity {
    Quantity::new(q.value * by, q.u * by)
}

fn required(name: &str, value: Option<f64>) -> Result<f64> {
    let value =
        value.ok_or_else(|| Error::argument(name, "a positive number (kg or m)", "nothing"))?;
    positive(name, value)
}

fn positive(name: &str, value: f64) -> Result<f64> {
    let is_fine = value.is_finite() && value > 0.0;
    is_fine
        .then_some(value)
        .ok_or_else(|| Error::argument(name, "a positive number", value))
}

impl Hull {
    /// The hull as a session and its measurement have it; what they do not tell is filled up from
    /// what hulls have in common.
    ///
    /// # Errors
    /// [`Error::NoResult`] where not even the yaw gyradius was measured.
    pub fn so_far(session: &Session, measurement: &Measurement) -> Result<Self> {
        let found = |name: &QuantityName| {
            let quantity = measurement.quantities.get(name)?;
            Some(Quantity::new(
                quantity.value.scalar()?,
                quantity.u.scalar()?,
            ))
        };
        let k_yaw_m = found(&QuantityName::KYaw).or_else(|| found(&QuantityName::KPitch)).ok_or_else(|| {
            let reason = "neither a yaw nor a pitch gyradius was measured so far: tell the hull's dimensions";
            Error::no_result("plan", reason)
        })?;
        let spacing = session
            .swings
            .iter()
            .filter_map(|s| s.suspension.spacing_m)
            .map(|q| q.value);
        let widest_m = spacing.fold(0.0, f64::max);
        let mut sources = BTreeMap::new();
        let mut figure = |name: QuantityName, guess: Quantity| {
            let (value, source) =
                found(&name).map_or((guess, "as hulls mostly have it"), |q| (q, MEASURED));
            sources.insert(name, source.to_owned());
            value
        };
        Self {
            mass_kg: session.body.mass_kg.map_or(1.0, |m| m.value),
            length_m: session
                .body
                .length_overall_m
                .unwrap_or(LENGTH_OVER_YAW * k_yaw_m.value),
            beam_m: if widest_m > 0.0 {
                BEAM_OVER_SPACING * widest_m
            } else {
                2.0 * k_yaw_m.value
            },
            k_yaw_m: figure(QuantityName::KYaw, k_yaw_m),
            k_pitch_m: figure(
                QuantityName::KPitch,
                Quantity::new(k_yaw_m.value, 0.1 * k_yaw_m.value),
            ),
            k_roll_m: figure(QuantityName::KRoll, times(ROLL_OVER_YAW, k_yaw_m.value)),
            cm_depth_m: figure(QuantityName::CmDepth, times(DEPTH_OVER_YAW, k_yaw_m.value)),
            psi_deg: figure(QuantityName::Psi, Quantity::new(0.0, 3.0)),
            sources,
        }
        .checked()
    }

    fn checked(self) -> Result<Self> {
        let lengths = [
            ("k_yaw_m", self.k_yaw_m),
            ("k_pitch_m", self.k_pitch_m),
            ("k_roll_m", self.k_roll_m),
            ("cm_depth_m", self.cm_depth_m),
        ];
        for (name, q) in lengths {
            positive(name, q.value)?;
            if !(q.u.is_finite() && q.u >= 0.0) {
                return Err(Error::argument(name, "an uncertainty of 0 or more", q.u));
            }
        }
        let psi = self.psi_deg;
        if !(psi.value.abs() <= 44.0 && psi.u.is_finite() && psi.u >= 0.0) {
            return Err(Error::argument(
                "psi_deg",
                "an angle from -44 to 44 degrees",
                psi.value,
            ));
        }
        // Of no body can one moment of inertia exceed the sum of the others; rough figures may seem
        // to.
        let gyradii = [self.k_roll_m, self.k_pitch_m, self.k_yaw_m];
        let rough = 1.05 + 4.0 * gyradii.iter().map(|q| q.u / q.value).fold(0.0, f64::max);
        let [r, p, y] = gyradii.map(|q| q.value.powi(2));
        if y > rough * (r + p) || p > rough * (r + y) || r > rough * (p + y) {
            let found = format!("{}, {}, {} m", r.sqrt(), p.sqrt(), y.sqrt());
            return Err(Error::argument(
                "k_roll_m, k_pitch_m, k_yaw_m",
                "gyradii that a body can have",
                found,
            ));
        }
        Ok(self)
    }

    /// A quantity by the name that measurements give it.
    pub fn quantity(&self, name: &QuantityName) -> Option<Quantity> {
        match name {
            QuantityName::KYaw => Some(self.k_yaw_m),
            QuantityName::KPitch => Some(self.k_pitch_m),
            QuantityName::KRoll => Some(self.k_roll_m),
            QuantityName::CmDepth => Some(self.cm_depth_m),
            QuantityName::Psi => Some(self.psi_deg),
            QuantityName::PrincipalGyradii
            | QuantityName::Inertia
            | QuantityName::InertiaYaw
            | QuantityName::InertiaPitch
            | QuantityName::InertiaRoll
            | QuantityName::SmallPeriod(_) => None,
        }
    }

    /// The body to predict with, hull axes. The principal axes are turned by ψ as large as it is
    /// likely to be: what the swings say of it vanishes where it is exactly nothing.
    pub fn body(&self) -> RigidBody {
        let gyradii = [self.k_roll_m, self.k_pitch_m, self.k_yaw_m].map(|q| q.value);
        let mut body = RigidBody::from_gyradii(
            self.mass_kg,
            gyradii,
            Vec3::new(0.0, 0.0, -self.cm_depth_m.value),
        );
        let psi_rad = self
            .psi_deg
            .value
            .hypot(self.psi_deg.u)
            .min(44.0)
            .to_radians();
        let sign = if self.psi_deg.value < 0.0 { -1.0 } else { 1.0 };
        let (xx, zz) = (body.inertia_kg_m2[(0, 0)], body.inertia_kg_m2[(2, 2)]);
        // (3), (4) in tensor form: tan 2ψ = 2 I_xz / (I_xx − I_zz).
        let product = 0.5 * (2.0 * sign * psi_rad).tan() * (xx - zz);
        (body.inertia_kg_m2[(0, 2)], body.inertia_kg_m2[(2, 0)]) = (product, product);
        body
    }
}
