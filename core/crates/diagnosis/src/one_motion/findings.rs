//! What the simulation without causes gets wrong in one motion, as sentences.

use super::super::findings::{Record, structure_of};
use super::super::point::Part;
use super::super::result::{Discrepancy, DiscrepancyKind};
use super::super::seen::Seen;
use super::super::unit::UnitName;
use super::super::white::spectrum;
use super::super::words;
use super::search::Found;
use super::swing::Swing;
use gyradius_base::frames::Vec3;
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
    let (swing, point) = (&found.swings[s], &found.base.fits[s].point);
    let mut all = Vec::new();
    let bands: Vec<_> = found
        .base
        .left
        .bands
        .iter()
        .filter(|band| band.swing == s)
        .collect();
    if let Some(rows) = swing
        .residual(point, &[], Part::All)
        .filter(|_| !bands.is_empty())
    {
        let times = swing.times_s(Part::All);
        let record = Record {
            id: swing.id,
            rows: rows.as_slice(),
            times_s: &times,
            duration_s: swing.duration_s,
        };
        all.extend(structure_of(&record, 1, bands, &|_| {
            words::message("line_swing", [])
        }));
    }
    all.extend(against(swing, point));
    all.extend(across(swing));
    all
}

/// What turns across the axis of the swing, where it stands out: a motion in one angle does not
/// have it.
fn across(swing: &Swing) -> Option<Discrepancy> {
    let values = &swing.stream.values;
    let mean = values.iter().sum::<Vec3>() / values.len().max(1) as f64;
    let parts = [0, 1].map(|k| {
        let direction = swing
            .axis
            .cross(&Vec3::ith(swing.axis.iamin(), 1.0))
            .normalize();
        let direction = if k == 0 {
            direction
        } else {
            swing.axis.cross(&direction)
        };
        values
            .iter()
            .map(|v| (v - mean).dot(&direction))
            .collect::<Vec<f64>>()
    });
    let square =
        |part: &Vec<f64>| part.iter().map(|v| v * v).sum::<f64>() / part.len().max(1) as f64;
    let along: Vec<f64> = swing
        .rates_rad_s
        .iter()
        .map(|r| r - mean.dot(&swing.axis))
        .collect();
    let (size, noise) = (
        parts.iter().map(square).sum::<f64>().sqrt(),
        swing.stream.noise.norm(),
    );
    let share = size / square(&along).sqrt();
    let power: Vec<f64> = spectrum(&parts[0])
        .iter()
        .zip(spectrum(&parts[1]))
        .map(|(a, b)| a + b)
        .collect();
    let most = (1..power.len()).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    let most_hz = most as f64 / swing.duration_s;
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
fn against(swing: &Swing, point: &[f64]) -> Vec<Discrepancy> {
    let Some(readings) = swing.readings(point, &[]) else {
        return vec![];
    };
    let seen = Seen {
        swing: swing.id,
        motion: swing.mode,
        t_s: &swing.stream.t_s,
        measured_rad_s: &swing.rates_rad_s,
        simulated_rad_s: &readings,
        noise_rad_s: swing.noise_rad_s,
        duration_s: swing.duration_s,
        mode: Pole {
            omega_rad_s: swing.scales.omega_rad_s,
            alpha_per_s: swing.start_damping_per_s(),
        },
        others: &swing.poles(point),
    };
    seen.findings()
}
