//! What the simulation without causes gets wrong in one motion, as sentences.

use num_complex::Complex64;

use super::super::findings::{Record, structure_of};
use super::super::point::Part;
use super::super::result::Discrepancy;
use super::super::white::spectrum;
use super::search::Found;
use super::swing::Swing;
use crate::frames::Vec3;
use crate::signal::{ChannelGroup, Pole, WindowPoint, WindowedMode, against_amplitude};

/// A turn across the axis is told of where it exceeds the noise so many times.
const STANDS_OUT: f64 = 2.0;
/// Differences between wide and narrow swings of more standard uncertainties are told of.
const TOLD: f64 = 4.0;

/// Everything found, the most significant first.
pub fn findings(found: &Found) -> Vec<Discrepancy> {
    let mut all: Vec<Discrepancy> = (0..found.swings.len()).flat_map(|s| of_swing(found, s)).collect();
    all.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    all
}

fn of_swing(found: &Found, s: usize) -> Vec<Discrepancy> {
    let (swing, point) = (&found.swings[s], &found.base.fits[s].point);
    let mut all = Vec::new();
    let bands: Vec<_> = found.base.left.bands.iter().filter(|band| band.swing == s).collect();
    if let Some(rows) = swing.residual(point, &[], Part::All).filter(|_| !bands.is_empty()) {
        let times = swing.times_s(Part::All);
        let record =
            Record { id: swing.id, rows: rows.as_slice(), times_s: &times, duration_s: swing.duration_s };
        all.extend(structure_of(&record, 1, bands, &|_| "the turn about the swing's axis".into()));
    }
    all.extend(against(swing, point).into_iter().flatten());
    all.extend(across(swing));
    all
}

/// What turns across the axis of the swing, where it stands out: a motion in one angle does not have it.
fn across(swing: &Swing) -> Option<Discrepancy> {
    let values = &swing.stream.values;
    let mean = values.iter().sum::<Vec3>() / values.len().max(1) as f64;
    let parts = [0, 1].map(|k| {
        let direction = swing.axis.cross(&Vec3::ith(swing.axis.iamin(), 1.0)).normalize();
        let direction = if k == 0 { direction } else { swing.axis.cross(&direction) };
        values.iter().map(|v| (v - mean).dot(&direction)).collect::<Vec<f64>>()
    });
    let square = |part: &Vec<f64>| part.iter().map(|v| v * v).sum::<f64>() / part.len().max(1) as f64;
    let along: Vec<f64> = swing.rates_rad_s.iter().map(|r| r - mean.dot(&swing.axis)).collect();
    let (size, noise) = (parts.iter().map(square).sum::<f64>().sqrt(), swing.stream.noise.norm());
    let share = size / square(&along).sqrt();
    let power: Vec<f64> = spectrum(&parts[0]).iter().zip(spectrum(&parts[1])).map(|(a, b)| a + b).collect();
    let most = (1..power.len()).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    let most_hz = most as f64 / swing.duration_s;
    (size > STANDS_OUT * noise).then(|| Discrepancy {
        swing: swing.id.into(),
        what: "across_the_axis".into(),
        size: share,
        unit: "1".into(),
        sigma: (size / noise - 1.0) * (values.len() as f64).sqrt(),
        text: format!(
            "{}: across the axis of the swing the phone turns by {:.1} % of the swing, most at {most_hz:.3} Hz; a motion in one angle has none of it",
            swing.id, 100.0 * share
        ),
    })
}

