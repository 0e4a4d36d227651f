//! What a line of the residual may be.

use std::f64::consts::{PI, TAU};

use super::basis::{Model, combined};
use super::fit::{Fit, project, promise, refine};
use super::motion::{Law, Motion};
use super::search::{Peak, Search};

/// Distance, in Rayleigh widths, within which a line may belong to a mode.
const NEAR: f64 = 2.5;
/// A new line this much weaker (in energy) than a mode it stands beside is that mode's skirt: −20
/// dB.
const SKIRT: f64 = 0.01;
/// Energy below which a line is of no account beside the strongest mode: −46 dB, a two-hundredth of
/// its amplitude.
const NEGLIGIBLE: f64 = 2.5e-5;
/// Energy, beside the strongest mode, below which a mode's own laws and combinations are not looked
/// for.
const MINOR: f64 = 3e-3;
/// Half-width of the skirt of a line that an amplitude law moves, in parts of its frequency.
const MOVED_SKIRT: f64 = 0.1;
/// χ² that the linearised problem must promise of a law before it is fitted: half of what it must
/// gain.
const HOPELESS_LAW: f64 = 12.0;
/// Most iterations of a trial.
const ITERATIONS: usize = 20;

/// What a trial adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Tone,
    Law,
    Mode,
}

/// All trials for a peak, fitted. Beside modes in `tried`, laws and pairs have been tried in vain.
pub(super) fn proposals(
    search: &Search,
    peak: &Peak,
    forced: bool,
    tried: &[usize],
) -> Vec<(Kind, Fit)> {
    let model = &search.fit.model;
    let mut trials = Vec::new();
    if !forced {
        trials.extend(tone(search, peak).map(|fit| (Kind::Tone, fit)));
    }
    let near = nearest(model, peak.k);
    let fresh = near.filter(|mode| !tried.contains(mode));
    if let (Some(mode), false) = (fresh, forced) {
        trials.extend(laws(search, mode, peak).map(|fit| (Kind::Law, fit)));
    }
    let starts = match (fresh, near) {
        (Some(mode), _) => split_starts(search, mode, peak),
        (None, Some(mode)) => {
            vec![with_mode(
                model,
                Motion::plain(TAU * peak.k, model.modes[mode].alpha.max(0.1)),
            )]
        }
        (None, None) => vec![with_mode(
            model,
            Motion::plain(TAU * peak.k, first_decay(peak)),
        )],
    };
    let fits = starts
        .iter()
        .filter_map(|start| refine(start, &search.cells, ITERATIONS));
    let fits = fits.filter(|fit| forced || (is_oscillation(fit, search) && !is_skirt(fit)));
    trials.extend(
        fits.min_by(|a, b| a.merit.total_cmp(&b.merit))
            .map(|fit| (Kind::Mode, fit)),
    );
    trials
}

fn with_mode(model: &Model, mode: Motion) -> Model {
    let mut model = model.clone();
    model.modes.push(mode);
    for tone in &mut model.tones {
        tone.push(0);
    }
    model
}

/// Decay from the half-power width: a window alone gives 0.886, a Lorentz line α/π.
fn first_decay(peak: &Peak) -> f64 {
    (PI * (peak.width * peak.width - 0.8).max(0.0).sqrt()).clamp(0.1, 0.1 * TAU * peak.k + 0.2)
}

/// The mode a line stands beside, its own range of frequencies counted.
pub(super) fn nearest(model: &Model, k: f64) -> Option<usize> {
    let distance = |mode: &Motion| {
        let (first, last) = (mode.at(0.0).rate.im / TAU, mode.at(1.0).rate.im / TAU);
        let outside = (first.min(last) - k).max(k - first.max(last)).max(0.0);
        outside - 0.5 * mode.alpha.max(0.0) / PI
    };
    let near = model
        .modes
        .iter()
        .enumerate()
        .map(|(m, mode)| (m, distance(mode)));
    near.filter(|(_, d)| *d < NEAR)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(m, _)| m)
}

/// A new mode must swing within the band, and count for something beside the strongest.
fn is_oscillation(fit: &Fit, search: &Search) -> bool {
    let band = search.record.band;
    let new = fit.model.modes.len() - 1;
    let mode = fit.model.modes[new];
    let swings = mode.alpha < search.most_damping * mode.omega && mode.alpha > -2.0;
    let inside = (band.0..=band.1).contains(&(mode.omega / TAU));
    swings && inside && counts(fit, new)
}

