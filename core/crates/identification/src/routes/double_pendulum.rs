//! Pitch–surge (or, on a fore-and-aft suspension, roll–sway) double pendulum: periods from gyradius
//! and depth (eqs. 16, 19), gyradius and depth from periods (17, 18), and the line length that
//! serves best (Figs. 16, 17).
//!
//! # Conventions
//! Modes are named by what they are: `in_phase` has the long period, `out_of_phase` the short one
//! (print and text of the paper number them differently). Always T_out < T_s < T_in, T_s being the
//! simple pendulum's period (7).

use std::f64::consts::TAU;

use super::domain::{positive, root};
use super::ratio;
use gyradius_base::{Error, Result};

/// The two periods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Periods {
    /// The long one, s.
    pub in_phase_s: f64,
    /// The short one, s.
    pub out_of_phase_s: f64,
}

/// What the two periods tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GyradiusAndDepth {
    /// Gyradius about the axis of the rotation through the centre of mass, m.
    pub gyradius_m: f64,
    /// Centre of mass below the suspension points, m.
    pub cm_depth_m: f64,
}

/// Small-amplitude periods of a hull of gyradius k with its centre l2 below the points, on lines of
/// length l1.
pub fn periods_s(
    body: &GyradiusAndDepth,
    line_length_m: f64,
    gravity_m_s2: f64,
) -> Result<Periods> {
    let k2 = positive("gyradius_m", body.gyradius_m)?.powi(2);
    let l2 = positive("cm_depth_m", body.cm_depth_m)?;
    let l1 = positive("line_length_m", line_length_m)?;
    let g = positive("gravity_m_s2", gravity_m_s2)?;
    let sum = l1 * l2 + l2 * l2 + k2;
    // sum² − 4 l1 l2 k² written as a sum of squares: no cancellation, never negative.
    let difference = ((l1 * l2 - k2).powi(2) + l2 * l2 * (l2 * l2 + 2.0 * (l1 * l2 + k2))).sqrt();
    let fast = g / (2.0 * l1 * k2) * (sum + difference); // (16), +
    let slow = g * g * l2 / (l1 * k2 * fast); // (16), −, by the product of the roots
    Ok(Periods {
        in_phase_s: TAU / root("in-phase frequency", slow)?,
        out_of_phase_s: TAU / root("out-of-phase frequency", fast)?,
    })
}

/// Gyradius and depth from the two periods and the sway period.
pub fn from_sway_period(
    periods: &Periods,
    sway_period_s: f64,
    gravity_m_s2: f64,
) -> Result<GyradiusAndDepth> {
    let fast = positive("out_of_phase_period_s", periods.out_of_phase_s)?;
    let slow = positive("in_phase_period_s", periods.in_phase_s)?;
    let sway = positive("sway_period_s", sway_period_s)?;
    if !(fast < sway && sway < slow) {
        let reason = format!(
            "periods must stand out of phase < sway < in phase, found {fast}, {sway}, {slow} s"
        );
        return Err(Error::no_result("double pendulum", reason));
    }
    let scale = positive("gravity_m_s2", gravity_m_s2)? / (TAU * sway).powi(2);
    let product = (sway - fast) * (sway + fast) * ((slow - sway) * (slow + sway));
    let cm_depth_m = scale * product; // (17)
    let gyradius_m = scale * fast * slow * root("gyradius", product)?; // (18)
    Ok(GyradiusAndDepth {
        gyradius_m,
        cm_depth_m,
    })
}

/// Gyradius and depth from the two periods and a line length: (17), (18) with T_s from (7).
pub fn from_line_length(
    periods: &Periods,
    line_length_m: f64,
    gravity_m_s2: f64,
) -> Result<GyradiusAndDepth> {
    from_sway_period(
        periods,
        ratio::sway_period_s(line_length_m, gravity_m_s2)?,
        gravity_m_s2,
    )
}

/// How the gyradius is got from the periods, which decides how it depends on their errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DepthIs {
    /// l2 is known and held fixed: what Figs. 16 and 17 of the paper show.
    Known,
    /// Gyradius and depth are both solved for, by (17) and (18), the line length being known.
    SolvedFor,
}

