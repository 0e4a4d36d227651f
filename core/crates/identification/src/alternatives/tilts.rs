//! Routes through several hangings: roll gyradius from tilted yaw (25, 26), ψ from one tilt (4) or
//! from three and more by least squares (3).

use std::f64::consts::FRAC_PI_2;

use crate::names::{Origin, QuantityName, RouteMethod};
use crate::routes::principal::{
    Tilt, TiltFit, fit_tilts, from_one_tilt, roll_gyradius_m, roll_gyradius_right_angle_m,
};
use crate::traced::Traced;
use gyradius_base::error::Result;
use gyradius_recording::Quantity;

use super::swings::yaw_gyradius;
use super::{Bench, RouteCalculation};

/// A tilt that says something of the other axes, degrees.
const LEAST_TILT_DEG: f64 = 5.0;
/// Two tilts whose angle differs from a right angle by less may use (26), degrees.
const RIGHT_ANGLE_DEG: f64 = 0.5;

/// A yaw gyradius of the hull alone, and the angle it was measured at.
struct TiltedYaw {
    id: String,
    gyradius: Traced,
    pitch: Traced,
}

impl TiltedYaw {
    fn of(bench: &Bench) -> Option<Self> {
        let degrees = bench.stated(Some(bench.index().pitch_deg))?;
        let pitch = Traced::combine(&[&degrees], |v| Ok(v[0].to_radians())).ok()?;
        Some(TiltedYaw {
            id: bench.id(),
            gyradius: yaw_gyradius(bench)?,
            pitch,
        })
    }

    fn origin(&self) -> Origin {
        Origin::Swing(self.id.clone())
    }

    fn is_tilted(&self) -> bool {
        self.pitch.value.to_degrees().abs() > LEAST_TILT_DEG
    }
}

/// Every route through tilted yaw; `rolls` are the single routes to the roll gyradius from swings.
pub fn routes(benches: &[Bench], rolls: &[&RouteCalculation]) -> Vec<RouteCalculation> {
    let level = benches
        .iter()
        .filter(|b| b.is_level())
        .filter_map(TiltedYaw::of);
    let level = level.min_by(|a, b| a.gyradius.u().total_cmp(&b.gyradius.u()));
    let tilted: Vec<TiltedYaw> = benches
        .iter()
        .filter_map(TiltedYaw::of)
        .filter(TiltedYaw::is_tilted)
        .collect();
    let mut found = Vec::new();
    if let Some(level) = &level {
        for (i, a) in tilted.iter().enumerate() {
            found.extend(tilted[i + 1..].iter().filter_map(|b| roll_of(level, a, b)));
            found.extend(rolls.first().and_then(|roll| psi_of_one(roll, level, a)));
        }
    }
    let all: Vec<&TiltedYaw> = level.iter().chain(&tilted).collect();
    found.extend(least_squares(&all, rolls.first().copied()).unwrap_or_default());
    found
}

fn roll_of(level: &TiltedYaw, a: &TiltedYaw, b: &TiltedYaw) -> Option<RouteCalculation> {
    let apart_deg = (a.pitch.value - b.pitch.value).abs().to_degrees();
    let parts = [
        &level.gyradius,
        &a.gyradius,
        &b.gyradius,
        &a.pitch,
        &b.pitch,
    ];
    let right_angle = (apart_deg - 90.0).abs() < RIGHT_ANGLE_DEG;
    let (method, equation) = if right_angle {
        (RouteMethod::TiltedYawRightAngle, "(26)")
    } else {
        (RouteMethod::TiltedYaw, "(25)")
    };
    let figure = Traced::combine(&parts, |v| match right_angle {
        true => roll_gyradius_right_angle_m(v[0], v[1], v[2]),
        false => roll_gyradius_m(v[0], (v[1], v[3]), (v[2], v[4])),
    });
    let from = [level, a, b].map(TiltedYaw::origin).to_vec();
    Some(RouteCalculation {
        quantity: QuantityName::KRoll,
        method,
        equation,
        from,
        figure: figure.ok()?,
        interval_95: None,
    })
}