/// Whether a mode stands beside the strongest in its energy or, where it dies away sooner, in its
/// amplitude at the start.
fn counts(fit: &Fit, mode: usize) -> bool {
    strength(fit, mode) > NEGLIGIBLE * strongest(fit) || size(fit, mode) > NEGLIGIBLE * largest(fit)
}

/// Whether the newest mode is what an imperfect model leaves beside a line.
fn is_skirt(fit: &Fit) -> bool {
    let model = &fit.model;
    let (count, new) = (model.modes.len(), model.modes.len() - 1);
    let (omega, own) = (model.modes[new].omega, strength(fit, new));
    (0..model.atoms()).filter(|atom| *atom != new).any(|atom| {
        let (centre, moved) = model.atom_omega(atom);
        let reach = TAU * NEAR + if moved { MOVED_SKIRT * centre } else { 0.0 };
        let share = match (atom < count, moved) {
            (true, false) => SKIRT,
            (true, true) => 5.0 * SKIRT,
            (false, _) => 1.0,
        };
        (omega - centre).abs() < reach && own < share * strength(fit, atom)
    })
}

fn strongest(fit: &Fit) -> f64 {
    (0..fit.model.modes.len())
        .map(|m| strength(fit, m))
        .fold(0.0, f64::max)
}

fn largest(fit: &Fit) -> f64 {
    (0..fit.model.modes.len())
        .map(|m| size(fit, m))
        .fold(0.0, f64::max)
}

/// Squared amplitude of an atom at the start, over noise variance.
fn size(fit: &Fit, atom: usize) -> f64 {
    (0..fit.channels())
        .map(|c| fit.amplitude(c, atom).norm_sqr() / fit.variance(c))
        .sum()
}

/// Mean energy of an atom over noise variance.
pub(super) fn strength(fit: &Fit, atom: usize) -> f64 {
    let at = |i: i32| {
        fit.model
            .atom_envelope(atom, (f64::from(i) + 0.5) / 20.0)
            .powi(2)
    };
    (0..20).map(at).sum::<f64>() / 20.0 * size(fit, atom)
}

/// Extensions of a mode by an amplitude law: the smooth one from both signs, then the linear one
/// from there.
fn laws(search: &Search, mode: usize, peak: &Peak) -> Option<Fit> {
    let model = &search.fit.model;
    let motion = model.modes[mode];
    if motion.law.is_some() || strength(&search.fit, mode) < MINOR * strongest(&search.fit) {
        return None;
    }
    let extended = |law: Law, alpha: f64| {
        let mut start = model.clone();
        start.modes[mode] = Motion {
            omega: motion.omega - 0.5 * law.shift,
            alpha,
            law: Some(law),
        };
        start
    };
    let none = extended(
        Law {
            shift: 0.0,
            beta: 0.0,
            power: 2,
        },
        motion.alpha,
    );
    if promise(&none, &search.cells)? * peak.over_floor < HOPELESS_LAW {
        return None;
    }
    let moved = |shift: f64| {
        extended(
            Law {
                shift,
                beta: 0.1,
                power: 2,
            },
            motion.alpha.max(0.3),
        )
    };
    let starts = [none, moved(-3.0), moved(3.0)];
    let begun = starts
        .iter()
        .filter_map(|start| refine(start, &search.cells, 4));
    let begun = begun.min_by(|a, b| a.merit.total_cmp(&b.merit))?;
    let smooth = refine(&begun.model, &search.cells, ITERATIONS)?;
    let mut start = smooth.model.clone();
    if let Some(law) = &mut start.modes[mode].law {
        law.power = 1;
    }
    let linear = refine(&start, &search.cells, ITERATIONS);
    linear
        .into_iter()
        .chain([smooth])
        .min_by(|a, b| a.merit.total_cmp(&b.merit))
}

