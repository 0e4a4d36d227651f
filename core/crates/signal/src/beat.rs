//! The beat count, eqs. (9)–(13): yaw and sway of about equal size at one point beat, and the
//! number n of oscillations per beat gives the ratio of the two periods without a clock (what
//! follows from n: `inertia::routes::beat`).

use std::f64::consts::TAU;

use num_complex::Complex64;

use gyradius_base::error::{Error, Result};

use super::crossings::median;
use super::curve_fit::linear;

/// A beat counted in a record.
#[derive(Debug, Clone, PartialEq)]
pub struct BeatCount {
    /// n, oscillations per beat.
    pub n: f64,
    /// Its standard uncertainty.
    pub n_u: f64,
    /// T_a, s.
    pub average_s: f64,
    /// T_b, s.
    pub beat_s: f64,
    /// Standard uncertainty of T_b, s.
    pub beat_u_s: f64,
    /// Size of the weaker motion relative to the stronger.
    pub balance: f64,
    /// Minima of the envelope that were counted.
    pub minima: usize,
}

/// The carrier removed: complex envelope at steps of a sixteenth of a period.
struct Envelope {
    t_s: Vec<f64>,
    z: Vec<Complex64>,
    omega_rad_s: f64,
}

/// A beat weaker than this (weaker motion over stronger) is not counted: noise makes such minima
/// too.
const WEAKEST_BALANCE: f64 = 0.08;

/// Counts oscillations per beat in one channel; an error where fewer than two minima of the
/// envelope are seen.
pub fn beat_count(t_s: &[f64], x: &[f64]) -> Result<BeatCount> {
    let refused = |reason: &str| Error::no_result("beat count", reason);
    let crossings = super::crossings::zero_crossings(t_s, x);
    let halves: Vec<f64> = crossings.windows(2).map(|w| w[1].t_s - w[0].t_s).collect();
    let period_s =
        2.0 * median(&halves).ok_or_else(|| refused("the channel does not oscillate"))?;
    let envelope = demodulated(t_s, x, TAU / period_s);
    let minima = minima(&envelope);
    if minima.len() < 2 {
        return Err(refused(
            "fewer than two minima of the envelope: no whole beat in the record",
        ));
    }
    let (beat_s, beat_se_s) = spacing(&minima);
    let counted =
        lobes(&envelope, &minima).ok_or_else(|| refused("no whole beat in the record"))?;
    if counted.balance < WEAKEST_BALANCE {
        return Err(refused(
            "the envelope hardly beats: one motion is much weaker than the other",
        ));
    }
    let average_s = TAU / counted.omega_rad_s;
    // An envelope's minimum is not placed better than an eighth of an oscillation: half a count,
    // rectangular, would be ±½/√3; the phase resolves it about twice as well.
    let placed_s = average_s / 8.0 / (minima.len() - 1) as f64;
    let beat_u_s = beat_se_s.max(placed_s);
    let n = beat_s / average_s; // eq. (12)
    let n_u = n * (beat_u_s / beat_s).hypot(counted.omega_u_rad_s / counted.omega_rad_s);
    Ok(BeatCount {
        n,
        n_u,
        average_s,
        beat_s,
        beat_u_s,
        balance: counted.balance,
        minima: minima.len(),
    })
}

/// Mean of x·e^{−iωt} over one period about each step (Hann window of two periods: the double
/// frequency vanishes).
fn demodulated(t_s: &[f64], x: &[f64], omega_rad_s: f64) -> Envelope {
    let period_s = TAU / omega_rad_s;
    let level = x.iter().sum::<f64>() / x.len().max(1) as f64;
    let (first, last) = (t_s[0] + period_s, t_s[t_s.len() - 1] - period_s);
    let steps = ((last - first) / (period_s / 16.0)).max(0.0) as usize;
    let mut envelope = Envelope {
        t_s: Vec::new(),
        z: Vec::new(),
        omega_rad_s,
    };
    for k in 0..steps {
        let at = first + k as f64 * period_s / 16.0;
        let from = t_s.partition_point(|t| *t < at - period_s);
        let to = t_s.partition_point(|t| *t <= at + period_s);
        let (mut sum, mut weights) = (Complex64::new(0.0, 0.0), 0.0);
        for i in from..to {
            let hann = 1.0 + (std::f64::consts::PI * (t_s[i] - at) / period_s).cos();
            sum += Complex64::from_polar(2.0 * hann * (x[i] - level), -omega_rad_s * t_s[i]);
            weights += hann;
        }
        if weights > 0.0 {
            envelope.t_s.push(at);
            envelope.z.push(sum / weights);
        }
    }
    envelope
}

