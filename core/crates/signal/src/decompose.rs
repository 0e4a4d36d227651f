//! From a record to its modes.

use std::cmp::Reverse;

use num_complex::Complex64;

use super::fit::{Fit, project_with_curvature};
use super::noise::{ChannelNoise, group_noise};
use super::record::{Record, no_result};
use super::search::Search;
use super::types::{
    AmplitudeLaw, ChannelGroup, CombinationTone, DecomposeOptions, Decomposition, FittedMode,
};
use super::uncertainty::{Errors, mean_rates};
use super::words::message;
use gyradius_base::Result;
use gyradius_base::message::Message;

/// Largest decay over frequency of an oscillation: 1.6 cycles in a decay time.
const OVERDAMPED: f64 = 0.1;
/// Of one that is heavily damped: a damping ratio of 0.33, half a cycle in a decay time.
const HEAVY: f64 = 0.35;
/// Noise per sample, over that in the band, from which cells are not trusted.
const ABOVE_BAND: f64 = 2.0;

/// Finds the damped oscillations that all channels of a record share.
///
/// Start values, the number of modes, the harmonics, the amplitude laws and the drift are all found
/// in the data. Every group keeps its own uneven time stamps; nothing is resampled. Fails with
/// [`Error::NoResult`](gyradius_base::Error::NoResult) where the record is too short or holds no
/// oscillation.
///
/// # Conventions
/// See [`Decomposition`]. For a mode with an amplitude law, `omega_rad_s` and `alpha_per_s` are
/// what a constant frequency and decay read over the span, and the law holds the small-amplitude
/// limits.
pub fn decompose(groups: &[ChannelGroup], options: &DecomposeOptions) -> Result<Decomposition> {
    decomposed(groups, options, OVERDAMPED)
}

/// The same of a record in which no other oscillation was found, with damping ratios to 0.33. Beside
/// others, what is so broad would be what they leave of themselves.
pub fn decompose_heavily_damped(groups: &[ChannelGroup]) -> Result<Decomposition> {
    decomposed(groups, &DecomposeOptions::default(), HEAVY)
}

fn decomposed(
    groups: &[ChannelGroup],
    options: &DecomposeOptions,
    most_damping: f64,
) -> Result<Decomposition> {
    let record = Record::new(groups, options)?;
    let search = searched(&record, options, most_damping)?;
    let noise = channel_noise(&record, &search);
    if !swings_above_band(&search, &noise) && !holds_alias(&search, &noise) {
        return summarize(&record, &search, &noise);
    }
    let record = record.by_sample();
    let search = searched(&record, options, most_damping)?;
    summarize(&record, &search, &channel_noise(&record, &search))
}

fn searched<'a>(
    record: &'a Record<'a>,
    options: &'a DecomposeOptions,
    most_damping: f64,
) -> Result<Search<'a>> {
    let mut search = Search::new(record, options, most_damping)
        .ok_or_else(|| no_result("the samples do not determine a mean and a drift"))?;
    search.run();
    Ok(search)
}

/// Whether a channel holds much more than noise above the band: cells average it away but for its
/// aliases.
fn swings_above_band(search: &Search, noise: &[ChannelNoise]) -> bool {
    noise
        .iter()
        .zip(&search.top_floor)
        .any(|(noise, floor)| noise.white.powi(2) > ABOVE_BAND * floor)
}

/// Whether a mode that stood in the cells it was found in is gone from the finer ones of the last
/// fit.
fn holds_alias(search: &Search, noise: &[ChannelNoise]) -> bool {
    (0..search.fit.model.modes.len()).any(|m| energy(&search.fit, noise, m) < search.bound)
}