/// (4) from a level yaw, a tilted yaw and a roll.
fn psi_of_one(
    roll: &RouteCalculation,
    level: &TiltedYaw,
    tilted: &TiltedYaw,
) -> Option<RouteCalculation> {
    let parts = [
        &roll.figure,
        &level.gyradius,
        &tilted.gyradius,
        &tilted.pitch,
    ];
    let psi_deg = |v: &[f64]| -> Result<f64> {
        Ok(from_one_tilt(v[0], v[1], v[2], v[3])?.psi_rad.to_degrees())
    };
    let figure = Traced::combine(&parts, psi_deg).ok()?;
    let from = roll
        .from
        .iter()
        .cloned()
        .chain([level, tilted].map(TiltedYaw::origin))
        .collect();
    let (quantity, method, equation) = (QuantityName::Psi, RouteMethod::OneTilt, "(3), (4)");
    Some(RouteCalculation {
        quantity,
        method,
        equation,
        from,
        figure,
        interval_95: None,
    })
}

/// Roll gyradius and ψ from three or more tilts, a roll counting as a tilt of a right angle.
/// Fieller's interval of ψ.
fn least_squares(
    yaws: &[&TiltedYaw],
    roll: Option<&RouteCalculation>,
) -> Option<Vec<RouteCalculation>> {
    let upright = Traced {
        value: FRAC_PI_2,
        by_input: Default::default(),
    };
    let mut rows: Vec<(&Traced, &Traced)> = yaws.iter().map(|y| (&y.gyradius, &y.pitch)).collect();
    rows.extend(roll.map(|roll| (&roll.figure, &upright)));
    let shared = shared_inputs(&rows);
    let tilts: Vec<Tilt> = rows
        .iter()
        .map(|(k, pitch)| tilt(k, pitch, &shared))
        .collect();
    let fit = fit_tilts(&tilts, 0.0).ok()?;
    let mut from: Vec<Origin> = yaws.iter().map(|y| y.origin()).collect();
    from.extend(roll.iter().flat_map(|roll| roll.from.clone()));
    let parts: Vec<&Traced> = rows.iter().flat_map(|(k, pitch)| [*k, *pitch]).collect();
    let again = |v: &[f64]| refitted(&tilts, v);
    let mut found = Vec::new();
    let mut push = |quantity, figure: Result<Traced>, interval_95| {
        let (method, equation, from) = (RouteMethod::TiltFit, "(3) by least squares", from.clone());
        found.extend(figure.ok().map(|figure| RouteCalculation {
            quantity,
            method,
            equation,
            from,
            figure,
            interval_95,
        }));
    };
    push(
        QuantityName::KRoll,
        Traced::combine(&parts, |v| Ok(again(v)?.k_roll_m.value)),
        None,
    );
    let psi = Traced::combine(&parts, |v| Ok(again(v)?.principal.psi_rad.to_degrees()));
    push(
        QuantityName::Psi,
        psi,
        Some(fit.psi_interval_95_rad.map(f64::to_degrees)),
    );
    Some(found)
}

/// Inputs of all gyradii, the spacing for one: they scale them together and turn no axis.
fn shared_inputs(rows: &[(&Traced, &Traced)]) -> Vec<String> {
    let Some(((first, _), rest)) = rows.split_first() else {
        return vec![];
    };
    let in_all = |name: &&String| rest.iter().all(|(k, _)| k.by_input.contains_key(*name));
    first.by_input.keys().filter(in_all).cloned().collect()
}

fn tilt(gyradius: &Traced, pitch: &Traced, shared: &[String]) -> Tilt {
    let own = gyradius
        .by_input
        .iter()
        .filter(|(name, _)| !shared.contains(name));
    let own_u = own.map(|(_, change)| change * change).sum::<f64>().sqrt();
    Tilt {
        pitch_rad: Quantity::new(pitch.value, pitch.u()),
        gyradius_m: Quantity::new(gyradius.value, own_u),
    }
}

/// The fit with other values and the same weights: gyradius and pitch of each tilt in turn.
fn refitted(tilts: &[Tilt], values: &[f64]) -> Result<TiltFit> {
    let moved: Vec<Tilt> = tilts
        .iter()
        .zip(values.chunks_exact(2))
        .map(|(tilt, v)| Tilt {
            pitch_rad: Quantity::new(v[1], tilt.pitch_rad.u),
            gyradius_m: Quantity::new(v[0], tilt.gyradius_m.u),
        })
        .collect();
    fit_tilts(&moved, 0.0)
}
