//! What is true of a swing: keys of `[truth]`, and the experiment that they make with what is
//! stated.
//!
//! # Conventions
//! Truth is told in hull axes, whatever the hull's pitch; the experiment's numbers are in hanging
//! axes. Starts count from rest: yaw to port, sway to port, surge forward, pitch bow up, roll to
//! starboard (a right-handed turn about x).

use std::collections::BTreeMap;

use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::{
    Body, Dimensions, Experiment, Hanging, Number, Numbers, Phone, Scene, Start, SuspensionAxis,
};
use gyradius_recording::{Domain, Orientation, Quantity, Session, SuspensionKind, Swing};

use super::hull::{Hull, hung, numbers, rigid};
use super::sampling::Sampling;

const ANY: Domain = Domain::between("a finite number", f64::MIN, f64::MAX);
const POSITIVE: Domain = Domain::above("a number above 0", 0.0);
const NOT_NEGATIVE: Domain = Domain::at_least("a number, 0 or above", 0.0);
const START_ANGLE: Domain = Domain::between("an angle in degrees from -170 to 170", -170.0, 170.0);
/// ψ is the angle to the principal axis nearest to the hull's x.
const PSI: Domain = Domain::between("an angle in degrees from -44 to 44", -44.0, 44.0);
const RATE: Domain = Domain::between("samples per second from 0.1 to 10000", 0.1, 1e4);
const DURATION: Domain = Domain::between("a time in s from 0.1 to 100000", 0.1, 1e5);

/// A key of `[truth]`.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    pub name: &'static str,
    pub domain: Domain,
}

const OWN: &[Key] = &[
    Key {
        name: "k_yaw_m",
        domain: POSITIVE,
    },
    Key {
        name: "k_pitch_m",
        domain: POSITIVE,
    },
    Key {
        name: "k_roll_m",
        domain: POSITIVE,
    },
    Key {
        name: "psi_deg",
        domain: PSI,
    },
    Key {
        name: "cm_depth_m",
        domain: POSITIVE,
    },
    Key {
        name: "hull_pitch_deg",
        domain: Domain::PITCH,
    },
    Key {
        name: "hull_roll_deg",
        domain: Domain::PITCH,
    },
    Key {
        name: "yaw_deg",
        domain: START_ANGLE,
    },
    Key {
        name: "sway_m",
        domain: ANY,
    },
    Key {
        name: "surge_m",
        domain: ANY,
    },
    Key {
        name: "pitch_deg",
        domain: START_ANGLE,
    },
    Key {
        name: "roll_deg",
        domain: START_ANGLE,
    },
    Key {
        name: "held_s",
        domain: NOT_NEGATIVE,
    },
    Key {
        name: "duration_s",
        domain: DURATION,
    },
    Key {
        name: "rate_hz",
        domain: RATE,
    },
];

/// Numbers that only make sense above zero.
const ABOVE_ZERO: &[&str] = &[
    "mass_kg",
    "inertia_xx_kg_m2",
    "inertia_yy_kg_m2",
    "inertia_zz_kg_m2",
    "line_length_m",
    "spacing_m",
    "top_spacing_m",
    "axis_height_m",
    "spread_m",
    "gravity_m_s2",
];

/// Every key of `[truth]`: its own, and the simulation's numbers by their names.
pub fn keys() -> Vec<(&'static str, Key)> {
    let numbers = [
        <Body as Numbers<f64>>::NUMBERS,
        <Dimensions as Numbers<f64>>::NUMBERS,
        <Start as Numbers<f64>>::NUMBERS,
        <Phone as Numbers<f64>>::NUMBERS,
    ]
    .concat();
    let domain = |name: &str| {
        if ABOVE_ZERO.contains(&name) {
            POSITIVE
        } else {
            ANY
        }
    };
    let key = |n: &Number| Key {
        name: n.name,
        domain: domain(n.name),
    };
    let all = OWN.iter().copied().chain(numbers.iter().map(key));
    all.map(|key| (key.name, key)).collect()
}