fn summarize(record: &Record, search: &Search, noise: &[ChannelNoise]) -> Result<Decomposition> {
    if search.fit.model.modes.is_empty() {
        return Err(no_result("no oscillation stands above the noise"));
    }
    let failed = || no_result("the modes found cannot be told apart in this record");
    let (fit, curvature) =
        project_with_curvature(&search.fit.model, &search.cells).ok_or_else(failed)?;
    let residual = search.spectrum_about_modes(&fit);
    let errors = Errors::of(&fit, &curvature, &residual).ok_or_else(failed)?;
    let mut strongest: Vec<(usize, FittedMode)> = (0..fit.model.modes.len())
        .map(|m| (m, fitted_mode(record, &fit, &errors, noise, m)))
        .collect();
    strongest.sort_by(|a, b| b.1.snr_db.total_cmp(&a.1.snr_db));
    let order: Vec<usize> = strongest.iter().map(|(m, _)| *m).collect();
    let (baseline, level) = baselines(record, &fit);
    let rms_over_noise = rms_over_noise(noise, &fit);
    let warnings_said = warnings(search, rms_over_noise);
    Ok(Decomposition {
        t_ref_s: record.clock.t_ref_s,
        t_end_s: record.clock.t_ref_s + record.clock.span_s,
        modes: strongest.into_iter().map(|(_, mode)| mode).collect(),
        tones: tones(&fit, &order),
        noise: noise.iter().map(|n| n.white).collect(),
        baseline,
        level,
        rms_over_noise,
        warnings: warnings_said,
    })
}

fn channel_noise(record: &Record, search: &Search) -> Vec<ChannelNoise> {
    let mut all = Vec::new();
    for (i, cells) in search.cells.iter().enumerate() {
        let (group, offsets) = (&record.groups[i], &record.offsets[i]);
        all.extend(group_noise(
            &search.fit,
            all.len(),
            cells,
            group,
            offsets,
            record.clock,
        ));
    }
    all
}

fn fitted_mode(
    record: &Record,
    fit: &Fit,
    errors: &Errors,
    noise: &[ChannelNoise],
    m: usize,
) -> FittedMode {
    let per_s = 1.0 / record.clock.span_s;
    let motion = fit.model.modes[m];
    let (omega, alpha) = mean_rates(&motion);
    let se =
        |function: fn(&super::motion::Motion) -> f64| errors.se_of(&fit.model, m, function) * per_s;
    let power = motion.law.map_or(0, |law| law.power);
    // An imperfect law extrapolates imperfectly: as large a part of the way to zero amplitude is
    // uncertain as the misfit is of the motion.
    let extrapolated = (omega - motion.omega).abs() * per_s * misfit_ratio(fit, noise, m);
    let law = AmplitudeLaw {
        omega_small_rad_s: motion.omega * per_s,
        omega_small_se_rad_s: se(|mode| mode.omega).hypot(extrapolated),
        alpha_small_per_s: motion.alpha * per_s,
        power,
        shift_rad_s: motion.law.map_or(0.0, |law| law.shift) * per_s,
        shift_se_rad_s: se(|mode| mode.law.map_or(0.0, |law| law.shift)),
        beta_per_s: motion.law.map_or(0.0, |law| law.beta) * per_s,
        beta_se_per_s: se(|mode| mode.law.map_or(0.0, |law| law.beta)),
    };
    FittedMode {
        omega_rad_s: omega * per_s,
        omega_se_rad_s: se(|mode| mean_rates(mode).0),
        alpha_per_s: alpha * per_s,
        alpha_se_per_s: se(|mode| mean_rates(mode).1),
        shape: (0..fit.channels()).map(|c| fit.amplitude(c, m)).collect(),
        shape_se: (0..fit.channels()).map(|c| errors.shape_se[c][m]).collect(),
        snr_db: snr_db(fit, noise, m),
        law,
    }
}

