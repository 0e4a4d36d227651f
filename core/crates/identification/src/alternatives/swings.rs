//! Routes that one swing allows by itself.

use crate::beats::CountedBeat;
use crate::estimate::Solution;
use crate::names::{QuantityName, RouteMethod};
use crate::routes::double_pendulum::{
    GyradiusAndDepth, Periods, from_line_length, from_sway_period,
};
use crate::routes::yaw::{Lines, yaw_gyradius_m};
use crate::routes::{beat, compound, ratio};
use crate::traced::Traced;
use gyradius_base::error::Result;
use gyradius_recording::{ModeName, Orientation, Quantity};

use super::{Bench, RouteCalculation};

/// Largest share of weak priors in a depth that a compound pendulum may borrow, and its largest
/// relative u.
const MOST_WEAK_SHARE: f64 = 0.05;
const MOST_RELATIVE_U: f64 = 0.25;

/// (17), (18) with one clock or the other.
type Solver = fn(&Periods, f64, f64) -> Result<GyradiusAndDepth>;

/// Every route through one swing.
pub fn routes(
    bench: &Bench,
    solution: &Solution,
    beats: &[Option<CountedBeat>],
) -> Vec<RouteCalculation> {
    let mut found = Vec::new();
    found.extend(yaw_period(bench));
    found.extend(period_ratio(bench));
    found.extend(
        beats
            .get(bench.swing)
            .and_then(|beat| beat_count(bench, beat.as_ref()?)),
    );
    found.extend(double_pendulum(bench).unwrap_or_default());
    found.extend(compound_pendulum(bench, solution));
    found
}

fn yaw_period(bench: &Bench) -> Option<RouteCalculation> {
    let figure = yaw_gyradius(bench).filter(|_| bench.is_level())?;
    bench.route(
        (QuantityName::KYaw, RouteMethod::YawPeriod, "(5), (6)"),
        &[&figure],
        |v| Ok(v[0]),
    )
}

/// Gyradius of the hull alone about the vertical of this hanging, by (6).
pub fn yaw_gyradius(bench: &Bench) -> Option<Traced> {
    let index = bench.index();
    let period = bench.period(ModeName::Yaw)?;
    let (length, spacing) = (
        bench.stated(index.line_length)?,
        bench.stated(index.spacing)?,
    );
    let (top, gravity) = (bench.stated(index.top_spacing)?, bench.gravity());
    Traced::combine(&[&period, &length, &spacing, &top, &gravity], |v| {
        let lines = Lines {
            length_m: v[1],
            half_spacing_m: 0.5 * v[2],
            top_half_spacing_m: 0.5 * v[3],
        };
        Ok(bench.share.gyradii[2] * yaw_gyradius_m(v[0], &lines, v[4])?)
    })
    .ok()
}

fn period_ratio(bench: &Bench) -> Option<RouteCalculation> {
    let (yaw, sway) = (bench.period(ModeName::Yaw)?, bench.period(ModeName::Sway)?);
    let half_spacing = bench
        .half_spacing()
        .filter(|_| bench.is_level() && bench.is_parallel())?;
    bench.route(
        (QuantityName::KYaw, RouteMethod::PeriodRatio, "(8)"),
        &[&yaw, &sway, &half_spacing],
        |v| Ok(bench.share.gyradii[2] * ratio::yaw_gyradius_m(v[0], v[1], v[2])?),
    )
}

/// (13): the count gives the ratio of the periods as they were swung; the corrections for finite amplitude bring
/// it to small amplitude.
fn beat_count(bench: &Bench, beat: &CountedBeat) -> Option<RouteCalculation> {
    let count = Traced::input(
        format!("oscillations per beat of {}", bench.id()),
        beat.count,
    );
    let half_spacing = bench
        .half_spacing()
        .filter(|_| bench.is_level() && bench.is_parallel())?;
    bench.route(
        (QuantityName::KYaw, RouteMethod::BeatCount, "(9)–(13)"),
        &[&count, &half_spacing],
        |v| {
            let share = bench.share.gyradii[2] * beat.small_over_observed;
            Ok(share * beat::yaw_gyradius_m(v[0], v[1], beat.yaw_is_slower)?)
        },
    )
}

/// (17), (18), with the sway period where the swing shows one, else from the lines by (7).
fn double_pendulum(bench: &Bench) -> Option<Vec<RouteCalculation>> {
    let (slow, fast, k_name, about) = match bench.orientation() {
        Orientation::Athwartships => (
            ModeName::PitchInPhase,
            ModeName::PitchOutOfPhase,
            QuantityName::KPitch,
            1,
        ),
        Orientation::ForeAndAft => (
            ModeName::RollInPhase,
            ModeName::RollOutOfPhase,
            QuantityName::KRoll,
            0,
        ),
    };
    let (slow, fast, gravity) = (bench.period(slow)?, bench.period(fast)?, bench.gravity());
    let (method, clock, solve) = match bench.period(ModeName::Sway) {
        Some(sway) => (
            RouteMethod::DoublePendulum,
            sway,
            from_sway_period as Solver,
        ),
        None => (
            RouteMethod::DoublePendulumAndLineLength,
            bench.stated(bench.index().line_length)?,
            from_line_length as _,
        ),
    };
    let parts = [&slow, &fast, &clock, &gravity];
    let body = |v: &[f64]| {
        solve(
            &Periods {
                in_phase_s: v[0],
                out_of_phase_s: v[1],
            },
            v[2],
            v[3],
        )
    };
    // Pitch gyradius and depth do not change with a tilt, the depth's reference does.
    let gyradius = bench.route((k_name, method, "(18)"), &parts, |v| {
        Ok(bench.share.gyradii[about] * body(v)?.gyradius_m)
    });
    let depth = bench
        .route((QuantityName::CmDepth, method, "(17)"), &parts, |v| {
            Ok(body(v)?.cm_depth_m + bench.share.depth_m)
        })
        .filter(|_| bench.is_level());
    Some(gyradius.into_iter().chain(depth).collect())
}

/// (23) with the depth of the joint estimate.
fn compound_pendulum(bench: &Bench, solution: &Solution) -> Option<RouteCalculation> {
    let index = bench.index();
    let (period, height) = (
        bench.period(ModeName::Compound)?,
        bench.stated(index.axis_height)?,
    );
    let depth = solution.derive(&bench.system.layout, |x| Some(x[index.log_depth].exp()))?;
    if depth.weak_share > MOST_WEAK_SHARE || depth.u > MOST_RELATIVE_U * depth.value {
        return None;
    }
    let depth = Traced::input(
        "depth of the joint estimate".into(),
        Quantity::new(depth.value, depth.u),
    );
    let (name, about) = bench.compound_quantity();
    bench.route(
        (name, RouteMethod::CompoundPendulum, "(23)"),
        &[&period, &height, &depth, &bench.gravity()],
        |v| Ok(bench.share.gyradii[about] * compound::gyradius_m(v[0], v[1] + v[2], v[3])?),
    )
}