/// What `[truth]` says.
#[derive(Debug, Clone, Default, PartialEq, schemars::JsonSchema)]
pub struct Truth(BTreeMap<&'static str, f64>);

impl Truth {
    /// All that is told, by name.
    pub fn all(&self) -> &BTreeMap<&'static str, f64> {
        &self.0
    }

    pub(super) fn set(&mut self, name: &'static str, value: f64) {
        self.0.insert(name, value);
    }

    fn get(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }

    /// What is true, or what is stated where it does not differ.
    fn or_stated(&self, name: &str, stated: Option<Quantity>) -> Option<f64> {
        self.get(name).or(stated.map(|q| q.value))
    }

    fn require(&self, name: &'static str) -> Result<f64> {
        self.get(name)
            .ok_or_else(|| Error::argument("truth", format!("`{name}`"), "no such key"))
    }

    /// Numbers by their names, each that is told put in place.
    fn told<T: Numbers<f64>>(&self, numbers: T) -> T {
        let values = T::NUMBERS.iter().zip(numbers.to_numbers());
        let told: Vec<f64> = values
            .map(|(n, value)| self.get(n.name).unwrap_or(value))
            .collect();
        T::from_numbers(&mut told.into_iter()).unwrap_or(numbers)
    }

    /// When the phone reads its sensors: for two minutes, a hundred times a second.
    pub fn sampling(&self) -> Sampling {
        Sampling {
            duration_s: self.get("duration_s").unwrap_or(120.0),
            rate_hz: self.get("rate_hz").unwrap_or(100.0),
        }
    }
}

/// The experiment of a swing with the effects on the hull and on the sensors. What is neither told
/// nor stated is an [`Error::Argument`] that names the key.
pub fn experiment(
    session: &Session,
    swing: &Swing,
    truth: &Truth,
    [effects, sensors]: [Vec<EffectValues>; 2],
) -> Result<Experiment> {
    let level = rigid(&truth.told(numbers(&hull(session, truth)?.with(&session.attachments))));
    let pitch_deg = truth
        .or_stated("hull_pitch_deg", swing.suspension.hull_pitch_deg)
        .unwrap_or(0.0);
    let heel_deg = truth
        .or_stated("hull_roll_deg", swing.suspension.hull_roll_deg)
        .unwrap_or(0.0);
    let turned = [pitch_deg, heel_deg].map(f64::to_radians);
    let hung = hung(&level, turned, &swing.added_masses);
    let axis = match swing.suspension.orientation {
        Orientation::Athwartships => SuspensionAxis::Athwartships,
        Orientation::ForeAndAft => SuspensionAxis::ForeAndAft,
    };
    let hanging = match swing.suspension.kind {
        SuspensionKind::Bifilar => Hanging::Bifilar(axis),
        SuspensionKind::Compound => Hanging::Compound(axis),
        SuspensionKind::Trifilar | SuspensionKind::Free => {
            let reason = "the simulation knows bifilar and compound suspensions";
            return Err(Error::no_result(&swing.id, reason));
        }
    };
    let mut scene = Scene {
        hanging,
        body: numbers(&hung.body),
        dimensions: dimensions(session, swing, truth)?,
        start: Start::default(),
        effects,
    };
    scene.start = start(&scene, truth)?;
    let mut phone = truth.told(Phone::default());
    let place = Vec3::new(phone.position_x_m, phone.position_y_m, phone.position_z_m);
    let place = hung.origin_m + hung.hanging_from_hull * place;
    (phone.position_x_m, phone.position_y_m, phone.position_z_m) = (place.x, place.y, place.z);
    let held_s = truth.get("held_s").unwrap_or(0.0);
    Ok(Experiment {
        scene,
        hull_from_phone: hung.hanging_from_hull,
        phone,
        sensors,
        held_s,
    })
}