/// Times of the envelope's minima: lowest within half a beat, placed by a parabola through |z|².
fn minima(envelope: &Envelope) -> Vec<f64> {
    let power: Vec<f64> = envelope.z.iter().map(|z| z.norm_sqr()).collect();
    let mut reach = 16;
    let mut found = lowest_within(&power, reach);
    // Widen to two fifths of the spacing found, so that ripple within a beat does not count.
    for _ in 0..4 {
        let gaps: Vec<f64> = found.windows(2).map(|w| (w[1] - w[0]) as f64).collect();
        let Some(gap) = median(&gaps) else { break };
        reach = reach.max((0.4 * gap) as usize);
        found = lowest_within(&power, reach);
    }
    found.iter().map(|&i| placed(envelope, &power, i)).collect()
}

fn lowest_within(power: &[f64], reach: usize) -> Vec<usize> {
    let lowest = |i: &usize| {
        let (from, to) = (i.saturating_sub(reach), (i + reach + 1).min(power.len()));
        *i >= 4 && i + 4 < power.len() && power[from..to].iter().all(|p| *p >= power[*i])
    };
    (0..power.len()).filter(lowest).collect()
}

fn placed(envelope: &Envelope, power: &[f64], i: usize) -> f64 {
    let (from, to) = (i.saturating_sub(8), (i + 9).min(power.len()));
    let u: Vec<f64> = envelope.t_s[from..to]
        .iter()
        .map(|t| t - envelope.t_s[i])
        .collect();
    let squares = u.iter().map(|v| v * v).collect();
    let step = 0.5 * TAU / envelope.omega_rad_s;
    match linear(
        &[vec![1.0; u.len()], u.clone(), squares],
        &power[from..to],
        &vec![1.0; u.len()],
    ) {
        Some(fit) if fit.parameters[2] > 0.0 => {
            envelope.t_s[i] + (-0.5 * fit.parameters[1] / fit.parameters[2]).clamp(-step, step)
        }
        _ => envelope.t_s[i],
    }
}

/// Mean spacing of the minima and its standard error (0 for a single spacing).
fn spacing(minima: &[f64]) -> (f64, f64) {
    let count: Vec<f64> = (0..minima.len()).map(|k| k as f64).collect();
    match linear(
        &[vec![1.0; minima.len()], count],
        minima,
        &vec![1.0; minima.len()],
    ) {
        Some(fit) => (fit.parameters[1], fit.se(1)),
        None => (minima[1] - minima[0], 0.0),
    }
}

struct Lobes {
    omega_rad_s: f64,
    omega_u_rad_s: f64,
    balance: f64,
}

/// The average frequency of eq. (10): the phase's rate at the envelope's maxima, corrected for
/// unequal motions.
///
/// With sizes A > B the rate at a maximum is (Aω_A + Bω_B)/(A+B), so it is off the plain mean by
/// (A−B)/(A+B)·(ω_A−ω_B)/2; which of the two is faster shows in the mean rate over whole beats,
/// which is ω_A.
fn lobes(envelope: &Envelope, minima: &[f64]) -> Option<Lobes> {
    let beat_s = (minima[minima.len() - 1] - minima[0]) / (minima.len() - 1) as f64;
    let step_s = TAU / envelope.omega_rad_s / 16.0;
    let turns = |k: usize| (envelope.z[k + 1] * envelope.z[k].conj()).arg() / step_s;
    let (mut rates, mut depths) = (Vec::new(), Vec::new());
    let mut total = (0.0, 0.0);
    for k in 0..envelope.z.len().saturating_sub(1) {
        let t = envelope.t_s[k];
        let phase = ((t - minima[0]) / beat_s).rem_euclid(1.0);
        if t >= minima[0] && t < minima[minima.len() - 1] {
            total = (total.0 + turns(k), total.1 + 1.0);
        }
        if (phase - 0.5).abs() < 0.12 {
            rates.push(turns(k));
            depths.push((true, envelope.z[k].norm()));
        } else if !(0.03..=0.97).contains(&phase) {
            depths.push((false, envelope.z[k].norm()));
        }
    }
    let mean_of = |top: bool| {
        median(
            &depths
                .iter()
                .filter(|d| d.0 == top)
                .map(|d| d.1)
                .collect::<Vec<f64>>(),
        )
    };
    let ratio = mean_of(false)? / mean_of(true)?; // |A−B| / (A+B)
    let at_top = median(&rates)?;
    let overall = total.0 / f64::max(total.1, 1.0);
    let correction = 0.5 * ratio.min(1.0) * TAU / beat_s * (overall - at_top).signum();
    Some(Lobes {
        omega_rad_s: envelope.omega_rad_s + at_top - correction,
        // A third of the correction is its own uncertainty: the envelope's smoothing and decay
        // shape the ratio.
        omega_u_rad_s: (correction / 3.0).abs(),
        balance: (1.0 - ratio.min(1.0)) / (1.0 + ratio.min(1.0)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_is_refused() {
        let t_s: Vec<f64> = (0..100).map(f64::from).collect();
        assert!(beat_count(&t_s, &vec![1.0; 100]).is_err());
        assert!(beat_count(&[], &[]).is_err());
    }
}
