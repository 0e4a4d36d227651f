//! What the simulation without causes gets wrong in one motion, as sentences.

use super::super::findings::{Record, structure_of};
use super::super::result::{Discrepancy, DiscrepancyKind};
use super::super::seen::Seen;
use super::super::unit::UnitName;
use super::super::white::spectrum;
use super::super::words;
use super::found::Found;
use super::swing::Swing;
use gyradius_base::frames::Vec3;
use gyradius_identification::one_motion::variance;
use gyradius_signal::Pole;

/// A turn across the axis is told of where it exceeds the noise so many times.
const STANDS_OUT: f64 = 2.0;

/// Everything found, the most significant first.
pub fn findings(found: &Found) -> Vec<Discrepancy> {
    let mut all: Vec<Discrepancy> = (0..found.swings.len())
        .flat_map(|s| of_swing(found, s))
        .collect();
    all.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    all
}

fn of_swing(found: &Found, s: usize) -> Vec<Discrepancy> {
    let (swing, x) = (&found.swings[s], &found.decision.base.swings[s].x);
    let readings = swing.readings();
    let mut all = Vec::new();
    let bands: Vec<_> = found
        .base_left
        .bands
        .iter()
        .filter(|band| band.swing == s)
        .collect();
    let rows = swing.left(&[], x).filter(|_| !bands.is_empty());
    if let Some(rows) = rows {
        let times = swing.block_times_s();
        let record = Record {
            id: swing.id,
            rows: rows.as_slice(),
            times_s: &times,
            duration_s: readings.duration_s(),
        };
        all.extend(structure_of(&record, 1, bands, &|_| {
            words::message("line_swing", [])
        }));
    }
    all.extend(against(swing, x));
    all.extend(across(swing));
    all
}

/// What turns across the axis of the swing, where it stands out: a motion in one angle does not
/// have it.
fn across(swing: &Swing) -> Option<Discrepancy> {
    let readings = swing.readings();
    let axis = readings.axis;
    let channels = &swing.group.channels;
    if channels.len() < 2 {
        return None;
    }
    let start = swing.group.t_s.partition_point(|t| *t < readings.start_s);
    let value = |i: usize| Vec3::from_fn(|c, _| channels.get(c).map_or(0.0, |all| all[start + i]));
    let values: Vec<Vec3> = (0..readings.t_s.len()).map(value).collect();
    let mean = values.iter().sum::<Vec3>() / values.len().max(1) as f64;
    let one = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
    let parts = [one, axis.cross(&one)].map(|direction| {
        let along = values.iter().map(|v| (v - mean).dot(&direction));
        along.collect::<Vec<f64>>()
    });
    let size = parts.iter().map(|part| variance(part)).sum::<f64>().sqrt();
    let noise = readings.noise * std::f64::consts::SQRT_2;
    let share = size / variance(&readings.values).sqrt();
    let power: Vec<f64> = spectrum(&parts[0])
        .iter()
        .zip(spectrum(&parts[1]))
        .map(|(a, b)| a + b)
        .collect();
    let most = (1..power.len()).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    let most_hz = most as f64 / readings.duration_s();
    (size > STANDS_OUT * noise).then(|| {
        let sigma = (size / noise - 1.0) * (values.len() as f64).sqrt();
        let said = words::message(
            "across",
            [
                ("swing", words::id(swing.id)),
                ("percent", words::number(100.0 * share, 1)),
                ("most_hz", words::number(most_hz, 3)),
            ],
        );
        Discrepancy::of(
            swing.id,
            DiscrepancyKind::AcrossTheAxis,
            (share, UnitName::One),
            sigma,
            said,
        )
    })
}

/// Period and decay against amplitude and what is left against phase, measured against simulated.
fn against(swing: &Swing, x: &[f64]) -> Vec<Discrepancy> {
    let Some(simulated) = swing.simulated(&[], x) else {
        return vec![];
    };
    let readings = swing.readings();
    let seen = Seen {
        swing: swing.id,
        motion: swing.mode,
        t_s: &readings.t_s,
        measured: &readings.values,
        simulated: &simulated,
        is_angle: readings.is_angle,
        noise: readings.noise,
        duration_s: readings.duration_s(),
        mode: Pole {
            omega_rad_s: swing.scales().omega_rad_s,
            alpha_per_s: swing.measured.start.damping_per_s,
        },
        others: &swing.poles(x),
    };
    seen.findings()
}
