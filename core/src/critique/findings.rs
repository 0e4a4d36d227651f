//! What the base simulation gets wrong, as sentences.

use crate::error::Result;
use crate::inertia::parameters::Role;
use crate::recording::RepairKind;

use super::base::Base;
use super::fitting::Fitted;
use super::point::{Model, Point};
use super::result::Discrepancy;
use super::white::{Band, Left};

/// A stated dimension that is pulled by more standard uncertainties is told of.
const PULLED: f64 = 3.0;
/// Lines told of in each swing.
const LINES: usize = 3;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Everything found, the most significant first.
pub fn findings(model: &Model, fitted: &Fitted, left: &Left) -> Result<Vec<Discrepancy>> {
    let mut all = structure(model, &fitted.point, left)?;
    all.extend(dimensions(model.base, &fitted.point));
    all.extend(saturated(model.base));
    all.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    Ok(all)
}

/// By swing: how much is left, how it goes with time, and at which frequencies.
fn structure(model: &Model, point: &Point, left: &Left) -> Result<Vec<Discrepancy>> {
    let mut all = Vec::new();
    for (s, swung) in model.base.swings.iter().enumerate() {
        let id = &swung.setup.swing.id;
        let mut bands: Vec<&Band> = left.bands.iter().filter(|b| b.swing == s).collect();
        if bands.is_empty() {
            continue;
        }
        let rows = model.rows(point, s)?;
        let excess: f64 = bands.iter().map(|b| b.excess).sum();
        let rms = (rows.iter().map(|r| r * r).sum::<f64>() / rows.len().max(1) as f64).sqrt();
        all.push(Discrepancy {
            swing: id.clone(),
            what: "structure".into(),
            size: rms,
            unit: "1".into(),
            sigma: excess.sqrt(),
            text: format!(
                "{id}: the simulation leaves {rms:.2} times the noise, and what it leaves is not noise"
            ),
        });
        all.extend(against_time(model, s, &rows));
        bands.sort_by(|a, b| b.excess.total_cmp(&a.excess));
        all.extend(bands.iter().take(LINES).map(|band| line(id, band, rows.len())));
    }
    Ok(all)
}

fn line(id: &str, band: &Band, rows: usize) -> Discrepancy {
    let sensor = if band.channel < 3 { "gyroscope" } else { "accelerometer" };
    let middle_hz = 0.5 * (band.from_hz + band.to_hz);
    // A sinusoid of amplitude a (in noise) adds n a²/2 to χ² of n samples.
    let size = (2.0 * band.excess / (rows as f64 / 6.0)).sqrt();
    Discrepancy {
        swing: id.into(),
        what: "line_in_spectrum".into(),
        size,
        unit: "1".into(),
        sigma: band.sigma,
        text: format!(
            "{id}: about {middle_hz:.3} Hz the {sensor}'s {} axis moves by {size:.2} times its noise more than simulated",
            AXES[band.channel % 3]
        ),
    }
}

/// Whether more is left at the beginning or at the end: by the halves of the record.
fn against_time(model: &Model, s: usize, rows: &[f64]) -> Option<Discrepancy> {
    let blocks = model.blocks(s);
    let half_s = 0.5 * model.swing(s).samples.duration_s;
    let (mut sums, mut counts) = ([0.0; 2], [0.0; 2]);
    for (block, row) in blocks.iter().zip(rows.chunks_exact(3)) {
        let k = usize::from(block.t_s > half_s);
        sums[k] += row.iter().map(|r| r * r).sum::<f64>();
        counts[k] += 3.0;
    }
    let [early, late] = [0, 1].map(|k| sums[k] / f64::max(counts[k], 1.0));
    let sigma = (early - late).abs() / (2.0 / counts[0].max(1.0) + 2.0 / counts[1].max(1.0)).sqrt();
    let (more, less) = if early > late { ("first", "second") } else { ("second", "first") };
    let id = &model.swing(s).setup.swing.id;
    (sigma > 5.0).then(|| Discrepancy {
        swing: id.clone(),
        what: "residual_vs_time".into(),
        size: early.sqrt() - late.sqrt(),
        unit: "1".into(),
        sigma,
        text: format!(
            "{id}: the {more} half of the recording is further from the simulation than the {less}: {:.2} against {:.2} times the noise",
            early.max(late).sqrt(),
            early.min(late).sqrt()
        ),
    })
}

/// Stated figures that the swings pull away from what was stated.
fn dimensions(base: &Base, point: &Point) -> Vec<Discrepancy> {
    let mut all = Vec::new();
    for i in &base.free {
        let parameter = &base.layout().parameters[*i];
        let sigma = (point.x[*i] - parameter.prior.value) / parameter.prior.u;
        if parameter.role != Role::Stated || sigma.abs() < PULLED {
            continue;
        }
        let name = parameter.name.replace('_', " ");
        let change = point.x[*i] - parameter.prior.value;
        let unit = unit_of(&parameter.name);
        all.push(Discrepancy {
            swing: String::new(),
            what: "dimension".into(),
            size: change,
            unit: unit.into(),
            sigma: sigma.abs(),
            text: format!(
                "{name}: stated as {:.5} {unit}, the swings want {change:+.5} {unit}: {:.1} times its stated uncertainty",
                parameter.prior.value,
                sigma.abs()
            ),
        });
    }
    all
}

fn unit_of(name: &str) -> &'static str {
    match name {
        "gravity" => "m/s²",
        "hull_pitch" => "°",
        "phone_clock" => "1",
        "line_length" | "spacing" | "top_spacing" | "axis_height" => "m",
        _ => "kg",
    }
}

/// Sensors that came to the end of their range.
fn saturated(base: &Base) -> Vec<Discrepancy> {
    let mut all = Vec::new();
    for swung in &base.swings {
        let id = &swung.setup.swing.id;
        let samples: usize = swung.samples.streams.iter().map(|s| s.t_s.len()).max().unwrap_or(0);
        for repair in swung.evidence.repairs.iter().filter(|r| r.kind == RepairKind::Saturation) {
            all.push(Discrepancy {
                swing: id.clone(),
                what: "saturated".into(),
                size: repair.count as f64 / (samples + repair.count).max(1) as f64,
                unit: "1".into(),
                sigma: (repair.count as f64).sqrt(),
                text: format!("{id}: {}", repair.text),
            });
        }
    }
    all
}
