//! Small corrections: buoyancy, gravity of the place, linear damping, levelling (28).

use std::f64::consts::TAU;

use super::domain::{between, finite, not_negative, positive, result, root};
use gyradius_base::Result;

/// Gravity less the lift of the air, m/s²: g' = (1 − ρ_a/ρ) g.
pub fn buoyant_gravity_m_s2(
    gravity_m_s2: f64,
    air_density_kg_m3: f64,
    density_kg_m3: f64,
) -> Result<f64> {
    let hull = positive("density_kg_m3", density_kg_m3)?;
    let air = not_negative("air_density_kg_m3", air_density_kg_m3)?;
    let share = between("air_density_kg_m3 / density_kg_m3", air / hull, -1.0, 1.0)?;
    Ok((1.0 - share) * positive("gravity_m_s2", gravity_m_s2)?)
}

// WGS 84, NIMA TR8350.2, 3rd edition (2000), tables 3.1, 3.3 and 3.4.
const EQUATOR_M_S2: f64 = 9.780_325_335_9;
const SOMIGLIANA_K: f64 = 0.001_931_852_652_41;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_14;
const SEMI_MAJOR_M: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
/// ω² a² b / GM.
const CENTRIFUGAL_RATIO: f64 = 0.003_449_786_506_84;

/// Standard uncertainty to give gravity computed from latitude and altitude, m/s². Normal gravity
/// knows no geology: free-air anomalies are a few tens of milligal (1 mGal = 1e-5 m/s²) at most
/// places, 50 is taken.
pub const NORMAL_GRAVITY_U_M_S2: f64 = 5e-4;

/// Normal gravity from latitude and altitude, m/s²: Somigliana's closed formula on the ellipsoid
/// (TR8350.2 eq. 4-1), second order in altitude (eq. 4-3). Altitudes from −500 to 10 000 m.
pub fn normal_gravity_m_s2(latitude_deg: f64, altitude_m: f64) -> Result<f64> {
    // A degree of rounding beyond the poles is none: the bounds belong to the domain.
    let latitude = between(
        "latitude_deg",
        latitude_deg,
        -90.0_f64.next_up(),
        90.0_f64.next_up(),
    )?;
    let h = between("altitude_m", altitude_m, -500.1, 10_000.1)?;
    let sin2 = latitude.to_radians().sin().powi(2);
    let surface =
        EQUATOR_M_S2 * (1.0 + SOMIGLIANA_K * sin2) / (1.0 - ECCENTRICITY_SQUARED * sin2).sqrt();
    let first =
        2.0 / SEMI_MAJOR_M * (1.0 + FLATTENING + CENTRIFUGAL_RATIO - 2.0 * FLATTENING * sin2);
    Ok(surface * (1.0 - first * h + 3.0 * (h / SEMI_MAJOR_M).powi(2)))
}

/// Undamped period from the observed one and the decay time τ of the amplitude, s (exact for linear
/// damping).
pub fn undamped_period_s(period_s: f64, decay_time_s: f64) -> Result<f64> {
    let period = positive("period_s", period_s)?;
    let per_radian = period / (TAU * positive("decay_time_s", decay_time_s)?);
    result("undamped period", period / per_radian.hypot(1.0)) // T0 = T / √(1 + (T/2πτ)²)
}

/// Gyradius about the vertical of a hull that is not level, m: pitched by φ_p = φ + ψ and rolled by
/// ϕ from its principal axes. The angles are those of the print: the vertical runs along (tan φ_p,
/// tan ϕ, 1) in principal axes.
pub fn tilted_gyradius_m(
    principal_gyradii_m: [f64; 3],
    pitch_rad: f64,
    roll_rad: f64,
) -> Result<f64> {
    let quarter = std::f64::consts::FRAC_PI_2;
    let pitch = between(
        "pitch_rad",
        finite("pitch_rad", pitch_rad)?,
        -quarter,
        quarter,
    )?
    .tan()
    .powi(2);
    let roll = between("roll_rad", roll_rad, -quarter, quarter)?
        .tan()
        .powi(2);
    let [x, y, z] = principal_gyradii_m;
    let square = (not_negative("k_px_m", x)?.powi(2) * pitch
        + not_negative("k_py_m", y)?.powi(2) * roll
        + not_negative("k_pz_m", z)?.powi(2))
        / (1.0 + pitch + roll); // (28), its three fractions on one denominator
    root("tilted gyradius", square)
}