/// Pairs of modes in place of one: offsets about its line, judged by their projection.
fn split_starts(search: &Search, mode: usize, peak: &Peak) -> Vec<Model> {
    let model = &search.fit.model;
    let old = model.modes[mode];
    let mut starts = vec![with_mode(
        model,
        Motion::plain(TAU * peak.k, old.alpha.max(0.1)),
    )];
    for decay in [old.alpha, 0.4 * old.alpha] {
        for apart in [0.4, 0.8, 1.4, 2.4] {
            for (first, second) in [(-0.5, 0.5), (0.0, 1.0), (0.0, -1.0)] {
                let at = |place: f64| Motion {
                    omega: old.omega + TAU * apart * place,
                    alpha: decay,
                    ..old
                };
                let mut start = with_mode(model, Motion::plain(at(second).omega, decay));
                start.modes[mode] = at(first);
                starts.push(start);
            }
        }
    }
    let merit =
        |start: &Model| project(start, &search.cells).map_or(f64::INFINITY, |fit| fit.merit);
    let mut ranked: Vec<(f64, Model)> = starts
        .into_iter()
        .map(|start| (merit(&start), start))
        .collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    ranked.into_iter().take(3).map(|(_, start)| start).collect()
}

/// The combination of known modes at a line, fitted as a tone.
fn tone(search: &Search, peak: &Peak) -> Option<Fit> {
    let model = &search.fit.model;
    let sideways = |n: &Vec<i32>| {
        let width: f64 = n
            .iter()
            .zip(&model.modes)
            .map(|(n, m)| f64::from(n.abs()) * m.alpha.abs())
            .sum();
        let away = (combined(n, &model.modes).abs() / TAU - peak.k).abs();
        // Where a law moves the parents, their combinations spread with them.
        let spread: f64 = n
            .iter()
            .zip(&model.modes)
            .map(|(n, m)| f64::from(n.abs()) * drift(m))
            .sum();
        (away - 0.3 * width / PI - spread, away)
    };
    let bound = MINOR * strongest(&search.fit);
    let major: Vec<bool> = (0..model.modes.len())
        .map(|m| strength(&search.fit, m) > bound)
        .collect();
    let of_major = |n: &Vec<i32>| n.iter().zip(&major).all(|(n, major)| *n == 0 || *major);
    let known = combinations(model.modes.len()).into_iter();
    let known = known
        .filter(|n| of_major(n) && !model.tones.contains(n) && !model.tones.contains(&negative(n)));
    let mut close: Vec<(f64, Vec<i32>)> = known
        .map(|n| (sideways(&n), n))
        .filter(|(d, _)| d.0 < 0.75)
        .map(|(d, n)| (d.1, n))
        .collect();
    close.sort_by(|a, b| {
        (order(&a.1), a.0)
            .partial_cmp(&(order(&b.1), b.0))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let (_, multiples) = close.into_iter().next()?;
    let sign = if combined(&multiples, &model.modes) < 0.0 {
        -1
    } else {
        1
    };
    let mut start = model.clone();
    start
        .tones
        .push(multiples.iter().map(|n| sign * n).collect());
    let fit = refine(&start, &search.cells, 8)?;
    // A combination is weaker than each of what it is made of.
    let parents = multiples
        .iter()
        .enumerate()
        .filter(|(_, n)| **n != 0)
        .map(|(m, _)| strength(&fit, m));
    let most = parents.fold(0.3 * strongest(&fit), f64::min);
    (strength(&fit, fit.model.atoms() - 1) < most).then_some(fit)
}

fn negative(multiples: &[i32]) -> Vec<i32> {
    multiples.iter().map(|n| -n).collect()
}

/// How far a law moves a mode over the span, cycles per span.
fn drift(mode: &Motion) -> f64 {
    (mode.at(1.0).rate.im - mode.at(0.0).rate.im).abs() / TAU
}

fn order(multiples: &[i32]) -> i32 {
    multiples.iter().map(|n| n.abs()).sum()
}

/// Harmonics up to the fifth, and sums and differences of two modes up to third order.
fn combinations(modes: usize) -> Vec<Vec<i32>> {
    let mut all = Vec::new();
    let unit = |terms: &[(usize, i32)]| {
        let mut n = vec![0; modes];
        terms.iter().for_each(|&(m, k)| n[m] = k);
        n
    };
    for a in 0..modes {
        all.extend((2..=5).map(|k| unit(&[(a, k)])));
        for b in 0..modes {
            if a != b {
                let pairs = [(1, 1), (1, -1), (2, 1), (2, -1)];
                all.extend(
                    pairs
                        .iter()
                        .filter(|(i, _)| *i == 2 || a < b)
                        .map(|&(i, j)| unit(&[(a, i), (b, j)])),
                );
            }
        }
    }
    all
}