/// Size of the misfit (the residual beyond white noise) beside that of a mode, at most 1.
fn misfit_ratio(fit: &Fit, noise: &[ChannelNoise], m: usize) -> f64 {
    let live = noise.iter().filter(|n| n.white > 0.0);
    let excess: f64 = live
        .map(|n| (n.rss / n.white.powi(2) - n.samples).max(0.0))
        .sum();
    (excess / 10_f64.powf(0.1 * snr_db(fit, noise, m)))
        .sqrt()
        .min(1.0)
}

fn snr_db(fit: &Fit, noise: &[ChannelNoise], m: usize) -> f64 {
    10.0 * energy(fit, noise, m).log10()
}

/// Energy of a mode over the white noise variance, summed over channels.
fn energy(fit: &Fit, noise: &[ChannelNoise], m: usize) -> f64 {
    let motion = fit.model.modes[m];
    let mean: f64 = (0..50)
        .map(|i| motion.envelope((f64::from(i) + 0.5) / 50.0).powi(2))
        .sum::<f64>()
        / 50.0;
    let ratio = |(c, n): (usize, &ChannelNoise)| {
        let energy = 0.5 * mean * n.samples * fit.amplitude(c, m).norm_sqr();
        if energy > 0.0 {
            energy / n.white.powi(2).max(f64::MIN_POSITIVE)
        } else {
            0.0
        }
    };
    noise.iter().enumerate().map(ratio).sum()
}

/// Tones with their multiples in the new order of modes, strongest first.
fn tones(fit: &Fit, order: &[usize]) -> Vec<CombinationTone> {
    let shape = |atom: usize| {
        (0..fit.channels())
            .map(|c| fit.amplitude(c, atom))
            .collect::<Vec<Complex64>>()
    };
    let tone = |(i, n): (usize, &Vec<i32>)| CombinationTone {
        multiples: order.iter().map(|&m| n[m]).collect(),
        shape: shape(fit.model.modes.len() + i),
    };
    let mut all: Vec<CombinationTone> = fit.model.tones.iter().enumerate().map(tone).collect();
    all.sort_by_key(|tone| {
        Reverse(
            tone.shape
                .iter()
                .map(|a| a.norm_sqr())
                .sum::<f64>()
                .to_bits(),
        )
    });
    all
}

/// Legendre coefficients with the levels put back, and the values at mid-span.
fn baselines(record: &Record, fit: &Fit) -> (Vec<Vec<f64>>, Vec<f64>) {
    let mut middle = vec![0.0; fit.model.baseline];
    super::basis::legendre(0.5, &mut middle);
    let offsets = record.offsets.iter().flatten();
    let own = |(a, offset): (&Vec<f64>, &f64)| {
        let mut own = a[2 * fit.model.atoms()..].to_vec();
        own[0] += offset;
        let level = own.iter().zip(&middle).map(|(a, p)| a * p).sum::<f64>();
        (own, level)
    };
    fit.coefficients.iter().zip(offsets).map(own).unzip()
}

fn rms_over_noise(noise: &[ChannelNoise], fit: &Fit) -> f64 {
    let shared = fit.model.parameter_count() as f64 / noise.len() as f64;
    let live = noise.iter().filter(|n| n.white > 0.0);
    let (sum, dof) = live.fold((0.0, 0.0), |(sum, dof), n| {
        (
            sum + n.rss / n.white.powi(2),
            dof + n.samples - fit.model.linear() as f64 - shared,
        )
    });
    if dof > 0.0 { (sum / dof).sqrt() } else { 1.0 }
}

fn warnings(search: &Search, rms_over_noise: f64) -> Vec<Message> {
    let mut all = Vec::new();
    if rms_over_noise > 1.1 {
        all.push(message("misfit", [("times", rms_over_noise, 2)]));
    }
    if search.held_growing > 0 {
        all.push(message(
            "growing",
            [("count", search.held_growing as f64, 0)],
        ));
    }
    if search.options.mode_count.is_none()
        && search.fit.model.modes.len() >= search.options.max_modes
    {
        all.push(message("many", []));
    }
    all
}