fn hull(session: &Session, truth: &Truth) -> Result<Hull> {
    let all_kg = truth.or_stated("mass_kg", session.body.mass_kg);
    let all_kg = all_kg
        .ok_or_else(|| Error::argument("truth", "`mass_kg`, or a mass in [body]", "neither"))?;
    let attached_kg: f64 = session.attachments.iter().map(|a| a.mass_kg.value).sum();
    // Whoever tells the whole tensor need not tell the gyradii.
    let gyradius = |key: &'static str, element: &str| match truth.get(element) {
        Some(inertia) => Ok(truth.get(key).unwrap_or((inertia / all_kg).sqrt())),
        None => truth.require(key),
    };
    let depth = truth
        .get("cm_z_m")
        .map_or_else(|| truth.require("cm_depth_m"), |z| Ok(-z));
    Ok(Hull {
        mass_kg: all_kg - attached_kg,
        gyradii_m: [
            gyradius("k_roll_m", "inertia_xx_kg_m2")?,
            gyradius("k_pitch_m", "inertia_yy_kg_m2")?,
            gyradius("k_yaw_m", "inertia_zz_kg_m2")?,
        ],
        psi_rad: truth.get("psi_deg").unwrap_or(0.0).to_radians(),
        cm_depth_m: depth?,
    })
}

fn dimensions(session: &Session, swing: &Swing, truth: &Truth) -> Result<Dimensions> {
    let stated = &swing.suspension;
    let spacing_m = truth
        .or_stated("spacing_m", stated.spacing_m)
        .unwrap_or(1.0);
    let axis_height_m = truth
        .or_stated("axis_height_m", stated.axis_height_m)
        .unwrap_or(0.0);
    let gravity = truth.or_stated("gravity_m_s2", session.site.gravity_m_s2);
    if gravity.is_none() && session.site.latitude_deg.is_some() {
        return Err(Error::argument(
            "truth",
            "`gravity_m_s2` beside a latitude",
            "no such key",
        ));
    }
    Ok(Dimensions {
        line_length_m: truth
            .or_stated("line_length_m", stated.line_length_m)
            .unwrap_or(0.0),
        spacing_m,
        top_spacing_m: truth
            .or_stated("top_spacing_m", stated.top_spacing_m)
            .unwrap_or(spacing_m),
        axis_height_m,
        spread_m: truth.get("spread_m").unwrap_or(axis_height_m),
        gravity_m_s2: gravity.unwrap_or(STANDARD_GRAVITY_M_S2),
    })
}

/// The start from rest by the motions' names, then what is told of it by number.
fn start(scene: &Scene, truth: &Truth) -> Result<Start> {
    refuse_bound(scene.hanging, truth)?;
    let get = |name: &str| truth.get(name).unwrap_or(0.0);
    let rad = |name: &str| get(name).to_radians();
    let rest_rad = scene.rest_turn_rad()?;
    // The axis is +y or +x; across is then +x or −y.
    let (along_m, across_m, turn_rad) = match scene.hanging.axis() {
        SuspensionAxis::Athwartships => {
            (get("sway_m"), get("surge_m"), rest_rad - rad("pitch_deg"))
        }
        SuspensionAxis::ForeAndAft => (get("surge_m"), -get("sway_m"), rest_rad + rad("roll_deg")),
    };
    Ok(truth.told(Start {
        along_m,
        across_m,
        turn_rad,
        yaw_rad: rad("yaw_deg"),
        ..Start::default()
    }))
}

/// Motions that the lines do not leave free.
fn refuse_bound(hanging: Hanging, truth: &Truth) -> Result<()> {
    let bound: &[&str] = match hanging {
        Hanging::Bifilar(SuspensionAxis::Athwartships) => &["roll_deg"],
        Hanging::Bifilar(SuspensionAxis::ForeAndAft) => &["pitch_deg"],
        Hanging::Compound(SuspensionAxis::Athwartships) => &["roll_deg", "yaw_deg", "surge_m"],
        Hanging::Compound(SuspensionAxis::ForeAndAft) => &["pitch_deg", "yaw_deg", "sway_m"],
    };
    match bound
        .iter()
        .find(|name| truth.get(name).is_some_and(|value| value != 0.0))
    {
        Some(name) => Err(Error::argument(
            "truth",
            format!("no `{name}` (the lines do not leave it free)"),
            "it",
        )),
        None => Ok(()),
    }
}