/// √((∂k/∂T_in)² + (∂k/∂T_out)²), m/s: the error of the gyradius for the same error of both periods
/// (Fig. 16).
pub fn sensitivity_m_s(
    body: &GyradiusAndDepth,
    line_length_m: f64,
    gravity_m_s2: f64,
    depth: DepthIs,
) -> Result<f64> {
    let periods = periods_s(body, line_length_m, gravity_m_s2)?;
    let (slow, fast) = match depth {
        DepthIs::Known => slopes_with_depth_known(body, line_length_m, gravity_m_s2, &periods),
        DepthIs::SolvedFor => slopes_with_depth_solved(
            body,
            ratio::sway_period_s(line_length_m, gravity_m_s2)?,
            &periods,
        ),
    };
    Ok(slow.hypot(fast))
}

/// ∂k/∂T of both modes at fixed l2, by differentiating the quadratic behind (16),
/// l1 k² w² − g (l1 l2 + l2² + k²) w + g² l2 = 0 with w = ω².
fn slopes_with_depth_known(
    body: &GyradiusAndDepth,
    l1: f64,
    g: f64,
    periods: &Periods,
) -> (f64, f64) {
    let (k, l2) = (body.gyradius_m, body.cm_depth_m);
    let slope = |period: f64| {
        let w = (TAU / period).powi(2);
        let by_w = 2.0 * l1 * k * k * w - g * (l1 * l2 + l2 * l2 + k * k);
        let by_k = 2.0 * k * w * (l1 * w - g);
        // dw/dT = −2w/T; dk/dT = −(F_w / F_k) dw/dT.
        by_w / by_k * 2.0 * w / period
    };
    (slope(periods.in_phase_s), slope(periods.out_of_phase_s))
}

/// ∂k/∂T of both modes by differentiating (18).
fn slopes_with_depth_solved(body: &GyradiusAndDepth, sway: f64, periods: &Periods) -> (f64, f64) {
    let (slow, fast) = (periods.in_phase_s, periods.out_of_phase_s);
    let by_slow = body.gyradius_m * (1.0 / slow + slow / (slow * slow - sway * sway));
    let by_fast = body.gyradius_m * (1.0 / fast - fast / (sway * sway - fast * fast));
    (by_slow, by_fast)
}

/// Line length at which [`sensitivity_m_s`] is least, m (Fig. 17; searched over 0.01 to 100 times
/// the depth).
pub fn best_line_length_m(
    body: &GyradiusAndDepth,
    gravity_m_s2: f64,
    depth: DepthIs,
) -> Result<f64> {
    let l2 = positive("cm_depth_m", body.cm_depth_m)?;
    let at = |log_ratio: f64| sensitivity_m_s(body, l2 * log_ratio.exp(), gravity_m_s2, depth);
    let (low, high, steps) = (0.01_f64.ln(), 100.0_f64.ln(), 200_u32);
    let step = (high - low) / f64::from(steps);
    let mut best = (f64::INFINITY, low);
    for i in 0..=steps {
        let x = low + step * f64::from(i);
        let value = at(x)?;
        if value < best.0 {
            best = (value, x);
        }
    }
    if best.1 <= low || best.1 >= high - 0.5 * step {
        return Err(Error::no_result(
            "best line length",
            "no minimum between 0.01 and 100 times the depth",
        ));
    }
    Ok(l2 * golden_section(at, best.1 - step, best.1 + step)?.exp())
}

/// Place of the minimum of a function with one minimum between the bounds.
fn golden_section(f: impl Fn(f64) -> Result<f64>, mut low: f64, mut high: f64) -> Result<f64> {
    const INVERSE_GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (
        high - INVERSE_GOLDEN * (high - low),
        low + INVERSE_GOLDEN * (high - low),
    );
    let (mut fa, mut fb) = (f(a)?, f(b)?);
    for _ in 0..80 {
        if fa < fb {
            (high, b, fb) = (b, a, fa);
            a = high - INVERSE_GOLDEN * (high - low);
            fa = f(a)?;
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + INVERSE_GOLDEN * (high - low);
            fb = f(b)?;
        }
    }
    Ok(0.5 * (low + high))
}

/// Dimensionless form: T √(g / l2) of both modes from K = k/l2 and L = l1/l2 (19).
pub fn dimensionless_periods(k_over_l2: f64, l1_over_l2: f64) -> Result<Periods> {
    let body = GyradiusAndDepth {
        gyradius_m: positive("k_over_l2", k_over_l2)?,
        cm_depth_m: 1.0,
    };
    periods_s(&body, positive("l1_over_l2", l1_over_l2)?, 1.0) // (19) is (16) in units of l2 and √(l2/g)
}