/// Period and decrement against amplitude, measured against simulated.
fn against(swing: &Swing, point: &[f64]) -> [Option<Discrepancy>; 2] {
    let Some(readings) = swing.readings(point, &[]) else { return [None, None] };
    let measured = windows(swing, point, &swing.rates_rad_s);
    let simulated = windows(swing, point, &readings);
    let mut pairs: Vec<(WindowPoint, WindowPoint)> = Vec::new();
    for m in measured {
        let same = simulated.iter().find(|s| (s.t_s - m.t_s).abs() < 1e-6 * swing.duration_s);
        pairs.extend(same.map(|s| (m, *s)));
    }
    pairs.sort_by(|a, b| b.0.amplitude.total_cmp(&a.0.amplitude));
    let period = thirds(&pairs, |p| (p.period_s, p.period_se_s));
    let decay = thirds(&pairs, |p| (100.0 * p.decrement, 100.0 * p.decrement_se));
    [
        period.and_then(|t| told(swing.id, "period_vs_amplitude", "the period is", "s", &t)),
        decay.and_then(|t| told(swing.id, "decay_vs_amplitude", "a swing loses of the one before", "%", &t)),
    ]
}

/// The swing followed through the record in windows.
fn windows(swing: &Swing, point: &[f64], rates_rad_s: &[f64]) -> Vec<WindowPoint> {
    let group = ChannelGroup { t_s: swing.stream.t_s.clone(), channels: vec![rates_rad_s.to_vec()] };
    let mode = Pole { omega_rad_s: swing.scales.omega_rad_s, alpha_per_s: swing.start_damping_per_s() };
    let wanted = WindowedMode {
        span_s: (0.0, swing.duration_s),
        mode,
        others: &swing.poles(point),
        project: &[Complex64::new(1.0, 0.0)],
    };
    against_amplitude(&[group], &wanted)
}

/// Means of a third of the windows.
struct Third {
    amplitude_rad: f64,
    measured: f64,
    simulated: f64,
    u: f64,
}

/// The widest, the middle and the narrowest third; `None` with fewer than three windows.
fn thirds(
    pairs: &[(WindowPoint, WindowPoint)],
    figure: impl Fn(&WindowPoint) -> (f64, f64),
) -> Option<[Third; 3]> {
    let size = pairs.len() / 3;
    if size == 0 {
        return None;
    }
    let third = |part: &[(WindowPoint, WindowPoint)]| {
        let weight = |pair: &(WindowPoint, WindowPoint)| figure(&pair.0).1.max(f64::MIN_POSITIVE).powi(-2);
        let sum: f64 = part.iter().map(weight).sum();
        let mean = |of: &dyn Fn(&(WindowPoint, WindowPoint)) -> f64| {
            part.iter().map(|pair| of(pair) * weight(pair)).sum::<f64>() / sum
        };
        Third {
            amplitude_rad: mean(&|(m, _)| m.amplitude_over_omega()),
            measured: mean(&|(m, _)| figure(m).0),
            simulated: mean(&|(_, s)| figure(s).0),
            u: sum.sqrt().recip(),
        }
    };
    Some([&pairs[..size], &pairs[size..pairs.len() - size], &pairs[pairs.len() - size..]].map(third))
}

/// The largest difference between two thirds of what is measured less what is simulated, where it stands out.
fn told(id: &str, what: &str, words: &str, unit: &str, thirds: &[Third; 3]) -> Option<Discrepancy> {
    let off = |t: &Third| t.measured - t.simulated;
    let pairs = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| (&thirds[i], &thirds[j]));
    let sigma = |(a, b): &(&Third, &Third)| (off(a) - off(b)).abs() / a.u.hypot(b.u);
    let most = pairs.iter().max_by(|a, b| sigma(a).total_cmp(&sigma(b)))?;
    let each = thirds.each_ref().map(|t| {
        // Two digits of the uncertainty.
        let decimals = (1.0 - t.u.log10().floor()).clamp(0.0, 9.0) as usize;
        let figures = [t.measured, t.u, t.simulated].map(|x| format!("{x:.decimals$}"));
        let [measured, u, simulated] = figures;
        format!("{measured} ± {u} {unit} at {:.3} rad (simulated {simulated})", t.amplitude_rad)
    });
    (sigma(most) > TOLD).then(|| Discrepancy {
        swing: id.into(),
        what: what.into(),
        size: off(most.0) - off(most.1),
        unit: unit.into(),
        sigma: sigma(most),
        text: format!("{id}: {words} {}", each.join(", ")),
    })
}
